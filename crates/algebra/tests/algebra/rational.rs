//! Rational functions, their limits, signs and cases: each answer found in two independent ways.

use std::time::Instant;

use kane_algebra::rational_function::{NotRational, RationalFunction, non_zero};
use kane_algebra::ring;
use kane_algebra::syntax::{Notation, Scope, eval, parse_expr};
use kane_kernel::{Context, Expr, Fuel, Poly, Var};
use kane_number::{Number, Rational, testkit};
use num_traits::Zero;
use proptest::prelude::*;

fn ratio(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

fn scope(names: &str) -> Scope {
    let mut scope = Scope::default();
    for name in names.split_whitespace() {
        let var = Var { name: name.to_owned(), of: None, lower: None, upper: None };
        scope.declare(var).expect("the names are free");
    }
    scope
}

fn read(text: &str, scope: &Scope) -> RationalFunction {
    let expr = parse_expr(text, scope).expect("well-formed");
    RationalFunction::from_expr(&expr, scope.context()).expect("rational")
}

fn xyz() -> Scope {
    scope("x y z")
}

/// Small rationals, zero and one often.
fn number() -> impl Strategy<Value = Rational> {
    prop_oneof![
        Just(ratio(0, 1)),
        Just(ratio(1, 1)),
        (-4i64..=4, 1i64..=3).prop_map(|(n, d)| ratio(n, d)),
    ]
}

/// A point of three coordinates on which small denominators often vanish.
fn point() -> impl Strategy<Value = Vec<Rational>> {
    prop::collection::vec(number(), 3)
}

/// Expressions in three symbols, of all constructs that are rational.
fn expr() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![number().prop_map(Expr::Num), (0usize..3).prop_map(Expr::Var)];
    leaf.prop_recursive(4, 12, 2, |inner| {
        let two = (inner.clone(), inner.clone());
        prop_oneof![
            inner.clone().prop_map(|a| Expr::Neg(a.into())),
            two.clone().prop_map(|(a, b)| Expr::Add(a.into(), b.into())),
            two.clone().prop_map(|(a, b)| Expr::Sub(a.into(), b.into())),
            two.clone().prop_map(|(a, b)| Expr::Mul(a.into(), b.into())),
            two.prop_map(|(a, b)| Expr::Div(a.into(), b.into())),
            (inner.clone(), -2i32..4).prop_map(|(a, n)| Expr::Pow(a.into(), n)),
            (inner, 0usize..3).prop_map(|(a, x)| Expr::Deriv(a.into(), x)),
        ]
    })
}

/// Rational functions of three symbols.
fn function() -> impl Strategy<Value = RationalFunction> {
    expr().prop_filter_map("defined somewhere", |e| {
        RationalFunction::from_expr(&e, xyz().context()).ok()
    })
}

/// Polynomials in three symbols, not zero, with up to four terms.
fn poly() -> impl Strategy<Value = Poly> {
    let term = (prop::collection::vec(0u32..3, 3), -3i64..=3);
    prop::collection::vec(term, 1..5)
        .prop_map(|terms| {
            let mut p = Poly::default();
            for (exponents, c) in terms {
                let powers = exponents.into_iter().enumerate().filter(|p| p.1 > 0);
                p = p.add(&Poly::term(powers.collect(), c.into()));
            }
            p
        })
        .prop_filter("not zero", |p| !p.is_empty())
}

fn times(p: &Poly, q: &Poly) -> Poly {
    p.mul(q, &Fuel::new(u64::MAX)).expect("fuel without end")
}

