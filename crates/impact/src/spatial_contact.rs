//! What a law sees of a collision in space.

use kane_number::{Number, Ordered};

use crate::invalid::{finite, fraction, not_negative};
use crate::{InvalidInput, SpatialDelassus};

/// A contact in space at the moment of touching. SI units.
///
/// The axes are those of [`SpatialDelassus`]: x and z are tangents, y is the normal, out of the
/// obstacle and into the body. The relative velocity of the contact points has the slip
/// (`v_x`, `v_z`) and the normal part −a with the approach speed a ≥ 0.
#[derive(Clone, Debug, PartialEq)]
pub struct SpatialContact<N> {
    velocity: [N; 3],
    delassus: SpatialDelassus<N>,
    friction: N,
    restitution: N,
}

impl<N: Ordered> SpatialContact<N> {
    /// Describes a contact by v (m/s) with `v_y` ≤ 0, W, μ ≥ 0 and 0 ≤ e ≤ 1.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first value outside its domain.
    pub fn new(
        velocity: [N; 3],
        delassus: SpatialDelassus<N>,
        friction: N,
        restitution: N,
    ) -> Result<Self, InvalidInput<N>> {
        let [x, y, z] = &velocity;
        finite("the slip", x.clone())?;
        finite("the slip", z.clone())?;
        not_negative("the approach speed", -y.clone())?;
        Ok(Self {
            velocity,
            delassus,
            friction: not_negative("the friction coefficient", friction)?,
            restitution: fraction("the restitution", restitution)?,
        })
    }
}

impl<N: Number> SpatialContact<N> {
    /// v = (`v_x`, −a, `v_z`) before the collision; m/s.
    #[must_use]
    pub const fn velocity(&self) -> &[N; 3] {
        &self.velocity
    }

    /// W; 1/kg.
    #[must_use]
    pub const fn delassus(&self) -> &SpatialDelassus<N> {
        &self.delassus
    }

    /// μ ≥ 0, Coulomb's coefficient.
    #[must_use]
    pub const fn friction(&self) -> &N {
        &self.friction
    }

    /// 0 ≤ e ≤ 1, the coefficient of restitution.
    #[must_use]
    pub const fn restitution(&self) -> &N {
        &self.restitution
    }

    /// The velocity after an impulse: v + W·p; m/s. Exact in exact numbers.
    #[must_use]
    pub fn velocity_after(&self, impulse: &[N; 3]) -> [N; 3] {
        let [x, y, z] = self.delassus.change(impulse);
        let [u, v, w] = &self.velocity;
        [x + u, y + v, z + w]
    }

    /// The kinetic energy that an impulse takes, −p·(v + v⁺)/2; J. Exact in exact numbers.
    #[must_use]
    pub fn energy_loss(&self, impulse: &[N; 3]) -> N {
        let after = self.velocity_after(impulse);
        let parts = impulse.iter().zip(self.velocity.iter().zip(after));
        let twice = parts.map(|(p, (before, after))| (after + before) * p);
        -(twice.fold(N::zero(), |sum, part| sum + part) / N::one().double())
    }

    /// The same contact in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> SpatialContact<M> {
        SpatialContact {
            velocity: self.velocity.each_ref().map(&to),
            delassus: self.delassus.map(&to),
            friction: to(&self.friction),
            restitution: to(&self.restitution),
        }
    }
}
