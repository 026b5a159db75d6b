//! Where methods fail, as a picture: a panel for each hard case.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::stress::Row;
use plotters::prelude::*;

use super::chart_frame::{GRID, INKS, headed};
use crate::stability::PictureError;

const PANEL: (u32, u32) = (520, 290);
const COLUMNS: usize = 2;
/// What no error is drawn below, and above: an answer that is not there.
const LEAST: f64 = 1e-17;
const MOST: f64 = 1e3;

/// The table of stress as SVG: the error, on a logarithmic scale, by how far each case is pushed.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn stress_picture(rows: &[Row]) -> Result<String, PictureError> {
    let mut cases: Vec<&str> = Vec::new();
    for row in rows {
        if !cases.contains(&row.case) {
            cases.push(row.case);
        }
    }
    let height = u32::try_from(cases.len().div_ceil(COLUMNS)).unwrap_or(1);
    let size = (PANEL.0 * u32::try_from(COLUMNS).unwrap_or(1), PANEL.1 * height);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        root.fill(&WHITE)?;
        let areas = root.split_evenly((usize::try_from(height).unwrap_or(1), COLUMNS));
        for (case, area) in cases.iter().zip(&areas) {
            let of_case: Vec<&Row> = rows.iter().filter(|row| row.case == *case).collect();
            let mut places: Vec<&str> = Vec::new();
            let mut methods: Vec<(&str, &str)> = Vec::new();
            for row in &of_case {
                if !places.contains(&row.to.as_str()) {
                    places.push(&row.to);
                }
                if !methods.contains(&(row.method, row.pushed)) {
                    methods.push((row.method, row.pushed));
                }
            }
            let last = places.len().saturating_sub(1);
            let ink = |index: usize| INKS[index % INKS.len()].stroke_width(2);
            let looks: Vec<(&str, ShapeStyle)> =
                methods.iter().enumerate().map(|(n, (method, _))| (*method, ink(n))).collect();
            let area = headed(area, case, &looks)?;
            let mut chart = ChartBuilder::on(&area)
                .margin(8)
                .x_label_area_size(36)
                .y_label_area_size(58)
                .build_cartesian_2d(-0.3..float(last) + 0.3, (LEAST..MOST).log_scale())?;
            let pushed = of_case.first().map_or("", |row| row.pushed);
            chart
                .configure_mesh()
                .x_desc(if methods.iter().all(|(_, p)| *p == pushed) {
                    pushed
                } else {
                    "pushed by"
                })
                .y_desc("error")
                .x_labels(places.len())
                .x_label_formatter(&|x| nearest(&places, *x))
                .y_labels(6)
                .y_label_formatter(&|y| super::small(*y))
                .light_line_style(TRANSPARENT)
                .bold_line_style(GRID)
                .draw()?;
            for (index, (method, pushed)) in methods.iter().enumerate() {
                let ink = ink(index);
                let points: Vec<(f64, f64)> = of_case
                    .iter()
                    .filter(|row| (row.method, row.pushed) == (*method, *pushed))
                    .filter_map(|row| {
                        let place = places.iter().position(|place| *place == row.to)?;
                        Some((float(place), row.error.clamp(LEAST, MOST)))
                    })
                    .collect();
                chart.draw_series(LineSeries::new(points.clone(), ink))?;
                let dots = points.into_iter().map(|point| Circle::new(point, 3, ink.filled()));
                chart.draw_series(dots)?;
            }
        }
        root.present()?;
    }
    Ok(svg)
}

fn float(n: usize) -> f64 {
    f64::from(u32::try_from(n).unwrap_or(u32::MAX))
}

/// The name of the place at a tick, where there is one.
fn nearest(places: &[&str], x: f64) -> String {
    let found = places.iter().enumerate().find(|(index, _)| (float(*index) - x).abs() < 0.05);
    found.map_or_else(String::new, |(_, place)| (*place).to_owned())
}
