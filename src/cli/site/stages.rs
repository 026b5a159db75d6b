//! The stages of making a site, and how long each took.

use std::time::{Duration, Instant};

use crate::cli::output;

/// What is said of a stage only if it took so long.
const PATIENCE: Duration = Duration::from_secs(2);

/// The stages that are over.
#[derive(Default)]
pub(super) struct Stages {
    over: Vec<(&'static str, Duration)>,
}

/// What a stage made, and how long it took.
pub(super) struct Timed<T> {
    name: &'static str,
    made: T,
    took: Duration,
}

/// Does a stage and looks at the clock.
pub(super) fn timed<T>(name: &'static str, stage: impl FnOnce() -> T) -> Timed<T> {
    let start = Instant::now();
    let made = stage();
    Timed { name, made, took: start.elapsed() }
}

impl Stages {
    /// Takes note of a stage, and says so if it was long.
    pub(super) fn took<T>(&mut self, timed: Timed<T>) -> T {
        if timed.took >= PATIENCE {
            output::to_stderr(&format!("{}: {}\n", timed.name, seconds(timed.took)));
        }
        self.over.push((timed.name, timed.took));
        timed.made
    }

    /// Does a stage, and takes note of it.
    pub(super) fn take<T>(&mut self, name: &'static str, stage: impl FnOnce() -> T) -> T {
        self.took(timed(name, stage))
    }

    /// Says what took how long, the longest first.
    pub(super) fn finish(mut self) {
        self.over.sort_by_key(|(_, took)| std::cmp::Reverse(*took));
        let told: Vec<String> =
            self.over.iter().map(|(name, took)| format!("{name} {}", seconds(*took))).collect();
        output::to_stderr(&format!("took: {}\n", told.join(", ")));
    }
}

/// Seconds with one decimal.
fn seconds(took: Duration) -> String {
    let tenths = took.as_millis() / 100;
    format!("{}.{} s", tenths / 10, tenths % 10)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_returns_what_it_made_and_is_noted() {
        let mut stages = Stages::default();
        assert_eq!(stages.take("one", || 7), 7);
        assert_eq!(stages.over.len(), 1);
        assert_eq!(seconds(Duration::from_millis(12_345)), "12.3 s");
    }
}
