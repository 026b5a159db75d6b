//! The root of an ordinary quadratic, without the room that the general method keeps for extremes.
#![allow(clippy::float_arithmetic, reason = "the numbers here are floating ones")]

use crate::error_free::two_product;
use crate::{DoubleDouble, Number as _};

/// Magnitudes between 2⁻¹⁰⁰ and 2¹⁰⁰, by their bits: no step below over- or underflows.
const LEAST: f64 = f64::from_bits((1023 - 100) << 52);
const GREATEST: f64 = f64::from_bits((1023 + 100) << 52);

fn is_ordinary(x: f64) -> bool {
    (LEAST..=GREATEST).contains(&x.abs())
}

/// The greatest root of c₀ + c₁x + c₂x² strictly inside of \[lower, upper\], where the polynomial
/// certainly changes its sign over that interval and all its coefficients are
/// ordinary; `None` otherwise, which says nothing.
///
/// The very number that [`float::greatest_root`](super::float::greatest_root) gives: the same
/// operations of double-doubles, of which [`Scaled`](crate::Scaled) differs by powers of two alone,
/// less those whose results are known to be zero or not to matter.
pub(crate) fn greatest_root(
    [c0, c1, c2]: [f64; 3],
    lower: f64,
    upper: f64,
) -> Option<DoubleDouble> {
    let ends_are_ordinary = [lower, upper].iter().all(|x| *x == 0.0 || is_ordinary(*x));
    if !([c0, c1, c2].into_iter().all(is_ordinary) && ends_are_ordinary && lower < upper) {
        return None;
    }
    if sign_at([c0, c1, c2], lower)? == sign_at([c0, c1, c2], upper)? {
        return None;
    }
    // h² − c₂c₀ with h = c₁/2, where the last product is exact as a pair
    let half = DoubleDouble::from(c1 / 2.0);
    let product = DoubleDouble::of(two_product(c2, c0));
    let discriminant = half.mul_add(&half, &-product);
    let root = discriminant.sqrt()?;
    let sum = if c1 < 0.0 { root - half } else { -(half + root) };
    let (first, second) = (sum / DoubleDouble::from(c2), DoubleDouble::from(c0) / sum);
    let (greater, lesser) = if first > second { (first, second) } else { (second, first) };
    let (lower, upper) = (DoubleDouble::from(lower), DoubleDouble::from(upper));
    [greater, lesser].into_iter().find(|x| lower < *x && *x < upper)
}

