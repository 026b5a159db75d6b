//! What a lemma cannot say is not emitted, and the file says why.

use std::rc::Rc;

use kane_audit::Audit;
use kane_judges::coq::NotEmitted;
use kane_kernel::{Evidence, Failure, Model, Point};

use crate::document::{judged, whole};
use crate::lemmas::coq;

/// Holds the reasons for which the last claims of statements are not emitted against those they should have; where there
/// is none a claim is emitted.
fn assert_reasons(wanted: &[(&str, &'static str)]) {
    for (statements, why) in wanted {
        let file = coq(&judged(statements));
        let last = file.lemmas.last().expect("it is judged");
        match *why {
            "" => assert_eq!(last.name.as_deref(), Ok("claim_c"), "{statements}"),
            why => assert_eq!(last.name, Err(NotEmitted::Step(why)), "{statements}"),
        }
        let said = file.beside_theory().contains(&format!("(* not emitted: {why} *)"));
        assert_eq!(said, !why.is_empty(), "{statements}");
    }
}

#[test]
fn of_derivatives_those_that_the_theory_has_no_rule_for() {
    let (root, inside) =
        ("the derivative of a square root", "a derivative inside what is differentiated");
    assert_reasons(&[
        (
            "var x, y\nclaim c: d(d(x^2*y^2, x), y) = 4*x*y",
            "a derivative by one symbol of one by another",
        ),
        ("var x\nclaim c: d(sqrt(x), x) > 0 when x > 0", root),
        ("var x, y\nclaim c: d(x*d(y^2, y), x) = 2*y", inside),
        ("var x, y\nclaim c: d(cases { d(y^2, y) < 1: x; else: x }, x) = 1 when y > 0", inside),
        ("var x, y\nclaim c: d(cases { sqrt(y) < x: x; else: x }, x) = 1 when y > 0, x < 0", root),
    ]);
}

#[test]
fn a_guard_is_followed_whose_sides_visibly_differ_by_something_that_varies() {
    let cancels = "a guard in which the variable cancels";
    let claim = |guard: &str, when: &str| {
        format!("var x, y\nclaim c: d(1 + cases {{ {guard}: x; else: 2*x }}, x) = 1 when {when}")
    };
    for (guard, when, why) in [
        ("x - x < y", "y > 0", cancels),
        ("y < x - x + 1", "y < 1", cancels),
        ("y < 1", "y < 1", ""),
        ("x < y", "x < y", ""),
        ("x < 2*x", "x > 0", ""),
        // the variable stands below alone
        ("1/x < 2", "x > 1", ""),
    ] {
        assert_reasons(&[(&claim(guard, when), why)]);
    }
}

#[test]
fn points_whose_symbols_are_not_polynomials_in_one_number() {
    assert_reasons(&[
        ("var x\nclaim c: sqrt(x) = 2 when x > 0 expect refuted", "a point at a square root"),
        (
            "var x\ngiven g: x^2 = 2\nclaim c: d(x^2, x) = 3 from g expect refuted",
            "a derivative at an algebraic number",
        ),
    ]);
}

#[test]
fn limits_that_are_not_those_of_one_rational_function_each() {
    assert_reasons(&[
        (
            "var x, y, a\nvar f(x)\ngiven g: f -> a as x -> oo\n\
             claim c: a*y -> 0 as y -> 0 from g",
            "limits in two variables",
        ),
        ("var x\nclaim c: sqrt(x)/x -> 0 as x -> oo", "a square root along a limit"),
        (
            "var x, a\nvar f(x)\ngiven g: f -> a as x -> oo when a > 0\n\
             claim c: 2*f -> 2*a as x -> oo when a > 0 from g",
            "a conditional limit among the premises",
        ),
        (
            "var x, a\nvar f(x)\ngiven g: a > 1\ngiven h: a < 0\n\
             claim c: f -> a as x -> oo from g, h expect vacuous",
            "premises of a limit that contradict each other",
        ),
        (
            "var x\nvar f(x)\ngiven g: f > 0, f -> 1 as x -> oo\ngiven h: f < 0\n\
             claim c: not implied g from h",
            "a limit beside other conclusions or conditions",
        ),
        ("var x\nclaim c: d(x^2, x) -> 0 as x -> 0", "a derivative along a limit"),
        (
            "var x, b\nvar f(x), g(x) > 0\ngiven h: x > 0\ngiven law: f = 1 + 1/x\n\
             given tends: g -> b as x -> oo\nclaim c: f = 1 from tends, law, h expect refuted",
            "functions in a declared range, known on a narrowed domain",
        ),
    ]);
}

/// Statements of which the last is refuted by functions, with another way in which they do it.
fn by_functions(statements: &str, change: impl FnOnce(&mut Failure)) -> Audit {
    let mut audit = judged(statements);
    let last = audit.judgements.last_mut().expect("a claim");
    let mut accepted = (**last.links[0].accepted.as_ref().expect("it is judged")).clone();
    let Evidence::Model(Model::Functions(functions)) = &mut accepted.certificate.evidence else {
        unreachable!("functions refute it")
    };
    change(&mut functions.failure);
    last.links[0].accepted = Some(Rc::new(accepted));
    audit
}

/// The kernel does not accept this one, and no gap in a proof is written for Coq either.
#[test]
fn a_limit_of_which_it_is_not_shown_that_the_domain_reaches_it() {
    let statements = "var x, a\nvar f(x)\ngiven ahead: x > 0\ngiven law: f = a + 1/x\n\
        claim c: f -> a + 1 as x -> oo from law, ahead expect refuted";
    let name = |audit: &Audit| coq(audit).lemmas[0].name.clone();
    assert_eq!(name(&by_functions(statements, |_| {})).as_deref(), Ok("claim_c"));
    let audit = by_functions(statements, |failure| {
        let Failure::Limit { proof, .. } = failure else {
            unreachable!("its limit is another one")
        };
        assert_eq!(proof.germ.inside.len(), 1, "one given narrows the domain");
        proof.germ.inside.clear();
    });
    assert_eq!(name(&audit), Err(NotEmitted::Step("a domain that a cited claim narrows")));
}

/// The relations of it alone would be another sentence.
#[test]
fn a_sentence_with_a_limit_that_fails_at_a_point() {
    let audit = by_functions(
        "var x\nvar f(x)\ngiven g: f > 0, f -> 1 as x -> oo\ngiven h: f < 0\n\
         claim c: not implied g from h",
        |failure| {
            let values = vec![(0, vec![whole(0)])];
            *failure = Failure::At(Point { generator: None, values });
        },
    );
    assert_eq!(coq(&audit).lemmas[0].name, Err(NotEmitted::Step("a limit as conclusion")));
}
