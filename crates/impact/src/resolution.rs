//! The resolution of a contact: the first regime of a law that applies, its root, its impulse, and what follows.
//!
//! It stands once, over a law's [`Regimes`]. In floats these are the law itself, so that the compiler sees through to
//! the formulas; elsewhere, where an operation costs more than a call, they are a table of the law's formulas, so that
//! the code below is there once a number system and not once a law.

use kane_number::{Number, Rational, Real};

use crate::{Alpha, Contact, Facing, Impulse, LawInfo, Outcome, Ratios, Restitution, Work};

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

/// What a resolution asks of a law, by the places of its regimes, at contacts that face forwards.
pub(crate) trait Regimes<N> {
    fn info(&self) -> &'static LawInfo;
    fn normal_collision(&self) -> Option<Rational>;
    fn has_frame(&self, contact: &Contact<N>) -> bool;
    fn acceptance(&self, contact: &Contact<N>, impulse: &Impulse<N>) -> Option<N>;
    fn count(&self) -> usize;
    fn name(&self, place: usize) -> &'static str;
    /// Whether all guards hold, or `None` if that is undecided.
    fn applies(&self, place: usize, contact: &Contact<N>) -> Option<bool>;
    /// The root of a regime that has one: `Some(None)` if it is no number of this system or cannot be told.
    fn root(&self, place: usize, contact: &Contact<N>) -> Option<Option<N>>;
    fn impulse(&self, place: usize, contact: &Contact<N>, root: &N) -> Impulse<N>;
    fn slip(&self, place: usize, contact: &Contact<N>, root: &N) -> Option<N>;
    fn work(&self, place: usize, contact: &Contact<N>, root: &N) -> Option<N>;
}

/// What a function makes of the first regime that applies, and its root, at a contact that faces forwards.
///
/// At a place that is a constant the compiler sees the formulas of the regime and what they share, which is worth its
/// length where these are a few instructions; a function that took `then` as a value would hide them.
macro_rules! taken {
    ($number:ty, $law:ident, $contact:ident, $then:path) => {
        taken!($number, $law, $contact, $then, first 3: 0, 1, 2)
    };
    ($number:ty, $law:ident, $contact:ident, $then:path, first $count:literal: $($place:expr),*) => {
        'taken: {
            if <$number>::IS_FLOAT {
                $(taken!($law, $contact, $then, $place, 'taken);)*
            }
            for place in if <$number>::IS_FLOAT { $count } else { 0 }..$law.count() {
                taken!($law, $contact, $then, place, 'taken);
            }
            Err(outside($law.info()))
        }
    };
    ($law:ident, $contact:ident, $then:path, $place:expr, $taken:lifetime) => {
        if let Some(root) = at($law, $place, &$contact) {
            break $taken match root {
                Ok(root) => $then($law, $place, &$contact, root),
                Err(none) => Err(none),
            };
        }
    };
}

/// The regime that a law takes, and what its formulas are given.
pub(crate) struct Settled<N> {
    pub(crate) place: usize,
    /// which way the contact faced
    pub(crate) facing: Facing,
    /// the contact, turned to face forwards
    pub(crate) contact: Contact<N>,
    /// the root, if the regime has one
    pub(crate) root: Option<N>,
}

/// The first regime that applies, and its root.
///
/// # Errors
/// [`NoImpulse`] if no regime applies, or none can be chosen in this number system.
#[inline]
pub(crate) fn settled<F: Regimes<N> + ?Sized, N: Real>(
    law: &F,
    contact: &Contact<N>,
) -> Result<Settled<N>, NoImpulse> {
    let (facing, contact) = forwards(law, contact.clone())?;
    let (place, root) = taken!(N, law, contact, itself)?;
    Ok(Settled { place, facing, contact, root })
}

/// The place of the first regime whose guards all hold for certain.
pub(crate) fn place<N: Real>(law: &dyn Regimes<N>, contact: &Contact<N>) -> Option<usize> {
    (0..law.count()).find(|place| law.applies(*place, contact) == Some(true))
}

/// The impulse of the first regime that applies.
///
/// # Errors
/// As [`settled`], and where the law does not accept it.
#[inline(always)]
pub(crate) fn impulse<F: Regimes<N::Working> + ?Sized, N: Real>(
    law: &F,
    contact: &Contact<N>,
) -> Result<Impulse<N>, NoImpulse> {
    let (facing, contact) = forwards(law, contact.map(N::to_working))?;
    let impulse = taken!(N::Working, law, contact, accepted_impulse)?;
    let impulse = match facing {
        Facing::Forward => impulse,
        Facing::Backward => impulse.mirrored(),
    };
    Ok(impulse.map(N::from_working))
}

/// The outcome, and the root of its regime if that has one.
///
/// # Errors
/// As [`impulse`].
#[inline(always)]
pub(crate) fn resolved<F: Regimes<N::Working> + ?Sized, N: Real>(
    law: &F,
    contact: &Contact<N>,
) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
    let (outcome, root) = working(law, contact.map(N::to_working))?;
    Ok((outcome.map(N::from_working), root.as_ref().map(N::from_working)))
}

/// The law in terms of α, see [`ImpactLaw::ratios`].
#[inline(always)]
pub(crate) fn ratios<F: Regimes<N::Working> + ?Sized, N: Real>(
    law: &F,
    alpha: &Alpha<N>,
) -> Option<Ratios<N>> {
    let alpha = match alpha {
        Alpha::Finite(alpha) => alpha,
        Alpha::Infinite => {
            let k = N::from_rational(&law.normal_collision()?);
            return Some(Ratios { k, impulse: N::zero(), energy: N::zero() });
        }
    };
    let contact = Contact::of_alpha(alpha.to_working());
    if law.has_frame(&contact) {
        return None;
    }
    let (outcome, _) = working(law, contact).ok()?;
    // v_t = 1/2 and μ·p_n = 1
    let ratios = Ratios {
        k: outcome.slip.double(),
        impulse: -outcome.impulse.tangential,
        energy: outcome.work.tangential.double(),
    };
    Some(ratios.map(N::from_working))
}

/// The outcome in the working system, and the root of its regime if that has one.
#[inline(always)]
fn working<F: Regimes<N> + ?Sized, N: Real>(
    law: &F,
    contact: Contact<N>,
) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
    let (facing, contact) = forwards(law, contact)?;
    let (outcome, root) = taken!(N, law, contact, accepted_outcome)?;
    Ok(match facing {
        Facing::Forward => (outcome, root),
        Facing::Backward => (outcome.mirrored(), root),
    })
}

