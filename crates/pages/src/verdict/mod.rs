//! `docs/verdict.md`: Kane's puzzle, answered on one page. No number is typed: each is computed here, and
//! the page cannot be made if a verdict is not what a sentence says of it.

mod cells;
mod claims;
mod mechanics;
mod puzzle;
mod reality;

use std::path::Path;

use crate::NotMade;
use cells::Cells;

/// The page, from the checkout at `root` and the table of the matrix.
///
/// # Errors
/// [`NotMade`] if a document cannot be read, or a verdict is not what the page says of it.
pub fn verdict(root: &Path, matrix: &str) -> Result<String, NotMade> {
    let cells = Cells(matrix);
    let reality = reality::section(cells)?;
    let parts = [
        HEAD.to_owned(),
        puzzle::section(root)?,
        mechanics::algebra(root)?,
        mechanics::not_unique(root, cells)?,
        reality.text.clone(),
        mechanics::coupled(root, cells)?,
        mechanics::choice(cells, &reality)?,
        mechanics::open()?,
    ];
    Ok(parts.join("\n"))
}

const HEAD: &str = "\
<!-- Made by crates/pages/src/verdict from the laws, the audits and the measured points: cargo run --release -p kane-pages -->

# Kane's puzzle, answered

In short: the paper's formulas for a sphere follow from its ansatz, and create no energy. But the ansatz is a choice among many that do the same, measured spheres do not follow it, and on contacts that couple, as Kane's does, it can leave the friction cone, and gain energy unless restitution is Newton's. The puzzle has older answers that need no ansatz: friction followed as a process, with Poisson's or energetic restitution.
";

/// Names with equal values together, in the order in which they come.
fn groups<'a, V: PartialEq + Clone>(names: &[&'a str], values: &[V]) -> Vec<(Vec<&'a str>, V)> {
    let mut groups: Vec<(Vec<&str>, V)> = Vec::new();
    for (name, value) in names.iter().zip(values) {
        match groups.iter_mut().find(|(_, known)| known == value) {
            Some((names, _)) => names.push(name),
            None => groups.push((vec![name], value.clone())),
        }
    }
    groups
}

/// A law's id with a link to what is said of it.
fn law_link(id: &str) -> String {
    format!("[{id}](laws.md#{id})")
}

/// Decimals with a minus as it is printed.
fn signed(x: f64, decimals: usize) -> String {
    format!("{x:.decimals$}").replace('-', "−")
}
