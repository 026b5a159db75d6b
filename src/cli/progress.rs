//! A progress bar for audits that take long enough to make one wonder.

use std::io::{self, IsTerminal as _};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// How long an audit may run in silence.
const PATIENCE: Duration = Duration::from_secs(2);

/// Shown on standard error, on a terminal alone, and only once patience has run out.
pub(super) struct Progress {
    start: Instant,
    listens: bool,
    bar: Option<ProgressBar>,
    unit: &'static str,
}

impl Progress {
    pub(super) fn new() -> Self {
        Self::counting("statements")
    }

    /// Counts something else.
    pub(super) fn counting(unit: &'static str) -> Self {
        Self { start: Instant::now(), listens: io::stderr().is_terminal(), bar: None, unit }
    }

    /// Takes note that `done` of `all` statements are judged, or whatever is counted.
    pub(super) fn update(&mut self, done: usize, all: usize) {
        if !self.listens || (self.bar.is_none() && self.start.elapsed() < PATIENCE) {
            return;
        }
        let bar = self.bar.get_or_insert_with(|| bar(self.unit));
        bar.set_length(u64::try_from(all).unwrap_or(u64::MAX));
        bar.set_position(u64::try_from(done).unwrap_or(u64::MAX));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn bar(unit: &str) -> ProgressBar {
    let template = format!("{{bar:30}} {{pos}}/{{len}} {unit}, {{elapsed}}");
    let style = ProgressStyle::with_template(&template).expect("the template is well formed");
    ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).with_style(style)
}
