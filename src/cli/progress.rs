//! A progress bar for audits that take long enough to make one wonder.

use std::io::{self, IsTerminal as _};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// How long an audit may run in silence.
const PATIENCE: Duration = Duration::from_secs(2);

/// How often the elapsed time moves on, also within a single long step.
const TICK: Duration = Duration::from_millis(200);

/// Shown on standard error, on a terminal alone, and only once patience has run out.
pub(super) struct Progress {
    /// `None` where nobody looks.
    bar: Option<ProgressBar>,
    over: Arc<Mutex<bool>>,
}

impl Progress {
    pub(super) fn new() -> Self {
        Self::counting("statements")
    }

    /// Counts something else.
    pub(super) fn counting(unit: &'static str) -> Self {
        let over = Arc::new(Mutex::new(false));
        let bar = io::stderr().is_terminal().then(|| hidden(unit));
        if let Some(bar) = bar.clone() {
            let over = Arc::clone(&over);
            thread::spawn(move || {
                thread::sleep(PATIENCE);
                // held, so that nothing is drawn after the end
                let over = over.lock().unwrap_or_else(PoisonError::into_inner);
                if !*over {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                    bar.enable_steady_tick(TICK);
                }
            });
        }
        Self { bar, over }
    }

    /// Takes note that `done` of `all` statements are judged, or whatever is counted.
    pub(super) fn update(&mut self, done: usize, all: usize) {
        if let Some(bar) = &self.bar {
            bar.set_length(u64::try_from(all).unwrap_or(u64::MAX));
            bar.set_position(u64::try_from(done).unwrap_or(u64::MAX));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        let mut over = self.over.lock().unwrap_or_else(PoisonError::into_inner);
        *over = true;
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn hidden(unit: &str) -> ProgressBar {
    let template = format!("{{bar:30}} {{pos}}/{{len}} {unit}, {{elapsed}}");
    let style = ProgressStyle::with_template(&template).expect("the template is well formed");
    ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden()).with_style(style)
}
