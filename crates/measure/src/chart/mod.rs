//! Speed against accuracy: what the next digit costs.

mod accuracy;
mod clock;
mod cost;
mod method;
mod proved;
mod registry;

pub(crate) use accuracy::right;
pub use accuracy::{Accuracy, accuracy};
pub use clock::{Effort, Time, clock};
pub(crate) use clock::{Run, timed};
pub use cost::cost;
pub use method::{Answer, FormNumber, Method};
pub use proved::Proved;
pub use registry::{DOMAIN, registry};

use crate::rounding_bounds;

/// One method with all that is known of it.
#[derive(Clone, Debug)]
pub struct Measured {
    /// the method
    pub method: Method,
    /// how accurate it is; `None` if the system cannot evaluate it
    pub accuracy: Accuracy,
    /// the operations, weighted; `None` for a law's own code, whose operations are not counted
    pub cost: Option<u64>,
    /// the bound on its error that is proved; `None` where none is
    pub proved: Option<Proved>,
    /// how long an evaluation took; `None` where nothing was timed
    pub time: Option<Time>,
}

/// The error of every method and its cost by counting, without a clock. Deterministic; in the order
/// of the registry. Methods that a system cannot evaluate, such as roots in rationals, are left out.
#[must_use]
pub fn table() -> Vec<Measured> {
    let bounds = rounding_bounds();
    let of = |method: Method| {
        let accuracy = accuracy(&method)?;
        let proved = Proved::of(&method, &bounds, &accuracy);
        Some(Measured { cost: cost(&method), method, accuracy, proved, time: None })
    };
    registry().into_iter().filter_map(of).collect()
}

/// The same with the time that each takes on this machine.
#[must_use]
pub fn chart(effort: Effort, progress: &mut dyn FnMut(usize, usize)) -> Vec<Measured> {
    let mut all = table();
    let methods: Vec<&Method> = all.iter().map(|measured| &measured.method).collect();
    let times = clock(&methods, effort, progress);
    for (measured, time) in all.iter_mut().zip(times) {
        measured.time = Some(time);
    }
    all
}

/// Which methods no other for the same quantity of the same law beats in one respect without being
/// worse in the other: by time where there is one, otherwise by the counted cost.
#[must_use]
pub fn front(all: &[Measured]) -> Vec<bool> {
    let price = |m: &Measured| match &m.time {
        Some(time) => Some(time.median),
        None => m.cost.map(|cost| cost.saturating_mul(1000)),
    };
    let beats = |a: &Measured, b: &Measured| match (price(a), price(b)) {
        (Some(x), Some(y)) => {
            let (p, q) = (a.accuracy.worst, b.accuracy.worst);
            x <= y && p >= q && (x < y || p > q)
        }
        _ => false,
    };
    let same = |a: &Measured, b: &Measured| {
        (a.method.law, a.method.quantity) == (b.method.law, b.method.quantity)
    };
    all.iter()
        .map(|m| price(m).is_some() && !all.iter().any(|other| same(other, m) && beats(other, m)))
        .collect()
}

/// How far apart two counted costs must be before the clock is expected to agree.
const CLEAR: u64 = 4;

/// Pairs, by index, whose counted costs are clearly one way and whose times are the other way: the
/// first counts as cheaper and took longer.
#[must_use]
pub fn contradictions(all: &[Measured]) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    for (i, a) in all.iter().enumerate() {
        for (j, b) in all.iter().enumerate() {
            let (Some(x), Some(y)) = (a.cost, b.cost) else { continue };
            let (Some(s), Some(t)) = (&a.time, &b.time) else { continue };
            // by the quartiles, so that noise alone does not contradict
            if x.saturating_mul(CLEAR) <= y && s.quartiles.0 > t.quartiles.1 {
                found.push((i, j));
            }
        }
    }
    found
}
