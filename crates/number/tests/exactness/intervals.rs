//! Intervals enclose, do not widen without need, and answer only what is certain.

use kane_number::{
    Comparison, Interval, Number, Ordered, Rational, Rounding, decode, encode, parse,
};

use crate::{quickcheck, rational};

fn tightest(exact: &Rational) -> Interval {
    Interval::from_rational(exact)
}

#[test]
fn points_give_the_tightest_enclosure() {
    fn holds(a: u64, b: u64) -> bool {
        let (a, b) = (f64::from_bits(a), f64::from_bits(b));
        let (Ok(x), Ok(y)) = (decode(a), decode(b)) else { return true };
        let (p, q) = (Interval::from(a), Interval::from(b));
        let normal = |exact: &Rational| encode::<f64>(exact, Rounding::NearestEven).abs() > 1e-280;
        let tight = |result: Interval, exact: Rational| {
            result.contains(&exact) && (!normal(&exact) || result == tightest(&exact))
        };
        let quotient = y == rational(0, 1) || a.abs() < 1e-280 || tight(p / q, &x / &y);
        tight(p + q, &x + &y) && tight(p - q, &x - &y) && tight(p * q, &x * &y) && quotient
    }
    quickcheck(6_000).quickcheck(holds as fn(_, _) -> bool);
}

#[test]
fn every_choice_of_operands_is_enclosed() {
    fn holds(a: (i16, i16, i16), b: (i16, i16, i16)) -> bool {
        let inside = |(p, q, r): (i16, i16, i16)| {
            let mut ends = [p, q, r];
            ends.sort_unstable();
            let [low, x, high] = ends.map(f64::from);
            (Interval::between(low, high) / Interval::from(3.0), rational(ends[1], 3), x)
        };
        let ((p, x, _), (q, y, _)) = (inside(a), inside(b));
        let quotient = p.checked_div(&q).is_none_or(|quotient| quotient.contains(&(&x / &y)));
        let root = p.sqrt().is_none_or(|root| {
            let square = root.square();
            x < rational(0, 1) || square.contains(&x)
        });
        (p + q).contains(&(&x + &y))
            && (p - q).contains(&(&x - &y))
            && (p * q).contains(&(&x * &y))
            && p.square().contains(&(&x * &x))
            && p.square().lower() >= 0.0
            && p.mul_add(&q, &p).contains(&(&x * &y + &x))
            && quotient
            && root
    }
    quickcheck(6_000).quickcheck(holds as fn(_, _) -> bool);
}

#[test]
fn exact_operations_stay_exact() {
    let point = Interval::from;
    assert_eq!(point(3.0) * point(0.25) + point(7.0), point(7.75));
    assert_eq!(point(1.0) / point(8.0), point(0.125));
    assert_eq!(point(9.0).sqrt(), Some(point(3.0)));
    assert_eq!(point(2.0).square() - point(4.0), point(0.0));
    assert!((point(1.0) / point(3.0)).width() < 1e-16);
}

#[test]
fn nothing_is_known_after_a_division_by_zero() {
    let (one, around) = (Interval::one(), Interval::between(-1.0, 2.0));
    assert_eq!(one / around, Interval::WHOLE);
    assert_eq!(one.checked_div(&around), None);
    assert_eq!(one.checked_div(&Interval::between(0.0, 2.0)), None);
    assert_eq!(Interval::from(f64::NAN), Interval::WHOLE);
    assert_eq!(Interval::WHOLE * Interval::zero(), Interval::zero());
    assert!(!Interval::WHOLE.is_finite());
    assert_eq!(Interval::WHOLE.sign(), Comparison::UNKNOWN);
}

#[test]
fn overflow_leaves_a_half_line() {
    let most = Interval::from(f64::MAX);
    let sum = most + most;
    assert_eq!((sum.lower(), sum.upper()), (f64::MAX, f64::INFINITY));
    let beyond = tightest(&(decode(f64::MAX).expect("finite") * rational(2, 1)));
    assert_eq!(beyond, sum);
    assert_eq!((-most * most).upper(), f64::MIN);
    assert!((most * most / (most * most)).lower() >= 0.0);
}

#[test]
fn a_square_is_not_negative_though_its_product_may_seem_so() {
    let x = Interval::between(-1.0, 2.0);
    assert_eq!(x.square(), Interval::between(0.0, 4.0));
    assert_eq!(x * x, Interval::between(-2.0, 4.0));
    assert!(Interval::between(-1e-200, 1e-200).square().lower() >= 0.0);
}

#[test]
fn an_interval_is_seen_by_its_ends() {
    let x = Interval::between(-0.5, 2.0);
    assert_eq!(x.ends(), Ok((rational(-1, 2), rational(2, 1))));
    assert_eq!((x.width(), Interval::from(7.0).width()), (2.5, 0.0));
    assert_eq!(Interval::between(0.1, 1e-20).width(), 0.1, "rounded up");
    for half in [Interval::between(0.0, f64::INFINITY), Interval::between(f64::NEG_INFINITY, 0.0)] {
        assert!(half.ends().is_err() && half.width() == f64::INFINITY && !half.is_finite());
    }
    assert!(x.is_finite() && !x.is_point() && Interval::one().is_point());
    for (a, b) in [(f64::NAN, 1.0), (1.0, f64::NAN)] {
        assert_eq!(Interval::between(a, b), Interval::WHOLE);
    }
}

#[test]
fn only_what_is_certain_is_answered() {
    let (low, high) = (Interval::between(0.0, 1.0), Interval::between(1.0, 2.0));
    assert_eq!(low.compare(&high), Comparison::possible(true, true, false));
    assert_eq!(low.sign().is_at_least(), Some(true));
    assert_eq!(low.sign().is_greater(), None);
    assert_eq!(low.compare(&low), Comparison::UNKNOWN);
    assert_eq!(Interval::one().compare(&Interval::one()).is_equal(), Some(true));
    assert_eq!(low.compare(&Interval::from(3.0)).is_less(), Some(true));
}

#[test]
fn intervals_are_written_by_their_ends() -> Result<(), kane_number::ParseError> {
    assert_eq!(Interval::between(2.0, -0.5).to_string(), "[-0.5, 2]");
    assert_eq!(Interval::WHOLE.to_string(), "[-inf, inf]");
    assert_eq!(tightest(&parse("1e-300")?).to_string(), "[9.999999999999999e-301, 1e-300]");
    assert_eq!(Interval::between(1.0, 4.0).midpoint(), 2.5);
    assert_eq!(Interval::WHOLE.midpoint(), 0.0);
    Ok(())
}

/// A float within 2^26 units below a power of two is parted into that power and the rest. Where its square is next to
/// the greatest float, the square of the power overflows.
#[test]
fn roots_of_the_greatest_floats_are_enclosed() {
    let mut lacking = 0;
    for steps in 0..3_000_u64 {
        let square = f64::from_bits(f64::MAX.to_bits() - steps * steps * 11);
        let root = Interval::from(square).sqrt().expect("it is positive");
        let exact = decode(square).expect("it is finite");
        let [lower, upper] =
            [root.lower(), root.upper()].map(|end| decode(end).expect("it is finite"));
        assert!(&lower * &lower <= exact && exact <= &upper * &upper, "√{square:e} in {root}");
        lacking += u32::from(root.lower().next_up() < root.upper());
    }
    assert_eq!(lacking, 0, "the ends are neighbours");
}
