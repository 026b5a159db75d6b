//! What a law does in its own frame, and the laws of a turned normal by themselves.

use kane_impact::bodies::{Collision, Direction, Motion, PlanarBody, SphereOnPlane};
use kane_impact::laws::{ChatterjeeRuina, KuninakaHayakawa, LougeAdams, Saitoh, Walton};
use kane_impact::{Contact, Delassus, Facing, Formulas, ImpactLaw, Impulse, NoImpulse};
use kane_number::{Number, Rational, Real};
use proptest::prelude::*;

use crate::contacts::tame_contact;
use crate::statement::decoupled;
use crate::{cases, rational};

/// A contact and an impulse there as the law sees them: facing forwards, and in its frame.
pub(crate) fn as_seen<N: Real>(
    law: &dyn Formulas<N>,
    contact: &Contact<N>,
    impulse: &Impulse<N>,
) -> (Contact<N>, Impulse<N>) {
    let (contact, impulse) = match contact.facing().expect("exact numbers decide") {
        Facing::Forward => (contact.clone(), impulse.clone()),
        Facing::Backward => (contact.mirrored(), impulse.clone().mirrored()),
    };
    let slips = contact.slip().sign().is_equal() != Some(true);
    match law.frame(&contact).filter(|_| slips) {
        Some(frame) => (frame.contact, impulse.turned(&frame.turn)),
        None => (contact, impulse),
    }
}

/// The contact that in the law's frame is the given one, save for its restitution.
pub(crate) fn as_given<N: Number>(law: &dyn Formulas<N>, seen: &Contact<N>) -> Contact<N> {
    // the turn is the same at every contact
    law.frame(seen).map_or_else(|| seen.clone(), |frame| seen.turned(&frame.turn.mirrored()))
}

fn tilts() -> impl Strategy<Value = Rational> {
    (0_i32..=12).prop_map(|n| rational(n, 12))
}

fn tilted(tilt: Rational) -> KuninakaHayakawa {
    KuninakaHayakawa { tilt, ..KuninakaHayakawa::default() }
}

