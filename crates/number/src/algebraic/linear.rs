//! Linear systems over the rationals.

use num_traits::Zero;

use crate::Rational;

/// The coefficients by which the columns sum to the right-hand side, which stands for each of
/// several; `None` if the columns depend on each other or a right-hand side is outside their span.
///
/// Exact, by Gaussian elimination: of the order of rows·columns² operations on numbers that grow.
#[must_use]
pub fn solve(
    columns: &[Vec<Rational>],
    right_hand_sides: &[&[Rational]],
) -> Option<Vec<Vec<Rational>>> {
    let count = columns.len();
    let height = columns.first().map_or(0, Vec::len);
    let mut rows: Vec<Vec<Rational>> = (0..height)
        .map(|row| {
            let left = columns.iter().map(|column| column[row].clone());
            left.chain(right_hand_sides.iter().map(|side| side[row].clone())).collect()
        })
        .collect();
    for column in 0..count {
        let pivot = (column..height).find(|&row| !rows[row][column].is_zero())?;
        rows.swap(column, pivot);
        let inverse = rows[column][column].recip();
        for entry in &mut rows[column][column..] {
            *entry *= &inverse;
        }
        let pivot_row = rows[column].clone();
        for (index, row) in rows.iter_mut().enumerate() {
            if index == column || row[column].is_zero() {
                continue;
            }
            let factor = row[column].clone();
            for (entry, pivot) in row.iter_mut().zip(&pivot_row).skip(column) {
                *entry -= &factor * pivot;
            }
        }
    }
    let spanned = rows[count..].iter().all(|row| row[count..].iter().all(Zero::is_zero));
    spanned.then(|| {
        (0..right_hand_sides.len())
            .map(|side| rows[..count].iter().map(|row| row[count + side].clone()).collect())
            .collect()
    })
}
