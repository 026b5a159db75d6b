//! What other judges answer to the claims of an audit, beside the kernel's verdicts.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use kane_audit::Audit;
use serde::Serialize;

/// A judge's answer to one link of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// it comes to the same finding
    Agrees,
    /// it agrees on the claim as it follows from what it cites, but was not asked whether that follows
    /// from the givens: why
    Partly(String),
    /// it comes to another one, or rejects the proof: what it said
    Disagrees(String),
    /// it came to no finding: why
    Undecided(String),
    /// the question was not put to it: why
    NotAsked(String),
}

/// The answers of one judge, by statement and link.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Judge {
    /// its name
    pub name: String,
    /// what it answers; empty if it is not installed
    pub answers: BTreeMap<(usize, usize), Answer>,
    /// whether it was there to be asked
    pub asked: bool,
    /// what its proofs rest on, where it says so
    pub axioms: Vec<String>,
}

impl Judge {
    /// Whether no answer disagrees.
    #[must_use]
    pub fn agrees(&self) -> bool {
        !self.answers.values().any(|a| matches!(a, Answer::Disagrees(_)))
    }

    fn count(&self, wanted: impl Fn(&Answer) -> bool) -> usize {
        self.answers.values().filter(|a| wanted(a)).count()
    }

    /// The answer to a link, in a word, and why.
    fn told(&self, place: (usize, usize)) -> (&'static str, &str) {
        self.answers.get(&place).map_or(("not checked", ""), |a| (a.word(), a.why()))
    }

    /// The answers to all links of a statement, `agrees` or `2 agrees, 1 not asked`, then why not.
    pub(crate) fn on(&self, statement: usize, links: usize) -> String {
        let told: Vec<_> = (0..links).map(|link| self.told((statement, link))).collect();
        let mut words: Vec<(&str, usize)> = Vec::new();
        let mut reasons: Vec<&str> = Vec::new();
        for (word, why) in told {
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
        let reasons =
            reasons.iter().map(|why| why.split_whitespace().collect::<Vec<_>>().join(" "));
        let parts: Vec<String> = std::iter::once(words.join(", ")).chain(reasons).collect();
        parts.join("; ")
    }

    /// Whether an answer to the statement disagrees.
    pub(crate) fn disagrees_on(&self, statement: usize) -> bool {
        let answers = self.answers.range((statement, 0)..(statement + 1, 0));
        answers.into_iter().any(|(_, answer)| matches!(answer, Answer::Disagrees(_)))
    }

    /// `Coq: 205 agree, 3 not asked`
    pub(crate) fn headline(&self) -> String {
        if !self.asked {
            return format!("{}: NOT CHECKED, it is not installed", self.name);
        }
        let told = [
            (self.count(|a| matches!(a, Answer::Disagrees(_))), "DISAGREE"),
            (self.count(|a| matches!(a, Answer::Agrees)), "agree"),
            (self.count(|a| matches!(a, Answer::Partly(_))), "agree in part"),
            (self.count(|a| matches!(a, Answer::Undecided(_))), "undecided"),
            (self.count(|a| matches!(a, Answer::NotAsked(_))), "not asked"),
        ];
        let parts: Vec<String> =
            told.iter().filter(|t| t.0 > 0).map(|(n, what)| format!("{n} {what}")).collect();
        let axioms = match self.axioms.as_slice() {
            [] => String::new(),
            some => format!("; rests on {}", some.join(", ")),
        };
        format!("{}: {}{axioms}", self.name, parts.join(", "))
    }
}

impl Answer {
    fn word(&self) -> &'static str {
        match self {
            Self::Agrees => "agrees",
            Self::Partly(_) => "agrees in part",
            Self::Disagrees(_) => "DISAGREES",
            Self::Undecided(_) => "undecided",
            Self::NotAsked(_) => "not asked",
        }
    }

    fn why(&self) -> &str {
        match self {
            Self::Agrees => "",
            Self::Partly(why) | Self::Disagrees(why) => why,
            Self::Undecided(why) | Self::NotAsked(why) => why,
        }
    }
}

/// The answers as text: a line a judge, then every link on which one does not agree.
#[must_use]
pub fn text(audit: &Audit, judges: &[Judge]) -> String {
    let mut out = String::new();
    for judge in judges {
        let _ = writeln!(out, "{}", judge.headline());
        for (place, answer) in &judge.answers {
            if *answer != Answer::Agrees {
                let _ = writeln!(
                    out,
                    "  {:10} {}: {}",
                    answer.word(),
                    claim(audit, *place),
                    answer.why()
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
            let cells: Vec<&str> = judges.iter().map(|j| j.told((statement, link)).0).collect();
            let said = claim(audit, (statement, link)).replace('|', "\\|");
            let _ = writeln!(out, "| {said} | {} | {} |", judged.verdict, cells.join(" | "));
        }
    }
    out.push('\n');
    out
}

/// The answers for programs.
#[derive(Debug, Serialize)]
pub(crate) struct Answers<'a> {
    document: &'a str,
    summary: BTreeMap<&'a str, String>,
    links: Vec<Row<'a>>,
}

#[derive(Debug, Serialize)]
struct Row<'a> {
    label: &'a str,
    link: usize,
    verdict: String,
    answers: BTreeMap<&'a str, Told<'a>>,
}

#[derive(Debug, Serialize)]
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
                let (answer, reason) = j.told((statement, link));
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
    let summary = judges.iter().map(|j| (j.name.as_str(), j.headline())).collect();
    Answers { document: &audit.document.name, summary, links }
}

fn claim(audit: &Audit, (statement, link): (usize, usize)) -> String {
    let label = &audit.document.statements[statement].label;
    match audit.judgements[statement].links.len() {
        1 => label.clone(),
        _ => format!("{label}, link {}", link + 1),
    }
}
