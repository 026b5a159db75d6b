//! The half-space as a row of springs.

use super::damped::{Damped, Loss, Spring};
use super::hertz::{Node, history, to_float};
use super::march::{Ledger, Moment, Response, bound, march};
use super::{Compliance, NoOutcome, Outcome, Process, checked, within};
use crate::{Alpha, Ratios};

/// The theory of Maw, Barber and Fawcett by the method of dimensionality reduction (id
/// `dimension-reduction`).
///
/// Abel's transform takes tractions q(r) to line loads g(x) = 2·∫ r·q/√(r² − x²) dr, and the
/// half-space to springs that know nothing of each other: Hertz's pressure becomes
/// (15/16)·(a² − x²), displacement u becomes (15/16)·u. What slides and sticks in rings does so in
/// the springs, each with a cone of its own:
///
/// ```text
/// |g(x)| ≤ λ·(15/16)·(a² − x²)    friction = 2·∫ g dx
/// ```
///
/// That local friction in the rings is the same as in the springs is exact where it is a
/// superposition of Cattaneo's and Mindlin's solutions (Jäger 1998); that it is so throughout a
/// collision is not proved here, but the two ways agree as their grids are refined, and share
/// nothing of what they make of a displacement. A step costs the springs' number, not its square.
///
/// k = 1 − 2α to rounding while the contact slides. Elsewhere *heuristic*, of second order in the
/// step and the springs (measured).
///
/// Source: V. L. Popov, M. Heß, *Method of Dimensionality Reduction* (2015), and I. A. Lyashenko,
/// V. L. Popov, Sci. Rep. 5 (2015) 8479, who find Maw's curve by it; from memory, originals not
/// consulted. The transform is derived in the docstring of the annuli.
#[derive(Clone, Debug)]
pub struct DimensionReduction {
    compliance: Compliance,
    damped: bool,
    fine: Grid,
    coarse: [Grid; 2],
}

const JOINS: f64 = 0.5;

/// The springs, the steps, and what each spring bears at each.
#[derive(Clone, Debug)]
struct Grid {
    springs: usize,
    nodes: Vec<Node>,
    bearing: Vec<Vec<f64>>,
}

impl Grid {
    fn new(springs: usize, nodes: Vec<Node>) -> Self {
        // of ∫(a² − x²)dx; a spring joins when its middle does
        let inside = |x: f64| x * (3.0 - x * x) / 2.0;
        let bearing = nodes.iter().map(|node| node.shared(springs, JOINS, inside)).collect();
        Self { springs, nodes, bearing }
    }

    /// The part of the step to a node that is over when a spring joins within it.
    fn free_share(&self, spring: usize, to: usize) -> f64 {
        let [from, to] = [to - 1, to].map(|n| self.nodes[n].penetration.sqrt());
        let joins = (to_float(spring) + JOINS) / to_float(self.springs);
        ((joins - from) / (to - from)).clamp(0.0, 1.0)
    }
}

impl DimensionReduction {
    /// Springs on either side by default.
    pub const SPRINGS: usize = 60;
    /// Steps in compression by default, and as many in restitution.
    pub const STEPS: usize = 200;
    /// The most springs.
    pub const MOST_SPRINGS: usize = 10_000;
    /// The most steps.
    pub const MOST_STEPS: usize = 100_000;

    /// With [`SPRINGS`](Self::SPRINGS) and [`STEPS`](Self::STEPS).
    #[must_use]
    pub fn new(compliance: Compliance) -> Self {
        Self::of_grid(compliance, Self::SPRINGS, Self::STEPS)
    }

    /// With a number of springs, and of steps in compression; as many follow in restitution. Cost:
    /// O(steps·springs), in memory, too.
    ///
    /// # Errors
    /// [`NoOutcome::Budget`] unless 6 ≤ springs ≤ [`MOST_SPRINGS`](Self::MOST_SPRINGS) and
    /// 6 ≤ steps ≤ [`MOST_STEPS`](Self::MOST_STEPS).
    pub fn with_grid(
        compliance: Compliance,
        springs: usize,
        steps: usize,
    ) -> Result<Self, NoOutcome> {
        within("the number of springs", springs, 6, Self::MOST_SPRINGS)?;
        within("the number of steps", steps, 6, Self::MOST_STEPS)?;
        Ok(Self::of_grid(compliance, springs, steps))
    }