/// Whether the value at x is below zero, or `None` if floats do not tell: four roundings, each of at
/// most 2⁻⁵³ of the sum of magnitudes, are less than 2⁻⁵⁰ of it.
fn sign_at(coefficients: [f64; 3], x: f64) -> Option<bool> {
    let at = |[c0, c1, c2]: [f64; 3], x: f64| (c2 * x + c1) * x + c0;
    let (value, magnitude) = (at(coefficients, x), at(coefficients.map(f64::abs), x.abs()));
    (value.abs() > 8.0 * f64::EPSILON * magnitude).then_some(value.is_sign_negative())
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    use quickcheck::{Gen, QuickCheck};

    use num_traits::{Signed as _, Zero as _};

    use super::*;
    use crate::{Rational, Scaled, decode, power_of, root::float};

    /// What the general method gives, with the noise of coefficients in binary64.
    fn general(coefficients: [f64; 3], lower: f64, upper: f64) -> Option<f64> {
        let wide = coefficients.map(Scaled::from);
        float::greatest_root(&wide, &Scaled::from(lower), &Scaled::from(upper), -49)
            .map(Scaled::to_f64)
    }

    #[test]
    fn an_ordinary_root_is_the_one_of_the_general_method_bit_by_bit() {
        static FOUND: AtomicUsize = AtomicUsize::new(0);
        fn agrees(c: (u64, u64, u64), ends: (u64, u64), spread: u8) -> bool {
            // a float of any significand between 2^−spread and 2^spread, of either sign
            let float = |bits: u64| {
                let power =
                    i64::try_from(bits >> 8 & 0xff).unwrap_or(0) % i64::from(spread % 120 + 1);
                let signed = if bits & 2 == 0 { power } else { -power };
                let exponent = (signed + 1023).unsigned_abs() << 52;
                f64::from_bits(bits >> 12 & ((1 << 52) - 1) | exponent | (bits & 1) << 63)
            };
            let coefficients = [c.0, c.1, c.2].map(float);
            let (a, b) =
                (float(ends.0), if ends.1.is_multiple_of(5) { 0.0 } else { float(ends.1) });
            let (lower, upper) = (a.min(b), a.max(b));
            greatest_root(coefficients, lower, upper).is_none_or(|root| {
                FOUND.fetch_add(1, Relaxed);
                Some(root.high()) == general(coefficients, lower, upper)
            })
        }
        QuickCheck::new()
            .rng(Gen::from_size_and_seed(100, 0x6b61_6e65))
            .tests(20_000)
            .quickcheck(agrees as fn(_, _, _) -> bool);
        assert!(FOUND.load(Relaxed) > 2_000, "{FOUND:?} of 20,000 are ordinary");
    }

    /// As Smith's law asks: v·x² − (2v + p)·x + 2v between 0 and 1, with p > v.
    #[test]
    fn the_roots_of_a_law_are_ordinary() {
        let mut found = 0;
        for step in 0..2000_u32 {
            let (v, p) = (0.3 + f64::from(step % 37), 40.0 + f64::from(step) / 7.0);
            let coefficients = [2.0 * v, -(2.0 * v + p), v];
            let root = greatest_root(coefficients, 0.0, 1.0).map(DoubleDouble::high);
            assert_eq!(root, general(coefficients, 0.0, 1.0), "{coefficients:?}");
            found += 1;
        }
        assert_eq!(found, 2000);
    }

    #[test]
    fn where_floats_tell_a_sign_it_is_that_of_the_fraction() {
        let exact = |x: f64| decode(x).expect("it is finite");
        let mut told = [0; 2];
        // of two roots of opposite signs next to the less one the square is small, and the terms that cancel are not
        for (r, s, c2) in [
            (0.1, -3.7, 1.3),
            (-0.7, 1e6, -0.9),
            (-5.1, -1e-7, 7.0),
            (1e20, -2.3, 0.3),
            (-0.3, 1.1, 3.3),
            (0.77, -12.9, -0.17),
            (6.1, -6.7, 1.9),
        ] {
            // c₂(x − r)(x − s), rounded
            let c = [c2 * r * s, -c2 * (r + s), c2];
            let near = |root: f64| {
                let steps = (0..9).map(move |step| f64::from_bits(root.to_bits() - 4 + step));
                steps.chain([-1e-3, -3e-15, 1e-15, 2e-14].map(|off| root * (1.0 + off)))
            };
            for x in near(r).chain(near(s)).chain([0.0, 1.0, -2.0, -(r + s) / 2.0]) {
                let at = |c: [Rational; 3], x: &Rational| (&c[2] * x + &c[1]) * x + &c[0];
                let value = at(c.map(exact), &exact(x));
                let magnitude = at(c.map(|c| exact(c.abs())), &exact(x.abs()));
                let sign = sign_at(c, x);
                let below = value.is_negative();
                assert!(sign.is_none_or(|sign| sign == below && !value.is_zero()), "{c:?} at {x}");
                let clear = value.abs() > magnitude * power_of(2, -48);
                assert!(sign.is_some() || !clear, "{c:?} at {x} is {value}");
                told[usize::from(sign.is_some())] += 1;
            }
        }
        assert!(told[0] >= 8 && told[1] >= 30, "{told:?}");
    }

    #[test]
    fn what_is_not_ordinary_is_left_to_the_general_method() {
        assert!(greatest_root([1.0, -3.0, 2.0], 0.0, 0.75).is_some());
        for (coefficients, lower, upper) in [
            ([1.0, -2.0, 1.0], 0.0, 3.0),      // a double root: no change of sign
            ([1.0, -3.0, 2.0], 0.0, 1.0),      // a root at the end
            ([0.0, -3.0, 2.0], -1.0, 1.0),     // no constant
            ([1.0, -3.0, 0.0], 0.0, 1.0),      // no square
            ([1e-40, -3.0, 2.0], 0.0, 1.0),    // too small a constant
            ([f64::NAN, -3.0, 2.0], 0.0, 1.0), // no number
            ([1.0, -3.0, 2.0], 0.0, f64::INFINITY), // no end
            ([1.0, -3.0, 2.0], 0.75, 0.0),     // ends the wrong way
        ] {
            assert!(greatest_root(coefficients, lower, upper).is_none(), "{coefficients:?}");
        }
    }
}
