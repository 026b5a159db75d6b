//! The report for print: an appendix of claims, each with its proof or counterexample.

use std::fmt::Write as _;

use kane_algebra::syntax::{canonical_name, greek_letter, latex_name};
use kane_audit::{LinkJudgement, Verdict};
use kane_judges::Judge;

use crate::judges;
use crate::markdown::capitalised;
use crate::outline::headings;
use crate::report::Entry;
use crate::typeset::{Names, Piece};
use crate::wording::evidence;
use crate::{Report, Summary};

/// Formulas stand in lines of text, where TeX may break them; nothing is hyphenated, and a line may be short.
const PREAMBLE: &str = r"\documentclass[11pt]{article}
\usepackage[utf8]{inputenc}
\usepackage{amsmath,amssymb}
\usepackage[margin=30mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.5\baselineskip plus 2pt}
\raggedright
\relpenalty=100 \binoppenalty=200 \emergencystretch=3em
\newcommand{\statement}[3]{\pagebreak[2]\medskip\par\textbf{#1 #2}\quad #3\par}
\newcommand{\evidence}[1]{\par\nopagebreak\textit{#1.}\enspace}
\newcommand{\step}[2]{\par\vspace{-\parskip}\hangindent=\dimexpr#1\relax\advance\hangindent by 1.5em\hangafter=1\hspace*{#1}#2}
\newcommand{\qed}{\hfill\ensuremath{\square}}
";

/// The report as a document for LaTeX, which needs `amsmath`, `amssymb` and `geometry` alone.
///
/// Section by section it states what is assumed and claimed; a proof ends in a square, and what is refuted is
/// followed by its counterexample. Equal reports give equal bytes.
#[must_use]
pub fn latex(report: &Report<'_>) -> String {
    let document = &report.audit.document;
    let names = Names::of(&document.context);
    let summary = Summary::of(report);
    let mut out = PREAMBLE.to_owned();
    let title = document.title.as_deref().unwrap_or(&document.name);
    let _ = writeln!(
        out,
        "\\begin{{document}}\n{{\\Large\\bfseries Audit: {}\\par}}\n\n{}. {}.\n",
        escape(title),
        escape(&capitalised(&summary.headline())),
        escape(&capitalised(&summary.expectation()))
    );
    for judge in report.judges {
        let _ = writeln!(out, "{}.\n", escape(&judges::headline(judge)));
    }
    let headings = headings(&document.text);
    let mut headings = headings.iter().peekable();
    for (&index, entry) in report.shown.iter().zip(report.entries()) {
        let mut above = Vec::new();
        while let Some(heading) = headings.next_if(|h| h.start < entry.statement.span.start) {
            // of headings without statements between them, only those that this statement stands under are shown
            above.retain(|other: &&crate::outline::Heading| other.level < heading.level);
            above.push(heading);
        }
        for heading in above {
            let command = if heading.level == 2 { "section" } else { "subsection" };
            let _ = writeln!(out, "\\{command}*{{{}}}\n", escape(&heading.title));
        }
        statement(&mut out, &entry, &names);
        if entry.is_claim() && !report.judges.is_empty() {
            let links = entry.judgement.links.len();
            let told =
                |judge: &Judge| format!("{}: {}.", judge.name, judges::on(judge, index, links));
            let told: Vec<String> = report.judges.iter().map(told).collect();
            let _ = writeln!(out, "\\par{{\\small {}}}\n", escape(&told.join(" ")));
        }
    }
    let _ = writeln!(
        out,
        "\\bigskip\\hrule\\medskip\n\\footnotesize kane {}: \\texttt{{{}}}\\\\\n\
         {}, {} bytes, SHA-256 \\texttt{{{}}}\n\\end{{document}}",
        env!("CARGO_PKG_VERSION"),
        escape(&report.command),
        escape(&document.name),
        document.text.len(),
        document.sha256()
    );
    out
}

fn statement(out: &mut String, entry: &Entry<'_>, names: &Names<'_>) {
    let judgement = entry.judgement;
    let kind = match entry.kind() {
        "let" => "Definition",
        "given" => "Premise",
        _ => "Claim",
    };
    let said = match entry.formula() {
        Some(formula) => format!("$\\displaystyle {}$", formula.replace(":=", "\\mathrel{:=}")),
        None => match entry.denied() {
            Some(denied) => {
                format!("{} does not follow.", escape(&entry.labels(&[denied]).join("")))
            }
            None => "The premises contradict each other.".to_owned(),
        },
    };
    let label = match entry.claim() {
        Some(_) | None if entry.kind() != "let" => escape(&entry.statement.label),
        // a definition goes by its name, which the formula begins with
        _ => String::new(),
    };
    let _ = writeln!(out, "\\statement{{{kind}}}{{{label}}}{{{said}}}");
    let Some(claim) = entry.claim() else {
        out.push('\n');
        return;
    };
    if !claim.from.is_empty() {
        let _ = writeln!(out, "From {}.", escape(&entry.labels(&claim.from).join(", ")));
    }
    let mut verdict = judgement.verdict.to_string();
    for remark in entry.expectation().into_iter().chain(entry.support()) {
        let _ = write!(verdict, ", {remark}");
    }
    if judgement.verdict != Verdict::Proved || !judgement.as_expected() {
        let _ = writeln!(out, "\\emph{{{}.}}", escape(&capitalised(&verdict)));
    }
    let count = judgement.links.len();
    for (number, link) in judgement.links.iter().enumerate() {
        let head = evidence(if count > 1 { link.verdict } else { judgement.verdict });
        if count > 1 {
            let _ = writeln!(
                out,
                "\\evidence{{{head}, part {} of {count}}} $\\displaystyle {}$.",
                number + 1,
                link.latex
            );
        } else {
            let _ = writeln!(out, "\\evidence{{{head}}}");
        }
        write_link(out, entry, link, names);
    }
    let mut ground = Vec::new();
    if !judgement.rests_on.is_empty() {
        ground.push(format!("Rests on {}.", entry.labels(&judgement.rests_on).join(", ")));
    }
    if judgement.verdict == Verdict::Proved && judgement.model.is_none() {
        ground.push("No model of its hypotheses was found.".to_owned());
    }
    if !ground.is_empty() {
        let _ = writeln!(out, "\\par{{\\small {}}}", escape(&ground.join(" ")));
    }
    out.push('\n');
}

fn write_link(out: &mut String, entry: &Entry<'_>, link: &LinkJudgement, names: &Names<'_>) {
    let _ = writeln!(out, "{}.", sentence(&capitalised(&link.reason), names));
    for step in link.steps.told() {
        let indent = format!("{}em", 1 + step.depth.min(8));
        for line in step.text.lines() {
            let _ = writeln!(out, "\\step{{{indent}}}{{{}}}", sentence(line, names));
        }
    }
    if let Some(certificate) = &link.certificate {
        let uses = match &link.used[..] {
            [] => String::new(),
            used => format!("Uses {}. ", escape(&entry.labels(used).join(", "))),
        };
        let square = if link.verdict == Verdict::Proved { "\\qed" } else { "" };
        let _ =
            writeln!(out, "\\par{{\\small {uses}Certificate \\texttt{{{certificate}}}{square}}}");
    }
}

/// The sentence with its names, operators and powers in math mode.
fn sentence(text: &str, names: &Names<'_>) -> String {
    let mut out = String::with_capacity(2 * text.len());
    for piece in names.pieces(text) {
        match piece {
            Piece::Text(text) => out.push_str(&escape(text)),
            Piece::Name(name) => _ = write!(out, "${}$", latex_name(name)),
            Piece::Power(digits) => _ = write!(out, "$^{{{digits}}}$"),
            Piece::Operator(operator) => out.push_str(match operator {
                "*" => "$\\cdot$\\allowbreak{}",
                "-" => "$-$",
                "<=" => "$\\le$",
                ">=" => "$\\ge$",
                "!=" => "$\\ne$",
                "->" => "$\\to$",
                "<" => "$<$",
                ">" => "$>$",
                _ => "$\\infty$",
            }),
        }
    }
    out
}

/// Digits in a row after which a number may be broken at the end of a line.
const DIGITS: usize = 12;

/// The text as it is, also where it has characters that LaTeX would read, or that its fonts lack.
fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut digits = 0;
    for c in text.chars() {
        digits = if c.is_ascii_digit() { digits + 1 } else { 0 };
        if digits > DIGITS {
            out.push_str("\\allowbreak{}");
            digits = 1;
        }
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => {
                out.push('\\');
                out.push(c);
            }
            '^' => out.push_str("\\textasciicircum{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '<' => out.push_str("$<$"),
            '>' => out.push_str("$>$"),
            '|' => out.push_str("$|$"),
            '"' => out.push_str("''"),
            '\n' | '\t' => out.push(' '),
            c if c.is_ascii() && !c.is_ascii_control() => out.push(c),
            c => out.push_str(&beyond_ascii(c)),
        }
    }
    out
}

/// A character that the fonts of LaTeX have in math mode alone, if at all.
fn beyond_ascii(c: char) -> String {
    let written = c.to_string();
    let canonical = canonical_name(&written);
    if greek_letter(&canonical).is_some() {
        return format!("${}$", latex_name(&canonical));
    }
    let known = match c {
        '–' => "--",
        '—' => "---",
        '’' => "'",
        '‘' => "`",
        '“' => "``",
        '”' => "''",
        '…' => "\\dots{}",
        '′' => "$'$",
        '×' => "$\\times$",
        '·' => "$\\cdot$",
        '−' => "$-$",
        '≤' => "$\\le$",
        '≥' => "$\\ge$",
        '≠' => "$\\ne$",
        '→' => "$\\to$",
        '∞' => "$\\infty$",
        '°' => "$^\\circ$",
        '²' => "$^2$",
        '³' => "$^3$",
        // the letters of Latin-1 are in every font
        'À'..='ÿ' => return written,
        _ => return format!("[U+{:04X}]", u32::from(c)),
    };
    known.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_character_of_a_text_becomes_a_command() {
        assert_eq!(escape(r"a_b \x {50%} #1 & $"), r"a\_b \textbackslash{}x \{50\%\} \#1 \& \$");
        assert_eq!(escape("μ ≤ é 漢"), "$\\mu$ $\\le$ é [U+6F22]");
        assert_eq!(escape("a\u{1b}[8m\tb\u{9b}"), "a[U+001B][8m b[U+009B]");
        assert_eq!(escape("1234567890123"), "123456789012\\allowbreak{}3");
    }
}
