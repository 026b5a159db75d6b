//! What can stand at a place: labels where statements are cited, symbols in formulas, the words of the
//! language where they belong.

use std::ops::Range;

use kane_audit::{Kind, Outline};
use serde_json::{Value, json};

use crate::document::Open;
use crate::message::Refusal;

/// Words with which a statement begins.
const STATEMENTS: [&str; 4] = ["var", "let", "given", "claim"];
/// Words with which a clause begins.
const CLAUSES: [&str; 6] = ["as", "when", "from", "using", "by", "expect"];
/// What stands behind `expect`.
const VERDICTS: [&str; 6] =
    ["proved", "refuted", "vacuous", "ill-defined", "unsupported", "undecided"];
/// Functions, and words of formulas.
const WORDS: [&str; 17] = [
    "abs", "min", "max", "sqrt", "sin", "cos", "tan", "exp", "log", "pi", "oo", "cases", "else",
    "and", "or", "implies", "iff",
];

/// What the protocol calls these kinds.
mod kind {
    pub(super) const FUNCTION: u8 = 3;
    pub(super) const VARIABLE: u8 = 6;
    pub(super) const KEYWORD: u8 = 14;
    pub(super) const REFERENCE: u8 = 18;
    pub(super) const CONSTANT: u8 = 21;
}

/// What can stand at a byte; nothing outside of the blocks of statements.
pub(crate) fn at(uri: &str, document: &mut Open, at: usize) -> Result<Value, Refusal> {
    let text = document.text.clone();
    let outline = document.outline(uri);
    let block = outline.blocks.iter().find(|block| block.start < at && at <= block.end);
    let Some(block) = block.cloned() else { return Ok(Value::Array(Vec::new())) };
    let statement = statement_before(&text[block.start..at]);
    // the line of the fence is the block's own
    let Some(statement) = statement else { return Ok(Value::Array(Vec::new())) };
    let start = at - statement.len();
    let items = match clause(statement) {
        Clause::Begin => words(&STATEMENTS, word_before(&text, at)),
        Clause::Expect => words(&VERDICTS, dashed_before(&text, at)),
        Clause::From => labels(outline, start, label_before(&text, start, at)),
        Clause::Formula => {
            let word = word_before(&text, at);
            let mut items = names(outline, word.clone());
            items.extend(words(&WORDS, word.clone()));
            items.extend(words(&CLAUSES, word));
            items
        }
    };
    let shown = items.into_iter().map(|(label, kind, detail, place)| {
        json!({
            "label": label,
            "kind": kind,
            "detail": detail,
            "filterText": label,
            "textEdit": { "range": document.range(&place), "newText": label },
        })
    });
    Ok(shown.collect::<Vec<_>>().into())
}

/// A label, a kind, a word on it, and the bytes that it replaces.
type Item = (String, u8, &'static str, Range<usize>);

fn words(words: &[&str], place: Range<usize>) -> Vec<Item> {
    words.iter().map(|word| ((*word).to_owned(), kind::KEYWORD, "", place.clone())).collect()
}

fn names(outline: &Outline, place: Range<usize>) -> Vec<Item> {
    let names = outline.names.iter().filter(|name| name.place.start < place.start);
    let symbols = names.map(|name| {
        let (kind, detail) = match name.is_definition {
            true => (kind::CONSTANT, "definition"),
            false => (kind::VARIABLE, "symbol"),
        };
        (name.text.clone(), kind, detail, place.clone())
    });
    let known = |text: &str| outline.names.iter().any(|name| name.text == text);
    // definitions with arguments, and arrays, are no symbols of their own
    let others = outline.labels.iter().filter(|label| {
        label.kind == Kind::Let && label.is_name && label.place.start < place.start
    });
    let others = others.filter(|label| !known(&label.text));
    let others =
        others.map(|label| (label.text.clone(), kind::FUNCTION, "definition", place.clone()));
    symbols.chain(others).collect()
}

/// The labels above a statement.
fn labels(outline: &Outline, statement: usize, place: Range<usize>) -> Vec<Item> {
    let above = outline.labels.iter().filter(|label| label.statement.start < statement);
    let item = |label: &kane_audit::Label| {
        let detail = match label.kind {
            Kind::Let => "let",
            Kind::Given => "given",
            Kind::Claim => "claim",
            Kind::Broken => "with an error",
        };
        (label.text.clone(), kind::REFERENCE, detail, place.clone())
    };
    // the nearest is cited most often
    above.rev().map(item).collect()
}

/// What is being written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Clause {
    Begin,
    From,
    Expect,
    Formula,
}

/// Which clause the end of a statement's text is in.
fn clause(statement: &str) -> Clause {
    let code = statement.rsplit('\n').next().unwrap_or_default();
    if code.contains('#') {
        return Clause::Begin;
    }
    let mut clause = Clause::Begin;
    let ended = statement.trim_end_matches(|c: char| c.is_alphanumeric() || "-_'′.(".contains(c));
    let mut before = "";
    for word in ended.split(|c: char| c.is_whitespace() || c == ',').filter(|w| !w.is_empty()) {
        clause = match word {
            "from" => Clause::From,
            "expect" => Clause::Expect,
            "implied" if before == "not" => Clause::From,
            "as" | "when" | "using" | "by" => Clause::Formula,
            _ if STATEMENTS.contains(&word) && clause == Clause::Begin => Clause::Formula,
            _ => clause,
        };
        before = word;
    }
    clause
}

/// The text of the statement at the end of this part of a block, which begins with its fence; `None` on
/// the line of the fence.
fn statement_before(block: &str) -> Option<&str> {
    let (_, code) = block.split_once('\n')?;
    let mut start = code.len();
    for line in code.split('\n').rev() {
        start -= line.len();
        if !line.starts_with([' ', '\t']) {
            break;
        }
        start = start.saturating_sub(1);
    }
    code.get(start..)
}

/// The word that ends here.
fn word_before(text: &str, at: usize) -> Range<usize> {
    let before = text.get(..at).unwrap_or_default();
    let inside = |c: char| c.is_alphanumeric() || "_'′".contains(c);
    before.trim_end_matches(inside).len()..at
}

/// The same with dashes in it.
fn dashed_before(text: &str, at: usize) -> Range<usize> {
    let before = text.get(..at).unwrap_or_default();
    before.trim_end_matches(|c: char| c.is_alphanumeric() || c == '-').len()..at
}

/// The label that ends here, back to a comma or a blank, and not before the statement begins.
fn label_before(text: &str, start: usize, at: usize) -> Range<usize> {
    let before = text.get(start..at).unwrap_or_default();
    let cut = before.rfind([',', ' ', '\t', '\n']).map_or(0, |cut| cut + 1);
    start + cut..at
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_clause_is_the_one_that_is_being_written() {
        for (statement, expected) in [
            ("", Clause::Begin),
            ("cla", Clause::Begin),
            ("claim a: x", Clause::Formula),
            ("claim a: x > 0 fr", Clause::Formula),
            ("claim a: x > 0 from", Clause::Formula),
            ("claim a: x > 0 from ", Clause::From),
            ("claim a: x > 0 from (1", Clause::From),
            ("claim a: x > 0\n  from (1), b, ", Clause::From),
            ("claim a: x > 0 from (1) using x", Clause::Formula),
            ("claim a: x > 0 from (1) expect ill-d", Clause::Expect),
            ("claim a: not implied ", Clause::From),
            ("claim a: x > 0 # from ", Clause::Begin),
        ] {
            assert_eq!(clause(statement), expected, "{statement}");
        }
    }
}
