//! The matrix as a picture: a cell a law and property, each with its sign, so that it never rests on colour.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_matrix::{Finding, Property, Row};

use super::finding::{breaking, conflicts, counts, refuted, sorted};
use super::{FINDINGS, MatrixReport, caveats, marked, word};
use crate::picture::{Anchor, Canvas, Ink, NUMBERS, Pen, Point, WORDS, count, length};

/// Sizes of a cell, and of the heads of rows and of columns.
const CELL: Point = (34.0, 26.0);
const LAWS: f64 = 158.0;
const HEADS: f64 = 262.0;
/// Between groups of columns, and the height of their names.
const APART: f64 = 12.0;
const GROUP: f64 = 26.0;
/// From the matrix to the legend, and from one of its entries to the next.
const GAP: f64 = 34.0;
const ENTRY: f64 = 170.0;

/// A column that is drawn.
struct Column {
    index: usize,
    property: &'static Property,
    left: f64,
}

/// The matrix as SVG, laws with the fewest refuted properties first, properties by groups, with counts at the edges
/// and with what it comes to below. Equal matrices give equal bytes.
#[must_use]
pub fn picture(report: &MatrixReport<'_>) -> String {
    let matrix = report.matrix;
    let rows = sorted(matrix);
    let (columns, all) = columns(report);
    let top = HEADS + GROUP;
    let bottom = top + CELL.1 * count(rows.len());
    let right = columns.last().map_or(LAWS, |column| column.left + CELL.0);
    let mut notes = conflicts(matrix);
    notes.push(breaking(matrix));
    if !all.is_empty() {
        notes.push(format!("No law breaks {}", all.join(", ")));
    }
    notes.push(report.headline());
    let mut notes = vec![
        format!("{}.", notes.join(". ")),
        "At the right: how many properties a law breaks; below: how many laws break a property. * asked of every planar \
         contact; the others where it does not couple, W_tn = 0."
            .to_owned(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    notes.splice(1..1, caveats(matrix));
    let width = (right + 40.0).max(ENTRY * count(FINDINGS.len())) + 12.0;
    let size = (width, bottom + GAP + CELL.1 + 18.0);
    let mut canvas = Canvas::new(size, "What each law breaks, fewest first", &notes);
    for column in &columns {
        let x = column.left + CELL.0 / 2.0;
        let star = if column.property.domain.starts_with("every") { " *" } else { "" };
        let name = format!("{}{star}", column.property.name);
        canvas.upright((x, HEADS - 6.0), &name, WORDS, Anchor::Start);
        let [refuted, _] = counts(matrix, column.index);
        canvas.words((x, bottom + 12.0), &refuted.to_string(), NUMBERS, Anchor::Middle);
    }
    for group in columns.chunk_by(|a, b| a.property.group == b.property.group) {
        let (Some(first), Some(last)) = (group.first(), group.last()) else { continue };
        let middle = f64::midpoint(first.left, last.left + CELL.0);
        let name = first.property.group;
        let line = HEADS + 3.0;
        canvas.line(&[(first.left + 2.0, line), (last.left + CELL.0 - 2.0, line)], RULE);
        let left = middle - length(name, WORDS) / 2.0;
        canvas.bold((left, line + 11.0), name, WORDS);
    }
    for (line, row) in rows.iter().enumerate() {
        let y = top + CELL.1 * (count(line) + 0.5);
        canvas.words((12.0, y), &marked(row), WORDS, Anchor::Start);
        canvas.words((right + 10.0, y), &refuted(row).to_string(), NUMBERS, Anchor::Start);
    }
    for (entry, finding) in FINDINGS.into_iter().enumerate() {
        let mut places: Vec<Point> = Vec::new();
        for (line, row) in rows.iter().enumerate() {
            let is_so = |column: &&Column| found(row, column.index) == Some(finding);
            let place = |column: &Column| (column.left, top + CELL.1 * count(line));
            places.extend(columns.iter().filter(is_so).map(place));
        }
        cells(&mut canvas, finding, &places);
        let at = (12.0 + ENTRY * count(entry), bottom + GAP);
        cells(&mut canvas, finding, &[at]);
        let beside = (at.0 + CELL.0 + 8.0, at.1 + CELL.1 / 2.0);
        canvas.words(beside, word(finding), WORDS, Anchor::Start);
    }
    canvas.finish()
}

const RULE: Pen = Pen::new(Ink::Quiet, 1.0);

fn found(row: &Row, column: usize) -> Option<Finding> {
    row.cells.get(column).map(|cell| cell.finding)
}

/// The columns by groups, and the names of those that are left out because every law has the property: of all there
/// are some, unless that would leave none.
fn columns(report: &MatrixReport<'_>) -> (Vec<Column>, Vec<&'static str>) {
    let matrix = report.matrix;
    let mut groups: Vec<&str> = matrix.properties.iter().map(|property| property.group).collect();
    let mut seen = Vec::new();
    groups.retain(|group| {
        !seen.contains(group) && {
            seen.push(*group);
            true
        }
    });
    let is_whole = |index: usize| counts(matrix, index)[1] == matrix.rows.len();
    let mut indices: Vec<usize> = (0..matrix.properties.len()).collect();
    let mut all = Vec::new();
    if !indices.iter().all(|index| is_whole(*index)) {
        indices.retain(|index| {
            let whole = is_whole(*index);
            all.extend(matrix.properties.get(*index).filter(|_| whole).map(|p| p.id));
            !whole
        });
    }
    let place = |index: &usize| {
        let group = matrix.properties.get(*index).map(|property| property.group);
        groups.iter().position(|name| Some(*name) == group)
    };
    indices.sort_by_key(place);
    let mut columns: Vec<Column> = Vec::new();
    for index in indices {
        let Some(&property) = matrix.properties.get(index) else { continue };
        let left = columns.last().map_or(LAWS, |last| {
            let apart = if last.property.group == property.group { 0.0 } else { APART };
            last.left + CELL.0 + apart
        });
        columns.push(Column { index, property, left });
    }
    (columns, all)
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

#[cfg(test)]
mod tests {
    use kane_matrix::PROPERTIES;

    use super::super::made_up::matrix;
    use super::*;

    #[test]
    fn what_every_law_has_is_said_in_words_and_what_one_lacks_is_drawn() {
        let told = |rows: &[&str]| {
            let matrix = matrix(rows);
            let (drawn, all) = columns(&MatrixReport { matrix: &matrix, command: String::new() });
            let drawn: Vec<usize> = drawn.iter().map(|column| column.index).collect();
            (drawn, all)
        };
        let id = |index: usize| PROPERTIES[index].id;
        assert_eq!(told(&["yny", "yyy"]), (vec![1], vec![id(0), id(2)]));
        // what has no meaning for a law is not had by it
        assert_eq!(told(&["y-", "yy"]), (vec![1], vec![id(0)]));
        // unless nothing would be left
        assert_eq!(told(&["yy", "yy"]), (vec![0, 1], vec![]));
        assert_eq!(told(&["nn", "yn"]), (vec![0, 1], vec![]));
    }

    #[test]
    fn columns_of_one_group_stand_together() {
        let width = PROPERTIES.len();
        let matrix = matrix(&["n".repeat(width).as_str()]);
        let (drawn, _) = columns(&MatrixReport { matrix: &matrix, command: String::new() });
        let groups: Vec<&str> = drawn.iter().map(|column| column.property.group).collect();
        let mut runs = groups.clone();
        runs.dedup();
        let mut names = groups.clone();
        names.sort_unstable();
        names.dedup();
        assert_eq!((groups.len(), runs.len()), (width, names.len()));
        for pair in drawn.windows(2) {
            let apart = pair[1].left - pair[0].left;
            let same = pair[0].property.group == pair[1].property.group;
            assert_eq!(apart, if same { CELL.0 } else { CELL.0 + APART });
        }
    }
}
