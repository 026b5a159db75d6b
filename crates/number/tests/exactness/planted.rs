//! The testkit itself: each fault that is planted in a number system is seen, and by the axiom that it breaks.

use std::cell::Cell;
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::panic::{AssertUnwindSafe, catch_unwind};

use kane_number::testkit::{
    Contract, conformance, field_axioms, greatest_roots, ordered_field_axioms,
};
use kane_number::{Algebraic, Comparison, Number, Ordered, Rational, Real};

use crate::rational;

/// What is wrong with the numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    None,
    Zero,
    One,
    Conversion,
    Narrowing,
    Negation,
    Double,
    Square,
    Finite,
    Sum,
    SumOfAscending,
    Difference,
    Product,
    ProductOfAscending,
    ProductByValue,
    ProductOfThreeAndMore,
    ProductOfPositive,
    Quotient,
    QuotientOfTwo,
    ByZero,
    Refused,
    Given,
    Fused,
    /// where the first is the order, the answer leaves others: less, equal, greater
    Order(Ordering, [bool; 3]),
    OneAndThree,
    Root,
}

thread_local! {
    static FAULT: Cell<Fault> = const { Cell::new(Fault::None) };
}

fn has(fault: Fault) -> bool {
    FAULT.get() == fault
}

/// A fraction with a fault.
#[derive(Clone, Debug, PartialEq)]
struct Planted(Rational);

fn whole(n: i64) -> Planted {
    Planted(rational(n, 1))
}

impl Planted {
    /// One more than it should be, where that is so.
    fn off(exact: Rational, wrong: bool) -> Self {
        Self(if wrong { exact + rational(1, 1) } else { exact })
    }

    fn sum(&self, other: &Self) -> Self {
        let (a, b) = (&self.0, &other.0);
        let zero = rational(0, 1);
        let ascending = has(Fault::SumOfAscending) && zero < *a && a < b;
        Self::off(a + b, has(Fault::Sum) || ascending)
    }

    fn product(&self, other: &Self) -> Self {
        let (a, b) = (&self.0, &other.0);
        let one = rational(1, 1);
        if has(Fault::ProductOfPositive) && *a > one && *b > one {
            return Self(-(a * b));
        }
        let ascending = has(Fault::ProductOfAscending) && one < *a && a < b;
        let three = rational(3, 1);
        let many = has(Fault::ProductOfThreeAndMore) && *a >= three && *b >= three;
        Self::off(a * b, has(Fault::Product) || ascending || many)
    }
}

impl fmt::Display for Planted {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Neg for Planted {
    type Output = Self;

    fn neg(self) -> Self {
        Self::off(-self.0, has(Fault::Negation))
    }
}

macro_rules! operator {
    ($operator:ident, $method:ident, |$a:ident, $b:ident| $by_reference:expr) => {
        impl $operator<&Planted> for Planted {
            type Output = Planted;

            fn $method(self, other: &Planted) -> Planted {
                let ($a, $b) = (&self, other);
                $by_reference
            }
        }

        impl $operator for Planted {
            type Output = Planted;

            fn $method(self, other: Planted) -> Planted {
                let result = $operator::$method(self, &other);
                let by_value = stringify!($operator) == "Mul" && has(Fault::ProductByValue);
                // the factor 1 is given by value too
                Planted::off(result.0, by_value && other.0 > rational(1, 1))
            }
        }
    };
}

operator!(Add, add, |a, b| a.sum(b));
operator!(Sub, sub, |a, b| Planted::off(&a.0 - &b.0, has(Fault::Difference)));
operator!(Mul, mul, |a, b| a.product(b));
operator!(Div, div, |a, b| {
    let of_two = has(Fault::QuotientOfTwo) && a.0 == rational(2, 1);
    Planted::off(&a.0 / &b.0, has(Fault::Quotient) || of_two)
});

impl Number for Planted {
    type Wide = Self;

    fn widen(&self) -> Self {
        self.clone()
    }

    fn narrow(wide: &Self) -> Self {
        Self::off(wide.0.clone(), has(Fault::Narrowing))
    }

