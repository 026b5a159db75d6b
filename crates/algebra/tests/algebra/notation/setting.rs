use kane_algebra::syntax::{
    Notation as _, Scope, latex_name, latex_with, mathml, mathml_name, parse_expr, parse_sentence,
};
use kane_kernel::{Expr, Link, Var};

use super::ratio;

/// Letters, differences, words, a function of alpha and definitions.
fn scope() -> Scope {
    let mut scope = Scope::default();
    let mut declare = |name: &str, of| {
        let var = Var { name: name.to_owned(), of, lower: None, upper: None };
        scope.declare(var).expect("the names are free")
    };
    for name in ["x", "y", "v'", "DeltaE", "dE", "Delta", "E", "DeltaE_n", "slip", "v_0"] {
        declare(name, None);
    }
    let alpha = declare("alpha", None);
    declare("k", Some(alpha));
    for name in ["f", "slope"] {
        let body = parse_expr("x^2 + 1", &scope).expect("well-formed");
        scope.define(name, body).expect("the name is free");
    }
    scope
}

fn set(e: &Expr) -> (String, String) {
    (e.latex(scope().context()), mathml(e, scope().context(), &|_| None))
}

/// The marks of MathML as one sees them: what stands above in `^`, below in `_`, over in a fraction with `/`.
fn seen(mathml: &str) -> String {
    let marks = [
        ("<mfrac>", "/"),
        ("<msup>", "^"),
        ("<msub>", "_"),
        ("<msubsup>", "_^"),
        ("<mrow>", "{"),
        ("</mrow>", "}"),
        ("<msqrt>", "√["),
        ("</msqrt>", "]"),
    ];
    let mut text =
        marks.iter().fold(mathml.to_owned(), |text, (tag, mark)| text.replace(tag, mark));
    for tag in ["mi", "mn", "mo"] {
        text = text.replace(&format!("<{tag}>"), "").replace(&format!("</{tag}>"), " ");
    }
    text.replace("</mfrac>", "")
        .replace("</msup>", "")
        .replace("</msub>", "")
        .replace("</msubsup>", "")
}

