//! The ranges on which a formula fails, with their edges by bisection on representable numbers.

use crate::{Axis, Fault, Format};

use super::scan::{Probe, Tried};
use super::{Point, Range};

/// Sound samples in a row that end a range: about three binades.
const GAP: usize = 24;
/// Binades beyond an edge in which lost digits are looked for, and tries in them.
const BINADES_BEYOND: u64 = 3;
const TRIES: u64 = 384;
/// How often an edge is moved out.
const MOVES: usize = 12;

/// All ranges, by their least input, the worse fault first. None leaves the axis.
pub(super) fn ranges<F: Format>(
    probe: &Probe<'_, F>,
    axis: &Axis,
    samples: &[Tried],
) -> Vec<Range> {
    let mut ranges = Vec::new();
    for fault in Fault::ALL {
        let mut start: Option<(usize, usize)> = None;
        for (index, tried) in samples.iter().enumerate() {
            if tried.sample.fault == Some(fault) {
                start = Some((start.map_or(index, |(first, _)| first), index));
            } else if let Some((first, last)) = start
                && index - last > GAP
                && tried.place - samples.get(last).map_or(0, |s| s.place) > near::<F>()
            {
                ranges.extend(range(probe, axis, samples, fault, (first, last)));
                start = None;
            }
        }
        if let Some((first, last)) = start {
            ranges.extend(range(probe, axis, samples, fault, (first, last)));
        }
    }
    ranges.sort_by_key(|range| (range.fault, range.from.place));
    let mut merged: Vec<Range> = Vec::new();
    for range in ranges {
        match merged.last_mut() {
            Some(last) if last.fault == range.fault && range.from.place <= last.to.place => {
                if range.to.place > last.to.place {
                    last.to = range.to;
                    last.open.1 = range.open.1;
                }
                if range.lost > last.lost {
                    (last.worst, last.lost) = (range.worst, range.lost);
                    (last.computed, last.exact) = (range.computed, range.exact);
                }
            }
            _ => merged.push(range),
        }
    }
    merged.sort_by_key(|range| (range.from.place, range.to.place, std::cmp::Reverse(range.fault)));
    merged
}

/// Places so close together that what is between does not part two ranges: a 64th of a binade.
fn near<F: Format>() -> u64 {
    1 << (F::PRECISION - 7)
}

fn range<F: Format>(
    probe: &Probe<'_, F>,
    axis: &Axis,
    samples: &[Tried],
    fault: Fault,
    (first, last): (usize, usize),
) -> Option<Range> {
    let place = |index: usize| samples.get(index).map(|tried| tried.place);
    let is_bad = |place: u64| {
        axis.holds(place) && probe.ask(place).is_some_and(|t| t.sample.fault == Some(fault))
    };
    let below = first.checked_sub(1).and_then(place);
    let above = place(last + 1);
    let mut tried = vec![];
    let from = edge::<F>(&is_bad, place(first)?, below, fault, &mut tried);
    let to = edge::<F>(&is_bad, place(last)?, above, fault, &mut tried);
    tried.extend([from, to]);
    let inside = samples.get(first..=last)?.iter().copied();
    let all = inside.chain(tried.into_iter().filter_map(|place| probe.ask(place)));
    let bad = all.filter(|tried| tried.sample.fault == Some(fault));
    let worst = bad.max_by_key(|tried| (tried.sample.lost, u64::MAX - tried.place))?;
    let computed = probe.computed(worst.place);
    let exact = probe.exact(worst.place);
    Some(Range {
        fault,
        from: Point::of::<F>(probe.negative, from),
        to: Point::of::<F>(probe.negative, to),
        open: (below.is_none() || from == axis.first, above.is_none() || to == axis.last),
        worst: Point::of::<F>(probe.negative, worst.place),
        lost: worst.sample.lost,
        computed: computed.map_or_else(|| "no value".to_owned(), |float| format!("{float:e}")),
        exact: exact.map_or_else(String::new, |exact| exact.rounded_to::<F>()),
        cause: String::new(),
        better: None,
    })
}

/// The outermost bad place, given one and a sound place beyond it, which is bad's neighbour in the
/// end. If there is no place beyond, the range ends with the domain.
fn edge<F: Format>(
    is_bad: &impl Fn(u64) -> bool,
    bad: u64,
    beyond: Option<u64>,
    fault: Fault,
    tried: &mut Vec<u64>,
) -> u64 {
    let Some(beyond) = beyond else { return bad };
    let up = beyond > bad;
    let mut bad = bisect(is_bad, bad, beyond);
    if fault != Fault::Lost {
        return bad;
    }
    // near its edge a loss comes and goes: look for the last one
    let reach = BINADES_BEYOND << (F::PRECISION - 1);
    for _ in 0..MOVES {
        let mut outermost = None;
        for step in 1..=TRIES {
            // finely nearby and evenly further out
            let distance = if step <= 64 { step } else { reach / TRIES * step + step * step };
            let place =
                if up { bad.saturating_add(distance) } else { bad.saturating_sub(distance) };
            if place < F::infinity_bits() && place > 0 && is_bad(place) {
                outermost = Some(place);
            }
        }
        let Some(place) = outermost else { break };
        tried.push(place);
        let next = if up { place + 1 } else { place - 1 };
        let mut width = 1_u64;
        let mut sound = next;
        while is_bad(sound) {
            width *= 2;
            sound = if up { place.saturating_add(width) } else { place.saturating_sub(width) };
        }
        bad = bisect(is_bad, place, sound);
    }
    bad
}

/// The bad one of two neighbours between a bad place and a sound one.
fn bisect(is_bad: &impl Fn(u64) -> bool, mut bad: u64, mut sound: u64) -> u64 {
    while bad.abs_diff(sound) > 1 {
        let middle = bad.min(sound) + bad.abs_diff(sound) / 2;
        if is_bad(middle) { bad = middle } else { sound = middle }
    }
    bad
}
