//! Real algebraic numbers are an ordered field, and are written and rounded as such.

use kane_number::testkit::{field_axioms, ordered_field_axioms};
use kane_number::{Algebraic, DoubleDouble, Integer, Number, Ordered, Rational, Rounding, decode};

use crate::{quickcheck, rational, two_to};

fn whole(n: i64) -> Algebraic {
    rational(n, 1).into()
}

fn root_of(square: i64) -> Algebraic {
    whole(square).sqrt().expect("a positive number")
}

/// The real root of 20x³ − 3x² + 140x + 47.
fn reference() -> Algebraic {
    let f = [47, 140, -3, 20].map(|c| rational(c, 1));
    Algebraic::roots(&f).remove(0)
}

#[test]
fn surds_of_one_radicand_are_an_ordered_field() {
    let elements =
        [whole(0), rational(-1, 3).into(), root_of(2), whole(3) - root_of(8), -root_of(50)];
    field_axioms(&elements);
    ordered_field_axioms(&elements);
}

#[test]
fn elements_of_one_cubic_field_are_an_ordered_field() {
    let x = reference();
    let elements = [whole(1), x.clone(), x.square() - whole(2), whole(1) / (x + whole(3))];
    field_axioms(&elements);
    ordered_field_axioms(&elements);
}

/// 1009 is a prime too great to be looked for: the radicands 2 and 2·1009² stay as they are, and are of one field.
#[test]
fn surds_are_of_one_field_where_the_product_of_their_radicands_is_a_square() {
    let (near, far) = (root_of(2), root_of(2 * 1009 * 1009));
    assert_eq!(far.to_string(), "sqrt(2036162)");
    assert_eq!(far, whole(1009) * &near);
    assert_eq!((far.clone() + &near).to_string(), "1010/1009*sqrt(2036162)");
    assert_eq!((near.clone() + &far).to_string(), "1010*sqrt(2)");
    assert_eq!((near.clone() * &far).as_rational(), Some(&rational(2018, 1)));
    assert_eq!((far.clone() / &near).as_rational(), Some(&rational(1009, 1)));
    assert!(whole(1008) * &near < far && far < whole(1010) * &near);
    let elements = [whole(1) - &near, far];
    field_axioms(&elements);
    ordered_field_axioms(&elements);
}

/// a + b√d over small a, b and d, with the sign and the floats of the number in twice the precision.
#[test]
fn the_sign_and_the_bounds_of_a_surd_are_those_of_its_value() {
    for d in [2, 3, 5, 8, 99] {
        let root = DoubleDouble::from(f64::from(d)).sqrt().expect("it is positive");
        for a in -9..=9 {
            for b in [-3, -1, 2] {
                let surd = whole(a.into()) + whole(b.into()) * root_of(d.into());
                let value =
                    root * DoubleDouble::from(f64::from(b)) + DoubleDouble::from(f64::from(a));
                assert_eq!(surd.is_negative(), value.high() < 0.0, "{surd}");
                assert_eq!(surd.to_f64(), value.high(), "{surd}");
                for bits in [0, 3, 64] {
                    let (low, high) = surd.enclose(bits);
                    assert!(
                        Algebraic::from(low.clone()) <= surd && surd <= high.clone().into(),
                        "{surd}"
                    );
                    assert!(high - low <= two_to(-i64::from(bits)) * rational(9, 1), "{surd}");
                }
            }
        }
    }
}

#[test]
fn surds_of_different_radicands_are_an_ordered_field() {
    let elements = [root_of(2), root_of(3) - whole(1)];
    field_axioms(&elements);
    ordered_field_axioms(&elements);
}

#[test]
fn a_surd_and_a_cubic_root_meet_and_part() {
    let (x, root) = (reference(), root_of(2));
    let sum = x.clone() + &root;
    assert_eq!(sum.clone() - &root, x);
    assert_eq!(sum.clone() - &x, root);
    assert_eq!((sum.clone() - &x).to_string(), "sqrt(2)");
    assert!(sum > x && sum < root);
    assert_eq!(sum.polynomial().len(), 7);
}

#[test]
fn the_reference_root_is_a_root() {
    let x = reference();
    let value = ((whole(20) * &x - whole(3)) * &x + whole(140)) * &x + whole(47);
    assert_eq!(value, whole(0));
    assert!(value.as_rational().is_some());
    assert_eq!(x.polynomial(), [47, 140, -3, 20].map(Integer::from));
    let (low, high) = x.isolating_interval();
    assert!(rational(-1, 1) < low && high < rational(0, 1));
    assert_eq!(x.to_f64(), -0.328_346_942_288_723_85);
}

