//! What an impact law is: an ordered list of regimes.

use std::ops::Deref;

use kane_number::{Number, Ordered, Rational, Real};

use crate::{Alpha, Contact, Facing, Frame, Impulse, LawInfo, Outcome, Ratios, Restitution, Work};

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

/// Why a law gives no impulse.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum NoImpulse {
    /// The number system cannot tell whether the regime applies.
    #[error("{law}: cannot decide whether the contact is in the regime \"{regime}\"")]
    Undecided {
        /// The law's id.
        law: &'static str,
        /// The first regime in question.
        regime: &'static str,
    },
    /// The number system does not hold the root that the regime needs.
    #[error("{law}: the impulse of the regime \"{regime}\" is no number of this system")]
    Unrepresentable {
        /// The law's id.
        law: &'static str,
        /// The regime that applies.
        regime: &'static str,
    },
    /// The law says nothing of such a contact.
    #[error("{law}: {reason}")]
    Outside {
        /// The law's id.
        law: &'static str,
        /// What the law lacks there.
        reason: &'static str,
    },
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
        let (facing, contact) = forwards(self, contact.clone())?;
        let (regime, root) = taken(self, &contact, |_, regime, _, root| Ok((regime, root)))?;
        Ok(Chosen { regime, facing, contact, root })
    }

    /// Gives the impulse in N·s, by the first regime that applies.
    ///
    /// Exact in exact numbers; see each law for its bound in floats. A float beyond the range is
    /// ±∞ or NaN, as everywhere in IEEE 754.
    ///
    /// # Errors
    /// [`NoImpulse`], see [`regime`](Self::regime).
    fn impulse<N: Real>(&self, contact: &Contact<N>) -> Result<Impulse<N>, NoImpulse> {
        let (facing, contact) = forwards(self, contact.map(N::to_working))?;
        let impulse = taken(self, &contact, accepted_impulse)?;
        let impulse = match facing {
            Facing::Forward => impulse,
            Facing::Backward => impulse.mirrored(),
        };
        Ok(impulse.map(N::from_working))
    }

    /// Gives the impulse with all that follows from it at the contact.
    ///
    /// # Errors
    /// [`NoImpulse`], see [`regime`](Self::regime).
    fn resolve<N: Real>(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        let (outcome, _) = resolved(self, contact.map(N::to_working))?;
        Ok(outcome.map(N::from_working))
    }

    /// The law in terms of α, for `v_t` > 0, or `None` where it has no finite value: its outcome on
    /// [`Contact::of_alpha`]. `None` also of a law with a [frame](Self::frame) of its own, whose k
    /// depends on e, μ and the angle of incidence one by one.
    ///
    /// Exact in exact numbers; see each law for its bound in floats.
    fn ratios<N: Real>(&self, alpha: &Alpha<N>) -> Option<Ratios<N>> {
        let alpha = match alpha {
            Alpha::Finite(alpha) => alpha,
            Alpha::Infinite => {
                let k = N::from_rational(&self.normal_collision()?);
                return Some(Ratios { k, impulse: N::zero(), energy: N::zero() });
            }
        };
        let contact = Contact::of_alpha(alpha.to_working());
        if self.frame(&contact).is_some() {
            return None;
        }
        let (outcome, _) = resolved(self, contact).ok()?;
        // v_t = 1/2 and μ·p_n = 1
        let ratios = Ratios {
            k: outcome.slip.double(),
            impulse: -outcome.impulse.tangential,
            energy: outcome.work.tangential.double(),
        };
        Some(ratios.map(N::from_working))
    }
}

/// The contact turned to face forwards, and how it faced.
#[inline]
fn forwards<L: ImpactLaw, N: Real>(
    law: &L,
    contact: Contact<N>,
) -> Result<(Facing, Contact<N>), NoImpulse> {
    match contact.facing() {
        Some(Facing::Forward) => Ok((Facing::Forward, contact)),
        Some(Facing::Backward) => Ok((Facing::Backward, contact.mirrored())),
        None => Err(NoImpulse::Undecided { law: law.id(), regime: "forward or backward slip" }),
    }
}

