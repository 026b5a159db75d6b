//! Limits by bounds, and along powers of t: roots are what they are for.

use std::cmp::Ordering::{Equal, Greater, Less};

use kane_kernel::{
    Approach, Atom, Conclusion, Evidence, Expr, Failure, Finding, Functions, Germ, Goal, Limit,
    Link, Model, Poly, Proof, Rejection, Side, SideProof, State, Target, constants, scope,
};

use crate::support::{
    X, Y, add, at_least, bound, bounded, closing, distinct, equal, germ, given, judged, limit, mul,
    n, nothing, number, plenty, positive, q, side, sqrt, sub, symbol, term, times, var,
    with_function, x, y,
};

/// A limit claim about x and a function y of x between two numbers, if there are such.
fn tending(e: Expr, to: Target, at: Approach, ends: (Option<i64>, Option<i64>)) -> Goal {
    let mut goal = with_function();
    let end = |e: Option<i64>| e.and_then(|e| bound(q(e, 1), false));
    (goal.context.vars[Y].lower, goal.context.vars[Y].upper) = (end(ends.0), end(ends.1));
    goal.conclusion = Conclusion::Link(Link::Limit(limit(e, to, at)));
    goal
}

fn finite(v: i64) -> Target {
    Target::Finite(number(v, 1))
}

/// Proofs that are made in the state of constants of a limit claim.
fn within<T>(goal: &Goal, make: impl FnOnce(&State<'_, '_>, &Limit) -> T) -> T {
    let Conclusion::Link(Link::Limit(l)) = &goal.conclusion else {
        unreachable!("a limit");
    };
    let scope = scope(goal, plenty()).expect("small");
    make(&constants(&scope, goal, X).expect("small"), l)
}

/// What the kernel says of one side proof of a limit claim.
fn proved(goal: &Goal, proof: &SideProof) -> Result<(), Rejection> {
    judged(goal, Finding::Proved, Evidence::Limit(vec![proof.clone()]))
}

/// Where an atom stands.
fn place(state: &State<'_, '_>, atom: &Atom) -> usize {
    state.atoms.iter().position(|a| a == atom).expect("it is known")
}

/// The last formula, case by case.
fn cases(state: &State<'_, '_>, proof: &dyn Fn(&State<'_, '_>) -> Proof) -> Proof {
    let formula = state.formulas.len() - 1;
    let next = state.assume(formula).expect("the last one");
    Proof::Assume { formula, cases: next.iter().map(proof).collect() }
}

/// sqrt(±(x − a)) → 0, or sqrt(±x) → ∞, with x = a ± t^2m or ±1/t^2m: the root is t^m or 1/t^m.
fn root_of_side(s: &Side, m: u32) -> (Goal, SideProof) {
    let (inner, to, sign) = match (&s.at, s.above) {
        (Some(a), true) => (sub(var(X), Expr::Num(a.clone())), finite(0), 1),
        (Some(a), false) => (sub(Expr::Num(a.clone()), var(X)), finite(0), -1),
        (None, true) => (var(X), Target::PlusInf, 1),
        (None, false) => (Expr::Neg(var(X).into()), Target::PlusInf, 1),
    };
    let goal = tending(sqrt(inner), to, s.approach(), (None, None));
    let proof = within(&goal, |state, l| {
        let (root, t) = (Poly::var(2), Poly::var(state.scope.germ()));
        let h = Poly::power(state.scope.germ(), m);
        let germ = Germ { power: 2 * m, ..germ(state, s.clone()) };
        let binding = germ.side.binding((state.scope.germ(), 2 * m), &plenty()).expect("small");
        let finite = s.at.is_some();
        let (gap, parts) = match finite {
            true => (root.sub(&h), (h.clone(), n(1), 0)),
            false => (times(&root, &h).sub(&n(1)), (n(1), h.clone(), m)),
        };
        // What is undefined, or differs, is the last atom of a case.
        let close = |s: &State<'_, '_>| {
            let (last, small) = (s.atoms.len() - 1, place(s, &positive(t.clone())));
            let bound = place(s, &binding);
            if s.atoms[last] != distinct(gap.clone()) {
                // −inner is positive: −inner + h² = 0, or −inner·h² + 1 = 0.
                let terms = match finite {
                    true => vec![term(1, n(1), vec![(last, 1)]), term(1, h.clone(), vec![])],
                    false => {
                        vec![term(1, n(1), vec![(last, 1), (small, 2 * m)]), term(1, n(1), vec![])]
                    }
                };
                return Proof::Positive { terms, cofactors: vec![(bound, n(sign))] };
            }
            // (root − h)²·(h + root) = 0, or (root·h − 1)²·(1 + root·h) = 0.
            let is_root = place(s, &at_least(root.clone()));
            let square = s.atoms.iter().position(|a| a.poly.degree(2) == 2).expect("it is known");
            let (one, other, scale) = match finite {
                true => (vec![(small, m)], vec![(is_root, 1)], n(1)),
                false => (vec![], vec![(small, m), (is_root, 1)], times(&h, &h)),
            };
            let terms = [one, other].map(|f| term(1, n(1), [vec![(last, 2)], f].concat()));
            let cofactors =
                vec![(square, times(&gap, &scale).neg()), (bound, times(&gap, &n(-sign)))];
            Proof::Positive { terms: terms.to_vec(), cofactors }
        };
        bounded(state, l, germ.clone(), parts, (Equal, &|s| cases(s, &close)))
    });
    (goal, proof)
}

