//! `or`, `implies` and `iff` as comparisons of `cases`, and which comparisons are such.
//!
//! A part is a conjunction of relations, read from left to right. `A or B` says
//! `cases { A: 1; B: 1; else: 0 } = 1`, `A implies B` says
//! `cases { A: cases { B: 1; else: 0 }; else: 1 } = 1`, and `A iff B` says
//! `cases { A: 1; else: 0 } = cases { B: 1; else: 0 }`. So a part that is read has to be defined, and
//! none is read that does not matter.

use kane_kernel::{Expr, Rel, Relation};
use num_traits::{One, Zero};

/// What a relation says in terms of parts, each a conjunction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Logic<'a> {
    /// at least one of these holds
    Or(Vec<&'a [Relation]>),
    /// where the first holds the second does
    Implies(&'a [Relation], &'a [Relation]),
    /// both hold or neither
    Iff(&'a [Relation], &'a [Relation]),
}

impl<'a> Logic<'a> {
    /// The parts of a relation that `or`, `implies` or `iff` makes; `None` for any other.
    #[must_use]
    pub fn of(relation: &'a Relation) -> Option<Self> {
        if relation.rel != Rel::Eq {
            return None;
        }
        if let (Some(a), Some(b)) = (truth(&relation.lhs), truth(&relation.rhs)) {
            return Some(Self::Iff(a, b));
        }
        let (Expr::Cases(branches, Some(otherwise)), true) = (&relation.lhs, is_one(&relation.rhs))
        else {
            return None;
        };
        if branches.iter().any(|(guards, _)| guards.is_empty()) {
            return None;
        }
        match branches.as_slice() {
            [(guards, body)] if is_one(otherwise) => Some(Self::Implies(guards, truth(body)?)),
            [_, _, ..] if is_zero(otherwise) && branches.iter().all(|(_, body)| is_one(body)) => {
                Some(Self::Or(branches.iter().map(|(guards, _)| guards.as_slice()).collect()))
            }
            _ => None,
        }
    }

    /// The parts as `part` writes them, with the words for `or`, `implies` and `iff` between.
    pub fn written(
        &self,
        part: impl Fn(&[Relation]) -> String,
        [or, implies, iff]: [&str; 3],
    ) -> String {
        match self {
            Self::Or(parts) => parts.iter().map(|p| part(p)).collect::<Vec<_>>().join(or),
            Self::Implies(a, b) => [part(a), part(b)].join(implies),
            Self::Iff(a, b) => [part(a), part(b)].join(iff),
        }
    }
}

/// `A or B or …`
pub(crate) fn or(parts: Vec<Vec<Relation>>) -> Relation {
    let branches = parts.into_iter().map(|guards| (guards, Expr::int(1))).collect();
    holds(Expr::Cases(branches, Some(Expr::int(0).into())))
}

/// `A implies B`
pub(crate) fn implies(a: Vec<Relation>, b: Vec<Relation>) -> Relation {
    holds(Expr::Cases(vec![(a, value(b))], Some(Expr::int(1).into())))
}

/// `A iff B`
pub(crate) fn iff(a: Vec<Relation>, b: Vec<Relation>) -> Relation {
    Relation { lhs: value(a), rel: Rel::Eq, rhs: value(b) }
}

fn holds(lhs: Expr) -> Relation {
    Relation { lhs, rel: Rel::Eq, rhs: Expr::int(1) }
}

/// 1 where the relations hold, 0 where one of them does not.
fn value(relations: Vec<Relation>) -> Expr {
    Expr::Cases(vec![(relations, Expr::int(1))], Some(Expr::int(0).into()))
}

/// The relations of which an expression is 1 where they hold, and else 0.
fn truth(e: &Expr) -> Option<&[Relation]> {
    let Expr::Cases(branches, Some(otherwise)) = e else { return None };
    match branches.as_slice() {
        [(guards, body)] if !guards.is_empty() && is_one(body) && is_zero(otherwise) => {
            Some(guards)
        }
        _ => None,
    }
}

fn is_one(e: &Expr) -> bool {
    matches!(e, Expr::Num(q) if q.is_one())
}

fn is_zero(e: &Expr) -> bool {
    matches!(e, Expr::Num(q) if q.is_zero())
}
