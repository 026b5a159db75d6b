//! Laws against properties: a sheet, a page of its own, JSON, CSV, a picture, and one cell in full.

mod csv;
mod explain;
mod finding;
mod html;
mod json;
#[cfg(test)]
pub(crate) mod made_up;
mod picture;
mod sheet;

use kane_matrix::{Finding, Matrix, Row};

pub use csv::csv;
pub use explain::explain;
pub(crate) use finding::{breaking, conflicts};
pub use html::{html, html_in_site};
#[cfg(feature = "schema")]
pub(crate) use json::schema;
pub use json::{LAWS_SCHEMA_NAME, LAWS_SCHEMA_VERSION, json};
pub use picture::picture;
pub use sheet::{properties, sheet};

/// The matrix, and the command that prints it again.
#[derive(Clone, Debug)]
pub struct MatrixReport<'a> {
    /// the findings
    pub matrix: &'a Matrix,
    /// a command that prints this report
    pub command: String,
}

impl MatrixReport<'_> {
    /// How many laws, properties, and cells of each finding.
    pub(crate) fn headline(&self) -> String {
        let matrix = self.matrix;
        let counted = |n: usize, one: &str, many: &str| {
            if n == 1 { format!("1 {one}") } else { format!("{n} {many}") }
        };
        let mut parts = Vec::new();
        for finding in FINDINGS {
            let count = matrix.count(finding);
            if count > 0 {
                parts.push(format!("{count} {}", word(finding)));
            }
        }
        format!(
            "{}, {}: {}",
            counted(matrix.rows.len(), "law", "laws"),
            counted(matrix.properties.len(), "property", "properties"),
            parts.join(", ")
        )
    }
}

/// All findings, in the order in which they are counted and explained.
pub(crate) const FINDINGS: [Finding; 4] =
    [Finding::Proved, Finding::Refuted, Finding::NotApplicable, Finding::Undecided];

/// A finding in a word.
pub(crate) fn word(finding: Finding) -> &'static str {
    match finding {
        Finding::Proved => "proved",
        Finding::Refuted => "refuted",
        Finding::NotApplicable => "not applicable",
        Finding::Undecided => "undecided",
    }
}

/// A finding in a cell.
pub(crate) fn mark(finding: Finding) -> &'static str {
    match finding {
        Finding::Proved => "yes",
        Finding::Refuted => "no",
        Finding::NotApplicable => "-",
        Finding::Undecided => "?",
    }
}

/// The law's id, with a mark where something must not be missed.
pub(crate) fn marked(row: &Row) -> String {
    let mark = if row.law.info.caveat.is_some() { "†" } else { "" };
    format!("{}{mark}", row.law.info.id)
}

/// What must not be missed of the laws that bear the mark.
pub(crate) fn caveats(matrix: &Matrix) -> Vec<String> {
    let told = matrix.rows.iter().filter_map(|row| Some((row.law.info.id, row.law.info.caveat?)));
    told.map(|(id, caveat)| format!("† {id}: {caveat}.")).collect()
}

/// The law's own parameters, `name = value, …`.
pub(crate) fn parameters(row: &Row) -> String {
    let pairs = row.law.parameters().into_iter().map(|(name, value)| format!("{name} = {value}"));
    pairs.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use kane_impact::{law, laws};
    use kane_matrix::{Cell, PROPERTIES};

    use super::*;

    fn row(id: &str, findings: &[Finding]) -> Row {
        let cell = |finding: &Finding| Cell {
            finding: *finding,
            reason: String::new(),
            parts: Vec::new(),
            witness: Vec::new(),
        };
        Row {
            law: law(id).expect("it is known").clone(),
            cells: findings.iter().map(cell).collect(),
        }
    }

    #[test]
    fn a_cell_says_yes_only_where_something_is_proved() {
        assert_eq!(FINDINGS.map(mark), ["yes", "no", "-", "?"]);
        assert_eq!(FINDINGS.map(word), ["proved", "refuted", "not applicable", "undecided"]);
    }

    #[test]
    fn the_headline_counts_laws_properties_and_findings() {
        use Finding::{NotApplicable, Proved, Refuted, Undecided};
        let headline = |rows: Vec<Row>| {
            let columns = rows.first().map_or(0, |row| row.cells.len());
            let matrix = Matrix { properties: PROPERTIES.iter().take(columns).collect(), rows };
            MatrixReport { matrix: &matrix, command: String::new() }.headline()
        };
        assert_eq!(headline(vec![row("walton", &[Proved])]), "1 law, 1 property: 1 proved");
        assert_eq!(
            headline(vec![
                row("walton", &[Proved, Undecided, Refuted]),
                row("garwin", &[Proved, NotApplicable, Refuted]),
            ]),
            "2 laws, 3 properties: 2 proved, 2 refuted, 1 not applicable, 1 undecided"
        );
    }

    #[test]
    fn what_must_not_be_missed_of_a_law_is_marked_and_told() {
        let (with, without): (Vec<_>, Vec<_>) =
            laws().iter().partition(|law| law.info.caveat.is_some());
        let (with, without) = (with[0].info.id, without[0].info.id);
        assert_eq!(marked(&row(with, &[])), format!("{with}†"));
        assert_eq!(marked(&row(without, &[])), without);
        let matrix =
            Matrix { properties: Vec::new(), rows: vec![row(without, &[]), row(with, &[])] };
        let caveat = law(with).and_then(|law| law.info.caveat).expect("it has one");
        assert_eq!(caveats(&matrix), [format!("† {with}: {caveat}.")]);
    }

    #[test]
    fn a_law_is_told_with_its_own_parameters() {
        assert_eq!(parameters(&row("routh-newton", &[])), "");
        assert!(parameters(&row("walton", &[])).starts_with("beta0 = "));
    }
}
