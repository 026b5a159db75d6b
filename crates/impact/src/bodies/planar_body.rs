//! A rigid body in the plane, as seen from its contact.

use kane_number::{Number, Ordered};

use super::{Motion, half};
use crate::invalid::{finite, positive};
use crate::{Delassus, Impulse, InvalidInput};

/// Any rigid body in the plane, touched at one point; SI units.
///
/// x is the tangent and y the normal, out of the obstacle and into the body; ω counts from x to y.
/// Plain data: a [`Collision`](super::Collision) checks it.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanarBody<N> {
    /// m > 0; kg.
    pub mass: N,
    /// J > 0, the moment of inertia about the centre of mass; kg·m².
    pub inertia: N,
    /// From the centre of mass to the contact point, along x and y; m.
    pub arm: [N; 2],
    /// The motion before the collision.
    pub before: Motion<N>,
}

impl<N: Number> PlanarBody<N> {
    /// The velocity of the contact point along x and y, m/s:
    /// v_x − ω·arm_y and v_y + ω·arm_x, each with one rounding.
    #[must_use]
    pub fn velocity(&self) -> [N; 2] {
        let Motion { vx, vy, omega } = &self.before;
        let [x, y] = &self.arm;
        [(-omega.clone()).mul_add(y, vx), omega.mul_add(x, vy)]
    }

    /// The inverse inertia at the contact point, 1/kg:
    ///
    /// ```text
    /// W_tt = 1/m + arm_y²/J    W_tn = −arm_x·arm_y/J    W_nn = 1/m + arm_x²/J
    /// ```
    #[must_use]
    pub fn delassus(&self) -> Delassus<N> {
        let [x, y] = &self.arm;
        let free = N::one() / &self.mass;
        let entry = |a: &N, b: &N| a.clone() * b / &self.inertia;
        Delassus::unchecked(free.clone() + entry(y, y), -entry(x, y), free + entry(x, x))
    }

    /// The motion after an impulse at the contact point.
    #[must_use]
    pub fn after(&self, impulse: &Impulse<N>) -> Motion<N> {
        let Motion { vx, vy, omega } = self.before.clone();
        let [x, y] = &self.arm;
        let Impulse { tangential, normal } = impulse;
        let torque = x.clone() * normal - y.clone() * tangential;
        Motion {
            vx: vx + tangential.clone() / &self.mass,
            vy: vy + normal.clone() / &self.mass,
            omega: omega + torque / &self.inertia,
        }
    }

    /// The kinetic energy before, m·v²/2 + J·ω²/2; J.
    #[must_use]
    pub fn kinetic_energy(&self) -> N {
        let Motion { vx, vy, omega } = &self.before;
        half((vx.square() + vy.square()) * &self.mass + omega.square() * &self.inertia)
    }

    /// The same body in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> PlanarBody<M> {
        PlanarBody {
            mass: to(&self.mass),
            inertia: to(&self.inertia),
            arm: [to(&self.arm[0]), to(&self.arm[1])],
            before: self.before.map(&to),
        }
    }
}

impl<N: Ordered> PlanarBody<N> {
    /// # Errors
    /// [`InvalidInput`] for the first value outside its domain.
    pub(super) fn check(&self) -> Result<(), InvalidInput<N>> {
        positive("the mass", self.mass.clone())?;
        positive("the moment of inertia", self.inertia.clone())?;
        for arm in &self.arm {
            finite("the arm of the contact point", arm.clone())?;
        }
        finite("the tangential velocity", self.before.vx.clone())?;
        finite("the normal velocity", self.before.vy.clone())?;
        finite("the angular velocity", self.before.omega.clone())?;
        Ok(())
    }
}
