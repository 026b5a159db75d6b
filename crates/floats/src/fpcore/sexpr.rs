//! S-expressions with their places.

use std::ops::Range;

use kane_algebra::syntax::{is_control, is_hidden};

/// The deepest nesting that is read.
const MAX_DEPTH: usize = 200;
/// The most bytes of a file.
const MAX_BYTES: usize = 1 << 20;

/// An atom or a list, with the bytes of its text.
#[derive(Clone, Debug)]
pub(super) struct Sexpr<'a> {
    pub(super) kind: Kind<'a>,
    pub(super) span: Range<usize>,
}

#[derive(Clone, Debug)]
pub(super) enum Kind<'a> {
    /// a symbol, a number or a keyword
    Atom(&'a str),
    /// a text in quotes, without them
    Text,
    List(Vec<Sexpr<'a>>),
}

/// What is wrong, and where.
pub(super) type Fault = (Range<usize>, String);

impl<'a> Sexpr<'a> {
    pub(super) const fn atom(&self) -> Option<&'a str> {
        match self.kind {
            Kind::Atom(text) => Some(text),
            _ => None,
        }
    }

    pub(super) fn list(&self) -> Option<&[Self]> {
        match &self.kind {
            Kind::List(items) => Some(items),
            _ => None,
        }
    }
}

/// All expressions of a text, one after the other.
pub(super) fn expressions(text: &str) -> Result<Vec<Sexpr<'_>>, Fault> {
    if text.len() > MAX_BYTES {
        return Err((0..0, format!("the file has more than {MAX_BYTES} bytes")));
    }
    if let Some((at, c)) = text.char_indices().find(|(_, c)| is_hidden(*c)) {
        let kind = if is_control(c) { "control" } else { "invisible" };
        return Err((at..at + c.len_utf8(), format!("{kind} character U+{:04X}", u32::from(c))));
    }
    let mut reader = Reader { text, at: 0 };
    let mut found = Vec::new();
    while let Some(next) = reader.expression(0)? {
        found.push(next);
    }
    Ok(found)
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
}

const fn closes(open: char) -> char {
    if open == '[' { ']' } else { ')' }
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        self.text.get(self.at..).unwrap_or_default()
    }

    fn skip(&mut self) {
        loop {
            let rest = self.rest();
            let trimmed = rest.trim_start();
            self.at += rest.len() - trimmed.len();
            if !trimmed.starts_with(';') {
                return;
            }
            self.at += trimmed.find('\n').unwrap_or(trimmed.len());
        }
    }

    fn expression(&mut self, depth: usize) -> Result<Option<Sexpr<'a>>, Fault> {
        self.skip();
        let start = self.at;
        let Some(first) = self.rest().chars().next() else { return Ok(None) };
        match first {
            '(' | '[' => {
                if depth >= MAX_DEPTH {
                    let why = format!("more than {MAX_DEPTH} parentheses are open");
                    return Err((start..start + 1, why));
                }
                self.at += 1;
                let mut items = Vec::new();
                loop {
                    self.skip();
                    match self.rest().chars().next() {
                        Some(c) if c == closes(first) => {
                            self.at += 1;
                            return Ok(Some(Sexpr {
                                kind: Kind::List(items),
                                span: start..self.at,
                            }));
                        }
                        Some(c @ (')' | ']')) => {
                            let why = format!("`{c}` closes what `{first}` opened");
                            return Err((self.at..self.at + 1, why));
                        }
                        None => {
                            return Err((start..start + 1, format!("`{first}` is not closed")));
                        }
                        _ => items.extend(self.expression(depth + 1)?),
                    }
                }
            }
            ')' | ']' => Err((start..start + 1, format!("`{first}` closes nothing"))),
            '"' => {
                let mut escaped = false;
                for (offset, c) in self.rest().char_indices().skip(1) {
                    match c {
                        _ if escaped => escaped = false,
                        '\\' => escaped = true,
                        '"' => {
                            self.at += offset + 1;
                            return Ok(Some(Sexpr { kind: Kind::Text, span: start..self.at }));
                        }
                        _ => {}
                    }
                }
                Err((start..start + 1, "the text is not closed by a quotation mark".to_owned()))
            }
            _ => {
                let ends = |c: char| c.is_whitespace() || "()[];\"".contains(c);
                let rest = self.rest();
                let length = rest.find(ends).unwrap_or(rest.len());
                self.at += length;
                let text = rest.get(..length).unwrap_or_default();
                Ok(Some(Sexpr { kind: Kind::Atom(text), span: start..self.at }))
            }
        }
    }
}
