//! A frame of a law's own, turned against the contact's.

use kane_number::Number;

use crate::bodies::Direction;
use crate::{Contact, Delassus, Impulse};

/// The frame in which a law's statement, friction cone and restitution stand, where that is not the
/// contact's own.
///
/// With c and s of the turn, its axes are t' = c·t + s·n and n' = c·n − s·t: a positive angle leans
/// the normal against a forward slip. Nothing but the axes changes, so the operator becomes
/// W' = R·W·Rᵀ, which couples even where W does not, unless `W_tt` = `W_nn`.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame<N> {
    /// The angle from the contact's frame.
    pub turn: Direction<N>,
    /// The contact as it is seen there, with the restitution that the law has there. Its approach
    /// speed may be of either sign.
    pub contact: Contact<N>,
}

impl<N: Number> Contact<N> {
    /// The same contact seen in turned axes. Exact in exact numbers; floats may cancel.
    #[must_use]
    pub fn turned(&self, turn: &Direction<N>) -> Self {
        let Direction { cos, sin } = turn;
        let slip = cos.clone() * self.slip() - sin.clone() * self.approach();
        let approach = cos.clone() * self.approach() + sin.clone() * self.slip();
        let (mu, e) = (self.friction().clone(), self.restitution().clone());
        Self::unchecked(slip, approach, self.delassus().turned(turn), mu, e)
    }
}

impl<N: Number> Delassus<N> {
    /// R·W·Rᵀ, the same operator in turned axes.
    fn turned(&self, Direction { cos, sin }: &Direction<N>) -> Self {
        let (cc, ss, cs) = (cos.square(), sin.square(), cos.clone() * sin);
        let coupling = (cs.clone() * self.tn()).double();
        Self::unchecked(
            cc.clone() * self.tt() + ss.clone() * self.nn() + &coupling,
            (cc.clone() - &ss) * self.tn() + cs * (self.nn().clone() - self.tt()),
            cc * self.nn() + ss * self.tt() - coupling,
        )
    }
}

impl<N: Number> Impulse<N> {
    /// The same impulse in turned axes.
    #[must_use]
    pub fn turned(&self, Direction { cos, sin }: &Direction<N>) -> Self {
        let Self { tangential, normal } = self;
        Self {
            tangential: cos.clone() * tangential + sin.clone() * normal,
            normal: cos.clone() * normal - sin.clone() * tangential,
        }
    }
}
