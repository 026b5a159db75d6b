//! How cost grows with size: a sheet, its data, and three pictures.

mod data;
mod picture;
mod sheet;

use kane_measure::growth::{Chain, Family, Growth, Way};
use kane_number::System;

use crate::chart::nanoseconds;

#[cfg(feature = "schema")]
pub(crate) use data::schema;
pub use data::{csv, json};
pub use picture::{Question, picture};
pub use sheet::sheet;

/// The curves, and where they were measured.
#[derive(Clone, Debug)]
pub struct GrowthReport<'a> {
    /// the curves
    pub growth: &'a Growth,
    /// machine and compiler, for the footer
    pub machine: String,
    /// a command that prints this report
    pub command: String,
}

/// The systems that are compared with the exact one.
const FLOATING: [System; 3] = [System::F64, System::DoubleDouble, System::Interval];

impl GrowthReport<'_> {
    /// What the batches come to, in a sentence; `None` where nothing was timed.
    fn rows_reading(&self) -> Option<String> {
        let at = |way: Way, last: bool| {
            let of = |batch: &kane_measure::growth::Batch| {
                let point = if last { batch.points.last() } else { batch.points.get(1) };
                point.map(|point| (point.time.median, point.rows))
            };
            let batches = self.growth.batches.iter().filter(move |batch| batch.way == way);
            batches.filter_map(of).collect::<Vec<_>>()
        };
        let span = |last: bool| {
            let all = at(Way::Columns, last);
            let (least, most) = (all.iter().min()?.0, all.iter().max()?.0);
            Some(format!("{} to {} ns", nanoseconds(least), nanoseconds(most)))
        };
        let memory = at(Way::Memory, true);
        let (memory, rows) = memory.first()?;
        let single = at(Way::Singly, true).first()?.0;
        Some(format!(
            "By the kernel, a row costs {} in cache and {} at {}, where its reads and writes alone \
             take {}; one by one, the paper's law takes {} ns.",
            span(false)?,
            span(true)?,
            power_of_ten(*rows),
            nanoseconds(*memory),
            nanoseconds(single),
        ))
    }
}

/// What a chain comes to, in a sentence.
fn chain_reading(chain: &Chain) -> String {
    let last = chain.bounces.last().map_or(0, |bounce| bounce.n);
    let exact = match chain.last_exact() {
        None => "exact fractions have no answer from the first bounce on".to_owned(),
        Some((n, bits)) if chain.doubles() => format!(
            "the exact state doubles with each bounce and is given up after {n}, at {bits} bits"
        ),
        Some((n, bits)) => format!(
            "the exact state grows by some {} bits a bounce and is affordable to the end, with \
             {bits} bits after {n}",
            bits / u64::try_from(n).unwrap_or(1).max(1)
        ),
    };
    let compared = chain.last_exact().map_or(0, |(n, _)| n);
    let kept = FLOATING.iter().filter_map(|system| {
        let n = chain.keeps_a_digit(*system)?;
        let known = if *system == System::Interval { last } else { compared };
        let least = if n == known && n < last { ", as far as is known" } else { "" };
        Some(format!("{system} to bounce {n}{least}"))
    });
    let kept: Vec<String> = kept.collect();
    let ends = match chain.is_compared_throughout() {
        true => "",
        false => " Beyond the exact chain only the width of an interval says what is right.",
    };
    format!("{exact}. A digit of the slip is kept by {}.{ends}", kept.join("; by "))
}

/// What a family comes to, in a few words.
fn family_reading(family: &Family) -> String {
    use kane_audit::Verdict::Undecided;
    let Some(last) = family.asked.last() else { return String::new() };
    let reason = last.link.as_ref().map_or_else(String::new, crate::words::reason_alone);
    if last.verdict == Undecided {
        format!("undecided at {}: {reason}", last.size)
    } else {
        format!("{} to {}, {reason}", last.verdict, last.size)
    }
}

/// A count as a power of ten, where it is one.
fn power_of_ten(count: usize) -> String {
    let exponent = count.checked_ilog10().unwrap_or(0);
    if 10_usize.checked_pow(exponent) == Some(count) {
        format!("10^{exponent}")
    } else {
        count.to_string()
    }
}

/// Bounces that tables show: 1, 2, 5, 10 and so on, and the last exact one.
fn shown(chain: &Chain) -> Vec<&kane_measure::growth::Bounce> {
    let exact = chain.last_exact().map_or(0, |(n, _)| n);
    let round = |mut n: usize| {
        while n.is_multiple_of(10) && n > 0 {
            n /= 10;
        }
        matches!(n, 1 | 2 | 5)
    };
    chain.bounces.iter().filter(|bounce| round(bounce.n) || bounce.n == exact).collect()
}
