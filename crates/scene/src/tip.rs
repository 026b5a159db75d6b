//! Bodies that meet a floor with a tip, off their normal, so that the contact couples.

use kane_impact::bodies::{Collision, Direction, DoublePendulum, Motion, PlanarBody};
use kane_impact::{Contact, InvalidInput};
use kane_number::{Rational, Real};

use crate::collide::System;

/// What has the tip; SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum TipBody<N> {
    /// A thin uniform rod.
    Rod {
        /// m > 0; kg.
        mass: N,
        /// l > 0; m.
        length: N,
        /// From the tip up to the centre, by the angle with the floor.
        direction: Direction<Rational>,
        /// Of the centre of mass.
        motion: Motion<N>,
    },
    /// Kane's double pendulum.
    Pendulum {
        /// m > 0 of each rod; kg.
        mass: N,
        /// l > 0 of each rod; m.
        length: N,
        /// From the vertical.
        angles: [Direction<Rational>; 2],
        /// u1, u2; rad/s.
        speeds: [N; 2],
    },
}

/// One impact of a tip on a floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Tip<N> {
    /// What has the tip.
    pub body: TipBody<N>,
    /// μ ≥ 0.
    pub friction: N,
    /// 0 ≤ e ≤ 1.
    pub restitution: N,
}

impl<N> Tip<N> {
    /// The same impact in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Tip<M> {
        let body = match &self.body {
            TipBody::Rod { mass, length, direction, motion } => TipBody::Rod {
                mass: to(mass),
                length: to(length),
                direction: direction.clone(),
                motion: Motion { vx: to(&motion.vx), vy: to(&motion.vy), omega: to(&motion.omega) },
            },
            TipBody::Pendulum { mass, length, angles, speeds: [first, second] } => {
                TipBody::Pendulum {
                    mass: to(mass),
                    length: to(length),
                    angles: angles.clone(),
                    speeds: [to(first), to(second)],
                }
            }
        };
        Tip { body, friction: to(&self.friction), restitution: to(&self.restitution) }
    }
}

impl<N: Real> Tip<N> {
    /// The collision that this is.
    #[must_use]
    pub fn system(&self) -> System<N> {
        let (friction, restitution) = (self.friction.clone(), self.restitution.clone());
        match &self.body {
            TipBody::Rod { mass, length, direction, motion } => {
                let direction = direction.map(N::from_rational);
                let body =
                    PlanarBody::rod_tip(mass.clone(), length.clone(), &direction, motion.clone());
                System::Planar(Collision { body, other: None, friction, restitution })
            }
            TipBody::Pendulum { mass, length, angles: [first, second], speeds } => {
                System::Pendulum(DoublePendulum {
                    mass: mass.clone(),
                    length: length.clone(),
                    angles: [first.map(N::from_rational), second.map(N::from_rational)],
                    before: speeds.clone(),
                    friction,
                    restitution,
                })
            }
        }
    }

    /// The contact, and the kinetic energy before in J.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first value outside its domain.
    pub fn contact(&self) -> Result<(Contact<N>, N), InvalidInput<N>> {
        let system = self.system();
        Ok((system.contact()?, system.kinetic_energy()))
    }
}
