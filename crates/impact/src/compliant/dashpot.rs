//! Two linear springs, the normal one with a damper.

use super::damped::{Damped, Loss, Spring};
use super::hertz::Node;
use super::march::{Ledger, Response, bound, march};
use super::{Compliance, NoOutcome, Outcome, Process, checked};
use crate::{Alpha, Ratios};

/// The pair of springs of [`Bilinear`](super::Bilinear) with a linear damper beside the normal one, in
/// place of a faster restitution (id `spring-dashpot`).
///
/// ```text
/// x'' = −x − c·x'    F = x + c·x' until it is zero    g' = y    |g| ≤ λ·F
/// ```
///
/// The usual contact of codes of granular mechanics, after P. A. Cundall and O. D. L. Strack,
/// Géotechnique 29 (1979) 47-65, from memory, original not consulted. *Heuristic*, of second order in
/// the step (measured).
#[derive(Clone, Debug)]
pub struct SpringDashpot {
    compliance: Compliance,
    fine: Vec<Node>,
    coarse: [Vec<Node>; 2],
}

impl SpringDashpot {
    /// Steps in an undamped compression.
    pub const STEPS: usize = 2_000;

    /// The springs of a compliance with the damper that gives its e.
    ///
    /// # Errors
    /// [`NoOutcome::NoDamper`] for an e that is too small.
    pub fn new(compliance: Compliance) -> Result<Self, NoOutcome> {
        let damped = Damped::new(Spring::Hooke, Loss::Linear, compliance.restitution())?;
        let [fine, half, third] = [1, 2, 3].map(|part| damped.history(Self::STEPS / part));
        Ok(Self { compliance, fine, coarse: [half, third] })
    }

    /// k alone, without an estimate of its error.
    ///
    /// # Errors
    /// As for [`outcome`](Process::outcome).
    pub fn k(&self, alpha: &Alpha<f64>) -> Result<f64, NoOutcome> {
        Ok(self.follow(&self.fine, checked(alpha)?)?.0.k)
    }

    fn follow(&self, nodes: &[Node], alpha: f64) -> Result<(Ratios<f64>, Ledger), NoOutcome> {
        let cone = self.compliance.cone(alpha);
        let mut spring = Slider { nodes, cone, slid: 0.0, force: 0.0 };
        march(nodes, &self.compliance, alpha, Some(&mut spring), &mut |_| ())
    }
}

/// A spring behind a slider.
struct Slider<'a> {
    nodes: &'a [Node],
    cone: f64,
    slid: f64,
    force: f64,
}

impl Response for Slider<'_> {
    fn respond(&mut self, to: usize, displacement: f64, _: f64) -> Result<f64, NoOutcome> {
        let bound = bound(self.cone, self.nodes[to].force);
        self.force = (displacement - self.slid).clamp(-bound, bound);
        self.slid = displacement - self.force;
        Ok(self.force)
    }

    fn stored(&self) -> Option<f64> {
        Some(self.force * self.force / 2.0)
    }
}

impl Process for SpringDashpot {
    fn id(&self) -> &'static str {
        "spring-dashpot"
    }

    fn source(&self) -> &'static str {
        "P. A. Cundall and O. D. L. Strack, Geotechnique 29 (1979) 47-65: from memory, original not consulted"
    }

    fn compliance(&self) -> &Compliance {
        &self.compliance
    }

    fn outcome(&self, alpha: &Alpha<f64>) -> Result<Outcome, NoOutcome> {
        let alpha = checked(alpha)?;
        Outcome::refined(&self.fine, &self.coarse, |nodes| self.follow(nodes, alpha))
    }
}
