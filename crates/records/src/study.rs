//! The study of a log: every row checked, and a law named.

use std::io::BufRead;

use kane_impact::Law;

use crate::check::{Case, Check, Finding, Ground};
use crate::event::{Event, Given};
use crate::fit::{PairFit, fits};
use crate::format::Format;
use crate::frame::Frame;
use crate::friction::{self, FrictionFit};
use crate::header::Header;
use crate::reader::{Kind, Pairs, ReadFault, Sink, read};
use crate::rejection::{Reason, Rejected, Rejections};
use crate::replay::{Replay, replay};
use crate::restitution::{Restitution, restitution};
use crate::rigid::{self, LawFit};
use crate::row::Row;
use crate::sample::Sample;
use crate::schema::Column;
use crate::seen::Seen;
use crate::suspicion::{Suspicion, suspicions};
use crate::tolerance::{EXTENT, Precision, Tolerance};
use crate::untold::{Untold, untold};

/// What is asked.
#[derive(Clone, Debug)]
pub struct Options<'a> {
    /// names of the schema, and those of the file
    pub map: Vec<(String, String)>,
    /// the format of the numbers, if it is not to be told by them
    pub format: Option<Format>,
    /// how large the world is, in arms
    pub extent: f64,
    /// the laws that are asked
    pub laws: &'a [Law],
    /// on how many rows attribution rests at most
    pub sample: usize,
}

impl<'a> Options<'a> {
    /// The defaults, with these laws.
    #[must_use]
    pub fn new(laws: &'a [Law]) -> Self {
        Self { map: Vec::new(), format: None, extent: EXTENT, laws, sample: 10_000 }
    }
}

/// How a check fared on all rows.
#[derive(Clone, Debug)]
pub struct Checked {
    /// which
    pub check: Check,
    /// rows that it had something to ask of
    pub rows: u64,
    /// rows on which it fails
    pub failed: u64,
    /// rows whose verdict is within a factor of two of the tolerance
    pub near: u64,
    /// the greatest size of a residual beyond tolerance, or else the greatest share of the tolerance
    pub worst: Option<(u64, Finding)>,
    /// a published law that gives every row, so that the check fails as that law has it
    pub excused: Option<&'static str>,
}

impl Checked {
    /// Whether it is as it should be: no row fails, or a law says that they do.
    #[must_use]
    pub const fn as_expected(&self) -> bool {
        self.failed == 0 || self.excused.is_some()
    }
}

/// One of the worst rows.
#[derive(Clone, Debug)]
pub struct Worst {
    /// the line of the file
    pub line: u64,
    /// the name of the row
    pub id: String,
    /// what fails most
    pub check: Check,
    /// by how much
    pub finding: Finding,
    /// how to see what laws say of it
    pub replay: Replay,
}

/// How many of the worst rows are kept.
pub const WORST: usize = 5;

/// Energy over the whole log.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// the sum of changes along the normal, along the tangent, and of rotation; J
    pub change: [f64; 3],
    /// the energy before, of all rows; J
    pub before: f64,
    /// rows with e > 1 in which energy does not rise, which is no fault
    pub bouncy: u64,
    /// rows that slip and have μ > 0, and no friction
    pub frictionless: u64,
    /// rows in which the part along the tangent and of rotation rises together
    pub friction_gains: u64,
}

/// What was found in a log.
#[derive(Clone, Debug)]
pub struct Study {
    /// the columns
    pub header: Header,
    /// the pairs of materials
    pub pairs: Vec<String>,
    /// the precision of the numbers
    pub precision: Precision,
    /// whether the format was stated, and not told by the numbers
    pub format_stated: bool,
    /// rows that were checked
    pub rows: u64,
    /// lines that were not
    pub rejections: Rejections,
    /// the checks
    pub checks: Vec<Checked>,
    /// energy
    pub energy: Energy,
    /// rows on which attribution rests
    pub sampled: usize,
    /// the restitution
    pub restitution: Option<Restitution>,
    /// laws of friction, best first
    pub friction: Vec<FrictionFit>,
    /// rigid laws, best first
    pub laws: Vec<LawFit>,
    /// coefficients
    pub fits: Vec<PairFit>,
    /// what the log leaves open
    pub untold: Vec<Untold>,
    /// what the log is suspected of
    pub suspicions: Vec<Suspicion>,
    /// the worst rows
    pub worst: Vec<Worst>,
    /// where the impulse acted, by the stated arm, less one: median and worst of what can be told
    pub arm: Option<(f64, f64)>,
}

impl Study {
    /// Whether every check is as it should be, and every row could be checked.
    #[must_use]
    pub fn as_expected(&self) -> bool {
        self.checks.iter().all(Checked::as_expected)
            && self.rejections.total() == 0
            && self.suspicions.is_empty()
    }

