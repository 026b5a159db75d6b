//! Rows that cannot be checked: each is counted, and the first of each kind are listed.

use std::collections::BTreeMap;
use std::fmt;

use crate::schema::{Column, Field, Word};

/// Why a row is not checked.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// It has more or fewer cells than the header.
    Ragged {
        /// cells of the row
        cells: usize,
        /// cells of the header
        expected: usize,
        /// line ends in its cells, which a quote that is not closed keeps there
        lines: usize,
    },
    /// A cell of numbers holds something else.
    NotANumber(Column, String),
    /// NaN or an infinity.
    NotFinite(Column),
    /// A magnitude with products that floats cannot hold: above 1e100, and of a mass, an inertia or a radius also
    /// below 1e-100.
    Extreme(Column, f64),
    /// A cell that is needed is empty.
    Missing(Column),
    /// A mass, an inertia or a radius that is not above zero.
    NotPositive(Column, f64),
    /// A friction coefficient, time step or phase below zero.
    Negative(Column, f64),
    /// A stated restitution that is not between 0 and 1.
    Restitution(f64),
    /// A normal that is not of unit length.
    Normal(f64),
    /// The bodies move apart already.
    Apart(f64),
    /// A word that names no shape, or a shape without a radius.
    Shape(Word, String),
    /// Friction or spin leaves the plane of slip and normal.
    OutOfPlane(&'static str),
    /// A line that is no JSON object.
    NotJson(String),
    /// A cell that is not UTF-8.
    NotText(Field),
}

impl Reason {
    /// The kind, for counting.
    #[must_use]
    pub fn kind(&self) -> String {
        match self {
            Self::Ragged { .. } => "ragged row".to_owned(),
            Self::NotANumber(column, _) => format!("no number in {}", column.name()),
            Self::NotFinite(column) => format!("NaN or infinity in {}", column.name()),
            Self::Extreme(column, _) => format!("{} is too large or too small", column.name()),
            Self::Missing(column) => format!("{} is empty", column.name()),
            Self::NotPositive(column, _) => format!("{} is not above zero", column.name()),
            Self::Negative(column, _) => format!("{} is negative", column.name()),
            Self::Restitution(_) => "stated e is not between 0 and 1".to_owned(),
            Self::Normal(_) => "the normal is not of unit length".to_owned(),
            Self::Apart(_) => "the bodies move apart before the impact".to_owned(),
            Self::Shape(word, _) => format!("unknown {}", word.name()),
            Self::OutOfPlane(why) => format!("leaves the plane: {why}"),
            Self::NotJson(_) => "no JSON object".to_owned(),
            Self::NotText(field) => format!("not UTF-8 in {}", field.name()),
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = self.kind();
        match self {
            Self::Ragged { cells, expected, lines } => {
                write!(f, "{kind}: {cells} cells where the header has {expected}")?;
                match lines {
                    0 => Ok(()),
                    _ => write!(f, "; a quote that opens in it takes {lines} line ends along"),
                }
            }
            Self::NotANumber(_, text) if text.replacen(',', ".", 1).parse::<f64>().is_ok() => {
                write!(f, "{kind}: `{text}`; decimals take a point")
            }
            Self::NotANumber(_, text) => {
                let text: String = text.chars().take(40).collect();
                write!(f, "{kind}: `{text}`")
            }
            Self::NotPositive(_, value) | Self::Negative(_, value) | Self::Restitution(value) => {
                write!(f, "{kind}: {value}")
            }
            Self::Extreme(_, value) => {
                write!(
                    f,
                    "{kind}: {value:e}; 1e100 is the most, and of masses, inertias and radii 1e-100 the least"
                )
            }
            Self::Normal(length) => write!(f, "{kind}: its length is {length}"),
            Self::Apart(speed) => write!(f, "{kind}, at {speed} m/s"),
            Self::Shape(_, text) => write!(f, "{kind}: `{text}`"),
            Self::NotJson(why) => write!(f, "{kind}: {why}"),
            _ => f.write_str(&kind),
        }
    }
}

/// A row that was rejected.
#[derive(Clone, Debug, PartialEq)]
pub struct Rejected {
    /// the line of the file, from 1
    pub line: u64,
    /// why
    pub reason: Reason,
}

/// How many of each kind are listed.
pub const LISTED: usize = 3;

/// A rejected row in a list.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Listed {
    /// the line of the file, or 0 if it is not known
    pub line: u64,
    /// why it was rejected
    pub why: String,
}

/// All rejections: counts by kind, and the first few of each, by line and then by reason.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rejections {
    kinds: BTreeMap<String, (u64, Vec<Listed>)>,
}

impl Rejections {
    /// Counts one.
    pub fn add(&mut self, rejected: Rejected) {
        let (count, listed) = self.kinds.entry(rejected.reason.kind()).or_default();
        *count += 1;
        let line = rejected.line;
        if listed.len() < LISTED || listed.last().is_some_and(|last| line <= last.line) {
            list(listed, Listed { line, why: rejected.reason.to_string() });
        }
    }

    /// Counts rows of a kind that were rejected elsewhere, with those that are listed of them.
    pub fn merge(&mut self, kind: &str, rows: u64, listed: &[Listed]) {
        let (count, own) = self.kinds.entry(kind.to_owned()).or_default();
        *count += rows;
        listed.iter().for_each(|one| list(own, one.clone()));
    }

    /// How many rows were rejected.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.kinds.values().map(|(count, _)| count).sum()
    }

    /// How many of this kind, by the beginning of its name.
    #[must_use]
    pub fn of_kind(&self, beginning: &str) -> u64 {
        let kinds = self.kinds.iter().filter(|(kind, _)| kind.starts_with(beginning));
        kinds.map(|(_, (count, _))| count).sum()
    }

    /// Kind, count and first rows, in the order of kinds.
    pub fn kinds(&self) -> impl Iterator<Item = (&str, u64, &[Listed])> {
        self.kinds.iter().map(|(kind, (count, rows))| (kind.as_str(), *count, rows.as_slice()))
    }
}

/// Keeps the first few.
fn list(listed: &mut Vec<Listed>, one: Listed) {
    let place = listed.partition_point(|other| *other <= one);
    if place < LISTED {
        listed.insert(place, one);
        listed.truncate(LISTED);
    }
}
