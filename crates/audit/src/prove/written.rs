//! Summands as they are written. A square, or a product whose odd factors are known not to be negative, stays
//! one whatever it is multiplied out to: sums of such summands are told without a search.

use kane_kernel::{Conclusion, Expr, Goal, Link, Poly, Relation, Sign, State};

use super::combination::{Multiple, Size, Summand, combined, summand};
use super::hints::{Hint, expanded};
use crate::argument::Argument;

/// Summands that are looked at.
const SUMMANDS: usize = 24;
/// The linear program of such summands.
const SIZE: Size = Size { rows: 2_000, columns: 200, pivots: 200 };

/// The summands of the relations of a goal, if one of them is written as a square of more than a symbol.
pub(super) fn summands(goal: &Goal) -> Vec<Expr> {
    let links = |links: &[Link]| -> Vec<Relation> {
        let relation = |link: &Link| match link {
            Link::Relation(relation) => Some(relation.clone()),
            Link::Limit(_) => None,
        };
        links.iter().filter_map(relation).collect()
    };
    let mut relations = match &goal.conclusion {
        Conclusion::Link(link) => links(std::slice::from_ref(link)),
        Conclusion::NotImplied(sentence) => links(&sentence.links),
        Conclusion::Contradiction => Vec::new(),
    };
    relations.extend(goal.when.iter().cloned());
    for hypothesis in &goal.hypotheses {
        relations.extend(links(&hypothesis.sentence.links));
    }
    let mut found = Vec::new();
    for side in relations.iter().flat_map(|relation| [&relation.lhs, &relation.rhs]) {
        if let Some(side) = expanded(side, &goal.context) {
            parts(&side, &mut found);
        }
        if found.len() > SUMMANDS {
            break;
        }
    }
    found.truncate(SUMMANDS);
    if found.iter().any(has_square) { found } else { Vec::new() }
}

/// The summands of a sum, without signs and numbers in front.
fn parts(e: &Expr, out: &mut Vec<Expr>) {
    match e {
        Expr::Add(a, b) | Expr::Sub(a, b) => {
            parts(a, out);
            parts(b, out);
        }
        Expr::Neg(a) => parts(a, out),
        Expr::Mul(a, b) if matches!(**a, Expr::Num(_)) => parts(b, out),
        Expr::Num(_) => {}
        _ if out.len() > SUMMANDS || out.contains(e) => {}
        _ => out.push(e.clone()),
    }
}

/// Whether a product has the square of a sum as a factor.
fn has_square(e: &Expr) -> bool {
    match e {
        Expr::Mul(a, b) => (a == b && is_sum(a)) || has_square(a) || has_square(b),
        Expr::Neg(a) => has_square(a),
        Expr::Pow(a, n) => *n >= 2 && is_sum(a) || has_square(a),
        _ => false,
    }
}

fn is_sum(e: &Expr) -> bool {
    matches!(e, Expr::Add(..) | Expr::Sub(..))
}

/// A sum of such summands, atoms and multiples of equations that is 0 although one of them is positive.
pub(super) fn closed(state: &State<'_, '_>, written: &[Hint]) -> Option<Argument> {
    let mut summands: Vec<Summand> = Vec::new();
    for (square, factors) in written.iter().filter_map(|hint| hint.as_term(state)) {
        summands.push(summand(state, square, factors)?);
    }
    if summands.iter().all(|(term, ..)| term.square.is_constant()) {
        return None;
    }
    summands.push(summand(state, Poly::one(), Vec::new())?);
    let mut multiples: Vec<Multiple> = Vec::new();
    for (i, atom) in state.atoms.iter().enumerate().filter(|(_, a)| a.decided().is_none()) {
        match atom.sign {
            Sign::Positive | Sign::NonNegative => {
                summands.push(summand(state, Poly::one(), vec![(i, 1)])?);
            }
            Sign::Zero => {
                let one = Poly::one();
                multiples.push((i, one.clone(), atom.poly.clone()));
                multiples.push((i, one.neg(), atom.poly.neg()));
            }
            Sign::NonZero => {}
        }
    }
    combined(state, summands, multiples, &SIZE)
}
