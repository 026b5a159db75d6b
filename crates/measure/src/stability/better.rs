//! Formulas of equal value, and which of them does better on a range.

use kane_number::{Rational, parse};

use crate::{Arithmetic, Dyadic, Format, Formula, Plain};

use super::scan::Probe;
use super::{Better, Range, Subject};

/// Inputs at which formulas are compared, exactly where their values are rational.
const POINTS: [&str; 12] =
    ["1/3", "5/7", "11/13", "2", "17/5", "101/3", "1/97", "3/4", "8/5", "29/31", "1000", "1/1024"];
/// How many of these both must have.
const LEAST: usize = 4;
/// Bits to which irrational values are compared.
const BITS: u64 = 640;
const AGREE: i64 = 512;
/// Inputs of a range at which a formula is tried.
const PROBES: u64 = 48;
/// Hundredths of bits that make no difference.
const SMALL: i64 = 250;

/// Per formula, the others whose values are equal at every common point.
pub(super) fn groups(formulas: &[Formula]) -> Vec<Vec<usize>> {
    let mut groups = vec![Vec::new(); formulas.len()];
    for (i, a) in formulas.iter().enumerate() {
        for (j, b) in formulas.iter().enumerate().skip(i + 1) {
            if are_equal(a, b) {
                if let Some(group) = groups.get_mut(i) {
                    group.push(j);
                }
                if let Some(group) = groups.get_mut(j) {
                    group.push(i);
                }
            }
        }
    }
    groups
}

fn are_equal(a: &Formula, b: &Formula) -> bool {
    let names = |formula: &Formula| -> Vec<String> {
        formula.inputs.iter().map(|input| input.name.clone()).collect()
    };
    if names(a) != names(b) {
        return false;
    }
    let points: Vec<Rational> = POINTS.iter().filter_map(|text| parse(text).ok()).collect();
    let mut common = 0;
    for shift in 0..points.len() {
        let at = |i: usize| points.get((shift * (1 + 4 * i) + 3 * i) % points.len()).cloned();
        let inputs: Vec<Rational> = (0..a.inputs.len()).filter_map(at).collect();
        match equal_at(a, b, &inputs) {
            Some(false) => return false,
            Some(true) => common += 1,
            None => {}
        }
    }
    common >= LEAST
}

/// Whether both have the same value at a point; `None` if one has none there.
fn equal_at(a: &Formula, b: &Formula, inputs: &[Rational]) -> Option<bool> {
    let exact = Plain::<Rational>::new();
    let inside = |formula: &Formula| {
        formula.admits(&exact, inputs)
            && formula.inputs.iter().zip(inputs).all(|(input, x)| {
                input.lower.as_ref().is_none_or(|bound| bound.value <= *x)
                    && input.upper.as_ref().is_none_or(|bound| *x <= bound.value)
            })
    };
    if !inside(a) || !inside(b) {
        return None;
    }
    let (x, y) = (a.program.value(&exact, inputs), b.program.value(&exact, inputs));
    if let (Some(x), Some(y)) = (x, y) {
        return Some(x == y);
    }
    let wide = Dyadic { bits: BITS };
    let inputs: Vec<_> = inputs.iter().map(|x| wide.number(x)).collect();
    let (x, y) = (a.program.value(&wide, &inputs)?, b.program.value(&wide, &inputs)?);
    let rest = x.minus(&y);
    Some(rest.is_zero() || rest.binade() < x.binade() - AGREE)
}

/// The equal formula that loses least on a range, if it loses less than half of the digits
/// throughout. Of those that lose little, the one that fails on the fewest ranges, then the first.
pub(super) fn better<F: Format>(
    subject: &Subject,
    index: usize,
    negative: bool,
    range: &Range,
    failures: &[usize],
) -> Option<Better> {
    let mut best: Option<((i64, usize), Better)> = None;
    for other in subject.equal.get(index)? {
        let probe = Probe::<F>::new(subject, *other, negative)?;
        let (from, to) = (range.from.place, range.to.place);
        let width = to - from;
        let step = |i: u64| from + width / PROBES * i + (width % PROBES) * i / PROBES;
        let places = (0..=PROBES).map(step).chain([range.worst.place]);
        let mut lost = 0;
        let mut sound = true;
        for place in places {
            match probe.ask(place) {
                Some(tried) if tried.sample.fault.is_none() => lost = lost.max(tried.sample.lost),
                _ => {
                    sound = false;
                    break;
                }
            }
        }
        let key =
            (if lost <= SMALL { 0 } else { lost }, failures.get(*other).copied().unwrap_or(0));
        if sound && best.as_ref().is_none_or(|(known, _)| key < *known) {
            best = Some((key, Better { formula: *other, lost }));
        }
    }
    best.map(|(_, better)| better)
}
