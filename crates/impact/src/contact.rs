//! What a law sees of a collision.

use kane_number::{Number, Ordered};

/// A planar contact whose normal and tangential directions are not coupled.
///
/// The normal impulse is settled before friction acts, as on a sphere, where the centre of mass
/// lies on the contact normal and the Delassus operator (the inverse inertia seen at the contact)
/// is diagonal. SI units; every value is finite, and all but the slip are at least zero.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact<N> {
    slip: N,
    normal_impulse: N,
    friction: N,
    tangential_mobility: N,
}

/// An input that no contact can have.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidInput<N> {
    /// NaN or infinite: given so, or out of the range of the number system when formed.
    #[error("{quantity} is {value}, which is not finite")]
    NotFinite {
        /// The name of the quantity.
        quantity: &'static str,
        /// Its value.
        value: N,
    },
    /// Not certainly above zero.
    #[error("{quantity} is {value}, but must be positive")]
    NotPositive {
        /// The name of the quantity.
        quantity: &'static str,
        /// Its value.
        value: N,
    },
    /// Not certainly at least zero.
    #[error("{quantity} is {value}, but must not be negative")]
    Negative {
        /// The name of the quantity.
        quantity: &'static str,
        /// Its value.
        value: N,
    },
    /// Not certainly at most one.
    #[error("{quantity} is {value}, but must not exceed 1")]
    AboveOne {
        /// The name of the quantity.
        quantity: &'static str,
        /// Its value.
        value: N,
    },
}

impl<N: Ordered> Contact<N> {
    /// Describes a contact by v_t (m/s), I_y ≥ 0 (N·s), μ ≥ 0 and W_tt > 0 (1/kg).
    ///
    /// # Errors
    /// [`InvalidInput`] for the first value outside its domain.
    pub fn new(
        slip: N,
        normal_impulse: N,
        friction: N,
        tangential_mobility: N,
    ) -> Result<Self, InvalidInput<N>> {
        Ok(Self {
            slip: finite("the slip", slip)?,
            normal_impulse: not_negative("the normal impulse", normal_impulse)?,
            friction: not_negative("the friction coefficient", friction)?,
            tangential_mobility: positive("the tangential mobility", tangential_mobility)?,
        })
    }
}

impl<N: Number> Contact<N> {
    /// v_t, the tangential velocity of the contact point before the collision, of either sign; m/s.
    #[must_use]
    pub fn slip(&self) -> &N {
        &self.slip
    }

    /// I_y ≥ 0, the normal impulse of the whole collision; N·s.
    #[must_use]
    pub fn normal_impulse(&self) -> &N {
        &self.normal_impulse
    }

    /// W_tt > 0, the tangential entry of the Delassus operator: Δv_t = −W_tt·I_x; 1/kg.
    #[must_use]
    pub fn tangential_mobility(&self) -> &N {
        &self.tangential_mobility
    }

    /// μ·I_y, the impulse that friction gives if sliding never stops; N·s. One rounding.
    #[must_use]
    pub fn sliding_impulse(&self) -> N {
        self.friction.clone() * &self.normal_impulse
    }

    /// W_tt·μ·I_y, the change of tangential velocity by the sliding impulse; m/s. Two roundings.
    #[must_use]
    pub fn sliding_change(&self) -> N {
        self.sliding_impulse() * &self.tangential_mobility
    }

    /// α = W_tt·μ·I_y/(2·v_t), with the sign of the slip, or `None` if the slip is zero.
    ///
    /// Dimensionless; three roundings. Source: Wang, Su, Li, equation (7).
    #[must_use]
    pub fn alpha(&self) -> Option<N> {
        self.sliding_change().checked_div(&self.slip.double())
    }
}

pub(crate) fn finite<N: Number>(quantity: &'static str, value: N) -> Result<N, InvalidInput<N>> {
    if value.is_finite() { Ok(value) } else { Err(InvalidInput::NotFinite { quantity, value }) }
}

pub(crate) fn positive<N: Ordered>(quantity: &'static str, value: N) -> Result<N, InvalidInput<N>> {
    let value = finite(quantity, value)?;
    match value.sign().is_greater() {
        Some(true) => Ok(value),
        _ => Err(InvalidInput::NotPositive { quantity, value }),
    }
}

pub(crate) fn not_negative<N: Ordered>(
    quantity: &'static str,
    value: N,
) -> Result<N, InvalidInput<N>> {
    let value = finite(quantity, value)?;
    match value.sign().is_at_least() {
        Some(true) => Ok(value),
        _ => Err(InvalidInput::Negative { quantity, value }),
    }
}

pub(crate) fn fraction<N: Ordered>(quantity: &'static str, value: N) -> Result<N, InvalidInput<N>> {
    let value = not_negative(quantity, value)?;
    match value.compare(&N::one()).is_at_most() {
        Some(true) => Ok(value),
        _ => Err(InvalidInput::AboveOne { quantity, value }),
    }
}
