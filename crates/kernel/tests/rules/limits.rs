//! Limit proofs, and what holds along a germ and at its end.

use std::cmp::Ordering;

use kane_kernel::{
    Approach, Atom, Case, Conclusion, Context, Evidence, Expr, Finding, Germ, Goal, Hypothesis,
    Inside, Limit, Link, Model, Passages, Place, Point, Poly, Proof, Rejection, Rel, Sentence,
    Side, SideProof, Sign, Target, Term, constants, point_state, premises, scope,
};

use crate::oracle::inside;
use crate::support::{
    Q, X, Y, add, at_least, bound, cited, closing, distinct, div, equal, germ, given, judged,
    limit, link, minus_one, mul, n, nothing, number, one_is_zero, plain, plenty, positive, q,
    relation, side, sqrt, symbol, term, times, var, with_function, x,
};

/// A root of the limit that the function has not is to be known beside it.
#[test]
fn a_root_of_the_limit_alone_stands_beside_the_function_times_nothing() {
    let two = || sqrt(number(2, 1));
    let beside = |f: Expr, to: Expr| {
        let found = limit(f.clone(), Target::Finite(to.clone()), Approach::PlusInf);
        let conclusion = Conclusion::Link(Link::Limit(found.clone()));
        let goal = Goal { conclusion, ..plain() };
        let scope = scope(&goal, plenty()).expect("the goal is plain");
        let compared = found.compared(&scope).into_owned();
        let owned = add(f.clone(), mul(number(0, 1), to));
        assert!(compared == f || compared == owned, "{compared:?}");
        compared == owned
    };
    assert!(beside(var(X), two()));
    assert!(beside(sqrt(number(3, 1)), add(two(), number(1, 1))));
    assert!(!beside(mul(two(), var(X)), two()));
    assert!(!beside(var(X), number(2, 1)));
}

/// 1/x as x → ∞, as a goal, and its proof with x = 1/t.
fn tends_to_zero() -> (Goal, SideProof) {
    (reciprocal(), reciprocal_proof(0))
}

fn reciprocal() -> Goal {
    let expr = Expr::Div(Expr::int(1).into(), Expr::Var(X).into());
    let to = Target::Finite(Expr::int(0));
    let limit = Limit { expr, to, var: X, at: Approach::PlusInf };
    Goal { conclusion: Conclusion::Link(Link::Limit(limit)), ..plain() }
}

/// The proof in a state in which so many atoms speak of constants.
fn reciprocal_proof(known: usize) -> SideProof {
    let t = 2;
    let split = |formula, cases| Box::new(Proof::Assume { formula, cases });
    // Formulas along the germ: `when`, then the failure; at t = 0 and for the radius alike.
    let germ = Germ {
        power: 1,
        side: Side { var: X, at: None, above: true },
        radius: (n(1), n(1)),
        positive: split(1, vec![minus_one(known), minus_one(known)]),
        inside: Vec::new(),
    };
    // Atoms behind those: t > 0, 1 − t > 0, x·t = 1; then x ≠ 0 and 1 − t·x ≠ 0, or x = 0.
    let gap = n(1).sub(&times(&x(), &Poly::var(t)));
    let pole = Proof::Positive {
        terms: vec![term(1, n(1), Vec::new())],
        cofactors: vec![(known + 2, n(1)), (known + 3, Poly::var(t).neg())],
    };
    let differs = Proof::Positive {
        terms: vec![term(1, n(1), vec![(known + 4, 2)])],
        cofactors: vec![(known + 2, gap)],
    };
    SideProof {
        germ,
        num: Poly::var(t),
        den: n(1),
        order: 0,
        sense: Ordering::Equal,
        upper: None,
        along: split(1, vec![differs, pole]),
        at_zero: split(1, vec![one_is_zero(known)]),
    }
}

