//! What every page has: head, style, title, and at the foot where it comes from.
//!
//! A page that stands alone is one file, and its policy forbids it to load anything. A page of a site loads what it
//! shares with the others from beside it, and from nowhere else. So opening a page tells nobody.

use kane_algebra::syntax::printable;
use maud::{DOCTYPE, Markup, PreEscaped, html};

use super::shared::{FRAME, MATHS, PICTURE, PLACE, Shared};
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
    /// styles beyond those of every page
    pub(crate) styles: &'static [Shared],
    /// what runs once the page is there
    pub(crate) script: Option<Shared>,
    /// what one needs to make the page again: names and values
    pub(crate) provenance: Vec<(&'static str, Markup)>,
}

/// What a page that stands alone may do.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; \
                      font-src data:; base-uri 'none'; form-action 'none'";
/// What a page of a site may do.
const POLICY_IN_SITE: &str = "default-src 'none'; style-src 'self'; script-src 'self'; \
                              font-src data:; base-uri 'none'; form-action 'none'";

impl Frame<'_> {
    /// The whole page with this content.
    pub(crate) fn page(&self, content: &Markup) -> String {
        let shared = self.place.shared();
        let shared = shared.as_deref();
        let policy = if shared.is_some() { POLICY_IN_SITE } else { POLICY };
        let (styles, content) = self.dressed(content);
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy" content=(policy);
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="color-scheme" content="light dark";
                    meta name="generator" content=(concat!("kane ", env!("CARGO_PKG_VERSION")));
                    title { (self.kind) ": " (self.title) }
                    @match shared {
                        Some(beside) => {
                            @for style in styles {
                                link rel="stylesheet" href={ (beside) (style.name) };
                            }
                        }
                        None => style { @for style in styles { (PreEscaped(style.text)) } },
                    }
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
                    @match (self.script, shared) {
                        (Some(script), Some(beside)) => script src={ (beside) (script.name) } {},
                        (Some(script), None) => script { (PreEscaped(script.text)) },
                        (None, _) => {}
                    }
                }
            }
        };
        let mut page = printable(&page.into_string()).into_owned();
        page.push('\n');
        page
    }

    /// The styles that the page needs with this content, and the content with the style of its pictures taken out: all
    /// of them have the same.
    fn dressed(&self, content: &Markup) -> (Vec<Shared>, Markup) {
        let within = format!("<style>{}</style>\n", PICTURE.text);
        let bare = content.0.replace(&within, "");
        let mut styles = Vec::new();
        styles.extend(bare.contains("<math").then_some(MATHS));
        styles.push(FRAME);
        styles.extend((!self.place.is_empty()).then_some(PLACE));
        styles.extend(self.styles);
        styles.extend((bare.len() < content.0.len()).then_some(PICTURE));
        (styles, PreEscaped(bare))
    }
}
