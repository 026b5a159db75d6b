//! What collides, whatever its kind.

use kane_impact::bodies::{
    CollideError, Collided, Collision, DoublePendulum, Ledger, Motion, SphereOnPlane,
};
use kane_impact::{Contact, InvalidInput, Outcome};
use kane_number::Real;

/// A body, two bodies, or a mechanism, at the moment of touching.
#[derive(Clone, Debug, PartialEq)]
pub enum System<N> {
    /// A round body and a fixed plane, in the paper's signs, y into the plane; what is read and shown
    /// has y away from it.
    Sphere(SphereOnPlane<N>),
    /// Any planar body that meets an obstacle or another body.
    Planar(Collision<N>),
    /// Kane's double pendulum.
    Pendulum(DoublePendulum<N>),
}

/// How a system moves after an impact.
#[derive(Clone, Debug, PartialEq)]
pub struct After<N> {
    /// In the order of [`System::velocities`].
    pub velocities: Vec<N>,
    /// The change of energy by part; a mechanism has no such parts.
    pub ledger: Option<Ledger<N>>,
}

impl<N> System<N> {
    /// What collides, in words.
    #[must_use]
    pub const fn title(&self) -> &'static str {
        match self {
            Self::Sphere(_) => "A round body meets a fixed plane",
            Self::Planar(Collision { other: None, .. }) => "A planar body meets a fixed obstacle",
            Self::Planar(_) => "Two planar bodies meet",
            Self::Pendulum(_) => "A double pendulum strikes the floor",
        }
    }

    /// The signs, in a sentence.
    #[must_use]
    pub const fn signs(&self) -> &'static str {
        match self {
            Self::Sphere(_) => {
                "Signs: x along the plane, y away from it, omega from x to y, the slip v_t = v_x + omega*r; p_t and p_n are on the body."
            }
            Self::Planar(Collision { other: None, .. }) => {
                "Signs: x along the surface, y out of the obstacle into the body, omega from x to y; p_t and p_n are on the body."
            }
            Self::Planar(_) => {
                "Signs: x along the common tangent, y from the second body into the first, omega from x to y; p_t and p_n are on the first body."
            }
            Self::Pendulum(_) => {
                "Signs: angles from the vertical; the tip has v_t = l*(cos q1*u1 + cos q2*u2) and v_n = l*(sin q1*u1 + sin q2*u2)."
            }
        }
    }

    /// Symbol, unit and meaning of each velocity.
    #[must_use]
    pub const fn velocities(&self) -> &'static [(&'static str, &'static str, &'static str)] {
        const SPEED: &str = "m/s";
        const SPIN: &str = "rad/s";
        match self {
            Self::Sphere(_) | Self::Planar(Collision { other: None, .. }) => &[
                ("v_x", SPEED, "of the centre, after"),
                ("v_y", SPEED, "of the centre, after"),
                ("omega", SPIN, "angular velocity after"),
            ],
            Self::Planar(_) => &[
                ("v_x1", SPEED, "of the first centre, after"),
                ("v_y1", SPEED, "of the first centre, after"),
                ("omega1", SPIN, "of the first body, after"),
                ("v_x2", SPEED, "of the second centre, after"),
                ("v_y2", SPEED, "of the second centre, after"),
                ("omega2", SPIN, "of the second body, after"),
            ],
            Self::Pendulum(_) => {
                &[("u1", SPIN, "of the upper rod, after"), ("u2", SPIN, "of the lower rod, after")]
            }
        }
    }

    /// The same system in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> System<M>
    where
        N: kane_number::Number,
    {
        match self {
            Self::Sphere(sphere) => System::Sphere(sphere.map(to)),
            Self::Planar(collision) => System::Planar(collision.map(to)),
            Self::Pendulum(pendulum) => System::Pendulum(pendulum.map(to)),
        }
    }
}

impl<N: Real> System<N> {
    /// The contact as a law sees it, each entry rounded once.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first input outside its domain, or if an entry overflows.
    pub fn contact(&self) -> Result<Contact<N>, InvalidInput<N>> {
        match self {
            Self::Sphere(sphere) => sphere.contact(),
            Self::Planar(collision) => collision.contact(),
            Self::Pendulum(pendulum) => pendulum.contact(),
        }
    }

    /// The kinetic energy before; J.
    #[must_use]
    pub fn kinetic_energy(&self) -> N {
        match self {
            Self::Sphere(sphere) => sphere.collision().kinetic_energy(),
            Self::Planar(collision) => collision.kinetic_energy(),
            Self::Pendulum(pendulum) => pendulum.kinetic_energy(),
        }
    }

    /// What follows of an outcome at the contact, whose impulse is in the signs of mechanics.
    ///
    /// # Errors
    /// [`CollideError`] if a result leaves the range of the number system.
    pub fn after(&self, outcome: &Outcome<N::WideReal>) -> Result<After<N>, CollideError<N>> {
        let three = |motion: Motion<N>| [motion.vx, motion.vy, motion.omega];
        match self {
            Self::Sphere(sphere) => {
                let Collided { after, energy, .. } = sphere.collision().collided(outcome)?;
                Ok(After { velocities: three(after).to_vec(), ledger: Some(energy) })
            }
            Self::Planar(collision) => {
                let Collided { after, other_after, energy, .. } = collision.collided(outcome)?;
                let motions = std::iter::once(after).chain(other_after);
                let velocities = motions.flat_map(three).collect();
                Ok(After { velocities, ledger: Some(energy) })
            }
            Self::Pendulum(pendulum) => {
                let velocities = pendulum.swung(outcome)?.after.to_vec();
                Ok(After { velocities, ledger: None })
            }
        }
    }

    /// The same bodies with other velocities, in the order of [`velocities`](Self::velocities);
    /// those that are not given stay.
    #[must_use]
    pub fn moving(&self, velocities: &[N]) -> Self {
        let motion = |three: &[N]| match three {
            [vx, vy, omega] => {
                Some(Motion { vx: vx.clone(), vy: vy.clone(), omega: omega.clone() })
            }
            _ => None,
        };
        let mut moving = self.clone();
        let mut motions = velocities.chunks(3).map(motion);
        match &mut moving {
            Self::Sphere(sphere) => {
                if let Some(Some(motion)) = motions.next() {
                    // the paper's y points into the plane
                    sphere.before = Motion { vx: motion.vx, vy: -motion.vy, omega: -motion.omega };
                }
            }
            Self::Planar(collision) => {
                let bodies = std::iter::once(&mut collision.body).chain(&mut collision.other);
                for (body, motion) in bodies.zip(motions) {
                    if let Some(motion) = motion {
                        body.before = motion;
                    }
                }
            }
            Self::Pendulum(pendulum) => {
                for (u, new) in pendulum.before.iter_mut().zip(velocities) {
                    *u = new.clone();
                }
            }
        }
        moving
    }
}
