//! Limits: sides, germs, what is owed, and what is left at t = 0.

use kane_kernel::{
    Approach, Atom, Conclusion, Context, Evidence, Expr, Finding, Fuel, Germ, Goal, Hypothesis,
    Inside, Limit, Link, Place, Poly, Proof, Rejection, Rel, Sentence, Side, SideProof, State,
    Target, Term, constants, differs, inside_goal, inside_state, misses, owed, premises, scope,
    sides,
};

use crate::oracle::inside;
use crate::support::{
    Q, X, Y, add, at_least, bound, cited, closing, distinct, div, equal, found, germ, given,
    judged, limit, link, minus_one, mul, n, nothing, number, one_is_zero, plain, plenty, positive,
    q, relation, side, side_proof, symbol, term, var, with_function, x,
};

/// 1/x as x → ∞, as a goal, and its proof with x = 1/t.
fn tends_to_zero() -> (Goal, SideProof) {
    let expr = Expr::Div(Expr::int(1).into(), Expr::Var(X).into());
    let to = Target::Finite(Expr::int(0));
    let limit = Limit { expr, to, var: X, at: Approach::PlusInf };
    let goal = Goal { conclusion: Conclusion::Link(Link::Limit(limit)), ..plain() };
    let t = 2;
    let split = |formula, cases| Box::new(Proof::Assume { formula, cases });
    // Formulas along the germ: `when`, then the failure; at t = 0 and for the radius alike.
    let germ = Germ {
        side: Side { var: X, at: None, above: true },
        radius: (n(1), n(1)),
        positive: split(1, vec![minus_one(0), minus_one(0)]),
        inside: Vec::new(),
    };
    // Atoms: t > 0, 1 − t > 0, x·t = 1; then x ≠ 0 and 1 − t·x ≠ 0, or x = 0.
    let gap = n(1).sub(&x().mul(&Poly::var(t), &Fuel::new(10)).expect("small"));
    let pole = Proof::Positive {
        terms: vec![term(1, n(1), Vec::new())],
        cofactors: vec![(2, n(1)), (3, Poly::var(t).neg())],
    };
    let differs =
        Proof::Positive { terms: vec![term(1, n(1), vec![(4, 2)])], cofactors: vec![(2, gap)] };
    let proof = SideProof {
        germ,
        num: Poly::var(t),
        den: n(1),
        order: 0,
        along: split(1, vec![differs, pole]),
        at_zero: split(1, vec![one_is_zero(0)]),
    };
    (goal, proof)
}

#[test]
fn a_limit_is_proved_along_its_germ_and_at_its_end() {
    let (goal, proof) = tends_to_zero();
    let limit = |proof: SideProof| judged(&goal, Finding::Proved, Evidence::Limit(vec![proof]));
    let with = |change: &dyn Fn(&mut SideProof)| {
        let mut changed = proof.clone();
        change(&mut changed);
        limit(changed)
    };
    assert_eq!(with(&|_| ()), Ok(()));
    assert!(with(&|p| p.germ.side.above = false).is_err());
    assert!(with(&|p| p.germ.side.at = Some(q(0, 1))).is_err());
    assert!(with(&|p| p.germ.radius.0 = n(-1)).is_err());
    assert!(with(&|p| p.germ.radius.1 = x()).is_err());
    assert!(with(&|p| *p.germ.positive = nothing()).is_err());
    let inside = || Inside { values: Vec::new(), proof: nothing() };
    assert!(with(&|p| p.germ.inside.push(inside())).is_err());
    assert!(with(&|p| p.num = n(1)).is_err());
    assert!(with(&|p| p.den = n(2)).is_err());
    assert!(with(&|p| p.order = 1).is_err());
    assert!(with(&|p| *p.along = nothing()).is_err());
    assert!(with(&|p| *p.at_zero = nothing()).is_err());
    assert!(judged(&goal, Finding::Proved, Evidence::Limit(Vec::new())).is_err());
}

