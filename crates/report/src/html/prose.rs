//! The words of a document: Markdown as HTML, with its formulas, and with nothing that could reach the network.

use std::ops::Range;

use maud::{Markup, PreEscaped, html};
use pulldown_cmark::{CodeBlockKind, CowStr, Event, Parser, Tag, TagEnd};
use pulldown_latex::config::DisplayMode;

use super::math::math;
use crate::outline::{MARKDOWN, number};

/// A stretch of a document.
pub(crate) enum Part {
    /// words
    Prose(Markup),
    /// a heading: its level and its byte in the text
    Heading { level: u8, start: usize, words: Markup },
    /// a block of statements
    Statements(Range<usize>),
}

/// The document in parts, without its title. `anchor` knows where the statement with a label is shown.
pub(crate) fn parts(text: &str, anchor: &dyn Fn(&str) -> Option<String>) -> Vec<Part> {
    let mut parts = Vec::new();
    let mut events: Vec<Event<'_>> = Vec::new();
    let mut source = Parser::new_ext(text, MARKDOWN).into_offset_iter();
    let mut titled = false;
    while let Some((event, range)) = source.next() {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info)))
                if info.split([' ', '\t', ',']).next() == Some("kane") =>
            {
                flush(&mut events, &mut parts);
                source.by_ref().find(|(event, _)| matches!(event, Event::End(TagEnd::CodeBlock)));
                parts.push(Part::Statements(range));
            }
            Event::Start(Tag::Heading { level, .. }) => {
                flush(&mut events, &mut parts);
                let inside = source
                    .by_ref()
                    .map(|(event, _)| event)
                    .take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))));
                events.extend(inside.map(|event| plain(event, anchor)));
                let words = PreEscaped(written(&mut events));
                if number(level) > 1 || std::mem::replace(&mut titled, true) {
                    let level = number(level).max(2);
                    parts.push(Part::Heading { level, start: range.start, words });
                }
            }
            Event::InlineHtml(markup) if is_comment(&markup) => {}
            Event::Start(Tag::HtmlBlock) if is_comment(&text[range.clone()]) => {
                source.by_ref().find(|(event, _)| matches!(event, Event::End(TagEnd::HtmlBlock)));
            }
            event => events.push(plain(event, anchor)),
        }
    }
    flush(&mut events, &mut parts);
    parts
}

/// Whether markup is one comment and nothing else: what no reader of Markdown shows.
fn is_comment(markup: &str) -> bool {
    let inside = markup.trim().strip_prefix("<!--").and_then(|rest| rest.strip_suffix("-->"));
    inside.is_some_and(|inside| !inside.contains("-->"))
}

fn flush(events: &mut Vec<Event<'_>>, parts: &mut Vec<Part>) {
    let written = written(events);
    if !written.trim().is_empty() {
        parts.push(Part::Prose(PreEscaped(written)));
    }
}

fn written(events: &mut Vec<Event<'_>>) -> String {
    let mut out = String::new();
    pulldown_cmark::html::push_html(&mut out, events.drain(..));
    out
}

/// The event as it may stand in the page: formulas as MathML; markup of the author's as words; of pictures, which
/// would be fetched, and of links other than to pages, the words alone.
fn plain<'a>(event: Event<'a>, anchor: &dyn Fn(&str) -> Option<String>) -> Event<'a> {
    match event {
        Event::Html(markup) | Event::InlineHtml(markup) => Event::Text(markup),
        Event::InlineMath(latex) => inline(math(&latex, DisplayMode::Inline)),
        Event::DisplayMath(latex) => inline(display(&latex, anchor)),
        Event::Start(Tag::Image { .. }) => Event::Text(CowStr::Borrowed("[")),
        Event::End(TagEnd::Image) => Event::Text(CowStr::Borrowed("]")),
        Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
            let dest_url = if is_page(&dest_url) { dest_url } else { CowStr::Borrowed("#") };
            Event::Start(Tag::Link { link_type, dest_url, title, id })
        }
        event => event,
    }
}

