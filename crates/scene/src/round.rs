//! A round body.

use kane_impact::bodies::Motion;
use kane_number::Number;

use crate::coordinate::half;

/// A round body and where it is; SI units, y upwards, ω from x to y.
#[derive(Clone, Debug, PartialEq)]
pub struct Round<N> {
    /// m > 0; kg.
    pub mass: N,
    /// J > 0; kg·m².
    pub inertia: N,
    /// r > 0, or 0 for the centre of a body with [`Corners`](crate::Corners); m.
    pub radius: N,
    /// The centre; m.
    pub position: [N; 2],
    /// Its velocity and the spin.
    pub motion: Motion<N>,
}

impl<N: Number> Round<N> {
    /// The kinetic energy, m·v²/2 + J·ω²/2; J.
    #[must_use]
    pub fn kinetic_energy(&self) -> N {
        let Motion { vx, vy, omega } = &self.motion;
        half((vx.square() + vy.square()) * &self.mass + omega.square() * &self.inertia)
    }

    /// The body after a flight of the given time under gravity; s, m/s².
    #[must_use]
    pub fn flown(&self, time: &N, gravity: &N) -> Self {
        let Motion { vx, vy, omega } = &self.motion;
        let [x, y] = &self.position;
        let gained = gravity.clone() * time;
        let mean = vy.clone() - half(gained.clone());
        Self {
            position: [vx.mul_add(time, x), mean.mul_add(time, y)],
            motion: Motion { vx: vx.clone(), vy: vy.clone() - gained, omega: omega.clone() },
            ..self.clone()
        }
    }

    /// The radius across J: r²/J, the rotational part of the tangential mobility; 1/kg.
    pub(crate) fn rotational_mobility(&self) -> N {
        self.radius.square() / &self.inertia
    }
}

impl<N> Round<N> {
    /// The same body in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Round<M> {
        let [x, y] = &self.position;
        let Motion { vx, vy, omega } = &self.motion;
        Round {
            mass: to(&self.mass),
            inertia: to(&self.inertia),
            radius: to(&self.radius),
            position: [to(x), to(y)],
            motion: Motion { vx: to(vx), vy: to(vy), omega: to(omega) },
        }
    }
}
