//! The normal form against an evaluator of its own: at each rational point exactly one piece of an
//! expression applies, and its value is the value of the expression.

use kane_kernel::{
    Atom, Context, Expr, Goal, Rejection, Rel, Relation, Scope, Sentence, Sign, scope,
};
use num_traits::Zero;

use crate::oracle::{self, exact_root, inside, value};
use crate::support::{
    Q, X, Y, abs, add, bound, div, either, equal, link, mul, number, plain, plenty, pow, q,
    relation, slope, sqrt, sub, var,
};

/// Points in the plane of which the roots below are rational, as far as they exist.
fn points() -> Vec<Vec<Q>> {
    let some = [q(-4, 1), q(-1, 1), q(-1, 4), q(0, 1), q(1, 9), q(1, 1), q(4, 1)];
    some.iter().flat_map(|a| some.iter().map(|b| vec![a.clone(), b.clone()])).collect()
}

/// A point with the variables for roots: the root where there is one, elsewhere anything.
fn at<'a>(scope: &'a Scope<'_>, point: &'a [Q]) -> impl Fn(usize) -> Q + 'a {
    move |v| match scope.root(v) {
        None => point[v].clone(),
        Some(Expr::Sqrt(a)) => {
            let radicand = oracle::series(a, point, None);
            radicand.and_then(|s| exact_root(&s[0])).unwrap_or_else(|| q(-7, 1))
        }
        Some(_) => Q::zero(),
    }
}

/// Checks each of these expressions at all points.
fn agree(expressions: &[Expr]) {
    let goal = plain();
    let subjects: Vec<&Expr> = expressions.iter().collect();
    let scope = Scope::new(&goal.context, &subjects, plenty()).expect("small");
    for e in expressions {
        let pieces = scope.pieces(e).expect("small");
        for point in points() {
            let at = at(&scope, &point);
            let here: Vec<_> = pieces.iter().filter(|p| inside(&p.atoms, &at)).collect();
            assert_eq!(here.len(), 1, "{e:?} at {point:?}");
            let found = here[0].value.as_ref().map(|f| {
                let den = value(&f.den, &at);
                assert!(!den.is_zero(), "{e:?} at {point:?}");
                value(&f.num, &at) / den
            });
            let wanted = oracle::series(e, &point, None).map(|s| s[0].clone());
            assert_eq!(found, wanted, "{e:?} at {point:?}");
        }
    }
}

fn least(a: Expr, b: Expr) -> Expr {
    Expr::Min(a.into(), b.into())
}

fn greatest(a: Expr, b: Expr) -> Expr {
    Expr::Max(a.into(), b.into())
}

#[test]
fn arithmetic_has_its_value_where_it_is_defined() {
    let (x, y) = (|| var(X), || var(Y));
    agree(&[
        number(-3, 4),
        add(x(), div(y(), number(2, 3))),
        sub(x(), mul(y(), number(5, 1))),
        sub(div(x(), y()), div(y(), x())),
        Expr::Neg(div(number(1, 1), add(x(), y())).into()),
        mul(number(0, 1), div(number(1, 1), x())),
        div(x(), div(y(), add(x(), number(1, 1)))),
        div(mul(x(), y()), mul(y(), y())),
        add(div(x(), y()), div(number(1, 1), y())),
    ]);
}

#[test]
fn powers_have_their_value_where_they_are_defined() {
    let base = || sub(var(X), var(Y));
    let powers: Vec<Expr> = (-3..5).map(|n| pow(base(), n)).collect();
    agree(&powers);
    agree(&[pow(div(number(1, 1), var(X)), 0), pow(div(var(Y), var(X)), -2)]);
    let goal = plain();
    let e = pow(var(X), i32::MIN);
    let scope = Scope::new(&goal.context, &[&e], plenty()).expect("small");
    assert_eq!(scope.pieces(&e).err(), Some(Rejection::Budget));
}