    /// The result of a check.
    #[must_use]
    pub fn checked(&self, check: Check) -> Option<&Checked> {
        self.checks.iter().find(|checked| checked.check == check)
    }

    /// The laws that give every row.
    pub fn consistent_laws(&self) -> impl Iterator<Item = &LawFit> {
        self.laws.iter().filter(|fit| fit.gives_all())
    }
}

/// Studies a log.
///
/// # Errors
/// [`ReadFault`] if there is nothing that could be checked.
pub fn study(input: impl BufRead, kind: Kind, options: &Options<'_>) -> Result<Study, ReadFault> {
    let mut gathering = Gathering::new(options);
    let header = read(input, kind, &options.map, &mut gathering)?;
    Ok(gathering.finish(header))
}

/// Rows that are looked at before the first is checked, to tell the format.
const AHEAD: usize = 1000;
/// Rows that fail, of which attribution sees all it can.
const FAILED: usize = 1000;

struct Gathering<'a> {
    options: &'a Options<'a>,
    spatial: bool,
    ahead: Vec<Row>,
    precision: Option<Precision>,
    rows: u64,
    rejections: Rejections,
    checks: Vec<Checked>,
    energy: Energy,
    sample: Sample<Seen>,
    failed: Vec<Seen>,
    worst: Vec<(f64, Worst)>,
    pairs: Vec<String>,
    last_time: Option<f64>,
}

impl Sink for Gathering<'_> {
    fn header(&mut self, header: &Header, _: &Pairs) {
        self.spatial = header.is_spatial();
    }

    fn row(&mut self, row: &Row) {
        match self.precision {
            Some(precision) => self.check(row, &precision),
            None => {
                self.ahead.push(row.clone());
                if self.ahead.len() == AHEAD {
                    self.begin();
                }
            }
        }
    }

    fn reject(&mut self, rejected: Rejected) {
        self.rejections.add(rejected);
    }

    fn end(&mut self, pairs: &Pairs) {
        self.begin();
        self.pairs = pairs.names().to_vec();
    }
}

impl<'a> Gathering<'a> {
    fn new(options: &'a Options<'a>) -> Self {
        let fresh =
            |check| Checked { check, rows: 0, failed: 0, near: 0, worst: None, excused: None };
        Self {
            options,
            spatial: false,
            ahead: Vec::new(),
            precision: None,
            rows: 0,
            rejections: Rejections::default(),
            checks: Check::ALL.map(fresh).to_vec(),
            energy: Energy::default(),
            sample: Sample::new(options.sample),
            failed: Vec::new(),
            worst: Vec::new(),
            pairs: Vec::new(),
            last_time: None,
        }
    }

    /// Tells the format and checks what was held back.
    fn begin(&mut self) {
        if self.precision.is_some() {
            return;
        }
        let ahead = std::mem::take(&mut self.ahead);
        let format = self.options.format.unwrap_or_else(|| Format::of(&ahead));
        let precision = Precision::new(format, self.options.extent);
        self.precision = Some(precision);
        for row in &ahead {
            self.check(row, &precision);
        }
    }

    fn check(&mut self, row: &Row, precision: &Precision) {
        if let Err(reason) = self.checked(row, precision) {
            self.rejections.add(Rejected { line: row.line, reason });
        }
    }

    fn checked(&mut self, row: &Row, precision: &Precision) -> Result<(), Reason> {
        let given = Given::of(row)?;
        let frame = Frame::of(row, self.spatial)?;
        let event = Event::<f64>::of(row, &frame)?;
        let facts = event.facts();
        let precision = Precision { tilt: precision.tilt + frame.slack, ..*precision };
        let tolerance = Tolerance::of(&event, &facts, &given, &precision);
        if facts.before[1] > tolerance.separation {
            return Err(Reason::Apart(facts.before[1]));
        }
        let case = Case { row, frame, event, facts, given, tolerance };
        self.rows += 1;
        let mut most: Option<(Check, Finding)> = None;
        for place in 0..Check::ALL.len() {
            let check = Check::ALL[place];
            let finding = match check {
                Check::Order => self.order(row),
                _ => case.finding(check),
            };
            let Some(finding) = finding else { continue };
            self.checks[place].add(row.line, finding);
            let greater = |most: &Finding| finding.size() > most.size();
            if !finding.holds && most.as_ref().is_none_or(|(_, most)| greater(most)) {
                most = Some((check, finding));
            }
        }
        self.count(&case);
        if let Some((check, finding)) = most {
            self.remember(&case, check, finding);
        }
        let wanted = self.sample.wants();
        self.sample.offer(|| Seen::of(&case));
        if most.is_some() && !wanted && self.failed.len() < FAILED {
            self.failed.push(Seen::of(&case));
        }
        Ok(())
    }

