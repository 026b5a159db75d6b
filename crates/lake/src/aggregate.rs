//! The functions of many rows.

use std::hash::{Hash, Hasher};
use std::sync::Arc;

use datafusion::arrow::array::{Array as _, ArrayRef, AsArray as _};
use datafusion::arrow::datatypes::{DataType, Field, FieldRef};
use datafusion::common::{Result, ScalarValue};
use datafusion::logical_expr::function::{AccumulatorArgs, StateFieldsArgs};
use datafusion::logical_expr::utils::format_state_name;
use datafusion::logical_expr::{Accumulator, AggregateUDF, AggregateUDFImpl, Signature};
use kane_records::format::Format;
use kane_records::told::Told;
use kane_report::records::{RecordsReport, headline, json};

use crate::columns::Columns;
use crate::fault::LakeFault;
use crate::numbers::Numbers;
use crate::scalar::{numbers, signature};
use crate::summary::Summary;

/// Rows on which attribution rests, of a whole log.
pub(crate) const SAMPLE: usize = 10_000;
/// The same where there may be many groups.
const SAMPLE_OF_GROUP: usize = 1000;

/// What an aggregate function gives of its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Whole {
    /// all that is kept of them, as bytes of [`Summary`]
    Tally,
    /// the sentence that says what they follow
    Sentence,
    /// the report of `kane check` on them, as JSON
    Report,
}

impl Whole {
    /// Every function of many rows.
    pub const ALL: [Self; 3] = [Self::Tally, Self::Sentence, Self::Report];

    /// The name of its function.
    #[must_use]
    pub const fn function(self) -> &'static str {
        match self {
            Self::Tally => "kane_tally",
            Self::Sentence => "kane_sentence",
            Self::Report => "kane_report",
        }
    }

    /// What it gives, in a line.
    #[must_use]
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Tally => "what `kane-lake check` keeps of rows, as bytes",
            Self::Sentence => "what the rows follow, in a sentence",
            Self::Report => "the report of `kane check` on the rows, as JSON",
        }
    }

    const fn room(self) -> usize {
        match self {
            Self::Tally => SAMPLE,
            Self::Sentence | Self::Report => SAMPLE_OF_GROUP,
        }
    }
}

#[derive(Debug)]
struct WholeFunction {
    whole: Whole,
    signature: Signature,
}

impl PartialEq for WholeFunction {
    fn eq(&self, other: &Self) -> bool {
        self.whole == other.whole
    }
}

impl Eq for WholeFunction {}

impl Hash for WholeFunction {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.whole.hash(state);
    }
}

/// All functions of many rows.
#[must_use]
pub fn aggregate_functions() -> Vec<Arc<AggregateUDF>> {
    let function =
        |whole| Arc::new(AggregateUDF::from(WholeFunction { whole, signature: signature() }));
    Whole::ALL.into_iter().map(function).collect()
}

impl AggregateUDFImpl for WholeFunction {
    fn name(&self) -> &str {
        self.whole.function()
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, _: &[DataType]) -> Result<DataType> {
        Ok(match self.whole {
            Whole::Tally => DataType::Binary,
            Whole::Sentence | Whole::Report => DataType::Utf8,
        })
    }

    fn accumulator(&self, _: AccumulatorArgs<'_>) -> Result<Box<dyn Accumulator>> {
        Ok(Box::new(Gathering { whole: self.whole, summary: Summary::new(self.whole.room()) }))
    }

    fn state_fields(&self, args: StateFieldsArgs<'_>) -> Result<Vec<FieldRef>> {
        let name = format_state_name(args.name, "summary");
        Ok(vec![Arc::new(Field::new(name, DataType::Binary, true))])
    }
}

/// Adds up rows and parts.
#[derive(Debug)]
struct Gathering {
    whole: Whole,
    summary: Summary,
}

impl Gathering {
    fn evaluated(&self) -> Result<ScalarValue, LakeFault> {
        if self.whole == Whole::Tally {
            return Ok(ScalarValue::Binary(Some(self.summary.to_bytes())));
        }
        if self.summary.log.is_none() {
            return Ok(ScalarValue::Utf8(None));
        }
        let study = self.summary.clone().study()?;
        Ok(ScalarValue::Utf8(Some(match self.whole {
            Whole::Report => {
                json(&RecordsReport { study: &study, log: "log", command: "kane-lake sql" })
            }
            _ => headline(&study),
        })))
    }
}

impl Accumulator for Gathering {
    fn update_batch(&mut self, values: &[ArrayRef]) -> Result<()> {
        let Some(rows) = values.first() else {
            let name = self.whole.function();
            let message = format!(
                "{name}() was not given its columns: register the functions in this session"
            );
            return Err(LakeFault::Argument(message).into());
        };
        if rows.is_empty() {
            return Ok(());
        }
        let constant =
            values.get(1).map(|array| ScalarValue::try_from_array(array, 0)).transpose()?;
        let numbers: Numbers = match &constant {
            None => Numbers::new(Told::stated(Format::Binary64)),
            constant => numbers(constant.as_ref())?,
        };
        Ok(self.summary.add(&Columns::of(rows)?, numbers)?)
    }

    fn evaluate(&mut self) -> Result<ScalarValue> {
        Ok(self.evaluated()?)
    }

    fn size(&self) -> usize {
        self.summary.size()
    }

    fn state(&mut self) -> Result<Vec<ScalarValue>> {
        Ok(vec![ScalarValue::Binary(Some(self.summary.to_bytes()))])
    }

    fn merge_batch(&mut self, states: &[ArrayRef]) -> Result<()> {
        let Some(parts) = states.first().and_then(|states| states.as_binary_opt::<i32>()) else {
            return Err(LakeFault::Parts("a part is no summary").into());
        };
        for part in parts.iter().flatten() {
            self.summary.merge(Summary::from_bytes(part, self.whole.room())?)?;
        }
        Ok(())
    }
}
