//! A table as text: columns side by side, in blocks where the page is narrow.

use anstyle::{AnsiColor, Style};
use unicode_width::UnicodeWidthStr as _;

use super::table::{Column, Fit, Row, Table};
use super::words::{Tone, Words};
use crate::shorten::shorten;

/// Between columns.
const GAP: usize = 2;

/// The page that text is set on.
#[derive(Clone, Copy, Debug)]
pub(super) struct Measure {
    pub(super) width: usize,
    /// whether long words are cut at the end of the line, instead of going on below
    pub(super) cut: bool,
    pub(super) colour: bool,
}

impl Measure {
    pub(super) fn ink(self, tone: Tone) -> Style {
        let colour = |colour: AnsiColor| Style::new().fg_color(Some(colour.into()));
        match tone {
            _ if !self.colour => Style::new(),
            Tone::Plain => Style::new(),
            Tone::Good => colour(AnsiColor::Green),
            Tone::Doubtful => colour(AnsiColor::Yellow),
            Tone::Bad => colour(AnsiColor::Red),
            Tone::Quiet => Style::new().dimmed(),
        }
    }
}

/// The text, filled with blanks up to `columns`.
pub(crate) fn padded(text: &str, columns: usize) -> String {
    let blanks = columns.saturating_sub(text.width());
    format!("{text}{:blanks$}", "")
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

/// The lines of a table, in blocks of columns that fit on the page and begin with the first column.
pub(super) fn blocks(table: &Table, measure: Measure) -> Vec<Vec<String>> {
    let rows: Vec<&Row> = table.rows.iter().filter(|row| !row.is_detail).collect();
    let columns = table.columns.iter().enumerate().filter(|(_, column)| !column.is_detail);
    let all: Vec<Set<'_>> = columns.map(|column| Set::of(column, &rows)).collect();
    let Some((name, others)) = all.split_first() else { return Vec::new() };
    let mut blocks: Vec<Vec<&Set<'_>>> = Vec::new();
    let mut left = 0;
    for column in others {
        let needed = GAP + column.least();
        match blocks.last_mut() {
            Some(block) if needed <= left => {
                block.push(column);
                left -= needed;
            }
            _ => {
                left = measure.width.saturating_sub(name.width + needed);
                blocks.push(vec![name, column]);
            }
        }
    }
    if blocks.is_empty() {
        blocks.push(vec![name]);
    }
    blocks.iter().map(|block| lines(block, &rows, measure)).collect()
}

/// A column with the width of its widest cell.
struct Set<'a> {
    index: usize,
    column: &'a Column,
    width: usize,
}

