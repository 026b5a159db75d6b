//! Lines end at LF, CR or CRLF, in any mixture: a document says the same, and its faults have the same
//! places.

use kane::audit::{Body, Content, Document, read};

use crate::many::many;
use crate::support::{Chance, pages};

/// The text with some of its line feeds replaced. A carriage return before a line feed that stays would
/// make one end of two.
fn mixed(text: &str, chance: &mut Chance) -> String {
    let mut out = String::with_capacity(2 * text.len());
    let mut ended_by_return = false;
    for c in text.chars() {
        if c != '\n' {
            ended_by_return = false;
            out.push(c);
            continue;
        }
        let choices: &[&str] =
            if ended_by_return { &["\r", "\r\n"] } else { &["\n", "\n", "\r", "\r\n"] };
        let end = *chance.pick(choices);
        ended_by_return = end == "\r";
        out.push_str(end);
    }
    out
}

/// What a document says, without its places in bytes.
fn said(document: &Document) -> Vec<String> {
    let statements = document.statements.iter().map(|s| {
        let body = match &s.body {
            Body::Claim(claim) => {
                let content = match &claim.content {
                    Content::Links(links) => {
                        format!("{:?}", links.iter().map(|(link, _)| link).collect::<Vec<_>>())
                    }
                    Content::Sought(sought) => {
                        let links = sought.links.iter().map(|(link, _)| link).collect::<Vec<_>>();
                        format!("{:?} {links:?}", sought.names)
                    }
                    other => format!("{other:?}"),
                };
                format!(
                    "{content} {:?} {:?} {:?} {:?}",
                    claim.when, claim.from, claim.by, claim.expect
                )
            }
            other => format!("{other:?}"),
        };
        format!("{} {}: {body}", s.line, s.label)
    });
    let whole = format!("{:?} {:?}", document.title, document.context);
    std::iter::once(whole).chain(statements).collect()
}

#[test]
fn no_mixture_of_line_ends_changes_a_statement_or_the_place_of_a_fault() {
    let mut chance = Chance::new(5);
    let shipped = pages("docs/derivations").into_iter().chain(pages("tests/conformance/semantics"));
    let mut seen = 0;
    for (name, bytes) in shipped {
        let text = String::from_utf8(bytes).expect("the pages are UTF-8");
        // those that are about line ends have some of their own
        if text.contains('\r') {
            continue;
        }
        let plain = read(&name, text.as_bytes());
        for _ in 0..many(3) {
            seen += 1;
            let other = mixed(&text, &mut chance);
            match (&plain, read(&name, other.as_bytes())) {
                (Ok(plain), Ok(other)) => assert_eq!(said(plain), said(&other), "{name}"),
                (Err(plain), Err(other)) => {
                    let shown = |faults: &[kane::audit::Diagnostic]| {
                        faults.iter().map(ToString::to_string).collect::<String>()
                    };
                    assert_eq!(shown(plain), shown(&other), "{name}");
                }
                (plain, other) => panic!("{name}: {} and {}", plain.is_ok(), other.is_ok()),
            }
        }
    }
    assert!(seen > 100, "{seen} mixtures");
}

#[test]
fn the_digest_is_that_of_the_file() {
    let read = |text: &str| read("a.md", text.as_bytes()).expect("well formed").sha256();
    let lines = ["# A", "", "```kane", "var x", "given a: x = 1", "```", ""];
    let digests = ["\n", "\r", "\r\n"].map(|end| read(&lines.join(end)));
    // as `sha256sum` prints them
    assert_ne!(digests[0], digests[1]);
    assert_ne!(digests[1], digests[2]);
}
