//! The events of a world, in their order.

use super::bounce::Bounce;
use super::ending::{Budget, End, Ending, Stopped, Until};
use super::flight::Unknown;
use super::space::run_in_space;
use super::state::State;
use crate::coordinate::Coordinate;
use crate::resolver::Resolver;
use crate::world::World;

/// Follows a world, event by event, and tells an observer every impact.
///
/// A flight is in closed form, and the next impact is the earliest root of a polynomial of degree two.
/// Each body keeps the state of its own last impact, so that what does not meet is not rounded. A
/// ball that comes to rest is followed to the end of infinitely many impacts in closed form. Spheres in
/// space are followed likewise, but for rest.
///
/// Exact in exact numbers, and enclosing on intervals, as far as they can tell the order of events; in
/// floats heuristic: each impact rounds, and the errors grow as the motion amplifies them.
///
/// # Errors
/// [`Stopped`].
pub fn run<N: Coordinate>(
    world: &World<N>,
    resolver: &dyn Resolver<N>,
    until: &Until<N>,
    budget: Budget,
    observer: &mut dyn FnMut(&Bounce<N>),
) -> Result<End<N>, Stopped> {
    if world.air.is_some() {
        return Err(Stopped::InAir);
    }
    if world.is_in_space() {
        return run_in_space(world, resolver, until, budget, observer);
    }
    let mut state = State::new(world);
    if matches!(until, Until::Rest) {
        state.can_rest()?;
    }
    for index in 0..world.bodies.len() {
        state.predict(index)?;
    }
    loop {
        if until.is_met(state.impacts) {
            return Ok(state.end(Ending::Impacts));
        }
        let next = state.earliest()?;
        let over = until.before(next.as_ref().map(|(time, _)| time));
        if let Some(end) = over.map_err(|Unknown| state.undecided())? {
            return Ok(state.end_at(end.clone()));
        }
        let Some((time, encounter)) = next else {
            return Ok(state.end(Ending::Quiet));
        };
        if state.impacts == budget.impacts {
            let time = state.now.to_f64();
            return Err(Stopped::Budget { impacts: budget.impacts, time });
        }
        state.impacts += 1;
        let bounce = state.meet(resolver, time, encounter)?;
        observer(&bounce);
        if bounce.time.is_long() || bounce.slip[1].is_long() {
            return Err(Stopped::Long { impact: state.impacts, time: state.now.to_f64() });
        }
        if let Some(end) = state.rests(resolver, until, budget, &bounce)? {
            return Ok(end);
        }
        let looked = state.refresh(encounter);
        // what would come after the last impact is no matter
        if !until.is_met(state.impacts) {
            looked?;
        }
    }
}
