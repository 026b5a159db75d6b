//! The central path: how far inside the cone of positive semidefinite matrices a pencil can be.
//!
//! Maximises t with G(y) − t·1 positive definite by Newton's method on the barrier
//! −τ·t − log det(G(y) − t·1) − log(1 − t) + ε/2·|y|², for growing τ (Nesterov and Nemirovskii 1994,
//! without their predictor). The last term keeps parameters small that do not matter.

use crate::cholesky::{Cholesky, dot};
use crate::{Entry, Matrix, Pencil};

/// A point on the central path.
#[derive(Clone, Debug, PartialEq)]
pub struct Center {
    /// the parameters
    pub y: Vec<f64>,
    /// G(y) − margin·1 is positive definite
    pub margin: f64,
    /// Newton steps taken
    pub steps: usize,
}

/// Weight of |y|²/2.
const RIDGE: f64 = 1e-5;
/// Newton steps for one τ.
const STEPS: usize = 25;
/// A margin with which rounding is easy.
const ENOUGH: f64 = 1e-3;
/// The end of the path.
const LAST: f64 = 1e10;

/// The most central point with a margin, or, if the pencil reaches only the boundary of the cone,
/// a point near it. `None` if it visibly reaches neither, or the arithmetic breaks down.
///
/// `pays` is asked before every Newton step whether there may be one more.
pub fn center(pencil: &Pencil, pays: &mut dyn FnMut() -> bool) -> Option<Center> {
    let n: usize = pencil.sizes.iter().sum();
    let mut path = Path::new(pencil)?;
    let mut tau = 1.0;
    while tau < LAST {
        if !path.settle(tau, pays) {
            break;
        }
        if path.t > ENOUGH {
            return Some(path.end());
        }
        // On the path t is at most (n + 1)/τ below the best; the ridge takes a little, too.
        let gap = 2.0 * f64::from(u32::try_from(n + 1).unwrap_or(u32::MAX)) / tau;
        if path.t + gap < -1e-4 {
            return None;
        }
        tau *= 6.0;
    }
    (path.t > -1e-5).then(|| path.end())
}

/// Where Newton's method is.
struct Path<'a> {
    pencil: &'a Pencil,
    y: Vec<f64>,
    t: f64,
    steps: usize,
}

impl<'a> Path<'a> {
    fn new(pencil: &'a Pencil) -> Option<Self> {
        let y = vec![0.0; pencil.directions.len()];
        let mut t = -1.0;
        while !pencil.is_nearly_definite(&y, -t) {
            t *= 2.0;
            if t < -1e12 {
                return None;
            }
        }
        Some(Self { pencil, y, t: 2.0 * t, steps: 0 })
    }

    fn end(&self) -> Center {
        Center { y: self.y.clone(), margin: self.t, steps: self.steps }
    }

    /// Goes to the minimum of the barrier; whether it got near it before the arithmetic or what pays
    /// for it came to an end.
    ///
    /// The barrier is self-concordant, so a step of 1/(1 + δ) times Newton's, δ² the decrement, stays
    /// in the cone and descends (Nesterov and Nemirovskii): no value of the barrier is needed.
    fn settle(&mut self, tau: f64, pays: &mut dyn FnMut() -> bool) -> bool {
        for _ in 0..STEPS {
            if !pays() {
                return false;
            }
            self.steps += 1;
            let Some((step, decrement)) = self.newton(tau) else {
                return false;
            };
            let mut length = if decrement < 0.06 { 1.0 } else { 1.0 / (1.0 + decrement.sqrt()) };
            loop {
                let y: Vec<f64> = self.y.iter().zip(&step).map(|(y, d)| y + length * d).collect();
                let t = self.t + length * step[self.y.len()];
                if t < 1.0 && self.pencil.is_nearly_definite(&y, -t) {
                    (self.y, self.t) = (y, t);
                    break;
                }
                // Floats are at their end.
                if length < 1e-9 {
                    return false;
                }
                length *= 0.5;
            }
            if decrement < 1e-3 {
                return true;
            }
        }
        true
    }

    /// Newton's step for (y, t), and how much the barrier should fall along it.
    fn newton(&self, tau: f64) -> Option<(Vec<f64>, f64)> {
        let (k, pencil) = (self.y.len(), self.pencil);
        let blocks = pencil.at(&self.y, self.t);
        let inverse = |b: &Matrix| Some(Cholesky::of(b)?.inverse());
        let inverses: Vec<Matrix> = blocks.iter().map(inverse).collect::<Option<_>>()?;
        let squares: Vec<Matrix> = inverses.iter().map(squared).collect();
        let mut gradient: Vec<f64> = vec![0.0; k + 1];
        let mut hessian: Matrix = vec![vec![0.0; k + 1]; k + 1];
        for (i, direction) in pencil.directions.iter().enumerate() {
            gradient[i] = RIDGE * self.y[i] - trace(&inverses, direction);
            // the upper triangle alone
            hessian[i][k] = -trace(&squares, direction);
            let between = between(&inverses, direction);
            for (entry, other) in hessian[i][i..k].iter_mut().zip(&pencil.directions[i..]) {
                *entry = trace(&between, other);
            }
            hessian[i][i] += RIDGE;
        }
        let room = 1.0 - self.t;
        let diagonal = |m: &Matrix| (0..m.len()).map(|i| m[i][i]).sum::<f64>();
        gradient[k] = -tau + inverses.iter().map(diagonal).sum::<f64>() + 1.0 / room;
        hessian[k][k] = squares.iter().map(diagonal).sum::<f64>() + 1.0 / (room * room);
        let opposite: Vec<f64> = gradient.iter().map(|g| -g).collect();
        let step = Cholesky::of(&hessian)?.solve(&opposite);
        let decrement: f64 = step.iter().zip(&opposite).map(|(s, g)| s * g).sum();
        decrement.is_finite().then_some((step, decrement))
    }
}

