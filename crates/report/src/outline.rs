//! The headings of a document, under which its statements stand.

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd};

/// A heading below the title.
#[derive(Debug)]
pub(crate) struct Heading {
    /// 2 for a section, 3 for a subsection, …
    pub(crate) level: u8,
    /// the words, without markup
    pub(crate) title: String,
    /// byte of the document at which it starts
    pub(crate) start: usize,
}

/// What of Markdown is read beyond the core: mathematics and tables. Neither moves the blocks in which statements
/// stand.
pub(crate) const MARKDOWN: Options = Options::ENABLE_MATH.union(Options::ENABLE_TABLES);

/// The level as a number.
pub(crate) const fn number(level: HeadingLevel) -> u8 {
    match level {
        HeadingLevel::H1 => 1,
        HeadingLevel::H2 => 2,
        HeadingLevel::H3 => 3,
        HeadingLevel::H4 => 4,
        HeadingLevel::H5 => 5,
        HeadingLevel::H6 => 6,
    }
}

/// All headings of level 2 and more, in order.
pub(crate) fn headings(text: &str) -> Vec<Heading> {
    let mut headings: Vec<Heading> = Vec::new();
    let mut open = false;
    for (event, range) in Parser::new_ext(text, MARKDOWN).into_offset_iter() {
        match event {
            Event::Start(Tag::Heading { level, .. }) if number(level) > 1 => {
                open = true;
                let heading =
                    Heading { level: number(level), title: String::new(), start: range.start };
                headings.push(heading);
            }
            Event::End(TagEnd::Heading(_)) => open = false,
            Event::Text(part) | Event::Code(part) | Event::InlineMath(part) if open => {
                if let Some(heading) = headings.last_mut() {
                    heading.title.push_str(&part);
                }
            }
            _ => {}
        }
    }
    headings
}

#[cfg(test)]
mod tests {
    use super::headings;

    #[test]
    fn the_title_is_not_a_section_and_a_fence_holds_no_heading() {
        let found = headings("# T\n\n## One $k$\n\n```\n## not\n```\n\n### Two\n");
        let shown: Vec<_> = found.iter().map(|h| (h.level, h.title.as_str(), h.start)).collect();
        assert_eq!(shown, [(2, "One k", 5), (3, "Two", 33)]);
    }
}