proptest! {
    /// Normal form against the evaluator, which divides and differentiates numbers at the point.
    #[test]
    fn value_and_domain_are_those_of_the_expression(e in expr(), points in prop::collection::vec(point(), 8)) {
        let scope = xyz();
        match RationalFunction::from_expr(&e, scope.context()) {
            Ok(f) => for p in points {
                prop_assert_eq!(f.eval(&p), eval(&e, scope.context(), &p).ok());
            },
            Err(NotRational::DivisionByZero) => for p in points {
                prop_assert!(eval(&e, scope.context(), &p).is_err());
            },
            Err(NotRational::TooLarge) => {}
            Err(other) => prop_assert!(false, "{other}"),
        }
    }

    #[test]
    fn rational_functions_are_a_field(f in function(), g in function()) {
        let x = RationalFunction::symbol(0);
        testkit::field_axioms(&[RationalFunction::zero(), RationalFunction::one(), x, f, g]);
    }

    #[test]
    fn a_planted_factor_cancels_and_stays_as_a_condition(
        p in poly(), q in poly(), g in poly(), points in prop::collection::vec(point(), 8),
    ) {
        let plain = RationalFunction::new(&p, &q).expect("q is not zero");
        let planted = RationalFunction::new(&times(&p, &g), &times(&q, &g)).expect("nor is g");
        prop_assert_eq!(planted.fraction(), plain.fraction());
        let all = planted.conditions();
        let product = all.iter().fold(Poly::one(), |a, b| times(&a, b));
        // every factor of g is one of the conditions
        let rest = (0..12).fold(g.clone(), |rest, _| ring::cancelled(&rest, &product).0);
        prop_assert!(rest.is_constant(), "{rest:?} is lost");
        for (i, a) in all.iter().enumerate() {
            for b in &all[i + 1..] {
                prop_assert!(ring::gcd(a, b).is_constant(), "{a:?} and {b:?}");
            }
        }
        let as_function = |p: &Poly| RationalFunction::new(p, &Poly::one()).expect("1 is not zero");
        for point in points {
            let values = [&p, &q, &g].map(|p| as_function(p).eval(&point).expect("whole"));
            let defined = !values[1].is_zero() && !values[2].is_zero();
            prop_assert_eq!(planted.eval(&point), defined.then(|| &values[0] / &values[1]));
            let conditions = all.iter().all(|c| !as_function(c).eval(&point).unwrap().is_zero());
            prop_assert_eq!(conditions, defined);
        }
    }

    #[test]
    fn substitution_commutes_with_evaluation(
        f in function(), by in (function(), function()), points in prop::collection::vec(point(), 8),
    ) {
        let replaced = f.substitute(&[(0, by.0.clone()), (2, by.1.clone())]);
        for mut p in points {
            let values = (by.0.eval(&p), by.1.eval(&p));
            let there = match &replaced {
                Ok(g) => g.eval(&p),
                Err(NotRational::DivisionByZero) => None,
                Err(NotRational::TooLarge) => continue,
                Err(other) => return Err(TestCaseError::fail(other.to_string())),
            };
            let here = match values {
                (Some(x), Some(z)) => {
                    (p[0], p[2]) = (x, z);
                    f.eval(&p)
                }
                _ => None,
            };
            prop_assert_eq!(there, here);
        }
    }

    /// (f(x + h) − f(x))/h cancels h, and is the derivative at h = 0.
    #[test]
    fn the_derivative_is_the_difference_quotient_at_zero(f in function(), p in point()) {
        let h = RationalFunction::symbol(3);
        let moved = f.substitute(&[(0, RationalFunction::symbol(0) + &h)]);
        prop_assume!(moved.is_ok());
        let quotient = (moved.unwrap() - &f) / &h;
        let (num, den) = quotient.fraction();
        let cancelled = RationalFunction::new(&num, &den).expect("a quotient");
        let at = [p, vec![ratio(0, 1)]].concat();
        if let (Some(there), Some(slope)) = (cancelled.eval(&at), f.derivative(0).eval(&at)) {
            prop_assert_eq!(there, slope);
        }
    }

    #[test]
    fn text_reads_back_as_the_same_function(f in function()) {
        let scope = xyz();
        let text = f.to_expr().plain(scope.context());
        prop_assert_eq!(&read(&text, &scope), &f);
        let shown = f.to_string();
        prop_assert_eq!(shown.contains(" when "), !f.cancelled().is_empty(), "{}", shown);
    }
}

#[test]
fn what_is_no_rational_function_is_refused_by_name() {
    let mut scope = xyz();
    let k = Var { name: "k".to_owned(), of: Some(0), lower: None, upper: None };
    scope.declare(k).expect("the name is free");
    let tower = |base: Expr| Expr::Pow(Expr::Pow(base.into(), 10_000).into(), 10_000);
    let read = |e: &Expr| RationalFunction::from_expr(e, scope.context()).err();
    for (text, reason) in [
        ("x + abs(y)", NotRational::Operation("abs")),
        ("min(x, y)", NotRational::Operation("min")),
        ("max(x, y)", NotRational::Operation("max")),
        ("sqrt(4)", NotRational::Operation("sqrt")),
        ("cases { x > 0: 1; else: 2 }", NotRational::Operation("cases")),
        ("1/(x - x)", NotRational::DivisionByZero),
        ("(x - x)^-1", NotRational::DivisionByZero),
        ("(x + y + z)^10000", NotRational::TooLarge),
    ] {
        let e = parse_expr(text, &scope).expect("well-formed");
        assert_eq!(read(&e), Some(reason), "{text}");
    }
    assert_eq!(read(&tower(Expr::Num(ratio(2, 1)))), Some(NotRational::TooLarge));
    assert_eq!(read(&Expr::Var(9)), Some(NotRational::Unknown));
    assert_eq!(read(&Expr::Let(0)), Some(NotRational::Unknown));
    assert_eq!(read(&Expr::Deriv(Expr::Var(3).into(), 0)), Some(NotRational::NotExplicit));
    // a definition that uses itself is not followed
    let circle = kane_kernel::Definition { name: "c".to_owned(), body: Expr::Let(0) };
    let context = Context { lets: vec![circle], ..Context::default() };
    assert_eq!(RationalFunction::from_expr(&Expr::Let(0), &context), Err(NotRational::Unknown));
}

