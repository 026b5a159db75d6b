//! Routh's diagram of a tip's impact.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Event, ImpulsePlane, PlaneLine};
use plotters::prelude::*;

use super::chart_frame::{GRID, INKS, SIZE, headed};
use super::{SceneReport, brief};
use crate::stability::PictureError;

fn look(line: PlaneLine) -> (&'static str, ShapeStyle) {
    match line {
        PlaneLine::Cone => ("friction cone", INKS[4].stroke_width(2)),
        PlaneLine::Stick => ("no slip", INKS[2].stroke_width(2)),
        PlaneLine::Compression => ("greatest compression", INKS[0].stroke_width(2)),
    }
}

fn words(event: Event) -> &'static str {
    match event {
        // it is the origin
        Event::Start => "",
        Event::Stick => "sticks",
        Event::Reverse => "slides back",
        Event::Compressed => "compression ends",
        Event::End => "impulse",
    }
}

/// The impact in the plane of its impulse, as SVG.
pub(super) fn impulse_picture(
    report: &SceneReport<'_>,
    plane: &ImpulsePlane,
) -> Result<String, PictureError> {
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        let path = INKS[1].stroke_width(3);
        let lines = [PlaneLine::Cone, PlaneLine::Stick, PlaneLine::Compression].map(look);
        let legend: Vec<_> = lines.into_iter().chain([("the impulse as it grows", path)]).collect();
        let area = headed(&root, &format!("{}: its impulse", report.title), &legend)?;
        let [low, high] = plane.frame;
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .x_label_area_size(40)
            .y_label_area_size(76)
            .build_cartesian_2d(low[0]..high[0], low[1]..high[1])?;
        chart
            .configure_mesh()
            .x_desc("tangential impulse p_t, N·s")
            .y_desc("normal impulse p_n, N·s")
            .x_label_formatter(&|x| brief(*x))
            .y_label_formatter(&|y| brief(*y))
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID)
            .draw()?;
        for (line, ends) in &plane.lines {
            let ends = ends.map(|[x, y]| (x, y));
            chart.draw_series(LineSeries::new(ends, look(*line).1))?;
        }
        let points: Vec<(f64, f64)> = plane.path.iter().map(|(_, [x, y])| (*x, *y)).collect();
        chart.draw_series(LineSeries::new(points.clone(), path))?;
        chart.draw_series(points.iter().map(|at| Circle::new(*at, 4, INKS[1].filled())))?;
        let font = || ("sans-serif", 13).into_font();
        for (event, [x, y]) in &plane.path {
            // beside the point, away from the axis of the cone
            let (px, py) = chart.backend_coord(&(*x, *y));
            let text = words(*event);
            let wide = 7 * i32::try_from(text.len()).unwrap_or(0);
            let at = if *x < 0.0 { (px - wide - 10, py - 6) } else { (px + 12, py - 6) };
            root.draw(&Text::new(text, at, font()))?;
        }
        root.present()?;
    }
    Ok(svg)
}