#[test]
fn a_limit_is_vacuous_only_if_its_own_side_is_not_reached() {
    // x → 0 as x → 0+ from a premise about x.
    let limit = Limit {
        expr: Expr::Var(X),
        to: Target::Finite(Expr::int(0)),
        var: X,
        at: Approach::Above(q(0, 1)),
    };
    let goal = |rel| Goal {
        hypotheses: vec![given(vec![link(Expr::Var(X), rel, Expr::int(5))])],
        conclusion: Conclusion::Link(Link::Limit(limit.clone())),
        ..plain()
    };
    let vacuous = |rel, at: i64, atom: Atom, terms: Vec<Term>, cofactor: i64| {
        let germ = Germ {
            side: Side { var: X, at: Some(q(at, 1)), above: true },
            radius: (n(1), n(1)),
            positive: Box::new(Proof::Assume {
                formula: 2,
                cases: vec![minus_one(0), minus_one(0)],
            }),
            inside: Vec::new(),
        };
        let sum = Proof::Positive { terms, cofactors: vec![(2, n(cofactor))] };
        let along = Box::new(Proof::Assume { formula: 0, cases: vec![sum] });
        let then = Box::new(one_is_zero(0));
        let proof = Proof::Pass { germ, atom, along, then };
        judged(&goal(rel), Finding::Vacuous, Evidence::Contradiction(proof))
    };
    // With x > 5 the side is not reached: (x − 5) + (1 − t) + 4 − (x − t) = 0.
    let reached = || {
        vec![term(1, n(1), vec![(4, 1)]), term(1, n(1), vec![(1, 1)]), term(4, n(1), Vec::new())]
    };
    assert_eq!(vacuous(Rel::Gt, 0, equal(n(1)), reached(), -1), Ok(()));
    assert!(vacuous(Rel::Gt, 0, distinct(n(0)), reached(), -1).is_err());
    assert!(vacuous(Rel::Gt, 0, equal(x()), reached(), -1).is_err());
    assert!(vacuous(Rel::Gt, 0, equal(n(0)), reached(), -1).is_err());
    assert!(vacuous(Rel::Gt, 0, equal(n(1)), reached(), 1).is_err());
    assert!(vacuous(Rel::Gt, 1, equal(n(1)), reached(), -1).is_err());
    // With x < 5 it is, whatever happens beyond 7: t + (5 − x) + 2 + (x − t − 7) = 0.
    let beyond =
        vec![term(1, n(1), vec![(0, 1)]), term(1, n(1), vec![(4, 1)]), term(2, n(1), Vec::new())];
    assert!(vacuous(Rel::Lt, 7, equal(n(1)), beyond, 1).is_err());
}