#[test]
fn kinks_take_the_side_that_the_sign_says() {
    let quotient = || div(number(1, 1), var(Y));
    agree(&[
        abs(sub(var(X), var(Y))),
        abs(div(var(X), var(Y))),
        abs(number(-2, 3)),
        least(var(X), var(Y)),
        greatest(var(X), var(Y)),
        least(quotient(), var(X)),
        greatest(var(X), quotient()),
        least(abs(var(X)), greatest(var(Y), number(1, 2))),
        greatest(number(1, 2), number(1, 3)),
        least(number(1, 2), number(1, 3)),
    ]);
    // As cases they are the same.
    for e in [abs(var(X)), least(var(X), var(Y)), greatest(var(X), var(Y))] {
        agree(&[e.as_cases()]);
        for p in points() {
            let (a, b) = (oracle::series(&e, &p, None), oracle::series(&e.as_cases(), &p, None));
            assert_eq!(a, b, "{e:?} at {p:?}");
        }
    }
}

#[test]
fn a_root_is_the_one_that_is_not_negative() {
    agree(&[
        sqrt(var(X)),
        sqrt(mul(var(X), var(X))),
        sqrt(div(var(X), var(Y))),
        mul(sqrt(var(X)), sqrt(var(X))),
        add(sqrt(var(X)), sqrt(pow(var(Y), 2))),
        div(number(1, 1), sqrt(var(X))),
        sqrt(number(4, 9)),
        sqrt(number(-4, 9)),
        sqrt(pow(sqrt(var(X)), 4)),
    ]);
}

#[test]
fn cases_take_the_first_branch_whose_guards_hold() {
    let guard = |e: Expr, rel| relation(e, rel, number(0, 1));
    let pole = || div(number(1, 1), var(X));
    let rels = [Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge];
    for rel in rels {
        agree(&[
            either(guard(var(X), rel), number(1, 1), pole()),
            either(guard(pole(), rel), var(Y), number(2, 1)),
            either(relation(number(1, 4), rel, var(Y)), var(Y), number(2, 1)),
        ]);
        let two = || vec![guard(var(X), rel), guard(pole(), Rel::Gt)];
        let branches = vec![(two(), number(1, 1)), (vec![guard(var(Y), Rel::Lt)], number(2, 1))];
        agree(&[
            Expr::Cases(branches.clone(), None),
            Expr::Cases(branches.clone(), Some(pole().into())),
            Expr::Cases(branches.into_iter().rev().collect(), None),
        ]);
    }
    agree(&[Expr::Cases(Vec::new(), None), Expr::Cases(vec![(Vec::new(), var(X))], None)]);
}

#[test]
fn a_derivative_has_its_value_where_it_is_defined() {
    agree(&[slope(mul(var(X), var(Y))), add(var(X), slope(abs(var(X)))), slope(sqrt(var(X)))]);
}

/// Relations between expressions of which some are undefined somewhere.
fn relations() -> Vec<Relation> {
    let pole = div(number(1, 1), sub(var(X), number(1, 1)));
    let mut out = Vec::new();
    for rel in [Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge] {
        out.push(relation(var(X), rel, var(Y)));
        out.push(relation(pole.clone(), rel, var(Y)));
        out.push(relation(number(1, 1), rel, div(var(Y), var(X))));
        out.push(relation(number(1, 3), rel, number(1, 2)));
    }
    out
}

#[test]
fn a_relation_is_true_false_or_undefined() {
    let goal = plain();
    let scope = Scope::new(&goal.context, &[], plenty()).expect("small");
    for r in relations() {
        let truth = scope.relation(&r).expect("small");
        for point in points() {
            let at = at(&scope, &point);
            let here: Vec<_> = truth.iter().filter(|p| inside(&p.atoms, &at)).collect();
            assert_eq!(here.len(), 1, "{r:?} at {point:?}");
            let wanted = oracle::all(std::slice::from_ref(&r), &point, None);
            assert_eq!(here[0].value, wanted, "{r:?} at {point:?}");
        }
    }
}

