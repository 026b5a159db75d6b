//! Columns of Arrow as rows of a log.

use datafusion::arrow::array::{
    Array as _, ArrayRef, AsArray as _, Float64Array, StringArray, StructArray,
};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Float64Type};
use kane_records::header::Header;
use kane_records::reader::{Pairs, fill, is_plain, number};
use kane_records::rejection::Reason;
use kane_records::row::Row;
use kane_records::schema::Field;

use crate::choice::{START, numbered};
use crate::fault::LakeFault;

/// The columns of a batch, each with what it is. The fields of a struct are called as the columns of a
/// log are, by any of their spellings.
pub(crate) struct Columns {
    pub(crate) header: Header,
    pub(crate) names: Vec<String>,
    cells: Vec<(Field, Cells)>,
    rows: usize,
}

/// A column.
enum Cells {
    /// numbers, all of which can stand in a row
    Plain(usize, Float64Array),
    /// numbers and gaps
    Floats(Float64Array),
    Texts(StringArray),
}

impl Columns {
    /// The columns of a struct. Numbers of other types are taken as binary64, which holds all but
    /// integers above 2^53 and decimals, which are rounded.
    pub(crate) fn of(array: &ArrayRef) -> Result<Self, LakeFault> {
        let of = array.as_struct_opt().ok_or_else(|| {
            let kind = array.data_type();
            LakeFault::Argument(format!(
                "a struct of the columns of a log is asked for, and not {kind}"
            ))
        })?;
        Self::of_struct(of)
    }

    fn of_struct(array: &StructArray) -> Result<Self, LakeFault> {
        let names: Vec<String> = array.fields().iter().map(|field| field.name().clone()).collect();
        let header = Header::of(&names, &[])?;
        let mut cells = Vec::new();
        for (field, column) in header.fields.iter().zip(array.columns()) {
            if let Some(field) = field {
                cells.push((*field, Cells::of(*field, column)?));
            }
        }
        Ok(Self { header, names, cells, rows: array.len() })
    }

    /// How many rows there are.
    pub(crate) const fn rows(&self) -> usize {
        self.rows
    }

    /// The row at a place, into `row`; its line is not known.
    ///
    /// # Errors
    /// [`Reason`] for a cell that is none of its column.
    pub(crate) fn fill(&self, at: usize, row: &mut Row, pairs: &mut Pairs) -> Result<(), Reason> {
        row.clear(0);
        for (field, cells) in &self.cells {
            match (field, cells) {
                (_, Cells::Plain(place, floats)) => row.set_place(*place, floats.value(at)),
                (Field::Number(column), Cells::Floats(floats)) => {
                    if floats.is_valid(at) {
                        number(row, *column, floats.value(at))?;
                    }
                }
                (_, Cells::Texts(texts)) => {
                    if texts.is_valid(at) {
                        fill(row, *field, texts.value(at).as_bytes(), pairs)?;
                    }
                }
                // words are never columns of floats, see below
                (Field::Word(_), Cells::Floats(_)) => {}
            }
        }
        Ok(())
    }

    /// The hash of each row's numbers, as [`hash`](crate::choice::hash) has it, column by column: rows do not
    /// wait for each other, where the numbers of one row do. None where a number stands as text.
    pub(crate) fn hashes(&self) -> Option<Vec<u64>> {
        let mut hashes = vec![START; self.rows];
        let mut by_place: Vec<&(Field, Cells)> = self.cells.iter().collect();
        by_place.sort_by_key(|(field, _)| place(*field));
        for (field, cells) in by_place {
            match (field, cells) {
                (_, Cells::Plain(place, floats)) => {
                    for (hash, value) in hashes.iter_mut().zip(floats.values()) {
                        *hash = numbered(*hash, *place, *value);
                    }
                }
                (Field::Number(column), Cells::Floats(floats)) => {
                    for (hash, value) in hashes.iter_mut().zip(floats) {
                        *hash = value.map_or(*hash, |value| numbered(*hash, column.index(), value));
                    }
                }
                (Field::Number(_), Cells::Texts(_)) => return None,
                (Field::Word(_), _) => {}
            }
        }
        Some(hashes)
    }
}

