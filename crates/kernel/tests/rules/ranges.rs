//! Ranges: what is said of constants, what narrows the domain, and what a germ owes.

use kane_kernel::{
    Approach, Conclusion, Definition, Evidence, Expr, Finding, Germ, Goal, Hypothesis, Inside,
    Limit, Link, Poly, Proof, Rejection, Rel, Sentence, Side, State, Target, claim_state,
    constants, inside_goal, inside_state, narrowing, owed, scope,
};

use crate::oracle::inside;
use crate::sides::approaching;
use crate::support::{
    X, Y, add, at_least, bound, cited, closing, div, found, germ, given, judged, limit, link, mul,
    n, nothing, number, plain, plenty, q, relation, side, side_proof, symbol, var, with_function,
};

/// Constants, items that vary, conditions of both kinds.
fn mixed() -> Goal {
    let mut goal = with_function();
    goal.context.vars.push(symbol("c", None));
    let list = || vec![link(var(Y), Rel::Eq, var(X)), link(var(2), Rel::Gt, number(1, 1))];
    let under = |e| Sentence { when: vec![relation(e, Rel::Gt, number(0, 1))], links: list() };
    goal.hypotheses = vec![
        given(list()),
        cited(list()),
        cited(vec![link(var(2), Rel::Lt, number(9, 1))]),
        Hypothesis { sentence: under(var(X)), given: true },
        Hypothesis { sentence: under(var(2)), given: true },
        given(vec![link(var(X), Rel::Gt, number(0, 1)), link(var(Y), Rel::Gt, number(0, 1))]),
    ];
    goal.when =
        vec![relation(var(X), Rel::Gt, number(6, 1)), relation(var(2), Rel::Ne, number(3, 1))];
    goal
}

#[test]
fn of_constants_a_given_says_its_items_and_a_citation_all_or_nothing() {
    let goal = mixed();
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    // At x = 1, f = 2, where nothing that varies holds.
    let holds = |i: usize, c: i64| {
        let at = |v: usize| if v == 2 { q(c, 1) } else { q(1 + i64::from(v == Y), 1) };
        state.formulas[i].iter().any(|case| inside(case, &at))
    };
    assert_eq!(state.formulas.len(), 7);
    assert_eq!([2, 1].map(|c| holds(0, c)), [true, false]);
    assert_eq!([2, 1].map(|c| holds(1, c)), [true, true]);
    assert_eq!([2, 9].map(|c| holds(2, c)), [true, false]);
    assert_eq!([2, 1].map(|c| holds(3, c)), [true, true]);
    assert_eq!([2, 1, -1].map(|c| holds(4, c)), [true, false, true]);
    assert_eq!([2, 1].map(|c| holds(5, c)), [true, true]);
    assert_eq!([2, 3].map(|c| holds(6, c)), [true, false], "its own conditions");
    let mut ranged = goal.clone();
    for v in [X, Y, 2] {
        ranged.context.vars[v].lower = bound(q(1, 1), false);
    }
    let scope = kane_kernel::scope(&ranged, plenty()).expect("small");
    let state = constants(&scope, &ranged, X).expect("small");
    assert_eq!(state.atoms, vec![at_least(Poly::var(2).sub(&n(1)))], "the ranges of constants");
    let along = state.along_unproved(&germ(&state, side(None, true))).expect("in the domain");
    let last = along.formulas.last().expect("its own conditions");
    let at = |c: i64| move |v: usize| if v == 2 { q(c, 1) } else { q(1, 1) };
    assert!(last.iter().any(|case| inside(case, &at(2))), "what varies is left out");
    assert!(!last.iter().any(|case| inside(case, &at(3))));
}

#[test]
fn a_given_that_varies_only_by_a_definition_is_owed() {
    let mut goal = plain();
    goal.context.lets.push(Definition { name: "u".into(), body: add(var(X), number(1, 1)) });
    goal.hypotheses = vec![given(vec![link(Expr::Let(0), Rel::Gt, number(0, 1))])];
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    assert_eq!(owed(&state, &side(None, true)).len(), 1);
    assert!(state.formulas[0].iter().any(Vec::is_empty), "nothing is said of constants");
}

