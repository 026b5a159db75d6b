//! The planar code against a computation in space, in exact rationals.
//!
//! `docs/derivations/spatial-sphere.md` proves that the collision of a sphere is planar. Here the
//! code is held to it: what [`SphereOnPlane`] says is compared with the rigid body in three
//! dimensions, m·Δv = p and J·Δω = c × p, worked out on the spot.

use kane::impact::bodies::{Motion, PlanarBody, SphereOnPlane};
use kane::impact::{Law, SpatialDelassus, Symmetric, laws};

use crate::many::many;
use crate::support::{Chance, Q, q};

type Vector = [Q; 3];

fn dot(a: &Vector, b: &Vector) -> Q {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    let entry = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [entry(1, 2), entry(2, 0), entry(0, 1)]
}

fn plus(a: &Vector, b: &Vector) -> Vector {
    [&a[0] + &b[0], &a[1] + &b[1], &a[2] + &b[2]]
}

fn times(factor: &Q, a: &Vector) -> Vector {
    [factor * &a[0], factor * &a[1], factor * &a[2]]
}

fn any(chance: &mut Chance) -> Q {
    q(chance.within(-9, 9), chance.within(1, 5))
}

fn positive(chance: &mut Chance) -> Q {
    q(chance.within(1, 9), chance.within(1, 5))
}

fn vector(chance: &mut Chance) -> Vector {
    [any(chance), any(chance), any(chance)]
}

/// L·Lᵀ of a lower triangular L with a positive diagonal.
fn definite(chance: &mut Chance) -> Symmetric<Q> {
    let [a, c, f] = [positive(chance), positive(chance), positive(chance)];
    let [b, d, e] = vector(chance);
    Symmetric {
        xx: &a * &a,
        yy: &b * &b + &c * &c,
        zz: &d * &d + &e * &e + &f * &f,
        xy: &a * &b,
        xz: &a * &d,
        yz: &b * &d + &c * &e,
    }
}

#[test]
fn the_spatial_operator_of_a_sphere_is_diagonal() {
    let mut chance = Chance::new(1);
    for _ in 0..many(50) {
        let [m, j, r] = [positive(&mut chance), positive(&mut chance), positive(&mut chance)];
        let inertia = Symmetric::diagonal([j.clone(), j.clone(), j.clone()]);
        let lever = [q(0, 1), -r.clone(), q(0, 1)];
        let operator = SpatialDelassus::of_body(m.clone(), &inertia, &lever).expect("a sphere");
        let tangential = m.recip() + &r * &r / j;
        let diagonal = Symmetric::diagonal([tangential.clone(), m.recip(), tangential]);
        assert_eq!(operator.entries(), &diagonal);
    }
}

/// With a spin Δω such that M = J·Δω is perpendicular to c, the impulse p = M × c/c² has c × p = M,
/// so that the velocity of the contact changes by p/m + Δω × c. No matrix is inverted for that.
#[test]
fn the_spatial_operator_is_that_of_newton_and_euler() {
    let mut chance = Chance::new(2);
    for _ in 0..many(200) {
        let (m, inertia) = (positive(&mut chance), definite(&mut chance));
        let (lever, direction) = (vector(&mut chance), vector(&mut chance));
        let square = dot(&lever, &lever);
        if square == q(0, 1) {
            continue;
        }
        let operator = SpatialDelassus::of_body(m.clone(), &inertia, &lever).expect("a body");
        let spin = cross(&inertia.times(&lever), &direction);
        let impulse = times(&square.recip(), &cross(&inertia.times(&spin), &lever));
        let change = plus(&times(&m.recip(), &impulse), &cross(&spin, &lever));
        assert_eq!(operator.change(&impulse), change);
        // along the lever there is no moment
        assert_eq!(operator.change(&lever), times(&m.recip(), &lever));
    }
}

#[test]
fn a_body_that_moves_in_the_plane_has_the_planar_operator() {
    let mut chance = Chance::new(3);
    for _ in 0..many(100) {
        let (mass, [jx, jy]) =
            (positive(&mut chance), [positive(&mut chance), positive(&mut chance)]);
        let body = PlanarBody {
            mass: mass.clone(),
            inertia: positive(&mut chance),
            arm: [any(&mut chance), any(&mut chance)],
            before: Motion { vx: q(0, 1), vy: q(0, 1), omega: q(0, 1) },
        };
        let inertia = Symmetric::diagonal([jx, jy, body.inertia.clone()]);
        let [x, y] = body.arm.clone();
        let spatial = SpatialDelassus::of_body(mass, &inertia, &[x, y, q(0, 1)]).expect("a body");
        let (planar, spatial) = (body.delassus(), spatial.entries());
        assert_eq!(
            (planar.tt(), planar.tn(), planar.nn()),
            (&spatial.xx, &spatial.xy, &spatial.yy)
        );
        assert_eq!((&spatial.xz, &spatial.yz), (&q(0, 1), &q(0, 1)));
    }
}

