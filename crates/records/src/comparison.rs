//! Two logs, the older and the newer version of an engine, check by check.

use crate::check::Check;
use crate::friction::{FrictionFit, FrictionLaw};
use crate::restitution::NormalLaw;
use crate::study::Study;

/// How a check changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Change {
    /// which
    pub check: Check,
    /// rows that it had something to ask of, before and now
    pub rows: [u64; 2],
    /// the share of rows on which it failed, before and now
    pub failing: [f64; 2],
    /// the share of rows of which it is undecided, before and now
    pub undecided: [f64; 2],
    /// the greatest residual beyond tolerance, by [its scale](crate::check::Finding::size), before and now
    pub worst: [f64; 2],
    /// whether it does worse, or is asked of no row any more
    pub worse: bool,
}

/// What changed between two logs.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// rows that were checked, before and now
    pub rows: [u64; 2],
    /// every check that either log could be asked
    pub changes: Vec<Change>,
    /// the nearest law of friction, before and now
    pub friction: [Option<FrictionLaw>; 2],
    /// whether the law that was nearest before is the nearest now, or is not told from it
    pub friction_kept: bool,
    /// the share of rows that it comes close to
    pub friction_close: [f64; 2],
    /// the restitution, before and now
    pub normal: [Option<NormalLaw>; 2],
    /// the share of rows whose e is as stated, to 0.01
    pub normal_close: [f64; 2],
    /// by how much e is off what is stated on the whole, [`Restitution::offset`](crate::restitution::Restitution::offset),
    /// before and now
    pub normal_offset: [f64; 2],
    /// [where the impulse acted](Study::arm_offset) beside the stated arm, before and now
    pub arm: [Option<f64>; 2],
    /// rows rejected, before and now
    pub rejected: [u64; 2],
}

/// A share of rows, or a share of a residual, by which nothing is called worse: logs of two versions
/// need not hold the same rows.
const SLACK: f64 = 0.01;
/// By how much e or an arm has to be off by another amount to be told.
const MOVED: f64 = 0.002;

impl Comparison {
    /// Whether both logs have a row that was checked, so that something is compared.
    #[must_use]
    pub const fn compares(&self) -> bool {
        self.rows[0] > 0 && self.rows[1] > 0
    }

    /// Whether a check or a law does worse, or rows are rejected that were not.
    #[must_use]
    pub fn is_worse(&self) -> bool {
        self.changes.iter().any(|change| change.worse)
            || self.friction_is_worse()
            || self.normal_is_worse()
            || self.rejected[1] > self.rejected[0]
    }

    /// Whether e is off what is stated by another amount on the whole: nearer or farther, which is for itself nothing
    /// worse.
    #[must_use]
    pub fn normal_moved(&self) -> bool {
        (self.normal_offset[1] - self.normal_offset[0]).abs() > MOVED
    }

    /// Whether the impulse misses the stated arm by another amount.
    #[must_use]
    pub fn arm_moved(&self) -> bool {
        matches!(self.arm, [Some(old), Some(new)] if (new - old).abs() > MOVED)
    }

    /// Whether e is as stated in fewer rows than before.
    #[must_use]
    pub fn normal_is_worse(&self) -> bool {
        self.normal_close[1] < self.normal_close[0] - SLACK
    }

    /// Whether friction follows another law than before, or its own less.
    #[must_use]
    pub fn friction_is_worse(&self) -> bool {
        !self.friction_kept || self.friction_close[1] < self.friction_close[0] - SLACK
    }
}

/// Compares an older log with a newer one.
#[must_use]
pub fn compare(old: &Study, new: &Study) -> Comparison {
    let changes = Check::ALL.into_iter().filter_map(|check| {
        let both = [old.checked(check)?, new.checked(check)?];
        if both.iter().all(|checked| checked.rows == 0) {
            return None;
        }
        let rows = both.map(|checked| checked.rows);
        let failing = both.map(|checked| part(checked.failed, checked.rows));
        let undecided = both.map(|checked| part(checked.undecided, checked.rows));
        let worst = both.map(|checked| match checked.worst {
            Some((_, finding)) if finding.fails() => finding.size(),
            _ => 0.0,
        });
        let more = failing[1] > failing[0] + SLACK || failing[0] == 0.0 && failing[1] > 0.0;
        let farther = worst[1] > worst[0] * (1.0 + SLACK) + 1e-12 && failing[1] > 0.0;
        let silent = rows[1] == 0;
        Some(Change { check, rows, failing, undecided, worst, worse: more || farther || silent })
    });
    let studies = [old, new];
    let friction = studies.map(|study| study.friction.first());
    let id = |fit: &FrictionFit| fit.law.id();
    let tied = |fit: &&FrictionFit| fit.tied;
    let kept = match friction.map(|fit| fit.map(id)) {
        [None, None] => true,
        [Some(old), _] => new.friction.iter().filter(tied).any(|fit| id(fit) == old),
        [None, Some(_)] => false,
    };
    let restitution = studies.map(|study| study.restitution.as_ref());
    Comparison {
        rows: studies.map(|study| study.rows),
        changes: changes.collect(),
        friction: friction.map(|fit| fit.map(|fit| fit.law)),
        friction_kept: kept,
        friction_close: friction.map(|fit| fit.map_or(0.0, |fit| share(fit.close, fit.rows))),
        normal: restitution.map(|found| found.map(|found| found.law)),
        normal_close: restitution
            .map(|found| found.map_or(0.0, |found| share(found.close, found.stated))),
        normal_offset: restitution.map(|found| found.map_or(0.0, |found| found.offset)),
        arm: studies.map(|study| study.arm_offset),
        rejected: studies.map(|study| study.rejections.total()),
    }
}

#[allow(clippy::cast_precision_loss, reason = "shares of rows")]
fn part(rows: u64, all: u64) -> f64 {
    if all == 0 { 0.0 } else { rows as f64 / all as f64 }
}

#[allow(clippy::cast_precision_loss, reason = "shares of rows")]
fn share(part: usize, all: usize) -> f64 {
    if all == 0 { 0.0 } else { part as f64 / all as f64 }
}