/// The contact turned to face forwards, and how it faced.
#[inline]
fn forwards<F: Regimes<N> + ?Sized, N: Real>(
    law: &F,
    contact: Contact<N>,
) -> Result<(Facing, Contact<N>), NoImpulse> {
    match contact.facing() {
        Some(Facing::Forward) => Ok((Facing::Forward, contact)),
        Some(Facing::Backward) => Ok((Facing::Backward, contact.mirrored())),
        None => {
            Err(NoImpulse::Undecided { law: law.info().id, regime: "forward or backward slip" })
        }
    }
}

/// The root of the regime at a place, if it has one; `None` if there is no such regime or it does not apply.
#[inline(always)]
fn at<F: Regimes<N> + ?Sized, N: Real>(
    law: &F,
    place: usize,
    contact: &Contact<N>,
) -> Option<Result<Option<N>, NoImpulse>> {
    if place >= law.count() {
        return None;
    }
    let here = || (law.info().id, law.name(place));
    match law.applies(place, contact) {
        Some(true) => {}
        Some(false) => return None,
        None => {
            let (law, regime) = here();
            return Some(Err(NoImpulse::Undecided { law, regime }));
        }
    }
    Some(match law.root(place, contact) {
        None => Ok(None),
        Some(Some(root)) => Ok(Some(root)),
        Some(None) => {
            let (law, regime) = here();
            Err(NoImpulse::Unrepresentable { law, regime })
        }
    })
}

/// The place of a regime, and its root.
#[inline(always)]
fn itself<F: Regimes<N> + ?Sized, N: Real>(
    _: &F,
    place: usize,
    _: &Contact<N>,
    root: Option<N>,
) -> Result<(usize, Option<N>), NoImpulse> {
    Ok((place, root))
}

