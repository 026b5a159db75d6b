//! Which rigid law gives these impacts, of the laws that are published.

use kane_impact::{Contact, Delassus, Law, Restitution};
use kane_number::{Interval, Rational, decode};

use crate::seen::Seen;
use crate::statistics::{Spread, median};

/// How well a law does.
#[derive(Clone, Debug)]
pub struct LawFit {
    /// the law, with its parameters as fitted
    pub law: Law,
    /// whether its own parameters were fitted to the log, and not taken as published
    pub fitted: bool,
    /// rows on which it was asked
    pub rows: usize,
    /// rows on which it has no answer
    pub silent: usize,
    /// rows whose velocities afterwards it gives within tolerance
    pub consistent: usize,
    /// the greatest miss of a velocity, by the speed at the contact before
    pub worst: f64,
    /// the median of these
    pub median: f64,
    /// the row of the greatest
    pub worst_line: u64,
}

impl LawFit {
    /// Whether the law gives every row.
    #[must_use]
    pub const fn gives_all(&self) -> bool {
        self.rows > 0 && self.silent == 0 && self.consistent == self.rows
    }

    /// Whether its restitution is Newton's in the frame of the contact.
    #[must_use]
    pub fn is_newton(&self) -> bool {
        self.law.info.restitution == Restitution::Newton && !self.law.has_frame()
    }

    /// `None` if a coefficient is missing in a row, so that the law cannot be asked.
    fn of(law: &Law, fitted: bool, rows: &[Seen]) -> Option<Self> {
        let mut spread = Spread::default();
        let (mut silent, mut consistent) = (0, 0);
        for seen in rows {
            coefficients(seen)?;
            match Miss::of(law, seen) {
                None => silent += 1,
                Some(miss) => {
                    spread.add(miss.size, seen.line);
                    consistent += usize::from(miss.holds);
                }
            }
        }
        let (worst, worst_line) = spread.worst().unwrap_or((f64::INFINITY, 0));
        Some(Self {
            law: law.clone(),
            fitted,
            rows: rows.len(),
            silent,
            consistent,
            worst,
            median: if spread.count() == 0 { f64::INFINITY } else { spread.median() },
            worst_line,
        })
    }
}

/// μ and e, if both are stated.
fn coefficients(seen: &Seen) -> Option<(f64, f64)> {
    seen.given.friction.zip(seen.given.restitution)
}

/// How far a law misses the velocities of a row.
#[derive(Clone, Copy)]
struct Miss {
    /// the greater of the differences of slip and separation, by the speed at the contact
    size: f64,
    /// whether that is within the tolerance of the row
    holds: bool,
}

impl Miss {
    /// About the stated arm or that at which the impulse acted, whichever is nearer; `None` where the law has no answer.
    fn of(law: &Law, seen: &Seen) -> Option<Self> {
        let miss = Self::of_arm(law, seen);
        if miss.is_some_and(|miss| miss.holds) {
            return miss;
        }
        let acted = seen.where_it_acted();
        Self::nearer(miss, acted.and_then(|seen| Self::of_arm(law, &seen)))
    }

    /// With gravity before the impact or after it, and with a coupling that may be rounding or without it, whichever is
    /// nearest.
    fn of_arm(law: &Law, seen: &Seen) -> Option<Self> {
        let miss = Self::of_one(law, seen);
        if miss.is_some_and(|miss| miss.holds) {
            return miss;
        }
        let later = seen.before_gravity().filter(|seen| seen.approach > 0.0);
        Self::nearer(miss, later.and_then(|seen| Self::of_one(law, &seen)))
    }

    fn of_one(law: &Law, seen: &Seen) -> Option<Self> {
        let (friction, restitution) = coefficients(seen)?;
        let miss = Self::of_contact(law, seen, &seen.contact(friction, restitution));
        if miss.is_some_and(|miss| miss.holds) {
            return miss;
        }
        let coupled = seen.coupled(friction, restitution);
        Self::nearer(miss, coupled.and_then(|contact| Self::of_contact(law, seen, &contact)))
    }

    fn nearer(one: Option<Self>, other: Option<Self>) -> Option<Self> {
        match (one, other) {
            (Some(one), Some(other)) => {
                Some(Self { size: one.size.min(other.size), holds: one.holds || other.holds })
            }
            (one, other) => one.or(other),
        }
    }

    fn of_contact(law: &Law, seen: &Seen, contact: &Contact<f64>) -> Option<Self> {
        let impulse = law.over::<f64>().impulse(contact).ok()?;
        let apart = [
            (contact.slip_after(&impulse) - seen.slip_after).abs(),
            (contact.separation_after(&impulse) - seen.separation).abs(),
        ];
        let speed = (seen.slip.abs() + seen.approach).max(f64::MIN_POSITIVE);
        let size = apart[0].max(apart[1]) / speed;
        size.is_finite().then(|| Self { size, holds: holds(law, seen, contact, apart, size) })
    }
}

/// Whether a miss is within the tolerance of its row.
fn holds(law: &Law, seen: &Seen, contact: &Contact<f64>, apart: [f64; 2], size: f64) -> bool {
    // an error of the velocities before, or of W, goes through W·W⁻¹, stretched by the condition
    let [tt, _, nn] = seen.mobility;
    // sliding friction grows with the approach, and so does its error beyond that of the approach
    let rubbed = contact.friction() * (1.0 + contact.restitution()) * tt / nn;
    let allowed = 2.0 * seen.stretch * (seen.within[0] + rubbed.max(1.0) * seen.within[1]);
    let holds = apart[0] <= allowed && apart[1] <= allowed;
    // which way a contact slides that hardly does is not known
    let hardly = contact.slip().abs() <= seen.within[0];
    holds || (size <= ILL || hardly) && encloses(law, seen, contact, allowed)
}

