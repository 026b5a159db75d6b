//! What the verdicts are called where a report has room for words.

use kane_audit::Verdict;

/// The heading over what decides a claim.
pub(crate) const fn evidence(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Proved | Verdict::Defined | Verdict::Assumed => "Proof",
        Verdict::Refuted => "Counterexample",
        Verdict::IllDefined => "Where it has no meaning",
        Verdict::Vacuous => "Why its premises cannot all hold",
        Verdict::Unsupported => "Proof from what it cites",
        Verdict::Undecided => "What was tried",
    }
}

/// A mark for the verdict, so that it never rests on colour alone.
pub(crate) const fn mark(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Defined => "≔",
        Verdict::Assumed => "▪",
        Verdict::Proved => "✓",
        Verdict::Refuted => "✗",
        Verdict::IllDefined => "∅",
        Verdict::Vacuous => "⊥",
        Verdict::Unsupported => "△",
        Verdict::Undecided => "?",
    }
}