/// The impulse of a regime, if the law accepts it.
#[inline(always)]
fn accepted_impulse<F: Regimes<N> + ?Sized, N: Real>(
    law: &F,
    place: usize,
    contact: &Contact<N>,
    root: Option<N>,
) -> Result<Impulse<N>, NoImpulse> {
    let impulse = law.impulse(place, contact, &root.unwrap_or_else(N::zero));
    accept(law, place, contact, &impulse)?;
    Ok(impulse)
}

/// The outcome of a regime, if the law accepts its impulse, and the root if there is one.
#[inline(always)]
fn accepted_outcome<F: Regimes<N> + ?Sized, N: Real>(
    law: &F,
    place: usize,
    contact: &Contact<N>,
    root: Option<N>,
) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
    let none = N::zero();
    let given = root.as_ref().unwrap_or(&none);
    let impulse = law.impulse(place, contact, given);
    accept(law, place, contact, &impulse)?;
    let (slip, work) = (law.slip(place, contact, given), law.work(place, contact, given));
    let frame = law.has_frame(contact);
    let outcome = following(law.info(), law.name(place), contact, impulse, (slip, work), frame);
    Ok((outcome, root))
}

/// What follows from an impulse at a contact that faces forwards; slip and work may be told by the regime.
#[inline(never)]
pub(crate) fn outcome<N: Number>(
    info: &LawInfo,
    regime: &'static str,
    contact: &Contact<N>,
    impulse: Impulse<N>,
    told: (Option<N>, Option<N>),
    has_frame: bool,
) -> Outcome<N> {
    following(info, regime, contact, impulse, told, has_frame)
}

#[inline(always)]
fn following<N: Number>(
    info: &LawInfo,
    regime: &'static str,
    contact: &Contact<N>,
    impulse: Impulse<N>,
    (slip, work): (Option<N>, Option<N>),
    has_frame: bool,
) -> Outcome<N> {
    let half = |x: N| x / N::one().double();
    let slip = slip.unwrap_or_else(|| contact.slip_after(&impulse));
    let tangential =
        work.unwrap_or_else(|| half((slip.clone() + contact.slip()) * &impulse.tangential));
    let (separation, normal) = match info.restitution {
        Restitution::Newton if !has_frame => {
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
    Outcome { regime, impulse, slip, separation, work: Work { normal, tangential } }
}

fn outside(info: &LawInfo) -> NoImpulse {
    let reason = info.gap.unwrap_or("no regime applies, which is a defect of the law");
    NoImpulse::Outside { law: info.id, reason }
}

#[inline]
fn accept<F: Regimes<N> + ?Sized, N: Real>(
    law: &F,
    place: usize,
    contact: &Contact<N>,
    impulse: &Impulse<N>,
) -> Result<(), NoImpulse> {
    let Some(quantity) = law.acceptance(contact, impulse) else { return Ok(()) };
    match quantity.sign().is_at_least() {
        Some(true) => Ok(()),
        Some(false) => Err(match law.info().rejects {
            Some(reason) => NoImpulse::Outside { law: law.info().id, reason },
            None => outside(law.info()),
        }),
        None => Err(NoImpulse::Undecided { law: law.info().id, regime: law.name(place) }),
    }
}

/// The same over a table of a law's formulas: one copy of each a number system.
pub(crate) mod tabled {
    use super::*;

    #[inline(never)]
    pub(crate) fn settled<N: Real>(
        law: &dyn Regimes<N>,
        contact: &Contact<N>,
    ) -> Result<Settled<N>, NoImpulse> {
        super::settled(law, contact)
    }

    #[inline(never)]
    pub(crate) fn impulse<N: Real>(
        law: &dyn Regimes<N::Working>,
        contact: &Contact<N>,
    ) -> Result<Impulse<N>, NoImpulse> {
        super::impulse(law, contact)
    }

    #[inline(never)]
    pub(crate) fn resolved<N: Real>(
        law: &dyn Regimes<N::Working>,
        contact: &Contact<N>,
    ) -> Result<(Outcome<N>, Option<N>), NoImpulse> {
        super::resolved(law, contact)
    }

    #[inline(never)]
    pub(crate) fn ratios<N: Real>(
        law: &dyn Regimes<N::Working>,
        alpha: &Alpha<N>,
    ) -> Option<Ratios<N>> {
        super::ratios(law, alpha)
    }
}
