//! Functions as witnesses: premises on the domain, ranges, and a point at which the conclusion fails.

use std::cmp::Ordering;

use kane_kernel::{
    Approach, Conclusion, Evidence, Expr, Failure, Finding, Functions, Germ, Goal, Hypothesis,
    Inside, Limit, Link, Model, Passages, Point, Poly, Proof, Rejection, Rel, Side, SideProof,
    State, Target, constants, differs, inside_goal, inside_state, misses, on_functions, owed,
    point_state, premised, range_premise, scope, sides,
};

use crate::support::{
    Q, X, Y, add, bound, cited, div, equal, found, germ, given, judged, limit, link, mul, n,
    nothing, number, one_is_zero, plain, plenty, q, relation, side, symbol, var, with_function,
};

/// The function k and the constant c.
pub(crate) const K: usize = Y;

pub(crate) const C: usize = 2;

/// num/den with an order, along a side: what a limit is shown with.
pub(crate) type Ends = (Side, Poly, Poly, u32);

/// A limit proof in the domain of functions, or as much of one as there is.
pub(crate) fn tends(domain: &Goal, l: &Limit, (at, num, den, order): Ends) -> SideProof {
    let conclusion = Conclusion::Link(Link::Limit(l.clone()));
    let goal = Goal { conclusion, ..domain.clone() };
    let scope = scope(&goal, plenty()).expect("small");
    let mut state = constants(&scope, &goal, l.var).expect("small");
    state.passages = Passages::Nowhere;
    let mut along = germ(&state, at);
    for given in owed(&state, &along.side) {
        let asked = inside_goal(&state, &along.side, given, &[]).expect("without functions");
        let inner = kane_kernel::scope(&asked, plenty()).expect("small");
        let question = inside_state(&state, &along, &inner, &asked).expect("small");
        let proof = found(&question).unwrap_or_else(nothing);
        along.inside.push(Inside { values: Vec::new(), proof });
    }
    let parts = (&num, &den, order);
    let wrong = differs(&scope, &l.expr, (&num, &den), Ordering::Equal).expect("small");
    let there = state.along_unproved(&along).map(|s| s.with_cases(wrong));
    let along_proof = there.ok().and_then(|s| found(&s)).unwrap_or_else(nothing);
    let ends = misses(&state, &along.side, parts, &l.to);
    let at_zero = ends.ok().and_then(|e| found(&state.with_cases(e))).unwrap_or_else(nothing);
    SideProof {
        germ: along,
        num,
        den,
        order,
        sense: Ordering::Equal,
        along: along_proof.into(),
        at_zero: at_zero.into(),
        upper: None,
    }
}

/// Functions for a goal, with such proofs as there are: those that are missing prove nothing.
pub(crate) fn functions(
    goal: &Goal,
    values: Vec<(usize, Expr)>,
    ends: &[Ends],
    failure: &dyn Fn(&Goal) -> Failure,
) -> Functions {
    let outer = scope(goal, plenty()).expect("small");
    let domain = on_functions(&outer, goal, X, &values);
    let holds = |h: &Hypothesis| {
        let goal =
            Goal { conclusion: Conclusion::NotImplied(h.sentence.clone()), ..domain.clone() };
        let scope = scope(&goal, plenty()).ok()?;
        let fails = scope.premise(&h.sentence, h.given, false).ok()?;
        let state = point_state(&scope, &goal, Some(fails)).ok()?;
        found(&State { passages: Passages::Nowhere, ..state })
    };
    let or_nothing = |h: &Hypothesis| holds(h).unwrap_or_else(nothing);
    let ranges = values.iter().map(|(v, _)| or_nothing(&range_premise(&domain.context, *v)));
    let ranges = ranges.collect();
    let mut ends = ends.iter().cloned();
    let premises = goal.hypotheses.iter().map(|h| {
        let limits = h.sentence.limits().map(|l| {
            let count = sides(&outer, l).len();
            ends.by_ref().take(count).map(|e| tends(&domain, l, e)).collect()
        });
        (or_nothing(h), limits.collect())
    });
    let premises = premises.collect();
    let failure = failure(&domain);
    Functions { var: X, values, ranges, premises, failure }
}

