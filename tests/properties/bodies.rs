//! From bodies to contacts and back: momentum, the ledger, and what must not depend on the description.

use kane_impact::ImpactLaw;
use kane_impact::bodies::{
    Collided, Collision, Direction, DoublePendulum, Motion, PlanarBody, Shape, SphereOnPlane,
};
use kane_impact::laws::{KaneLevinson, Keller1986, WangSuLi};
use kane_number::{Algebraic, Number, Ordered as _, Rational};
use proptest::prelude::*;

use crate::strategies::restitution;
use crate::{cases, rational};

fn small() -> impl Strategy<Value = Rational> {
    (1_i32..60, 1_i32..60).prop_map(|(n, d)| rational(n, d))
}

fn either() -> impl Strategy<Value = Rational> {
    (-60_i32..60, 1_i32..60).prop_map(|(n, d)| rational(n, d))
}

fn body() -> impl Strategy<Value = PlanarBody<Rational>> {
    (small(), small(), [either(), either()], (either(), either(), either())).prop_map(
        |(mass, inertia, arm, (vx, vy, omega))| {
            let before = Motion { vx, vy, omega };
            PlanarBody { mass, inertia, arm, before }
        },
    )
}

fn collision() -> impl Strategy<Value = Collision<Rational>> {
    (body(), prop::option::of(body()), small(), restitution()).prop_map(
        |(body, other, friction, restitution)| Collision { body, other, friction, restitution },
    )
}

/// Kinetic energy after, of both bodies.
fn energy_after(collision: &Collision<Rational>, collided: &Collided<Rational>) -> Rational {
    let moved = |body: &PlanarBody<Rational>, after: &Motion<Rational>| PlanarBody {
        before: after.clone(),
        ..body.clone()
    };
    let other = collision.other.as_ref().zip(collided.other_after.as_ref());
    let after = Collision {
        body: moved(&collision.body, &collided.after),
        other: other.map(|(body, after)| moved(body, after)),
        ..collision.clone()
    };
    after.kinetic_energy()
}

