//! A summary as bytes, for the next stage of a query.

use kane_records::check::{Check, Finding, Verdict};
use kane_records::rejection::Listed;
use kane_records::tally::Checked;

use crate::bytes::{Reader, Writer};
use crate::choice::Choice;
use crate::fault::LakeFault;
use crate::summary::{Missing, Summary};

/// It rises whenever the bytes change, or what they mean.
const VERSION: u64 = 3;

impl Summary {
    /// The summary as bytes.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Writer::default();
        out.count(VERSION);
        out.flag(self.log.is_some());
        if let Some((names, numbers)) = &self.log {
            out.text(&numbers.to_string());
            out.count(names.len() as u64);
            names.iter().for_each(|name| out.text(name));
        }
        out.count(self.tally.rows);
        for checked in &self.tally.checks {
            let counts = [checked.rows, checked.failed, checked.undecided, checked.near];
            counts.into_iter().for_each(|n| out.count(n));
            out.flag(checked.worst.is_some());
            if let Some((_, finding)) = &checked.worst {
                [finding.residual, finding.tolerance, finding.scale]
                    .into_iter()
                    .for_each(|x| out.float(x));
                out.flag(finding.verdict != Verdict::Holds);
                out.flag(finding.fails());
            }
        }
        for sum in &self.tally.sums {
            let terms: Vec<f64> = sum.terms().collect();
            out.count(terms.len() as u64);
            terms.into_iter().for_each(|term| out.float(term));
        }
        self.tally.counts.iter().for_each(|count| out.count(*count));
        out.count(self.rejections.kinds().count() as u64);
        for (kind, count, listed) in self.rejections.kinds() {
            out.text(kind);
            out.count(count);
            out.count(listed.len() as u64);
            listed.iter().for_each(|one| out.text(&one.why));
        }
        for choice in [&self.sample, &self.failed] {
            out.count(choice.kept().len() as u64);
            for (hash, chosen) in choice.kept() {
                out.count(*hash);
                out.count(chosen.count);
                out.bytes(&chosen.row);
            }
        }
        out.count(self.worst.len() as u64);
        for missing in &self.worst {
            out.float(missing.size);
            out.count(missing.hash);
            out.count(missing.check.place() as u64);
            out.bytes(&missing.row);
        }
        out.0
    }

    /// A summary from its bytes, with room for so many rows.
    ///
    /// # Errors
    /// [`LakeFault::Parts`] for bytes of another version, or damaged ones.
    pub fn from_bytes(bytes: &[u8], sample: usize) -> Result<Self, LakeFault> {
        let mut from = Reader(bytes);
        if from.count()? != VERSION {
            return Err(LakeFault::Parts("a part was summed up by another version of kane-lake"));
        }
        let mut summary = Self::new(sample);
        if from.flag()? {
            let numbers = from.text()?.parse()?;
            let mut names = Vec::new();
            for _ in 0..from.length()? {
                names.push(from.text()?.to_owned());
            }
            summary.log = Some((names, numbers));
        }
        summary.tally.rows = from.count()?;
        for checked in &mut summary.tally.checks {
            *checked = read_checked(&mut from, checked.check)?;
        }
        for sum in &mut summary.tally.sums {
            for _ in 0..from.length()? {
                sum.add(from.float()?);
            }
        }
        for count in &mut summary.tally.counts {
            *count = from.count()?;
        }
        for _ in 0..from.length()? {
            let (kind, count) = (from.text()?, from.count()?);
            let mut listed = Vec::new();
            for _ in 0..from.length()? {
                listed.push(Listed { line: 0, why: from.text()?.to_owned() });
            }
            summary.rejections.merge(kind, count, &listed);
        }
        read_choice(&mut from, &mut summary.sample)?;
        read_choice(&mut from, &mut summary.failed)?;
        for _ in 0..from.length()? {
            let (size, hash, place) = (from.float()?, from.count()?, from.count()?);
            let check = usize::try_from(place).ok().and_then(|place| Check::ALL.get(place));
            let check = *check.ok_or(LakeFault::Parts("a check is not known"))?;
            summary.worst.push(Missing { size, hash, check, row: Box::from(from.bytes()?) });
        }
        Ok(summary)
    }
}

fn read_checked(from: &mut Reader<'_>, check: Check) -> Result<Checked, LakeFault> {
    let (rows, failed) = (from.count()?, from.count()?);
    let (undecided, near) = (from.count()?, from.count()?);
    let worst = if from.flag()? {
        let (residual, tolerance, scale) = (from.float()?, from.float()?, from.float()?);
        let verdict = match (from.flag()?, from.flag()?) {
            (_, true) => Verdict::Fails,
            (true, false) => Verdict::Undecided,
            (false, false) => Verdict::Holds,
        };
        Some((0, Finding { residual, tolerance, scale, verdict }))
    } else {
        None
    };
    Ok(Checked { rows, failed, undecided, near, worst, ..Checked::none(check) })
}

fn read_choice(from: &mut Reader<'_>, choice: &mut Choice) -> Result<(), LakeFault> {
    for _ in 0..from.length()? {
        let (hash, count, row) = (from.count()?, from.count()?, from.bytes()?);
        choice.offer(hash, count, || Box::from(row));
    }
    Ok(())
}
