//! One impact of spheres in space: its contact is planar, in the plane of the normal and the slip.
//!
//! At a sphere no impulse along the normal changes the slip, and one along the slip changes it along itself
//! alone, alike in every direction (W is diagonal, and its tangential entries are equal). So friction against
//! the slip keeps its direction until it is gone, and stays in one plane; a spin about the normal is no slip
//! of a point. `docs/derivations/spatial-sphere.md` proves that for one contact.

use kane_impact::bodies::Ledger;
use kane_impact::{Contact, Delassus, Impulse, NoImpulse};
use kane_number::Interval;

use super::bounce::Struck;
use crate::coordinate::{Coordinate, half};
use crate::encounter::Encounter;
use crate::resolver::Resolver;
use crate::round::Round;
use crate::vector::{Vector, cross, dot, minus, over, plus, square, times};
use crate::world::World;

/// Where spheres touch, and how the wall moves.
pub(super) struct Touch<'a, N> {
    pub(super) encounter: Encounter,
    /// out of the wall or the second body
    pub(super) normal: Vector<N>,
    /// of the wall
    pub(super) velocity: Option<&'a Vector<N>>,
    /// the slip, where it is known to be this
    pub(super) held: Option<&'a Vector<N>>,
}

/// What an impact in space does, beside what one in a plane does.
pub(super) struct StruckInSpace<N> {
    pub(super) struck: Struck<N>,
    /// the direction of the slip
    pub(super) tangent: Vector<N>,
}

const NO_ROOT: NoImpulse =
    NoImpulse::Unrepresentable { law: "contact in space", regime: "speed of slip" };

const TURNS: NoImpulse = NoImpulse::Outside {
    law: "contact in space",
    reason: "a law with a frame of its own turns the axes in one plane, and says nothing in space",
};

/// The speed of a slip and its direction, zero without slip; where an interval does not tell it from none,
/// the direction is any.
fn heading<N: Coordinate>(slip: &Vector<N>) -> Result<(N, Vector<N>), NoImpulse> {
    let speed = square(slip).sqrt().ok_or(NO_ROOT)?;
    let direction = match speed.sign().is_equal() {
        Some(true) => [N::zero(), N::zero(), N::zero()],
        Some(false) => over(slip, &speed),
        None => {
            let any = N::of_enclosure(Interval::between(-1.0, 1.0)).ok_or(NO_ROOT)?;
            [any.clone(), any.clone(), any]
        }
    };
    Ok((speed, direction))
}

/// Which of the axes a normal is along, if it is along one.
fn axis<N: Coordinate>(normal: &Vector<N>) -> Option<usize> {
    let is_one = |k: &usize| normal[*k].square().compare(&N::one()).is_equal() == Some(true);
    (0..3).find(is_one)
}

/// The velocity of the point at −r·n of the first body or r·n of the second, without that of the centre.
fn swept<N: Coordinate>(body: &Round<N>, way: &N, normal: &Vector<N>) -> Vector<N> {
    cross(&body.spin(), &times(&(way.clone() * &body.radius), normal))
}

/// Resolves the impact of a sphere, as it arrives, with a wall or with another sphere.
///
/// # Errors
/// [`NoImpulse`] where the law has no answer, or the number system no speed of the slip.
pub(super) fn strike_in_space<N: Coordinate>(
    resolver: &dyn Resolver<N>,
    world: &World<N>,
    touch: &Touch<'_, N>,
    first: &Round<N>,
    second: Option<&Round<N>>,
) -> Result<StruckInSpace<N>, NoImpulse> {
    let Touch { encounter, normal, velocity, held } = touch;
    let one = N::one();
    let mut relative = plus(&first.velocity(), &swept(first, &-one.clone(), normal));
    let mut nn = one.clone() / &first.mass;
    let mut tt = nn.clone() + first.rotational_mobility();
    let mut separation = dot(&first.velocity(), normal);
    if let Some(body) = second {
        relative = minus(&relative, &plus(&body.velocity(), &swept(body, &one, normal)));
        separation = separation - dot(&body.velocity(), normal);
        let free = one / &body.mass;
        tt = tt + &free + body.rotational_mobility();
        nn = nn + free;
    }
    if let Some(velocity) = velocity {
        relative = minus(&relative, velocity);
        separation = separation - dot(velocity, normal);
    }
    let slip = match held {
        Some(held) => (*held).clone(),
        None => {
            let mut slip = minus(&relative, &times(&separation, normal));
            if let Some(k) = axis(normal) {
                // which an interval would not know
                slip[k] = N::zero();
            }
            slip
        }
    };
    let (speed, tangent) = heading(&slip)?;
    let approach = -separation;
    let restitution = world.restitution_of(*encounter, &approach)?;
    let friction = world.friction_of(*encounter).clone();
    let delassus = Delassus::unchecked(tt, N::zero(), nn);
    let contact = Contact::unchecked(speed.clone(), approach, delassus, friction, restitution);
    if resolver.turns(&contact) {
        return Err(TURNS);
    }
    let outcome = resolver.resolve(&contact)?;
    let Impulse { tangential, normal: push } = &outcome.impulse;

    let mut ledger = Ledger { normal: N::zero(), tangential: N::zero(), rotational: N::zero() };
    let along = times(tangential, &tangent);
    let impulse = plus(&along, &times(push, normal));
    // (−r·n) × p of the first and r·n × (−p) of the second
    let turning = cross(&along, normal);
    let mut apply = |body: &Round<N>, way: &N| {
        let (v, w) = (body.velocity(), body.spin());
        let mut after = plus(&v, &over(&times(way, &impulse), &body.mass));
        if let (None, Some(k)) = (second, axis(normal)) {
            let wall = velocity.map_or_else(N::zero, |velocity| velocity[k].clone());
            after[k] = wall + outcome.separation.clone() * &normal[k];
        }
        let moment = times(&body.radius, &turning);
        let spin = plus(&w, &over(&moment, &body.inertia));
        let mean = plus(&v, &after).map(half);
        let add = |to: &mut N, work: N| *to = to.clone() + work;
        add(&mut ledger.tangential, dot(&mean, &along) * way);
        add(&mut ledger.normal, dot(&mean, normal) * push * way);
        add(&mut ledger.rotational, dot(&plus(&w, &spin).map(half), &moment));
        body.moved(body.place(), after, spin)
    };
    let one = N::one();
    let after = apply(first, &one);
    let second = second.map(|body| apply(body, &-one));
    Ok(StruckInSpace {
        struck: Struck {
            regime: outcome.regime,
            slip: [speed, outcome.slip],
            approach: contact.approach().clone(),
            separation: outcome.separation,
            impulse: outcome.impulse,
            ledger,
            first: after,
            second,
        },
        tangent,
    })
}
