//! The picture of speed against accuracy: one panel for each quantity of each law.

use kane_measure::chart::{Measured, front};
use kane_number::System;
use plotters::coord::Shift;
use plotters::prelude::*;

use super::{ChartReport, reach};
use crate::shorten::shorten;
use crate::stability::PictureError;

/// Size of a panel and of the header, in pixels; panels in a row.
const PANEL: (u32, u32) = (620, 380);
const HEADER: u32 = 78;
const COLUMNS: usize = 2;
/// Where exact methods are drawn, in hundredths of digits.
const EXACT: i64 = 3800;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Colours of the palette by Okabe and Ito, which colour-blind people tell apart; shapes differ, too.
pub(crate) const fn colour(system: System) -> RGBColor {
    match system {
        System::F32 => RGBColor(213, 94, 0),
        System::F64 => RGBColor(0, 114, 178),
        System::DoubleDouble => RGBColor(0, 158, 115),
        System::Interval => RGBColor(204, 121, 167),
        System::Rational => RGBColor(0, 0, 0),
    }
}

/// Every method that was timed, as SVG: decimal digits that are right at the worst input, against
/// the time; the Pareto front is a line, and its methods bear their names.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn picture(report: &ChartReport<'_>) -> Result<String, PictureError> {
    let groups = report.groups();
    let front = front(report.all);
    let rows = groups.len().div_ceil(COLUMNS).max(1);
    let height = PANEL.1 * u32::try_from(rows).unwrap_or(1);
    let width = PANEL.0 * u32::try_from(COLUMNS).unwrap_or(1);
    let mut svg = String::new();
    {
        let root =
            SVGBackend::with_string(&mut svg, (width, HEADER + height + 40)).into_drawing_area();
        root.fill(&WHITE)?;
        let (header, rest) = root.split_vertically(HEADER);
        let (panels, footer) = rest.split_vertically(height);
        draw_header(&header)?;
        let areas = panels.split_evenly((rows, COLUMNS));
        for (((law, quantity), group), area) in groups.iter().zip(&areas) {
            let members: Vec<(&Measured, bool)> = group
                .iter()
                .filter_map(|i| Some((report.all.get(*i)?, front.get(*i).copied()?)))
                .collect();
            panel(area, &format!("{law}: {quantity}"), &members)?;
        }
        let font = ("sans-serif", 13).into_font();
        footer.draw(&Text::new(report.machine.clone(), (12, 2), font.clone()))?;
        let command = format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
        footer.draw(&Text::new(command, (12, 20), font))?;
        root.present()?;
    }
    Ok(svg)
}

/// Title and legend, above all panels so that it covers no data.
fn draw_header(area: &Area<'_>) -> Result<(), PictureError> {
    let title = "What does the next digit cost? Decimal digits right at the worst input, by time";
    area.draw(&Text::new(title, (12, 10), ("sans-serif", 20).into_font()))?;
    let mut x = 20;
    for system in System::ALL {
        marker(area, (x, 56), system)?;
        let name = system.to_string();
        area.draw(&Text::new(name.clone(), (x + 12, 49), ("sans-serif", 14).into_font()))?;
        x += 46 + 8 * i32::try_from(name.len()).unwrap_or(10);
    }
    let line = vec![(x, 56), (x + 26, 56)];
    area.draw(&PathElement::new(line, RGBColor(120, 120, 120).stroke_width(2)))?;
    let text = "Pareto front: nothing else is both cheaper and better";
    area.draw(&Text::new(text, (x + 34, 49), ("sans-serif", 14).into_font()))?;
    Ok(())
}

fn marker(area: &Area<'_>, at: (i32, i32), system: System) -> Result<(), PictureError> {
    let style = colour(system).filled();
    match system {
        System::F32 => area.draw(&TriangleMarker::new(at, 6, style))?,
        System::F64 => area.draw(&Circle::new(at, 5, style))?,
        System::DoubleDouble => {
            area.draw(&Rectangle::new([(at.0 - 4, at.1 - 4), (at.0 + 4, at.1 + 4)], style))?;
        }
        System::Interval => {
            area.draw(&Cross::new(at, 5, colour(system).stroke_width(2)))?;
        }
        System::Rational => {
            area.draw(&Circle::new(at, 5, colour(system).stroke_width(2)))?;
        }
    }
    Ok(())
}

fn panel(
    area: &Area<'_>,
    caption: &str,
    members: &[(&Measured, bool)],
) -> Result<(), PictureError> {
    let time = |m: &Measured| m.time.as_ref().map_or(1, |time| time.median.max(1));
    let height = |m: &Measured| if m.accuracy.worst == i64::MAX { EXACT } else { m.accuracy.worst };
    let least = members.iter().map(|(m, _)| time(m)).min().unwrap_or(1000);
    let most = members.iter().map(|(m, _)| time(m)).max().unwrap_or(1000);
    let range = (least / 2).max(1)..most.saturating_mul(8);
    let mut chart = ChartBuilder::on(area)
        .caption(caption, ("sans-serif", 15))
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(52)
        .build_cartesian_2d(range.log_scale(), -150_i64..4200)?;
    chart
        .configure_mesh()
        .x_desc("time of one evaluation, ns")
        .y_desc("digits right, worst input")
        .x_labels(8)
        .y_labels(9)
        .x_label_formatter(&|picoseconds| super::nanoseconds(*picoseconds))
        .y_label_formatter(&|hundredths| match *hundredths {
            EXACT.. => "exact".to_owned(),
            h => (h / 100).to_string(),
        })
        .light_line_style(TRANSPARENT)
        .bold_line_style(RGBColor(225, 225, 225))
        .draw()?;
    let mut line: Vec<(u64, i64)> =
        members.iter().filter(|(_, front)| *front).map(|(m, _)| (time(m), height(m))).collect();
    line.sort_unstable();
    chart.draw_series(LineSeries::new(line, RGBColor(120, 120, 120).stroke_width(2)))?;
    let plot = chart.plotting_area();
    let mut labels: Vec<(i32, i32)> = Vec::new();
    for (measured, on_front) in members {
        let at = plot.map_coordinate(&(time(measured), height(measured)));
        marker(&area.strip_coord_spec(), local(area, at), measured.method.system)?;
        if *on_front {
            let (x, mut y) = local(area, at);
            // labels of neighbours in a column give way downward
            while labels.iter().any(|(a, b)| (a - x).abs() < 150 && (b - y).abs() < 13) {
                y += 13;
            }
            labels.push((x, y));
            let text = format!("{} {}", measured.method.name, measured.method.text);
            let own = || match measured.method.name {
                "columns" => "the law's code, in columns".to_owned(),
                _ => "the law's code".to_owned(),
            };
            let text = if measured.method.is_law { own() } else { text };
            let bound = measured
                .proved
                .as_ref()
                .map(|p| format!(", proved: {} ulp to {}", p.ulps, reach(p)));
            let text = shorten(&text, 34) + &bound.unwrap_or_default();
            let font = ("sans-serif", 11).into_font();
            area.draw(&Text::new(text, (x + 9, y + 2), font))?;
        }
    }
    Ok(())
}

/// A pixel of the whole picture as one of an area.
fn local(area: &Area<'_>, (x, y): (i32, i32)) -> (i32, i32) {
    let (columns, rows) = area.get_pixel_range();
    (x - columns.start, y - rows.start)
}
