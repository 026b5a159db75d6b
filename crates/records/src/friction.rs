//! Which law of friction the impacts follow, given the normal impulse that was measured.

use std::cmp::Ordering;

use crate::seen::Seen;
use crate::statistics::{Spread, median};

/// A law of friction that takes the normal impulse as given. With s = u_t + W_tn·p_n, the slip that
/// there would be without friction:
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrictionLaw {
    /// p_t = 0.
    None,
    /// p_t = −s/W_tt as far as |p_t| ≤ μ·p_n: Coulomb's, which stops the slip.
    Coulomb,
    /// The same with the bound μ·p_n/(1 + e): that of an impulse before its restitution.
    Compression,
    /// The same with the bound c·μ·p_n.
    Share(f64),
    /// p_t = −(s + β0·u_t)/W_tt as far as |p_t| ≤ μ·p_n: Walton's.
    Walton(f64),
    /// p_t = −μ·p_n·(v|v| + v⁺|v⁺|)/(v² + v⁺²): Smith's.
    Smith,
    /// p_t = −μ·p_n·(1 + k)/2: Wang, Su and Li's.
    WangSuLi,
    /// p_t = −μ·p_n·sgn(u_t), even where that reverses the slip.
    Uncapped,
}

/// A pyramid in place of the cone of friction, with its edges by two axes of the surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pyramid {
    /// Each axis is bounded by μ·p_n alone: along the diagonal friction reaches √2·μ·p_n.
    Outer,
    /// |p_1| + |p_2| ≤ μ·p_n: along the diagonal friction ends at μ·p_n/√2.
    Inner,
}

/// By how much a fitted share may miss that of a pyramid.
const OF_PYRAMID: f64 = 1e-3;

/// How well a law of friction does.
#[derive(Clone, Debug, PartialEq)]
pub struct FrictionFit {
    /// which
    pub law: FrictionLaw,
    /// rows on which it was asked
    pub rows: usize,
    /// rows within their tolerance
    pub consistent: usize,
    /// these, and rows whose k it misses by at most [`CLOSE`]
    pub close: usize,
    /// these, and rows whose k it misses by at most [`ROUGH`]
    pub rough: usize,
    /// the greatest miss of k
    pub worst: f64,
    /// the median miss of k
    pub median: f64,
    /// the row of the greatest miss
    pub worst_line: u64,
    /// whether it is not told from the [first](ranked)
    pub tied: bool,
}

/// A miss of k that is called close: what the eye cannot tell in a chart of k over α.
pub const CLOSE: f64 = 0.01;
/// A miss of k that is called rough: what the measured points of experiments are uncertain by.
pub const ROUGH: f64 = 0.05;

impl FrictionLaw {
    /// Its name.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Coulomb => "coulomb",
            Self::Compression => "compression",
            Self::Share(_) => "share",
            Self::Walton(_) => "walton",
            Self::Smith => "smith",
            Self::WangSuLi => "wang-su-li",
            Self::Uncapped => "uncapped",
        }
    }

    /// The pyramid that has this bound along its diagonal. Along its axes a pyramid is the cone, and
    /// between them friction leaves the plane of the slip, so that no row of a log is there.
    #[must_use]
    pub fn pyramid(self) -> Option<Pyramid> {
        use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};
        let Self::Share(share) = self else { return None };
        let near = |of: f64| (share / of - 1.0).abs() <= OF_PYRAMID;
        match () {
            () if near(SQRT_2) => Some(Pyramid::Outer),
            () if near(FRAC_1_SQRT_2) => Some(Pyramid::Inner),
            () => None,
        }
    }

    /// Its own parameter.
    #[must_use]
    pub const fn parameter(self) -> Option<f64> {
        match self {
            Self::Share(value) | Self::Walton(value) => Some(value),
            _ => None,
        }
    }

    /// p_t, or `None` where the row lacks what the law asks for.
    ///
    /// In floats; the two laws with an equation of their own solve it in closed form.
    #[must_use]
    pub fn impulse(self, seen: &Seen) -> Option<f64> {
        let push = seen.normal.max(0.0);
        let bound = || seen.given.friction.map(|mu| mu * push);
        let e = || seen.given.restitution.or_else(|| seen.observed_restitution());
        let stop = seen.stopping();
        Some(match self {
            Self::None => 0.0,
            Self::Coulomb => within(stop, bound()?),
            Self::Compression => within(stop, bound()? / (1.0 + e()?.max(0.0))),
            Self::Share(share) => within(stop, share * bound()?),
            Self::Walton(beta) => within(stop - beta * seen.slip / seen.mobility[0], bound()?),
            Self::Smith => smith(seen, bound()?),
            Self::WangSuLi => {
                // p = −(b/2)·(1 + (s + W·p)/u), linear in p
                let (b, w) = (bound()? / 2.0, seen.mobility[0]);
                if seen.slip == 0.0 {
                    stop
                } else {
                    let u = seen.slip.abs();
                    let s = seen.slip_without_friction() * seen.slip.signum();
                    -seen.slip.signum() * b * (u + s) / (u + b * w)
                }
            }
            Self::Uncapped => -sign(seen.slip) * bound()?,
        })
    }

    /// How far the law misses k, and whether it is within the row's tolerance: with gravity before the impact or
    /// after it, whichever is nearer.
    #[must_use]
    pub fn miss(self, seen: &Seen) -> Option<(f64, bool)> {
        let (miss, holds) = self.miss_of(seen)?;
        let later = seen.before_gravity().and_then(|seen| self.miss_of(&seen));
        Some(later.map_or((miss, holds), |(other, within)| (miss.min(other), holds || within)))
    }

    fn miss_of(self, seen: &Seen) -> Option<(f64, bool)> {
        let expected = self.impulse(seen)?;
        let missed = (seen.tangential - expected).abs();
        let slip = seen.mobility[0] * missed;
        let mu = seen.given.friction.unwrap_or(0.0);
        let bound = seen.within[2] + mu * seen.within[3];
        // what is uncertain of the slip is uncertain of the friction that stops it
        let allowed = seen.within[0] + seen.mobility[0] * bound;
        Some((slip / scale(seen), slip <= allowed))
    }
}

