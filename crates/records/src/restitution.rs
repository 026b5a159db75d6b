//! What restitution the impacts have, and on what it depends.

use crate::seen::Seen;
use crate::statistics::{Spread, classes, median, within_groups};

/// A quantity on which restitution may depend.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Factor {
    /// e as stated
    Stated,
    /// a, the speed of approach
    Speed,
    /// |u_t|, the slip before
    Slip,
    /// the phase within the step
    Phase,
    /// the time step
    Step,
}

impl Factor {
    const ALL: [Self; 5] = [Self::Stated, Self::Speed, Self::Slip, Self::Phase, Self::Step];

    fn of(self, seen: &Seen) -> Option<f64> {
        match self {
            Self::Stated => seen.given.restitution,
            Self::Speed => Some(seen.approach),
            Self::Slip => Some(seen.slip.abs()),
            Self::Phase => seen.given.phase,
            Self::Step => seen.given.dt,
        }
    }

    /// Its name for programs.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Stated => "stated",
            Self::Speed => "speed",
            Self::Slip => "slip",
            Self::Phase => "phase",
            Self::Step => "step",
        }
    }
}

/// A value of a factor at which restitution changes from what is stated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// of what
    pub factor: Factor,
    /// between these two values
    pub between: (f64, f64),
    /// whether e is not as stated below it, or above
    pub misses_below: bool,
    /// the median e where it is not as stated
    pub instead: f64,
}

/// The restitution of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NormalLaw {
    /// e is as stated within every row's tolerance.
    Stated,
    /// e is as stated to 0.01 in all but one row of a hundred.
    Close,
    /// As stated on one side of a threshold.
    Threshold(Threshold),
    /// One e, to 0.01, whatever is stated.
    Constant,
    /// None of these; see what it depends on.
    Depends,
    /// Nothing is stated: what is measured is all that can be said.
    Unstated,
}

impl NormalLaw {
    /// Its name for programs.
    #[must_use]
    pub const fn id(&self) -> &'static str {
        match self {
            Self::Stated => "stated",
            Self::Close => "close",
            Self::Threshold(_) => "threshold",
            Self::Constant => "constant",
            Self::Depends => "depends",
            Self::Unstated => "unstated",
        }
    }
}

/// What was found about restitution.
#[derive(Clone, Debug, PartialEq)]
pub struct Restitution {
    /// what it follows
    pub law: NormalLaw,
    /// rows with an approach
    pub rows: usize,
    /// rows with a stated e
    pub stated: usize,
    /// of these, within tolerance
    pub consistent: usize,
    /// of these, within 0.01
    pub close: usize,
    /// the least, the median and the greatest e
    pub observed: [f64; 3],
    /// Σ(u_n⁺ − e·a)/Σa over the rows with a stated e: by how much e is off on the whole; zero without one
    pub offset: f64,
    /// the greatest miss, and its line
    pub worst: (f64, u64),
    /// on what e depends: the share of its variance that this alone or with others explains
    pub depends: Vec<(Factor, f64)>,
    /// rows with e > 1
    pub above_one: usize,
}

/// A miss of e that is called close.
const CLOSE: f64 = 0.01;
/// A share of the variance that is worth telling.
const TELLING: f64 = 0.02;

