//! A sheet as a page.

use maud::{Markup, PreEscaped, html};

use super::symbols::heading;
use super::table::{Column, Fit, Table};
use super::words::{Tone, Words};
use super::{Block, Entry, Sheet};
use crate::html::{Frame, shared};

impl Sheet<'_> {
    /// The sheet as one HTML file, which loads nothing. Equal sheets give equal bytes.
    #[must_use]
    pub fn html(&self) -> String {
        let mut contents = Vec::new();
        for block in &self.blocks {
            match block {
                Block::Heading { id, words } => contents.push((id.clone(), words.html())),
                Block::Figure(figure) => {
                    contents.push((figure.name.to_owned(), html! { (figure.heading) }));
                }
                _ => {}
            }
        }
        let machine = self.machine.iter().map(|machine| ("Machine", html! { (machine) }));
        let mut provenance = vec![
            ("Program", html! { (Self::program()) }),
            ("Command", html! { code { (self.command) } }),
        ];
        provenance.extend(machine);
        provenance.push(("Seed", html! { "none: nothing here is drawn at random" }));
        let page = Frame {
            title: &self.title,
            kind: self.kind,
            place: &self.place,
            news: html! { @if !self.headline.is_empty() { p { (self.headline) "." } } },
            contents,
            styles: &[shared::SHEET],
            script: None,
            provenance,
        };
        let mut under = "content";
        let blocks: Vec<Markup> = self.blocks.iter().map(|block| block.html(&mut under)).collect();
        page.page(&html! { @for block in &blocks { (block) } })
    }
}

impl Block<'_> {
    /// The block; `under` is the heading that it stands under, which names what may scroll.
    fn html<'s>(&'s self, under: &mut &'s str) -> Markup {
        match self {
            Self::Heading { id, words } => {
                *under = id;
                html! { h2 id=(id) { (words.html()) } }
            }
            Self::Prose(words) => html! { p { (words.html()) } },
            Self::Labelled(entries) => labelled(entries),
            Self::Table(table) => rows(table, under),
            Self::Figure(figure) => {
                *under = figure.name;
                html! {
                    h2 id=(figure.name) { (figure.heading) }
                    figure.picture tabindex="0" aria-labelledby=(figure.name) {
                        (PreEscaped((figure.draw)()))
                    }
                }
            }
        }
    }
}

fn labelled(entries: &[Entry]) -> Markup {
    html! {
        dl.labelled {
            @for Entry { label, words } in entries {
                div { dt { (label) } dd class=[class(words.tone)] { (words.html()) } }
            }
        }
    }
}

/// A table, which may be wider than the page: it scrolls, by keys too.
fn rows(table: &Table, under: &str) -> Markup {
    let all = table.rows.len();
    html! {
        @if all > table.most { p { "The first " (table.most) " of " (all) "." } }
        table tabindex="0" aria-labelledby=(under) {
            thead { tr {
                @for column in &table.columns {
                    @let head = column.head();
                    @if head.is_empty() { td {} } @else { th scope="col" class=[number(column)] { (heading(&head)) } }
                }
            } }
            tbody {
                @for row in table.rows.iter().take(table.most) {
                    tr class=[class(row.tone)] {
                        @for (index, (cell, column)) in row.cells.iter().zip(&table.columns).enumerate() {
                            @if index == 0 && !cell.plain().is_empty() {
                                th scope="row" class=[number(column)] { (cell.html()) }
                            } @else {
                                (data(cell, column))
                            }
                        }
                    }
                }
            }
        }
    }
}

fn data(cell: &Words, column: &Column) -> Markup {
    let classes: Vec<&str> = number(column).into_iter().chain(class(cell.tone)).collect();
    html! { td class=[(!classes.is_empty()).then(|| classes.join(" "))] { (cell.html()) } }
}

fn number(column: &Column) -> Option<&'static str> {
    match column.fit {
        Fit::Right => Some("number"),
        Fit::Long(_) => Some("long"),
        Fit::Left => None,
    }
}

const fn class(tone: Tone) -> Option<&'static str> {
    match tone {
        Tone::Plain => None,
        Tone::Good => Some("good"),
        Tone::Doubtful => Some("doubtful"),
        Tone::Bad => Some("bad"),
        Tone::Quiet => Some("little"),
    }
}