pub(crate) fn judge(goal: &Goal, finding: Finding, f: &Functions) -> Result<(), Rejection> {
    judged(goal, finding, Evidence::Model(Model::Functions(f.clone().into())))
}

pub(crate) fn at(x: Q) -> impl Fn(&Goal) -> Failure {
    move |_| Failure::At(Point { generator: None, values: vec![(X, vec![x.clone()])] })
}

/// From x > 0, k·x = c, k → 0 as x → ∞ and c > 0 (cited) it does not follow that k = 1 when x > 1.
pub(crate) fn hyperbola() -> Goal {
    let mut goal = with_function();
    goal.context.vars.push(symbol("c", None));
    goal.context.vars[K].lower = bound(q(0, 1), true);
    let l = limit(var(K), Target::Finite(number(0, 1)), Approach::PlusInf);
    goal.hypotheses = vec![
        given(vec![link(var(X), Rel::Gt, number(0, 1))]),
        given(vec![link(mul(var(K), var(X)), Rel::Eq, var(C))]),
        given(vec![Link::Limit(l)]),
        cited(vec![link(var(C), Rel::Gt, number(0, 1))]),
    ];
    goal.when = vec![relation(var(X), Rel::Gt, number(1, 1))];
    let Link::Relation(same) = link(var(K), Rel::Eq, number(1, 1)) else {
        unreachable!("a relation");
    };
    goal.conclusion = Conclusion::Link(Link::Relation(same));
    goal
}

/// k = a/x, c = a
pub(crate) fn inverse(a: i64) -> Vec<(usize, Expr)> {
    vec![(K, div(number(a, 1), var(X))), (C, number(a, 1))]
}

/// a/x = a·t/1 as x = 1/t.
pub(crate) fn far(a: i64) -> Vec<Ends> {
    vec![(side(None, true), Poly::var(3).scale(&a.into()), n(1), 0)]
}

#[test]
fn functions_refute_a_claim_at_a_point_of_their_domain() {
    let goal = hyperbola();
    let f = |x: Q| functions(&goal, inverse(1), &far(1), &at(x));
    assert_eq!(judge(&goal, Finding::Refuted, &f(q(2, 1))), Ok(()));
    assert!(judge(&goal, Finding::Refuted, &f(q(1, 2))).is_err(), "its own condition");
    assert!(judge(&goal, Finding::Refuted, &f(q(-2, 1))).is_err(), "outside the domain");
    let f3 = functions(&goal, inverse(3), &far(3), &at(q(3, 1)));
    assert!(judge(&goal, Finding::Refuted, &f3).is_err(), "there the claim holds");
    assert_eq!(judge(&goal, Finding::Consistent, &f3), Ok(()), "but so do the premises");
    for finding in [Finding::Proved, Finding::Vacuous, Finding::IllDefined] {
        assert!(judge(&goal, finding, &f(q(2, 1))).is_err(), "{finding:?}");
    }
    let mut open = goal.clone();
    open.when.clear();
    let outside = functions(&open, inverse(1), &far(1), &at(q(-2, 1)));
    assert!(judge(&open, Finding::Refuted, &outside).is_err(), "outside the domain");
    assert!(judge(&open, Finding::Consistent, &outside).is_err(), "outside the domain");
}

