//! What is stated of some contacts otherwise than of all: μ and e of one pair, and e over the speed.

use kane_impact::NoImpulse;

use crate::coordinate::Coordinate;
use crate::encounter::Encounter;

/// e over the speed of approach a; m/s.
#[derive(Clone, Debug, PartialEq)]
pub enum Restitution<N> {
    /// The same at every speed.
    Constant(N),
    /// e = e₁·(v₁/a)^(1/4), and 1 where that is more: a sphere that yields fully plastically and rebounds
    /// elastically. K. L. Johnson, *Contact Mechanics* (1985), section 11.5, from memory. In exact numbers
    /// it has an answer only where the root is one; in floats a few roundings.
    QuarterPower {
        /// v₁ > 0; m/s.
        speed: N,
        /// e₁, from 0 to 1.
        value: N,
    },
    /// Measured: pairs of a speed and e, by speed. Straight between them, constant before the first and
    /// after the last. Exact.
    Table(Vec<[N; 2]>),
}

/// What is stated of one pair, or of every contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Terms<N> {
    /// Who meets; `None` is every contact.
    pub between: Option<Encounter>,
    /// μ ≥ 0, if it is stated.
    pub friction: Option<N>,
    /// e, if it is stated.
    pub restitution: Option<Restitution<N>>,
}

const LAW: &str = "restitution by speed";
const UNDECIDED: NoImpulse = NoImpulse::Undecided { law: LAW, regime: "below a stated speed" };
const NO_ROOT: NoImpulse = NoImpulse::Unrepresentable { law: LAW, regime: "fourth root" };

impl<N: Coordinate> Restitution<N> {
    /// e at a speed of approach.
    ///
    /// # Errors
    /// [`NoImpulse`] where the number system cannot tell which stretch the speed is in, or has no root.
    pub fn at(&self, approach: &N) -> Result<N, NoImpulse> {
        match self {
            Self::Constant(e) => Ok(e.clone()),
            Self::QuarterPower { speed, value } => {
                let lossless = speed.clone() * value.square().square();
                if approach.compare(&lossless).is_at_most().ok_or(UNDECIDED)? {
                    return Ok(N::one());
                }
                let square = (speed.clone() / approach).sqrt().ok_or(NO_ROOT)?;
                Ok(square.sqrt().ok_or(NO_ROOT)? * value)
            }
            Self::Table(points) => {
                let mut before: Option<&[N; 2]> = None;
                for point in points {
                    let [speed, e] = point;
                    if approach.compare(speed).is_at_most().ok_or(UNDECIDED)? {
                        return Ok(match before {
                            None => e.clone(),
                            Some([slower, more]) => {
                                let part = (approach.clone() - slower) / (speed.clone() - slower);
                                (e.clone() - more).mul_add(&part, more)
                            }
                        });
                    }
                    before = Some(point);
                }
                before.map(|[_, e]| e.clone()).ok_or(UNDECIDED)
            }
        }
    }
}

impl<N> Restitution<N> {
    /// The same in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Restitution<M> {
        match self {
            Self::Constant(e) => Restitution::Constant(to(e)),
            Self::QuarterPower { speed, value } => {
                Restitution::QuarterPower { speed: to(speed), value: to(value) }
            }
            Self::Table(points) => {
                let point = |[speed, e]: &[N; 2]| [to(speed), to(e)];
                Restitution::Table(points.iter().map(point).collect())
            }
        }
    }

    /// The values of e in it, to be changed.
    pub(crate) fn values_mut(&mut self) -> Vec<&mut N> {
        match self {
            Self::Constant(e) => vec![e],
            Self::QuarterPower { value, .. } => vec![value],
            Self::Table(points) => points.iter_mut().map(|[_, e]| e).collect(),
        }
    }
}

impl<N> Terms<N> {
    /// The same in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Terms<M> {
        Terms {
            between: self.between,
            friction: self.friction.as_ref().map(&mut to),
            restitution: self.restitution.as_ref().map(|e| e.map(&mut to)),
        }
    }

    /// Whether they are of a contact.
    pub(crate) fn are_of(&self, encounter: Encounter) -> bool {
        self.between.is_none_or(|between| between == encounter)
    }
}
