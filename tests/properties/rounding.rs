//! How far floats are from exact numbers when they start from physical inputs. u = 2^−53.
//!
//! **From an α that is rounded once**, an error of 1/2 ulp, at most u relative: i_x = 1/(1 + α) has
//! it with weight α/(1 + α), one u from the sum and half an ulp from the quotient: **5/2 ulp**.
//!
//! **I_x = S·q/(q + W_tt·S)** from a contact whose entries are rounded once: S = μ·((1 + e)·a/W_nn)
//! has the errors of fma(e, a, a), of W_nn, of the quotient and of the product, 4u with weight
//! 1/(1 + α); q = 2·v_t and W_tt have u each with weight α/(1 + α); the sum by a fused multiply-add,
//! the quotient and the product add u, u and half an ulp: at most **13/2 ulp**, at α → 0.
//! The second order is below 2^−48 ulp.
//!
//! **Through scaled double-double** every operation errs by less than 2^−100, and fewer than forty
//! operations follow each other, so that the rounding at the end is all that shows: 1/2 ulp and
//! less than 2^−40; asked as **51/100 ulp** for the impulse and for the work −S·v_t·i_x² alike,
//! which no longer has the cancellation of 1 + k.

use kane_impact::bodies::{CollideError, Motion, SphereOnPlane};
use kane_impact::double::{Arithmetic, impulse};
use kane_impact::laws::WangSuLi;
use kane_impact::{Alpha, Contact, Delassus, ImpactLaw, InvalidInput, Law, NoImpulse, laws};
use kane_number::{Algebraic, Interval, Number, Rational, decode, error_in_ulps};
use proptest::prelude::*;

use crate::dyadic::{Dyadic, within_ulps};
use crate::strategies::float_sphere;
use crate::{cases, rational};

/// The sphere's exact answers as fractions of integers: with s = μ·(1 + e)·v_y and b = J + m·r²,
///
/// ```text
/// i_x = 2·v·J/(2·v·J + b·s)    I_x = m·s·i_x    ΔE = −I_x·v·i_x
/// ```
struct Truth {
    slip: Dyadic,
    sliding: Dyadic,
    reach: Dyadic,
    whole: Dyadic,
}

impl Truth {
    /// For v > 0 and v_y > 0.
    fn of(sphere: &SphereOnPlane<f64>) -> Self {
        let SphereOnPlane { mass, radius, inertia, friction, restitution, before } =
            sphere.map(|&x| Dyadic::of(x));
        let slip = before.vx - &before.omega * &radius;
        let closing = &(Dyadic::of(1.0) + restitution) * &before.vy;
        let sliding = &friction * &closing;
        let reach = &(&Dyadic::of(2.0) * &slip) * &inertia;
        let body = inertia + &(&mass * &radius) * &radius;
        let whole = reach.clone() + &body * &sliding;
        Self { slip, sliding: &mass * &sliding, reach, whole }
    }

    fn impulse(&self) -> (Dyadic, Dyadic) {
        (&self.sliding * &self.reach, self.whole.clone())
    }

    fn work(&self) -> (Dyadic, Dyadic) {
        let (numer, denom) = self.impulse();
        (-(&(&numer * &self.reach) * &self.slip), &denom * &self.whole)
    }
}

/// Turns the sphere so that it slips forwards, or `None` if it does not slip or approach.
fn forward(mut sphere: SphereOnPlane<f64>) -> Option<SphereOnPlane<f64>> {
    let slip = Dyadic::of(sphere.before.vx)
        - &Dyadic::of(sphere.before.omega) * &Dyadic::of(sphere.radius);
    match slip.sign() {
        std::cmp::Ordering::Less => {
            sphere.before.vx = -sphere.before.vx;
            sphere.before.omega = -sphere.before.omega;
        }
        std::cmp::Ordering::Equal => return None,
        std::cmp::Ordering::Greater => {}
    }
    (sphere.before.vy > 0.0 && sphere.friction > 0.0).then_some(sphere)
}

/// Any finite float, of every exponent alike.
fn wild() -> impl Strategy<Value = f64> {
    (1..f64::INFINITY.to_bits()).prop_map(f64::from_bits)
}

fn wild_sphere() -> impl Strategy<Value = SphereOnPlane<f64>> {
    let unit = prop_oneof![
        Just(0.0),
        Just(1.0),
        Just(f64::from_bits(1)),
        (0..1.0_f64.to_bits()).prop_map(f64::from_bits)
    ];
    (wild(), wild(), wild(), wild(), unit, wild(), (wild(), wild(), any::<bool>())).prop_map(
        |(mass, radius, inertia, friction, restitution, vx, (vy, omega, sign))| SphereOnPlane {
            mass,
            radius,
            inertia,
            friction,
            restitution,
            before: Motion { vx, vy, omega: if sign { omega } else { -omega } },
        },
    )
}

fn half_an_ulp() -> Rational {
    rational(51, 100)
}

proptest! {
    #![proptest_config(cases(60_000))]

    #[test]
    fn physical_inputs_keep_their_bounds_in_plain_floats(sphere in float_sphere()) {
        let Some(sphere) = forward(sphere) else { return Ok(()) };
        let truth = Truth::of(&sphere);
        let alpha = sphere.alpha()?.expect("it slips");
        let share = WangSuLi.ratios(&Alpha::Finite(alpha)).expect("finite").impulse;
        prop_assert!(within_ulps(share, (&truth.reach, &truth.whole), &rational(5, 2)));

        let (numer, denom) = truth.impulse();
        let (plain, arithmetic) = impulse(&WangSuLi, &sphere.contact()?)?;
        if arithmetic == Arithmetic::Plain {
            prop_assert!(within_ulps(-plain.tangential, (&numer, &denom), &rational(13, 2)));
        }
        let rebound = sphere.collide(&WangSuLi)?;
        prop_assert!(within_ulps(rebound.tangential_impulse, (&numer, &denom), &half_an_ulp()));
        let (numer, denom) = truth.work();
        prop_assert!(within_ulps(rebound.work.tangential, (&numer, &denom), &half_an_ulp()));
    }
}

