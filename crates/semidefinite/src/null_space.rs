//! A basis of a space of vectors in which some columns are unit vectors.

use crate::Matrix;

/// Rows that span the same space as some independent vectors, reduced by Gauss and Jordan with the
/// largest pivots: the columns of the pivots, and the rows, each 1 at its own pivot and 0 at the
/// others. `None` if the vectors look dependent.
#[must_use]
pub fn null_space(vectors: &[Vec<f64>]) -> Option<(Vec<usize>, Matrix)> {
    let mut rows: Matrix = vectors.to_vec();
    let mut pivots = Vec::new();
    for i in 0..rows.len() {
        let largest = |row: &Vec<f64>| {
            let sizes = row.iter().enumerate().map(|(c, x)| (c, x.abs()));
            sizes.fold((0, 0.0), |best, next| if next.1 > best.1 + 1e-9 { next } else { best })
        };
        let (column, size) = largest(&rows[i]);
        if size < 1e-6 {
            return None;
        }
        let lead = rows[i][column];
        rows[i].iter_mut().for_each(|x| *x /= lead);
        let pivot = rows[i].clone();
        for (j, row) in rows.iter_mut().enumerate() {
            if j != i {
                let by = row[column];
                row.iter_mut().zip(&pivot).for_each(|(x, p)| *x -= by * p);
            }
        }
        pivots.push(column);
    }
    Some((pivots, rows))
}
