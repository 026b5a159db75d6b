//! Places as editors count them: lines that end at LF, CRLF or CR, and units of UTF-16 in them.

use std::ops::Range;

use serde_json::{Value, json};

/// Where the lines of a text begin.
#[derive(Clone, Debug)]
pub(crate) struct Lines {
    starts: Vec<usize>,
}

/// A place in a text, both from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Position {
    pub(crate) line: usize,
    /// in units of UTF-16
    pub(crate) character: usize,
}

impl Position {
    /// The position of a request; `None` if it is none.
    pub(crate) fn of(value: &Value) -> Option<Self> {
        let number = |name| usize::try_from(value.get(name)?.as_u64()?).ok();
        Some(Self { line: number("line")?, character: number("character")? })
    }

    fn json(self) -> Value {
        json!({ "line": self.line, "character": self.character })
    }
}

impl Lines {
    pub(crate) fn of(text: &str) -> Self {
        let bytes = text.as_bytes();
        let ends = |&(at, byte): &(usize, &u8)| {
            *byte == b'\n' || (*byte == b'\r' && bytes.get(at + 1) != Some(&b'\n'))
        };
        let after = bytes.iter().enumerate().filter(ends).map(|(at, _)| at + 1);
        Self { starts: std::iter::once(0).chain(after).collect() }
    }

    /// The bytes of a line, without its end.
    pub(crate) fn line(&self, text: &str, line: usize) -> Range<usize> {
        let start = self.starts.get(line).copied().unwrap_or(text.len());
        let end = self.starts.get(line.saturating_add(1)).copied().unwrap_or(text.len());
        let inside = text.get(start..end).unwrap_or_default().trim_end_matches(['\n', '\r']);
        start..start + inside.len()
    }

    /// The line of a byte.
    pub(crate) fn line_of(&self, at: usize) -> usize {
        self.starts.partition_point(|start| *start <= at).saturating_sub(1)
    }

    /// The position of a byte; one inside of a character counts as its beginning.
    pub(crate) fn position(&self, text: &str, at: usize) -> Position {
        let mut at = at.min(text.len());
        while !text.is_char_boundary(at) {
            at -= 1;
        }
        let line = self.line_of(at);
        let start = self.starts.get(line).copied().unwrap_or(0);
        let before = text.get(start..at).unwrap_or_default();
        Position { line, character: before.chars().map(char::len_utf16).sum() }
    }

    /// The byte at a position. Behind the end of a line there is its end, as the protocol has it, and
    /// within a character its beginning.
    pub(crate) fn byte(&self, text: &str, position: Position) -> usize {
        let line = self.line(text, position.line);
        let mut units = 0;
        for (at, c) in text.get(line.clone()).unwrap_or_default().char_indices() {
            units += c.len_utf16();
            if units > position.character {
                return line.start + at;
            }
        }
        line.end
    }

    /// A range of bytes as the protocol has it.
    pub(crate) fn range(&self, text: &str, range: &Range<usize>) -> Value {
        let (start, end) = (self.position(text, range.start), self.position(text, range.end));
        json!({ "start": start.json(), "end": end.json() })
    }
}

/// A range of the protocol as bytes; `None` if it is none.
pub(crate) fn bytes(text: &str, lines: &Lines, range: &Value) -> Option<Range<usize>> {
    let start = Position::of(range.get("start")?)?;
    let end = Position::of(range.get("end")?)?;
    (start <= end).then(|| lines.byte(text, start)..lines.byte(text, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_character_has_a_position_and_comes_back_from_it() {
        let text = "a\r\nμ𝛂x\r\r\n\n𝒙\nend";
        let lines = Lines::of(text);
        for (at, c) in text.char_indices() {
            if c == '\n' && at > 0 && text.as_bytes()[at - 1] == b'\r' {
                continue; // within the end of a line
            }
            assert_eq!(lines.byte(text, lines.position(text, at)), at, "{at} {c:?}");
        }
        assert_eq!(lines.position(text, text.find('x').expect("it is there")).character, 3);
        assert_eq!(lines.position(text, text.len()), Position { line: 5, character: 3 });
    }

    #[test]
    fn lines_are_counted_as_a_second_way_counts_them() {
        for text in ["", "\n", "\r", "\r\n", "a\rb\nc\r\nd", "\r\r\n\n\r", "x\u{2028}y\n"] {
            let plain = text.replace("\r\n", "\n").replace('\r', "\n");
            let lines = Lines::of(text);
            assert_eq!(lines.starts.len(), plain.split('\n').count(), "{text:?}");
            for (number, line) in plain.split('\n').enumerate() {
                assert_eq!(&text[lines.line(text, number)], line, "{text:?}");
            }
        }
    }

    #[test]
    fn a_place_outside_of_the_text_is_its_nearest_end() {
        let text = "𝛂b\nc";
        let lines = Lines::of(text);
        let byte = |line, character| lines.byte(text, Position { line, character });
        assert_eq!((byte(0, 1), byte(0, 2), byte(0, 99)), (0, 4, 5));
        assert_eq!((byte(1, 9), byte(7, 0), byte(usize::MAX, usize::MAX)), (7, 7, 7));
        let back =
            json!({"start": {"line": 1, "character": 0}, "end": {"line": 0, "character": 0}});
        assert_eq!(bytes(text, &lines, &back), None);
    }
}
