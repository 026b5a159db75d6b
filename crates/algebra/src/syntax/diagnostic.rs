//! What is wrong with a file, for people: place, message, the line with a caret.

use std::fmt;
use std::ops::Range;

use super::{is_hidden, visible};

/// Characters of a line that are shown at most.
const WINDOW: usize = 100;

/// One fault of a file. Its `Display` is the whole report, with the line and a caret:
///
/// ```text
/// error: unknown symbol `vx1`
///   --> collision.md:12:9
///    |
/// 12 | given (2): vx1 = 3
///    |            ^^^
///    = did you mean `vx0`?
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// the file's name, as given
    pub file: String,
    /// line, from 1
    pub line: usize,
    /// column in characters, from 1
    pub column: usize,
    /// bytes of the text concerned
    pub span: Range<usize>,
    /// what is wrong
    pub message: String,
    /// a hint at the remedy
    pub note: Option<String>,
    excerpt: Excerpt,
}

/// The part of the line that is shown, and where in it the caret stands, in characters.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Excerpt {
    text: String,
    caret: usize,
    width: usize,
}

impl Diagnostic {
    /// A fault at a place of a text, without a hint.
    #[must_use]
    pub fn new(file: &str, text: &str, span: Range<usize>, message: String) -> Self {
        Self::among(file, &mut Lines::new(text), span, message)
    }

    /// The same, one of several faults of a text: lines are counted once if they come in the order of
    /// the text.
    #[must_use]
    pub fn among(file: &str, lines: &mut Lines<'_>, span: Range<usize>, message: String) -> Self {
        let text = lines.text;
        let start = floor(text, span.start);
        let Place { line, column, line_start } = lines.place(start);
        let before = text.get(line_start..start).unwrap_or_default();
        let after = text.get(start..).unwrap_or_default();
        let after = after.lines().next().unwrap_or_default();
        let length = floor(text, span.end).saturating_sub(start);
        let marked = after.get(..length).unwrap_or(after);
        let excerpt = Excerpt::new(before, after, marked.chars().count());
        Self { file: file.to_owned(), line, column, span, message, note: None, excerpt }
    }

    /// That a file is not text, at the first byte that is not UTF-8.
    #[must_use]
    pub fn not_utf8(file: &str, bytes: &[u8]) -> Self {
        let valid = std::str::from_utf8(bytes).map_or_else(|error| error.valid_up_to(), str::len);
        let mut text = String::from_utf8_lossy(bytes.get(..valid).unwrap_or_default()).into_owned();
        text.push(char::REPLACEMENT_CHARACTER);
        // a carriage return by itself ends a line, too; no byte moves
        let lone = |at: usize| text.as_bytes().get(at + 1) != Some(&b'\n');
        let ended = |(at, c): (usize, char)| if c == '\r' && lone(at) { '\n' } else { c };
        let text: String = text.char_indices().map(ended).collect();
        Self::new(file, &text, valid..valid + 1, "the file is not UTF-8".to_owned())
    }

    /// A fault of the file as a whole.
    #[must_use]
    pub fn at_start(file: &str, message: String) -> Self {
        Self {
            file: file.to_owned(),
            line: 1,
            column: 1,
            span: 0..0,
            message,
            note: None,
            excerpt: Excerpt::default(),
        }
    }
}

impl Excerpt {
    fn new(before: &str, after: &str, width: usize) -> Self {
        // tabs and what cannot be seen would put the caret out of place, or more
        let printable = |c: char| match c {
            _ if is_hidden(c) => char::REPLACEMENT_CHARACTER,
            _ if c.is_control() => ' ',
            _ => c,
        };
        let kept = WINDOW / 2;
        let cut = before.char_indices().rev().nth(kept - 1);
        let cut = cut.map_or(0, |(cut, _)| cut);
        let mut text = String::new();
        if cut > 0 {
            text.push('…');
        }
        text.extend(before.get(cut..).unwrap_or_default().chars().map(printable));
        let caret = text.chars().count();
        let room = WINDOW - kept;
        text.extend(after.chars().take(room).map(printable));
        if after.chars().nth(room).is_some() {
            text.push('…');
        }
        Self { text: text.trim_end().to_owned(), caret, width: width.clamp(1, room) }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "error: {}", visible(&self.message))?;
        let number = self.line.to_string();
        let margin = " ".repeat(number.len());
        writeln!(f, "{margin}--> {}:{}:{}", visible(&self.file), self.line, self.column)?;
        if self.excerpt != Excerpt::default() {
            let indent = " ".repeat(self.excerpt.caret);
            let carets = "^".repeat(self.excerpt.width);
            writeln!(f, "{margin} |")?;
            writeln!(f, "{number} | {}", self.excerpt.text)?;
            writeln!(f, "{margin} | {indent}{carets}")?;
        }
        if let Some(note) = &self.note {
            writeln!(f, "{margin} = {}", visible(note))?;
        }
        Ok(())
    }
}

/// The nearest character boundary at or before `at`.
fn floor(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Where a byte of the text is.
#[derive(Clone, Copy, Debug)]
pub struct Place {
    /// from 1
    pub line: usize,
    /// in characters, from 1
    pub column: usize,
    /// the first byte of the line
    pub line_start: usize,
}

/// Counts lines and columns, in one pass as long as places are asked for in the order of the text.
#[derive(Debug)]
pub struct Lines<'a> {
    text: &'a str,
    at: usize,
    place: Place,
}

impl<'a> Lines<'a> {
    /// Before the first of them.
    #[must_use]
    pub fn new(text: &'a str) -> Self {
        let place = Place { line: 1, column: 1, line_start: 0 };
        Self { text, at: 0, place }
    }

    /// The place of this byte, which begins a character.
    pub fn place(&mut self, at: usize) -> Place {
        if at < self.at {
            *self = Self::new(self.text);
        }
        let passed = self.text.get(self.at..at).unwrap_or_default();
        let newlines = passed.bytes().filter(|byte| *byte == b'\n').count();
        let tail = match passed.rfind('\n') {
            Some(newline) => {
                self.place.line_start = self.at + newline + 1;
                self.place.column = 1;
                passed.get(newline + 1..).unwrap_or_default()
            }
            None => passed,
        };
        self.place.line += newlines;
        self.place.column += tail.chars().count();
        self.at = at;
        self.place
    }
}