/// The slip by which a miss is called large or small.
fn scale(seen: &Seen) -> f64 {
    let slip = seen.slip.abs().max(seen.slip_without_friction().abs());
    slip.max(seen.within[0]).max(f64::MIN_POSITIVE)
}

fn within(impulse: f64, bound: f64) -> f64 {
    impulse.clamp(-bound, bound)
}

/// −1, 0 or 1.
pub(crate) fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}

/// Smith's mean of the directions of slip, by bisection on v⁺: the left side p_t(v⁺) falls in v⁺ and
/// v⁺ = s + W·p rises in p, so that there is one solution.
fn smith(seen: &Seen, bound: f64) -> f64 {
    let (v, s, w) = (seen.slip, seen.slip_without_friction(), seen.mobility[0]);
    let friction = |after: f64| {
        let squares = v * v + after * after;
        if squares == 0.0 { 0.0 } else { -bound * (v * v.abs() + after * after.abs()) / squares }
    };
    let (mut low, mut high) = (s - w * bound, s + w * bound);
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            break;
        }
        if s + w * friction(middle) > middle { low = middle } else { high = middle }
    }
    friction(f64::midpoint(low, high))
}

/// The laws asked about these rows, with their parameters fitted, best first.
///
/// A law that gives every row comes before one that comes close to nine rows in ten, and that before
/// one that comes roughly near to as many; among equals the one with the most rows. A parameter of
/// its own that was fitted costs a law a tenth of its rows.
///
/// A law is [tied](FrictionFit::tied) with the first if both give every row; or if none does, and the rows to which
/// the first alone comes close are more than those to which it alone does by at most twice the root of the sum of
/// both counts: a sign test, and heuristic, since rows are not drawn by lot.
#[must_use]
pub fn ranked(rows: &[Seen]) -> Vec<FrictionFit> {
    let mut laws = vec![
        FrictionLaw::Coulomb,
        FrictionLaw::Compression,
        FrictionLaw::None,
        FrictionLaw::Smith,
        FrictionLaw::WangSuLi,
        FrictionLaw::Uncapped,
    ];
    laws.extend(share(rows).map(FrictionLaw::Share));
    let mut fits: Vec<FrictionFit> =
        laws.into_iter().filter_map(|law| FrictionFit::of(law, rows)).collect();
    fits.extend(walton(rows));
    fits.sort_by(FrictionFit::order);
    if let Some((first, others)) = fits.split_first_mut() {
        first.tied = true;
        for other in others {
            other.tied = other.is_tied(first, rows);
        }
    }
    fits
}

/// Walton's law with the β0 that does best: of the rows with gravity before the impact, or after it.
fn walton(rows: &[Seen]) -> Option<FrictionFit> {
    let later: Vec<Seen> =
        rows.iter().map(|seen| seen.before_gravity().unwrap_or_else(|| seen.clone())).collect();
    let betas = [rebound(rows), rebound(&later)].into_iter().flatten();
    let fits = betas.filter_map(|beta| FrictionFit::of(FrictionLaw::Walton(beta), rows));
    fits.min_by(FrictionFit::order)
}

