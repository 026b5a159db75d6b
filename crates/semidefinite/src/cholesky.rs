//! Cholesky factors Uᵀ·U of a positive definite matrix.

use crate::Matrix;

/// The upper triangle U, row by row.
#[derive(Clone, Debug)]
pub(crate) struct Cholesky {
    order: usize,
    upper: Vec<f64>,
}

impl Cholesky {
    /// The factor of the matrix with this upper triangle; `None` if a pivot is not positive.
    pub(crate) fn of(a: &Matrix) -> Option<Self> {
        let n = a.len();
        let mut upper = vec![0.0; n * n];
        for i in 0..n {
            let (above, rest) = upper.split_at_mut(i * n);
            let row = &mut rest[i..n];
            row.copy_from_slice(&a[i][i..]);
            // four at once, so that the row is loaded and stored once for all of them
            let groups = above.chunks_exact(4 * n);
            let single = groups.remainder().chunks_exact(n);
            for group in groups {
                let (p, group) = group.split_at(n);
                let (q, group) = group.split_at(n);
                let (r, s) = group.split_at(n);
                let others = p[i..].iter().zip(&q[i..]).zip(&r[i..]).zip(&s[i..]);
                for (x, (((a, b), c), d)) in row.iter_mut().zip(others) {
                    *x = *x - p[i] * a - q[i] * b - r[i] * c - s[i] * d;
                }
            }
            for p in single {
                row.iter_mut().zip(&p[i..]).for_each(|(x, a)| *x -= p[i] * a);
            }
            // NaN is no pivot either.
            if !(row[0] > 0.0 && row[0].is_finite()) {
                return None;
            }
            let root = row[0].sqrt();
            row.iter_mut().for_each(|x| *x /= root);
        }
        Some(Self { order: n, upper })
    }

    /// x with A·x = b.
    pub(crate) fn solve(&self, b: &[f64]) -> Vec<f64> {
        let mut x = b.to_vec();
        let rows = || self.upper.chunks_exact(self.order).enumerate();
        for (i, row) in rows() {
            x[i] /= row[i];
            let (known, rest) = x.split_at_mut(i + 1);
            rest.iter_mut().zip(&row[i + 1..]).for_each(|(y, a)| *y -= known[i] * a);
        }
        for (i, row) in rows().rev() {
            x[i] = (x[i] - dot(&row[i + 1..], &x[i + 1..])) / row[i];
        }
        x
    }

    /// A⁻¹
    pub(crate) fn inverse(&self) -> Matrix {
        let n = self.order;
        let unit = |i: usize| (0..n).map(|j| f64::from(u8::from(i == j))).collect::<Vec<_>>();
        (0..n).map(|i| self.solve(&unit(i))).collect()
    }
}

/// x·y in sums of every fourth product, so that no addition waits for the one before it.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    let (x, y) = (x.chunks_exact(4), y.chunks_exact(4));
    let rest: f64 = x.remainder().iter().zip(y.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; 4];
    for (x, y) in x.zip(y) {
        sums.iter_mut().zip(x.iter().zip(y)).for_each(|(sum, (a, b))| *sum += a * b);
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Small integers, so that every product and sum is exact: A = Bᵀ·B + n·1 with a fixed B.
    fn sample(n: usize) -> Matrix {
        let b = |i: usize, j: usize| f64::from(u32::try_from((7 * i + 3 * j * j) % 5).unwrap_or(0));
        let shift = f64::from(u32::try_from(n).unwrap_or(0));
        let entry = |i: usize, j: usize| {
            (0..n).map(|k| b(k, i) * b(k, j)).sum::<f64>() + if i == j { shift } else { 0.0 }
        };
        (0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()
    }

    #[test]
    fn a_solution_solves_at_every_order() {
        for n in 1..=23 {
            let a = sample(n);
            let b: Vec<f64> = (1..=n).map(|i| f64::from(u32::try_from(i).unwrap_or(0))).collect();
            let x = Cholesky::of(&a).expect("it is positive definite").solve(&b);
            for (row, wanted) in a.iter().zip(&b) {
                // by at most (3n + 1)·u·Σ√(aᵢᵢ·aⱼⱼ)·|xⱼ| (Higham 2002, theorem 10.4), and as much as
                // n·u of that for the product; aᵢᵢ ≤ 17n and |x| ≤ |b|/n ≤ √n, so below 1e-10 at n = 23
                let product: f64 = row.iter().zip(&x).map(|(a, x)| a * x).sum();
                assert!((product - wanted).abs() < 1e-9, "{n}: {product} {wanted}");
            }
        }
    }

    #[test]
    fn what_is_not_positive_definite_has_no_factor() {
        for n in 1..=9 {
            for at in 0..n {
                let mut a = sample(n);
                a[at][at] = 0.0;
                assert!(Cholesky::of(&a).is_none(), "{n} {at}");
                a[at][at] = f64::NAN;
                assert!(Cholesky::of(&a).is_none(), "{n} {at}");
            }
        }
    }
}
