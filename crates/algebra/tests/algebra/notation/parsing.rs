use kane_algebra::syntax::{
    Notation, SyntaxErrorKind, parse_expr, parse_relations, parse_sentence,
};
use kane_kernel::{Approach, Expr, Link, Target};

use super::{ratio, scope};

/// The expression with all its parentheses.
fn explicit(e: &Expr) -> String {
    match e {
        Expr::Add(a, b) => format!("({}+{})", explicit(a), explicit(b)),
        Expr::Sub(a, b) => format!("({}-{})", explicit(a), explicit(b)),
        Expr::Mul(a, b) => format!("({}*{})", explicit(a), explicit(b)),
        Expr::Div(a, b) => format!("({}/{})", explicit(a), explicit(b)),
        Expr::Neg(a) => format!("(-{})", explicit(a)),
        Expr::Pow(a, n) => format!("({}^{n})", explicit(a)),
        leaf => leaf.plain(scope().context()),
    }
}

#[test]
fn operators_bind_as_in_print() {
    for (text, meaning) in [
        ("4/3*x", "((4/3)*x)"),
        ("-x^2", "(-(x^2))"),
        ("-x*y", "(-(x*y))"),
        ("-x + y", "((-x)+y)"),
        ("x - y - mu", "((x-y)-mu)"),
        ("x/y/mu", "((x/y)/mu)"),
        ("x/-y*mu", "((x/(-y))*mu)"),
        ("x*-y^2", "(x*(-(y^2)))"),
        ("2^3^2", "(2^9)"),
        ("x^-2", "(x^-2)"),
        ("x^(-2)", "(x^-2)"),
        ("x^-2^2", "(x^-4)"),
        ("x^2.0", "(x^2)"),
        ("--x", "(-(-x))"),
        ("x − y", "(x-y)"),
        ("μ + µ", "(mu+mu)"),
        ("x # a remark\n + y", "(x+y)"),
        ("0.40*x", "(0.4*x)"),
        ("x·y⋅mu × 2", "(((x*y)*mu)*2)"),
        ("-x² + y⁻¹²", "((-(x^2))+(y^-12))"),
        ("1.5e-3*x", "(0.0015*x)"),
        ("1e2 - x", "(100-x)"),
    ] {
        let parsed = parse_expr(text, &scope()).unwrap_or_else(|e| panic!("{text}: {e:?}"));
        assert_eq!(explicit(&parsed), meaning, "text {text}");
    }
}

#[test]
fn functions_and_cases_are_parsed() {
    for (bars, text) in [
        ("|x|", "abs(x)"),
        ("-|x - |y|*2|^2", "-abs(x - abs(y)*2)^2"),
        ("||x| - |y|| + 1", "abs(abs(x) - abs(y)) + 1"),
    ] {
        let parsed = parse_expr(bars, &scope()).unwrap_or_else(|e| panic!("{bars}: {e:?}"));
        assert_eq!(parsed.plain(scope().context()), text);
    }
    for text in [
        "abs(x) + sqrt(y)",
        "min(x, max(y, 1))",
        "d(x^2*y, x)",
        "d(f, x)",
        "cases { x < 1, y != 2: x; 0 <= x < y: y; else: f }",
    ] {
        let parsed = parse_expr(text, &scope()).unwrap_or_else(|e| panic!("{text}: {e:?}"));
        assert_eq!(parsed.plain(scope().context()), text);
    }
    parse_expr("cases { x < 1: x; }", &scope()).expect("a last semicolon is harmless");
}

#[test]
fn chains_and_lists_become_links() {
    let links = parse_relations("0 <= x < 1, x ≠ y = mu ≥ 0", &scope()).expect("well-formed");
    let context = scope().into_context();
    let texts: Vec<String> = links.iter().map(|link| link.plain(&context)).collect();
    assert_eq!(texts, ["0 <= x", "x < 1", "x != y", "y = mu", "mu >= 0"]);
}

#[test]
fn limits_are_parsed() {
    let approach = |text: &str| {
        let text = format!("k -> -1, x*k -> 2 as alpha -> {text} when x > 0");
        let sentence = parse_sentence(&text, &scope()).unwrap_or_else(|e| panic!("{text}: {e:?}"));
        assert_eq!(sentence.when.len(), 1);
        let [Link::Limit(first), Link::Limit(second)] = sentence.links.as_slice() else {
            panic!("two limits")
        };
        assert_eq!(first.at, second.at);
        first.at.clone()
    };
    assert_eq!(approach("0"), Approach::To(ratio(0, 1)));
    assert_eq!(approach("1/2+"), Approach::Above(ratio(1, 2)));
    assert_eq!(approach("-3/4 -"), Approach::Below(ratio(-3, 4)));
    assert_eq!(approach("1 + 2"), Approach::To(ratio(3, 1)));
    assert_eq!(approach("1 - 2-"), Approach::Below(ratio(-1, 1)));
    assert_eq!(approach("oo"), Approach::PlusInf);
    assert_eq!(approach("−∞"), Approach::MinusInf);
    let sentence = parse_sentence("k → -oo as α → ∞", &scope()).expect("well-formed");
    assert!(matches!(&sentence.links[..], [Link::Limit(limit)] if limit.to == Target::MinusInf));
}

