//! Times of methods that were taken once, on a machine that is named: for a figure that is the same in every run.

use kane_measure::chart::{Measured, Time};

/// Methods with times, and the machine on which these were taken.
#[derive(Clone, Debug)]
pub struct Times {
    /// the methods, those that were timed with their times
    pub methods: Vec<Measured>,
    /// the machine, in words
    pub machine: String,
}

/// The methods of a table with the times of `docs/data/times.csv`: a line `# machine`, a line of names, then law,
/// quantity, name, system, and the quartiles in picoseconds with the number of rounds. A method without a line has no
/// time.
#[must_use]
pub fn timed(table: Vec<Measured>, times: &str) -> Times {
    let machine = times.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or_default();
    let rows: Vec<Vec<&str>> = super::rows(times).skip(1).collect();
    let time = |measured: &Measured| {
        let method = &measured.method;
        let system = method.system.to_string();
        let is_its = |row: &&Vec<&str>| {
            row.get(..4) == Some(&[method.law, method.quantity, method.name, system.as_str()])
        };
        let row = rows.iter().find(is_its)?;
        let number = |column: usize| row.get(column).and_then(|cell| cell.parse().ok());
        let rounds = row.get(7).and_then(|cell| cell.parse().ok())?;
        Some(Time { median: number(5)?, quartiles: (number(4)?, number(6)?), rounds })
    };
    let methods = table.into_iter().map(|one| Measured { time: time(&one), ..one }).collect();
    Times { methods, machine: machine.to_owned() }
}