/// The three cases of a polynomial: that it is zero, positive, negative.
fn by_sign(poly: Poly, then: [Evidence; 3]) -> Evidence {
    let signs = [(false, Sign::Zero), (false, Sign::Positive), (true, Sign::Positive)];
    let case = |((opposite, sign), then)| Case { opposite, sign, then };
    Evidence::Split { poly, cases: signs.into_iter().zip(then).map(case).collect() }
}

#[test]
fn a_limit_is_proved_by_cases_of_constants_and_of_nothing_else() {
    let judge = |evidence: Evidence| judged(&reciprocal(), Finding::Proved, evidence);
    let shown = |known: usize| Evidence::Limit(vec![reciprocal_proof(known)]);
    let all = |known: usize| [shown(known), shown(known), shown(known)];
    assert_eq!(judge(by_sign(Poly::var(Y), all(1))), Ok(()));
    let [zero, positive, negative] = all(1);
    let twice = by_sign(Poly::var(Y).sub(&n(1)), all(2));
    assert_eq!(judge(by_sign(Poly::var(Y), [zero, twice, negative.clone()])), Ok(()));
    // what varies has no sign for all small t
    for varies in [x(), Poly::var(2), x().mul(&Poly::var(Y), &plenty()).expect("small")] {
        assert_eq!(judge(by_sign(varies, all(1))), Err(Rejection::NotConstant));
    }
    for left_out in 0..3 {
        let Evidence::Split { poly, mut cases } = by_sign(Poly::var(Y), all(1)) else {
            unreachable!("it is made so")
        };
        cases.remove(left_out);
        assert_eq!(judge(Evidence::Split { poly, cases }), Err(Rejection::SignLeftOut));
    }
    let empty = || Evidence::Limit(Vec::new());
    assert!(judge(by_sign(Poly::var(Y), [shown(1), empty(), shown(1)])).is_err());
    let model = Evidence::Model(Model::Point(Point::default()));
    let by_model = judge(by_sign(Poly::var(Y), [shown(1), positive, model]));
    assert_eq!(by_model, Err(Rejection::WrongEvidence));
    // the proof of another case has other atoms
    assert!(judge(by_sign(Poly::var(Y), [shown(1), shown(0), negative])).is_err());
}

