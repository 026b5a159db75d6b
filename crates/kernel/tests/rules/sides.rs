//! Sides of a limit, and how its ends are compared.

use std::cmp::Ordering;

use kane_kernel::{
    Approach, Conclusion, Evidence, Expr, Finding, Goal, Link, Poly, Rejection, Rel, Side, Target,
    constants, differs, misses, scope, sides,
};

use crate::oracle::inside;
use crate::support::{
    X, bound, div, found, germ, judged, limit, n, number, plain, plenty, q, relation, side,
    side_proof, var,
};

/// x → 0 on its way there, as a goal.
pub(crate) fn approaching(at: Approach) -> Goal {
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
        let binding = s.binding((1, 1), &plenty()).expect("small");
        for x in [q(3, 4), q(1, 4), q(-11, 12), q(4, 1), q(-4, 1), q(1, 2)] {
            let at = |v: usize| if v == X { x.clone() } else { q(1, 4) };
            assert_eq!(inside(std::slice::from_ref(&binding), &at), x == moved, "{s:?} {x}");
        }
    }
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
    for (num, den) in [(5, 3), (7, 3), (-5, -3), (-7, -3), (-6, 3)] {
        assert_eq!(closes(n(num), n(den), 0, &two), Ok(false), "{num}/{den}");
    }
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
    let cases = differs(&scope, &e, (&n(2), &n(1)), Ordering::Equal).expect("small");
    let at = |x: i64| cases.iter().filter(|case| inside(case, &|_| q(x, 1))).count();
    assert_eq!([0, 3, 2, -3].map(at), [1, 0, 1, 1]);
}

#[test]
fn what_is_bounded_is_undefined_or_beyond_where_it_differs() {
    // 6/x, and x/(x − 2), against num/den, where den is not 0.
    let goal = Goal { when: vec![relation(var(X), Rel::Ne, number(0, 1))], ..plain() };
    let scope = scope(&goal, plenty()).expect("small");
    let shifted = || Expr::Sub(var(X).into(), number(2, 1).into());
    let (six, moved) = (div(number(6, 1), var(X)), div(var(X), shifted()));
    let value = |e: usize, x: i64| match (e, x) {
        (0, x) if x != 0 => Some(q(6, x)),
        (1, x) if x != 2 => Some(q(x, x - 2)),
        _ => None,
    };
    for (num, den) in (-3..4).flat_map(|num| [-2, -1, 1, 3].map(|den| (num, den))) {
        for (e, sense) in (0..2).flat_map(|e| [Ordering::Less, Ordering::Greater].map(|s| (e, s))) {
            let cases = differs(&scope, [&six, &moved][e], (&n(num), &n(den)), sense);
            for x in -7..8 {
                let found = cases.as_ref().expect("small").iter();
                let found = found.filter(|case| inside(case, &|_| q(x, 1))).count();
                let differs = value(e, x).is_none_or(|v| v.cmp(&q(num, den)) == sense.reverse());
                assert_eq!(found, usize::from(differs), "{e} at {x}, {num}/{den}, {sense:?}");
            }
        }
    }
}

#[test]
fn along_a_power_of_t_the_variable_moves_by_that_power() {
    for (s, moved) in [
        (side(Some(q(1, 2)), true), [q(3, 4), q(9, 16), q(33, 64)]),
        (side(Some(q(-2, 3)), false), [q(-11, 12), q(-35, 48), q(-131, 192)]),
        (side(None, true), [q(4, 1), q(16, 1), q(64, 1)]),
        (side(None, false), [q(-4, 1), q(-16, 1), q(-64, 1)]),
    ] {
        for (power, x) in (1..).zip(&moved) {
            let binding = s.binding((1, power), &plenty()).expect("small");
            for other in &moved {
                let at = |v: usize| if v == X { other.clone() } else { q(1, 4) };
                assert_eq!(
                    inside(std::slice::from_ref(&binding), &at),
                    x == other,
                    "{s:?} {power}"
                );
            }
        }
    }
}