/// Misses beyond which no row is excused as ill conditioned.
const ILL: f64 = 1e-3;

/// Whether the law, run on intervals about the contact, reaches what was measured: a contact that
/// nearly jams, or that nearly changes its regime, makes much of little.
fn encloses(law: &Law, seen: &Seen, contact: &Contact<f64>, allowed: f64) -> bool {
    let about = |value: f64, error: f64| Interval::between(value - error, value + error);
    let w = contact.delassus();
    let relative = seen.arm_within + 1e-15 + seen.within[0] / (seen.slip.abs() + seen.approach);
    let entry = |value: &f64| about(*value, relative * value.abs());
    let wide = Contact::unchecked(
        about(*contact.slip(), seen.within[0]),
        about(*contact.approach(), seen.within[1]),
        Delassus::unchecked(entry(w.tt()), entry(w.tn()), entry(w.nn())),
        entry(contact.friction()),
        about(*contact.restitution(), relative),
    );
    match law.over::<Interval>().impulse(&wide) {
        // the regime cannot be told: a neighbouring one may have been taken
        Err(_) => true,
        Ok(impulse) => {
            let reaches = |found: Interval, measured: f64| {
                found.lower() - allowed <= measured && measured <= found.upper() + allowed
            };
            reaches(wide.slip_after(&impulse), seen.slip_after)
                && reaches(wide.separation_after(&impulse), seen.separation)
        }
    }
}

/// How many rows parameters are fitted on.
const FITTED_ON: usize = 60;

/// The laws, best first: by the rows that they give, then those with published parameters, then by
/// the median miss. Where none gives every row as published, those with parameters of their own are
/// asked with the values that fit best.
#[must_use]
pub fn ranked(laws: &[Law], rows: &[Seen]) -> Vec<LawFit> {
    let published = laws.iter().filter_map(|law| LawFit::of(law, false, rows));
    let mut fits: Vec<LawFit> = published.collect();
    if !fits.iter().any(LawFit::gives_all) {
        let stride = rows.len().div_ceil(FITTED_ON).max(1);
        let few: Vec<&Seen> = rows.iter().step_by(stride).collect();
        for fit in fits.iter_mut().filter(|fit| !fit.law.info.parameters.is_empty()) {
            let better = fitted(&fit.law, &few).and_then(|law| LawFit::of(&law, true, rows));
            let is_better =
                |better: &LawFit| better.consistent > fit.consistent || better.median < fit.median;
            if let Some(better) = better.filter(is_better) {
                *fit = better;
            }
        }
    }
    fits.sort_by(|a, b| {
        let given = b.consistent.cmp(&a.consistent);
        let published = a.fitted.cmp(&b.fitted);
        given.then(published).then(a.silent.cmp(&b.silent)).then(a.median.total_cmp(&b.median))
    });
    fits
}

/// The law with the parameters that miss least, one after the other, twice.
fn fitted(law: &Law, rows: &[&Seen]) -> Option<Law> {
    let mut best = law.clone();
    let rounds = if law.info.parameters.len() > 1 { 3 } else { 1 };
    for _ in 0..rounds {
        for parameter in law.info.parameters {
            let least = f64::from(parameter.least);
            let greatest = parameter.greatest.map_or(2.0, f64::from);
            best = along(&best, parameter.name, (least, greatest), rows)?;
        }
    }
    Some(best)
}

/// A grid, and then ever finer ones about its best point.
fn along(law: &Law, name: &str, (least, greatest): (f64, f64), rows: &[&Seen]) -> Option<Law> {
    const POINTS: u32 = 10;
    let at = |value: f64| law.with(name, &decode(value).ok()?);
    let badness = |value: f64| at(value).map_or(f64::INFINITY, |law| badness(&law, rows));
    let (mut low, mut high) = (least, greatest);
    let mut best = (f64::INFINITY, least);
    for _ in 0..9 {
        let step = (high - low) / f64::from(POINTS);
        for i in 0..=POINTS {
            let value = (low + step * f64::from(i)).clamp(least, greatest);
            let found = badness(value);
            if found < best.0 {
                best = (found, value);
            }
        }
        (low, high) = ((best.1 - 2.0 * step).max(least), (best.1 + 2.0 * step).min(greatest));
    }
    at(best.1)
}

/// The median miss, and a little of the mean so that it has a slope where half of the rows fit.
fn badness(law: &Law, rows: &[&Seen]) -> f64 {
    let of = |seen: &&Seen| Miss::of(law, seen).map_or(1.0, |miss| miss.size.min(1.0));
    let misses: Vec<f64> = rows.iter().map(of).collect();
    #[allow(clippy::cast_precision_loss, reason = "a count of rows in memory")]
    let count = misses.len().max(1) as f64;
    let mean = misses.iter().sum::<f64>() / count;
    median(misses).unwrap_or(1.0) + mean
}

/// A law's own parameters, as numbers.
#[must_use]
pub fn parameters(law: &Law) -> Vec<(&'static str, f64)> {
    let float = |value: &Rational| kane_number::encode(value, kane_number::Rounding::NearestEven);
    law.parameters().iter().map(|(name, value)| (*name, float(value))).collect()
}