#[test]
fn a_tensor_that_is_not_positive_definite_is_refused() {
    let lever = [q(0, 1), q(-1, 1), q(0, 1)];
    for (xx, xy) in
        [(q(-1, 1), q(0, 1)), (q(0, 1), q(0, 1)), (q(1, 1), q(1, 1)), (q(1, 1), q(2, 1))]
    {
        let tensor = Symmetric { xy, ..Symmetric::diagonal([xx, q(1, 1), q(1, 1)]) };
        assert!(SpatialDelassus::of_body(q(1, 1), &tensor, &lever).is_err(), "{tensor:?}");
    }
    let flat = Symmetric::diagonal([q(1, 1), q(1, 1), q(0, 1)]);
    assert!(SpatialDelassus::of_body(q(1, 1), &flat, &lever).is_err());
    let round = Symmetric::diagonal([q(1, 1), q(1, 1), q(1, 1)]);
    assert!(SpatialDelassus::of_body(q(0, 1), &round, &lever).is_err());
}

/// A sphere in space whose slip is along (cos, 0, sin), and the same in the plane of the slip.
struct Sphere {
    planar: SphereOnPlane<Q>,
    tangent: Vector,
    lever: Vector,
    velocity: Vector,
    spin: Vector,
}

impl Sphere {
    fn any(chance: &mut Chance) -> Self {
        let r = positive(chance);
        let lever = [q(0, 1), -r.clone(), q(0, 1)];
        let half = any(chance); // the tangent of half the angle
        let sum = q(1, 1) + &half * &half;
        let (cos, sin) = ((q(1, 1) - &half * &half) / &sum, (&half + &half) / &sum);
        let (tangent, side) = ([cos.clone(), q(0, 1), sin.clone()], [-sin, q(0, 1), cos]);
        let spin = vector(chance);
        let [slip, approach] = [positive(chance), positive(chance)];
        // the velocity that gives this slip, whatever the spin: the side has no slip
        let velocity = [times(&slip, &tangent), [q(0, 1), -approach.clone(), q(0, 1)]]
            .iter()
            .fold(times(&q(-1, 1), &cross(&spin, &lever)), |sum, part| plus(&sum, part));
        let planar = SphereOnPlane {
            mass: positive(chance),
            radius: r,
            inertia: positive(chance),
            friction: positive(chance),
            restitution: q(chance.within(0, 5), 5),
            // in the plane the spin is about tangent × normal, and the paper counts it backwards
            before: Motion {
                vx: dot(&velocity, &tangent),
                vy: approach,
                omega: -dot(&spin, &side),
            },
        };
        Self { planar, tangent, lever, velocity, spin }
    }

    fn energy(&self, velocity: &Vector, spin: &Vector) -> Q {
        let SphereOnPlane { mass, inertia, .. } = &self.planar;
        (mass * dot(velocity, velocity) + inertia * dot(spin, spin)) / q(2, 1)
    }
}

struct InSpace<'a>(&'a Sphere, &'a mut usize);

impl InSpace<'_> {
    fn visit(&mut self, law: &Law) {
        let Sphere { planar, tangent, lever, velocity, spin } = self.0;
        // a law that has no answer, or an irrational one, says nothing here
        let Ok(rebound) = planar.collide(law.over()) else { return };
        *self.1 += 1;
        let id = law.info.id;
        let impulse = plus(
            &times(&-rebound.tangential_impulse.clone(), tangent),
            &[q(0, 1), rebound.normal_impulse.clone(), q(0, 1)],
        );
        let velocity_after = plus(velocity, &times(&planar.mass.recip(), &impulse));
        let spin_after = plus(spin, &times(&planar.inertia.recip(), &cross(lever, &impulse)));
        let slip = plus(&velocity_after, &cross(&spin_after, lever));

        let expected =
            plus(&times(&rebound.slip, tangent), &[q(0, 1), -rebound.after.vy.clone(), q(0, 1)]);
        assert_eq!(slip, expected, "{id}: the contact moves as in the plane");
        assert_eq!(dot(&velocity_after, tangent), rebound.after.vx, "{id}: so does the centre");
        let side = cross(tangent, &[q(0, 1), q(1, 1), q(0, 1)]);
        assert_eq!(-dot(&spin_after, &side), rebound.after.omega, "{id}: and the spin");
        assert_eq!(
            dot(&velocity_after, &side),
            dot(velocity, &side),
            "{id}: nothing happens across"
        );
        assert_eq!(dot(&spin_after, tangent), dot(spin, tangent), "{id}: nor about the tangent");
        assert_eq!(spin_after[1], spin[1], "{id}: nor about the normal");
        let gain = self.0.energy(&velocity_after, &spin_after) - self.0.energy(velocity, spin);
        assert_eq!(gain, rebound.energy.total(), "{id}: the energy changes as in the plane");
    }
}

#[test]
fn a_sphere_in_space_collides_as_in_the_plane_of_its_slip() {
    let mut chance = Chance::new(4);
    let mut compared = 0;
    for _ in 0..many(60) {
        for law in laws() {
            InSpace(&Sphere::any(&mut chance), &mut compared).visit(law);
        }
    }
    println!("{compared} collisions in space");
    assert!(compared >= 10 * many(60), "the suite is there");
}
