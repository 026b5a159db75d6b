//! A paper as a draft of a derivation document.

use std::collections::BTreeSet;
use std::fmt::Write;

use kane_algebra::syntax::visible;

use crate::display::{Equation, Numbering};
use crate::domain::{Domain, customary, stated};
use crate::name::{Names, Symbol};
use crate::prose::{plain, unfenced};
use crate::relation::{Statement, head, of_tokens};
use crate::source::{Block, Format, REFERENCE, Source};
use crate::token::{Token, written};
use crate::unreadable::Unreadable;

/// A draft: a document, and what became of each equation.
#[derive(Clone, Debug)]
pub struct Draft {
    /// a derivation document in Markdown
    pub document: String,
    /// the equations in the order of the paper
    pub equations: Vec<Outcome>,
}

/// What became of an equation.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// its label in the document
    pub label: String,
    /// the line of its display in the source, from 1
    pub line: usize,
    /// why it was not read
    pub fault: Option<Unreadable>,
}

/// Premises that a claim cites if the text names none.
const MOST_CITED: usize = 30;

/// Words behind which a formula follows from what was said.
const FOLLOWS: [&str; 30] = [
    "hence",
    "therefore",
    "thus",
    "follows",
    "we obtain",
    "obtains",
    "we get",
    "we find",
    "yield",
    "gives",
    "leads to",
    "substitut",
    "so that",
    "implies",
    "consequently",
    "combining",
    "solving",
    "eliminat",
    "reduces to",
    "becomes",
    "simplif",
    "insert",
    "we have",
    "rewritten",
    "equivalent",
    "that is",
    "conclude",
    "results in",
    "must be",
    "amounts to",
];
/// Words behind which a formula is assumed, or says what something is.
const ASSUMED: [&str; 21] = [
    "define",
    "denote",
    "let ",
    "assume",
    "suppose",
    "where",
    "given by",
    "introduc",
    "law",
    "hypothes",
    "definition",
    "initial",
    "constraint",
    "obey",
    "according to",
    "postulat",
    "requir",
    "model",
    "prescribe",
    "equations of motion",
    "balance",
];

/// Reads a paper. Every equation stands in the draft as printed; those that could be read are
/// statements, the others are quoted with the reason. Which are premises, and which claims, is guessed
/// from the words before them, and what a claim rests on from the numbers that they name.
///
/// ```
/// use kane_latex::{Format, draft};
///
/// let paper = r"Momentum is \begin{equation} m(v - v_0) = p \end{equation}";
/// let draft = draft(paper, Format::Latex);
/// assert!(draft.document.contains("given (1): m*(v - v_0) = p"));
/// ```
#[must_use]
pub fn draft(text: &str, format: Format) -> Draft {
    let source = Source::read(text, format);
    let mut numbering = Numbering::of(&source);
    let latex = format == Format::Latex;
    // all numbers first: a reference may point forwards
    let mut displays: Vec<Vec<Equation>> = Vec::new();
    for block in &source.blocks {
        numbering.pass(block);
        if let Block::Display(shown) = block {
            displays.push(numbering.equations(shown, &source.macros, latex));
        }
    }
    let mut names = Names::default();
    for equation in displays.iter().flatten() {
        let defined = head(&equation.tokens).filter(|(_, parameters, rest)| {
            parameters.iter().all(|p| p != "t")
                && matches!(rest, [Token::Char('='), ..] | [Token::Char(':'), Token::Char('='), ..])
        });
        if let Some((name, ..)) = defined {
            names.functions.insert(name);
        }
    }
    let mut writer = Writer {
        source: &source,
        numbering: &numbering,
        names,
        latex,
        body: String::new(),
        before: String::new(),
        taken: BTreeSet::new(),
        premises: Vec::new(),
        unnumbered: 0,
        equations: Vec::new(),
        definitions: BTreeSet::new(),
        unread: BTreeSet::new(),
    };
    let mut displays = displays.into_iter();
    for block in &source.blocks {
        match block {
            Block::Heading(level, text) => {
                let text = writer.referenced(text);
                writer.body.push_str(&format!("{} {text}\n\n", "#".repeat(*level)));
            }
            Block::Prose(text) => {
                let shown = writer.referenced(text);
                writer.body.push_str(&format!("{shown}\n\n"));
                writer.before.push_str(&format!("{text} "));
            }
            Block::Display(_) => writer.display(displays.next().unwrap_or_default()),
            Block::Shared(_) | Block::Counter(_) => {}
        }
    }
    writer.finish(text)
}