#[test]
fn relations_are_read_from_left_to_right() {
    let goal = plain();
    let scope = Scope::new(&goal.context, &[], plenty()).expect("small");
    let all = relations();
    for pair in all.iter().flat_map(|a| all.iter().map(move |b| [a.clone(), b.clone()])) {
        let truth = scope.all(&pair).expect("small");
        for point in points().into_iter().step_by(6) {
            let at = at(&scope, &point);
            let here: Vec<_> = truth.iter().filter(|p| inside(&p.atoms, &at)).collect();
            assert_eq!(here.len(), 1, "{pair:?} at {point:?}");
            assert_eq!(here[0].value, oracle::all(&pair, &point, None), "{pair:?} at {point:?}");
        }
    }
}

#[test]
fn a_premise_says_nothing_off_its_conditions() {
    let goal = plain();
    let scope = Scope::new(&goal.context, &[], plenty()).expect("small");
    let all = relations();
    let some = all.iter().step_by(7);
    for (when, r) in some.flat_map(|w| all.iter().map(move |r| (w.clone(), r.clone()))) {
        let links = vec![kane_kernel::Link::Relation(r), link(var(Y), Rel::Ge, number(-1, 1))];
        let s = Sentence { when: vec![when], links };
        for given in [true, false] {
            for holds in [true, false] {
                let cases = scope.premise(&s, given, holds).expect("small");
                for point in points().into_iter().step_by(4) {
                    let at = at(&scope, &point);
                    let found = cases.iter().filter(|case| inside(case, &at)).count();
                    let wanted = oracle::premise(&s, given, &point) == holds;
                    assert_eq!(found, usize::from(wanted), "{s:?} {given} {holds} at {point:?}");
                }
            }
        }
    }
}

#[test]
fn a_range_is_what_its_ends_say() {
    for (strict, end) in [(true, false), (false, true)] {
        let mut goal = plain();
        goal.context.vars[X].lower = bound(q(-1, 3), strict);
        goal.context.vars[X].upper = bound(q(3, 2), strict);
        let e = var(X);
        let scope = Scope::new(&goal.context, &[&e], plenty()).expect("small");
        let within = |x: Q| {
            let at = |_| x.clone();
            assert_eq!(inside(&scope.range(X), &at), inside(&scope.ranges(), &at));
            inside(&scope.ranges(), &at)
        };
        assert!(within(q(0, 1)) && within(q(-1, 4)) && within(q(7, 5)));
        assert!(!within(q(-1, 2)) && !within(q(2, 1)));
        assert_eq!((within(q(-1, 3)), within(q(3, 2))), (end, end));
        assert!(scope.range(Y).is_empty() && scope.range(9).is_empty());
    }
    // Symbols that are not mentioned are not restricted.
    let mut goal = plain();
    goal.context.vars[Y].lower = bound(q(0, 1), false);
    let e = var(X);
    assert!(Scope::new(&goal.context, &[&e], plenty()).expect("small").ranges().is_empty());
}

#[test]
fn an_empty_range_is_refused() {
    for (lower, upper, strict, empty) in [
        (1, 0, (false, false), true),
        (0, 0, (false, false), false),
        (0, 0, (true, false), true),
        (0, 0, (false, true), true),
        (0, 1, (true, true), false),
    ] {
        let mut goal = plain();
        goal.context.vars[Y].lower = bound(q(lower, 1), strict.0);
        goal.context.vars[Y].upper = bound(q(upper, 1), strict.1);
        let refused = matches!(scope(&goal, plenty()), Err(Rejection::EmptyRange(Y)));
        assert_eq!(refused, empty, "{lower} {upper} {strict:?}");
    }
}

