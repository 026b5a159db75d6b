//! The matrix of laws and properties, as the program prints it.

use kane::impact::{law, laws};
use kane::matrix::{Cell, Finding, Matrix, PROPERTIES, Row, Selection, matrix};
use kane::report::Page;
use kane::report::matrix::{MatrixReport, csv, explain, html, json, picture, properties, sheet};

use crate::schemas::assert_valid;
use crate::{assert_kept, settings};

/// In every form, by one test: making the matrix takes longest.
#[test]
fn the_matrix_in_every_form() {
    let matrix = matrix(laws(), &Selection::default(), &mut |_, _| {});
    as_text(&matrix);
    as_markdown(&matrix);
    as_json(&matrix);
    as_page(&matrix);
    as_figure(&matrix);
    some_cells_in_full(&matrix);
    no_cell_is_undecided(&matrix);
}

fn report(matrix: &Matrix) -> MatrixReport<'_> {
    MatrixReport { matrix, command: "kane laws".to_owned() }
}

fn as_text(matrix: &Matrix) {
    let shown = sheet(&report(matrix)).text(Page::default());
    for line in shown.lines() {
        assert!(line.chars().count() <= 120, "more than 120 columns: {line}");
    }
    settings().bind(|| insta::assert_snapshot!("text", shown));
}

fn as_markdown(matrix: &Matrix) {
    settings().bind(|| insta::assert_snapshot!("markdown", sheet(&report(matrix)).markdown()));
}

/// Of three laws: all of them are more than a snapshot may hold.
fn as_json(matrix: &Matrix) {
    assert_valid("laws", &json(&report(matrix)));
    let value: serde_json::Value =
        serde_json::from_str(&json(&report(matrix))).expect("it is JSON");
    assert_eq!(value["laws"].as_array().expect("a list").len(), matrix.rows.len());
    let some = Matrix { properties: matrix.properties.clone(), rows: matrix.rows[..3].to_vec() };
    settings().bind(|| insta::assert_snapshot!("json", json(&report(&some))));
}

/// The page is asserted, not kept: it is long, and tells what the other forms tell.
fn as_page(matrix: &Matrix) {
    let laws = include_str!("../../docs/laws.md");
    let page = html(&report(matrix), laws);
    // half of it is witnesses, whose guards are long polynomials; the font in it is of one size everywhere
    let font = page.split_once("base64,").and_then(|(_, rest)| rest.find(')')).unwrap_or(0);
    assert!(
        page.len() - font < 1_300_000,
        "{} bytes without the {font} of its font",
        page.len() - font
    );
    assert_eq!(page, html(&report(matrix), laws), "the same in every run");
    let ids: Vec<_> =
        page.split(" id=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let distinct: std::collections::BTreeSet<_> = ids.iter().collect();
    assert_eq!(ids.len(), distinct.len(), "no two elements share an anchor");
    for link in page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        // the page of the laws has links to publications
        let anchor = link.strip_prefix('#').filter(|anchor| !anchor.is_empty());
        assert!(anchor.is_none_or(|anchor| ids.contains(&anchor)), "{link} leads nowhere");
    }
    assert_eq!(page.matches("Formula, source and domain").count(), matrix.rows.len());
    for row in &matrix.rows {
        let known = page
            .matches(&format!("impact::laws::{}</code>", in_code(row.law.info.id, laws)))
            .count();
        assert_eq!(known, 1, "what is known of {} stands there once", row.law.info.id);
        for (property, cell) in matrix.properties.iter().zip(&row.cells) {
            let id = format!("{}:{}", row.law.info.id, property.id);
            let told = |id: &str| {
                let (_, entry) = page.split_once(&format!(" id=\"{id}\"")).expect("a cell");
                entry.split("</details>").next().expect("it is closed")
            };
            // what is word for word that of a law above stands there
            let entry = match told(&id).split_once("Word for word as for <a href=\"#") {
                Some((_, first)) => told(first.split('"').next().expect("an address")),
                None => told(&id),
            };
            let is_whole = cell.parts.iter().all(|part| entry.contains(&part.digest()));
            let outline = format!("kane laws --explain {id}</code>");
            let is_outlined = told(&id).contains(&outline);
            assert!(is_whole || is_outlined, "{id} is neither whole nor outlined");
            assert!(cell.finding != Finding::Refuted || is_whole, "{id}: a witness is whole");
        }
    }
    let table = csv(&report(matrix));
    assert_eq!(table.lines().count(), 1 + matrix.rows.len() * matrix.properties.len());
}

