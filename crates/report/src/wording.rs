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

/// `0 rows`, `1 row`, `2 rows`.
pub(crate) fn number_of(n: impl std::fmt::Display, noun: &str) -> String {
    let n = n.to_string();
    let plural = if n == "1" { "" } else { "s" };
    format!("{n} {noun}{plural}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_is_no_plural() {
        assert_eq!(
            [0, 1, 2, 11].map(|n| number_of(n, "row")),
            ["0 rows", "1 row", "2 rows", "11 rows"]
        );
    }
}