proptest! {
    #![proptest_config(cases(60_000))]

    /// Whatever the exponents, subnormals included: the nearest float or its neighbour, unless the
    /// exact result overflows, which is an error that names it.
    #[test]
    fn no_exponent_is_too_large_or_too_small(sphere in wild_sphere()) {
        let Some(sphere) = forward(sphere) else { return Ok(()) };
        let truth = Truth::of(&sphere);
        let (numer, denom) = truth.impulse();
        match sphere.collide(&WangSuLi) {
            Ok(rebound) => {
                let share = rebound.tangential_impulse;
                prop_assert!(within_ulps(share, (&numer, &denom), &half_an_ulp()), "{share}");
                let (numer, denom) = truth.work();
                let work = rebound.work.tangential;
                prop_assert!(within_ulps(work, (&numer, &denom), &half_an_ulp()), "{work}");
            }
            Err(CollideError::Invalid(InvalidInput::NotFinite { .. })) => {}
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        }
    }
}

/// Contacts in floats: any exponents within ±30, coupling of every strength, exact ties at random.
fn float_contact() -> impl Strategy<Value = Contact<f64>> {
    let size = || {
        prop_oneof![
            (1_u32..16).prop_map(f64::from),
            (-30_i32..30, any::<u64>()).prop_map(|(exponent, bits)| {
                f64::from_bits(1.0_f64.to_bits() | bits >> 12) * 2.0_f64.powi(exponent)
            }),
        ]
    };
    let unit = prop_oneof![Just(0.0), Just(0.5), Just(1.0), 0.0..1.0];
    let cosine = prop_oneof![Just(0.0), Just(0.5), -0.999..0.999];
    (size(), size(), cosine, size(), size(), size(), (unit, any::<bool>())).prop_filter_map(
        "rounding may make the operator singular",
        |(tt, nn, cosine, slip, approach, friction, (restitution, sign))| {
            let tn = cosine * (tt * nn).sqrt();
            let delassus = Delassus::new(tt, tn, nn).ok()?;
            let slip = if sign { slip } else { -slip };
            Contact::new(slip, approach, delassus, friction, restitution).ok()
        },
    )
}

/// Counts what the number systems say of every law at one contact.
#[derive(Default)]
struct Compare {
    contact: Option<Contact<f64>>,
    decided: u32,
    undecided: u32,
    fault: Option<String>,
}

impl Compare {
    fn visit(&mut self, law: &Law) {
        let contact = self.contact.as_ref().expect("set before the visit");
        let enclosed = match law.over().impulse(&contact.map(|&x| Interval::from(x))) {
            Ok(enclosed) => enclosed,
            Err(NoImpulse::Undecided { .. } | NoImpulse::Unrepresentable { .. }) => {
                self.undecided += 1;
                return;
            }
            Err(NoImpulse::Outside { .. }) => {
                self.decided += 1;
                let exact = contact.map(|&x| Algebraic::from(decode(x).expect("finite")));
                if law.over().impulse(&exact).is_ok() {
                    self.fault = Some(format!("{}: intervals refuse {contact:?}", law.info.id));
                }
                return;
            }
            Err(error) => unreachable!("{error}"),
        };
        self.decided += 1;
        let exact = contact.map(|&x| Algebraic::from(decode(x).expect("finite")));
        let exact = law.over().impulse(&exact).expect("intervals decided");
        let plain = law.over().impulse(contact).expect("intervals decided");
        // floats and intervals find a root in different ways
        let rooted = law.over().regime(contact).is_ok_and(|chosen| chosen.root.is_some());
        let wide = law.over().impulse(&contact.map(Number::widen)).expect("intervals decided");
        let wide = wide.map(f64::narrow);
        for (name, enclosure, exact, plain, wide) in [
            ("p_t", &enclosed.tangential, &exact.tangential, plain.tangential, wide.tangential),
            ("p_n", &enclosed.normal, &exact.normal, plain.normal, wide.normal),
        ] {
            let (low, high) = exact.enclose(200);
            let holds = |x: &Rational| enclosure.contains(x);
            let plain_bounded = rooted || holds(&decode(plain).expect("finite"));
            let bounded = holds(&low) && holds(&high) && plain_bounded;
            let error = error_in_ulps(wide, &low).expect("finite");
            // what loses more than fifty bits in plain floats may lose some in the wide ones
            let lost = enclosure.width() > plain.abs() / 8.0;
            let near = lost || error <= rational(1, 1) && error >= rational(-1, 1);
            if !bounded || !near {
                let id = law.info.id;
                self.fault = Some(format!(
                    "{id}: {name} = {exact} in {enclosure}, f64 {plain:?}, wide {wide:?} ({error} ulp) at {contact:?}"
                ));
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(700))]

    /// For every law, coupled or not: the interval holds the exact impulse and, where no root is
    /// needed, the one of plain floats, so that its width bounds their distance; and the wide way
    /// is within one ulp.
    #[test]
    fn intervals_bound_plain_floats_and_the_wide_way_is_within_an_ulp(contact in float_contact()) {
        let mut compare = Compare { contact: Some(contact), ..Compare::default() };
        laws().iter().for_each(|law| compare.visit(law));
        prop_assert!(compare.fault.is_none(), "{}", compare.fault.unwrap_or_default());
        prop_assert!(compare.decided >= compare.undecided, "{}", compare.undecided);
    }
}
