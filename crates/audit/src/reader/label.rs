//! Labels: `(9)`, `(10v)`, `k-range`.

use std::ops::Range;

use kane_algebra::syntax::{Parser, SyntaxError, SyntaxErrorKind, canonical_name};

/// Clauses in the order in which they must stand; no label is called so.
pub(super) const CLAUSES: [&str; 6] = ["as", "when", "from", "using", "by", "expect"];

/// Bytes of a label.
const MAX_LABEL_BYTES: usize = 200;

/// The key under which a label is known: without parentheses and outer blanks, Greek spelled out.
pub(super) fn key(label: &str) -> String {
    let bare = label.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')).unwrap_or(label);
    canonical_name(bare.trim()).into_owned()
}

/// Bytes that the label at the start of `text` takes, if there is one.
pub(super) fn length(text: &str) -> Option<usize> {
    let end = if text.starts_with('(') {
        let inner = text.get(1..)?;
        // a comment may begin here, too
        let close = inner.find(['(', ')', '#', '\n', '\r'])?;
        if !inner.get(close..)?.starts_with(')') || inner.get(..close)?.trim().is_empty() {
            return None;
        }
        close + 2
    } else {
        if !text.starts_with(char::is_alphanumeric) {
            return None;
        }
        text.find(|c: char| !c.is_alphanumeric() && !"-_'′.".contains(c)).unwrap_or(text.len())
    };
    (end <= MAX_LABEL_BYTES).then_some(end)
}

/// Passes a label and returns it with its place.
pub(super) fn take<'a>(p: &mut Parser<'a>) -> Result<(&'a str, Range<usize>), SyntaxError> {
    let (rest, start) = p.rest();
    let Some(length) = length(rest) else {
        return Err(p.unexpected("a label, such as `(9)` or `k-range`"));
    };
    let word = rest.get(..length).unwrap_or_default();
    if CLAUSES.contains(&word) {
        return Err(p.fault(SyntaxErrorKind::ReservedWord(word.to_owned())));
    }
    Ok(p.take_until(start + length))
}
