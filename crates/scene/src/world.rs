//! Round bodies among walls, under gravity.

use kane_impact::NoImpulse;
use kane_impact::bodies::Motion;
use kane_number::Number;

use crate::air::Air;
use crate::coordinate::{Coordinate, half};
use crate::plane::Plane;
use crate::simulate::{Bounce, Encounter};
use crate::terms::{Restitution, Terms};

/// A round body and where it is; SI units, y upwards, ω from x to y.
#[derive(Clone, Debug, PartialEq)]
pub struct Round<N> {
    /// m > 0; kg.
    pub mass: N,
    /// J > 0; kg·m².
    pub inertia: N,
    /// r > 0; m.
    pub radius: N,
    /// The centre; m.
    pub position: [N; 2],
    /// Its velocity and the spin.
    pub motion: Motion<N>,
}

/// A world has no more planes.
pub const MOST_PLANES: usize = 8;

/// The side on which a wall bounds the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Side {
    /// below
    Floor,
    /// above
    Ceiling,
    /// at the least x
    Left,
    /// at the greatest x
    Right,
    /// a [`Plane`], by its index
    Plane(u8),
}

/// The ids of planes.
const PLANES: [&str; 8] =
    ["wall-1", "wall-2", "wall-3", "wall-4", "wall-5", "wall-6", "wall-7", "wall-8"];
/// In words.
const PLANES_IN_WORDS: [&str; 8] =
    ["wall 1", "wall 2", "wall 3", "wall 4", "wall 5", "wall 6", "wall 7", "wall 8"];

impl Side {
    /// Its id in files for programs.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Ceiling => "ceiling",
            Self::Left => "left",
            Self::Right => "right",
            Self::Plane(index) => PLANES[(index as usize) % MOST_PLANES],
        }
    }

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Floor => "floor",
            Self::Ceiling => "ceiling",
            Self::Left => "left wall",
            Self::Right => "right wall",
            Self::Plane(index) => PLANES_IN_WORDS[(index as usize) % MOST_PLANES],
        }
    }
}

/// A fixed plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall<N> {
    /// Which side of the room it bounds.
    pub side: Side,
    /// Its height, or its x; m.
    pub at: N,
}

/// Round bodies among walls, under gravity.
#[derive(Clone, Debug, PartialEq)]
pub struct World<N> {
    /// g ≥ 0, downwards; m/s².
    pub gravity: N,
    /// What the bodies fly through; `None` is nothing.
    pub air: Option<Air<N>>,
    /// At most one a side.
    pub walls: Vec<Wall<N>>,
    /// Walls at an angle, or in motion; at most [`MOST_PLANES`].
    pub planes: Vec<Plane<N>>,
    /// At least one.
    pub bodies: Vec<Round<N>>,
    /// μ ≥ 0 of every contact of which nothing else is stated.
    pub friction: N,
    /// 0 ≤ e ≤ 1, likewise.
    pub restitution: N,
    /// What is stated otherwise; of several the first.
    pub terms: Vec<Terms<N>>,
    /// ρ ≥ 0 of the floor: what rolls on it slows down by ρ·g/(1 + J/(m·r²)).
    pub rolling: N,
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

impl<N: Coordinate> World<N> {
    /// The kinetic energy of bodies in this world and that of their heights above where they would lie on
    /// the floor; J. `None` if there is gravity and no floor.
    pub(crate) fn energy(&self, bodies: &[Round<N>]) -> Option<N> {
        let motion = bodies.iter().fold(N::zero(), |sum, body| sum + body.kinetic_energy());
        if self.gravity.sign().is_equal() == Some(true) {
            return Some(motion);
        }
        let floor = &self.walls.iter().find(|wall| wall.side == Side::Floor)?.at;
        let heights = bodies.iter().fold(N::zero(), |sum, body| {
            let height = body.position[1].clone() - floor - &body.radius;
            sum + height * &body.mass * &self.gravity
        });
        Some(motion + heights)
    }

