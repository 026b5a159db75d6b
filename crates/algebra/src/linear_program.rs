//! Exact linear feasibility: the simplex method in whole numbers.
//!
//! A row of the tableau counts up to a positive factor, so it is kept without a common one (no fraction is
//! ever reduced). Signs, ratios and pivots are those of the tableau in fractions.

use kane_kernel::Fuel;
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use crate::ray::Ray;

type Q = BigRational;

/// Pivots that gain nothing, times the number of rows, after which a cycle is feared.
const IDLE: usize = 20;

/// Which variable enters the basis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Entering {
    /// the first that gains anything (Bland 1977): there are no cycles, and many steps where there are many columns
    First,
    /// the one with the largest cost (Dantzig 1951), until nothing has been gained for long
    Greatest,
}

/// Finds x ≥ 0 with A·x = b, or `None` if there is none or the steps or the fuel run out.
///
/// `columns[j]` lists the non-zero entries (row, value) of column j; `b` has one entry a row.
/// Exact; `steps` bounds the pivots and `fuel` their work, which grows with the numbers in the tableau.
#[must_use]
pub fn feasible(
    columns: &[Vec<(usize, Q)>],
    b: &[Q],
    entering: Entering,
    steps: usize,
    fuel: &Fuel,
) -> Option<Vec<Q>> {
    let (rows, cols) = (b.len(), columns.len());
    // The tableau of phase one in whole numbers: artificial variables are the initial basis.
    let common = common_denominator(columns.iter().flatten().map(|(_, value)| value).chain(b));
    let of = |q: &Q| q.numer() * (&common / q.denom());
    let mut table = vec![vec![BigInt::zero(); cols + 1]; rows];
    for (j, column) in columns.iter().enumerate() {
        for (i, value) in column {
            table[*i][j] = of(value);
        }
    }
    let mut cost = vec![BigInt::zero(); cols + 1];
    for (row, value) in table.iter_mut().zip(b) {
        row[cols] = of(value);
        if value.is_negative() {
            row.iter_mut().for_each(|x| *x = -&*x);
        }
        cost.iter_mut().zip(&*row).for_each(|(c, x)| *c += x);
    }
    let mut table: Vec<Ray> = table.into_iter().map(Ray::of).collect();
    let mut cost = Ray::of(cost);
    let mut basis: Vec<Option<usize>> = vec![None; rows];
    // pivots since the last one by which the sum of the artificial variables became less
    let mut idle = 0;
    for _ in 0..steps {
        if cost.sign(cols).is_eq() {
            let mut x = vec![Q::zero(); cols];
            for (row, variable) in table.iter().zip(&basis) {
                if let Some(j) = variable {
                    x[*j] = row.quotient(cols, *j);
                }
            }
            return Some(x);
        }
        let enter = match entering {
            Entering::Greatest if idle <= IDLE * rows => cost.greatest(cols),
            _ => cost.first_positive(cols),
        }?;
        // Smallest ratio; ties by the lowest basic variable, artificial ones leave first.
        let able = (0..rows).filter(|&i| table[i].sign(enter).is_gt());
        let leave = able.min_by(|&i, &j| {
            table[i].compare(&table[j], cols, enter).then(basis[i].cmp(&basis[j]))
        })?;
        let pivot = table[leave].clone();
        idle = if pivot.sign(cols).is_eq() { idle + 1 } else { 0 };
        for (i, row) in table.iter_mut().enumerate() {
            if i != leave && row.sign(enter).is_ne() {
                *row = row.cleared(enter, &pivot, fuel).ok()?;
            }
        }
        cost = cost.cleared(enter, &pivot, fuel).ok()?;
        basis[leave] = Some(enter);
    }
    None
}

/// The least common denominator; 1 of no fractions.
pub fn common_denominator<'q>(values: impl IntoIterator<Item = &'q Q>) -> BigInt {
    let fractions = values.into_iter().filter(|q| !q.is_integer());
    fractions.fold(BigInt::one(), |l, q| l.lcm(q.denom()))
}

