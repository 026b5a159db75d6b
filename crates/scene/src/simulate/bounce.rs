//! One impact of round bodies: from the bodies to the contact, and back.

use kane_impact::bodies::{Ledger, Motion};
use kane_impact::{Contact, Delassus, Impulse, NoImpulse};

use crate::coordinate::{Coordinate, half};
use crate::encounter::Encounter;
use crate::resolver::Resolver;
use crate::round::Round;
use crate::side::Side;
use crate::world::World;

/// An impact, with all that is to be told of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounce<N> {
    /// When; s.
    pub time: N,
    /// Who.
    pub encounter: Encounter,
    /// What happened at the contact.
    pub regime: &'static str,
    /// `v_t` before and after; m/s.
    pub slip: [N; 2],
    /// The speed of approach; m/s.
    pub approach: N,
    /// The speed of separation; m/s.
    pub separation: N,
    /// The impulse on the first body; N·s.
    pub impulse: Impulse<N>,
    /// The change of kinetic energy by part, along the normal and the tangent of this contact.
    pub ledger: Ledger<N>,
    /// The work of gravity on these bodies since the impact before of each; J.
    pub gravity: N,
    /// The work of the air on these bodies since then; `None` where there is no air; J.
    pub air: Option<N>,
    /// Of spheres in space: the direction of the slip, zero without slip, and the normal, out of the wall or
    /// the second body.
    pub axes: Option<[[N; 3]; 2]>,
    /// Of a body with corners: which one struck, from 0, and by what the body has turned since the start; rad.
    pub corner: Option<(usize, N)>,
    /// The bodies afterwards; the second is absent at a wall.
    pub after: (Round<N>, Option<Round<N>>),
}

impl<N> Bounce<N> {
    /// The bodies that meet, by their index, in the order of `after`.
    pub fn bodies(&self) -> impl Iterator<Item = usize> {
        let (first, second) = match self.encounter {
            Encounter::Wall(i, _) => (i, None),
            Encounter::Pair(i, j) => (i, Some(j)),
        };
        std::iter::once(first).chain(second)
    }

    /// The same impact with other numbers.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Bounce<M> {
        Bounce {
            time: to(&self.time),
            encounter: self.encounter,
            regime: self.regime,
            slip: [to(&self.slip[0]), to(&self.slip[1])],
            approach: to(&self.approach),
            separation: to(&self.separation),
            impulse: Impulse {
                tangential: to(&self.impulse.tangential),
                normal: to(&self.impulse.normal),
            },
            ledger: Ledger {
                normal: to(&self.ledger.normal),
                tangential: to(&self.ledger.tangential),
                rotational: to(&self.ledger.rotational),
            },
            gravity: to(&self.gravity),
            air: self.air.as_ref().map(&mut to),
            axes: self.axes.as_ref().map(|axes| {
                let mut vector = |v: &[N; 3]| {
                    let [x, y, z] = v;
                    [to(x), to(y), to(z)]
                };
                let [tangent, normal] = axes;
                [vector(tangent), vector(normal)]
            }),
            corner: self.corner.as_ref().map(|(corner, angle)| (*corner, to(angle))),
            after: (self.after.0.map(&mut to), self.after.1.as_ref().map(|body| body.map(&mut to))),
        }
    }
}

impl<N: Coordinate> World<N> {
    /// α of an impact, `W_tt`·μ·(1 + e)·a/(2·`W_nn`·`v_t`), with the sign of the slip; `None` without slip.
    pub(crate) fn alpha(&self, bounce: &Bounce<N>) -> Option<N> {
        let ratio = self.mobility_ratio(bounce.encounter);
        let e = self.restitution_of(bounce.encounter, &bounce.approach).ok()?;
        let friction = self.friction_of(bounce.encounter);
        let change = ratio * friction * (N::one() + e) * &bounce.approach;
        change.checked_div(&bounce.slip[0].double())
    }
}

/// The outward normal of a wall, and with it the tangent, such that tangent and normal turn like x
/// and y.
pub(super) fn normal_of<N: Coordinate>(world: &World<N>, side: Side) -> [N; 2] {
    let (zero, one) = (N::zero(), N::one());
    match side {
        Side::Floor | Side::Back | Side::Front => [zero, one],
        Side::Ceiling => [zero, -one],
        Side::Left => [one, zero],
        Side::Right => [-one, zero],
        Side::Plane(index) => match world.planes.get(usize::from(index)) {
            Some(plane) => plane.normal.clone(),
            None => [zero, one],
        },
    }
}

/// Tangential and normal component of a vector, for the normal n: the tangent is (`n_y`, −`n_x`).
pub(super) fn turned<N: Coordinate>([x, y]: [&N; 2], [nx, ny]: &[N; 2]) -> [N; 2] {
    let along = x.clone() * ny - y.clone() * nx;
    let out = x.clone() * nx + y.clone() * ny;
    [along, out]
}

