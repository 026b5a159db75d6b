//! A table: columns with units and alignment, and rows.

use super::words::{Tone, Words};

/// A table.
pub(crate) struct Table {
    pub(crate) columns: Vec<Column>,
    pub(crate) rows: Vec<Row>,
    /// rows that a page shows; Markdown shows all
    pub(crate) most: usize,
    /// what the rows are, where text says how many more there are
    pub(crate) counted: Option<&'static str>,
}

/// A column.
#[derive(Clone, Debug)]
pub(crate) struct Column {
    head: String,
    /// of all its numbers; empty for none
    unit: &'static str,
    pub(crate) fit: Fit,
    /// what text leaves out, because it would not fit beside the rest
    pub(crate) is_detail: bool,
}

/// How a column takes its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fit {
    /// short names or words
    Left,
    /// numbers
    Right,
    /// long words, at least so many characters wide; longer ones go on below, or are cut
    Long(usize),
}

/// A row, a cell a column.
#[derive(Clone, Debug)]
pub(crate) struct Row {
    pub(crate) cells: Vec<Words>,
    pub(crate) tone: Tone,
    /// what text leaves out, because nobody looks for it first
    pub(crate) is_detail: bool,
}

impl Table {
    pub(crate) fn new(columns: Vec<Column>, rows: Vec<Row>) -> Self {
        Self { columns, rows, most: usize::MAX, counted: None }
    }

    /// The columns whose cells are not all empty: where nothing was measured, nothing is headed.
    pub(crate) fn without_empty_columns(mut self) -> Self {
        let is_used: Vec<bool> = (0..self.columns.len())
            .map(|i| self.rows.iter().any(|row| row.cells.get(i).is_some_and(|c| !c.is_empty())))
            .collect();
        let mut used = is_used.iter();
        self.columns.retain(|_| used.next() == Some(&true));
        for row in &mut self.rows {
            let mut used = is_used.iter();
            row.cells.retain(|_| used.next() == Some(&true));
        }
        self
    }
}

impl Column {
    pub(crate) fn left(head: impl Into<String>) -> Self {
        Self { head: head.into(), unit: "", fit: Fit::Left, is_detail: false }
    }

    pub(crate) fn right(head: impl Into<String>) -> Self {
        Self { head: head.into(), unit: "", fit: Fit::Right, is_detail: false }
    }

    /// A column of long words.
    pub(crate) fn long(head: impl Into<String>, least: usize) -> Self {
        Self { head: head.into(), unit: "", fit: Fit::Long(least), is_detail: false }
    }

    pub(crate) fn unit(mut self, unit: &'static str) -> Self {
        self.unit = unit;
        self
    }

    /// The same, left out of text.
    pub(crate) fn detail(mut self) -> Self {
        self.is_detail = true;
        self
    }

    /// Name and unit: `normal, J`.
    pub(crate) fn head(&self) -> String {
        match (self.head.as_str(), self.unit) {
            (head, "") => head.to_owned(),
            ("", unit) => unit.to_owned(),
            (head, unit) => format!("{head}, {unit}"),
        }
    }
}

impl Row {
    pub(crate) fn new(cells: Vec<Words>) -> Self {
        Self { cells, tone: Tone::Plain, is_detail: false }
    }

    pub(crate) fn toned(mut self, tone: Tone) -> Self {
        self.tone = tone;
        self
    }

    pub(crate) fn detail(mut self, is_detail: bool) -> Self {
        self.is_detail = is_detail;
        self
    }
}

/// A row of anything that is words.
macro_rules! row {
    ($($cell:expr),+ $(,)?) => {
        $crate::sheet::Row::new(vec![$($crate::sheet::Words::from($cell)),+])
    };
}
pub(crate) use row;