#[test]
fn definitions_that_name_each_other_twice_are_walked_once() {
    let mut goal = plain();
    let twice = |i: usize| if i == 0 { var(Y) } else { add(Expr::Let(i - 1), Expr::Let(i - 1)) };
    goal.context.lets =
        (0..64).map(|i| Definition { name: format!("u{i}"), body: twice(i) }).collect();
    goal.hypotheses = vec![given(vec![link(Expr::Let(63), Rel::Gt, number(0, 1))])];
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    assert!(owed(&state, &side(None, true)).is_empty(), "2^63 y does not depend on x");
}

#[test]
fn the_domain_is_narrowed_by_what_givens_say_of_the_variable_alone() {
    let goal = mixed();
    let scope = scope(&goal, plenty()).expect("small");
    let narrowed = |h: &Hypothesis| narrowing(&scope, h, X).links;
    let of_x = || link(var(X), Rel::Gt, number(0, 1));
    assert_eq!(narrowed(&goal.hypotheses[0]), Vec::new());
    assert_eq!(narrowed(&goal.hypotheses[5]), vec![of_x()], "the item about x alone");
    assert_eq!(narrowed(&cited(vec![of_x()])), Vec::new(), "not by a citation");
    let under = |e: Expr, links| Hypothesis {
        sentence: Sentence { when: vec![relation(e, Rel::Gt, number(0, 1))], links },
        given: true,
    };
    let of_c = || link(var(2), Rel::Gt, number(0, 1));
    assert_eq!(narrowed(&given(vec![of_c()])), Vec::new());
    assert_eq!(narrowed(&under(var(X), vec![of_c()])), vec![of_c()], "under a condition on x");
    assert_eq!(narrowed(&under(var(2), vec![of_x(), of_c()])), vec![of_x()]);
    assert_eq!(narrowed(&under(var(Y), vec![of_x()])), Vec::new(), "under one on a function");
    let both = link(var(X), Rel::Gt, var(Y));
    assert_eq!(narrowed(&given(vec![both])), Vec::new());
}

#[test]
fn a_germ_owes_every_given_that_depends_on_its_variable() {
    let mut goal = mixed();
    goal.context.vars.push(symbol("u", None));
    let behind =
        |e: Expr| Sentence { when: Vec::new(), links: vec![link(e, Rel::Gt, number(0, 1))] };
    let under = Sentence {
        when: vec![relation(var(Y), Rel::Gt, number(0, 1))],
        links: vec![link(var(2), Rel::Gt, number(0, 1))],
    };
    goal.behind = vec![behind(var(2)), behind(var(X)), behind(var(Y)), under.clone()];
    goal.conclusion = approaching(Approach::Above(q(0, 1))).conclusion;
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let s = |i: usize| &goal.hypotheses[i].sentence;
    let rest = || vec![&goal.behind[1], &goal.behind[2], &under];
    let cited = || vec![s(0), s(3), s(4), s(5)];
    let (above, below) = (side(Some(q(0, 1)), true), side(Some(q(0, 1)), false));
    for here in [&above, &below] {
        assert_eq!(owed(&state, here), [cited(), rest()].concat());
    }
    let reaching = State { reaching: true, ..state.clone() };
    assert_eq!(owed(&reaching, &above), rest(), "it is assumed that they let it through");
    assert_eq!(
        owed(&reaching, &below),
        [cited(), rest()].concat(),
        "but from the claimed side alone"
    );
    assert!(reaching.reaches(&above) && !reaching.reaches(&below) && !state.reaches(&above));
    assert!(owed(&state, &Side { var: 3, at: None, above: true }).is_empty());
    let of_c = owed(&state, &Side { var: 2, at: None, above: true });
    assert_eq!(of_c, vec![s(0), s(3), s(4), &goal.behind[0], &under]);
}

