//! Coulomb friction through a planar impact, integrated in impulse space, event by event.
//!
//! The normal impulse p plays the part of time. Between two events friction is a fixed multiple of
//! it, so that velocities are linear in p and the normal work is quadratic: a piece is integrated
//! exactly, and the events are where one of these functions has a zero. Nothing here is taken from
//! the closed forms of [`laws`](crate::laws); only the contact is shared.

use kane_number::Real;

use crate::{Contact, Impulse, Restitution};

/// What happens at a point of a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Event {
    /// The bodies touch.
    Start,
    /// `v_t` = 0 is reached, and the contact sticks from here on.
    Stick,
    /// `v_t` = 0 is reached, and the contact slides back from here on.
    Reverse,
    /// `v_n` = 0 is reached: compression ends.
    Compressed,
    /// The hypothesis of restitution ends the collision.
    End,
}

/// A point of a path.
#[derive(Clone, Debug, PartialEq)]
pub struct PathEvent<N> {
    /// What happens.
    pub event: Event,
    /// The impulse up to here; N·s.
    pub impulse: Impulse<N>,
    /// `v_t` here; m/s.
    pub slip: N,
    /// `v_n` here, negative in compression; m/s.
    pub normal_velocity: N,
    /// The work of the normal impulse up to here; J.
    pub normal_work: N,
    /// The work of friction up to here, never positive; J.
    pub tangential_work: N,
}

/// The path of a collision through impulse space; at least one event, in order of normal impulse.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<N> {
    /// From [`Event::Start`] to [`Event::End`].
    pub events: Vec<PathEvent<N>>,
}

impl<N> Path<N> {
    /// The end of the path.
    #[must_use]
    pub fn end(&self) -> &PathEvent<N> {
        self.events.last().expect("a path has its start at least")
    }
}

/// Why there is no path.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoPath {
    /// The number system cannot tell which event is next.
    #[error("cannot decide which event is next after {0:?}")]
    Undecided(Event),
    /// The number system does not hold the impulse at which the collision ends.
    #[error("the end of the collision is no number of this system")]
    Unrepresentable,
    /// No event follows, which mechanics excludes: floats beyond their range.
    #[error("no event follows {0:?}")]
    Endless(Event),
}

/// How friction acts on a piece.
#[derive(Clone, Copy)]
enum Friction {
    /// Against a slip that is positive.
    Forward,
    /// Against a slip that is negative.
    Backward,
    /// As much as keeps the contact from slipping.
    Sticking,
}

/// The velocities' rates of change by the normal impulse.
struct Rates<N> {
    friction: N,
    slip: N,
    normal: N,
}

/// More events than any planar path has: start, stop, compression and end.
const MOST_EVENTS: usize = 8;

/// Follows a contact through the impact under a hypothesis of restitution.
///
/// Exact in exact numbers: the end of the energetic hypothesis is the root of a quadratic
/// polynomial, rational or not. In floats heuristic, each event being computed from the one before.
///
/// Source: E. J. Routh's process as stated by J. B. Keller (1986) and W. J. Stronge (1990).
///
/// # Errors
/// [`NoPath`]; never in exact numbers that hold square roots.
pub fn integrate<N: Real>(
    contact: &Contact<N>,
    hypothesis: Restitution,
) -> Result<Path<N>, NoPath> {
    let mut walk = Walk::new(contact, hypothesis);
    while walk.last().event != Event::End {
        if walk.path.events.len() == MOST_EVENTS {
            return Err(NoPath::Endless(walk.last().event));
        }
        walk.step()?;
    }
    Ok(walk.path)
}

struct Walk<'a, N> {
    contact: &'a Contact<N>,
    hypothesis: Restitution,
    path: Path<N>,
}

