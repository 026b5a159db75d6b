//! Chatterjee and Ruina's law in space: what determines its impulse, the plane, turns about the normal,
//! and energy.

use kane_impact::laws::ChatterjeeRuina;
use kane_impact::{
    Contact, Delassus, ImpactLaw, NoImpulse, SpatialContact, SpatialDelassus, Symmetric,
};
use kane_number::{Algebraic, Interval, Number, Ordered as _, Rational, decode};
use proptest::prelude::*;

use crate::{cases, rational};

type Q = Rational;
type Vector = [Q; 3];

/// A body by m, the factor of J = L·Lᵀ, c and v, with μ and e.
#[derive(Clone, Debug)]
struct Body {
    mass: Q,
    inertia: Symmetric<Q>,
    lever: Vector,
    velocity: Vector,
    friction: Q,
    restitution: Q,
}

impl Body {
    fn contact(&self) -> SpatialContact<Q> {
        let w = SpatialDelassus::of_body(self.mass.clone(), &self.inertia, &self.lever);
        let w = w.expect("a positive definite tensor");
        let [mu, e] = [self.friction.clone(), self.restitution.clone()];
        SpatialContact::new(self.velocity.clone(), w, mu, e).expect("inside the domain")
    }

    /// The same body, turned about the normal.
    fn turned(&self, half_tangent: &Q) -> Self {
        let [lever, velocity] = [&self.lever, &self.velocity].map(|v| turned(v, half_tangent));
        // J' = R·J·Rᵀ, column by column
        let column = |n: usize| {
            let unit = std::array::from_fn(|m| rational(i32::from(n == m), 1));
            turned(&self.inertia.times(&turned(&unit, &-half_tangent.clone())), half_tangent)
        };
        let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = [column(0), column(1), column(2)];
        Self { inertia: Symmetric { xx, yy, zz, xy, xz, yz }, lever, velocity, ..self.clone() }
    }

    /// The same body with everything in the plane of x and y.
    fn planar(&self) -> Self {
        let flat = |[x, y, _]: &Vector| [x.clone(), y.clone(), rational(0, 1)];
        let zero = || rational(0, 1);
        let inertia = Symmetric { xz: zero(), yz: zero(), ..self.inertia.clone() };
        Self { inertia, lever: flat(&self.lever), velocity: flat(&self.velocity), ..self.clone() }
    }
}

fn turned<N: Number>([x, y, z]: &[N; 3], half_tangent: &Q) -> [N; 3] {
    let turn = kane_impact::bodies::Direction::of_half_tangent(&N::from_rational(half_tangent));
    let (cos, sin) = (turn.cos, turn.sin);
    [cos.clone() * x + sin.clone() * z, y.clone(), cos * z - sin * x]
}

fn body() -> impl Strategy<Value = Body> {
    let small = || (-6_i32..=6, 1_i32..5).prop_map(|(n, d)| rational(n, d));
    let positive = || (1_i32..=6, 1_i32..5).prop_map(|(n, d)| rational(n, d));
    let factor = ([positive(), positive(), positive()], [small(), small(), small()]);
    let vectors = ([small(), small(), small()], (small(), positive(), small()));
    (positive(), factor, vectors, (0_i32..=12, 0_i32..=4)).prop_map(
        |(mass, ([a, b, c], [d, e, f]), (lever, (x, y, z)), (friction, restitution))| Body {
            mass,
            inertia: Symmetric {
                xx: a.square(),
                xy: &a * &d,
                xz: &a * &e,
                yy: d.square() + b.square(),
                yz: &d * &e + &b * &f,
                zz: e.square() + f.square() + c.square(),
            },
            lever,
            velocity: [x, -y, z],
            friction: rational(friction, 6),
            restitution: rational(restitution, 4),
        },
    )
}

fn laws() -> impl Strategy<Value = ChatterjeeRuina> {
    (-4_i32..=4).prop_map(|n| ChatterjeeRuina { restitution: rational(n, 4) })
}

fn exact(contact: &SpatialContact<Q>) -> SpatialContact<Algebraic> {
    contact.map(|x| Algebraic::from(x.clone()))
}

fn sign(x: &Algebraic) -> i32 {
    let sign = x.sign();
    i32::from(sign.is_greater() == Some(true)) - i32::from(sign.is_less() == Some(true))
}

