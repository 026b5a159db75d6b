//! Single goals, judged on their own: what documents do for their claims, for whoever states goals.

use std::cell::RefCell;

use kane_kernel::{
    Certificate, Checked, Evidence, Expr, Finding, Fuel, Goal, Model, Point, check, digest,
};

use crate::argument::Grounds;
use crate::prove::{Budget, Decided, Memory, Prover};
use crate::{Open, Proof, Reason, explain};

/// The certificates that the kernel accepted for a goal.
#[derive(Clone, Debug)]
pub struct Findings {
    /// the one that decides
    pub decided: Option<Certificate>,
    /// a model of the hypotheses
    pub model: Option<Certificate>,
    /// why nothing decides
    pub open: Option<Open>,
}

/// Judges a goal on its own; `by` proposes values or functions for a witness. Nothing is returned
/// that the kernel did not accept.
#[must_use]
pub fn judge_goal(goal: &Goal, by: &[(usize, Expr)], budget: Budget) -> Findings {
    let earlier = RefCell::default();
    let found = alone(goal, by, budget, &earlier).judge(goal, true);
    let model = |m| Certificate {
        goal: digest(goal),
        finding: Finding::Consistent,
        evidence: Evidence::Model(m),
    };
    let decided = found.decided.map(|d| d.certificate);
    Findings { decided, model: found.model.map(model), open: found.open }
}

/// Looks for a proof of a goal alone, not for witnesses: what the kernel accepted.
///
/// # Errors
/// Why there is none.
pub fn prove_goal(goal: &Goal, budget: Budget) -> Result<Decided, Open> {
    let earlier = RefCell::default();
    let found = alone(goal, &[], budget, &earlier).prove(goal);
    found.decided.ok_or(found.open.unwrap_or(Open::NoProof(budget.steps)))
}

/// Whether a goal is proved, as what the kernel accepted says, with a part of this work.
pub(crate) fn is_proved(goal: &Goal, budget: Budget, work: &Fuel) -> bool {
    let earlier = RefCell::default();
    let work = work.within(budget.document);
    Prover { work, ..alone(goal, &[], budget, &earlier) }.prove(goal).decided.is_some()
}

/// That a goal is refuted at a point, if the kernel accepts it.
///
/// # Errors
/// The kernel's [`Rejection`](kane_kernel::Rejection).
pub fn refute_goal(goal: &Goal, point: Point) -> Checked<Decided> {
    let model = Model::Point(point);
    let grounds = Grounds::Model(model.clone());
    let evidence = Evidence::Model(model);
    let certificate = Certificate { goal: digest(goal), finding: Finding::Refuted, evidence };
    check(goal, &certificate, Fuel::new(Budget::default().check))?;
    Ok(Decided { certificate, grounds, kept: None })
}

/// Looks for a point that refutes a goal, and for nothing else: what the kernel accepted.
#[must_use]
pub fn find_witness(goal: &Goal, budget: Budget) -> Option<Decided> {
    let earlier = RefCell::default();
    alone(goal, &[], budget, &earlier).refute(goal).decided
}

/// The search for a goal that rests on nothing else.
fn alone<'a>(
    goal: &'a Goal,
    by: &'a [(usize, Expr)],
    budget: Budget,
    earlier: &'a RefCell<Vec<Model>>,
) -> Prover<'a> {
    Prover {
        budget,
        work: Fuel::new(budget.document),
        using: &[],
        by,
        earlier,
        near: Memory::default(),
        cited: goal.hypotheses.len(),
        resting: goal,
    }
}

impl Decided {
    /// The proof or the witness in outline. The goal is the one that was decided.
    #[must_use]
    pub fn reason(&self, goal: &Goal) -> Reason {
        explain::reason(goal, self.certificate.finding, (&self.grounds, self.kept.as_deref()))
    }

    /// The proof or the witness step by step.
    #[must_use]
    pub fn steps(&self, goal: &Goal) -> Proof {
        explain::told(goal, self.certificate.finding, (&self.grounds, self.kept.as_deref()))
    }
}