#[test]
fn each_fault_is_named_and_placed() {
    use SyntaxErrorKind as E;
    let unknown = |name: &str| E::UnknownSymbol(name.to_owned());
    let cases: Vec<(&str, E, &str)> = vec![
        ("x + z = 1", unknown("z"), "z"),
        ("x^0.5 = 1", E::ExponentNotInteger, "0.5"),
        ("x^y = 1", E::ExponentNotInteger, "y"),
        ("x^(1/2) = 1", E::ExponentNotInteger, "(1/2)"),
        ("x^10001 = 1", E::ExponentTooLarge, "10001"),
        ("x^10^10^10 = 1", E::ExponentTooLarge, "10^10"),
        ("1.2.3 = x", E::MalformedNumber("1.2.3".into()), "1.2.3"),
        ("2x = 1", E::MalformedNumber("2x".into()), "2x"),
        (".5 = x", E::MalformedNumber(".5".into()), ".5"),
        ("x = 1e", E::MalformedNumber("1e".into()), "1e"),
        ("(x = 1", E::Unclosed('('), "("),
        ("x = cases { x > 0: 1", E::Unclosed('{'), "{"),
        ("x) = 1", E::Unopened(')'), ")"),
        ("= 1", E::NoLeftSide, "="),
        ("x = ", E::NoRightSide, "="),
        ("x <, y < 1", E::NoRightSide, "<"),
        ("x == 1", E::Foreign { written: "==", ours: "`=`" }, "=="),
        ("x => 1", E::Foreign { written: "=>", ours: "`>=` or `implies`" }, "=>"),
        ("x =< 1", E::Foreign { written: "=<", ours: "`<=`" }, "=<"),
        ("x <> 1", E::Foreign { written: "<>", ours: "`!=`" }, "<>"),
        ("x**2 = 1", E::Foreign { written: "**", ours: "`^`" }, "**"),
        // apart they are two signs
        ("x = = 1", E::NoRightSide, "="),
        ("x = 1;", E::LastSemicolon, ";"),
        ("x + 1", E::NoRelation, "x + 1"),
        ("x y = 1", E::ImplicitProduct("`y`".into()), "y"),
        ("k(x) = 1", E::ImplicitProduct("`(`".into()), "("),
        ("x = 1 y", E::ImplicitProduct("`y`".into()), "y"),
        ("x ? 1", E::StrayCharacter('?'), "?"),
        (
            "sqrt = 1",
            E::Expected { expected: "`(` after a function's name".into(), found: "`=`".into() },
            "=",
        ),
        ("x = cases { }", E::NoBranch, "cases { }"),
        ("x = cases { else: 1; x > 1: 2 }", E::ElseNotLast, "x"),
        (
            "x = cases { x > 1: 2, else: 1 }",
            E::Expected { expected: "`;` between two branches".into(), found: "`,`".into() },
            ",",
        ),
        ("k -> 1", E::LimitWithoutAs, ""),
        ("x = 1 as x -> 1", E::AsWithoutLimit, "as"),
        ("k -> x as x -> 1", E::LimitNotFree("x".into()), "x"),
        ("x -> 2*k as alpha -> 1", E::LimitNotFree("alpha".into()), "2*k"),
        ("x -> f as x -> 1", E::LimitNotFree("x".into()), "f"),
        ("x -> 1 as k -> 1", E::NotALimitVariable("k".into()), "k"),
        ("x -> 1 as f -> 1", E::NotALimitVariable("f".into()), "f"),
        ("x -> 1 as alpha -> x", E::NoShift("alpha".into()), "x"),
        ("x -> 1 as alpha -> alpha/2", E::PointNotFree("alpha".into()), "alpha/2"),
        ("x -> 1 as alpha -> 1/(1-1)", E::NotConstant, "1/(1-1)"),
        ("d(k, alpha) = 1", E::NoRate("k".into()), "k"),
        ("x = when", E::NoRightSide, "="),
        (
            "min = 1",
            E::Expected { expected: "`(` after a function's name".into(), found: "`=`".into() },
            "=",
        ),
        ("by = 1", E::ReservedWord("by".into()), "by"),
        ("a -> b -> 1 as x -> 1", unknown("a"), "a"),
        ("x -> y -> 1 as x -> 1", E::MisplacedLimit, "->"),
        ("x < y -> 1 as x -> 1", E::MisplacedLimit, "->"),
    ];
    for (text, kind, place) in cases {
        let errors = parse_sentence(text, &scope()).expect_err(text);
        let first = &errors[0];
        assert_eq!(first.kind, kind, "text {text}");
        let found = &text[first.span.clone()];
        assert!(found.starts_with(place), "text {text}: at {found}");
    }
}

#[test]
fn several_faults_are_found_at_once() {
    let errors = parse_sentence("a/2 + b^0.5 = c", &scope()).expect_err("four faults");
    assert_eq!(errors.len(), 4);
}
