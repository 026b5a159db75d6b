//! A sheet for the web, as Markdown.

use std::fmt::Write as _;

use super::table::{Fit, Table};
use super::{Block, Entry, Sheet};
use crate::markdown::{code, escape};

impl Sheet<'_> {
    /// The sheet as Markdown, with tables as GitHub reads them.
    #[must_use]
    pub fn markdown(&self) -> String {
        let mut out = format!("# {}: {}\n", self.kind, escape(&self.title));
        if !self.headline.is_empty() {
            let _ = writeln!(out, "\n**{}**", escape(&self.headline));
        }
        for block in &self.blocks {
            out.push('\n');
            match block {
                Block::Heading { words, .. } => _ = writeln!(out, "## {}", words.markdown()),
                Block::Prose(words) => _ = writeln!(out, "{}", words.markdown()),
                Block::Labelled(entries) => labelled(&mut out, entries),
                Block::Table(table) => rows(&mut out, table),
                Block::Figure(_) => out.truncate(out.len() - 1),
            }
        }
        if let Some(machine) = &self.machine {
            let _ = writeln!(out, "\n{}", escape(machine));
        }
        let _ = writeln!(out, "\n{}: {}", Self::program(), code(&self.command));
        out
    }
}

fn labelled(out: &mut String, entries: &[Entry]) {
    for (index, Entry { label, words }) in entries.iter().enumerate() {
        let words = words.markdown();
        let _ = match (*label, index) {
            ("", 1..) if !entries[0].label.is_empty() => writeln!(out, "  {words}"),
            ("", _) => writeln!(out, "- {words}"),
            (label, _) => writeln!(out, "- {label}: {words}"),
        };
    }
}

fn rows(out: &mut String, table: &Table) {
    let line = |out: &mut String, cells: Vec<String>| {
        let _ = writeln!(out, "| {} |", cells.join(" | "));
    };
    line(out, table.columns.iter().map(|column| escape(&column.head())).collect());
    let rules = table.columns.iter().map(|column| match column.fit {
        Fit::Right => "---:|",
        Fit::Left | Fit::Long(_) => "---|",
    });
    let _ = writeln!(out, "|{}", rules.collect::<String>());
    for row in &table.rows {
        line(out, row.cells.iter().map(super::Words::markdown).collect());
    }
}
