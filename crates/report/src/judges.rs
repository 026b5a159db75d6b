//! What other judges answer to the claims of an audit, beside the kernel's verdicts.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use kane_audit::Audit;
use kane_judges::{Answer, Judge};
use serde::Serialize;

/// The answer to a link, in a word, and why.
fn told(judge: &Judge, place: (usize, usize)) -> (&'static str, &str) {
    judge.answers.get(&place).map_or(("not checked", ""), |a| (word(a), why(a)))
}

/// The answers to all links of a statement, `agrees` or `2 agrees, 1 not asked`, then why not.
pub(crate) fn on(judge: &Judge, statement: usize, links: usize) -> String {
    let answers: Vec<_> = (0..links).map(|link| told(judge, (statement, link))).collect();
    let mut words: Vec<(&str, usize)> = Vec::new();
    let mut reasons: Vec<&str> = Vec::new();
    for (word, why) in answers {
        match words.iter_mut().find(|(known, _)| *known == word) {
            Some((_, count)) => *count += 1,
            None => words.push((word, 1)),
        }
        if !why.is_empty() && !reasons.contains(&why) {
            reasons.push(why);
        }
    }
    let words: Vec<String> = match words.as_slice() {
        [(word, _)] => vec![(*word).to_owned()],
        several => several.iter().map(|(word, count)| format!("{count} {word}")).collect(),
    };
    let reasons = reasons.iter().map(|why| why.split_whitespace().collect::<Vec<_>>().join(" "));
    let parts: Vec<String> = std::iter::once(words.join(", ")).chain(reasons).collect();
    parts.join("; ")
}

/// `Coq: 205 agree, 3 not asked`
pub(crate) fn headline(judge: &Judge) -> String {
    if !judge.asked {
        return format!("{}: NOT CHECKED, it is not installed", judge.name);
    }
    let count = |wanted: fn(&Answer) -> bool| judge.answers.values().filter(|a| wanted(a)).count();
    let told = [
        (count(|a| matches!(a, Answer::Disagrees(_))), "DISAGREE"),
        (count(|a| matches!(a, Answer::Agrees)), "agree"),
        (count(|a| matches!(a, Answer::Partly(_))), "agree in part"),
        (count(|a| matches!(a, Answer::Undecided(_))), "undecided"),
        (count(|a| matches!(a, Answer::NotAsked(_))), "not asked"),
    ];
    let parts: Vec<String> =
        told.iter().filter(|t| t.0 > 0).map(|(n, what)| format!("{n} {what}")).collect();
    let axioms = match judge.axioms.as_slice() {
        [] => String::new(),
        some => format!("; rests on {}", some.join(", ")),
    };
    format!("{}: {}{axioms}", judge.name, parts.join(", "))
}

fn word(answer: &Answer) -> &'static str {
    match answer {
        Answer::Agrees => "agrees",
        Answer::Partly(_) => "agrees in part",
        Answer::Disagrees(_) => "DISAGREES",
        Answer::Undecided(_) => "undecided",
        Answer::NotAsked(_) => "not asked",
    }
}

fn why(answer: &Answer) -> &str {
    match answer {
        Answer::Agrees => "",
        Answer::Partly(why) | Answer::Disagrees(why) => why,
        Answer::Undecided(why) | Answer::NotAsked(why) => why,
    }
}

/// The answers as text: a line a judge, then every link on which one does not agree.
#[must_use]
pub fn text(audit: &Audit, judges: &[Judge]) -> String {
    let mut out = String::new();
    for judge in judges {
        let _ = writeln!(out, "{}", headline(judge));
        for (place, answer) in &judge.answers {
            if *answer != Answer::Agrees {
                let _ = writeln!(
                    out,
                    "  {:10} {}: {}",
                    word(answer),
                    claim(audit, *place),
                    why(answer)
                );
            }
        }
    }
    out
}

/// The answers as a table in Markdown, one row a link and one column a judge.
pub(crate) fn markdown(audit: &Audit, judges: &[Judge]) -> String {
    let mut out = "## Other judges\n".to_owned();
    let names: Vec<&str> = judges.iter().map(|j| j.name.as_str()).collect();
    let _ = writeln!(out, "\n| claim | kernel | {} |", names.join(" | "));
    let _ = writeln!(out, "|---|---|{}", "---|".repeat(judges.len()));
    for (statement, judgement) in audit.judgements.iter().enumerate() {
        for (link, judged) in judgement.links.iter().enumerate() {
            let cells: Vec<&str> = judges.iter().map(|j| told(j, (statement, link)).0).collect();
            let said = claim(audit, (statement, link)).replace('|', "\\|");
            let _ = writeln!(out, "| {said} | {} | {} |", judged.verdict, cells.join(" | "));
        }
    }
    out.push('\n');
    out
}

