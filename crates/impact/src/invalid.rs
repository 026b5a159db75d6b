//! What no contact and no body can have, and the checks that say so.

use kane_number::{Number, Ordered};

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

impl<N> InvalidInput<N> {
    /// The same complaint about a value in another number system.
    pub fn map<M>(self, to: impl Fn(&N) -> M) -> InvalidInput<M> {
        match self {
            Self::NotFinite { quantity, value } => {
                InvalidInput::NotFinite { quantity, value: to(&value) }
            }
            Self::NotPositive { quantity, value } => {
                InvalidInput::NotPositive { quantity, value: to(&value) }
            }
            Self::Negative { quantity, value } => {
                InvalidInput::Negative { quantity, value: to(&value) }
            }
            Self::AboveOne { quantity, value } => {
                InvalidInput::AboveOne { quantity, value: to(&value) }
            }
        }
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