#[test]
fn what_would_be_read_as_something_else_stands_apart() {
    for (text, latex, shown) in [
        // the exponent is that of all of it
        ("v'^2", r"(v')^{2}", "^^v ′ 2 "),
        ("DeltaE^2", r"(\Delta E)^{2}", "^{( ΔE ) }2 "),
        ("DeltaE_n^2", r"(\Delta E_n)^{2}", "^{( _ΔE n ) }2 "),
        ("dE^2", r"(dE)^{2}", "^{( dE ) }2 "),
        ("min(x, y)^2", r"(\min(x, y))^{2}", "^{( min {( x , y ) }) }2 "),
        ("x + max(x, y)^3", r"x + (\max(x, y))^{3}", "x + ^{( max {( x , y ) }) }3 "),
        ("(x/y)^2", r"\left(\frac{x}{y}\right)^{2}", "^{( /x y ) }2 "),
        (
            "d(x^2, x)^2",
            r"\left(\frac{\mathrm{d}}{\mathrm{d}x}(x^{2})\right)^{2}",
            "^{( /d {d x }{( ^x 2 ) }) }2 ",
        ),
        ("f^2", "f^{2}", "^f 2 "),
        ("slope^2", r"\mathrm{slope}^{2}", "^slope 2 "),
        ("v_0^-1", "v_0^{-1}", "_^v 0 {− 1 }"),
        ("x^-2", "x^{-2}", "^x {− 2 }"),
        ("2^3", "2^{3}", "^2 3 "),
        ("x^0", "x^{0}", "^x 0 "),
        ("Delta^2", r"\Delta^{2}", "^Δ 2 "),
        ("sqrt(y)^2", r"\sqrt{y}^{2}", "^√[y ]2 "),
        // the sign of a product keeps numbers, words and differences apart
        ("2*3*x", r"2 \cdot 3 x", "2 · 3 x "),
        ("2*(1/x)", r"2 \cdot \frac{1}{x}", "2 · /1 x "),
        ("x*(1/y)", r"x \frac{1}{y}", "x /1 y "),
        ("slip*x", r"\mathrm{slip} \cdot x", "slip · x "),
        ("x*slip", r"x \cdot \mathrm{slip}", "x · slip "),
        ("2*x*slope*y", r"2 x \cdot \mathrm{slope} \cdot y", "2 x · slope · y "),
        ("Delta*E", r"\Delta \cdot E", "Δ · E "),
        ("x*Delta*E", r"x \Delta \cdot E", "x Δ · E "),
        ("E*Delta", r"E \Delta", "E Δ "),
        // a function is not applied to its factor, and a derivative ends before it
        ("k*(x + y)", r"k \cdot (x + y)", "k · {( x + y ) }"),
        ("k*(x/y + 1)", r"k \cdot \left(\frac{x}{y} + 1\right)", "k · {( /x y + 1 ) }"),
        ("k*x", "k x", "k x "),
        ("y*(x + 1)", "y (x + 1)", "y {( x + 1 ) }"),
        (
            "d(x^2, x)*y",
            r"\frac{\mathrm{d}}{\mathrm{d}x}(x^{2}) \cdot y",
            "/d {d x }{( ^x 2 ) }· y ",
        ),
        // what takes one place is one element
        ("x/(-2)", r"\frac{x}{-2}", "/x {− 2 }"),
        ("2/x", r"\frac{2}{x}", "/2 x "),
        ("(x + 1)/y", r"\frac{x + 1}{y}", "/{x + 1 }y "),
    ] {
        let (tex, page) = set(&parse_expr(text, &scope()).expect(text));
        assert_eq!((&*tex, &*seen(&page)), (latex, shown), "{text}");
    }
    let (latex, page) = set(&parse_expr("2*cases { x > 0: 1; else: 0 }", &scope()).expect("read"));
    assert!(
        latex.starts_with(r"2 \left(\begin{cases} 1 & ") && latex.ends_with(r"\right)"),
        "{latex}"
    );
    assert!(
        seen(&page).starts_with("2 {( {{ <mtable>") && page.ends_with("<mo>)</mo></mrow>"),
        "{page}"
    );
    // a symbol that is set by its caller as a fraction
    let beyond = Expr::Pow(Expr::Var(99).into(), 2);
    let fraction = |_| Some(r"\frac{a}{b}".to_owned());
    assert_eq!(latex_with(&beyond, scope().context(), &fraction), r"\left(\frac{a}{b}\right)^{2}");
    let difference = |_| Some(latex_name("DeltaE"));
    assert_eq!(latex_with(&beyond, scope().context(), &difference), r"(\Delta E)^{2}");
    let difference = |_| Some(mathml_name("DeltaE"));
    assert_eq!(seen(&mathml(&beyond, scope().context(), &difference)), "^{( ΔE ) }2 ");
    let twice = Expr::Mul(Expr::Var(99).into(), Expr::Var(0).into());
    let word = |v| (v == 99).then(|| latex_name("slope"));
    assert_eq!(latex_with(&twice, scope().context(), &word), r"\mathrm{slope} \cdot x");
    let fraction = |_| Some("<mfrac><mi>a</mi><mi>b</mi></mfrac>".to_owned());
    assert_eq!(seen(&mathml(&beyond, scope().context(), &fraction)), "^{( /a b ) }2 ");
}

#[test]
fn numbers_that_nobody_wrote_hold_together() {
    for (n, d, plain, latex, shown) in [
        (-2, 1, "(-2)^2", "(-2)^{2}", "^{( − 2 ) }2 "),
        (1, 3, "(1/3)^2", r"\left(\frac{1}{3}\right)^{2}", "^{( /1 3 ) }2 "),
        (-1, 3, "(-1/3)^2", r"\left(-\frac{1}{3}\right)^{2}", "^{( − /1 3 ) }2 "),
        (5, 2, "2.5^2", "2.5^{2}", "^2.5 2 "),
    ] {
        let squared = Expr::Pow(Expr::Num(ratio(n, d)).into(), 2);
        let (tex, page) = set(&squared);
        let all = (squared.plain(scope().context()), tex, seen(&page));
        assert_eq!((&*all.0, &*all.1, &*all.2), (plain, latex, shown));
    }
}

