//! Derivatives against power series worked out anew, and where they are not defined.

use kane_kernel::{
    Context, Definition, Evidence, Expr, Failure, Finding, Functions, Goal, Model, Point,
    Rejection, Rel, Scope,
};
use num_traits::Zero;

use crate::oracle::{self, exact_root, inside, value};
use crate::support::{
    Q, X, Y, abs, add, div, either, given, judged, link, mul, number, plain, plenty, pow, q,
    relation, slope, sqrt, sub, symbol, var,
};

fn least(a: Expr, b: Expr) -> Expr {
    Expr::Min(a.into(), b.into())
}

fn greatest(a: Expr, b: Expr) -> Expr {
    Expr::Max(a.into(), b.into())
}

/// The value of an expression by the kernel, at a point.
fn found(context: &Context, e: &Expr, point: &[Q]) -> Result<Option<Q>, Rejection> {
    let scope = Scope::new(context, &[e], plenty())?;
    let pieces = scope.pieces(e)?;
    let at = |v: usize| match scope.root(v) {
        None => point[v].clone(),
        Some(Expr::Sqrt(a)) => {
            let radicand = oracle::series(a, point, None);
            radicand.and_then(|s| exact_root(&s[0])).unwrap_or_else(|| q(-7, 1))
        }
        Some(_) => Q::zero(),
    };
    let here: Vec<_> = pieces.iter().filter(|p| inside(&p.atoms, &at)).collect();
    assert_eq!(here.len(), 1, "{e:?} at {point:?}");
    Ok(here[0].value.as_ref().map(|f| value(&f.num, &at) / value(&f.den, &at)))
}

/// First, second and third derivatives are what the series says, at all points.
fn agree(expressions: &[Expr], points: &[Vec<Q>]) {
    let context = plain().context;
    for f in expressions {
        let mut e = f.clone();
        for order in 1..4 {
            e = slope(e);
            for point in points {
                let wanted = oracle::series(&e, point, None).map(|s| s[0].clone());
                let is = found(&context, &e, point);
                assert_eq!(is, Ok(wanted), "derivative {order} of {f:?} at {point:?}");
            }
        }
    }
}

fn points() -> Vec<Vec<Q>> {
    let some = [q(-4, 1), q(-1, 1), q(0, 1), q(1, 4), q(1, 1), q(4, 1)];
    some.iter().flat_map(|a| [q(-1, 1), q(0, 1), q(4, 1)].map(|b| vec![a.clone(), b])).collect()
}

#[test]
fn derivatives_of_fractions_follow_the_rules() {
    let (x, y) = (|| var(X), || var(Y));
    agree(
        &[
            number(5, 2),
            y(),
            Expr::Neg(pow(x(), 3).into()),
            sub(mul(x(), pow(x(), 2)), mul(y(), x())),
            div(add(x(), number(3, 1)), sub(pow(x(), 2), y())),
            div(pow(x(), 3), number(-3, 2)),
            pow(sub(x(), number(1, 2)), -2),
            pow(div(y(), x()), 0),
            pow(add(x(), y()), 5),
        ],
        &points(),
    );
}

#[test]
fn derivatives_of_roots_need_a_positive_radicand_unless_it_is_fixed() {
    let (x, y) = (|| var(X), || var(Y));
    agree(
        &[
            sqrt(x()),
            mul(sqrt(x()), sqrt(x())),
            div(x(), sqrt(x())),
            mul(sqrt(y()), pow(x(), 2)),
            sqrt(mul(pow(x(), 2), number(9, 1))),
            div(sqrt(pow(x(), 4)), add(sqrt(x()), number(1, 1))),
        ],
        &points(),
    );
    let same_sign: Vec<_> = points().into_iter().filter(|p| &p[0] * &p[1] > Q::zero()).collect();
    agree(&[sqrt(div(y(), x()))], &same_sign);
    agree(&[sqrt(pow(sqrt(x()), 4)), mul(sqrt(x()), sqrt(pow(x(), 2)))], &points());
}

