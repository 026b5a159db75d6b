//! The figures: the laws over α with what was measured, how far models are from each other, and where
//! energy is created.
//!
//! Here numbers are gathered; [`report::figures`](crate::report::figures) draws them.

pub mod experiment;
mod model_error;
mod over_alpha;
mod puzzle_map;
mod times;

use kane_impact::compliant::NoOutcome;
use kane_report::figures::{Axis, Figure};

pub use times::{Times, timed};

/// The tables behind the last two figures, as CSV. To compute them takes half a minute, so that the
/// program carries them with it.
#[derive(Clone, Copy, Debug)]
pub struct Tables<'a> {
    /// k by the elastic half-space over α, and by how much k of others exceeds it
    pub model_error: &'a str,
    /// where in the plane of friction and restitution a law creates energy
    pub energy_map: &'a str,
}

impl Tables<'static> {
    /// Those in `docs/data`.
    pub const CARRIED: Self = Self {
        model_error: include_str!("../../docs/data/model-error.csv"),
        energy_map: include_str!("../../docs/data/kane-puzzle.csv"),
    };
}

/// Figures 3, 4 and 5 of Wang, Su and Li with all laws, the model error, and the map of Kane's puzzle;
/// `progress` is told how much is done, and of how much. Deterministic.
///
/// The curves of the laws are exact, rounded once to the floats that are drawn; those of the
/// half-space are *heuristic*, see [`compliant`](kane_impact::compliant).
///
/// # Errors
/// [`NoOutcome`] if the elastic half-space finds no outcome within its budget.
pub fn figures(progress: &mut dyn FnMut(usize, usize)) -> Result<Vec<Figure>, NoOutcome> {
    of_tables(&Tables::CARRIED, progress)
}

/// The same figures with other tables.
///
/// # Errors
/// [`NoOutcome`] if the elastic half-space finds no outcome within its budget.
pub fn of_tables(
    tables: &Tables<'_>,
    progress: &mut dyn FnMut(usize, usize),
) -> Result<Vec<Figure>, NoOutcome> {
    let [slip, impulse, friction] = over_alpha::figures(progress)?;
    let model_error = model_error::figure(tables.model_error);
    Ok(vec![slip, impulse, friction, model_error, puzzle_map::figure(tables.energy_map)])
}

/// α on a logarithmic axis that bears a number at every first, second and fifth.
fn alpha(from: f64, to: f64) -> Axis {
    let ticks = [0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];
    Axis {
        symbol: "alpha",
        label: "α, collision parameter (dimensionless, logarithmic)".to_owned(),
        range: (from, to),
        ticks: ticks.into_iter().filter(|tick| from <= *tick && *tick <= to).collect(),
        is_logarithmic: true,
    }
}

/// The rows of a table that the program carries with it: without comments, the line of names first.
fn rows(table: &str) -> impl Iterator<Item = Vec<&str>> {
    table.lines().filter(|line| !line.starts_with('#')).map(|line| line.split(',').collect())
}

/// A number of such a table.
fn number(cell: &str) -> f64 {
    cell.parse().expect("the tables that are carried along hold numbers")
}
