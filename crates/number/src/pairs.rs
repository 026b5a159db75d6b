//! The transformations and the directed operations on all pairs of floats of small formats, held against integers.
//!
//! They are the same functions that the program runs in `f64`: what they rest on is a format of radix 2 with subnormals,
//! rounded to nearest, of a precision and a range that no step names. Formats of 3 to 7 bits have room for every regime
//! (subnormal, small, splittable or not, next to overflow).
#![allow(
    clippy::float_arithmetic,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    clippy::cast_possible_wrap,
    reason = "small formats are made of floats that are integers times a power of two"
)]

mod toy;

use toy::Toy;

use crate::directed::{Outward, product, quotient, root, sum};
use crate::error_free::{fast_two_sum, fused_product, split_product, two_product, two_sum};
use crate::format::Format;
use crate::{Binary, Rounding, decode, encode, power_of};

/// A bound from one side, and the float before it, which would be a better one.
struct Bound<const P: u32, const E: i64> {
    float: Toy<P, E>,
    better: Toy<P, E>,
    direction: Outward,
}

impl<const P: u32, const E: i64> Bound<P, E> {
    fn new(float: Toy<P, E>, direction: Outward) -> Self {
        let better = match direction {
            Outward::Down => float.next_up(),
            Outward::Up => float.next_down(),
        };
        Self { float, better, direction }
    }

    /// Whether it bounds; `holds(x)` says that the exact value is on the right side of x, in units.
    fn encloses(&self, holds: impl Fn(i128) -> bool) -> bool {
        if self.float.is_infinite() {
            return self.float.is_negative() == (self.direction == Outward::Down);
        }
        holds(self.float.units())
    }

    /// Whether no other float of the format would do better.
    fn is_best(&self, holds: impl Fn(i128) -> bool) -> bool {
        self.better.is_infinite() || !holds(self.better.units())
    }
}

const DIRECTIONS: [Outward; 2] = [Outward::Down, Outward::Up];

/// Whether `exact` is on the side of `bound` that the direction asks for.
fn beyond(direction: Outward, bound: i128, exact: i128) -> bool {
    match direction {
        Outward::Down => bound <= exact,
        Outward::Up => exact <= bound,
    }
}

/// One pair: the transformations lose nothing, and the directed operations bound from the side that is asked for and are
/// the nearest float there.
fn try_pair<const P: u32, const E: i64>(a: Toy<P, E>, b: Toy<P, E>) {
    let (x, y) = (a.units(), b.units());
    // units of a product, in units of the least float
    let scale = 1_i128 << -Toy::<P, E>::LEAST_EXPONENT;

    let (nearest, error) = two_sum(a, b);
    if !nearest.is_infinite() {
        assert_eq!(nearest.units() + error.units(), x + y, "{a:?} + {b:?}");
        if x.abs() >= y.abs() || x == 0 {
            let fast = fast_two_sum(a, b);
            assert_eq!(
                (fast.0.units(), fast.1.units()),
                (nearest.units(), error.units()),
                "{a:?} + {b:?}"
            );
        }
    }
    for direction in DIRECTIONS {
        let bound = Bound::new(sum(a, b, direction), direction);
        let holds = |r| beyond(direction, r, x + y);
        assert!(bound.encloses(holds) && bound.is_best(holds), "{a:?} + {b:?}, {direction:?}");
    }

    let exact = x * y;
    let lossless = exact.abs()
        >= (scale * scale) >> -(Toy::<P, E>::LEAST_EXPONENT + 2 * i64::from(P))
        || exact == 0;
    if !(a * b).is_infinite() && lossless {
        let whole = |(p, e): (Toy<P, E>, Toy<P, E>)| (p.units() + e.units()) * scale;
        assert_eq!(whole(two_product(a, b)), exact, "{a:?}·{b:?}");
        assert_eq!(whole(fused_product(a, b)), exact, "{a:?}·{b:?}, fused");
        let splits = |x: Toy<P, E>| x.abs() < Format::splittable();
        let top = Format::power_of_two(E);
        if splits(a) && splits(b) && (a * b).abs() < top {
            assert_eq!(whole(split_product(a, b)), exact, "{a:?}·{b:?}, split");
        }
    }
    for direction in DIRECTIONS {
        let bound = Bound::new(product(a, b, direction), direction);
        let holds = |r: i128| beyond(direction, r * scale, exact);
        assert!(bound.encloses(holds), "{a:?}·{b:?}, {direction:?}");
        let tight = (a * b).abs() >= Format::small() || exact == 0;
        assert!(!tight || bound.is_best(holds), "{a:?}·{b:?}, {direction:?}");
    }

    if y != 0 {
        for direction in DIRECTIONS {
            let bound = Bound::new(quotient(a, b, direction), direction);
            // r ≤ x/y in units is r·y ≤ x·scale for positive y
            let holds = |r: i128| beyond(direction, r * y.abs(), x * y.signum() * scale);
            assert!(bound.encloses(holds), "{a:?}/{b:?}, {direction:?}");
            let tight = (a / b).abs() >= Format::small()
                && a.abs() >= Format::small()
                && !overflows(a / b, b);
            assert!(!tight || bound.is_best(holds), "{a:?}/{b:?}, {direction:?}");
        }
    }
}

