//! A spring that stiffens with the contact, as codes of granular mechanics have it.

use super::hertz::{Node, history};
use super::march::{Ledger, Moment, Response, bound, march};
use super::{Compliance, NoOutcome, Outcome, Process, checked, within};
use crate::{Alpha, Ratios};

/// Hertz's normal force and a tangential spring of stiffness 8·G*·a, advanced by increments and cut
/// at Coulomb's cone (id `hertz-mindlin`).
///
/// The stiffness is that of Mindlin's contact without slip. What slides at the edge of a real
/// contact is left out, and so is what a shrinking contact releases. This is the common shortcut of
/// codes of granular mechanics; [`MawBarberFawcett`](super::MawBarberFawcett) does without it.
/// Codes differ in what they [remember](Memory). Either way the spring has no energy that depends
/// on its state alone, and can return more than it took: k < −1 or k > 1, which
/// [`Ledger::above_start`] tells.
///
/// *Heuristic*, of second order in the step (measured); the error of k with the default 400 steps is
/// near 1e-4 for a solid sphere.
///
/// Source: as described for codes of granular mechanics (Cundall and Strack's increments with
/// Hertz's and Mindlin's stiffness), from memory; no original was consulted.
#[derive(Clone, Debug)]
pub struct HertzMindlin {
    compliance: Compliance,
    memory: Memory,
    fine: Vec<Node>,
    coarse: [Vec<Node>; 2],
}

/// What the tangential spring remembers from step to step.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Memory {
    /// The force: Δg = 8·G*·a·Δs, |g| ≤ μ·F. Growing contacts lose nothing; shrinking ones keep
    /// traction that has left with the edge, and give back more than was stored: up to a tenth of the
    /// energy of the slip near normal collision, at some χ.
    #[default]
    Force,
    /// The displacement: g = 8·G*·a·s, and s is shortened where |g| would exceed μ·F (id
    /// `hertz-mindlin-secant`). Growing contacts stiffen what is already displaced, which
    /// creates energy at moderate α already, in particular where e is small.
    Displacement,
}

impl HertzMindlin {
    /// Steps in compression by default, and as many in restitution.
    pub const STEPS: usize = 200;
    /// The most steps.
    pub const MOST_STEPS: usize = 1_000_000;

    /// With [`STEPS`](Self::STEPS).
    #[must_use]
    pub fn new(compliance: Compliance) -> Self {
        Self::of_steps(compliance, Self::STEPS)
    }

    /// With `steps` steps in compression and as many in restitution. Cost: O(steps).
    ///
    /// # Errors
    /// [`NoOutcome::Budget`] unless 6 ≤ steps ≤ [`MOST_STEPS`](Self::MOST_STEPS).
    pub fn with_steps(compliance: Compliance, steps: usize) -> Result<Self, NoOutcome> {
        within("the number of steps", steps, 6, Self::MOST_STEPS)?;
        Ok(Self::of_steps(compliance, steps))
    }

    fn of_steps(compliance: Compliance, steps: usize) -> Self {
        let restitution = compliance.restitution();
        let fine = history(steps, restitution);
        let coarse = [2, 3].map(|part| history(steps / part, restitution));
        Self { compliance, memory: Memory::default(), fine, coarse }
    }

    /// The same with another memory; [`Memory::Force`] by default.
    #[must_use]
    pub fn remembering(self, memory: Memory) -> Self {
        Self { memory, ..self }
    }

    /// The same collision with an observer of every step, the start included.
    ///
    /// # Errors
    /// [`NoOutcome`], see [`outcome`](Process::outcome).
    pub fn observe(
        &self,
        alpha: &Alpha<f64>,
        observe: &mut dyn FnMut(&Moment),
    ) -> Result<(Ratios<f64>, Ledger), NoOutcome> {
        self.follow(&self.fine, checked(alpha)?, observe)
    }

    fn follow(
        &self,
        nodes: &[Node],
        alpha: f64,
        observe: &mut dyn FnMut(&Moment),
    ) -> Result<(Ratios<f64>, Ledger), NoOutcome> {
        let cone = self.compliance.cone(alpha);
        let mut spring = Spring { nodes, cone, memory: self.memory, state: 0.0 };
        march(nodes, &self.compliance, alpha, Some(&mut spring), observe)
    }
}

struct Spring<'a> {
    nodes: &'a [Node],
    cone: f64,
    memory: Memory,
    /// The force or the displacement.
    state: f64,
}

impl Response for Spring<'_> {
    fn respond(&mut self, to: usize, _: f64, by: f64) -> Result<f64, NoOutcome> {
        let node = &self.nodes[to];
        let bound = bound(self.cone, node.force);
        match self.memory {
            Memory::Force => {
                self.state = (self.state + node.stiffness * by).clamp(-bound, bound);
                Ok(self.state)
            }
            Memory::Displacement => {
                let stiffness = 1.875 * node.penetration.sqrt();
                let force = stiffness * (self.state + by);
                let cut = force.clamp(-bound, bound);
                let stretched = stiffness > 0.0 && cut != force;
                self.state = if stretched { cut / stiffness } else { self.state + by };
                Ok(cut)
            }
        }
    }

    fn stored(&self) -> Option<f64> {
        None
    }
}

impl Process for HertzMindlin {
    fn id(&self) -> &'static str {
        match self.memory {
            Memory::Force => "hertz-mindlin",
            Memory::Displacement => "hertz-mindlin-secant",
        }
    }

    fn source(&self) -> &'static str {
        "incremental Hertz-Mindlin contact with Coulomb's bound, as described for codes of granular mechanics; from memory, no original consulted"
    }

    fn compliance(&self) -> &Compliance {
        &self.compliance
    }

    fn outcome(&self, alpha: &Alpha<f64>) -> Result<Outcome, NoOutcome> {
        let alpha = checked(alpha)?;
        Outcome::refined(&self.fine, &self.coarse, |nodes| self.follow(nodes, alpha, &mut |_| ()))
    }
}
