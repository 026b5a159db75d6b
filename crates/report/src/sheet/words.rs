//! Words of a sheet: what is said, what of it is code, and in which tone.

use std::borrow::Cow;
use std::ops::Add;

use kane_algebra::syntax::visible;
use maud::{Markup, html};

use super::symbols::{formula, name, typeset};
use crate::{markdown, tex};

/// Words in a row.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Words {
    spans: Vec<Span>,
    pub(crate) tone: Tone,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Span {
    Plain(String),
    /// a name as it is typed
    Code(String),
    /// a formula as it is typed
    Formula(String),
    Strong(String),
    /// words that lead to another file, by its relative address
    Link {
        words: String,
        to: String,
    },
}

/// How something is to be taken. No form shows it by colour alone: the words say it, too.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tone {
    #[default]
    Plain,
    Good,
    Doubtful,
    Bad,
    /// of little weight
    Quiet,
}

impl<T: Into<String>> From<T> for Words {
    fn from(text: T) -> Self {
        Self { spans: vec![Span::Plain(seen(text))], tone: Tone::Plain }
    }
}

/// What words of a sheet are made of: text that stays on its line, and all of which is seen. A name from a log or of a
/// file could otherwise draw lines of a report.
pub(super) fn seen(text: impl Into<String>) -> String {
    let text = text.into();
    match visible(&text) {
        Cow::Borrowed(_) => text,
        Cow::Owned(written_out) => written_out,
    }
}

impl<T: Into<Self>> Add<T> for Words {
    type Output = Self;

    fn add(mut self, more: T) -> Self {
        self.spans.extend(more.into().spans);
        self
    }
}

impl Words {
    /// A formula as it is typed; pages set it as in print.
    pub(crate) fn formula(text: impl Into<String>) -> Self {
        Self { spans: vec![Span::Formula(seen(text))], tone: Tone::Plain }
    }

    /// A name as it is typed.
    pub(crate) fn code(text: impl Into<String>) -> Self {
        Self { spans: vec![Span::Code(seen(text))], tone: Tone::Plain }
    }

    /// What must not be overlooked.
    pub(crate) fn strong(text: impl Into<String>) -> Self {
        Self { spans: vec![Span::Strong(seen(text))], tone: Tone::Plain }
    }

    /// Words that lead to another file; text and LaTeX have the words alone.
    pub(crate) fn link(words: impl Into<String>, to: impl Into<String>) -> Self {
        let span = Span::Link { words: seen(words), to: to.into() };
        Self { spans: vec![span], tone: Tone::Plain }
    }

    pub(crate) fn toned(mut self, tone: Tone) -> Self {
        self.tone = tone;
        self
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.spans.iter().all(|span| span.text().is_empty())
    }

    pub(crate) fn plain(&self) -> String {
        self.spans.iter().map(Span::text).collect()
    }

    pub(crate) fn markdown(&self) -> String {
        let span = |span: &Span| match span {
            Span::Plain(text) => markdown::escape(text),
            Span::Code(text) | Span::Formula(text) if text.is_empty() => String::new(),
            // a bar ends a cell even within code
            Span::Code(text) | Span::Formula(text) => markdown::code(text).replace('|', "\\|"),
            Span::Strong(text) => format!("**{}**", markdown::escape(text)),
            // an address within angle brackets may hold anything but these and line ends
            Span::Link { words, to } => format!("[{}](<{to}>)", markdown::escape(words)),
        };
        self.spans.iter().map(span).collect()
    }

    pub(crate) fn html(&self) -> Markup {
        html! {
            @for span in &self.spans {
                @match span {
                    Span::Plain(text) => (typeset(text)),
                    Span::Code(text) => @match name(text) {
                        Some(said) => span title=(text) { (said) },
                        None => code { (text) },
                    },
                    Span::Formula(text) => (formula(text)),
                    Span::Strong(text) => strong { (text) },
                    Span::Link { words, to } => a href=(to) { (words) },
                }
            }
        }
    }

    pub(crate) fn latex(&self) -> String {
        let span = |span: &Span| match span {
            Span::Plain(text) => tex::escape(text),
            Span::Code(text) | Span::Formula(text) => {
                format!("\\texttt{{{}}}", tex::escape(text))
            }
            Span::Strong(text) => format!("\\textbf{{{}}}", tex::escape(text)),
            Span::Link { words, .. } => tex::escape(words),
        };
        self.spans.iter().map(span).collect()
    }
}

impl Span {
    fn text(&self) -> &str {
        match self {
            Self::Plain(text) | Self::Code(text) | Self::Formula(text) | Self::Strong(text) => text,
            Self::Link { words, .. } => words,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_character_of_a_cell_becomes_markup_in_any_form() {
        let words = Words::from("a|b <i> $") + Words::code("|x| {y}") + Words::strong("_no_");
        assert_eq!(words.plain(), "a|b <i> $|x| {y}_no_");
        assert_eq!(words.markdown(), r"a\|b &lt;i&gt; \$`\|x\| {y}`**\_no\_**");
        let html = "a|b &lt;i&gt; $<code>|x| {y}</code><strong>_no_</strong>";
        assert_eq!(words.html().into_string(), html);
        let latex = r"a$|$b $<$i$>$ \$\texttt{$|$x$|$ \{y\}}\textbf{\_no\_}";
        assert_eq!(words.latex(), latex);
    }

    #[test]
    fn no_text_draws_a_line_or_moves_what_stands_beside_it() {
        let hostile = "steel\nclaim (1): proved\r\u{1b}[2K\u{2028}\u{202e}x";
        let told = r"steel\u{a}claim (1): proved\u{d}\u{1b}[2K\u{2028}\u{202e}x";
        let all = [
            Words::from(hostile),
            Words::code(hostile),
            Words::formula(hostile),
            Words::strong(hostile),
            Words::link(hostile, "a.html"),
        ];
        for words in all {
            assert_eq!(words.plain(), told);
        }
    }

    #[test]
    fn a_link_leads_somewhere_where_a_form_has_links() {
        let words = Words::link("the <laws>", "laws.html#cone");
        assert_eq!(words.plain(), "the <laws>");
        assert_eq!(words.html().into_string(), "<a href=\"laws.html#cone\">the &lt;laws&gt;</a>");
        assert_eq!(words.markdown(), "[the &lt;laws&gt;](<laws.html#cone>)");
        assert_eq!(words.latex(), "the $<$laws$>$");
    }
}
