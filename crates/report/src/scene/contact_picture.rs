//! Spheres that touch at once, over the time of their contact.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::simulate::ContactTime;
use plotters::prelude::*;

use super::chart_frame::{Area, GRID, INKS, SIZE, headed};
use super::{SceneReport, brief};
use crate::stability::PictureError;

/// Velocities above, forces below, as SVG.
pub(super) fn contact_picture(
    report: &SceneReport<'_>,
    contact: &ContactTime,
) -> Result<String, PictureError> {
    let first = contact.moments.first();
    let (bodies, pairs) = first.map_or((0, 0), |m| (m.velocities.len(), m.forces.len()));
    let ink = |n: usize| INKS[n % INKS.len()].stroke_width(2);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, (SIZE.0, SIZE.1 + 130)).into_drawing_area();
        let spheres: Vec<String> = (1..=bodies).map(|n| format!("sphere {n}")).collect();
        let legend: Vec<_> =
            spheres.iter().enumerate().map(|(n, name)| (name.as_str(), ink(n))).collect();
        let title = format!("{}: velocities, and forces between neighbours", report.title);
        let area = headed(&root, &title, &legend)?;
        let (above, below) = area.split_vertically(280);
        let of = |values: &dyn Fn(usize) -> f64| -> Vec<(f64, f64)> {
            let times = contact.moments.iter().map(|moment| moment.time * 1e6);
            times.enumerate().map(|(index, time)| (time, values(index))).collect()
        };
        let velocities: Vec<_> =
            (0..bodies).map(|n| (of(&|m| contact.moments[m].velocities[n]), ink(n))).collect();
        panel(&above, "velocity, m/s", &velocities)?;
        // in the colour of the sphere that is pushed
        let forces: Vec<_> =
            (0..pairs).map(|n| (of(&|m| contact.moments[m].forces[n]), ink(n + 1))).collect();
        panel(&below, "force, N", &forces)?;
        for n in 0..pairs {
            let words = format!("{} on {}", n + 1, n + 2);
            let at = (760, 372 + 18 * i32::try_from(n).unwrap_or(0));
            let font = ("sans-serif", 13).into_font().color(&INKS[(n + 1) % INKS.len()]);
            root.draw(&Text::new(words, at, font))?;
        }
        root.present()?;
    }
    Ok(svg)
}

type Curve = (Vec<(f64, f64)>, ShapeStyle);

fn panel(area: &Area<'_>, what: &str, curves: &[Curve]) -> Result<(), PictureError> {
    let all = || curves.iter().flat_map(|(points, _)| points.iter().copied());
    let end = all().map(|(time, _)| time).fold(0.0, f64::max).max(f64::MIN_POSITIVE);
    let (low, high) =
        all().fold((0.0_f64, 0.0_f64), |(low, high), (_, y)| (low.min(y), high.max(y)));
    let margin = ((high - low) * 0.08).max(1e-300);
    let mut chart = ChartBuilder::on(area)
        .margin(10)
        .x_label_area_size(36)
        .y_label_area_size(76)
        .build_cartesian_2d(0.0..end, (low - margin)..(high + margin))?;
    chart
        .configure_mesh()
        .x_desc("time since the first touch, µs")
        .y_desc(what)
        .x_label_formatter(&|x| brief(*x))
        .y_label_formatter(&|y| brief(if y.abs() < margin / 1e6 { 0.0 } else { *y }))
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .draw()?;
    for (points, style) in curves {
        chart.draw_series(LineSeries::new(points.clone(), *style))?;
    }
    Ok(())
}
