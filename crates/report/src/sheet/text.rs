//! A sheet for a terminal or a text file.

use std::fmt::Write as _;

use anstyle::Style;
use unicode_width::UnicodeWidthStr as _;

use super::columns::{Measure, blocks, padded, wrapped};
use super::{Block, Entry, Sheet};
use crate::shorten::shorten;

/// The page to write on.
#[derive(Clone, Copy, Debug, Default)]
pub struct Page {
    /// its columns; `None` lets reasons run on, as in a file
    pub width: Option<usize>,
    /// whether it shows colours
    pub colour: bool,
}

impl Sheet<'_> {
    /// The sheet as text. On a page with a width, long words in tables are cut; in a file they go on below.
    #[must_use]
    pub fn text(&self, page: Page) -> String {
        let measure = Measure {
            width: page.width.unwrap_or(self.columns),
            cut: page.width.is_some(),
            colour: page.colour,
        };
        // lines of prose longer than that are hard to read
        let prose = measure.width.min(page.width.unwrap_or(super::COLUMNS));
        let bold = if page.colour { Style::new().bold() } else { Style::new() };
        let mut out = String::new();
        let _ = writeln!(out, "{}", self.title);
        if !self.headline.is_empty() {
            for line in wrapped("", &self.headline, prose) {
                let _ = writeln!(out, "{bold}{line}{bold:#}");
            }
        }
        // a heading stands close to what it heads, a paragraph to the paragraph above
        let mut headed = false;
        for block in &self.blocks {
            let lines = match block {
                Block::Heading { words, .. } => {
                    vec![format!("{bold}{}{bold:#}", shorten(&words.plain(), measure.width))]
                }
                Block::Prose(words) => wrapped("", &words.plain(), prose),
                Block::Labelled(entries) => labelled(entries, Measure { width: prose, ..measure }),
                Block::Table(table) if table.rows.iter().all(|row| row.is_detail) => continue,
                Block::Table(table) => {
                    let mut lines = blocks(table, measure).join(&String::new());
                    let more = table.rows.iter().filter(|row| row.is_detail).count();
                    if let Some(counted) = table.counted.filter(|_| more > 0) {
                        lines.push(format!("… and {more} more {counted}"));
                    }
                    lines
                }
                Block::Figure(_) => continue,
            };
            if !headed {
                out.push('\n');
            }
            headed = matches!(block, Block::Heading { .. });
            for line in lines {
                out.push_str(&line);
                out.push('\n');
            }
        }
        out.push('\n');
        if let Some(machine) = &self.machine {
            let _ = writeln!(out, "{machine}");
        }
        let _ = writeln!(out, "{}: {}", Self::program(), self.command);
        out.replace('\u{a0}', " ")
    }
}

/// Lines beside their labels, which stand in one column.
fn labelled(entries: &[Entry], measure: Measure) -> Vec<String> {
    let widest = entries.iter().map(|entry| entry.label.width()).max().unwrap_or(0);
    let margin = if widest == 0 { 2 } else { widest + 2 };
    let mut lines = Vec::new();
    for Entry { label, words } in entries {
        let ink = measure.ink(words.tone);
        let set = wrapped(&padded(label, margin), &words.plain(), measure.width);
        lines.extend(set.iter().map(|line| format!("{ink}{line}{ink:#}")));
    }
    lines
}
