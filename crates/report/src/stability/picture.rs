//! A picture: digits lost against the binade of the input, one panel a formula.

use std::collections::BTreeSet;

use kane_measure::{Examined, Fault, Plane};
use plotters::coord::Shift;
use plotters::prelude::*;

use super::{Entry, StabilityReport, title};
use crate::shorten::shorten;

/// Size of a panel and of the header, in pixels; panels in a row.
const PANEL: (u32, u32) = (460, 250);
const HEADER: u32 = 74;
const COLUMNS: usize = 3;

/// Blue and vermilion of the palette by Okabe and Ito, which colour-blind people tell apart.
const DOUBLE: RGBColor = RGBColor(0, 114, 178);
const SINGLE: RGBColor = RGBColor(213, 94, 0);
/// Faults in a plane, worst first, and lost digits from few to all.
const NAN: RGBColor = RGBColor(0, 0, 0);
const INFINITE: RGBColor = RGBColor(204, 121, 167);
const SIGN: RGBColor = RGBColor(213, 94, 0);
const VANISHES: RGBColor = RGBColor(86, 180, 233);
const LOST: RGBColor = RGBColor(230, 159, 0);
const SOUND: RGBColor = RGBColor(235, 235, 235);

/// The picture could not be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PictureError(String);

impl std::fmt::Display for PictureError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "the picture cannot be drawn: {}", self.0)
    }
}

impl std::error::Error for PictureError {}

impl<E: std::error::Error + Send + Sync> From<DrawingAreaErrorKind<E>> for PictureError {
    fn from(error: DrawingAreaErrorKind<E>) -> Self {
        Self(error.to_string())
    }
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Every formula that fails, as SVG. One input: bits lost by the binade of the input, in both
/// formats; two inputs: the plane of both binades in `f64`, by the fault.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn picture(report: &StabilityReport<'_>) -> Result<String, PictureError> {
    let entries = report.entries();
    // a search has no picture
    let is_drawn =
        |entry: &&Entry<'_>| entry.fails() && !(entry.lines.is_empty() && entry.planes.is_empty());
    let failing: Vec<&Entry<'_>> = entries.iter().filter(is_drawn).collect();
    let rows = u32::try_from(failing.len().div_ceil(COLUMNS).max(1)).unwrap_or(1);
    let columns = u32::try_from(COLUMNS).unwrap_or(1);
    let size = (PANEL.0 * columns, HEADER + PANEL.1 * rows + 24);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        root.fill(&WHITE)?;
        let (header, rest) = root.split_vertically(HEADER);
        let (panels, footer) = rest.split_vertically(PANEL.1 * rows);
        draw_header(&header, report)?;
        let areas = panels.split_evenly((usize::try_from(rows).unwrap_or(1), COLUMNS));
        for (entry, area) in failing.iter().zip(&areas) {
            if entry.planes.is_empty() {
                lines(area, entry)?;
            } else if let Some(plane) = entry.planes.iter().find(|plane| plane.format == "f64") {
                draw_plane(area, entry, plane)?;
            }
        }
        let text = format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
        footer.draw(&Text::new(text, (12, 4), ("sans-serif", 12).into_font()))?;
        root.present()?;
    }
    Ok(svg)
}

/// Title and legend, above all panels so that it covers no data.
fn draw_header(area: &Area<'_>, report: &StabilityReport<'_>) -> Result<(), PictureError> {
    let title = report.stability.title.as_deref().unwrap_or(&report.stability.name);
    let title = format!("{title}: bits lost, by the binade of the input");
    area.draw(&Text::new(title, (12, 8), ("sans-serif", 20).into_font()))?;
    let font = || ("sans-serif", 13).into_font();
    for (x, colour, name) in [(12, DOUBLE, "f64 (53 bits)"), (130, SINGLE, "f32 (24 bits)")] {
        area.draw(&PathElement::new(vec![(x, 54), (x + 24, 54)], colour.stroke_width(3)))?;
        area.draw(&Text::new(name, (x + 30, 47), font()))?;
    }
    area.draw(&Text::new("dotted: half of the bits; thin: below 0", (250, 47), font()))?;
    area.draw(&Text::new("planes, f64:", (500, 47), font()))?;
    let legend = [
        (SOUND, "sound"),
        (LOST, "digits lost"),
        (VANISHES, "0 instead"),
        (SIGN, "wrong sign"),
        (INFINITE, "infinite"),
        (NAN, "NaN"),
    ];
    let mut x = 585;
    for (colour, name) in legend {
        area.draw(&Rectangle::new([(x, 48), (x + 14, 60)], colour.filled()))?;
        area.draw(&Rectangle::new([(x, 48), (x + 14, 60)], BLACK.stroke_width(1)))?;
        area.draw(&Text::new(name, (x + 20, 47), font()))?;
        x += 36 + 7 * i32::try_from(name.len()).unwrap_or(10);
    }
    Ok(())
}

