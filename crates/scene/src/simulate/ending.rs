//! When a motion ends, and why.

use kane_impact::NoImpulse;

use super::flight::Unknown;
use crate::coordinate::Coordinate;
use crate::round::Round;

/// When to stop.
#[derive(Clone, Debug, PartialEq)]
pub enum Until<N> {
    /// After so many impacts.
    Impacts(u64),
    /// At this time; s.
    Duration(N),
    /// When a bouncing ball has come to rest on the floor.
    Rest,
}

impl<N> Until<N> {
    /// The same in another number system.
    pub fn map<M>(&self, to: impl FnOnce(&N) -> M) -> Until<M> {
        match self {
            Self::Impacts(n) => Until::Impacts(*n),
            Self::Duration(time) => Until::Duration(to(time)),
            Self::Rest => Until::Rest,
        }
    }

    /// Whether so many impacts are what is asked for.
    pub(super) fn is_met(&self, impacts: u64) -> bool {
        matches!(self, Self::Impacts(asked) if *asked <= impacts)
    }
}

impl<N: Coordinate> Until<N> {
    /// The time asked for, if the next event, should there be one, comes later.
    pub(super) fn before(&self, next: Option<&N>) -> Result<Option<&N>, Unknown> {
        let Self::Duration(end) = self else { return Ok(None) };
        let over = match next {
            Some(time) => end.compare(time).is_less().ok_or(Unknown)?,
            None => true,
        };
        Ok(over.then_some(end))
    }
}

/// How much work a motion may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The most impacts that are followed one by one.
    pub impacts: u64,
    /// So many impacts of a ball that comes to rest are shown before the rest of them, infinitely
    /// many, is summed up.
    pub shown: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Self { impacts: 100_000, shown: 12 }
    }
}

/// Why a motion ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The impacts asked for have happened.
    Impacts,
    /// The time is over.
    Duration,
    /// The ball rests on the floor, after infinitely many impacts.
    Rest,
    /// Nothing meets any more.
    Quiet,
}

/// The state at the end.
#[derive(Clone, Debug, PartialEq)]
pub struct End<N> {
    /// s
    pub time: N,
    /// Every body at that time.
    pub bodies: Vec<Round<N>>,
    /// Impacts that were followed one by one.
    pub impacts: u64,
    /// Why it ended.
    pub ending: Ending,
    /// By what a body with corners has turned since the start; rad.
    pub turned: Option<N>,
}

impl<N> End<N> {
    /// The same with other numbers.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> End<M> {
        End {
            time: to(&self.time),
            bodies: self.bodies.iter().map(|body| body.map(&mut to)).collect(),
            impacts: self.impacts,
            ending: self.ending,
            turned: self.turned.as_ref().map(to),
        }
    }
}

/// Why a motion could not be followed to its end.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Stopped {
    /// The law has no answer.
    #[error("impact {impact} at {time} s: {source}")]
    NoImpulse {
        /// Counted from 1.
        impact: u64,
        /// s, rounded
        time: f64,
        /// The law's reason.
        source: NoImpulse,
    },
    /// The number system cannot tell what comes next, or does not hold the time of it.
    #[error("{} the number system cannot tell what comes next", after(*impact, *time))]
    Undecided {
        /// Counted from 1; 0 is the start.
        impact: u64,
        /// s, rounded
        time: f64,
    },
    /// More impacts than the budget allows.
    #[error(
        "{impacts} impacts happened by {time} s, and the end is not reached; many impacts in a short time are a pile that comes to rest, which is summed up for one ball on a floor, under a law whose slip has a sum"
    )]
    Budget {
        /// The budget.
        impacts: u64,
        /// s, rounded
        time: f64,
    },
    /// More steps than are made.
    #[error(
        "{impacts} impacts happened by {time} s, and the flight in air goes on for more steps than are made; a step is at most half a radius long"
    )]
    Steps {
        /// So far.
        impacts: u64,
        /// s, rounded
        time: f64,
    },
    /// Exact numbers have become too long.
    #[error("{} the exact numbers are too long to go on with", after(*impact, *time))]
    Long {
        /// Counted from 1.
        impact: u64,
        /// s, rounded
        time: f64,
    },
    /// The ball never rests.
    #[error("without loss, e = 1, a ball never comes to rest; give `impacts` or `duration_s`")]
    NeverRests,
    /// The rest is that of one ball on a floor.
    #[error(
        "`rest` needs one ball, a floor, no other wall, and gravity; give `impacts` or `duration_s`"
    )]
    NotABall,
    /// A flight in air has no closed form.
    #[error(
        "a flight in air is followed in floats, from impact to impact; give `impacts` or `duration_s`"
    )]
    InAir,
    /// The sums of a ball that comes to rest are of motion in one plane.
    #[error(
        "`rest` is described in one plane, and these spheres move in space; give `impacts` or `duration_s`"
    )]
    RestInSpace,
    /// Friction of several contacts at once in space.
    #[error(
        "impact {impact} at {time} s: a sphere has several contacts at once, with friction; in space friction stays in the plane of its slip for one contact alone, and several at once are not described"
    )]
    AtOnce {
        /// Counted from 1.
        impact: u64,
        /// s, rounded
        time: f64,
    },
    /// The bouncing has no sum.
    #[error(
        "`rest` needs a restitution that does not depend on the speed; give `impacts` or `duration_s`"
    )]
    BySpeed,
    /// What lies on a wall is pressed against it from then on.
    #[error(
        "after impact {impact} at {time} s a body lies on a wall; what lies on something is followed for one ball on a floor without other walls alone"
    )]
    Lies {
        /// Counted from 1.
        impact: u64,
        /// s, rounded
        time: f64,
    },
    /// A side lands flat.
    #[error(
        "impact {impact} at {time} s: two corners meet walls at once; one contact at a time is described"
    )]
    Flat {
        /// Counted from 1.
        impact: u64,
        /// s, rounded
        time: f64,
    },
    /// The ball has come to rest and still slips.
    #[error(
        "the ball lies on the floor and slips, and the model does not say how that goes on; give `rest` or `impacts`"
    )]
    LiesUntold,
}

/// Where a motion is: after an impact, counted from 1, or at the start.
fn after(impact: u64, time: f64) -> String {
    match impact {
        0 => "at the start".to_owned(),
        _ => format!("after impact {impact} at {time} s"),
    }
}

#[cfg(test)]
mod tests {
    use super::Stopped;

    #[test]
    fn what_stops_before_the_first_impact_stops_at_the_start() {
        let of = |impact, time| Stopped::Undecided { impact, time }.to_string();
        assert_eq!(of(0, 0.0), "at the start the number system cannot tell what comes next");
        let later = "after impact 2 at 0.5 s the number system cannot tell what comes next";
        assert_eq!(of(2, 0.5), later);
    }
}
