//! Sliding with a given share of the friction, for the laws that state one.

use kane_number::{Number, Rational};

use super::whittaker_uncapped::frictionless;
use crate::law::guards;
use crate::{Contact, Guard, ImpactLaw, Regime, Relation};

/// A law whose impulses have a given ratio while the contact slides, i_x = share.
pub(crate) trait Share: ImpactLaw {
    /// The share of μ, a pure number.
    fn share(&self) -> &Rational;
}

/// −`p_t`/`p_n` = share·μ.
fn ratio<L: Share, N: Number>(law: &L, contact: &Contact<N>) -> N {
    N::from_rational(law.share()) * contact.friction()
}

/// Nothing without slip, and the given ratio with it, where that separates the bodies.
pub(crate) const fn regimes<L: Share, N: Number>(sliding: &'static str) -> [Regime<L, N>; 2] {
    [
        Regime::new("no slip", guards![Guard::no_slip()], frictionless),
        Regime::new(
            sliding,
            guards![Guard::new(Relation::Positive, |law: &L, contact: &Contact<N>| {
                let w = contact.delassus();
                (-ratio(law, contact)).mul_add(w.tn(), w.nn())
            })],
            |law, contact, _| contact.with_ratio(&-ratio(law, contact)),
        ),
    ]
}
