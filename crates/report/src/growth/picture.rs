//! The curves as a picture: batches, exact states, digits under each law, and the audit.

use kane_audit::Verdict;
use kane_measure::growth::Chain;
use kane_number::System;
use plotters::coord::Shift;
use plotters::prelude::*;

use super::{FLOATING, GrowthReport, power_of_ten};
use crate::chart::colour;
use crate::chart::nanoseconds;
use crate::shorten::shorten;
use crate::stability::PictureError;

/// Size of a panel and of the header, in pixels; panels in a row.
const PANEL: (u32, u32) = (620, 380);
const HEADER: u32 = 44;
const COLUMNS: usize = 2;
/// Where an answer without an error is drawn, in hundredths of digits.
const EXACT: i64 = 3800;

/// The palette by Okabe and Ito, which colour-blind people tell apart.
const PALETTE: [RGBColor; 7] = [
    RGBColor(0, 0, 0),
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
];
const GRID: RGBColor = RGBColor(225, 225, 225);

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A curve on two logarithmic axes, with a mark where it ends undecided.
struct Curve {
    name: String,
    points: Vec<(u64, u64)>,
    undecided: Option<(u64, u64)>,
}

/// The words on a panel, and how its y axis is labelled.
struct Words<'a> {
    caption: &'a str,
    x: &'a str,
    y: &'a str,
    label: fn(u64) -> String,
}

/// All curves, as SVG.
///
/// # Errors
/// [`PictureError`], which drawing into a string does not give in practice.
pub fn picture(report: &GrowthReport<'_>) -> Result<String, PictureError> {
    let growth = report.growth;
    let panels = 5 + growth.chains.len();
    let rows = panels.div_ceil(COLUMNS);
    let height = PANEL.1 * u32::try_from(rows).unwrap_or(1);
    let width = PANEL.0 * u32::try_from(COLUMNS).unwrap_or(1);
    let mut svg = String::new();
    {
        let root =
            SVGBackend::with_string(&mut svg, (width, HEADER + height + 40)).into_drawing_area();
        root.fill(&WHITE)?;
        let (header, rest) = root.split_vertically(HEADER);
        let (panels, footer) = rest.split_vertically(height);
        let title = "How does cost grow with size?";
        header.draw(&Text::new(title, (12, 10), ("sans-serif", 20).into_font()))?;
        let mut areas = panels.split_evenly((rows, COLUMNS)).into_iter();
        for (curves, words) in cost_panels(report) {
            if let Some(area) = areas.next() {
                log_log(&area, &words, &curves)?;
            }
        }
        for chain in &growth.chains {
            if let Some(area) = areas.next() {
                digits(&area, chain)?;
            }
        }
        let font = ("sans-serif", 13).into_font();
        footer.draw(&Text::new(report.machine.clone(), (12, 2), font.clone()))?;
        let command = format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command);
        footer.draw(&Text::new(command, (12, 20), font))?;
        root.present()?;
    }
    Ok(svg)
}

/// The curves of cost, and what is said of them.
fn cost_panels(report: &GrowthReport<'_>) -> [(Vec<Curve>, Words<'static>); 5] {
    let growth = report.growth;
    let large = |n: usize| u64::try_from(n).unwrap_or(u64::MAX);
    let batches = growth.batches.iter().map(|batch| Curve {
        name: batch.name.to_owned(),
        points: batch.points.iter().map(|p| (large(p.rows), p.time.median.max(1))).collect(),
        undecided: None,
    });
    let bits = growth.chains.iter().map(|chain| Curve {
        name: format!("{}, bits", chain.law),
        points: chain.bounces.iter().filter_map(|b| Some((large(b.n), b.bits?))).collect(),
        undecided: None,
    });
    // floats take the same time at every bounce: one law stands for all
    let times = growth.chains.iter().enumerate().flat_map(|(index, chain)| {
        let systems = [System::Rational, System::F64, System::DoubleDouble, System::Interval];
        let shown = if index == 0 { systems.len() } else { 1 };
        systems.into_iter().take(shown).map(move |system| Curve {
            name: format!("{}, {system}", chain.law),
            points: chain
                .bounces
                .iter()
                .filter_map(|bounce| {
                    let time = bounce.times.iter().find(|(known, _)| *known == system)?.1;
                    Some((large(bounce.n), time.max(1)))
                })
                .collect(),
            undecided: None,
        })
    });
    let audit = |steps: bool| {
        let curve = move |family: &kane_measure::growth::Family| {
            let at = |asked: &kane_measure::growth::Asked| {
                let cost = if steps { asked.steps } else { asked.time.unwrap_or(0) };
                (large(asked.size), cost.max(1))
            };
            let undecided = family.asked.iter().find(|a| a.verdict == Verdict::Undecided).map(at);
            let points = family.asked.iter().map(at).collect();
            Curve { name: family.name.to_owned(), points, undecided }
        };
        growth.families.iter().map(curve).collect::<Vec<_>>()
    };
    let nanoseconds: fn(u64) -> String = |time| match usize::try_from(time / 1000) {
        Ok(time) if time >= 10_000 => power_of_ten(time),
        _ => nanoseconds(time),
    };
    [
        (
            batches.collect(),
            Words { caption: "Rows in a batch", x: "rows", y: "ns a row", label: nanoseconds },
        ),
        (
            bits.filter(|curve| !curve.points.is_empty()).collect(),
            Words {
                caption: "An exact chain of bounces: size of the state",
                x: "bounces",
                y: "bits",
                label: |bits| bits.to_string(),
            },
        ),
        (
            times.filter(|curve| !curve.points.is_empty()).collect(),
            Words {
                caption: "A chain of bounces: time of one bounce",
                x: "bounces",
                y: "ns",
                label: nanoseconds,
            },
        ),
        (
            audit(true),
            Words {
                caption: "The audit: steps of search; a cross is undecided",
                x: "variables or degree",
                y: "steps",
                label: |steps| steps.to_string(),
            },
        ),
        (
            audit(false),
            Words {
                caption: "The audit: time; a cross is undecided",
                x: "variables or degree",
                y: "ns",
                label: nanoseconds,
            },
        ),
    ]
}

