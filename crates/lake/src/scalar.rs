//! The functions of one row.

use std::hash::{Hash, Hasher};
use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, BooleanBuilder, Float64Builder, StringBuilder};
use datafusion::arrow::datatypes::DataType;
use datafusion::common::{Result, ScalarValue};
use datafusion::logical_expr::{
    ColumnarValue, ScalarFunctionArgs, ScalarUDF, ScalarUDFImpl, Signature, TypeSignature,
    Volatility,
};
use kane_records::case::Case;
use kane_records::check::Check;
use kane_records::format::Format;
use kane_records::reader::Pairs;
use kane_records::row::Row;
use kane_records::told::Told;

use crate::columns::Columns;
use crate::fault::LakeFault;
use crate::numbers::Numbers;
use crate::quantity::Asked;

/// What every function takes: nothing, which is filled in from the table, or a struct of columns, and
/// perhaps the format of their numbers.
pub(crate) fn signature() -> Signature {
    let counts = vec![TypeSignature::Nullary, TypeSignature::Any(1), TypeSignature::Any(2)];
    Signature::one_of(counts, Volatility::Immutable)
}

/// A function of one row.
#[derive(Debug)]
struct RowFunction {
    name: String,
    asked: Asked,
    signature: Signature,
}

impl PartialEq for RowFunction {
    fn eq(&self, other: &Self) -> bool {
        self.asked == other.asked
    }
}

impl Eq for RowFunction {}

impl Hash for RowFunction {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.asked.hash(state);
    }
}

/// All functions of one row.
#[must_use]
pub fn scalar_functions() -> Vec<Arc<ScalarUDF>> {
    let function = |asked: Asked| {
        let name = asked.function();
        Arc::new(ScalarUDF::from(RowFunction { name, asked, signature: signature() }))
    };
    Asked::all().into_iter().map(function).collect()
}

/// The format that a constant names.
pub(crate) fn numbers(constant: Option<&ScalarValue>) -> Result<Numbers, LakeFault> {
    match constant {
        None => Ok(Numbers::new(Told::stated(Format::Binary64))),
        Some(
            ScalarValue::Utf8(Some(text))
            | ScalarValue::LargeUtf8(Some(text))
            | ScalarValue::Utf8View(Some(text)),
        ) => Ok(text.parse()?),
        Some(other) => {
            Err(LakeFault::Argument(format!("a format of numbers is a constant text, not {other}")))
        }
    }
}

impl ScalarUDFImpl for RowFunction {
    fn name(&self) -> &str {
        &self.name
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, _: &[DataType]) -> Result<DataType> {
        Ok(match self.asked {
            Asked::Quantity(_) | Asked::Residual(_) => DataType::Float64,
            Asked::Holds(_) => DataType::Boolean,
            Asked::Fails | Asked::Rejected => DataType::Utf8,
        })
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        let Some(rows) = args.args.first() else {
            let message = format!(
                "{}() was not given its columns: register the functions in this session",
                self.name
            );
            return Err(LakeFault::Argument(message).into());
        };
        let columns = Columns::of(&rows.to_array(args.number_rows)?)?;
        let constant = match args.args.get(1) {
            None => None,
            Some(ColumnarValue::Scalar(value)) => Some(value.clone()),
            Some(ColumnarValue::Array(array)) => Some(ScalarValue::try_from_array(array, 0)?),
        };
        let precision = numbers(constant.as_ref())?.precision();
        let spatial = columns.header.is_spatial();
        let (mut row, mut pairs) = (Row::empty(0), Pairs::default());
        let mut each = |at: usize, take: &mut dyn FnMut(Result<&Case<'_>, String>)| {
            let filled = columns.fill(at, &mut row, &mut pairs);
            match filled.and_then(|()| Case::of(&row, spatial, &precision)) {
                Ok(case) => take(Ok(&case)),
                Err(reason) => take(Err(reason.to_string())),
            }
        };
        let places = 0..columns.rows();
        let array: ArrayRef = match self.asked {
            Asked::Quantity(quantity) => {
                let mut out = Float64Builder::with_capacity(columns.rows());
                places.for_each(|at| {
                    each(at, &mut |case| {
                        out.append_option(case.ok().and_then(|case| quantity.of(case)));
                    });
                });
                Arc::new(out.finish())
            }
            Asked::Residual(check) => {
                let mut out = Float64Builder::with_capacity(columns.rows());
                places.for_each(|at| {
                    each(at, &mut |case| {
                        let finding = case.ok().and_then(|case| case.finding(check));
                        out.append_option(finding.map(|finding| finding.residual));
                    });
                });
                Arc::new(out.finish())
            }
            Asked::Holds(check) => {
                let mut out = BooleanBuilder::with_capacity(columns.rows());
                places.for_each(|at| {
                    each(at, &mut |case| {
                        let finding = case.ok().and_then(|case| case.finding(check));
                        out.append_option(finding.and_then(|finding| finding.holds()));
                    });
                });
                Arc::new(out.finish())
            }
            Asked::Fails => {
                let mut out = StringBuilder::new();
                places.for_each(|at| {
                    each(at, &mut |case| out.append_option(case.ok().map(failing)));
                });
                Arc::new(out.finish())
            }
            Asked::Rejected => {
                let mut out = StringBuilder::new();
                places.for_each(|at| each(at, &mut |case| out.append_option(case.err())));
                Arc::new(out.finish())
            }
        };
        Ok(ColumnarValue::Array(array))
    }
}

/// The checks that a row fails, by name.
fn failing(case: &Case<'_>) -> String {
    let fails = |check: &Check| case.finding(*check).is_some_and(|finding| finding.fails());
    let names: Vec<&str> = Check::ALL.into_iter().filter(fails).map(Check::id).collect();
    names.join(" ")
}
