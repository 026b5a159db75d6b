use kane_number::testkit::{field_axioms, ordered_field_axioms};

use crate::{quickcheck, rational, two_to};

#[test]
fn rationals_are_an_ordered_field_at_the_edges() {
    let mut elements = vec![rational(0, 1), rational(1, 3), rational(-7, 2)];
    for exponent in [-1074, 0, 1023] {
        elements.extend([two_to(exponent), -two_to(exponent)]);
        elements.push(two_to(exponent) + rational(1, 3));
    }
    field_axioms(&elements);
    ordered_field_axioms(&elements);
}

#[test]
fn rationals_are_an_ordered_field() {
    fn axioms_hold(a: (i64, i64), b: (i64, i64), c: (i64, i64)) -> bool {
        let elements = [a, b, c].map(|(n, d)| rational(n, if d == 0 { 1 } else { d }));
        field_axioms(&elements);
        ordered_field_axioms(&elements);
        true
    }
    quickcheck(500).quickcheck(axioms_hold as fn(_, _, _) -> bool);
}

#[test]
#[should_panic(expected = "(a + b) + c = a + (b + c) fails")]
fn the_axioms_catch_floats() {
    field_axioms(&[1.0, -1.0, 2.0_f64.powi(-60)]);
}