fn as_figure(matrix: &Matrix) {
    let drawn = picture(&report(matrix));
    assert!(drawn.len() < 64 * 1024, "{} bytes", drawn.len());
    for (ending, text) in [("svg", drawn), ("csv", csv(&report(matrix)))] {
        assert_kept(&format!("docs/figures/matrix.{ending}"), &text);
    }
}

/// The name of a law's type, from the page of the laws.
fn in_code<'a>(id: &str, laws: &'a str) -> &'a str {
    let (_, section) = laws.split_once(&format!("\n## {id}\n")).expect("a section");
    let (_, code) = section.split_once("kane::impact::laws::").expect("its type");
    code.split('`').next().expect("the name ends").trim_end_matches(';')
}

/// Of a matrix made by hand with every finding in it, so that a change of the prover changes no picture.
#[test]
fn the_picture_of_a_matrix() {
    use Finding::{NotApplicable, Proved, Refuted, Undecided};
    let cell = |finding| Cell {
        finding,
        reason: "because, \"so\"".to_owned(),
        parts: Vec::new(),
        witness: Vec::new(),
    };
    let row = |id, findings: [Finding; 4]| Row {
        law: law(id).expect("it is known").clone(),
        cells: findings.map(cell).to_vec(),
    };
    let properties = [0, 5, 6, 9].map(|index| &PROPERTIES[index]).to_vec();
    let rows = vec![
        row("garwin", [Proved, Refuted, NotApplicable, Undecided]),
        row("walton", [Refuted, Proved, Proved, Proved]),
    ];
    let matrix = Matrix { properties, rows };
    let shown = picture(&report(&matrix));
    settings().bind(|| insta::assert_snapshot!("picture", shown));
    let table = csv(&report(&matrix));
    assert!(table.contains("garwin,cone,not applicable,0,\"because, \"\"so\"\"\"\n"), "{table}");
}

fn no_cell_is_undecided(matrix: &Matrix) {
    let cells = matrix.rows.iter().flat_map(|row| {
        let cells = matrix.properties.iter().zip(&row.cells);
        cells.map(|(property, cell)| (format!("{}:{}", row.law.info.id, property.id), cell.finding))
    });
    let open: Vec<String> =
        cells.filter(|(_, f)| *f == Finding::Undecided).map(|(name, _)| name).collect();
    assert_eq!(open, [""; 0]);
}

fn some_cells_in_full(matrix: &Matrix) {
    for (law, property) in [
        ("wang-su-li", "reversal"),
        ("smith-1991", "C1"),
        ("smith-1991", "subdivision"),
        ("kane-levinson", "energy"),
        ("keller-printed", "cone"),
    ] {
        let row = matrix.rows.iter().find(|row| row.law.info.id == law).expect("a law");
        let index = matrix.properties.iter().position(|p| p.id == property).expect("a property");
        let shown = explain(row, matrix.properties[index], &row.cells[index]);
        settings().bind(|| insta::assert_snapshot!(format!("{law}-{property}"), shown));
    }
}

#[test]
fn the_page_of_properties_is_what_the_program_says() {
    let page = include_str!("../../docs/properties.md");
    let (head, _) = page.split_once("| column |").expect("the page has its table");
    assert_kept("docs/properties.md", &format!("{head}{}", properties()));
}
