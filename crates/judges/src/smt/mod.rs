//! SMT-LIB: the opposite of a claim, for solvers that decide such conditions over the real numbers.
//!
//! The question is written from the statement as it was read: premises that are defined and true,
//! cited claims that are true where they are defined, and a conclusion that is not. What an
//! expression is, where it is defined and what its derivatives are is said here, and nothing is
//! taken from the kernel but the statement and the witness. A proved claim's conditions have no
//! common point: the answer should be `unsat`. For a refuted one the witness is asserted too: `sat`.

mod slope;
mod term;

use std::collections::BTreeSet;
use std::fmt::Write as _;

use kane_audit::Accepted;
use kane_kernel::{
    Certificate, Conclusion, Evidence, Expr, Finding, Goal, Link, Model, Point, Relation,
    expressions, premised,
};

use crate::Claims;
pub use term::NotPut;
use term::{Terms, any, integer, rational, root_name, times};

/// A question to a solver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Question {
    /// one file with one `check-sat`
    pub text: String,
    /// whether the answer should be `sat`; else `unsat`
    pub satisfiable: bool,
}

/// The question that a finding answers.
///
/// # Errors
/// [`NotPut`]: why there is none.
pub fn question(accepted: &Accepted) -> Result<Question, NotPut> {
    let (goal, Certificate { finding, evidence, .. }) = (&accepted.goal, &accepted.certificate);
    let limit = matches!(goal.conclusion, Conclusion::Link(Link::Limit(_)));
    if limit || premised(goal).next().is_some() {
        return Err(NotPut::Limits);
    }
    let point = match evidence {
        Evidence::Contradiction(_) => None,
        Evidence::Model(Model::Point(point)) => Some(point),
        Evidence::Model(Model::Functions(_)) | Evidence::Limit(_) | Evidence::Split { .. } => {
            return Err(NotPut::Limits);
        }
    };
    let terms = Terms::new(&goal.context);
    let mut asserted = Vec::new();
    for h in &goal.hypotheses {
        let truth = terms.sentence(&h.sentence)?;
        asserted.push(any(&truth, |v| v.unwrap_or(!h.given)));
    }
    asserted.push(any(&terms.relations(&goal.when)?, |v| *v == Some(true)));
    asserted.extend(failure(&terms, goal, *finding)?);
    let mut text = "(set-logic QF_NRA)\n".to_owned();
    for v in mentioned(goal) {
        let _ = writeln!(text, "(declare-const {} Real)\n{}", terms.symbol(v), terms.range(v));
    }
    for i in 0..terms.roots.borrow().len() {
        let _ = writeln!(text, "(declare-const {} Real)", root_name(i));
    }
    text = text.replace("\n\n", "\n") + &terms.named.borrow().concat();
    for condition in asserted.iter().filter(|c| *c != "true") {
        let _ = writeln!(text, "(assert {condition})");
    }
    if let Some(point) = point {
        text.push_str(&witness(&terms, goal, point));
    }
    text.push_str("(check-sat)\n");
    let satisfiable = point.is_some() && *finding != Finding::Vacuous;
    Ok(Question { text, satisfiable })
}

/// How the conclusion fails.
fn failure(terms: &Terms<'_>, goal: &Goal, finding: Finding) -> Result<Option<String>, NotPut> {
    let relation = |r: &Relation, wanted: fn(&Option<bool>) -> bool| {
        Ok::<_, NotPut>(Some(any(&terms.relation(r)?, wanted)))
    };
    match (&goal.conclusion, finding) {
        (_, Finding::Vacuous | Finding::Consistent) | (Conclusion::Contradiction, _) => Ok(None),
        (Conclusion::Link(Link::Relation(r)), Finding::Proved) => relation(r, |v| *v != Some(true)),
        (Conclusion::Link(Link::Relation(r)), Finding::Refuted) => {
            relation(r, |v| *v == Some(false))
        }
        (Conclusion::Link(Link::Relation(r)), Finding::IllDefined) => relation(r, Option::is_none),
        (Conclusion::NotImplied(s), _) if s.limits().next().is_none() => {
            Ok(Some(any(&terms.sentence(s)?, |v| *v != Some(true))))
        }
        _ => Err(NotPut::Limits),
    }
}

/// The symbols of a goal of which all terms are written, definitions followed.
fn mentioned(goal: &Goal) -> BTreeSet<usize> {
    let context = &goal.context;
    let (mut out, mut seen) = (BTreeSet::new(), BTreeSet::new());
    let sentences = goal.hypotheses.iter().map(|h| &h.sentence);
    let mut todo: Vec<&Expr> = sentences
        .flat_map(|s| expressions(&s.when, &s.links))
        .chain(expressions(&goal.when, &[]))
        .chain(expressions(goal.conclusion.when(), goal.conclusion.links()))
        .collect();
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) | Expr::Deriv(_, v) => _ = out.insert(*v),
            Expr::Let(i) if seen.insert(*i) => todo.extend(context.lets.get(*i).map(|l| &l.body)),
            _ => {}
        }
        todo.extend(e.children());
    }
    out
}

/// The coordinates of a witness, with the number in which they are polynomials. Roots follow from
/// the symbols.
fn witness(terms: &Terms<'_>, goal: &Goal, point: &Point) -> String {
    let term = |c: String, n: usize| (0..n).fold(c, |product, _| times(&product, "theta"));
    let sum = |parts: Vec<String>| match parts.as_slice() {
        [] => "0".to_owned(),
        [one] => one.clone(),
        many => format!("(+ {})", many.join(" ")),
    };
    let mut text = String::new();
    if let Some(root) = &point.generator {
        let parts = root.poly.iter().enumerate().map(|(n, c)| term(integer(c), n)).collect();
        let _ = writeln!(text, "(declare-const theta Real)\n(assert (= {} 0))", sum(parts));
        let (lo, hi) = (rational(&root.lo), rational(&root.hi));
        let _ = writeln!(text, "(assert (< {lo} theta {hi}))");
    }
    let known = mentioned(goal);
    for (v, cs) in point.values.iter().filter(|(v, _)| known.contains(v)) {
        let parts = cs.iter().enumerate().map(|(n, c)| term(rational(c), n)).collect();
        let _ = writeln!(text, "(assert (= {} {}))", terms.symbol(*v), sum(parts));
    }
    text
}

/// The questions to all links of claims, each with a name for its file.
#[must_use]
pub fn questions(claims: &Claims<'_>) -> Vec<(String, Question)> {
    let mut out: Vec<(String, Question)> = Vec::new();
    for asked in claims.links() {
        let Some(asks) = asked.judged.accepted.as_deref().and_then(|a| question(a).ok()) else {
            continue;
        };
        let mut name = asked.name();
        while out.iter().any(|(n, _)| *n == name) {
            name.push('_');
        }
        out.push((name, asks));
    }
    out
}
