//! Points as witnesses: rational ones, and those with one algebraic number.

use kane_kernel::{Conclusion, Evidence, Finding, Goal, Model, Point, Rejection, Rel};
use num_bigint::BigInt;

use crate::support::{
    Q, X, Y, add, bound, div, given, judged, link, mul, number, plain, pow, q, relation, root,
    sqrt, sub, var,
};

fn at(goal: &Goal, finding: Finding, values: Vec<(usize, Vec<Q>)>) -> Result<(), Rejection> {
    let point = Point { generator: None, values };
    judged(goal, finding, Evidence::Model(Model::Point(point)))
}

fn plane(a: Q, b: Q) -> Vec<(usize, Vec<Q>)> {
    vec![(X, vec![a]), (Y, vec![b])]
}

#[test]
fn a_point_satisfies_every_range_and_every_formula() {
    let mut goal = Goal {
        hypotheses: vec![
            given(vec![link(var(X), Rel::Lt, var(Y))]),
            given(vec![link(var(Y), Rel::Ne, number(3, 1))]),
        ],
        when: vec![relation(var(Y), Rel::Le, number(4, 1))],
        ..plain()
    };
    goal.context.vars[X].lower = bound(q(1, 2), true);
    let judge = |a, b| at(&goal, Finding::Refuted, plane(a, b));
    assert_eq!(judge(q(1, 1), q(7, 2)), Ok(()));
    assert_eq!(judge(q(1, 2), q(7, 2)), Err(Rejection::NotAModel(None)), "the range of x");
    assert_eq!(judge(q(4, 1), q(7, 2)), Err(Rejection::NotAModel(Some(0))));
    assert_eq!(judge(q(1, 1), q(3, 1)), Err(Rejection::NotAModel(Some(1))));
    assert_eq!(judge(q(1, 1), q(5, 1)), Err(Rejection::NotAModel(Some(2))), "its own conditions");
    let only = vec![(Y, vec![q(2, 1)])];
    assert_eq!(
        at(&goal, Finding::Refuted, only),
        Err(Rejection::NotAModel(None)),
        "x has no value"
    );
    assert_eq!(at(&goal, Finding::Consistent, plane(q(1, 1), q(2, 1))), Ok(()));
    assert_eq!(at(&goal, Finding::Vacuous, plane(q(1, 1), q(2, 1))), Err(Rejection::WrongEvidence));
    assert_eq!(at(&goal, Finding::Proved, plane(q(1, 1), q(2, 1))), Err(Rejection::WrongEvidence));
}

#[test]
fn a_claim_fails_by_being_false_or_by_being_undefined() {
    // 1/x ≥ y
    let r = relation(div(number(1, 1), var(X)), Rel::Ge, var(Y));
    let goal = Goal { conclusion: Conclusion::Link(kane_kernel::Link::Relation(r)), ..plain() };
    let judge = |finding, a| at(&goal, finding, plane(q(a, 1), q(1, 1)));
    let table =
        [(Finding::Refuted, [false, true, false]), (Finding::IllDefined, [true, false, false])];
    for (finding, wanted) in table {
        assert_eq!([0, 2, 1].map(|a| judge(finding, a).is_ok()), wanted, "{finding:?}");
    }
    assert_eq!(judge(Finding::Proved, 2), Err(Rejection::WrongEvidence));
}

#[test]
fn a_sentence_does_not_follow_where_it_is_not_true() {
    // Not implied: 1/x ≥ y when y ≥ 0.
    let r = link(div(number(1, 1), var(X)), Rel::Ge, var(Y));
    let when = vec![relation(var(Y), Rel::Ge, number(0, 1))];
    let sentence = kane_kernel::Sentence { when, links: vec![r] };
    let goal = Goal { conclusion: Conclusion::NotImplied(sentence), ..plain() };
    let judge = |a, b| at(&goal, Finding::Proved, plane(q(a, 1), q(b, 1))).is_ok();
    assert!(judge(2, 1), "false");
    assert!(judge(0, 1), "undefined");
    assert!(!judge(1, 1), "true");
    assert!(!judge(2, -1) && !judge(0, -1), "nothing is said");
    assert_eq!(at(&goal, Finding::Refuted, plane(q(2, 1), q(1, 1))), Err(Rejection::WrongEvidence));
}