    /// Adds up energy, and what is worth telling though no check fails by it.
    fn count(&mut self, case: &Case<'_>) {
        let (facts, tolerance) = (&case.facts, &case.tolerance);
        for (sum, part) in self.energy.change.iter_mut().zip(facts.energy) {
            *sum += part;
        }
        self.energy.before += case.energy_before();
        let [normal, tangential, rotational] = facts.energy;
        let by_friction = tangential + rotational;
        self.energy.friction_gains += u64::from(by_friction > tolerance.energy);
        let rebounds = facts.after[1] + facts.before[1] > 2.0 * tolerance.separation;
        let rises = normal + by_friction > tolerance.energy;
        self.energy.bouncy += u64::from(rebounds && !rises);
        let slips =
            facts.before[0].abs() > tolerance.slip_before && facts.after[0].abs() > tolerance.slip;
        let none = facts.impulse[0].abs() <= tolerance.tangential
            && case.given.friction.unwrap_or(0.0) * facts.impulse[1] > 2.0 * tolerance.tangential;
        self.energy.frictionless += u64::from(slips && none);
    }

    /// Time does not go back.
    fn order(&mut self, row: &Row) -> Option<Finding> {
        let time = row.get(Column::Time)?;
        let last = self.last_time.replace(time)?;
        let residual = (last - time).max(0.0);
        let scale = last.abs().max(time.abs());
        Some(Finding { residual, tolerance: 0.0, scale, holds: residual == 0.0 })
    }

    fn remember(&mut self, case: &Case<'_>, check: Check, finding: Finding) {
        let least = self.worst.last().map_or(0.0, |(size, _)| *size);
        if self.worst.len() == WORST && finding.size() <= least {
            return;
        }
        let worst = Worst {
            line: case.row.line,
            id: case.row.id.clone(),
            check,
            finding,
            replay: replay(&case.event, &case.given),
        };
        let place = self.worst.partition_point(|(size, _)| *size >= finding.size());
        self.worst.insert(place, (finding.size(), worst));
        self.worst.truncate(WORST);
    }

    fn finish(self, header: Header) -> Study {
        let precision =
            self.precision.unwrap_or_else(|| Precision::new(Format::Binary64, self.options.extent));
        let mut rows: Vec<Seen> = self.sample.kept().to_vec();
        rows.extend(self.failed);
        let friction = friction::ranked(&rows);
        let laws = rigid::ranked(self.options.laws, &rows);
        let mut checks = self.checks;
        for checked in &mut checks {
            checked.excused = excuse(checked, &laws);
        }
        let mut arms: Vec<f64> =
            rows.iter().map(|seen| seen.arm).filter(|arm| arm.is_finite()).collect();
        arms.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        let arm = arms.last().map(|worst| (arms[arms.len() / 2], *worst));
        Study {
            header,
            pairs: self.pairs,
            precision,
            format_stated: self.options.format.is_some(),
            rows: self.rows,
            suspicions: suspicions(&rows, &self.rejections, self.rows),
            rejections: self.rejections,
            checks,
            energy: self.energy,
            sampled: rows.len(),
            restitution: restitution(&rows),
            untold: untold(&rows, &friction),
            friction,
            laws,
            fits: fits(&rows),
            worst: self.worst.into_iter().map(|(_, worst)| worst).collect(),
            arm,
        }
    }
}

impl Checked {
    fn add(&mut self, line: u64, finding: Finding) {
        self.rows += 1;
        self.failed += u64::from(!finding.holds);
        self.near += u64::from(finding.is_near());
        let worse = |(_, worst): &(u64, Finding)| match (finding.holds, worst.holds) {
            (false, true) => true,
            (true, false) => false,
            (false, false) => finding.size() > worst.size(),
            // by the share of the tolerance, without a division
            (true, true) => finding.residual * worst.tolerance > worst.residual * finding.tolerance,
        };
        if self.worst.as_ref().is_none_or(worse) {
            self.worst = Some((line, finding));
        }
    }
}

/// With fewer rows a law whose parameters were fitted to them excuses nothing.
const FITTED_EXCUSES: usize = 20;

/// The law by which a check may fail.
fn excuse(checked: &Checked, laws: &[LawFit]) -> Option<&'static str> {
    if checked.failed == 0 || checked.check.ground() != Ground::Constitutive {
        return None;
    }
    // Newton's law is what the check of restitution asks for
    let other = |fit: &&LawFit| checked.check != Check::Restitution || !fit.is_newton();
    let enough = |fit: &&LawFit| !fit.fitted || fit.rows >= FITTED_EXCUSES;
    let giving = laws.iter().filter(|fit| fit.gives_all()).filter(enough);
    giving.filter(other).map(|fit| fit.law.info.id).next()
}
