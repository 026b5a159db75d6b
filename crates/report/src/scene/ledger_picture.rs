//! The energy ledger, and error against cost, as pictures.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Bounced, Judged, Known, Verdict};
use plotters::prelude::*;

use super::SceneReport;
use super::chart_frame::{GRID, INKS, SIZE, headed};
use crate::stability::PictureError;

const PARTS: [(&str, RGBColor); 4] =
    [("normal", INKS[0]), ("tangential", INKS[1]), ("rotational", INKS[2]), ("gravity", INKS[4])];

/// The ledger as SVG: what impacts have done to the energy so far, by part, and what gravity has;
/// `None` without impacts to show.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn ledger_picture(report: &SceneReport<'_>) -> Result<Option<String>, PictureError> {
    let sums: &[Bounced] = &report.answer.sums;
    let Some(last) = sums.last() else { return Ok(None) };
    let all = || sums.iter().flat_map(|sum| sum.parts).chain([0.0]);
    let (low, high) =
        (all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max));
    // where nothing changes, the energy itself gives the scale
    let extent = if high > low { high - low } else { report.answer.start_energy.max(1e-300) };
    let margin = extent * 0.08;
    // a while after the last impact, so that its step is seen
    let end = last.time * 1.06;
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        let looks = PARTS.map(|(name, ink)| (name, ink.stroke_width(2)));
        let area = headed(&root, &format!("{}: energy by part", report.title), &looks)?;
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .x_label_area_size(38)
            .y_label_area_size(76)
            .build_cartesian_2d(0.0..end, (low - margin)..(high + margin))?;
        chart
            .configure_mesh()
            .x_desc("time, s")
            .y_desc("change of energy so far, J")
            // the axis counts in steps that round: its zero is only near it
            .y_label_formatter(&|y| super::brief(if y.abs() < margin / 1e6 { 0.0 } else { *y }))
            .x_label_formatter(&|x| super::brief(*x))
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID)
            .draw()?;
        for (part, (_, look)) in looks.iter().enumerate() {
            let mut points = vec![(0.0, 0.0)];
            let mut level = 0.0;
            for sum in sums {
                points.push((sum.time, level));
                level = sum.parts[part];
                points.push((sum.time, level));
            }
            points.push((end, level));
            chart.draw_series(LineSeries::new(points, *look))?;
        }
        root.present()?;
    }
    Ok(Some(svg))
}

/// The height of a label in pixels.
const LABEL: i32 = 13;

/// What no error is drawn below.
const LEAST: f64 = 1e-18;

/// Error by tolerance against counted cost, as SVG, for every model that was tried and has an error.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn compare_picture(report: &SceneReport<'_>) -> Result<String, PictureError> {
    let drawn: Vec<(&Judged, f64, f64)> = report
        .answer
        .judged
        .iter()
        .filter_map(|judged| {
            let cost = f64::from(u32::try_from(judged.cost).unwrap_or(u32::MAX));
            Some((judged, cost, judged.ratio?.clamp(LEAST, 1e18)))
        })
        .collect();
    let most = drawn.iter().map(|(_, cost, _)| *cost).fold(100.0, f64::max);
    let worst = drawn.iter().map(|(.., ratio)| *ratio).fold(10.0, f64::max);
    let best = drawn.iter().map(|(.., ratio)| *ratio).fold(0.1, f64::min);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        let tolerance = RGBColor(213, 94, 0).stroke_width(2);
        let title = format!("{}: error against cost", report.title);
        let looks = [
            ("the tolerance", tolerance),
            ("good enough; the chosen one is full", INKS[2].stroke_width(2)),
            ("not, or not known to be", INKS[4].stroke_width(2)),
        ];
        let area = headed(&root, &title, &looks)?;
        let costs = (20.0..most * 12.0).log_scale();
        let ratios = (best / 10.0..worst * 10.0).log_scale();
        let mut chart = ChartBuilder::on(&area)
            .margin(12)
            .x_label_area_size(38)
            .y_label_area_size(72)
            .build_cartesian_2d(costs, ratios)?;
        chart
            .configure_mesh()
            .x_desc("cost of an impact, additions of f64")
            .y_desc(match report.answer.known {
                Some(Known::Estimated) => "worst error by its tolerance, estimated",
                _ => "worst error by its tolerance",
            })
            .x_label_formatter(&|x| super::small(*x))
            .y_label_formatter(&|y| super::small(*y))
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID)
            .draw()?;
        let line = vec![(20.0, 1.0), (most * 12.0, 1.0)];
        chart.draw_series(LineSeries::new(line, tolerance))?;
        let mut labels: Vec<(String, f64, f64)> = Vec::new();
        for (judged, cost, ratio) in drawn {
            let good = judged.verdict == Verdict::Meets;
            let ink = if good { INKS[2] } else { INKS[4] };
            let chosen = report.answer.chosen == Some(judged.model);
            let style = if chosen { ink.filled() } else { ink.stroke_width(2) };
            chart.draw_series(std::iter::once(Circle::new((cost, ratio), 5, style)))?;
            // models in one place share a label
            match labels.iter_mut().find(|(_, x, y)| *x == cost && (ratio / *y).ln().abs() < 0.2) {
                Some((text, ..)) => text.push_str(&format!(", {}", judged.model.system)),
                None => labels.push((judged.model.to_string(), cost, ratio)),
            }
        }
        // beside its circle, and lower where another one is in the way
        let mut taken: Vec<[i32; 3]> = Vec::new();
        labels.sort_by(|a, b| b.2.total_cmp(&a.2).then(a.1.total_cmp(&b.1)));
        for (text, cost, ratio) in labels {
            let (x, y) = chart.backend_coord(&(cost, ratio));
            let (left, mut top) = (x + 9, y - 6);
            let right = left + 7 * i32::try_from(text.len()).unwrap_or(0);
            let meets =
                |top: i32, [l, t, r]: [i32; 3]| left < r && l < right && (top - t).abs() < LABEL;
            while let Some(other) = taken.iter().find(|other| meets(top, **other)) {
                top = other[1] + LABEL;
            }
            taken.push([left, top, right]);
            root.draw(&Text::new(text, (left, top), ("sans-serif", 11).into_font()))?;
        }
        root.present()?;
    }
    Ok(svg)
}