fn squared(m: &Matrix) -> Matrix {
    m.iter().map(|row| m.iter().map(|other| dot(row, other)).collect()).collect()
}

/// tr(V·G), where a block of V without rows is zero
fn trace(v: &[Matrix], g: &[Entry]) -> f64 {
    g.iter()
        .filter(|e| !v[e.block].is_empty())
        .map(|e| {
            let twice = if e.row == e.column { 1.0 } else { 2.0 };
            twice * e.value * v[e.block][e.row][e.column]
        })
        .sum()
}

/// V·G·V, whose product with H has the trace tr(V·G·V·H); without rows for a block in which G is zero.
fn between(v: &[Matrix], g: &[Entry]) -> Vec<Matrix> {
    let mut halves: Vec<Matrix> = vec![Matrix::new(); v.len()];
    for e in g {
        let n = v[e.block].len();
        let half = &mut halves[e.block];
        half.resize_with(n, || vec![0.0; n]);
        add(&mut half[e.row], e.value, &v[e.block][e.column]);
        if e.row != e.column {
            add(&mut half[e.column], e.value, &v[e.block][e.row]);
        }
    }
    let whole = |(half, v): (&Matrix, &Matrix)| -> Matrix {
        // rows of G that are empty stay so
        let full: Vec<usize> =
            (0..half.len()).filter(|&k| half[k].iter().any(|x| *x != 0.0)).collect();
        let product = |row: &Vec<f64>| {
            let mut out = vec![0.0; row.len()];
            full.iter().for_each(|&k| add(&mut out, row[k], &half[k]));
            out
        };
        if half.is_empty() { Matrix::new() } else { v.iter().map(product).collect() }
    };
    halves.iter().zip(v).map(whole).collect()
}

/// Adds a multiple of a row.
fn add(sum: &mut [f64], by: f64, row: &[f64]) {
    sum.iter_mut().zip(row).for_each(|(sum, x)| *sum += by * x);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(row: usize, column: usize, value: f64) -> Entry {
        Entry { block: 0, row, column, value }
    }

    /// (x² − 1)² by (1, x, x²): only y = −1 is left.
    fn square() -> Pencil {
        Pencil {
            sizes: vec![3],
            constant: vec![entry(0, 0, 1.0), entry(1, 1, -2.0), entry(2, 2, 1.0)],
            directions: vec![vec![entry(0, 2, 1.0), entry(1, 1, -2.0)]],
        }
    }

    #[test]
    fn a_pencil_with_room_gets_a_margin() {
        // x⁴ − 2x² + 3 by (1, x, x²): [[3, 0, y], [0, −2 − 2y, 0], [y, 0, 1]]
        let pencil = Pencil {
            sizes: vec![3],
            constant: vec![entry(0, 0, 3.0), entry(1, 1, -2.0), entry(2, 2, 1.0)],
            directions: vec![vec![entry(0, 2, 1.0), entry(1, 1, -2.0)]],
        };
        let found = center(&pencil, &mut || true).expect("it is a sum of squares");
        assert!(found.margin > 0.0);
        assert!(pencil.is_nearly_definite(&found.y, 0.0));
    }

    #[test]
    fn a_pencil_on_the_boundary_is_followed_to_it() {
        let found = center(&square(), &mut || true).expect("it is a square");
        assert!((found.y[0] + 1.0).abs() < 1e-4, "{found:?}");
    }

    #[test]
    fn no_step_is_taken_that_is_not_paid_for() {
        let pencil = square();
        let all = center(&pencil, &mut || true).expect("it is a square").steps;
        for most in 0..all {
            let mut paid = 0;
            let found = center(&pencil, &mut || {
                paid += 1;
                paid <= most
            });
            assert_eq!(paid, most + 1, "it asks until it is refused");
            assert!(found.is_none_or(|found| found.steps == most));
        }
    }

    #[test]
    fn a_pencil_outside_the_cone_is_told_so() {
        // −x² + y·0 has no margin, whatever y is.
        let pencil = Pencil {
            sizes: vec![2],
            constant: vec![entry(0, 0, 1.0), entry(1, 1, -1.0)],
            directions: vec![vec![entry(0, 1, 1.0)]],
        };
        assert_eq!(center(&pencil, &mut || true), None);
    }
}
