//! From floats to an exact Gram matrix: near the middle of the cone by rounding, on its boundary by
//! going into the face that the floats point to.

use kane_kernel::{Fuel, Poly};
use kane_semidefinite::{Center, Entry, Pencil, center, eigen, null_space, vanishing};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::elimination::{Column, Solution};
use super::gram::{Block, Gram};
use super::{Exact, Q, ldl};
use crate::work::FRACTION;

/// What became of a solution.
pub(super) enum Rounded {
    /// exact values
    Inside(Exact),
    /// smaller matrices, if the floats are right: several where they can be read in several ways
    Faces(Vec<Gram>),
}

/// Denominators to try: what people write first, then finer and finer grids.
const DENOMINATORS: [u64; 18] =
    [1, 2, 3, 4, 6, 8, 12, 24, 30, 60, 100, 360, 1024, 5040, 1 << 14, 1 << 18, 1 << 24, 1 << 30];
/// Newton steps of one search, at most.
const NEWTON: usize = 160;
/// How far from a float a rational number may be, as one part in so many, and its largest denominator: what
/// people write first, then what points leave whose coordinates are irrational.
const SIMPLE: [(u32, u32); 2] = [(300, 64), (20_000, 1000)];
/// Bits of a common denominator of such numbers.
const LONGEST: u64 = 40;
/// How far below its margin a rounded matrix may seem to floats, and still be tried exactly.
const SLACK: f64 = 1e-8;
/// Eigenvalues, relative to the largest one, that count as zero; tried in this order.
const ZEROS: [f64; 3] = [1e-5, 1e-4, 1e-3];

/// Rounds the middle of what a solution allows.
pub(super) fn rounded(gram: &Gram, solution: &Solution, fuel: &Fuel) -> Rounded {
    let (pencil, units) = pencil(gram, solution);
    let Some(found) = center(&pencil, &mut newton(&pencil, fuel)) else {
        return Rounded::Faces(Vec::new());
    };
    for denominator in DENOMINATORS {
        let exact = at(gram, solution, &pencil, (&found, &units), denominator, fuel);
        if let Some(exact) = exact {
            return Rounded::Inside(exact);
        }
    }
    let mut faces: Vec<Gram> = Vec::new();
    for simplicity in SIMPLE {
        for zero in ZEROS {
            faces.extend(
                face(gram, &pencil, &found, (zero, simplicity)).filter(|f| !faces.contains(f)),
            );
        }
    }
    Rounded::Faces(faces)
}

/// Whether the budget allows one more Newton step, which it pays for; each costs about k³/3 + 16·k² for
/// k parameters. In the operations of which the whole is a budget they are twice what they are among squares.
fn newton<'a>(pencil: &Pencil, fuel: &'a Fuel) -> impl FnMut() -> bool + use<'a> {
    let (k, n) = (pencil.directions.len() as u64, pencil.sizes.iter().sum::<usize>() as u64);
    let cost = (k * k * k / 3 + 16 * k * k + n * n * n) / 16 + 1;
    let pays = move || fuel.spend(cost / 4 + 1).and_then(|()| fuel.spend_beyond(cost / 4 + 1));
    let mut steps = 0..NEWTON;
    move || steps.next().is_some() && pays().is_ok()
}

/// The Gram matrices as floats, all parameters scaled to matter alike; and what one unit of each is.
fn pencil(gram: &Gram, solution: &Solution) -> (Pencil, Vec<Q>) {
    let entry = |(c, q): (usize, &Q)| match solution.columns[c] {
        Column::Entry { block, row, column } => Some((block, row, column, q.clone())),
        Column::Cofactor { .. } => None,
    };
    let largest = |entries: &[(usize, usize, usize, Q)]| {
        entries.iter().map(|e| e.3.abs()).max().filter(|q| !q.is_zero()).unwrap_or_else(Q::one)
    };
    let scaled = |entries: Vec<(usize, usize, usize, Q)>, by: &Q| -> Vec<Entry> {
        let scaled = entries.into_iter().map(|(block, row, column, q)| {
            let value = (q / by).to_f64().unwrap_or(0.0);
            Entry { block, row, column, value }
        });
        scaled.collect()
    };
    let constant: Vec<_> = solution.origin().filter_map(entry).collect();
    let size = largest(&constant);
    let (mut directions, mut units) = (Vec::new(), Vec::new());
    for direction in solution.directions() {
        let entries: Vec<_> = direction.iter().filter_map(|(c, q)| entry((*c, q))).collect();
        let own = largest(&entries);
        directions.push(scaled(entries, &own));
        units.push(&size / own);
    }
    (Pencil { sizes: gram.sizes(), constant: scaled(constant, &size), directions }, units)
}

