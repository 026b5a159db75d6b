use kane_algebra::syntax::{
    Evaluator, Notation, Parser, Scope, latex_name, mathml_name, parse_expr, placeholder, put_in,
};
use kane_kernel::{Bound, Expr, Var};
use num_rational::BigRational;

use super::ratio;

const N: usize = 1;

/// q between 0 and 1, an index n, and the sequence s(0) = q, s(n + 1) = 2·s(n) + n·qⁿ.
fn scope() -> Scope {
    let mut scope = Scope::default();
    let end = |n, strict| Some(Bound { value: ratio(n, 1), strict });
    let q = Var { name: "q".to_owned(), of: None, lower: end(0, true), upper: end(1, true) };
    scope.declare(q).expect("free");
    scope.declare_index("n").expect("free");
    scope.declare_power("q", Expr::Var(0), N).expect("free");
    scope.declare_power("2", Expr::int(2), N).expect("free");
    let step = Expr::Add(
        Expr::Mul(Expr::int(2).into(), placeholder(0).into()).into(),
        parse_expr("n*q^n", &scope).expect("well-formed").into(),
    );
    let next = |term: &Expr| put_in(&step, std::slice::from_ref(term));
    scope.declare_recursion("s", N, Expr::Var(0), next).expect("free");
    let twice = parse_expr("s(n) + s(n + 1)", &scope).expect("well-formed");
    scope.declare_sequence("u", N, twice).expect("free");
    scope
}

/// The value where q is 2/3, without an index.
fn value(e: &Expr, scope: &Scope) -> BigRational {
    let none = ratio(0, 1);
    let values = vec![ratio(2, 3), none.clone(), none.clone(), none.clone(), none];
    Evaluator::new(scope.context(), &values).value(e).expect("a value")
}

/// s(k), walked.
fn walked(k: u32) -> BigRational {
    let (mut s, mut power) = (ratio(2, 3), ratio(1, 1));
    for n in 0..k {
        s = ratio(2, 1) * s + BigRational::from_integer(n.into()) * &power;
        power *= ratio(2, 3);
    }
    s
}

#[test]
fn one_step_further_at_a_number_is_at_the_next_number() {
    let scope = scope();
    for text in
        ["n", "q^n", "q^(2*n + 3)*2^n", "s(n)", "s(n + 2) - n^2", "u(n)", "abs(s(n) - u(n + 1))"]
    {
        let e = parse_expr(text, &scope).expect("well-formed");
        let next = scope.sequences().next(&e, N).expect("short");
        for k in 0..6 {
            let at = |e: &Expr, k| value(&scope.sequences().at(e, N, k).expect("short"), &scope);
            assert_eq!(at(&next, k), at(&e, k + 1), "{text} at {k}");
        }
    }
}

#[test]
fn terms_at_numbers_are_those_of_the_walk() {
    let scope = scope();
    for k in 0..8 {
        let term = parse_expr(&format!("s({k})"), &scope).expect("well-formed");
        assert_eq!(value(&term, &scope), walked(k), "s({k})");
        let both = parse_expr(&format!("u({k})"), &scope).expect("well-formed");
        assert_eq!(value(&both, &scope), walked(k) + walked(k + 1), "u({k})");
    }
}

#[test]
fn what_is_printed_of_powers_and_terms_reads_back() {
    let scope = scope();
    for text in ["q^n", "q^(n + 1)", "(q^n)^2", "q^(2*n)", "2^n*s(n)", "s(n + 1)^2", "pow(q, n)"] {
        let e = parse_expr(text, &scope).expect("well-formed");
        let printed = e.plain(scope.context());
        assert_eq!(parse_expr(&printed, &scope).as_ref(), Ok(&e), "{text} as {printed}");
        let known = Scope::of(scope.context());
        assert_eq!(
            parse_expr(&printed, &known).as_ref(),
            Ok(&e),
            "{text} as {printed}, found again"
        );
    }
    assert_eq!(latex_name("pow(q, n)"), "\\left(q^{n}\\right)");
}

#[test]
fn what_is_printed_of_sums_reads_back() {
    let mut scope = scope();
    for name in
        ["sum(k^2 for k in 1..n)", "prod(1 + 1/k for k in 2..n + 1)", "sum(q^k for k in 0..n)"]
    {
        let sum = Parser::new(name, 0, &scope).sum_to_declare().expect("it is one");
        scope.declare_sum(name, sum).expect("a new one");
        let e = parse_expr(&format!("2*{name} + 1"), &scope).expect("well-formed");
        let printed = e.plain(scope.context());
        assert_eq!(printed, format!("2*{name} + 1"));
        assert_eq!(parse_expr(&printed, &Scope::of(scope.context())).as_ref(), Ok(&e), "{printed}");
    }
    let value = |text: &str| value(&parse_expr(text, &scope).expect("well-formed"), &scope);
    assert_eq!(value("sum(k^2 for k in 1..4)"), ratio(30, 1));
    assert_eq!(value("prod(1 + 1/k for k in 2..5)"), ratio(3, 1));
    assert_eq!(value("sum(k for k in 3..2) + prod(k for k in 3..2)"), ratio(1, 1));
    assert_eq!(
        latex_name("sum(k^(2*j) for k in 1..n)"),
        "\\left(\\sum_{k=1}^{n} k^{2\\,j}\\right)"
    );
    assert!(mathml_name("prod(1/k^2 for k in 1..n)").contains("<munderover><mo>∏</mo>"));
}

#[test]
fn a_power_is_bounded_as_its_base_says() {
    let scope = scope();
    let vars = &scope.context().vars;
    let power = vars.iter().find(|var| var.name == "pow(q, n)").expect("declared");
    let of = |bound: &Option<Bound>| bound.as_ref().map(|b| (b.value.clone(), b.strict));
    assert_eq!(of(&power.lower), Some((ratio(0, 1), true)));
    assert_eq!(of(&power.upper), Some((ratio(1, 1), false)), "1 at n = 0");
}

#[test]
fn what_cannot_be_written_out_is_refused() {
    let scope = scope();
    for (text, why) in [
        ("q^(n - 1)", "natural factors"),
        ("q^(-n)", "natural factors"),
        ("q^(n*n)", "natural factors"),
        ("q^(n/2)", "natural factors"),
        ("q^(n + 0.5)", "natural factors"),
        ("n^n", "the base"),
        ("(1 + q)^n", "the base"),
        ("3^n", "no symbol"),
        ("s(n - 1)", "at its index"),
        ("s(2*n)", "at its index"),
        ("s(q)", "at its index"),
        ("s(65)", "too much"),
        ("s(99999999999)", "at its index"),
        ("s + 1", "takes its index"),
    ] {
        let faults = parse_expr(text, &scope).expect_err(text);
        assert!(faults.iter().any(|f| f.to_string().contains(why)), "{text}: {faults:?}");
    }
}
