//! Logs of impacts: from text, or from columns that NumPy owns.

use kane_impact::laws;
use kane_records::format::NoFormat;
use kane_records::reader::Kind;
use kane_records::study::{Options, Study, study};
use kane_records::table::{Cells, Table, study_table};
use kane_report::records::{RecordsReport, json, sheet};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::away::away;
use crate::bad_input;
use crate::columns::filled;

/// What is asked: names of the schema and of the log, the format of the numbers, the extent in arms.
type Asked = (Vec<(String, String)>, Option<String>, Option<f64>);

/// A report: JSON, HTML, text, and whether all is as expected.
type Told = (String, String, String, bool);

/// Studies a log in CSV or JSON lines.
///
/// # Errors
/// `ValueError` if there is nothing that could be checked.
#[pyfunction]
pub(crate) fn check_text(
    py: Python<'_>,
    text: String,
    name: String,
    json_lines: bool,
    asked: Asked,
) -> PyResult<Told> {
    let kind = if json_lines { Kind::JsonLines } else { Kind::Csv };
    let options = options(asked)?;
    away(py, move |_| {
        let study = study(text.as_bytes(), kind, &options).map_err(bad_input)?;
        Ok(told(&study, &name))
    })?
}

/// Studies a table: columns of numbers, each with a mask of the cells that are missing (empty for none),
/// and columns of words.
///
/// # Errors
/// As of [`check_text`], and for columns of several lengths.
#[pyfunction]
pub(crate) fn check_columns(
    py: Python<'_>,
    numbers: Vec<(String, PyReadonlyArray1<'_, f64>, Vec<bool>)>,
    words: Vec<(String, Vec<Option<String>>)>,
    name: &str,
    asked: Asked,
) -> PyResult<Told> {
    let options = options(asked)?;
    let mut table = Table::default();
    for (name, values, missing) in &numbers {
        let values = filled(values).map_err(|why| bad_input(format!("{name}: {why}")))?;
        table.push(name, Cells::Numbers { values, missing });
    }
    for (name, values) in &words {
        table.push(name, Cells::Words(values));
    }
    py.detach(|| {
        let study = study_table(&table, &options).map_err(bad_input)?;
        Ok(told(&study, name))
    })
}

fn options((map, float, extent): Asked) -> PyResult<Options<'static>> {
    let mut options = Options::new(laws());
    options.map = map;
    let format = float.as_deref().map(str::parse).transpose();
    options.format = format.map_err(|wrong: NoFormat| bad_input(format!("float is {wrong}")))?;
    if let Some(extent) = extent {
        if !(0.0..=1e12).contains(&extent) {
            return Err(bad_input("extent must be between 0 and 1e12 arms"));
        }
        options.extent = extent;
    }
    Ok(options)
}

fn told(study: &Study, name: &str) -> Told {
    let command = format!("kane.check({name})");
    let report = RecordsReport { study, log: name, command: &command };
    let sheet = sheet(&report);
    let text = sheet.text(kane_report::Page::default());
    (json(&report), sheet.html(), text, study.rows > 0 && study.as_expected())
}