/// The matrices with parameters rounded to multiples of 1/denominator, if they are what is needed.
fn at(
    gram: &Gram,
    solution: &Solution,
    pencil: &Pencil,
    (found, units): (&Center, &[Q]),
    denominator: u64,
    fuel: &Fuel,
) -> Option<Exact> {
    let grid = BigInt::from(denominator);
    let free: Vec<Q> = found
        .y
        .iter()
        .zip(units)
        .map(|(y, unit)| {
            let exact = Q::from_float(*y).unwrap_or_else(Q::zero) * unit;
            Q::new((exact * Q::from(grid.clone())).round().to_integer(), grid.clone())
        })
        .collect();
    let floats: Vec<f64> =
        free.iter().zip(units).map(|(q, unit)| (q / unit).to_f64().unwrap_or(0.0)).collect();
    if !pencil.is_nearly_definite(&floats, SLACK) {
        return None;
    }
    // Cubes of rows in fractions: not of the budget for squares, which counts what led here.
    let rows = gram.sizes().into_iter().map(|n| n as u64);
    fuel.spend_beyond(rows.map(|n| n * n * n * FRACTION / 3).sum()).ok()?;
    let values = solution.values(&free);
    let mut matrices: Vec<Vec<Vec<Q>>> =
        gram.sizes().iter().map(|&n| vec![vec![Q::zero(); n]; n]).collect();
    for (column, value) in solution.columns.iter().zip(&values) {
        if let Column::Entry { block, row, column } = column {
            matrices[*block][*row][*column] = value.clone();
            matrices[*block][*column][*row] = value.clone();
        }
    }
    let factors =
        matrices.into_iter().map(|m| ldl::factors(m, fuel)).collect::<Option<Vec<_>>>()?;
    Some(Exact { values, factors })
}

/// The bases without the directions in which the matrices vanish, if those look rational.
fn face(
    gram: &Gram,
    pencil: &Pencil,
    found: &Center,
    (zero, simplicity): (f64, (u32, u32)),
) -> Option<Gram> {
    let (mut blocks, mut smaller) = (Vec::new(), false);
    let matrices = pencil.at(&found.y, 0.0);
    let spectra: Vec<_> = matrices.iter().map(eigen).collect();
    let counts = vanishing(&spectra, zero);
    for ((block, spectrum), small) in gram.blocks.iter().zip(&spectra).zip(counts) {
        if small == 0 {
            blocks.push(block.clone());
            continue;
        }
        smaller = true;
        let (pivots, rows) = null_space(&spectrum.vectors[..small])?;
        let rows: Vec<Vec<Q>> = rows
            .iter()
            .map(|row| row.iter().map(|x| simple(*x, simplicity)).collect::<Option<_>>())
            .collect::<Option<_>>()?;
        let basis: Vec<Poly> = (0..block.basis.len())
            .filter(|i| !pivots.contains(i))
            .map(|i| combination(block, i, &pivots, &rows))
            .collect::<Option<_>>()?;
        if !basis.is_empty() {
            blocks.push(Block { product: block.product, basis });
        }
    }
    (smaller && !blocks.is_empty()).then(|| Gram { blocks, ..gram.clone() })
}

/// bᵢ − Σ rowᵢ·b over the pivots, in integers: what is orthogonal to the rows. `None` where so many denominators show that
/// the rows are none that people would write.
fn combination(block: &Block, i: usize, pivots: &[usize], rows: &[Vec<Q>]) -> Option<Poly> {
    let common = rows.iter().fold(BigInt::one(), |l, row| l.lcm(row[i].denom()));
    if common.bits() > LONGEST {
        return None;
    }
    let mut out = block.basis[i].scale(&common);
    for (pivot, row) in pivots.iter().zip(rows) {
        let by = (&row[i] * Q::from(common.clone())).to_integer();
        out = out.add(&block.basis[*pivot].scale(&-by));
    }
    Some(out.primitive().1)
}

/// The simplest rational number near a float, if it is simple.
fn simple(x: f64, (near, most): (u32, u32)) -> Option<Q> {
    let (exact, near) = (Q::from_float(x)?, Q::new(1.into(), near.into()));
    let between =
        crate::sign_table::simplest_between(Some(&(&exact - &near)), Some(&(&exact + &near)));
    (between.denom() <= &BigInt::from(most)).then_some(between)
}