proptest! {
    #![proptest_config(cases(600))]

    /// The ledger is the change of ½·m·v² + ½·J·ω², in whole and by part, the contact point ends
    /// with the velocity of the law, and two bodies keep their momentum.
    #[test]
    fn bodies_and_contact_tell_the_same_story(collision in collision()) {
        let Ok(collided) = collision.collide(&Keller1986) else {
            prop_assert!(collision.contact().is_err(), "only bodies that move apart are refused");
            return Ok(());
        };
        let change = energy_after(&collision, &collided) - collision.kinetic_energy();
        prop_assert_eq!(&change, &collided.energy.total());
        prop_assert_eq!(&change, &collided.outcome.work.total());

        let velocity = |body: &PlanarBody<Rational>, after: &Motion<Rational>| {
            PlanarBody { before: after.clone(), ..body.clone() }.velocity()
        };
        let [mut slip, mut normal] = velocity(&collision.body, &collided.after);
        let mut momentum = &collision.body.mass * (&collided.after.vx - &collision.body.before.vx);
        if let (Some(other), Some(after)) = (&collision.other, &collided.other_after) {
            let [vt, vn] = velocity(other, after);
            (slip, normal) = (slip - vt, normal - vn);
            momentum += &other.mass * (&after.vx - &other.before.vx);
            prop_assert_eq!(momentum, rational(0, 1));
        }
        prop_assert_eq!(slip, collided.outcome.slip);
        prop_assert_eq!(normal, collided.outcome.separation);
    }

    /// A second body of infinite mass is a fixed obstacle: its part of the operator vanishes like 1/m.
    #[test]
    fn a_heavy_partner_is_a_wall(body in body(), friction in small(), restitution in restitution()) {
        let resting = Motion { vx: rational(0, 1), vy: rational(0, 1), omega: rational(0, 1) };
        let mass = rational(2, 1).pow(200);
        let arm = [rational(0, 1), rational(1, 1)];
        let wall = PlanarBody { mass: mass.clone(), inertia: mass.clone(), arm, before: resting };
        let alone = Collision { body, other: None, friction, restitution };
        let Ok(alone_contact) = alone.contact() else { return Ok(()) };
        let pair = Collision { other: Some(wall), ..alone.clone() };
        let difference = |a: &Rational, b: &Rational| (a - b) * &mass;
        let contact = pair.contact()?;
        prop_assert_eq!(contact.slip(), alone_contact.slip());
        let (w, w_alone) = (contact.delassus(), alone_contact.delassus());
        prop_assert_eq!(difference(w.tt(), w_alone.tt()), rational(2, 1));
        prop_assert_eq!(difference(w.nn(), w_alone.nn()), rational(1, 1));
        prop_assert_eq!(w.tn(), w_alone.tn());
    }

    /// What matters of two bodies is their relative motion: a common velocity changes nothing.
    #[test]
    fn the_outcome_does_not_depend_on_the_observer(
        first in body(),
        second in body(),
        (ux, uy) in (either(), either()),
    ) {
        let still = Collision {
            body: first,
            other: Some(second),
            friction: rational(1, 2),
            restitution: rational(1, 2),
        };
        let mut moving = still.clone();
        for body in [&mut moving.body].into_iter().chain(&mut moving.other) {
            body.before.vx += &ux;
            body.before.vy += &uy;
        }
        let outcomes = (still.collide(&Keller1986), moving.collide(&Keller1986));
        if let (Ok(still), Ok(moving)) = outcomes {
            prop_assert_eq!(&still.outcome, &moving.outcome);
            prop_assert_eq!(&still.after.vx + &ux, moving.after.vx);
            prop_assert_eq!(&still.after.omega, &moving.after.omega);
        }
    }

    /// The paper's sphere and the general body are the same collision in two notations.
    #[test]
    fn the_sphere_on_a_plane_is_a_collision(
        (mass, radius) in (small(), small()),
        (vx, vy, omega) in (either(), small(), either()),
    ) {
        let inertia = Shape::Sphere.gyration() * &mass * radius.square();
        let sphere = SphereOnPlane {
            mass: mass.clone(),
            radius: radius.clone(),
            inertia,
            friction: rational(1, 3),
            restitution: rational(4, 5),
            before: Motion { vx: vx.clone(), vy: vy.clone(), omega: omega.clone() },
        };
        let before = Motion { vx, vy: -vy, omega: -omega };
        let body = Shape::Sphere.body(mass, radius, before);
        prop_assert_eq!(&sphere.collision().body, &body);
        let contact = sphere.contact()?;
        let ratio = contact.delassus().tt() / contact.delassus().nn();
        prop_assert_eq!(ratio, Shape::Sphere.mobility_ratio());
        let (rebound, collided) = (sphere.collide(&WangSuLi)?, sphere.collision().collide(&WangSuLi)?);
        prop_assert_eq!(&rebound.tangential_impulse, &-collided.outcome.impulse.tangential);
        prop_assert_eq!(&rebound.after.vy, &-collided.after.vy);
    }

    /// T⁺ from the generalised speeds, and the tip's velocity from them.
    #[test]
    fn the_pendulum_keeps_its_books(
        (q1, q2) in (either(), either()),
        (u1, u2) in (either(), either()),
        friction in small(),
    ) {
        let pendulum = DoublePendulum {
            mass: rational(3, 2),
            length: rational(2, 3),
            angles: [Direction::of_half_tangent(&q1), Direction::of_half_tangent(&q2)],
            before: [u1, u2],
            friction,
            restitution: rational(1, 2),
        };
        let Ok(swung) = pendulum.collide(&KaneLevinson) else { return Ok(()) };
        let after = DoublePendulum { before: swung.after.clone(), ..pendulum.clone() };
        let change = after.kinetic_energy() - pendulum.kinetic_energy();
        prop_assert_eq!(&change, &swung.outcome.work.total());
        // the tip of the pendulum afterwards separates, so the contact's approach is negative
        let mirrored = DoublePendulum {
            before: [-swung.after[0].clone(), -swung.after[1].clone()],
            ..pendulum
        };
        let contact = mirrored.contact()?;
        prop_assert_eq!(contact.slip(), &-swung.outcome.slip);
        prop_assert_eq!(contact.approach(), &swung.outcome.separation);
    }

    /// The ellipse: a circle does not couple, the arm is the support point, and a quarter turn
    /// exchanges the axes.
    #[test]
    fn the_ellipse_touches_where_its_support_says(
        (a, b) in (small(), small()),
        tangent in either(),
    ) {
        let algebraic = |x: &Rational| Algebraic::from(x.clone());
        let direction = Direction::of_half_tangent(&tangent).map(algebraic);
        let (a, b) = (algebraic(&a), algebraic(&b));
        let before = Motion { vx: algebraic(&rational(1, 1)), vy: algebraic(&rational(-1, 1)), omega: Algebraic::zero() };
        let mass = || Algebraic::one();
        let axes = [a.clone(), b.clone()];
        let ellipse = PlanarBody::ellipse(mass(), axes, &direction, before.clone()).expect("exact");
        // in the frame of the axes, the contact point is on the ellipse
        let Direction { cos, sin } = &direction;
        let [x, y] = &ellipse.arm;
        let along = x.clone() * cos + y.clone() * sin;
        let across = y.clone() * cos - x.clone() * sin;
        prop_assert_eq!((along / &a).square() + (across / &b).square(), Algebraic::one());
        // and nothing of the ellipse is lower: the normal there is vertical, (x/a², y/b²) ∥ (sin, cos)
        let along = x.clone() * cos + y.clone() * sin;
        let across = y.clone() * cos - x.clone() * sin;
        prop_assert_eq!(along / a.square() * cos, across / b.square() * sin);
        let circle = PlanarBody::ellipse(mass(), [a.clone(), a.clone()], &direction, before);
        let circle = circle.expect("exact");
        prop_assert_eq!(&circle.arm, &[Algebraic::zero(), -a]);
        prop_assert_eq!(circle.delassus().tn().sign().is_equal(), Some(true));
    }
}

