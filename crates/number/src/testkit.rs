//! Axioms as reusable functions: a new number system is right when it passes them.
//!
//! For tests only (feature `testkit`). Each function takes the elements to try, edge cases first,
//! and panics with the first equation that fails, in mathematical notation.

use std::fmt::Debug;

use crate::{Number, Ordered};

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
