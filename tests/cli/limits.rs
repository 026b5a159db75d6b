//! What is said of limits that are not as their author meant them.

use crate::{document, kane, scratch};

/// Runs the document and gives what is printed of the claim.
fn said(name: &str, text: &str) -> String {
    let path = document(&scratch(name), "limit.md", text);
    let run = kane(&["audit", &path]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    let mut lines = run.stdout.lines();
    let line = lines.find(|line| line.starts_with("! ") && line.contains("told"));
    line.expect("the claim has a line").to_owned()
}

#[test]
fn a_constant_that_a_given_ties_to_the_limit_variable_is_named() {
    let text = "var m > 0, u, w\ngiven law: m*w = u\nclaim told: w -> 0 as m -> oo from law";
    let line = said("constant", text);
    let advice =
        "nothing in it varies with m: w is a constant as declared, and would be a function as w(m)";
    assert!(line.contains(advice), "{line}");
    let text = text.replace(", w\n", ", w(m)\n");
    let path = document(&scratch("function"), "limit.md", &text);
    assert_eq!(kane(&["audit", &path]).code, 0, "with a function the claim is proved");
}

#[test]
fn the_side_on_which_a_limit_fails_is_named() {
    let line = said("side", "var h\nclaim told: abs(h)/h -> 1 as h -> 0");
    assert!(line.contains("the limit from the left is -1"), "{line}");
    let line = said("domain", "var h > 0\nclaim told: abs(h)/h -> -1 as h -> 0");
    assert!(line.contains("the limit is 1"), "there is one side alone: {line}");
}

#[test]
fn a_place_at_which_what_tends_is_undefined_is_named() {
    let line = said("radicand", "var h\nclaim told: sqrt(h) -> 0 as h -> 0");
    assert!(line.contains("(root of a negative number), for example at h = -1/"), "{line}");
    let line = said("target", "var h, v\nclaim told: h/h -> v/v as h -> 0");
    assert!(line.contains("is undefined (division by zero), for example for v = 0"), "{line}");
}
