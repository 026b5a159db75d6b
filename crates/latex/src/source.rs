//! A paper as headings, prose and displayed formulas.

use crate::macros::Macros;
use crate::prose::{Prose, accent, escaped, plain};
use crate::token::{braced, tokens, written};

/// How a source is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// LaTeX
    Latex,
    /// Markdown with formulas between dollars
    Markdown,
}

/// A part of a paper.
#[derive(Clone, Debug)]
pub(crate) enum Block {
    /// a heading of a level, from 1
    Heading(usize, String),
    /// a paragraph in Markdown; references stand between two [`REFERENCE`]s
    Prose(String),
    /// a displayed formula
    Display(Shown),
    /// the beginning (true) or the end of equations that share a number
    Shared(bool),
    /// the last number of an equation is this
    Counter(usize),
}

/// A displayed formula as it stands in the source.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    /// the environment, without its star; `[` for one without a name
    pub(crate) environment: String,
    /// whether its rows have numbers
    pub(crate) numbered: bool,
    /// what stands in it
    pub(crate) body: String,
    /// its line in the source, from 1
    pub(crate) line: usize,
}

/// A paper that is taken apart.
#[derive(Clone, Debug, Default)]
pub(crate) struct Source {
    pub(crate) title: Option<String>,
    pub(crate) author: Option<String>,
    pub(crate) blocks: Vec<Block>,
    pub(crate) macros: Macros,
    /// whether numbers of equations have the section before them
    pub(crate) by_section: bool,
    /// formulas in the running text
    pub(crate) inline: Vec<String>,
}

/// Stands around the key of a reference until all numbers are known; no source has it.
pub(crate) const REFERENCE: char = '\u{1}';

/// Arguments in one another beyond which their words are left out.
const DEPTH: usize = 50;
/// Bytes of a formula in the running text.
const INLINE: usize = 10_000;

const DISPLAYS: [&str; 11] = [
    "equation",
    "align",
    "gather",
    "multline",
    "eqnarray",
    "flalign",
    "alignat",
    "displaymath",
    "dmath",
    "math",
    "IEEEeqnarray",
];
/// Environments of which only the caption is kept.
const LEFT_OUT: [&str; 12] = [
    "figure",
    "table",
    "tabular",
    "tikzpicture",
    "thebibliography",
    "lstlisting",
    "verbatim",
    "algorithm",
    "comment",
    "wrapfigure",
    "picture",
    "minted",
];

impl Source {
    /// Takes a paper apart. What is no LaTeX stays as it is; nothing is refused.
    pub(crate) fn read(text: &str, format: Format) -> Self {
        let clean: String = text
            .replace("\r\n", "\n")
            .chars()
            .filter(|c| !c.is_control() || *c == '\n' || *c == '\t')
            .collect();
        let latex = format == Format::Latex;
        let mut scanner = Scanner {
            text: &clean,
            at: 0,
            latex,
            body: !latex || !clean.contains("\\begin{document}"),
            depth: 0,
            line: (0, 1),
            out: Self::default(),
            prose: Prose::default(),
        };
        while scanner.at < clean.len() {
            scanner.step();
        }
        scanner.paragraph();
        scanner.out
    }
}

struct Scanner<'a> {
    text: &'a str,
    at: usize,
    latex: bool,
    /// behind `\begin{document}`
    body: bool,
    /// how many arguments this one stands in
    depth: usize,
    /// a place, and the line it is in
    line: (usize, usize),
    out: Source,
    prose: Prose,
}

