//! A round body.

use kane_impact::bodies::Motion;
use kane_number::Number;

use crate::coordinate::half;
use crate::off_plane::OffPlane;
use crate::vector::Vector;

/// A round body and where it is; SI units, y upwards, ω from x to y. It moves in the plane of x and y, or as
/// a sphere in space.
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
    /// Of a sphere in space the rest; `None` for what stays in the plane.
    pub off_plane: Option<OffPlane<N>>,
}

impl<N: Number> Round<N> {
    /// The kinetic energy, m·v²/2 + J·ω²/2; J.
    #[must_use]
    pub fn kinetic_energy(&self) -> N {
        let Motion { vx, vy, omega } = &self.motion;
        let (mut speed, mut spin) = (vx.square() + vy.square(), omega.square());
        if let Some(off) = &self.off_plane {
            speed = speed + off.vz.square();
            spin = spin + off.omega_x.square() + off.omega_y.square();
        }
        half(speed * &self.mass + spin * &self.inertia)
    }

    /// The centre in space.
    pub(crate) fn place(&self) -> Vector<N> {
        let [x, y] = self.position.clone();
        [x, y, self.off_plane.as_ref().map_or_else(N::zero, |off| off.z.clone())]
    }

    /// Its velocity in space.
    pub(crate) fn velocity(&self) -> Vector<N> {
        let Motion { vx, vy, .. } = &self.motion;
        let vz = self.off_plane.as_ref().map_or_else(N::zero, |off| off.vz.clone());
        [vx.clone(), vy.clone(), vz]
    }

    /// The spin as a vector.
    pub(crate) fn spin(&self) -> Vector<N> {
        let of_off = |part: fn(&OffPlane<N>) -> &N| {
            self.off_plane.as_ref().map_or_else(N::zero, |off| part(off).clone())
        };
        [of_off(|off| &off.omega_x), of_off(|off| &off.omega_y), self.motion.omega.clone()]
    }

    /// The same sphere elsewhere in space, in another motion.
    pub(crate) fn moved(&self, place: Vector<N>, velocity: Vector<N>, spin: Vector<N>) -> Self {
        let ([x, y, z], [vx, vy, vz], [omega_x, omega_y, omega]) = (place, velocity, spin);
        Self {
            position: [x, y],
            motion: Motion { vx, vy, omega },
            off_plane: Some(OffPlane { z, vz, omega_x, omega_y }),
            ..self.clone()
        }
    }

    /// The body after a flight of the given time under gravity; s, m/s².
    #[must_use]
    pub fn flown(&self, time: &N, gravity: &N) -> Self {
        let Motion { vx, vy, omega } = &self.motion;
        let [x, y] = &self.position;
        let gained = gravity.clone() * time;
        let mean = vy.clone() - half(gained.clone());
        let off_plane = self.off_plane.as_ref().map(|off| {
            let OffPlane { z, vz, omega_x, omega_y } = off;
            let [vz, omega_x, omega_y] = [vz, omega_x, omega_y].map(N::clone);
            OffPlane { z: vz.mul_add(time, z), vz, omega_x, omega_y }
        });
        Self {
            position: [vx.mul_add(time, x), mean.mul_add(time, y)],
            motion: Motion { vx: vx.clone(), vy: vy.clone() - gained, omega: omega.clone() },
            off_plane,
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
            off_plane: self.off_plane.as_ref().map(|off| off.map(&mut to)),
        }
    }
}