/// The vector of these components.
pub(super) fn turned_back<N: Coordinate>([t, n]: [N; 2], [nx, ny]: &[N; 2]) -> [N; 2] {
    [t.clone() * ny + n.clone() * nx, n * ny - t * nx]
}

/// What an impact does to the bodies.
pub(super) struct Struck<N> {
    pub(super) regime: &'static str,
    pub(super) slip: [N; 2],
    pub(super) approach: N,
    pub(super) separation: N,
    pub(super) impulse: Impulse<N>,
    pub(super) ledger: Ledger<N>,
    pub(super) first: Round<N>,
    pub(super) second: Option<Round<N>>,
}

impl<N> Struck<N> {
    /// The impact of these at a time, with the work of gravity since those before.
    pub(super) fn at(self, time: N, encounter: Encounter, gravity: N) -> Bounce<N> {
        let Self { regime, slip, approach, separation, impulse, ledger, first, second } = self;
        let after = (first, second);
        Bounce {
            time,
            encounter,
            regime,
            slip,
            approach,
            separation,
            impulse,
            ledger,
            gravity,
            air: None,
            axes: None,
            corner: None,
            after,
        }
    }
}

/// Resolves the impact of a body, as it arrives, with a wall or with another body, on what the world
/// states of their contact. `held` is the slip that the contact is known to have, where forming it anew
/// would cancel.
#[inline]
pub(super) fn strike<N: Coordinate>(
    resolver: &dyn Resolver<N>,
    (world, encounter): (&World<N>, Encounter),
    normal: &[N; 2],
    first: &Round<N>,
    second: Option<&Round<N>>,
    held: Option<&N>,
) -> Result<Struck<N>, NoImpulse> {
    let components = |body: &Round<N>| turned([&body.motion.vx, &body.motion.vy], normal);
    let [vt, vn] = components(first);
    let mut slip = match held {
        Some(held) => held.clone(),
        None => first.motion.omega.mul_add(&first.radius, &vt),
    };
    let mut separation = vn.clone();
    let mut nn = N::one() / &first.mass;
    let mut tt = nn.clone() + first.rotational_mobility();
    let other = second.map(|body| (body, components(body)));
    if let Some((body, [wt, wn])) = &other {
        slip = slip - (wt.clone() - body.motion.omega.clone() * &body.radius);
        separation = separation - wn;
        let free = N::one() / &body.mass;
        tt = tt + &free + body.rotational_mobility();
        nn = nn + free;
    }
    let wall = match encounter {
        Encounter::Wall(_, Side::Plane(index)) => world.planes.get(usize::from(index)),
        _ => None,
    };
    if let Some([along, out]) = wall.map(|plane| &plane.velocity) {
        slip = slip - along;
        separation = separation - out;
    }
    let delassus = Delassus::unchecked(tt, N::zero(), nn);
    let approach = -separation;
    let restitution = world.restitution_of(encounter, &approach)?;
    let friction = world.friction_of(encounter).clone();
    let contact = Contact::unchecked(slip.clone(), approach, delassus, friction, restitution);
    let outcome = resolver.resolve(&contact)?;
    let Impulse { tangential, normal: push } = &outcome.impulse;

    let mut ledger = Ledger { normal: N::zero(), tangential: N::zero(), rotational: N::zero() };
    // one body, by the impulse on it and its moment about the centre
    let mut apply = |body: &Round<N>, [t, n]: &[N; 2], p: [&N; 2], moment: &N, exact: Option<N>| {
        let after_t = t.clone() + p[0].clone() / &body.mass;
        let after_n = exact.unwrap_or_else(|| n.clone() + p[1].clone() / &body.mass);
        let omega = body.motion.omega.clone() + moment.clone() / &body.inertia;
        let mean = |a: &N, b: &N| half(a.clone() + b);
        let add = |to: &mut N, work: N| *to = to.clone() + work;
        add(&mut ledger.tangential, mean(t, &after_t) * p[0]);
        add(&mut ledger.normal, mean(n, &after_n) * p[1]);
        add(&mut ledger.rotational, mean(&body.motion.omega, &omega) * moment);
        let [vx, vy] = turned_back([after_t, after_n], normal);
        Round { motion: Motion { vx, vy, omega }, ..body.clone() }
    };
    // the contact point of the first is at −r·n, that of the second at +r·n
    let moment = first.radius.clone() * tangential;
    let exact = other.is_none().then(|| match wall {
        Some(plane) => outcome.separation.clone() + &plane.velocity[1],
        None => outcome.separation.clone(),
    });
    let struck = apply(first, &[vt, vn], [tangential, push], &moment, exact);
    let second = other.map(|(body, velocity)| {
        let opposite = [&-tangential.clone(), &-push.clone()];
        let moment = body.radius.clone() * tangential;
        apply(body, &velocity, opposite, &moment, None)
    });
    Ok(Struck {
        regime: outcome.regime,
        slip: [slip, outcome.slip],
        approach: contact.approach().clone(),
        separation: outcome.separation,
        impulse: outcome.impulse,
        ledger,
        first: struck,
        second,
    })
}
