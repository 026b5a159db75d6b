//! Smith's law: friction weighted by the slip before and after.

use kane_number::{Number, Rational};

use super::whittaker_uncapped::slide;
use crate::law::guards;
use crate::{Coefficients, Contact, Guard, ImpactLaw, Impulse, LawInfo, Provenance, Regime, Root};

/// Friction along the mean of the slip before and after, weighted by speed (id `smith-1991`):
/// `p_t` = −μ·`p_n`·(|v|·v + |v⁺|·v⁺)/(v² + v⁺²), that is `i_x` = (1 + k·|k|)/(1 + k²).
///
/// Where the contact does not couple, for `v_t` > 0,
///
/// ```text
/// k = 1 − 2α                    i_x = 1            α ≤ 1/2
/// k = α − √(α² + 2α − 1)        i_x = (1 − k)/(2α)  α ≥ 1/2
/// ```
///
/// With coupling and a slip that reverses, k is the root of a cubic equation; exactly one has
/// `p_n` > 0 and k < 0, because `i_x` grows with k and k falls as `i_x` grows. Friction never gains
/// energy and stays in the cone. At `v_t` = 0 the contact slides along `W_tn` if that accelerates,
/// else sticks.
///
/// Domain: every contact. Exact in exact numbers: algebraic ones hold the root, rational ones only
/// where it is rational, and always where the slip is not reversed.
///
/// In floats, from an exact α, [`ratios`](ImpactLaw::ratios) has no cancellation: k is formed as
/// (1 − 2α)·x/(2 − x) with the root x = 1 + k. With coupling plain floats are heuristic where the
/// slip reverses, and intervals enclose the impulse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Smith1991;

/// −μ·(1 − k²)/(1 + k²), the ratio of the impulses for k ≤ 0.
fn ratio<N: Number>(contact: &Contact<N>, k: &N) -> N {
    let square = k.square();
    -((N::one() - &square) / (N::one() + square) * contact.friction())
}

/// The impulse by the change of slip, (W_tt·r + W_tn)·p_n = (k − 1)·v: where k ≤ 0, k − 1 does not
/// cancel, while W_nn + r·W_tn may where the contact all but jams.
fn reversed<N: Number>(contact: &Contact<N>, k: &N) -> Impulse<N> {
    let (w, ratio) = (contact.delassus(), ratio(contact, k));
    let change = (k.clone() - N::one()) * contact.slip();
    let normal = change / ratio.mul_add(w.tt(), w.tn());
    Impulse { tangential: normal.clone() * ratio, normal }
}

/// (k − 1)·v·(W_nn·(1 + k²) − μ·(1 − k²)·W_tn) + (1 + e)·a·(μ·(1 − k²)·W_tt − (1 + k²)·W_tn).
fn cubic<N: Number>(contact: &Contact<N>) -> [N; 4] {
    let (w, mu, v, c) = (contact.delassus(), contact.friction(), contact.slip(), contact.closing());
    let sliding = contact.separation_rate() * v;
    let reversed = mu.mul_add(w.tn(), w.nn()) * v;
    let slowing = contact.slowing_rate() * &c;
    let pushing = mu.mul_add(w.tt(), w.tn()) * c;
    [slowing - &sliding, sliding, -(reversed.clone() + pushing), reversed]
}

impl ImpactLaw for Smith1991 {
    const INFO: LawInfo = LawInfo {
        id: "smith-1991",
        people: "Smith",
        year: Some(1991),
        source: "C. E. Smith, J. Appl. Mech. 58 (1991) 754-758, as quoted by Chatterjee and Ruina (1998); original not consulted",
        known_by: Provenance::Others,
        statement: "i_x = 1 when k >= 0\ni_x = (1 - k^2)/(1 + k^2) when k <= 0",
        on_a_sphere: &[("1/2", "1 - 2*alpha"), ("", "alpha - sqrt(alpha^2 + 2*alpha - 1)")],
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        Some(-Rational::one())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[
                Regime::new("slide", guards![Guard::slides_apart(), Guard::slides_on()], slide),
                Regime {
                    slip: Some(|_, _, _| N::zero()),
                    ..Regime::new("stick", guards![Guard::no_slip()], |_, contact, _| {
                        contact.ending_at(&N::zero())
                    })
                },
                // x = 1 + k is the smaller root of v·x² − (2v + p)·x + 2v; the other is above 2
                Regime {
                    slip: Some(|_, contact: &Contact<N>, x: &N| {
                        let change = contact.sliding_impulse() * contact.delassus().tt();
                        (contact.slip().clone() - change) * x / (N::one().double() - x)
                    }),
                    work: Some(|_, contact: &Contact<N>, x: &N| {
                        let ratio = (N::one().double() - x) * x * contact.slip().square();
                        -(ratio / contact.delassus().tt().double())
                    }),
                    ..Regime::new("reverse", guards![Guard::uncoupled()], |_, contact, x| {
                        let jump = (N::one().double() - x) * contact.slip();
                        Impulse {
                            tangential: -(jump / contact.delassus().tt()),
                            normal: contact.closing() / contact.delassus().nn(),
                        }
                    })
                }
                .with_root(Root {
                    coefficients: |_, contact| {
                        let twice = contact.slip().double();
                        let change = contact.sliding_impulse() * contact.delassus().tt();
                        Coefficients::Quadratic([
                            twice.clone(),
                            -(twice + change),
                            contact.slip().clone(),
                        ])
                    },
                    between: |_, _| (N::zero(), N::one()),
                }),
                // friction cannot exceed sliding, so the slip ends above the one of full sliding
                Regime::new("reverse, coupled", guards![Guard::slides_apart()], |_, contact, k| {
                    contact.with_ratio(&ratio(contact, k))
                })
                .with_root(Root {
                    coefficients: |_, contact| Coefficients::Cubic(cubic(contact)),
                    between: |_, contact| {
                        let change = contact.closing() * contact.slowing_rate();
                        let change = change / contact.separation_rate() / contact.slip();
                        (N::one() - change, N::zero())
                    },
                }),
                // the signs of the coefficients at −k are −, −, +, +: one negative root, and
                // Cauchy's bound on its size
                Regime::new("reverse, jammed", &[], |_, contact, k| reversed(contact, k))
                    .with_root(Root {
                        coefficients: |_, contact| Coefficients::Cubic(cubic(contact)),
                        between: |_, contact| {
                            let [c0, c1, c2, c3] = cubic(contact);
                            (-((c0 - c1 - c2) / c3 + N::one()), N::zero())
                        },
                    }),
            ]
        }
    }
}