    fn of_grid(compliance: Compliance, springs: usize, steps: usize) -> Self {
        let grid = |part: usize| {
            Grid::new(springs / part, history(steps / part, compliance.restitution()))
        };
        let coarse = [grid(2), grid(3)];
        Self { compliance, damped: false, fine: grid(1), coarse }
    }

    /// The half-space with another [choice](Loss) of what is lost for e < 1: the cone of every spring
    /// follows the whole normal force, the damper's part included. The grid as for
    /// [`with_grid`](Self::with_grid), steps in an undamped compression.
    ///
    /// # Errors
    /// [`NoOutcome::Budget`] as there, and [`NoOutcome::NoDamper`] for an e that is too small.
    pub fn damped(
        compliance: Compliance,
        loss: Loss,
        springs: usize,
        steps: usize,
    ) -> Result<Self, NoOutcome> {
        let recoil = Self::with_grid(compliance, springs, steps)?;
        if loss == Loss::Recoil || compliance.restitution() == 1.0 {
            return Ok(recoil);
        }
        let damped = Damped::new(Spring::Hertz, loss, compliance.restitution())?;
        let [fine, half, third] =
            [1, 2, 3].map(|part| Grid::new(springs / part, damped.history(steps / part)));
        Ok(Self { damped: true, fine, coarse: [half, third], ..recoil })
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
        grid: &Grid,
        alpha: f64,
        observe: &mut dyn FnMut(&Moment),
    ) -> Result<(Ratios<f64>, Ledger), NoOutcome> {
        let mut row = Row {
            grid,
            cone: self.compliance.cone(alpha),
            stiffness: 15.0 / 8.0 / to_float(grid.springs),
            slid: vec![0.0; grid.springs],
            stored: 0.0,
        };
        // the documented range is that of the undamped motion
        let sliding = !self.damped && alpha <= self.compliance.sliding_until();
        march(&grid.nodes, &self.compliance, alpha, (!sliding).then_some(&mut row), observe)
    }
}

/// The springs during a collision.
struct Row<'a> {
    grid: &'a Grid,
    cone: f64,
    stiffness: f64,
    /// By how much each spring's foot has slid so far.
    slid: Vec<f64>,
    stored: f64,
}

impl Response for Row<'_> {
    fn respond(&mut self, to: usize, displacement: f64, by: f64) -> Result<f64, NoOutcome> {
        let bearing = &self.grid.bearing[to];
        let before = self.grid.bearing[to - 1].len();
        for i in before..bearing.len() {
            // the foot follows freely until the spring touches
            self.slid[i] += by * self.grid.free_share(i, to);
        }
        let (touching, free) = self.slid.split_at_mut(bearing.len());
        let (mut friction, mut energy) = (0.0, 0.0);
        for (slid, force) in touching.iter_mut().zip(bearing) {
            let bound = bound(self.cone, *force) / self.stiffness;
            let stretch = (displacement - *slid).clamp(-bound, bound);
            *slid = displacement - stretch;
            friction += stretch;
            energy += stretch * stretch;
        }
        free.fill(displacement);
        self.stored = self.stiffness * energy / 2.0;
        Ok(self.stiffness * friction)
    }

    fn stored(&self) -> Option<f64> {
        Some(self.stored)
    }
}

impl Process for DimensionReduction {
    fn id(&self) -> &'static str {
        "dimension-reduction"
    }

    fn source(&self) -> &'static str {
        "V. L. Popov, M. Hess, Method of Dimensionality Reduction (2015), and I. A. Lyashenko, V. L. Popov, Sci. Rep. 5 (2015) 8479: from memory, originals not consulted"
    }

    fn compliance(&self) -> &Compliance {
        &self.compliance
    }

    fn outcome(&self, alpha: &Alpha<f64>) -> Result<Outcome, NoOutcome> {
        let alpha = checked(alpha)?;
        Outcome::refined(&self.fine, &self.coarse, |grid| self.follow(grid, alpha, &mut |_| ()))
    }
}
