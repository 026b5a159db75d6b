//! Reads logs row by row: CSV, and JSON with one object a line. No row is held.

use std::collections::BTreeMap;
use std::io::{self, BufRead, Read as _};
use std::str::FromStr as _;

use kane_impact::bodies::Shape;
use serde_json::Value;

use crate::header::{Header, HeaderFault};
use crate::json;
use crate::opening::{LONGEST, foreign, is_passed_over, opening};
use crate::quotes::Quotes;
use crate::rejection::{Reason, Rejected};
use crate::row::Row;
use crate::schema::{Column, Field, Side, Word};

/// The two forms of a log.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Cells separated by commas, semicolons or tabs, under a line of names; `#` begins a comment.
    Csv,
    /// A JSON object a line.
    JsonLines,
}

/// Why a log cannot be read at all.
#[derive(Debug, thiserror::Error)]
pub enum ReadFault {
    /// The file ends or breaks.
    #[error("cannot read: {0}")]
    Io(#[from] io::Error),
    /// The cells cannot be told apart.
    #[error("cannot read: {0}")]
    Csv(#[from] csv::Error),
    /// Bytes that are no text of a log.
    #[error("this is {0}")]
    Foreign(&'static str),
    /// There is no header, or no row.
    #[error("the log is empty")]
    Empty,
    /// The columns are not those that are needed.
    #[error(transparent)]
    Header(#[from] HeaderFault),
    /// Columns in memory have several lengths.
    #[error("the columns are not of one length")]
    Lengths,
    /// The first line is no JSON object, so that there are no names.
    #[error("line {0}: {1}")]
    FirstLine(u64, Reason),
}

/// What reads rows.
pub trait Sink {
    /// The header, before the first row.
    fn header(&mut self, header: &Header, pairs: &Pairs);
    /// A row.
    fn row(&mut self, row: &Row);
    /// A line that is none.
    fn reject(&mut self, rejected: Rejected);
    /// The names of the pairs of materials, after the last row.
    fn end(&mut self, pairs: &Pairs);
}

/// The names of the pairs of materials, in the order in which they are met.
#[derive(Clone, Debug, Default)]
pub struct Pairs {
    names: Vec<String>,
    places: BTreeMap<String, u32>,
}

/// The largest magnitude of which products of three are floats.
const MOST: f64 = 1e100;

/// How many pairs are told apart; what comes later is counted with the last.
const MOST_PAIRS: usize = 1000;

impl Pairs {
    /// The names.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    fn place(&mut self, name: &str) -> u32 {
        if let Some(place) = self.places.get(name) {
            return *place;
        }
        let next = u32::try_from(self.names.len()).unwrap_or(u32::MAX);
        if self.names.len() >= MOST_PAIRS {
            return next.saturating_sub(1);
        }
        self.names.push(name.to_owned());
        self.places.insert(name.to_owned(), next);
        next
    }
}

/// The names of the columns, from the [`opening`] of a log; none where they cannot be read.
#[must_use]
pub fn names(start: &[u8], kind: Kind) -> Vec<String> {
    match kind {
        Kind::Csv => {
            let mut reader = csv::ReaderBuilder::new()
                .delimiter(delimiter(start))
                .comment(Some(b'#'))
                .flexible(true)
                .trim(csv::Trim::Headers)
                .from_reader(start);
            header_names(&mut reader).unwrap_or_default()
        }
        Kind::JsonLines => {
            let mut lines =
                start.split(|&byte| byte == b'\n').filter(|l| !l.trim_ascii().is_empty());
            let cells = lines.next().and_then(|line| json::cells(line).ok()).unwrap_or_default();
            cells.into_iter().map(|(name, _)| name).collect()
        }
    }
}

/// The names in the first record.
fn header_names<R: io::Read>(reader: &mut csv::Reader<R>) -> Result<Vec<String>, csv::Error> {
    let name = |name: &[u8]| {
        String::from_utf8_lossy(name).trim_start_matches('\u{feff}').trim().to_owned()
    };
    Ok(reader.byte_headers()?.iter().map(name).collect())
}

/// Reads the log to its end.
///
/// # Errors
/// [`ReadFault`] if there is nothing that could be checked; a line that cannot is the sink's.
pub fn read(
    input: impl BufRead,
    kind: Kind,
    map: &[(String, String)],
    sink: &mut dyn Sink,
) -> Result<Header, ReadFault> {
    match kind {
        Kind::Csv => csv_rows(input, map, sink),
        Kind::JsonLines => json_rows(input, map, sink),
    }
}

fn csv_rows(
    input: impl BufRead,
    map: &[(String, String)],
    sink: &mut dyn Sink,
) -> Result<Header, ReadFault> {
    let (start, input) = opening(input)?;
    if let Some(what) = foreign(&start) {
        return Err(ReadFault::Foreign(what));
    }
    let delimiter = delimiter(&start);
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter)
        .comment(Some(b'#'))
        .flexible(true)
        .trim(csv::Trim::Headers)
        .from_reader(Quotes::new(input, delimiter));
    let names = header_names(&mut reader)?;
    if names.is_empty() {
        return Err(ReadFault::Empty);
    }
    let header = Header::of(&names, map)?;
    let mut pairs = Pairs::default();
    sink.header(&header, &pairs);
    let (mut record, mut row) = (csv::ByteRecord::new(), Row::empty(0));
    while reader.read_byte_record(&mut record)? {
        let line = first_line(&record, reader.position().line());
        row.clear(line);
        let filled = if record.len() == names.len() {
            let cells = header.fields.iter().zip(record.iter());
            cells
                .filter_map(|(field, cell)| field.map(|field| (field, cell)))
                .try_for_each(|(field, cell)| fill(&mut row, field, cell, &mut pairs))
        } else {
            let lines = record.as_slice().iter().filter(|&&byte| byte == b'\n').count();
            Err(Reason::Ragged { cells: record.len(), expected: names.len(), lines })
        };
        match filled {
            Ok(()) => sink.row(&row),
            Err(reason) => sink.reject(Rejected { line, reason }),
        }
    }
    sink.end(&pairs);
    Ok(header)
}

/// The line in which a record begins, from that behind it. That in which its reading began may be above it:
/// lines without cells and comments are read with the record that follows.
fn first_line(record: &csv::ByteRecord, behind: u64) -> u64 {
    let last = behind.saturating_sub(1);
    if record.position().is_some_and(|position| position.line() == last) {
        return last;
    }
    let within = memchr::memchr_iter(b'\n', record.as_slice()).count();
    last.saturating_sub(u64::try_from(within).unwrap_or(0))
}

/// What separates the cells of the first line that is no comment.
fn delimiter(start: &[u8]) -> u8 {
    let first =
        start.split(|&byte| matches!(byte, b'\n' | b'\r')).find(|line| !is_passed_over(line));
    let count = |byte: u8| first.map_or(0, |line| line.iter().filter(|&&b| b == byte).count());
    [b',', b';', b'\t'].into_iter().rev().max_by_key(|&byte| count(byte)).unwrap_or(b',')
}

/// Takes a cell; an empty one is no value.
///
/// # Errors
/// [`Reason`] for a cell that is none of its column.
pub fn fill(row: &mut Row, field: Field, cell: &[u8], pairs: &mut Pairs) -> Result<(), Reason> {
    let text = std::str::from_utf8(cell).map_err(|_| Reason::NotText(field))?.trim();
    if text.is_empty() {
        return Ok(());
    }
    match field {
        Field::Number(column) => {
            let value = text.parse().map_err(|_| Reason::NotANumber(column, text.to_owned()))?;
            number(row, column, value)
        }
        Field::Word(word) => words(row, word, text, pairs),
    }
}

/// Whether [`number`] takes it: it is finite, and products of three such are floats.
#[inline]
#[must_use]
pub fn is_plain(value: f64) -> bool {
    value.abs() <= MOST
}

/// Takes a number.
///
/// # Errors
/// [`Reason::NotFinite`] or [`Reason::Extreme`].
#[inline]
pub fn number(row: &mut Row, column: Column, value: f64) -> Result<(), Reason> {
    if !value.is_finite() {
        return Err(Reason::NotFinite(column));
    }
    if value.abs() > MOST {
        return Err(Reason::Extreme(column, value));
    }
    row.set(column, value);
    Ok(())
}

fn words(row: &mut Row, word: Word, text: &str, pairs: &mut Pairs) -> Result<(), Reason> {
    match word {
        Word::Id => text.clone_into(&mut row.id),
        Word::Pair => row.pair = pairs.place(text),
        Word::Shape(side) => {
            let shape = Shape::from_str(&text.to_ascii_lowercase().replace('_', "-"));
            let place = usize::from(side == Side::Second);
            let unknown = |_| Reason::Shape(word, text.to_owned());
            row.shapes[place] = Some(shape.map_err(unknown)?);
        }
    }
    Ok(())
}

fn json_rows(
    mut input: impl BufRead,
    map: &[(String, String)],
    sink: &mut dyn Sink,
) -> Result<Header, ReadFault> {
    let mut known: Option<(Header, BTreeMap<String, Option<Field>>)> = None;
    let (mut text, mut line, mut row) = (Vec::new(), 0, Row::empty(0));
    let mut pairs = Pairs::default();
    loop {
        text.clear();
        let most = u64::try_from(LONGEST).unwrap_or(u64::MAX);
        if input.by_ref().take(most + 1).read_until(b'\n', &mut text)? == 0 {
            break;
        }
        line += 1;
        if text.len() > LONGEST {
            let why = format!("line {line} has no end in 16 MiB");
            return Err(io::Error::new(io::ErrorKind::InvalidData, why).into());
        }
        if text.trim_ascii().is_empty() {
            continue;
        }
        let cells = match json::cells(&text) {
            Ok(cells) => cells,
            Err(reason) if known.is_none() => return Err(ReadFault::FirstLine(line, reason)),
            Err(reason) => {
                sink.reject(Rejected { line, reason });
                continue;
            }
        };
        if known.is_none() {
            let names: Vec<String> = cells.iter().map(|(name, _)| name.clone()).collect();
            let header = Header::of(&names, map)?;
            sink.header(&header, &pairs);
            let fields = names.into_iter().zip(header.fields.iter().copied()).collect();
            known = Some((header, fields));
        }
        let Some((_, fields)) = &known else { continue };
        row.clear(line);
        let filled = cells.iter().try_for_each(|(name, value)| match fields.get(name) {
            Some(Some(field)) => take(&mut row, *field, value, &mut pairs),
            Some(None) => Ok(()),
            None => Err(Reason::NotJson(format!("the first line has no `{name}`"))),
        });
        match filled {
            Ok(()) => sink.row(&row),
            Err(reason) => sink.reject(Rejected { line, reason }),
        }
    }
    sink.end(&pairs);
    known.map(|(header, _)| header).ok_or(ReadFault::Empty)
}

fn take(row: &mut Row, field: Field, value: &Value, pairs: &mut Pairs) -> Result<(), Reason> {
    match (field, value) {
        (_, Value::Null) => Ok(()),
        (Field::Number(column), Value::Number(value)) => {
            let value = value.as_f64().ok_or(Reason::NotFinite(column))?;
            number(row, column, value)
        }
        (field, Value::String(text)) => fill(row, field, text.as_bytes(), pairs),
        (Field::Number(column), other) => Err(Reason::NotANumber(column, other.to_string())),
        (Field::Word(word), other) => words(row, word, &other.to_string(), pairs),
    }
}
