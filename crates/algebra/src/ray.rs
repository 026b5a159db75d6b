//! Rays: rows of whole numbers without a common factor, which stand for all their positive multiples.

use std::cmp::{Ordering, Reverse};

use kane_kernel::{Checked, Fuel};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// A row, in machine words where they reach.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Ray {
    Words(Vec<i64>),
    Long(Vec<BigInt>),
}

impl Ray {
    /// The ray of these numbers: without what divides all, in words if they reach.
    pub(crate) fn of(mut row: Vec<BigInt>) -> Self {
        let mut content = BigInt::zero();
        for x in &row {
            content = content.gcd(x);
            if content.is_one() {
                break;
            }
        }
        if !content.is_zero() && !content.is_one() {
            row.iter_mut().for_each(|x| *x /= &content);
        }
        // the least word has no absolute value
        let word = |x: &BigInt| x.to_i64().filter(|x| *x != i64::MIN);
        match row.iter().map(word).collect() {
            Some(words) => Self::Words(words),
            None => Self::Long(row),
        }
    }

    /// How an entry compares with zero.
    pub(crate) fn sign(&self, at: usize) -> Ordering {
        match self {
            Self::Words(row) => row[at].cmp(&0),
            Self::Long(row) => row[at].cmp(&BigInt::zero()),
        }
    }

    /// The first of so many entries that is positive.
    pub(crate) fn first_positive(&self, among: usize) -> Option<usize> {
        match self {
            Self::Words(row) => row[..among].iter().position(|x| *x > 0),
            Self::Long(row) => row[..among].iter().position(BigInt::is_positive),
        }
    }

    /// The greatest of so many entries, the first of equal ones, if it is positive.
    pub(crate) fn greatest(&self, among: usize) -> Option<usize> {
        let first = |i: &usize| Reverse(*i);
        match self {
            Self::Words(row) => (0..among).max_by_key(|i| (row[*i], first(i))),
            Self::Long(row) => (0..among).max_by_key(|i| (&row[*i], first(i))),
        }
        .filter(|i| self.sign(*i).is_gt())
    }

    /// The quotient of two entries, of which the second is not 0.
    pub(crate) fn quotient(&self, over: usize, under: usize) -> BigRational {
        BigRational::new(self.entry(over), self.entry(under))
    }

    /// Compares the quotient of two entries with that of another row. Both denominators are positive.
    pub(crate) fn compare(&self, other: &Self, over: usize, under: usize) -> Ordering {
        if let (Self::Words(a), Self::Words(b)) = (self, other) {
            let times = |x: i64, y: i64| i128::from(x) * i128::from(y);
            return times(a[over], b[under]).cmp(&times(b[over], a[under]));
        }
        let left = self.entry(over) * other.entry(under);
        left.cmp(&(other.entry(over) * self.entry(under)))
    }

    /// This row plus the multiple of another that clears an entry of it. The other's entry is positive.
    ///
    /// # Errors
    /// The kernel's rejection when the budget does not reach.
    pub(crate) fn cleared(&self, at: usize, by: &Self, fuel: &Fuel) -> Checked<Self> {
        if let (Self::Words(row), Self::Words(by)) = (self, by) {
            fuel.spend(row.len() as u64)?;
            if let Some(cleared) = cleared(row, at, by) {
                return Ok(Self::Words(cleared));
            }
        }
        let (row, by) = (self.entries(), by.entries());
        let common = row[at].gcd(&by[at]);
        let (factor, pivot) = (&row[at] / &common, &by[at] / &common);
        let mut sums = Vec::with_capacity(row.len());
        let outer = words(&factor) + words(&pivot);
        for (x, y) in row.iter().zip(&by) {
            let size = outer + words(x) + words(y);
            fuel.spend(size)?;
            fuel.spend_beyond(size.saturating_mul(size))?;
            sums.push(x * &pivot - y * &factor);
        }
        Ok(Self::of(sums))
    }

    fn entry(&self, at: usize) -> BigInt {
        match self {
            Self::Words(row) => row[at].into(),
            Self::Long(row) => row[at].clone(),
        }
    }

    fn entries(&self) -> Vec<BigInt> {
        match self {
            Self::Words(row) => row.iter().map(|x| BigInt::from(*x)).collect(),
            Self::Long(row) => row.clone(),
        }
    }
}

/// The same in words; `None` if they do not reach.
fn cleared(row: &[i64], at: usize, by: &[i64]) -> Option<Vec<i64>> {
    let common = row[at].gcd(&by[at]);
    let (factor, pivot) = (i128::from(row[at] / common), i128::from(by[at] / common));
    // products of two words have a sign and 126 bits, so that their difference fits
    let sums: Vec<i128> =
        row.iter().zip(by).map(|(x, y)| i128::from(*x) * pivot - i128::from(*y) * factor).collect();
    let mut content: u128 = 0;
    for sum in &sums {
        content = content.gcd(&sum.unsigned_abs());
        if content == 1 {
            break;
        }
    }
    let content = i128::try_from(content.max(1)).ok()?;
    let word = |sum: i128| {
        let reduced = if content == 1 { sum } else { sum / content };
        i64::try_from(reduced).ok().filter(|x| *x != i64::MIN)
    };
    sums.into_iter().map(word).collect()
}

/// Machine words of a number.
fn words(n: &BigInt) -> u64 {
    1 + n.bits() / 64
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn ray(numbers: &[i128]) -> Ray {
        Ray::of(numbers.iter().map(|n| BigInt::from(*n)).collect())
    }

    /// Small numbers, and such as are just within or beyond a word.
    fn number() -> impl Strategy<Value = i128> {
        let edge = i128::from(i64::MAX);
        prop_oneof![
            4 => -9i128..=9,
            1 => (edge - 2)..=(edge + 3),
            1 => (-edge - 3)..=(2 - edge),
            1 => -(1i128 << 90)..=(1i128 << 90),
        ]
    }

    proptest! {
        /// In rationals, entry by entry: row − row[at]/by[at]·by, up to a positive factor.
        #[test]
        fn clearing_is_elimination_up_to_a_factor(
            row in prop::collection::vec(number(), 5),
            by in prop::collection::vec(number(), 5),
            at in 0usize..5,
        ) {
            prop_assume!(by[at] > 0);
            let fuel = Fuel::new(1 << 30);
            let cleared = ray(&row).cleared(at, &ray(&by), &fuel).expect("there is fuel");
            prop_assert_eq!(cleared.sign(at), Ordering::Equal);
            let q = |n: i128| BigRational::from_integer(n.into());
            let by_ray = ray(&by);
            let expected: Vec<BigRational> = (0..5)
                .map(|j| q(row[j]) - q(row[at]) * by_ray.quotient(j, at))
                .collect();
            for i in 0..5 {
                let sign = expected[i].cmp(&BigRational::zero());
                prop_assert_eq!(cleared.sign(i), sign);
                for j in 0..5 {
                    if sign.is_ne() {
                        prop_assert_eq!(cleared.quotient(j, i), &expected[j] / &expected[i]);
                    }
                }
            }
        }

        #[test]
        fn quotients_compare_as_fractions(
            (a, b) in (number(), number()),
            (c, d) in (1i128..1 << 70, 1i128..1 << 70),
        ) {
            let order = (BigRational::new(a.into(), c.into())).cmp(&BigRational::new(b.into(), d.into()));
            prop_assert_eq!(ray(&[a, c]).compare(&ray(&[b, d]), 0, 1), order);
        }
    }
}