struct Writer<'a> {
    source: &'a Source,
    numbering: &'a Numbering,
    names: Names,
    latex: bool,
    body: String,
    /// the running text since the last display
    before: String,
    taken: BTreeSet<String>,
    premises: Vec<String>,
    unnumbered: usize,
    equations: Vec<Outcome>,
    /// labels of definitions, which are in force everywhere and cited nowhere
    definitions: BTreeSet<String>,
    /// labels of equations that are no statements, and cannot be cited
    unread: BTreeSet<String>,
}

impl Writer<'_> {
    /// A text with the numbers that its references stand for.
    fn referenced(&self, text: &str) -> String {
        let mut out = String::new();
        for (i, part) in text.split(REFERENCE).enumerate() {
            match (i % 2, self.numbering.labels.get(part)) {
                (0, _) => out.push_str(part),
                (_, Some(number)) => out.push_str(&format!("({})", plain(&one_line(number)))),
                (_, None) => out.push_str("(?)"),
            }
        }
        unfenced(&out)
    }

    /// The labels above that the text before a display names, in its order, as far as these fit.
    fn named(&self, fits: impl Fn(&String) -> bool) -> Vec<String> {
        let text = self.referenced(&self.before);
        let mut found: Vec<String> = Vec::new();
        for part in text.split('(').skip(1) {
            let Some((label, _)) = part.split_once(')') else { continue };
            let label = format!("({label})");
            if fits(&label) && !found.contains(&label) {
                found.push(label);
            }
        }
        found
    }

    /// Whether the words before a formula say that it follows.
    fn follows(&self) -> Option<bool> {
        let words = self.before.to_lowercase();
        let last = |all: &[&str]| all.iter().filter_map(|word| words.rfind(word)).max();
        match (last(&FOLLOWS), last(&ASSUMED)) {
            (None, None) => None,
            (a, b) => Some(a > b),
        }
    }

    fn label(&mut self, number: Option<&String>) -> String {
        let kept = |text: &str| -> String {
            text.chars()
                .filter(|c| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '\''))
                .collect()
        };
        let number = number.map(|n| kept(n)).filter(|n| !n.is_empty());
        let mut label = match number {
            Some(number) => format!("({number})"),
            None => {
                self.unnumbered += 1;
                format!("(u{})", self.unnumbered)
            }
        };
        while self.taken.contains(&label) {
            label = format!("{}')", label.trim_end_matches(')'));
        }
        label
    }

    fn display(&mut self, equations: Vec<Equation>) {
        let named =
            self.named(|label| self.taken.contains(label) && !self.definitions.contains(label));
        let dropped =
            self.named(|label| self.unread.contains(label) && !self.taken.contains(label));
        let follows = self.follows();
        let mut statements = String::new();
        for equation in equations {
            let label = self.label(equation.number.as_ref());
            let shown = one_line(&written(&equation.tokens)).replace('$', "");
            let _ = match &equation.number {
                Some(number) => writeln!(
                    self.body,
                    "$${shown} \\tag{{{}}}$$",
                    one_line(number).replace(['{', '}', '$', '\\'], "")
                ),
                None => writeln!(self.body, "$${shown}$$"),
            };
            let known: Vec<Symbol> = self.names.symbols().to_vec();
            let read = match equation.fault {
                Some(fault) => Err(fault),
                None => of_tokens(&equation.tokens, &mut self.names),
            };
            let fault = match read {
                Ok(read) => {
                    let new = self.names.symbols().len() > known.len();
                    self.statement(&mut statements, &label, &read, new, follows, &named)
                }
                Err(fault) => Err(fault),
            };
            let fault = fault.err();
            if let Some(fault) = &fault {
                let why = one_line(&fault.to_string());
                let _ = writeln!(statements, "# {label} is not read: {why}");
                self.unread.insert(label.clone());
            }
            self.equations.push(Outcome { label, line: equation.line, fault });
        }
        if !dropped.is_empty() {
            let (list, is) = (dropped.join(", "), if dropped.len() == 1 { "is" } else { "are" });
            let note = format!("# the text above names {list}, which {is} not read");
            statements = format!("{note} and cannot be cited\n{statements}");
        }
        if !statements.is_empty() {
            self.body.push_str(&format!("\n```kane\n{statements}```\n\n"));
        }
        self.before.clear();
    }

    fn statement(
        &mut self,
        out: &mut String,
        label: &str,
        read: &Statement,
        new: bool,
        follows: Option<bool>,
        named: &[String],
    ) -> Result<(), Unreadable> {
        let text = one_line(&read.text());
        if let Some(head) = &read.defines {
            let name = head.split('(').next().unwrap_or_default().to_owned();
            if !self.names.defined.insert(name) {
                return Err(Unreadable::DefinedTwice(head.clone()));
            }
            let _ = writeln!(out, "let {label} {head} := {text}");
            self.definitions.insert(label.to_owned());
            self.taken.insert(label.to_owned());
            return Ok(());
        }
        self.taken.insert(label.to_owned());
        if let Some(left_out) = &read.left_out {
            let _ = writeln!(out, "# {label} has besides: {}", one_line(left_out));
        }
        let assumed = new && read.limit.is_none()
            || follows == Some(false) && !self.premises.is_empty() && named.is_empty();
        if self.premises.is_empty() || assumed {
            let _ = writeln!(out, "given {label}: {text}");
            self.premises.push(label.to_owned());
            return Ok(());
        }
        let nearest = &self.premises[self.premises.len().saturating_sub(MOST_CITED)..];
        let cited = if named.is_empty() { nearest } else { named };
        let _ = writeln!(out, "claim {label}: {text} from {}", cited.join(", "));
        Ok(())
    }

    fn finish(self, text: &str) -> Draft {
        let mut document = String::new();
        let line = |text: &Option<String>| text.as_ref().map(|t| unfenced(&t.replace('\n', " ")));
        match line(&self.source.title) {
            Some(title) => document.push_str(&format!("# {}\n\n", title.trim())),
            None if self.latex => document.push_str("# A paper\n\n"),
            None => {}
        }
        if let Some(author) = line(&self.source.author) {
            document.push_str(&format!("Source: {}\n\n", author.trim()));
        }
        document.push_str(
            "This is a draft, made by kane draft. Equations stand as printed and under their numbers. \
             Which of them are premises and which are claims, what a claim rests on, and the ranges of the \
             symbols are guesses from the words around them: they are for you to decide.\n\n",
        );
        let declared = self.declared(&text.to_lowercase());
        if !declared.is_empty() {
            document.push_str(&format!("```kane\n{declared}```\n\n"));
        }
        document.push_str(&self.body);
        let document = format!("{}\n", document.trim_end());
        Draft { document, equations: self.equations }
    }

    /// The declarations, one a line, with the guesses and their reasons.
    fn declared(&self, words: &str) -> String {
        let stated = stated(&self.source.inline);
        let mut lines: Vec<(String, String)> = Vec::new();
        let symbols = self.names.symbols();
        // t before what varies with it
        let first = symbols.iter().filter(|symbol| symbol.name == "t");
        for symbol in first.chain(symbols.iter().filter(|symbol| symbol.name != "t")) {
            let argument = if symbol.of_time { "(t)" } else { "" };
            let name = format!("{}{argument}", symbol.name);
            if symbol.vector {
                lines.push((format!("var {name} in R^3"), "guessed: a vector in space".to_owned()));
                continue;
            }
            // bounds are always in force, so that what the text says somewhere is only told
            let said = stated.get(&symbol.name).cloned();
            let (line, reason) = match customary(&symbol.name, words) {
                Some(Domain { lower, upper, reason }) => {
                    (format!("var {lower}{name}{upper}"), format!("guessed: {reason}"))
                }
                None => (format!("var {name}"), String::new()),
            };
            let reasons: Vec<String> =
                [reason, said.unwrap_or_default()].into_iter().filter(|r| !r.is_empty()).collect();
            lines.push((line, reasons.join("; ")));
        }
        let mut out = String::new();
        for (line, reason) in lines {
            let _ = match reason.as_str() {
                "" => writeln!(out, "{line}"),
                _ => writeln!(out, "{line:28}  # {}", one_line(&reason)),
            };
        }
        out
    }
}

/// A text in one line, without what would end a block, and with what nobody sees written out, which a block may not have.
pub(crate) fn one_line(text: &str) -> String {
    visible(&text.replace(['\n', '\r', '\t', '~'], " ")).replace('`', "'")
}
