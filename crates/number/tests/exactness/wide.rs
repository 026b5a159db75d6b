//! Double-double and scaled numbers: what is lost on the way to a float, and what is not.

use kane_number::{
    Comparison, DoubleDouble, Number, Ordered, Rounding, Scaled, decode, encode, parse,
};

use crate::{quickcheck, rational, two_to};

#[test]
fn a_scaled_number_rounds_once_to_either_format() {
    fn holds(high: u64, low: i64, twos: i16) -> bool {
        let exact = (rational(high, 1) + rational(low, 1) * two_to(-70)) * two_to(twos.into());
        let number = Scaled::from_rational(&exact);
        let held = number.to_rational().expect("a moderate exponent");
        let nearest: f64 = encode(&held, Rounding::NearestEven);
        let single: f32 = encode(&held, Rounding::NearestEven);
        number.to_f64() == nearest && number.to_f32() == single
    }
    quickcheck(6_000).quickcheck(holds as fn(_, _, _) -> bool);
}

#[test]
fn ties_and_subnormals_round_once() {
    // Halfway to the next subnormal, and just off halfway by the low part.
    for unit in [-1074, -1060, -149, -140] {
        for odd in [1, 3, 5] {
            for off in [-1_i64, 0, 1] {
                let exact = rational(odd, 2) * two_to(unit) + rational(off, 1) * two_to(unit - 90);
                let number = Scaled::from_rational(&exact);
                assert_eq!(number.to_rational().as_ref(), Some(&exact));
                let nearest: f64 = encode(&exact, Rounding::NearestEven);
                let single: f32 = encode(&exact, Rounding::NearestEven);
                assert_eq!((number.to_f64(), number.to_f32()), (nearest, single), "{exact}");
            }
        }
    }
}

#[test]
fn sums_and_products_next_to_the_greatest_float_are_exact() {
    let unit = f64::MAX - f64::MAX.next_down();
    let exact = |x: f64| decode(x).expect("it is finite");
    for steps in 0..200_u32 {
        // the greatest float and a few halves of a unit less
        let less = -unit * f64::from(steps) / 2.0;
        for (a, b) in [(f64::MAX, less), (less, f64::MAX)] {
            let sum = DoubleDouble::from(a) + DoubleDouble::from(b);
            assert_eq!(sum.to_rational().ok(), Some(exact(a) + exact(b)), "{a:e} + {b:e}");
        }
        // factors below a power of two, whose upper halves are the power
        let a = f64::from_bits(2_f64.powi(512).to_bits() - 1 - u64::from(steps));
        let b = f64::from_bits(2_f64.powi(512).to_bits() - 1 - u64::from(7 * steps));
        let product = DoubleDouble::from(a) * DoubleDouble::from(b);
        assert_eq!(product.to_rational().ok(), Some(exact(a) * exact(b)), "{a:e}·{b:e}");
    }
}

/// Beyond the range a quotient is infinite, as that of floats; by infinity it is zero.
#[test]
fn quotients_beyond_the_range_are_infinite() {
    let number = |x: f64| DoubleDouble::from(x);
    for sign in [1.0, -1.0] {
        for (a, b) in [(1.0, 0.0), (1.0, 5e-324), (1e200, 1e-200), (f64::MAX, 0.5)] {
            let quotient = number(sign * a) / number(b);
            assert_eq!((quotient.high(), quotient.low()), (sign * f64::INFINITY, 0.0), "{a}/{b}");
            assert!(!quotient.is_finite());
        }
        assert_eq!((number(sign) / number(f64::INFINITY)).high(), 0.0);
        let product = number(sign * 1e200).mul_add(&number(1e200), &number(-sign));
        assert!(!product.is_finite(), "{product}");
    }
}

/// Next to the least floats a pair is off by half of the least one at most, and its high part is the float nearest to it.
#[test]
fn a_pair_next_to_the_subnormals_is_the_nearest() {
    for exponent in -1080..-960 {
        for low in [0, 1, -1, 3] {
            let exact = (rational(5, 3) + rational(low, 1) * two_to(-70)) * two_to(exponent);
            let wide = Scaled::from_rational(&exact);
            let held = wide.to_rational().expect("a moderate exponent");
            let pair = wide.to_double_double();
            let sum = pair.to_rational().expect("it is finite");
            let off = if sum < held { &held - &sum } else { &sum - &held };
            assert!(off <= two_to(-1075), "{exact}: {off}");
            assert_eq!(encode::<f64>(&sum, Rounding::NearestEven), pair.high(), "{exact}");
        }
    }
}

