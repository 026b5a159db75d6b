//! The Rust side of `crates/python/benches/batch.py`: runs a law over a column of α when asked, and says how long it took.
//!
//! Each line on the standard input is `law rows passes samples new`; the answer is a line with the nanoseconds of the best
//! sample, which is so many passes. With `new` = 1 each pass makes the columns of its results, with 0 it writes over those
//! of the one before.

use std::hint::black_box;
use std::io::{BufRead, Write};
use std::time::Instant;

use kane_impact::batch::{self, Batched, Columns};
use kane_impact::laws::{
    GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerStop, WhittakerUncapped,
};

type Lane = fn(&[f64], Columns<'_>);

fn lane<L: Batched + Default>() -> (&'static str, Lane) {
    (L::INFO.id, |alpha, out| batch::evaluate(&L::default(), alpha, out))
}

fn made(rows: usize) -> [Vec<f64>; 3] {
    // every page is there before a pass writes, as it is of columns that were used before
    [vec![1.0; rows], vec![1.0; rows], vec![1.0; rows]]
}

fn pass(lane: Lane, alpha: &[f64], [k, impulse, energy]: &mut [Vec<f64>; 3]) {
    lane(black_box(alpha), Columns { k, impulse, energy });
}

fn timed(lane: Lane, [rows, passes, samples]: [usize; 3], new: bool) -> u128 {
    let step = 4.0 / rows as f64;
    let alpha: Vec<f64> = (0..rows).map(|row| row as f64 * step).collect();
    let mut columns = made(rows);
    pass(lane, &alpha, &mut columns);
    let mut sample = || {
        let start = Instant::now();
        for _ in 0..passes {
            if new {
                // zeros that the system gives when they are written, as of `numpy.empty`
                columns = [vec![0.0; rows], vec![0.0; rows], vec![0.0; rows]];
            }
            pass(lane, &alpha, &mut columns);
            black_box(&columns);
        }
        start.elapsed().as_nanos()
    };
    (0..samples).map(|_| sample()).min().unwrap_or_default()
}

fn main() {
    let lanes = [
        lane::<WangSuLi>(),
        lane::<WhittakerUncapped>(),
        lane::<WhittakerStop>(),
        lane::<Walton>(),
        lane::<GarwinCapped>(),
        lane::<Smith1991>(),
    ];
    for line in std::io::stdin().lock().lines().map_while(Result::ok) {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [law, counts @ ..] = words.as_slice() else { continue };
        let counts: Vec<usize> = counts.iter().filter_map(|count| count.parse().ok()).collect();
        match (lanes.iter().find(|(id, _)| id == law), counts.as_slice()) {
            (Some((_, lane)), [rows, passes, samples, new]) => {
                println!("{}", timed(*lane, [*rows, *passes, *samples], *new == 1));
            }
            _ => println!("expected: law rows passes samples new"),
        }
        _ = std::io::stdout().flush();
    }
}
