//! Two ways of telling the nearest float that share no code with `encode`: the standard
//! library's decimal parser, and the exact distances to the neighbouring floats.

use kane_number::{Integer, Number, Rational, Rounding, decode, encode};

use crate::{quickcheck, rational, two_to};

fn nearest(exact: &Rational) -> f64 {
    encode(exact, Rounding::NearestEven)
}

/// mantissa·2^twos·10^tens as an exact number and as an exact decimal literal.
fn decimal(mantissa: &Integer, twos: i64, tens: i32) -> (Rational, String) {
    let count = u32::try_from(twos.unsigned_abs()).expect("a small exponent");
    let (digits, places) = if twos >= 0 {
        (mantissa * Integer::from(2).pow(count), 0)
    } else {
        (mantissa * Integer::from(5).pow(count), twos)
    };
    let ten = Rational::from_integer(10.into());
    let exact = two_to(twos) * ten.pow(tens) * mantissa;
    (exact, format!("{digits}e{}", i64::from(tens) + places))
}

fn agrees_with_the_standard_parser(exact: &Rational, literal: &str) -> bool {
    let double: f64 = literal.parse().expect("a decimal literal");
    let single: f32 = literal.parse().expect("a decimal literal");
    let to_single: f32 = encode(exact, Rounding::NearestEven);
    nearest(exact).to_bits() == double.to_bits() && to_single.to_bits() == single.to_bits()
}

#[test]
fn decimals_round_as_the_standard_parser_rounds_them() {
    fn agrees(mantissa: i64, twos: i16, tens: i16) -> bool {
        if mantissa == 0 {
            return true; // the sign of zero is not a rational's
        }
        let (exact, literal) =
            decimal(&mantissa.into(), i64::from(twos % 1200), i32::from(tens % 350));
        agrees_with_the_standard_parser(&exact, &literal)
    }
    quickcheck(20_000).quickcheck(agrees as fn(_, _, _) -> bool);
}

#[test]
fn ties_and_their_surroundings_round_as_the_standard_parser_rounds_them() {
    fn agrees(bits: u64, single: bool) -> bool {
        let (low, high, least) = if single {
            let low = f32::from_bits(u32::try_from(bits >> 33).expect("31 bits"));
            (decode(low), decode(low.next_up()), -149)
        } else {
            let low = f64::from_bits(bits >> 1);
            (decode(low), decode(low.next_up()), -1074)
        };
        let (Ok(low), Ok(high)) = (low, high) else {
            return true;
        };
        let tie = (low + high) / Integer::from(2);
        [-1, 0, 1].into_iter().all(|side| {
            let exact = &tie + two_to(least - 40) * Integer::from(side);
            // Every finite float is an integer multiple of 2^least.
            let twos = least - 40;
            let mantissa = (&exact / two_to(twos)).to_integer();
            let (again, literal) = decimal(&mantissa, twos, 0);
            again == exact && agrees_with_the_standard_parser(&exact, &literal)
        })
    }
    quickcheck(2_000).quickcheck(agrees as fn(_, _) -> bool);
}

#[test]
fn no_neighbour_is_nearer() {
    fn is_nearest(numer: i64, denom: i64, twos: i16) -> bool {
        let denom = if denom == 0 { 3 } else { denom };
        let exact = rational(numer, denom) * two_to(i64::from(twos % 1120));
        let float = nearest(&exact);
        let Ok(value) = decode(float) else {
            return exact > two_to(1023) || exact < -two_to(1023);
        };
        let distance = |other: &Rational| Rational::from(other - &exact).square();
        [float.next_down(), float.next_up()].into_iter().all(|neighbour| {
            decode(neighbour).is_ok_and(|neighbour| distance(&value) <= distance(&neighbour))
        })
    }
    quickcheck(50_000).quickcheck(is_nearest as fn(_, _, _) -> bool);
}

#[test]
fn directed_roundings_enclose_tightly() {
    fn encloses(numer: i64, denom: i64, twos: i16) -> bool {
        let denom = if denom == 0 { 3 } else { denom };
        let exact = rational(numer, denom) * two_to(i64::from(twos % 1200));
        let down: f64 = encode(&exact, Rounding::Down);
        let up: f64 = encode(&exact, Rounding::Up);
        let below = decode(down).map_or(down < 0.0, |down| down <= exact);
        let above = decode(up).map_or(up > 0.0, |up| exact <= up);
        let tight =
            if decode(down).as_ref() == Ok(&exact) { down == up } else { down.next_up() == up };
        below && above && tight && (nearest(&exact) == down || nearest(&exact) == up)
    }
    quickcheck(50_000).quickcheck(encloses as fn(_, _, _) -> bool);
}

#[test]
fn overflow_follows_the_standard() {
    let greatest = decode(f64::MAX).expect("finite");
    let threshold = two_to(1024) - two_to(970); // halfway from MAX to 2^1024
    let below = &threshold - rational(1, 3);
    assert_eq!(nearest(&greatest), f64::MAX);
    assert_eq!(nearest(&below), f64::MAX);
    assert_eq!(nearest(&threshold), f64::INFINITY);
    assert_eq!(nearest(&-threshold.clone()), f64::NEG_INFINITY);
    for beyond in [threshold, two_to(1024), two_to(30_000)] {
        assert_eq!(encode::<f64>(&beyond, Rounding::Down), f64::MAX);
        assert_eq!(encode::<f64>(&beyond, Rounding::Up), f64::INFINITY);
        assert_eq!(encode::<f64>(&-beyond.clone(), Rounding::Up), f64::MIN);
        assert_eq!(encode::<f64>(&-beyond, Rounding::Down), f64::NEG_INFINITY);
    }
}

#[test]
fn underflow_is_gradual_and_keeps_the_sign() {
    let least = f64::from_bits(1);
    assert_eq!(nearest(&two_to(-1075)).to_bits(), 0); // a tie, to even
    assert_eq!(nearest(&(two_to(-1075) * rational(4, 3))), least);
    assert_eq!(nearest(&-two_to(-1075)).to_bits(), (-0.0_f64).to_bits());
    assert_eq!(encode::<f64>(&two_to(-30_000), Rounding::Up), least);
    assert_eq!(encode::<f64>(&-two_to(-30_000), Rounding::Up).to_bits(), (-0.0_f64).to_bits());
    assert_eq!(encode::<f64>(&-two_to(-30_000), Rounding::Down), -least);
    // The step from the greatest subnormal to the least normal carries into the exponent.
    let between = two_to(-1022) - two_to(-1076);
    assert_eq!(nearest(&between), f64::MIN_POSITIVE);
}
