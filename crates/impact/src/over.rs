//! A law over one number system, whatever its type: what stands above laws is written for these.
//!
//! Authors write [`ImpactLaw`], which is generic; every law then has these faces by itself. A call
//! goes through a table once a collision, and the arithmetic behind it is the law's own.

use kane_number::{Number, Real};

use crate::law::resolved;
use crate::{
    Alpha, Chosen, Contact, Facing, Frame, ImpactLaw, Impulse, LawInfo, NoImpulse, Outcome, Ratios,
    Regime, Relation,
};

/// The equation of a regime's root at a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation<N> {
    /// c₀, c₁, …
    pub coefficients: Vec<N>,
    /// The interval of which the greatest root is meant.
    pub between: (N, N),
}

/// A regime of a law, see [`Regime`].
pub trait RegimeOver<N: Number> {
    /// What happens at the contact, for people.
    fn name(&self) -> &'static str;

    /// The guards at a contact: quantities, and the sign that each must have.
    fn guards<'a>(
        &'a self,
        contact: &'a Contact<N>,
    ) -> Box<dyn Iterator<Item = (N, Relation)> + 'a>;

    /// The equation of the root, if there is one.
    fn equation(&self, contact: &Contact<N>) -> Option<Equation<N>>;

    /// The impulse at a contact that faces forwards, given the root.
    fn impulse(&self, contact: &Contact<N>, root: &N) -> Impulse<N>;

    /// What follows at a contact that faces forwards, given the root.
    fn outcome(&self, contact: &Contact<N>, root: &N) -> Outcome<N>;
}

/// A law's formulas, without any comparison.
pub trait Formulas<N: Number> {
    /// What is said about the law.
    fn info(&self) -> &'static LawInfo;

    /// See [`ImpactLaw::frame`].
    fn frame(&self, contact: &Contact<N>) -> Option<Frame<N>>;

    /// See [`ImpactLaw::acceptance`].
    fn acceptance(&self, contact: &Contact<N>, impulse: &Impulse<N>) -> Option<N>;

    /// See [`ImpactLaw::regimes`].
    fn regimes(&self) -> Vec<Box<dyn RegimeOver<N> + '_>>;
}

/// A law that chooses its regime and resolves contacts.
pub trait LawOver<N: Real>: Formulas<N> {
    /// See [`ImpactLaw::regime`].
    ///
    /// # Errors
    /// As there.
    fn regime(&self, contact: &Contact<N>) -> Result<Taken<N>, NoImpulse>;

    /// The place of the first regime whose guards all hold for certain, at a contact that faces
    /// forwards; `None` if there is none.
    fn place(&self, contact: &Contact<N>) -> Option<usize>;

    /// See [`ImpactLaw::impulse`].
    ///
    /// # Errors
    /// As there.
    fn impulse(&self, contact: &Contact<N>) -> Result<Impulse<N>, NoImpulse>;

    /// See [`ImpactLaw::resolve`].
    ///
    /// # Errors
    /// As there.
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse>;

    /// The outcome, and the root of its regime if that has one.
    ///
    /// # Errors
    /// As [`ImpactLaw::resolve`].
    fn resolve_with_root(&self, contact: &Contact<N>)
    -> Result<(Outcome<N>, Option<N>), NoImpulse>;

    /// See [`ImpactLaw::ratios`].
    fn ratios(&self, alpha: &Alpha<N>) -> Option<Ratios<N>>;
}

/// The regime that a law takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Taken<N> {
    /// What happens at the contact, for people.
    pub name: &'static str,
    /// Which way the contact faced.
    pub facing: Facing,
    /// The contact, turned to face forwards.
    pub contact: Contact<N>,
    /// The root, if the regime has one.
    pub root: Option<N>,
}

/// A regime with its law.
struct Bound<'l, L: 'static, N: 'static> {
    law: &'l L,
    regime: &'static Regime<L, N>,
}

impl<L: ImpactLaw, N: Number> RegimeOver<N> for Bound<'_, L, N> {
    fn name(&self) -> &'static str {
        self.regime.name
    }

    fn guards<'a>(
        &'a self,
        contact: &'a Contact<N>,
    ) -> Box<dyn Iterator<Item = (N, Relation)> + 'a> {
        let guards = self.regime.guards.iter();
        Box::new(guards.map(|guard| ((guard.quantity)(self.law, contact), guard.relation)))
    }

    fn equation(&self, contact: &Contact<N>) -> Option<Equation<N>> {
        let root = self.regime.root.as_ref()?;
        Some(Equation {
            coefficients: (root.coefficients)(self.law, contact).to_vec(),
            between: (root.between)(self.law, contact),
        })
    }

    fn impulse(&self, contact: &Contact<N>, root: &N) -> Impulse<N> {
        (self.regime.impulse)(self.law, contact, root)
    }

    fn outcome(&self, contact: &Contact<N>, root: &N) -> Outcome<N> {
        self.regime.outcome(self.law, contact, root)
    }
}

impl<L: ImpactLaw, N: Number> Formulas<N> for L {
    fn info(&self) -> &'static LawInfo {
        const { &L::INFO }
    }

    fn frame(&self, contact: &Contact<N>) -> Option<Frame<N>> {
        ImpactLaw::frame(self, contact)
    }

    fn acceptance(&self, contact: &Contact<N>, impulse: &Impulse<N>) -> Option<N> {
        ImpactLaw::acceptance(self, contact, impulse)
    }

    fn regimes(&self) -> Vec<Box<dyn RegimeOver<N> + '_>> {
        let bound =
            |regime| -> Box<dyn RegimeOver<N> + '_> { Box::new(Bound { law: self, regime }) };
        ImpactLaw::regimes::<N>(self).iter().map(bound).collect()
    }
}

impl<L: ImpactLaw, N: Real> LawOver<N> for L {
    fn regime(&self, contact: &Contact<N>) -> Result<Taken<N>, NoImpulse> {
        let Chosen { regime, facing, contact, root } = ImpactLaw::regime(self, contact)?;
        let root = regime.root.as_ref().map(|_| root);
        Ok(Taken { name: regime.name, facing, contact, root })
    }

    fn place(&self, contact: &Contact<N>) -> Option<usize> {
        let holds = |regime: &Regime<L, N>| regime.applies(self, contact) == Some(true);
        ImpactLaw::regimes::<N>(self).iter().position(holds)
    }

    fn impulse(&self, contact: &Contact<N>) -> Result<Impulse<N>, NoImpulse> {
        ImpactLaw::impulse(self, contact)
    }

    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        ImpactLaw::resolve(self, contact)
    }

    fn resolve_with_root(
        &self,
        contact: &Contact<N>,
    ) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
        let (outcome, root) = resolved(self, contact.map(N::to_working))?;
        Ok((outcome.map(N::from_working), root.as_ref().map(N::from_working)))
    }

    fn ratios(&self, alpha: &Alpha<N>) -> Option<Ratios<N>> {
        ImpactLaw::ratios(self, alpha)
    }
}
