use std::rc::Rc;

use kane_algebra::syntax::{
    Notation, latex_name, literal, parse_expr, parse_relations, parse_sentence, surface,
};
use kane_kernel::{Expr, Rel, Relation, Var};
use proptest::prelude::*;

use super::{ratio, scope};

/// All that the parser can produce over the test scope: non-negative decimals, any structure.
fn expressions() -> impl Strategy<Value = Expr> {
    let decimal = (0_i64..200, 0_u32..4).prop_map(|(n, places)| ratio(n, 10_i64.pow(places)));
    let leaf = prop_oneof![
        decimal.prop_map(Expr::Num),
        (0_usize..4).prop_map(Expr::Var),
        Just(Expr::Let(0)),
    ];
    leaf.prop_recursive(6, 40, 4, |inner| {
        let two = (inner.clone(), inner.clone()).prop_map(|(a, b)| (Rc::new(a), Rc::new(b)));
        let guards = prop::collection::vec(relations_of(inner.clone()), 1..3);
        let branches = prop::collection::vec((guards, inner.clone()), 1..3);
        prop_oneof![
            inner.clone().prop_map(|a| Expr::Neg(a.into())),
            two.clone().prop_map(|(a, b)| Expr::Add(a, b)),
            two.clone().prop_map(|(a, b)| Expr::Sub(a, b)),
            two.clone().prop_map(|(a, b)| Expr::Mul(a, b)),
            two.clone().prop_map(|(a, b)| Expr::Div(a, b)),
            two.clone().prop_map(|(a, b)| Expr::Min(a, b)),
            two.prop_map(|(a, b)| Expr::Max(a, b)),
            (inner.clone(), -4_i32..5).prop_map(|(a, n)| Expr::Pow(a.into(), n)),
            inner.clone().prop_map(|a| Expr::Abs(a.into())),
            inner.clone().prop_map(|a| Expr::Sqrt(a.into())),
            (inner.clone(), 0_usize..4).prop_map(|(f, x)| Expr::Deriv(f.into(), x)),
            (branches, prop::option::of(inner))
                .prop_map(|(branches, last)| Expr::Cases(branches, last.map(Rc::new))),
        ]
    })
}

/// Relations, and what `or`, `implies` and `iff` make of them.
fn formulas() -> impl Strategy<Value = Relation> {
    let value = |guards: Vec<Relation>| {
        Expr::Cases(vec![(guards, Expr::int(1))], Some(Expr::int(0).into()))
    };
    let equal = |lhs, rhs| Relation { lhs, rel: Rel::Eq, rhs };
    relations_of((0_usize..4).prop_map(Expr::Var)).prop_recursive(4, 24, 3, move |inner| {
        let part = prop::collection::vec(inner, 1..3);
        let two = (part.clone(), part.clone());
        prop_oneof![
            prop::collection::vec(part, 2..4).prop_map(move |parts| {
                let branches = parts.into_iter().map(|part| (part, Expr::int(1))).collect();
                equal(Expr::Cases(branches, Some(Expr::int(0).into())), Expr::int(1))
            }),
            two.clone().prop_map(move |(a, b)| {
                let lhs = Expr::Cases(vec![(a, value(b))], Some(Expr::int(1).into()));
                equal(lhs, Expr::int(1))
            }),
            two.prop_map(move |(a, b)| equal(value(a), value(b))),
        ]
    })
}

fn relations_of(sides: impl Strategy<Value = Expr> + Clone) -> impl Strategy<Value = Relation> {
    let rel = prop::sample::select(vec![Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge]);
    (sides.clone(), rel, sides).prop_map(|(lhs, rel, rhs)| Relation { lhs, rel, rhs })
}

