//! Cases and matrices.

use crate::formula::{Reader, strip};
use crate::part::Part;
use crate::relation::conjunction;
use crate::token::Token;
use crate::unreadable::Unreadable;

impl<'a> Reader<'a> {
    fn rows(&mut self, name: &str) -> Result<Vec<Vec<&'a [Token]>>, Unreadable> {
        if name == "array" {
            self.group()?;
        }
        let (mut rows, mut cells, mut start, mut depth) = (Vec::new(), Vec::new(), self.at, 0usize);
        loop {
            let at = self.at;
            let cell = &self.tokens[start.min(at)..at.min(self.tokens.len())];
            match self.next() {
                None => return Err(Unreadable::Missing("the end of an environment")),
                Some(Token::Begin(_) | Token::Open) => depth += 1,
                Some(Token::End(_)) if depth == 0 => {
                    if !(cell.is_empty() && cells.is_empty()) {
                        cells.push(cell);
                        rows.push(cells);
                    }
                    return Ok(rows);
                }
                Some(Token::End(_) | Token::Close) => depth = depth.saturating_sub(1),
                Some(Token::Column) if depth == 0 => {
                    cells.push(cell);
                    start = self.at;
                }
                Some(Token::Row) if depth == 0 => {
                    cells.push(cell);
                    rows.push(std::mem::take(&mut cells));
                    start = self.at;
                }
                Some(_) => {}
            }
        }
    }

    pub(crate) fn cases(&mut self, name: &str) -> Result<Part, Unreadable> {
        let mut branches = Vec::new();
        let mut otherwise = None;
        for row in self.rows(name)? {
            let [value, condition @ ..] = row.as_slice() else { continue };
            let value = strip(value);
            let value = self.whole(value)?.number()?.text;
            let condition: Vec<Token> = condition.concat();
            let otherwise_words =
                |words: &str| matches!(words.trim().to_lowercase().as_str(), "otherwise" | "else");
            let is_last = match strip(&condition) {
                [] => true,
                [Token::Words(words)] => otherwise_words(words),
                _ => false,
            };
            if is_last {
                if otherwise.replace(value).is_some() {
                    return Err(Unreadable::Missing("a condition"));
                }
                continue;
            }
            // between conditions `and` is a comma; what stands in cases within them is theirs
            let (mut plain, mut depth): (Vec<Token>, usize) = (Vec::new(), 0);
            for token in condition {
                match &token {
                    Token::Begin(_) => depth += 1,
                    Token::End(_) => depth = depth.saturating_sub(1),
                    _ => {}
                }
                match token {
                    Token::Words(words) if depth == 0 => match words.trim() {
                        "and" => plain.push(Token::Char(',')),
                        "if" | "for" | "when" | "" => {}
                        _ => return Err(Unreadable::Words(words)),
                    },
                    Token::Quad if depth == 0 => {}
                    other => plain.push(other),
                }
            }
            let plain = match strip(&plain) {
                [Token::Char('('), inside @ .., Token::Char(')')] => inside.to_vec(),
                other => other.to_vec(),
            };
            let mut inner = Reader::new(&plain, self.names);
            inner.depth = self.depth;
            let guard = conjunction(&mut inner)?;
            branches.push(format!("{guard}: {value}"));
        }
        if branches.is_empty() {
            return Err(Unreadable::Missing("a condition"));
        }
        branches.extend(otherwise.map(|value| format!("else: {value}")));
        Ok(Part::atom(format!("cases {{ {} }}", branches.join("; "))))
    }

    pub(crate) fn matrix(&mut self, name: &str) -> Result<Part, Unreadable> {
        let mut rows = Vec::new();
        for row in self.rows(name)? {
            let cells: Result<Vec<String>, Unreadable> =
                row.iter().map(|cell| Ok(self.whole(cell)?.number()?.text)).collect();
            rows.push(cells?);
        }
        let text = if rows.iter().all(|row| row.len() == 1) {
            rows.concat().join(", ")
        } else {
            let rows: Vec<String> =
                rows.iter().map(|row| format!("[{}]", row.join(", "))).collect();
            rows.join(", ")
        };
        Ok(Part { vector: true, ..Part::atom(format!("[{text}]")) })
    }
}
