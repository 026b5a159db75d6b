//! Where formulas fail in floating point: a sheet, JSON, CSV and a picture.

mod csv;
mod json;
#[cfg(test)]
mod made_up;
mod picture;
mod sheet;
mod strips_picture;

use kane_measure::{Better, Examined, Fault, Formula, Plane, Point, Range, Searched, Stability};

pub use csv::csv;
pub use json::json;
#[cfg(feature = "schema")]
pub(crate) use json::schema;
pub use picture::picture;
pub(crate) use sheet::WHICH_FORMULAS;
pub use sheet::sheet;
pub(crate) use strips_picture::Strips;
pub use strips_picture::strips_picture;

/// What came out for a document, and the command that shows it again.
#[derive(Clone, Debug)]
pub struct StabilityReport<'a> {
    /// the findings
    pub stability: &'a Stability,
    /// bounds, worst inputs and repairs of its formulas, where they were asked for
    pub accounts: &'a [kane_measure::certify::Account],
    /// a command that prints this report
    pub command: String,
}

/// One formula with all that was found of it.
pub(crate) struct Entry<'a> {
    pub(crate) formula: &'a Formula,
    pub(crate) is_own: bool,
    pub(crate) lines: Vec<&'a Examined>,
    pub(crate) planes: Vec<&'a Plane>,
    pub(crate) searches: Vec<&'a Searched>,
}

impl<'a> StabilityReport<'a> {
    /// The formulas that were examined, in order.
    pub(crate) fn entries(&self) -> Vec<Entry<'a>> {
        let stability = self.stability;
        let subject = &stability.subject;
        let of = |(index, formula): (usize, &'a Formula)| Entry {
            formula,
            is_own: index < subject.own,
            lines: stability.lines.iter().filter(|line| line.formula == index).collect(),
            planes: stability.planes.iter().filter(|plane| plane.formula == index).collect(),
            searches: stability.searches.iter().filter(|search| search.formula == index).collect(),
        };
        subject.formulas.iter().enumerate().take(subject.examined).map(of).collect()
    }

    /// The formula that is better on a range.
    pub(crate) fn better(&self, better: &Better) -> Option<&'a Formula> {
        self.stability.subject.formulas.get(better.formula)
    }

    /// How many formulas there are, and how many of them fail somewhere.
    pub(crate) fn headline(&self) -> String {
        let entries = self.entries();
        let left_out = self.stability.subject.left_out.len();
        let and_left_out = match left_out {
            0 => String::new(),
            _ => format!("; {left_out} left out"),
        };
        if entries.is_empty() {
            return format!("no formula was examined{and_left_out}");
        }
        let failing = entries.iter().filter(|entry| entry.fails()).count();
        let formulas = if entries.len() == 1 { "formula" } else { "formulas" };
        let fail = if failing == 1 { "fails" } else { "fail" };
        let count = entries.len();
        format!("{count} {formulas} in f32 and f64: {failing} {fail} somewhere{and_left_out}")
    }
}

impl Entry<'_> {
    pub(crate) fn fails(&self) -> bool {
        self.lines.iter().any(|line| !line.ranges.is_empty())
            || self.planes.iter().any(|plane| !plane.faults.is_empty())
            || self.searches.iter().any(|search| !search.faults.is_empty())
    }

    /// Per format, the most hundredths of bits that are lost, and the input where that is if there
    /// is one input.
    pub(crate) fn losses(&self) -> Vec<(&'static str, i64, Option<&Point>)> {
        let lines = self.lines.iter().map(|l| (l.format, l.worst.1, Some(&l.worst.0)));
        let planes = self.planes.iter().map(|p| (p.format, p.worst.1, None));
        let searches = self.searches.iter().map(|s| (s.format, s.worst.1, None));
        let mut losses: Vec<(&'static str, i64, Option<&Point>)> = Vec::new();
        for loss in lines.chain(planes).chain(searches) {
            match losses.iter_mut().find(|known| known.0 == loss.0) {
                Some(known) if loss.1 > known.1 => *known = loss,
                Some(_) => {}
                None => losses.push(loss),
            }
        }
        losses
    }

    /// Which formulas are evaluated first, and where else this one stands; empty for none.
    pub(crate) fn notes(&self) -> String {
        let mut notes = Vec::new();
        if !self.formula.by.is_empty() {
            notes.push(format!("with {}", self.formula.by.join(", ")));
        }
        if !self.formula.also.is_empty() {
            notes.push(format!("also {}", self.formula.also.join(", ")));
        }
        if !self.is_own {
            notes.push("an equal form".to_owned());
        }
        notes.join("; ")
    }
}

/// What a formula is called: its label, unless that is what it is a formula of, and the equation.
pub(crate) fn title(formula: &Formula) -> String {
    let equation = format!("{} = {}", formula.quantity, formula.text);
    if formula.label == formula.quantity {
        equation
    } else {
        format!("{}  {equation}", formula.label)
    }
}

/// A formula as others are referred to it: its text, and its label with the definitions used.
pub(crate) fn named(formula: &Formula) -> String {
    match formula.by.as_slice() {
        [] => format!("{}  {}", formula.text, formula.label),
        by => format!("{}  {} with {}", formula.text, formula.label, by.join(", ")),
    }
}

/// A profile without what repeats itself: binades at which the fault changes or the loss does by
/// half a bit, and those before them.
pub(crate) fn thinned(line: &Examined) -> Vec<(i64, i64, Option<Fault>)> {
    let mut kept: Vec<(i64, i64, Option<Fault>)> = Vec::new();
    let mut before = None;
    for &now in &line.profile {
        let changes =
            kept.last().is_none_or(|last| last.2 != now.2 || (last.1 - now.1).abs() >= 50);
        if changes {
            kept.extend(before.filter(|b| kept.last() != Some(b)));
            kept.push(now);
        }
        before = Some(now);
    }
    kept.extend(before.filter(|b| kept.last() != Some(b)));
    kept
}

