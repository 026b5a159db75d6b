//! Equal forms of a formula that lose fewer digits.
//!
//! A beam search over rewritings: conjugates, common denominators, differences of squares, forms that are
//! multiplied out, fused operations. What ranks them is the error at points of the domain, compared with the
//! exact value of the formula as it was given. The result is a proposal: that it is equal is for the auditor
//! to prove.
#![allow(
    clippy::float_arithmetic,
    reason = "forms are ranked by float errors; nothing rests on it"
)]

mod fused;
mod rules;
mod tree;

use std::collections::HashSet;

use kane_number::{DoubleDouble, Number as _};

use crate::Core;
use crate::exact::{Enclosure, value};
use crate::machine::{Machine, Runner, compares};
use crate::rigor::{Cell, Inputs, upward};
use tree::Tree;

pub use fused::fused;

/// A form that may be better, with what it loses at the points that were tried.
#[derive(Clone, Debug)]
pub struct Proposal {
    /// the formula
    pub core: Core,
    /// bits lost at the worst point that was tried
    pub lost: f64,
    /// and on average
    pub lost_on_average: f64,
}

/// Forms that go on to the next round, rounds, and points.
const BEAM: usize = 10;
const ROUNDS: usize = 4;
const POINTS: usize = 240;

/// Looks for equal forms in the format of `M`, the best first; the formula as it was given comes with them,
/// as the first of the pair. `None` if the formula has choices, is too large, or has no value at most points.
#[must_use]
pub fn repairs<M: Machine>(core: &Core, further: &[Vec<M>]) -> Option<(Proposal, Vec<Proposal>)> {
    let start = Tree::of(&core.program, core.root)?;
    let points = points::<M>(core, further);
    if points.len() < 8 {
        return None;
    }
    let rank = |tree: &Tree| {
        let core = tree.core(core);
        let (lost, lost_on_average) = lost(&core, &points);
        Proposal { core, lost, lost_on_average }
    };
    let given = Proposal { core: core.clone(), ..rank(&start) };
    let mut seen: HashSet<Tree> = HashSet::from([start.clone()]);
    let mut beam = vec![(start, given.clone())];
    let mut all: Vec<(Tree, Proposal)> = Vec::new();
    for _ in 0..ROUNDS {
        let mut next: Vec<(Tree, Proposal)> = Vec::new();
        for (tree, _) in &beam {
            for form in everywhere(tree) {
                if form.nodes() <= tree::MOST_NODES && seen.insert(form.clone()) {
                    let proposal = rank(&form);
                    next.push((form, proposal));
                }
            }
        }
        if next.is_empty() {
            break;
        }
        sort(&mut next);
        all.extend(next.iter().take(BEAM).cloned());
        next.truncate(BEAM);
        beam = next;
    }
    sort(&mut all);
    let better = |proposal: &Proposal| {
        proposal.lost + 1.0 < given.lost || proposal.lost_on_average + 0.5 < given.lost_on_average
    };
    let found = all.into_iter().map(|(_, proposal)| proposal).filter(better).take(6).collect();
    Some((given, found))
}

/// By the bits lost, worst and average together; of those that lose as much, the cheaper first.
fn sort(forms: &mut [(Tree, Proposal)]) {
    let key = |(tree, proposal): &(Tree, Proposal)| {
        // a bit more or less is no difference
        let lost = (proposal.lost + 2.0 * proposal.lost_on_average).round();
        (lost, tree.nodes())
    };
    forms.sort_by(|a, b| {
        let (a, b) = (key(a), key(b));
        a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))
    });
}

/// All trees that differ by one rewriting somewhere.
fn everywhere(tree: &Tree) -> Vec<Tree> {
    let mut found = rules::at_top(tree);
    for (index, part) in tree.parts().into_iter().enumerate() {
        found.extend(everywhere(part).into_iter().map(|part| tree.with(index, part)));
    }
    found
}

/// A point of the domain, and the exact value there.
struct Point<M> {
    at: Vec<M>,
    exact: DoubleDouble,
}

fn points<M: Machine>(core: &Core, further: &[Vec<M>]) -> Vec<Point<M>> {
    let Ok(whole) = Cell::whole::<M>(core, Inputs::Floats) else { return Vec::new() };
    let mut found = Vec::new();
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        seed >> 11
    };
    let runner = Runner::<M>::new(&core.program);
    let drawn = (0..POINTS).map(|turn| {
        let place = |&(lower, upper): &(f64, f64)| {
            let (low, high) = (M::nearest(lower), M::nearest(upper));
            if turn % 2 == 0 {
                let width = low.place().abs_diff(high.place());
                let step = if width == u64::MAX { draw() } else { draw() % (width + 1) };
                M::at(low.place().saturating_add(i64::try_from(step).unwrap_or(i64::MAX)))
            } else {
                let part = f64::from_bits((draw() & ((1 << 52) - 1)) | 1.0_f64.to_bits()) - 1.0;
                M::nearest(lower * (1.0 - part) + upper * part)
            }
        };
        whole.ends.iter().map(place).collect::<Vec<M>>()
    });
    let drawn: Vec<Vec<M>> = drawn.collect();
    for at in further.iter().cloned().chain(drawn) {
        let mut results = Vec::new();
        runner.run(&at, &mut results);
        let compare = |rel, a: usize, b: usize| {
            Some(compares(rel, results.get(a)?.partial_cmp(results.get(b)?)))
        };
        if !core.assumed.iter().all(|test| test.holds(&compare) == Some(true)) {
            continue;
        }
        let inputs: Option<Vec<Enclosure>> = at.iter().map(|x| Enclosure::of(*x)).collect();
        let Some(inputs) = inputs else { continue };
        let sharp = |bits: u32| {
            value(&core.program, core.root, &inputs, bits).filter(|exact| exact.sharpness() > 70)
        };
        if let Some(exact) = sharp(256).or_else(|| sharp(2_048)) {
            let exact = DoubleDouble::from_rational(&exact.middle());
            if exact.is_finite() && M::nearest(exact.high()).finite() {
                found.push(Point { at, exact });
            }
        }
    }
    found
}

/// Bits that a form loses at the worst of the points, and on average.
fn lost<M: Machine>(core: &Core, points: &[Point<M>]) -> (f64, f64) {
    let runner = Runner::<M>::new(&core.program);
    let all = f64::from(M::PRECISION);
    let (mut worst, mut sum) = (0.0_f64, 0.0);
    let mut results = Vec::new();
    for point in points {
        runner.run(&point.at, &mut results);
        let bits = match results.get(core.root) {
            Some(computed) if computed.finite() => {
                let error = (DoubleDouble::from(computed.wide()) - point.exact).high().abs();
                let unit = upward::power(1 - i64::from(M::PRECISION)) * point.exact.high().abs();
                let ulps = error / unit.max(upward::power(M::LEAST_EXPONENT));
                (1.0 + ulps).log2().min(all)
            }
            _ => all,
        };
        worst = worst.max(bits);
        sum += bits;
    }
    let count = f64::from(u32::try_from(points.len()).unwrap_or(1).max(1));
    (worst, sum / count)
}
