//! What a row costs, by how many there are in a batch.

use std::hint::black_box;
use std::time::Instant;

use kane_impact::batch::{self, Batched, Columns};
use kane_impact::laws::{GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerUncapped};
use kane_impact::{Alpha, ImpactLaw};

use super::Told;
use crate::chart::{Effort, Time};

/// Rows in the least batch, and the factor from one to the next.
const LEAST: usize = 100;
const FACTOR: usize = 10;
/// Rows that a turn takes at least, in passes over the batch.
const TURN: usize = 100_000;

/// One kernel over batches of growing length.
#[derive(Clone, Debug)]
pub struct Batch {
    /// the law's id, or what is done instead of a law
    pub name: &'static str,
    /// how it goes through the batch
    pub way: Way,
    /// the points, by rows
    pub points: Vec<Rows>,
}

/// A way through a batch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// the reads and writes without a law
    Memory,
    /// a kernel over columns
    Columns,
    /// one collision after the other
    Singly,
}

/// One batch.
#[derive(Clone, Debug)]
pub struct Rows {
    /// how many rows
    pub rows: usize,
    /// picoseconds a row
    pub time: Time,
}

/// A pass over the batch: α in, three columns out.
type Pass = fn(&[f64], &mut [Vec<f64>; 3]);

fn columns<L: Batched + Default>(alpha: &[f64], [k, impulse, energy]: &mut [Vec<f64>; 3]) {
    batch::evaluate(&L::default(), alpha, Columns { k, impulse, energy });
}

/// The same reads and writes without a law.
fn copies(alpha: &[f64], [k, impulse, energy]: &mut [Vec<f64>; 3]) {
    for (((alpha, k), impulse), energy) in alpha.iter().zip(k).zip(impulse).zip(energy) {
        (*k, *impulse, *energy) = (*alpha, *alpha, *alpha);
    }
}

/// The paper's law as its single lane says it, one collision after the other.
fn singly(alpha: &[f64], [k, impulse, energy]: &mut [Vec<f64>; 3]) {
    for (((alpha, k), impulse), energy) in alpha.iter().zip(k).zip(impulse).zip(energy) {
        if let Some(ratios) = WangSuLi.ratios(&Alpha::Finite(*alpha)) {
            (*k, *impulse, *energy) = (ratios.k, ratios.impulse, ratios.energy);
        }
    }
}

const PASSES: [(&str, Way, Pass); 7] = [
    ("reads and writes alone", Way::Memory, copies),
    ("wang-su-li", Way::Columns, columns::<WangSuLi>),
    ("whittaker-uncapped", Way::Columns, columns::<WhittakerUncapped>),
    ("walton", Way::Columns, columns::<Walton>),
    ("garwin-capped", Way::Columns, columns::<GarwinCapped>),
    ("smith-1991", Way::Columns, columns::<Smith1991>),
    ("wang-su-li, one by one", Way::Singly, singly),
];

/// Rows of the greatest batch, and rounds.
const fn plan(effort: Effort) -> (usize, usize) {
    match effort {
        Effort::Quick => (1_000_000, 5),
        Effort::Full => (10_000_000, 9),
    }
}

fn sizes(effort: Effort) -> impl Iterator<Item = usize> {
    let greatest = plan(effort).0;
    std::iter::successors(Some(LEAST), |rows| Some(rows * FACTOR))
        .take_while(move |rows| *rows <= greatest)
}

pub(super) fn steps(effort: Effort, timed: bool) -> usize {
    if timed { sizes(effort).count() * plan(effort).1 } else { 0 }
}

/// α between 2⁻⁸ and 2⁸ in an order that no processor guesses, so that a branch would show.
pub(super) fn alphas(rows: usize) -> Vec<f64> {
    let mut seed = 0x9e37_79b9_7f4a_7c15_u64;
    let mut draw = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let mixed = (seed ^ (seed >> 31)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        // the top twelve bits of the place are sign and exponent
        let place = (1023 - 8) << 52;
        f64::from_bits(place + (mixed >> 8))
    };
    (0..rows).map(|_| draw()).collect()
}

/// Times every pass at every size, turn by turn.
pub(super) fn batches(effort: Effort, told: &mut Told<'_>) -> Vec<Batch> {
    let rounds = plan(effort).1;
    let mut all: Vec<Batch> =
        PASSES.iter().map(|(name, way, _)| Batch { name, way: *way, points: Vec::new() }).collect();
    for rows in sizes(effort) {
        let alpha = alphas(rows);
        // written once, so that memory is there before the clock starts
        let mut out = [vec![1.0; rows], vec![1.0; rows], vec![1.0; rows]];
        let passes = (TURN / rows).max(1);
        let mut times = vec![Vec::new(); PASSES.len()];
        for round in 0..=rounds {
            for ((.., pass), times) in PASSES.iter().zip(&mut times) {
                let start = Instant::now();
                for _ in 0..passes {
                    pass(black_box(&alpha), black_box(&mut out));
                }
                let elapsed = start.elapsed().as_nanos().saturating_mul(1000);
                let rows = u128::try_from(passes * rows).unwrap_or(1);
                // the first round warms up
                if round > 0 {
                    times.push(u64::try_from(elapsed / rows).unwrap_or(u64::MAX));
                }
            }
            if round > 0 {
                told.step();
            }
        }
        for (batch, times) in all.iter_mut().zip(times) {
            batch.points.push(Rows { rows, time: Time::of(times) });
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inputs_lie_on_both_sides_of_every_guard_without_order() {
        let alpha = alphas(10_000);
        let (least, most) = (1.0 / 256.0, 256.0);
        assert!(alpha.iter().all(|alpha| (least..most).contains(alpha)));
        let changes = alpha.windows(2).filter(|pair| (pair[0] <= 0.5) != (pair[1] <= 0.5)).count();
        // a guess is wrong nearly as often as a coin: 2·7/16·9/16 of the time
        assert!((4_600..5_300).contains(&changes), "{changes}");
    }

    #[test]
    fn the_passes_do_what_they_are_named_for() {
        let alpha = alphas(100);
        let fresh = || [vec![9.0; 100], vec![9.0; 100], vec![9.0; 100]];
        let [mut batch, mut single, mut copied] = [fresh(), fresh(), fresh()];
        columns::<WangSuLi>(&alpha, &mut batch);
        singly(&alpha, &mut single);
        copies(&alpha, &mut copied);
        assert_eq!(batch[1..], single[1..]); // k has a bound of its own in columns
        assert_eq!(copied, [alpha.clone(), alpha.clone(), alpha]);
    }
}