/// Hundredths of bits as bits with one decimal, rounded down.
pub(crate) fn bits(hundredths: i64) -> String {
    format!("{}.{}", hundredths / 100, hundredths % 100 / 10)
}

/// A representable number in few characters: a power of two as such, others to four digits.
pub(crate) fn short(point: &Point) -> String {
    let pattern = point.value.to_bits();
    if point.value < 0.0 {
        let text = point.text.trim_start_matches('-').to_owned();
        return format!(
            "-{}",
            short(&Point { place: point.place, value: point.value.abs(), text })
        );
    }
    let fraction = pattern & ((1 << 52) - 1);
    let field = i64::try_from(pattern >> 52).unwrap_or(0);
    if pattern == 0 {
        "0".to_owned()
    } else if [format!("{:e}", f64::MAX), format!("{:e}", f32::MAX)].contains(&point.text) {
        // the shortest decimal in the format of the number: the greatest of f32 is one of f64 among others
        "max".to_owned()
    } else if fraction == 0 {
        format!("2^{}", field - 1023)
    } else if field == 0 && fraction.is_power_of_two() {
        format!("2^{}", i64::from(fraction.trailing_zeros()) - 1074)
    } else {
        format!("{:.3e}", point.value)
    }
}

/// A range by its first and last failing input.
pub(crate) fn interval(range: &Range) -> String {
    if range.from == range.to {
        return format!("at {}", short(&range.from));
    }
    let (from, to) = (short(&range.from), short(&range.to));
    if from == to {
        // so close that four digits do not tell them apart
        return format!("[{}, {}]", range.from.text, range.to.text);
    }
    format!("[{from}, {to}]")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(value: f64) -> Point {
        Point { place: 0, value, text: format!("{value:e}") }
    }

    fn range(from: f64, to: f64) -> Range {
        Range {
            fault: Fault::Lost,
            from: point(from),
            to: point(to),
            open: (false, false),
            worst: point(from),
            lost: 0,
            computed: String::new(),
            exact: String::new(),
            cause: String::new(),
            better: None,
        }
    }

    #[test]
    fn bits_are_rounded_down_to_a_tenth() {
        let told = [0, 9, 10, 99, 100, 123, 199, 5307].map(bits);
        assert_eq!(told, ["0.0", "0.0", "0.1", "0.9", "1.0", "1.2", "1.9", "53.0"]);
    }

    #[test]
    fn powers_of_two_are_told_as_such_and_others_to_four_digits() {
        let told = |value: f64| short(&point(value));
        for power in [-1074, -1073, -1023, -1022, -149, -1, 0, 1, 127, 1023] {
            let value = 2.0_f64.powi(power.max(-1022)) * 2.0_f64.powi((power + 1022).min(0));
            assert_eq!(told(value), format!("2^{power}"));
            assert_eq!(told(-value), format!("-2^{power}"));
        }
        assert_eq!(told(0.0), "0");
        assert_eq!([f64::MAX, -f64::MAX].map(told), ["max", "-max"]);
        // the greatest float of f32 is none of f64
        let single = |sign: f32| Point {
            text: format!("{:e}", sign * f32::MAX),
            ..point(f64::from(sign * f32::MAX))
        };
        assert_eq!([1.0, -1.0].map(|sign| short(&single(sign))), ["max", "-max"]);
        assert_eq!(told(f32::MAX.into()), "3.403e38");
        assert_eq!([0.1, -1234.56, 3.0].map(told), ["1.000e-1", "-1.235e3", "3.000e0"]);
        // no power of two, below the least normal number
        assert_eq!(told(3.0 * f64::from_bits(1)), "1.482e-323");
    }

    #[test]
    fn a_range_is_told_by_its_ends_and_in_full_where_four_digits_do_not_tell_them_apart() {
        assert_eq!(interval(&range(0.1, 0.1)), "at 1.000e-1");
        assert_eq!(interval(&range(0.5, 3.0)), "[2^-1, 3.000e0]");
        assert_eq!(interval(&range(0.1, 0.100_001)), "[1e-1, 1.00001e-1]");
    }

    fn examined(
        format: &'static str,
        lost: i64,
        profile: &[(i64, i64, Option<Fault>)],
    ) -> Examined {
        Examined {
            formula: 0,
            format,
            precision: 53,
            negative: false,
            domain: (point(0.5), point(2.0)),
            ranges: Vec::new(),
            worst: (point(1.0), lost),
            profile: profile.to_vec(),
            tried: 3,
        }
    }

    #[test]
    fn a_profile_keeps_where_it_changes_and_what_was_before() {
        let lost = Some(Fault::Lost);
        let flat: Vec<_> = (0..6).map(|n| (n, 100, None)).collect();
        assert_eq!(thinned(&examined("f64", 0, &flat)), [(0, 100, None), (5, 100, None)]);
        let of = |profile: &[(i64, i64, Option<Fault>)]| thinned(&examined("f64", 0, profile));
        // half a bit is a change, and less is none
        let less = [(0, 100, None), (1, 149, None), (2, 149, None)];
        assert_eq!(of(&less), [less[0], less[2]]);
        let half = [(0, 100, None), (1, 100, None), (2, 150, None), (3, 100, None)];
        assert_eq!(of(&half), half);
        let faults = [(0, 100, None), (1, 100, None), (2, 100, lost), (3, 100, lost)];
        assert_eq!(of(&faults), faults);
        assert_eq!(of(&[]), []);
    }
}
