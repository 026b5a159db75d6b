//! A scene: what collides, what is asked, and how accurately.

use kane_impact::compliant::Loss;
use kane_number::{Interval, Rational};

use crate::quantity::Quantity;
use crate::read::Stated;
use crate::simulate::Until;
use crate::tip::Tip;
use crate::world::World;

/// What collides.
#[derive(Clone, Debug, PartialEq)]
#[allow(clippy::large_enum_variant, reason = "a scene has one of them")]
pub enum Setup<N> {
    /// Round bodies that fly and meet.
    Bodies(World<N>),
    /// One impact of a tip.
    Tip(Tip<N>),
}

impl<N> Setup<N> {
    /// The same in another number system.
    pub fn map<M>(&self, to: impl FnMut(&N) -> M) -> Setup<M> {
        match self {
            Self::Bodies(world) => Setup::Bodies(world.map(to)),
            Self::Tip(tip) => Setup::Tip(tip.map(to)),
        }
    }

    /// Every μ that is stated.
    pub fn frictions(&self) -> Vec<&N> {
        match self {
            Self::Bodies(world) => world.frictions().collect(),
            Self::Tip(tip) => vec![&tip.friction],
        }
    }
}

/// What the author states of the contact along its tangent: what a model is held against.
#[derive(Clone, Debug, PartialEq)]
pub enum Tangential {
    /// Rigid bodies with Coulomb friction at every instant.
    Rigid,
    /// A share of the slip that is given back where the contact does not slide: 0 ≤ β₀ ≤ 1.
    Grip(Rational),
    /// Elastic spheres of this Poisson's ratio.
    Elastic(Rational),
    /// A pair of springs: κ > 0, the tangential by the normal stiffness.
    Springs(Rational),
}

/// A quantity and how far its answer may be off.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// What is asked.
    pub quantity: Quantity,
    /// At least 0, in the unit of the quantity; 0 asks for the exact value.
    pub tolerance: Rational,
}

/// A scene, as read.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The SHA-256 of the file, as 64 hexadecimal digits.
    pub sha256: String,
    /// Heads the report.
    pub title: String,
    /// What collides, with what is not known of it.
    pub setup: Setup<Stated>,
    /// When to stop; a tip has one impact.
    pub until: Until<Rational>,
    /// The contact along its tangent.
    pub tangential: Tangential,
    /// What e < 1 means for an elastic contact, if that is stated.
    pub loss: Option<Loss>,
    /// How many times finer than by default a process steps; 1 as read.
    pub finer: usize,
    /// κ of Hertz's force κ·δ^(3/2), for spheres in a row; N/m^(3/2).
    pub stiffness: Option<Rational>,
    /// At least one.
    pub asked: Vec<Asked>,
}

/// So many numbers may be uncertain: every corner of their box is visited.
pub const MOST_UNCERTAIN: u32 = 6;

impl Scene {
    /// The values as stated.
    #[must_use]
    pub fn nominal(&self) -> Setup<Rational> {
        self.setup.map(|stated| stated.value.clone())
    }

    /// How many numbers are uncertain.
    #[must_use]
    pub fn uncertain(&self) -> u32 {
        let mut count = 0;
        self.setup.map(|stated| count += u32::from(!stated.is_certain()));
        count
    }

    /// Whether flights are in air, which has no closed form.
    #[must_use]
    pub const fn in_air(&self) -> bool {
        matches!(&self.setup, Setup::Bodies(world) if world.air.is_some())
    }

    /// Every state that the author cannot exclude, enclosed.
    #[must_use]
    pub fn enclosed(&self) -> Setup<Interval> {
        self.setup.map(Stated::enclosed)
    }

    /// The corners of the box of such states; none if all is certain.
    #[must_use]
    pub fn corners(&self) -> Vec<Setup<Rational>> {
        let count = self.uncertain();
        let corners = if count == 0 { 0 } else { 1_u64 << count };
        let corner = |corner: u64| {
            let mut index = 0;
            self.setup.map(|stated| {
                if stated.is_certain() {
                    return stated.value.clone();
                }
                let up = corner >> index & 1 == 1;
                index += 1;
                if up { &stated.value + &stated.within } else { &stated.value - &stated.within }
            })
        };
        (0..corners).map(corner).collect()
    }
}
