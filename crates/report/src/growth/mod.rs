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

#[cfg(test)]
mod tests {
    use kane_measure::chart::Time;
    use kane_measure::growth::{Batch, Bounce, Digits, Rows};

    use super::*;

    fn bounce(
        n: usize,
        bits: Option<u64>,
        digits: &[(System, Option<i64>, Option<i64>)],
    ) -> Bounce {
        let digits = digits.iter();
        let digits = digits
            .map(|(system, right, certain)| (*system, Digits { right: *right, certain: *certain }));
        Bounce { n, bits, digits: digits.collect(), times: Vec::new() }
    }

    fn chain(bounces: Vec<Bounce>) -> Chain {
        Chain { law: "a law", bounces, ended: Vec::new() }
    }

    #[test]
    fn a_chain_is_told_by_the_growth_of_its_exact_state_and_the_digits_that_are_kept() {
        let kept = [(System::F64, Some(1500), None), (System::Interval, Some(1400), Some(1300))];
        let lost = [(System::F64, Some(99), None), (System::Interval, None, Some(200))];
        let doubling = chain(vec![
            bounce(1, Some(10), &kept),
            bounce(2, Some(20), &kept),
            bounce(3, Some(40), &kept),
            bounce(4, Some(80), &lost),
            bounce(5, None, &[(System::Interval, None, Some(100))]),
        ]);
        // f64 has less than a digit after four; the interval is certain to the end
        assert_eq!(
            chain_reading(&doubling),
            "the exact state doubles with each bounce and is given up after 4, at 80 bits. A digit of the slip is kept by \
             f64 to bounce 3; by interval to bounce 5. Beyond the exact chain only the width of an interval says what is \
             right."
        );
        let steady = chain(vec![
            bounce(1, Some(30), &kept),
            bounce(2, Some(40), &kept),
            bounce(3, Some(50), &kept),
        ]);
        assert_eq!(
            chain_reading(&steady),
            "the exact state grows by some 16 bits a bounce and is affordable to the end, with 50 bits after 3. A digit of \
             the slip is kept by f64 to bounce 3; by interval to bounce 3."
        );
        // what is right is known as far as the exact chain goes
        let f64_alone = [(System::F64, Some(1500), None)];
        let short = chain(vec![bounce(1, Some(30), &f64_alone), bounce(2, None, &[])]);
        assert_eq!(
            chain_reading(&short),
            "the exact state grows by some 30 bits a bounce and is affordable to the end, with 30 bits after 1. A digit of \
             the slip is kept by f64 to bounce 1, as far as is known. Beyond the exact chain only the width of an interval \
             says what is right."
        );
        let none = chain(vec![bounce(1, None, &f64_alone)]);
        assert!(
            chain_reading(&none)
                .starts_with("exact fractions have no answer from the first bounce on. ")
        );
    }

    #[test]
    fn a_batch_is_told_in_cache_and_beyond_it() {
        let batch = |name, way, times: &[(usize, u64)]| Batch {
            name,
            way,
            points: times
                .iter()
                .map(|(rows, median)| Rows {
                    rows: *rows,
                    time: Time { median: *median, quartiles: (0, 0), rounds: 3 },
                })
                .collect(),
        };
        let mut growth = Growth {
            batches: vec![
                batch("copy", Way::Memory, &[(10, 9_000), (100, 8_000), (1_000_000, 1_500)]),
                batch("first", Way::Columns, &[(10, 7_000), (100, 500), (1_000_000, 2_500)]),
                batch("second", Way::Columns, &[(10, 6_000), (100, 750), (1_000_000, 2_000)]),
                batch("one", Way::Singly, &[(10, 5_000), (100, 4_000), (1_000_000, 3_000)]),
            ],
            chains: Vec::new(),
            families: Vec::new(),
        };
        let reading = |growth: &Growth| {
            let command = String::new;
            GrowthReport { growth, machine: command(), command: command() }.rows_reading()
        };
        assert_eq!(
            reading(&growth).as_deref(),
            Some(
                "By the kernel, a row costs 0.50 to 0.75 ns in cache and 2.00 to 2.50 ns at 10^6, where its reads and \
                 writes alone take 1.50; one by one, the paper's law takes 3.00 ns."
            )
        );
        growth.batches.clear();
        assert_eq!(reading(&growth), None);
    }

    #[test]
    fn a_power_of_ten_is_told_as_such_and_other_counts_as_they_are() {
        let told = [0, 1, 2, 10, 99, 100, 1_000_000, 1_048_576].map(power_of_ten);
        assert_eq!(told, ["0", "10^0", "2", "10^1", "99", "10^2", "10^6", "1048576"]);
    }

    #[test]
    fn tables_show_round_bounces_and_the_last_exact_one() {
        let all = (0..=200).map(|n| bounce(n, (n <= 37).then_some(7), &[])).collect();
        let chain = chain(all);
        let bounces: Vec<usize> = shown(&chain).iter().map(|bounce| bounce.n).collect();
        assert_eq!(bounces, [1, 2, 5, 10, 20, 37, 50, 100, 200]);
    }
}