impl<'a> Scanner<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn step(&mut self) {
        let rest = self.rest();
        let Some(c) = rest.chars().next() else { return };
        if c == '\\' {
            return self.command();
        }
        if let Some(inside) = rest.strip_prefix("$$") {
            let end = inside.find("$$");
            return self.display("[", false, 2, end, 2);
        }
        self.at += c.len_utf8();
        match c {
            '$' => self.inline("$"),
            '%' if self.latex => {
                let line = self.rest().find('\n').map_or(self.rest().len(), |n| n + 1);
                self.at += line;
            }
            '\n' => {
                let blank = self.rest().lines().next().is_none_or(|line| line.trim().is_empty());
                if blank { self.paragraph() } else { self.prose.push('\n') }
            }
            '{' | '}' if self.latex => {}
            '~' if self.latex => self.prose.push(' '),
            '-' if self.latex && self.rest().starts_with("--") => {
                self.at += 2;
                self.prose.push('—');
            }
            '-' if self.latex && self.rest().starts_with('-') => {
                self.at += 1;
                self.prose.push('–');
            }
            '`' if self.latex => {
                let double = self.rest().starts_with('`');
                self.at += usize::from(double);
                self.prose.push(if double { '“' } else { '‘' });
            }
            '\'' if self.latex && self.rest().starts_with('\'') => {
                self.at += 1;
                self.prose.push('”');
            }
            _ if self.latex => self.prose.push_str(&escaped(c)),
            _ => self.prose.push(c),
        }
    }

    /// A formula up to where it ends, between marks of these lengths; all that is left if it does not.
    fn display(
        &mut self,
        name: &str,
        numbered: bool,
        open: usize,
        end: Option<usize>,
        close: usize,
    ) {
        self.paragraph();
        let (place, line) = self.line;
        let line = line + self.text[place..self.at].matches('\n').count();
        self.line = (self.at, line);
        let inside = &self.rest()[open..];
        let (body, length) = match end {
            Some(end) => (&inside[..end], open + end + close),
            None => (inside, self.rest().len()),
        };
        self.at += length;
        if self.body {
            let environment = name.to_owned();
            let body = body.to_owned();
            self.out.blocks.push(Block::Display(Shown { environment, numbered, body, line }));
        }
    }

    fn inline(&mut self, close: &str) {
        let rest = self.rest();
        let window = rest.char_indices().take_while(|(at, _)| *at < INLINE).last();
        let window = &rest[..window.map_or(0, |(at, c)| at + c.len_utf8())];
        let window = window.split("\n\n").next().unwrap_or_default();
        let Some(end) = window.find(close) else {
            self.prose.push_str("\\$");
            return;
        };
        self.at += end + close.len();
        let all = tokens(&rest[..end], self.latex);
        let shown = match self.out.macros.expand(&all) {
            Ok(all) if self.latex => written(&all),
            _ => rest[..end].to_owned(),
        };
        let shown = shown.replace('`', "'").replace('~', " ");
        self.out.inline.push(shown.clone());
        self.prose.push_str(&format!("${shown}$"));
    }

    /// Ends the paragraph.
    fn paragraph(&mut self) {
        let text = self.prose.take();
        if self.body && !text.trim().is_empty() {
            self.out.blocks.push(Block::Prose(text.trim().to_owned()));
        }
    }

    fn command(&mut self) {
        let rest = &self.rest()[1..];
        let letters = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
        if letters == 0 {
            return self.sign(rest);
        }
        let name = &rest[..letters];
        self.at += 1 + letters;
        if let Some(behind) = self.out.macros.define(name, self.rest()) {
            self.at = self.text.len() - behind.len();
            return;
        }
        match name {
            "begin" => self.begin(),
            "end" => {
                let environment = self.argument();
                match environment.as_str() {
                    "document" => self.at = self.text.len(),
                    "subequations" => {
                        self.paragraph();
                        self.out.blocks.push(Block::Shared(false));
                    }
                    _ => {}
                }
            }
            "numberwithin" => {
                self.out.by_section = self.argument() == "equation" && self.argument() == "section";
            }
            "setcounter" => {
                let (counter, value) = (self.argument(), self.argument());
                if let ("equation", Ok(value)) = (counter.as_str(), value.parse()) {
                    self.paragraph();
                    self.out.blocks.push(Block::Counter(value));
                }
            }
            "title" => self.out.title = Some(self.words()),
            "author" => self.out.author = Some(self.words()),
            _ if !self.body => {}
            "section" | "chapter" => self.heading(2),
            "subsection" => self.heading(3),
            "subsubsection" => self.heading(4),
            "paragraph" => {
                let words = self.words();
                self.prose.push_str(&format!("**{words}** "));
            }
            "emph" | "textit" | "textsl" => {
                let words = self.words();
                self.prose.push_str(&format!("*{words}*"));
            }
            "textbf" => {
                let words = self.words();
                self.prose.push_str(&format!("**{words}**"));
            }
            "footnote" | "thanks" => {
                let words = self.words();
                self.prose.push_str(&format!(" ({words})"));
            }
            "cite" | "citep" | "citet" | "citealp" => {
                let keys = self.argument();
                let keys = plain(&keys);
                self.prose.push_str(&format!("({keys})"));
            }
            "ref" | "eqref" | "autoref" | "cref" | "Cref" => {
                let key = self.argument();
                self.prose.push_str(&format!("{REFERENCE}{key}{REFERENCE}"));
            }
            "item" => {
                self.optional();
                self.prose.push_str("\n- ");
            }
            "input" | "include" => {
                let file = self.argument();
                let file = plain(&file);
                self.prose.push_str(&format!("*(not read: the file {file})*"));
            }
            "label" | "bibliography" | "bibliographystyle" | "vspace" | "hspace" | "pagestyle"
            | "usepackage" | "documentclass" | "date" | "graphicspath" => {
                self.optional();
                self.argument();
            }
            "ss" => self.prose.push('ß'),
            "o" => self.prose.push('ø'),
            "aa" => self.prose.push('å'),
            // unknown commands fall away, what stands in their braces stays
            _ => self.optional(),
        }
    }

    /// `\[`, `\(`, an accent, or a character that needs its backslash.
    fn sign(&mut self, rest: &str) {
        let Some(c) = rest.chars().next() else {
            self.at += 1;
            return;
        };
        match c {
            '[' => {
                let end = rest[1..].find("\\]");
                self.display("[", false, 2, end, 2);
            }
            '(' => {
                self.at += 2;
                self.inline("\\)");
            }
            _ if !self.latex => {
                self.at += 1 + c.len_utf8();
                self.prose.push('\\');
                self.prose.push(c);
            }
            '\\' => {
                self.at += 2;
                self.optional();
                self.prose.push('\n');
            }
            _ => {
                self.at += 1 + c.len_utf8();
                match accent(c) {
                    Some(mark) => {
                        let mut words = self.argument();
                        // \i and \j are letters without their dots, and eat the space behind them
                        if words == "\\" {
                            words = self.argument();
                            let rest = self.rest();
                            self.at += rest.len() - rest.trim_start_matches(' ').len();
                        }
                        let mut letters = words.trim_start_matches('\\').chars();
                        if let Some(letter) = letters.next() {
                            self.prose.push_str(&plain(&format!("{letter}{mark}")));
                            self.prose.push_str(&plain(letters.as_str()));
                        }
                    }
                    None if c.is_ascii_punctuation()
                        && !matches!(c, ',' | ';' | '!' | '/' | '-') =>
                    {
                        self.prose.push_str(&escaped(c));
                    }
                    None => self.prose.push(' '),
                }
            }
        }
    }

    fn begin(&mut self) {
        let start = self.at;
        let name = self.argument();
        let plain = name.trim_end_matches('*');
        if DISPLAYS.contains(&plain) {
            let end = self.rest().find(&format!("\\end{{{name}}}"));
            let numbered = !name.ends_with('*') && !matches!(plain, "displaymath" | "math");
            let close = name.len() + "\\end{}".len();
            return self.display(plain, numbered, 0, end, close);
        }
        if LEFT_OUT.contains(&plain) {
            let end = self.rest().find(&format!("\\end{{{name}}}")).unwrap_or(self.rest().len());
            let inside = &self.rest()[..end];
            let caption = inside.find("\\caption").and_then(|at| {
                let behind = &inside[at + "\\caption".len()..];
                braced(behind.trim_start()).map(|(words, _)| words.to_owned())
            });
            self.at += end;
            self.paragraph();
            if let Some(caption) = caption {
                let words = self.converted(&caption);
                self.prose.push_str(&format!("*({plain}: {words})*"));
                self.paragraph();
            }
            return;
        }
        match plain {
            "document" => {
                // what stands before it is no text of the paper
                self.prose.take();
                self.body = true;
            }
            "abstract" => self.prose.push_str("**Abstract.** "),
            "subequations" => {
                self.paragraph();
                self.out.blocks.push(Block::Shared(true));
            }
            "itemize" | "enumerate" | "description" | "center" | "quote" => self.optional(),
            _ if self.latex && self.body => {
                self.paragraph();
                let words: String = plain.chars().filter(char::is_ascii_alphanumeric).collect();
                self.prose.push_str(&format!("**{words}.** "));
                self.optional();
            }
            _ if !self.latex => self.prose.push_str(&self.text[start - "\\begin".len()..self.at]),
            _ => {}
        }
    }

    fn heading(&mut self, level: usize) {
        self.paragraph();
        let words = self.words().replace('\n', " ");
        self.out.blocks.push(Block::Heading(level, words.trim().to_owned()));
    }

    /// The words of an argument, in Markdown.
    fn words(&mut self) -> String {
        let argument = self.argument();
        self.converted(&argument)
    }

    /// A piece of the running text in Markdown.
    fn converted(&mut self, text: &str) -> String {
        if self.depth > DEPTH {
            return String::new();
        }
        let macros = std::mem::take(&mut self.out.macros);
        let mut inner = Scanner {
            text,
            at: 0,
            latex: self.latex,
            body: true,
            depth: self.depth + 1,
            line: (0, 1),
            out: Source { macros, ..Source::default() },
            prose: Prose::default(),
        };
        let mut words: Vec<String> = Vec::new();
        while inner.at < text.len() {
            inner.step();
        }
        inner.paragraph();
        for block in &inner.out.blocks {
            if let Block::Prose(text) = block {
                words.push(text.clone());
            }
        }
        self.out.macros = inner.out.macros;
        self.out.inline.append(&mut inner.out.inline);
        words.join(" ")
    }

    fn argument(&mut self) -> String {
        let rest = self.rest();
        let rest = rest.strip_prefix('*').unwrap_or(rest);
        let mut rest = rest.trim_start_matches([' ', '\t']);
        if let Some(inside) = rest.strip_prefix('[')
            && let Some(end) = inside.find(']')
        {
            rest = inside[end + 1..].trim_start_matches([' ', '\t']);
        }
        let (argument, rest) = match braced(rest) {
            Some(found) => found,
            None => rest.split_at(rest.chars().next().map_or(0, char::len_utf8)),
        };
        self.at = self.text.len() - rest.len();
        argument.to_owned()
    }

    fn optional(&mut self) {
        if let Some(inside) = self.rest().strip_prefix('[')
            && let Some(end) = inside.find(']')
        {
            self.at += end + 2;
        }
    }
}
