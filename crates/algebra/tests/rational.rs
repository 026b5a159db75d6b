//! Rational functions, their limits, signs and cases: each answer found in two independent ways.

use std::cmp::Ordering;
use std::time::Instant;

use kane_algebra::limit::{Extended, Limit, limit};
use kane_algebra::piecewise::Piecewise;
use kane_algebra::rational_function::{NotRational, RationalFunction, non_zero};
use kane_algebra::ring;
use kane_algebra::sign::{Domain, NoSign, pieces, witness};
use kane_algebra::syntax::{Notation, Scope, eval, parse_expr};
use kane_kernel::{Approach, Bound, Context, Expr, Fuel, Poly, Rel, Root, Var};
use kane_number::{Number, Rational, testkit};
use num_traits::{Signed, Zero};
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
                p.add_term(powers.collect(), c.into());
            }
            p
        })
        .prop_filter("not zero", |p| !p.is_empty())
}

fn times(p: &Poly, q: &Poly) -> Poly {
    p.mul(q, &Fuel::new(u64::MAX)).expect("fuel without end")
}

/// Π (x − root)
fn with_roots(roots: &[Rational]) -> RationalFunction {
    let factor = |r: &Rational| RationalFunction::symbol(0) - RationalFunction::from(r.clone());
    roots.iter().map(factor).fold(RationalFunction::one(), |p, f| p * f)
}

/// Rational functions of x with small rational, irrational and common roots.
fn univariate() -> impl Strategy<Value = RationalFunction> {
    let polynomial = prop_oneof![
        prop::collection::vec(number(), 0..3).prop_map(|roots| with_roots(&roots)),
        prop::collection::vec(-3i64..=3, 1..5).prop_map(|coefficients| {
            let power = |n| RationalFunction::symbol(0).powi(n).expect("n ≥ 0");
            coefficients.iter().zip(0..).fold(RationalFunction::zero(), |sum, (c, n)| {
                sum + power(n) * RationalFunction::from(ratio(*c, 1))
            })
        }),
    ];
    (polynomial.clone(), polynomial.clone(), polynomial)
        .prop_filter_map("a divisor", |(n, d, g)| (n * &g).checked_div(&(d * g)))
}

fn domain() -> impl Strategy<Value = Domain> {
    let end = || {
        prop::option::of(
            (number(), any::<bool>()).prop_map(|(value, strict)| Bound { value, strict }),
        )
    };
    (end(), end()).prop_map(|(lower, upper)| Domain { lower, upper })
}

fn relation() -> impl Strategy<Value = Rel> {
    prop::sample::select(vec![Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge])
}

fn holds(rel: Rel, value: &Rational) -> bool {
    match rel {
        Rel::Eq => value.is_zero(),
        Rel::Ne => !value.is_zero(),
        Rel::Lt => value.is_negative(),
        Rel::Le => !value.is_positive(),
        Rel::Gt => value.is_positive(),
        Rel::Ge => !value.is_negative(),
    }
}

