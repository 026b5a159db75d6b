//! The law of Wang, Su and Li: the tangential impulse as the mean of k and 1.

use kane_number::{Number, Rational};

use crate::arithmetic::two_sum;
use crate::law::guards;
use crate::{
    Coefficients, Contact, Guard, ImpactLaw, Impulse, Lasting, LawInfo, ModelInfo, Provenance,
    Regime, Relation, Root,
};

/// Friction that fades from sliding to reversal: `i_x` = (1 + k)/2 (id `wang-su-li`).
///
/// Where the contact does not couple it gives, with momentum, for `v_t` > 0 and 0 ≤ α ≤ ∞,
///
/// ```text
/// k = (1 − α)/(1 + α)    i_x = 1/(1 + α)    Δe = −1/(1 + α)²
/// ```
///
/// The paper has `v_t` > 0; here the law is total: odd in the slip, and without tangential impulse
/// at `v_t` = 0, where `I_x` = μ·`I_y`/(1 + α) tends to zero from both sides. Where μ·`I_y` = 0 and
/// `v_t` ≠ 0 nothing happens, k = 1.
///
/// They derive it for a sphere. On a contact that couples, the ansatz `i_x` = (1 + k)/2 with
/// Newton's restitution is a quadratic equation in k, of which exactly one root has `p_n` > 0:
/// friction then never gains energy, but may leave the friction cone (k > 1). At `v_t` = 0 the
/// limit is taken, which is sticking.
///
/// Domain: every contact. Exact in exact numbers; with coupling algebraic ones hold the root, and
/// rational ones only where it is rational.
///
/// The impulse is formed from homogeneous quantities, `I_x` = S·q/(q + `W_tt`·S) with q = 2·`v_t`
/// and S = μ·`I_y`, so that α need not exist. In floats, barring under- and overflow, and to first
/// order in the unit roundoff, a contact whose entries are each rounded once gives `I_x` within
/// 13/2 ulp: S has four errors of at most one ulp, weighted by 1/(1 + α), q and `W_tt` have one
/// each, weighted by α/(1 + α), and sum, quotient and product add 1 + 1 + 1/2. From an exact α,
/// [`ratios`](ImpactLaw::ratios) gives k within 51/100 ulp, `i_x` within 3/2 and Δe within 4. With
/// coupling plain floats are heuristic, and intervals enclose the impulse.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WangSuLi;

/// i_x of a contact that does not couple: q/(q + `W_tt`·S).
fn share<N: Number>(contact: &Contact<N>) -> N {
    let q = contact.slip().double();
    let sum = contact.delassus().tt().mul_add(&contact.sliding_impulse(), &q);
    q / sum
}

/// (1 + k)/2 times −μ, the ratio of the impulses.
fn ratio<N: Number>(contact: &Contact<N>, k: &N) -> N {
    -((N::one() + k) / N::one().double() * contact.friction())
}

/// v_t·(k − 1)·(W_nn − μ·(1 + k)/2·W_tn) + (1 + e)·a·(μ·(1 + k)/2·W_tt − W_tn) in powers of k.
fn coefficients<N: Number>(contact: &Contact<N>) -> Coefficients<N> {
    let (w, v, c) = (contact.delassus(), contact.slip(), contact.closing());
    let half_friction = contact.friction().clone() / N::one().double();
    let (tt, tn) = (half_friction.clone() * w.tt(), half_friction * w.tn());
    let constant = c.clone() * (tt.clone() - w.tn()) - v.clone() * (w.nn().clone() - &tn);
    let linear = v.clone() * w.nn() + c * tt;
    Coefficients::Quadratic([constant, linear, -(v.clone() * tn)])
}

impl ImpactLaw for WangSuLi {
    const INFO: LawInfo = LawInfo {
        id: "wang-su-li",
        people: "Wang, Su and Li",
        source: "X. Wang, Q. Su, S. Li, \"Resolving Kane's Puzzle in Oblique Collisions of Rigid Bodies\", equations (15) to (17) and (19); original consulted",
        known_by: Provenance::Original,
        statement: "i_x = (k + 1)/2",
        on_a_sphere: &[("", "(1 - alpha)/(1 + alpha)")],
        model: Some(ModelInfo {
            words: "the law of Wang, Su and Li",
            operations: [29, 24, 11, 0],
            lasting: Lasting::Unsummed,
        }),
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        Some(-Rational::one())
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[
                Regime::new("no slip", guards![Guard::no_slip()], |_, contact, _| {
                    contact.ending_at(&N::zero())
                }),
                Regime {
                    slip: Some(|_, contact, _| fading_slip(contact)),
                    // p_t·(v + v⁺)/2 = −S·i·v·(1 + k)/2, and (1 + k)/2 = i
                    work: Some(|_, contact, _| {
                        -(contact.sliding_impulse() * contact.slip() * share(contact).square())
                    }),
                    ..Regime::new(
                        "fading friction",
                        guards![Guard::uncoupled()],
                        |_, contact, _| {
                            let normal = contact.closing() / contact.delassus().nn();
                            let tangential = -(contact.sliding_impulse() * share(contact));
                            Impulse { tangential, normal }
                        },
                    )
                },
                // The impulses' ratio is negative, so the slip ends below the one without friction. By
                // the change of slip the impulse is a sum of terms of one sign.
                Regime::new(
                    "fading friction, slip speeds up the separation",
                    guards![Guard::new(Relation::Positive, |_, contact: &Contact<N>| contact
                        .delassus()
                        .tn()
                        .clone())],
                    |_, contact, k| contact.ending_at(&(k.clone() * contact.slip())),
                )
                .with_root(Root {
                    coefficients: |_, contact| coefficients(contact),
                    between: |_, contact| {
                        let w = contact.delassus();
                        let frictionless = contact.closing() * w.tn() / w.nn() / contact.slip();
                        (-N::one(), N::one() + frictionless)
                    },
                }),
                // k ≤ 1, so i_x ≤ 1, and the slip ends above the one of full sliding.
                Regime::new(
                    "fading friction, slip slows the separation down",
                    &[],
                    |_, contact, k| contact.with_ratio(&ratio(contact, k)),
                )
                .with_root(Root {
                    coefficients: |_, contact| coefficients(contact),
                    between: |_, contact| {
                        let change = contact.closing() * contact.slowing_rate();
                        let change = change / contact.separation_rate() / contact.slip();
                        (N::one() - change, N::one())
                    },
                }),
            ]
        }
    }
}

/// v_t·k = v_t·(q − p)/(q + p), with the three rounding errors given back: sum and difference are
/// exact as pairs, and the remainder of the division is exact by a fused multiply-add. What is left
/// is the rounding of the last sum, half an ulp, and second order.
fn fading_slip<N: Number>(contact: &Contact<N>) -> N {
    let q = contact.slip().double();
    let p = contact.sliding_impulse() * contact.delassus().tt();
    if N::IS_EXACT {
        return (q.clone() - &p) / (q + p) * contact.slip();
    }
    let ((sum, of_sum), (difference, of_difference)) = (two_sum(&q, &p), two_sum(&q, &-p));
    let k = difference.clone() / &sum;
    let remainder = (-k.clone()).mul_add(&sum, &difference);
    let correction = (remainder + of_difference - k.clone() * of_sum) / sum;
    (k + correction) * contact.slip()
}
