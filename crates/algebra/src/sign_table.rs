//! Sign tables: the real line cut at all roots of some polynomials, complete in one variable.

use std::cmp::Ordering;

use kane_kernel::{Fuel, Rejection, Root, sign_at};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use crate::coprime::{coprime_bases, factor_over};
use crate::descartes::descartes;
use crate::work::spend_fraction;

type Q = BigRational;

/// A cut line: the kernel confirms it by Descartes' rule.
#[derive(Clone, Debug)]
pub struct SignTable {
    /// polynomials without common or repeated roots
    pub bases: Vec<Vec<BigInt>>,
    /// their roots and auxiliary cuts, ascending
    pub roots: Vec<Root>,
    /// each input as constant · Π baseᵢ^eᵢ
    pub factored: Vec<(Q, Vec<u32>)>,
}

/// A cell of the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cell {
    /// the open gap before root i (after the last one if i is their number)
    Gap(usize),
    /// root i
    Root(usize),
}

/// Halvings of one interval before giving up.
const MAX_HALVINGS: usize = 4096;

impl SignTable {
    /// Cuts the line at the roots of all `polys` (coefficients from x⁰ up, none of them zero), and at what else the kernel
    /// needs to see by Descartes' rule that there are no other roots.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn new(polys: &[Vec<BigInt>], fuel: &Fuel) -> Result<Self, Rejection> {
        let Self { bases, roots, factored } = Self::at_roots(polys, fuel)?;
        let roots = separate(roots, fuel, &|root| is_lone(&bases, root, fuel))?;
        let roots = cut_gaps(&bases, roots, fuel)?;
        Ok(Self { bases, roots, factored })
    }

    /// The same cut at the roots alone, for those who look for a point and prove nothing: where roots lie near each other
    /// it takes a fraction of the work.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn at_roots(polys: &[Vec<BigInt>], fuel: &Fuel) -> Result<Self, Rejection> {
        let bases = coprime_bases(polys, fuel)?;
        let factored =
            polys.iter().map(|p| factor_over(p, &bases, fuel)).collect::<Result<Vec<_>, _>>()?;
        let mut roots = Vec::new();
        for base in &bases {
            isolate(base, &mut roots, fuel)?;
        }
        let roots = separate(roots, fuel, &|_| Ok(true))?;
        Ok(Self { bases, roots, factored })
    }

    /// All cells from left to right.
    pub fn cells(&self) -> impl Iterator<Item = Cell> {
        let n = self.roots.len();
        (0..n).flat_map(|i| [Cell::Gap(i), Cell::Root(i)]).chain([Cell::Gap(n)])
    }

    /// Sign of input `i` on a cell.
    #[must_use]
    pub fn sign(&self, i: usize, cell: Cell) -> i8 {
        let (constant, powers) = &self.factored[i];
        let mut sign = kane_kernel::sign(constant.numer());
        for (base, n) in self.bases.iter().zip(powers) {
            if *n == 0 {
                continue;
            }
            match self.base_sign(base, cell) {
                0 => return 0,
                s if s < 0 && n % 2 == 1 => sign = -sign,
                _ => {}
            }
        }
        sign
    }

    fn base_sign(&self, base: &[BigInt], cell: Cell) -> i8 {
        match cell {
            Cell::Gap(_) => sign_at(base, &self.sample(cell)),
            Cell::Root(i) => {
                let root = &self.roots[i];
                if root.is_exact() {
                    sign_at(base, &root.lo)
                } else if root.poly == base {
                    0
                } else {
                    sign_at(base, &root.lo)
                }
            }
        }
    }

    /// The simplest rational in a gap, or the rational at an exact root; for an irrational root
    /// the left end of its interval.
    #[must_use]
    pub fn sample(&self, cell: Cell) -> Q {
        match cell {
            Cell::Root(i) => self.roots[i].lo.clone(),
            Cell::Gap(i) => {
                let lo = i.checked_sub(1).and_then(|j| self.roots.get(j)).map(|r| &r.hi);
                let hi = self.roots.get(i).map(|r| &r.lo);
                match (lo, hi) {
                    (Some(a), Some(b)) if a == b => a.clone(),
                    _ => simplest_between(lo, hi),
                }
            }
        }
    }

    /// Simple rationals in the gap before root i, near its ends: within 1/1024 and within 1/8 of its width; none where it
    /// has one end.
    ///
    /// # Errors
    /// [`Rejection::Budget`].
    pub fn near_ends(&self, i: usize, fuel: &Fuel) -> Result<Vec<Q>, Rejection> {
        let end = |i: usize| self.roots.get(i).cloned();
        let (Some(mut left), Some(mut right)) = (i.checked_sub(1).and_then(end), end(i)) else {
            return Ok(Vec::new());
        };
        let fine = Q::from_integer(1024.into());
        let is_coarse = |root: &Root, width: &Q| (&root.hi - &root.lo) * &fine > *width;
        let mut width = &right.lo - &left.hi;
        for _ in 0..MAX_HALVINGS {
            match (is_coarse(&left, &width), is_coarse(&right, &width)) {
                (false, false) => break,
                (true, _) => refine(&mut left, fuel)?,
                (false, true) => refine(&mut right, fuel)?,
            }
            width = &right.lo - &left.hi;
        }
        let mut near = Vec::new();
        for part in [1024, 8] {
            let part = &width / Q::from_integer(part.into());
            let half = &part / Q::from_integer(2.into());
            let inward =
                |from: &Q, a: &Q, b: &Q| simplest_between(Some(&(from + a)), Some(&(from + b)));
            near.push(inward(&left.hi, &half, &part));
            near.push(inward(&right.lo, &-&part, &-&half));
        }
        Ok(near)
    }
}

