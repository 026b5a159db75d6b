//! A sheet for print, as LaTeX.

use std::fmt::Write as _;

use unicode_width::UnicodeWidthStr as _;

use super::table::{Fit, Table};
use super::{Block, Entry, Sheet};
use crate::tex::escape;

/// Tables may be longer than a page, and are set small; nothing is hyphenated.
const PREAMBLE: &str = r"\documentclass[10pt]{article}
\usepackage[utf8]{inputenc}
\usepackage{amsmath,amssymb,longtable,array}
\usepackage[a4paper,landscape,margin=18mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.5\baselineskip plus 2pt}
\setlength{\tabcolsep}{4pt}
\setlength{\LTleft}{0pt}
\raggedright
\begin{document}
";

/// Millimetres that a page has, tenths of one that a letter of a table takes, and millimetres between two columns.
const PAGE: usize = 261;
const LETTER: usize = 17;
const BETWEEN: usize = 3;
/// Millimetres that the long columns of a table share, at most and at least.
const LONG: usize = 110;
const SHORT: usize = 40;

impl Sheet<'_> {
    /// The sheet as a document for LaTeX, without its figures.
    #[must_use]
    pub fn latex(&self) -> String {
        let mut out = PREAMBLE.to_owned();
        let title = escape(&self.title);
        let _ = writeln!(out, "{{\\Large\\bfseries {}: {title}\\par}}\n", self.kind);
        if !self.headline.is_empty() {
            let _ = writeln!(out, "{}.\n", escape(&self.headline));
        }
        for block in &self.blocks {
            let _ = match block {
                Block::Heading { words, .. } => writeln!(out, "\\section*{{{}}}\n", words.latex()),
                Block::Prose(words) => writeln!(out, "{}\n", words.latex()),
                Block::Labelled(entries) => writeln!(out, "{}", labelled(entries)),
                Block::Table(table) => writeln!(out, "{}", rows(table)),
                Block::Figure(_) => Ok(()),
            };
        }
        let command = escape(&self.command);
        let program = Self::program();
        let _ = write!(
            out,
            "\\bigskip\\hrule\\medskip\n\\footnotesize {program}: \\texttt{{{command}}}"
        );
        if let Some(machine) = &self.machine {
            let _ = write!(out, "\\\\\n{}", escape(machine));
        }
        out.push_str("\n\\end{document}\n");
        out
    }
}

fn labelled(entries: &[Entry]) -> String {
    let mut out = String::new();
    for Entry { label, words } in entries {
        let _ = writeln!(
            out,
            "\\hangindent=8em\\makebox[8em][l]{{{}}}{}\\par",
            escape(label),
            words.latex()
        );
    }
    out
}

fn rows(table: &Table) -> String {
    let long = table.columns.iter().filter(|c| matches!(c.fit, Fit::Long(_))).count().max(1);
    // what the other columns leave; where that is little, letters are smaller
    let widest = |i: usize| {
        let cells = table.rows.iter().filter_map(|row| row.cells.get(i)).map(|c| c.plain().width());
        cells.max().unwrap_or(0)
    };
    let others = table.columns.iter().enumerate().filter(|(_, c)| !matches!(c.fit, Fit::Long(_)));
    let others: usize = others.map(|(i, c)| widest(i).max(c.head().width()) * LETTER / 10).sum();
    let left = PAGE.saturating_sub(others + BETWEEN * table.columns.len());
    let size = if left < SHORT { "scriptsize" } else { "footnotesize" };
    let share = left.clamp(SHORT, LONG);
    let place = |fit: Fit| match fit {
        Fit::Left => "l".to_owned(),
        Fit::Right => "r".to_owned(),
        Fit::Long(_) => format!(">{{\\raggedright\\arraybackslash}}p{{{}mm}}", share / long),
    };
    let places: String = table.columns.iter().map(|column| place(column.fit)).collect();
    let heads: Vec<String> = table.columns.iter().map(|column| escape(&column.head())).collect();
    let mut out = format!("{{\\{size}\\begin{{longtable}}{{{places}}}\n");
    let _ = writeln!(out, "{} \\\\ \\hline \\endhead", heads.join(" & "));
    for row in table.rows.iter().take(table.most) {
        let cells: Vec<String> = row.cells.iter().map(super::Words::latex).collect();
        // so that a bracket in the next row is no argument
        let _ = writeln!(out, "{} \\\\[0pt]", cells.join(" & "));
    }
    out.push_str("\\end{longtable}}\n");
    out
}
