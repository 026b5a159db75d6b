use std::cmp::Ordering;

use kane_number::{
    Comparison, NotFinite, Ordered, Rounding, decode, encode, error_in_ulps, steps_between, ulp,
};

use crate::{quickcheck, rational, two_to};

#[test]
fn the_ulp_is_the_spacing_above_with_a_floor() {
    for (exact, exponent) in [
        (rational(1, 1), -52),
        (rational(-3, 2), -52),
        (rational(2, 3), -53),
        (two_to(-1022), -1074),
        (two_to(-2000), -1074),
        (rational(0, 1), -1074),
        (two_to(1023), 971),
        (two_to(2000), 1948), // no float there, yet a unit to measure with
    ] {
        assert_eq!(ulp::<f64>(&exact), two_to(exponent), "{exact}");
    }
    assert_eq!(ulp::<f32>(&rational(1, 3)), two_to(-25));
}

#[test]
fn the_error_is_signed_and_exact() {
    let third = rational(1, 3);
    assert_eq!(error_in_ulps(1.0_f64 / 3.0, &third), Ok(rational(-1, 3)));
    assert_eq!(error_in_ulps((1.0_f64 / 3.0).next_up(), &third), Ok(rational(2, 3)));
    assert_eq!(error_in_ulps(f64::NAN, &third), Err(NotFinite::Nan));
}

#[test]
fn correct_rounding_errs_by_half_an_ulp_at_most() {
    fn holds(numer: i64, denom: i64, twos: i16) -> bool {
        let denom = if denom == 0 { 1 } else { denom };
        let exact = rational(numer, denom) * two_to(i64::from(twos % 950));
        let float: f64 = encode(&exact, Rounding::NearestEven);
        let half = rational(1, 2);
        error_in_ulps(float, &exact).is_ok_and(|error| -&half <= error && error <= half)
    }
    quickcheck(20_000).quickcheck(holds as fn(_, _, _) -> bool);
}

#[test]
fn steps_count_the_floats_between() {
    fn next_is_one_step(bits: u64) -> bool {
        let float = f64::from_bits(bits);
        let next = float.next_up();
        !float.is_finite() || !next.is_finite() || steps_between(float, next) == Ok(1)
    }
    quickcheck(10_000).quickcheck(next_is_one_step as fn(_) -> bool);
    assert_eq!(steps_between(-0.0_f64, 0.0), Ok(0));
    assert_eq!(steps_between(f32::from_bits(3), -f32::from_bits(4)), Ok(7));
    assert_eq!(steps_between(f64::MIN, f64::MAX), Ok(2 * f64::MAX.to_bits()));
    assert_eq!(steps_between(1.0, f64::INFINITY), Err(NotFinite::PositiveInfinity));
}

#[test]
fn floats_compare_as_the_rationals_that_they_are() {
    fn agrees(a: u64, b: u64) -> bool {
        let (a, b) = (f64::from_bits(a), f64::from_bits(b));
        match (decode(a), decode(b)) {
            (Ok(x), Ok(y)) => a.compare(&b) == x.compare(&y),
            _ => true,
        }
    }
    quickcheck(10_000).quickcheck(agrees as fn(_, _) -> bool);
    assert_eq!((-0.0_f64).sign().is_equal(), Some(true));
    assert_eq!(f64::NAN.sign(), Comparison::UNKNOWN);
}

#[test]
fn a_partial_comparison_still_answers_what_is_certain() {
    let at_least = Comparison::possible(false, true, true); // as of [0, 1] and 0
    assert_eq!(at_least.is_at_least(), Some(true));
    assert_eq!(at_least.is_less(), Some(false));
    assert_eq!(at_least.is_greater(), None);
    assert_eq!(at_least.is_equal(), None);
    assert_eq!(at_least.is_at_most(), None);
}

type Question = fn(Ordering) -> bool;

/// A question is answered where all orders that are left agree, and stays open elsewhere.
#[test]
fn every_comparison_answers_what_all_that_it_leaves_agree_in() {
    let orders = [Ordering::Less, Ordering::Equal, Ordering::Greater];
    for set in 1..8_u8 {
        let [less, equal, greater] = [0, 1, 2].map(|bit| set >> bit & 1 == 1);
        let left: Vec<Ordering> = (0..3).filter(|n| set >> n & 1 == 1).map(|n| orders[n]).collect();
        let comparison = Comparison::possible(less, equal, greater);
        let questions: [(Option<bool>, Question); 5] = [
            (comparison.is_less(), Ordering::is_lt),
            (comparison.is_at_most(), Ordering::is_le),
            (comparison.is_equal(), Ordering::is_eq),
            (comparison.is_at_least(), Ordering::is_ge),
            (comparison.is_greater(), Ordering::is_gt),
        ];
        for (answer, holds) in questions {
            let answers: Vec<bool> = left.iter().map(|order| holds(*order)).collect();
            let agreed = answers.iter().all(|answer| *answer == answers[0]);
            assert_eq!(answer, agreed.then_some(answers[0]), "{left:?}");
        }
    }
}
