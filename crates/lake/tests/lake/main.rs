//! Logs in Parquet, Arrow and CSV are checked as `kane check` checks them, whoever reads them.

mod faults;
mod functions;
mod same_answer;

use std::path::{Path, PathBuf};

use datafusion::arrow::array::{Array as _, AsArray as _};
use datafusion::dataframe::DataFrameWriteOptions;
use datafusion::prelude::{SessionConfig, SessionContext};
use kane_lake::{Opened, Reading, open};

/// The small logs of engines that `kane_records` is tested on.
const LOGS: [&str; 5] = [
    "box2d-2.3.10_v2x_above_threshold",
    "mujoco-4.0.0_default",
    "pymunk-7.3.1_default",
    "rapier2d-0.34.0_tight",
    "rapier2d-0.36.1_tight",
];

fn recorded(name: &str) -> PathBuf {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../records/tests/data");
    data.join(format!("{name}.csv"))
}

fn session(parts: usize) -> SessionContext {
    let config = SessionConfig::new().with_target_partitions(parts).with_batch_size(64);
    SessionContext::new_with_config(config)
}

/// A session in which the log is open.
async fn opened(log: &Path, parts: usize) -> (SessionContext, Opened) {
    let session = session(parts);
    let log = open(&session, &[log.to_owned()], Reading::default()).await.expect("it is a log");
    (session, log)
}

/// Writes what a query gives into a directory, as Parquet.
async fn parquet(session: &SessionContext, query: &str, into: &Path) {
    let frame = session.sql(query).await.expect("it is a query");
    let options = DataFrameWriteOptions::new();
    frame.write_parquet(&into.to_string_lossy(), options, None).await.expect("it can be written");
}

/// The one column of the answer, as text; nulls are empty.
async fn column(session: &SessionContext, query: &str) -> Vec<String> {
    let frame = session.sql(query).await.expect("it is a query");
    let batches = frame.collect().await.expect("it has an answer");
    let mut texts = Vec::new();
    for batch in batches {
        let column = datafusion::arrow::compute::cast(
            batch.column(0),
            &datafusion::arrow::datatypes::DataType::Utf8,
        );
        let column = column.expect("it is shown");
        let column = column.as_string::<i32>();
        texts.extend(column.iter().map(|text| text.unwrap_or_default().to_owned()));
        assert_eq!(column.len(), batch.num_rows());
    }
    texts
}