#[test]
fn kinks_have_no_derivative_where_their_sides_meet() {
    let (x, y) = (|| var(X), || var(Y));
    let mut some = vec![
        abs(x()),
        abs(mul(x(), x())),
        abs(y()),
        mul(abs(y()), pow(x(), 2)),
        least(x(), number(1, 4)),
        greatest(pow(x(), 2), x()),
        least(y(), mul(y(), number(2, 1))),
        greatest(x(), add(x(), number(1, 1))),
        mul(x(), abs(sub(x(), y()))),
    ];
    for rel in [Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge] {
        some.push(either(relation(x(), rel, y()), pow(x(), 2), mul(number(3, 1), x())));
        some.push(either(relation(y(), rel, number(0, 1)), pow(x(), 2), mul(number(3, 1), x())));
        let pole = div(number(1, 1), x());
        some.push(either(relation(pole, rel, number(1, 1)), x(), pow(x(), 3)));
        let two = vec![relation(x(), rel, number(1, 1)), relation(y(), rel, x())];
        some.push(Expr::Cases(vec![(two, x())], Some(pow(x(), 2).into())));
        some.push(Expr::Cases(vec![(vec![relation(x(), rel, y())], pow(x(), 2))], None));
    }
    agree(&some, &points());
}

/// An expression, a point, and its value there.
type Example = (Expr, [i64; 2], Option<i64>);

fn examples(some: Vec<Example>) {
    let context = plain().context;
    for (e, point, wanted) in some {
        let at: Vec<Q> = point.iter().map(|c| q(*c, 1)).collect();
        assert_eq!(found(&context, &e, &at), Ok(wanted.map(|c| q(c, 1))), "{e:?} at {point:?}");
    }
}

#[test]
fn a_kink_in_the_side_of_a_guard_does_not_matter() {
    let (x, y) = (|| var(X), || var(Y));
    let twice = || mul(number(2, 1), x());
    let below = |side: Expr| slope(either(relation(side, Rel::Lt, number(1, 1)), x(), twice()));
    examples(vec![
        (slope(least(abs(x()), number(-1, 1))), [0, 0], Some(0)),
        (below(abs(x())), [0, 0], Some(1)),
        (below(abs(x())), [1, 0], None),
        (below(abs(x())), [2, 0], Some(2)),
        (below(greatest(x(), number(0, 1))), [0, 0], Some(1)),
        (below(least(x(), Expr::Neg(x().into()))), [0, 0], Some(1)),
        (below(greatest(x(), abs(y()))), [0, 0], Some(1)),
        (below(sqrt(pow(x(), 2))), [1, 0], None),
        // A root that varies is not continuous to both sides where it vanishes.
        (below(sqrt(x())), [0, 0], None),
        (below(sqrt(y())), [0, 0], Some(1)),
        (below(div(number(0, 1), x())), [0, 0], None),
        // A side that jumps is no continuous one, although it differs from the other.
        (
            below(either(relation(x(), Rel::Gt, number(0, 1)), number(-1, 1), number(0, 1))),
            [0, 0],
            None,
        ),
    ]);
}

#[test]
fn one_side_of_a_kink_is_not_all_that_is_near() {
    let (x, y) = (|| var(X), || var(Y));
    let twice = || mul(number(2, 1), x());
    let guard = |a: Expr, b: Expr| slope(either(relation(a, Rel::Le, b), x(), twice()));
    let minus = |a: Expr| Expr::Neg(a.into());
    examples(vec![
        // |x| ≤ x holds on the right alone; so does min(x, 0) ≥ 0.
        (guard(abs(x()), x()), [0, 0], None),
        (guard(minus(x()), abs(x())), [0, 0], None),
        (guard(abs(x()), x()), [-1, 0], Some(2)),
        (guard(number(0, 1), least(x(), number(0, 1))), [0, 0], None),
        (guard(greatest(x(), number(0, 1)), number(0, 1)), [0, 0], None),
        (guard(number(0, 1), least(number(0, 1), x())), [0, 0], None),
        (guard(greatest(x(), sub(x(), abs(y()))), x()), [3, 0], Some(1)),
        // Of two that keep their distance the one is all that is near.
        (guard(least(x(), add(x(), number(1, 1))), x()), [0, 0], Some(1)),
        (guard(abs(y()), y()), [0, 0], Some(1)),
        (guard(abs(y()), y()), [0, -1], Some(2)),
        // Kinks inside sums, products, roots and powers count as well.
        (guard(add(abs(x()), number(0, 1)), x()), [0, 0], None),
        (guard(sqrt(add(sub(abs(x()), x()), number(4, 1))), number(2, 1)), [0, 0], None),
        (guard(abs(abs(x())), x()), [0, 0], None),
    ]);
}

