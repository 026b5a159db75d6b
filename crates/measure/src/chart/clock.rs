//! How long an evaluation takes, on this machine and now.

use std::time::{Duration, Instant};

use super::accuracy::inputs;
use super::method::Method;

/// How much time a chart may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// some seconds
    Quick,
    /// under a minute
    Full,
}

impl Effort {
    /// Rounds over all methods, and the least time of one method in a round.
    const fn plan(self) -> (usize, Duration) {
        match self {
            Self::Quick => (7, Duration::from_micros(500)),
            Self::Full => (25, Duration::from_millis(4)),
        }
    }
}

/// Picoseconds for one evaluation, over the rounds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Time {
    /// the median
    pub median: u64,
    /// the first and the third quartile
    pub quartiles: (u64, u64),
    /// how many rounds
    pub rounds: usize,
}

impl Time {
    /// The quartiles of readings.
    pub(crate) fn of(mut times: Vec<u64>) -> Self {
        times.sort_unstable();
        let at = |quarter: usize| times.get(times.len() * quarter / 4).copied().unwrap_or(0);
        Self { median: at(2), quartiles: (at(1), at(3)), rounds: times.len() }
    }
}

/// Inputs of a round.
const INPUTS: usize = 128;

/// Times the methods: a warm-up, then rounds in which each has its turn, so that what disturbs the
/// machine for a while disturbs all of them.
#[must_use]
pub fn clock(
    methods: &[&Method],
    effort: Effort,
    progress: &mut dyn FnMut(usize, usize),
) -> Vec<Time> {
    let prepared = |method: &&Method| {
        let all = inputs(method);
        let step = (all.len() / INPUTS).max(1);
        let some: Vec<f64> = all.into_iter().step_by(step).take(INPUTS).collect();
        (method.prepare(&some), some.len())
    };
    timed(methods.iter().map(prepared).collect(), effort, progress)
}

/// Something to be timed, and of how many evaluations it is made.
pub(crate) type Run<'a> = (Box<dyn Fn() + 'a>, usize);

/// Times runs in the same way.
pub(crate) fn timed(
    runs: Vec<Run<'_>>,
    effort: Effort,
    progress: &mut dyn FnMut(usize, usize),
) -> Vec<Time> {
    let (rounds, least) = effort.plan();
    let mut prepared = Vec::new();
    for (run, inputs) in runs {
        // the warm-up, which also says how often a turn repeats
        let start = Instant::now();
        let mut warm = 0_u64;
        while warm == 0 || start.elapsed() < least {
            run();
            warm += 1;
        }
        prepared.push((run, warm, u64::try_from(inputs).unwrap_or(1), Vec::new()));
    }
    for round in 0..rounds {
        progress(round, rounds);
        for (run, repeats, inputs, times) in &mut prepared {
            let start = Instant::now();
            for _ in 0..*repeats {
                run();
            }
            let nanoseconds = u64::try_from(start.elapsed().as_nanos()).unwrap_or(u64::MAX);
            times.push(nanoseconds.saturating_mul(1000) / (*repeats * *inputs).max(1));
        }
    }
    progress(rounds, rounds);
    prepared.into_iter().map(|(.., times)| Time::of(times)).collect()
}
