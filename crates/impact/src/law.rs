//! What an impact law is: an ordered list of regimes.

use std::ops::Deref;

use kane_number::{Comparison, Number, Ordered, Rational, Real};

use crate::resolution::{self, NoImpulse, Regimes, Settled};
use crate::{Alpha, Contact, Facing, Frame, Impulse, LawInfo, Outcome, Ratios, Restitution};

/// A sign that a guard asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// > 0
    Positive,
    /// ≥ 0
    NotNegative,
    /// = 0
    Zero,
    /// ≤ 0
    NotPositive,
    /// < 0
    Negative,
}

impl Relation {
    /// Whether a quantity of this sign is as asked, or `None` if that is not certain.
    #[inline]
    #[must_use]
    pub fn admits(self, sign: Comparison) -> Option<bool> {
        match self {
            Self::Positive => sign.is_greater(),
            Self::NotNegative => sign.is_at_least(),
            Self::Zero => sign.is_equal(),
            Self::NotPositive => sign.is_at_most(),
            Self::Negative => sign.is_less(),
        }
    }
}

/// Guards as constants, which a constant expression keeps only in a constant of their own.
macro_rules! guards {
    ($($guard:expr),* $(,)?) => { const { &[$($guard),*] } };
}
pub(crate) use guards;

/// A condition on the contact: a quantity, by field arithmetic, and the sign that it must have.
pub struct Guard<L, N> {
    /// The quantity whose sign decides.
    pub quantity: fn(&L, &Contact<N>) -> N,
    /// The sign asked for.
    pub relation: Relation,
}

/// The coefficients of a polynomial, c₀ first. The last may be zero.
#[derive(Clone, Debug, PartialEq)]
pub enum Coefficients<N> {
    /// c₀ + c₁·x + c₂·x²
    Quadratic([N; 3]),
    /// c₀ + c₁·x + c₂·x² + c₃·x³
    Cubic([N; 4]),
}

impl<N> Deref for Coefficients<N> {
    type Target = [N];

    fn deref(&self) -> &[N] {
        match self {
            Self::Quadratic(coefficients) => coefficients,
            Self::Cubic(coefficients) => coefficients,
        }
    }
}

/// The one number of a regime that field arithmetic does not reach.
pub struct Root<L, N> {
    /// The polynomial c₀ + c₁·x + …
    pub coefficients: fn(&L, &Contact<N>) -> Coefficients<N>,
    /// The interval of which the greatest root is meant; the signs at its ends differ.
    pub between: fn(&L, &Contact<N>) -> (N, N),
}

/// A formula of a regime: field arithmetic in the law, the contact and the root.
pub type Formula<L, N, T> = fn(&L, &Contact<N>, &N) -> T;

/// A part of the domain on which the impulse is one branch-free formula.
///
/// Regimes are written for contacts that face forwards; the others are their mirror images, so
/// that every law is odd by construction. Choosing the regime is the only comparison that a law
/// makes. On rational functions, which have no order, guards become hypotheses.
pub struct Regime<L: 'static, N: 'static> {
    /// What happens at the contact, for people.
    pub name: &'static str,
    /// All must hold.
    pub guards: &'static [Guard<L, N>],
    /// The root that the formulas may use; without one they are given zero.
    pub root: Option<Root<L, N>>,
    /// The impulse in N·s, by field arithmetic in the contact and the root.
    pub impulse: Formula<L, N, Impulse<N>>,
    /// `v_t⁺`, where v + W·p would cancel; m/s.
    pub slip: Option<Formula<L, N, N>>,
    /// The work of friction, where `p_t`·(`v_t` + `v_t⁺`)/2 would cancel; J.
    pub work: Option<Formula<L, N, N>>,
}