#[test]
fn derivatives_by_two_symbols_vary_both() {
    let (x, y) = (|| var(X), || var(Y));
    let by_y = |e: Expr| Expr::Deriv(e.into(), Y);
    examples(vec![
        (by_y(slope(mul(pow(x(), 2), pow(y(), 3)))), [2, 1], Some(12)),
        (slope(by_y(mul(pow(x(), 2), pow(y(), 3)))), [2, 1], Some(12)),
        // d(|y|·x, x) is |y|, which has no derivative by y at 0.
        (slope(mul(abs(y()), x())), [1, 0], Some(0)),
        (by_y(slope(mul(abs(y()), x()))), [1, 0], None),
        (by_y(slope(mul(abs(y()), x()))), [1, -2], Some(-1)),
        (by_y(slope(mul(sqrt(y()), x()))), [1, 0], None),
        // d(|x|, x) changes at 0 alone, and not with y.
        (by_y(slope(abs(x()))), [0, 1], None),
        (by_y(slope(abs(x()))), [1, 1], Some(0)),
    ]);
    let e = by_y(slope(mul(sqrt(y()), pow(x(), 2))));
    assert_eq!(found(&plain().context, &e, &[q(3, 1), q(4, 1)]), Ok(Some(q(3, 2))));
}

#[test]
fn a_derivative_of_what_is_not_explicit_is_refused() {
    let mut goal = plain();
    goal.context.vars.push(symbol("k", Some(X)));
    let k = || var(2);
    let at = [q(3, 1), q(5, 1), q(7, 1)];
    assert_eq!(found(&goal.context, &slope(mul(k(), var(X))), &at), Err(Rejection::NotExplicit));
    assert_eq!(
        found(&goal.context, &slope(slope(mul(k(), var(Y)))), &at),
        Err(Rejection::NotExplicit)
    );
    assert_eq!(found(&goal.context, &slope(var(9)), &at), Err(Rejection::UnknownSymbol));
    // By another symbol it is a number.
    let by_y = Expr::Deriv(mul(k(), pow(var(Y), 2)).into(), Y);
    assert_eq!(found(&goal.context, &by_y, &at), Ok(Some(q(70, 1))));
    let both = Expr::Deriv(slope(mul(var(X), var(Y))).into(), Y);
    assert_eq!(found(&goal.context, &both, &at), Ok(Some(q(1, 1))));
    let hidden = Expr::Deriv(slope(mul(k(), var(Y))).into(), Y);
    assert_eq!(found(&goal.context, &hidden, &at), Err(Rejection::NotExplicit));
    // With an expression for it the derivative is that of the expression.
    goal.context.values = vec![(2, pow(var(X), 2))];
    assert_eq!(found(&goal.context, &slope(k()), &at), Ok(Some(q(6, 1))));
    // But what is a function of x alone does not vary with y, whatever stands for it here.
    assert_eq!(
        found(&goal.context, &Expr::Deriv(mul(k(), var(Y)).into(), Y), &at),
        Ok(Some(q(9, 1)))
    );
    goal.context.values = vec![(2, mul(var(X), var(Y)))];
    assert_eq!(found(&goal.context, &slope(k()), &at), Ok(Some(q(5, 1))));
    assert_eq!(found(&goal.context, &Expr::Deriv(k().into(), Y), &at), Err(Rejection::NotExplicit));
}

#[test]
fn definitions_are_expanded_near_a_point_too() {
    let define = |name: &str, body| Definition { name: name.into(), body };
    let context = Context {
        lets: vec![
            define("a", abs(var(X))),
            define("b", mul(Expr::Let(0), var(Y))),
            define("loop", slope(Expr::Let(2))),
        ],
        ..plain().context
    };
    let e = slope(Expr::Let(1));
    let at = |a, b| [q(a, 1), q(b, 1)];
    assert_eq!(found(&context, &e, &at(-2, 5)), Ok(Some(q(-5, 1))));
    assert_eq!(found(&context, &e, &at(0, 5)), Ok(None));
    // Known for one question, not for another: first by x and then by y, in a guard and outside.
    let by_y = || Expr::Deriv(Expr::Let(1).into(), Y);
    assert_eq!(found(&context, &add(slope(Expr::Let(1)), by_y()), &at(-2, 5)), Ok(Some(q(-3, 1))));
    assert_eq!(found(&context, &add(by_y(), slope(Expr::Let(1))), &at(0, 5)), Ok(None));
    let guard = relation(Expr::Let(0), Rel::Lt, number(1, 1));
    let guarded = slope(either(guard, Expr::Let(0), var(X)));
    assert_eq!(found(&context, &guarded, &at(0, 0)), Ok(None));
    assert_eq!(found(&context, &slope(Expr::Let(2)), &at(0, 0)), Err(Rejection::Budget));
}

