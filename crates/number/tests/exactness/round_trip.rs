//! Nine in ten of quickcheck's integers are random, the others edge values: 1.15·10⁶ of them
//! hold more than 10⁶ random patterns. The long run, 10⁸ patterns a format, takes minutes:
//! `cargo test --release -p kane-number --test exactness -- --ignored long_run`

use kane_number::{Binary, NotFinite, Rounding, decode, encode};

use crate::quickcheck;

/// decode then encode gives the same bits under every rounding; non-finite patterns are named.
fn survives<F: Binary>(float: F) -> bool {
    let bits = |float: F| (float.is_negative(), float.magnitude_bits());
    match decode(float) {
        Ok(exact) => {
            [Rounding::NearestEven, Rounding::Down, Rounding::Up].into_iter().all(|rounding| {
                let back: F = encode(&exact, rounding);
                // The rationals have one zero only.
                bits(back) == bits(float) || (bits(float) == (true, 0) && bits(back) == (false, 0))
            })
        }
        Err(NotFinite::Nan) => float.magnitude_bits() > F::infinity_bits(),
        Err(NotFinite::PositiveInfinity) => bits(float) == (false, F::infinity_bits()),
        Err(NotFinite::NegativeInfinity) => bits(float) == (true, F::infinity_bits()),
    }
}

fn f64_survives(bits: u64) -> bool {
    survives(f64::from_bits(bits))
}

fn f32_survives(bits: u32) -> bool {
    survives(f32::from_bits(bits))
}

#[test]
fn a_million_f64_patterns_survive() {
    quickcheck(1_150_000).quickcheck(f64_survives as fn(_) -> bool);
}

#[test]
fn a_million_f32_patterns_survive() {
    quickcheck(1_150_000).quickcheck(f32_survives as fn(_) -> bool);
}

#[test]
fn every_f64_exponent_survives_at_its_edges() {
    for exponent in 0..0x800_u64 {
        for fraction in [0, 1, (1 << 51) - 1, 1 << 51, (1 << 52) - 1] {
            let bits = exponent << 52 | fraction;
            assert!(f64_survives(bits) && f64_survives(bits | 1 << 63), "{bits:#x}");
        }
    }
}

#[test]
#[ignore = "long run: 10^8 random patterns, see the head of this file"]
fn long_run_of_f64_patterns_survives() {
    quickcheck(115_000_000).quickcheck(f64_survives as fn(_) -> bool);
}

#[test]
#[ignore = "long run: 10^8 random patterns, see the head of this file"]
fn long_run_of_f32_patterns_survives() {
    quickcheck(115_000_000).quickcheck(f32_survives as fn(_) -> bool);
}

#[test]
fn what_is_no_number_is_refused_by_name() {
    assert_eq!(decode(f64::NAN), Err(NotFinite::Nan));
    assert_eq!(decode(-f32::NAN), Err(NotFinite::Nan));
    assert_eq!(decode(f32::INFINITY), Err(NotFinite::PositiveInfinity));
    assert_eq!(decode(f64::NEG_INFINITY), Err(NotFinite::NegativeInfinity));
}

#[test]
fn both_zeros_decode_to_zero_and_the_least_subnormal_to_itself() {
    assert_eq!(decode(-0.0_f64), decode(0.0_f64));
    assert_eq!(decode(f64::from_bits(1)), Ok(crate::two_to(-1074)));
    assert_eq!(decode(f32::from_bits(1)), Ok(crate::two_to(-149)));
}
