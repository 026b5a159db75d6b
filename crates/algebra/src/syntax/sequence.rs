//! Indices, powers with an index for exponent, and sequences.
//!
//! An index is a symbol declared by `var n in N`, a natural number. The power bⁿ is a symbol of its own,
//! `pow(b, n)`, and so is the term s(n) of a sequence that is defined by its first term and its step.
//! Nothing is known of such a symbol but what [`next`](Sequences::next) writes for the next index and
//! [`at`](Sequences::at) for a number in the place of the index. The bases of powers and the steps of
//! sequences are total, so that the symbols stand for real numbers at all indices.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use kane_kernel::{Expr, Relation};
use num_rational::BigRational;
use num_traits::{Signed as _, ToPrimitive as _, Zero as _};

use super::rebuild::rebuild;
use super::value::size;

/// The greatest number that is put in the place of an index.
pub const MAX_INDEX: u32 = 64;
/// Parts of an expression that is written out.
const MAX_PARTS: usize = 20_000;

/// Operations on top of each other in such an expression.
const MAX_DEPTH: usize = 400;

/// What the value of a symbol comes from.
#[derive(Clone, Debug)]
enum Source {
    /// of bⁿ the base b
    Power(Expr),
    /// of s(n) the term s(0), and s(n+1) in terms of s(n)
    Recursion(Expr, Expr),
}

/// The indices of a document, and the symbols that stand for powers and for terms of sequences.
#[derive(Clone, Debug, Default)]
pub struct Sequences {
    indices: BTreeSet<usize>,
    /// by symbol its index, and what it comes from
    sources: BTreeMap<usize, (usize, Source)>,
}

/// A sum of whole multiples of indices, and a whole number.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Linear {
    /// by index
    pub(crate) times: BTreeMap<usize, i64>,
    pub(crate) plus: i64,
}

impl Linear {
    fn number(plus: i64) -> Self {
        Self { times: BTreeMap::new(), plus }
    }

    fn scaled(mut self, by: i64) -> Option<Self> {
        self.plus = self.plus.checked_mul(by)?;
        for n in self.times.values_mut() {
            *n = n.checked_mul(by)?;
        }
        self.times.retain(|_, n| *n != 0);
        Some(self)
    }

    fn plus(mut self, other: Self) -> Option<Self> {
        self.plus = self.plus.checked_add(other.plus)?;
        for (index, n) in other.times {
            let sum = self.times.entry(index).or_insert(0);
            *sum = sum.checked_add(n)?;
        }
        self.times.retain(|_, n| *n != 0);
        Some(self)
    }
}

/// Operations on the longest path to a leaf.
fn height(e: &Expr) -> usize {
    1 + e.children().into_iter().map(height).max().unwrap_or(0)
}

/// A number as an expression.
fn number(n: u32) -> Expr {
    Expr::Num(BigRational::from_integer(n.into()))
}

/// `a^n`, or what it is for an n below 2.
pub(crate) fn power(a: Expr, n: i32) -> Expr {
    match n {
        1 => a,
        _ => Expr::Pow(a.into(), n),
    }
}

/// The expression with others in the place of symbols, which `other` gives with the parts that they count
/// for; nothing if that comes to too many, or if `other` fails.
fn written_out(
    e: &Expr,
    mut other: impl FnMut(usize) -> Result<Option<(Expr, usize)>, ()>,
) -> Option<Expr> {
    let mut parts = 0_usize;
    let mut replace = |part: &Expr| {
        parts += 1;
        if parts > MAX_PARTS {
            return Err(());
        }
        let Expr::Var(v) = part else { return Ok(None) };
        let found = other(*v)?;
        Ok(found.map(|(e, more)| {
            parts += more;
            e
        }))
    };
    rebuild(e, &mut replace).ok()
}