/// A power of two beyond all roots in absolute value: 2·max |aₙ₋ₖ/aₙ|^(1/k), rounded up (Fujiwara 1916).
fn root_bound(p: &[BigInt]) -> BigInt {
    let bits = |c: &BigInt| i64::try_from(c.bits()).unwrap_or(i64::MAX);
    let lead = p.last().map_or(1, bits);
    let lower = (1i64..).zip(p.iter().rev().skip(1)).filter(|(_, c)| !c.is_zero());
    // |aₙ₋ₖ| < 2^bits, and |aₙ| ≥ 2^(lead − 1)
    let exponent = lower.map(|(k, c)| (bits(c) - lead + 1).div_euclid(k) + 1).max();
    BigInt::one() << (exponent.unwrap_or(0).max(0) + 1)
}

fn isolate(base: &[BigInt], out: &mut Vec<Root>, fuel: &Fuel) -> Result<(), Rejection> {
    if let [c, d] = base {
        let at = -Q::new(c.clone(), d.clone());
        out.push(Root { poly: base.to_vec(), lo: at.clone(), hi: at });
        return Ok(());
    }
    let bound = Q::from_integer(root_bound(base));
    let mut todo = vec![(-bound.clone(), bound, 0usize)];
    while let Some((lo, hi, depth)) = todo.pop() {
        if depth > MAX_HALVINGS {
            return Err(Rejection::Budget);
        }
        match descartes(base, Some(&lo), Some(&hi), fuel)? {
            0 => {}
            1 => out.push(Root { poly: base.to_vec(), lo, hi }),
            _ => {
                let mid = midpoint(&lo, &hi, fuel)?;
                if value_sign(base, &mid, fuel)? == 0 {
                    out.push(Root { poly: base.to_vec(), lo: mid.clone(), hi: mid.clone() });
                }
                todo.push((lo, mid.clone(), depth + 1));
                todo.push((mid, hi, depth + 1));
            }
        }
    }
    Ok(())
}

