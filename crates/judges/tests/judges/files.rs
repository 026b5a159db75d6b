//! A file for Coq begins with the theory that its lemmas need, and ends with all that it shows.

use kane_judges::coq::{THEORY, library, shared_theory};

use crate::document::judged;
use crate::lemmas::coq;

/// Claims that need more and more of the theory.
const NEEDS: [&str; 4] = [
    "var x\nclaim c: x^2 >= 0",
    "var x\nclaim c: x^2 > 1 expect refuted",
    "var x\nclaim c: 1/x -> 0 as x -> oo",
    "var x, a\nvar f(x)\ngiven g: f -> a as x -> oo\nclaim c: f > a from g expect refuted",
];

#[test]
fn a_file_begins_with_the_theory_that_its_lemmas_need_and_no_more() {
    // by what tells of points, of witnesses, of limits, and of functions
    let tells =
        ["Theorem proved ", "Theorem refuted ", "Theorem limit_proved ", "Theorem point_refuted "];
    let has = [
        [true, false, false, false],
        [true, true, false, false],
        [true, false, true, false],
        [true, true, true, true],
    ];
    for (statements, has) in NEEDS.iter().zip(has) {
        let file = coq(&judged(statements));
        let theory = file.theory();
        assert_eq!(tells.map(|word| theory.contains(word)), has, "{statements}");
        let lemmas = file.text().strip_prefix(&theory).map(str::to_owned);
        let beside = file.beside_theory();
        let (head, shared) =
            beside.split_once("Require Import kane_theory.\n").expect("it is loaded");
        assert!(head.contains(&format!("{THEORY}.v")) && !head.contains("Lemma"), "{head}");
        assert_eq!(lemmas.as_deref(), Some(shared), "{statements}");
    }
    assert!(tells.iter().all(|word| shared_theory().contains(word)));
}

#[test]
fn all_that_is_shown_is_listed_at_the_end() {
    let end = |statements: &str| {
        let text = coq(&judged(statements)).beside_theory();
        text.split_once("Definition all_claims : True :=\n").map(|(_, end)| end.to_owned())
    };
    let statements = "var x\ngiven g: x > 1\nclaim a: x > 0 from g\nclaim b: x + 1 > 0 from a\n\
        claim c: x > 2 from g expect refuted\nclaim d: x > 1 from c\nclaim e: x^2 > 1 from g";
    let names = ["claim_a", "theorem_a", "claim_b", "theorem_b", "claim_c", "claim_d", "claim_e"];
    let bound = |name: &&str| format!("  let _ := @{name} in\n");
    let names = names.iter().chain(&["theorem_e"]).map(bound).collect::<String>();
    let wanted = format!("{names}  I.\nPrint Assumptions all_claims.\n");
    assert_eq!(end(statements), Some(wanted));
    assert_eq!(end("var x\ngiven g: x > 1"), None);
    assert_eq!(end("var x\nclaim c: sqrt(x) = 2 when x > 0 expect refuted"), None);
}

#[test]
fn without_a_lemma_there_is_no_theorem_that_rests_on_it() {
    let audit = judged("var x\ngiven g: x > 1\nclaim a: x > 0 from g\nclaim b: x + 1 > 0 from a");
    let file = coq(&audit);
    let text = file.beside_theory_without(&["claim_a"]);
    assert!(!text.contains("claim_a") && text.contains("Lemma claim_b :"), "{text}");
    assert!(!text.contains("theorem_b"), "{text}");
    assert!(file.theorems(&["claim_a"]).is_empty());
    assert_eq!(file.theorems(&["claim_b"]).into_iter().collect::<Vec<_>>(), ["theorem_a"]);
    assert!(file.without(&["claim_a"]).ends_with(text.split_once("(** * ").expect("a title").1));
}

#[test]
fn a_line_belongs_to_the_lemma_or_the_example_around_it() {
    let file = coq(&judged("var x\ngiven g: x > 1\nclaim a: x > 0 from g\nclaim b: x^2 >= 0"));
    let text = file.text();
    let of = |line: &str| {
        let at = text.lines().position(|l| l == line).expect("the line is there");
        file.lemma_at(at + 1, &text)
    };
    assert_eq!(of("Lemma claim_a :"), Some("claim_a"));
    assert_eq!(of("Example met_a : ~ ("), Some("claim_a"));
    assert_eq!(of("Lemma claim_b :"), Some("claim_b"));
    assert_eq!(file.lemma_at(1, &text), None);
}

