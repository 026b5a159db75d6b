//! What adds up over the rows of a log, in any order and from any parts.

use kane_number::ExactSum;

use crate::case::Case;
use crate::check::{Check, Finding, Verdict};

/// How a check fared on all rows.
#[derive(Clone, Debug)]
pub struct Checked {
    /// which
    pub check: Check,
    /// rows that it had something to ask of
    pub rows: u64,
    /// rows on which it fails
    pub failed: u64,
    /// rows of which the log does not tell whether it holds, because it does not tell the format of its numbers
    pub undecided: u64,
    /// rows whose verdict is within a factor of two of the tolerance
    pub near: u64,
    /// the line of the greatest size of a residual beyond tolerance, or else of the greatest share of
    /// the tolerance; a line of 0 is not known
    pub worst: Option<(u64, Finding)>,
    /// a published law that gives every row, so that the check fails as that law has it
    pub excused: Option<&'static str>,
}

impl Checked {
    /// Of no row.
    #[must_use]
    pub const fn none(check: Check) -> Self {
        Self { check, rows: 0, failed: 0, undecided: 0, near: 0, worst: None, excused: None }
    }

    /// Whether it is as it should be: it holds in every row, or a law says that it does not.
    #[must_use]
    pub const fn as_expected(&self) -> bool {
        self.failed == 0 && self.undecided == 0 || self.excused.is_some()
    }

    /// Adds what it says of a row.
    #[inline(always)]
    fn take(
        &mut self,
        case: &Case<'_>,
        most: &mut Option<(Check, Finding)>,
        finding: Option<Finding>,
    ) {
        let Some(finding) = finding else { return };
        self.rows += 1;
        if self.is_exceeded(case.row.line, &finding) {
            self.keep(case.row.line, most, finding);
        }
    }

    /// Counts and keeps what is more than another row that holds; `most` is what fails most of the row.
    #[inline(never)]
    fn keep(&mut self, line: u64, most: &mut Option<(Check, Finding)>, finding: Finding) {
        match finding.verdict {
            Verdict::Holds => {}
            Verdict::Undecided => self.undecided += 1,
            Verdict::Fails => self.failed += 1,
        }
        self.near += u64::from(finding.is_near());
        self.offer(line, finding);
        let greater = |most: &Finding| finding.size() > most.size();
        if finding.fails() && most.as_ref().is_none_or(|(_, most)| greater(most)) {
            *most = Some((self.check, finding));
        }
    }

    /// Whether this is more than another row that holds, far from the tolerance and not as near to it as the worst.
    #[inline(always)]
    fn is_exceeded(&self, line: u64, finding: &Finding) -> bool {
        let Some((other, worst)) = &self.worst else { return true };
        let shares = [finding.residual * worst.tolerance, worst.residual * finding.tolerance];
        // where lines are not known, most rows are as near as the worst, to which nothing is left
        let equal = || shares[0] == shares[1] && !worse(&(line, *finding), &(*other, *worst));
        let less = shares[0] < shares[1] || equal();
        let far = finding.verdict == Verdict::Holds && !finding.is_near();
        !(far && (less || worst.verdict != Verdict::Holds))
    }

    fn offer(&mut self, line: u64, finding: Finding) {
        let here = (line, finding);
        if self.worst.as_ref().is_none_or(|worst| worse(&here, worst)) {
            self.worst = Some(here);
        }
    }

    fn merge(&mut self, other: &Self) {
        self.rows += other.rows;
        self.failed += other.failed;
        self.undecided += other.undecided;
        self.near += other.near;
        if let Some((line, finding)) = other.worst {
            self.offer(line, finding);
        }
    }
}

/// Whether a row is worse than another. Of equals the first line is, and on one line, or where lines
/// are not known, the one with the larger numbers: so it is the same in whatever order rows come.
fn worse((line, finding): &(u64, Finding), (other, worst): &(u64, Finding)) -> bool {
    if finding.verdict != worst.verdict {
        return finding.verdict > worst.verdict;
    }
    let sizes = match finding.verdict {
        Verdict::Fails => [finding.size(), worst.size()],
        // by the share of the tolerance, without a division
        _ => [finding.residual * worst.tolerance, worst.residual * finding.tolerance],
    };
    let numbers =
        |finding: &Finding| [finding.residual, finding.tolerance, finding.scale].map(f64::to_bits);
    sizes[0]
        .total_cmp(&sizes[1])
        .then_with(|| other.cmp(line))
        .then_with(|| numbers(finding).cmp(&numbers(worst)))
        .is_gt()
}

