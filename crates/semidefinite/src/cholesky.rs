//! Cholesky factors L·Lᵀ of a positive definite matrix.

use crate::Matrix;

/// The lower triangle L.
#[derive(Clone, Debug)]
pub(crate) struct Cholesky(Matrix);

impl Cholesky {
    /// The factor; `None` if a pivot is not positive.
    pub(crate) fn of(a: &Matrix) -> Option<Self> {
        let n = a.len();
        let mut l: Matrix = vec![vec![0.0; n]; n];
        for i in 0..n {
            let (above, rest) = l.split_at_mut(i);
            let row = &mut rest[0];
            for j in 0..i {
                let known: f64 = row[..j].iter().zip(&above[j][..j]).map(|(x, y)| x * y).sum();
                row[j] = (a[i][j] - known) / above[j][j];
            }
            let known: f64 = row[..i].iter().map(|x| x * x).sum();
            let pivot = a[i][i] - known;
            // NaN is no pivot either.
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            row[i] = pivot.sqrt();
        }
        Some(Self(l))
    }

    /// x with A·x = b.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let (l, n) = (&self.0, b.len());
        let mut x = b.to_vec();
        for i in 0..n {
            let known: f64 = l[i][..i].iter().zip(&x[..i]).map(|(a, y)| a * y).sum();
            x[i] = (x[i] - known) / l[i][i];
        }
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|j| l[j][i] * x[j]).sum();
            x[i] = (x[i] - known) / l[i][i];
        }
        x
    }

    /// A⁻¹
    pub(crate) fn inverse(&self) -> Matrix {
        let n = self.0.len();
        let unit = |i: usize| (0..n).map(|j| f64::from(u8::from(i == j))).collect::<Vec<_>>();
        (0..n).map(|i| self.solve(&unit(i))).collect()
    }
}