/// The place of a number, and behind all numbers that of words.
const fn place(field: Field) -> usize {
    match field {
        Field::Number(column) => column.index(),
        Field::Word(_) => usize::MAX,
    }
}

impl Cells {
    fn of(field: Field, column: &ArrayRef) -> Result<Self, LakeFault> {
        let texts = matches!(
            column.data_type(),
            DataType::Utf8 | DataType::LargeUtf8 | DataType::Utf8View | DataType::Dictionary(..)
        );
        let wanted = match field {
            Field::Number(_) if !texts => DataType::Float64,
            _ => DataType::Utf8,
        };
        let column = cast(column, &wanted).map_err(datafusion::error::DataFusionError::from)?;
        Ok(match wanted {
            DataType::Float64 => {
                let floats = column.as_primitive::<Float64Type>().clone();
                if floats.null_count() == 0 && floats.values().iter().all(|x| is_plain(*x)) {
                    Self::Plain(place(field), floats)
                } else {
                    Self::Floats(floats)
                }
            }
            _ => Self::Texts(column.as_string::<i32>().clone()),
        })
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use datafusion::arrow::datatypes::{Field as Named, Fields};

    use super::*;
    use crate::choice::{hash, worded};

    fn columns(cells: Vec<(&str, ArrayRef)>) -> Columns {
        let (names, cells): (Vec<&str>, Vec<ArrayRef>) = cells.into_iter().unzip();
        let fields = names.iter().zip(&cells);
        let fields: Fields = fields
            .map(|(name, cells)| Named::new(*name, cells.data_type().clone(), true))
            .collect();
        Columns::of_struct(&StructArray::new(fields, cells, None)).expect("a log")
    }

    fn floats(cells: impl IntoIterator<Item = Option<f64>>) -> ArrayRef {
        Arc::new(cells.into_iter().collect::<Float64Array>())
    }

    fn texts(cells: [&str; 4]) -> ArrayRef {
        Arc::new(StringArray::from(cells.to_vec()))
    }

    /// Columns in no order of places, a gap, an infinity, words, and a number that may be a text.
    fn log(mu: ArrayRef) -> Columns {
        let plain = |first: f64| floats((0..4).map(|row| Some(first - f64::from(row))));
        columns(vec![
            ("omega_post", plain(2.0)),
            ("shape", texts(["disc", "hoop", "disc", "hoop"])),
            ("vy_pre", plain(-1.0)),
            ("mass", floats([Some(1.0), Some(2.0), None, Some(f64::INFINITY)])),
            ("material", texts(["steel", "ice", "", "steel"])),
            ("mu", mu),
            ("radius", plain(9.0)),
            ("vx_pre", plain(-0.0)),
            ("omega_pre", plain(0.0)),
            ("vx_post", plain(0.5)),
            ("vy_post", plain(1e100)),
            ("inertia", plain(1e100)),
        ])
    }

    #[test]
    fn hashes_by_columns_are_those_of_the_rows() {
        let log = log(floats([Some(0.3), None, Some(0.1), Some(0.2)]));
        let by_column = log.hashes().expect("all numbers are numbers");
        let (mut row, mut pairs) = (Row::empty(0), Pairs::default());
        for (at, pair) in ["steel", "ice", ""].into_iter().enumerate() {
            assert_eq!(log.fill(at, &mut row, &mut pairs), Ok(()));
            assert_eq!(worded(by_column[at], &row, pair), hash(&row, pair), "row {at}");
        }
        assert!(matches!(log.fill(3, &mut row, &mut pairs), Err(Reason::NotFinite(_))));
    }

    #[test]
    fn numbers_that_stand_as_text_have_no_hash_by_columns() {
        assert_eq!(log(texts(["0.3", "", "1", "2"])).hashes(), None);
    }
}