#[test]
fn a_root_has_a_value_of_its_own() {
    // √x = y can hold at (4, 2), with the variable 2 for the root.
    let goal = Goal { when: vec![relation(sqrt(var(X)), Rel::Eq, var(Y))], ..plain() };
    let judge = |a, b, s| {
        let values = vec![(X, vec![q(a, 1)]), (Y, vec![q(b, 1)]), (2, vec![q(s, 1)])];
        at(&goal, Finding::Refuted, values).is_ok()
    };
    assert!(judge(4, 2, 2));
    assert!(!judge(4, -2, -2), "the root is not negative");
    assert!(!judge(4, 3, 3), "its square is the radicand");
    assert!(!judge(4, 2, 3) && !judge(-4, 2, 2));
}

#[test]
fn an_algebraic_point_is_isolated_by_its_polynomial() {
    // x² = 2 and x > 0 can hold.
    let square = pow(var(X), 2);
    let goal = Goal {
        hypotheses: vec![given(vec![
            link(square, Rel::Eq, number(2, 1)),
            link(var(X), Rel::Gt, number(0, 1)),
        ])],
        ..plain()
    };
    let at = |poly: [i64; 3], lo, hi, values: Vec<Q>| {
        let poly = poly.map(BigInt::from).to_vec();
        let point = Point {
            generator: Some(kane_kernel::Root { poly, lo, hi }),
            values: vec![(X, values)],
        };
        judged(&goal, Finding::Refuted, Evidence::Model(Model::Point(point)))
    };
    let theta = || vec![q(0, 1), q(1, 1)];
    assert_eq!(at([-2, 0, 1], q(1, 1), q(2, 1), theta()), Ok(()));
    assert!(at([-3, 0, 1], q(1, 1), q(2, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(-2, 1), q(-1, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(-2, 1), q(2, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(3, 2), q(2, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(1, 1), q(2, 1), vec![q(0, 1), q(2, 1)]).is_err());
    // No value may redefine the algebraic number itself.
    let poly = vec![(-2).into(), 0.into(), 1.into()];
    let generator = Some(kane_kernel::Root { poly, lo: q(1, 1), hi: q(2, 1) });
    let values = vec![(X, vec![q(0, 1), q(2, 1)]), (usize::MAX, vec![q(0, 1), q(0, 1), q(1, 1)])];
    let point = Point { generator, values };
    assert!(judged(&goal, Finding::Refuted, Evidence::Model(Model::Point(point))).is_err());
}

/// Whether conditions on x and y hold for values in the only root of a polynomial in an interval.
fn algebraic(
    when: Vec<kane_kernel::Relation>,
    (poly, lo, hi): (&[i64], Q, Q),
    x: &[Q],
    y: &[Q],
) -> Result<(), Rejection> {
    let goal = Goal { when, ..plain() };
    let values = vec![(X, x.to_vec()), (Y, y.to_vec())];
    let point = Point { generator: Some(root(poly, lo, hi)), values };
    judged(&goal, Finding::Refuted, Evidence::Model(Model::Point(point)))
}

#[test]
fn signs_at_an_algebraic_number_are_exact() {
    let theta = || [q(0, 1), q(1, 1)];
    let holds = |e: kane_kernel::Expr, rel, poly: &[i64], y: &[Q]| {
        algebraic(vec![relation(e, rel, number(0, 1))], (poly, q(1, 1), q(2, 1)), &theta(), y)
    };
    // θ = √2, whichever sign its polynomial has, and ∛2, with an odd power at the top.
    for (poly, n) in
        [(&[-2, 0, 1][..], 2), (&[6, 0, -3], 2), (&[2, 0, 0, -1], 3), (&[-2, 0, 0, 1], 3)]
    {
        let two = || sub(pow(var(X), n), number(2, 1));
        assert_eq!(holds(two(), Rel::Eq, poly, &[]), Ok(()));
        assert!(holds(two(), Rel::Ne, poly, &[]).is_err());
        assert_eq!(holds(pow(var(X), n + 1), Rel::Gt, poly, &[]), Ok(()));
        assert!(holds(pow(var(X), n + 1), Rel::Lt, poly, &[]).is_err());
        let (below, above) =
            if n == 2 { ((1414, 1000), (1415, 1000)) } else { ((1259, 1000), (1260, 1000)) };
        let less = |(a, b)| sub(var(X), number(a, b));
        assert_eq!(holds(less(below), Rel::Gt, poly, &[]), Ok(()));
        assert_eq!(holds(less(above), Rel::Lt, poly, &[]), Ok(()));
        assert!(holds(less(below), Rel::Lt, poly, &[]).is_err());
        assert!(holds(less(above), Rel::Gt, poly, &[]).is_err());
        // y = 1/2 − θ/3, by itself and in a product.
        let y = [q(1, 2), q(-1, 3)];
        let rest = || add(mul(number(3, 1), var(Y)), sub(var(X), number(3, 2)));
        assert_eq!(holds(rest(), Rel::Eq, poly, &y), Ok(()));
        assert_eq!(holds(mul(rest(), var(Y)), Rel::Eq, poly, &y), Ok(()));
        assert!(holds(mul(rest(), var(Y)), Rel::Gt, poly, &y).is_err());
        assert_eq!(holds(sub(var(Y), var(X)), Rel::Lt, poly, &y), Ok(()));
        assert!(holds(sub(var(Y), var(X)), Rel::Gt, poly, &y).is_err());
    }
    // A rational root is one, too: θ = 3/2, the middle of the interval, and 5/4, a middle later on.
    for (poly, c) in [(&[-3, 2][..], q(3, 2)), (&[-5, 4], q(5, 4)), (&[7, -4], q(7, 4))] {
        let gap = || sub(var(X), kane_kernel::Expr::Num(c.clone()));
        assert_eq!(holds(gap(), Rel::Eq, poly, &[]), Ok(()));
        assert!(holds(gap(), Rel::Ne, poly, &[]).is_err());
        assert_eq!(
            holds(sub(mul(gap(), number(5, 1)), number(1, 100)), Rel::Lt, poly, &[]),
            Ok(())
        );
    }
}

#[test]
fn the_algebraic_number_takes_no_other_value() {
    // x = θ = √2 is not above 3, although 5 is.
    let goal = Goal { when: vec![relation(var(X), Rel::Gt, number(3, 1))], ..plain() };
    let theta = || vec![(X, vec![q(0, 1), q(1, 1)])];
    let judge = |values| {
        let point = Point { generator: Some(root(&[-2, 0, 1], q(1, 1), q(2, 1))), values };
        judged(&goal, Finding::Refuted, Evidence::Model(Model::Point(point)))
    };
    assert!(judge(theta()).is_err());
    assert!(judge([theta(), vec![(usize::MAX, vec![q(5, 1)])]].concat()).is_err());
}

#[test]
fn a_root_in_the_middle_of_its_interval_is_that_number() {
    // θ = 0, a root of θ³ − 2θ between −1 and 1: no remainder shows that θ itself is zero.
    let at = |rel| {
        let when = vec![relation(var(X), rel, number(0, 1))];
        algebraic(when, (&[0, -2, 0, 1], q(-1, 1), q(1, 1)), &[q(0, 1), q(1, 1)], &[])
    };
    assert_eq!(at(Rel::Eq), Ok(()));
    for wrong in [Rel::Lt, Rel::Gt, Rel::Ne] {
        assert!(at(wrong).is_err());
    }
}

#[test]
fn an_algebraic_number_is_the_only_root_in_its_interval() {
    let judge =
        |poly: &[i64], lo, hi| algebraic(Vec::new(), (poly, lo, hi), &[q(0, 1), q(1, 1)], &[]);
    assert_eq!(judge(&[-2, 0, 1], q(1, 1), q(2, 1)), Ok(()));
    for (poly, lo, hi) in [
        (&[-2, 0, 1][..], q(2, 1), q(3, 1)),
        (&[-2, 0, 1], q(-2, 1), q(2, 1)),
        (&[1, -2, 1], q(0, 1), q(2, 1)),
        (&[-1, 1], q(1, 1), q(2, 1)),
        (&[-2, 1], q(1, 1), q(2, 1)),
        (&[-1, 1], q(1, 1), q(1, 1)),
        (&[2, -3, 1], q(1, 1), q(3, 1)),
        (&[2, -3, 1], q(0, 1), q(2, 1)),
        (&[1, 0, 1], q(0, 1), q(2, 1)),
        (&[1], q(0, 1), q(2, 1)),
        (&[0], q(0, 1), q(2, 1)),
        (&[], q(0, 1), q(2, 1)),
        (&[-2, 0, 1], q(2, 1), q(1, 1)),
    ] {
        assert_eq!(
            judge(poly, lo.clone(), hi.clone()),
            Err(Rejection::RootCount),
            "{poly:?} {lo} {hi}"
        );
    }
}

#[test]
fn a_root_is_exact_where_its_interval_is_a_point() {
    assert!(root(&[-2, 1], q(2, 1), q(2, 1)).is_exact());
    assert!(!root(&[-2, 0, 1], q(1, 1), q(2, 1)).is_exact());
}
