//! The cells of the matrix of laws and properties, out of its committed table.

use crate::NotMade;

/// The table of `docs/figures/matrix.csv`.
#[derive(Clone, Copy)]
pub(super) struct Cells<'a>(pub(super) &'a str);

/// One of them.
#[derive(Clone, Copy)]
pub(super) struct Cell<'a> {
    law: &'a str,
    property: &'a str,
    /// `proved`, `refuted`, …
    pub(super) finding: &'a str,
    /// why
    pub(super) reason: &'a str,
    line: usize,
}

impl<'a> Cells<'a> {
    fn all(self) -> impl Iterator<Item = Cell<'a>> {
        let cell = |(line, row): (usize, &'a str)| {
            let [law, property, finding, _, reason] =
                row.splitn(5, ',').collect::<Vec<_>>().try_into().ok()?;
            let reason = reason.trim_matches('"');
            Some(Cell { law, property, finding, reason, line: line + 1 })
        };
        self.0.lines().enumerate().skip(1).filter_map(cell)
    }

    /// The cell of a law and a property.
    pub(super) fn cell(self, law: &str, property: &str) -> Result<Cell<'a>, NotMade> {
        let found = self.all().find(|cell| cell.law == law && cell.property == property);
        found.ok_or_else(|| NotMade::because("verdict.md", format!("no cell {law}:{property}")))
    }

    /// The laws of which all these properties are proved, in the order of the table.
    pub(super) fn laws_with(self, properties: &[&str]) -> Vec<&'a str> {
        let mut laws: Vec<&str> = self.all().map(|cell| cell.law).collect();
        laws.dedup();
        let proved = |law: &str, property: &str| {
            self.cell(law, property).is_ok_and(|cell| cell.finding == "proved")
        };
        laws.retain(|law| properties.iter().all(|property| proved(law, property)));
        laws
    }
}

impl Cell<'_> {
    /// The finding with a link to its line.
    pub(super) fn link(self) -> String {
        format!("[{}](figures/matrix.csv#L{})", self.finding, self.line)
    }

    /// The same, if the finding is what a sentence says of it.
    pub(super) fn told(self, finding: &str) -> Result<String, NotMade> {
        if self.finding == finding {
            return Ok(self.link());
        }
        let why = format!("{}:{} is {}, not {finding}", self.law, self.property, self.finding);
        Err(NotMade::because("verdict.md", why))
    }
}
