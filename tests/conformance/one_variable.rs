//! One variable is complete: every verdict is that of an independent decision, none is open.

use std::collections::BTreeMap;
use std::rc::Rc;
use std::time::Instant;

use kane::audit::{Budget, judge_goal};
use kane::kernel::{Bound, Conclusion, Context, Expr, Finding, Goal, Link, Rel, Relation, Var};

use crate::decision::{Truth, decide};
use crate::generate::{RELS, add, div, mul, pow, rel, sub};
use crate::many::many;
use crate::support::{Chance, num, q, shown};

fn x() -> Expr {
    Expr::Var(0)
}

/// A polynomial of degree one to three: rational and irrational roots, or none.
fn factor(chance: &mut Chance) -> Expr {
    let c = num(&q(chance.within(-4, 4), *chance.pick(&[1, 1, 2, 3])));
    match chance.below(8) {
        0..=2 => sub(x(), c),
        3 => sub(pow(x(), 2), num(&q(*chance.pick(&[2, 3, 5, 8]), 1))),
        4 => add(pow(x(), 2), Expr::int(chance.within(1, 3))),
        5 => sub(sub(pow(x(), 2), x()), Expr::int(1)),
        6 => add(sub(pow(x(), 3), mul(Expr::int(chance.within(1, 3)), x())), c),
        _ => x(),
    }
}

fn product(chance: &mut Chance) -> Expr {
    let count = 1 + chance.below(3);
    let mut out = factor(chance);
    for _ in 1..count {
        out = mul(out, factor(chance));
    }
    if chance.once_in(3) { pow(out, 2) } else { out }
}

fn term(chance: &mut Chance) -> Expr {
    let a = product(chance);
    match chance.below(8) {
        0..=2 => a,
        3 | 4 => div(a, product(chance)),
        5 => Expr::Abs(a.into()),
        6 => {
            let b = factor(chance);
            if chance.once_in(2) {
                Expr::Min(a.into(), b.into())
            } else {
                Expr::Max(a.into(), b.into())
            }
        }
        _ => {
            let guard = rel(factor(chance), *chance.pick(&RELS), Expr::int(0));
            let last = (!chance.once_in(3)).then(|| Rc::new(factor(chance)));
            Expr::Cases(vec![(vec![guard], a)], last)
        }
    }
}

fn condition(chance: &mut Chance) -> Relation {
    let side =
        if chance.once_in(4) { div(factor(chance), factor(chance)) } else { product(chance) };
    rel(side, *chance.pick(&[Rel::Gt, Rel::Ge, Rel::Lt, Rel::Le, Rel::Ne, Rel::Eq]), Expr::int(0))
}

fn statement(chance: &mut Chance) -> Goal {
    let bound = |n, strict| Some(Bound { value: q(n, 1), strict });
    let (lower, upper) = match chance.below(6) {
        0 | 1 => (None, None),
        2 => (bound(0, true), None),
        3 => (bound(0, false), None),
        4 => (bound(-1, false), bound(1, false)),
        _ => (bound(-2, true), bound(3, true)),
    };
    let vars = vec![Var { name: "x".to_owned(), of: None, lower, upper }];
    let when: Vec<Relation> = (0..chance.below(3)).map(|_| condition(chance)).collect();
    let claim = match chance.below(6) {
        // true wherever it is defined
        0 => rel(pow(term(chance), 2), Rel::Ge, Expr::int(0)),
        1 => {
            let (a, b) = (product(chance), product(chance));
            rel(mul(div(a.clone(), b.clone()), b), Rel::Eq, a)
        }
        // what a condition says, in other words
        2 if !when.is_empty() => {
            let r = chance.pick(&when).clone();
            let (k, c) = (Expr::int(chance.within(1, 3)), factor(chance));
            let scaled = |e: Expr| add(mul(k.clone(), e), c.clone());
            let loose = match r.rel {
                Rel::Gt if chance.once_in(2) => Rel::Ge,
                Rel::Lt if chance.once_in(2) => Rel::Le,
                other => other,
            };
            rel(scaled(r.lhs), loose, scaled(r.rhs))
        }
        3 => rel(term(chance), *chance.pick(&RELS), Expr::int(0)),
        _ => rel(term(chance), *chance.pick(&RELS), term(chance)),
    };
    Goal {
        context: Context { vars, ..Context::default() },
        hypotheses: Vec::new(),
        behind: Vec::new(),
        when,
        conclusion: Conclusion::Link(Link::Relation(claim)),
    }
}

#[test]
fn one_variable_is_decided_as_an_independent_procedure_decides() {
    let (mut chance, start) = (Chance::new(4), Instant::now());
    let (mut wrong, mut counts) = (Vec::new(), BTreeMap::new());
    let (mut own, mut slowest) = (0.0, (0.0, String::new()));
    let count = many(10_000);
    for _ in 0..count {
        let goal = statement(&mut chance);
        let begin = Instant::now();
        let truth = decide(&goal);
        own += begin.elapsed().as_secs_f64();
        let begin = Instant::now();
        let found = judge_goal(&goal, &[], Budget::default());
        let seconds = begin.elapsed().as_secs_f64();
        if seconds > slowest.0 {
            slowest = (seconds, shown(&goal));
        }
        *counts.entry(truth).or_insert(0_usize) += 1;
        let verdict = found.decided.as_ref().map(|c| c.finding);
        let wanted = match truth {
            Truth::Vacuous => Finding::Vacuous,
            Truth::Undefined => Finding::IllDefined,
            Truth::False => Finding::Refuted,
            Truth::True => Finding::Proved,
        };
        if verdict != Some(wanted) {
            let open = &found.open;
            wrong.push(format!("{truth:?}, but {verdict:?} ({open:?}):\n{}", shown(&goal)));
        }
    }
    println!(
        "one variable: {count} claims, {counts:?}; {:.1} s, of which the decision {own:.1} s",
        start.elapsed().as_secs_f64()
    );
    println!("one variable: the longest took {:.2} s:\n{}", slowest.0, slowest.1);
    assert!(
        wrong.is_empty(),
        "{} differ; the first:\n{}",
        wrong.len(),
        wrong[..wrong.len().min(8)].join("\n")
    );
}
