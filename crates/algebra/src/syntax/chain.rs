//! Relations one after the other; those that share a side become a chain, `a < b = c`.

use kane_kernel::{Expr, Rel, Relation};

use super::logic::Logic;

/// How a notation writes what relations are made of.
pub(super) struct Hand<'a> {
    /// one side of a comparison
    pub(super) side: &'a dyn Fn(&Expr) -> String,
    /// a comparison's sign
    pub(super) sign: fn(Rel) -> &'static str,
    /// `or`, `implies` or `iff`, in parentheses where it has to be
    pub(super) formula: &'a dyn Fn(&Logic<'_>) -> String,
}

/// Relations with `between` them.
pub(super) fn chained(relations: &[Relation], between: &str, hand: &Hand<'_>) -> String {
    let mut out = String::new();
    let mut last: Option<&Expr> = None;
    for relation in relations {
        let logic = Logic::of(relation);
        if !out.is_empty() && (logic.is_some() || last != Some(&relation.lhs)) {
            out.push_str(between);
            last = None;
        }
        if let Some(logic) = logic {
            out.push_str(&(hand.formula)(&logic));
            continue;
        }
        if last != Some(&relation.lhs) {
            out.push_str(&(hand.side)(&relation.lhs));
        }
        out.push(' ');
        out.push_str((hand.sign)(relation.rel));
        out.push(' ');
        out.push_str(&(hand.side)(&relation.rhs));
        last = Some(&relation.rhs);
    }
    out
}
