//! The matrix as a picture: a cell a law and property, each with its sign, so that it never rests on colour.

use kane_matrix::Finding;
use plotters::prelude::*;
use plotters::style::FontTransform;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::{FINDINGS, MatrixReport, word};
use crate::figures::sheet::{Area, font, footer, px, sheet, upx};
use crate::figures::{NUMBERS, WORDS};
use crate::stability::PictureError;

/// Sizes in pixels of the picture: of a cell, of the heads of rows and of columns, of the title.
const CELL: (i32, i32) = (38, 26);
const LAWS: i32 = 176;
const HEADS: i32 = 268;
const TITLE: i32 = 40;
const MARGIN: i32 = 12;
/// From the matrix to the legend, how high that is, and from one of its entries to the next.
const GAP: i32 = 16;
const LEGEND: i32 = 50;
const ENTRY: i32 = 170;

/// The matrix as SVG. Equal matrices give equal bytes.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn picture(report: &MatrixReport<'_>) -> Result<String, PictureError> {
    let matrix = report.matrix;
    let count = |n: usize| i32::try_from(n).unwrap_or(i32::MAX / 4096);
    let bottom = TITLE + HEADS + CELL.1 * count(matrix.rows.len());
    let columns = LAWS + CELL.0 * count(matrix.properties.len());
    let width = 2 * MARGIN + columns.max(ENTRY * count(FINDINGS.len()));
    let notes = [
        report.headline(),
        "* asked of every planar contact; the others where it does not couple, W_tn = 0".to_owned(),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    let height = bottom + GAP + LEGEND + footer(&notes);
    sheet((width, height), "Laws and properties", &notes, |area| {
        let words = font(NUMBERS).pos(Pos::new(HPos::Left, VPos::Center));
        let upright = words.transform(FontTransform::Rotate270);
        for (property, column) in matrix.properties.iter().zip(0..) {
            let at = (MARGIN + LAWS + CELL.0 * column + CELL.0 / 2, TITLE + HEADS - 6);
            let star = if property.domain.starts_with("every") { " *" } else { "" };
            area.draw(&Text::new(format!("{}{star}", property.name), pixel(at), upright.clone()))?;
        }
        for (row, line) in matrix.rows.iter().zip(0..) {
            let at = (MARGIN, TITLE + HEADS + CELL.1 * line + CELL.1 / 2);
            area.draw(&Text::new(row.law.info.id, pixel(at), words.clone()))?;
        }
        for finding in FINDINGS {
            let places = matrix.rows.iter().zip(0..).flat_map(|(row, line)| {
                row.cells.iter().zip(0..).map(move |(cell, column)| (cell, column, line))
            });
            let places: Vec<_> = places
                .filter(|(cell, ..)| cell.finding == finding)
                .map(|(_, column, line)| {
                    (MARGIN + LAWS + CELL.0 * column, TITLE + HEADS + CELL.1 * line)
                })
                .collect();
            cells(area, finding, &places)?;
        }
        for (finding, entry) in FINDINGS.into_iter().zip(0..) {
            let at = (MARGIN + ENTRY * entry, bottom + GAP);
            cells(area, finding, &[at])?;
            let beside = (at.0 + CELL.0 + 8, at.1 + CELL.1 / 2);
            area.draw(&Text::new(word(finding), pixel(beside), words.clone()))?;
        }
        Ok(())
    })
}

const fn pixel((x, y): (i32, i32)) -> (i32, i32) {
    (px(x), px(y))
}

/// Filling and ink: blue and orange of the palette by Okabe and Ito, light and dark in grey, too.
const fn paint(finding: Finding) -> (RGBColor, RGBColor) {
    match finding {
        Finding::Proved => (RGBColor(205, 229, 243), RGBColor(0, 70, 112)),
        Finding::Refuted => (RGBColor(190, 78, 0), WHITE),
        Finding::NotApplicable => (RGBColor(238, 238, 238), RGBColor(90, 90, 90)),
        Finding::Undecided => (WHITE, BLACK),
    }
}

/// Cells of one finding: first their grounds, then their signs, which the sheet makes one path.
fn cells(area: &Area<'_>, finding: Finding, places: &[(i32, i32)]) -> Result<(), PictureError> {
    let (fill, ink) = paint(finding);
    for &(x, y) in places {
        let corners = [pixel((x + 1, y + 1)), pixel((x + CELL.0 - 1, y + CELL.1 - 1))];
        area.draw(&Rectangle::new(corners, fill.filled()))?;
        if finding == Finding::Undecided {
            area.draw(&Rectangle::new(corners, ink.stroke_width(upx(1))))?;
        }
    }
    // strokes from the middle of a cell, in pixels; no font is asked for a tick or a cross
    let strokes: &[&[(i32, i32)]] = match finding {
        Finding::Proved => &[&[(-6, 0), (-2, 5), (6, -6)]],
        Finding::Refuted => &[&[(-5, -5), (5, 5)], &[(-5, 5), (5, -5)]],
        Finding::NotApplicable => &[&[(-5, 0), (5, 0)]],
        Finding::Undecided => &[],
    };
    let line = ink.stroke_width(upx(2));
    for &(x, y) in places {
        let (x, y) = (x + CELL.0 / 2, y + CELL.1 / 2);
        for stroke in strokes {
            let points: Vec<_> = stroke.iter().map(|(a, b)| pixel((x + a, y + b))).collect();
            area.draw(&PathElement::new(points, line))?;
        }
        if finding == Finding::Undecided {
            let style = font(WORDS).pos(Pos::new(HPos::Center, VPos::Center));
            area.draw(&Text::new("?", pixel((x, y)), style))?;
        }
    }
    Ok(())
}