#[test]
fn a_case_of_constants_that_cannot_be_needs_no_limit() {
    let judge = |evidence: Evidence| judged(&reciprocal(), Finding::Proved, evidence);
    let absurd = |proof: Proof| Evidence::Contradiction(proof);
    let shown = || Evidence::Limit(vec![reciprocal_proof(1)]);
    // 1 is neither zero nor negative
    let cases = |zero: Proof| [absurd(zero), shown(), absurd(minus_one(0))];
    assert_eq!(judge(by_sign(n(1), cases(one_is_zero(0)))), Ok(()));
    assert!(judge(by_sign(n(1), cases(nothing()))).is_err());
    let sum = |cases| by_sign(Poly::var(Y), cases);
    assert!(judge(sum([shown(), absurd(minus_one(0)), shown()])).is_err());
    // what is shown of all points is no limit
    assert_eq!(judge(absurd(one_is_zero(0))), Err(Rejection::WrongEvidence));
    for finding in [Finding::Refuted, Finding::Vacuous, Finding::Consistent] {
        let verdict = judged(&reciprocal(), finding, by_sign(n(1), [shown(), shown(), shown()]));
        assert_eq!(verdict, Err(Rejection::WrongEvidence), "{finding:?}");
    }
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
fn a_limit_proof_shows_that_the_limit_holds_and_nothing_else() {
    let (goal, proof) = tends_to_zero();
    for finding in [Finding::Refuted, Finding::IllDefined, Finding::Vacuous, Finding::Consistent] {
        let verdict = judged(&goal, finding, Evidence::Limit(vec![proof.clone()]));
        assert_eq!(verdict, Err(Rejection::WrongEvidence), "{finding:?}");
    }
}

#[test]
fn a_citation_is_known_where_it_is_defined_at_a_point_and_along_a_germ() {
    // c/c = 1 as a given says that c is not 0; as a citation it does not.
    let (c, above) = (|| var(Y), side(Some(q(0, 1)), true));
    let known = |given: bool| {
        let premise =
            Hypothesis { given, ..cited(vec![link(div(c(), c()), Rel::Eq, number(1, 1))]) };
        let goal = Goal { hypotheses: vec![premise], ..plain() };
        let scope = scope(&goal, plenty()).expect("small");
        [Place::Point, Place::Constants(X), Place::Germ(&above)].map(|place| {
            let formulas = premises(&scope, &goal, place).expect("small");
            let holds = |value: i64| formulas[0].iter().any(|case| inside(case, &|_| q(value, 1)));
            (holds(0), holds(5))
        })
    };
    assert_eq!(known(true), [(false, true); 3]);
    assert_eq!(known(false), [(true, true); 3]);
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
            power: 1,
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
        power: 1,
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
fn a_root_of_constants_passes_to_the_limit_and_one_that_varies_does_not() {
    let mut goal = premised();
    let root = |v: usize| Expr::Sqrt(var(v).into());
    goal.when = [2, X, Y].map(|v| relation(root(v), Rel::Ge, number(0, 1))).to_vec();
    let scope = scope(&goal, plenty()).expect("small");
    let state = constants(&scope, &goal, X).expect("small");
    let along = germ(&state, side(Some(q(0, 1)), true));
    let roots: Vec<usize> = (goal.context.vars.len()..scope.germ()).collect();
    assert_eq!(roots.len(), 3);
    for v in roots {
        let p = Poly::var(v).add(&Poly::var(scope.germ())).sub(&n(4));
        let fixed = scope.root(v) == Some(&root(2));
        let left = state.at_zero(&along, &equal(p));
        let end = fixed.then(|| equal(Poly::var(v).sub(&n(4)))).ok_or(Rejection::NotConstant);
        assert_eq!(left, end, "{v}");
        // another question may number its roots in another way: a radius has none
        let wide = Germ { radius: (Poly::var(v), n(1)), ..along.clone() };
        assert_eq!(state.along_unproved(&wide).err(), Some(Rejection::NotConstant), "{v}");
    }
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
    *along.positive = closing(
        &state.with_cases(vec![vec![positive(Poly::var(2)).not()], vec![positive(n(8)).not()]]),
    );
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
    // A radius of 0 is none, although it is not negative.
    let not_negative =
        closing(&state.with_cases(vec![vec![positive(n(0))], vec![positive(n(8)).not()]]));
    let zero = |g: &mut Germ| {
        g.radius.0 = n(0);
        *g.positive = not_negative.clone();
    };
    assert!(with(&zero).is_some());
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
    let holds = |t: Q| inside(&known.atoms, &|v| if v == X { q(9, 2) + &t } else { t.clone() });
    assert!(holds(q(1, 4)));
    assert!(!holds(q(3, 4)), "x < 5");
    assert!(!holds(q(0, 1)), "t > 0");
}

#[test]
fn without_a_limit_nothing_is_passed() {
    // y = 1 at a point says nothing of other points.
    let goal = |links| Goal { hypotheses: vec![given(links)], ..plain() };
    let tends = Link::Limit(limit(var(X), Target::PlusInf, Approach::PlusInf));
    for (links, wanted) in [
        (vec![link(var(Y), Rel::Eq, number(1, 1))], Passages::Nowhere),
        (vec![tends], Passages::Anywhere),
    ] {
        let goal = goal(links);
        let scope = scope(&goal, plenty()).expect("small");
        let state = point_state(&scope, &goal, None).expect("small");
        assert_eq!(state.passages, wanted);
        let state = constants(&scope, &goal, X).expect("small");
        assert_eq!(state.passages, Passages::Along(X));
        let along = state.along_unproved(&germ(&state, side(None, true))).expect("in the domain");
        assert_eq!(along.passages, Passages::Nowhere);
    }
}