/// A law that gives the impulse of a collision.
pub trait ImpactLaw: Clone + Send + Sync + 'static {
    /// What is said about the law.
    const INFO: LawInfo;

    /// The values of its own parameters, in the order of [`LawInfo::parameters`].
    fn values(&self) -> Vec<&Rational> {
        Vec::new()
    }

    /// The same, to be set.
    fn values_mut(&mut self) -> Vec<&mut Rational> {
        Vec::new()
    }

    /// The law's own parameters by the names of the statement, beyond μ and e.
    fn parameters(&self) -> Vec<(&'static str, Rational)> {
        let names = Self::INFO.parameters.iter().map(|parameter| parameter.name);
        names.zip(self.values().into_iter().cloned()).collect()
    }

    /// The name of the law in every table and report; printed and true forms differ.
    fn id(&self) -> &'static str {
        Self::INFO.id
    }

    /// Who published the law, and what was consulted: one sentence without its full stop.
    fn source(&self) -> &'static str {
        Self::INFO.source
    }

    /// See [`LawInfo::statement`].
    fn statement(&self) -> &'static str {
        Self::INFO.statement
    }

    /// See [`LawInfo::stated_for_coupling`].
    fn is_stated_for_coupling(&self) -> bool {
        Self::INFO.stated_for_coupling
    }

    /// The hypothesis of restitution; Newton's unless the law says otherwise.
    fn restitution(&self) -> Restitution {
        Self::INFO.restitution
    }

    /// What the law lacks where no regime applies, or `None` if the regimes cover every contact.
    fn gap(&self) -> Option<&'static str> {
        Self::INFO.gap
    }

    /// The frame in which the law's statement, friction cone and restitution stand, for a contact
    /// that faces forwards and slips; `None` where that is the contact's own, as it always is
    /// without slip.
    fn frame<N: Number>(&self, _: &Contact<N>) -> Option<Frame<N>> {
        None
    }

    /// The regimes in order, for contacts that face forwards; the first whose guards hold is taken.
    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>];

    /// A quantity of the impulse that must not be negative for the law to accept it, at a contact
    /// that faces forwards; where it is negative there is a [`gap`](Self::gap).
    fn acceptance<N: Number>(&self, _: &Contact<N>, _: &Impulse<N>) -> Option<N> {
        None
    }

    /// The limit of k in normal collision, α → ∞, where `i_x` and Δe vanish; `None` without a limit.
    fn normal_collision(&self) -> Option<Rational>;

    /// The regime that applies, with the contact turned to face forwards and the root.
    ///
    /// # Errors
    /// [`NoImpulse`] if no regime applies, or none can be chosen in this number system.
    fn regime<N: Real>(&self, contact: &Contact<N>) -> Result<Chosen<Self, N>, NoImpulse> {
        let Settled { place, facing, contact, root } = resolution::settled(self, contact)?;
        let regime = &self.regimes::<N>()[place];
        Ok(Chosen { regime, facing, contact, root: root.unwrap_or_else(N::zero) })
    }

    /// Gives the impulse in N·s, by the first regime that applies.
    ///
    /// Exact in exact numbers; see each law for its bound in floats. A float beyond the range is
    /// ±∞ or NaN, as everywhere in IEEE 754.
    ///
    /// # Errors
    /// [`NoImpulse`], see [`regime`](Self::regime).
    fn impulse<N: Real>(&self, contact: &Contact<N>) -> Result<Impulse<N>, NoImpulse> {
        resolution::impulse(self, contact)
    }

    /// Gives the impulse with all that follows from it at the contact.
    ///
    /// # Errors
    /// [`NoImpulse`], see [`regime`](Self::regime).
    fn resolve<N: Real>(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        Ok(resolution::resolved(self, contact)?.0)
    }

    /// The law in terms of α, for `v_t` > 0, or `None` where it has no finite value: its outcome on
    /// [`Contact::of_alpha`]. `None` also of a law with a [frame](Self::frame) of its own, whose k
    /// depends on e, μ and the angle of incidence one by one.
    ///
    /// Exact in exact numbers; see each law for its bound in floats.
    fn ratios<N: Real>(&self, alpha: &Alpha<N>) -> Option<Ratios<N>> {
        resolution::ratios(self, alpha)
    }
}

#[inline(always)]
fn regime<L: ImpactLaw, N: Number>(law: &L, place: usize) -> &'static Regime<L, N> {
    &law.regimes::<N>()[place]
}