    /// μ of a contact.
    pub(crate) fn friction_of(&self, encounter: Encounter) -> &N {
        let mut own = self.terms.iter().filter(|terms| terms.are_of(encounter));
        own.find_map(|terms| terms.friction.as_ref()).unwrap_or(&self.friction)
    }

    /// e of a contact where it depends on nothing else; `None` where it depends on the speed.
    pub(crate) fn constant_restitution(&self, encounter: Encounter) -> Option<&N> {
        let mut own = self.terms.iter().filter(|terms| terms.are_of(encounter));
        match own.find_map(|terms| terms.restitution.as_ref()) {
            None => Some(&self.restitution),
            Some(Restitution::Constant(e)) => Some(e),
            Some(_) => None,
        }
    }

    /// e of a contact at a speed of approach.
    ///
    /// # Errors
    /// As [`Restitution::at`].
    pub(crate) fn restitution_of(
        &self,
        encounter: Encounter,
        approach: &N,
    ) -> Result<N, NoImpulse> {
        let mut own = self.terms.iter().filter(|terms| terms.are_of(encounter));
        match own.find_map(|terms| terms.restitution.as_ref()) {
            None => Ok(self.restitution.clone()),
            Some(stated) => stated.at(approach),
        }
    }

    /// `W_tt`/`W_nn` of a contact.
    pub(crate) fn mobility_ratio(&self, encounter: Encounter) -> N {
        let free = |index: usize| N::one() / &self.bodies[index].mass;
        let turning = |index: usize| self.bodies[index].rotational_mobility();
        let (nn, turn) = match encounter {
            Encounter::Wall(i, _) => (free(i), turning(i)),
            Encounter::Pair(i, j) => (free(i) + free(j), turning(i) + turning(j)),
        };
        (nn.clone() + turn) / nn
    }

    /// α of an impact, `W_tt`·μ·(1 + e)·a/(2·`W_nn`·`v_t`), with the sign of the slip; `None` without slip.
    pub(crate) fn alpha(&self, bounce: &Bounce<N>) -> Option<N> {
        let ratio = self.mobility_ratio(bounce.encounter);
        let e = self.restitution_of(bounce.encounter, &bounce.approach).ok()?;
        let friction = self.friction_of(bounce.encounter);
        let change = ratio * friction * (N::one() + e) * &bounce.approach;
        change.checked_div(&bounce.slip[0].double())
    }
}

impl<N> World<N> {
    /// Every μ that is stated.
    pub fn frictions(&self) -> impl Iterator<Item = &N> {
        let own = self.terms.iter().filter_map(|terms| terms.friction.as_ref());
        std::iter::once(&self.friction).chain(own)
    }

    /// The same, to be changed.
    pub(crate) fn frictions_mut(&mut self) -> impl Iterator<Item = &mut N> {
        let own = self.terms.iter_mut().filter_map(|terms| terms.friction.as_mut());
        std::iter::once(&mut self.friction).chain(own)
    }

    /// Every e that is stated, to be changed.
    pub(crate) fn restitutions_mut(&mut self) -> impl Iterator<Item = &mut N> {
        let own = self.terms.iter_mut().filter_map(|terms| terms.restitution.as_mut());
        std::iter::once(&mut self.restitution).chain(own.flat_map(Restitution::values_mut))
    }

    /// The same world in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> World<M> {
        World {
            gravity: to(&self.gravity),
            air: self.air.as_ref().map(|air| air.map(&mut to)),
            walls: self
                .walls
                .iter()
                .map(|wall| Wall { side: wall.side, at: to(&wall.at) })
                .collect(),
            planes: self.planes.iter().map(|plane| plane.map(&mut to)).collect(),
            bodies: self.bodies.iter().map(|body| body.map(&mut to)).collect(),
            friction: to(&self.friction),
            restitution: to(&self.restitution),
            terms: self.terms.iter().map(|terms| terms.map(&mut to)).collect(),
            rolling: to(&self.rolling),
        }
    }
}