#[test]
fn every_premise_holds_on_the_whole_domain() {
    let goal = hyperbola();
    let two = |values| functions(&goal, values, &far(1), &at(q(2, 1)));
    // k = 1/2 satisfies k·x = 1 at 2 alone; c = 2 nowhere.
    for values in [
        vec![(K, number(1, 2)), (C, number(1, 1))],
        vec![(K, div(number(1, 1), var(X))), (C, number(2, 1))],
    ] {
        assert!(judge(&goal, Finding::Refuted, &two(values)).is_err());
    }
    // c = −1 is what the citation forbids, and k its declared range.
    let negative = functions(&goal, inverse(-1), &far(-1), &at(q(2, 1)));
    assert!(judge(&goal, Finding::Refuted, &negative).is_err());
    let mut free = goal.clone();
    free.context.vars[K].lower = None;
    let negative = functions(&free, inverse(-1), &far(-1), &at(q(2, 1)));
    assert!(judge(&free, Finding::Refuted, &negative).is_err(), "by the citation");
    free.hypotheses.truncate(3);
    let negative = functions(&free, inverse(-1), &far(-1), &at(q(2, 1)));
    assert_eq!(judge(&free, Finding::Refuted, &negative), Ok(()));
    free.context.vars[K].upper = bound(q(-3, 1), false);
    let low = functions(&free, inverse(-1), &far(-1), &at(q(2, 1)));
    assert!(judge(&free, Finding::Refuted, &low).is_err(), "by the range of k");
    // A citation does not narrow the domain: x > 0 has to be a given.
    let mut wide = goal.clone();
    wide.hypotheses[0].given = false;
    let f = functions(&wide, inverse(1), &far(1), &at(q(2, 1)));
    assert!(judge(&wide, Finding::Refuted, &f).is_err());
    // An expression that is undefined somewhere is no function on the domain.
    let mut bare = plain();
    bare.context.vars[Y].of = Some(X);
    bare.when = vec![relation(var(Y), Rel::Ne, var(X))];
    let pole = functions(&bare, vec![(Y, div(number(1, 1), var(X)))], &[], &at(q(2, 1)));
    assert!(judge(&bare, Finding::Refuted, &pole).is_err());
    let smooth = functions(&bare, vec![(Y, add(var(X), number(1, 1)))], &[], &at(q(2, 1)));
    assert_eq!(judge(&bare, Finding::Refuted, &smooth), Ok(()));
}

#[test]
fn hypotheses_are_consistent_where_the_condition_of_the_claim_holds() {
    // The claim of the hyperbola speaks of x > 1 alone.
    let goal = hyperbola();
    let f = |x: Q| functions(&goal, inverse(1), &far(1), &at(x));
    assert_eq!(judge(&goal, Finding::Consistent, &f(q(2, 1))), Ok(()));
    assert!(judge(&goal, Finding::Consistent, &f(q(1, 1))).is_err());
    // It does not matter what is claimed, which may be a limit.
    let l = limit(var(K), Target::Finite(number(5, 1)), Approach::PlusInf);
    let limiting = Goal { conclusion: Conclusion::Link(Link::Limit(l)), ..goal.clone() };
    let f = |x: Q| functions(&limiting, inverse(1), &far(1), &at(x));
    assert_eq!(judge(&limiting, Finding::Consistent, &f(q(2, 1))), Ok(()));
    assert!(judge(&limiting, Finding::Consistent, &f(q(1, 1))).is_err());
    let nowhere = Goal { when: vec![relation(var(X), Rel::Lt, number(0, 1))], ..goal.clone() };
    let f = |x: Q| functions(&nowhere, inverse(1), &far(1), &at(x));
    assert!(
        [q(2, 1), q(-2, 1)]
            .into_iter()
            .all(|x| { judge(&nowhere, Finding::Consistent, &f(x)).is_err() })
    );
}

#[test]
fn a_function_keeps_within_both_ends_of_its_range() {
    // y = a, of which nothing is said but that it is a function of x in a range.
    let judge_at = |lower, upper, a| {
        let mut goal = with_function();
        (goal.context.vars[Y].lower, goal.context.vars[Y].upper) = (lower, upper);
        goal.when = vec![relation(var(Y), Rel::Eq, var(Y))];
        let f = functions(&goal, vec![(Y, number(a, 1))], &[], &at(q(0, 1)));
        judge(&goal, Finding::Consistent, &f).is_ok()
    };
    let end = |strict| bound(q(0, 1), strict);
    for strict in [true, false] {
        let above = [-1, 0, 1].map(|a| judge_at(end(strict), None, a));
        assert_eq!(above, [false, !strict, true]);
        let below = [-1, 0, 1].map(|a| judge_at(None, end(strict), a));
        assert_eq!(below, [true, !strict, false]);
    }
}

