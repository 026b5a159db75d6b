//! The dimensionless state of an oblique collision, and what a law says in its terms.

use kane_number::{Number, Ordered};

/// The collision parameter α = W_tt·μ·I_y/(2·v_t), from grazing (0) to normal collision (∞).
///
/// Dimensionless; W_tt is the tangential entry of the Delassus operator, so that on a sphere this
/// is j_p·μ·I_y/(2·m·v_px0). Source: Wang, Su, Li, equation (7).
#[derive(Clone, Debug, PartialEq)]
pub enum Alpha<N> {
    /// 0 ≤ α < ∞.
    Finite(N),
    /// The limit of normal collision.
    Infinite,
}

/// A value that is no collision parameter.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum InvalidAlpha<N> {
    /// Below zero.
    #[error("alpha is {0}, but must not be negative")]
    Negative(N),
    /// NaN, or an interval that may reach below zero.
    #[error("alpha is {0}, of unknown sign")]
    UnknownSign(N),
}

impl<N: Ordered> Alpha<N> {
    /// Takes a number as α. Exact. A float +∞ is [`Alpha::Infinite`]; −0 counts as 0.
    ///
    /// # Errors
    /// [`InvalidAlpha`] if the number is negative, or not certainly at least zero.
    pub fn new(value: N) -> Result<Self, InvalidAlpha<N>> {
        match value.sign().is_at_least() {
            Some(false) => Err(InvalidAlpha::Negative(value)),
            None => Err(InvalidAlpha::UnknownSign(value)),
            Some(true) if value.is_finite() => Ok(Self::Finite(value)),
            Some(true) => Ok(Self::Infinite),
        }
    }
}

/// A law's answer in dimensionless form; all three are pure numbers.
///
/// Where the contact does not couple, momentum ties them together: i_x = (1 − k)/(2α) and
/// Δe = −i_x·(1 + k)/2 (Wang, Su, Li, equations (9) and (19)).
#[derive(Clone, Debug, PartialEq)]
pub struct Ratios<N> {
    /// k = v_t⁺/v_t, the tangential velocity of the contact point after by before.
    pub k: N,
    /// i_x = −p_t/(μ·p_n) for v_t > 0, the friction by the one of full sliding.
    pub impulse: N,
    /// Δe = ΔE/(μ·p_n·v_t), the work of friction.
    pub energy: N,
}

impl<N: Number> Ratios<N> {
    /// The same ratios in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Ratios<M> {
        Ratios { k: to(&self.k), impulse: to(&self.impulse), energy: to(&self.energy) }
    }

    /// Whether momentum is balanced, 2α·i_x = 1 − k, and energy is the work of the impulse,
    /// 2Δe = −i_x·(1 + k). Meant for exact numbers; floats satisfy it up to rounding.
    #[must_use]
    pub fn is_consistent(&self, alpha: &N) -> bool
    where
        N: PartialEq,
    {
        let momentum = alpha.double() * &self.impulse == N::one() - &self.k;
        let work = self.energy.double() == -(self.impulse.clone() * (N::one() + &self.k));
        momentum && work
    }
}
