//! Whittaker's hypothesis as the paper states it, without a stop.

use kane_number::{Number, Rational};

use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, Impulse, Lasting, LawInfo, ModelInfo, Provenance, Regime};

/// Friction that slides to the end, whatever the slip does: `i_x` = 1 (id `whittaker-uncapped`).
///
/// Where the contact does not couple, for `v_t` > 0 and 0 ≤ α < ∞,
///
/// ```text
/// k = 1 − 2α    i_x = 1    Δe = α − 1
/// ```
///
/// so that energy is created for α > 1. Wang, Su and Li take that for Kane's puzzle; but on Kane's own
/// double pendulum this law loses energy (T⁺/T⁻ = 0.562 for e = μ = 1/2), and the puzzle is that of
/// [`KaneLevinson`](crate::laws::KaneLevinson). Odd in the slip, and without tangential impulse at `v_t` = 0, where the law jumps from −μ·`I_y` to μ·`I_y`. On a contact that
/// couples, `p_n` = (1 + e)·a/(`W_nn` − μ·`W_tn`); where that denominator is not positive the
/// contact jams, and sliding in one direction has no admissible impulse.
///
/// Domain: contacts with `W_nn` > μ·`W_tn`, among them all that do not couple; elsewhere the law
/// has no answer. k has no limit for α → ∞. Exact in exact numbers.
///
/// As published the law is said to stop the slip at zero; this is the form without that stop.
///
/// In floats, barring under- and overflow, the impulse has at most five roundings, 5 ulp, where the
/// contact does not couple; k and Δe of [`ratios`](ImpactLaw::ratios) are correctly rounded.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WhittakerUncapped;

/// The reason that every law of one-directional sliding gives where the contact jams.
pub(crate) const JAM: &str = "sliding in one direction has no admissible impulse here: W_nn - mu*W_tn <= 0, the contact jams";

/// Sliding forwards all the time with the coefficient μ.
pub(crate) fn slide<L, N: Number>(_: &L, contact: &Contact<N>, _: &N) -> Impulse<N> {
    contact.with_ratio(&-contact.friction().clone())
}

/// A collision without tangential impulse.
pub(crate) fn frictionless<L, N: Number>(_: &L, contact: &Contact<N>, _: &N) -> Impulse<N> {
    contact.with_ratio(&N::zero())
}

impl ImpactLaw for WhittakerUncapped {
    const INFO: LawInfo = LawInfo {
        id: "whittaker-uncapped",
        people: "Whittaker",
        year: Some(1904),
        form: "as printed by Wang, Su and Li",
        source: "E. T. Whittaker (1904) as quoted by Wang, Su and Li, equations (20) to (23); original not consulted",
        known_by: Provenance::Others,
        statement: "i_x = 1",
        gap: Some(JAM),
        on_a_sphere: &[("", "1 - 2*alpha")],
        model: Some(ModelInfo {
            words: "friction in full against the slip",
            operations: [9, 12, 4, 0],
            lasting: Lasting::Full,
        }),
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        None // k falls without bound
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[
                Regime::new("no slip", guards![Guard::no_slip()], frictionless),
                Regime {
                    work: Some(|_, contact, _| {
                        // S·(W_tt·S/2 − v)
                        let sliding = contact.sliding_impulse();
                        let half = sliding.clone() / N::one().double();
                        let mean = contact.delassus().tt().mul_add(&half, &-contact.slip().clone());
                        sliding * mean
                    }),
                    ..Regime::new("slide", guards![Guard::uncoupled()], slide)
                },
                Regime::new("slide, coupled", guards![Guard::slides_apart()], slide),
            ]
        }
    }
}