#[test]
fn numbers_are_written_readably() {
    for (number, text) in [
        (rational(3, 2).into(), "3/2"),
        (whole(1) - root_of(2), "1 - sqrt(2)"),
        (root_of(12), "2*sqrt(3)"),
        (-root_of(3), "-sqrt(3)"),
        ((root_of(5) + whole(1)) / whole(2), "1/2 + 1/2*sqrt(5)"),
        (root_of(4), "2"),
        (reference(), "root of 20*x^3 - 3*x^2 + 140*x + 47 near -0.3283"),
        (root_of(2) + root_of(3), "root of x^4 - 10*x^2 + 1 near 3.146"),
    ] {
        assert_eq!(number.to_string(), text);
    }
}

#[test]
fn roots_come_in_order_and_once() {
    // (x + 2)(x − 1)²(x² − 3)
    let roots = Algebraic::roots(&[-6, 9, 2, -6, 0, 1].map(|c| rational(c, 1)));
    let written: Vec<String> = roots.iter().map(ToString::to_string).collect();
    assert_eq!(written, ["-2", "-sqrt(3)", "1", "sqrt(3)"]);
    // (1 ± √5)/2 lie beyond every quotient of two coefficients
    let golden = Algebraic::roots(&[-1, -1, 1].map(|c| rational(c, 1)));
    let written: Vec<String> = golden.iter().map(ToString::to_string).collect();
    assert_eq!(written, ["1/2 - 1/2*sqrt(5)", "1/2 + 1/2*sqrt(5)"]);
    assert!(Algebraic::roots(&[]).is_empty() && Algebraic::roots(&[rational(1, 1)]).is_empty());
    assert!(Algebraic::roots(&[rational(1, 1), rational(0, 1), rational(1, 1)]).is_empty());
}

/// (3x − 1)²·2⁸⁰ = 3: the roots are nearer to each other than the first enclosure of either, and so are those of
/// the product with x − 2, which is a cubic.
#[test]
fn roots_next_to_each_other_are_told_apart() {
    let scale = Rational::from_integer(Integer::from(1) << 80_u32);
    let f = [&scale - rational(3, 1), &scale * rational(-6, 1), &scale * rational(9, 1)];
    let cubic = [
        &f[0] * rational(-2, 1),
        &f[0] - &f[1] * rational(2, 1),
        &f[1] - &f[2] * rational(2, 1),
        f[2].clone(),
    ];
    for roots in [Algebraic::roots(&f), Algebraic::roots(&cubic)] {
        let third = Algebraic::from(rational(1, 3));
        assert!(roots[0] < third && third < roots[1]);
        for (root, sign) in roots.iter().zip(["-", "+"]) {
            let square = (whole(3) * root - whole(1)).square() * Algebraic::from(scale.clone());
            assert_eq!(square, whole(3), "{root}");
            let b = Integer::from(3) << 40_u32;
            assert_eq!(root.to_string(), format!("1/3 {sign} 1/{b}*sqrt(3)"));
        }
    }
}

#[test]
fn nested_roots_are_exact() {
    // √(3 + 2√2) = 1 + √2, and √(√2) squares to √2.
    let nested = (whole(3) + whole(2) * root_of(2)).sqrt().expect("positive");
    assert_eq!(nested, whole(1) + root_of(2));
    let fourth = root_of(2).sqrt().expect("positive");
    assert_eq!(fourth.square(), root_of(2));
    assert!((-root_of(2)).sqrt().is_none());
    // of the roots of x³ − 3x + 1 one is negative, and of the others each has its own
    for x in Algebraic::roots(&[1, -3, 0, 1].map(|c| rational(c, 1))) {
        assert_eq!(x.sqrt().map(|root| root.square()), (!x.is_negative()).then_some(x));
    }
}

#[test]
fn surds_round_to_the_nearest_float() {
    fn holds(a: i32, b: i32, d: u16, twos: i8) -> bool {
        let scale = Algebraic::from(two_to(i64::from(twos) * 7));
        let surd = (whole(a.into()) + whole(b.into()) * root_of(d.into())) * scale;
        let float = surd.to_f64();
        let (down, up): (f64, f64) = (surd.encode(Rounding::Down), surd.encode(Rounding::Up));
        let value = |float: f64| Algebraic::from(decode(float).expect("finite"));
        let distance = |float: f64| {
            let off = value(float) - &surd;
            if off.is_negative() { -off } else { off }
        };
        let other = if float == down { up } else { down };
        value(down) <= surd && surd <= value(up) && distance(float) <= distance(other)
    }
    quickcheck(200).quickcheck(holds as fn(_, _, _, _) -> bool);
}

#[test]
fn the_order_of_close_numbers_is_told() {
    // A convergent of √2 with 100 bits, and √2.
    let (mut p, mut q) = (Integer::from(1), Integer::from(1));
    for _ in 0..80 {
        (p, q) = (&p + &q * 2, &p + &q);
    }
    let convergent = Algebraic::from(Rational::new(p, q));
    assert_eq!(convergent.compare(&root_of(2)).is_equal(), Some(false));
    assert_eq!(root_of(2).to_f64(), convergent.to_f64());
    assert!((convergent.clone() - root_of(2)).is_negative() == (convergent < root_of(2)));
}
