//! Round bodies among walls, under gravity.

use kane_impact::NoImpulse;

use crate::air::Air;
use crate::coordinate::Coordinate;
use crate::corners::Corners;
use crate::encounter::Encounter;
use crate::plane::Plane;
use crate::round::Round;
use crate::side::Side;
use crate::terms::{Restitution, Terms};

/// A fixed plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall<N> {
    /// Which side of the room it bounds.
    pub side: Side,
    /// Its height, its x, or its z; m.
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
    /// Walls at an angle, or in motion; at most [`MOST_PLANES`](crate::MOST_PLANES).
    pub planes: Vec<Plane<N>>,
    /// At least one.
    pub bodies: Vec<Round<N>>,
    /// Of the only body, if it is not round; its radius is 0 then.
    pub corners: Option<Corners<N>>,
    /// μ ≥ 0 of every contact of which nothing else is stated.
    pub friction: N,
    /// 0 ≤ e ≤ 1, likewise.
    pub restitution: N,
    /// What is stated otherwise; of several the first.
    pub terms: Vec<Terms<N>>,
    /// ρ ≥ 0 of the floor: what rolls on it slows down by ρ·g/(1 + J/(m·r²)).
    pub rolling: N,
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

    /// All walls as planes that bodies in the plane of x and y may meet, those of the room first.
    pub(crate) fn as_planes(&self) -> Vec<(Side, Plane<N>)> {
        let zero = N::zero;
        let (one, at_rest) = (N::one(), [zero(), zero()]);
        let of_side = |wall: &Wall<N>| {
            let (normal, through) = match wall.side {
                Side::Left => ([one.clone(), zero()], [wall.at.clone(), zero()]),
                Side::Right => ([-one.clone(), zero()], [wall.at.clone(), zero()]),
                Side::Ceiling => ([zero(), -one.clone()], [zero(), wall.at.clone()]),
                Side::Floor | Side::Plane(_) | Side::Back | Side::Front => {
                    ([zero(), one.clone()], [zero(), wall.at.clone()])
                }
            };
            (wall.side, Plane { normal, through, velocity: at_rest.clone() })
        };
        let planes = (0..).map(Side::Plane).zip(self.planes.iter().cloned());
        // what stays in the plane meets nothing behind or in front
        let in_plane = |wall: &&Wall<N>| !matches!(wall.side, Side::Back | Side::Front);
        self.walls.iter().filter(in_plane).map(of_side).chain(planes).collect()
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
}

impl<N> World<N> {
    /// Whether its bodies are spheres in space, which all of them are then.
    pub fn is_in_space(&self) -> bool {
        self.bodies.iter().any(|body| body.off_plane.is_some())
    }

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
            corners: self.corners.as_ref().map(|corners| corners.map(&mut to)),
            friction: to(&self.friction),
            restitution: to(&self.restitution),
            terms: self.terms.iter().map(|terms| terms.map(&mut to)).collect(),
            rolling: to(&self.rolling),
        }
    }
}