#[test]
fn every_float_survives_widening() {
    fn f64_survives(bits: u64) -> bool {
        let float = f64::from_bits(bits);
        f64::narrow(&float.widen()).to_bits() == bits || float.is_nan()
    }
    fn f32_survives(bits: u32) -> bool {
        let float = f32::from_bits(bits);
        f32::narrow(&float.widen()).to_bits() == bits || float.is_nan()
    }
    quickcheck(6_000).quickcheck(f64_survives as fn(_) -> bool);
    quickcheck(6_000).quickcheck(f32_survives as fn(_) -> bool);
    for float in [0.0, -0.0, f64::INFINITY, f64::NEG_INFINITY, f64::from_bits(1), f64::MAX] {
        assert!(f64_survives(float.to_bits()), "{float}");
    }
    assert!(f64::narrow(&f64::NAN.widen()).is_nan());
}

#[test]
fn nothing_overflows_in_between() {
    let huge = f64::MAX.widen();
    assert_eq!(f64::narrow(&(huge.square().square() / huge.square() / huge)), f64::MAX);
    let tiny = f64::from_bits(1).widen();
    assert_eq!(f64::narrow(&(tiny.square() / tiny)), f64::from_bits(1));
    assert_eq!(f64::narrow(&tiny.square()), 0.0);
    assert_eq!(f64::narrow(&-huge.square()), f64::NEG_INFINITY);
    let root = huge.square().sqrt().expect("positive");
    assert_eq!(f64::narrow(&root), f64::MAX);
}

#[test]
fn what_is_not_finite_compares_with_nothing() {
    let one = Scaled::one();
    for odd in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let number = Scaled::from(odd);
        assert!(!number.is_finite() && !(number + one).is_finite() && !(one * number).is_finite());
        assert_eq!(number.compare(&one), Comparison::UNKNOWN);
        assert_eq!(number.sign(), Comparison::UNKNOWN);
        let number = DoubleDouble::from(odd);
        assert!(!number.is_finite() && !(number - DoubleDouble::one()).is_finite());
        assert_eq!(number.compare(&DoubleDouble::one()), Comparison::UNKNOWN);
    }
    assert!(!(one / Scaled::zero()).is_finite());
    let huge = DoubleDouble::from(f64::MAX);
    assert!(!(huge + huge).is_finite() && !huge.square().is_finite());
}

#[test]
fn scaled_numbers_compare_as_the_rationals_that_they_are() {
    fn agrees(a: (i32, i16), b: (i32, i16)) -> bool {
        let number = |(n, twos): (i32, i16)| rational(n, 3) * two_to(i64::from(twos));
        let (x, y) = (Scaled::from_rational(&number(a)), Scaled::from_rational(&number(b)));
        x.compare(&y) == x.to_rational().cmp(&y.to_rational()).into()
    }
    quickcheck(5_000).quickcheck(agrees as fn(_, _) -> bool);
}

#[test]
fn cancellation_keeps_its_digits() {
    // The slip v − ω·r of a body that almost rolls.
    let third = DoubleDouble::from_rational(&rational(1, 3));
    let product = third.to_rational().expect("finite");
    let exact = &product * &product;
    let minus = -DoubleDouble::from_rational(&exact);
    let left = third.mul_add(&third, &minus);
    let lost = exact + minus.to_rational().expect("finite");
    assert_eq!(left.to_rational(), Ok(lost));
}

#[test]
fn square_roots_are_near() {
    fn holds(n: u64, twos: i16) -> bool {
        let exact = rational(n, 1) * two_to(twos.into());
        let root = Scaled::from_rational(&exact).sqrt().expect("not negative");
        let root = root.to_rational().expect("moderate");
        let slack = two_to(-102) * &exact;
        let off = &root * &root - &exact;
        -&slack <= off && off <= slack
    }
    quickcheck(2_000).quickcheck(holds as fn(_, _) -> bool);
}

#[test]
fn wide_numbers_are_written_in_decimal() -> Result<(), Box<dyn std::error::Error>> {
    let written = |text: &str| parse(text);
    for text in ["0", "-1234567.25", "0.5", "100", "-0.00001", "1e-200", "7.5e200"] {
        assert_eq!(Scaled::from_rational(&written(text)?).to_string(), text);
        assert_eq!(DoubleDouble::from_rational(&written(text)?).to_string(), text);
    }
    assert_eq!(Scaled::from(f64::NAN).to_string(), "NaN");
    let far = Scaled::one().scaled_by(1 << 40);
    assert_eq!(far.to_string(), "1*2^1099511627776");
    assert_eq!(far.to_rational(), None);
    assert_eq!(decode(Scaled::from_rational(&written("1/3")?).to_f64())?, decode(1.0 / 3.0)?);
    Ok(())
}
