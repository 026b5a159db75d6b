//! The greatest root in every system, against the exact algebraic one.

use kane_number::testkit::{Contract, RootProblem, greatest_roots};
use kane_number::{
    Algebraic, DoubleDouble, Integer, Interval, Number, OddFraction, Ordered, Rational, Real,
    Scaled, parse,
};

use crate::{quickcheck, rational, two_to};

/// Polynomials by their coefficients from the constant on, and the interval's ends.
fn problems() -> Vec<RootProblem> {
    let written = [
        // Degrees 0 and 1, also as formal cubics.
        ("1 2", "-1", "0"),
        ("-1 3 0 0", "0", "1"),
        ("0 1 0 0", "-1", "1"),
        // Pure squares and general quadratics.
        ("-2 0 1", "0", "2"),
        ("-1/4 0 1", "-1", "1"),
        ("-2 0 1", "-2", "0"),
        ("-1 -1 1", "0", "2"),
        ("3 -1000000 1", "0", "1"),
        ("3 -1000000 1", "1", "10000000"),
        ("1 -2 1", "0", "1"),
        ("1 -2 1", "1", "3"),
        ("0 -1 1", "0", "1"),
        ("0 -1 1", "-1", "1/2"),
        // Tiny and huge leading coefficients.
        ("-1 1 1e-300", "-3", "2"),
        ("-1 1 1e-300 1e-300", "-3", "2"),
        ("-1e-300 0 0 1e300", "-2", "2"),
        ("-1e300 1e-300 0 1e-300", "0", "1e201"),
        ("-1 1e200 1", "0", "1"),
        ("1e-30 -1 1 1e-20", "-1/2", "3/4"),
        // Cubics: one root, three, a triple one, and the reference.
        ("47 140 -3 20", "-1", "0"),
        ("-6 11 -6 1", "0", "4"),
        ("-6 11 -6 1", "0", "5/2"),
        ("-1 3 -3 1", "0", "2"),
        ("1 -3 0 1", "-2", "2"),
        ("-1 -3 0 1", "-1", "1"),
        ("0 1 0 1", "-2", "2"),
        // A double root at the upper end, where the value is zero.
        ("2 -3 0 1", "-3", "1"),
        ("1 1 -1 -1", "-1", "0"),
    ];
    let number = |text: &str| parse(text).expect("a number");
    let row = |(f, lower, upper): (&str, &str, &str)| {
        (f.split(' ').map(number).collect(), number(lower), number(upper))
    };
    written.into_iter().map(row).collect()
}

macro_rules! suite {
    ($($name:ident: $system:ty;)*) => {$(
        #[test]
        fn $name() {
            let asked = greatest_roots::<$system>(&problems());
            assert!(asked >= 20, "only {asked} polynomials kept their root");
            fn holds(f: (i8, i16, i16, i16), signs: (i8, i8)) -> bool {
                greatest_roots::<$system>(&[random_problem(f, signs)]) <= 1
            }
            quickcheck(8).quickcheck(holds as fn(_, _) -> bool);
        }
    )*};
}

suite! {
    f32_roots_are_a_step_off_at_most: f32;
    f64_roots_are_a_step_off_at_most: f64;
    double_double_roots_are_near: DoubleDouble;
    scaled_roots_are_near: Scaled;
    interval_roots_are_enclosed: Interval;
    rational_roots_are_found_and_others_refused: Rational;
    odd_fractions_find_the_rational_roots: OddFraction;
    algebraic_roots_are_themselves: Algebraic;
}

/// A polynomial that changes sign between two random ends, by choice of its constant.
fn random_problem(f: (i8, i16, i16, i16), (low, width): (i8, i8)) -> RootProblem {
    let lower = rational(low, 8);
    let upper = &lower + rational(i64::from(width).abs() + 1, 8);
    let mut f = [rational(0, 1), rational(f.1, 4), rational(f.2, 4), rational(f.3, 4)];
    let at =
        |f: &[Rational], x: &Rational| f.iter().rev().fold(rational(0, 1), |sum, c| sum * x + c);
    // Minus a third of one value and two thirds of the other.
    let (below, above) = (at(&f, &lower), at(&f, &upper));
    f[0] = -(below + above * Integer::from(2)) / Integer::from(3);
    f[0] = &f[0] * two_to(8);
    f[0] = f[0].round() / Integer::from(256);
    (f.to_vec(), lower, upper)
}

#[test]
fn enclosures_of_simple_roots_are_narrow() {
    let point = |f: &[f64]| f.iter().copied().map(Interval::from).collect::<Vec<_>>();
    let root = Interval::greatest_root(
        &point(&[47.0, 140.0, -3.0, 20.0]),
        &Interval::from(-1.0),
        &Interval::from(0.0),
    );
    assert!(root.expect("a root").width() < 1e-14);
}

#[test]
fn an_enclosure_holds_for_every_choice_of_coefficients() {
    // x² = c for c from 2 to 3: the roots fill [√2, √3].
    let c = Interval::between(-3.0, -2.0);
    let f = [c, Interval::zero(), Interval::one()];
    let root = Interval::greatest_root(&f, &Interval::zero(), &Interval::from(2.0)).expect("one");
    assert!(root.lower() <= 2.0_f64.sqrt() && 3.0_f64.sqrt() <= root.upper());
    assert!(root.width() < 0.32);
    let cubic = [c, Interval::zero(), Interval::zero(), Interval::between(1.0, 2.0)];
    let root = Interval::greatest_root(&cubic, &Interval::zero(), &Interval::from(2.0));
    let root = root.expect("a root");
    assert!(root.lower() <= 1.0 && 3.0_f64.cbrt() <= root.upper() && root.width() < 1.0);
}