fn inline(markup: Markup) -> Event<'static> {
    Event::InlineHtml(markup.into_string().into())
}

/// Whether an address is one of a page: anything relative, or on the web.
fn is_page(address: &str) -> bool {
    let scheme = address.split(['/', '?', '#']).next().and_then(|first| first.split_once(':'));
    scheme.is_none_or(|(scheme, _)| {
        ["http", "https", "mailto"].iter().any(|known| scheme.eq_ignore_ascii_case(known))
    })
}

/// A displayed formula; its number leads to the statement of that number.
fn display(latex: &str, anchor: &dyn Fn(&str) -> Option<String>) -> Markup {
    let (formula, tag) = untagged(latex);
    html! {
        span.shown {
            (math(&formula, DisplayMode::Block))
            @if let Some(tag) = tag {
                @let label = format!("({tag})");
                span.tag {
                    @if let Some(anchor) = anchor(&label) {
                        a href={ "#" (anchor) } { (label) }
                    } @else {
                        (label)
                    }
                }
            }
        }
    }
}

/// The formula without its `\tag{…}`, and what that says.
fn untagged(latex: &str) -> (String, Option<String>) {
    let found = latex.split_once("\\tag{").and_then(|(before, rest)| {
        let (tag, after) = rest.split_once('}')?;
        Some((format!("{before}{after}"), tag.to_owned()))
    });
    match found {
        Some((formula, tag)) => (formula, Some(tag)),
        None => (latex.to_owned(), None),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> String {
        let anchor = |label: &str| (label == "(1)").then(|| "s-1".to_owned());
        let parts = parts(text, &anchor);
        let each = parts.into_iter().map(|part| match part {
            Part::Prose(words) => words.into_string(),
            Part::Heading { level, words, .. } => format!("<{level}>{}", words.into_string()),
            Part::Statements(range) => format!("<<{}>>", &text[range]),
        });
        each.collect()
    }

    #[test]
    fn nothing_of_the_author_s_reaches_the_network_or_runs() {
        let text =
            "# T\n\n<script>x</script>\n\na <img src=y> ![p](http://z/p.png) [l](javascript:x)\n";
        let shown = shown(text);
        for forbidden in ["<script", "<img", "javascript:", "p.png"] {
            assert!(!shown.contains(forbidden), "{forbidden} in {shown}");
        }
        assert!(shown.contains("&lt;script&gt;") && shown.contains("[p]"), "{shown}");
    }

    #[test]
    fn a_comment_is_not_shown_and_what_stands_beside_it_is() {
        assert_eq!(shown("<!-- a\n\nb -->\n\nw <!-- c -->v\n"), "<p>w v</p>\n");
        for beside in ["<!-- a --> b <!-- c -->\n", "<!-- a --><b>\n", "<!-- a\n\nb\n"] {
            assert!(shown(beside).contains("&lt;!-- a"), "{beside}");
        }
    }

    #[test]
    fn a_number_beside_a_formula_leads_to_its_statement() {
        let shown = shown("$$x=1\\tag{1}$$\n\n$$x=2\\tag{2}$$\n");
        assert!(shown.contains("<a href=\"#s-1\">(1)</a>"), "{shown}");
        assert!(shown.contains("<span class=\"tag\">(2)</span>"), "{shown}");
    }

    #[test]
    fn blocks_and_headings_stand_apart() {
        let shown = shown("# T\n\n## A $k$\n\nw\n\n```kane\nvar x\n```\n\nv\n");
        assert!(!shown.contains('T'), "{shown}");
        assert!(shown.starts_with("<2>A <math"), "{shown}");
        assert!(shown.contains("<p>w</p>\n<<```kane\nvar x\n```>><p>v</p>"), "{shown}");
    }
}