impl<'a> Set<'a> {
    fn of((index, column): (usize, &'a Column), rows: &[&Row]) -> Self {
        let cells = rows.iter().filter_map(|row| row.cells.get(index));
        let widest = cells.map(|cell| cell.plain().width()).max().unwrap_or(0);
        Self { index, column, width: widest.max(column.head().width()) }
    }

    fn least(&self) -> usize {
        match self.column.fit {
            Fit::Long(least) => self.width.min(least),
            Fit::Left | Fit::Right => self.width,
        }
    }
}

fn lines(block: &[&Set<'_>], rows: &[&Row], measure: Measure) -> Vec<String> {
    let least: usize = block.iter().map(|set| set.least() + GAP).sum::<usize>() - GAP;
    // what is left goes to the first long columns
    let mut spare = measure.width.saturating_sub(least);
    let widths: Vec<usize> = block
        .iter()
        .map(|set| {
            let more = spare.min(set.width - set.least());
            spare -= more;
            set.least() + more
        })
        .collect();
    let empty = Words::default();
    let mut out = Vec::new();
    let heads: Vec<String> = block.iter().map(|set| set.column.head()).collect();
    if heads.iter().any(|head| !head.is_empty()) {
        let mut head = String::new();
        for ((set, width), text) in block.iter().zip(&widths).zip(&heads) {
            head.push_str(&aligned(set.column.fit, text, *width));
            head.push_str("  ");
        }
        out.push(head.trim_end().to_owned());
    }
    for row in rows {
        let cells: Vec<&Words> =
            block.iter().map(|set| row.cells.get(set.index).unwrap_or(&empty)).collect();
        let parts: Vec<Vec<String>> = cells
            .iter()
            .zip(&widths)
            .map(|(cell, width)| {
                let text = cell.plain();
                let is_cut = measure.cut || text.width() <= *width;
                if is_cut { vec![shorten(&text, *width)] } else { wrapped("", &text, *width) }
            })
            .collect();
        let height = parts.iter().map(Vec::len).max().unwrap_or(0);
        let line_ink = measure.ink(row.tone);
        for line in 0..height {
            let mut text = String::new();
            // blanks are written once something follows them
            let mut blanks = 0;
            for (((set, cell), part), width) in block.iter().zip(&cells).zip(&parts).zip(&widths) {
                let own = part.get(line).map_or("", String::as_str);
                let own = aligned(set.column.fit, own, *width);
                let bare = own.trim_end();
                if !bare.is_empty() {
                    let ink = measure.ink(cell.tone);
                    text.push_str(&format!("{:blanks$}{ink}{bare}{ink:#}", ""));
                    blanks = 0;
                }
                blanks += own.width() - bare.width() + GAP;
            }
            out.push(format!("{line_ink}{text}{line_ink:#}"));
        }
    }
    out
}

fn aligned(fit: Fit, text: &str, width: usize) -> String {
    match fit {
        Fit::Right => format!("{:blanks$}{text}", "", blanks = width.saturating_sub(text.width())),
        Fit::Left | Fit::Long(_) => padded(text, width),
    }
}

#[cfg(test)]
mod tests {
    use super::super::row;
    use super::*;

    fn measure(width: usize, cut: bool) -> Measure {
        Measure { width, cut, colour: false }
    }

    #[test]
    fn columns_that_do_not_fit_go_below() {
        let columns = vec![Column::left("law"), Column::right("k"), Column::right("v")];
        let rows = vec![row!["one", "-0.5", "2"], row!["two", "1", "3"]];
        let table = Table::new(columns, rows);
        let whole = [["law     k  v", "one  -0.5  2", "two     1  3"]];
        assert_eq!(blocks(&table, measure(20, true)), whole);
        let parts = [["law     k", "one  -0.5", "two     1"], ["law  v", "one  2", "two  3"]];
        assert_eq!(blocks(&table, measure(10, true)), parts);
    }

    #[test]
    fn long_words_take_what_is_left_and_then_go_on_below_or_are_cut() {
        let columns = vec![Column::left("law"), Column::long("regime", 6)];
        let table = Table::new(columns, vec![row!["one", "sliding all the time"]]);
        assert_eq!(blocks(&table, measure(15, true)), [["law  regime", "one  sliding a…"]]);
        let below = [["law  regime", "one  sliding", "     all the", "     time"]];
        assert_eq!(blocks(&table, measure(15, false)), below);
    }

    #[test]
    fn a_colour_ends_with_its_cell_and_a_detail_is_left_out() {
        let columns = vec![Column::left("law"), Column::left("C1")];
        let no = Words::from("no").toned(Tone::Bad);
        let rows = vec![row!["one", no], row!["two", "yes"].detail(true)];
        let measure = Measure { width: 20, cut: true, colour: true };
        let shown = blocks(&Table::new(columns, rows), measure);
        assert_eq!(shown, [["law  C1", "one  \u{1b}[31mno\u{1b}[0m"]]);
    }

    #[test]
    fn long_words_are_not_torn() {
        assert_eq!(wrapped("a ", "bb cc dd", 7), ["a bb cc", "  dd"]);
        assert_eq!(wrapped("a ", "bbbbbbbbbb c", 5), ["a bbbbbbbbbb", "  c"]);
        assert_eq!(padded("μ", 3), "μ  ", "blanks count columns, not bytes");
    }
}
