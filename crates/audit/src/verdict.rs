//! The judgement of a document as data: verdicts, reasons, what they rest on.

use std::fmt;
use std::rc::Rc;

use kane_kernel::{Certificate, Goal};

use crate::argument::Grounds;
use crate::explain;

/// How a statement fares. The order is that of increasing trouble for a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Verdict {
    /// a definition: nothing to judge
    Defined,
    /// a premise: taken as it is
    Assumed,
    /// the kernel accepted a certificate
    Proved,
    /// neither proof nor witness was found within the budget
    Undecided,
    /// the kernel accepted a witness against it
    Refuted,
    /// a point where all hypotheses hold and the claim has no meaning
    IllDefined,
    /// the hypotheses contradict each other
    Vacuous,
    /// a claim that it cites is not proved
    Unsupported,
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Defined => "defined",
            Self::Assumed => "assumed",
            Self::Proved => "proved",
            Self::Undecided => "undecided",
            Self::Refuted => "refuted",
            Self::IllDefined => "ill-defined",
            Self::Vacuous => "vacuous",
            Self::Unsupported => "unsupported",
        })
    }
}

/// The judged document.
#[derive(Clone, Debug)]
pub struct Audit {
    /// what was judged
    pub document: crate::Document,
    /// one per statement, in the same order
    pub judgements: Vec<Judgement>,
}

/// The judgement of one statement.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// verdict of the whole: the worst link
    pub verdict: Verdict,
    /// what it would be if every cited claim were proved; differs from `verdict` only when unsupported
    pub conditional: Verdict,
    /// one per link; empty for `let` and `given`
    pub links: Vec<LinkJudgement>,
    /// indices of the cited claims that are not proved
    pub unproved: Vec<usize>,
    /// indices of the `given`s on which it finally rests, ascending
    pub rests_on: Vec<usize>,
    /// a point or functions at which all hypotheses hold: `name = value` pairs; `None` where none was found
    pub model: Option<Vec<(String, String)>>,
    /// the same as the kernel accepted it, for those who hand it to another judge
    pub met: Option<Rc<Accepted>>,
    /// the author's expectation, if written
    pub expect: Option<Verdict>,
}

/// The judgement of one link of a claim.
#[derive(Clone, Debug)]
pub struct LinkJudgement {
    /// the link in plain notation
    pub text: String,
    /// the link in LaTeX
    pub latex: String,
    /// verdict of this link, cited claims taken as proved
    pub verdict: Verdict,
    /// one sentence: how it was proved, the witness, or why undecided
    pub reason: String,
    /// digest of the accepted certificate, 32 hexadecimal digits; `None` when undecided
    pub certificate: Option<String>,
    /// cited statements that the proof actually used, as indices
    pub used: Vec<usize>,
    /// the proof or witness step by step, for a person with paper
    pub steps: Steps,
    /// search steps spent
    pub cost: u64,
    /// the goal that the kernel was asked about and the certificate that it accepted, for those who
    /// hand both to another judge; `None` when undecided
    pub accepted: Option<Rc<Accepted>>,
}

/// A goal and the certificate that the kernel accepted for it.
#[derive(Clone, Debug)]
pub struct Accepted {
    /// the goal: the cited premises, or those and the givens behind them
    pub goal: Goal,
    /// what was found about it, and why
    pub certificate: Certificate,
}

/// The steps of a proof or witness. They are made when something shows them.
#[derive(Clone, Debug)]
pub struct Steps(Source);

#[derive(Clone, Debug)]
enum Source {
    Told(Vec<Step>),
    Found { accepted: Rc<Accepted>, grounds: Rc<Grounds>, labels: Vec<String> },
}

impl Steps {
    /// Steps from what was accepted and the grounds for it; the labels are names of the goal's
    /// hypotheses.
    pub(crate) fn of(accepted: Rc<Accepted>, grounds: Grounds, labels: Vec<String>) -> Self {
        Self(Source::Found { accepted, grounds: Rc::new(grounds), labels })
    }

    /// The steps, told anew at each call.
    #[must_use]
    pub fn told(&self) -> Vec<Step> {
        match &self.0 {
            Source::Told(steps) => steps.clone(),
            Source::Found { accepted, grounds, labels } => {
                let labels: Vec<&str> = labels.iter().map(String::as_str).collect();
                explain::steps(&accepted.goal, accepted.certificate.finding, grounds, &labels)
            }
        }
    }
}

impl From<Vec<Step>> for Steps {
    fn from(steps: Vec<Step>) -> Self {
        Self(Source::Told(steps))
    }
}

/// One line of a written-out proof or witness.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// nesting, 0 for the outermost
    pub depth: usize,
    /// the sentence
    pub text: String,
}

impl Judgement {
    /// Whether the verdict is what the author expects (`proved` where nothing is written).
    #[must_use]
    pub fn as_expected(&self) -> bool {
        match self.verdict {
            Verdict::Defined | Verdict::Assumed => true,
            verdict => verdict == self.expect.unwrap_or(Verdict::Proved),
        }
    }
}

impl Audit {
    /// Whether every statement ends as its author expects.
    #[must_use]
    pub fn as_expected(&self) -> bool {
        self.judgements.iter().all(Judgement::as_expected)
    }
}
