//! Inputs that are drawn, in the same order every time.
#![allow(clippy::float_arithmetic, reason = "where a point is drawn is free")]

use crate::Core;
use crate::machine::{Machine, Runner, compares};
use crate::rigor::{Cell, Inputs};

/// The generator `splitmix64`.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) const fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// An integer from 0 to `most`.
    pub(crate) fn upto(&mut self, most: u64) -> i64 {
        let drawn = self.next();
        let within = if most == u64::MAX { drawn } else { drawn % (most + 1) };
        i64::try_from(within).unwrap_or(i64::MAX)
    }

    /// A number in [0, 1).
    pub(crate) const fn part(&mut self) -> f64 {
        f64::from_bits((self.next() >> 12) | 1.0_f64.to_bits()) - 1.0
    }

    /// A float between two places, by value or by the order of floats.
    pub(crate) fn place<M: Machine>(&mut self, (first, last): (i64, i64), by_value: bool) -> i64 {
        if by_value {
            let (low, high) = (M::at(first).wide(), M::at(last).wide());
            let part = self.part();
            M::nearest(low * (1.0 - part) + high * part).place().clamp(first, last)
        } else {
            let width = last.abs_diff(first);
            let drawn = self.next();
            let within = if width == u64::MAX { drawn } else { drawn % (width + 1) };
            first.saturating_add_unsigned(within)
        }
    }
}

/// Points of a formula's domain at which what is assumed holds: at most `count`, half drawn by value and half by
/// the order of floats. Deterministic.
///
/// # Errors
/// The name of an argument that has no float in its range.
pub fn points<M: Machine>(core: &Core, count: usize) -> Result<Vec<Vec<M>>, String> {
    let whole = Cell::whole::<M>(core, Inputs::Floats)?;
    let mut random = Random(0x5851_f42d_4c95_7f2d);
    let runner = Runner::<M>::new(&core.program);
    let (mut found, mut results) = (Vec::new(), Vec::new());
    for turn in 0..count {
        let one = |&(lower, upper): &(f64, f64)| {
            let ends = (M::nearest(lower).place(), M::nearest(upper).place());
            M::at(random.place::<M>(ends, turn % 2 == 0))
        };
        let at: Vec<M> = whole.ends.iter().map(one).collect();
        runner.run(&at, &mut results);
        let compare = |rel, a: usize, b: usize| {
            Some(compares(rel, results.get(a)?.partial_cmp(results.get(b)?)))
        };
        if core.assumed.iter().all(|test| test.holds(&compare) == Some(true)) {
            found.push(at);
        }
    }
    Ok(found)
}
