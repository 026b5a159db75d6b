//! Matrices of laws and properties that are made up, for tests.

use kane_impact::{Law, laws};
use kane_matrix::{Cell, Finding, Matrix, PROPERTIES, Property, Row};

/// A law a row, a property a column, the first ones: `y` proved, `n` refuted, `-` not applicable, `?` undecided.
pub(crate) fn matrix(rows: &[&str]) -> Matrix {
    let columns = rows.first().map_or(0, |row| row.len());
    matrix_of(PROPERTIES.iter().take(columns).collect(), rows)
}

/// The same with these properties.
pub(crate) fn matrix_of(properties: Vec<&'static Property>, rows: &[&str]) -> Matrix {
    let cell = |letter: char| Cell {
        finding: match letter {
            'y' => Finding::Proved,
            'n' => Finding::Refuted,
            '?' => Finding::Undecided,
            _ => Finding::NotApplicable,
        },
        reason: String::new(),
        parts: Vec::new(),
        witness: Vec::new(),
    };
    let row = |(law, letters): (&Law, &&str)| Row {
        law: law.clone(),
        cells: letters.chars().map(cell).collect(),
    };
    Matrix { properties, rows: laws().iter().zip(rows).map(row).collect() }
}
