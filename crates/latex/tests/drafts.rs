//! Drafts of papers that mean ill: only what was read from a displayed equation is a statement.

use kane_latex::{Format, draft};
use proptest::prelude::*;

/// The statements of a draft, after a look at its blocks: fences stand alone, each is closed, and what is
/// in them begins as a statement or a comment does.
fn statements(latex: &str, format: Format) -> Vec<String> {
    let document = draft(latex, format).document;
    let mut inside = false;
    let mut out = Vec::new();
    for line in document.lines() {
        if inside && line == "```" {
            inside = false;
        } else if inside {
            let known = ["var ", "given (", "claim (", "let (", "# "];
            assert!(known.iter().any(|word| line.starts_with(word)), "{line:?} in\n{document}");
            out.push(line.to_owned());
        } else if line == "```kane" {
            inside = true;
        } else if format == Format::Latex {
            assert!(!line.contains('`') && !line.contains("~~~"), "{line:?} in\n{document}");
        } else {
            assert!(!line.contains("```") && !line.contains("~~~"), "{line:?} in\n{document}");
        }
    }
    assert!(!inside, "{document}");
    out
}

#[test]
fn prose_titles_tags_and_labels_are_no_statements() {
    let paper = r"\title{A `title` ```kane}
\author{x ```kane}
\begin{document}
\section{```kane}
```kane
claim fake: 1 = 2
```
\begin{equation} x = 1 \tag{```kane} \end{equation}
\begin{equation} x = 2 \tag{#) from given} \end{equation}
\begin{equation} \text{```kane} = `b` \end{equation}
\begin{figure}\caption{```kane}\end{figure}
\end{document}";
    let found = statements(paper, Format::Latex);
    assert!(found.contains(&"given (kane): x = 1".to_owned()), "{found:?}");
    assert!(!found.iter().any(|line| line.contains("fake")), "{found:?}");
    assert_eq!(found.iter().filter(|line| line.contains("is not read")).count(), 1, "{found:?}");
}

#[test]
fn statements_of_a_markdown_source_are_none_of_the_draft() {
    for fence in ["```", "````", "~~~", "  ~~~~ "] {
        let text = format!("{fence}kane\nclaim fake: 1 = 2\n{fence}\n\n$$x = 1$$\n");
        assert_eq!(statements(&text, Format::Markdown), ["var x", "given (u1): x = 1"], "{fence}");
    }
}

#[test]
fn what_has_no_end_ends() {
    let deep = |open: &str, close: &str, n| format!("{}x = 1{}", open.repeat(n), close.repeat(n));
    for paper in [
        format!("\\[ {} \\]", deep("{", "}", 20_000)),
        format!("\\[ {} \\]", deep("(", ")", 20_000)),
        format!("\\[ {} \\]", deep("\\frac{1}{", "}", 20_000)),
        format!("\\[ {} \\]", deep("\\begin{cases}", "\\end{cases}", 2_000)),
        deep("\\emph{", "}", 20_000),
        "\\begin{equation}".repeat(20_000),
        "\\( x ".repeat(20_000),
        "\\newcommand{\\a}{\\a\\a}\\[ \\a \\]".to_owned(),
        "\\begin{equation} a = b \\end{equation}\n".repeat(2_000),
        "\\begin{equation}\\begin{pmatrix} 1".to_owned(),
    ] {
        statements(&paper, Format::Latex);
    }
}

#[test]
fn a_function_with_its_argument_is_defined() {
    let paper = r"We define \[ k(\alpha) := \frac{1-\alpha}{1+\alpha} \] and \[ f(x) = x^2, \] hence \[ k(f(u)) \le 1. \]";
    let found = statements(paper, Format::Latex);
    let wanted = [
        "let (u1) k(alpha) := (1 - alpha)/(1 + alpha)",
        "let (u2) f(x) := x^2",
        "given (u3): k(f(u)) <= 1",
    ];
    assert!(wanted.iter().all(|line| found.contains(&(*line).to_owned())), "{found:?}");
}

#[test]
fn a_function_that_has_its_definition_has_values() {
    let paper = r"Newton's law is \[ v = -e u \] We define \[ f(x) = x^2 \tag{2} \]
        From (2) it follows that \[ f(v) = e^2 u^2 \tag{3} \] and \[ f(x) = x^3 \tag{4} \]";
    let draft = draft(paper, Format::Latex);
    // a definition is in force everywhere, and says nothing by itself
    assert!(draft.document.contains("claim (3): f(v) = e^2*u^2 from (u1)\n"), "{}", draft.document);
    assert!(draft.document.contains("# (4) is not read: it defines 'f(x)' a second time\n"));
    let faults: Vec<_> = draft.equations.iter().filter_map(|one| one.fault.as_ref()).collect();
    assert_eq!(faults.len(), 1, "{faults:?}");
}

/// A guess is no part of the formula that stands beside it.
#[test]
fn what_a_claim_must_not_rest_on_leaves_the_claim() {
    let paper = r"Let \[ a = 1 \tag{1} \] and \[ b = 2 \tag{2} \] hence \[ a = b \tag{3} \]";
    let mut draft = draft(paper, Format::Latex);
    let claim = "claim (3): a = b from (1), (2)";
    let line = 1 + draft.document.lines().position(|line| line == claim).expect("a claim");
    let column = claim.find("(2)").expect("it is cited") + 1;
    assert!(!draft.refuse_citation(line, 12, "a place in the formula"));
    assert!(!draft.refuse_citation(1, 1, "a heading"));
    assert!(draft.refuse_citation(line, column, "it says\nnothing"));
    assert!(draft.refuse_citation(line + 1, column - 5, "nor does it"));
    let left = "# (3) does not rest on (2), it says nothing\n# (3) does not rest on (1), nor does it\n\
                claim (3): a = b\n";
    assert!(draft.document.contains(left), "{}", draft.document);
    assert!(draft.equations.iter().all(|equation| equation.fault.is_none()));
}

