//! The definitions of a document that a goal reaches.

use kane_kernel::{Conclusion, Definition, Expr, Goal, Hypothesis, Link, Target};

use crate::Document;

/// The document's definitions with those emptied that the goal does not reach, so that a claim and
/// its certificate do not depend on the rest of the document.
pub(super) fn needed_lets(
    document: &Document,
    goal: &Goal,
    behind: &[Hypothesis],
    by: &[(usize, Expr)],
) -> Vec<Definition> {
    let mut todo: Vec<&Expr> = by.iter().map(|b| &b.1).collect();
    let sentences = goal.hypotheses.iter().chain(behind).map(|h| &h.sentence);
    for s in sentences {
        todo.extend(s.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
        todo.extend(s.links.iter().flat_map(link_parts));
    }
    todo.extend(goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
    match &goal.conclusion {
        Conclusion::Link(l) => todo.extend(link_parts(l)),
        Conclusion::NotImplied(s) => {
            todo.extend(s.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
            todo.extend(s.links.iter().flat_map(link_parts));
        }
        Conclusion::Contradiction => {}
    }
    kept(&document.context.lets, todo)
}

/// The definitions with those emptied that nothing of this reaches.
pub(super) fn kept<'a>(lets: &'a [Definition], mut todo: Vec<&'a Expr>) -> Vec<Definition> {
    let mut needed = vec![false; lets.len()];
    while let Some(e) = todo.pop() {
        if let Expr::Let(i) = e
            && !std::mem::replace(&mut needed[*i], true)
        {
            todo.push(&lets[*i].body);
        }
        todo.extend(e.children());
    }
    let keep = |(d, needed): (&Definition, bool)| Definition {
        name: d.name.clone(),
        body: if needed { d.body.clone() } else { Expr::int(0) },
    };
    lets.iter().zip(needed).map(keep).collect()
}

/// The expressions of a link.
pub(super) fn link_parts(l: &Link) -> Vec<&Expr> {
    match l {
        Link::Relation(r) => vec![&r.lhs, &r.rhs],
        Link::Limit(l) => match &l.to {
            Target::Finite(value) => vec![&l.expr, value],
            _ => vec![&l.expr],
        },
    }
}