/// A vector of whole numbers in the same ratios.
#[must_use]
pub fn whole(values: &[Q]) -> Vec<BigInt> {
    let common = common_denominator(values);
    values.iter().map(|q| q.numer() * (&common / q.denom())).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn fuel() -> Fuel {
        Fuel::new(1 << 30)
    }

    fn q(n: i64) -> Q {
        Q::from_integer(n.into())
    }

    const BOTH: [Entering; 2] = [Entering::First, Entering::Greatest];

    #[test]
    fn a_feasible_system_is_solved() {
        // x + y = 3, x − y = 1
        let columns = [vec![(0, q(1)), (1, q(1))], vec![(0, q(1)), (1, q(-1))]];
        for entering in BOTH {
            let found = feasible(&columns, &[q(3), q(1)], entering, 100, &fuel());
            assert_eq!(found, Some(vec![q(2), q(1)]));
        }
    }

    #[test]
    fn an_infeasible_system_is_not() {
        // x + y = −1
        let columns = [vec![(0, q(1))], vec![(0, q(1))]];
        for entering in BOTH {
            assert_eq!(feasible(&columns, &[q(-1)], entering, 100, &fuel()), None);
        }
    }

    #[test]
    fn whole_numbers_keep_their_ratios() {
        let values = [Q::new(1.into(), 2.into()), Q::new((-2).into(), 3.into()), q(0)];
        assert_eq!(whole(&values), [3, -4, 0].map(BigInt::from));
    }

    #[test]
    fn no_steps_no_answer() {
        assert_eq!(feasible(&[vec![(0, q(1))]], &[q(1)], Entering::Greatest, 0, &fuel()), None);
    }

    type Rows = Vec<Vec<i64>>;

    fn columns(rows: &Rows) -> Vec<Vec<(usize, Q)>> {
        let column = |j| {
            let entries =
                rows.iter().enumerate().map(move |(i, row): (usize, &Vec<i64>)| (i, row[j]));
            entries.filter(|e| e.1 != 0).map(|(i, v)| (i, q(v))).collect()
        };
        (0..rows[0].len()).map(column).collect()
    }

    fn rows() -> impl Strategy<Value = Rows> {
        prop::collection::vec(prop::collection::vec(-3i64..=3, 4), 3)
    }

    fn dot(a: &[i64], b: &[i64]) -> i64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    proptest! {
        #[test]
        fn a_planted_solution_makes_the_system_feasible(a in rows(), x in prop::collection::vec(0i64..4, 4)) {
            let b: Vec<Q> = a.iter().map(|row| q(dot(row, &x))).collect();
            for entering in BOTH {
                let found = feasible(&columns(&a), &b, entering, 1000, &fuel()).expect("x is a solution");
                prop_assert!(found.iter().all(|v| !v.is_negative()));
                for (row, b) in a.iter().zip(&b) {
                    let sum = row.iter().zip(&found).fold(Q::zero(), |s, (a, x)| s + q(*a) * x);
                    prop_assert_eq!(&sum, b);
                }
            }
        }

        /// Farkas (1902): y·A ≥ 0 with y·b < 0 leaves no solution.
        #[test]
        fn a_planted_obstruction_makes_it_infeasible(mut a in rows(), mut b in prop::collection::vec(-5i64..=5, 3)) {
            for j in 0..4 {
                // y = (1, 1, 1)
                let sum: i64 = a.iter().map(|row| row[j]).sum();
                a[0][j] += (-sum).max(0);
            }
            b[0] -= b.iter().sum::<i64>().max(0) + 1;
            let b: Vec<Q> = b.into_iter().map(q).collect();
            for entering in BOTH {
                prop_assert_eq!(feasible(&columns(&a), &b, entering, 1000, &fuel()), None);
            }
        }
    }
}
