//! L·D·Lᵀ of a rational symmetric matrix: whether it is positive semidefinite, exactly.

use kane_kernel::{Checked, Fuel};
use num_traits::{Signed, Zero};

use super::Q;

/// weight · (row · basis)²
pub(super) struct Factor {
    pub(super) weight: Q,
    pub(super) row: Vec<Q>,
}

/// The matrix as a sum of weighted squares of rows, all weights positive; `None` if it is not
/// positive semidefinite, or if its fractions grow beyond what the budget allows.
pub(super) fn factors(mut a: Vec<Vec<Q>>, fuel: &Fuel) -> Option<Vec<Factor>> {
    let n = a.len();
    let mut out = Vec::new();
    for i in 0..n {
        let pivot = a[i][i].clone();
        if pivot.is_negative() {
            return None;
        }
        if pivot.is_zero() {
            // Beside a zero on the diagonal there is nothing.
            if a[i][i..].iter().any(|q| !q.is_zero()) {
                return None;
            }
            continue;
        }
        let row: Vec<Q> =
            (0..n).map(|j| if j < i { Q::zero() } else { &a[i][j] / &pivot }).collect();
        for j in i + 1..n {
            if row[j].is_zero() {
                continue;
            }
            for k in j..n {
                pay([&row[j], &row[k], &pivot, &a[j][k]], fuel).ok()?;
                let less = &row[j] * &row[k] * &pivot;
                a[j][k] -= less;
            }
        }
        out.push(Factor { weight: pivot, row });
    }
    Some(out)
}

/// Pays for products of fractions that are longer than a word: greatest common divisors take the square of their length.
fn pay(of: [&Q; 4], fuel: &Fuel) -> Checked {
    let words = |q: &Q| (q.numer().bits() + q.denom().bits()) / 64;
    let words: u64 = of.into_iter().map(words).sum();
    if words == 0 {
        Ok(())
    } else {
        fuel.spend_beyond(words.saturating_mul(words).saturating_mul(4))
    }
}
