//! Pictures that answer a question at a glance, drawn from data of which some is measured once.

use std::path::Path;

use kane::figures::timed;
use kane::measure::chart::{Effort, Measured, chart, table};
use kane::measure::examine;
use kane::report::chart::{ChartReport, speed_accuracy, times};
use kane::report::stability::{StabilityReport, strips_picture};

use crate::NotMade;

/// Where the times of methods are kept.
pub const TIMES: &str = "docs/data/times.csv";

/// Speed against accuracy, with the times that are kept in the checkout.
///
/// # Errors
/// [`NotMade`] if there are none.
pub fn speed(root: &Path) -> Result<String, NotMade> {
    let kept = std::fs::read_to_string(root.join(TIMES));
    let kept = kept.map_err(|error| NotMade::because(TIMES, error))?;
    Ok(speed_of(table(), &kept))
}

/// Speed against accuracy of methods with these times.
#[must_use]
pub fn speed_of(table: Vec<Measured>, kept: &str) -> String {
    let with = timed(table, kept);
    let command = "kane chart".to_owned();
    speed_accuracy(&ChartReport { all: &with.methods, machine: with.machine, command })
}

/// Where the paper's formulas fail.
///
/// # Errors
/// [`NotMade`] if the paper cannot be read.
pub fn strips(root: &Path) -> Result<String, NotMade> {
    let name = "docs/derivations/oblique-collision.md";
    let bytes = std::fs::read(root.join(name)).map_err(|error| NotMade::because(name, error))?;
    let document = kane::audit::read("oblique-collision.md", &bytes)
        .map_err(|_| NotMade::because(name, "it is not well formed"))?;
    let stability = examine(&document, true, &mut |_, _| {});
    let command = "kane stability --full-line".to_owned();
    Ok(strips_picture(&StabilityReport { stability: &stability, accounts: &[], command }))
}

/// The methods, timed now on a machine that is named so: what is to be kept.
#[must_use]
pub fn times_now(machine: String) -> String {
    let all = chart(Effort::Full, &mut |_, _| {});
    times(&ChartReport { all: &all, machine, command: "kane chart".to_owned() })
}
