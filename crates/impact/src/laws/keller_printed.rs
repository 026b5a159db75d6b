//! The two pieces printed under Keller's name.

use kane_number::{Number, Rational};

use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, Impulse, LawInfo, Provenance, Regime, Relation};

/// Two straight pieces: k = 1 − 4α/3 while k > 0, then k = 1/2 − 2α/3 (id `keller-printed`).
///
/// The friction that momentum needs for it is `i_x` = 2/3 on the first piece and 1/3 + 1/(4α) on
/// the second. Energy is created for α > 9/4. Only for contacts that do not couple. This is not the
/// law of Keller's paper, for which see [`Keller1986`](crate::laws::Keller1986).
///
/// Domain: contacts that do not couple; without tangential impulse at `v_t` = 0. Exact in exact
/// numbers.
///
/// In floats, barring under- and overflow, at most 7 roundings of positive terms, 7 ulp.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct KellerPrinted;

/// S/3
fn third<N: Number>(contact: &Contact<N>) -> N {
    contact.sliding_impulse() / (N::one().double() + N::one())
}

/// The impulse without coupling whose tangential part opposes the slip by the given amount.
fn opposing<N: Number>(contact: &Contact<N>, friction: N) -> Impulse<N> {
    Impulse { tangential: -friction, normal: contact.closing() / contact.delassus().nn() }
}

impl ImpactLaw for KellerPrinted {
    const INFO: LawInfo = LawInfo {
        id: "keller-printed",
        people: "Wang, Su and Li",
        form: "under Keller's name",
        source: "Wang, Su and Li, equation (26). Their (27) prints i_x = 1/3 on the second piece, which contradicts momentum; we follow (26). Original consulted",
        known_by: Provenance::Original,
        statement: "k = 1 - 4/3*alpha when k > 0\nk = 1/2 - 2/3*alpha when k <= 0",
        stated_for_coupling: false,
        gap: Some("the law is printed for contacts that do not couple, W_tn = 0"),
        on_a_sphere: &[("3/4", "1 - 4/3*alpha"), ("", "1/2 - 2/3*alpha")],
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        None // k falls without bound
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[
                Regime::new(
                    "no slip",
                    guards![Guard::no_slip(), Guard::uncoupled()],
                    |_, contact, _| opposing(contact, N::zero()),
                ),
                // α ≤ 3/4, that is 3·v ≥ 2·W_tt·S
                Regime::new(
                    "first piece",
                    guards![
                        Guard::uncoupled(),
                        Guard::new(Relation::NotNegative, |_, contact: &Contact<N>| {
                            let slip = contact.slip();
                            let change = contact.sliding_impulse() * contact.delassus().tt();
                            slip.double() + slip - change.double()
                        }),
                    ],
                    |_, contact, _| opposing(contact, third(contact).double()),
                ),
                // S·(1/3 + 1/(4α)) = S/3 + v/(2·W_tt)
                Regime::new("second piece", guards![Guard::uncoupled()], |_, contact, _| {
                    let rest = contact.slip().clone() / contact.delassus().tt().double();
                    opposing(contact, third(contact) + rest)
                }),
            ]
        }
    }
}
