//! What a law sees of a collision.

use kane_number::{Number, Ordered};

use crate::invalid::{finite, fraction, not_negative};
use crate::{Delassus, Impulse, InvalidInput};

/// A planar contact at the moment of touching: all that a rigid law needs to know. SI units.
///
/// The relative velocity of the contact points has a tangential part `v_t`, the slip, and a normal
/// part `v_n` = −a with the approach speed a ≥ 0. [`Delassus`] says how an impulse changes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact<N> {
    slip: N,
    approach: N,
    delassus: Delassus<N>,
    friction: N,
    restitution: N,
}

/// Which way along the tangent a contact faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// `v_t` > 0, or `v_t` = 0 and `W_tn` ≥ 0, so that slip starts forwards if it starts at all.
    Forward,
    /// The mirror image.
    Backward,
}

impl<N: Ordered> Contact<N> {
    /// Describes a contact by `v_t` (m/s), a ≥ 0 (m/s), W, μ ≥ 0 and 0 ≤ e ≤ 1.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first value outside its domain.
    pub fn new(
        slip: N,
        approach: N,
        delassus: Delassus<N>,
        friction: N,
        restitution: N,
    ) -> Result<Self, InvalidInput<N>> {
        Ok(Self {
            slip: finite("the slip", slip)?,
            approach: not_negative("the approach speed", approach)?,
            delassus,
            friction: not_negative("the friction coefficient", friction)?,
            restitution: fraction("the restitution", restitution)?,
        })
    }

    /// Which way the contact faces, or `None` if the number system cannot tell.
    #[must_use]
    pub fn facing(&self) -> Option<Facing> {
        let slip = self.slip.sign();
        if slip.is_greater() == Some(true) {
            return Some(Facing::Forward);
        }
        if slip.is_less() == Some(true) {
            return Some(Facing::Backward);
        }
        // a sign that is known only as "≥ 0" decides too, if the coupling agrees
        let coupling = self.delassus.tn().sign();
        match (slip.is_at_least(), slip.is_at_most()) {
            (Some(true), _) if coupling.is_at_least() == Some(true) => Some(Facing::Forward),
            (_, Some(true)) if coupling.is_less() == Some(true) => Some(Facing::Backward),
            _ => None,
        }
    }
}

impl<N: Number> Contact<N> {
    /// The contact of symbols, or of numbers known to be in their domains: nothing is checked.
    #[must_use]
    pub const fn unchecked(
        slip: N,
        approach: N,
        delassus: Delassus<N>,
        friction: N,
        restitution: N,
    ) -> Self {
        Self { slip, approach, delassus, friction, restitution }
    }

    /// The contact with `v_t` = 1/2, a = 1, e = 0, μ = 1, `W_nn` = 1, without coupling, on which
    /// α is `W_tt`: what a law says in terms of α it says of this contact. All values are exact.
    #[must_use]
    pub fn of_alpha(alpha: N) -> Self {
        let one = N::one;
        let half = one() / one().double();
        let delassus = Delassus::unchecked(alpha, N::zero(), one());
        Self::unchecked(half, one(), delassus, one(), N::zero())
    }

    /// `v_t`, the tangential velocity before the collision, of either sign; m/s.
    #[must_use]
    pub const fn slip(&self) -> &N {
        &self.slip
    }

    /// a = −`v_n` ≥ 0, the speed of approach; m/s.
    #[must_use]
    pub const fn approach(&self) -> &N {
        &self.approach
    }

    /// W, the inverse inertia at the contact; 1/kg.
    #[must_use]
    pub const fn delassus(&self) -> &Delassus<N> {
        &self.delassus
    }

    /// μ ≥ 0, Coulomb's coefficient.
    #[must_use]
    pub const fn friction(&self) -> &N {
        &self.friction
    }

    /// 0 ≤ e ≤ 1, the coefficient of restitution, whatever the hypothesis.
    #[must_use]
    pub const fn restitution(&self) -> &N {
        &self.restitution
    }

    /// (1 + e)·a, the change of normal velocity under Newton's hypothesis; m/s. One rounding.
    #[must_use]
    pub fn closing(&self) -> N {
        self.restitution.mul_add(&self.approach, &self.approach)
    }

