//! Rewritings that keep the value wherever both sides are defined.
//!
//! None of them is trusted: whoever shows a repair has it proved.

use kane_number::Rational;
use num_traits::{One as _, Signed as _};

use super::tree::Tree;

type Boxed = Box<Tree>;

fn boxed(tree: &Tree) -> Boxed {
    Box::new(tree.clone())
}

fn sub(a: &Tree, b: &Tree) -> Tree {
    Tree::Sub(boxed(a), boxed(b))
}

fn add(a: &Tree, b: &Tree) -> Tree {
    Tree::Add(boxed(a), boxed(b))
}

fn mul(a: &Tree, b: &Tree) -> Tree {
    Tree::Mul(boxed(a), boxed(b))
}

fn div(a: &Tree, b: &Tree) -> Tree {
    Tree::Div(boxed(a), boxed(b))
}

/// Multiplied out if that is possible, otherwise as it is.
fn simple(tree: Tree) -> Tree {
    tree.normal().filter(|normal| normal.nodes() <= 2 * tree.nodes()).unwrap_or(tree)
}

/// All forms that one rewriting at the top gives.
pub(super) fn at_top(tree: &Tree) -> Vec<Tree> {
    let mut found = Vec::new();
    found.extend(tree.normal());
    match tree {
        Tree::Sub(a, b) => {
            conjugate(a, b, &mut found);
            fractions(a, b, true, &mut found);
            squares(a, b, &mut found);
            regrouped_difference(a, b, &mut found);
            if let Tree::Mul(p, q) = &**a {
                found.push(Tree::Fma(p.clone(), q.clone(), Box::new(Tree::Neg(b.clone()))));
            }
            if let Tree::Mul(p, q) = &**b {
                found.push(Tree::Fma(Box::new(Tree::Neg(p.clone())), q.clone(), a.clone()));
            }
        }
        Tree::Add(a, b) => {
            // a + b as a − (−b), and as b − (−a)
            if let Tree::Neg(negative) = &**a {
                found.push(sub(b, negative));
                conjugate(b, negative, &mut found);
            } else if matches!(**a, Tree::Sqrt(_)) || matches!(**b, Tree::Sqrt(_)) {
                sum_of_root(a, b, &mut found);
            }
            if let Tree::Neg(negative) = &**b {
                found.push(sub(a, negative));
                conjugate(a, negative, &mut found);
            }
            fractions(a, b, false, &mut found);
            for (product, other) in [(a, b), (b, a)] {
                if let Tree::Mul(p, q) = &**product {
                    found.push(Tree::Fma(p.clone(), q.clone(), other.clone()));
                }
            }
        }
        Tree::Mul(a, b) => {
            for (quotient, other) in [(a, b), (b, a)] {
                if let Tree::Div(p, q) = &**quotient {
                    found.push(div(&mul(p, other), q));
                }
            }
        }
        Tree::Div(a, b) => {
            if let Tree::Div(p, q) = &**a {
                found.push(div(p, &mul(q, b)));
            }
            if let Tree::Div(p, q) = &**b {
                found.push(div(&mul(a, q), p));
            }
        }
        Tree::Sqrt(a) => {
            // √(p/q) and √(p·q) as they are: a rule of their own would need signs
            found.extend(a.normal().map(|a| Tree::Sqrt(Box::new(a))));
        }
        _ => {}
    }
    found.retain(|form| form != tree);
    found
}

/// The square of a tree, without its root if it is one.
fn square(tree: &Tree) -> Tree {
    match tree {
        Tree::Sqrt(radicand) => (**radicand).clone(),
        Tree::Mul(a, b) => match (&**a, &**b) {
            (Tree::Sqrt(radicand), factor) | (factor, Tree::Sqrt(radicand)) => {
                mul(&mul(factor, factor), radicand)
            }
            _ => mul(tree, tree),
        },
        Tree::Neg(a) => square(a),
        _ => mul(tree, tree),
    }
}

fn has_root(tree: &Tree) -> bool {
    match tree {
        Tree::Sqrt(_) => true,
        Tree::Neg(a) => has_root(a),
        Tree::Mul(a, b) => has_root(a) || has_root(b),
        _ => false,
    }
}

/// a − b = (a² − b²)/(a + b), where one of them is a root.
fn conjugate(a: &Tree, b: &Tree, found: &mut Vec<Tree>) {
    if has_root(a) || has_root(b) {
        let difference = simple(sub(&square(a), &square(b)));
        found.push(div(&difference, &add(a, b)));
    }
}

/// a + b = (a² − b²)/(a − b), where one of them is a root.
fn sum_of_root(a: &Tree, b: &Tree, found: &mut Vec<Tree>) {
    let difference = simple(sub(&square(a), &square(b)));
    found.push(div(&difference, &sub(a, b)));
}

/// p/q ± r/s = (p·s ± r·q)/(q·s), the numerator multiplied out.
fn fractions(a: &Tree, b: &Tree, minus: bool, found: &mut Vec<Tree>) {
    let one = Tree::Number(Rational::one());
    let parts = |tree: &Tree| match tree {
        Tree::Div(p, q) => ((**p).clone(), (**q).clone(), true),
        _ => (tree.clone(), one.clone(), false),
    };
    let ((p, q, first), (r, s, second)) = (parts(a), parts(b));
    if !first && !second {
        return;
    }
    let (left, right) = (mul(&p, &s), mul(&r, &q));
    let numerator = simple(if minus { sub(&left, &right) } else { add(&left, &right) });
    let denominator = match (first, second) {
        (true, true) => mul(&q, &s),
        (true, false) => q,
        _ => s,
    };
    found.push(div(&numerator, &denominator));
}

/// The root of a tree that is visibly a square.
fn root_of(tree: &Tree) -> Option<Tree> {
    match tree {
        Tree::Mul(a, b) if a == b => Some((**a).clone()),
        Tree::Number(number) if number.is_positive() => {
            let (n, d) = (number.numer().sqrt(), number.denom().sqrt());
            let is_square = &n * &n == *number.numer() && &d * &d == *number.denom();
            is_square.then(|| Tree::Number(Rational::new(n, d)))
        }
        _ => None,
    }
}

/// p² − q² = (p − q)·(p + q).
fn squares(a: &Tree, b: &Tree, found: &mut Vec<Tree>) {
    if let (Some(p), Some(q)) = (root_of(a), root_of(b)) {
        found.push(mul(&sub(&p, &q), &add(&p, &q)));
    }
}

/// (p + q) − r = p + (q − r) = (p − r) + q, and the same with differences.
fn regrouped_difference(a: &Tree, r: &Tree, found: &mut Vec<Tree>) {
    match a {
        Tree::Add(p, q) => {
            found.push(add(p, &sub(q, r)));
            found.push(add(&sub(p, r), q));
        }
        Tree::Sub(p, q) => found.push(sub(&sub(p, r), q)),
        _ => {}
    }
}