impl<L: ImpactLaw, N: Real> Regimes<N> for L {
    #[inline(always)]
    fn info(&self) -> &'static LawInfo {
        const { &L::INFO }
    }

    fn normal_collision(&self) -> Option<Rational> {
        ImpactLaw::normal_collision(self)
    }

    #[inline(always)]
    fn has_frame(&self, contact: &Contact<N>) -> bool {
        self.frame(contact).is_some()
    }

    #[inline(always)]
    fn acceptance(&self, contact: &Contact<N>, impulse: &Impulse<N>) -> Option<N> {
        ImpactLaw::acceptance(self, contact, impulse)
    }

    #[inline(always)]
    fn count(&self) -> usize {
        self.regimes::<N>().len()
    }

    #[inline(always)]
    fn name(&self, place: usize) -> &'static str {
        regime::<L, N>(self, place).name
    }

    #[inline(always)]
    fn applies(&self, place: usize, contact: &Contact<N>) -> Option<bool> {
        regime(self, place).applies(self, contact)
    }

    #[inline(always)]
    fn root(&self, place: usize, contact: &Contact<N>) -> Option<Option<N>> {
        regime(self, place).root.as_ref().map(|root| root.solve(self, contact))
    }

    #[inline(always)]
    fn impulse(&self, place: usize, contact: &Contact<N>, root: &N) -> Impulse<N> {
        (regime(self, place).impulse)(self, contact, root)
    }

    #[inline(always)]
    fn slip(&self, place: usize, contact: &Contact<N>, root: &N) -> Option<N> {
        regime(self, place).slip.map(|slip| slip(self, contact, root))
    }

    #[inline(always)]
    fn work(&self, place: usize, contact: &Contact<N>, root: &N) -> Option<N> {
        regime(self, place).work.map(|work| work(self, contact, root))
    }
}

/// A regime that applies, and what its formulas are given.
pub struct Chosen<L: 'static, N: 'static> {
    /// The regime.
    pub regime: &'static Regime<L, N>,
    /// Which way the contact faced.
    pub facing: Facing,
    /// The contact, turned to face forwards.
    pub contact: Contact<N>,
    /// The root, or zero if the regime has none.
    pub root: N,
}

impl<L: ImpactLaw, N: Number> Regime<L, N> {
    /// A regime in closed form.
    pub(crate) const fn new(
        name: &'static str,
        guards: &'static [Guard<L, N>],
        impulse: Formula<L, N, Impulse<N>>,
    ) -> Self {
        Self { name, guards, root: None, impulse, slip: None, work: None }
    }

    /// The same, with a root.
    pub(crate) const fn with_root(self, root: Root<L, N>) -> Self {
        Self { root: Some(root), ..self }
    }
}

impl<L, N: Ordered> Regime<L, N> {
    /// Whether all guards hold, or `None` if that is undecided: one failing guard decides.
    #[inline]
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

impl<L, N: Real> Root<L, N> {
    /// The root, or `None` if it is no number of this system or cannot be told.
    pub(crate) fn solve(&self, law: &L, contact: &Contact<N>) -> Option<N> {
        let (lower, upper) = (self.between)(law, contact);
        N::greatest_root(&(self.coefficients)(law, contact), &lower, &upper)
    }
}

impl<L, N: Number> Guard<L, N> {
    /// Asks for the sign of a quantity.
    pub(crate) const fn new(relation: Relation, quantity: fn(&L, &Contact<N>) -> N) -> Self {
        Self { quantity, relation }
    }

    /// `v_t` = 0.
    pub(crate) const fn no_slip() -> Self {
        Self::new(Relation::Zero, |_, contact| contact.slip().clone())
    }

    /// `W_tn` = 0.
    pub(crate) const fn uncoupled() -> Self {
        Self::new(Relation::Zero, |_, contact| contact.delassus().tn().clone())
    }

    /// `W_nn` − μ·`W_tn` > 0: forward sliding separates the bodies.
    pub(crate) const fn slides_apart() -> Self {
        Self::new(Relation::Positive, |_, contact| contact.separation_rate())
    }

    /// `v_t⁺` ≥ 0 if the contact slides forwards all the time, given that it slides apart.
    pub(crate) const fn slides_on() -> Self {
        Self::new(Relation::NotNegative, |_, contact| {
            let before = contact.slip().clone() * contact.separation_rate();
            before - contact.closing() * contact.slowing_rate()
        })
    }
}

impl<L, N: Ordered> Guard<L, N> {
    #[inline]
    fn holds(&self, law: &L, contact: &Contact<N>) -> Option<bool> {
        self.relation.admits((self.quantity)(law, contact).sign())
    }
}
