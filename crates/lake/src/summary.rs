//! What is kept of a part of a log, and how two parts become one.

use std::collections::BTreeMap;

use kane_impact::laws;
use kane_records::case::Case;
use kane_records::check::{Check, Finding};
use kane_records::header::Header;
use kane_records::reader::Pairs;
use kane_records::rejection::{Rejected, Rejections};
use kane_records::row::Row;
use kane_records::seen::Seen;
use kane_records::study::{Gathered, Study};
use kane_records::tally::Tally;
use kane_records::tolerance::Precision;
use kane_records::worst::{WORST, Worst};

use crate::choice::{Choice, hash, worded};
use crate::columns::Columns;
use crate::fault::LakeFault;
use crate::numbers::Numbers;
use crate::written::{read, written};

/// Rows of which attribution sees all it can, beside the sample: those that fail.
const FAILED: usize = 1000;

/// What is kept of some rows of a log. Two summaries [merge](Self::merge) to that of all their rows,
/// bit by bit, however the rows were parted and in whatever order they came.
#[derive(Clone, Debug)]
pub struct Summary {
    /// the names of the columns, and the format of their numbers; unknown before the first row
    pub(crate) log: Option<(Vec<String>, Numbers)>,
    pub(crate) tally: Tally,
    pub(crate) rejections: Rejections,
    pub(crate) sample: Choice,
    pub(crate) failed: Choice,
    pub(crate) worst: Vec<Missing>,
}

/// A row that misses a check, among the worst.
#[derive(Clone, Debug)]
pub(crate) struct Missing {
    pub(crate) size: f64,
    pub(crate) hash: u64,
    pub(crate) check: Check,
    pub(crate) row: Box<[u8]>,
}

impl Summary {
    /// Of no row, with room for so many on which attribution may rest.
    #[must_use]
    pub fn new(sample: usize) -> Self {
        Self {
            log: None,
            tally: Tally::default(),
            rejections: Rejections::default(),
            sample: Choice::new(sample.max(2)),
            failed: Choice::new(FAILED),
            worst: Vec::new(),
        }
    }

    /// That all parts have the same columns and format.
    fn agree(&mut self, names: &[String], numbers: Numbers) -> Result<(), LakeFault> {
        match &self.log {
            Some((own, format)) if *own == names && *format == numbers => Ok(()),
            Some(_) => Err(LakeFault::Parts("columns or formats of numbers differ")),
            None => {
                self.log = Some((names.to_vec(), numbers));
                Ok(())
            }
        }
    }

    /// Adds the rows of a batch.
    ///
    /// # Errors
    /// [`LakeFault::Parts`] if its columns are not those of the rows before.
    pub(crate) fn add(&mut self, columns: &Columns, numbers: Numbers) -> Result<(), LakeFault> {
        if columns.rows() == 0 {
            return Ok(());
        }
        self.agree(&columns.names, numbers)?;
        let (precision, spatial) = (numbers.precision(), columns.header.is_spatial());
        let (mut row, mut pairs) = (Row::empty(0), Pairs::default());
        let hashes = columns.hashes();
        for at in 0..columns.rows() {
            if let Err(reason) = columns.fill(at, &mut row, &mut pairs) {
                self.rejections.add(Rejected { line: 0, reason });
                continue;
            }
            // a case is large, and stays where it was made
            match &Case::of(&row, spatial, &precision) {
                Ok(case) => {
                    let pair = name(&row, &pairs);
                    let numbers = hashes.as_ref().and_then(|hashes| hashes.get(at));
                    let hash =
                        numbers.map_or_else(|| hash(&row, pair), |hash| worded(*hash, &row, pair));
                    self.add_case(case, hash, pair);
                }
                Err(reason) => {
                    self.rejections.add(Rejected { line: 0, reason: reason.clone() });
                }
            }
        }
        Ok(())
    }

    fn add_case(&mut self, case: &Case<'_>, hash: u64, pair: &str) {
        let most = self.tally.add(case, None);
        self.sample.offer(hash, 1, || written(case.row, pair));
        let Some((check, finding)) = most else { return };
        self.failed.offer(hash, 1, || written(case.row, pair));
        let size = finding.size();
        if self.worst.len() < WORST || self.worst.last().is_some_and(|last| size >= last.size) {
            self.miss(Missing { size, hash, check, row: written(case.row, pair) });
        }
    }

