//! What can be asked of a scene.

use std::fmt;

use kane_algebra::syntax::nearest_with_unit;

use crate::coordinate::Coordinate;
use crate::simulate::{Bounce, End};
use crate::world::World;

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    /// The time of the end; s.
    Time,
    /// The centre of a body at the end; m.
    X,
    /// Its height; m.
    Y,
    /// Its velocity along x at the end; m/s.
    Vx,
    /// And along y; m/s.
    Vy,
    /// Its spin, about z; rad/s.
    Omega,
    /// The centre of a sphere in space along z, at the end; m.
    Z,
    /// Its velocity along z; m/s.
    Vz,
    /// Its spin about x; rad/s.
    OmegaX,
    /// And about y; rad/s.
    OmegaY,
    /// By what a body with corners has turned since the start, at the end; rad.
    Turned,
    /// The kinetic energy of all bodies at the end; J.
    Energy,
    /// The energy of motion and height at the end by that at the start, heights counted from where a
    /// body lies on the floor; behind one impact of a tip, T⁺/T.
    EnergyRatio,
    /// k = `v_t⁺`/`v_t` of the first impact.
    K,
    /// `p_t` of the first impact; N·s.
    TangentialImpulse,
    /// `p_n` of the first impact; N·s.
    NormalImpulse,
    /// `v_t⁺` of the first impact; m/s.
    Slip,
    /// `v_n⁺` of the first impact; m/s.
    Separation,
}

impl Kind {
    const ALL: [(Self, &'static str, &'static str); 18] = [
        (Self::Time, "time_s", "s"),
        (Self::X, "x_m", "m"),
        (Self::Y, "y_m", "m"),
        (Self::Vx, "v_x_m_s", "m/s"),
        (Self::Vy, "v_y_m_s", "m/s"),
        (Self::Omega, "omega_rad_s", "rad/s"),
        (Self::Z, "z_m", "m"),
        (Self::Vz, "v_z_m_s", "m/s"),
        (Self::OmegaX, "omega_x_rad_s", "rad/s"),
        (Self::OmegaY, "omega_y_rad_s", "rad/s"),
        (Self::Turned, "turned_rad", "rad"),
        (Self::Energy, "kinetic_energy_j", "J"),
        (Self::EnergyRatio, "energy_ratio", ""),
        (Self::K, "k", ""),
        (Self::TangentialImpulse, "p_t_n_s", "N·s"),
        (Self::NormalImpulse, "p_n_n_s", "N·s"),
        (Self::Slip, "v_t_m_s", "m/s"),
        (Self::Separation, "v_n_m_s", "m/s"),
    ];

    /// Whether it is of one body, of which there may be several.
    const fn is_of_a_body(self) -> bool {
        self.is_off_plane() || matches!(self, Self::X | Self::Y | Self::Vx | Self::Vy | Self::Omega)
    }

    /// Whether it is of spheres in space.
    pub(crate) const fn is_off_plane(self) -> bool {
        matches!(self, Self::Z | Self::Vz | Self::OmegaX | Self::OmegaY)
    }

    /// Whether one impact of a tip answers it.
    pub(crate) const fn is_of_a_tip(self) -> bool {
        matches!(
            self,
            Self::K
                | Self::TangentialImpulse
                | Self::NormalImpulse
                | Self::Slip
                | Self::Separation
                | Self::EnergyRatio
        )
    }
}

/// A quantity of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Quantity {
    /// What is measured.
    pub kind: Kind,
    /// Of which body, from 0.
    pub body: usize,
}

impl Quantity {
    /// Reads the key of a file: a name, and for a body other than the first `_of_2` and so on.
    ///
    /// # Errors
    /// That nothing is called so, with what may have been meant.
    pub fn parse(key: &str) -> Result<Self, String> {
        let (name, body) = match key.rsplit_once("_of_") {
            Some((name, number)) => {
                (name, number.parse::<usize>().ok().and_then(|n| n.checked_sub(1)))
            }
            None => (key, Some(0)),
        };
        let found = Kind::ALL.iter().find(|(_, known, _)| *known == name);
        match (found, body) {
            (Some((kind, ..)), Some(body)) if body == 0 || kind.is_of_a_body() => {
                Ok(Self { kind: *kind, body })
            }
            (Some(_), _) => Err(format!(
                "nothing is called `{key}`; bodies are counted from 1, and velocities, positions and spin alone are of a body"
            )),
            (None, _) => {
                let known = Kind::ALL.iter().map(|(_, known, _)| *known);
                let hint = match nearest_with_unit(name, known.clone()) {
                    Some(near) => format!("did you mean `{near}`?"),
                    None => format!("there are {}", known.collect::<Vec<_>>().join(", ")),
                };
                Err(format!("nothing is called `{key}`; {hint}"))
            }
        }
    }

    /// The unit, empty for a pure number.
    #[must_use]
    pub fn unit(self) -> &'static str {
        Kind::ALL.iter().find(|(kind, ..)| *kind == self.kind).map_or("", |(_, _, unit)| unit)
    }

    /// The value, or `None` where it has no meaning: k without slip, say.
    pub(crate) fn of<N: Coordinate>(
        self,
        world: &World<N>,
        first: Option<&Bounce<N>>,
        end: &End<N>,
    ) -> Option<N> {
        let body = end.bodies.get(self.body);
        let off_plane = || body.and_then(|body| body.off_plane.as_ref());
        let energy = || end.bodies.iter().fold(N::zero(), |sum, body| sum + body.kinetic_energy());
        match self.kind {
            Kind::Time => Some(end.time.clone()),
            Kind::X => body.map(|body| body.position[0].clone()),
            Kind::Y => body.map(|body| body.position[1].clone()),
            Kind::Vx => body.map(|body| body.motion.vx.clone()),
            Kind::Vy => body.map(|body| body.motion.vy.clone()),
            Kind::Omega => body.map(|body| body.motion.omega.clone()),
            Kind::Z => off_plane().map(|off| off.z.clone()),
            Kind::Vz => off_plane().map(|off| off.vz.clone()),
            Kind::OmegaX => off_plane().map(|off| off.omega_x.clone()),
            Kind::OmegaY => off_plane().map(|off| off.omega_y.clone()),
            Kind::Turned => end.turned.clone(),
            Kind::Energy => Some(energy()),
            Kind::EnergyRatio => {
                world.energy(&end.bodies)?.checked_div(&world.energy(&world.bodies)?)
            }
            Kind::K => first.and_then(|bounce| bounce.slip[1].checked_div(&bounce.slip[0])),
            Kind::TangentialImpulse => first.map(|bounce| bounce.impulse.tangential.clone()),
            Kind::NormalImpulse => first.map(|bounce| bounce.impulse.normal.clone()),
            Kind::Slip => first.map(|bounce| bounce.slip[1].clone()),
            Kind::Separation => first.map(|bounce| bounce.separation.clone()),
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = Kind::ALL.iter().find(|(kind, ..)| *kind == self.kind).map_or("", |(_, n, _)| n);
        if self.body == 0 { f.pad(name) } else { f.pad(&format!("{name}_of_{}", self.body + 1)) }
    }
}