    fn zero() -> Self {
        Self::off(rational(0, 1), has(Fault::Zero))
    }

    fn one() -> Self {
        if has(Fault::One) { Self::zero() } else { whole(1) }
    }

    fn from_rational(exact: &Rational) -> Self {
        Self::off(exact.clone(), has(Fault::Conversion))
    }

    fn mul_add(&self, factor: &Self, addend: &Self) -> Self {
        Self::off(&self.0 * &factor.0 + &addend.0, has(Fault::Fused))
    }

    fn checked_div(&self, divisor: &Self) -> Option<Self> {
        if divisor.0 == rational(0, 1) {
            return has(Fault::ByZero).then(|| self.clone());
        }
        if has(Fault::Refused) {
            return None;
        }
        let quotient = self.clone() / divisor;
        Some(Self::off(quotient.0, has(Fault::Given)))
    }

    fn is_finite(&self) -> bool {
        !has(Fault::Finite)
    }

    fn double(&self) -> Self {
        Self::off(&self.0 + &self.0, has(Fault::Double))
    }

    fn square(&self) -> Self {
        Self::off(self.product(self).0, has(Fault::Square))
    }
}

impl Ordered for Planted {
    fn compare(&self, other: &Self) -> Comparison {
        let order = self.0.cmp(&other.0);
        match FAULT.get() {
            Fault::Order(at, [less, equal, greater]) if at == order => {
                Comparison::possible(less, equal, greater)
            }
            Fault::OneAndThree
                if [self, other] == [&whole(1), &whole(3)]
                    || [self, other] == [&whole(3), &whole(1)] =>
            {
                order.reverse().into()
            }
            _ => order.into(),
        }
    }
}

impl Real for Planted {
    type WideReal = Self;
    type Working = Self;

    fn to_working(&self) -> Self {
        self.clone()
    }

    fn from_working(working: &Self) -> Self {
        working.clone()
    }

    fn greatest_root(coefficients: &[Self], lower: &Self, upper: &Self) -> Option<Self> {
        let exact: Vec<Rational> = coefficients.iter().map(|c| c.0.clone()).collect();
        let root = Rational::greatest_root(&exact, &lower.0, &upper.0)?;
        Some(Self::off(root, has(Fault::Root)))
    }
}

impl Contract for Planted {
    fn operand(exact: &Rational) -> Option<(Self, Rational)> {
        Some((Self(exact.clone()), exact.clone()))
    }

    fn admits(result: &Self, exact: &Rational) -> bool {
        result.0 == *exact
    }

