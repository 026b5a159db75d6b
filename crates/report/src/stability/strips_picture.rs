//! Where formulas fail at a glance: a strip a formula, those that fail near 1 first.
#![allow(clippy::float_arithmetic, reason = "a picture has a scale")]

use kane_measure::Examined;

use super::picture::{FAULTS, along, bar, ink};
use super::{Entry, StabilityReport};
use crate::picture::{Canvas, Key, Strip, WORDS, height_of, legend, strips};
use crate::shorten::{in_print, shorten};

/// The width of the picture, and where the axis of the strips begins.
const WIDTH: f64 = 760.0;
const SPLIT: f64 = 262.0;
const LEGEND: f64 = 34.0;
/// Above each group of strips.
const HEAD: f64 = 26.0;
/// Characters of a name.
const NAME: usize = 38;
/// Inputs of a size that occurs.
pub(crate) const BAND: (f64, f64) = (1e-3, 1e3);

/// How formulas of one input fare, by where their `f64` fails.
pub(crate) struct Strips {
    /// formulas of one input
    pub(crate) formulas: usize,
    /// those that fail within the band, and those that fail elsewhere alone
    pub(crate) near: Vec<Strip>,
    pub(crate) far: Vec<Strip>,
}

impl Strips {
    pub(crate) fn of(report: &StabilityReport<'_>) -> Self {
        let entries = report.entries();
        let of_one = || entries.iter().filter(|entry| !entry.lines.is_empty());
        let fails = |entry: &&Entry<'_>| entry.lines.iter().any(|line| !line.ranges.is_empty());
        let is_near = |entry: &&Entry<'_>| entry.lines.iter().any(|line| is_near(line));
        let strip = |entry: &Entry<'_>| strip(entry);
        let (near, far): (Vec<&Entry<'_>>, _) = of_one().filter(fails).partition(is_near);
        Self {
            formulas: of_one().count(),
            near: near.into_iter().map(strip).collect(),
            far: far.into_iter().map(strip).collect(),
        }
    }

    /// How many fail, and where, in a sentence.
    pub(crate) fn reading(&self) -> String {
        let (near, far) = (self.near.len(), self.far.len());
        format!(
            "{} of {} formulas of one input, evaluated as written, fail somewhere in f32 or f64; {near} of them between \
             1/1000 and 1000",
            near + far,
            self.formulas,
        )
    }
}

/// Whether the format fails somewhere in the band.
fn is_near(line: &Examined) -> bool {
    line.ranges.iter().any(|range| {
        let (a, b) = (range.from.value.abs(), range.to.value.abs());
        a.max(b) >= BAND.0 && a.min(b) <= BAND.1
    })
}

/// A formula's strip: its positive inputs, and below them its negative ones if it fails there.
fn strip(entry: &Entry<'_>) -> Strip {
    let formula = entry.formula;
    let label = formula.label.as_str();
    // a dash in a label is no minus
    let text = in_print(&formula.text);
    let name = match label == formula.quantity {
        true => format!("{} = {text}", in_print(label)),
        false => format!("{label}  {text}"),
    };
    let of = |format: &str, negative: bool| {
        entry.lines.iter().find(|line| line.format == format && line.negative == negative)
    };
    let is_negative = [true, false].map(|negative| {
        ["f32", "f64"].iter().any(|f| of(f, negative).is_some_and(|line| !line.ranges.is_empty()))
    });
    let sides: &[bool] = match is_negative {
        [true, true] => &[false, true],
        [true, false] => &[true],
        _ => &[false],
    };
    let bars = sides.iter().flat_map(|side| ["f32", "f64"].map(|format| of(format, *side)));
    let below = match sides {
        [false] => "",
        [true] => ", < 0",
        _ => ", ≷ 0",
    };
    let room = NAME - below.chars().count();
    Strip {
        name: shorten(&name, room) + below,
        bars: bars.flatten().map(|line| bar(line)).collect(),
    }
}

/// Every formula of one input that fails, as SVG.
#[must_use]
pub fn strips_picture(report: &StabilityReport<'_>) -> String {
    let all = Strips::of(report);
    let notes = [
        format!(
            "{}. A strip is a formula over the size of its input, f32 above f64; ≷ 0: inputs above 0 over those below. \
             The axis is squeezed far from 1; grey: 1/1000 to 1000. Narrow ranges are drawn wider than they are.",
            all.reading()
        ),
        format!("kane {}: {}", env!("CARGO_PKG_VERSION"), report.command),
    ];
    let groups = [
        ("They fail between 1/1000 and 1000 too", &all.near),
        ("They fail at extremes alone", &all.far),
    ];
    let groups: Vec<_> = groups.into_iter().filter(|(_, strips)| !strips.is_empty()).collect();
    let height = |strips: &[Strip]| HEAD + height_of(strips) + 8.0;
    let size = (WIDTH, LEGEND + groups.iter().map(|(_, strips)| height(strips)).sum::<f64>());
    let mut canvas = Canvas::new(size, "Where formulas fail in floats", &notes);
    let named = FAULTS.map(|fault| (fault, fault.to_string()));
    let keys: Vec<(Key, &str)> =
        named.iter().map(|(fault, name)| (Key::Area(ink(Some(*fault))), name.as_str())).collect();
    legend(&mut canvas, (12.0, 2.0), WIDTH - 24.0, &keys);
    let ticks =
        [-300_i32, -30, -3, 0, 3, 30, 300].map(|power| (along(f64::from(power)), in_power(power)));
    let band = (along(BAND.0.log10()), along(BAND.1.log10()));
    let mut top = LEGEND;
    for (head, rows) in groups {
        let counted = format!("{head}: {}", rows.len());
        canvas.bold((12.0, top + HEAD / 2.0), &counted, WORDS);
        let place = (top + HEAD, SPLIT, WIDTH - 24.0);
        strips(&mut canvas, place, rows, ("size of the input; 0 at the left end", &ticks, band));
        top += height(rows);
    }
    canvas.finish()
}

/// `1`, `10³`, `10⁻³⁰⁰`.
fn in_power(power: i32) -> String {
    if power == 0 {
        return "1".to_owned();
    }
    let digit = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32('⁰' as u32 + c.to_digit(10).unwrap_or(0)).unwrap_or(c),
    };
    format!("10{}", power.to_string().chars().map(digit).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_set_as_in_print() {
        assert_eq!([in_power(0), in_power(-300), in_power(30)], ["1", "10⁻³⁰⁰", "10³⁰"]);
    }
}
