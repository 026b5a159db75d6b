//! Eigenvalues of a symmetric matrix, by Jacobi's rotations (Jacobi 1846).

use crate::Matrix;

/// Sweeps over all pairs; a few suffice for matrices of this size.
const SWEEPS: usize = 30;

/// Eigenvalues, ascending, each with its vector of length 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigen {
    /// the eigenvalues
    pub values: Vec<f64>,
    /// the vectors, in the same order
    pub vectors: Vec<Vec<f64>>,
}

/// The eigenvalues and eigenvectors of a symmetric matrix; *heuristic*, as good as floats are.
#[must_use]
pub fn eigen(a: &Matrix) -> Eigen {
    let n = a.len();
    let mut a = a.clone();
    // Row i is the vector that belongs to a[i][i].
    let mut vectors: Matrix =
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for _ in 0..SWEEPS {
        let off: f64 =
            (0..n).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| a[i][j].abs()).sum();
        if off < 1e-300 {
            break;
        }
        for p in 0..n {
            for q in p + 1..n {
                if a[p][q].abs() > 0.0 {
                    rotate(&mut a, &mut vectors, p, q);
                }
            }
        }
    }
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&i, &j| a[i][i].total_cmp(&a[j][j]));
    Eigen {
        values: order.iter().map(|&i| a[i][i]).collect(),
        vectors: order.iter().map(|&i| vectors[i].clone()).collect(),
    }
}

/// How many eigenvalues of each matrix are small beside the largest of all: below that times `zero`.
#[must_use]
pub fn vanishing(spectra: &[Eigen], zero: f64) -> Vec<usize> {
    let largest = spectra.iter().filter_map(|s| s.values.last()).copied().fold(0.0, f64::max);
    let small = |s: &Eigen| s.values.iter().take_while(|v| **v < zero * largest).count();
    spectra.iter().map(small).collect()
}

/// Makes a[p][q] zero.
fn rotate(a: &mut Matrix, vectors: &mut Matrix, p: usize, q: usize) {
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let t = theta.signum() / (theta.abs() + (theta * theta + 1.0).sqrt());
    let c = 1.0 / (t * t + 1.0).sqrt();
    let s = t * c;
    let turned = |x: f64, y: f64| (c * x - s * y, s * x + c * y);
    for row in a.iter_mut() {
        (row[p], row[q]) = turned(row[p], row[q]);
    }
    for rows in [a, vectors] {
        let (above, below) = rows.split_at_mut(q);
        for (x, y) in above[p].iter_mut().zip(&mut below[0]) {
            (*x, *y) = turned(*x, *y);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vectors_are_stretched_by_their_values() {
        let a = vec![vec![2.0, -1.0, 0.0], vec![-1.0, 2.0, -1.0], vec![0.0, -1.0, 2.0]];
        let found = eigen(&a);
        for (value, v) in found.values.iter().zip(&found.vectors) {
            for (row, x) in a.iter().zip(v) {
                let image: f64 = row.iter().zip(v).map(|(a, x)| a * x).sum();
                // Jacobi is accurate to a few units in the last place of the norm, 4.
                assert!((image - value * x).abs() < 1e-14, "{image} is not {value} times {x}");
            }
        }
        assert!(found.values.windows(2).all(|w| w[0] <= w[1]));
    }
}
