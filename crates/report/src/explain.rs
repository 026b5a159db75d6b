//! One statement in full: the proof or the witness, step by step, for a person with paper.

use std::fmt::Write as _;

use kane_audit::{Audit, LinkJudgement, Verdict};

use crate::report::Entry;
use crate::words::{Form, Line, equations, example};

/// Writes out the statement at `index`; `None` if the audit has no such statement.
#[must_use]
pub fn explain(audit: &Audit, index: usize) -> Option<String> {
    let entry = Entry::new(audit, index)?;
    let judgement = entry.judgement;
    let mut out = String::new();
    let _ = writeln!(out, "{}", entry.source());
    let _ = write!(out, "{}:{}: {}", audit.document.name, entry.statement.line, judgement.verdict);
    for remark in entry.expectation().into_iter().chain(entry.support()) {
        let _ = write!(out, ", {remark}");
    }
    out.push('\n');

    let count = judgement.links.len();
    for (number, link) in judgement.links.iter().enumerate() {
        out.push('\n');
        if count > 1 {
            let _ = write!(out, "link {} of {count}: ", number + 1);
        }
        write_link(&mut out, &entry, (number, link));
    }
    if entry.is_claim() {
        write_ground(&mut out, &entry);
    }
    Some(out)
}

/// The proof or witness of one link.
fn write_link(out: &mut String, entry: &Entry<'_>, (number, link): (usize, &LinkJudgement)) {
    let _ = writeln!(out, "{}", entry.link_text(number));
    let _ = writeln!(out, "  {}: {}", link.verdict, entry.reason(link, Form::Plain));
    for Line { depth, text, .. } in entry.steps(link, Form::Plain) {
        let _ = writeln!(out, "{:indent$}{text}", "", indent = 4 + 2 * depth);
    }
    if !link.used.is_empty() {
        let _ = writeln!(out, "  uses {}", entry.labels(&link.used).join(", "));
    }
    match &link.certificate {
        Some(digest) => {
            _ = writeln!(
                out,
                "  the kernel accepted certificate {digest}; search steps: {}",
                link.cost
            )
        }
        None => _ = writeln!(out, "  no certificate; search steps: {}", link.cost),
    }
}

/// Verdicts of which it is shown whether the hypotheses can hold: nowhere, or at the point that speaks against the claim.
const AGAINST: [Verdict; 3] = [Verdict::Vacuous, Verdict::Refuted, Verdict::IllDefined];

/// What the whole rests on: the premises, each as written, and one point at which they hold.
fn write_ground(out: &mut String, entry: &Entry<'_>) {
    let judgement = entry.judgement;
    let givens = entry.cited(&judgement.rests_on);
    if !givens.is_empty() {
        out.push_str("\nrests on\n");
        for given in givens {
            let _ = writeln!(out, "  {}", given.source());
        }
    }
    match example(judgement, Form::Plain) {
        Some(example) if example.is_empty() => {}
        Some(example) => {
            let at = equations(&example, Form::Plain);
            let _ = writeln!(out, "\nits hypotheses hold, for example, at {at}");
        }
        // and where a point speaks against the claim, it is one at which they do
        None if AGAINST.contains(&judgement.verdict) => {}
        None => out.push_str("\nno point was found at which all its hypotheses hold\n"),
    }
}

#[cfg(test)]
mod tests {
    use kane_audit::{Options, audit, read};

    use super::*;

    /// The claim of a document, written out, and its verdict.
    fn explained(statements: &str) -> (Verdict, String) {
        let text = format!("# T\n\n```kane\n{statements}```\n");
        let document = read("explain.md", text.as_bytes()).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let last = audit.judgements.len() - 1;
        (audit.judgements[last].verdict, explain(&audit, last).expect("it is there"))
    }