#[test]
fn a_limit_is_not_taken_for_the_function_along_the_germ() {
    // f = x for all x and f → 0 as x → 0+ contradict nothing. Along the germ z is f itself, and a
    // passage there would add what holds of its limit.
    let (t, z) = (Poly::var(2), Poly::var(3));
    let f = Expr::Var(Y);
    let same = link(f.clone(), Rel::Eq, Expr::Var(X));
    let at = Approach::Above(q(0, 1));
    let to = Target::Finite(Expr::int(0));
    let limit = Link::Limit(Limit { expr: f, to, var: X, at });
    let goal = Goal {
        context: Context {
            vars: vec![symbol("x", None), symbol("f", Some(X))],
            ..Context::default()
        },
        hypotheses: vec![given(vec![same]), given(vec![limit])],
        ..plain()
    };
    let germ = || Germ {
        side: Side { var: X, at: Some(q(0, 1)), above: true },
        radius: (n(1), n(1)),
        positive: Box::new(Proof::Assume { formula: 4, cases: vec![minus_one(0), minus_one(0)] }),
        // With x for f the given holds along the germ.
        inside: vec![Inside {
            values: vec![(Y, Expr::Var(X))],
            proof: Proof::Assume { formula: 3, cases: Vec::new() },
        }],
    };
    let with_f = |then| {
        let z_is_f = Proof::Assume { formula: 2, cases: vec![then] };
        Box::new(Proof::Assume { formula: 0, cases: vec![z_is_f] })
    };
    let gap = z.sub(&t);
    let along = Proof::Positive {
        terms: vec![term(1, n(1), vec![(4, 2)])],
        cofactors: vec![(3, gap.neg()), (5, gap.neg()), (6, gap.clone())],
    };
    let then = Proof::Positive {
        terms: vec![term(1, n(1), vec![(0, 1)])],
        cofactors: vec![(2, n(1)), (5, n(1)), (6, n(-1)), (4, n(-1))],
    };
    let inner =
        Proof::Pass { germ: germ(), atom: equal(gap), along: with_f(along), then: with_f(then) };
    let absurd = equal(n(1));
    let proof = Proof::Pass {
        germ: germ(),
        atom: absurd,
        along: inner.into(),
        then: one_is_zero(0).into(),
    };
    let verdict = judged(&goal, Finding::Proved, Evidence::Contradiction(proof));
    assert_eq!(verdict, Err(Rejection::OutsideDomain));
}

/// x → 0 on its way there, as a goal.
fn approaching(at: Approach) -> Goal {
    let l = limit(var(X), Target::Finite(number(0, 1)), at);
    Goal { conclusion: Conclusion::Link(Link::Limit(l)), ..plain() }
}

#[test]
fn sides_are_those_that_the_declared_range_reaches() {
    let ends = [None, Some((0, true)), Some((0, false)), Some((2, true)), Some((2, false))];
    let end = |e: Option<(i64, bool)>| e.and_then(|(v, strict)| bound(q(v, 1), strict));
    for (lower, upper) in ends.iter().flat_map(|l| ends.iter().map(move |u| (*l, *u))) {
        if lower.zip(upper).is_some_and(|(l, u)| l.0 >= u.0) {
            continue;
        }
        let mut goal = plain();
        (goal.context.vars[X].lower, goal.context.vars[X].upper) = (end(lower), end(upper));
        let scope = scope(&goal, plenty()).expect("small");
        let here = |at: Approach| sides(&scope, &limit(var(X), Target::PlusInf, at));
        // Whether points as near as one likes lie within the range.
        let near = |a: i64, step: i64| {
            let p = q(a, 1) + q(step, 1000);
            lower.is_none_or(|l| p > q(l.0, 1)) && upper.is_none_or(|u| p < q(u.0, 1))
        };
        for a in -1..4 {
            let wanted = |above: &bool| near(a, if *above { 1 } else { -1 });
            let of = |directions: &[bool]| -> Vec<Side> {
                directions.iter().filter(|d| wanted(d)).map(|d| side(Some(q(a, 1)), *d)).collect()
            };
            assert_eq!(here(Approach::To(q(a, 1))), of(&[true, false]), "{lower:?} {upper:?} {a}");
            assert_eq!(here(Approach::Above(q(a, 1))), of(&[true]));
            assert_eq!(here(Approach::Below(q(a, 1))), of(&[false]));
        }
        let far = |above: bool, open: bool| if open { vec![side(None, above)] } else { Vec::new() };
        assert_eq!(here(Approach::PlusInf), far(true, upper.is_none()));
        assert_eq!(here(Approach::MinusInf), far(false, lower.is_none()));
        assert!(!Side { var: 9, at: None, above: true }.is_inside(&scope), "no such symbol");
    }
}

