//! `kane laws`: every law against every property.

use kane::impact::laws;
use kane::matrix::{Finding, Matrix, Selection, matrix};
use kane::report::Sheet;
use kane::report::matrix::{MatrixReport, csv, explain, html, json, sheet};

use super::args::LawsArgs;
use super::delivery::Written;
use super::ids::{law_ids, property_ids, unknown};
use super::progress::Progress;
use super::{Outcome, bad_input, deliver, forms};

/// Runs the verb.
pub(super) fn run(args: &LawsArgs) -> Outcome {
    let selection = match selection(args) {
        Ok(selection) => selection,
        Err(message) => return bad_input(&message),
    };
    let mut progress = Progress::counting("cells");
    let matrix = matrix(laws(), &selection, &mut |done, all| progress.update(done, all));
    drop(progress);

    let report = MatrixReport { matrix: &matrix, command: command(args) };
    let sheet = sheet(&report);
    let shown = || match &args.explain {
        Some(_) => explained(&matrix),
        None => forms::printed(args.format, &sheet, || json(&report)),
    };
    if let Err(outcome) = deliver(args.out.as_deref(), &[], || Ok(files(&report, &sheet)), shown) {
        return outcome;
    }
    outcome(&matrix)
}

/// How the run ends: what is refuted is an answer, what is undecided is none.
fn outcome(matrix: &Matrix) -> Outcome {
    if matrix.count(Finding::Undecided) > 0 { Outcome::Unexpected } else { Outcome::AsExpected }
}

/// What is asked for, or what is wrong with it.
fn selection(args: &LawsArgs) -> Result<Selection, String> {
    let (mut wanted, mut columns) = (args.law.clone(), args.property.clone());
    if let Some(cell) = &args.explain {
        let Some((law, property)) = cell.split_once(':') else {
            return Err(format!("`{cell}` is not LAW:PROPERTY, as in wang-su-li:energy"));
        };
        wanted.push(law.to_owned());
        columns.push(property.to_owned());
    }
    let properties = property_ids();
    let laws = law_ids();
    known("law", &wanted, &laws)?;
    known("property", &columns, &properties)?;
    let chosen = |ids: Vec<String>| (!ids.is_empty()).then_some(ids);
    Ok(Selection { laws: chosen(wanted), properties: chosen(columns) })
}

/// Whether all ids are known.
fn known(what: &str, wanted: &[String], ids: &[&str]) -> Result<(), String> {
    for id in wanted {
        if !ids.contains(&id.as_str()) {
            return Err(unknown(what, id, ids));
        }
    }
    Ok(())
}

/// The command that prints the report again.
fn command(args: &LawsArgs) -> String {
    let mut command = "kane laws".to_owned();
    for id in &args.law {
        command.push_str(&format!(" --law {id}"));
    }
    for id in &args.property {
        command.push_str(&format!(" --property {id}"));
    }
    command
}

/// The only cell in full.
fn explained(matrix: &Matrix) -> String {
    let rows = matrix.rows.iter().flat_map(|row| {
        matrix.properties.iter().zip(&row.cells).map(move |(p, cell)| explain(row, p, cell))
    });
    rows.collect()
}

/// What each law says and how it is known, for the page.
pub(super) const LAWS: &str = include_str!("../../docs/laws.md");

/// The report in every form, with the page that the matrix has, and the picture with its data.
fn files(report: &MatrixReport<'_>, sheet: &Sheet<'_>) -> Vec<Written> {
    let mut files = forms::files_with_page("laws", sheet, html(report, LAWS), json(report));
    files.push(Written::new("matrix.csv", csv(report)));
    files
}

#[cfg(test)]
mod tests {
    use kane::matrix::{Cell, PROPERTIES, Row};

    use super::*;

    /// No shipped cell is open, so that this one is made by hand.
    #[test]
    fn a_matrix_with_one_open_cell_is_not_as_expected() {
        let matrix_of = |findings: &[Finding]| {
            let cell = |finding: &Finding| Cell {
                finding: *finding,
                reason: String::new(),
                parts: Vec::new(),
                witness: Vec::new(),
            };
            let cells = findings.iter().map(cell).collect();
            let row = Row { law: laws()[0].clone(), cells };
            Matrix { properties: PROPERTIES.iter().take(findings.len()).collect(), rows: vec![row] }
        };
        let decided = [Finding::Proved, Finding::Refuted, Finding::NotApplicable];
        assert!(matches!(outcome(&matrix_of(&decided)), Outcome::AsExpected));
        let open = [Finding::Proved, Finding::Undecided];
        assert!(matches!(outcome(&matrix_of(&open)), Outcome::Unexpected));
    }
}
