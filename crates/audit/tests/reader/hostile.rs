//! Whatever comes in is read or refused, soon and without a panic.

use kane_audit::read;
use proptest::prelude::*;

use crate::many::share;
use crate::{GOOD, LOWERED};

/// Documents near the good ones: pieces of them dropped, doubled, moved, and bytes changed.
fn mutated() -> impl Strategy<Value = Vec<u8>> {
    let edits = prop::collection::vec(
        (any::<prop::sample::Index>(), 0_usize..40, 0_u8..6, any::<u8>()),
        1..8,
    );
    (prop::sample::select(vec![GOOD, LOWERED]), edits).prop_map(|(good, edits)| {
        let mut bytes = good.as_bytes().to_vec();
        for (at, length, kind, byte) in edits {
            let start = at.index(bytes.len().max(1)).min(bytes.len());
            let end = (start + length).min(bytes.len());
            match kind {
                0 => drop(bytes.drain(start..end)),
                1 => {
                    let piece = bytes[start..end].to_vec();
                    bytes.splice(start..start, piece);
                }
                2 => bytes[start..end].reverse(),
                3 => bytes.insert(start, byte),
                4 => bytes.insert(start, b"()`{}[]|\n#=<>-^/*:,;~"[usize::from(byte) % 21]),
                _ => bytes.truncate(end),
            }
        }
        bytes
    })
}

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, ..ProptestConfig::default() }
}

/// Reads and renders: whatever comes in, the places are in the text and nothing panics.
fn survives(bytes: &[u8]) {
    match read("any.md", bytes) {
        Ok(document) => {
            for statement in &document.statements {
                assert!(document.text.get(statement.span.clone()).is_some());
                assert!(!document.source(statement).is_empty());
            }
        }
        Err(found) => {
            assert!(!found.is_empty());
            for diagnostic in found {
                assert!(diagnostic.line >= 1 && diagnostic.column >= 1);
                assert!(diagnostic.to_string().len() < 4000, "{diagnostic}");
            }
        }
    }
}

proptest! {
    #![proptest_config(config(3000))]

    #[test]
    fn mutated_documents_never_panic(bytes in mutated()) {
        survives(&bytes);
    }

    #[test]
    fn raw_bytes_never_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        survives(&bytes);
    }

    #[test]
    fn raw_text_in_a_block_never_panics(text in "\\PC{0,200}") {
        survives(format!("```kane\n{text}\n```\n").as_bytes());
    }

    #[test]
    fn statements_of_any_words_never_panic(
        words in prop::collection::vec(prop::sample::select(vec![
            "var", "let", "given", "claim", "\n", "\n  ", "(1)", "a-b", ":", ":=", "x", "k(x)", "k", "=", "->",
            "oo", "as", "when", "from", "using", "by", "expect", "proved", "not", "implied", "contradiction",
            "and", "or", "implies", "iff", "exists", "in R^2", "in R^3x3", "v", "A", "[", "]", "dot(", "cross(",
            "inverse(", "f(", "f(u, v) :=", "[kg]", "in N", "n", "s(0) :=", "s(n + 1) :=", "s(n)", "x^n", "for n >= 0",
            "by induction", "pow(x, n)", "sum(", "prod(", "for k in 1..n", "for j in 0..3", "..", "exp(", "log(", "x < k", "2*x < y",
            "1", "0", "/", "^", "d(", "(", ")", "cases {", "}", ",", ";", "else", "<", "#", "μ", "−",
        ]), 0..60)
    ) {
        survives(format!("```kane\n{}\n```\n", words.join(" ")).as_bytes());
    }
}