#[test]
fn a_side_says_how_its_variable_moves() {
    for (s, approach, moved) in [
        (side(Some(q(1, 2)), true), Approach::Above(q(1, 2)), q(3, 4)),
        (side(Some(q(1, 2)), false), Approach::Below(q(1, 2)), q(1, 4)),
        (side(Some(q(-2, 3)), false), Approach::Below(q(-2, 3)), q(-11, 12)),
        (side(None, true), Approach::PlusInf, q(4, 1)),
        (side(None, false), Approach::MinusInf, q(-4, 1)),
    ] {
        assert_eq!(s.approach(), approach);
        let binding = s.binding(1, &plenty()).expect("small");
        for x in [q(3, 4), q(1, 4), q(-11, 12), q(4, 1), q(-4, 1), q(1, 2)] {
            let at = |v: usize| if v == X { x.clone() } else { q(1, 4) };
            assert_eq!(inside(std::slice::from_ref(&binding), &at), x == moved, "{s:?} {x}");
        }
    }
}

/// x, a function f of x, and a constant c, with premised limits: f → 1/c from above and −f → 7 from
/// below as x → 0; f → x and, under a condition on x, f → 2 from above; c·f → ∞.
fn premised() -> Goal {
    let mut goal = with_function();
    goal.context.vars.push(symbol("c", None));
    let at = || Approach::Above(q(0, 1));
    let f = || var(Y);
    let tends = |e, to, at| Link::Limit(limit(e, Target::Finite(to), at));
    let varied = Sentence {
        when: vec![relation(var(X), Rel::Gt, number(0, 1))],
        links: vec![tends(f(), number(2, 1), at())],
    };
    goal.hypotheses = vec![
        given(vec![tends(f(), div(number(1, 1), var(2)), at())]),
        given(vec![tends(Expr::Neg(f().into()), number(7, 1), Approach::Below(q(0, 1)))]),
        given(vec![tends(f(), var(X), at())]),
        Hypothesis { sentence: varied, given: true },
        given(vec![Link::Limit(limit(f(), Target::PlusInf, at()))]),
    ];
    goal
}

#[test]
fn a_limit_stands_for_its_value_at_a_point_and_for_its_function_along_its_side() {
    let goal = premised();
    let scope = scope(&goal, plenty()).expect("small");
    let z = scope.germ() + 1;
    assert_eq!(scope.germ(), 3);
    // x = 1, f = 3, c = 2, and a value for each z.
    let holds = |place, i: usize, value: Q| {
        let at = |v: usize| match v {
            0 => q(1, 1),
            1 => q(3, 1),
            2 => q(2, 1),
            v if v == z + i => value.clone(),
            _ => q(77, 1),
        };
        let formulas = premises(&scope, &goal, place).expect("small");
        assert_eq!(formulas.len(), 11);
        formulas[5 + i].iter().any(|case| inside(case, &at))
    };
    let (above, below) = (side(Some(q(0, 1)), true), side(Some(q(0, 1)), false));
    for place in [Place::Point, Place::Constants(X)] {
        for (i, value) in [(0, q(1, 2)), (1, q(7, 1))] {
            assert!(holds(place, i, value), "{place:?} {i}");
            assert!(!holds(place, i, q(5, 1)), "{place:?} {i}");
        }
        assert!((2..5).all(|i| holds(place, i, q(5, 1))), "nothing is said of the others");
    }
    assert!(holds(Place::Germ(&above), 0, q(3, 1)) && !holds(Place::Germ(&above), 0, q(1, 2)));
    assert!((1..5).all(|i| holds(Place::Germ(&above), i, q(5, 1))));
    assert!(holds(Place::Germ(&below), 1, q(-3, 1)) && !holds(Place::Germ(&below), 1, q(7, 1)));
    assert!([0, 2, 3, 4].iter().all(|i| holds(Place::Germ(&below), *i, q(5, 1))));
}