/// Pieces of the language in any order, most of them nonsense.
fn soup() -> impl Strategy<Value = String> {
    let words = vec![
        "x", "y", "mu", "μ", "alpha", "k", "f", "zz", "1", "0", "0.5", "12.", "+", "-", "−", "*",
        "/", "^", "^2", "(", ")", "{", "}", ",", ";", ":", ":=", "->", "=", "<", "<=", "≠", "oo",
        "and", "or", "implies", "iff", "exists", "[", "]", "|", "dot(", "cross(", "det(", "norm(",
        "inverse(", "∞", "abs(", "sqrt(", "min(", "d(", "cases {", "else", "when", "as", "from",
        "#", "\n", "é",
    ];
    prop::collection::vec(prop::sample::select(words), 0..30).prop_map(|parts| parts.join(" "))
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(config(2000))]

    #[test]
    fn what_is_printed_reads_back_as_the_same(e in expressions()) {
        let text = e.plain(scope().context());
        match parse_expr(&text, &scope()) {
            Ok(back) => prop_assert_eq!(back, e, "text {}", text),
            // the only expressions here that the parser refuses
            Err(errors) => {
                for error in errors {
                    prop_assert!(error.to_string().contains("literal zero"), "{text}: {error}");
                }
            }
        }
    }

    /// What is set by the grammar alone is what is set from the syntax that was read. `vv` stands for what is written out.
    #[test]
    fn the_surface_is_set_as_what_was_read(e in expressions()) {
        let text = e.plain(scope().context());
        prop_assume!(!text.contains("cases") && parse_expr(&text, &scope()).is_ok());
        let set = surface(&format!("vv > {text} when 1 < vv"), scope().context(), &|_| false);
        let said = format!("{} > {}", latex_name("vv"), e.latex(scope().context()));
        prop_assert_eq!(set, Some((said, Some(format!("1 < {}", latex_name("vv"))))), "{}", text);
        let nothing = surface(&format!("x > {text}"), scope().context(), &|_| false);
        prop_assert_eq!(nothing, None, "nothing in {} is written out", text);
    }

    /// The reader knows `vv`, and the surface does not.
    #[test]
    fn the_surface_of_limits_and_lists_is_set_as_what_was_read(
        f in expressions(),
        list in prop::collection::vec(relations_of(expressions().boxed()), 1..4),
        side in prop::sample::select(vec!["", "+", "-"]),
    ) {
        let (shown, mut known) = (scope(), scope());
        let var = Var { name: "vv".to_owned(), of: None, lower: None, upper: None };
        known.declare(var).expect("a name");
        let plain = |e: &Expr| e.plain(shown.context());
        let limit = format!("{} -> vv*({}) as x -> -1/2{side}", plain(&f), plain(&list[0].lhs));
        for text in [limit, format!("vv > 1, {}", list.plain(shown.context()))] {
            let Ok(sentence) = parse_sentence(&text, &known) else { continue };
            if text.contains("cases") {
                continue;
            }
            let set = surface(&text, shown.context(), &|_| false);
            prop_assert_eq!(set, Some((sentence.latex(known.context()), None)), "{}", text);
        }
    }

    #[test]
    fn the_surface_of_any_text_ends(text in soup()) {
        let _ = surface(&text, scope().context(), &|_| false);
    }

    #[test]
    fn printed_relations_read_back_as_the_same(
        list in prop::collection::vec(relations_of((0_usize..4).prop_map(Expr::Var)), 1..6)
    ) {
        let text = list.plain(scope().context());
        prop_assert_eq!(parse_relations(&text, &scope()), Ok(list));
    }

    #[test]
    fn printed_formulas_read_back_as_the_same(list in prop::collection::vec(formulas(), 1..5)) {
        let text = list.plain(scope().context());
        prop_assert!(!text.contains("cases"), "{}", text);
        prop_assert_eq!(parse_relations(&text, &scope()), Ok(list), "{}", text);
    }

    #[test]
    fn any_text_is_parsed_or_refused_and_prints_back(text in soup()) {
        if let Ok(sentence) = parse_sentence(&text, &scope()) {
            let printed = sentence.plain(scope().context());
            prop_assert_eq!(parse_sentence(&printed, &scope()), Ok(sentence), "{}", printed);
        }
        if let Ok(e) = parse_expr(&text, &scope()) {
            let printed = e.plain(scope().context());
            prop_assert_eq!(parse_expr(&printed, &scope()), Ok(e), "{}", printed);
        }
    }

    #[test]
    fn latex_is_balanced(e in expressions()) {
        let latex = e.latex(scope().context());
        let count = |what: &str| latex.matches(what).count();
        prop_assert_eq!(count("{"), count("}"));
        prop_assert_eq!(count("\\left"), count("\\right"));
        prop_assert_eq!(count("\\begin"), count("\\end"));
    }
}

#[test]
fn parentheses_are_as_few_as_it_takes() {
    for text in [
        "x + y - mu",
        "x - (y - mu)",
        "-x*y/mu",
        "-(x + y)^2",
        "(-x)^2",
        "x^2*y^-3",
        "x*(y/mu)",
        "4/3*x",
        "(x + 1)/(y*mu)",
        "0.4*x",
    ] {
        let e = parse_expr(text, &scope()).expect(text);
        assert_eq!(e.plain(scope().context()), text);
    }
}

#[test]
fn numbers_that_nobody_wrote_keep_their_meaning() {
    let context = scope().into_context();
    let plain = |n, d| Expr::Num(ratio(n, d)).plain(&context);
    assert_eq!(plain(1, 3), "1/3");
    assert_eq!(plain(-1, 3), "-1/3");
    assert_eq!(plain(-2, 5), "-0.4");
    assert_eq!(literal(&ratio(-2, 5)).plain(&context), "-2/5");
    assert_eq!(literal(&ratio(7, 1)).plain(&context), "7");
    let squared = Expr::Pow(Expr::Num(ratio(-1, 3)).into(), 2);
    assert_eq!(squared.plain(&context), "(-1/3)^2");
}

#[test]
fn sentences_print_whole() {
    for text in [
        "0 <= x < y, x = 1 when mu > 0",
        "k -> -1, x*k -> oo as alpha -> 1/2+ when x != 0, y > 1",
        "k -> x/2 as alpha -> -oo",
    ] {
        let sentence = parse_sentence(text, &scope()).expect(text);
        assert_eq!(sentence.plain(scope().context()), text);
    }
}

