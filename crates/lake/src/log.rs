//! Files of a log as a table.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufRead as _, BufReader, ErrorKind, Read as _, Seek as _, SeekFrom};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use datafusion::arrow::datatypes::{DataType, Field, Schema};
use datafusion::datasource::file_format::options::ArrowReadOptions;
use datafusion::prelude::{CsvReadOptions, DataFrame, ParquetReadOptions, SessionContext};
use kane_records::header::HeaderFault;
use kane_records::opening::opening;
use kane_records::quotes::Quotes;
use kane_records::reader::{Kind, names};
use url::Url;

use crate::fault::LakeFault;

/// The form of a file, by the end of its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Parquet,
    Arrow,
    Csv,
}

/// The files of a log: those that are given, and those of a known form in directories that are.
///
/// # Errors
/// [`LakeFault`] for a file that cannot be read, is of another form than the first, or is a Parquet
/// file that is not whole.
pub fn files(given: &[PathBuf]) -> Result<Vec<PathBuf>, LakeFault> {
    let mut files = Vec::new();
    for path in given {
        let io = |error| LakeFault::Io(path.clone(), error);
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let mut inside = Vec::new();
        for entry in std::fs::read_dir(path).map_err(io)? {
            inside.push(entry.map_err(io)?.path());
        }
        inside.retain(|path| path.is_file() && form(path).is_ok());
        inside.sort();
        files.append(&mut inside);
    }
    let first = files.first().ok_or(LakeFault::NoLog)?;
    let wanted = form(first)?;
    for path in &files {
        if form(path)? != wanted || ending(path) != ending(first) {
            return Err(LakeFault::TwoForms(first.clone(), path.clone()));
        }
        File::open(path).map_err(|error| LakeFault::Io(path.clone(), error))?;
        if wanted == Form::Parquet {
            whole(path)?;
        }
    }
    Ok(files)
}

/// The table of these [`files`].
///
/// Columns that mean something to the checks are numbers or words whatever the first rows of a CSV file
/// look like; the type of others is told by its first thousand rows.
///
/// # Errors
/// [`LakeFault`] for what the query engine cannot read.
pub async fn table(session: &SessionContext, files: &[PathBuf]) -> Result<DataFrame, LakeFault> {
    let first = files.first().ok_or(LakeFault::NoLog)?;
    let paths: Vec<String> = files.iter().map(|path| absolute(path)).collect::<Result<_, _>>()?;
    let ending = format!(".{}", ending(first));
    Ok(match form(first)? {
        Form::Parquet => {
            let options = ParquetReadOptions::default().file_extension(&ending);
            session.read_parquet(paths, options).await?
        }
        Form::Arrow => {
            let options = ArrowReadOptions { file_extension: &ending, ..Default::default() };
            session.read_arrow(paths, options).await?
        }
        Form::Csv => {
            let delimiter = delimiter(first)?;
            let mut goes_on = false;
            for path in files {
                names_differ(path)?;
                goes_on |= quotes_close(path, delimiter)?;
            }
            let options = CsvReadOptions::new()
                .file_extension(&ending)
                .delimiter(delimiter)
                .newlines_in_values(goes_on)
                .comment(b'#');
            let told = session.read_csv(paths.clone(), options.clone()).await?;
            let wide = widened(told.schema().as_arrow());
            session.read_csv(paths, options.schema(&wide)).await?
        }
    })
}

/// Integers are floats: a column that begins with them need not end with them.
fn widened(schema: &Schema) -> Schema {
    let fields = schema.fields().iter().map(|field| match field.data_type() {
        kind if kind.is_integer() => Arc::new(Field::new(field.name(), DataType::Float64, true)),
        _ => Arc::clone(field),
    });
    Schema::new(fields.collect::<Vec<_>>())
}

fn ending(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().into_owned()
}

