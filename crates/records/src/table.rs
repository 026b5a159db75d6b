//! Logs that are in memory, column by column.

use crate::header::Header;
use crate::reader::{Pairs, ReadFault, fill, number};
use crate::rejection::{Reason, Rejected};
use crate::row::Row;
use crate::schema::Field;
use crate::study::{Options, Study, study_rows};

/// The cells of a column.
#[derive(Clone, Copy, Debug)]
pub enum Cells<'a> {
    /// Numbers, and which of them are missing: as long as they are, or empty where none is. A NaN that is
    /// not missing is a fault of its row.
    Numbers {
        /// the numbers
        values: &'a [f64],
        /// which are missing
        missing: &'a [bool],
    },
    /// Words; those of a column of numbers are read as in CSV.
    Words(&'a [Option<String>]),
}

impl Cells<'_> {
    const fn len(&self) -> usize {
        match self {
            Self::Numbers { values, .. } => values.len(),
            Self::Words(words) => words.len(),
        }
    }
}

/// A log in memory: columns with their names, in order.
#[derive(Clone, Debug, Default)]
pub struct Table<'a> {
    names: Vec<String>,
    columns: Vec<Cells<'a>>,
}

impl<'a> Table<'a> {
    /// Adds a column.
    pub fn push(&mut self, name: &str, cells: Cells<'a>) {
        self.names.push(name.to_owned());
        self.columns.push(cells);
    }

    /// How many rows there are; `None` if the columns differ in it.
    fn rows(&self) -> Option<usize> {
        let rows = self.columns.first().map_or(0, Cells::len);
        let fits = |cells: &Cells<'_>| {
            let mask = match cells {
                Cells::Numbers { missing, .. } => missing.is_empty() || missing.len() == rows,
                Cells::Words(_) => true,
            };
            cells.len() == rows && mask
        };
        self.columns.iter().all(fits).then_some(rows)
    }
}

/// Studies a log in memory; its rows are counted from 1.
///
/// # Errors
/// [`ReadFault`] if there is nothing that could be checked, or the columns are not of one length.
pub fn study_table(table: &Table<'_>, options: &Options<'_>) -> Result<Study, ReadFault> {
    let header = Header::of(&table.names, &options.map)?;
    let rows = table.rows().ok_or(ReadFault::Lengths)?;
    if rows == 0 {
        return Err(ReadFault::Empty);
    }
    let read: Vec<(Field, Cells<'_>)> = header
        .fields
        .iter()
        .zip(&table.columns)
        .filter_map(|(field, cells)| field.map(|field| (field, *cells)))
        .collect();
    Ok(study_rows(header, options, |sink, header| {
        let mut pairs = Pairs::default();
        sink.header(header, &pairs);
        let mut row = Row::empty(0);
        for place in 0..rows {
            let line = u64::try_from(place).unwrap_or(u64::MAX).saturating_add(1);
            row.clear(line);
            match read
                .iter()
                .try_for_each(|(f, cells)| take(&mut row, *f, cells, place, &mut pairs))
            {
                Ok(()) => sink.row(&row),
                Err(reason) => sink.reject(Rejected { line, reason }),
            }
        }
        sink.end(&pairs);
    }))
}

fn take(
    row: &mut Row,
    field: Field,
    cells: &Cells<'_>,
    place: usize,
    pairs: &mut Pairs,
) -> Result<(), Reason> {
    match cells {
        Cells::Words(words) => match words.get(place).and_then(Option::as_deref) {
            Some(word) => fill(row, field, word.as_bytes(), pairs),
            None => Ok(()),
        },
        Cells::Numbers { missing, .. } if missing.get(place).is_some_and(|it| *it) => Ok(()),
        Cells::Numbers { values, .. } => {
            let value = values.get(place).copied().unwrap_or(f64::NAN);
            match field {
                Field::Number(column) => number(row, column, value),
                // a name or a pair that is written as a number
                Field::Word(_) => fill(row, field, value.to_string().as_bytes(), pairs),
            }
        }
    }
}