proptest! {
    #![proptest_config(cases(1500))]

    /// The body is turned instead of the normal: its arm and its velocity, in rotated axes, meet a
    /// plane in the ordinary way, and the velocities after are turned back.
    #[test]
    fn a_tilted_normal_is_a_turned_body(
        (tilt, friction, restitution) in (tilts(), 0_i32..40, 0_i32..=8),
        arm in (-9_i32..9, 1_i32..9),
        (vx, vy, omega) in (-9_i32..9, -9_i32..9, -9_i32..9),
        (mass, inertia) in (1_i32..9, 1_i32..9),
    ) {
        let n = |x: i32| rational(x, 3);
        let before = Motion { vx: n(vx), vy: n(vy), omega: n(omega) };
        let collision = |before: Motion<Rational>, arm: [Rational; 2]| Collision {
            body: PlanarBody { mass: n(mass), inertia: n(inertia), arm, before },
            other: None,
            friction: rational(friction, 10),
            restitution: rational(restitution, 8),
        };
        let arm = [n(arm.0), n(-arm.1)];
        let flat = collision(before.clone(), arm.clone());
        let Ok(contact) = flat.contact() else { return Ok(()) };
        prop_assume!(*contact.slip() != rational(0, 1));
        let law = tilted(tilt.clone());
        let Ok(mine) = law.impulse(&contact) else { return Ok(()) };
        let turn = Direction::of_half_tangent(&tilt);
        let turn = if *contact.slip() < rational(0, 1) { turn.mirrored() } else { turn };
        // components along t' = c·t + s·n and n' = c·n − s·t
        let turned = |[x, y]: [&Rational; 2]| {
            [&turn.cos * x + &turn.sin * y, &turn.cos * y - &turn.sin * x]
        };
        let [vx, vy] = turned([&before.vx, &before.vy]);
        let leant = collision(Motion { vx, vy, omega: before.omega }, turned([&arm[0], &arm[1]]));
        let inner = ChatterjeeRuina { restitution: law.restitution };
        let theirs = leant.contact().expect("it approaches").clone();
        let theirs = inner.impulse(&theirs)?.turned(&turn.mirrored());
        prop_assert_eq!(mine, theirs);
    }

    /// Kuninaka and Hayakawa's formula for the restitution along the untilted normal, from velocities.
    #[test]
    fn the_kinematic_restitution_is_kuninaka_and_hayakawa_s(
        contact in tame_contact(),
        tilt in tilts(),
    ) {
        let law = tilted(tilt.clone());
        prop_assume!(*contact.approach() != rational(0, 1) && *contact.slip() != rational(0, 1));
        let Ok(impulse) = law.impulse(&contact) else { return Ok(()) };
        let (seen, turned) = as_seen(&law, &contact, &impulse);
        let Direction { cos, sin } = Direction::of_half_tangent(&tilt);
        prop_assume!(cos != rational(0, 1) && *seen.approach() != rational(0, 1));
        let one = rational(1, 1);
        let tan = &sin / &cos;
        let incidence = contact.slip() / contact.approach();
        let incidence = if incidence < rational(0, 1) { -incidence } else { incidence };
        let before = (&incidence - &tan) / (&one + &incidence * &tan);
        let after = seen.slip_after(&turned) / seen.approach();
        prop_assert_eq!(&before, &(seen.slip() / seen.approach()));
        let formula = (contact.restitution() + after * &tan) / (one - before * tan);
        prop_assert_eq!(contact.separation_after(&impulse) / contact.approach(), formula);
    }

    /// Without a tilt or a turn these are Walton's law where nothing couples, and Chatterjee and
    /// Ruina's everywhere.
    #[test]
    fn without_a_turn_nothing_is_new(contact in tame_contact()) {
        let zero = || rational(0, 1);
        // without approach there is none along a normal that could turn either
        prop_assume!(*contact.approach() != zero());
        let restitution = Walton::default().restitution;
        let inner = ChatterjeeRuina { restitution }.resolve(&contact)?;
        let same = |impulse: Result<Impulse<Rational>, NoImpulse>| impulse == Ok(inner.impulse.clone());
        prop_assert!(same(tilted(zero()).impulse(&contact)));
        let louge = LougeAdams { tilt: zero(), ..LougeAdams::default() };
        let saitoh = Saitoh { turn: zero(), ..Saitoh::default() };
        prop_assert!(same(louge.impulse(&contact)));
        prop_assert!(same(saitoh.impulse(&contact)));
        let plain = decoupled(&contact);
        let flat = tilted(zero()).impulse(&plain);
        prop_assert_eq!(flat, Walton::default().impulse(&plain));
    }

    /// A frame is turned and turned back, and energy is the same in both.
    #[test]
    fn energy_does_not_see_the_frame(
        contact in tame_contact(),
        tilt in tilts(),
        (t, n) in (-20_i32..20, -20_i32..20),
    ) {
        let turn = Direction::of_half_tangent(&tilt);
        let impulse = Impulse { tangential: rational(t, 7), normal: rational(n, 7) };
        let (seen, turned) = (contact.turned(&turn), impulse.turned(&turn));
        prop_assert_eq!(&seen.turned(&turn.mirrored()), &contact);
        prop_assert_eq!(&turned.turned(&turn.mirrored()), &impulse);
        prop_assert_eq!(seen.energy_loss(&turned), contact.energy_loss(&impulse));
        prop_assert_eq!(seen.delassus().determinant(), contact.delassus().determinant());
    }

    /// g'·n' = −e·g·n with the two normals of Saitoh et al., from velocities.
    #[test]
    fn the_proper_restitution_compares_two_normals(contact in tame_contact()) {
        let contact = if *contact.slip() < rational(0, 1) { contact.mirrored() } else { contact };
        prop_assume!(*contact.slip() != rational(0, 1));
        let law = Saitoh::default();
        let Ok(outcome) = law.resolve(&contact) else { return Ok(()) };
        let Direction { cos, sin } = Direction::of_half_tangent(&law.turn);
        let proper = cos * outcome.separation + sin * outcome.slip;
        prop_assert_eq!(proper, contact.restitution() * contact.approach());
    }
}

