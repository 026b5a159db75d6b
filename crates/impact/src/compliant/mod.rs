//! Impact of compliant bodies, in time: processes fitted to nothing, for contacts that do not
//! couple.
//!
//! A rigid law jumps from the state before to the state after. Here the bodies are elastic at the
//! contact, and slip, stick and friction are followed through the collision. What is left of their
//! differences shows how far a rigid law can be trusted.
//!
//! | process | normal | tangential | solved |
//! |---|---|---|---|
//! | [`Bilinear`] | linear spring | linear spring behind a Coulomb slider | in closed form, phase by phase |
//! | [`HertzMindlin`] | Hertz | spring of stiffness 8·G*·a, cut at Coulomb's cone | step by step |
//! | [`MawBarberFawcett`] | Hertz | elastic half-space, Coulomb friction annulus by annulus | step by step |
//! | [`DimensionReduction`] | Hertz | the same half-space as a row of springs | step by step |
//! | [`SpringDashpot`] | linear spring and damper | as for [`Bilinear`] | step by step |
//!
//! # Dimensionless groups
//!
//! All of them depend on three pure numbers alone: [α](crate::Alpha), the restitution e, and
//! χ = κ·j_p/2 of [`Compliance`], where κ is the tangential by the normal stiffness of the contact.
//! Mass, radius, moduli, speed and μ enter through them. Inside, m = 1 and the speed of approach is
//! 1, forces are divided by μ, slips by the one before, ∫`v_t`dt by κ⁻¹ of the same; with y for
//! `v_t`/`v_t0`, g for the friction and F for the normal force,
//!
//! ```text
//! y' = −2χ·g    |g| ≤ λ·F    λ = α/((1 + e)·χ) = 1/ψ1    k = y at the end
//! ```
//!
//! ψ1 = κ·`v_t0`/(μ·`v_n0`) is the variable of Maw, Barber and Fawcett.
//!
//! # Restitution
//!
//! In all of them, the normal force of restitution is that of compression run backwards with a clock
//! that is faster by 1/e: the work given back is e² of the work done (Stronge's hypothesis), and as
//! the mass does not change also Newton's and Poisson's coefficients are e. For linear springs this
//! is Stronge's own unloading; for the others it is our extension of theories for e = 1, which say
//! nothing of e < 1. The size of the contact follows the force.
//!
//! It is one [choice](Loss) of several, and k depends on it: at ν = 0.3 and α = 1, −0.476 for
//! e = 0.98 where the half-space with Tsuji's damper has −0.464, and −0.74 for e = 0.5 where that has
//! −0.48. [`DimensionReduction::damped`] and [`SpringDashpot`] follow the viscous dampers of codes of
//! granular mechanics, so that whoever shows a k can count the difference as an error.
//!
//! ```
//! use kane_impact::Alpha;
//! use kane_impact::compliant::{Bilinear, Compliance, Process};
//!
//! // A solid sphere with ν = 0.3: χ = 7/4·2·(1 − ν)/(2 − ν). It slides all the time at α = 1/2.
//! let sphere = Compliance::of_poisson(3.5, 0.3, 1.0)?;
//! let sliding = Bilinear::new(sphere).outcome(&Alpha::Finite(0.5))?;
//! assert!(sliding.ratios.k.abs() < 1e-12 && (sliding.ratios.impulse - 1.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![allow(clippy::float_arithmetic, reason = "the processes are followed in floats")]

mod annuli;
mod bilinear;
mod compliance;
mod damped;
mod dashpot;
mod hertz;
mod hertz_mindlin;
mod march;
mod maw;
mod reduced;

pub use bilinear::{Bilinear, Piece};
pub use compliance::{Compliance, Elastic};
pub use damped::Loss;
pub use dashpot::SpringDashpot;
pub use hertz_mindlin::{HertzMindlin, Memory};
pub use march::{Ledger, Moment};
pub use maw::MawBarberFawcett;
pub use reduced::DimensionReduction;

use crate::{Alpha, InvalidAlpha, InvalidInput, Ratios};

/// What a contact, or an annulus of it, does for a while.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// It does not slide: what is elastic takes all of the motion.
    Stick,
    /// It slides forwards, friction is at the cone.
    Forward,
    /// The same backwards.
    Backward,
}

impl Grip {
    /// The sign of friction, 0 for stick.
    const fn sign(self) -> f64 {
        match self {
            Self::Stick => 0.0,
            Self::Forward => 1.0,
            Self::Backward => -1.0,
        }
    }
}

