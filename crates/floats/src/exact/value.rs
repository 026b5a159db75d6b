//! Programs over enclosures, and how far a float is from the truth.

use kane_number::Binary;

use super::Enclosure;
use crate::machine::{Machine, compares};
use crate::{Operation, Program};

/// Bits at which the first attempt is made, and the most.
const FIRST: u32 = 192;
const MOST: u32 = 6_144;
/// Bits of the value that are enough.
const ENOUGH: i64 = 80;

/// The enclosure of an operation's exact value at exact inputs, at a number of bits; `None` where
/// there is no value, or where these bits do not tell.
#[must_use]
pub fn value(program: &Program, root: usize, inputs: &[Enclosure], bits: u32) -> Option<Enclosure> {
    results(program, inputs, bits).into_iter().nth(root).flatten()
}

/// The exact results of all operations.
fn results(program: &Program, inputs: &[Enclosure], bits: u32) -> Vec<Option<Enclosure>> {
    let mut results: Vec<Option<Enclosure>> = Vec::with_capacity(program.operations().len());
    for operation in program.operations() {
        let at = |index: usize| results.get(index)?.as_ref();
        let result = match *operation {
            Operation::Number(ref number) => Some(Enclosure::of_rational(number, bits)),
            Operation::Input(input) => inputs.get(input).cloned(),
            Operation::Neg(a) => at(a).map(Enclosure::neg),
            Operation::Add(a, b) => at(a).zip(at(b)).map(|(a, b)| a.add(b, bits)),
            Operation::Sub(a, b) => at(a).zip(at(b)).map(|(a, b)| a.sub(b, bits)),
            Operation::Mul(a, b) => at(a).zip(at(b)).map(|(a, b)| a.mul(b, bits)),
            Operation::Div(a, b) => at(a).zip(at(b)).and_then(|(a, b)| a.div(b, bits)),
            Operation::Sqrt(a) => at(a).and_then(|a| a.sqrt(bits)),
            Operation::Fma(a, b, c) => {
                at(a).zip(at(b)).zip(at(c)).map(|((a, b), c)| a.mul(b, bits).add(c, bits))
            }
            Operation::Abs(a) => at(a).map(Enclosure::abs),
            Operation::Min(a, b) => at(a).zip(at(b)).map(|(a, b)| a.min(b)),
            Operation::Max(a, b) => at(a).zip(at(b)).map(|(a, b)| a.max(b)),
            Operation::If(ref test, a, b) => {
                let compare = |rel, a, b| {
                    let difference = at(a)?.sub(at(b)?, bits);
                    Some(compares(rel, Some(difference.sign()?)))
                };
                match test.holds(&compare) {
                    Some(true) => at(a).cloned(),
                    Some(false) => at(b).cloned(),
                    None => None,
                }
            }
        };
        results.push(result);
    }
    results
}

/// A computed value beside the exact one.
#[derive(Clone, Debug)]
pub struct Compared {
    /// the exact value
    pub exact: Enclosure,
    /// |computed − exact| at least, as a float rounded down; ∞ for a computed NaN or ±∞
    pub error: f64,
    /// and at most
    pub error_at_most: f64,
    /// the error in ulps of the exact value at least
    pub ulps: f64,
    /// and at most
    pub ulps_at_most: f64,
}

/// Compares what a program returns with its exact value. Rigorous: `None` where there is no exact
/// value, or where 6,144 bits do not tell it.
#[must_use]
pub fn compared<M: Machine>(
    program: &Program,
    root: usize,
    inputs: &[M],
    computed: M,
) -> Option<Compared> {
    let inputs: Vec<Enclosure> = inputs.iter().map(|x| Enclosure::of(*x)).collect::<Option<_>>()?;
    let mut bits = FIRST;
    loop {
        let found = value(program, root, &inputs, bits);
        let last = bits >= MOST;
        if let Some(exact) = found {
            let Some(float) = Enclosure::of(computed) else {
                let infinite = f64::INFINITY;
                return Some(Compared {
                    exact,
                    error: infinite,
                    error_at_most: infinite,
                    ulps: infinite,
                    ulps_at_most: infinite,
                });
            };
            let error = float.sub(&exact, bits).abs();
            if last || suffices(&exact, ENOUGH) && suffices(&error, 20) {
                return Some(told::<M>(exact, &error));
            }
        } else if last {
            return None;
        }
        bits *= 2;
    }
}