    /// Keeps the worst rows, each once.
    fn miss(&mut self, missing: Missing) {
        if self.worst.iter().any(|other| other.hash == missing.hash) {
            return;
        }
        let before = |other: &Missing| {
            other.size.total_cmp(&missing.size).then(missing.hash.cmp(&other.hash)).is_ge()
        };
        let place = self.worst.partition_point(before);
        self.worst.insert(place, missing);
        self.worst.truncate(WORST);
    }

    /// Adds the rows of another part.
    ///
    /// # Errors
    /// [`LakeFault::Parts`] if its columns are others.
    pub fn merge(&mut self, other: Self) -> Result<(), LakeFault> {
        if let Some((names, numbers)) = &other.log {
            self.agree(names, *numbers)?;
        }
        self.tally.merge(&other.tally);
        for (kind, count, listed) in other.rejections.kinds() {
            self.rejections.merge(kind, count, listed);
        }
        self.sample.merge(&other.sample);
        self.failed.merge(&other.failed);
        other.worst.into_iter().for_each(|missing| self.miss(missing));
        Ok(())
    }

    /// Bytes of memory, about.
    pub(crate) fn size(&self) -> usize {
        size_of::<Self>() + self.sample.size() + self.failed.size()
    }

    /// What the rows say.
    ///
    /// Laws are named on all rows where there was room for them, and otherwise on those of the sample,
    /// each once, and on as many that fail as there was room for besides.
    ///
    /// # Errors
    /// [`LakeFault::Parts`] if there was no row at all, or a row that was handed on is damaged.
    pub fn study(self) -> Result<Study, LakeFault> {
        let (names, numbers) = self.log.ok_or(LakeFault::Parts("there is no row"))?;
        let header = Header::of(&names, &[])?;
        let spatial = header.is_spatial();
        let precision = numbers.precision();
        let mut pairs = Named::default();
        let counted: u64 = self.sample.kept().values().map(|chosen| chosen.count).sum();
        let all = counted == self.tally.rows;
        let mut rows = Vec::new();
        for chosen in self.sample.kept().values() {
            let seen = pairs.seen(&chosen.row, spatial, &precision)?;
            let count = if all { chosen.count } else { 1 };
            rows.extend((0..count).filter_map(|_| seen.clone()));
        }
        for (hash, chosen) in self.failed.kept() {
            if !self.sample.kept().contains_key(hash) {
                rows.extend(pairs.seen(&chosen.row, spatial, &precision)?);
            }
        }
        let mut worst = Vec::new();
        for missing in &self.worst {
            let (row, _) = read(&missing.row)?;
            let case = Case::of(&row, spatial, &precision).ok();
            worst.extend(case.and_then(|case| {
                let finding: Finding = case.finding(missing.check)?;
                Some(Worst::of(&case, missing.check, finding))
            }));
        }
        let gathered = Gathered {
            header,
            pairs: pairs.names,
            precision,
            format_stated: false,
            tally: self.tally,
            rejections: self.rejections,
            rows,
            worst,
        };
        Ok(gathered.conclude(laws()))
    }
}

/// The name of a row's pair of materials.
fn name<'a>(row: &Row, pairs: &'a Pairs) -> &'a str {
    let place = usize::try_from(row.pair).unwrap_or(usize::MAX);
    pairs.names().get(place).map_or("", String::as_str)
}

/// The pairs of materials of the rows that were chosen.
#[derive(Default)]
struct Named {
    names: Vec<String>,
    places: BTreeMap<String, u32>,
}

impl Named {
    fn seen(
        &mut self,
        bytes: &[u8],
        spatial: bool,
        precision: &Precision,
    ) -> Result<Option<Seen>, LakeFault> {
        let (mut row, pair) = read(bytes)?;
        if !pair.is_empty() {
            let next = u32::try_from(self.names.len()).unwrap_or(u32::MAX);
            row.pair = *self.places.entry(pair.to_owned()).or_insert_with(|| {
                self.names.push(pair.to_owned());
                next
            });
        }
        Ok(Case::of(&row, spatial, precision).ok().map(|case| Seen::of(&case)))
    }
}