fn all_sides() -> [Side; 5] {
    [
        side(Some(q(0, 1)), true),
        side(Some(q(3, 1)), true),
        side(Some(q(1, 1)), false),
        side(None, true),
        side(None, false),
    ]
}

#[test]
fn a_root_is_a_power_of_t_where_its_inside_is_an_even_one() {
    for (s, m) in all_sides().iter().flat_map(|s| [1, 2, 3].map(|m| (s, m))) {
        let (goal, proof) = root_of_side(s, m);
        assert_eq!(proved(&goal, &proof), Ok(()), "{s:?} {m}");
        for power in [0, 1, 2 * m - 1, 2 * m + 1, 2 * m + 2, u32::MAX] {
            let mut other = proof.clone();
            other.germ.power = power;
            let verdict = proved(&goal, &other);
            assert!(verdict.is_err(), "{s:?} {m} {power}");
            if power == 0 {
                assert_eq!(verdict, Err(Rejection::OutsideDomain));
            }
        }
    }
}

/// x·y → 0 as x → 0+ with y between −1 and 1, from −x and x; `k` is the denominator.
fn squeezed(k: i64) -> (Goal, SideProof) {
    let l = (mul(var(X), var(Y)), finite(0), Approach::Above(q(0, 1)));
    let goal = tending(l.0, l.1, l.2, (Some(-1), Some(1)));
    let proof = within(&goal, |state, l| {
        let t = Poly::var(state.scope.germ());
        let bound = |sign: i64, sense| {
            let germ = germ(state, side(Some(q(0, 1)), true));
            bounded(state, l, germ, (t.scale(&(sign * k).into()), n(k), 0), (sense, &closing))
        };
        SideProof { upper: Some(bound(1, Less).into()), ..bound(-1, Greater) }
    });
    (goal, proof)
}

#[test]
fn what_lies_between_two_bounds_tends_to_what_both_tend_to() {
    for k in [1, -1] {
        let (goal, proof) = squeezed(k);
        assert_eq!(proved(&goal, &proof), Ok(()), "{k}");
        let upper = || proof.upper.clone().expect("two bounds");
        let with = |change: &dyn Fn(&mut SideProof)| {
            let mut changed = proof.clone();
            change(&mut changed);
            proved(&goal, &changed)
        };
        let above = |change: &dyn Fn(&mut SideProof)| {
            with(&|p| change(p.upper.as_mut().expect("two bounds")))
        };
        let wrong = Err(Rejection::WrongEvidence);
        // Both, each once, the lower one first.
        assert_eq!(with(&|p| p.upper = None), wrong);
        assert_eq!(proved(&goal, &upper()), wrong);
        let lower = SideProof { upper: None, ..proof.clone() };
        assert_eq!(with(&|p| p.upper = Some(lower.clone().into())), wrong);
        let swapped = SideProof { upper: Some(lower.clone().into()), ..*upper() };
        assert_eq!(proved(&goal, &swapped), wrong);
        let twice = SideProof { upper: Some(upper()), ..*upper() };
        assert_eq!(proved(&goal, &twice), wrong);
        assert_eq!(above(&|p| p.upper = Some(upper())), wrong);
        assert_eq!(with(&|p| p.sense = Equal), wrong);
        assert_eq!(above(&|p| p.sense = Equal), wrong);
        // Each with a proof of its own, on the same side.
        let changes: [&dyn Fn(&mut SideProof); 7] = [
            &|p| p.num = n(5),
            &|p| p.den = n(0),
            &|p| p.order = 1,
            &|p| *p.along = nothing(),
            &|p| *p.at_zero = nothing(),
            &|p| *p.germ.positive = nothing(),
            &|p| p.germ.power = 0,
        ];
        for change in changes {
            assert!(with(change).is_err() && above(change).is_err());
        }
        assert_eq!(above(&|p| p.germ.side.above = false), Err(Rejection::OutsideDomain));
        assert_eq!(above(&|p| p.germ.side.at = Some(q(1, 1))), Err(Rejection::OutsideDomain));
        assert_eq!(above(&|p| p.germ.side.at = None), Err(Rejection::OutsideDomain));
    }
}