#[test]
fn a_premised_limit_is_proved_from_each_side() {
    let goal = hyperbola();
    let f = functions(&goal, inverse(1), &far(1), &at(q(2, 1)));
    let with = |change: &dyn Fn(&mut Vec<Vec<SideProof>>)| {
        let mut changed = f.clone();
        change(&mut changed.premises[2].1);
        judge(&goal, Finding::Refuted, &changed)
    };
    assert_eq!(with(&|_| ()), Ok(()));
    assert_eq!(with(&|l| l.clear()), Err(Rejection::CaseCount(1, 0)));
    assert_eq!(with(&|l| l[0].clear()), Err(Rejection::OutsideDomain));
    assert!(with(&|l| l[0][0].num = n(0)).is_err());
    assert!(with(&|l| *l[0][0].along = nothing()).is_err());
    assert!(with(&|l| l[0][0].germ.inside.clear()).is_err(), "the narrowed domain is owed");
    let twice = |l: &mut Vec<Vec<SideProof>>| {
        let first = l[0].clone();
        l.push(first);
    };
    assert_eq!(with(&twice), Err(Rejection::CaseCount(1, 2)));
    // Another limit is not reached, and neither is 0 by a constant.
    let mut other = goal.clone();
    let l = limit(var(K), Target::Finite(number(1, 1)), Approach::PlusInf);
    other.hypotheses[2] = given(vec![Link::Limit(l)]);
    let f = functions(&other, inverse(1), &far(1), &at(q(2, 1)));
    assert!(judge(&other, Finding::Refuted, &f).is_err());
}

#[test]
fn values_are_functions_of_the_variable_and_closed_constants() {
    let goal = hyperbola();
    let base = functions(&goal, inverse(1), &far(1), &at(q(2, 1)));
    let with = |values: Vec<(usize, Expr)>| {
        let changed = Functions { values, ..base.clone() };
        judge(&goal, Finding::Refuted, &changed)
    };
    let k = || (K, div(number(1, 1), var(X)));
    assert_eq!(with(inverse(1)), Ok(()));
    for values in [
        vec![k()],
        vec![(C, number(1, 1)), k()],
        vec![k(), (C, number(1, 1)), (9, number(1, 1))],
        vec![k(), (C, add(number(1, 1), mul(number(0, 1), var(X))))],
        vec![(K, div(var(C), var(X))), (C, number(1, 1))],
        vec![(K, Expr::Let(0)), (C, number(1, 1))],
        vec![(X, number(2, 1)), k(), (C, number(1, 1))],
    ] {
        assert_eq!(with(values.clone()), Err(Rejection::NotConstant), "{values:?}");
    }
    let mut short = base.clone();
    short.ranges.pop();
    assert!(matches!(judge(&goal, Finding::Refuted, &short), Err(Rejection::CaseCount(..))));
    let mut short = base.clone();
    short.premises.pop();
    assert!(matches!(judge(&goal, Finding::Refuted, &short), Err(Rejection::CaseCount(..))));
    for i in 0..2 {
        let mut unproved = base.clone();
        unproved.ranges[i] = one_is_zero(7);
        assert!(judge(&goal, Finding::Refuted, &unproved).is_err(), "range {i}");
    }
    for i in 0..4 {
        let mut unproved = base.clone();
        unproved.premises[i].0 = one_is_zero(7);
        assert!(judge(&goal, Finding::Refuted, &unproved).is_err(), "premise {i}");
    }
    // A document has no values of its own.
    let mut valued = plain();
    valued.context.values = vec![(X, number(1, 1))];
    valued.when = vec![relation(number(1, 1), Rel::Lt, number(0, 1))];
    let evidence = Evidence::Contradiction(Proof::Assume { formula: 0, cases: Vec::new() });
    assert_eq!(judged(&valued, Finding::Proved, evidence), Err(Rejection::OtherGoal));
}

