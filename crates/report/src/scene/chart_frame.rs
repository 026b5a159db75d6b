//! A sheet for a chart: the title, the legend below it where it hides nothing, and the plot.

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::stability::PictureError;

/// Where charts are drawn.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// The size of a chart in pixels.
pub(super) const SIZE: (u32, u32) = (860, 470);

/// Title and legend, in pixels.
const HEADER: u32 = 62;

/// Blue, vermilion, green and purple of the palette by Okabe and Ito, and grey.
pub(super) const INKS: [RGBColor; 5] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(120, 120, 120),
];

pub(super) const GRID: RGBColor = RGBColor(225, 225, 225);

/// Fills the sheet, heads it, and returns what is left for the plot.
pub(super) fn headed<'a>(
    root: &Area<'a>,
    title: &str,
    legend: &[(&str, ShapeStyle)],
) -> Result<Area<'a>, PictureError> {
    root.fill(&WHITE)?;
    root.draw(&Text::new(title.to_owned(), (12, 8), ("sans-serif", 17).into_font()))?;
    let mut x = 14;
    for (words, style) in legend {
        root.draw(&PathElement::new(vec![(x, 44), (x + 22, 44)], *style))?;
        root.draw(&Text::new((*words).to_owned(), (x + 28, 37), ("sans-serif", 13).into_font()))?;
        // sans-serif of this size is about seven pixels a character
        x += 28 + 8 * i32::try_from(words.chars().count()).unwrap_or(0) + 18;
    }
    Ok(root.split_vertically(HEADER).1)
}