#[test]
fn a_range_is_shown_with_functions_of_the_variable_alone() {
    let mut goal = mixed();
    goal.context.vars.push(symbol("h", Some(2)));
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let above = side(Some(q(0, 1)), true);
    let question = |values: &[(usize, Expr)]| {
        inside_goal(&state, &above, &goal.hypotheses[0].sentence, values)
    };
    let asked = question(&[(Y, var(X))]).expect("a function of x in x");
    assert!(asked.behind.is_empty());
    assert_eq!(asked.when, vec![goal.when[1].clone()], "conditions on constants");
    assert_eq!(asked.hypotheses.len(), goal.hypotheses.len());
    assert!(asked.hypotheses[0].sentence.links == vec![link(var(2), Rel::Gt, number(1, 1))]);
    assert!(asked.hypotheses[1].sentence.links.is_empty());
    assert!(question(&[]).is_ok() && question(&[(Y, add(var(2), var(3)))]).is_ok());
    let wrong = |values: &[(usize, Expr)]| {
        assert_eq!(question(values), Err(Rejection::WrongEvidence), "{values:?}");
    };
    wrong(&[(X, number(1, 1))]);
    wrong(&[(2, number(1, 1))]);
    wrong(&[(3, number(1, 1))]);
    wrong(&[(9, number(1, 1))]);
    wrong(&[(Y, var(Y))]);
    wrong(&[(Y, var(9))]);
    wrong(&[(Y, Expr::Let(0))]);
    wrong(&[(Y, Expr::Deriv(var(X).into(), Y))]);
    wrong(&[(Y, var(X)), (Y, number(0, 1))]);
    // The question along the germ: with f = x the list holds where c > 1, with f = 1 it does not.
    let closes = |goal: &Goal| {
        let inner = kane_kernel::scope(goal, plenty()).expect("small");
        let along = germ(&state, above.clone());
        found(&inside_state(&state, &along, &inner, goal).expect("small")).is_some()
    };
    assert!(closes(&asked));
    assert!(!closes(&question(&[(Y, number(1, 1))]).expect("explicit")));
    assert!(
        !closes(&question(&[(Y, div(number(1, 1), number(0, 1)))]).expect("explicit")),
        "undefined"
    );
    assert!(!closes(&question(&[]).expect("explicit")), "for any f");
    // A function keeps within its declared range.
    let mut bounded = goal.clone();
    bounded.context.vars[Y].upper = bound(q(-1, 1), false);
    let scope = kane_kernel::scope(&bounded, plenty()).expect("small");
    let state = constants(&scope, &bounded, X).expect("small");
    let asked = inside_goal(&state, &above, &bounded.hypotheses[0].sentence, &[(Y, var(X))]);
    assert!(!closes(&asked.expect("explicit")));
}

/// «k < 1 wherever −1 < x < 1», cited without its given.
fn low() -> (Goal, Limit) {
    let mut goal = with_function();
    let near = vec![link(number(-1, 1), Rel::Lt, var(X)), link(var(X), Rel::Lt, number(1, 1))];
    goal.hypotheses = vec![cited(vec![link(var(Y), Rel::Lt, number(1, 1))])];
    goal.behind = vec![Sentence { when: Vec::new(), links: near }];
    let l = limit(var(Y), Target::Finite(number(5, 1)), Approach::Above(q(0, 1)));
    goal.hypotheses.push(given(vec![Link::Limit(l.clone())]));
    (goal, l)
}

/// Passes k ≤ 1 to a limit where k → 5, on a side.
fn passed(
    goal: &Goal,
    at: Side,
    inside: &dyn Fn(&State<'_, '_>, &Germ) -> Vec<Inside>,
) -> Result<(), Rejection> {
    let scope = scope(goal, plenty()).expect("small");
    let state = claim_state(&scope, goal, Finding::Proved).expect("a contradiction claim");
    let mut along = germ(&state, at);
    along.inside = inside(&state, &along);
    let atom = at_least(n(1).sub(&Poly::var(scope.germ() + 1)));
    let there = state.along_unproved(&along).expect("in the domain").with(atom.not());
    let end = state.at_zero(&along, &atom).expect("a premised limit");
    let (along_proof, then) = (closing(&there), closing(&state.with(end)));
    let proof = Proof::Pass { germ: along, atom, along: along_proof.into(), then: then.into() };
    judged(goal, Finding::Proved, Evidence::Contradiction(proof))
}