#[test]
fn nothing_is_passed_to_a_limit_for_explicit_functions() {
    let goal = hyperbola();
    let base = functions(&goal, inverse(1), &far(1), &at(q(2, 1)));
    let pass = || Proof::Pass {
        germ: base.premises[2].1[0][0].germ.clone(),
        atom: equal(n(0)),
        along: nothing().into(),
        then: nothing().into(),
    };
    let with = |change: &dyn Fn(&mut Functions)| {
        let mut changed = base.clone();
        change(&mut changed);
        judge(&goal, Finding::Refuted, &changed)
    };
    let refused = Err(Rejection::OutsideDomain);
    assert_eq!(with(&|f| f.ranges[0] = pass()), refused);
    assert_eq!(with(&|f| f.premises[1].0 = pass()), refused);
    assert_eq!(with(&|f| f.premises[2].0 = pass()), refused, "nor where the premise is a limit");
    assert_eq!(with(&|f| *f.premises[2].1[0][0].at_zero = pass()), refused);
    assert_eq!(with(&|f| *f.premises[2].1[0][0].along = pass()), refused);
    assert_eq!(with(&|f| f.premises[2].1[0][0].germ.inside[0].proof = pass()), refused);
}

#[test]
fn a_limit_in_another_variable_is_none_of_the_functions() {
    let mut goal = hyperbola();
    let by_c = Limit { expr: var(C), to: Target::PlusInf, var: C, at: Approach::PlusInf };
    goal.hypotheses.push(given(vec![Link::Limit(by_c)]));
    assert_eq!(premised(&goal).count(), 2);
    let base = hyperbola();
    let mut f = functions(&base, inverse(1), &far(1), &at(q(2, 1)));
    f.premises.push((nothing(), vec![Vec::new()]));
    assert_eq!(judge(&goal, Finding::Refuted, &f), Err(Rejection::NotConstant));
    // Where limits are spoken of, no point is a witness.
    let point = Point {
        generator: None,
        values: vec![(X, vec![q(2, 1)]), (K, vec![q(1, 2)]), (C, vec![q(1, 1)])],
    };
    let evidence = Evidence::Model(Model::Point(point));
    assert_eq!(judged(&goal, Finding::Refuted, evidence), Err(Rejection::NeedsFunctions));
}

/// A proof that a premise without undefined parts, or a range, holds: nothing of it is left to fail.
fn evident() -> Proof {
    Proof::Assume { formula: 1, cases: Vec::new() }
}

#[test]
fn premised_limits_are_about_the_variable_of_the_functions() {
    // k·a = 1 for all a > 0 and k → 1/3 as a → ∞ cannot both hold; at a = 3 alone they would.
    let (a, k) = (X, 2);
    let mut goal = plain();
    goal.context.vars.push(symbol("k", Some(a)));
    goal.context.vars[a].lower = bound(q(0, 1), true);
    let third = || number(1, 3);
    let product = Expr::Mul(Expr::Var(k).into(), Expr::Var(a).into());
    let limit =
        Limit { expr: Expr::Var(k), to: Target::Finite(third()), var: a, at: Approach::PlusInf };
    goal.hypotheses =
        vec![given(vec![link(product, Rel::Eq, Expr::int(1))]), given(vec![Link::Limit(limit)])];
    let germ = Germ {
        power: 1,
        side: Side { var: a, at: None, above: true },
        radius: (n(1), n(1)),
        positive: Box::new(Proof::Assume { formula: 1, cases: vec![nothing(), nothing()] }),
        inside: Vec::new(),
    };
    let proof = SideProof {
        germ,
        sense: Ordering::Equal,
        upper: None,
        num: n(1),
        den: n(3),
        order: 0,
        along: Box::new(evident()),
        at_zero: Box::new(Proof::Assume { formula: 1, cases: vec![nothing()] }),
    };
    let functions = Functions {
        var: Y,
        values: vec![(a, Expr::int(3)), (k, third())],
        ranges: vec![evident(), evident()],
        premises: vec![(evident(), Vec::new()), (evident(), vec![vec![proof]])],
        failure: Failure::At(Point { generator: None, values: vec![(Y, vec![q(0, 1)])] }),
    };
    let evidence = Evidence::Model(Model::Functions(functions.into()));
    assert_eq!(judged(&goal, Finding::Refuted, evidence), Err(Rejection::NotConstant));
}
