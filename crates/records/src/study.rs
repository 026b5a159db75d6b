//! The study of a log: every row checked, and a law named.

use std::io::BufRead;

use kane_impact::Law;

use crate::case::Case;
use crate::check::{Check, Finding, Ground, Verdict};
use crate::fit::{PairFit, fits};
use crate::format::Format;
use crate::friction::{self, FrictionFit};
use crate::header::Header;
use crate::reader::{Kind, Pairs, ReadFault, Sink, read};
use crate::rejection::{Rejected, Rejections};
use crate::restitution::{Restitution, restitution};
use crate::rigid::{self, LawFit};
use crate::row::Row;
use crate::sample::Sample;
use crate::scatter::{Spot, spots};
use crate::schema::Column;
use crate::seen::Seen;
use crate::statistics::median;
use crate::suspicion::{Suspicion, suspicions};
use crate::tally::{Checked, Energy, Tally};
use crate::told::Told;
use crate::tolerance::{EXTENT, Precision};
use crate::untold::{Untold, untold};
use crate::worst::{WORST, Worst};

/// What is asked.
#[derive(Clone, Debug)]
pub struct Options<'a> {
    /// names of the schema, and those of the file
    pub map: Vec<(String, String)>,
    /// the format of the numbers, if it is not to be told by them
    pub format: Option<Told>,
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
    /// 1 − y'/y of the stated arm y and that at which the impulse acted: by magnitude the median and the worst of what
    /// can be told
    pub arm: Option<(f64, f64)>,
    /// the median of the same by sign, below zero where impulses act farther out than stated
    pub arm_offset: Option<f64>,
    /// the rows in pictures
    pub spots: Vec<Spot>,
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

/// Studies rows that somebody feeds: header, rows and end, in that order.
pub(crate) fn study_rows(
    header: Header,
    options: &Options<'_>,
    feed: impl FnOnce(&mut dyn Sink, &Header),
) -> Study {
    let mut gathering = Gathering::new(options);
    feed(&mut gathering, &header);
    gathering.finish(header)
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
    tally: Tally,
    rejections: Rejections,
    sample: Sample<Seen>,
    failed: Vec<Seen>,
    worst: Vec<Worst>,
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
        Self {
            options,
            spatial: false,
            ahead: Vec::new(),
            precision: None,
            tally: Tally::default(),
            rejections: Rejections::default(),
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
        let told = self.options.format.unwrap_or_else(|| Told::of(&ahead));
        let precision = Precision::told(told, self.options.extent);
        self.precision = Some(precision);
        for row in &ahead {
            self.check(row, &precision);
        }
    }

    fn check(&mut self, row: &Row, precision: &Precision) {
        // a case is large, and stays where it was made
        match &Case::of(row, self.spatial, precision) {
            Ok(case) => self.checked(case),
            Err(reason) => {
                self.rejections.add(Rejected { line: row.line, reason: reason.clone() });
            }
        }
    }

    fn checked(&mut self, case: &Case<'_>) {
        let order = self.order(case.row);
        let most = self.tally.add(case, order);
        if let Some((check, finding)) = most {
            self.remember(case, check, finding);
        }
        let wanted = self.sample.wants();
        self.sample.offer(|| Seen::of(case));
        if most.is_some() && !wanted && self.failed.len() < FAILED {
            self.failed.push(Seen::of(case));
        }
    }

    /// Time does not go back.
    fn order(&mut self, row: &Row) -> Option<Finding> {
        let time = row.get(Column::Time)?;
        let last = self.last_time.replace(time)?;
        let residual = (last - time).max(0.0);
        let scale = last.abs().max(time.abs());
        let verdict = if residual == 0.0 { Verdict::Holds } else { Verdict::Fails };
        Some(Finding { residual, tolerance: 0.0, scale, verdict })
    }

    fn remember(&mut self, case: &Case<'_>, check: Check, finding: Finding) {
        let least = self.worst.last().map_or(0.0, |worst| worst.finding.size());
        if self.worst.len() == WORST && finding.size() <= least {
            return;
        }
        let place = self.worst.partition_point(|worst| worst.finding.size() >= finding.size());
        self.worst.insert(place, Worst::of(case, check, finding));
        self.worst.truncate(WORST);
    }

    fn finish(self, header: Header) -> Study {
        let precision = self.precision.unwrap_or_else(|| {
            Precision::told(Told::stated(Format::Binary64), self.options.extent)
        });
        let mut rows: Vec<Seen> = self.sample.kept().to_vec();
        rows.extend(self.failed);
        let gathered = Gathered {
            header,
            pairs: self.pairs,
            precision,
            format_stated: self.options.format.is_some(),
            tally: self.tally,
            rejections: self.rejections,
            rows,
            worst: self.worst,
        };
        gathered.conclude(self.options.laws)
    }
}

/// All that a log was read for, however that was done.
#[derive(Clone, Debug)]
pub struct Gathered {
    /// the columns
    pub header: Header,
    /// the pairs of materials
    pub pairs: Vec<String>,
    /// the precision of the numbers
    pub precision: Precision,
    /// whether the format was stated, and not told by the numbers
    pub format_stated: bool,
    /// what adds up over rows
    pub tally: Tally,
    /// rows that were not checked
    pub rejections: Rejections,
    /// the rows on which attribution rests
    pub rows: Vec<Seen>,
    /// the worst rows
    pub worst: Vec<Worst>,
}

impl Gathered {
    /// What it says, with these laws asked.
    #[must_use]
    pub fn conclude(self, laws: &[Law]) -> Study {
        let rows = self.rows;
        let friction = friction::ranked(&rows);
        let laws = rigid::ranked(laws, &rows);
        let energy = self.tally.energy();
        let mut checks = self.tally.checks.to_vec();
        for checked in &mut checks {
            checked.excused = excuse(checked, &laws);
        }
        let mut arms: Vec<f64> =
            rows.iter().map(|seen| seen.arm).filter(|arm| arm.is_finite()).collect();
        let arm_offset = median(arms.clone());
        arms.sort_by(|a, b| a.abs().total_cmp(&b.abs()));
        let arm = arms.last().map(|worst| (arms[arms.len() / 2], *worst));
        Study {
            header: self.header,
            pairs: self.pairs,
            precision: self.precision,
            format_stated: self.format_stated,
            rows: self.tally.rows,
            suspicions: suspicions(&rows, &self.rejections, self.tally.rows),
            rejections: self.rejections,
            checks,
            energy,
            sampled: rows.len(),
            restitution: restitution(&rows),
            untold: untold(&rows, &friction, &self.precision),
            friction,
            laws,
            fits: fits(&rows),
            worst: self.worst,
            arm,
            arm_offset,
            spots: spots(&rows),
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
