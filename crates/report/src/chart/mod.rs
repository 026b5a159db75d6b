//! Speed against accuracy: a sheet, its data, and a picture.

mod data;
mod overview;
mod picture;
mod sheet;
#[cfg(test)]
mod tests;

use kane_measure::chart::{DOMAIN, Measured, Method, Proved, Time, contradictions};
use kane_number::Rational;
use num_bigint::BigInt;

#[cfg(feature = "schema")]
pub(crate) use data::schema;
pub use data::{committed, csv, json, times};
pub use overview::speed_accuracy;
pub(crate) use overview::{Reading, readings, timed};
pub use picture::picture;
pub(crate) use picture::{Spot, ink, panels, spot};
pub use sheet::sheet;

/// The methods with their errors, their times if they were taken, and where that was.
#[derive(Clone, Debug)]
pub struct ChartReport<'a> {
    /// the methods, by law and quantity
    pub all: &'a [Measured],
    /// machine and compiler, for the footer
    pub machine: String,
    /// a command that prints this report
    pub command: String,
}

/// Hundredths of digits as digits with one decimal.
pub(crate) fn digits(hundredths: i64) -> String {
    if hundredths == i64::MAX {
        return "exact".to_owned();
    }
    format!("{}.{}", hundredths / 100, hundredths % 100 / 10)
}

/// Picoseconds as nanoseconds to three digits or so.
pub(crate) fn nanoseconds(picoseconds: u64) -> String {
    match picoseconds {
        0..10_000 => format!("{}.{:02}", picoseconds / 1000, picoseconds % 1000 / 10),
        10_000..100_000 => format!("{}.{}", picoseconds / 1000, picoseconds % 1000 / 100),
        _ => (picoseconds / 1000).to_string(),
    }
}

/// The quartiles of a time, in nanoseconds.
pub(crate) fn quartiles(time: &Time) -> String {
    let (low, high) = time.quartiles;
    format!("{} .. {}", nanoseconds(low), nanoseconds(high))
}

/// An error in hundredths of log₂ ulps, as ulps.
fn ulps(hundredths: Option<i64>) -> String {
    match hundredths {
        None => String::new(),
        Some(h) if h <= 0 => "<= 1".to_owned(),
        Some(h) => format!("2^{}.{}", h / 100, h % 100 / 10),
    }
}

/// The bound that is proved, in ulps; that none is, where an error is measured in them.
fn bound(measured: &Measured) -> String {
    match &measured.proved {
        Some(proved) => proved.ulps.to_string(),
        None if measured.accuracy.ulps.is_some() && measured.accuracy.worst != i64::MAX => {
            "none".to_owned()
        }
        None => String::new(),
    }
}

/// The same with a dagger where the bound ends before the domain does.
fn daggered(measured: &Measured) -> String {
    let (_, last) = DOMAIN;
    let is_partial = measured.proved.as_ref().is_some_and(|p| reach(p) != format!("2^{last}"));
    bound(measured) + if is_partial { "†" } else { "" }
}

/// Where a proved bound ends, as a power of two.
pub(crate) fn reach(proved: &Proved) -> String {
    match proved.to.numer().bits() {
        bits @ 1.. if proved.to == Rational::from_integer(BigInt::from(1) << (bits - 1)) => {
            format!("2^{}", bits - 1)
        }
        _ => proved.to.to_string(),
    }
}

/// The form as written, or that it is the law's own code.
const fn form_of(method: &Method) -> &'static str {
    if method.is_law { "the program's own" } else { method.text }
}

impl ChartReport<'_> {
    /// Groups of methods for one quantity of one law, in the order of the registry, each with the
    /// cheaper method first.
    pub(crate) fn groups(&self) -> Vec<((&'static str, &'static str), Vec<usize>)> {
        let mut groups: Vec<((&str, &str), Vec<usize>)> = Vec::new();
        for (index, measured) in self.all.iter().enumerate() {
            let key = (measured.method.law, measured.method.quantity);
            match groups.iter_mut().find(|(known, _)| *known == key) {
                Some((_, group)) => group.push(index),
                None => groups.push((key, vec![index])),
            }
        }
        let price = |index: &usize| {
            let measured = self.all.get(*index);
            let time = measured.and_then(|m| m.time.as_ref()).map(|time| time.median);
            let cost = measured.and_then(|m| m.cost);
            (time, cost.unwrap_or(u64::MAX), measured.map(|m| m.method.system))
        };
        for (_, group) in &mut groups {
            group.sort_by_key(price);
        }
        groups
    }

    /// What the proved bounds are about, and where one ends before the domain does.
    pub(crate) fn notes(&self) -> Vec<String> {
        let (_, last) = DOMAIN;
        let mut notes = vec![format!(
            "proved: no error for alpha from 0 to 2^{last} is larger, in ulps (docs/rounding)"
        )];
        for measured in self.all {
            let Some(proved) = &measured.proved else { continue };
            if reach(proved) == format!("2^{last}") {
                continue;
            }
            let Method { law, quantity, name, system, .. } = measured.method;
            notes.push(format!(
                "† proved to alpha = {} only, and up to there at most {} measured: {law} {quantity} {name} in {system}",
                reach(proved),
                ulps(proved.measured),
            ));
        }
        notes
    }

    /// What the clock says against the counted costs, one line a pair, at most some.
    fn warnings(&self) -> Vec<String> {
        let name = |index: usize| {
            self.all.get(index).map_or_else(String::new, |m| {
                format!(
                    "{} {} {} in {}",
                    m.method.law, m.method.quantity, m.method.name, m.method.system
                )
            })
        };
        contradictions(self.all)
            .into_iter()
            .map(|(a, b)| {
                format!("warning: counted as cheaper, but slower: {} than {}", name(a), name(b))
            })
            .collect()
    }
}
