//! What of `docs` is made from data: pages, tables and figures.
//!
//! `cargo run --release -p kane-pages` writes all of it; the tests only compare. Everything is
//! deterministic, and the numbers are those that the program computes for its users.

mod glance;
mod laws;
mod model_error;
mod puzzle;
mod verdict;

use std::fmt;
use std::path::Path;

use kane::figures::Tables;
use kane::impact::laws as all_laws;
use kane::matrix::{Matrix, Selection, matrix};
use kane::report::chart::committed;
use kane::report::figures::{csv, svg};
use kane::report::matrix::{self as shown, MatrixReport};
use kane::report::scene::{stress_csv, stress_picture};
use kane::scene::stress;

pub use glance::{TIMES, speed, speed_of, strips, times_now};
pub use laws::{Docstring, docstrings, laws};
pub use model_error::model_error;
pub use puzzle::energy_map;
pub use verdict::verdict;

/// A file of the documentation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Page {
    /// its path in the checkout
    pub path: String,
    /// what it holds
    pub text: String,
}

/// A page that could not be made, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotMade(String);

impl NotMade {
    pub(crate) fn because(page: &str, why: impl fmt::Display) -> Self {
        Self(format!("{page}: {why}"))
    }
}

impl fmt::Display for NotMade {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for NotMade {}

/// All pages of the checkout at `root`, which is read for the prose in them: the laws' docstrings, and
/// the head of the page of properties. Takes a minute.
///
/// # Errors
/// [`NotMade`].
pub fn pages(root: &Path) -> Result<Vec<Page>, NotMade> {
    let page = |path: &str, text: String| Page { path: path.to_owned(), text };
    let (model_error, energy_map) = (model_error()?, energy_map()?);
    let tables = Tables { model_error: &model_error, energy_map: &energy_map };
    let mut all = figures(&tables)?;
    all.push(page("docs/figures/speed-accuracy.svg", speed(root)?));
    all.push(page("docs/figures/formula-failures.svg", strips(root)?));
    all.push(page("docs/data/model-error.csv", model_error));
    all.push(page("docs/data/kane-puzzle.csv", energy_map));
    all.push(page("docs/data/methods.csv", committed(&kane::measure::chart::table())));
    all.push(page("docs/laws.md", laws(root)?));
    all.push(page("docs/properties.md", properties(root)?));
    for bound in kane::measure::rounding_bounds() {
        all.push(page(&format!("docs/rounding/{}.g", bound.name()), bound.gappa()));
    }
    for (name, schema) in kane_report::schemas() {
        let text = serde_json::to_string_pretty(&schema);
        let text = text.map_err(|error| NotMade::because(name, error))? + "\n";
        all.push(page(&format!("docs/schema/{name}.json"), text));
    }
    let rows = stress::rows(all_laws());
    let picture = stress_picture(&rows);
    all.push(page("docs/data/scene-stress.csv", stress_csv(&rows)));
    all.push(page("docs/data/scene-stress.svg", picture));
    let matrix = figure_of(&matrix(all_laws(), &Selection::default(), &mut |_, _| {}));
    all.push(page("docs/verdict.md", verdict(root, &matrix[1].text)?));
    all.extend(matrix);
    Ok(all)
}

/// The figures over α, the model error and the map, as pictures with their data.
fn figures(tables: &Tables<'_>) -> Result<Vec<Page>, NotMade> {
    let figures = kane::figures::of_tables(tables, &mut |_, _| {});
    let figures = figures.map_err(|error| NotMade::because("docs/figures", error))?;
    let mut pages = Vec::new();
    for figure in &figures {
        let path = |ending| format!("docs/figures/{}.{ending}", figure.stem);
        let picture = svg(figure);
        pages.push(Page { path: path("svg"), text: picture });
        pages.push(Page { path: path("csv"), text: csv(figure) });
    }
    Ok(pages)
}

/// The matrix of laws and properties, as a picture with its data.
fn figure_of(matrix: &Matrix) -> [Page; 2] {
    let report = MatrixReport { matrix, command: "kane laws".to_owned() };
    let picture = shown::picture(&report);
    let page = |ending: &str, text| Page { path: format!("docs/figures/matrix.{ending}"), text };
    [page("svg", picture), page("csv", shown::csv(&report))]
}

/// The page of properties: its head as it is, and the table and all below it made anew.
fn properties(root: &Path) -> Result<String, NotMade> {
    let path = root.join("docs/properties.md");
    let page = std::fs::read_to_string(path).map_err(|e| NotMade::because("properties.md", e))?;
    let head = page.split("| column |").next().unwrap_or_default();
    Ok(format!("{head}{}", shown::properties()))
}