#[test]
fn one_bound_of_a_function_is_no_limit_of_it() {
    // −1 ≤ y ≤ 1, and y is arbitrary: it tends to neither.
    for (end, sense) in [(-1, Greater), (1, Less)] {
        let at = Approach::Above(q(0, 1));
        let goal = tending(var(Y), finite(end), at, (Some(-1), Some(1)));
        let proof = within(&goal, |state, l| {
            let germ = germ(state, side(Some(q(0, 1)), true));
            bounded(state, l, germ, (n(end), n(1), 0), (sense, &closing))
        });
        assert_eq!(proved(&goal, &proof), Err(Rejection::WrongEvidence));
        let twice = SideProof { upper: Some(proof.clone().into()), ..proof.clone() };
        assert_eq!(proved(&goal, &twice), Err(Rejection::WrongEvidence));
        for other in [Less, Equal, Greater] {
            let named = SideProof { sense: other, ..proof.clone() };
            assert!(proved(&goal, &named).is_err());
        }
    }
}

/// ±(x + y) → ±∞ as x → ∞ with y ≥ 0, by ends with a factor k: bounds from x, or from −x, which is
/// true and shows nothing.
fn far(up: bool, from_x: bool, k: i64) -> (SideProof, Goal) {
    let sum = || add(var(X), var(Y));
    let e = if up { sum() } else { Expr::Neg(sum().into()) };
    // The bound tends up if it is one of x and e does, or of −x and e does not.
    let (to, sign) = if up == from_x { (Target::PlusInf, 1) } else { (Target::MinusInf, -1) };
    let goal = tending(e, to, Approach::PlusInf, (Some(0), None));
    let proof = within(&goal, |state, l| {
        let t = Poly::var(state.scope.germ());
        let along = |s: &State<'_, '_>| {
            cases(s, &|s| {
                // With the bound's opposite W: W + t²·y + t·(x·t − 1) is 0, or −2t.
                let last = s.atoms.len() - 1;
                let square = Poly::constant((k * k).into());
                let mut terms = vec![
                    term(1, n(1), vec![(last, 1)]),
                    term(k * k, t.clone(), vec![(place(s, &at_least(y())), 1)]),
                ];
                if !from_x {
                    let small = place(s, &positive(t.clone()));
                    terms.push(term(2 * k * k, n(1), vec![(small, 1)]));
                }
                let bound = place(s, &equal(times(&x(), &t).sub(&n(1))));
                Proof::Positive { terms, cofactors: vec![(bound, times(&square, &t))] }
            })
        };
        let parts = (n(sign * k), t.scale(&k.into()), 1);
        let sense = if up { Greater } else { Less };
        bounded(state, l, germ(state, side(None, true)), parts, (sense, &along))
    });
    (proof, goal)
}

#[test]
fn an_infinite_limit_needs_the_bound_that_tends_to_it() {
    for (up, k) in [(true, 1), (false, 1), (true, -1), (false, -3)] {
        let (proof, goal) = far(up, true, k);
        assert_eq!(proved(&goal, &proof), Ok(()), "{up} {k}");
        for sense in [Less, Equal, Greater].into_iter().filter(|s| *s != proof.sense) {
            assert!(proved(&goal, &SideProof { sense, ..proof.clone() }).is_err());
        }
        let between = |sense| {
            let other = SideProof { sense, ..proof.clone() };
            proved(&goal, &SideProof { upper: Some(other.into()), ..proof.clone() })
        };
        assert_eq!(
            [Less, Equal, Greater].map(between),
            [(); 3].map(|()| Err(Rejection::WrongEvidence))
        );
        // x + y ≥ −x, which tends to −∞, and −x − y ≤ x, which tends to ∞.
        let (nothing, false_goal) = far(up, false, k);
        assert_eq!(proved(&false_goal, &nothing), Err(Rejection::WrongEvidence), "{up} {k}");
    }
}