#[test]
fn what_passes_to_the_limit_mentions_nothing_that_varies() {
    let goal = premised();
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let (t, z) = (scope.germ(), scope.germ() + 1);
    let along = germ(&state, side(Some(q(0, 1)), true));
    let left = |atom: Atom| state.at_zero(&along, &atom);
    let p = |v| Poly::var(v).add(&Poly::var(t)).sub(&n(4));
    assert_eq!(left(equal(p(2))), Ok(equal(Poly::var(2).sub(&n(4)))), "a constant");
    assert_eq!(left(at_least(p(z))), Ok(at_least(Poly::var(z).sub(&n(4)))), "a limit from here");
    assert_eq!(left(equal(Poly::var(t))), Ok(equal(n(0))));
    for v in [X, Y, z + 1, z + 2, z + 3, z + 4, z + 5] {
        assert_eq!(left(equal(p(v))), Err(Rejection::NotConstant), "{v}");
    }
    for atom in [positive(p(2)), distinct(p(2))] {
        assert_eq!(left(atom), Err(Rejection::NotAnEquation(0)), "t > 0, but 0 is not");
    }
    let below = germ(&state, side(Some(q(0, 1)), false));
    assert!(state.at_zero(&below, &equal(p(z + 1))).is_ok());
    assert_eq!(state.at_zero(&below, &equal(p(z))), Err(Rejection::NotConstant));
    assert!(state.is_constant(2, X) && !state.is_constant(X, X) && !state.is_constant(Y, X));
    assert!(!state.is_constant(t, X) && !state.is_constant(z, X) && state.is_constant(Y, 2));
}

#[test]
fn huge_powers_along_a_germ_take_no_room() {
    let goal = premised();
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let along = germ(&state, side(Some(q(0, 1)), true));
    let p = Poly::power(scope.germ(), u32::MAX).add(&n(3));
    assert_eq!(state.at_zero(&along, &equal(p)), Ok(equal(n(3))));
}

#[test]
fn ends_are_compared_at_the_order_that_the_target_needs() {
    let goal = approaching(Approach::PlusInf);
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let up = side(None, true);
    let t = |n| Poly::power(scope.germ(), n);
    let closes = |num: Poly, den: Poly, order, to: &Target| {
        let cases = misses(&state, &up, (&num, &den, order), to)?;
        let none = found(&state.with_cases(cases)).is_none();
        Ok::<bool, Rejection>(!none)
    };
    let two = Target::Finite(number(2, 1));
    assert_eq!(closes(n(6).add(&t(1)), n(3).sub(&t(2)), 0, &two), Ok(true));
    assert_eq!(closes(n(5), n(3), 0, &two), Ok(false));
    assert_eq!(closes(t(1).scale(&2.into()), t(1), 0, &two), Ok(false), "0/0");
    assert_eq!(closes(n(0), n(0), 0, &two), Ok(false));
    assert_eq!(closes(n(6), n(3), 1, &two), Err(Rejection::WrongOrder));
    assert_eq!(closes(n(6), t(1).scale(&3.into()), 1, &two), Err(Rejection::WrongOrder));
    let undefined = Target::Finite(div(number(1, 1), number(0, 1)));
    assert_eq!(closes(n(6), n(3), 0, &undefined), Ok(false));
    let (plus, minus) = (Target::PlusInf, Target::MinusInf);
    for c in [2, -3] {
        let den = |k: u32| t(k).scale(&c.into()).add(&t(k + 1));
        for k in [1, 2] {
            for a in [5, -5] {
                let num = n(a).sub(&t(1));
                assert_eq!(closes(num.clone(), den(k), k, &plus), Ok(a * c > 0), "{a} {c} {k}");
                assert_eq!(closes(num, den(k), k, &minus), Ok(a * c < 0), "{a} {c} {k}");
            }
        }
        assert_eq!(
            closes(n(1), den(1), 2, &plus),
            Err(Rejection::WrongOrder),
            "a lower power is left"
        );
        assert_eq!(
            closes(n(c), n(1), 0, if c > 0 { &plus } else { &minus }),
            Err(Rejection::WrongOrder)
        );
        assert_eq!(closes(t(1), den(2), 2, &plus), Ok(false), "num vanishes");
    }
    assert_eq!(closes(n(1), n(0), 1, &plus), Err(Rejection::WrongOrder));
}