/// Looks at the restitution of these rows; `None` without a row.
#[must_use]
pub fn restitution(rows: &[Seen]) -> Option<Restitution> {
    let measured: Vec<(&Seen, f64)> =
        rows.iter().filter_map(|seen| Some((seen, seen.observed_restitution()?))).collect();
    let values: Vec<f64> = measured.iter().map(|(_, e)| *e).collect();
    let middle = median(values.clone())?;
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);

    let mut spread = Spread::default();
    let (mut consistent, mut close) = (0, 0);
    let mut hits: Vec<(&Seen, bool)> = Vec::new();
    let mut above_one = 0;
    let (mut left, mut approach) = (0.0, 0.0);
    for (seen, e) in &measured {
        let allowed = seen.within[1] / seen.approach;
        above_one += usize::from(*e > 1.0 + 2.0 * allowed);
        let Some(stated) = seen.given.restitution else { continue };
        left += seen.separation - stated * seen.approach;
        approach += seen.approach;
        let miss = (e - stated).abs();
        spread.add(miss, seen.line);
        let holds = miss <= (1.0 + stated) * allowed;
        consistent += usize::from(holds);
        close += usize::from(holds || miss <= CLOSE);
        hits.push((seen, holds || miss <= CLOSE));
    }
    let stated = spread.count();
    let threshold = threshold(&hits);
    let law = if stated == 0 {
        NormalLaw::Unstated
    } else if consistent == stated {
        NormalLaw::Stated
    } else if let Some(threshold) = threshold {
        NormalLaw::Threshold(threshold)
    } else if close * 100 >= stated * 99 {
        NormalLaw::Close
    } else if greatest - least <= 2.0 * CLOSE {
        NormalLaw::Constant
    } else {
        NormalLaw::Depends
    };
    let depends = match law {
        NormalLaw::Depends | NormalLaw::Unstated => depends(&measured),
        _ => Vec::new(),
    };
    Some(Restitution {
        law,
        rows: measured.len(),
        stated,
        consistent,
        close,
        observed: [least, middle, greatest],
        offset: if approach > 0.0 { left / approach } else { 0.0 },
        worst: spread.worst().unwrap_or((0.0, 0)),
        depends,
        above_one,
    })
}

/// A factor that parts the rows that miss from those that do not.
fn threshold(hits: &[(&Seen, bool)]) -> Option<Threshold> {
    let missed = hits.iter().filter(|(_, hit)| !hit).count();
    if missed < 2 || hits.len() - missed < 2 {
        return None;
    }
    [Factor::Speed, Factor::Step, Factor::Phase, Factor::Slip].into_iter().find_map(|factor| {
        let range = |want: bool| {
            let of = hits.iter().filter(|(_, hit)| *hit == want);
            of.map(|(seen, _)| factor.of(seen))
                .try_fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| {
                    value.map(|value| (low.min(value), high.max(value)))
                })
        };
        let ((miss_low, miss_high), (hit_low, hit_high)) = (range(false)?, range(true)?);
        let (between, misses_below) = if miss_high < hit_low {
            ((miss_high, hit_low), true)
        } else if hit_high < miss_low {
            ((hit_high, miss_low), false)
        } else {
            return None;
        };
        let of = hits.iter().filter(|(_, hit)| !hit);
        let instead = median(of.filter_map(|(seen, _)| seen.observed_restitution()).collect())?;
        Some(Threshold { factor, between, misses_below, instead })
    })
}

/// Shares of the variance of e. Where the log is a sweep, so that rows differ in one factor alone,
/// the share is the total effect of that factor (Sobol): the mean variance that is left if all
/// others are held. Elsewhere it is what the factor explains by itself.
fn depends(measured: &[(&Seen, f64)]) -> Vec<(Factor, f64)> {
    let values: Vec<f64> = measured.iter().map(|(_, e)| *e).collect();
    let one = vec![Vec::new(); values.len()];
    let (all, _) = within_groups(&values, &one);
    if all <= 0.0 {
        return Vec::new();
    }
    let known: Vec<(Factor, Vec<usize>)> = Factor::ALL
        .into_iter()
        .filter_map(|factor| {
            let of: Option<Vec<f64>> = measured.iter().map(|(seen, _)| factor.of(seen)).collect();
            let classes = classes(&of?);
            let varies = classes.iter().any(|class| *class != classes[0]);
            varies.then_some((factor, classes))
        })
        .collect();
    let mut shares: Vec<(Factor, f64)> = known
        .iter()
        .map(|(factor, classes)| {
            let others: Vec<&Vec<usize>> =
                known.iter().filter(|(other, _)| other != factor).map(|(_, c)| c).collect();
            let groups: Vec<Vec<usize>> =
                (0..values.len()).map(|i| others.iter().map(|c| c[i]).collect()).collect();
            let (held, grouped) = within_groups(&values, &groups);
            let share = if grouped * 2 > values.len() {
                held / all
            } else {
                let groups: Vec<Vec<usize>> = classes.iter().map(|c| vec![*c]).collect();
                1.0 - within_groups(&values, &groups).0 / all
            };
            (*factor, share)
        })
        .filter(|(_, share)| *share >= TELLING)
        .collect();
    shares.sort_by(|a, b| b.1.total_cmp(&a.1));
    shares
}