fn form(path: &Path) -> Result<Form, LakeFault> {
    Ok(match &*ending(path).to_ascii_lowercase() {
        "parquet" | "pq" => Form::Parquet,
        "arrow" | "feather" | "ipc" => Form::Arrow,
        "csv" | "tsv" | "txt" => Form::Csv,
        _ => return Err(LakeFault::Form(path.to_owned())),
    })
}

/// The file by a name that means the same to every process of a cluster on shared storage, and in
/// which no character is a wildcard.
fn absolute(path: &Path) -> Result<String, LakeFault> {
    let io = |error| LakeFault::Io(path.to_owned(), error);
    let whole = path.canonicalize().map_err(io)?;
    let url = Url::from_file_path(whole);
    Ok(url.map_err(|()| io(ErrorKind::InvalidFilename.into()))?.to_string())
}

/// That a Parquet file begins and ends as one: one that was cut off lacks its end, where all is told.
fn whole(path: &Path) -> Result<(), LakeFault> {
    let io = |error| LakeFault::Io(path.to_owned(), error);
    let mut file = File::open(path).map_err(io)?;
    let length = file.metadata().map_err(io)?.len();
    if length < 12 {
        return Err(LakeFault::Truncated(path.to_owned(), "it is too short"));
    }
    let mut mark = [0; 4];
    file.read_exact(&mut mark).map_err(io)?;
    if &mark != b"PAR1" {
        return Err(LakeFault::Truncated(path.to_owned(), "it does not begin as one"));
    }
    let mut footer = [0; 4];
    file.seek(SeekFrom::End(-8)).map_err(io)?;
    file.read_exact(&mut footer).map_err(io)?;
    file.read_exact(&mut mark).map_err(io)?;
    if &mark != b"PAR1" {
        return Err(LakeFault::Truncated(path.to_owned(), "its end is missing"));
    }
    if u64::from(u32::from_le_bytes(footer)) > length - 12 {
        let what = "its end says that it is longer than the file";
        return Err(LakeFault::Truncated(path.to_owned(), what));
    }
    Ok(())
}

/// That every quote of a CSV file is closed, which the query engine does not ask: it would make one cell of all lines
/// behind one that is open. Whether a cell goes on in another line, so that the file cannot be cut at line ends.
fn quotes_close(path: &Path, delimiter: u8) -> Result<bool, LakeFault> {
    let io = |error| LakeFault::Io(path.to_owned(), error);
    let mut quotes = Quotes::new(File::open(path).map_err(io)?, delimiter);
    let mut buffer = vec![0; 1 << 18];
    while quotes.read(&mut buffer).map_err(io)? > 0 {}
    Ok(quotes.goes_on())
}

/// That no two columns of a CSV file have one name; the query engine would count them as one.
fn names_differ(path: &Path) -> Result<(), LakeFault> {
    let io = |error| LakeFault::Io(path.to_owned(), error);
    let (start, _) = opening(BufReader::new(File::open(path).map_err(io)?)).map_err(io)?;
    let mut places = BTreeMap::new();
    for (name, place) in names(&start, Kind::Csv).into_iter().zip(1..) {
        if let Some(first) = places.get(&name) {
            return Err(HeaderFault::OneName(name, *first, place).into());
        }
        places.insert(name, place);
    }
    Ok(())
}

/// What separates the cells of the first line that is no comment.
fn delimiter(path: &Path) -> Result<u8, LakeFault> {
    let io = |error| LakeFault::Io(path.to_owned(), error);
    let mut file = BufReader::new(File::open(path).map_err(io)?);
    let mut line = Vec::new();
    loop {
        line.clear();
        if file.read_until(b'\n', &mut line).map_err(io)? == 0 || !line.starts_with(b"#") {
            break;
        }
    }
    let count = |byte: u8| line.iter().filter(|&&other| other == byte).count();
    Ok([b',', b';', b'\t'].into_iter().rev().max_by_key(|&byte| count(byte)).unwrap_or(b','))
}