    #[test]
    fn a_claim_that_a_point_refutes_is_not_said_to_have_hypotheses_that_hold_at_none() {
        let none = "no point was found at which all its hypotheses hold";
        let givens = "var x > 0, y\ngiven (1): x^3 + x*y^2 = 2*y + 5\ngiven (2): x^2*y + y^5 = 3\n";
        let (verdict, told) =
            explained(&format!("{givens}claim (3): contradiction from (1), (2)\n"));
        assert_eq!(verdict, Verdict::Refuted);
        assert!(told.contains("At the point") && !told.contains(none), "{told}");
        let (verdict, told) =
            explained("var x\ngiven (1): x^2 < 0\nclaim (2): contradiction from (1)\n");
        assert_eq!(verdict, Verdict::Proved);
        assert!(told.contains(none), "{told}");
    }

    /// The lines of what was told that come behind one, down to the next that is not indented further.
    fn below<'t>(told: &'t str, head: &str) -> Vec<&'t str> {
        let behind = told.lines().skip_while(|line| line.trim() != head).skip(1);
        behind.take_while(|line| line.starts_with("      ")).map(str::trim).collect()
    }

    const GIVENS: &str = "var u > 0, v, w, e >= 0\ngiven rebound: v = -e*u\ngiven other: w = 2*u\n";

    #[test]
    fn what_is_false_under_all_is_told_with_a_point_at_which_all_can_be_checked() {
        let (verdict, told) = explained(&format!("{GIVENS}claim c: v = 0 from rebound\n"));
        assert_eq!(verdict, Verdict::Refuted);
        let head = "All else that is assumed above holds there too, with w = 2:";
        assert_eq!(below(&told, head), ["other, w = 2*u: 2 = 2"], "{told}");
    }

    #[test]
    fn a_given_that_fails_at_a_witness_is_told_in_numbers_that_the_outline_has() {
        let (verdict, told) =
            explained(&format!("{GIVENS}given sum: w + v > 0\nclaim c: u < w from rebound\n"));
        assert_eq!(verdict, Verdict::Refuted);
        let outline = told.lines().find(|line| line.starts_with("  refuted: ")).expect("a reason");
        for symbol in ["u = ", "v = ", "w = "] {
            assert!(outline.contains(symbol), "{symbol}: {outline}");
        }
        let failing = below(&told, "What is assumed above and not cited fails there:");
        assert!(!failing.is_empty(), "{told}");
        assert!(failing.iter().all(|line| line.ends_with(" is false")), "{told}");
    }

    #[test]
    fn a_premise_that_says_nothing_at_a_point_is_not_told_to_be_false_there() {
        let conditional =
            "var x, y\ngiven g: x = 5 when y > 0\nclaim c: x = 1 or x = 5 when y < 0 from g\n";
        let (verdict, told) = explained(conditional);
        assert_eq!(verdict, Verdict::Refuted);
        assert!(told.contains("g says nothing there, since y > 0: "), "{told}");
        assert!(!told.contains("g, x = 5:"), "{told}");
        let undefined =
            "var x\ngiven p: x > 0\nclaim q: x*(1/x) = 1 from p\nclaim c: x != 0 from q\n";
        let (verdict, told) = explained(undefined);
        assert_eq!(verdict, Verdict::Refuted);
        let says = "q says nothing there, since x*(1/x) = 1: undefined (division by zero: x = 0)";
        assert!(told.contains(says), "{told}");
    }

    #[test]
    fn at_an_irrational_point_a_premise_whose_condition_fails_or_is_not_seen_to_hold_says_nothing()
    {
        let of = |when: &str| {
            let givens = "var v > 4, y\ngiven a: v = 10\ngiven root: y^3 = 3\n";
            let (verdict, told) = explained(&format!(
                "{givens}given b: y = 5 when {when}\nclaim c: contradiction from a\n"
            ));
            assert_eq!(verdict, Verdict::Refuted);
            assert!(told.contains("All else that is assumed above holds there too"), "{told}");
            assert!(!told.contains("b, y = 5"), "{told}");
            told
        };
        assert!(of("y < 0").contains("b says nothing there, since y < 0: left side about 1.44"));
        assert!(!of("abs(y^3 - 3) > 0").contains("      b"));
    }
}
