//! One suite for all the number systems: each is held to what it promises.

use kane_number::testkit::{Contract, conformance};
use kane_number::{Algebraic, DoubleDouble, Interval, OddFraction, Rational, Scaled, decode};

use crate::{quickcheck, rational, two_to};

/// Where roundings go wrong: ends of the range, ties and near ties, and cancellation.
fn edges() -> Vec<Rational> {
    let mut edges = vec![rational(0, 1), rational(1, 3), rational(-1, 10), rational(7, 2)];
    for exponent in [-1074, -1000, -149, -53, 53, 1000, 1023] {
        edges.push(two_to(exponent));
    }
    edges.extend(
        [f64::MAX, -f64::MIN_POSITIVE.next_up(), 1.0_f64.next_up(), 1.0_f64.next_down()]
            .map(|float| decode(float).expect("finite")),
    );
    edges.push(decode(f32::MAX).expect("finite"));
    edges.push(decode(1.0_f32.next_down()).expect("finite"));
    // A tie, and next to it on either side.
    let tie = rational(1, 1) + two_to(-53);
    edges.extend([&tie - two_to(-110), &tie + two_to(-110), tie]);
    edges
}

macro_rules! suite {
    ($($name:ident: $system:ty, $cases:expr;)*) => {$(
        mod $name {
            use super::*;

            #[test]
            fn conforms_at_the_edges() {
                conformance::<$system>(&edges());
            }

            #[test]
            fn conforms_on_random_rationals() {
                fn conforms(a: (i64, i64, i16), b: (i64, i64, i16), near: i8) -> bool {
                    random_conformance::<$system>(a, b, near);
                    true
                }
                quickcheck($cases).quickcheck(conforms as fn(_, _, _) -> bool);
            }
        }
    )*};
}

suite! {
    f32s: f32, 80;
    f64s: f64, 80;
    double_doubles: DoubleDouble, 80;
    scaled_numbers: Scaled, 80;
    intervals: Interval, 80;
    rationals: Rational, 80;
    odd_fractions: OddFraction, 80;
    algebraic_numbers: Algebraic, 80;
}

/// Two numbers at random, and a third that almost cancels their product.
fn random_conformance<N: Contract>(a: (i64, i64, i16), b: (i64, i64, i16), near: i8) {
    let number = |(numer, denom, twos): (i64, i64, i16)| {
        rational(numer, if denom == 0 { 1 } else { denom }) * two_to(i64::from(twos % 400))
    };
    let (x, y) = (number(a), number(b));
    let product = match (N::operand(&x), N::operand(&y)) {
        (Some((_, x)), Some((_, y))) => -(x * y),
        _ => return,
    };
    let off = &product * (rational(1, 1) + rational(near, 1) * two_to(-60));
    conformance::<N>(&[x, y, product, off]);
}