fn fuel() -> Fuel {
    Fuel::new(1 << 40)
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

    /// (f(x + h) − f(x))/h cancels h, and tends to the derivative.
    #[test]
    fn the_derivative_is_the_limit_of_difference_quotients(f in function()) {
        let h = RationalFunction::symbol(3);
        let moved = f.substitute(&[(0, RationalFunction::symbol(0) + &h)]);
        prop_assume!(moved.is_ok());
        let quotient = (moved.unwrap() - &f) / &h;
        let tends = limit(&quotient, 3, &Approach::To(ratio(0, 1))).unwrap();
        prop_assert_eq!(tends, Some(Limit::Finite(f.derivative(0))));
    }

    #[test]
    fn text_reads_back_as_the_same_function(f in function()) {
        let scope = xyz();
        let text = f.to_expr().plain(scope.context());
        prop_assert_eq!(&read(&text, &scope), &f);
        let shown = f.to_string();
        prop_assert_eq!(shown.contains(" when "), !f.cancelled().is_empty(), "{}", shown);
    }

    /// f = (x − a)ᵏ·u/w with u(a), w(a) ≠ 0 against what k says.
    #[test]
    fn limits_at_points_follow_the_planted_order(
        u in univariate(), a in number(), k in -3i32..=3, above in any::<bool>(),
    ) {
        let t = with_roots(std::slice::from_ref(&a));
        let at = u.eval(std::slice::from_ref(&a));
        prop_assume!(at.as_ref().is_some_and(|v| !v.is_zero()));
        let at = at.unwrap();
        let f = t.powi(k).unwrap() * &u;
        let place = if above { Approach::Above(a.clone()) } else { Approach::Below(a.clone()) };
        let found = limit(&f, 0, &place).unwrap().and_then(|l| l.at(&[]));
        let odd = !above && k % 2 != 0;
        let expected = match k.cmp(&0) {
            Ordering::Greater => Extended::Finite(ratio(0, 1)),
            Ordering::Equal => Extended::Finite(at),
            Ordering::Less if at.is_positive() != odd => Extended::PlusInf,
            Ordering::Less => Extended::MinusInf,
        };
        prop_assert_eq!(found, Some(expected.clone()));
        let both = limit(&f, 0, &Approach::To(a)).unwrap().and_then(|l| l.at(&[]));
        prop_assert_eq!(both, (k >= 0 || k % 2 == 0).then_some(expected));
    }

    /// Values ever nearer to the place approach the limit, without bound where it is infinite.
    #[test]
    fn limits_are_approached(f in univariate(), a in number(), side in 0usize..4) {
        let place = match side {
            0 => Approach::Above(a.clone()),
            1 => Approach::Below(a.clone()),
            2 => Approach::PlusInf,
            _ => Approach::MinusInf,
        };
        let found = limit(&f, 0, &place).unwrap().and_then(|l| l.at(&[])).expect("one symbol");
        let near = |bits: i32| {
            let t = ratio(2, 1).pow(-bits);
            let x = match side {
                0 => &a + t,
                1 => &a - t,
                2 => t.recip(),
                _ => -t.recip(),
            };
            f.eval(&[x]).expect("no pole so near")
        };
        let (far, near) = (near(40), near(80));
        match found {
            Extended::Finite(l) => {
                let (far, near) = ((far - &l).abs(), (near - l).abs());
                // the error is of first order at least
                prop_assert!(near <= far * ratio(2, 1).pow(-39), "{f} at {place:?}");
            }
            Extended::PlusInf => prop_assert!(far.is_positive() && near > far * ratio(2, 1).pow(39)),
            Extended::MinusInf => prop_assert!(far.is_negative() && near < far * ratio(2, 1).pow(39)),
        }
    }

    #[test]
    fn the_limit_at_infinity_is_that_of_the_reciprocal_at_zero(f in univariate()) {
        let reciprocal = RationalFunction::one() / RationalFunction::symbol(0);
        let turned = f.substitute(&[(0, reciprocal)]).unwrap();
        for (far, near) in [
            (Approach::PlusInf, Approach::Above(ratio(0, 1))),
            (Approach::MinusInf, Approach::Below(ratio(0, 1))),
        ] {
            prop_assert_eq!(limit(&f, 0, &far).unwrap(), limit(&turned, 0, &near).unwrap());
        }
    }

    /// Where the conditions of a limit with parameters hold, it is the limit at those parameters.
    #[test]
    fn parameters_may_be_fixed_before_or_after_the_limit(f in function(), p in point(), a in number()) {
        for place in [Approach::Above(a.clone()), Approach::Below(a), Approach::PlusInf] {
            let general = limit(&f, 0, &place).unwrap().expect("one-sided");
            let Some(general) = general.at(&p) else { continue };
            let fixed = [(1, p[1].clone().into()), (2, p[2].clone().into())];
            let fixed = f.substitute(&fixed).expect("defined beside the place");
            let special = limit(&fixed, 0, &place).unwrap().and_then(|l| l.at(&[]));
            prop_assert_eq!(special, Some(general));
        }
    }

    #[test]
    fn signs_are_those_of_values(
        f in univariate(), domain in domain(),
        samples in prop::collection::vec((-40i64..=40, 1i64..=12), 16),
    ) {
        let pieces = pieces(&f, &domain, &fuel()).unwrap();
        let below = |x: &Rational, r: &Root| if r.is_exact() { *x < r.lo } else { *x <= r.lo };
        let above = |x: &Rational, r: &Root| if r.is_exact() { *x > r.hi } else { *x >= r.hi };
        for (n, d) in samples {
            let x = ratio(n, d);
            // pieces that may hold x; several if x lies within the bracket of an irrational edge
            let may_hold: Vec<_> = pieces.iter().filter(|piece| {
                let lower = piece.lower.as_ref().is_none_or(|e| {
                    !below(&x, &e.at) && (e.included || !e.at.is_exact() || x != e.at.lo)
                });
                let upper = piece.upper.as_ref().is_none_or(|e| {
                    !above(&x, &e.at) && (e.included || !e.at.is_exact() || x != e.at.hi)
                });
                lower && upper
            }).collect();
            prop_assert_eq!(!may_hold.is_empty(), domain.contains(&x), "{} at {}", f, x);
            if let [piece] = may_hold[..] {
                let sign = f.eval(std::slice::from_ref(&x)).map(|v| v.cmp(&ratio(0, 1)));
                prop_assert_eq!(piece.sign, sign, "{} at {}", f, x);
            }
        }
        for pair in pieces.windows(2) {
            prop_assert_ne!(pair[0].sign, pair[1].sign);
            let (left, right) = (pair[0].upper.as_ref().unwrap(), pair[1].lower.as_ref().unwrap());
            prop_assert_eq!(&left.at, &right.at);
            prop_assert!(left.included != right.included);
        }
        for piece in &pieces {
            if let Some(x) = piece.simplest() {
                prop_assert!(domain.contains(&x));
                prop_assert_eq!(piece.sign, f.eval(&[x]).map(|v| v.cmp(&ratio(0, 1))));
            }
        }
    }

    /// All rationals of small denominator are tried.
    #[test]
    fn the_witness_is_the_simplest_point_of_failure(
        f in univariate(), domain in domain(), rel in relation(),
    ) {
        let found = witness(&f, rel, &domain, &fuel()).unwrap();
        let fails = |x: &Rational| {
            domain.contains(x) && f.eval(std::slice::from_ref(x)).is_some_and(|v| !holds(rel, &v))
        };
        let mut tried = (1i64..=6).flat_map(|d| (0..=60).flat_map(move |n| [(n, d), (-n, d)]));
        let first = tried.find(|&(n, d)| ratio(n, d).denom() == &d.into() && fails(&ratio(n, d)));
        match (&found, first) {
            (Some(root), Some((n, d))) => {
                prop_assert!(root.is_exact());
                prop_assert_eq!(&root.lo, &ratio(n, d));
            }
            (Some(root), None) if root.is_exact() => {
                prop_assert!(fails(&root.lo));
                prop_assert!(*root.lo.denom() > 6.into() || root.lo.abs() > ratio(10, 1));
            }
            // only an irrational root fails; it is one of the numerator
            (Some(root), None) => {
                let num = ring::univariate(&f.fraction().0, 0).unwrap();
                let ends = [&root.lo, &root.hi].map(|x| kane_kernel::sign_at(&num, x));
                prop_assert!(ends[0] * ends[1] <= 0 || rel != Rel::Ne);
            }
            (None, first) => prop_assert_eq!(first, None),
        }
    }

    #[test]
    fn cases_evaluate_as_the_evaluator_does(
        sides in prop::collection::vec((expr(), relation(), expr()), 2),
        bodies in prop::collection::vec(expr(), 3), otherwise in any::<bool>(),
        points in prop::collection::vec(point(), 8),
    ) {
        let scope = xyz();
        let guard = |(lhs, rel, rhs): (Expr, Rel, Expr)| vec![kane_kernel::Relation { lhs, rel, rhs }];
        let branches = sides.into_iter().map(guard).zip(bodies.iter().cloned()).collect();
        let e = Expr::Cases(branches, otherwise.then(|| bodies[2].clone().into()));
        let Ok(f) = Piecewise::from_expr(&e, scope.context()) else { return Ok(()) };
        for p in points {
            prop_assert_eq!(f.eval(&p), eval(&e, scope.context(), &p).ok());
        }
    }

    /// One formula cut in two is continuous at the cut exactly where it has a value.
    #[test]
    fn a_function_cut_in_two_stays_continuous(f in univariate(), jump in number(), a in number()) {
        let x = RationalFunction::symbol(0) - RationalFunction::from(a.clone());
        let guard = kane_algebra::piecewise::Guard { difference: x, rel: Rel::Lt };
        let shifted = f.clone() + RationalFunction::from(jump.clone());
        let whole = Piecewise { branches: vec![(vec![guard], f.clone()), (vec![], shifted)] };
        let there = whole.at_breakpoint(0, &a).unwrap();
        let value = f.eval(std::slice::from_ref(&a));
        prop_assert_eq!(there.is_continuous(), value.is_some() && jump.is_zero());
        prop_assert_eq!(there.value, value.map(|v| v + jump));
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

#[test]
fn a_generic_limit_names_the_lead_it_divides_by() {
    let scope = scope("x a b c e");
    let f = read("(a*x + b)/(c*x + e)", &scope);
    let at_infinity = limit(&f, 0, &Approach::PlusInf).unwrap();
    let Some(Limit::Finite(value)) = &at_infinity else { panic!("{at_infinity:?}") };
    assert_eq!(value.plain(scope.context()), "a/c");
    let point = |c: i64| [0, 6, 1, c, 1].map(|n| ratio(n, 1));
    let limit_at = |c| at_infinity.as_ref().and_then(|l| l.at(&point(c)));
    assert_eq!(limit_at(3), Some(Extended::Finite(ratio(2, 1))));
    // where the lead vanishes nothing is said
    assert_eq!(limit_at(0), None);
    let pole = limit(&read("a/x", &scope), 0, &Approach::Below(ratio(0, 1))).unwrap();
    let Some(Limit::Infinite(sign)) = pole else { panic!("{pole:?}") };
    assert_eq!(sign.plain(scope.context()), "-a when a != 0");
    assert_eq!(limit(&read("a/x", &scope), 0, &Approach::To(ratio(0, 1))), Ok(None));
    // zero too rests on the lead: without c it is infinite
    let zero = limit(&read("x/(c*x^2 + 1)", &scope), 0, &Approach::PlusInf).unwrap();
    let Some(Limit::Finite(value)) = zero else { panic!("{zero:?}") };
    assert_eq!(value.plain(scope.context()), "0 when c != 0");
    // the condition on b outlives its cancellation
    let hidden = limit(&read("b*x/b", &scope), 0, &Approach::To(ratio(2, 1))).unwrap();
    let Some(Limit::Finite(value)) = hidden else { panic!("{hidden:?}") };
    assert_eq!(value.plain(scope.context()), "2 when b != 0");
}

#[test]
fn an_irrational_zero_is_the_witness_only_if_no_rational_fails() {
    let scope = scope("x y");
    let f = read("(x^2 - 2)^2", &scope);
    let positive = Domain { lower: Some(Bound { value: ratio(0, 1), strict: true }), upper: None };
    let root = witness(&f, Rel::Gt, &positive, &fuel()).unwrap().expect("√2");
    assert!(!root.is_exact() && root.lo < ratio(3, 2) && root.hi > ratio(7, 5));
    assert_eq!(witness(&f, Rel::Ge, &positive, &fuel()), Ok(None));
    let simple = witness(&read("x^2 - 2", &scope), Rel::Le, &positive, &fuel()).unwrap();
    assert_eq!(simple.map(|r| r.lo), Some(ratio(2, 1)));
    let several = read("x*y", &scope);
    assert_eq!(pieces(&several, &positive, &fuel()), Err(NoSign::SeveralSymbols));
    assert!(matches!(pieces(&f, &positive, &Fuel::new(1)), Err(NoSign::Budget(_))));
}

#[test]
fn cases_that_meet_are_continuous_and_those_that_jump_are_not() {
    let scope = scope("x");
    for (text, at, continuous) in [
        ("cases { x < 1: x; else: 1/x }", 1, true),
        ("cases { x < 1: x; else: 2/x }", 1, false),
        ("cases { x < 1: x; x > 1: 1/x }", 1, false),
        ("cases { x = 1: 1; else: (x^2 - 1)/(2*x - 2) }", 1, true),
        ("cases { x = 1: 2; else: (x^2 - 1)/(2*x - 2) }", 1, false),
        ("cases { 1/(x - 1) > 0: x; else: x }", 1, false),
        ("cases { x <= 0: 0; else: 1/x }", 0, false),
        ("x^2/x", 1, true),
        ("x^2/x", 0, false),
    ] {
        let f = Piecewise::from_expr(&parse_expr(text, &scope).unwrap(), scope.context()).unwrap();
        let there = f.at_breakpoint(0, &ratio(at, 1)).unwrap();
        assert_eq!(there.is_continuous(), continuous, "{text}: {there:?}");
    }
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
