//! What a figure shows, for programs and in words.

use std::fmt::Write as _;

use super::{Content, Figure, Kind, Series};

/// The data of the figure as CSV. Lines that begin with `#` tell what the numbers in the first column
/// stand for; the numbers are those of the picture.
#[must_use]
pub fn csv(figure: &Figure) -> String {
    let mut out = format!("# {}\n", figure.title);
    for note in &figure.notes {
        line(&mut out, format_args!("# {note}"));
    }
    let (x, y) = (figure.x.symbol, figure.y.symbol);
    match &figure.content {
        Content::Map(panels) => {
            line(&mut out, format_args!("body,law,{y},{x}_from,{x}_to"));
            for panel in panels {
                let [body, law] = &panel.case;
                for stretch in &panel.stretches {
                    let to = stretch.to.map_or_else(String::new, |to| format!("{to:.4}"));
                    let (y, from) = (stretch.y, stretch.from);
                    line(&mut out, format_args!("{body},{law},{y:.4},{from:.4},{to}"));
                }
            }
        }
        Content::Curves { series, zones } => {
            for (number, one) in series.iter().enumerate() {
                let (kind, names) = (word(one.kind), one.names.join(", "));
                line(&mut out, format_args!("# {} ({kind}): {names}", number + 1));
            }
            let mut letters = 'A'..;
            let zones: Vec<_> = zones.iter().zip(letters.by_ref()).collect();
            for (zone, letter) in &zones {
                line(&mut out, format_args!("# {letter} (zone): {}", zone.name));
            }
            line(&mut out, format_args!("series,{x},{y}"));
            for (number, one) in series.iter().enumerate() {
                for (at, value) in &one.points {
                    if let Some(value) = value {
                        let (at, value) = (abscissa(one, *at), decimals(*value, one.decimals));
                        line(&mut out, format_args!("{},{at},{value}", number + 1));
                    }
                }
                // how far a point may be off to either side
                for ((at, _), bar) in one.points.iter().zip(&one.bars) {
                    let (at, bar) = (abscissa(one, *at), decimals(*bar, one.decimals));
                    line(&mut out, format_args!("{} bar,{at},{bar}", number + 1));
                }
            }
            for (zone, letter) in zones {
                for border in &zone.borders {
                    let side = if border.is_zone_above { "above" } else { "below" };
                    for (at, value) in &border.points {
                        let value = decimals(*value, 6);
                        line(&mut out, format_args!("{letter} {side},{at},{value}"));
                    }
                }
            }
        }
    }
    out
}

/// What the figures show, for a terminal: titles, files and legends.
#[must_use]
pub fn text(figures: &[Figure]) -> String {
    let mut out = String::new();
    for figure in figures {
        line(&mut out, format_args!("{}: {}", figure.stem, figure.title));
        match &figure.content {
            Content::Map(panels) => {
                for panel in panels {
                    line(&mut out, format_args!("     {}", panel.case.join(", ")));
                }
            }
            Content::Curves { series, zones } => {
                for (number, one) in series.iter().enumerate() {
                    let (kind, names) = (word(one.kind), one.names.join(", "));
                    line(&mut out, format_args!("  {:>2} {kind}: {names}", number + 1));
                }
                for zone in zones {
                    line(&mut out, format_args!("     zone: {}", zone.name));
                }
            }
        }
        out.push('\n');
    }
    out
}

pub(super) const fn word(kind: Kind) -> &'static str {
    match kind {
        Kind::Law => "law",
        Kind::Process => "process",
        Kind::Measured => "measured",
    }
}

/// x is exact where a law was asked, and rounded where it was measured.
fn abscissa(series: &Series, x: f64) -> String {
    match series.kind {
        Kind::Measured => format!("{x:.4}"),
        Kind::Law | Kind::Process => x.to_string(),
    }
}

/// Without the sign of a zero, which rounding alone would choose.
fn decimals(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    match text.strip_prefix('-') {
        Some(magnitude) if magnitude.bytes().all(|b| b == b'0' || b == b'.') => {
            magnitude.to_owned()
        }
        _ => text,
    }
}

fn line(out: &mut String, text: std::fmt::Arguments<'_>) {
    writeln!(out, "{text}").expect("a string takes all");
}
