//! The matrix as a picture: a cell a law and property, each with its sign, so that it never rests on colour.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_matrix::{Finding, Row};

use super::{FINDINGS, MatrixReport, caveats, marked, word};
use crate::picture::{Anchor, Canvas, Ink, NUMBERS, Pen, Point, WORDS, count};

/// Sizes of a cell, and of the heads of rows and of columns.
const CELL: Point = (38.0, 26.0);
const LAWS: f64 = 188.0;
const HEADS: f64 = 268.0;
/// From the matrix to the legend, and from one of its entries to the next.
const GAP: f64 = 34.0;
const ENTRY: f64 = 170.0;

/// The matrix as SVG, laws with the fewest refuted properties first, with their number at the edges. Equal matrices
/// give equal bytes.
#[must_use]
pub fn picture(report: &MatrixReport<'_>) -> String {
    let matrix = report.matrix;
    let refuted = |row: &Row| row.cells.iter().filter(|c| c.finding == Finding::Refuted).count();
    let mut rows: Vec<&Row> = matrix.rows.iter().collect();
    rows.sort_by_key(|row| refuted(row));
    let bottom = HEADS + CELL.1 * count(rows.len());
    let right = LAWS + CELL.0 * count(matrix.properties.len());
    let mut notes = vec![
        report.headline(),
        "* asked of every planar contact; the others where it does not couple, W_tn = 0. Laws stand by the \
         number of properties refuted, at the right; below is by how many laws each property is refuted."
            .to_owned(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    notes.splice(2..2, caveats(matrix));
    let width = (right + 40.0).max(ENTRY * count(FINDINGS.len())) + 12.0;
    let size = (width, bottom + GAP + CELL.1 + 18.0);
    let mut canvas = Canvas::new(size, "Laws and properties", &notes);
    for (column, property) in matrix.properties.iter().enumerate() {
        let x = LAWS + CELL.0 * (count(column) + 0.5);
        let star = if property.domain.starts_with("every") { " *" } else { "" };
        let name = format!("{}{star}", property.name);
        canvas.upright((x, HEADS - 6.0), &name, WORDS, Anchor::Start);
        let refuted = rows.iter().filter(|row| row.cells[column].finding == Finding::Refuted);
        let number = refuted.count().to_string();
        canvas.words((x, bottom + 12.0), &number, NUMBERS, Anchor::Middle);
    }
    for (line, row) in rows.iter().enumerate() {
        let y = HEADS + CELL.1 * (count(line) + 0.5);
        canvas.words((12.0, y), &marked(row), WORDS, Anchor::Start);
        canvas.words((right + 10.0, y), &refuted(row).to_string(), NUMBERS, Anchor::Start);
    }
    for (entry, finding) in FINDINGS.into_iter().enumerate() {
        let mut places: Vec<Point> = Vec::new();
        for (line, row) in rows.iter().enumerate() {
            let found = row.cells.iter().enumerate().filter(|(_, cell)| cell.finding == finding);
            let place = |column| (LAWS + CELL.0 * count(column), HEADS + CELL.1 * count(line));
            places.extend(found.map(|(column, _)| place(column)));
        }
        cells(&mut canvas, finding, &places);
        let at = (12.0 + ENTRY * count(entry), bottom + GAP);
        cells(&mut canvas, finding, &[at]);
        let beside = (at.0 + CELL.0 + 8.0, at.1 + CELL.1 / 2.0);
        canvas.words(beside, word(finding), WORDS, Anchor::Start);
    }
    canvas.finish()
}

/// Cells of one finding: first their grounds, then their signs; no font is asked for a tick or a cross.
fn cells(canvas: &mut Canvas, finding: Finding, places: &[Point]) {
    let (fill, strength, ink) = match finding {
        Finding::Proved => (Ink::BLUE, 0.22, Ink::Text),
        Finding::Refuted => (Ink::VERMILION, 0.85, Ink::Paper),
        Finding::NotApplicable => (Ink::Grid, 0.6, Ink::Quiet),
        Finding::Undecided => (Ink::Paper, 1.0, Ink::Text),
    };
    let corners = |(x, y): &Point| ((x + 1.0, y + 1.0), (x + CELL.0 - 1.0, y + CELL.1 - 1.0));
    canvas.boxes(&places.iter().map(corners).collect::<Vec<_>>(), fill, strength);
    let strokes: &[&[Point]] = match finding {
        Finding::Proved => &[&[(-6.0, 0.0), (-2.0, 5.0), (6.0, -6.0)]],
        Finding::Refuted => &[&[(-5.0, -5.0), (5.0, 5.0)], &[(-5.0, 5.0), (5.0, -5.0)]],
        Finding::NotApplicable => &[&[(-5.0, 0.0), (5.0, 0.0)]],
        Finding::Undecided => &[],
    };
    let middle = |(x, y): &Point| (x + CELL.0 / 2.0, y + CELL.1 / 2.0);
    let signs = places.iter().map(middle).flat_map(|(x, y)| {
        strokes.iter().map(move |stroke| stroke.iter().map(|(a, b)| (x + a, y + b)).collect())
    });
    let signs: Vec<Vec<Point>> = signs.collect();
    canvas.lines(signs.iter().map(Vec::as_slice), Pen::new(ink, 2.0));
    for at in places.iter().map(middle).filter(|_| finding == Finding::Undecided) {
        canvas.words(at, "?", WORDS, Anchor::Middle);
        canvas.ring(at, 9.0, Pen::new(ink, 1.0));
    }
}
