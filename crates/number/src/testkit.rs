//! Axioms as reusable functions: a new number system is right when it passes them.
//!
//! For tests only (feature `testkit`). Each function takes the elements to try, edge cases first,
//! and panics with the first equation that fails, in mathematical notation.

mod contract;

use std::cmp::Ordering;
use std::fmt::Debug;

use crate::{Algebraic, Number, Ordered, Rational, Real};

pub use contract::Contract;

/// Checks that a number system keeps its [`Contract`] on every constant, conversion, operation
/// and comparison, for all triples of `elements` (those that the system can hold).
///
/// # Panics
/// If a result is outside the contract.
pub fn conformance<N: Contract>(elements: &[Rational]) {
    let integer = |n: i64| Rational::from_integer(n.into());
    holds::<N>("0 is 0", &[], N::admits(&N::zero(), &integer(0)));
    holds::<N>("1 is 1", &[], N::admits(&N::one(), &integer(1)));
    for exact in elements {
        let converted = N::from_rational(exact);
        holds("a rational is converted", &[&converted], N::admits(&converted, exact));
    }
    let held: Vec<(N, Rational)> = elements.iter().filter_map(N::operand).collect();
    for (a, x) in &held {
        let keeps = |law: &str, result: &N, exact: &Rational| {
            assert!(N::admits(result, exact), "{law} fails at {a}: {result:?} for {exact}");
        };
        keeps("−a", &-a.clone(), &-x);
        keeps("2a", &a.double(), &(x + x));
        keeps("a²", &a.square(), &(x * x));
        holds("a is a number", &[a], a.is_finite());
        holds("a widened and narrowed is a", &[a], N::narrow(&a.widen()) == *a);
        holds("a/0 is refused", &[a], a.checked_div(&N::zero()).is_none());
    }
    for ((a, x), (b, y)) in pairs(&held) {
        let keeps = |law: &str, result: &N, exact: &Rational| {
            assert!(N::admits(result, exact), "{law} fails at {a}, {b}: {result:?} for {exact}");
        };
        keeps("a + b", &(a.clone() + b), &(x + y));
        keeps("a − b", &(a.clone() - b), &(x - y));
        keeps("a·b", &(a.clone() * b), &(x * y));
        match a.checked_div(b) {
            Some(quotient) => keeps("a/b", &quotient, &(x / y)),
            None => holds("only a/0 is refused", &[a, b], *y == integer(0)),
        }
        holds("the order is the exact one", &[a, b], agrees(a, b, x.cmp(y)));
        for (c, z) in &held {
            let fused = a.mul_add(b, c);
            let exact = x * y + z;
            let law = "fma(a, b, c)";
            assert!(N::admits(&fused, &exact), "{law} fails at {a}, {b}, {c}: {fused:?}");
        }
    }
}

/// Whether the answers of a comparison, where there are any, are those of the exact order.
fn agrees<N: Ordered>(a: &N, b: &N, exact: Ordering) -> bool {
    let known = a.compare(b);
    let right = |answer: Option<bool>, truth: bool| answer.is_none_or(|answer| answer == truth);
    right(known.is_less(), exact.is_lt())
        && right(known.is_equal(), exact.is_eq())
        && right(known.is_greater(), exact.is_gt())
        && right(known.is_at_most(), exact.is_le())
        && right(known.is_at_least(), exact.is_ge())
}

/// A polynomial by ascending coefficients, and the two ends between which a root is wanted.
pub type RootProblem = (Vec<Rational>, Rational, Rational);

/// Checks the greatest root of each polynomial against the exact one, and gives how many had
/// one: in a rounding system the polynomial is the rounded one, which may have lost it.
///
/// # Panics
/// If an answer is outside the contract.
pub fn greatest_roots<N: Contract>(problems: &[RootProblem]) -> usize {
    let mut asked = 0;
    for (coefficients, lower, upper) in problems {
        let operands: Option<Vec<(N, Rational)>> = coefficients.iter().map(N::operand).collect();
        let ends = (operands, N::operand(lower), N::operand(upper));
        let (Some(operands), Some((low, lower)), Some((high, upper))) = ends else { continue };
        let (numbers, exact): (Vec<N>, Vec<Algebraic>) =
            operands.into_iter().map(|(number, exact)| (number, exact.into())).unzip();
        let (from, to) = (lower.into(), upper.into());
        let Some(root) = Algebraic::greatest_root(&exact, &from, &to) else { continue };
        asked += 1;
        let answer = N::greatest_root(&numbers, &low, &high);
        assert!(
            N::admits_root(answer.as_ref(), &root),
            "the greatest root of {numbers:?} in [{low}, {high}] is {root}, not {answer:?}"
        );
    }
    asked
}

