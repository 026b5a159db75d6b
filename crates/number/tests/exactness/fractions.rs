//! The fractions of the working system are those of the heap, whatever their size.

use kane_number::testkit::{field_axioms, ordered_field_axioms};
use kane_number::{Integer, Number, OddFraction, Ordered, Rational, Real};

use crate::{quickcheck, rational, two_to};

/// An integer of the limbs given, from none to beyond the room of the short form; edges are as
/// likely as anything else.
fn integer(limbs: &[u64]) -> Integer {
    let limb = |seed: &u64| match seed % 6 {
        0 => 0,
        1 => u64::MAX,
        2 => i64::MIN.unsigned_abs(),
        _ => seed.wrapping_mul(0x9e37_79b9_7f4a_7c15),
    };
    limbs.iter().map(limb).fold(Integer::ZERO, |sum, limb| (sum << 64_u32) + limb)
}

fn fraction(numer: &[u64], denom: &[u64], twos: i16) -> Rational {
    let sign = if twos % 2 == 0 { 1 } else { -1 };
    Rational::new(integer(numer) * sign, integer(denom) + 1) * two_to(i64::from(twos % 300))
}

/// Whether a result is the same number, in lowest terms with a positive denominator.
fn is(result: OddFraction, exact: &Rational) -> bool {
    let result = result.to_rational();
    (result.numer(), result.denom()) == (exact.numer(), exact.denom())
}

fn agrees(x: &Rational, y: &Rational, z: &Rational) -> bool {
    let [a, b, c] = [x, y, z].map(Real::to_working);
    let divides = match a.checked_div(&b) {
        Some(quotient) => is(quotient, &(x / y)),
        None => *y == rational(0, 1),
    };
    let order = a.compare(&b) == x.cmp(y).into() && a.sign() == x.cmp(&rational(0, 1)).into();
    let seen = a.to_string() == x.to_string() && Rational::from_working(&a) == *x;
    seen && is(a.clone(), x)
        && is(a.clone() + &b, &(x + y))
        && is(a.clone() - &b, &(x - y))
        && is(a.clone() * &b, &(x * y))
        && is(a.mul_add(&b, &c), &(x * y + z))
        && is(a.double(), &(x + x))
        && is(-a, &-x)
        && divides
        && order
}

#[test]
fn every_operation_is_that_of_fractions_on_the_heap() {
    type Parts = (Vec<u64>, Vec<u64>, i16);
    fn of_limbs(a: Parts, b: Parts, share: bool) -> bool {
        // up to 20 limbs, of which 8 and 16 have room
        let [x, y] = [&a, &b].map(|(n, d, twos)| fraction(n, d, *twos));
        // a common denominator, so that sums cancel
        let y = if share { &x * Rational::from_integer(integer(&b.0)) } else { y };
        let near = -(&x * &y) + two_to(-90);
        agrees(&x, &y, &near) && agrees(&y, &x, &-(&x * &y))
    }
    let generator = quickcheck::Gen::from_size_and_seed(20, 0x6b61_6e65);
    quickcheck(3_000).rng(generator).quickcheck(of_limbs as fn(_, _, _) -> bool);
}

#[test]
fn machine_words_at_their_ends_are_no_exception() {
    let ends = [i64::MIN, i64::MIN + 1, -1, 0, 1, i64::MAX - 1, i64::MAX];
    let mut edges: Vec<Rational> = ends.map(|n| rational(n, 1)).to_vec();
    edges.extend([i128::MIN, i128::MAX].map(|n| rational(n, i64::MAX)));
    edges.extend([63, 64, 127, 128, 511, 512, -1074].map(two_to));
    for bits in [64, 128, 511, 512, 513, 1023, 1024, 1025] {
        let full = two_to(bits) - rational(1, 1);
        edges.extend([full.recip(), &full / rational(3, 1), full]);
    }
    for x in &edges {
        for y in &edges {
            assert!(agrees(x, y, &-(x * y)), "{x}, {y}");
        }
    }
}

#[test]
fn short_wide_and_long_forms_are_one_ordered_field() {
    let long = two_to(1100) + rational(1, 3);
    let wide = two_to(600) + rational(1, 3);
    let elements = [rational(0, 1), rational(-7, 6), wide, long].map(|x| x.to_working());
    field_axioms(&elements);
    ordered_field_axioms(&elements);
}