fn caption(entry: &Entry<'_>) -> String {
    let formula = entry.formula;
    let with = if formula.by.is_empty() {
        String::new()
    } else {
        format!(", with {}", formula.by.join(", "))
    };
    shorten(&format!("{}{with}", title(formula)), 62)
}

fn lines(area: &Area<'_>, entry: &Entry<'_>) -> Result<(), PictureError> {
    let input = entry.formula.inputs.first().map_or("", |input| input.name.as_str());
    let mut chart = ChartBuilder::on(area)
        .caption(caption(entry), ("sans-serif", 13))
        .margin(8)
        .x_label_area_size(34)
        .y_label_area_size(44)
        .build_cartesian_2d(-1074_i64..1024, 0_i64..5600)?;
    chart
        .configure_mesh()
        .x_desc(format!("log2 |{input}|"))
        .y_desc("bits lost")
        .x_labels(9)
        .y_labels(6)
        .y_label_formatter(&|hundredths| (hundredths / 100).to_string())
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(225, 225, 225))
        .draw()?;
    for (format, colour) in [("f64", DOUBLE), ("f32", SINGLE)] {
        for line in entry.lines.iter().filter(|line| line.format == format) {
            let half = 50 * i64::from(line.precision);
            let ends = |examined: &Examined| -> Option<(i64, i64)> {
                Some((examined.profile.first()?.0, examined.profile.last()?.0))
            };
            if let Some((first, last)) = ends(line) {
                let step = ((last - first) / 60).max(1);
                let steps = usize::try_from(step).unwrap_or(1);
                for start in (first..last).step_by(2 * steps) {
                    let dash = vec![(start, half), (start + step, half)];
                    chart.draw_series(std::iter::once(PathElement::new(dash, colour)))?;
                }
            }
            let points = super::thinned(line).into_iter().map(|(binade, lost, _)| (binade, lost));
            let width = if line.negative { 1 } else { 2 };
            chart.draw_series(LineSeries::new(points, colour.stroke_width(width)))?;
        }
    }
    Ok(())
}

fn draw_plane(area: &Area<'_>, entry: &Entry<'_>, plane: &Plane) -> Result<(), PictureError> {
    let name =
        |index: usize| entry.formula.inputs.get(index).map_or("", |input| input.name.as_str());
    let ends = |of: &dyn Fn((i64, i64)) -> i64| {
        let all = || plane.cells.iter().map(|cell| of(cell.binades));
        (all().min().unwrap_or(0), all().max().unwrap_or(1))
    };
    let (x, y) = (ends(&|(x, _)| x), ends(&|(_, y)| y));
    // the widest gap between neighbours of the grid, so that no gap shows
    let step = |of: &dyn Fn((i64, i64)) -> i64| {
        let all: BTreeSet<i64> = plane.cells.iter().map(|cell| of(cell.binades)).collect();
        all.iter().zip(all.iter().skip(1)).map(|(a, b)| b - a).max().unwrap_or(1)
    };
    let (width, height) = (step(&|(x, _)| x), step(&|(_, y)| y));
    let mut chart = ChartBuilder::on(area)
        .caption(caption(entry), ("sans-serif", 13))
        .margin(8)
        .x_label_area_size(34)
        .y_label_area_size(52)
        .build_cartesian_2d(x.0..x.1 + width, y.0..y.1 + height)?;
    chart
        .configure_mesh()
        .disable_mesh()
        .x_desc(format!("log2 {}", name(0)))
        .y_desc(format!("log2 {}", name(1)))
        .x_labels(7)
        .y_labels(6)
        .draw()?;
    chart.draw_series(plane.cells.iter().map(|cell| {
        let (x, y) = cell.binades;
        let colour = match cell.sample.fault {
            None => SOUND,
            Some(Fault::Lost) => LOST,
            Some(Fault::Vanishes) => VANISHES,
            Some(Fault::WrongSign) => SIGN,
            Some(Fault::Infinite) => INFINITE,
            Some(Fault::Nan) => NAN,
        };
        Rectangle::new([(x, y), (x + width, y + height)], colour.filled())
    }))?;
    Ok(())
}
