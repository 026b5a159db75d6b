//! The oblique impact of elastic spheres, annulus by annulus.

use super::annuli::{Annuli, DEFICIT, Friction};
use super::hertz::{Node, history};
use super::march::{Ledger, Moment, Response, bound, march};
use super::{Compliance, NoOutcome, Outcome, Process, checked, within};
use crate::{Alpha, Ratios};

/// Hertz's contact with the elastic half-space's answer to friction, and Coulomb's law at every
/// radius by itself (id `maw-barber-fawcett`).
///
/// The greatest contact disc is divided into annuli of equal width. On each the traction is even,
/// and bounded by μ times the mean of Hertz's pressure; where it is below, the annulus moves with
/// the bodies, and where it slides, friction is along the slip. Displacements are averaged over an
/// annulus and over the angle, which is the approximation of Maw, Barber and Fawcett; they also
/// leave out friction across the plane of motion and the coupling of normal and tangential
/// displacements of unlike materials.
///
/// Gross sliding, ψ1 ≥ 4χ − 1 for e = 1, needs no annuli and is k = 1 − 2α to rounding: under
/// friction λ·F everywhere the displacement is λ times the normal one, which changes by λ·x' at
/// every radius alike, so that the contact slides as a whole as long as y > λ·x'. Elsewhere *heuristic*; the error
/// falls with the first power of the annuli's number at least, see
/// [`outcome`](Process::outcome) for its estimate.
///
/// Theirs is a sum of tractions √(1 − r²/`a_j²`), adjusted at points; ours the same operator by its
/// energy, which keeps the flexibility symmetric, so that no step can create energy beyond the
/// reversal of slip within it.
///
/// Source: N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101–114, and J. Lubr. Technol. 103
/// (1981) 74–80: the theory from memory and from abstracts; originals not consulted.
#[derive(Clone, Debug)]
pub struct MawBarberFawcett {
    compliance: Compliance,
    fine: Grid,
    coarse: [Grid; 2],
}

/// The annuli, the steps, and what each annulus bears at each.
#[derive(Clone, Debug)]
struct Grid {
    annuli: Annuli,
    nodes: Vec<Node>,
    /// The normal forces of the annuli in contact, node by node.
    bearing: Vec<Vec<f64>>,
}

impl Grid {
    fn new(annuli: usize, steps: usize, restitution: f64) -> Self {
        let nodes = history(steps, restitution);
        // F·(1 − (1 − r²/a²)^(3/2)) is the force inside the radius r
        let inside = |r: f64| 1.0 - (1.0 - r * r).max(0.0).powf(1.5);
        let bearing = nodes.iter().map(|node| node.shared(annuli, JOINS, inside)).collect();
        Self { annuli: Annuli::new(annuli), nodes, bearing }
    }
}

/// An annulus joins when this much of its width is covered, and leaves likewise.
///
/// As long as m annuli are in contact the disc should be as large as the real one in the mean,
/// (m − 1/2 + joins)·w for the width w; even tractions make it act as if it were smaller by
/// [`DEFICIT`]·w.
const JOINS: f64 = 0.5 - DEFICIT;

impl MawBarberFawcett {
    /// Annuli by default.
    pub const ANNULI: usize = 60;
    /// Steps in compression by default, and as many in restitution.
    pub const STEPS: usize = 600;
    /// The most annuli: memory and time grow with their square, and with the steps.
    pub const MOST_ANNULI: usize = 1000;
    /// The most steps.
    pub const MOST_STEPS: usize = 100_000;

    /// With [`ANNULI`](Self::ANNULI) and [`STEPS`](Self::STEPS).
    #[must_use]
    pub fn new(compliance: Compliance) -> Self {
        Self::of_grid(compliance, Self::ANNULI, Self::STEPS)
    }