    fn admits_root(answer: Option<&Self>, exact: &Algebraic) -> bool {
        answer.map(|root| &root.0) == exact.as_rational()
    }
}

/// What a suite says of a fault; nothing if it sees none.
fn said(fault: Fault, suite: impl Fn()) -> Option<String> {
    FAULT.set(fault);
    let run = catch_unwind(AssertUnwindSafe(suite));
    FAULT.set(Fault::None);
    let panic = run.err()?;
    Some(panic.downcast_ref::<String>().cloned().unwrap_or_default())
}

#[track_caller]
fn sees(suite: &str, run: impl Fn(), faults: &[(Fault, &str)]) {
    assert_eq!(said(Fault::None, &run), None, "{suite}: nothing is wrong with fractions");
    for (fault, axiom) in faults {
        let said = said(*fault, &run);
        let message = said.as_deref().unwrap_or("nothing");
        assert!(message.starts_with(axiom), "{suite}, {fault:?}: {message}, not {axiom}");
    }
}

#[test]
fn conformance_sees_each_operation_that_breaks_its_contract() {
    let elements = [0, 1, 2, -3].map(|n| rational(n, 1));
    let faults = [
        (Fault::Zero, "0 is 0"),
        (Fault::One, "1 is 1"),
        (Fault::Conversion, "a rational is converted"),
        (Fault::Negation, "−a"),
        (Fault::Double, "2a"),
        (Fault::Square, "a²"),
        (Fault::Finite, "a is a number"),
        (Fault::Narrowing, "a widened and narrowed is a"),
        (Fault::ByZero, "a/0 is refused"),
        (Fault::Sum, "a + b"),
        (Fault::Difference, "a − b"),
        (Fault::Quotient, "a/b"),
        (Fault::Given, "a/b"),
        (Fault::Refused, "only a/0 is refused"),
        (Fault::Fused, "fma(a, b, c)"),
    ];
    sees("conformance", || conformance::<Planted>(&elements), &faults);
    let ascending = [2, 3].map(|n| rational(n, 1));
    let product = [(Fault::ProductOfAscending, "a·b")];
    sees("conformance", || conformance::<Planted>(&ascending), &product);
}

#[test]
fn conformance_sees_every_answer_without_the_true_order() {
    let elements = [rational(1, 2), rational(2, 1)];
    let orders = [Ordering::Less, Ordering::Equal, Ordering::Greater];
    for (place, order) in orders.into_iter().enumerate() {
        for set in 1..8_u8 {
            let possible = [0, 1, 2].map(|bit| set >> bit & 1 == 1);
            let seen =
                said(Fault::Order(order, possible), || conformance::<Planted>(&elements)).is_some();
            assert_eq!(seen, !possible[place], "{order:?} is answered by {possible:?}");
        }
    }
}

#[test]
fn the_axioms_of_a_field_see_what_breaks_them() {
    let elements = [0, 1, 2, 3].map(whole);
    let faults = [
        (Fault::One, "0 ≠ 1"),
        (Fault::Sum, "a + 0 = a"),
        (Fault::Product, "a·1 = a"),
        (Fault::Negation, "a + (−a) = 0"),
        (Fault::Double, "2a = a + a"),
        (Fault::Square, "a² = a·a"),
        (Fault::ByZero, "a/0 is refused"),
        (Fault::Quotient, "a·(1/a) = 1"),
        (Fault::SumOfAscending, "a + b = b + a"),
        (Fault::ProductOfAscending, "a·b = b·a"),
        (Fault::Difference, "a − b = a + (−b)"),
        (Fault::ProductByValue, "a·b"),
        (Fault::QuotientOfTwo, "(a/b)·b = a"),
        (Fault::Refused, "a/b is found"),
        (Fault::Given, "a/b is found"),
        (Fault::Fused, "fma(a, b, c) = a·b + c"),
    ];
    sees("a field", || field_axioms(&elements), &faults);
    let large = [whole(2), whole(3)];
    let product = [(Fault::ProductOfThreeAndMore, "(a·b)·c = a·(b·c)")];
    sees("a field", || field_axioms(&large), &product);
}

#[test]
fn the_axioms_of_an_order_see_what_breaks_them() {
    let elements = [1, 2, 3].map(whole);
    let less = Fault::Order(Ordering::Greater, [true, false, false]);
    let faults = [
        (less, "exactly one of a < b, a = b, a > b"),
        (Fault::Order(Ordering::Equal, [false, true, true]), "a = b is seen"),
        (Fault::Order(Ordering::Greater, [false, true, true]), "a = b is seen"),
        (Fault::ProductOfPositive, "a, b > 0 ⇒ a·b > 0"),
        (Fault::SumOfAscending, "a < b ⇒ a + c < b + c"),
        (Fault::OneAndThree, "a < b < c ⇒ a < c"),
    ];
    sees("an order", || ordered_field_axioms(&elements), &faults);
}

#[test]
fn the_suite_of_roots_sees_a_wrong_one_and_counts_those_that_are_asked() {
    let problem = |constant: i64| {
        let coefficients = [constant, 0, 1].map(|n| rational(n, 1)).to_vec();
        (coefficients, rational(0, 1), rational(5, 1))
    };
    // x² − 4 and x² − 9; x² + 4 has no root
    let problems = [problem(-4), problem(4), problem(-9)];
    let wrong = [(Fault::Root, "the greatest root of")];
    sees("roots", || assert_eq!(greatest_roots::<Planted>(&problems), 2), &wrong);
}
