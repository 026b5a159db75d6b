//! Columns of Arrow as rows of a log.

use datafusion::arrow::array::{
    Array as _, ArrayRef, AsArray as _, Float64Array, StringArray, StructArray,
};
use datafusion::arrow::compute::cast;
use datafusion::arrow::datatypes::{DataType, Float64Type};
use kane_records::header::Header;
use kane_records::reader::{Pairs, fill, number};
use kane_records::rejection::Reason;
use kane_records::row::Row;
use kane_records::schema::Field;

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
            DataType::Float64 => Self::Floats(column.as_primitive::<Float64Type>().clone()),
            _ => Self::Texts(column.as_string::<i32>().clone()),
        })
    }
}
