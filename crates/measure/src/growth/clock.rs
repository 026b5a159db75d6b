//! One piece of work by the clock.

use std::time::{Duration, Instant};

/// Turns beyond the first, and how long a turn lasts at least.
const TURNS: usize = 5;
const TURN: Duration = Duration::from_micros(100);
/// What takes longer is read three times in all, and once where it takes much longer.
const LONG: Duration = Duration::from_millis(20);
const VERY_LONG: Duration = Duration::from_millis(500);

fn picoseconds(elapsed: Duration) -> u64 {
    u64::try_from(elapsed.as_nanos().saturating_mul(1000)).unwrap_or(u64::MAX)
}

/// The result, and, if `timed`, the picoseconds that it took: the median of several turns, or for
/// very long work the first reading.
pub(super) fn reading<T>(timed: bool, run: impl Fn() -> T) -> (T, Option<u64>) {
    let start = Instant::now();
    let result = run();
    let first = start.elapsed();
    if !timed {
        return (result, None);
    }
    if first > VERY_LONG {
        return (result, Some(picoseconds(first)));
    }
    if first > LONG {
        let again = || {
            let start = Instant::now();
            std::hint::black_box(run());
            picoseconds(start.elapsed())
        };
        let mut times = [picoseconds(first), again(), again()];
        times.sort_unstable();
        return (result, Some(times[1]));
    }
    let repeats = (TURN.as_nanos() / first.as_nanos().max(1)).clamp(1, 1000);
    let repeats = u64::try_from(repeats).unwrap_or(1);
    let mut times: Vec<u64> = (0..TURNS)
        .map(|_| {
            let start = Instant::now();
            for _ in 0..repeats {
                std::hint::black_box(run());
            }
            picoseconds(start.elapsed()) / repeats
        })
        .collect();
    times.sort_unstable();
    (result, times.get(TURNS / 2).copied())
}