#[test]
fn a_definition_stands_for_its_body() {
    let define = |name: &str, body| kane_kernel::Definition { name: name.into(), body };
    let context = Context {
        lets: vec![
            define("a", div(number(1, 1), var(X))),
            define("b", add(Expr::Let(0), var(Y))),
            define("never", div(number(1, 1), number(0, 1))),
        ],
        ..plain().context
    };
    let goal = Goal { context, when: vec![relation(Expr::Let(1), Rel::Eq, var(Y))], ..plain() };
    let scope = scope(&goal, plenty()).expect("small");
    assert_eq!(scope.mentioned.iter().copied().collect::<Vec<_>>(), vec![X, Y]);
    let direct = add(div(number(1, 1), var(X)), var(Y));
    let (a, b) =
        (scope.pieces(&Expr::Let(1)).expect("known"), scope.pieces(&direct).expect("small"));
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(&b) {
        assert_eq!((&a.atoms, &a.value), (&b.atoms, &b.value));
    }
    assert_eq!(scope.pieces(&Expr::Let(2)).err(), Some(Rejection::UnknownSymbol), "not mentioned");
    assert_eq!(scope.pieces(&Expr::Let(9)).err(), Some(Rejection::UnknownSymbol));
    assert_eq!(scope.pieces(&var(9)).err(), Some(Rejection::UnknownSymbol));
    assert_eq!(scope.pieces(&sqrt(var(X))).err(), Some(Rejection::UnknownSymbol));
}

#[test]
fn a_symbol_that_is_not_declared_is_no_name_of_a_root() {
    // Roots are numbered behind the symbols: a symbol next to the last one must not mean √x.
    let goal = plain();
    let root = sqrt(var(X));
    let scope = Scope::new(&goal.context, &[&root], plenty()).expect("small");
    let first = goal.context.vars.len();
    assert_eq!(scope.root(first), Some(&root));
    assert_eq!(scope.pieces(&var(first)).err(), Some(Rejection::UnknownSymbol));
}

#[test]
fn an_expression_has_at_most_4096_pieces() {
    let kinks = |n: i64| (0..n).map(|k| abs(sub(var(X), number(k, 1)))).reduce(add).expect("some");
    let goal = plain();
    for (n, count) in [(11, Ok(2048)), (12, Ok(4096)), (13, Err(Rejection::Budget))] {
        let e = kinks(n);
        let scope = Scope::new(&goal.context, &[&e], plenty()).expect("small");
        assert_eq!(scope.pieces(&e).map(|pieces| pieces.len()), count, "{n} kinks");
    }
}

#[test]
fn a_value_stands_for_its_symbol() {
    let context = Context { values: vec![(Y, pow(var(X), 2))], ..plain().context };
    let e = add(var(Y), var(X));
    let scope = Scope::new(&context, &[&e], plenty()).expect("small");
    assert_eq!(scope.mentioned.iter().copied().collect::<Vec<_>>(), vec![X]);
    let pieces = scope.pieces(&e).expect("small");
    let f = pieces[0].value.as_ref().expect("defined everywhere");
    assert_eq!(value(&f.num, &|_| q(3, 1)) / value(&f.den, &|_| q(3, 1)), q(12, 1));
}

#[test]
fn a_sign_admits_what_it_names() {
    let table = [
        (Sign::Zero, [false, true, false], false),
        (Sign::NonZero, [true, false, true], false),
        (Sign::NonNegative, [false, true, true], true),
        (Sign::Positive, [false, false, true], true),
    ];
    for (sign, admitted, order) in table {
        assert_eq!([-1, 0, 1].map(|s| sign.admits(s)), admitted);
        assert_eq!(sign.is_order(), order);
        for c in [-2_i32, 0, 5] {
            let atom = Atom::new(kane_kernel::Poly::constant(c.into()), sign);
            let holds = sign.admits(i8::try_from(c.signum()).unwrap_or(0));
            assert_eq!(atom.decided(), Some(holds));
            assert_eq!(atom.not().decided(), Some(!holds), "{sign:?} {c}");
        }
    }
    assert_eq!(equal(crate::support::x()).decided(), None);
}
