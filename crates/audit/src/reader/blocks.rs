//! Where the statements of a Markdown document are.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};

use kane_algebra::syntax::visible;

use super::statement::KEYWORDS;
use super::{Fault, MAX_FAULTS, MAX_STATEMENTS};

/// The statements of a document, not yet parsed.
pub(super) struct Blocks {
    /// the text with all but the code of the blocks replaced by blanks, byte for byte, so that
    /// places in it are places in the text
    pub(super) code: String,
    /// where each statement stands
    pub(super) statements: Vec<Range<usize>>,
    /// the blocks, with their fences
    pub(super) ranges: Vec<Range<usize>>,
    /// the first level-one heading
    pub(super) title: Option<String>,
    /// what is wrong with the blocks themselves
    pub(super) faults: Vec<Fault>,
}

/// Finds the blocks tagged `kane` and divides them into statements.
pub(super) fn find(text: &str) -> Blocks {
    let mut faults = Vec::new();
    let mut title: Option<String> = None;
    let mut in_title = false;
    let mut in_block = false;
    let mut pieces = Vec::new();
    let mut code: Vec<u8> =
        text.bytes().map(|byte| if byte == b'\n' { b'\n' } else { b' ' }).collect();
    let mut statements = Vec::new();
    let mut ranges = Vec::new();
    for (event, range) in Parser::new_ext(text, Options::empty()).into_offset_iter() {
        match event {
            Event::Start(Tag::Heading { level: HeadingLevel::H1, .. }) if title.is_none() => {
                in_title = true;
                title = Some(String::new());
            }
            Event::End(TagEnd::Heading(_)) => in_title = false,
            Event::Text(part) | Event::Code(part) if in_title => {
                title.get_or_insert_default().push_str(&part);
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                let tag = info.split([' ', '\t', ',']).next().unwrap_or_default();
                in_block = tag == "kane";
                faults.extend(nearly_tagged(text, tag, &range));
            }
            Event::Text(_) if in_block => pieces.push(range),
            Event::End(TagEnd::CodeBlock) if in_block => {
                in_block = false;
                for piece in &pieces {
                    unmask(&mut code, text, piece);
                }
                ranges.push(range.clone());
                let block = Block { text, range, lines: lines(text, &pieces) };
                block.divide(&mut statements, &mut faults);
                pieces.clear();
            }
            _ => {}
        }
    }
    Blocks {
        code: String::from_utf8(code).expect("whole characters are blanked or copied"),
        statements,
        ranges,
        title: title.filter(|title| !title.trim().is_empty()),
        faults,
    }
}

/// A tag that is nearly the one of statements: a block that is passed over must not read as one that was judged.
fn nearly_tagged(text: &str, tag: &str, block: &Range<usize>) -> Option<Fault> {
    let bare = tag.trim_matches(|c: char| !c.is_alphanumeric());
    if tag == "kane" || !bare.eq_ignore_ascii_case("kane") {
        return None;
    }
    let fence = text.get(block.clone()).and_then(|block| block.lines().next()).unwrap_or_default();
    let message = format!("a block tagged `{}` would be passed over", visible(tag));
    let span = block.start..block.start + fence.len();
    Some(Fault::new(span, message).with_note("the tag of statements is `kane`, in small letters"))
}

fn unmask(code: &mut [u8], text: &str, piece: &Range<usize>) {
    let source = text.as_bytes().get(piece.clone()).unwrap_or_default();
    if let Some(target) = code.get_mut(piece.clone()) {
        target.copy_from_slice(source);
    }
}

/// The lines of a block, as its container shows them, without their ends.
fn lines(text: &str, pieces: &[Range<usize>]) -> Vec<Range<usize>> {
    let mut lines: Vec<Range<usize>> = Vec::new();
    let mut open = false;
    for piece in pieces {
        let mut start = piece.start;
        for part in text.get(piece.clone()).unwrap_or_default().split_inclusive('\n') {
            let end = start + part.len();
            match lines.last_mut() {
                Some(line) if open => line.end = end,
                _ => lines.push(start..end),
            }
            open = !part.ends_with('\n');
            start = end;
        }
    }
    lines
}

struct Block<'a> {
    text: &'a str,
    /// fences included
    range: Range<usize>,
    lines: Vec<Range<usize>>,
}

impl Block<'_> {
    fn line(&self, line: &Range<usize>) -> &str {
        self.text.get(line.clone()).unwrap_or_default()
    }

    /// Adds the statements of the block.
    fn divide(&self, statements: &mut Vec<Range<usize>>, faults: &mut Vec<Fault>) {
        let closed = self.is_closed(faults);
        let first = statements.len();
        for line in &self.lines {
            // either is reported as too many, so what follows does not count
            if statements.len() > MAX_STATEMENTS || faults.len() > MAX_FAULTS {
                return;
            }
            let content = self.line(line);
            let bare = content.trim();
            if bare.is_empty() || bare.starts_with('#') {
                continue;
            }
            let end = line.start + content.trim_end().len();
            if content.starts_with([' ', '\t']) {
                let blank = content.len() - content.trim_start().len();
                match statements.get_mut(first..).and_then(<[_]>::last_mut) {
                    Some(statement) => statement.end = end,
                    None if closed => faults.push(
                        Fault::new(
                            line.start + blank..end,
                            "an indented line continues a statement, and there is none".to_owned(),
                        )
                        .with_note("statements begin at the margin of their block"),
                    ),
                    None => {}
                }
                continue;
            }
            let word = bare.split(|c: char| !c.is_alphanumeric()).next();
            // what follows an unclosed block is prose and would only give a flood of faults
            if closed || word.is_some_and(|word| KEYWORDS.contains(&word)) {
                statements.push(line.start..end);
            }
        }
    }

    /// Whether the block ends with its own closing fence; otherwise notes the fault.
    fn is_closed(&self, faults: &mut Vec<Fault>) -> bool {
        let source = self.text.get(self.range.clone()).unwrap_or_default();
        let mark = if source.starts_with('~') { '~' } else { '`' };
        let fence_length = |line: &str| line.chars().take_while(|c| *c == mark).count();
        let length = fence_length(source);
        let opening =
            self.range.start..self.range.start + source.lines().next().map_or(0, str::len);
        let inner = self.lines.iter().find(|line| fence_length(self.line(line).trim_start()) >= 3);
        let message = "unbalanced block: its fence is never closed".to_owned();
        if let Some(inner) = inner {
            let line = 1 + self.text.get(..inner.start).map_or(0, |s| s.matches('\n').count());
            faults.push(
                Fault::new(opening, message)
                    .with_note(format!("another fence opens inside it, on line {line}")),
            );
            return false;
        }
        let last = source.trim_end_matches(['\n', '\r']).rsplit('\n').next();
        let last = last.unwrap_or_default().trim_start_matches([' ', '\t', '>']).trim_end();
        let closed = source.contains('\n')
            && fence_length(last) >= length
            && last.chars().all(|c| c == mark);
        if !closed {
            faults.push(Fault::new(opening, message));
        }
        closed
    }
}
