//! A sphere that meets a fixed plane.

use kane_number::{Number, Ordered};

use crate::contact::{finite, fraction, not_negative, positive};
use crate::{Contact, ImpactLaw, InvalidInput, Ledger, NoRegime};

/// A sphere (or a disc) at the moment it touches a fixed plane; SI units, signs as in the crate docs.
///
/// Plain data: [`contact`](Self::contact) and [`collide`](Self::collide) check it.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereOnPlane<N> {
    /// m > 0, kg.
    pub mass: N,
    /// r > 0, m.
    pub radius: N,
    /// J > 0, the moment of inertia about the centre of mass, kg·m² (solid sphere: 2/5·m·r²).
    pub inertia: N,
    /// μ ≥ 0, Coulomb's coefficient of friction.
    pub friction: N,
    /// 0 ≤ e ≤ 1, Newton's coefficient of normal restitution.
    pub restitution: N,
    /// The motion before the collision, with v_y0 ≥ 0; v_y0 = 0 is grazing.
    pub before: Motion<N>,
}

/// The planar motion of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<N> {
    /// Velocity of the centre of mass along the plane, m/s.
    pub vx: N,
    /// Velocity of the centre of mass into the plane, m/s.
    pub vy: N,
    /// Angular velocity, rad/s, positive if it moves the contact point against x.
    pub omega: N,
}

impl<N: Number> Motion<N> {
    /// v_t = v_x − ω·r, the tangential velocity of the contact point of a sphere; m/s.
    ///
    /// One rounding, of the difference: two would leave no correct digit where the terms cancel.
    #[must_use]
    pub fn slip(&self, radius: &N) -> N {
        (-self.omega.clone()).mul_add(radius, &self.vx)
    }
}

/// The outcome of a collision.
#[derive(Clone, Debug, PartialEq)]
pub struct Rebound<N> {
    /// I_y ≥ 0, N·s.
    pub normal_impulse: N,
    /// I_x, of the sign of the slip before, N·s.
    pub tangential_impulse: N,
    /// The motion after the collision.
    pub after: Motion<N>,
    /// The change of kinetic energy.
    pub energy: Ledger<N>,
}

/// Why a collision has no outcome.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CollideError<N> {
    /// The input is outside the domain, or a result is outside the range of the number system.
    #[error(transparent)]
    Invalid(#[from] InvalidInput<N>),
    /// The law could not choose a regime.
    #[error(transparent)]
    NoRegime(#[from] NoRegime),
}

impl<N: Ordered> SphereOnPlane<N> {
    /// Gives the contact as a law sees it:
    ///
    /// ```text
    /// v_t = v_x0 − ω0·r    I_y = m·(1 + e)·v_y0    W_tt = 1/m + r²/J
    /// ```
    ///
    /// Exact in exact numbers. In floats, barring under- and overflow, the relative errors are at
    /// most u, 3u and 3u (to first order, u half the spacing at 1): the slip is formed with one
    /// rounding, the others have positive terms only.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first input outside its domain, or if v_t, I_y or W_tt overflows.
    pub fn contact(&self) -> Result<Contact<N>, InvalidInput<N>> {
        let mass = positive("the mass", self.mass.clone())?;
        let radius = positive("the radius", self.radius.clone())?;
        let inertia = positive("the moment of inertia", self.inertia.clone())?;
        let restitution = fraction("the restitution", self.restitution.clone())?;
        let approach = not_negative("the approach speed", self.before.vy.clone())?;
        finite("the tangential velocity", self.before.vx.clone())?;
        finite("the angular velocity", self.before.omega.clone())?;

        let slip = self.before.slip(&radius);
        let normal_impulse = (N::one() + restitution) * &mass * approach;
        let mobility = N::one() / mass + radius.square() / inertia;
        Contact::new(slip, normal_impulse, self.friction.clone(), mobility)
    }

    /// Collides under a law: impulses, the motion afterwards, and the energy ledger.
    ///
    /// ```text
    /// v_y = −e·v_y0    v_x = v_x0 − I_x/m    ω = ω0 + r·I_x/J
    /// ```
    ///
    /// Exact in exact numbers; in floats the velocities have three roundings more than the
    /// impulse, relative to the larger of the two terms.
    ///
    /// # Errors
    /// [`CollideError`] if the input is invalid, if the law cannot choose a regime, or if a result
    /// leaves the range of the number system. No NaN is ever returned.
    pub fn collide<L: ImpactLaw>(&self, law: &L) -> Result<Rebound<N>, CollideError<N>> {
        let contact = self.contact()?;
        let impulse = finite("the tangential impulse", law.resolve(&contact)?)?;
        let Motion { vx, vy, omega } = self.before.clone();
        let after = Motion {
            vx: finite("the tangential velocity after", vx - impulse.clone() / &self.mass)?,
            vy: -(vy * &self.restitution),
            omega: finite(
                "the angular velocity after",
                omega + impulse.clone() * &self.radius / &self.inertia,
            )?,
        };
        let energy = Ledger::of(self, contact.normal_impulse(), &impulse, &after);
        finite("the change of energy", energy.total())?;
        Ok(Rebound {
            normal_impulse: contact.normal_impulse().clone(),
            tangential_impulse: impulse,
            after,
            energy,
        })
    }
}
