//! Roots that rounding could move elsewhere: next to an end, next to each other, double ones.

use kane_number::testkit::{RootProblem, greatest_roots};
use kane_number::{DoubleDouble, Number, Rational, Real, Scaled};

use crate::{rational, two_to};

/// c(x − r)(x − s)… from the constant on.
fn with_roots(c: &Rational, roots: &[Rational]) -> Vec<Rational> {
    roots.iter().fold(vec![c.clone()], |f, root| {
        let shifted = std::iter::once(rational(0, 1)).chain(f.iter().cloned());
        let lowered = f.iter().map(|c| -c * root).chain([rational(0, 1)]);
        shifted.zip(lowered).map(|(a, b)| a + b).collect()
    })
}

/// The discriminant of such a polynomial is what is left of two products that agree in all but some bits.
#[test]
fn wide_floats_find_close_roots_to_their_precision() {
    let mut problems: Vec<RootProblem> = Vec::new();
    for bits in [10, 20, 30, 40] {
        for r in [rational(1, 3), rational(-7, 5), rational(22, 7)] {
            let s = &r + two_to(-bits);
            let middle = (&r + &s) * two_to(-1);
            let f = with_roots(&rational(5, 7), &[r.clone(), s.clone()]);
            problems.push((f.clone(), middle.clone(), &r + rational(1, 1)));
            problems.push((f, &r - rational(1, 1), middle.clone()));
        }
    }
    assert_eq!(greatest_roots::<Scaled>(&problems), problems.len());
    assert_eq!(greatest_roots::<DoubleDouble>(&problems), problems.len());
}

/// The root is the lower end, and the polynomial vanishes at the upper one to within the noise of coefficients that
/// were rounded: these are not.
#[test]
fn an_end_that_is_a_root_exactly_is_the_root() {
    for f in
        [vec![-1.0, 1.0], vec![-1.0, 1.0, 0.0], vec![-2.0, 1.0, 1.0], vec![-3.0, 1.0, 1.0, 1.0]]
    {
        for width in [1e-3, 2_f64.powi(-50)] {
            let (lower, upper) = (1.0, 1.0 + width);
            assert_eq!(f64::greatest_root(&f, &lower, &upper), Some(1.0), "{f:?} to {upper:e}");
        }
        assert_eq!(f64::greatest_root(&f, &0.5, &1.0), Some(1.0), "{f:?}");
    }
}

/// (x − 1/3)(x² − 1/16), with 1/3 rounded to a float r, between −1 and an end next to r. Just below r the signs are
/// equal, and one of the ends is a root, as is promised, but for rounding: not 1/4, though there the sign changes. Some
/// steps above r the signs differ, and the root is r.
#[test]
fn an_end_next_to_a_root_is_the_root_only_if_the_signs_are_equal() {
    let r = 1.0_f64 / 3.0;
    let f = [r / 16.0, -1.0 / 16.0, -r, 1.0];
    let below = r.next_down();
    assert_eq!(f64::greatest_root(&f, &-1.0, &below), Some(below));
    assert_eq!(f64::greatest_root(&f, &-1.0, &r), Some(r));
    let above = f64::from_bits(r.to_bits() + 8);
    assert_eq!(f64::greatest_root(&f, &-1.0, &above), Some(r));
    // from 1/4, a root exactly, there is no sign below
    assert_eq!(f64::greatest_root(&f, &0.25, &0.3), Some(0.25));
}

/// (x − s)(x² − 1/4) and (x − s)(x − 1/2) for s above 1 by 2⁻¹⁰⁴, all of whose coefficients wide floats hold: between 0
/// and 1 the sign changes at 1/2, though the value at 1 is next to zero.
#[test]
fn a_root_beyond_the_end_is_not_the_one_however_near() {
    let s = rational(1, 1) + two_to(-104);
    let half = two_to(-1);
    let problems = [vec![s.clone(), half.clone()], vec![s, half.clone(), -half]]
        .map(|roots| (with_roots(&rational(1, 1), &roots), rational(0, 1), rational(1, 1)));
    assert_eq!(greatest_roots::<Scaled>(&problems), 2);
}

/// (3x − 1)²(x + 2) and 3·(x − 1/3)² with what rounding leaves of it: no float is the root, so nowhere is the value zero.
#[test]
fn double_roots_that_are_no_floats_are_found() {
    let third = 1.0_f64 / 3.0;
    for upper in [1.0, 2.0, 1e3] {
        assert_eq!(f64::greatest_root(&[2.0, -11.0, 12.0, 9.0], &-3.0, &upper), Some(third));
        assert_eq!(f64::greatest_root(&[-2.0, 11.0, -12.0, -9.0], &-3.0, &upper), Some(third));
    }
    // the constant is a step above or below that of a square
    for constant in [third.next_up(), third, third.next_down()] {
        for (f, root) in [([constant, -2.0, 3.0], third), ([-constant, -2.0, -3.0], -third)] {
            let found = f64::greatest_root(&f, &-2.0, &2.0).expect("there is one");
            assert!((found - root).abs() < 2e-8, "{f:?}: {found}");
            // one float above 1/3 there is no root any more, and the vertex is given
            let above = constant > third;
            assert!(!above || (found - root).abs() < 1e-15, "the vertex of {f:?}, not {found}");
        }
    }
}

/// The root of lowest magnitude lies just beyond the bound below which there is none, on either side of zero.
#[test]
fn a_root_is_found_next_to_an_end_that_is_zero() {
    let mut problems: Vec<RootProblem> = Vec::new();
    for bits in [1, 2, 3, 60, 400] {
        for sign in [1, -1] {
            let r = rational(sign, 3) * two_to(-bits);
            let f = with_roots(
                &rational(3, 1),
                &[r.clone(), rational(7 * sign, 2), rational(9 * sign, 2)],
            );
            for far in [two_to(0), &r * rational(2 * sign, 1), &r * rational(257 * sign, 256)] {
                let (lower, upper) =
                    if sign > 0 { (rational(0, 1), far) } else { (-far, rational(0, 1)) };
                problems.push((f.clone(), lower, upper));
            }
        }
    }
    assert_eq!(greatest_roots::<Scaled>(&problems), problems.len());
    assert_eq!(Scaled::greatest_root(&[Scaled::one()], &Scaled::zero(), &Scaled::one()), None);
}
