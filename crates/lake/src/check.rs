//! A log checked by a query.

use std::path::PathBuf;

use datafusion::arrow::array::AsArray as _;
use datafusion::arrow::array::{ArrayRef, StructArray};
use datafusion::prelude::{DataFrame, SessionConfig, SessionContext};
use kane_records::header::Header;
use kane_records::reader::Pairs;
use kane_records::row::Row;
use kane_records::study::Study;
use kane_records::told::Told;

use crate::aggregate::{SAMPLE, Whole};
use crate::columns::Columns;
use crate::fault::LakeFault;
use crate::log::{files, table};
use crate::numbers::Numbers;
use crate::register::register_for;
use crate::rewrite::Reading;
use crate::summary::Summary;

/// Rows of the first file that tell the format of numbers.
const AHEAD: usize = 1000;

/// The name of the table of a log.
pub const TABLE: &str = "log";

/// Opens a log in a session as the table [`TABLE`], and gives the session the functions, which know
/// what its columns are called and which format its numbers have: the stated one, or the one that the
/// first thousand rows of the first file tell, as `kane check` has it.
///
/// # Errors
/// [`LakeFault`] for files that cannot be read, or that lack columns of an impact.
pub async fn open(
    session: &SessionContext,
    given: &[PathBuf],
    reading: Reading,
) -> Result<Opened, LakeFault> {
    let files = files(given)?;
    session.state_ref().write().config_mut().options_mut().execution.collect_statistics = false;
    let log = table(session, &files).await?;
    let names: Vec<String> =
        log.schema().fields().iter().map(|field| field.name().clone()).collect();
    let header = Header::of(&names, &reading.map)?;
    let (numbers, stated) = match reading.numbers {
        Some(numbers) => (numbers, true),
        None => (Numbers::new(told(&files, &header).await?), false),
    };
    register_for(session, Reading { numbers: Some(numbers), ..reading })?;
    session.register_table(TABLE, log.into_view())?;
    Ok(Opened { header, numbers, stated })
}

/// A log in a session.
#[derive(Clone, Debug)]
pub struct Opened {
    /// its columns
    pub header: Header,
    /// the format of its numbers
    pub numbers: Numbers,
    /// whether that was stated
    pub stated: bool,
}

/// The format that the first rows of the first file tell. They are read here, whoever reads the log.
async fn told(files: &[PathBuf], header: &Header) -> Result<Told, LakeFault> {
    let session = SessionContext::new_with_config(
        SessionConfig::new().with_target_partitions(1).with_collect_statistics(false),
    );
    let first = files.get(..1).ok_or(LakeFault::NoLog)?;
    let log = table(&session, first).await?.limit(0, Some(AHEAD))?;
    let (mut rows, mut pairs) = (Vec::new(), Pairs::default());
    for batch in collected(log).await? {
        let mut fields = Vec::new();
        for (place, field) in header.fields.iter().enumerate() {
            if let Some(field) = field {
                let old = batch.schema_ref().field(place).clone();
                fields.push((old.with_name(field.name()).into(), batch.column(place).clone()));
            }
        }
        let array: ArrayRef = std::sync::Arc::new(StructArray::from(fields));
        let columns = Columns::of(&array)?;
        for at in 0..columns.rows() {
            let mut row = Row::empty(0);
            if columns.fill(at, &mut row, &mut pairs).is_ok() {
                rows.push(row);
            }
        }
    }
    Ok(Told::of(&rows))
}

async fn collected(
    frame: DataFrame,
) -> Result<Vec<datafusion::arrow::record_batch::RecordBatch>, LakeFault> {
    Ok(frame.collect().await?)
}

/// Checks the log that is [open](open) in a session, wherever the session has its queries run.
///
/// # Errors
/// [`LakeFault`] if the log breaks off or has no row.
pub async fn check(session: &SessionContext, log: &Opened) -> Result<Study, LakeFault> {
    let query = format!("SELECT {}() AS tally FROM {TABLE}", Whole::Tally.function());
    let mut whole = Summary::new(SAMPLE);
    for batch in collected(session.sql(&query).await?).await? {
        let parts = batch.column(0).as_binary_opt::<i32>();
        for part in parts.ok_or(LakeFault::Parts("a part is no summary"))?.iter().flatten() {
            whole.merge(Summary::from_bytes(part, SAMPLE)?)?;
        }
    }
    let mut study = whole.study()?;
    study.header = log.header.clone();
    study.format_stated = log.stated;
    Ok(study)
}
