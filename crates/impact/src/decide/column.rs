//! Decisions over columns: the filter for a block of rows without a branch, the rest for those in doubt.

use std::cmp::Ordering;

use super::filter::{Filter, is_usual};
use super::question::{Question, Sliding};
use super::{Shares, decide};
use crate::InvalidInput;
use crate::bodies::{Motion, SphereOnPlane};

const BLOCK: usize = 64;

/// Spheres that meet a plane, column by column; fields and units as in [`SphereOnPlane`].
#[derive(Clone, Copy, Debug)]
pub struct Spheres<'a> {
    /// m > 0, kg.
    pub mass: &'a [f64],
    /// r > 0, m.
    pub radius: &'a [f64],
    /// J > 0, kg·m².
    pub inertia: &'a [f64],
    /// μ ≥ 0.
    pub friction: &'a [f64],
    /// 0 ≤ e ≤ 1.
    pub restitution: &'a [f64],
    /// v_x0, m/s.
    pub vx: &'a [f64],
    /// v_y0 ≥ 0, m/s.
    pub vy: &'a [f64],
    /// ω0, 1/s.
    pub omega: &'a [f64],
}

impl<'a> Spheres<'a> {
    const fn columns(&self) -> [&'a [f64]; 8] {
        let Self { mass, radius, inertia, friction, restitution, vx, vy, omega } = *self;
        [mass, radius, inertia, friction, restitution, vx, vy, omega]
    }
}

#[inline]
const fn sphere(row: [f64; 8]) -> SphereOnPlane<f64> {
    let [mass, radius, inertia, friction, restitution, vx, vy, omega] = row;
    let before = Motion { vx, vy, omega };
    SphereOnPlane { mass, radius, inertia, friction, restitution, before }
}

/// Decides [`sliding`](super::sliding) for every sphere, and says how many decisions each stage made.
///
/// The same signs, nearly at the price of plain floats where the filter suffices.
///
/// # Errors
/// The row of the first sphere with an input outside its domain, and [`InvalidInput`]; the signs from
/// there on mean nothing then.
///
/// # Panics
/// If the columns and the signs are not of one length.
pub fn sliding_all(
    spheres: Spheres<'_>,
    signs: &mut [Ordering],
) -> Result<Shares, (usize, InvalidInput<f64>)> {
    let columns = spheres.columns();
    assert!(columns.iter().all(|column| column.len() == signs.len()), "columns of one length");
    let mut shares = Shares::default();
    let blocks = columns.map(|column| column.as_chunks::<BLOCK>().0);
    for (at, signs) in signs.chunks_mut(BLOCK).enumerate() {
        if let Ok(signs) = <&mut [Ordering; BLOCK]>::try_from(&mut *signs)
            && filter_block(&Sliding, blocks.map(|blocks| &blocks[at]), signs)
        {
            shares.filter += BLOCK as u64;
            continue;
        }
        for (row, sign) in signs.iter_mut().enumerate() {
            let row = at * BLOCK + row;
            let decision = decide(&Sliding, &sphere(columns.map(|column| column[row])))
                .map_err(|error| (row, error))?;
            shares.count(decision.stage);
            *sign = decision.sign;
        }
    }
    Ok(shares)
}

/// Whether the filter decides every row.
#[inline]
fn filter_block<Q: Question>(
    question: &Q,
    columns: [&[f64; BLOCK]; 8],
    signs: &mut [Ordering; BLOCK],
) -> bool {
    let mut values = [0.0; BLOCK];
    let mut doubts = 0_u64;
    for row in 0..BLOCK {
        let sphere = sphere(columns.map(|column| column[row]));
        let answer = question.value::<Filter>(&sphere);
        values[row] = answer.value();
        let decided = is_usual(&sphere) & (answer.value().abs() > answer.bound());
        doubts += u64::from(!decided);
    }
    for (sign, value) in signs.iter_mut().zip(&values) {
        *sign = if *value > 0.0 { Ordering::Greater } else { Ordering::Less };
    }
    doubts == 0
}
