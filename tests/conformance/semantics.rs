//! One small document a rule of the language: each ends exactly as it says.
//!
//! A page that starts with `<!-- error: text -->` cannot be read, and the message contains the
//! text. One that starts with `<!-- fails -->` is read, and does not end as its `expect`s say.

use kane::audit::{Options, audit, read};

use crate::support::pages;

#[test]
fn every_rule_of_the_language_has_a_document_that_ends_as_it_says() {
    let pages = pages("tests/conformance/semantics");
    let (mut claims, mut errors, mut fails) = (0, 0, 0);
    let mut surprises = Vec::new();
    for (name, bytes) in &pages {
        let text = String::from_utf8_lossy(bytes);
        let head = text.lines().next().unwrap_or_default();
        let wanted = head.strip_prefix("<!-- error: ").and_then(|rest| rest.strip_suffix(" -->"));
        let document = match (read(name, bytes), wanted) {
            (Ok(document), None) => document,
            (Ok(_), Some(_)) => {
                surprises.push(format!("{name} is read without an error"));
                continue;
            }
            (Err(faults), wanted) => {
                let message: String = faults.iter().map(ToString::to_string).collect();
                match wanted {
                    Some(wanted) if message.contains(wanted) => errors += 1,
                    _ => surprises.push(format!("{name}: {message}")),
                }
                continue;
            }
        };
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        if head == "<!-- fails -->" {
            fails += 1;
            if audit.as_expected() {
                surprises.push(format!("{name} ends as expected, but should not"));
            }
            continue;
        }
        for (statement, judgement) in audit.document.statements.iter().zip(&audit.judgements) {
            claims += usize::from(!judgement.links.is_empty());
            if !judgement.as_expected() {
                let reasons: Vec<String> = judgement
                    .links
                    .iter()
                    .map(|l| format!("{:?}", (l.reason(), &l.open)))
                    .collect();
                surprises.push(format!(
                    "{name}: {} is {}: {}",
                    statement.label,
                    judgement.verdict,
                    reasons.join("; ")
                ));
            }
        }
    }
    println!("semantics: {} documents, {claims} claims as expected", pages.len());
    println!("semantics: {errors} documents rejected, {fails} documents that fail, as they should");
    assert!(surprises.is_empty(), "{}", surprises.join("\n"));
    assert!(pages.len() >= 30 && errors >= 3 && fails >= 2, "the suite is there");
}
