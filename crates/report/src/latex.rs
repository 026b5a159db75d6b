//! The report for print: an appendix of claims, each with its proof or counterexample.

use std::fmt::Write as _;

use kane_audit::{LinkJudgement, Verdict};
use kane_judges::Judge;

use crate::breakable::breakable;
use crate::judges;
use crate::markdown::capitalised;
use crate::outline::headings;
use crate::report::Entry;
use crate::tex::{escape, whole};
use crate::wording::evidence;
use crate::words::{Form, Line};
use crate::{Report, Summary};

/// Formulas stand in lines of text, where TeX may break them; nothing is hyphenated, and a line may be short.
const PREAMBLE: &str = r"\documentclass[11pt]{article}
\usepackage[utf8]{inputenc}
\usepackage{amsmath,amssymb}
\usepackage[margin=30mm]{geometry}
\usepackage[hidelinks]{hyperref}
\setlength{\parindent}{0pt}
\setlength{\parskip}{0.5\baselineskip plus 2pt}
\raggedright
\relpenalty=100 \binoppenalty=200 \emergencystretch=3em
\newsavebox{\said}
\makeatletter
\newcommand{\anchor}[2]{\phantomsection\def\@currentlabel{#2}\label{#1}}
\newcommand{\statement}[4]{\pagebreak[2]\medskip\par\sbox{\said}{$\displaystyle #4$}%
  \ifdim\wd\said<.75\linewidth\relax
    \textbf{#1}\nopagebreak\begin{equation*}#4\tag*{#3}\label{#2}\end{equation*}%
  \else\anchor{#2}{#3}\textbf{#1 #3}\quad$\displaystyle #4$\par\fi}
\makeatother
\newcommand{\evidence}[1]{\par\nopagebreak\textit{#1.}\enspace}
\newcommand{\step}[2]{\par\vspace{-\parskip}\hangindent=\dimexpr#1\relax\advance\hangindent by 1.5em\hangafter=1\hspace*{#1}#2}
\newcommand{\qed}{\hfill\ensuremath{\square}}
";

/// The report as a document for LaTeX, which needs `amsmath`, `amssymb`, `geometry` and `hyperref` alone.
///
/// A statement that is short enough is a displayed formula with its label as its tag. Each can be referred to: the one at
/// index 4 of the document as `\ref{s:4}`, which prints its label.
///
/// Section by section it states what is assumed and claimed; a proof ends in a square, and what is refuted is
/// followed by its counterexample. Equal reports give equal bytes.
#[must_use]
pub fn latex(report: &Report<'_>) -> String {
    let document = &report.audit.document;
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
        statement(&mut out, index, &entry);
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
    breakable(&out)
}

/// References to the statements at these indices.
fn references(indices: &[usize]) -> String {
    let all: Vec<String> = indices.iter().map(|index| format!("\\ref{{s:{index}}}")).collect();
    all.join(", ")
}

fn statement(out: &mut String, index: usize, entry: &Entry<'_>) {
    let judgement = entry.judgement;
    let kind = match entry.kind() {
        "let" => "Definition",
        "given" => "Premise",
        _ => "Claim",
    };
    let said = match entry.formula() {
        Some(formula) => formula.replace(":=", "\\mathrel{:=}"),
        None => match entry.denied() {
            Some(denied) => {
                format!("\\text{{{} does not follow.}}", escape(&entry.labels(&[denied]).join("")))
            }
            None if !entry.is_contradiction() => format!("\\texttt{{{}}}", escape(&entry.saying())),
            None => "\\text{The premises contradict each other.}".to_owned(),
        },
    };
    let label = escape(&entry.statement.label);
    let _ = writeln!(out, "\\statement{{{kind}}}{{s:{index}}}{{{label}}}{{{said}}}");
    let Some(claim) = entry.claim() else {
        out.push('\n');
        return;
    };
    if !claim.from.is_empty() {
        let _ = writeln!(out, "From {}.", references(&claim.from));
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
                entry.link_latex(number)
            );
        } else {
            let _ = writeln!(out, "\\evidence{{{head}}}");
        }
        write_link(out, entry, link);
    }
    let mut ground = Vec::new();
    if !judgement.rests_on.is_empty() {
        ground.push(format!("Rests on {}.", references(&judgement.rests_on)));
    }
    if judgement.verdict == Verdict::Proved && judgement.met.is_none() {
        ground.push("No model of its hypotheses was found.".to_owned());
    }
    if !ground.is_empty() {
        let _ = writeln!(out, "\\par{{\\small {}}}", ground.join(" "));
    }
    out.push('\n');
}

fn write_link(out: &mut String, entry: &Entry<'_>, link: &LinkJudgement) {
    let _ = writeln!(out, "{}.", capitalised(&whole(&entry.reason(link, Form::Latex))));
    for Line { depth, text, folded } in entry.steps(link, Form::Latex) {
        let small = if folded { "\\footnotesize " } else { "" };
        let _ = writeln!(out, "\\step{{{}em}}{{{small}{}}}", 1 + depth.min(8), whole(&text));
    }
    if let Some(certificate) = &link.certificate {
        let uses = match &link.used[..] {
            [] => String::new(),
            used => format!("Uses {}. ", references(used)),
        };
        let square = if link.verdict == Verdict::Proved { "\\qed" } else { "" };
        let _ =
            writeln!(out, "\\par{{\\small {uses}Certificate \\texttt{{{certificate}}}{square}}}");
    }
}
