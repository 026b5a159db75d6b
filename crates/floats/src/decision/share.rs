//! On which inputs plain floats decide wrongly.

use std::cmp::Ordering;

use kane_kernel::Rel;

use super::compared::Decision;
use crate::Core;
use crate::draw::Random;
use crate::exact::{Enclosure, value};
use crate::machine::{Machine, Runner, compares};
use crate::rigor::{Cell, Inputs};

/// An input at which plain floats decide wrongly.
#[derive(Clone, Debug, PartialEq)]
pub struct Tie<M> {
    /// the inputs
    pub at: Vec<M>,
    /// whether the comparison holds there
    pub holds: bool,
}

/// Inputs that were tried, and those at which plain floats decide wrongly.
#[derive(Clone, Debug, PartialEq)]
pub struct Share<M> {
    /// inputs drawn over the whole domain, of which half by value and half by the order of floats
    pub drawn: usize,
    /// and how many of them are decided wrongly
    pub wrong: usize,
    /// inputs drawn next to ties: each argument within 1,024 floats of where the comparison turns
    pub near: usize,
    /// and how many of them are decided wrongly
    pub wrong_near: usize,
    /// one of these
    pub tie: Option<Tie<M>>,
}

/// Inputs drawn over the domain, ties that are looked for, and inputs drawn next to each.
const DRAWN: usize = 2_000;
const TIES: usize = 40;
const NEAR: usize = 32;
/// Bits to which what is compared is known at first, and at most.
const BITS: [u32; 3] = [256, 1_024, 6_144];

/// Decides a comparison in the floats of `M` and exactly, over the domain and next to where it turns. A heuristic:
/// the shares are of the inputs that were drawn; every wrong decision that is counted is one. Inputs at which
/// an exact value is missing, or outside of what is assumed, do not count. Deterministic. `None` if
/// an argument has no float in its range.
#[must_use]
pub fn share<M: Machine>(core: &Core, decision: &Decision) -> Option<Share<M>> {
    let whole = Cell::whole::<M>(core, Inputs::Floats).ok()?;
    let places =
        |&(lower, upper): &(f64, f64)| (M::nearest(lower).place(), M::nearest(upper).place());
    let mut drawn = Drawn::<M> {
        core,
        decision,
        runner: Runner::new(&core.program),
        places: whole.ends.iter().map(places).collect(),
        results: Vec::new(),
        random: Random(0x9e37_79b9_7f4a_7c15),
    };
    let mut share = Share { drawn: 0, wrong: 0, near: 0, wrong_near: 0, tie: None };
    for turn in 0..DRAWN {
        let at = drawn.point(turn % 2 == 0);
        let Some((wrong, holds)) = drawn.is_wrong(&at) else { continue };
        share.drawn += 1;
        if wrong {
            share.wrong += 1;
            share.tie.get_or_insert_with(|| Tie { at: floats(&at), holds });
        }
    }
    for turn in 0..TIES {
        let Some(tie) = drawn.tie(turn) else { continue };
        for _ in 0..NEAR {
            let at = drawn.next_to(&tie);
            let Some((wrong, holds)) = drawn.is_wrong(&at) else { continue };
            share.near += 1;
            if wrong {
                share.wrong_near += 1;
                share.tie.get_or_insert_with(|| Tie { at: floats(&at), holds });
            }
        }
    }
    Some(share)
}

struct Drawn<'a, M> {
    core: &'a Core,
    decision: &'a Decision,
    runner: Runner<'a, M>,
    places: Vec<(i64, i64)>,
    results: Vec<M>,
    random: Random,
}

fn floats<M: Machine>(at: &[i64]) -> Vec<M> {
    at.iter().map(|place| M::at(*place)).collect()
}

impl<M: Machine> Drawn<'_, M> {
    /// A point of the domain, by value or by the order of floats.
    fn point(&mut self, by_value: bool) -> Vec<i64> {
        let random = &mut self.random;
        self.places.iter().map(|ends| random.place::<M>(*ends, by_value)).collect()
    }

    /// A point within 1,024 floats of another, often nearer.
    fn next_to(&mut self, at: &[i64]) -> Vec<i64> {
        let random = &mut self.random;
        let one = |(place, &(first, last)): (&i64, &(i64, i64))| {
            let within = 1_i64 << (random.next() % 11);
            let near = (place.saturating_sub(within), place.saturating_add(within));
            random.place::<M>(near, false).clamp(first, last)
        };
        at.iter().zip(&self.places).map(one).collect()
    }

    /// How what is compared stands exactly; `None` if there is no value, or it is not known.
    fn order(&self, at: &[i64]) -> Option<Ordering> {
        let inputs: Option<Vec<Enclosure>> =
            at.iter().map(|place| Enclosure::of(M::at(*place))).collect();
        let inputs = inputs?;
        let (a, b) = self.decision.operands;
        BITS.iter().find_map(|bits| {
            let a = value(&self.core.program, a, &inputs, *bits)?;
            let b = value(&self.core.program, b, &inputs, *bits)?;
            a.sub(&b, *bits).sign()
        })
    }

    /// Whether floats decide wrongly, and what is right; `None` outside of the domain, or where it is not known.
    fn is_wrong(&mut self, at: &[i64]) -> Option<(bool, bool)> {
        let mut results = std::mem::take(&mut self.results);
        self.runner.run(&floats::<M>(at), &mut results);
        let compare = |rel: Rel, a: usize, b: usize| {
            Some(compares(rel, results.get(a)?.partial_cmp(results.get(b)?)))
        };
        let assumed = self.core.assumed.iter().all(|test| test.holds(&compare) == Some(true));
        let (a, b) = self.decision.operands;
        let computed = compare(self.decision.rel, a, b);
        self.results = results;
        if !assumed {
            return None;
        }
        let holds = compares(self.decision.rel, Some(self.order(at)?));
        Some((computed? != holds, holds))
    }

    /// A point at which the comparison turns to the float, along one argument in turn.
    fn tie(&mut self, turn: usize) -> Option<Vec<i64>> {
        let index = turn % self.places.len().max(1);
        let &(first, last) = self.places.get(index)?;
        let start = self.point(turn % 4 < 2);
        let mut along: Vec<i64> =
            (0..12).map(|_| self.random.place::<M>((first, last), false)).collect();
        along.extend([first, last, *start.get(index)?]);
        along.sort_unstable();
        let moved = |place: i64| {
            let mut at = start.clone();
            if let Some(known) = at.get_mut(index) {
                *known = place;
            }
            at
        };
        let orders: Vec<Option<Ordering>> =
            along.iter().map(|place| self.order(&moved(*place))).collect();
        let turns = along.windows(2).zip(orders.windows(2));
        let (mut low, mut high, below) = turns
            .filter_map(|(places, orders)| match (places, orders) {
                ([a, b], [Some(below), Some(above)]) if below != above => Some((*a, *b, *below)),
                _ => None,
            })
            .next()?;
        while high.abs_diff(low) > 1 {
            let middle = low.midpoint(high);
            if self.order(&moved(middle))? == below { low = middle } else { high = middle }
        }
        Some(moved(low))
    }
}
