//! One suite for all the number systems: each is held to what it promises.

use kane_number::testkit::{Contract, conformance};
use kane_number::{
    Algebraic, DoubleDouble, Integer, Interval, Number, OddFraction, Rational, Real, Scaled, decode,
};

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

/// Whether a result is admitted that is off by so much relatively, above and below.
fn admits_off<N: Contract>(off: &Rational) -> [bool; 2] {
    let exact = rational(1, 1) + two_to(-60);
    [off.clone(), -off]
        .map(|off| N::admits(&N::from_rational(&(&exact * (off + Integer::from(1)))), &exact))
}

#[test]
fn each_contract_admits_what_it_promises_and_no_more() {
    // 1 + 2^−60 is rounded to 1; the next floats are off by a step
    assert_eq!(
        [1.0_f64.next_down(), 1.0, 1.0_f64.next_up()]
            .map(|x| f64::admits(&x, &(rational(1, 1) + two_to(-60)))),
        [false, true, false]
    );
    assert_eq!(
        [1.0_f32, 1.0_f32.next_up()].map(|x| f32::admits(&x, &(rational(1, 1) + two_to(-60)))),
        [true, false]
    );
    for (off, pair) in [(-103, true), (-99, false)] {
        assert_eq!(admits_off::<DoubleDouble>(&two_to(off)), [pair; 2], "2^{off}");
        assert_eq!(admits_off::<Scaled>(&two_to(off)), [pair; 2], "2^{off}");
    }
    for exact in [two_to(1023), -two_to(1023), two_to(-851), -two_to(-851)] {
        assert!(DoubleDouble::admits(&DoubleDouble::from(1.0), &exact), "beyond the promise");
        assert!(!Scaled::admits(&Scaled::from(1.0), &exact), "there is no beyond");
    }
    for exact in [two_to(1022), -two_to(1022), two_to(-850), -two_to(-850), rational(0, 1)] {
        assert!(!DoubleDouble::admits(&DoubleDouble::from(1.0), &exact), "within the promise");
        assert!(DoubleDouble::admits(&DoubleDouble::from_rational(&exact), &exact));
    }
    assert_eq!(admits_off::<Rational>(&two_to(-300)), [false; 2]);
    assert_eq!(admits_off::<OddFraction>(&two_to(-300)), [false; 2]);
    assert_eq!(admits_off::<Algebraic>(&two_to(-300)), [false; 2]);
    assert_eq!(admits_off::<Algebraic>(&rational(0, 1)), [true; 2]);
    let root = Algebraic::from(rational(2, 1)).sqrt().expect("it is positive");
    assert!(!Algebraic::admits(&root, &rational(2, 1)), "no fraction");
    assert_eq!(admits_off::<Interval>(&rational(0, 1)), [true; 2]);
    assert_eq!(admits_off::<Interval>(&two_to(-40)), [false; 2]);
}

/// A third is held by every system, and is then the number that it stands for or encloses.
fn holds_a_third<N: Contract>() {
    let third = rational(1, 3);
    let (number, exact) = N::operand(&third).expect("it is held");
    assert!(N::admits(&number, &exact), "{number} for {exact}");
    assert!((exact - third) * two_to(24) < rational(1, 1), "{number}");
}

#[test]
fn each_contract_holds_a_number_so_that_something_is_asked() {
    holds_a_third::<f32>();
    holds_a_third::<f64>();
    holds_a_third::<DoubleDouble>();
    holds_a_third::<Scaled>();
    holds_a_third::<Interval>();
    holds_a_third::<Rational>();
    holds_a_third::<OddFraction>();
    holds_a_third::<Algebraic>();
    assert_eq!(Rational::operand(&rational(1, 3)), Some((rational(1, 3), rational(1, 3))));
    assert!(f64::operand(&two_to(1024)).is_none() && f32::operand(&two_to(128)).is_none());
}

/// Whether an answer for √2 is admitted, and whether one for 3/2.
fn admits_roots<N: Contract>(answer: Option<&N>) -> [bool; 2] {
    let three_halves = Algebraic::from(rational(3, 2));
    let root = Algebraic::from(rational(2, 1)).sqrt().expect("it is positive");
    [root, three_halves].map(|exact| N::admits_root(answer, &exact))
}

#[test]
fn each_contract_admits_the_root_and_no_other() {
    fn of_floats<N: Contract>(near: &N, off: &N, half: &N) {
        assert_eq!(admits_roots(Some(near)), [true, false], "{near}");
        assert_eq!(admits_roots(Some(off)), [false, false], "{off}");
        assert_eq!(admits_roots(Some(half)), [false, true], "{half}");
        assert_eq!(admits_roots::<N>(None), [false, false]);
    }
    let two = 2.0_f64.sqrt();
    of_floats(&two, &two.next_up().next_up(), &1.5);
    of_floats(&two.next_up(), &two.next_down().next_down(), &1.5_f64.next_down());
    let single = 2.0_f32.sqrt();
    of_floats(&single.next_down(), &single.next_up().next_up(), &1.5);
    let pair = DoubleDouble::from(2.0).sqrt().expect("it is positive");
    let by = |off: i64| DoubleDouble::from_rational(&(rational(1, 1) + two_to(off)));
    of_floats(&(pair * by(-95)), &(pair * by(-85)), &(by(-95) * DoubleDouble::from(1.5)));
    of_floats(&(pair / by(-95)), &(pair / by(-85)), &DoubleDouble::from(1.5));
    let [wide, near, far] = [pair, by(-95), by(-85)].map(Scaled::from);
    of_floats(&(wide * near), &(wide / far), &Scaled::from(1.5));
    let around = |x: f64| Interval::between(x.next_down(), x.next_up());
    of_floats(&around(two), &Interval::between(1.0, two.next_down()), &around(1.5));
    of_floats(&around(two), &Interval::between(two.next_up(), 1.49), &around(1.5));
    // a fraction is none of √2: no answer is the right one
    let half = rational(3, 2);
    assert_eq!(admits_roots::<Rational>(None), [true, false]);
    assert_eq!(admits_roots(Some(&half)), [false, true]);
    assert_eq!(admits_roots::<OddFraction>(None), [true, false]);
    assert_eq!(admits_roots(Some(&half.to_working())), [false, true]);
    assert_eq!(admits_roots(Some(&rational(7, 5).to_working())), [false, false]);
    let exact = Algebraic::from(rational(2, 1)).sqrt().expect("it is positive");
    of_floats(&exact, &Algebraic::from(rational(7, 5)), &Algebraic::from(half));
}