/// The published sliding formula, Ψ2 = Ψ1 − j_p·(1 + e)·μ, is that of a disc or a sphere whose contact
/// point is on the tilted normal through its centre; there the law gives it without a remainder. And
/// the same from a body on a plane that is tilted as a whole.
#[test]
fn a_disc_with_its_contact_on_the_tilted_normal_obeys_the_published_formula() {
    let mut raised = 0;
    for (inertia, j_p) in [(rational(1, 2), rational(3, 1)), (rational(2, 5), rational(7, 2))] {
        for (tilt, vx, friction, e) in
            [(10, 3, 5, 9), (20, 5, 4, 8), (10, 6, 2, 7), (8, 9, 10, 10), (15, 1, 10, 5)]
        {
            let law = tilted(rational(1, tilt));
            let (friction, e) = (rational(friction, 100), rational(e, 10));
            let Direction { cos, sin } = Direction::of_half_tangent(&law.tilt);
            let (one, zero) = (|| rational(1, 1), || rational(0, 1));
            let before = Motion { vx: rational(vx, 1), vy: -one(), omega: zero() };
            // n' = c·n − s·t, and the contact is a radius from the centre against it
            let disc = Collision {
                body: PlanarBody {
                    mass: one(),
                    inertia: inertia.clone(),
                    arm: [sin.clone(), -cos.clone()],
                    before,
                },
                other: None,
                friction: friction.clone(),
                restitution: e.clone(),
            };
            let contact = disc.contact().expect("it approaches");
            let outcome = law.resolve(&contact).expect("it separates");
            assert_eq!(outcome.regime, "on the turned cone, backwards");

            let tan = &sin / &cos;
            let incidence = rational(vx, 1);
            let psi1 = (&incidence - &tan) / (one() + &incidence * &tan);
            let psi2 = &psi1 - &j_p * (one() + &e) * &friction;
            let formula = (&e + &psi2 * &tan) / (one() - &psi1 * &tan);
            assert_eq!(outcome.separation, formula, "a = 1");
            raised += usize::from(formula > one());
            assert!(outcome.work.total() <= zero());

            // the plane is tilted: Walton's law on it, and the velocity of the centre turned back
            let approach = &cos + &sin * &incidence;
            let leant = SphereOnPlane {
                mass: one(),
                radius: one(),
                inertia: inertia.clone(),
                friction,
                restitution: e,
                before: Motion { vx: &cos * &incidence - &sin, vy: approach, omega: zero() },
            };
            let rebound = leant.collide(&Walton::default()).expect("it collides");
            // the contact point's velocity is the centre's and the spin's
            let normal = &sin * &rebound.slip - &cos * &rebound.after.vy;
            assert_eq!(normal, formula);
        }
    }
    assert!(raised >= 4, "the restitution exceeds one, {raised} times");
}

/// What Walton's slip of −β0 would do in the tilted frame of a sphere: e = 1, and friction that holds a
/// slip which the coupling drives. The law itself creates none.
#[test]
fn walton_s_rebound_in_a_coupled_frame_would_create_energy_on_a_sphere() {
    let delassus = Delassus::new(rational(7, 2), rational(0, 1), rational(1, 1)).expect("positive");
    let contact = |slip: Rational| {
        let one = || rational(1, 1);
        Contact::new(slip, one(), delassus.clone(), one(), one()).expect("inside the domain")
    };
    let law = tilted(rational(1, 10));
    let contact = contact(rational(1, 4)); // tan φ = 20/99
    let frame = ImpactLaw::frame(&law, &contact).expect("its own");
    let walton = Walton::default().resolve(&frame.contact).expect("it pushes");
    assert_eq!(walton.regime, "rebound of the slip");
    assert!(walton.work.total() > rational(0, 1), "{}", walton.work.total());
    let outcome = law.resolve(&contact).expect("inside the domain");
    assert!(outcome.work.total() <= rational(0, 1), "{}", outcome.work.total());
}

/// Solid sphere, tan φ = 5/12, e = 1/4, μ = 1/10, v = (2, −1): a' = 12/13 − 10/13 = 2/13.
#[test]
fn saitoh_s_law_has_negative_restitution_and_may_create_energy() {
    let delassus = Delassus::new(rational(7, 2), rational(0, 1), rational(1, 1)).expect("positive");
    let contact = |slip: Rational, e: Rational| {
        let one = rational(1, 1);
        Contact::new(slip, one, delassus.clone(), rational(1, 10), e).expect("inside the domain")
    };
    let law = Saitoh::default();
    let outcome = law.resolve(&contact(rational(1, 1), rational(1, 4))).expect("it approaches");
    assert!(outcome.separation < rational(0, 1), "{}", outcome.separation);
    assert!(outcome.work.total() < rational(0, 1));
    let outcome = law.resolve(&contact(rational(2, 1), rational(1, 1))).expect("it approaches");
    assert!(outcome.work.total() > rational(0, 1), "{}", outcome.work.total());
    let none = law.resolve(&contact(rational(5, 2), rational(1, 1)));
    assert!(matches!(none, Err(NoImpulse::Outside { .. })), "{none:?}");
}
