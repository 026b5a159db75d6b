//! The pencil: a symmetric block-diagonal matrix that depends affinely on parameters.

use crate::Matrix;
use crate::cholesky::Cholesky;

/// A number in a block, at both (row, column) and (column, row).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    /// index of the block
    pub block: usize,
    /// row, at most the column
    pub row: usize,
    /// column
    pub column: usize,
    /// the number
    pub value: f64,
}

/// G(y) = G₀ + Σ yᵢGᵢ.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pencil {
    /// number of rows of each block
    pub sizes: Vec<usize>,
    /// G₀
    pub constant: Vec<Entry>,
    /// the Gᵢ
    pub directions: Vec<Vec<Entry>>,
}

impl Pencil {
    /// The blocks of G(y) − t·1.
    #[must_use]
    pub fn at(&self, y: &[f64], t: f64) -> Vec<Matrix> {
        let mut blocks: Vec<Matrix> = self.sizes.iter().map(|&n| vec![vec![0.0; n]; n]).collect();
        let mut add = |e: &Entry, by: f64| {
            let block = &mut blocks[e.block];
            block[e.row][e.column] += by * e.value;
            if e.row != e.column {
                block[e.column][e.row] += by * e.value;
            }
        };
        self.constant.iter().for_each(|e| add(e, 1.0));
        for (direction, &y) in self.directions.iter().zip(y) {
            direction.iter().for_each(|e| add(e, y));
        }
        for block in &mut blocks {
            for (i, row) in block.iter_mut().enumerate() {
                row[i] -= t;
            }
        }
        blocks
    }

    /// Whether G(y) + slack·1 is positive definite as far as floats see it.
    #[must_use]
    pub fn is_nearly_definite(&self, y: &[f64], slack: f64) -> bool {
        self.at(y, -slack).iter().all(|block| Cholesky::of(block).is_some())
    }

    /// The largest entry of G₀ and of the Gᵢ.
    #[must_use]
    pub fn size(&self) -> f64 {
        let entries = self.constant.iter().chain(self.directions.iter().flatten());
        entries.fold(0.0, |size: f64, e| size.max(e.value.abs()))
    }
}