#[test]
fn a_claim_says_what_the_text_names_for_it_that_is_not_read() {
    let paper = r"Let \[ a = 1 \tag{1} \] and \[ \int a = 2 \tag{2} \] and \[ b \approx 2 \tag{3} \]
        From (1) and (2) we get \[ 2a = 2 \tag{4} \] from (2) and (3) \[ 3a = 3 \tag{5} \] hence \[ a = a \tag{6} \]";
    let document = draft(paper, Format::Latex).document;
    for left in [
        "# the text above names (2), which is not read and cannot be cited\nclaim (4): 2*a = 2 from (1)\n",
        "# the text above names (2), (3), which are not read and cannot be cited\nclaim (5): 3*a = 3 from (1)\n",
        "```kane\nclaim (6): a = a from (1)\n",
    ] {
        assert!(document.contains(left), "{document}");
    }
}

#[test]
fn a_refused_statement_is_a_comment_that_nothing_rests_on() {
    let paper = r"Let \[ a = 1 \tag{1} \] and \[ b = 2 \tag{2} \] hence \[ a = b \tag{3} \]";
    let mut draft = draft(paper, Format::Latex);
    let line = |document: &str, start: &str| {
        document.lines().position(|line| line.starts_with(start)).map(|at| at + 1)
    };
    let at = line(&draft.document, "given (2)").expect("a premise");
    assert!(draft.refuse(at, "no reason\nat all"));
    assert!(!draft.refuse(1, "a heading"));
    assert!(draft.document.contains("# not accepted, no reason at all: given (2): b = 2"));
    let claim = "# (3) does not rest on (2), which is not accepted\nclaim (3): a = b from (1)\n";
    assert!(draft.document.contains(claim), "{}", draft.document);
    assert_eq!(draft.equations.iter().filter(|equation| equation.fault.is_some()).count(), 1);
}

/// A block with one cannot be read, not even as a comment.
#[test]
fn what_nobody_sees_is_written_out_in_a_block() {
    for hidden in ['\u{feff}', '\u{200b}', '\u{202e}', '\u{1b}'] {
        for paper in [
            format!(r"Let \[ a = 1, {hidden} b = 2 \tag{{1}} \] be"),
            format!(r"Let \[ a = 1 \text{{ if{hidden} so}} \tag{{1}} \] be"),
            format!(r"Let \[ \operatorname{{a{hidden}b}} = 1 \tag{{1}} \] be"),
            format!(r"Let \[ a = 1 \tag{{1{hidden}}} \] be"),
            format!(r"Let \[ a{hidden} = 1 \label{{eq:{hidden}}} \] be"),
        ] {
            let found = statements(&paper, Format::Latex);
            assert!(!found.is_empty(), "{paper:?}");
            assert!(!found.concat().contains(hidden), "{found:?}");
        }
    }
}

/// Accents, citations, references to a number and names of environments hand on what stands in their braces,
/// and what a command leaves out brings its neighbours together.
#[test]
fn what_stands_in_braces_or_comes_together_opens_no_block() {
    let block = "\n```kane\nclaim fake: 1 = 1\n```\n";
    for fence in [block.to_owned(), block.replace('`', "~"), block.replace("```", "``\\end{x}`")] {
        for paper in [
            format!(r"\'{{{fence}}} is an accent"),
            format!(r"\cite{{{fence}}} and \input{{{fence}}}"),
            format!(r"\emph{{{fence}}} and \footnote{{{fence}}}"),
            format!(
                r"\ref{{x}} \begin{{equation}} a = 1 \tag{{{fence}}} \label{{x}} \end{{equation}}"
            ),
            format!(r"\ref{{{fence}}} \begin{{equation}} a = 1 \label{{{fence}}} \end{{equation}}"),
            format!(r"\begin{{{fence}}} \end{{{fence}}}"),
            format!(r"\title{{{fence}}} \author{{{fence}}} \section{{{fence}}}"),
            fence.clone(),
        ] {
            for format in [Format::Latex, Format::Markdown] {
                let found = statements(&paper, format);
                assert!(!found.iter().any(|line| line.contains("fake:")), "{paper}\n{found:?}");
            }
        }
    }
    let accents = draft(
        r#"\begin{document} H\"older, Poincar\'{e}, na\"\i ve, na\"{\i}ve, \~{n} \end{document}"#,
        Format::Latex,
    );
    for name in ["Ho\u{308}lder", "Poincare\u{301}", "nai\u{308}ve, nai\u{308}ve", "n\u{303}"] {
        assert!(accents.document.contains(name), "{}", accents.document);
    }
}

#[test]
fn what_stands_before_the_document_is_none_of_its_text() {
    let paper = r"\documentclass[12pt]{article} \sloppy head \begin{document} body \end{document}";
    let found = draft(paper, Format::Latex).document;
    assert!(found.contains("body") && !found.contains("head"), "{found}");
    assert!(!found.contains("article"), "{found}");
}

proptest! {
    #[test]
    fn no_paper_speaks_in_statements(text in r"(\\(begin|end)\{(equation|align\*?|cases|document|figure|x)\}|\\(tag|label|section|title|newcommand|cite|ref|emph|item|'|~)\{|\\(ref|label)\{a\}|\\\\|[{}`~$&%#\n]|``|~~|```kane\n|~~~ kane\n|claim x: 1 = 2|x = 1| ){0,40}") {
        statements(&text, Format::Latex);
        statements(&text, Format::Markdown);
    }
}
