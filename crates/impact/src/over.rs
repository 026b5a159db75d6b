//! A law over one number system, whatever its type: what stands above laws is written for these.
//!
//! Authors write [`ImpactLaw`], which is generic; every law then has these faces by itself. A call
//! goes through a table once a collision, and the arithmetic behind it is the law's own.

use kane_number::{Number, Real};

use crate::resolution::{self, Regimes, Settled};
use crate::{
    Alpha, Coefficients, Contact, Facing, Frame, ImpactLaw, Impulse, LawInfo, NoImpulse, Outcome,
    Ratios, Regime, Relation,
};

/// The equation of a regime's root at a contact.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation<N> {
    /// c₀, c₁, …
    pub coefficients: Vec<N>,
    /// The interval of which the greatest root is meant.
    pub between: (N, N),
}

impl<N> Equation<N> {
    fn new(coefficients: Coefficients<N>, between: (N, N)) -> Self {
        let coefficients = match coefficients {
            Coefficients::Quadratic(coefficients) => coefficients.into(),
            Coefficients::Cubic(coefficients) => coefficients.into(),
        };
        Self { coefficients, between }
    }
}

/// A regime of a law, see [`Regime`].
pub trait RegimeOver<N: Number> {
    /// What happens at the contact, for people.
    fn name(&self) -> &'static str;

    /// A guard at a contact by its place: a quantity, and the sign that it must have; `None` beyond the last.
    fn guard(&self, place: usize, contact: &Contact<N>) -> Option<(N, Relation)>;

    /// The equation of the root, if there is one.
    fn equation(&self, contact: &Contact<N>) -> Option<Equation<N>>;

    /// The impulse at a contact that faces forwards, given the root.
    fn impulse(&self, contact: &Contact<N>, root: &N) -> Impulse<N>;

    /// What follows at a contact that faces forwards, given the root.
    fn outcome(&self, contact: &Contact<N>, root: &N) -> Outcome<N>;
}

impl<N: Number> dyn RegimeOver<N> + '_ {
    /// The guards at a contact: quantities, and the sign that each must have.
    pub fn guards(&self, contact: &Contact<N>) -> impl Iterator<Item = (N, Relation)> {
        (0..).map_while(move |place| self.guard(place, contact))
    }
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

    fn guard(&self, place: usize, contact: &Contact<N>) -> Option<(N, Relation)> {
        let guard = self.regime.guards.get(place)?;
        Some(((guard.quantity)(self.law, contact), guard.relation))
    }

    fn equation(&self, contact: &Contact<N>) -> Option<Equation<N>> {
        let root = self.regime.root.as_ref()?;
        let coefficients = (root.coefficients)(self.law, contact);
        Some(Equation::new(coefficients, (root.between)(self.law, contact)))
    }

    fn impulse(&self, contact: &Contact<N>, root: &N) -> Impulse<N> {
        (self.regime.impulse)(self.law, contact, root)
    }

    fn outcome(&self, contact: &Contact<N>, root: &N) -> Outcome<N> {
        let Self { law, regime } = self;
        let told = (
            regime.slip.map(|slip| slip(law, contact, root)),
            regime.work.map(|work| work(law, contact, root)),
        );
        let impulse = (regime.impulse)(law, contact, root);
        let has_frame = ImpactLaw::frame(*law, contact).is_some();
        resolution::outcome(&L::INFO, regime.name, contact, impulse, told, has_frame)
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
        let all = ImpactLaw::regimes::<N>(self);
        listed(all.len(), &|place| Box::new(Bound { law: self, regime: &all[place] }))
    }
}

/// The regimes at all places.
fn listed<'l, N>(
    count: usize,
    at: &dyn Fn(usize) -> Box<dyn RegimeOver<N> + 'l>,
) -> Vec<Box<dyn RegimeOver<N> + 'l>> {
    (0..count).map(at).collect()
}

/// A function of a resolution: over the law itself in floats, elsewhere over the table of its formulas.
macro_rules! resolve {
    ($number:ty, $function:ident, $law:expr, $given:expr) => {
        if <$number as Real>::IS_FLOAT {
            resolution::$function($law, $given)
        } else {
            resolution::tabled::$function($law, $given)
        }
    };
}

impl<L: ImpactLaw, N: Real> LawOver<N> for L {
    fn regime(&self, contact: &Contact<N>) -> Result<Taken<N>, NoImpulse> {
        let Settled { place, facing, contact, root } = resolve!(N, settled, self, contact)?;
        Ok(Taken { name: Regimes::<N>::name(self, place), facing, contact, root })
    }

    fn place(&self, contact: &Contact<N>) -> Option<usize> {
        resolution::place(self, contact)
    }

    fn impulse(&self, contact: &Contact<N>) -> Result<Impulse<N>, NoImpulse> {
        resolve!(N::Working, impulse, self, contact)
    }

    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        Ok(resolve!(N::Working, resolved, self, contact)?.0)
    }

    fn resolve_with_root(
        &self,
        contact: &Contact<N>,
    ) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
        resolve!(N::Working, resolved, self, contact)
    }

    fn ratios(&self, alpha: &Alpha<N>) -> Option<Ratios<N>> {
        resolve!(N::Working, ratios, self, alpha)
    }
}