/// A document of about this many bytes, all of it statements.
fn long_document(bytes: usize) -> String {
    let mut text = "```kane\nvar x > 0, y, alpha, k(alpha)\ngiven g0: x = y\n".to_owned();
    let terms = " + 3/4*x*y^2 - abs(x - 0.5)".repeat(6);
    let mut i = 0;
    while text.len() < bytes {
        i += 1;
        text.push_str(&format!("let f{i} := x{terms} # remark\n"));
        text.push_str(&format!("claim g{i}: f{i} <= 0 when y > 1 from g0, g{}\n", i - 1));
    }
    text.push_str("```\n");
    text
}

#[test]
fn ten_megabytes_are_read_in_seconds() {
    let text = long_document(10_000_000);
    let start = std::time::Instant::now();
    let document = read("long.md", text.as_bytes()).expect("well-formed");
    let time = start.elapsed();
    println!("{} statements, {} bytes: {time:?}", document.statements.len(), text.len());
    // a slow machine gets ten times what was measured
    assert!(time.as_secs() < 15, "{time:?}");
}

#[test]
fn hostile_documents_end_quickly() {
    let entangled = {
        let mut text = "```kane\nvar alpha, k(alpha)\nlet s0 := 1\n".to_owned();
        for i in 1..40_000 {
            text.push_str(&format!("let s{i} := s{} + 1\n", if i % 900 == 0 { 0 } else { i - 1 }));
            text.push_str(&format!("claim c{i}: k -> s{i} as alpha -> oo\n"));
        }
        text + "```\n"
    };
    let block = |body: String| format!("```kane\nvar x\ngiven a: x = {body}\n```\n");
    let hostile = [
        block("(".repeat(9_000_000)),
        block("x+".repeat(4_000_000)),
        block("x^".repeat(4_000_000)),
        block("-".repeat(9_000_000)),
        block("9".repeat(9_000_000)),
        block(format!("0.{}5+", "9".repeat(9_990)).repeat(900)),
        block("x,x=".repeat(2_000_000)),
        block(format!("x{}", " when x=x,zz=x".repeat(500_000))),
        format!("```kane\nvar x\n{}```\n", "claim a: x=x from a,b,c,d,e,f,g,h\n".repeat(90_000)),
        format!("```kane\n{}```\n", " x\n".repeat(3_000_000)),
        format!("```kane\nvar {}\n```\n", "a,".repeat(4_000_000)),
        "`".repeat(9_000_000),
        "```kane\n".repeat(1_000_000),
        "> ".repeat(4_000_000),
        block(format!("1, {}x = 1", "(".repeat(9_000_000))),
        block(format!("1, {} = 1", "x or ".repeat(2_000_000))),
        format!(
            "```kane\nvar v in R^3\ngiven a: v = {}v{}\n```\n",
            "inverse(".repeat(200),
            ")".repeat(200)
        ),
        format!(
            "```kane\nvar A in R^3x3\ngiven a: A = {}A{}\n```\n",
            "inverse(".repeat(200),
            ")".repeat(200)
        ),
        format!(
            "```kane\nvar x\nlet f(u) := u*u*u*u\ngiven a: x = {}x{}\n```\n",
            "f(".repeat(200),
            ")".repeat(200)
        ),
        format!("```kane\nvar {}\n```\n", "a < (, ".repeat(1_000_000)),
        format!("```kane\nvar {}\n```\n", "a < sum(, ".repeat(1_000_000)),
        block(format!("{}1{}", "sum(".repeat(200), " for k in 1..9)".repeat(200))),
        block(
            ["a", "b", "c", "e", "f", "g", "h", "i"]
                .iter()
                .fold("x".to_owned(), |term, k| format!("sum({term}*{k} for {k} in 1..60)")),
        ),
        entangled,
    ];
    for text in share(hostile) {
        let start = std::time::Instant::now();
        let outcome = read("hostile.md", text.as_bytes());
        let time = start.elapsed();
        let head: String = text.chars().take(40).collect();
        println!("{time:?} {} {head:?}", outcome.is_ok());
        assert!(time.as_secs() < 15, "{time:?} for {head:?}");
    }
}
