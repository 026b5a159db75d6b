//! Where a page stands: the pages beside it, and the other forms of what it tells.

use maud::{Markup, html};

use crate::html::shared::DIRECTORY;

/// A file beside a page, by its relative address.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// what it is called
    pub words: String,
    /// where it is, seen from the page
    pub to: String,
}

/// What is beside a page, in rows that each have a label. A page that stands alone has none.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Place {
    rows: Vec<(String, Vec<Link>)>,
    /// the way to the index of the site, empty or `../`; none for a page that stands alone
    up: Option<String>,
}

impl Link {
    /// A link to this address.
    #[must_use]
    pub fn new(words: impl Into<String>, to: impl Into<String>) -> Self {
        Self { words: words.into(), to: to.into() }
    }
}

impl Place {
    /// A page of a site, whose index is this way up: empty, or `../` once or more. What its pages share is beside the
    /// index.
    #[must_use]
    pub fn in_site(up: impl Into<String>) -> Self {
        Self { rows: Vec::new(), up: Some(up.into()) }
    }

    /// The way to what pages of the site share.
    pub(crate) fn shared(&self) -> Option<String> {
        self.up.as_ref().map(|up| format!("{up}{DIRECTORY}/"))
    }

    pub(crate) const fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
    /// The same place with one more row, unless it would be empty.
    #[must_use]
    pub fn with(mut self, label: &str, links: Vec<Link>) -> Self {
        if !links.is_empty() {
            self.rows.push((label.to_owned(), links));
        }
        self
    }

    /// The rows as navigation; nothing where there are none.
    pub(crate) fn html(&self) -> Markup {
        html! {
            @if !self.rows.is_empty() {
                nav.place aria-label="Site" {
                    dl {
                        @for (label, links) in &self.rows {
                            div {
                                dt { (label) }
                                dd { @for link in links { a href=(link.to) { (link.words) } " " } }
                            }
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_that_stands_alone_has_no_navigation() {
        assert_eq!(Place::default().html().into_string(), "");
        let empty = Place::default().with("Site", Vec::new());
        assert_eq!((empty.html().into_string().as_str(), empty.shared()), ("", None));
        let place = empty.with("Site", vec![Link::new("laws & more", "../laws.html")]);
        assert!(
            place.html().into_string().contains("<a href=\"../laws.html\">laws &amp; more</a>")
        );
    }
}