/// Halves an interval around a root, or finds the root.
///
/// # Errors
/// [`Rejection::Budget`].
pub fn refine(root: &mut Root, fuel: &Fuel) -> Result<(), Rejection> {
    let mid = midpoint(&root.lo, &root.hi, fuel)?;
    // A root at an end of the interval is another one: compare with a sign just inside.
    match (value_sign(&root.poly, &mid, fuel)?, value_sign(&root.poly, &root.hi, fuel)?) {
        (0, _) => {
            root.lo = mid.clone();
            root.hi = mid;
        }
        // Both ends may be other roots; Descartes' rule is exact on halves with one root or none.
        (_, 0) => match descartes(&root.poly, Some(&root.lo), Some(&mid), fuel)? {
            1 => root.hi = mid,
            _ => root.lo = mid,
        },
        (s, h) if s == h => root.hi = mid,
        _ => root.lo = mid,
    }
    Ok(())
}

/// (a + b)/2. A fraction in lowest terms takes a common divisor, which takes the square of its size.
pub(crate) fn midpoint(a: &Q, b: &Q, fuel: &Fuel) -> Result<Q, Rejection> {
    let words = size(a).saturating_add(size(b));
    spend_fraction(words, fuel)?;
    Ok(if a.denom() == b.denom() {
        Q::new(a.numer() + b.numer(), a.denom() * 2)
    } else {
        Q::new(a.numer() * b.denom() + b.numer() * a.denom(), a.denom() * b.denom() * 2)
    })
}