    /// With a number of annuli, and of steps in compression; as many follow in restitution. Cost:
    /// O(annuli³) once, and O(steps·annuli²) a collision.
    ///
    /// # Errors
    /// [`NoOutcome::Budget`] unless 6 ≤ annuli ≤ [`MOST_ANNULI`](Self::MOST_ANNULI) and
    /// 6 ≤ steps ≤ [`MOST_STEPS`](Self::MOST_STEPS).
    pub fn with_grid(
        compliance: Compliance,
        annuli: usize,
        steps: usize,
    ) -> Result<Self, NoOutcome> {
        within("the number of annuli", annuli, 6, Self::MOST_ANNULI)?;
        within("the number of steps", steps, 6, Self::MOST_STEPS)?;
        Ok(Self::of_grid(compliance, annuli, steps))
    }

    fn of_grid(compliance: Compliance, annuli: usize, steps: usize) -> Self {
        let grid = |part: usize| Grid::new(annuli / part, steps / part, compliance.restitution());
        Self { compliance, fine: grid(1), coarse: [grid(2), grid(3)] }
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
        let count = grid.annuli.count;
        let mut patch = Patch {
            grid,
            cone: self.compliance.cone(alpha),
            friction: Friction::new(count),
            slid: vec![0.0; count],
            bounds: Vec::with_capacity(count),
            wanted: Vec::with_capacity(count),
        };
        let sliding = alpha <= self.compliance.sliding_until();
        march(&grid.nodes, &self.compliance, alpha, (!sliding).then_some(&mut patch), observe)
    }
}

/// The contact patch during a collision.
struct Patch<'a> {
    grid: &'a Grid,
    cone: f64,
    friction: Friction,
    /// By how much each annulus has slid so far.
    slid: Vec<f64>,
    bounds: Vec<f64>,
    wanted: Vec<f64>,
}

impl Response for Patch<'_> {
    fn respond(&mut self, to: usize, displacement: f64, _: f64) -> Result<f64, NoOutcome> {
        self.bounds.clear();
        self.bounds.extend(self.grid.bearing[to].iter().map(|force| bound(self.cone, *force)));
        self.wanted.clear();
        self.wanted.extend(self.slid.iter().map(|slid| displacement - slid));
        self.wanted.truncate(self.bounds.len());
        self.friction.settle(&self.grid.annuli, &self.bounds, &self.wanted)?;
        // annuli out of contact are free: they keep up with what is displaced
        for (slid, moved) in self.slid.iter_mut().zip(&self.friction.displacements) {
            *slid = displacement - moved;
        }
        Ok(self.friction.forces.iter().sum())
    }

    fn stored(&self) -> Option<f64> {
        let pairs = self.friction.forces.iter().zip(&self.friction.displacements);
        Some(pairs.map(|(force, moved)| force * moved).sum::<f64>() / 2.0)
    }

    fn beyond_cone(&self) -> f64 {
        let excess = |(force, bound): (&f64, &f64)| (force.abs() - bound).max(0.0);
        let pairs = self.friction.forces.iter().zip(&self.bounds);
        let worst = pairs.map(excess).fold(0.0, f64::max);
        let greatest = self.bounds.iter().copied().fold(0.0, f64::max);
        if worst > 0.0 { worst / greatest } else { 0.0 }
    }
}

impl Process for MawBarberFawcett {
    fn id(&self) -> &'static str {
        "maw-barber-fawcett"
    }

    fn source(&self) -> &'static str {
        "N. Maw, J. R. Barber, J. N. Fawcett, Wear 38 (1976) 101-114, and J. Lubr. Technol. 103 (1981) 74-80: from memory and from abstracts, originals not consulted"
    }

    fn compliance(&self) -> &Compliance {
        &self.compliance
    }

    fn outcome(&self, alpha: &Alpha<f64>) -> Result<Outcome, NoOutcome> {
        let alpha = checked(alpha)?;
        Outcome::refined(&self.fine, &self.coarse, |grid| self.follow(grid, alpha, &mut |_| ()))
    }
}