#[test]
fn what_cannot_be_solved_is_refused() {
    assert_eq!(f64::greatest_root(&[1.0, 0.0, 1.0], &-1.0, &1.0), None);
    assert_eq!(f64::greatest_root(&[1.0], &-1.0, &1.0), None);
    assert_eq!(f64::greatest_root(&[0.0, 0.0, 0.0, 0.0, 1.0], &-1.0, &1.0), None);
    assert_eq!(f64::greatest_root(&[f64::NAN, 1.0], &-1.0, &1.0), None);
    assert_eq!(f64::greatest_root(&[1.0, 1.0], &f64::NEG_INFINITY, &1.0), Some(-1.0));
    let tall = [Interval::one(), Interval::zero(), Interval::one()];
    assert_eq!(Interval::greatest_root(&tall, &-Interval::one(), &Interval::one()), None);
    let two = rational(2, 1);
    let f = [-two.clone(), rational(0, 1), rational(1, 1)];
    assert_eq!(Rational::greatest_root(&f, &rational(0, 1), &two), None);
    let line = [-two.clone(), rational(1, 1)];
    for (lower, upper) in [(0, 1), (3, 4), (3, 1)] {
        let (lower, upper) = (rational(lower, 1), rational(upper, 1));
        assert_eq!(Rational::greatest_root(&line, &lower, &upper), None, "2 is elsewhere");
    }
}

#[test]
fn double_roots_inside_are_found_by_floats() {
    // (x − 1)²(x + 2), and (x − 1/3)² with a coefficient that is rounded.
    assert_eq!(f64::greatest_root(&[2.0, -3.0, 0.0, 1.0], &-3.0, &2.0), Some(1.0));
    let third = f64::greatest_root(&[1.0 / 9.0, -2.0 / 3.0, 1.0], &0.0, &1.0);
    assert!((third.expect("a root") - 1.0 / 3.0).abs() < 1e-7);
}

/// (x − r)(x² + r²) for powers of two from the least to the greatest, with ends that are far from the root: there is
/// none of its binade that is not come to within the steps that there are.
#[test]
fn the_root_of_a_cubic_is_found_in_every_binade() {
    for exponent in (-1000..=1000).step_by(125) {
        for sign in [1, -1] {
            let r = Scaled::from_rational(&(rational(3 * sign, 2) * two_to(exponent)));
            let square = r.square();
            let f = [-(square * r), square, -r, Scaled::one()];
            let far = Scaled::one().scaled_by(1020);
            for (lower, upper) in
                [(-far, far), (-far.double(), far), (Scaled::zero(), far), (-far, Scaled::zero())]
            {
                let found = Scaled::greatest_root(&f, &lower, &upper);
                if lower < r && r < upper {
                    let off = (found.expect("it is there") - r).abs();
                    assert!(off <= r.abs().scaled_by(-90), "{r} in [{lower}, {upper}]: {found:?}");
                } else {
                    assert_eq!(found, None, "{r} is not in [{lower}, {upper}]");
                }
            }
        }
    }
}

#[test]
fn where_floats_see_no_root_there_is_none_and_at_a_rounded_end_it_is_the_end() {
    // x² + 2x + 2 and x² + 2x + 1.001 are above zero
    for constant in [2.0, 1.001] {
        assert_eq!(f64::greatest_root(&[constant, 2.0, 1.0], &-3.0, &3.0), None);
        assert_eq!(f64::greatest_root(&[constant, -2.0, 1.0], &-3.0, &3.0), None);
    }
    // (x − 1/3)(x + 5), where 1/3 is the upper end
    let third = 1.0_f64 / 3.0;
    for upper in [third.next_down(), third, third.next_up()] {
        let root = f64::greatest_root(&[-5.0 / 3.0, 14.0 / 3.0, 1.0], &-1.0, &upper);
        assert!((root.expect("there is one") - third).abs() < 1e-15, "{upper}: {root:?}");
    }
}

#[test]
fn a_law_may_take_coefficients_from_another_root() {
    let whole = |n: i64| Algebraic::from(rational(n, 1));
    let root = whole(2).sqrt().expect("2 is positive");
    // x³ + √2·x − √2, and x² + x − √2.
    for f in [
        vec![-root.clone(), root.clone(), whole(0), whole(1)],
        vec![-root.clone(), whole(1), whole(1)],
    ] {
        let x = Algebraic::greatest_root(&f, &whole(0), &whole(5)).expect("a root");
        let value = f.iter().rev().fold(whole(0), |sum, c| sum * &x + c);
        assert_eq!(value.sign().is_equal(), Some(true), "{x}");
    }
}

/// The contract itself can fail: a wrong root is seen.
#[test]
fn the_suite_sees_a_wrong_root() {
    let root = Algebraic::roots(&[rational(-2, 1), rational(0, 1), rational(1, 1)]).remove(1);
    assert!(f64::admits_root(Some(&2.0_f64.sqrt()), &root));
    assert!(!f64::admits_root(Some(&1.414), &root));
    assert!(!f64::admits_root(None, &root));
    assert!(!Interval::admits_root(Some(&Interval::between(0.0, 1.4)), &root));
}
