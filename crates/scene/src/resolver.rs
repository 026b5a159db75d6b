//! What resolves an impact: a law, or a process.

use kane_impact::{Contact, Delassus, ImpactLaw, Impulse, NoImpulse, Outcome, Work};
use kane_number::{Interval, Number as _, Ordered as _, Rational, Real};

use crate::coordinate::{Coordinate, half};

/// Something that gives the outcome of an impact, in a number system.
pub trait Resolver<N> {
    /// The outcome at a contact.
    ///
    /// # Errors
    /// [`NoImpulse`] where it has none, or the number system cannot tell.
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse>;
}

/// An impact law, in every number system.
#[derive(Clone, Debug)]
pub struct ByLaw<L>(pub L);

impl<L: ImpactLaw, N: Real> Resolver<N> for ByLaw<L> {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        self.0.resolve(contact)
    }
}

/// No tangential impulse: one dimension. It looks at no slip, so that none need be decided.
#[derive(Clone, Copy, Debug)]
pub struct NormalOnly;

impl<N, R: Resolver<N> + ?Sized> Resolver<N> for &R {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        (**self).resolve(contact)
    }
}

impl<N: Real> Resolver<N> for NormalOnly {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        let normal = contact.closing() / contact.delassus().nn();
        Ok(with_impulse("no friction", contact, Impulse { tangential: N::zero(), normal }))
    }
}

fn with_impulse<N: Real>(
    regime: &'static str,
    contact: &Contact<N>,
    impulse: Impulse<N>,
) -> Outcome<N> {
    let slip = contact.slip_after(&impulse);
    let separation = contact.restitution().clone() * contact.approach();
    let work = Work {
        normal: half((separation.clone() - contact.approach()) * &impulse.normal),
        tangential: half((slip.clone() + contact.slip()) * &impulse.tangential),
    };
    Outcome { regime, impulse, slip, separation, work }
}

/// The answer of a compliant process at one α, with a bound on or an estimate of its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compliant {
    /// k = `v_t⁺`/`v_t`
    pub k: f64,
    /// `i_x` = −`p_t`/(μ·`p_n`)
    pub impulse: f64,
    /// Δe, the work of friction by μ·`p_n`·`v_t`
    pub energy: f64,
    /// how far k may be from the process's own exact answer, by refinement
    pub error: f64,
}

/// A compliant contact process of a sphere, seen from a scene: dimensionless, as in
/// [`Ratios`](kane_impact::Ratios).
pub trait Process {
    /// Its name in tables.
    fn id(&self) -> &'static str;

    /// k, `i_x` and Δe at α = `W_tt`·μ·(1 + e)·a/(2·`W_nn`·`v_t`) > 0 for Poisson's ratio ν and
    /// restitution e; `None` outside the domain.
    fn answer(&self, alpha: f64, poisson_ratio: f64, restitution: f64) -> Option<Compliant>;
}

/// An elastic contact: sliding all the time where that is documented, and a process elsewhere.
///
/// Maw, Barber and Fawcett (1976), for e = 1: sliding all the time for ψ₁ > 4χ − 1, that is
/// α < 2χ/(4χ − 1) with χ = (1 − ν)·`W_tt`/((2 − ν)·`W_nn`). Stronge's bilinear pair (1994), for any e:
/// α < (1 + e)/2, and where e² ≥ η²/β₁ also α < 1/(2·(1 − η²/(e·(1 + e)·β₁))), η² = (2 − ν)/(2·(1 − ν))
/// and β₁ = `W_tt`/`W_nn`; the two agree at e = 1. Bounds taken here: α at most 1/2 for e < 1, where
/// every rigid and compliant model slides, and Maw's for e = 1.
#[derive(Clone, Debug)]
pub struct Elastic<'a> {
    /// ν
    pub poisson_ratio: Rational,
    /// What answers beyond sliding; `None` if nothing does.
    pub process: Option<&'a dyn Process>,
}

impl std::fmt::Debug for dyn Process + '_ {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.id())
    }
}

impl Elastic<'_> {
    /// The α below which the contact certainly slides all the time.
    #[must_use]
    pub fn slides_up_to<N: Real>(&self, contact: &Contact<N>) -> N {
        let nu = N::from_rational(&self.poisson_ratio);
        let two = N::one().double();
        let w: &Delassus<N> = contact.delassus();
        let bound = half(N::one());
        if (N::one() - contact.restitution()).sign().is_equal() != Some(true) {
            return bound;
        }
        let chi = (N::one() - &nu) * w.tt() / ((two.clone() - nu) * w.nn());
        let maw = two.clone() * &chi / (two.double() * chi - N::one());
        if maw.compare(&bound).is_at_least() == Some(true) { maw } else { bound }
    }
}

const BEYOND: NoImpulse = NoImpulse::Outside {
    law: "elastic contact",
    reason: "the contact does not slide all the time, and its tangential compliance decides",
};

impl Elastic<'_> {
    fn enclose(&self, contact: &Contact<Interval>) -> Result<Outcome<Interval>, NoImpulse> {
        let sign = contact.slip().sign();
        if sign.is_equal() == Some(true) {
            return NormalOnly.resolve(contact);
        }
        let law = "elastic contact";
        let undecided = NoImpulse::Undecided { law, regime: "forward or backward slip" };
        let forward = sign.is_greater().filter(|forward| *forward || sign.is_less() == Some(true));
        let forward = forward.ok_or(undecided)?;
        let alpha = contact.alpha().ok_or(undecided)?;
        let alpha = if forward { alpha } else { -alpha };
        let normal = contact.closing() / contact.delassus().nn();
        let limit = self.slides_up_to(contact);
        if alpha.compare(&limit).is_at_most() == Some(true) {
            let friction = normal * contact.friction();
            let tangential = if forward { -friction } else { friction };
            return Ok(with_impulse("slide", contact, Impulse { tangential, normal }));
        }
        let process = self.process.ok_or(BEYOND)?;
        // k is not monotone in α: a box of states is answered at a point alone
        if alpha.width() > 1e-9 * alpha.midpoint() {
            return Err(NoImpulse::Undecided { law: process.id(), regime: "over the uncertainty" });
        }
        let nu = Interval::from_rational(&self.poisson_ratio).midpoint();
        let e = contact.restitution().midpoint();
        let found = process.answer(alpha.midpoint(), nu, e).ok_or(BEYOND)?;
        let k = Interval::between(found.k - found.error, found.k + found.error);
        let slip = k * contact.slip();
        let tangential = (slip - contact.slip()) / contact.delassus().tt();
        let mut outcome = with_impulse("compliant", contact, Impulse { tangential, normal });
        outcome.slip = slip;
        Ok(outcome)
    }
}

impl<N: Coordinate> Resolver<N> for Elastic<'_> {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        let found = self.enclose(&contact.map(Coordinate::enclosed))?;
        let lost = || NoImpulse::Unrepresentable { law: "elastic contact", regime: found.regime };
        let of = |x: &Interval| N::of_enclosure(*x).ok_or_else(lost);
        Ok(Outcome {
            regime: found.regime,
            impulse: Impulse {
                tangential: of(&found.impulse.tangential)?,
                normal: of(&found.impulse.normal)?,
            },
            slip: of(&found.slip)?,
            separation: of(&found.separation)?,
            work: Work { normal: of(&found.work.normal)?, tangential: of(&found.work.tangential)? },
        })
    }
}
