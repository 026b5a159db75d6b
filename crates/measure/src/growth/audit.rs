//! What a claim costs the audit, by the number of its variables and by its degree.

use std::fmt::Write as _;

use kane_audit::{LinkJudgement, Options, Verdict, audit, read};

use super::Told;
use super::clock::reading;
use crate::chart::Effort;

/// Claims of one kind, of growing size, up to the first that stays undecided.
#[derive(Clone, Debug)]
pub struct Family {
    /// what is claimed
    pub name: &'static str,
    /// what grows: `variables` or `degree`
    pub grows: &'static str,
    /// the claims, by size
    pub asked: Vec<Asked>,
}

/// One claim.
#[derive(Clone, Debug)]
pub struct Asked {
    /// how many variables, or which degree
    pub size: usize,
    /// the verdict
    pub verdict: Verdict,
    /// the judgement of its first link, which tells how it came about
    pub link: Option<LinkJudgement>,
    /// steps of search
    pub steps: u64,
    /// picoseconds for reading and judging the document, if it was timed
    pub time: Option<u64>,
}

/// A family before it is asked: a document for each size.
struct Kind {
    name: &'static str,
    grows: &'static str,
    text: fn(usize) -> String,
    quick: &'static [usize],
    full: &'static [usize],
}

const KINDS: [Kind; 5] = [
    Kind {
        name: "restitution over n bounces: v_n = (-e)^n*v_0",
        grows: "variables",
        text: restitutions,
        quick: &[3, 4, 6, 10, 18],
        full: &[3, 4, 6, 10, 18, 34, 66, 130],
    },
    Kind {
        name: "(x_1 + ... + x_n)^2 <= n*(x_1^2 + ... + x_n^2)",
        grows: "variables",
        text: cauchy,
        quick: &[2, 3, 4],
        full: &[2, 3, 4, 5, 6],
    },
    Kind {
        name: "x^n + (n - 1)*y^n >= n*x*y^(n - 1) for x, y >= 0",
        grows: "degree",
        text: means,
        quick: &[2, 3, 4],
        full: &[2, 3, 4, 5, 6, 7],
    },
    Kind {
        name: "x^n >= n*x - (n - 1) for x >= 0",
        grows: "degree",
        text: bernoulli,
        quick: &[2, 4, 8, 16, 32],
        full: &[2, 4, 8, 16, 32, 64],
    },
    Kind {
        name: "k^n -> (-1)^n as alpha -> oo, k = (1 - alpha)/(1 + alpha)",
        grows: "degree",
        text: limit,
        quick: &[1, 2, 4, 8, 16],
        full: &[1, 2, 4, 8, 16, 32, 64],
    },
];

/// e and the speeds from `v_0` to `v_n`: n + 2 variables.
fn restitutions(variables: usize) -> String {
    let n = variables - 2;
    let mut text = "var 0 <= e <= 1".to_owned();
    for i in 0..=n {
        let _ = write!(text, ", v_{i}");
    }
    for i in 1..=n {
        let _ = write!(text, "\ngiven ({i}): v_{i} = -e*v_{}", i - 1);
    }
    let _ = write!(text, "\nclaim (c): v_{n} = (-e)^{n}*v_0 from (1)");
    for i in 2..=n {
        let _ = write!(text, ", ({i})");
    }
    text
}

fn cauchy(n: usize) -> String {
    let join =
        |by: &str, of: &dyn Fn(usize) -> String| (1..=n).map(of).collect::<Vec<_>>().join(by);
    let symbols = join(", ", &|i| format!("x_{i}"));
    let sum = join(" + ", &|i| format!("x_{i}"));
    let squares = join(" + ", &|i| format!("x_{i}^2"));
    format!("var {symbols}\nclaim (c): ({sum})^2 <= {n}*({squares})")
}

fn means(n: usize) -> String {
    let m = n - 1;
    format!("var x >= 0, y >= 0\nclaim (c): x^{n} + {m}*y^{n} >= {n}*x*y^{m}")
}

fn bernoulli(n: usize) -> String {
    format!("var x >= 0\nclaim (c): x^{n} >= {n}*x - {}", n - 1)
}

fn limit(n: usize) -> String {
    let to = if n.is_multiple_of(2) { "1" } else { "-1" };
    format!(
        "var alpha > 0\nlet k := (1 - alpha)/(1 + alpha)\nclaim (c): k^{n} -> {to} as alpha -> oo"
    )
}

const fn sizes(kind: &Kind, effort: Effort) -> &'static [usize] {
    match effort {
        Effort::Quick => kind.quick,
        Effort::Full => kind.full,
    }
}

pub(super) fn steps(effort: Effort) -> usize {
    KINDS.iter().map(|kind| sizes(kind, effort).len()).sum()
}

pub(super) fn families(effort: Effort, timed: bool, told: &mut Told<'_>) -> Vec<Family> {
    KINDS.iter().map(|kind| family(kind, effort, timed, told)).collect()
}

fn family(kind: &Kind, effort: Effort, timed: bool, told: &mut Told<'_>) -> Family {
    let mut asked: Vec<Asked> = Vec::new();
    for size in sizes(kind, effort) {
        told.step();
        if asked.last().is_none_or(|last| last.verdict != Verdict::Undecided) {
            asked.extend(ask(kind, *size, timed));
        }
    }
    Family { name: kind.name, grows: kind.grows, asked }
}

/// `None` if the document of that size cannot be read, which a test excludes.
fn ask(kind: &Kind, size: usize, timed: bool) -> Option<Asked> {
    let text = format!("```kane\n{}\n```\n", (kind.text)(size));
    let judged = || {
        let document = read("growth.md", text.as_bytes()).ok()?;
        audit(document, &Options::default(), &mut |_, _| {}).judgements.pop()
    };
    let (judgement, time) = reading(timed, judged);
    let judgement = judgement?;
    let link = judgement.links.first().cloned();
    let steps = judgement.links.iter().map(|link| link.cost).sum();
    Some(Asked { size, verdict: judgement.verdict, link, steps, time })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The claims are true, so a refutation or a document that cannot be read were a mistake here.
    #[test]
    fn every_size_is_read_and_proved_or_left_undecided() {
        for kind in &KINDS {
            for size in kind.full {
                let text = format!("```kane\n{}\n```\n", (kind.text)(*size));
                let document = read("growth.md", text.as_bytes());
                assert!(document.is_ok(), "{text}\n{:?}", document.err());
            }
            for size in kind.quick {
                let asked = ask(kind, *size, false).expect("it is read");
                assert_eq!(asked.verdict, Verdict::Proved, "{} of {size}", kind.name);
            }
        }
    }

    #[test]
    fn documents_have_the_variables_and_the_degree_that_they_are_named_for() {
        for size in [3, 10] {
            let variables = |text: &str| {
                let text = format!("```kane\n{text}\n```\n");
                read("growth.md", text.as_bytes()).expect("well formed").context.vars.len()
            };
            assert_eq!(variables(&restitutions(size)), size);
            assert_eq!(variables(&cauchy(size)), size);
        }
        assert!(means(7).contains("x^7 + 6*y^7 >= 7*x*y^6"));
        assert!(bernoulli(7).contains("x^7 >= 7*x - 6"));
        assert!(limit(7).contains("k^7 -> -1"));
    }
}