    /// `W_nn` − μ·`W_tn`, what a unit of normal impulse adds to the normal velocity while the
    /// contact slides forwards; not positive where it jams; 1/kg.
    #[must_use]
    pub fn separation_rate(&self) -> N {
        (-self.friction.clone()).mul_add(self.delassus.tn(), self.delassus.nn())
    }

    /// μ·`W_tt` − `W_tn`, what a unit of normal impulse takes from a forward slip; 1/kg.
    #[must_use]
    pub fn slowing_rate(&self) -> N {
        self.friction.mul_add(self.delassus.tt(), &-self.delassus.tn().clone())
    }

    /// α = `W_tt`·μ·`p_n`/(2·`v_t`) with Newton's `p_n` = (1 + e)·a/`W_nn` of a contact that does not
    /// couple, with the sign of the slip; `None` if the slip is zero.
    ///
    /// Dimensionless. Source: Wang, Su, Li, equation (7).
    #[must_use]
    pub fn alpha(&self) -> Option<N> {
        let change = self.sliding_impulse() * self.delassus.tt();
        change.checked_div(&self.slip.double())
    }

    /// μ·(1 + e)·a/`W_nn`, the friction of full sliding where the contact does not couple; N·s.
    #[must_use]
    pub fn sliding_impulse(&self) -> N {
        self.closing() / self.delassus.nn() * &self.friction
    }

    /// The impulse with `p_t` = ratio·`p_n` that ends with `v_n` = e·a (Newton):
    /// `p_n` = (1 + e)·a/(`W_nn` + ratio·`W_tn`).
    pub(crate) fn with_ratio(&self, ratio: &N) -> Impulse<N> {
        let normal = self.closing() / ratio.mul_add(self.delassus.tn(), self.delassus.nn());
        Impulse { tangential: normal.clone() * ratio, normal }
    }

    /// The impulse that ends with the given slip and `v_n` = e·a (Newton).
    pub(crate) fn ending_at(&self, slip: &N) -> Impulse<N> {
        let (tangential, normal) = self.numerators_ending_at(slip);
        let determinant = self.delassus.determinant();
        Impulse { tangential: tangential / &determinant, normal: normal / determinant }
    }

    /// det W times the impulse that ends with the given slip and `v_n` = e·a; W⁻¹ is the adjugate
    /// over the determinant.
    pub(crate) fn numerators_ending_at(&self, slip: &N) -> (N, N) {
        let (w, change, closing) = (&self.delassus, slip.clone() - &self.slip, self.closing());
        let tangential = change.clone() * w.nn() - closing.clone() * w.tn();
        let normal = closing * w.tt() - change * w.tn();
        (tangential, normal)
    }

    /// The slip after an impulse: `v_t` + `W_tt·p_t` + `W_tn·p_n`; m/s.
    #[must_use]
    pub fn slip_after(&self, impulse: &Impulse<N>) -> N {
        let w = &self.delassus;
        w.tt().mul_add(&impulse.tangential, &self.slip) + impulse.normal.clone() * w.tn()
    }

    /// The normal velocity after an impulse: −a + `W_tn·p_t` + `W_nn·p_n`; m/s.
    #[must_use]
    pub fn separation_after(&self, impulse: &Impulse<N>) -> N {
        let w = &self.delassus;
        w.nn().mul_add(&impulse.normal, &-self.approach.clone())
            + impulse.tangential.clone() * w.tn()
    }

    /// The kinetic energy that an impulse takes, −p·(v + v⁺)/2 by both directions; J.
    #[must_use]
    pub fn energy_loss(&self, impulse: &Impulse<N>) -> N {
        let tangential = (self.slip_after(impulse) + &self.slip) * &impulse.tangential;
        let normal = (self.separation_after(impulse) - &self.approach) * &impulse.normal;
        -((tangential + normal) / N::one().double())
    }

    /// The contact in the mirror, where the tangent points the other way.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        Self { slip: -self.slip.clone(), delassus: self.delassus.mirrored(), ..self.clone() }
    }

    /// The same contact in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Contact<M> {
        Contact {
            slip: to(&self.slip),
            approach: to(&self.approach),
            delassus: self.delassus.map(&to),
            friction: to(&self.friction),
            restitution: to(&self.restitution),
        }
    }
}
