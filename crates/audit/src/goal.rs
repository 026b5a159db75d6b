//! Certificates of single goals, for tests that hold them against the kernel.

use kane_kernel::{Certificate, Evidence, Expr, Finding, Goal, digest};

use crate::prove::{Budget, Prover};

/// The certificates that the kernel accepted for a goal.
#[doc(hidden)]
#[derive(Clone, Debug)]
pub struct Findings {
    /// the one that decides
    pub decided: Option<Certificate>,
    /// a model of the hypotheses
    pub model: Option<Certificate>,
    /// why nothing decides
    pub reason: String,
}

/// Judges a goal on its own; `by` proposes values or functions for a witness.
#[doc(hidden)]
#[must_use]
pub fn judge_goal(goal: &Goal, by: &[(usize, Expr)], budget: Budget) -> Findings {
    let earlier = std::cell::RefCell::default();
    let cited = goal.hypotheses.len();
    let prover = Prover { budget, by, earlier: &earlier, cited, resting: goal };
    let found = prover.judge(goal, true);
    let model = |m| Certificate {
        goal: digest(goal),
        finding: Finding::Consistent,
        evidence: Evidence::Model(m),
    };
    Findings { decided: found.decided, model: found.model.map(model), reason: found.reason }
}
