//! How far a method is from the exact value, over the domain.

use kane_number::{Rational, System};

use super::method::{Answer, Method};
use super::registry::DOMAIN;
use crate::{Arithmetic, Dyadic, DyadicNumber, Format, Program, formulas};

/// Inputs drawn over the domain, beside the ones of `chosen`.
const DRAWN: u64 = 768;
/// Bits of the reference: what can cancel over the domain is far less.
const BITS: u64 = 640;

/// The error of a method over its domain. Digits are decimal, in hundredths, and of the relative
/// error: −100·log₁₀|x − exact|/|exact|.
#[derive(Clone, Debug, PartialEq)]
pub struct Accuracy {
    /// digits that are right at the worst input; `i64::MAX` if all answers are exact
    pub worst: i64,
    /// digits that are right at the median input
    pub median: i64,
    /// the worst input
    pub at: f64,
    /// the worst error in hundredths of log₂ ulps of the format, for `f32` and `f64`
    pub ulps: Option<i64>,
    /// the greatest input
    pub greatest: f64,
    /// how many inputs were tried
    pub tried: usize,
}

/// The inputs of a method: floats of its own format, evenly drawn over the binades, with powers of
/// two and the neighbours of 1. `f64` serves the systems that are wider.
#[must_use]
pub(super) fn inputs(method: &Method) -> Vec<f64> {
    match method.system {
        System::F32 => drawn::<f32>(method.least),
        _ => drawn::<f64>(method.least),
    }
}

fn drawn<F: Format>(least: i32) -> Vec<f64> {
    let place = |exponent: i32| -> u64 {
        let biased = i64::from(exponent) + F::GREATEST_EXPONENT;
        u64::try_from(biased).unwrap_or(0) << (F::PRECISION - 1)
    };
    let least = least.max(DOMAIN.0);
    let (first, last) = (place(least), place(DOMAIN.1));
    let mut seed = 0x5851_f42d_4c95_7f2d_u64;
    let mut places: Vec<u64> = (least..=DOMAIN.1).map(place).collect();
    for bit in 0..F::PRECISION - 2 {
        places.extend([place(0) - (1 << bit), place(0) + (1 << bit)]);
    }
    for _ in 0..DRAWN {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (seed ^ (seed >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        places.push(first + (mixed >> 1) % (last - first).max(1));
    }
    places.retain(|place| (first..=last).contains(place));
    places.sort_unstable();
    places.dedup();
    let value = |place: u64| {
        kane_number::decode(F::at(place)).map_or(f64::NAN, |exact| {
            kane_number::encode(&exact, kane_number::Rounding::NearestEven)
        })
    };
    places.into_iter().map(value).collect()
}

/// The form of a method as a program over α, read from its text.
#[must_use]
pub(super) fn program(method: &Method) -> Option<Program> {
    let k = if method.k.is_empty() { String::new() } else { format!("let k := {}\n", method.k) };
    let text = format!("```kane\nvar alpha > 0\n{k}let form := {}\n```\n", method.text);
    let document = kane_audit::read("form", text.as_bytes()).ok()?;
    formulas(&document).formulas.into_iter().next_back().map(|formula| formula.program)
}

/// Compares a method with the exact value of its form; `None` if it has no answer at most inputs,
/// as where its system has no roots.
#[must_use]
pub fn accuracy(method: &Method) -> Option<Accuracy> {
    accuracy_up_to(method, f64::INFINITY)
}

/// The same over the inputs that are no greater than `reach`.
pub(super) fn accuracy_up_to(method: &Method, reach: f64) -> Option<Accuracy> {
    let program = program(method)?;
    let reference = Dyadic { bits: BITS };
    let mut digits: Vec<(i64, f64)> = Vec::new();
    let mut ulps: Option<i64> = None;
    let mut inputs = inputs(method);
    inputs.retain(|alpha| *alpha <= reach);
    let tried = inputs.len();
    let greatest = inputs.last().copied()?;
    for alpha in inputs {
        let exact = program.value(&reference, &[alpha.exactly()?])?;
        if exact.certain_bits() < 200 {
            // 0: a relative error has no meaning
            continue;
        }
        match method.answer(alpha) {
            None => digits.push((0, alpha)),
            Some(answer) => {
                let error = error(&reference, &answer, &exact);
                digits.push((right(&error, &exact), alpha));
                ulps = ulps.max(in_ulps(method.system, &error, &exact));
            }
        }
    }
    let none = digits.iter().filter(|(digits, _)| *digits == 0).count();
    if digits.is_empty() || 2 * none > digits.len() {
        return None;
    }
    digits.sort_by_key(|(digits, alpha)| (*digits, alpha.to_bits()));
    let (worst, at) = *digits.first()?;
    let (median, _) = *digits.get(digits.len() / 2)?;
    Some(Accuracy { worst, median, at, ulps, greatest, tried })
}

/// |x − exact|, for an enclosure that of the end further away.
fn error(reference: &Dyadic, answer: &Answer, exact: &DyadicNumber) -> DyadicNumber {
    let distance = |x: &Rational| {
        let difference = reference.number(x).minus(exact);
        if difference.is_negative() { reference.neg(&difference) } else { difference }
    };
    match answer {
        Answer::Number(x) => distance(x),
        Answer::Between(lower, upper) => {
            let (a, b) = (distance(lower), distance(upper));
            if a.minus(&b).is_negative() { b } else { a }
        }
    }
}

/// Hundredths of decimal digits that are right; all of them if the error is no more than the doubt
/// about the reference.
pub(crate) fn right(error: &DyadicNumber, exact: &DyadicNumber) -> i64 {
    if error.certain_bits() <= 8 {
        return i64::MAX;
    }
    match (error.hundredths_of_log2(), exact.hundredths_of_log2()) {
        (Some(error), Some(exact)) => ((exact - error) * 30_103 / 100_000).max(0),
        _ => i64::MAX,
    }
}

fn in_ulps(system: System, error: &DyadicNumber, exact: &DyadicNumber) -> Option<i64> {
    let precision = match system {
        System::F32 => 24,
        System::F64 => 53,
        _ => return None,
    };
    Some(error.hundredths_of_log2()? - 100 * (exact.binade() - precision + 1))
}