#[test]
fn nothing_is_passed_to_a_limit_where_a_range_is_shown() {
    let (goal, l) = low();
    let scope = scope(&goal, plenty()).expect("small");
    let state = claim_state(&scope, &goal, Finding::Proved).expect("a contradiction claim");
    assert!(state.passages.allow(X));
    let along = germ(&state, side(Some(q(0, 1)), true));
    // The question has no limits among its premises; even with one the function has a value in it.
    let values = [(Y, var(X))];
    let mut asked = inside_goal(&state, &along.side, &goal.behind[0], &values).expect("explicit");
    asked.hypotheses.push(given(vec![Link::Limit(l)]));
    let inner = kane_kernel::scope(&asked, plenty()).expect("small");
    let there = inside_state(&state, &along, &inner, &asked).expect("small");
    assert!(!there.passages.allow(X) && !there.passages.allow(Y));
}

#[test]
fn a_citation_is_used_only_in_the_range_of_the_givens_behind_it() {
    let (mut goal, mut l) = low();
    let shown = |state: &State<'_, '_>, along: &Germ| {
        let given = &state.goal.behind[0];
        let asked = inside_goal(state, &along.side, given, &[]).expect("without functions");
        let inner = scope(&asked, plenty()).expect("small");
        let question = inside_state(state, along, &inner, &asked).expect("small");
        vec![Inside { values: Vec::new(), proof: found(&question).unwrap_or_else(nothing) }]
    };
    let above = || side(Some(q(0, 1)), true);
    assert_eq!(passed(&goal, above(), &shown), Ok(()), "near 0 it holds");
    let none = |_: &State<'_, '_>, _: &Germ| Vec::new();
    assert_eq!(passed(&goal, above(), &none), Err(Rejection::CaseCount(1, 0)));
    let twice = |s: &State<'_, '_>, g: &Germ| [shown(s, g), shown(s, g)].concat();
    assert_eq!(passed(&goal, above(), &twice), Err(Rejection::CaseCount(1, 2)));
    let empty = |_: &State<'_, '_>, _: &Germ| vec![Inside { values: Vec::new(), proof: nothing() }];
    assert!(passed(&goal, above(), &empty).is_err());
    // Far away the given behind it does not hold, whatever is cited.
    l.at = Approach::PlusInf;
    goal.hypotheses[1] = given(vec![Link::Limit(l)]);
    for inside in [&shown as &dyn Fn(&State<'_, '_>, &Germ) -> Vec<Inside>, &none, &empty] {
        assert!(passed(&goal, side(None, true), inside).is_err());
    }
}

#[test]
fn a_function_of_x_is_none_of_a_constant_when_a_range_is_shown() {
    // For every function k of x, d(k·c, c) = k: so the given holds where k = x < 0, and nowhere
    // near 0+. With x − c for k it would, if k varied with c.
    let mut goal = plain();
    goal.context.vars.push(symbol("k", Some(X)));
    let k = || var(2);
    let slope = Expr::Deriv(mul(k(), var(Y)).into(), Y);
    let law = vec![
        link(slope, Rel::Eq, add(mul(number(2, 1), k()), Expr::Neg(var(X).into()))),
        link(k(), Rel::Lt, number(0, 1)),
    ];
    goal.behind = vec![Sentence { when: Vec::new(), links: law }];
    goal.hypotheses = vec![
        cited(vec![link(var(X), Rel::Lt, number(0, 1))]),
        given(vec![link(var(Y), Rel::Eq, number(1, 1))]),
    ];
    let l = limit(var(X), Target::Finite(number(5, 1)), Approach::Above(q(0, 1)));
    goal.conclusion = Conclusion::Link(Link::Limit(l.clone()));
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let mut along = germ(&state, side(Some(q(0, 1)), true));
    let values = vec![(2, add(Expr::Neg(var(Y).into()), var(X)))];
    let asked = inside_goal(&state, &along.side, &goal.behind[0], &values).expect("explicit");
    let inner = kane_kernel::scope(&asked, plenty()).expect("small");
    let question = inside_state(&state, &along, &inner, &asked);
    let proof = question.map_or_else(|_| nothing(), |s| closing(&s));
    along.inside = vec![Inside { values, proof }];
    let proof = side_proof(&state, &l, along, (n(5), n(1), 0));
    let verdict = judged(&goal, Finding::Proved, Evidence::Limit(vec![proof]));
    assert_eq!(verdict, Err(Rejection::NotExplicit));
}