impl Sequences {
    /// Whether nothing of the kind is declared.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    pub(crate) fn add_index(&mut self, symbol: usize) {
        self.indices.insert(symbol);
    }

    pub(crate) fn add_power(&mut self, symbol: usize, base: Expr, index: usize) {
        self.sources.insert(symbol, (index, Source::Power(base)));
    }

    pub(crate) fn add_recursion(&mut self, symbol: usize, index: usize, first: Expr, next: Expr) {
        self.sources.insert(symbol, (index, Source::Recursion(first, next)));
    }

    /// The index on which the value of a symbol depends, if it does: the symbol itself, or the one of a
    /// power or of a term.
    #[must_use]
    pub fn index_of(&self, symbol: usize) -> Option<usize> {
        match self.indices.contains(&symbol) {
            true => Some(symbol),
            false => self.sources.get(&symbol).map(|(index, _)| *index),
        }
    }

    /// The expressions that the values of a power or of a term come from.
    #[must_use]
    pub fn made_of(&self, symbol: usize) -> Vec<&Expr> {
        match self.sources.get(&symbol) {
            Some((_, Source::Power(base))) => vec![base],
            Some((_, Source::Recursion(first, next))) => vec![first, next],
            None => Vec::new(),
        }
    }

    /// What an expression is as a sum of whole multiples of indices; nothing if it is none.
    pub(crate) fn linear(&self, e: &Expr) -> Option<Linear> {
        let pair = |a: &Expr, b: &Expr| Some((self.linear(a)?, self.linear(b)?));
        match e {
            Expr::Num(q) if q.is_integer() => Some(Linear::number(q.numer().to_i64()?)),
            Expr::Var(v) if self.indices.contains(v) => {
                Some(Linear { times: [(*v, 1)].into(), plus: 0 })
            }
            Expr::Neg(a) => self.linear(a)?.scaled(-1),
            Expr::Add(a, b) => pair(a, b).and_then(|(a, b)| a.plus(b)),
            Expr::Sub(a, b) => pair(a, b).and_then(|(a, b)| a.plus(b.scaled(-1)?)),
            Expr::Mul(a, b) => match pair(a, b)? {
                (a, b) if a.times.is_empty() => b.scaled(a.plus),
                (a, b) if b.times.is_empty() => a.scaled(b.plus),
                _ => None,
            },
            _ => None,
        }
    }

    /// The expression with n + 1 in the place of the index n; nothing if it comes to too much.
    #[must_use]
    pub fn next(&self, e: &Expr, n: usize) -> Option<Expr> {
        let done = written_out(e, |v| {
            if v == n {
                return Ok(Some((Expr::Add(Expr::Var(v).into(), Expr::int(1).into()), 0)));
            }
            Ok(match self.sources.get(&v) {
                Some((index, Source::Power(base))) if *index == n => {
                    Some((Expr::Mul(base.clone().into(), Expr::Var(v).into()), 0))
                }
                Some((index, Source::Recursion(_, next))) if *index == n => {
                    Some((next.clone(), size(next)))
                }
                _ => None,
            })
        })?;
        (height(&done) <= MAX_DEPTH).then_some(done)
    }

    /// The expression with a number in the place of the index n; nothing if it comes to too much.
    #[must_use]
    pub fn at(&self, e: &Expr, n: usize, value: u32) -> Option<Expr> {
        if value > MAX_INDEX {
            return None;
        }
        let mut terms = HashMap::new();
        let done = self.put_in(e, n, value, &mut terms)?;
        (size(&done) <= MAX_PARTS && height(&done) <= MAX_DEPTH).then_some(done)
    }

    /// A relation with n + 1 in the place of the index n; nothing if it comes to too much.
    #[must_use]
    pub fn next_relation(&self, r: &Relation, n: usize) -> Option<Relation> {
        let (lhs, rhs) = (self.next(&r.lhs, n)?, self.next(&r.rhs, n)?);
        Some(Relation { lhs, rel: r.rel, rhs })
    }

    /// A relation with a number in the place of the index n; nothing if it comes to too much.
    #[must_use]
    pub fn relation_at(&self, r: &Relation, n: usize, value: u32) -> Option<Relation> {
        let (lhs, rhs) = (self.at(&r.lhs, n, value)?, self.at(&r.rhs, n, value)?);
        Some(Relation { lhs, rel: r.rel, rhs })
    }

    fn put_in(
        &self,
        e: &Expr,
        n: usize,
        value: u32,
        terms: &mut HashMap<(usize, u32), Expr>,
    ) -> Option<Expr> {
        written_out(e, |v| {
            if v == n {
                return Ok(Some((number(value), 0)));
            }
            let Some((_, source)) = self.sources.get(&v).filter(|(index, _)| *index == n) else {
                return Ok(None);
            };
            let done = match source {
                Source::Power(base) => {
                    Expr::Pow(base.clone().into(), i32::try_from(value).map_err(|_| ())?)
                }
                Source::Recursion(..) => self.term(v, n, value, terms).ok_or(())?,
            };
            let parts = size(&done);
            Ok(Some((done, parts)))
        })
    }

    /// The term of a sequence at a number.
    fn term(
        &self,
        symbol: usize,
        n: usize,
        value: u32,
        terms: &mut HashMap<(usize, u32), Expr>,
    ) -> Option<Expr> {
        if let Some(known) = terms.get(&(symbol, value)) {
            return Some(known.clone());
        }
        let Some((_, Source::Recursion(first, next))) = self.sources.get(&symbol) else {
            return None;
        };
        // from below, so that no term is deeper than one step above one that is known
        let mut last = first.clone();
        terms.insert((symbol, 0), last.clone());
        for k in 0..value {
            last = match terms.get(&(symbol, k + 1)) {
                Some(known) => known.clone(),
                None => self.put_in(next, n, k, terms)?,
            };
            if size(&last) > MAX_PARTS {
                return None;
            }
            terms.insert((symbol, k + 1), last.clone());
        }
        Some(last)
    }
}

/// Bounds of bⁿ for all n, from the bounds of b: each a number and whether it is excluded.
type Ends = [Option<(BigRational, bool)>; 2];

/// What the bounds of the base say of all its powers: bⁿ is positive if b is, at most 1 if b is between
/// 0 and 1, and at least 1 if b is.
pub(crate) fn bounds_of_power(base: Ends) -> Ends {
    let one = BigRational::from_integer(1.into());
    let [lower, upper] = base;
    let Some((low, strict)) = lower.filter(|(low, _)| !low.is_negative()) else {
        return [None, None];
    };
    let below = upper.is_some_and(|(high, _)| high <= one).then(|| (one.clone(), false));
    let above = match low >= one {
        true => (one, false),
        false => (BigRational::zero(), low.is_positive() || strict),
    };
    [Some(above), below]
}
