use kane_algebra::syntax::{NoValue, eval, holds, parse_expr, parse_relations};
use kane_kernel::{Definition, Expr};
use num_rational::BigRational;

use super::{ratio, scope};

/// The value at x, y = 3, mu = 1/2, alpha = 2, k = -1.
fn at(x: i64, text: &str) -> Result<BigRational, NoValue> {
    let scope = scope();
    let e = parse_expr(text, &scope).expect(text);
    let point = [ratio(x, 1), ratio(3, 1), ratio(1, 2), ratio(2, 1), ratio(-1, 1)];
    eval(&e, scope.context(), &point)
}

#[test]
fn values_are_exact() {
    for (x, text, n, d) in [
        (2, "x^2 - y/x", 5, 2),
        (2, "-x^2", -4, 1),
        (2, "x^-3*mu", 1, 16),
        (0, "x^0", 1, 1),
        (2, "f + k", 4, 1),
        (-2, "abs(x) + min(x, y) + max(x, y)", 3, 1),
        (4, "sqrt(x/9)", 2, 3),
        (1, "cases { x < 1: 1/0.5; x = 1: 7; else: 9 }", 7, 1),
        (5, "cases { x < 1: 1; 1/(x - 5 + 1) > 0, x > 9: 2; else: 3 }", 3, 1),
    ] {
        assert_eq!(at(x, text), Ok(ratio(n, d)), "{text} at {x}");
    }
}

/// Two looks at each would be 2^100 at the innermost.
#[test]
fn magnitudes_within_each_other_are_looked_at_once() {
    let text = format!("{}x{}", "|".repeat(100), " + 1|".repeat(100));
    // |-7 + 1|, and then one more each time
    assert_eq!(at(-7, &text), Ok(ratio(105, 1)));
}

#[test]
fn each_reason_for_no_value_is_told() {
    for (x, text, reason) in [
        (0, "1/x", NoValue::DivisionByZero),
        (0, "x^-2", NoValue::DivisionByZero),
        (0, "0/x", NoValue::DivisionByZero),
        (-1, "0*sqrt(x)", NoValue::NegativeRadicand),
        (2, "sqrt(x)", NoValue::Irrational),
        (0, "sqrt(2) + 1/x", NoValue::DivisionByZero),
        (1, "cases { x < 1: 0; x > 1: 1 }", NoValue::NoCase),
        (0, "cases { 1/x > 0: 0; else: 1 }", NoValue::DivisionByZero),
        (2, "(x^10000)^10000", NoValue::TooLarge),
    ] {
        assert_eq!(at(x, text), Err(reason), "{text} at {x}");
    }
}

#[test]
fn only_the_branch_taken_counts() {
    assert_eq!(at(0, "cases { x = 0: 1; else: 1/x }"), Ok(ratio(1, 1)));
    assert_eq!(at(1, "cases { x > 1, 1/(x - 1) > 0: 1; else: 0 }"), Ok(ratio(0, 1)));
}

#[test]
fn derivatives_are_exact() {
    for (x, text, n, d) in [
        (2, "d(x^3, x)", 12, 1),
        (2, "d(1/x, x)", -1, 4),
        (2, "d(x^-2, x)", -1, 4),
        (4, "d(sqrt(x), x)", 1, 4),
        (2, "d(x*y^2, y)", 12, 1),
        (2, "d(f, x)", 4, 1),
        (2, "d(f*f, x)", 40, 1),
        (2, "d(d(x^4, x), x)", 48, 1),
        (2, "d(d(x^2*y^3, x), y)", 108, 1),
        (2, "d(x*d(x^2, x), x)", 8, 1),
        (-2, "d(abs(x), x)", -1, 1),
        (2, "d(min(x^2, y), x)", 0, 1),
        (2, "d(k*x, x)", -1, 1),
        (2, "d(alpha, x)", 0, 1),
        (0, "d(cases { abs(x) < 1: x; else: 0 }, x)", 1, 1),
        (0, "d(x^0, x)", 0, 1),
        (0, "d(min(abs(x), -1), x)", 0, 1),
        (0, "d(abs(y - 3)*x, x)", 0, 1),
        (0, "d(sqrt(y - 3)*x, x)", 0, 1),
        (2, "d(d(abs(x)*x^2, x), x)", 12, 1),
        (0, "d(cases { max(x, -x) < 1: x; else: 2 }, x)", 1, 1),
        (3, "d((x + 1)/(x - 1), x)", -1, 2),
    ] {
        assert_eq!(at(x, text), Ok(ratio(n, d)), "{text} at {x}");
    }
}

#[test]
fn derivatives_stop_at_boundaries() {
    for (x, text) in [
        (0, "d(abs(x), x)"),
        (0, "d(sqrt(x), x)"),
        (3, "d(min(x, y), x)"),
        (1, "d(cases { x < 1: x; else: 1 }, x)"),
        (1, "d(cases { x >= 1: x; else: 1 }, x)"),
        (0, "d(cases { x^2 <= 0: x; else: 2*x }, x)"),
        (0, "d(cases { sqrt(min(0, x)) > -1: x; else: 5 }, x)"),
        (0, "d(abs(x)^0, x)"),
        (0, "d(cases { cases { x < 0: 1; else: 2 } > 0: x; else: 5 }, x)"),
        (3, "d(d(abs(x - y), x), x)"),
    ] {
        assert_eq!(at(x, text), Err(NoValue::NotDifferentiable), "{text} at {x}");
    }
    assert_eq!(at(0, "d(x/x, x)"), Err(NoValue::DivisionByZero));
    assert_eq!(at(0, "d(cases { x - x > 0: x; else: 5 }, x)"), Err(NoValue::Unsettled));
}

#[test]
fn definitions_that_double_are_followed_once_near_a_point() {
    // a(0) = x + 1, a(n) = a(n − 1) + a(n − 1): the side of the guard in |a(60)| has 2^60 parts
    let mut context = scope().context().clone();
    let first = context.lets.len();
    let mut body = parse_expr("x + 1", &scope()).expect("it is well formed");
    for i in 0..=60 {
        context.lets.push(Definition { name: format!("a{i}"), body });
        let half = || Expr::Let(first + i).into();
        body = Expr::Add(half(), half());
    }
    let slope = Expr::Deriv(Expr::Abs(Expr::Let(first + 60).into()).into(), 0);
    let slope_at = |x| eval(&slope, &context, &[ratio(x, 1)]);
    assert_eq!(slope_at(0), Ok(ratio(1 << 60, 1)));
    assert_eq!(slope_at(-2), Ok(ratio(-(1 << 60), 1)));
    assert_eq!(slope_at(-1), Err(NoValue::NotDifferentiable));
}

#[test]
fn relations_hold_fail_or_have_no_truth() {
    let scope = scope();
    let point = [ratio(0, 1), ratio(3, 1)];
    for (text, truth) in [
        ("x < y", Ok(true)),
        ("x >= y", Ok(false)),
        ("x != y", Ok(true)),
        ("x = 0", Ok(true)),
        ("1/x = 1/x", Err(NoValue::DivisionByZero)),
        ("sqrt(2) > 1", Err(NoValue::Irrational)),
        ("mu = 0", Err(NoValue::Unassigned)),
    ] {
        let relation = &parse_relations(text, &scope).expect(text)[0];
        assert_eq!(holds(relation, scope.context(), &point), truth, "{text}");
    }
}