/// Checks the field axioms on every triple of `elements`; for exact systems only.
///
/// # Panics
/// If an axiom fails.
pub fn field_axioms<N: Number + PartialEq>(elements: &[N]) {
    let (zero, one) = (N::zero(), N::one());
    holds::<N>("0 ≠ 1", &[], zero != one);
    for a in elements {
        let x = || a.clone();
        equal("a + 0 = a", &[a], x() + &zero, x());
        equal("a·1 = a", &[a], x() * &one, x());
        equal("a + (−a) = 0", &[a], x() + -x(), zero.clone());
        equal("2a = a + a", &[a], a.double(), x() + a);
        equal("a² = a·a", &[a], a.square(), x() * a);
        holds("a/0 is refused", &[a], a.checked_div(&zero).is_none());
        if *a != zero {
            equal("a·(1/a) = 1", &[a], x() * (one.clone() / a), one.clone());
        }
    }
    for (a, b) in pairs(elements) {
        let (x, y) = (|| a.clone(), || b.clone());
        equal("a + b = b + a", &[a, b], x() + b, y() + a);
        equal("a·b = b·a", &[a, b], x() * b, y() * a);
        equal("a − b = a + (−b)", &[a, b], x() - b, x() + -y());
        equal("a·b by value = by reference", &[a, b], x() * y(), x() * b);
        if *b != zero {
            equal("(a/b)·b = a", &[a, b], x() / b * b, x());
            let divided = a.checked_div(b);
            holds("a/b is found", &[a, b], divided == Some(x() / y()));
        }
    }
    for (a, b) in pairs(elements) {
        for c in elements {
            let x = || a.clone();
            let all = [a, b, c];
            let (sum, product) = (b.clone() + c, b.clone() * c);
            equal("(a + b) + c = a + (b + c)", &all, x() + b + c, x() + sum.clone());
            equal("(a·b)·c = a·(b·c)", &all, x() * b * c, x() * product);
            equal("a·(b + c) = a·b + a·c", &all, x() * sum, x() * b + x() * c);
            equal("fma(a, b, c) = a·b + c", &all, a.mul_add(b, c), x() * b + c);
        }
    }
}

/// Checks on every triple of `elements` that the order is total and fits the field; for exact
/// systems only.
///
/// # Panics
/// If an axiom fails.
pub fn ordered_field_axioms<N: Ordered + PartialEq>(elements: &[N]) {
    let less = |a: &N, b: &N| a.compare(b).is_less() == Some(true);
    for (a, b) in pairs(elements) {
        let known = [less(a, b), a == b, less(b, a)];
        let count = known.into_iter().filter(|&known| known).count();
        holds("exactly one of a < b, a = b, a > b", &[a, b], count == 1);
        holds("a = b is seen", &[a, b], a.compare(b).is_equal() == Some(a == b));
        if a.sign().is_greater() == Some(true) && b.sign().is_greater() == Some(true) {
            let product = a.clone() * b;
            holds("a, b > 0 ⇒ a·b > 0", &[a, b], less(&N::zero(), &product));
        }
        for c in elements {
            if less(a, b) {
                let shifted = less(&(a.clone() + c), &(b.clone() + c));
                holds("a < b ⇒ a + c < b + c", &[a, b, c], shifted);
                let transitive = !less(b, c) || less(a, c);
                holds("a < b < c ⇒ a < c", &[a, b, c], transitive);
            }
        }
    }
}

fn pairs<N>(elements: &[N]) -> impl Iterator<Item = (&N, &N)> {
    elements.iter().flat_map(move |a| elements.iter().map(move |b| (a, b)))
}

fn equal<N: Debug + PartialEq>(axiom: &str, at: &[&N], left: N, right: N) {
    assert!(left == right, "{axiom} fails at {at:?}: {left:?} ≠ {right:?}");
}

fn holds<N: Debug>(axiom: &str, at: &[&N], holds: bool) {
    assert!(holds, "{axiom} fails at {at:?}");
}