impl FrictionFit {
    /// How a law does on these rows; `None` if it can be asked of none.
    #[must_use]
    pub fn of(law: FrictionLaw, rows: &[Seen]) -> Option<Self> {
        let mut spread = Spread::default();
        let (mut consistent, mut close, mut rough) = (0, 0, 0);
        for seen in rows {
            let Some((miss, holds)) = law.miss(seen) else { continue };
            spread.add(miss, seen.line);
            consistent += usize::from(holds);
            close += usize::from(miss <= CLOSE || holds);
            rough += usize::from(miss <= ROUGH || holds);
        }
        let (worst, worst_line) = spread.worst()?;
        let (rows, median) = (spread.count(), spread.median());
        Some(Self { law, rows, consistent, close, rough, worst, median, worst_line, tied: false })
    }

    /// The better one first.
    fn order(&self, other: &Self) -> Ordering {
        // among laws that differ by rounding alone the one that is listed first
        let miss = |fit: &Self| if fit.median < 1e-9 { 0.0 } else { fit.median };
        other.rank().cmp(&self.rank()).then(miss(self).total_cmp(&miss(other)))
    }

    /// Whether the rows do not tell that it does worse than the first.
    fn is_tied(&self, first: &Self, rows: &[Seen]) -> bool {
        let level = first.rank().0;
        if level == 3 {
            return self.rows == first.rows && self.consistent == self.rows;
        }
        let most = if level == 1 { ROUGH } else { CLOSE };
        let near =
            |law: FrictionLaw, seen| law.miss(seen).is_some_and(|(k, holds)| k <= most || holds);
        let (mut more, mut less) = (0_u32, 0_u32);
        for seen in rows {
            match (near(first.law, seen), near(self.law, seen)) {
                (true, false) => more += 1,
                (false, true) => less += 1,
                _ => {}
            }
        }
        let [more, less] = [more, less].map(f64::from);
        more - less <= 2.0 * (more + less).sqrt()
    }

    /// How well it does: the level, and the rows that count there.
    fn rank(&self) -> (u8, usize) {
        let most = |rows: usize| rows * 10 >= self.rows * 9;
        let (level, rows) = match () {
            () if self.consistent == self.rows => (3, self.rows),
            () if most(self.close) => (2, self.close),
            () if most(self.rough) => (1, self.rough),
            () => (0, self.close),
        };
        (level, rows * if self.law.parameter().is_some() { 9 } else { 10 })
    }
}

/// c of the rows that slide on: the median of |p_t|/(μ·p_n), if it is not one.
fn share(rows: &[Seen]) -> Option<f64> {
    let ratios = rows.iter().filter_map(|seen| {
        let bound = seen.given.friction? * seen.normal;
        let slides = seen.slips_after() && seen.tangential * seen.slip_after < 0.0;
        (slides && bound > 0.0).then(|| seen.tangential.abs() / bound)
    });
    let share = median(ratios.collect())?;
    // less is no friction
    (share > 1e-3 && (share - 1.0).abs() > 1e-3).then_some(share)
}

/// β0: the median of −u_t⁺/u_t of the rows whose slip was reversed, moved to what every row allows if there is such
/// a value. On the cone a reversed slip is a lower bound. `None` if nothing tells it from zero.
fn rebound(rows: &[Seen]) -> Option<f64> {
    let mut ratios = Vec::new();
    let (mut low, mut high) = (0.0_f64, f64::INFINITY);
    for seen in rows {
        let bound = seen.given.friction.map_or(f64::INFINITY, |mu| mu * seen.normal);
        let below = seen.tangential.abs() < bound - 2.0 * (seen.within[2] + seen.within[3]);
        let (ratio, within) = (-seen.slip_after / seen.slip, seen.within[0] / seen.slip.abs());
        if !ratio.is_finite() || !within.is_finite() {
            continue;
        }
        low = low.max(ratio - within);
        if below {
            high = high.min(ratio + within);
            if seen.slips_after() && ratio > 0.0 {
                ratios.push(ratio);
            }
        }
    }
    let one_value = 0.0 < low && low <= high;
    let told = median(ratios);
    let beta = match (told, one_value) {
        (Some(told), true) => Some(told.clamp(low, high)),
        (None, true) if high.is_finite() => Some(f64::midpoint(low, high)),
        (None, true) => Some(low),
        (told, false) => told,
    };
    beta.filter(|beta| *beta > 1e-3)
}
