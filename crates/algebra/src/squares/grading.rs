//! Symmetries of a question under scalings xᵢ → λ^wᵢ·xᵢ and changes of sign: what an answer need not contain.

use std::collections::{BTreeMap, BTreeSet};

use kane_kernel::{Monomial, Poly, exponent};
use num_integer::Integer as _;

use super::Question;

/// Weights of the variables by which P, all products and all equations are homogeneous, and sets of variables
/// that may all change their signs at once.
///
/// Between what is homogeneous an identity of the weight of P is looked for. The mean over changes of sign of an
/// identity is an identity in which a square has terms of one parity alone (Gatermann and Parrilo 2004).
#[derive(Clone, Debug)]
pub(super) struct Grading {
    vars: Vec<usize>,
    /// by variable
    weights: Vec<Vec<i64>>,
    /// bits by variable
    signs: Vec<u64>,
}

impl Grading {
    /// All symmetries of a question; none where numbers get large or variables many.
    pub(super) fn of(question: &Question<'_>) -> Self {
        let fixed = || [question.positive].into_iter().chain(question.products);
        let all = || fixed().chain(question.equations);
        let vars: BTreeSet<usize> = all().flat_map(Poly::vars).collect();
        let vars: Vec<usize> = vars.into_iter().collect();
        let out = Self { vars, weights: Vec::new(), signs: Vec::new() };
        if out.vars.len() > 63 {
            return out;
        }
        let row = |m: &[(usize, u32)]| -> Vec<i64> {
            out.vars.iter().map(|&v| i64::from(exponent(m, v))).collect()
        };
        let steps = |p: &Poly| -> BTreeSet<Vec<i64>> {
            let mut rows = p.terms().map(|(m, _)| row(m));
            let first = rows.next().unwrap_or_default();
            rows.map(|r| r.iter().zip(&first).map(|(a, b)| a - b).collect()).collect()
        };
        let bits = |r: &[i64]| r.iter().rev().fold(0, |b, n| 2 * b + u64::from(n.is_odd()));
        let degrees = fixed().flat_map(Poly::terms).map(|(m, _)| bits(&row(m)));
        let parities = degrees.chain(question.equations.iter().flat_map(&steps).map(|r| bits(&r)));
        let signs = orthogonal_signs(parities, out.vars.len());
        let weights = orthogonal(all().flat_map(steps), out.vars.len()).unwrap_or_default();
        Self { weights, signs, ..out }
    }

    /// The weights of the first term of a polynomial, which are those of all of them, `times` over.
    fn weight(&self, m: &[(usize, u32)], times: i64) -> Vec<i64> {
        let of = |w: &Vec<i64>| {
            let each = self.vars.iter().zip(w).map(|(&v, w)| w * i64::from(exponent(m, v)));
            times * each.sum::<i64>()
        };
        self.weights.iter().map(of).collect()
    }

    /// Which changes of sign change that of a monomial.
    fn parity(&self, m: &[(usize, u32)]) -> u64 {
        let odd = |v: &usize| exponent(m, *v) % 2 == 1;
        let bits = self.vars.iter().rev().fold(0, |b, v| 2 * b + u64::from(odd(v)));
        self.signs.iter().fold(0, |out, s| 2 * out + u64::from((s & bits).count_ones() % 2))
    }

    /// Whether a multiple of a polynomial, by a monomial once or twice, has the weights of P.
    fn fits(&self, question: &Question<'_>, p: &Poly, m: &[(usize, u32)], times: i64) -> bool {
        let first = |p: &Poly| p.terms().next().map(|(m, _)| self.weight(m, 1));
        let (Some(whole), Some(own)) = (first(question.positive), first(p)) else { return true };
        let by = self.weight(m, times);
        whole.iter().zip(&own).zip(&by).all(|((whole, own), by)| *whole == own + by)
    }

