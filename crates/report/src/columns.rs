//! A table that is broken into blocks where the page is narrow.

use unicode_width::UnicodeWidthStr as _;

use crate::shorten::{padded, shorten};

/// A column of text.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    head: String,
    cells: Vec<String>,
    /// numbers stand to the right
    right: bool,
    /// takes what is left of the line, at least this much, and is cut there
    rest: Option<usize>,
}

impl Column {
    pub(crate) fn left(head: impl Into<String>, cells: Vec<String>) -> Self {
        Self { head: head.into(), cells, right: false, rest: None }
    }

    pub(crate) fn right(head: impl Into<String>, cells: Vec<String>) -> Self {
        Self { head: head.into(), cells, right: true, rest: None }
    }

    /// A column for words, which may be cut to `least` columns.
    pub(crate) fn words(head: impl Into<String>, cells: Vec<String>, least: usize) -> Self {
        Self { head: head.into(), cells, right: false, rest: Some(least) }
    }

    fn width(&self) -> usize {
        let cells = self.cells.iter().map(|cell| cell.width());
        cells.max().unwrap_or(0).max(self.head.width())
    }

    fn least(&self) -> usize {
        self.rest.map_or(self.width(), |least| self.width().min(least))
    }

    fn cell(&self, text: &str, width: usize) -> String {
        let text = shorten(text, width);
        if self.right {
            let blanks = width.saturating_sub(text.width());
            format!("{:blanks$}{text}", "")
        } else {
            padded(&text, width)
        }
    }
}

/// The lines of the table, in blocks of columns that fit into `width` and begin with the first
/// column. Words are cut there only if `cut`.
pub(crate) fn lines(columns: &[Column], width: usize, cut: bool) -> Vec<Vec<String>> {
    let Some((name, others)) = columns.split_first() else { return Vec::new() };
    let gap = 2;
    let mut blocks: Vec<Vec<&Column>> = Vec::new();
    let mut left = 0;
    for column in others {
        let needed = gap + column.least();
        match blocks.last_mut() {
            Some(block) if needed <= left => {
                block.push(column);
                left -= needed;
            }
            _ => {
                left = width.saturating_sub(name.width() + needed);
                blocks.push(vec![column]);
            }
        }
    }
    blocks
        .iter()
        .map(|block| block_lines(name, block, if cut { width } else { usize::MAX }))
        .collect()
}

fn block_lines(name: &Column, block: &[&Column], width: usize) -> Vec<String> {
    let fixed: usize = block.iter().filter(|c| c.rest.is_none()).map(|c| 2 + c.width()).sum();
    let spare = width.saturating_sub(name.width() + fixed + 2);
    let widths: Vec<usize> = block
        .iter()
        .map(|column| match column.rest {
            Some(least) => column.width().min(spare.max(least)),
            None => column.width(),
        })
        .collect();
    let line = |pick: &dyn Fn(&Column) -> String| {
        let mut line = padded(&pick(name), name.width());
        for (column, width) in block.iter().zip(&widths) {
            line.push_str("  ");
            line.push_str(&column.cell(&pick(column), *width));
        }
        line.trim_end().to_owned()
    };
    let mut lines = vec![line(&|column| column.head.clone())];
    for row in 0..name.cells.len() {
        lines.push(line(&|column| column.cells.get(row).cloned().unwrap_or_default()));
    }
    lines
}

/// Words broken into lines of `width`, after `head` and under it.
pub(crate) fn wrapped(head: &str, text: &str, width: usize) -> Vec<String> {
    let indent = head.width();
    let mut lines = vec![head.to_owned()];
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        let Some(line) = lines.last_mut() else { break };
        let bare = line.width() <= indent;
        if !bare && line.width() + 1 + word.width() > width {
            lines.push(format!("{:indent$}{word}", ""));
        } else {
            if !bare {
                line.push(' ');
            }
            line.push_str(word);
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(texts: &[&str]) -> Vec<String> {
        texts.iter().map(|&text| text.to_owned()).collect()
    }

    #[test]
    fn columns_that_do_not_fit_go_below() {
        let columns = [
            Column::left("law", cells(&["one", "two"])),
            Column::right("k", cells(&["-0.5", "1"])),
            Column::right("v", cells(&["2", "3"])),
        ];
        assert_eq!(lines(&columns, 20, true), [["law     k  v", "one  -0.5  2", "two     1  3"]]);
        assert_eq!(
            lines(&columns, 10, true),
            [["law     k", "one  -0.5", "two     1"], ["law  v", "one  2", "two  3"]]
        );
    }

    #[test]
    fn words_take_what_is_left() {
        let columns = [
            Column::left("law", cells(&["one"])),
            Column::words("regime", cells(&["sliding all the time"]), 6),
        ];
        assert_eq!(lines(&columns, 15, true), [["law  regime", "one  sliding a…"]]);
        assert_eq!(lines(&columns, 15, false), [["law  regime", "one  sliding all the time"]]);
    }

    #[test]
    fn long_words_are_not_torn() {
        assert_eq!(wrapped("a ", "bb cc dd", 7), ["a bb cc", "  dd"]);
        assert_eq!(wrapped("a ", "bbbbbbbbbb c", 5), ["a bbbbbbbbbb", "  c"]);
    }
}