proptest! {
    #![proptest_config(cases(250))]

    /// What the formula says of velocities and the cone, which determines the impulse: v_n⁺ = e·a, and
    /// inside the cone every tangential velocity is v_t⁺ = −e_t·v_t + (e − e_t)·a·W_tn/W_nn; on the
    /// cone p is (1 + e)·p_I and a part of p_II − p_I that is less. Energy never rises.
    #[test]
    fn the_law_in_space_is_its_formula_and_gains_nothing(body in body(), law in laws()) {
        let contact = body.contact();
        let p = law.impulse_in_space(&exact(&contact))?;
        let contact = exact(&contact);
        let [after_x, after_y, after_z] = contact.velocity_after(&p);
        let [x, y, z] = contact.velocity();
        let (e, mu) = (contact.restitution().clone(), contact.friction().clone());
        let one = || Algebraic::from(rational(1, 1));
        prop_assert_eq!(&after_y, &(-(e.clone() * y)));
        prop_assert!(sign(&contact.energy_loss(&p)) >= 0);
        prop_assert!(sign(&p[1]) >= 0);
        let margin = sign(&((mu * &p[1]).square() - p[0].square() - p[2].square()));
        prop_assert!(margin >= 0);

        let share = Algebraic::from(law.restitution);
        let w = contact.delassus().entries();
        let pushed = |coupling: &Algebraic| -((e.clone() - &share) * y * coupling / &w.yy);
        let rebound = [
            pushed(&w.xy) - share.clone() * x,
            pushed(&w.yz) - share.clone() * z,
        ];
        let inner = [after_x.clone(), after_z.clone()] == rebound;
        if !inner {
            prop_assert_eq!(margin, 0, "on the cone");
            // W·(p_II − p_I) is tangential, and W·(p − (1 + e)·p_I) is a part κ of it, 0 ≤ κ < 1 + e_t
            let plastic = -(y.clone() / &w.yy);
            let d = [-(plastic.clone() * &w.xy) - x, -(plastic.clone() * &w.yz) - z];
            let pushed = (one() + &e) * plastic;
            let part = [
                after_x - x - pushed.clone() * &w.xy,
                after_z - z - pushed * &w.yz,
            ];
            prop_assert_eq!(part[0].clone() * &d[1], part[1].clone() * &d[0]);
            let (kappa, whole) = (
                part[0].clone() * &d[0] + part[1].clone() * &d[1],
                d[0].square() + d[1].square(),
            );
            prop_assert!(sign(&kappa) >= 0);
            prop_assert!(sign(&((one() + &share) * whole - kappa)) > 0);
        }
    }

    /// Turned about the normal, the impulse is the turned one.
    #[test]
    fn the_law_in_space_does_not_see_a_turn_about_the_normal(
        body in body(),
        law in laws(),
        half in (-8_i32..8).prop_map(|n| rational(n, 3)),
    ) {
        let before = law.impulse_in_space(&exact(&body.contact()))?;
        let after = law.impulse_in_space(&exact(&body.turned(&half).contact()))?;
        prop_assert_eq!(turned(&before, &half), after);
    }

    /// Where everything lies in a plane it is the planar law, and rational.
    #[test]
    fn the_law_in_space_is_the_planar_one_in_a_plane(body in body(), law in laws()) {
        let contact = body.planar().contact();
        let w = contact.delassus().entries();
        let planar = Delassus::new(w.xx.clone(), w.xy.clone(), w.yy.clone())?;
        let [x, y, _] = contact.velocity().clone();
        let (mu, e) = (contact.friction().clone(), contact.restitution().clone());
        let planar = law.impulse(&Contact::new(x, -y, planar, mu, e)?)?;
        let expected = [planar.tangential, planar.normal, rational(0, 1)];
        prop_assert_eq!(law.impulse_in_space(&contact)?, expected);
    }

    /// Intervals hold the exact impulse, and floats lie inside.
    #[test]
    fn intervals_hold_the_impulse_in_space(body in body(), law in laws()) {
        let rounded = body.contact().map(f64::from_rational);
        let truth = rounded.map(|&x| Algebraic::from(decode(x).expect("finite")));
        // a tie on the cone is decided by exact numbers alone
        let Ok(enclosed) = law.impulse_in_space(&rounded.map(|&x| Interval::from(x))) else {
            return Ok(());
        };
        for (exact, enclosure) in law.impulse_in_space(&truth)?.iter().zip(enclosed) {
            let (low, high) = exact.enclose(200);
            prop_assert!(enclosure.contains(&low) && enclosure.contains(&high));
        }
    }
}

/// A unit ball with c = (0, −1, 0) and J = 1, so that W = diag(2, 1, 2): v = (3, −1, 4), e = 0, μ = 1.
/// p_II = (−3/2, 1, −2) has |p_t| = 5/2, and sliding takes 1 of it, in the direction (−3/5, −4/5).
#[test]
fn a_ball_slides_against_its_slip_in_space() {
    let q = rational;
    let ball = |velocity: Vector| Body {
        mass: q(1, 1),
        inertia: Symmetric::diagonal([q(1, 1), q(1, 1), q(1, 1)]),
        lever: [q(0, 1), q(-1, 1), q(0, 1)],
        velocity,
        friction: q(1, 1),
        restitution: q(0, 1),
    };
    let law = ChatterjeeRuina::default();
    let contact = ball([q(3, 1), q(-1, 1), q(4, 1)]).contact();
    assert_eq!(law.impulse_in_space(&contact), Ok([q(-3, 5), q(1, 1), q(-4, 5)]));
    // |D_t| = √2 is no fraction
    let contact = ball([q(2, 1), q(-1, 1), q(2, 1)]).contact();
    let rational = law.impulse_in_space(&contact);
    assert!(matches!(rational, Err(NoImpulse::Unrepresentable { .. })), "{rational:?}");
    let [x, _, z] = law.impulse_in_space(&exact(&contact)).expect("algebraic");
    assert_eq!((x.to_string(), &x), ("-1/2*sqrt(2)".to_owned(), &z));
}