/// Whether a product overflows.
fn overflows<F: Format>(a: F, b: F) -> bool {
    (a * b).is_infinite()
}

/// One float: its root, and that it is the same after the exact number that it is.
fn try_one<const P: u32, const E: i64>(a: Toy<P, E>) {
    let x = a.units();
    let scale = 1_i128 << -Toy::<P, E>::LEAST_EXPONENT;
    if x >= 0 {
        for direction in DIRECTIONS {
            let bound = Bound::new(root(a, direction), direction);
            let holds = |r: i128| beyond(direction, r.signum() * r * r, x * scale);
            assert!(bound.encloses(holds), "√{a:?}, {direction:?}");
            assert!(a < Format::small() || bound.is_best(holds), "√{a:?}, {direction:?}");
        }
    }
    let exact = decode(a).expect("it is finite");
    assert_eq!(exact, power_of(2, Toy::<P, E>::LEAST_EXPONENT) * crate::Integer::from(x), "{a:?}");
    for rounding in [Rounding::NearestEven, Rounding::Down, Rounding::Up] {
        assert_eq!(encode::<Toy<P, E>>(&exact, rounding), a, "{a:?}, {rounding:?}");
    }
}

/// What lies between two neighbours goes to the one that the rounding asks for.
fn try_between<const P: u32, const E: i64>(below: Toy<P, E>, above: Toy<P, E>) {
    let ends = [below, above].map(|x| decode(x).expect("it is finite"));
    for eighths in 1..8 {
        let part = crate::Rational::new(eighths.into(), 8.into());
        let exact = &ends[0] + (&ends[1] - &ends[0]) * part;
        assert_eq!(encode::<Toy<P, E>>(&exact, Rounding::Down), below);
        assert_eq!(encode::<Toy<P, E>>(&exact, Rounding::Up), above);
        let nearest: Toy<P, E> = encode(&exact, Rounding::NearestEven);
        let even = if below.magnitude_bits().is_multiple_of(2) { below } else { above };
        let expected = match eighths {
            ..4 => below,
            4 => even,
            _ => above,
        };
        assert_eq!(nearest, expected, "{eighths}/8 from {below:?} to {above:?}");
    }
}

/// The whole of a format; gives the number of pairs.
fn try_format<const P: u32, const E: i64>() -> usize {
    let all = Toy::<P, E>::all();
    all.iter().for_each(|a| try_one(*a));
    all.windows(2).for_each(|pair| try_between(pair[0], pair[1]));
    for a in &all {
        all.iter().for_each(|b| try_pair(*a, *b));
    }
    all.len() * all.len()
}

/// What is infinite stays so, in either direction; a product with zero and a quotient by infinity are zero.
#[test]
fn an_infinite_operand_is_a_bound_that_stays() {
    let infinity = f64::INFINITY;
    for direction in DIRECTIONS {
        for sign in [1.0, -1.0] {
            let beyond = sign * infinity;
            for a in [5e-324, 1e-310, 0.1, 1.0, 3e200, f64::MAX] {
                assert_eq!(product(beyond, a, direction), beyond);
                assert_eq!(product(-a, beyond, direction), -beyond);
                assert_eq!(quotient(beyond, a, direction), beyond);
                assert_eq!(quotient(beyond, -a, direction), -beyond);
                assert_eq!(quotient(a, beyond, direction), 0.0);
                assert_eq!(sum(beyond, a, direction), beyond);
                assert_eq!(sum(-a, beyond, direction), beyond);
            }
            assert_eq!(product(beyond, beyond, direction), infinity);
            assert_eq!(product(0.0, beyond, direction), 0.0);
            assert_eq!(product(beyond, 0.0, direction), 0.0);
        }
        assert_eq!(root(infinity, direction), infinity);
        assert_eq!(root(0.0, direction), 0.0);
    }
}

#[test]
fn no_pair_of_floats_of_three_bits_loses_anything() {
    assert_eq!(try_format::<3, 15>(), 61_009);
}

#[test]
fn no_pair_of_floats_of_four_or_five_bits_loses_anything() {
    assert_eq!(try_format::<4, 17>(), 312_481);
    assert_eq!(try_format::<5, 19>(), 1_555_009);
}

#[test]
#[ignore = "takes a minute: `cargo test -p kane-number --lib pairs -- --ignored`"]
fn no_pair_of_floats_of_six_or_seven_bits_loses_anything() {
    assert_eq!(try_format::<6, 19>(), 6_225_025);
    assert_eq!(try_format::<7, 21>(), 30_283_009);
}