    /// The monomials whose squares times a product are of use, those of one parity together.
    pub(super) fn bases(
        &self,
        question: &Question<'_>,
        by: &Poly,
        monomials: Vec<Monomial>,
    ) -> impl Iterator<Item = Vec<Poly>> + use<> {
        let mut classes: BTreeMap<u64, Vec<Poly>> = BTreeMap::new();
        for m in monomials {
            if self.fits(question, by, &m, 2) {
                classes.entry(self.parity(&m)).or_default().push(Poly::term(m, 1.into()));
            }
        }
        classes.into_values()
    }

    /// Whether a multiple of an equation by a monomial is of use.
    pub(super) fn cofactor(&self, question: &Question<'_>, equation: &Poly, m: &Monomial) -> bool {
        let own = equation.terms().next().map_or(0, |(first, _)| self.parity(first));
        self.fits(question, equation, m, 1) && self.parity(m) == own
    }
}

/// A basis of the vectors that are orthogonal to all rows; `None` where numbers get too large.
fn orthogonal(rows: impl Iterator<Item = Vec<i64>>, columns: usize) -> Option<Vec<Vec<i64>>> {
    // each row reduced by the ones before it, with a pivot in which the others are 0
    let mut reduced: Vec<(usize, Vec<i64>)> = Vec::new();
    for mut row in rows {
        for (pivot, by) in &reduced {
            row = eliminated(&row, by, *pivot)?;
        }
        let Some(pivot) = row.iter().position(|n| *n != 0) else { continue };
        for (_, other) in &mut reduced {
            *other = eliminated(other, &row, pivot)?;
        }
        reduced.push((pivot, row));
        if reduced.len() == columns {
            return Some(Vec::new());
        }
    }
    let free = (0..columns).filter(|c| reduced.iter().all(|(pivot, _)| pivot != c));
    free.map(|c| {
        let common = reduced.iter().try_fold(1, |l: i64, (pivot, row)| {
            let lead = row[*pivot].abs();
            (l / l.gcd(&lead)).checked_mul(lead)
        })?;
        let mut out = vec![0; columns];
        out[c] = common;
        for (pivot, row) in &reduced {
            out[*pivot] = (-row[c]).checked_mul(common / row[*pivot])?;
        }
        Some(out)
    })
    .collect()
}

/// A row with 0 at the pivot of another one, without common factors.
fn eliminated(row: &[i64], by: &[i64], pivot: usize) -> Option<Vec<i64>> {
    if row[pivot] == 0 {
        return Some(row.to_vec());
    }
    let entry =
        |(x, b): (&i64, &i64)| x.checked_mul(by[pivot])?.checked_sub(b.checked_mul(row[pivot])?);
    let out: Vec<i64> = row.iter().zip(by).map(entry).collect::<Option<_>>()?;
    let common = out.iter().fold(0, |g: i64, n| g.gcd(n)).max(1);
    Some(out.iter().map(|n| n / common).collect())
}

/// A basis of the sets of columns that have an even number of ones with each row.
fn orthogonal_signs(rows: impl Iterator<Item = u64>, columns: usize) -> Vec<u64> {
    let mut reduced: Vec<(u64, u64)> = Vec::new();
    for mut row in rows {
        for (pivot, by) in &reduced {
            if row & pivot != 0 {
                row ^= by;
            }
        }
        if row == 0 {
            continue;
        }
        let pivot = 1 << row.trailing_zeros();
        for (_, other) in &mut reduced {
            if *other & pivot != 0 {
                *other ^= row;
            }
        }
        reduced.push((pivot, row));
        if reduced.len() == columns {
            return Vec::new();
        }
    }
    let pivots = reduced.iter().fold(0, |all, (pivot, _)| all | pivot);
    let free = (0..columns).map(|c| 1 << c).filter(|c: &u64| pivots & c == 0);
    free.map(|c| reduced.iter().filter(|(_, row)| row & c != 0).fold(c, |s, (pivot, _)| s | pivot))
        .collect()
}
