//! What can go wrong between a log and its answer.

use std::io;
use std::path::PathBuf;

use datafusion::common::SchemaError;
use datafusion::error::DataFusionError;
use kane_records::header::HeaderFault;

use crate::numbers::NoNumbers;

/// Why there is no answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LakeFault {
    /// A file that cannot be read.
    #[error("cannot read {0}: {1}")]
    Io(PathBuf, io::Error),
    /// A Parquet file that does not begin and end as one.
    #[error("{0} is no whole Parquet file: {1}")]
    Truncated(PathBuf, &'static str),
    /// A file whose form is not known by its name.
    #[error(
        "{0}: what form is it? .parquet, .pq, .arrow, .feather, .csv, .tsv and .txt are known; JSON lines are read by `kane check`"
    )]
    Form(PathBuf),
    /// Files of two forms at once.
    #[error("{0} and {1} are of two forms; give logs of one form at a time")]
    TwoForms(PathBuf, PathBuf),
    /// No file at all.
    #[error("no log was given, or its directory has none")]
    NoLog,
    /// A table without the columns of an impact, or with columns that cannot be told.
    #[error(transparent)]
    Header(#[from] HeaderFault),
    /// Two columns have one name, which no query can tell apart.
    #[error("two columns are both called `{0}`: rename one of them in the file")]
    OneName(String),
    /// A format of numbers that is none.
    #[error(transparent)]
    Numbers(#[from] NoNumbers),
    /// A function was not given a struct of columns.
    #[error("{0}")]
    Argument(String),
    /// Two parts of a log were summed up with different formats or columns, or by different versions.
    #[error("parts of the log do not belong together: {0}")]
    Parts(&'static str),
    /// What the query engine says.
    #[error("{0}")]
    Engine(#[source] DataFusionError),
}

impl From<DataFusionError> for LakeFault {
    fn from(error: DataFusionError) -> Self {
        if let DataFusionError::SchemaError(schema, _) = error.find_root()
            && let SchemaError::DuplicateUnqualifiedField { name }
            | SchemaError::DuplicateQualifiedField { name, .. } = &**schema
        {
            return Self::OneName(name.clone());
        }
        Self::Engine(error)
    }
}

impl From<LakeFault> for DataFusionError {
    fn from(fault: LakeFault) -> Self {
        match fault {
            LakeFault::Engine(error) => error,
            other => Self::External(Box::new(other)),
        }
    }
}
