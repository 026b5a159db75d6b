use kane_algebra::syntax::{
    MAX_DIGITS, MAX_HEIGHT, MAX_NESTING, Notation, Scope, SyntaxErrorKind, eval, parse_expr,
    parse_relations,
};
use kane_kernel::Expr;

use super::{ratio, scope};

/// The greatest height as a value.
const HEIGHT: i64 = 1000;

/// The first fault; the text itself is too long to be shown.
fn first_error(text: &str) -> SyntaxErrorKind {
    let outcome = parse_expr(text, &scope()).map(|_| "accepted");
    outcome.expect_err("beyond a limit").swap_remove(0).kind
}

#[test]
fn nesting_is_limited_in_all_its_forms() {
    let wrap = |open: &str, close: &str, depth: usize| {
        format!("{}x{}", open.repeat(depth), close.repeat(depth))
    };
    for (open, close) in [
        ("(", ")"),
        ("-", ""),
        ("abs(", ")"),
        ("min(1, ", ")"),
        ("cases { x > 0: ", " }"),
        ("cases { ", " > 0: 1 }"),
    ] {
        let good = wrap(open, close, MAX_NESTING);
        parse_expr(&good, &scope()).unwrap_or_else(|e| panic!("{open}: {e:?}"));
        assert_eq!(first_error(&wrap(open, close, MAX_NESTING + 1)), SyntaxErrorKind::TooNested);
        assert_eq!(first_error(&wrap(open, close, 1_000_000)), SyntaxErrorKind::TooNested);
    }
    for (open, close) in [("(", ")"), ("x < 1 or (", ")"), ("x < 1 implies (", ")")] {
        let formula = |depth| format!("{}x > 0{}", open.repeat(depth), close.repeat(depth));
        parse_relations(&formula(MAX_NESTING), &scope())
            .unwrap_or_else(|e| panic!("{open}: {e:?}"));
        let errors = parse_relations(&formula(MAX_NESTING + 1), &scope()).expect_err("too deep");
        assert_eq!(errors[0].kind, SyntaxErrorKind::TooNested);
    }
    let tower = format!("x{}", "^1".repeat(1_000_000));
    assert_eq!(first_error(&tower), SyntaxErrorKind::TooNested);
}

#[test]
fn the_tallest_expression_survives_every_walk() {
    let tall = format!("x{}", " + 1".repeat(MAX_HEIGHT - 1));
    let scope = scope();
    let e = parse_expr(&tall, &scope).expect("just tall enough");
    assert_eq!(scope.height(&e), MAX_HEIGHT);
    assert_eq!(i64::try_from(MAX_HEIGHT), Ok(HEIGHT));
    let context = scope.context();
    assert_eq!(e.plain(context), tall);
    assert!(e.latex(context).len() >= tall.len());
    let copy = e.clone();
    assert_eq!(copy, e);
    let value = eval(&e, context, &[ratio(0, 1)]);
    assert_eq!(value, Ok(ratio(HEIGHT - 1, 1)));
    assert_eq!(first_error(&format!("{tall} + 1")), SyntaxErrorKind::TooTall);
}

#[test]
fn nested_groups_of_tall_sums_survive_too() {
    let sum = " + 1".repeat(MAX_HEIGHT / MAX_NESTING - 1);
    let text = format!(
        "d({}x{}, x)",
        "sqrt(".repeat(MAX_NESTING - 1),
        format!("{sum})").repeat(MAX_NESTING - 1)
    );
    let scope = scope();
    let e = parse_expr(&text, &scope).unwrap_or_else(|e| panic!("{e:?}"));
    assert_eq!(e.plain(scope.context()), text);
    // an irrational root, found at the bottom
    assert!(eval(&e, scope.context(), &[ratio(3, 1)]).is_err());
}

#[test]
fn definitions_count_for_the_height() {
    let mut scope = Scope::default();
    let mut last = "1".to_owned();
    for i in 1..=MAX_HEIGHT / 2 - 1 {
        let body =
            parse_expr(&format!("{last} + 1"), &scope).unwrap_or_else(|e| panic!("{i}: {e:?}"));
        last = format!("a{i}");
        scope.define(&last, body).expect("a new name");
    }
    let top = parse_expr(&last, &scope).expect("just tall enough");
    assert_eq!(eval(&top, scope.context(), &[]), Ok(ratio(HEIGHT / 2, 1)));
    let errors = parse_expr(&format!("({last} + 1)*2 + 1"), &scope).expect_err("too tall");
    assert_eq!(errors[0].kind, SyntaxErrorKind::TooTall);
}

#[test]
fn shared_definitions_are_evaluated_once() {
    let mut scope = Scope::default();
    let mut last = "1".to_owned();
    for i in 0..100 {
        let body = parse_expr(&format!("{last}/2 + {last}/2"), &scope).expect("well-formed");
        last = format!("a{i}");
        scope.define(&last, body).expect("a new name");
    }
    let top = parse_expr(&last, &scope).expect("well-formed");
    assert_eq!(eval(&top, scope.context(), &[]), Ok(ratio(1, 1)));
}

#[test]
fn literals_are_limited() {
    let digits = "7".repeat(MAX_DIGITS);
    let e = parse_expr(&digits, &scope()).expect("just short enough");
    assert_eq!(e.plain(scope().context()), digits);
    let long = format!("{digits}7");
    assert_eq!(first_error(&long), SyntaxErrorKind::LiteralTooLong);
    let fraction = format!("0.{}", "7".repeat(MAX_DIGITS - 1));
    let e = parse_expr(&fraction, &scope()).expect("just short enough");
    assert!(matches!(&e, Expr::Num(_)));
    assert_eq!(e.plain(scope().context()), fraction);
    assert_eq!(first_error(&format!("{fraction}7")), SyntaxErrorKind::LiteralTooLong);
}
