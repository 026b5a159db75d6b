//! The sheet that a figure is drawn on.
//!
//! The plotting library places everything on whole pixels, which shows as a wobble in smooth lines. A
//! sheet is therefore drawn four times as large as it is shown.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::TextStyle;

use super::{NUMBERS, TITLE};
use crate::stability::PictureError;

pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Pixels of the library to a pixel of the picture.
const FINE: i32 = 4;
/// Pixels of the picture from one note to the next.
const NOTE: i32 = 17;

/// A length of the picture, in pixels of the library.
pub(crate) const fn px(length: i32) -> i32 {
    length * FINE
}

/// The same, for what the library counts without a sign.
pub(crate) const fn upx(length: i32) -> u32 {
    px(length).unsigned_abs()
}

/// The type of this size.
pub(crate) fn font(size: i32) -> TextStyle<'static> {
    ("sans-serif", px(size)).into_text_style(&(0, 0))
}

/// How high the notes are, in pixels of the picture.
pub(crate) fn footer(notes: &[String]) -> i32 {
    NOTE * i32::try_from(lines(notes).len()).unwrap_or(0) + 12
}

fn lines(notes: &[String]) -> Vec<String> {
    notes.iter().flat_map(|note| wrapped(note, 145)).collect()
}

/// A sheet of this size in pixels of the picture, with a title and notes, and the rest by `draw`.
pub(crate) fn sheet(
    (width, height): (i32, i32),
    title: &str,
    notes: &[String],
    draw: impl FnOnce(&Area<'_>) -> Result<(), PictureError>,
) -> Result<String, PictureError> {
    let size = (upx(width), upx(height));
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        root.fill(&WHITE)?;
        root.draw(&Text::new(title.to_owned(), (px(12), px(10)), font(TITLE)))?;
        draw(&root)?;
        let first = height - footer(notes) + 6;
        for (note, n) in lines(notes).into_iter().zip(0..) {
            let at = (px(12), px(first + NOTE * n));
            root.draw(&Text::new(note, at, font(NUMBERS)))?;
        }
        root.present()?;
    }
    // shown at its size, whatever it was drawn at
    let drawn = format!("width=\"{}\" height=\"{}\"", size.0, size.1);
    let shown = format!("width=\"{width}\" height=\"{height}\"");
    Ok(merged(&svg.replacen(&drawn, &shown, 1)))
}

/// Neighbouring lines of one style as one path: every dash is a line of its own to the library, which
/// makes a picture twice as long.
fn merged(svg: &str) -> String {
    let mut out = String::new();
    let mut style = None;
    for line in svg.lines() {
        let parts = line
            .strip_prefix("<polyline ")
            .and_then(|rest| rest.strip_suffix("\"/>"))
            .and_then(|rest| rest.split_once(" points=\""));
        if style.is_some() && style != parts.map(|(style, _)| style) {
            out.push_str("\"/>\n");
        }
        match parts {
            Some((own, points)) => {
                if style != Some(own) {
                    out.extend(["<path ", own, " d=\""]);
                }
                // what follows the first point of an M is joined by lines
                out.push('M');
                out.push_str(points.trim_end());
            }
            None => out.extend([line, "\n"]),
        }
        style = parts.map(|(style, _)| style);
    }
    out
}

/// Words in lines of so many characters.
pub(crate) fn wrapped(words: &str, columns: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in words.split(' ') {
        let line = lines.last().map_or(0, |line| line.chars().count());
        if line > 0 && line + 1 + word.chars().count() > columns {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(word);
        }
    }
    lines
}