#[test]
fn a_germ_that_stands_still_shows_no_limit() {
    // With x = 0 + t⁰ it would be shown that x → 1 as x → 0+.
    let goal = tending(var(X), finite(1), Approach::Above(q(0, 1)), (None, None));
    let proof = within(&goal, |state, l| {
        let along = |s: &State<'_, '_>| {
            let mut there = s.clone();
            there.atoms[2] = equal(x().sub(&n(1)));
            cases(&there, &closing)
        };
        let germ = germ(state, side(Some(q(0, 1)), true));
        let proof = bounded(state, l, germ.clone(), (n(1), n(1), 0), (Equal, &along));
        SideProof { germ: Germ { power: 0, ..germ }, ..proof }
    });
    assert_eq!(proved(&goal, &proof), Err(Rejection::OutsideDomain));
}

#[test]
fn a_bound_may_be_one_of_a_premised_limit() {
    // x + y → c as x → 0+ if y does: y ≤ x + y ≤ y + 2x.
    let goal = |premised: Approach| {
        let e = add(var(X), var(Y));
        let mut goal = tending(e, Target::Finite(var(2)), Approach::Above(q(0, 1)), (None, None));
        goal.context.vars.push(symbol("c", None));
        let tends = limit(var(Y), Target::Finite(var(2)), premised);
        goal.hypotheses = vec![given(vec![Link::Limit(tends)])];
        goal
    };
    let right = goal(Approach::Above(q(0, 1)));
    let proof = within(&right, |state, l| {
        let (t, z) = (Poly::var(state.scope.germ()), Poly::var(state.scope.germ() + 1));
        let bound = |num: Poly, sense| {
            let germ = germ(state, side(Some(q(0, 1)), true));
            bounded(state, l, germ, (num, n(1), 0), (sense, &closing))
        };
        let upper = bound(z.add(&t).add(&t), Less);
        SideProof { upper: Some(upper.into()), ..bound(z, Greater) }
    });
    assert_eq!(proved(&right, &proof), Ok(()));
    for elsewhere in [Approach::Below(q(0, 1)), Approach::Above(q(1, 1)), Approach::PlusInf] {
        assert!(proved(&goal(elsewhere), &proof).is_err());
    }
}

#[test]
fn a_limit_is_refuted_by_another_one_and_not_by_a_bound() {
    let judge = |claimed: i64, target: i64, proof: SideProof| {
        let (mut goal, _) = root_of_side(&side(Some(q(0, 1)), true), 1);
        let Conclusion::Link(Link::Limit(l)) = &mut goal.conclusion else {
            unreachable!("a limit");
        };
        l.to = finite(claimed);
        let functions = Functions {
            var: X,
            values: Vec::new(),
            ranges: Vec::new(),
            premises: Vec::new(),
            failure: Failure::Limit { link: 0, target: finite(target), proof, apart: None },
        };
        judged(&goal, Finding::Refuted, Evidence::Model(Model::Functions(functions.into())))
    };
    let (goal, proof) = root_of_side(&side(Some(q(0, 1)), true), 1);
    assert_eq!(judge(1, 0, proof.clone()), Ok(()));
    assert!(judge(0, 0, proof).is_err(), "it is the limit");
    // sqrt(x) ≥ 0 − 1, which tends to −1.
    let mut lower = goal.clone();
    let Conclusion::Link(Link::Limit(l)) = &mut lower.conclusion else {
        unreachable!("a limit");
    };
    l.to = finite(-1);
    let proof = within(&lower, |state, l| {
        let germ = Germ { power: 2, ..germ(state, side(Some(q(0, 1)), true)) };
        let t = Poly::var(state.scope.germ());
        let along = |s: &State<'_, '_>| {
            cases(s, &|s| {
                // −x + t² + (x − t²) = 0, or (−root − 1) + root + 1 = 0.
                let last = s.atoms.len() - 1;
                let undefined = s.atoms[last] == positive(x().neg());
                let (square, cofactors) = match undefined {
                    true => (term(1, t.clone(), vec![]), vec![(2, n(1))]),
                    false => (term(1, n(1), vec![(place(s, &at_least(Poly::var(2))), 1)]), vec![]),
                };
                let mut terms = vec![term(1, n(1), vec![(last, 1)]), square];
                terms.extend((!undefined).then(|| term(1, n(1), vec![])));
                Proof::Positive { terms, cofactors }
            })
        };
        bounded(state, l, germ, (n(-1), n(1), 0), (Greater, &along))
    });
    assert_eq!(judge(0, -1, proof), Err(Rejection::WrongEvidence));
}
