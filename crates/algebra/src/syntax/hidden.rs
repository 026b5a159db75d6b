//! Characters that are not seen, or that change how others are seen.

use std::borrow::Cow;
use std::fmt::Write as _;

/// Whether it is a control character that moves or hides what stands beside it: all but the tab and
/// the ends of lines.
#[must_use]
pub fn is_control(c: char) -> bool {
    c.is_control() && !matches!(c, '\t' | '\n' | '\r')
}

/// Whether it turns the order of what follows: embeddings, overrides and isolates.
fn reorders(c: char) -> bool {
    matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// Whether a reader cannot see that it is there: control characters, those that turn the order of
/// letters, those without width, and the two that end lines only for some programs.
#[must_use]
pub fn is_hidden(c: char) -> bool {
    is_control(c)
        || reorders(c)
        || matches!(
            c,
            '\u{ad}'
                | '\u{34f}'
                | '\u{61c}'
                | '\u{115f}'
                | '\u{1160}'
                | '\u{17b4}'
                | '\u{17b5}'
                | '\u{180b}'..='\u{180f}'
                | '\u{200b}'..='\u{200f}'
                | '\u{2028}'
                | '\u{2029}'
                | '\u{2060}'..='\u{2064}'
                | '\u{206a}'..='\u{206f}'
                | '\u{2800}'
                | '\u{3164}'
                | '\u{fe00}'..='\u{fe0f}'
                | '\u{feff}'
                | '\u{ffa0}'
                | '\u{fff9}'..='\u{fffb}'
                | '\u{1bca0}'..='\u{1bca3}'
                | '\u{1d173}'..='\u{1d17a}'
                | '\u{e0000}'..='\u{e0fff}'
        )
}

/// A short text, such as a title or a file's name, with its hidden characters written out: an
/// escape as `\u{1b}`.
#[must_use]
pub fn visible(text: &str) -> Cow<'_, str> {
    written_out(text, |c, _| is_hidden(c) || matches!(c, '\n' | '\r' | '\t'))
}

/// A whole page: what could reach beyond its own line is written out, and nothing else, since the
/// prose of some languages needs characters without width.
#[must_use]
pub fn printable(page: &str) -> Cow<'_, str> {
    let lone = |c: char, next: Option<char>| c == '\r' && next != Some('\n');
    written_out(page, |c, next| is_control(c) || reorders(c) || lone(c, next))
}

/// The text with some characters written out, each judged with the one that follows it.
fn written_out(text: &str, hidden: impl Fn(char, Option<char>) -> bool) -> Cow<'_, str> {
    let following = || text.chars().skip(1).map(Some).chain([None]);
    if !text.chars().zip(following()).any(|(c, next)| hidden(c, next)) {
        return Cow::Borrowed(text);
    }
    let mut out = String::with_capacity(text.len() + 16);
    for (c, next) in text.chars().zip(following()) {
        if hidden(c, next) {
            // a string takes every write
            let _ = write!(out, "\\u{{{:x}}}", u32::from(c));
        } else {
            out.push(c);
        }
    }
    Cow::Owned(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_not_seen_is_written_out() {
        assert_eq!(visible("a\u{1b}[2K\rb\u{9b}c\u{202e}d"), r"a\u{1b}[2K\u{d}b\u{9b}c\u{202e}d");
        assert_eq!(visible("μ·x ≤ é 漢"), "μ·x ≤ é 漢");
        let page = "a\r\n\tb\u{200d}c\u{8}\u{2066}\rd";
        assert_eq!(printable(page), "a\r\n\tb\u{200d}c\\u{8}\\u{2066}\\u{d}d");
    }

    #[test]
    fn every_control_character_is_hidden() {
        let controls = (0..=0x9f).filter_map(char::from_u32).filter(|c| c.is_control());
        for c in controls {
            assert_eq!(is_hidden(c), !matches!(c, '\t' | '\n' | '\r'), "{:x}", u32::from(c));
        }
    }
}