impl<'a, N: Real> Walk<'a, N> {
    fn new(contact: &'a Contact<N>, hypothesis: Restitution) -> Self {
        let start = PathEvent {
            event: Event::Start,
            impulse: Impulse { tangential: N::zero(), normal: N::zero() },
            slip: contact.slip().clone(),
            normal_velocity: -contact.approach().clone(),
            normal_work: N::zero(),
            tangential_work: N::zero(),
        };
        Self { contact, hypothesis, path: Path { events: vec![start] } }
    }

    fn last(&self) -> &PathEvent<N> {
        self.path.end()
    }

    fn undecided(&self) -> NoPath {
        NoPath::Undecided(self.last().event)
    }

    fn decide(&self, answer: Option<bool>) -> Result<bool, NoPath> {
        answer.ok_or(self.undecided())
    }

    /// Goes on to the next event.
    fn step(&mut self) -> Result<(), NoPath> {
        let here = self.last();
        if here.event == Event::Start && self.decide(here.normal_velocity.sign().is_equal())? {
            let there = PathEvent { event: Event::End, ..here.clone() };
            self.path.events.push(there);
            return Ok(());
        }
        let friction = self.friction()?;
        let rates = self.rates(friction);
        let mut next: Option<(Event, N)> = None;
        for candidate in [self.stop(friction, &rates)?, self.compressed(&rates)?] {
            next = self.earlier(next, candidate)?;
        }
        let end = self.end(&rates, next.as_ref().map(|(_, step)| step))?;
        let (event, step) = self
            .earlier(end.map(|step| (Event::End, step)), next)?
            .ok_or(NoPath::Endless(self.last().event))?;
        let there = self.advance(event, &rates, &step);
        self.path.events.push(there);
        Ok(())
    }

    /// The one that comes first; the first argument if they coincide.
    fn earlier(
        &self,
        a: Option<(Event, N)>,
        b: Option<(Event, N)>,
    ) -> Result<Option<(Event, N)>, NoPath> {
        Ok(match (a, b) {
            (Some(a), Some(b)) => {
                Some(if self.decide(b.1.compare(&a.1).is_less())? { b } else { a })
            }
            (a, b) => a.or(b),
        })
    }

    /// Friction opposes the slip, until the slip stops; what follows then lasts to the end, because
    /// sticking stays sticking, and a slip that starts from rest only grows.
    fn friction(&self) -> Result<Friction, NoPath> {
        if self.has_stopped() {
            return self.without_slip();
        }
        let slip = self.contact.slip().sign();
        if self.decide(slip.is_greater())? {
            return Ok(Friction::Forward);
        }
        if self.decide(slip.is_less())? {
            return Ok(Friction::Backward);
        }
        self.without_slip()
    }

    /// Without slip friction holds the contact if the cone allows, and else the contact slides the
    /// way that it is pushed.
    fn without_slip(&self) -> Result<Friction, NoPath> {
        let (w, mu) = (self.contact.delassus(), self.contact.friction());
        let bound = mu.clone() * w.tt();
        if self.decide(w.tn().compare(&bound).is_greater())? {
            return Ok(Friction::Forward);
        }
        if self.decide(w.tn().compare(&-bound).is_less())? {
            return Ok(Friction::Backward);
        }
        Ok(Friction::Sticking)
    }

    fn has_stopped(&self) -> bool {
        self.path.events.iter().any(|event| matches!(event.event, Event::Stick | Event::Reverse))
    }

    fn rates(&self, friction: Friction) -> Rates<N> {
        let (w, mu) = (self.contact.delassus(), self.contact.friction().clone());
        let (friction, slip) = match friction {
            Friction::Forward => (-mu.clone(), w.tn().clone() - mu * w.tt()),
            Friction::Backward => (mu.clone(), w.tn().clone() + mu * w.tt()),
            Friction::Sticking => (-w.tn().clone() / w.tt(), N::zero()),
        };
        let normal = w.nn().clone() + friction.clone() * w.tn();
        Rates { friction, slip, normal }
    }

