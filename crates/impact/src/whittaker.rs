//! Whittaker's hypothesis as the paper states it, without a stop.

use kane_number::Number;

use crate::{Alpha, Contact, ImpactLaw, Ratios, Regime};

/// Friction that slides to the end, whatever the slip does: i_x = 1 (id `whittaker-uncapped`).
///
/// For v_t > 0 and 0 ≤ α < ∞,
///
/// ```text
/// k = 1 − 2α    i_x = 1    Δe = α − 1
/// ```
///
/// so that energy is created for large α; this is Kane's puzzle. Odd in the slip, and without
/// tangential impulse at v_t = 0, where the law jumps from −μ·I_y to μ·I_y.
///
/// Source: E. T. Whittaker (1904) as quoted by Wang, Su and Li, equations (20) to (23); original
/// not consulted. As published the law is said to stop the slip at zero; this is the form without
/// that stop.
///
/// In floats [`resolve`](ImpactLaw::resolve) is correctly rounded for a given contact, and so are
/// k and Δe of [`ratios`](ImpactLaw::ratios), save for overflow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WhittakerUncapped;

impl ImpactLaw for WhittakerUncapped {
    const ID: &'static str = "whittaker-uncapped";

    fn statement(&self) -> &'static str {
        "i_x = 1"
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &Regime::by_slip(
                |_, contact: &Contact<N>| contact.sliding_impulse(),
                |_, contact: &Contact<N>| -contact.sliding_impulse(),
            )
        }
    }

    fn ratios<N: Number>(&self, alpha: &Alpha<N>) -> Option<Ratios<N>> {
        match alpha {
            Alpha::Finite(alpha) => Some(Ratios {
                k: N::one() - alpha.double(),
                impulse: N::one(),
                energy: alpha.clone() - N::one(),
            }),
            // k falls without bound.
            Alpha::Infinite => None,
        }
    }
}