#[test]
fn what_is_known_of_a_definition_near_a_point_answers_one_question() {
    // u = |x|, which has no derivative by x at 0.
    let body = abs(var(X));
    let context = Context { lets: vec![Definition { name: "u".into(), body }], ..plain().context };
    let (x, u, twice) = (|| var(X), || Expr::Let(0), || mul(number(2, 1), var(X)));
    let at_zero = |e: &Expr| found(&context, e, &[q(0, 1), q(1, 1)]);
    // By y it has one, whichever of the two is asked for first.
    let by_y = || Expr::Deriv(u().into(), Y);
    assert_eq!(at_zero(&by_y()), Ok(Some(q(0, 1))));
    for both in [add(slope(u()), by_y()), add(by_y(), slope(u()))] {
        assert_eq!(at_zero(&both), Ok(None), "{both:?}");
    }
    // As the side of a guard it has to be continuous, no more, and is; what the guard chooses has
    // to have a derivative. Either may be asked for first.
    let small = || relation(u(), Rel::Lt, number(1, 1));
    let guarded = || slope(either(small(), x(), twice()));
    assert_eq!(at_zero(&guarded()), Ok(Some(q(1, 1))));
    assert_eq!(at_zero(&slope(either(small(), x(), u()))), Ok(Some(q(1, 1))));
    for both in [add(slope(u()), guarded()), add(guarded(), slope(u()))] {
        assert_eq!(at_zero(&both), Ok(None), "{both:?}");
    }
}

#[test]
fn a_derivative_is_undefined_where_a_guard_jumps() {
    // g jumps at x = 1 from 1 to −1, and with it f from x to 2·x.
    let cases = |rel, side: Expr, edge, yes: Expr, no: Expr| {
        Expr::Cases(vec![(vec![relation(side, rel, Expr::int(edge))], yes)], Some(no.into()))
    };
    let double = Expr::Mul(Expr::int(2).into(), Expr::Var(X).into());
    let g = cases(Rel::Lt, Expr::Var(X), 1, Expr::int(1), Expr::int(-1));
    let f = cases(Rel::Gt, g, 0, Expr::Var(X), double);
    let slope = relation(Expr::Deriv(f.into(), X), Rel::Eq, Expr::int(2));
    let goal = Goal {
        conclusion: kane_kernel::Conclusion::Link(kane_kernel::Link::Relation(slope)),
        ..plain()
    };
    let undefined = |x: i64| {
        let point = Point { generator: None, values: vec![(X, vec![q(x, 1)])] };
        judged(&goal, Finding::IllDefined, Evidence::Model(Model::Point(point)))
    };
    assert_eq!(undefined(1), Ok(()));
    assert!(undefined(0).is_err());
    assert!(undefined(2).is_err());
}

/// A proof that a premise without undefined parts, or a range, holds: nothing of it is left to fail.
fn evident() -> kane_kernel::Proof {
    kane_kernel::Proof::Assume { formula: 1, cases: Vec::new() }
}

#[test]
fn a_derivative_by_a_symbol_with_a_value_is_refused() {
    // d(x², x) = c with x := 2, as functions of y.
    let model = |c, var, values: Vec<(usize, Expr)>, at| {
        let slope = Expr::Deriv(Expr::Pow(Expr::Var(X).into(), 2).into(), X);
        let premise = given(vec![link(slope, Rel::Eq, Expr::int(c))]);
        let goal = Goal { hypotheses: vec![premise], ..plain() };
        let ranges = values.iter().map(|_| evident()).collect();
        let failure = Failure::At(Point { generator: None, values: vec![(at, vec![q(0, 1)])] });
        let premises = vec![(evident(), Vec::new())];
        let functions = Functions { var, values, ranges, premises, failure };
        judged(&goal, Finding::Refuted, Evidence::Model(Model::Functions(functions.into())))
    };
    let two = || vec![(X, Expr::int(2))];
    for c in [0, 4] {
        assert_eq!(model(c, Y, two(), Y), Err(Rejection::NotExplicit));
    }
    assert!(model(4, X, two(), Y).is_err());
}