#[test]
fn names_of_powers_sums_and_angles_have_their_parts() {
    for (name, shown) in [
        ("cos(2*theta^2/3)", "{cos ( 2 ^θ 2 / 3 ) }"),
        ("g(n)", "{g ( n ) }"),
        ("pow(2, n)", "{( ^2 n ) }"),
        ("pow(q, n)", "{( ^q n ) }"),
        ("prod(k for k in 1..2*n)", "{( <munderover>∏ {k = 1 }{2 &#x2062; n }</munderover>k ) }"),
        (
            "sum(k^2 - 2*j for k in 1..n)",
            "{( <munderover>∑ {k = 1 }{n }</munderover>^k {2 }− 2 &#x2062; j ) }",
        ),
    ] {
        assert_eq!(seen(&mathml_name(name)), shown, "{name}");
    }
    let half = "<mrow><mi>cos</mi><mo>(</mo><mi>θ</mi><mo>/</mo><mn>2</mn><mo>)</mo></mrow>";
    assert_eq!(mathml_name("cos(theta/2)"), half);
    let sum = mathml_name("sum(k + 2 for k in 1..n)");
    assert!(sum.contains("<mi>k</mi><mo>+</mo><mn>2</mn>"), "{sum}");
    for (name, latex) in [
        ("cos(10*theta/2)", r"\cos(10 \theta/2)"),
        ("sum(alpha^k for k in 0..n)", r"\left(\sum_{k=0}^{n} \alpha^{k}\right)"),
        (
            "prod(2^((k + 1)*(k - 1)) for k in 1..n)",
            r"\left(\prod_{k=1}^{n} 2^{(k+1)\,(k-1)}\right)",
        ),
        ("Omicron", "O"),
        ("omicron", "o"),
        ("k_muon", "k_{muon}"),
        ("k_mu0", r"k_{\mu 0}"),
    ] {
        assert_eq!(latex_name(name), latex, "{name}");
    }
}

#[test]
fn a_link_alone_is_written_as_its_sentence() {
    for (text, latex) in [
        ("x < y", "x < y"),
        ("x > 0 or y > 0", r"x > 0 \lor y > 0"),
        ("x > 0 implies y > 0 and x < 1", r"x > 0 \Rightarrow y > 0 \land x < 1"),
        ("k -> oo as alpha -> 0+", r"k \to \infty \text{ as } \alpha \to 0^{+}"),
    ] {
        let sentence = parse_sentence(text, &scope()).expect(text);
        let [link] = &sentence.links[..] else { panic!("{text} is one link") };
        assert_eq!(
            (&*link.plain(scope().context()), &*link.latex(scope().context())),
            (text, latex)
        );
        match link {
            Link::Relation(relation) => assert_eq!(relation.latex(scope().context()), latex),
            Link::Limit(limit) => {
                let both = (limit.plain(scope().context()), limit.latex(scope().context()));
                assert_eq!((&*both.0, &*both.1), (text, latex));
            }
        }
    }
}

/// `or`, `implies` and `iff` are comparisons of cases with 1 and 0 in certain places; with others, they stay what they are.
#[test]
fn what_only_resembles_a_formula_is_written_as_it_is() {
    for text in [
        "cases { x > 0: 2; y > 0: 1; else: 0 } = 1",
        "cases { x > 0: 1; y > 0: 1; else: 2 } = 1",
        "cases { x > 0: 1; y > 0: 1; else: 0 } = 2",
        "cases { x > 0: 1; y > 0: 1; else: 0 } >= 1",
        "cases { x > 0: cases { y > 0: 2; else: 0 }; else: 1 } = 1",
        "cases { x > 0: cases { y > 0: 1; else: 2 }; else: 1 } = 1",
        "cases { x > 0: cases { y > 0: 1; else: 0 }; else: 2 } = 1",
        "cases { x > 0: 1; else: 2 } = cases { y > 0: 1; else: 0 }",
        "cases { x > 0: 1; else: 0 } = cases { y > 0: 2; else: 0 }",
        "cases { x > 0: 1; else: 0 } = 1",
    ] {
        let sentence = parse_sentence(text, &scope()).expect(text);
        assert_eq!(sentence.plain(scope().context()), text);
        assert!(sentence.latex(scope().context()).contains("cases"), "{text}");
    }
}