#[test]
fn latex_reads_like_print() {
    for (text, latex) in [
        ("(1 - alpha)/(1 + alpha) = k", "\\frac{1 - \\alpha}{1 + \\alpha} = k"),
        ("4/3*alpha >= 2*3", "\\frac{4}{3} \\alpha \\ge 2 \\cdot 3"),
        ("(x/y)^2 != -x", "\\left(\\frac{x}{y}\\right)^{2} \\ne -x"),
        ("-(x + y) < abs(x)", "-(x + y) < \\left|x\\right|"),
        ("x*(x + y) = sqrt(2)", "x (x + y) = \\sqrt{2}"),
        ("d(x^2, x) = min(x, y)", "\\frac{\\mathrm{d}}{\\mathrm{d}x}(x^{2}) = \\min(x, y)"),
        (
            "x = cases { x < 3/4: 1; else: 2 }",
            "x = \\begin{cases} 1 & \\text{if } x < \\frac{3}{4} \\\\ 2 & \\text{otherwise} \\end{cases}",
        ),
        (
            "k -> -1 as alpha -> 0+ when mu > 0",
            "k \\to -1 \\text{ as } \\alpha \\to 0^{+} \\quad\\text{when } \\mu > 0",
        ),
        ("k -> 0.5 as alpha -> 3/4-", "k \\to 0.5 \\text{ as } \\alpha \\to \\frac{3}{4}^{-}"),
        ("0 < x < 1, y = 1", "0 < x < 1,\\; y = 1"),
    ] {
        let sentence = parse_sentence(text, &scope()).expect(text);
        assert_eq!(sentence.latex(scope().context()), latex);
    }
}

#[test]
fn what_is_written_out_is_set_as_it_is_written() {
    for (text, said) in [
        ("dot(v, v) = dot(v, n)^2 + 1", r"v \cdot v = (v \cdot n)^{2} + 1"),
        ("v - dot(v, n)*n = [x, y]", r"v - (v \cdot n) n = \begin{pmatrix} x \\ y \end{pmatrix}"),
        ("cross(u + v, w) = 2*cross(u, w)/x", r"(u + v) \times w = \frac{2 (u \times w)}{x}"),
        ("sin(2*x) <= norm(v)", r"\sin(2 x) \le \left|v\right|"),
        ("d(d(v, x), x) = cross(u, v)", r"\frac{d^2 v}{d x^2} = u \times v"),
        ("dot(v, v) > 0 and x > 0, y > 0", r"v \cdot v > 0,\; x > 0,\; y > 0"),
        ("exists u, w: h(u) = w", r"\exists\, u, w:\; h(u) = w"),
        ("h(n) > n for n >= 2", r"h(n) > n \quad\text{for } n \ge 2"),
        ("(x^n)^2 = pow(x, n)^n", r"(x^{n})^{2} = (x^{n})^{n}"),
        ("2*x^n*y = (x^2)^n", r"2 x^{n} y = (x^{2})^{n}"),
        ("transpose(transpose(u)) = inverse(u*v)", r"(u^{\mathsf{T}})^{\mathsf{T}} = (u v)^{-1}"),
        ("h(x/y) = x^n", r"h\left(\frac{x}{y}\right) = x^{n}"),
        (
            "det([[x, y], [y, x]]) = x² - y²",
            r"\det\left(\begin{pmatrix} x & y \\ y & x \end{pmatrix}\right) = x^{2} - y^{2}",
        ),
        ("sum(k^2 for k in 1..n) > 0", r"\sum_{k=1}^{n} k^{2} > 0"),
        ("2*sum(k + 1 for k in 1..n) > 0", r"2 \left(\sum_{k=1}^{n} (k + 1)\right) > 0"),
        ("exp(-x) -> 0 as x -> oo", r"\exp(-x) \to 0 \text{ as } x \to \infty"),
        ("h(x) -> -(x + y) as y -> 1/2+", r"h(x) \to -(x + y) \text{ as } y \to \frac{1}{2}^{+}"),
        ("h(x) -> x - 1 as y -> -oo", r"h(x) \to x - 1 \text{ as } y \to -\infty"),
        ("h(x) -> -oo as y -> -1-", r"h(x) \to -\infty \text{ as } y \to -1^{-}"),
        ("h(x) := x*y", "h(x) := x y"),
        ("u := dot(v, w)", r"u := v \cdot w"),
    ] {
        let set = surface(text, scope().context(), &|_| false);
        assert_eq!(set.map(|set| set.0).as_deref(), Some(said), "{text}");
    }
    for text in [
        "x > 0 or dot(v, v) > 0",
        "dot(v, v) > 0 and x > 0 or y > 0",
        "dot(v, v)",
        "dot(v, v) > 0 extra",
        "x = cases { x > 0: 1 }",
        "",
    ] {
        assert_eq!(surface(text, scope().context(), &|_| false), None, "{text}");
    }
    let own = surface("dot(x, y) = norm(vv)", scope().context(), &|name| name == "dot");
    let said = format!("{}(x, y) = \\left|{}\\right|", latex_name("dot"), latex_name("vv"));
    assert_eq!(own, Some((said, None)), "a function of the document is no product");
}
