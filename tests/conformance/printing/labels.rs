//! Labels, titles and prose that try to speak for the auditor in the notation of a report.

use kane::audit::{Audit, Options, audit, read};
use kane::judges::{Claims, coq, smt};
use kane::report::{Report, html, json, latex, markdown};

use crate::support::installed;

/// What may stand between the parentheses of a label, and in a heading.
const NASTY: [&str; 14] = [
    r"x *",
    r"\end{document} proved",
    r"a % b",
    r"$x = 1$ & {",
    r"}} \input{/etc/passwd}",
    r"</title><script>alert",
    r#"a" onclick="b"#,
    r"<!-- -->",
    r"| sat ; unsat",
    r#""open string"#,
    r"`code` **proved** [x]",
    r"a_b ^ c ~ d \\",
    r"' { } @ ?",
    r"&lt;b&gt; &amp;",
];

fn document() -> Audit {
    let mut text = "# T \\end{document} <script> *) \"\n\n```kane\nvar x > 0\n".to_owned();
    for label in NASTY {
        text.push_str(&format!(
            "claim ({label}): x + 1 > 0\nclaim (r {label}): x > 1 expect refuted\n"
        ));
    }
    text.push_str("```\n\n");
    for label in NASTY {
        text.push_str(&format!("## H {label}\n\nProse {label}.\n\n"));
    }
    let document = read("a*) \\end{b} <i>.md", text.as_bytes()).unwrap_or_else(|faults| {
        unreachable!("{}", faults.iter().map(ToString::to_string).collect::<String>())
    });
    let audit = audit(document, &Options::default(), &mut |_, _| {});
    assert!(audit.as_expected());
    audit
}

/// Coq's text without its comments, in which strings hide what ends them; an open comment is an error.
fn without_comments(text: &str) -> Result<String, String> {
    let (mut out, mut depth, mut string) = (String::new(), 0, false);
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let step = match () {
            () if string => {
                string = c != '"';
                c.len_utf8()
            }
            () if rest.starts_with("(*") => {
                depth += 1;
                2
            }
            () if depth > 0 && rest.starts_with("*)") => {
                depth -= 1;
                2
            }
            () if rest.starts_with("*)") => {
                return Err("a comment ends that never began".to_owned());
            }
            () => {
                string = depth > 0 && c == '"';
                if depth == 0 {
                    out.push(c);
                }
                c.len_utf8()
            }
        };
        rest = &rest[step..];
    }
    if depth == 0 && !string { Ok(out) } else { Err("a comment or string is left open".to_owned()) }
}

#[test]
fn coq_reads_no_label_as_its_own() {
    let audit = document();
    let file = coq::file(&Claims::of(&audit));
    let code = without_comments(&file.text()).expect("all comments end");
    for word in ["script", "passwd", "unsat", "onclick", "string"] {
        let outside = |line: &&str| line.contains(word) && !line.contains("claim_");
        let names = |line: &str| {
            ["goal_", "proof_", "witness_", "theorem_"].iter().any(|name| line.contains(name))
        };
        assert_eq!(code.lines().filter(outside).find(|line| !names(line)), None, "{word}");
    }
    let lemmas = code.matches("\nLemma claim_").count();
    assert_eq!(lemmas, 2 * NASTY.len(), "one lemma a claim");
    if installed("coqc") {
        let judge = crate::judges::coq(&file);
        assert!(judge.agrees(), "{:?}", judge.answers);
    }
}

#[test]
fn questions_and_their_files_hold_nothing_of_a_label() {
    let audit = document();
    for (name, question) in smt::questions(&Claims::of(&audit)) {
        let safe = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\'';
        assert!(name.chars().all(safe), "{name}");
        let read = crate::smt::Question::read(&question.text);
        assert_eq!(read.expect("well formed").declared, ["|x|"]);
    }
}

/// LaTeX as the characters that it prints, commands that print none left out; an active character is an
/// error.
fn printed(tex: &str) -> Result<String, String> {
    let mut out = String::new();
    let mut rest = tex;
    while let Some(c) = rest.chars().next() {
        let known = [
            (r"\textbackslash{}", "\\"),
            (r"\textasciicircum{}", "^"),
            (r"\textasciitilde{}", "~"),
            ("$<$", "<"),
            ("$>$", ">"),
            ("$|$", "|"),
            ("''", "\""),
            (r"\{", "{"),
            (r"\}", "}"),
            (r"\$", "$"),
            (r"\&", "&"),
            (r"\#", "#"),
            (r"\%", "%"),
            (r"\_", "_"),
        ];
        if let Some((written, shown)) = known.iter().find(|(written, _)| rest.starts_with(written))
        {
            out.push_str(shown);
            rest = &rest[written.len()..];
        } else if "\\{}$&#%_^~".contains(c) {
            return Err(format!("{c} in {tex}"));
        } else {
            out.push(c);
            rest = &rest[c.len_utf8()..];
        }
    }
    Ok(out)
}

#[test]
fn latex_prints_labels_and_headings_as_they_are() {
    let audit = document();
    let tex = latex(&Report::new(&audit, "kane audit"));
    assert_eq!(tex.matches("\\end{document}").count(), 1);
    let labels: Vec<String> = tex
        .lines()
        .filter_map(|line| line.strip_prefix("\\statement{Claim}{s:")?.split_once("}{"))
        .map(|(_, rest)| rest.split("}{").next().unwrap_or_default().to_owned())
        .collect();
    assert_eq!(labels.len(), 2 * NASTY.len());
    for (label, statement) in labels.iter().zip(&audit.document.statements) {
        assert_eq!(printed(label).as_ref(), Ok(&statement.label));
    }
    assert!(printed(r"\end{document}").is_err() && printed("50% off").is_err());
}

#[test]
fn pages_show_labels_and_prose_as_they_are() {
    let audit = document();
    let page = html(&Report::new(&audit, "kane audit"));
    assert_eq!(page.matches("<script").count(), 1, "the page's own");
    let tags = page.split('<').skip(1).filter_map(|piece| piece.split('>').next());
    assert!(tags.into_iter().all(|tag| !tag.contains("onclick=\"")));
    assert!(!page.contains("<i>.md"));
    let unescaped = |text: &str| {
        let text = text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"");
        text.replace("&amp;", "&")
    };
    let heads = page.split("role=\"heading\"").skip(1);
    for (head, statement) in heads.zip(&audit.document.statements) {
        let link = head.split("</a>").next().unwrap_or_default();
        let shown = link.rsplit('>').next().unwrap_or_default();
        assert_eq!(unescaped(shown), statement.label);
    }
    let marked = markdown(&Report::new(&audit, "kane audit"));
    let headings = marked.lines().filter(|line| line.starts_with("## "));
    assert!(headings.clone().count() >= 2 * NASTY.len());
    assert!(headings.into_iter().all(|line| !line.contains('<') && !line.contains("**")));
    let data: serde_json::Value =
        serde_json::from_str(&json(&[Report::new(&audit, "kane audit")])).expect("well formed");
    assert!(data.is_object() || data.is_array());
}
