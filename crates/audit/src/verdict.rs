//! The judgement of a document as data: verdicts, reasons, what they rest on.

use std::fmt;
use std::rc::Rc;

use kane_kernel::{Certificate, Evidence, Goal};

use crate::argument::Grounds;
use crate::kept::Kept;
use crate::{Assignment, Attempt, Beside, Open, Proof, Reason, Standing, Unreached, explain};

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
    /// indices of the cited statements that say something, in the order of the goals' hypotheses
    pub hypotheses: Vec<usize>,
    /// a point or functions at which all hypotheses hold, as the kernel accepted it; `None` where none
    /// was found
    pub met: Option<Rc<Accepted>>,
    /// the author's expectation, if written
    pub expect: Option<Verdict>,
}

/// The judgement of one link of a claim.
#[derive(Clone, Debug)]
pub struct LinkJudgement {
    /// verdict of this link, cited claims taken as proved
    pub verdict: Verdict,
    /// digest of the accepted certificate, 32 hexadecimal digits; `None` when undecided
    pub certificate: Option<String>,
    /// cited statements that the proof actually used, as indices
    pub used: Vec<usize>,
    /// search steps spent
    pub cost: u64,
    /// coefficient operations spent, of the document's budget
    pub work: u64,
    /// the goal that the kernel was asked about and the certificate that it accepted, for those who
    /// hand both to another judge; `None` when undecided
    pub accepted: Option<Rc<Accepted>>,
    /// what can be told of what was accepted
    pub explanation: Explanation,
    /// how a witness against it stands to the givens above; `None` where there is no such witness
    pub standing: Option<Standing>,
    /// the givens above that are not cited, at the witness, where there is something to tell of them
    pub beside: Option<Rc<Beside>>,
    /// why the search ended, when undecided
    pub open: Option<Open>,
    /// what was tried in vain, when undecided
    pub attempt: Option<Attempt>,
    /// a given that was not shown to hold near a limit, which left it undecided
    pub unreached: Option<Unreached>,
    /// a given above that is not cited, with which a refuted link would be proved
    pub would_do: Option<usize>,
    /// the numbers that were put in the place of indices for what was accepted, by their symbols
    pub at: Vec<(usize, u32)>,
}

/// A goal and the certificate that the kernel accepted for it.
#[derive(Clone, Debug)]
pub struct Accepted {
    /// the goal: the cited premises, or those and the givens behind them
    pub goal: Goal,
    /// what was found about it, and why
    pub certificate: Certificate,
}

impl Default for LinkJudgement {
    /// A link about which nothing is known.
    fn default() -> Self {
        Self {
            verdict: Verdict::Undecided,
            certificate: None,
            used: Vec::new(),
            cost: 0,
            work: 0,
            accepted: None,
            explanation: Explanation::default(),
            standing: None,
            beside: None,
            open: None,
            attempt: None,
            unreached: None,
            would_do: None,
            at: Vec::new(),
        }
    }
}

impl LinkJudgement {
    /// The proof or the witness in outline; `None` when undecided. A point has the values that the givens ask for of
    /// which it is said that they fail there, too.
    #[must_use]
    pub fn reason(&self) -> Option<Reason> {
        let mut reason = self.own_reason();
        if let (Some(Reason::Point { values, .. }), Some(beside)) = (&mut reason, &self.beside) {
            let is_new = |new: &&Assignment| values.iter().all(|old| old.symbol != new.symbol);
            let further: Vec<_> = beside.further.iter().filter(is_new).cloned().collect();
            values.extend(further);
        }
        reason
    }

    fn own_reason(&self) -> Option<Reason> {
        match &self.explanation.0 {
            Source::Nothing => None,
            Source::Told(reason, _) => Some(reason.clone()),
            Source::Found(grounds, kept) => {
                let Accepted { goal, certificate } = self.accepted.as_deref()?;
                Some(explain::reason(goal, certificate.finding, (grounds, kept.as_deref())))
            }
        }
    }

    /// The proof or the witness step by step, made anew at each call; no steps when undecided.
    #[must_use]
    pub fn steps(&self) -> Proof {
        match (&self.explanation.0, self.accepted.as_deref()) {
            (Source::Told(_, proof), _) => proof.clone(),
            (Source::Found(grounds, kept), Some(Accepted { goal, certificate })) => {
                explain::told(goal, certificate.finding, (grounds, kept.as_deref()))
            }
            (Source::Nothing | Source::Found(..), _) => Proof::default(),
        }
    }
}

/// What can be told of a finding. It is made when something shows it.
#[derive(Clone, Debug, Default)]
pub struct Explanation(Source);

#[derive(Clone, Debug, Default)]
enum Source {
    #[default]
    Nothing,
    Told(Reason, Proof),
    Found(Grounds, Option<Rc<Kept>>),
}

impl Explanation {
    /// What these grounds of an accepted finding tell.
    pub(crate) const fn of(grounds: Grounds, kept: Option<Rc<Kept>>) -> Self {
        Self(Source::Found(grounds, kept))
    }
}

impl From<(Reason, Proof)> for Explanation {
    fn from((reason, proof): (Reason, Proof)) -> Self {
        Self(Source::Told(reason, proof))
    }
}

impl Judgement {
    /// Values of the symbols for which all hypotheses hold; `None` where none were found.
    #[must_use]
    pub fn example(&self) -> Option<Vec<Assignment>> {
        let met = self.met.as_deref()?;
        match &met.certificate.evidence {
            Evidence::Model(model) => Some(explain::model(&met.goal, model)),
            Evidence::Contradiction(_) | Evidence::Limit(_) | Evidence::Split { .. } => None,
        }
    }

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
