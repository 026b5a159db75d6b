//! The Delassus operator: the inverse inertia seen at the contact.

use kane_number::{Number, Ordered};

use crate::InvalidInput;
use crate::arithmetic::difference_of_products;
use crate::invalid::{finite, positive};

/// The planar Delassus operator W, a symmetric positive definite 2×2 matrix; 1/kg.
///
/// It maps an impulse (`p_t`, `p_n`) at the contact to the change of the relative velocity there,
///
/// ```text
/// Δv_t = W_tt·p_t + W_tn·p_n      Δv_n = W_tn·p_t + W_nn·p_n
/// ```
///
/// A contact couples where `W_tn` ≠ 0. Source: É. Delassus (1917); called the b-matrix or the
/// collision matrix elsewhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Delassus<N> {
    tt: N,
    tn: N,
    nn: N,
}

impl<N: Ordered> Delassus<N> {
    /// Takes the entries `W_tt` > 0, `W_tn`, `W_nn` > 0 with a positive determinant; 1/kg.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first condition that does not certainly hold.
    pub fn new(tt: N, tn: N, nn: N) -> Result<Self, InvalidInput<N>> {
        let operator = Self {
            tt: positive("the tangential mobility W_tt", tt)?,
            tn: finite("the coupling W_tn", tn)?,
            nn: positive("the normal mobility W_nn", nn)?,
        };
        // Without coupling the entries decide, and a product that underflows does not.
        if operator.tn.sign().is_equal() != Some(true) {
            positive("the determinant of the Delassus operator", operator.determinant())?;
        }
        Ok(operator)
    }
}

impl<N: Number> Delassus<N> {
    /// The operator of symbols, or of numbers known to be positive definite: nothing is checked.
    #[must_use]
    pub const fn unchecked(tt: N, tn: N, nn: N) -> Self {
        Self { tt, tn, nn }
    }

    /// `W_tt` > 0; 1/kg.
    #[must_use]
    pub const fn tt(&self) -> &N {
        &self.tt
    }

    /// `W_tn`, of either sign; 1/kg.
    #[must_use]
    pub const fn tn(&self) -> &N {
        &self.tn
    }

    /// `W_nn` > 0; 1/kg.
    #[must_use]
    pub const fn nn(&self) -> &N {
        &self.nn
    }

    /// `W_tt·W_nn` − `W_tn`² > 0; 1/kg². Within 3/2 ulp in floats, barring under- and overflow.
    #[must_use]
    pub fn determinant(&self) -> N {
        difference_of_products(&self.tt, &self.nn, &self.tn, &self.tn)
    }

    /// The operator in the mirror, where the tangent points the other way.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        Self { tt: self.tt.clone(), tn: -self.tn.clone(), nn: self.nn.clone() }
    }

    /// The operator of two bodies that touch: the sum of theirs.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            tt: self.tt.clone() + &other.tt,
            tn: self.tn.clone() + &other.tn,
            nn: self.nn.clone() + &other.nn,
        }
    }

    /// The same operator in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Delassus<M> {
        Delassus { tt: to(&self.tt), tn: to(&self.tn), nn: to(&self.nn) }
    }
}
