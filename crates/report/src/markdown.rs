//! The report for the web: the document's sections, mathematics in fences, proofs folded away.

use std::fmt::Write as _;

use kane_audit::LinkJudgement;

use crate::judges;
use crate::outline::{Heading, headings};
use crate::report::Entry;
use crate::words::{Form, Line, example};
use crate::{Report, Summary};

/// The report as Markdown.
#[must_use]
pub fn markdown(report: &Report<'_>) -> String {
    let document = &report.audit.document;
    let summary = Summary::of(report);
    let mut out = String::new();
    let _ =
        writeln!(out, "# Audit: {}\n", escape(document.title.as_deref().unwrap_or(&document.name)));
    let _ = writeln!(out, "**{}**\n", escape(&summary.headline()));
    let _ = writeln!(out, "{}.\n", escape(&summary.expectation()));
    for judge in report.judges {
        let _ = writeln!(out, "- {}", escape(&judges::headline(judge)));
    }
    if !report.judges.is_empty() {
        out.push('\n');
    }
    let headings = headings(&document.text);
    let mut headings = headings.iter().peekable();
    let mut level = 1;
    for entry in report.entries() {
        let start = entry.statement.span.start;
        // of the headings above it, those that it stands under
        let mut above: Vec<&Heading> = Vec::new();
        while let Some(heading) = headings.next_if(|heading| heading.start < start) {
            above.retain(|over| over.level < heading.level);
            above.push(heading);
        }
        for heading in above {
            level = usize::from(heading.level);
            let _ = writeln!(out, "{} {}\n", "#".repeat(level), escape(&heading.title));
        }
        section(&mut out, &entry, (level + 1).min(6));
    }
    if !report.judges.is_empty() {
        out.push_str(&judges::markdown(report.audit, report.judges));
    }
    let _ = writeln!(out, "---\n\nkane {}, {}\n", env!("CARGO_PKG_VERSION"), code(&report.command));
    out.truncate(out.trim_end().len());
    out.push('\n');
    out
}

/// One statement, under a heading of this level: what it says, its verdict and reason, what it rests on, and the proof.
fn section(out: &mut String, entry: &Entry<'_>, level: usize) {
    let judgement = entry.judgement;
    let (marks, label) = ("#".repeat(level), escape(&entry.statement.label));
    let _ = write!(out, "{marks} {label} · {}", judgement.verdict);
    if let Some(remark) = entry.expectation() {
        let _ = write!(out, " · *{}*", escape(&remark));
    }
    out.push_str("\n\n");
    if let Some(formula) = entry.formula() {
        let _ = writeln!(out, "{}\n", math(&formula));
    }
    let _ = writeln!(out, "{}\n", code(&entry.source()));
    if let Some(support) = entry.support() {
        let _ = writeln!(out, "{}.\n", escape(&capitalised(&support)));
    }
    for (number, link) in judgement.links.iter().enumerate() {
        if judgement.links.len() > 1 {
            let _ = writeln!(out, "{}\n", math(&entry.link_latex(number)));
        }
        write_link(out, entry, link);
    }
    let mut ground = Vec::new();
    if entry.is_claim() && !judgement.rests_on.is_empty() {
        ground.push(format!("Rests on {}.", escape(&entry.labels(&judgement.rests_on).join(", "))));
    }
    match example(judgement, Form::Plain) {
        Some(example) if !example.is_empty() => {
            let pairs: Vec<_> =
                example.iter().map(|(name, value)| code(&format!("{name} = {value}"))).collect();
            ground.push(format!("The hypotheses hold, for example, at {}.", pairs.join(", ")));
        }
        _ => {}
    }
    if !ground.is_empty() {
        let _ = writeln!(out, "{}\n", ground.join(" "));
    }
}

/// One link: its verdict and reason, with the steps folded away.
fn write_link(out: &mut String, entry: &Entry<'_>, link: &LinkJudgement) {
    let reason = entry.reason(link, Form::Plain);
    let _ = writeln!(out, "**{}**: {}\n", capitalised(&link.verdict.to_string()), escape(&reason));
    let mut notes = Vec::new();
    if !link.used.is_empty() {
        notes.push(format!("Uses {}.", escape(&entry.labels(&link.used).join(", "))));
    }
    if let Some(digest) = &link.certificate {
        notes.push(format!("Certificate {}.", code(digest)));
    }
    let told = entry.steps(link, Form::Plain);
    if !told.is_empty() {
        let _ = writeln!(
            out,
            "<details><summary>Step by step</summary>\n\n{}\n</details>\n",
            steps(&told)
        );
    }
    if !notes.is_empty() {
        let _ = writeln!(out, "{}\n", notes.join(" "));
    }
}

/// The steps, indented by their depth.
fn steps(told: &[Line]) -> String {
    let mut steps = String::new();
    for Line { depth, text, .. } in told {
        let _ = writeln!(steps, "{:indent$}{text}", "", indent = 2 * depth);
    }
    fenced(&steps)
}

/// Lines as they are, in a fence that none of them can close.
pub(crate) fn fenced(lines: &str) -> String {
    let fence = "`".repeat(longest_run(lines, '`').max(2) + 1);
    format!("{fence}text\n{lines}{fence}\n")
}

/// The formula in a fence of its own, on one line: between dollar signs GitHub takes backslashes for its own.
fn math(latex: &str) -> String {
    let latex = latex.split_whitespace().collect::<Vec<_>>().join(" ");
    format!("```math\n{latex}\n```")
}

/// The text as it is, also where it has characters that Markdown or HTML would read.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '\\' | '`' | '*' | '_' | '[' | ']' | '$' | '|' | '~' | '#' => {
                out.push('\\');
                out.push(c);
            }
            '\n' => out.push(' '),
            _ => out.push(c),
        }
    }
    out
}

/// The text as code, on one line.
pub(crate) fn code(text: &str) -> String {
    let text = text.replace('\n', " ");
    let fence = "`".repeat(longest_run(&text, '`') + 1);
    let pad = if text.starts_with('`') || text.ends_with('`') { " " } else { "" };
    format!("{fence}{pad}{text}{pad}{fence}")
}

/// The length of the longest run of `c`.
fn longest_run(text: &str, c: char) -> usize {
    text.split(|other| other != c).map(str::len).max().unwrap_or(0)
}

/// The text with its first letter in upper case.
pub(crate) fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_character_of_a_reason_becomes_markup() {
        assert_eq!(escape("a_b * <c> $d$"), r"a\_b \* &lt;c&gt; \$d\$");
        // what stands for a character in HTML, and a line of its own
        assert_eq!(escape("&lt;\n# a"), r"&amp;lt; \# a");
    }

    #[test]
    fn code_may_contain_backticks() {
        assert_eq!(code("a ` b"), "``a ` b``");
        assert_eq!(code("`a`"), "`` `a` ``");
        assert_eq!([code("`a"), code("a`")], ["`` `a ``", "`` a` ``"]);
    }
}