/// What a compliant process makes of a collision.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// k, i_x and Δe, each summed up on its own, so that (9) and (19) of Wang, Su and Li are a check.
    pub ratios: Ratios<f64>,
    /// How far k is from the process's own limit of fine steps, estimated; *heuristic*: the
    /// greater difference to the same with a half and with a third of the steps and annuli, which
    /// with 30 annuli was too small in one of twenty collisions and never by a factor of ten, or, for
    /// a closed form, the tolerance of its events.
    pub error: f64,
    /// What was checked at every step.
    pub ledger: Ledger,
}

impl Outcome {
    /// What fine steps give, with the greatest difference to coarser ones as the error: one alone may
    /// vanish by chance, where errors change their sign from grid to grid.
    fn refined<G>(
        fine: &G,
        [half, third]: &[G; 2],
        run: impl Fn(&G) -> Result<(Ratios<f64>, Ledger), NoOutcome>,
    ) -> Result<Self, NoOutcome> {
        let (ratios, ledger) = run(fine)?;
        let error = [run(half)?, run(third)?].map(|(other, _)| (ratios.k - other.k).abs());
        Ok(Self { error: error[0].max(error[1]), ratios, ledger })
    }
}

/// Why there is no outcome.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoOutcome {
    /// Not a collision parameter.
    #[error(transparent)]
    Alpha(#[from] InvalidAlpha<f64>),
    /// A parameter outside its domain.
    #[error(transparent)]
    Input(#[from] InvalidInput<f64>),
    /// More stick and slip than the budget allows: a tangential stiffness far above the normal one.
    #[error("more than {0} changes between stick and slip")]
    TooManyEvents(usize),
    /// No damper takes so much of the speed of approach.
    #[error("no damper gives a restitution of {0}")]
    NoDamper(f64),
    /// Which annuli stick was not found within the budget.
    #[error("which of {annuli} annuli stick was not decided in {rounds} rounds")]
    Unsettled {
        /// How many annuli there are.
        annuli: usize,
        /// How many rounds were made.
        rounds: usize,
    },
    /// A number of steps or annuli outside the budget.
    #[error("{quantity} is {value}, but must be from {least} to {most}")]
    Budget {
        /// What was to be chosen.
        quantity: &'static str,
        /// The choice.
        value: usize,
        /// The least that makes sense.
        least: usize,
        /// The most that is allowed.
        most: usize,
    },
}

/// A compliant process with its parameters and what it may cost.
pub trait Process {
    /// The name of the process in tables and reports.
    fn id(&self) -> &'static str;

    /// Who published it, and what was consulted: one sentence without its full stop.
    fn source(&self) -> &'static str;

    /// χ and e.
    fn compliance(&self) -> &Compliance;

    /// Follows the collision and returns k, i_x and Δe with an estimate of the error of k.
    ///
    /// In the limits, α = 0 is sliding all the time (k = 1, i_x = 1, Δe = −1), and α = ∞ a slip so
    /// small that friction never reaches the cone before the bodies part (i_x = Δe = 0).
    ///
    /// # Errors
    /// [`NoOutcome::Alpha`] for an α that is negative or NaN; [`NoOutcome::TooManyEvents`] or
    /// [`NoOutcome::Unsettled`] where a budget ends.
    fn outcome(&self, alpha: &Alpha<f64>) -> Result<Outcome, NoOutcome>;
}

/// α checked, as a float: ∞ for normal collision.
fn checked(alpha: &Alpha<f64>) -> Result<f64, NoOutcome> {
    let value = match alpha {
        Alpha::Finite(value) => *value,
        Alpha::Infinite => f64::INFINITY,
    };
    match Alpha::new(value)? {
        Alpha::Finite(value) => Ok(value),
        Alpha::Infinite => Ok(f64::INFINITY),
    }
}

/// α → 0: friction is at the cone all the time and changes nothing.
const fn grazing() -> Ratios<f64> {
    Ratios { k: 1.0, impulse: 1.0, energy: -1.0 }
}

fn within(
    quantity: &'static str,
    value: usize,
    least: usize,
    most: usize,
) -> Result<usize, NoOutcome> {
    if (least..=most).contains(&value) {
        Ok(value)
    } else {
        Err(NoOutcome::Budget { quantity, value, least, most })
    }
}