/// The order of two fractions by their cross products: as continued fractions, which their own order compares, nearby
/// ones of many digits take a division for each digit or two.
fn order(a: &Q, b: &Q) -> Ordering {
    if a.denom() == b.denom() {
        return a.numer().cmp(b.numer());
    }
    (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
}

/// Words of a fraction.
fn size(x: &Q) -> u64 {
    1 + (x.numer().bits() + x.denom().bits()) / 64
}

/// The sign of a value, within the budget: Horner's rule on numbers that grow by the size of x in
/// each step. Its three products a step are of long integers, however short these are.
fn value_sign(p: &[BigInt], x: &Q, fuel: &Fuel) -> Result<i8, Rejection> {
    let degree = u64::try_from(p.len()).unwrap_or(u64::MAX);
    let words = 1 + degree.saturating_mul(x.numer().bits() + x.denom().bits()) / 64;
    fuel.spend(degree.saturating_mul(words))?;
    fuel.spend_beyond(degree.saturating_mul(8))?;
    Ok(sign_at(p, x))
}

/// Shrinks intervals until they are disjoint, and each is as it is asked for.
fn separate(
    roots: Vec<Root>,
    fuel: &Fuel,
    is_lone: &dyn Fn(&Root) -> Result<bool, Rejection>,
) -> Result<Vec<Root>, Rejection> {
    // with each root, whether its interval was found to be as asked for: only a halving changes that
    let mut lone: Vec<(Root, bool)> = roots.into_iter().map(|root| (root, false)).collect();
    for _ in 0..MAX_HALVINGS {
        lone.sort_by(|(a, _), (b, _)| order(&a.lo, &b.lo).then_with(|| order(&a.hi, &b.hi)));
        let mut dirty = false;
        for i in 0..lone.len() {
            let root = &lone[i].0;
            if root.is_exact() {
                continue;
            }
            let after = |left: &Root, right: &Root| order(&left.hi, &right.lo).is_lt();
            let apart = (i == 0 || after(&lone[i - 1].0, root))
                && lone.get(i + 1).is_none_or(|next| after(root, &next.0));
            if apart && !lone[i].1 {
                lone[i].1 = is_lone(&lone[i].0)?;
            }
            if !(apart && lone[i].1) {
                refine(&mut lone[i].0, fuel)?;
                lone[i].1 = false;
                dirty = true;
            }
        }
        if !dirty {
            return Ok(lone.into_iter().map(|(root, _)| root).collect());
        }
    }
    Err(Rejection::Budget)
}

/// Whether no base vanishes at an end of the interval of a root, and none but its own has a sign change inside.
fn is_lone(bases: &[Vec<BigInt>], root: &Root, fuel: &Fuel) -> Result<bool, Rejection> {
    for base in bases {
        let vanishes = |x| Ok(value_sign(base, x, fuel)? == 0);
        if vanishes(&root.lo)? || vanishes(&root.hi)? {
            return Ok(false);
        }
        let is_other = *base != root.poly;
        if is_other && descartes(base, Some(&root.lo), Some(&root.hi), fuel)? != 0 {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Cuts gaps at rational points until Descartes' rule sees that they hold no root.
fn cut_gaps(bases: &[Vec<BigInt>], roots: Vec<Root>, fuel: &Fuel) -> Result<Vec<Root>, Rejection> {
    let mut out: Vec<Root> = Vec::new();
    let mut todo: Vec<Option<Root>> = roots.into_iter().map(Some).rev().collect();
    todo.insert(0, None);
    let mut cuts = 0;
    while let Some(next) = todo.pop() {
        let lo = out.last().map(|r| &r.hi);
        let hi = next.as_ref().map(|r| &r.lo);
        let mut clear = true;
        // of a line the only root is known, and so in no gap
        for base in bases.iter().filter(|base| base.len() > 2) {
            clear = clear && descartes(base, lo, hi, fuel)? == 0;
        }
        if clear {
            match next {
                Some(root) => out.push(root),
                None => return Ok(out),
            }
            continue;
        }
        cuts += 1;
        if cuts > MAX_HALVINGS {
            return Err(Rejection::Budget);
        }
        let beyond = bases.iter().map(|p| root_bound(p)).max().unwrap_or_else(BigInt::one);
        let beyond = Q::from_integer(beyond);
        let at = match (lo, hi) {
            (Some(a), Some(b)) => midpoint(a, b, fuel)?,
            (Some(a), None) => beyond.max(a + Q::one()),
            (None, Some(b)) => (-beyond).min(b - Q::one()),
            (None, None) => Q::zero(),
        };
        todo.push(next);
        let poly = vec![-at.numer(), at.denom().clone()];
        todo.push(Some(Root { poly, lo: at.clone(), hi: at }));
    }
    Ok(out)
}

/// The rational with the smallest denominator, then numerator, strictly between two ends.
#[must_use]
pub fn simplest_between(lo: Option<&Q>, hi: Option<&Q>) -> Q {
    let zero = Q::zero();
    let above = lo.is_none_or(|a| *a < zero);
    let below = hi.is_none_or(|b| *b > zero);
    match (above, below) {
        (true, true) => zero,
        (_, false) => match hi {
            // All negative: mirror.
            Some(b) => -simplest_between(Some(&-b), lo.map(|a| -a).as_ref()),
            None => zero,
        },
        (false, true) => {
            let a = lo.cloned().unwrap_or_else(Q::zero);
            let next = a.floor() + Q::one();
            if hi.is_none_or(|b| next < *b) {
                return next;
            }
            // Same integer part: recurse into the reciprocal of the fraction.
            let whole = a.floor();
            let upper = hi.map(|b| b - &whole).unwrap_or_else(Q::one);
            let low = &a - &whole;
            let inverse_hi = (!low.is_zero()).then(|| low.recip());
            whole + simplest_between(Some(&upper.recip()), inverse_hi.as_ref()).recip()
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use num_traits::Signed;
    use polycore::Uni;

    use super::*;
    use crate::coprime::{integers, uni};

    fn fuel() -> Fuel {
        Fuel::new(1 << 40)
    }

    fn ratio(n: i64, d: i64) -> Q {
        Q::new(n.into(), d.into())
    }

    /// Polynomials with planted rational roots, some repeated, times arbitrary ones.
    fn poly() -> impl Strategy<Value = Vec<BigInt>> {
        let free = prop::collection::vec(-4i64..=4, 1..5);
        let roots = prop::collection::vec((-4i64..=4, 1i64..=3, 1u32..=2), 0..3);
        (free, roots)
            .prop_map(|(free, roots)| {
                let free = Uni::new(free.into_iter().map(|c| ratio(c, 1)).collect());
                let planted = roots.into_iter().fold(free, |p, (n, d, e)| {
                    &p * &Uni::new(vec![ratio(-n, 1), ratio(d, 1)]).pow(e)
                });
                integers(&planted)
            })
            .prop_filter("not zero", |p| !p.is_empty())
    }

    /// The table with what a proof needs, and the one at the roots alone.
    fn both(polys: &[Vec<BigInt>]) -> [SignTable; 2] {
        [SignTable::new, SignTable::at_roots].map(|cut| cut(polys, &fuel()).unwrap())
    }

    /// 1 + Σ |aₖ| is beyond all roots of integer coefficients (Cauchy 1829: 1 + max |aₖ| is).
    fn beyond(p: &[BigInt]) -> Q {
        Q::from_integer(p.iter().map(Signed::abs).sum::<BigInt>() + 1)
    }

    proptest! {
        /// Sturm's count (polycore) knows nothing of Descartes' rule, by which the table is made.
        #[test]
        fn the_table_has_as_many_roots_as_sturm_counts(p in poly(), q in poly()) {
            let inputs = [p, q];
            for table in both(&inputs) {
                for (i, p) in inputs.iter().enumerate() {
                    let zeros: Vec<_> = table.cells().filter(|c| table.sign(i, *c) == 0).collect();
                    let p = uni(p);
                    let bound = beyond(&inputs[i]);
                    let count = if p.deg() == 0 { 0 } else { p.sturm(&-&bound, &bound) };
                    prop_assert_eq!(zeros.len(), count);
                    for cell in zeros {
                        let Cell::Root(at) = cell else { panic!("a gap of zeros") };
                        let root = &table.roots[at];
                        if root.is_exact() {
                            prop_assert!(p.eval(&root.lo).is_zero());
                        } else {
                            prop_assert_eq!(p.sturm(&root.lo, &root.hi), 1);
                        }
                    }
                }
            }
        }

        #[test]
        fn all_roots_are_below_their_bound(p in poly()) {
            let bound = Q::from_integer(root_bound(&p));
            let far = beyond(&p);
            let p = uni(&p);
            let count = |end: &Q| if p.deg() == 0 { 0 } else { p.sturm(&-end, end) };
            prop_assert_eq!(count(&bound), count(&far.max(bound.clone())));
            prop_assert!(!p.eval(&bound).is_zero() && !p.eval(&-&bound).is_zero());
        }

        #[test]
        fn points_near_the_ends_of_a_gap_lie_in_it(p in poly(), q in poly()) {
            let inputs = [p, q];
            let table = SignTable::at_roots(&inputs, &fuel()).unwrap();
            for i in 0..=table.roots.len() {
                let near = table.near_ends(i, &fuel()).unwrap();
                prop_assert_eq!(near.is_empty(), i == 0 || i == table.roots.len());
                for x in &near {
                    for (input, p) in inputs.iter().enumerate() {
                        prop_assert_eq!(table.sign(input, Cell::Gap(i)), sign_at(p, x));
                    }
                }
                if let [left, right, ..] = &near[..] {
                    // the table's intervals reach into the gap
                    let width = &table.roots[i].lo - &table.roots[i - 1].hi;
                    prop_assert!(right - left > &width * ratio(99, 100));
                }
            }
        }

        #[test]
        fn signs_in_gaps_are_those_of_any_value_there(
            p in poly(), q in poly(), x in (-60i64..=60, 1i64..=9),
        ) {
            let inputs = [p, q];
            let x = ratio(x.0, x.1);
            for table in both(&inputs) {
                let beyond = |i: usize| i.checked_sub(1).and_then(|i| table.roots.get(i)).is_none_or(|r| r.hi < x);
                let before = |i: usize| table.roots.get(i).is_none_or(|r| x < r.lo);
                for i in (0..=table.roots.len()).filter(|i| beyond(*i) && before(*i)) {
                    for (input, p) in inputs.iter().enumerate() {
                        prop_assert_eq!(table.sign(input, Cell::Gap(i)), sign_at(p, &x));
                    }
                }
            }
        }

        #[test]
        fn roots_ascend_without_overlap(p in poly(), q in poly()) {
            let table = SignTable::new(&[p, q], &fuel()).unwrap();
            for pair in table.roots.windows(2) {
                prop_assert!(pair[0].hi < pair[1].lo || (pair[0].hi == pair[1].lo && pair[0] != pair[1]));
            }
        }

        #[test]
        fn inputs_are_the_products_of_their_factors(p in poly(), q in poly()) {
            let inputs = [p, q];
            let table = SignTable::new(&inputs, &fuel()).unwrap();
            for (p, (constant, powers)) in inputs.iter().zip(&table.factored) {
                let one = Uni::constant(constant.clone());
                let product = table.bases.iter().zip(powers);
                let product = product.fold(one, |a, (base, n)| &a * &uni(base).pow(*n));
                prop_assert_eq!(uni(p), product);
            }
        }

        #[test]
        fn a_refined_interval_keeps_its_root(p in poly(), times in 1usize..20) {
            let table = SignTable::new(std::slice::from_ref(&p), &fuel()).unwrap();
            for root in table.roots.iter().filter(|r| !r.is_exact()) {
                let mut refined = root.clone();
                for _ in 0..times {
                    refine(&mut refined, &fuel()).unwrap();
                }
                prop_assert!(root.lo <= refined.lo && refined.hi <= root.hi);
                let at = |x: &Q| sign_at(&root.poly, x);
                prop_assert!(at(&refined.lo) * at(&refined.hi) < 0 || refined.is_exact() && at(&refined.lo) == 0);
            }
        }

        /// All fractions of small denominators are tried.
        #[test]
        fn simplest_between_is_the_simplest(
            a in prop::option::of((-30i64..=30, 1i64..=12)), b in prop::option::of((-30i64..=30, 1i64..=12)),
        ) {
            let (a, b) = (a.map(|(n, d)| ratio(n, d)), b.map(|(n, d)| ratio(n, d)));
            prop_assume!(a.is_none() || b.is_none() || a < b);
            let found = simplest_between(a.as_ref(), b.as_ref());
            let inside = |x: &Q| a.as_ref().is_none_or(|a| a < x) && b.as_ref().is_none_or(|b| x < b);
            prop_assert!(inside(&found));
            let size = |q: &Q| (q.denom().clone(), q.numer().abs());
            // two fractions differ by 1/144 at least, so a denominator up to 145 lies between
            let all = (1i64..=145).flat_map(|d| (-31 * d..=31 * d).map(move |n| ratio(n, d)));
            let first = all.filter(inside).map(|q| size(&q)).next().map(|first| first.0);
            prop_assert_eq!(first, Some(found.denom().clone()));
            let d = i64::try_from(found.denom()).unwrap();
            let least = (-31 * d..=31 * d).map(|n| ratio(n, d)).filter(inside).map(|q| size(&q)).min();
            prop_assert_eq!(least, Some(size(&found)));
        }
    }

    #[test]
    fn a_spent_budget_is_told() {
        let p: Vec<BigInt> = [-2, 0, 1].map(BigInt::from).to_vec();
        assert_eq!(SignTable::new(&[p], &Fuel::new(1)).err(), Some(Rejection::Budget));
    }
}
