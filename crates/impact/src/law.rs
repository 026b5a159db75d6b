//! What an impact law is: an ordered list of regimes.

use kane_number::{Number, Ordered};

use crate::{Alpha, Contact, Ratios};

/// A sign that a guard asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// > 0
    Positive,
    /// = 0
    Zero,
    /// < 0
    Negative,
}

/// A condition on the contact: a quantity, by field arithmetic, and the sign that it must have.
pub struct Guard<L, N> {
    /// The quantity whose sign decides.
    pub quantity: fn(&L, &Contact<N>) -> N,
    /// The sign asked for.
    pub relation: Relation,
}

/// A part of the domain on which the impulse is one branch-free formula.
///
/// Choosing the regime is the only comparison that a law makes. On rational functions, which have
/// no order, the guards become hypotheses.
pub struct Regime<L: 'static, N: 'static> {
    /// What happens at the contact, for people.
    pub name: &'static str,
    /// All must hold.
    pub guards: &'static [Guard<L, N>],
    /// I_x in N·s, by field arithmetic.
    pub impulse: fn(&L, &Contact<N>) -> N,
}

/// Why no regime was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoRegime {
    /// The number system cannot tell whether the regime applies.
    #[error("{law}: cannot decide whether the contact is in the regime \"{regime}\"")]
    Undecided {
        /// The law's id.
        law: &'static str,
        /// The first regime in question.
        regime: &'static str,
    },
    /// The guards leave a gap in the domain, which is a defect of the law.
    #[error("{law}: no regime covers the contact")]
    Uncovered {
        /// The law's id.
        law: &'static str,
    },
}

/// A law that gives the tangential impulse of a collision.
pub trait ImpactLaw: Sized + 'static {
    /// The name of the law in every table and report; printed and true forms differ.
    const ID: &'static str;

    /// The constitutive relation in the derivation language, for v_t > 0, in the symbols of
    /// [`Ratios`]: what the law adds to momentum and restitution.
    fn statement(&self) -> &'static str;

    /// The regimes in order; the first whose guards hold is taken.
    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>];

    /// The law in terms of α, for v_t > 0, or `None` where it has no finite value.
    fn ratios<N: Number>(&self, alpha: &Alpha<N>) -> Option<Ratios<N>>;

    /// Gives the tangential impulse I_x in N·s, by the first regime that applies.
    ///
    /// Exact in exact numbers; see each law for its bound in floats. A float beyond the range is
    /// ±∞ or NaN, as everywhere in IEEE 754.
    ///
    /// # Errors
    /// [`NoRegime`] if the number system cannot decide on the regime. Neither rationals nor
    /// floats ever fail so, because a [`Contact`] holds no NaN.
    fn resolve<N: Ordered>(&self, contact: &Contact<N>) -> Result<N, NoRegime> {
        for regime in self.regimes() {
            match regime.applies(self, contact) {
                Some(true) => return Ok((regime.impulse)(self, contact)),
                Some(false) => {}
                None => {
                    let (law, regime) = (Self::ID, regime.name);
                    return Err(NoRegime::Undecided { law, regime });
                }
            }
        }
        Err(NoRegime::Uncovered { law: Self::ID })
    }
}

impl<L, N: Number> Regime<L, N> {
    /// The three regimes of a law that only asks which way the contact slips, and gives no
    /// tangential impulse where it does not.
    #[must_use]
    pub const fn by_slip(
        forward: fn(&L, &Contact<N>) -> N,
        backward: fn(&L, &Contact<N>) -> N,
    ) -> [Self; 3] {
        [
            Self {
                name: "forward slip",
                guards: const { &[Guard::slip(Relation::Positive)] },
                impulse: forward,
            },
            Self {
                name: "no slip",
                guards: const { &[Guard::slip(Relation::Zero)] },
                impulse: |_, _| N::zero(),
            },
            Self {
                name: "backward slip",
                guards: const { &[Guard::slip(Relation::Negative)] },
                impulse: backward,
            },
        ]
    }
}

impl<L, N: Ordered> Regime<L, N> {
    /// Whether all guards hold, or `None` if that is undecided: one failing guard decides.
    #[must_use]
    pub fn applies(&self, law: &L, contact: &Contact<N>) -> Option<bool> {
        let mut decided = Some(true);
        for guard in self.guards {
            match guard.holds(law, contact) {
                Some(true) => {}
                Some(false) => return Some(false),
                None => decided = None,
            }
        }
        decided
    }
}

impl<L, N: Number> Guard<L, N> {
    /// Asks for the sign of the slip v_t.
    const fn slip(relation: Relation) -> Self {
        Self { quantity: |_, contact| contact.slip().clone(), relation }
    }
}

impl<L, N: Ordered> Guard<L, N> {
    fn holds(&self, law: &L, contact: &Contact<N>) -> Option<bool> {
        let sign = (self.quantity)(law, contact).sign();
        match self.relation {
            Relation::Positive => sign.is_greater(),
            Relation::Zero => sign.is_equal(),
            Relation::Negative => sign.is_less(),
        }
    }
}
