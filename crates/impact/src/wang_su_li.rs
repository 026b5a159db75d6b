//! The law of Wang, Su and Li: the tangential impulse as the mean of k and 1.

use kane_number::Number;

use crate::{Alpha, Contact, ImpactLaw, Ratios, Regime};

/// Friction that fades from sliding to reversal: i_x = (1 + k)/2 (id `wang-su-li`).
///
/// With momentum it gives, for v_t > 0 and 0 ≤ α ≤ ∞,
///
/// ```text
/// k = (1 − α)/(1 + α)    i_x = 1/(1 + α)    Δe = −1/(1 + α)²
/// ```
///
/// Source: X. Wang, Q. Su, S. Li, "Resolving Kane's Puzzle in Oblique Collisions of Rigid
/// Bodies", equations (15) to (17) and (19). Theirs is v_t > 0; here the law is total: odd in the
/// slip for v_t < 0, and without tangential impulse at v_t = 0, where I_x = μ·I_y/(1 + α) tends to
/// zero from both sides. At μ·I_y = 0 and v_t ≠ 0 nothing happens, k = 1.
///
/// The impulse is formed from homogeneous quantities, I_x = μ·I_y·q/(q + p) with q = 2|v_t| and
/// p = W_tt·μ·I_y, so that α need not exist. In floats six roundings of positive quantities bound the
/// relative error of [`resolve`](ImpactLaw::resolve) by 6·u to first order (u is half the spacing
/// at 1) for a given contact, barring under- and overflow; [`ratios`](ImpactLaw::ratios) is bounded
/// by 9/4 ulp in k (2 for α < 1/u), 3/2 in i_x and 4 in Δe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WangSuLi;

impl WangSuLi {
    /// μ·I_y·q/(q + p) for the slip speed |v_t| > 0, so that q + p > 0.
    fn opposing<N: Number>(contact: &Contact<N>, speed: &N) -> N {
        let q = speed.double();
        let share = q.clone() / (q + contact.sliding_change());
        contact.sliding_impulse() * share
    }
}

impl ImpactLaw for WangSuLi {
    const ID: &'static str = "wang-su-li";

    fn statement(&self) -> &'static str {
        "i_x = (k + 1)/2"
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &Regime::by_slip(
                |_, contact: &Contact<N>| Self::opposing(contact, contact.slip()),
                |_, contact: &Contact<N>| -Self::opposing(contact, &-contact.slip().clone()),
            )
        }
    }

    fn ratios<N: Number>(&self, alpha: &Alpha<N>) -> Option<Ratios<N>> {
        Some(match alpha {
            Alpha::Finite(alpha) => {
                let sum = N::one() + alpha;
                let impulse = N::one() / &sum;
                Ratios {
                    // Not 2·i_x − 1: near α = 1 that would cancel to noise.
                    k: (N::one() - alpha) / sum,
                    energy: -impulse.square(),
                    impulse,
                }
            }
            Alpha::Infinite => Ratios { k: -N::one(), impulse: N::zero(), energy: N::zero() },
        })
    }
}
