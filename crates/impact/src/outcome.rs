//! What a collision leaves behind at the contact.

use kane_number::{Number, Ordered};

use crate::{Contact, Impulse, Ratios};

/// The outcome of a law at a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome<N> {
    /// The name of the regime that applied.
    pub regime: &'static str,
    /// p, N·s.
    pub impulse: Impulse<N>,
    /// `v_t⁺`, the slip afterwards; m/s.
    pub slip: N,
    /// `v_n⁺` ≥ 0, the speed of separation; m/s.
    pub separation: N,
    /// The change of kinetic energy, by the direction of the impulse that made it.
    pub work: Work<N>,
}

/// The work of an impulse: p·(v + v⁺)/2 in each direction; J, negative for a loss.
///
/// The sum is exact for any bodies; the parts are those of an impulse spread evenly over the
/// collision, which a [path](crate::oracle) may divide otherwise. On a sphere the tangential part is the change of tangential and rotational energy together
/// (Wang, Su, Li, equation (18)).
#[derive(Clone, Debug, PartialEq)]
pub struct Work<N> {
    /// `p_n`·(`v_n` + `v_n⁺`)/2.
    pub normal: N,
    /// `p_t`·(`v_t` + `v_t⁺`)/2.
    pub tangential: N,
}

impl<N: Number> Work<N> {
    /// The change of all kinetic energy; J. One rounding of the sum.
    #[must_use]
    pub fn total(&self) -> N {
        self.normal.clone() + &self.tangential
    }

    /// The same work in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Work<M> {
        Work { normal: to(&self.normal), tangential: to(&self.tangential) }
    }
}

impl<N: Number> Outcome<N> {
    /// The outcome in the mirror, where the tangent points the other way.
    #[must_use]
    pub fn mirrored(self) -> Self {
        Self { impulse: self.impulse.mirrored(), slip: -self.slip, ..self }
    }

    /// The same outcome in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Outcome<M> {
        Outcome {
            regime: self.regime,
            impulse: self.impulse.map(&to),
            slip: to(&self.slip),
            separation: to(&self.separation),
            work: self.work.map(&to),
        }
    }

    /// k, i_x and Δe of this outcome, or `None` where a ratio has no meaning: without slip before,
    /// or without friction.
    #[must_use]
    pub fn ratios(&self, contact: &Contact<N>) -> Option<Ratios<N>>
    where
        N: Ordered,
    {
        let sliding = self.impulse.normal.clone() * contact.friction();
        let k = self.slip.checked_div(contact.slip())?;
        let signed = match contact.slip().sign().is_greater()? {
            true => sliding,
            false => -sliding,
        };
        let impulse = (-self.impulse.tangential.clone()).checked_div(&signed)?;
        let energy = self.work.tangential.checked_div(&(signed * contact.slip()))?;
        Some(Ratios { k, impulse, energy })
    }
}