#[test]
fn definitions_are_expanded_once() {
    let mut scope = scope("x");
    scope.define("d0", parse_expr("x + 1", &scope).unwrap()).unwrap();
    for i in 1..60 {
        let body = format!("(d{0} + d{0})/2", i - 1);
        scope.define(&format!("d{i}"), parse_expr(&body, &scope).unwrap()).unwrap();
    }
    assert_eq!(read("d59", &scope), read("x + 1", &scope));
}

#[test]
fn cancelled_factors_are_printed() {
    let scope = scope("x y alpha k");
    for (text, plain, latex) in [
        ("x/x", "1 when x != 0", "1 \\quad\\text{when } x \\ne 0"),
        ("(1 - k)/(2*alpha)", "(1 - k)/(2*alpha)", "\\frac{1 - k}{2 \\alpha}"),
        ("1/(1/x + 1/y)", "x*y/(x + y) when x != 0, y != 0", ""),
        ("(x^2 - y^2)/(y - x)", "-x - y when x - y != 0", ""),
        ("x/(x^2 - x)", "1/(x - 1) when x != 0", ""),
        ("0*(1/(x^3*(y + 1)^2))", "0 when x != 0, y + 1 != 0", ""),
        ("x/2 - 0.25*y", "(2*x - y)/4", "\\frac{2 x - y}{4}"),
    ] {
        let f = read(text, &scope);
        assert_eq!(f.plain(scope.context()), plain);
        if !latex.is_empty() {
            assert_eq!(f.latex(scope.context()), latex);
        }
    }
    let all = read("x/(x^2 - x)", &scope).conditions();
    assert_eq!(non_zero(&all)[..].plain(scope.context()), "x != 0, x - 1 != 0");
    assert_eq!(read("y/x", &scope).to_string(), "x1/x0");
}

/// i_x = (1 − k)/(2α) from the premises of the paper, each solved for one symbol. The premises are
/// the definitions of the slips, tangential and angular momentum, and those of k, i_x and α.
#[test]
fn equation_nine_follows_by_substitution() {
    let scope = scope("ix k alpha vpx vpx0 vx omega vx0 omega0 r m J Ix Iy mu");
    let symbol = |name: &str| match parse_expr(name, &scope) {
        Ok(Expr::Var(index)) => index,
        other => panic!("{other:?}"),
    };
    // parsed before the clock runs
    let parsed = |text: &str| parse_expr(text, &scope).expect("well-formed");
    let difference = parsed("ix - (1 - k)/(2*alpha)");
    let solved = [
        ("ix", "Ix/(mu*Iy)"),
        ("k", "vpx/vpx0"),
        ("alpha", "1/2*(J + m*r^2)*mu*Iy/(J*m*vpx0)"),
        ("vpx", "vx - omega*r"),
        ("vx", "vx0 - Ix/m"),
        ("omega", "omega0 + r*Ix/J"),
        ("vpx0", "vx0 - omega0*r"),
    ]
    .map(|(name, value)| (symbol(name), parsed(value)));
    let mut fastest = None;
    for _ in 0..20 {
        let start = Instant::now();
        let read = |e| RationalFunction::from_expr(e, scope.context()).expect("rational");
        let rest = solved.iter().fold(read(&difference), |f, (symbol, value)| {
            f.substitute(&[(*symbol, read(value))]).expect("defined")
        });
        assert!(rest.is_zero());
        let time = start.elapsed();
        assert_eq!(
            non_zero(&rest.conditions())[..].plain(scope.context()),
            "m != 0, J != 0, Iy != 0, mu != 0, omega0*r - vx0 != 0, r^2*m + J != 0"
        );
        fastest = Some(fastest.map_or(time, |f: std::time::Duration| f.min(time)));
    }
    println!("equation (9) by substitution: {:?}", fastest.expect("ran"));
}
