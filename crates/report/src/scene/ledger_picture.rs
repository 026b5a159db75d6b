//! The energy ledger, and error against cost, as pictures.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_scene::{Bounced, Judged, Verdict};
use plotters::prelude::*;

use super::SceneReport;
use crate::stability::PictureError;

const SIZE: (u32, u32) = (760, 420);
const PARTS: [(&str, RGBColor); 4] = [
    ("normal", RGBColor(0, 114, 178)),
    ("tangential", RGBColor(213, 94, 0)),
    ("rotational", RGBColor(0, 158, 115)),
    ("gravity", RGBColor(130, 130, 130)),
];

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
    let margin = ((high - low) * 0.08).max(1e-300);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, SIZE).into_drawing_area();
        root.fill(&WHITE)?;
        let mut chart = ChartBuilder::on(&root)
            .caption(format!("{}: energy by part", report.title), ("sans-serif", 17))
            .margin(12)
            .x_label_area_size(38)
            .y_label_area_size(76)
            .build_cartesian_2d(0.0..last.time * 1.02, (low - margin)..(high + margin))?;
        chart
            .configure_mesh()
            .x_desc("time, s")
            .y_desc("change of energy so far, J")
            // the axis counts in steps that round: its zero is only near it
            .y_label_formatter(&|y| super::small(if y.abs() < margin / 1e6 { 0.0 } else { *y }))
            .x_label_formatter(&|x| super::number(*x))
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225))
            .draw()?;
        for (part, (name, ink)) in PARTS.iter().enumerate() {
            let mut points = vec![(0.0, 0.0)];
            let mut level = 0.0;
            for sum in sums {
                points.push((sum.time, level));
                level = sum.parts[part];
                points.push((sum.time, level));
            }
            chart.draw_series(LineSeries::new(points, ink.stroke_width(2)))?.label(*name).legend(
                move |(x, y)| PathElement::new(vec![(x, y), (x + 18, y)], ink.stroke_width(3)),
            );
        }
        chart
            .configure_series_labels()
            .background_style(WHITE.mix(0.85))
            .border_style(RGBColor(200, 200, 200))
            .draw()?;
        root.present()?;
    }
    Ok(Some(svg))
}

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
        root.fill(&WHITE)?;
        let costs = (20.0..most * 12.0).log_scale();
        let ratios = (best / 10.0..worst * 10.0).log_scale();
        let mut chart = ChartBuilder::on(&root)
            .caption(format!("{}: error against cost", report.title), ("sans-serif", 17))
            .margin(12)
            .x_label_area_size(38)
            .y_label_area_size(72)
            .build_cartesian_2d(costs, ratios)?;
        chart
            .configure_mesh()
            .x_desc("counted cost of an impact, additions of f64")
            .y_desc("worst error by its tolerance")
            .x_label_formatter(&|x| super::small(*x))
            .y_label_formatter(&|y| super::small(*y))
            .light_line_style(TRANSPARENT)
            .bold_line_style(RGBColor(225, 225, 225))
            .draw()?;
        let line = vec![(20.0, 1.0), (most * 12.0, 1.0)];
        chart.draw_series(LineSeries::new(line, RGBColor(213, 94, 0).stroke_width(2)))?;
        let mut labels: Vec<(String, f64, f64)> = Vec::new();
        for (judged, cost, ratio) in drawn {
            let good = judged.verdict == Verdict::Meets;
            let ink = if good { RGBColor(0, 158, 115) } else { RGBColor(90, 90, 90) };
            let chosen = report.answer.chosen == Some(judged.model);
            let style = if chosen { ink.filled() } else { ink.stroke_width(2) };
            chart.draw_series(std::iter::once(Circle::new((cost, ratio), 5, style)))?;
            // models in one place share a label
            match labels.iter_mut().find(|(_, x, y)| *x == cost && (ratio / *y).ln().abs() < 0.2) {
                Some((text, ..)) => text.push_str(&format!(", {}", judged.model.system)),
                None => labels.push((judged.model.to_string(), cost, ratio)),
            }
        }
        for (text, cost, ratio) in labels {
            let font = ("sans-serif", 11).into_font();
            chart.draw_series(std::iter::once(Text::new(text, (cost * 1.12, ratio), font)))?;
        }
        root.present()?;
    }
    Ok(svg)
}
