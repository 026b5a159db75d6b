//! Formulas in LaTeX between dollars: what they are read as, and where in the file they stand.

use kane_audit::{read, survey};
use sha2::{Digest as _, Sha256};

fn document(statement: &str) -> String {
    format!("# T\n\n```kane\nvar x, alpha, k, v_x0'\n{statement}\n```\n")
}

fn source(statement: &str) -> String {
    let text = document(statement);
    let read = read("d.md", text.as_bytes()).expect("it is well formed");
    let last = read.statements.last().expect("a statement");
    // the digest is of the file, and not of what it is read as
    let written: String = Sha256::digest(&text).iter().map(|b| format!("{b:02x}")).collect();
    assert_eq!(read.sha256(), written);
    read.source(last).to_owned()
}

#[test]
fn formulas_in_dollars_are_read_and_shown_in_the_language() {
    for (written, read) in [
        (
            r"claim (16): $k = \frac{1-\alpha}{1+\alpha}$ expect refuted",
            "claim (16): k = (1 - alpha)/(1 + alpha) expect refuted",
        ),
        (r"given a: $v_{x0}' > 0$, x = 1 # $", "given a: v_x0' > 0, x = 1"),
        (r"given (50% $&$): $x = 1$", "given (50% $&$): x = 1"),
    ] {
        assert_eq!(source(written), read);
    }
}

#[test]
fn a_formula_that_cannot_be_read_is_an_error_at_its_place() {
    for (statement, column, message) in [
        (r"given a: x = 1, $k \approx 1$", 17, "approximately"),
        (r"given a: $k = \int x$", 10, "no meaning"),
        (r"given a: $k = 1", 10, "ends in its line"),
        ("given a: $k = \n  1$", 10, "ends in its line"),
        (r"given a: $\varphi = 1$, $\phi = 2$", 25, "one name"),
    ] {
        let faults = read("d.md", document(statement).as_bytes()).expect_err(statement);
        assert_eq!((faults[0].line, faults[0].column), (5, column), "{}", faults[0]);
        assert!(faults[0].message.contains(message), "{}", faults[0]);
    }
}

#[test]
fn a_place_behind_a_formula_is_found_in_the_file() {
    let source = "# T\n\n```kane\nvar x, alpha # μ 𝛂\ngiven a: $x = \\frac{\\alpha}{2}$ when x > 0, \
                  alpha = 1\nclaim b: $x > 0$, x >= 0 from a\n```\n";
    let survey = survey("d.md", source.as_bytes());
    let document = survey.document.expect("it is well formed");
    let (given, claim) = (&document.statements[0], &document.statements[1]);
    let file = |range| &source[survey.origin.in_file(range)];
    assert_eq!(file(given.parts.content.clone()), "$x = \\frac{\\alpha}{2}$");
    assert_eq!(file(given.parts.when.clone().expect("it has one")), "when x > 0, alpha = 1");
    assert_eq!(file(claim.parts.label.clone()), "b");
    assert_eq!(file(claim.parts.content.clone()), "$x > 0$, x >= 0");
    assert_eq!(file(claim.parts.from.clone().expect("it has one")), "from a");
    // in the middle of a formula the whole of it is meant
    let middle = given.parts.content.start + 4;
    assert_eq!(file(middle..middle + 2), "$x = \\frac{\\alpha}{2}$");
}