    /// How far it is to `v_t` = 0, and what happens there.
    fn stop(&self, friction: Friction, rates: &Rates<N>) -> Result<Option<(Event, N)>, NoPath> {
        let slip = &self.last().slip;
        if self.has_stopped() || self.decide(self.contact.slip().sign().is_equal())? {
            return Ok(None);
        }
        let towards = match friction {
            Friction::Forward => rates.slip.sign().is_less(),
            Friction::Backward => rates.slip.sign().is_greater(),
            Friction::Sticking => Some(false),
        };
        if !self.decide(towards)? {
            return Ok(None);
        }
        let event = match self.without_slip()? {
            Friction::Sticking => Event::Stick,
            Friction::Forward | Friction::Backward => Event::Reverse,
        };
        Ok(Some((event, -(slip.clone() / &rates.slip))))
    }

    /// How far it is to `v_n` = 0, if compression is not over.
    fn compressed(&self, rates: &Rates<N>) -> Result<Option<(Event, N)>, NoPath> {
        let over = self.path.events.iter().any(|event| event.event == Event::Compressed);
        if over || !self.decide(rates.normal.sign().is_greater())? {
            return Ok(None);
        }
        let step = -(self.last().normal_velocity.clone() / &rates.normal);
        Ok(Some((Event::Compressed, step)))
    }

    /// How far it is to the end, if it comes on this piece, which lasts up to `limit`.
    fn end(&self, rates: &Rates<N>, limit: Option<&N>) -> Result<Option<N>, NoPath> {
        let Some(compressed) =
            self.path.events.iter().find(|event| event.event == Event::Compressed)
        else {
            return Ok(None);
        };
        let (here, e) = (self.last(), self.contact.restitution());
        Ok(Some(match self.hypothesis {
            Restitution::Newton => {
                let rebound = e.clone() * self.contact.approach();
                (rebound - &here.normal_velocity) / &rates.normal
            }
            Restitution::Poisson => {
                let whole = (N::one() + e) * &compressed.impulse.normal;
                whole - &here.impulse.normal
            }
            Restitution::Energetic => {
                // v·x + v'·x²/2 = what is still to be given back
                let regained = here.normal_work.clone() - &compressed.normal_work;
                let left = -(e.square() * &compressed.normal_work) - regained;
                let half = rates.normal.clone() / N::one().double();
                let work = |x: &N| (half.clone() * x + &here.normal_velocity) * x;
                if let Some(limit) = limit
                    && self.decide(work(limit).compare(&left).is_less())?
                {
                    return Ok(None);
                }
                // a bound: one of the two terms alone reaches it
                let upper = match limit {
                    Some(limit) => limit.clone(),
                    None => N::one() + left.clone() / &half,
                };
                let polynomial = [-left.clone(), here.normal_velocity.clone(), half.clone()];
                N::greatest_root(&polynomial, &N::zero(), &upper).ok_or(NoPath::Unrepresentable)?
            }
        }))
    }

    fn advance(&self, event: Event, rates: &Rates<N>, step: &N) -> PathEvent<N> {
        let here = self.last();
        // an event that is a zero has it exactly, also where the step to it is only enclosed
        let slip = match event {
            Event::Stick | Event::Reverse => N::zero(),
            _ => here.slip.clone() + rates.slip.clone() * step,
        };
        let normal = match event {
            Event::Compressed => N::zero(),
            _ => here.normal_velocity.clone() + rates.normal.clone() * step,
        };
        // the mean velocity of a piece is the mean of its ends
        let mean = |a: &N, b: &N| (a.clone() + b) / N::one().double();
        let friction = rates.friction.clone() * step;
        PathEvent {
            event,
            impulse: Impulse {
                tangential: here.impulse.tangential.clone() + &friction,
                normal: here.impulse.normal.clone() + step,
            },
            normal_work: here.normal_work.clone() + mean(&here.normal_velocity, &normal) * step,
            tangential_work: here.tangential_work.clone() + mean(&here.slip, &slip) * friction,
            slip,
            normal_velocity: normal,
        }
    }
}
