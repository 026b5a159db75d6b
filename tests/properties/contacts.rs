//! Contacts that couple, aimed at the places where a law changes its mind.

use kane_impact::{Contact, Delassus};
use kane_number::{Number, Rational};
use proptest::prelude::*;

use crate::strategies::{not_negative, positive, restitution, signed};
use crate::{rational, two_to};

/// The boundary that a contact is planted on.
#[derive(Clone, Copy, Debug)]
enum Tie {
    /// none
    None,
    /// μ·W_tt = |W_tn|: sticking is just possible, or slip just does not slow down
    Cone,
    /// μ·|W_tn| = W_nn: sliding one way just does not separate
    Jam,
    /// sliding all the time ends with v_t⁺ = 0 under Newton, and friction stops the slip at the end
    Stop,
    /// the slip stops when compression ends
    Compression,
    /// the rebound of the slip by a share is just inside the cone
    Rebound,
    /// Chatterjee and Ruina's impulse with e_t = 0 is just on the cone
    Sticking,
}

/// A tie of every kind, one time in eight each, and none in two of eight.
fn tie() -> impl Strategy<Value = Tie> {
    prop_oneof![
        2 => Just(Tie::None),
        1 => Just(Tie::Cone),
        1 => Just(Tie::Jam),
        1 => Just(Tie::Stop),
        1 => Just(Tie::Compression),
        1 => Just(Tie::Rebound),
        1 => Just(Tie::Sticking),
    ]
}

/// Any planar contact with exact data. A symmetric matrix is positive definite exactly if it is
/// L·Lᵀ with a positive diagonal, so that form reaches all of them, mass ratios up to 2^2000 among
/// them. One time in eight each: a tie of every kind, to the hair or on it; v_t = 0, μ = 0, a = 0,
/// e = 0 and e = 1 in between.
pub(crate) fn contact() -> impl Strategy<Value = Contact<Rational>> {
    let hair = prop_oneof![1 => Just(None), 1 => (1_i32..200, any::<bool>()).prop_map(Some)];
    let factor = (positive(), signed(), positive());
    let state = (signed(), not_negative(), not_negative(), restitution());
    (factor, state, tie(), hair).prop_map(|(factor, state, tie, hair)| {
        let nudge = match hair {
            None => rational(1, 1),
            Some((bits, true)) => rational(1, 1) + two_to(-bits),
            Some((bits, false)) => rational(1, 1) - two_to(-bits),
        };
        planted(factor, state, tie, &nudge)
    })
}

/// The same with small numbers only, for what is too slow on numbers of thousands of bits.
pub(crate) fn tame_contact() -> impl Strategy<Value = Contact<Rational>> {
    let small = || (1_i32..60, 1_i32..60).prop_map(|(n, d)| rational(n, d));
    let zeroed = move || prop_oneof![1 => Just(rational(0, 1)), 7 => small()];
    let either = move || (zeroed(), any::<bool>()).prop_map(|(x, s)| if s { -x } else { x });
    let unit = (0_i32..=8).prop_map(|n| rational(n, 8));
    let nudge = prop_oneof![1 => Just(rational(1, 1)), 1 => Just(rational(1001, 1000)), 1 => Just(rational(999, 1000))];
    let factor = (small(), either(), small());
    ((factor, (either(), zeroed(), zeroed(), unit)), tie(), nudge)
        .prop_map(|((factor, state), tie, nudge)| planted(factor, state, tie, &nudge))
}

type Triple = (Rational, Rational, Rational);

fn planted(
    (l11, l21, l22): Triple,
    (slip, approach, friction, restitution): (Rational, Rational, Rational, Rational),
    tie: Tie,
    nudge: &Rational,
) -> Contact<Rational> {
    let (tt, tn) = (l11.square(), &l11 * &l21);
    let nn = l21.square() + l22.square();
    let size = |x: &Rational| if *x < rational(0, 1) { -x } else { x.clone() };
    let (mut slip, mut friction) = (slip, friction);
    match tie {
        Tie::Cone => friction = size(&tn) / &tt * nudge,
        Tie::Jam if tn != rational(0, 1) => friction = &nn / size(&tn) * nudge,
        _ => {}
    }
    // in the frame that faces forwards
    let coupling = if slip < rational(0, 1) { -&tn } else { tn.clone() };
    let closing = (rational(1, 1) + &restitution) * &approach;
    let (separation, slowing) = (&nn - &friction * &coupling, &friction * &tt - &coupling);
    let speed = match tie {
        _ if separation == rational(0, 1) => None,
        Tie::Stop => Some(&closing * &slowing / &separation),
        Tie::Compression => Some(&approach * &slowing / &separation),
        Tie::Rebound => Some(&closing * &slowing / &separation / rational(36, 25)),
        Tie::Sticking => {
            let determinant = &tt * &nn - tn.square();
            let sticking = &friction * &closing * determinant / &separation;
            Some((sticking - &coupling * &approach) / &nn)
        }
        Tie::None | Tie::Cone | Tie::Jam => None,
    };
    if let Some(speed) = speed.filter(|speed| *speed > rational(0, 1)) {
        let speed = speed * nudge;
        slip = if slip < rational(0, 1) { -speed } else { speed };
    }
    let delassus = Delassus::new(tt, tn, nn).expect("L·Lᵀ is positive definite");
    Contact::new(slip, approach, delassus, friction, restitution).expect("inside the domain")
}