#[test]
fn names_are_those_of_claims_and_of_nothing_else() {
    let audit = judged(
        "var x\nclaim (1): x^2 >= 0\nclaim 1.: x^2 + 1 >= 0\nclaim proved: x^2 + 2 >= 0\n\
         claim pair: x^2 + 3 > 0, x^2 + 4 > 0",
    );
    let names: Vec<String> =
        coq(&audit).lemmas.into_iter().map(|l| l.name.expect("it is emitted")).collect();
    assert_eq!(names, ["claim_1", "claim_1_", "claim_proved'", "claim_pair_1", "claim_pair_2"]);
    assert_eq!(library("oblique-collision"), "oblique_collision");
    assert_eq!(library("2-bodies"), "_2_bodies");
}

#[test]
fn a_claim_without_a_theorem_says_why() {
    let why = |statements: &str| {
        let file = coq(&judged(statements));
        let last = file.lemmas.last().expect("it is judged");
        let said = last.theorem.clone().expect("it follows").map(|t| t.name);
        let text = file.beside_theory();
        if let Err(why) = &said {
            assert!(text.ends_with(".\n") && text.contains(&format!("(* {why} *)")), "{text}");
        }
        said.map_err(|why| why.to_string())
    };
    let none = |why: &str| Err(format!("no theorem from the givens: {why}"));
    assert_eq!(
        why("var x\ngiven g: x > 1\nclaim a: x > 2 from g expect refuted\nclaim b: x > 1 from a"),
        none("it cites a")
    );
    assert_eq!(
        why(
            "var n in N\nlet s(0) := 0, s(n + 1) := s(n) + 1\nclaim c: s(n) >= 0 for n >= 0 by induction"
        ),
        none("an induction")
    );
    assert_eq!(
        why("var x, a\nvar f(x)\ngiven g: f = a + 1/x\ngiven h: x > 0\n\
             claim r: sqrt(x^2) = x from h\nclaim s: f = a + 1/x from g, r\n\
             claim c: f -> a as x -> oo from s, h"),
        none("it is about limits")
    );
    assert_eq!(
        why("var x, a\nvar f(x)\ngiven g: f = a + 1/x\ngiven h: x > 0\n\
             claim r: d(x^2, x) = 2*x\nclaim s: f = a + 1/x from g, r\n\
             claim c: f -> a as x -> oo from s, h"),
        none("it is about limits")
    );
    // beside what rests on limits there are no roots and no derivatives
    for (own, reason) in [
        ("sqrt(a - b + 1) >= 1", "a square root along a limit"),
        ("(a - b)*d(b^2, b)^2 >= 0", "it is about limits"),
    ] {
        assert_eq!(
            why(&format!(
                "var x, a, b\nvar f(x)\ngiven tends: f -> a as x -> oo\ngiven above: f > b\n\
                 claim order: a >= b from tends, above\nclaim c: {own} from order"
            )),
            none(reason)
        );
    }
    // a set of values of x has no points of t
    assert_eq!(
        why("var x, t, a, b\nvar f(x), g(t)\ngiven tends: f -> a as x -> oo\ngiven above: f > b\n\
             claim order: a >= b from tends, above\ngiven law: g = a + t\n\
             given after: t > 0\nclaim c: g + t -> a as t -> 0+ from law, after, order"),
        none("it is about limits")
    );
}

#[test]
fn a_title_and_a_label_do_not_end_a_comment() {
    let text = "# T (* \"a\" *) *)\n\n```kane\nvar x\nclaim (1*): x^2 >= 0\n```\n";
    let document = kane_audit::read("t.md", text.as_bytes()).expect("it is well formed");
    let audit = kane_audit::audit(document, &kane_audit::Options::default(), &mut |_, _| {});
    let text = coq(&audit).beside_theory();
    assert!(text.contains("(** * T ( * 'a' * ) * ) *)"), "{text}");
    assert!(text.contains("(** (1* ): x^2 >= 0 (proved) *)"), "{text}");
}
