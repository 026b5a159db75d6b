//! The matrix of laws and properties, as the program prints it.

use std::path::Path;

use kane::audit::matrix::{Finding, Matrix, Selection, matrix};
use kane::report::Page;
use kane::report::matrix::{MatrixReport, explain, json, markdown, properties, text};

use crate::settings;

/// In every form, by one test: making the matrix takes longest.
#[test]
fn the_matrix_in_every_form() {
    let matrix = matrix(&Selection::default(), &mut |_, _| {});
    as_text(&matrix);
    as_markdown(&matrix);
    as_json(&matrix);
    some_cells_in_full(&matrix);
    no_cell_is_undecided(&matrix);
}

fn report(matrix: &Matrix) -> MatrixReport<'_> {
    MatrixReport { matrix, command: "kane laws".to_owned() }
}

fn as_text(matrix: &Matrix) {
    let shown = text(&report(matrix), Page::default());
    for line in shown.lines() {
        assert!(line.chars().count() <= 120, "more than 120 columns: {line}");
    }
    settings().bind(|| insta::assert_snapshot!("text", shown));
}

fn as_markdown(matrix: &Matrix) {
    settings().bind(|| insta::assert_snapshot!("markdown", markdown(&report(matrix))));
}

/// Of three laws: all of them are more than a snapshot may hold.
fn as_json(matrix: &Matrix) {
    let value: serde_json::Value =
        serde_json::from_str(&json(&report(matrix))).expect("it is JSON");
    assert_eq!(value["laws"].as_array().expect("a list").len(), matrix.rows.len());
    let some = Matrix { properties: matrix.properties.clone(), rows: matrix.rows[..3].to_vec() };
    settings().bind(|| insta::assert_snapshot!("json", json(&report(&some))));
}

fn no_cell_is_undecided(matrix: &Matrix) {
    let cells = matrix.rows.iter().flat_map(|row| {
        let cells = matrix.properties.iter().zip(&row.cells);
        cells.map(|(property, cell)| (format!("{}:{}", row.id, property.id), cell.finding))
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
        let row = matrix.rows.iter().find(|row| row.id == law).expect("a law");
        let index = matrix.properties.iter().position(|p| p.id == property).expect("a property");
        let shown = explain(row, matrix.properties[index], &row.cells[index]);
        settings().bind(|| insta::assert_snapshot!(format!("{law}-{property}"), shown));
    }
}

/// `KANE_WRITE_DOCS=1 cargo test --test golden page_of_properties` makes it again.
#[test]
fn the_page_of_properties_is_what_the_program_says() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/properties.md");
    let page = std::fs::read_to_string(&path).expect("the page is there");
    let (head, _) = page.split_once("| column |").expect("the page has its table");
    let made = format!("{head}{}", properties());
    if std::env::var_os("KANE_WRITE_DOCS").is_some() {
        std::fs::write(&path, made).expect("the page can be written");
        return;
    }
    assert!(made == page, "docs/properties.md is not what the program says");
}