fn log_log(area: &Area<'_>, words: &Words<'_>, curves: &[Curve]) -> Result<(), PictureError> {
    let all = || curves.iter().flat_map(|curve| &curve.points);
    let ends = |of: fn(&(u64, u64)) -> u64| {
        (all().map(of).min().unwrap_or(1), all().map(of).max().unwrap_or(1))
    };
    let (x, y) = (ends(|point| point.0), ends(|point| point.1));
    // room above the curves for their names
    let room = if curves.len() > 4 { 30 } else { 6 };
    let (least, most) = ((y.0 / 2).max(1), y.1.saturating_mul(room).max(10));
    let mut chart = ChartBuilder::on(area)
        .caption(words.caption, ("sans-serif", 15))
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(64)
        .build_cartesian_2d((x.0..x.1.max(x.0 + 1)).log_scale(), (least..most).log_scale())?;
    chart
        .configure_mesh()
        .x_desc(words.x)
        .y_desc(words.y)
        .x_labels(8)
        .y_labels(9)
        .x_label_formatter(&|n| match usize::try_from(*n) {
            Ok(n) if n >= 10_000 => power_of_ten(n),
            _ => n.to_string(),
        })
        .y_label_formatter(&|n| (words.label)(*n))
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .draw()?;
    for (curve, colour) in curves.iter().zip(PALETTE.into_iter().cycle()) {
        let line =
            LineSeries::new(curve.points.iter().copied(), colour.stroke_width(2)).point_size(3);
        chart
            .draw_series(line)?
            .label(shorten(&curve.name, 58))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
        if let Some(at) = curve.undecided {
            chart.draw_series([Cross::new(at, 8, colour.stroke_width(3))])?;
        }
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .background_style(WHITE.mix(0.7))
        .label_font(("sans-serif", 11))
        .draw()?;
    Ok(())
}

/// The digits of the slip that each system keeps under one law.
fn digits(area: &Area<'_>, chain: &Chain) -> Result<(), PictureError> {
    let large = |n: usize| u64::try_from(n).unwrap_or(u64::MAX);
    let last = chain.bounces.last().map_or(2, |bounce| large(bounce.n)).max(2);
    let caption = format!("{}: digits of the slip that are right", chain.law);
    let mut chart = ChartBuilder::on(area)
        .caption(caption, ("sans-serif", 15))
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(64)
        .build_cartesian_2d((1..last).log_scale(), -100_i64..4500)?;
    chart
        .configure_mesh()
        .x_desc("bounces")
        .y_desc("decimal digits")
        .x_labels(8)
        .y_labels(9)
        .y_label_formatter(&|hundredths| (hundredths / 100).to_string())
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID)
        .draw()?;
    for system in FLOATING {
        let style = colour(system).stroke_width(2);
        for (certain, word) in [(false, "right"), (true, "certain")] {
            let points = chain.bounces.iter().filter_map(|bounce| {
                let digits = bounce.digits.iter().find(|(known, _)| *known == system)?.1;
                let digits = if certain { digits.certain } else { digits.right };
                Some((large(bounce.n), digits?.min(EXACT)))
            });
            let points: Vec<(u64, i64)> = points.collect();
            if points.is_empty() {
                continue;
            }
            let line = if certain {
                LineSeries::new(points, style).point_size(3)
            } else {
                LineSeries::new(points, style)
            };
            chart
                .draw_series(line)?
                .label(format!("{system}, {word}"))
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
        }
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.7))
        .label_font(("sans-serif", 11))
        .draw()?;
    Ok(())
}
