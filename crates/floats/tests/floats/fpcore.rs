//! FPCore is read, written, and told what is wrong with it.

use kane_floats::{Core, Precision, fpcore};

fn one(text: &str) -> Core {
    let mut cores = fpcore::read("t.fpcore", text).expect("it is well formed");
    assert_eq!(cores.len(), 1);
    cores.remove(0)
}

#[test]
fn what_is_written_reads_back_as_the_same() {
    let texts = [
        "(FPCore (x y) :name \"a\" :precision binary32 :pre (and (< 0 x 1) (<= x y)) (/ x (+ x y)))",
        "(FPCore f (x) :cite (a b) (let ([y (* x x)] [z 1/3]) (+ (* y y) (sqrt z))))",
        "(FPCore (x) (let* ([x (+ x 1)] [x (* x x)]) (if (< x 2) (- x) (fma x x 0x1p-3))))",
        "(FPCore (x) (if (and (not (== x 0)) (or TRUE (!= x 1 2))) (fabs x) (fmin x (fmax 1 x))))",
        "(FPCore (x) :pre (< -1e-3 x) (* 1.5 x)) ; a comment",
    ];
    for text in texts {
        let core = one(text);
        let written = fpcore::write(&core);
        let again = one(&written);
        assert_eq!(again.text(), core.text(), "{written}");
        assert_eq!(again.arguments, core.arguments, "{written}");
        assert_eq!(again.assumed.len(), core.assumed.len(), "{written}");
        assert_eq!((again.precision, again.name.clone()), (core.precision, core.name), "{written}");
        assert_eq!(fpcore::write(&again), written);
    }
}

#[test]
fn a_let_binds_at_once_and_a_let_star_in_turn() {
    let parallel = one("(FPCore (x) (let ([x 1] [y x]) (+ x y)))");
    assert_eq!(parallel.text(), "1 + x");
    let in_turn = one("(FPCore (x) (let* ([x 1] [y x]) (+ x y)))");
    assert_eq!(in_turn.text(), "1 + 1");
}

#[test]
fn ranges_are_taken_from_what_is_assumed() {
    let core = one("(FPCore (x y z) :pre (and (<= 1/2 x 2) (> 3 y) (== z 1) (< x y)) x)");
    let ends: Vec<String> = core
        .arguments
        .iter()
        .flat_map(|a| [&a.lower, &a.upper])
        .map(|bound| {
            bound.as_ref().map_or_else(String::new, |b| format!("{}{}", b.value, b.strict))
        })
        .collect();
    assert_eq!(ends, ["1/2false", "2false", "", "3true", "1false", "1false"]);
    assert_eq!(core.assumed.len(), 1);
    assert_eq!(core.precision, None);
    let core = one("(FPCore (x) :precision binary32 x)");
    assert_eq!(core.precision, Some(Precision::F32));
}

#[test]
fn each_fault_has_its_place_and_its_reason() {
    let cases = [
        ("(FPCore (x) (sin x))", 1, 14, "`sin` is none of the operators"),
        ("(FPCore (x) (+ x))", 1, 13, "`+` does not take 1 operand"),
        ("(FPCore (x)\n (+ x y))", 2, 7, "`y` is neither an argument"),
        ("(FPCore (x) (+ x 1)", 1, 1, "is not closed"),
        ("(FPCore (x) (+ x 1]", 1, 19, "`]` closes what `(` opened"),
        ("(FPCore (x) x) )", 1, 16, "closes nothing"),
        ("(FPCore (x x) x)", 1, 12, "two arguments"),
        ("(FPCore (x) :pre (< 2 x 1) x)", 1, 18, "no x is in its range"),
        ("(FPCore (x) :pre (< 1 x 1) x)", 1, 18, "no x is in its range"),
        ("(FPCore (x) :precision binary80 x)", 1, 24, "binary32 and binary64"),
        ("(FPCore (x) :round toZero x)", 1, 20, "nearestEven"),
        ("(FPCore (x) :name f x)", 1, 19, "a name is a text"),
        ("(FPCore (x) (< x 1))", 1, 13, "a comparison is no number"),
        ("(FPCore (x) (if x 1 2))", 1, 17, "expected a comparison"),
        ("(FPCore (x) 1/0)", 1, 13, "denominator"),
        ("(Core (x) x)", 1, 2, "expected `FPCore`"),
        ("(FPCore (x) \"x)", 1, 13, "not closed by a quotation mark"),
        ("(FPCore ((! :precision binary32 x)) x)", 1, 10, "an argument is a name"),
        ("(FPCore (x) (while (< x 1) ([x 0 x]) x))", 1, 14, "none of the operators"),
        ("(FPCore (x) :pre)", 1, 13, "neither an argument"),
        ("(FPCore (x))", 1, 1, "the expression is missing"),
        ("(FPCore (x) ())", 1, 13, "an expression is missing here"),
        ("(FPCore (x|y) 1)", 1, 10, "has no `|`"),
        ("(FPCore (a`b) 1)", 1, 10, "has no ``"),
        ("(FPCore (x)\n :name \"a\u{1b}[8m\" x)", 2, 10, "control character U+001B"),
        ("(FPCore (x) x) ; \u{202e}", 1, 18, "invisible character U+202E"),
        ("(FPCore (x\u{200b}) 1)", 1, 11, "invisible character U+200B"),
    ];
    for (text, line, column, why) in cases {
        let fault = fpcore::read("t.fpcore", text).expect_err(text);
        assert_eq!((fault.line, fault.column), (line, column), "{text}: {fault}");
        assert!(fault.message.contains(why), "{text}: {fault}");
    }
    assert_eq!(fpcore::read("t.fpcore", " ; none\n").map(|cores| cores.len()), Ok(0));
    let deep = format!("(FPCore (x) {}x{})", "(- ".repeat(300), ")".repeat(300));
    let fault = fpcore::read("t.fpcore", &deep).expect_err("too deep");
    assert!(fault.message.contains("200 parentheses"), "{fault}");
}
