//! What every page has: head, style, title, and at the foot where it comes from.
//!
//! A page is one file. Its policy forbids it to load anything, so opening it tells nobody; its font for formulas is in
//! it.

use kane_algebra::syntax::printable;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::place::Place;

/// A page around its content.
pub(crate) struct Frame<'a> {
    /// what the page is about
    pub(crate) title: &'a str,
    /// what kind of page it is, above the title
    pub(crate) kind: &'a str,
    /// what is beside it
    pub(crate) place: &'a Place,
    /// what stands under the title
    pub(crate) news: Markup,
    /// places within the page: anchor and words
    pub(crate) contents: Vec<(String, Markup)>,
    /// rules beyond those of every page
    pub(crate) style: &'static str,
    /// what runs once the page is there
    pub(crate) script: &'static str,
    /// what one needs to make the page again: names and values
    pub(crate) provenance: Vec<(&'static str, Markup)>,
}

const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; \
                      font-src data:; base-uri 'none'; form-action 'none'";
/// Of a font for mathematics what formulas need, within the page: without one, indices stand at the base line.
const MATHS: &str = include_str!("../fonts/maths.css");

impl Frame<'_> {
    /// The whole page with this content.
    pub(crate) fn page(&self, content: &Markup) -> String {
        let has_formulas = content.0.contains("<math");
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy" content=(POLICY);
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    meta name="generator" content=(concat!("kane ", env!("CARGO_PKG_VERSION")));
                    title { (self.kind) ": " (self.title) }
                    @if has_formulas { style { (PreEscaped(MATHS)) } }
                    style { (PreEscaped(include_str!("frame.css"))) (PreEscaped(self.place.style())) (PreEscaped(self.style)) }
                }
                body {
                    a.skip href="#content" { "Skip to the content" }
                    header.top {
                        p.kind { (self.kind) }
                        h1 { (self.title) }
                        (self.news)
                        (self.place.html())
                    }
                    @if !self.contents.is_empty() {
                        nav.contents aria-label="Contents" {
                            ol {
                                @for (anchor, words) in &self.contents {
                                    li { a href={ "#" (anchor) } { (words) } }
                                }
                            }
                        }
                    }
                    main id="content" tabindex="-1" { (content) }
                    footer.provenance {
                        h2 { "Provenance" }
                        dl {
                            @for (name, value) in &self.provenance {
                                div { dt { (name) } dd { (value) } }
                            }
                        }
                    }
                    @if !self.script.is_empty() {
                        script { (PreEscaped(self.script)) }
                    }
                }
            }
        };
        let mut page = printable(&page.into_string()).into_owned();
        page.push('\n');
        page
    }
}