/// Energy over the whole log.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// the sum of changes along the normal, along the tangent, and of rotation; J, correctly rounded
    /// from the changes of the rows
    pub change: [f64; 3],
    /// the energy before, of all rows; J, likewise
    pub before: f64,
    /// rows with e > 1 in which energy does not rise, which is no fault
    pub bouncy: u64,
    /// rows that slip and have μ > 0, and no friction
    pub frictionless: u64,
    /// rows in which the part along the tangent and of rotation rises together
    pub friction_gains: u64,
}

/// What adds up over rows: two tallies [merge](Self::merge) to that of all their rows, bit by bit,
/// whichever rows either has and in whichever order they came.
#[derive(Clone, Debug)]
pub struct Tally {
    /// rows that were checked
    pub rows: u64,
    /// the checks, in the order of [`Check::ALL`]
    pub checks: [Checked; Check::ALL.len()],
    /// the sums of energy: the three changes, and the energy before
    pub sums: [ExactSum; 4],
    /// the counts of [`Energy`]: bouncy, frictionless, gains by friction
    pub counts: [u64; 3],
}

impl Default for Tally {
    fn default() -> Self {
        Self {
            rows: 0,
            checks: Check::ALL.map(Checked::none),
            sums: Default::default(),
            counts: [0; 3],
        }
    }
}

impl Tally {
    /// Adds a row. What [`Check::Order`] says of it is for who knows the rows before.
    ///
    /// Gives the check that fails most, if one fails.
    pub fn add(&mut self, case: &Case<'_>, order: Option<Finding>) -> Option<(Check, Finding)> {
        self.rows += 1;
        let mut most: Option<(Check, Finding)> = None;
        // one by one, so that each check is code of its own and what they share is computed once
        let [
            reaction,
            moment,
            pull,
            penetration,
            energy,
            restitution,
            cone,
            opposes,
            sticks,
            turns,
        ] = &mut self.checks;
        reaction.take(case, &mut most, case.finding(Check::Reaction));
        moment.take(case, &mut most, case.finding(Check::Moment));
        pull.take(case, &mut most, case.finding(Check::Pull));
        penetration.take(case, &mut most, case.finding(Check::Penetration));
        energy.take(case, &mut most, case.finding(Check::Energy));
        restitution.take(case, &mut most, case.finding(Check::Restitution));
        cone.take(case, &mut most, case.finding(Check::Cone));
        opposes.take(case, &mut most, case.finding(Check::Opposes));
        sticks.take(case, &mut most, case.finding(Check::Sticks));
        turns.take(case, &mut most, order);
        self.count(case);
        most
    }

    /// Adds up energy, and what is worth telling though no check fails by it.
    fn count(&mut self, case: &Case<'_>) {
        let (facts, tolerance) = (&case.facts, &case.tolerance);
        let [normal, tangential, rotational] = facts.energy;
        let terms = [normal, tangential, rotational, case.energy_before()];
        for (sum, term) in self.sums.iter_mut().zip(terms) {
            sum.add(term);
        }
        let by_friction = tangential + rotational;
        let rebounds = facts.after[1] + facts.before[1] > 2.0 * tolerance.separation;
        let rises = normal + by_friction > tolerance.energy;
        let slips =
            facts.before[0].abs() > tolerance.slip_before && facts.after[0].abs() > tolerance.slip;
        let none = facts.impulse[0].abs() <= tolerance.tangential
            && case.given.friction.unwrap_or(0.0) * facts.impulse[1] > 2.0 * tolerance.tangential;
        let found = [rebounds && !rises, slips && none, by_friction > tolerance.energy];
        for (count, found) in self.counts.iter_mut().zip(found) {
            *count += u64::from(found);
        }
    }

    /// Adds the rows of another.
    pub fn merge(&mut self, other: &Self) {
        self.rows += other.rows;
        for (checked, more) in self.checks.iter_mut().zip(&other.checks) {
            checked.merge(more);
        }
        for (sum, more) in self.sums.iter_mut().zip(&other.sums) {
            sum.merge(more);
        }
        for (count, more) in self.counts.iter_mut().zip(other.counts) {
            *count += more;
        }
    }

    /// Energy over these rows.
    #[must_use]
    pub fn energy(&self) -> Energy {
        let [normal, tangential, rotational, before] =
            [0, 1, 2, 3].map(|place: usize| self.sums[place].value());
        let [bouncy, frictionless, friction_gains] = self.counts;
        Energy {
            change: [normal, tangential, rotational],
            before,
            bouncy,
            frictionless,
            friction_gains,
        }
    }
}