/// What `then` makes of the first regime that applies, and its root, at a contact that faces forwards.
#[inline(always)]
fn taken<L: ImpactLaw, N: Real, T>(
    law: &L,
    contact: &Contact<N>,
    then: impl Fn(&L, &'static Regime<L, N>, &Contact<N>, N) -> Result<T, NoImpulse>,
) -> Result<T, NoImpulse> {
    // At a place that is a constant the compiler sees the formulas of the regime and what they share.
    // It is worth its length where these are a few instructions.
    if N::IS_FLOAT
        && let Some(value) = at(law, 0, contact, &then)
            .or_else(|| at(law, 1, contact, &then))
            .or_else(|| at(law, 2, contact, &then))
    {
        return value;
    }
    let places = if N::IS_FLOAT { 3 } else { 0 }..law.regimes::<N>().len();
    for place in places {
        if let Some(value) = at(law, place, contact, &then) {
            return value;
        }
    }
    Err(outside(law))
}

/// The same of the regime at a place; `None` if there is none or it does not apply.
#[inline(always)]
fn at<L: ImpactLaw, N: Real, T>(
    law: &L,
    place: usize,
    contact: &Contact<N>,
    then: &impl Fn(&L, &'static Regime<L, N>, &Contact<N>, N) -> Result<T, NoImpulse>,
) -> Option<Result<T, NoImpulse>> {
    let regime = law.regimes::<N>().get(place)?;
    match regime.applies(law, contact) {
        Some(true) => {}
        Some(false) => return None,
        None => return Some(Err(NoImpulse::Undecided { law: law.id(), regime: regime.name })),
    }
    let root = match &regime.root {
        None => Some(N::zero()),
        Some(root) => root.solve(law, contact),
    };
    Some(match root {
        Some(root) => then(law, regime, contact, root),
        None => Err(NoImpulse::Unrepresentable { law: law.id(), regime: regime.name }),
    })
}

/// The impulse of a regime, if the law accepts it.
#[inline(always)]
fn accepted_impulse<L: ImpactLaw, N: Real>(
    law: &L,
    regime: &'static Regime<L, N>,
    contact: &Contact<N>,
    root: N,
) -> Result<Impulse<N>, NoImpulse> {
    let impulse = (regime.impulse)(law, contact, &root);
    accept(law, regime.name, contact, &impulse)?;
    Ok(impulse)
}

/// The outcome of a regime, if the law accepts its impulse, and the root if there is one.
#[inline(always)]
fn accepted_outcome<L: ImpactLaw, N: Real>(
    law: &L,
    regime: &'static Regime<L, N>,
    contact: &Contact<N>,
    root: N,
) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
    let outcome = regime.outcome(law, contact, &root);
    accept(law, regime.name, contact, &outcome.impulse)?;
    Ok((outcome, regime.root.as_ref().map(|_| root)))
}

/// The outcome of a law, and the root of its regime if that has one.
#[inline(always)]
pub(crate) fn resolved<L: ImpactLaw, N: Real>(
    law: &L,
    contact: Contact<N>,
) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
    let (facing, contact) = forwards(law, contact)?;
    let (outcome, root) = taken(law, &contact, accepted_outcome)?;
    Ok(match facing {
        Facing::Forward => (outcome, root),
        Facing::Backward => (outcome.mirrored(), root),
    })
}

fn outside<L: ImpactLaw>(law: &L) -> NoImpulse {
    let reason = law.gap().unwrap_or("no regime applies, which is a defect of the law");
    NoImpulse::Outside { law: law.id(), reason }
}

#[inline]
fn accept<L: ImpactLaw, N: Real>(
    law: &L,
    regime: &'static str,
    contact: &Contact<N>,
    impulse: &Impulse<N>,
) -> Result<(), NoImpulse> {
    let Some(quantity) = law.acceptance(contact, impulse) else { return Ok(()) };
    match quantity.sign().is_at_least() {
        Some(true) => Ok(()),
        Some(false) => Err(match L::INFO.rejects {
            Some(reason) => NoImpulse::Outside { law: law.id(), reason },
            None => outside(law),
        }),
        None => Err(NoImpulse::Undecided { law: law.id(), regime }),
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

    /// What follows at a contact that faces forwards, given the root.
    #[inline(always)]
    pub fn outcome(&self, law: &L, contact: &Contact<N>, root: &N) -> Outcome<N> {
        let impulse = (self.impulse)(law, contact, root);
        let slip = match self.slip {
            Some(slip) => slip(law, contact, root),
            None => contact.slip_after(&impulse),
        };
        let half = |x: N| x / N::one().double();
        let tangential = match self.work {
            Some(work) => work(law, contact, root),
            None => half((slip.clone() + contact.slip()) * &impulse.tangential),
        };
        let (separation, normal) = match law.restitution() {
            Restitution::Newton if law.frame(contact).is_none() => {
                let (e, a) = (contact.restitution(), contact.approach());
                let loss = (N::one() - e) * a * &impulse.normal;
                (e.clone() * a, -half(loss))
            }
            Restitution::Newton | Restitution::Poisson | Restitution::Energetic => {
                let separation = contact.separation_after(&impulse);
                let mean = separation.clone() - contact.approach();
                (separation, half(mean * &impulse.normal))
            }
        };
        let work = Work { normal, tangential };
        Outcome { regime: self.name, impulse, slip, separation, work }
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
    fn solve(&self, law: &L, contact: &Contact<N>) -> Option<N> {
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
        let sign = (self.quantity)(law, contact).sign();
        match self.relation {
            Relation::Positive => sign.is_greater(),
            Relation::NotNegative => sign.is_at_least(),
            Relation::Zero => sign.is_equal(),
            Relation::NotPositive => sign.is_at_most(),
            Relation::Negative => sign.is_less(),
        }
    }
}
