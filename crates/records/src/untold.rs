//! What a log cannot tell, whatever it was made by.

use crate::friction::{FrictionFit, FrictionLaw};
use crate::restitution::Factor;
use crate::seen::Seen;
use crate::told::Told;
use crate::tolerance::Precision;

/// Something that the rows leave open.
#[derive(Clone, Debug, PartialEq)]
pub enum Untold {
    /// No row couples: on round bodies Routh, Keller, Stronge and Kane–Levinson are one law.
    Round,
    /// e does not vary where the impacts slide: μ/(1 + e) is only another μ, this one.
    ConstantRestitution(f64),
    /// No row slides on: μ has a lower bound alone.
    NothingSlides,
    /// Every row slides on: nothing is said of what happens where slip stops.
    NothingSticks,
    /// This does not vary, so that nothing is said of what depends on it.
    Same(Factor),
    /// These laws of friction give the same impulses here.
    SameFriction(Vec<FrictionLaw>),
    /// μ or e is not stated, so that no law can be asked with it.
    NoCoefficients,
    /// The numbers may have been rounded as they seem to be, and may be of a stricter format.
    Format(Told),
}

/// What these rows leave open.
#[must_use]
pub fn untold(rows: &[Seen], friction: &[FrictionFit], precision: &Precision) -> Vec<Untold> {
    let mut open = Vec::new();
    if precision.told.or.is_some() {
        open.push(Untold::Format(precision.told));
    }
    if rows.is_empty() {
        return open;
    }
    if !rows.iter().any(Seen::couples) {
        open.push(Untold::Round);
    }
    let sliding: Vec<&Seen> = rows.iter().filter(|seen| seen.slips_after()).collect();
    if sliding.is_empty() {
        open.push(Untold::NothingSlides);
    } else if sliding.len() == rows.len() {
        open.push(Untold::NothingSticks);
    }
    if let Some(mu) = another_friction(&sliding) {
        open.push(Untold::ConstantRestitution(mu));
    }
    for (factor, of) in [
        (Factor::Speed, (|seen| Some(seen.approach)) as fn(&Seen) -> Option<f64>),
        (Factor::Stated, |seen| seen.given.restitution),
        (Factor::Phase, |seen| seen.given.phase),
        (Factor::Step, |seen| seen.given.dt),
    ] {
        let mut values = rows.iter().map(of);
        let first = values.next().flatten();
        let close = |a: f64, b: f64| (a - b).abs() <= 1e-6 * b.abs();
        if values.all(|value| match (value, first) {
            (Some(value), Some(first)) => close(value, first),
            (None, None) => true,
            _ => false,
        }) {
            open.push(Untold::Same(factor));
        }
    }
    if rows.iter().all(|seen| seen.given.friction.is_none() || seen.given.restitution.is_none()) {
        open.push(Untold::NoCoefficients);
    }
    if let Some(first) = friction.first() {
        let same: Vec<FrictionLaw> = friction
            .iter()
            .map(|fit| fit.law)
            .filter(|law| *law == first.law || same(*law, first.law, rows))
            .collect();
        if same.len() > 1 {
            open.push(Untold::SameFriction(same));
        }
    }
    open
}

/// The μ' that would do as well, where the bound is not μ·p_n but e is constant and every row that slides on has
/// the same share of p_n.
fn another_friction(sliding: &[&Seen]) -> Option<f64> {
    let first = sliding.first()?;
    let constant = sliding.iter().all(|seen| {
        let e = |seen: &Seen| seen.observed_restitution().unwrap_or(0.0);
        (e(seen) - e(first)).abs() <= 1e-3 && seen.given.friction == first.given.friction
    });
    let of = |seen: &Seen| seen.tangential.abs() / seen.normal;
    let ratio = of(first);
    let one = sliding.iter().all(|seen| (of(seen) - ratio).abs() <= 1e-2 * ratio);
    let stated = first.given.friction?;
    (constant && one && (ratio - stated).abs() > 1e-3 * stated).then_some(ratio)
}

/// Whether two laws give the same impulses within the tolerance of every row.
fn same(a: FrictionLaw, b: FrictionLaw, rows: &[Seen]) -> bool {
    rows.iter().all(|seen| match (a.impulse(seen), b.impulse(seen)) {
        (Some(a), Some(b)) => {
            seen.mobility[0] * (a - b).abs() <= seen.within[0] + seen.mobility[0] * seen.within[2]
        }
        _ => false,
    })
}
