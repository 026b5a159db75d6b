//! Whittaker's hypothesis with the test whether the slip stops.

use kane_number::{Number, Rational};

use super::whittaker_uncapped::slide;
use crate::info::STOPS;
use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, LawInfo, Provenance, Regime, Relation};

/// Friction that slides to the end, or else stops the slip: k = max(0, 1 − 2α) on a sphere
/// (id `whittaker-stop`).
///
/// If sliding forwards all the time would reverse the slip, the surfaces are taken as perfectly
/// rough instead: the impulse is what ends with `v_t⁺` = 0. No test asks whether that impulse is
/// inside the friction cone; on a sphere it always is. On a contact that couples it may not be: even
/// with μ = 0 the slip is stopped, and Kane's double pendulum then gains energy (T⁺/T⁻ = 1.587 for
/// e = 1/2). With that test it would be [`KaneLevinson`](crate::laws::KaneLevinson). Where the impulse
/// would pull the bodies together the law has no answer.
///
/// Domain: contacts on which sliding or stopping has a normal impulse that pushes, among them all
/// that do not couple. Exact in exact numbers.
///
/// In floats, barring under- and overflow, each regime is a quotient of few positive terms where
/// the contact does not couple: the impulse is within 6 ulp. With coupling the bound is the width
/// of the result on intervals.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WhittakerStop;

impl ImpactLaw for WhittakerStop {
    const INFO: LawInfo = LawInfo {
        id: "whittaker-stop",
        people: "Whittaker",
        year: Some(1904),
        form: "textbook form, without a test of the cone",
        caveat: Some(
            "no test asks whether friction can give its impulse: where a contact couples, it may leave the cone, and stop a slip without any friction",
        ),
        source: "the textbook form of E. T. Whittaker (1904), as quoted by Keller (1986); original not consulted",
        known_by: Provenance::Others,
        statement: "k >= 0\ni_x = 1 when k > 0\ni_x <= 1 when k = 0",
        gap: Some("neither sliding nor stopping the slip has a normal impulse that pushes"),
        on_a_sphere: STOPS,
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        Some(Rational::zero())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[
                Regime::new("slide", guards![Guard::slides_apart(), Guard::slides_on()], slide),
                Regime {
                    slip: Some(|_, _, _| N::zero()),
                    ..Regime::new(
                        "stop",
                        guards![Guard::new(Relation::NotNegative, |_, contact: &Contact<N>| {
                            contact.numerators_ending_at(&N::zero()).1
                        })],
                        |_, contact, _| contact.ending_at(&N::zero()),
                    )
                },
            ]
        }
    }
}