/// The answers for programs.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(crate) struct Answers<'a> {
    document: &'a str,
    summary: BTreeMap<&'a str, String>,
    links: Vec<Row<'a>>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Row<'a> {
    label: &'a str,
    link: usize,
    verdict: String,
    answers: BTreeMap<&'a str, Told<'a>>,
}

#[derive(Debug, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct Told<'a> {
    answer: &'a str,
    reason: &'a str,
}

/// The answers of judges to one audit, for programs.
pub(crate) fn answers<'a>(audit: &'a Audit, judges: &'a [Judge]) -> Answers<'a> {
    let mut links = Vec::new();
    for (statement, judgement) in audit.judgements.iter().enumerate() {
        for (link, judged) in judgement.links.iter().enumerate() {
            let told = |j: &'a Judge| {
                let (answer, reason) = told(j, (statement, link));
                Told { answer, reason }
            };
            links.push(Row {
                label: &audit.document.statements[statement].label,
                link: link + 1,
                verdict: judged.verdict.to_string(),
                answers: judges.iter().map(|j| (j.name.as_str(), told(j))).collect(),
            });
        }
    }
    let summary = judges.iter().map(|j| (j.name.as_str(), headline(j))).collect();
    Answers { document: &audit.document.name, summary, links }
}

fn claim(audit: &Audit, (statement, link): (usize, usize)) -> String {
    let label = &audit.document.statements[statement].label;
    match audit.judgements[statement].links.len() {
        1 => label.clone(),
        _ => format!("{label}, link {}", link + 1),
    }
}

#[cfg(test)]
mod tests {
    use kane_audit::{Options, audit, read};

    use super::*;

    #[test]
    fn as_text_each_judge_has_a_line_and_each_answer_that_does_not_agree() {
        let text_of =
            b"```kane\nvar x\nclaim a: x^2 >= 0\nclaim b: x^2 + 1 > 0, x^2 + 2 > 1\n```\n";
        let document = read("judges.md", text_of).expect("it is well formed");
        let audit = audit(document, &Options::default(), &mut |_, _| {});
        let judge = |name: &str, answers: [Answer; 3]| Judge {
            name: name.to_owned(),
            asked: true,
            answers: [(0, 0), (1, 0), (1, 1)].into_iter().zip(answers).collect(),
            axioms: Vec::new(),
        };
        let no = || Answer::Disagrees("x = 0".to_owned());
        let late = || Answer::Undecided("late".to_owned());
        let judges = [
            judge("z3", [Answer::Agrees, Answer::Agrees, no()]),
            judge("Coq", [late(), late(), late()]),
            Judge { name: "third".to_owned(), ..Judge::default() },
        ];
        let told = text(&audit, &judges);
        let lines: Vec<String> =
            told.lines().map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
        assert_eq!(
            lines,
            [
                "z3: 1 DISAGREE, 2 agree",
                "DISAGREES b, link 2: x = 0",
                "Coq: 3 undecided",
                "undecided a: late",
                "undecided b, link 1: late",
                "undecided b, link 2: late",
                "third: NOT CHECKED, it is not installed",
            ]
        );
        // three links of which two fare alike
        let mixed = judge("z3", [no(), Answer::Agrees, Answer::Agrees]);
        assert_eq!(on(&mixed, 1, 2), "agrees");
        let mixed = judge("z3", [no(), Answer::Agrees, late()]);
        assert_eq!(on(&mixed, 1, 2), "1 agrees, 1 undecided; late");
        assert_eq!(on(&mixed, 0, 1), "DISAGREES; x = 0");
        let mut three = judge("z3", [late(), late(), late()]);
        three.answers.insert((1, 2), Answer::Agrees);
        assert_eq!(on(&three, 1, 3), "2 undecided, 1 agrees; late");
        let rows = answers(&audit, &judges);
        let told: Vec<(&str, usize, &str)> =
            rows.links.iter().map(|row| (row.label, row.link, row.answers["z3"].answer)).collect();
        assert_eq!(told, [("a", 1, "agrees"), ("b", 1, "agrees"), ("b", 2, "DISAGREES")]);
    }
}