/// Two equal spheres that meet head on without friction exchange their velocities at e = 1.
#[test]
fn equal_spheres_exchange_their_velocities() {
    let one = || rational(1, 1);
    let motion = |vy| Motion { vx: rational(0, 1), vy, omega: rational(0, 1) };
    let upper = Shape::Sphere.body(one(), one(), motion(-one()));
    let mut lower = Shape::Sphere.body(one(), one(), motion(one()));
    lower.arm[1] = one(); // touched from above
    let collision =
        Collision { body: upper, other: Some(lower), friction: rational(0, 1), restitution: one() };
    let collided = collision.collide(&WangSuLi).expect("they approach");
    assert_eq!(collided.after.vy, one());
    assert_eq!(collided.other_after.map(|after| after.vy), Some(-one()));
    assert_eq!(collided.energy.total(), rational(0, 1));
}

/// A rod of mass 1 and length 2, half-tangent 1/2: the centre is (3/5, 4/5) from its tip, J = 1/3, so
/// that W_tn = −(3/5)·(4/5)·3 = −36/25. It jams for a slip into its slope and μ ≥ W_nn/|W_tn|.
#[test]
fn a_rod_tip_couples() {
    let n = |n: i32, d: i32| rational(n, d);
    let direction = Direction::of_half_tangent(&n(1, 2));
    let before = Motion { vx: n(1, 1), vy: n(-1, 1), omega: n(0, 1) };
    let rod = PlanarBody::rod_tip(n(1, 1), n(2, 1), &direction, before);
    assert_eq!(rod.arm, [n(-3, 5), n(-4, 5)]);
    let w = rod.delassus();
    assert_eq!((w.tt(), w.tn(), w.nn()), (&n(73, 25), &n(-36, 25), &n(52, 25)));
    // where it jams: μ·|W_tn| ≥ W_nn, sliding into the slope of the rod
    let jams = n(52, 36);
    let collision =
        |friction| Collision { body: rod.clone(), other: None, friction, restitution: n(1, 2) };
    let sliding = kane_impact::laws::WhittakerUncapped;
    let mut reversed = collision(jams);
    reversed.body.before.vx = n(-1, 1);
    let contact = reversed.contact().expect("it approaches");
    assert!(sliding.impulse(&contact).is_err(), "one-directional sliding has no answer");
    assert!(Keller1986.impulse(&contact).is_ok(), "the process has");
}
