//! A report as a sheet: title, headline, blocks, provenance.
//!
//! A report is a function from data to a [`Sheet`]. Text, Markdown, HTML and LaTeX are written here, once for all
//! reports; what a form cannot show, it leaves out, and it leaves out nothing else.

mod columns;
mod csv;
mod html;
mod latex;
mod markdown;
mod symbols;
mod table;
mod text;
mod words;

use crate::place::Place;
pub(crate) use columns::wrapped;
pub(crate) use csv::csv;
pub(crate) use table::{Column, Row, Table, row};
pub use text::Page;
pub(crate) use words::{Tone, Words};

/// A report, ready to be written in any form.
pub struct Sheet<'a> {
    /// what kind of report it is: a word
    pub(crate) kind: &'static str,
    /// what it is about
    pub(crate) title: String,
    /// the news in a sentence, without its full stop
    pub(crate) headline: String,
    pub(crate) blocks: Vec<Block<'a>>,
    /// a command that prints it again
    pub(crate) command: String,
    /// machine and compiler, where they matter
    pub(crate) machine: Option<String>,
    /// what is beside its page
    pub(crate) place: Place,
    /// columns of text where the page has no width of its own
    pub(crate) columns: usize,
}

/// A part of a sheet.
pub(crate) enum Block<'a> {
    /// a heading, which a page can link to
    Heading {
        id: String,
        words: Words,
    },
    /// a paragraph
    Prose(Words),
    /// lines under labels at the margin; without a label, a line belongs to the one above
    Labelled(Vec<Entry>),
    Table(Table),
    /// a drawing, which text, Markdown and LaTeX leave to its file
    Figure(Figure<'a>),
}

/// A line with its label.
pub(crate) struct Entry {
    pub(crate) label: &'static str,
    pub(crate) words: Words,
}

/// A drawing, made when a form shows it.
pub(crate) struct Figure<'a> {
    /// its place on a page, and the end of its file's name
    pub(crate) name: &'static str,
    pub(crate) heading: String,
    /// draws it as SVG
    pub(crate) draw: Box<dyn Fn() -> String + 'a>,
}

/// The columns of most sheets.
pub(crate) const COLUMNS: usize = 100;

impl<'a> Sheet<'a> {
    /// A sheet without blocks.
    pub(crate) fn new(
        kind: &'static str,
        title: impl Into<String>,
        headline: impl Into<String>,
        command: &str,
    ) -> Self {
        Self {
            kind,
            title: words::seen(title),
            headline: words::seen(headline),
            blocks: Vec::new(),
            command: words::seen(command),
            machine: None,
            place: Place::default(),
            columns: COLUMNS,
        }
    }

    /// The same sheet with links to what is beside its page.
    #[must_use]
    pub fn placed(self, place: Place) -> Self {
        Self { place, ..self }
    }

    /// The news in a sentence, without its full stop; it may be empty.
    #[must_use]
    pub fn headline(&self) -> &str {
        &self.headline
    }

    pub(crate) fn heading(&mut self, id: impl Into<String>, words: impl Into<Words>) {
        self.blocks.push(Block::Heading { id: id.into(), words: words.into() });
    }

    /// A paragraph, unless it is empty.
    pub(crate) fn prose(&mut self, words: impl Into<Words>) {
        let words = words.into();
        if !words.is_empty() {
            self.blocks.push(Block::Prose(words));
        }
    }

    /// Lines under labels, those that say something.
    pub(crate) fn labelled(&mut self, mut entries: Vec<Entry>) {
        entries.retain(|entry| !entry.words.is_empty());
        if !entries.is_empty() {
            self.blocks.push(Block::Labelled(entries));
        }
    }

    /// A table, unless it has no rows.
    pub(crate) fn table(&mut self, table: Table) {
        if !table.rows.is_empty() {
            self.blocks.push(Block::Table(table));
        }
    }

    pub(crate) fn figure(
        &mut self,
        name: &'static str,
        heading: impl Into<String>,
        draw: impl Fn() -> String + 'a,
    ) {
        self.blocks.push(Block::Figure(Figure {
            name,
            heading: heading.into(),
            draw: Box::new(draw),
        }));
    }

    /// The drawings, SVG, each with the end of its file's name.
    #[must_use]
    pub fn drawings(&self) -> Vec<(&'static str, String)> {
        let drawing = |block: &Block<'_>| match block {
            Block::Figure(figure) => Some((figure.name, (figure.draw)())),
            _ => None,
        };
        self.blocks.iter().filter_map(drawing).collect()
    }

    /// `kane 0.1.0`, the program that wrote the sheet.
    fn program() -> String {
        concat!("kane ", env!("CARGO_PKG_VERSION")).to_owned()
    }
}

impl Entry {
    pub(crate) fn new(label: &'static str, words: impl Into<Words>) -> Self {
        Self { label, words: words.into() }
    }
}