#[test]
fn along_a_germ_the_ranges_the_constants_and_the_binding_are_known() {
    let mut goal = with_function();
    goal.context.vars.push(symbol("c", None));
    goal.context.vars[X].lower = bound(q(-1, 1), true);
    goal.context.vars[Y].lower = bound(q(0, 1), false);
    goal.hypotheses = vec![given(vec![link(var(2), Rel::Gt, var(Y))])];
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let state = state.with(at_least(Poly::var(2).sub(&n(3)))).with(equal(x().sub(&n(50))));
    let mut along = germ(&state, side(Some(q(-1, 1)), true));
    along.radius = (Poly::var(2), n(8));
    along.positive = Box::new(closing(
        &state.with_cases(vec![vec![positive(Poly::var(2)).not()], vec![positive(n(8)).not()]]),
    ));
    let known = state.along(&along);
    assert_eq!(known.as_ref().err(), Some(&Rejection::CaseCount(1, 0)), "the given is owed");
    let known = state.along_unproved(&along).expect("a germ in the domain");
    let t = scope.germ();
    let holds = |x: Q, f: i64, c: i64, small: Q| {
        let at = |v: usize| match v {
            X => x.clone(),
            Y => q(f, 1),
            2 => q(c, 1),
            v if v == t => small.clone(),
            _ => q(77, 1),
        };
        inside(&known.atoms, &at)
            && known.formulas.iter().all(|f| f.iter().any(|case| inside(case, &at)))
    };
    assert!(holds(q(-3, 4), 2, 3, q(1, 4)));
    assert!(!holds(q(-3, 4), -1, 3, q(1, 4)), "the range of f");
    assert!(!holds(q(-3, 4), 2, 2, q(1, 4)), "what is known of c");
    assert!(!holds(q(-3, 4), 3, 3, q(1, 4)), "the premise");
    assert!(!holds(q(-1, 2), 2, 3, q(1, 2)), "t below the radius");
    assert!(!holds(q(-1, 1), 2, 3, q(0, 1)) && !holds(q(-5, 4), 2, 3, q(-1, 4)), "t > 0");
    assert!(!holds(q(-1, 2), 2, 3, q(1, 4)), "x = −1 + t");
    // The radius is made of constants, is positive, and the side is one of the domain.
    let with = |change: &dyn Fn(&mut Germ)| {
        let mut changed = along.clone();
        change(&mut changed);
        state.along_unproved(&changed).err()
    };
    assert_eq!(with(&|_| ()), None);
    assert_eq!(with(&|g| g.radius.0 = x()), Some(Rejection::NotConstant));
    assert_eq!(with(&|g| g.radius.1 = Poly::var(Y)), Some(Rejection::NotConstant));
    assert_eq!(with(&|g| g.radius.1 = Poly::var(t)), Some(Rejection::NotConstant));
    assert_eq!(with(&|g| g.side.above = false), Some(Rejection::OutsideDomain));
    assert!(with(&|g| g.radius.0 = n(-1)).is_some());
    assert!(with(&|g| g.radius.1 = Poly::var(2).neg()).is_some());
    assert!(with(&|g| g.radius.1 = n(0)).is_some());
    assert!(with(&|g| *g.positive = nothing()).is_some());
    // A symbol that is not mentioned keeps its range along the germ, if it is the limit variable.
    assert!(!holds(q(-2, 1), 2, 3, q(1, 4)));
}