/// Whether so many bits of an enclosure are known, or it is so far below every double, in which errors are told, that more
/// of them change nothing: of sqrt(x + 0) − sqrt(x) no number of bits is enough.
fn suffices(enclosure: &Enclosure, bits: i64) -> bool {
    enclosure.sharpness() >= bits || enclosure.binades().1 < f64::LEAST_EXPONENT - ENOUGH
}

fn told<M: Machine>(exact: Enclosure, error: &Enclosure) -> Compared {
    let (least, most) = error.ends();
    let precision = i64::from(M::PRECISION);
    let (low, high) = exact.binades();
    let unit = |binade: i64| binade.max(M::LEAST_EXPONENT + precision - 1) - precision + 1;
    // by a power of two before it is rounded: an error below the least float is some part of an ulp
    let (ulps, _) = error.scaled(-unit(high)).ends();
    let (_, ulps_at_most) = error.scaled(-unit(low)).ends();
    Compared { exact, error: least, error_at_most: most, ulps, ulps_at_most }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fpcore;

    /// The enclosure of a formula of x at 2e-300.
    fn at(formula: &str, bits: u32) -> Enclosure {
        let text = format!("(FPCore (x) :pre (<= 0 x 1) {formula})");
        let core = fpcore::read("t.fpcore", &text).unwrap().remove(0);
        value(&core.program, core.root, &[Enclosure::of(2e-300).unwrap()], bits).unwrap()
    }

    #[test]
    fn a_value_that_is_zero_needs_no_more_bits_than_tell_that_it_is_below_every_float() {
        let nothing = "(- (sqrt (+ x 0)) (sqrt x))";
        // a root is 2^-498, and an ulp of it 2^-690 or 2^-1266
        assert!(!suffices(&at(nothing, 192), ENOUGH));
        assert!(suffices(&at(nothing, 768), ENOUGH));
        // and what is told is what all the bits tell, but for parts of an ulp that nobody sees
        let told_at = |bits: u32| {
            let exact = at(nothing, bits);
            let error = Enclosure::of(0.0).unwrap().sub(&exact, bits).abs();
            let told = told::<f64>(exact, &error);
            assert!(told.ulps_at_most < 1e-24, "{bits}: {told:?}");
            [told.error, told.error_at_most, told.ulps].map(f64::to_bits)
        };
        assert_eq!(told_at(768), told_at(MOST));
    }

    #[test]
    fn an_error_below_the_least_float_is_so_much_of_an_ulp() {
        // 3/10 of seven least floats: 2.1 of them, of which the machine returns two
        let text = "(FPCore (x) :precision binary64 :pre (<= 0 x 1) (* x 0.3))";
        let core = fpcore::read("t.fpcore", text).unwrap().remove(0);
        let least = f64::from_bits(1);
        let found = compared(&core.program, core.root, &[7.0 * least], 2.0 * least).unwrap();
        assert_eq!((found.error, found.error_at_most), (0.0, least));
        assert!(
            (found.ulps - 0.1).abs() < 1e-15 && (found.ulps_at_most - 0.1).abs() < 1e-15,
            "{found:?}"
        );
    }

    #[test]
    fn a_value_next_to_the_least_float_is_told_to_its_bits() {
        // 4e-600 is far below every float, and 4e-324 rounds to the least one
        assert!(suffices(&at("(* x x)", 4), ENOUGH));
        let small = "(* (sqrt x) (* (sqrt x) 2e-24))";
        assert!(!suffices(&at(small, 40), ENOUGH));
        assert!(suffices(&at(small, 192), ENOUGH));
    }
}