#[test]
fn the_limit_variable_keeps_its_range_although_it_is_not_mentioned() {
    let mut goal = plain();
    goal.context.vars[X].upper = bound(q(5, 1), true);
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let known = state.along_unproved(&germ(&state, side(Some(q(9, 2)), true))).expect("within");
    let at = |v: usize| if v == X { q(21, 4) } else { q(3, 4) };
    assert!(!inside(&known.atoms, &at));
}

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
fn the_domain_is_narrowed_by_what_givens_say_of_the_variable_alone() {
    let goal = mixed();
    let scope = scope(&goal, plenty()).expect("small");
    let narrowed = |h: &Hypothesis| kane_kernel::narrowing(&scope, h, X).links;
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
    let state =
        kane_kernel::claim_state(&scope, goal, Finding::Proved).expect("a contradiction claim");
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
    let proof = question.ok().and_then(|s| found(&s)).unwrap_or_else(nothing);
    along.inside = vec![Inside { values, proof }];
    let proof = side_proof(&state, &l, along, (n(5), n(1), 0));
    let verdict = judged(&goal, Finding::Proved, Evidence::Limit(vec![proof]));
    assert_eq!(verdict, Err(Rejection::NotExplicit));
}

#[test]
fn a_limit_of_both_sides_has_a_proof_for_each() {
    let goal = approaching(Approach::To(q(0, 1)));
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let Conclusion::Link(Link::Limit(l)) = &goal.conclusion else {
        unreachable!("a limit");
    };
    let proof = |above: bool| {
        let t = Poly::var(scope.germ());
        let num = if above { t } else { t.neg() };
        side_proof(&state, l, germ(&state, side(Some(q(0, 1)), above)), (num, n(1), 0))
    };
    let judge = |proofs| judged(&goal, Finding::Proved, Evidence::Limit(proofs));
    assert_eq!(judge(vec![proof(true), proof(false)]), Ok(()));
    assert_eq!(judge(vec![proof(false), proof(true)]), Err(Rejection::OutsideDomain));
    assert_eq!(judge(vec![proof(true)]), Err(Rejection::OutsideDomain));
    assert_eq!(judge(vec![proof(true), proof(true)]), Err(Rejection::OutsideDomain));
    // A limit that no side reaches is not proved by no proof.
    let mut closed = goal.clone();
    closed.context.vars[X].lower = bound(q(1, 1), false);
    let evidence = Evidence::Limit(Vec::new());
    assert_eq!(judged(&closed, Finding::Proved, evidence), Err(Rejection::OutsideDomain));
}

#[test]
fn two_sides_differ_where_one_is_undefined_or_another() {
    let goal = Goal { when: vec![relation(var(X), Rel::Ne, number(0, 1))], ..plain() };
    let scope = scope(&goal, plenty()).expect("small");
    let e = div(number(6, 1), var(X));
    let cases = differs(&scope, &e, (&n(2), &n(1))).expect("small");
    let at = |x: i64| cases.iter().filter(|case| inside(case, &|_| q(x, 1))).count();
    assert_eq!([0, 3, 2, -3].map(at), [1, 0, 1, 1]);
}

#[test]
fn without_a_limit_nothing_is_passed() {
    // y = 1 at a point says nothing of other points.
    let goal = |links| Goal { hypotheses: vec![given(links)], ..plain() };
    let tends = Link::Limit(limit(var(X), Target::PlusInf, Approach::PlusInf));
    for (links, wanted) in [
        (vec![link(var(Y), Rel::Eq, number(1, 1))], kane_kernel::Passages::Nowhere),
        (vec![tends], kane_kernel::Passages::Anywhere),
    ] {
        let goal = goal(links);
        let scope = scope(&goal, plenty()).expect("small");
        let state = kane_kernel::point_state(&scope, &goal, None).expect("small");
        assert_eq!(state.passages, wanted);
        let state = constants(&scope, &goal, X).expect("small");
        assert_eq!(state.passages, kane_kernel::Passages::Along(X));
        let along = state.along_unproved(&germ(&state, side(None, true))).expect("in the domain");
        assert_eq!(along.passages, kane_kernel::Passages::Nowhere);
    }
}
