//! Expressions read as rational functions, and how large they may grow.

use std::collections::HashMap;

use kane_kernel::{Context, Expr, Poly};
use kane_number::Number as _;

use super::{Foreign, NotRational, RationalFunction};

/// Bounds on what is handed to the gcd: terms, degree in a symbol, bits of a coefficient. The worst
/// measured within them took 0.1 s, and its conditions 0.8 s.
const MAX_TERMS: usize = 10_000;
const MAX_DEGREE: u32 = 256;
const MAX_BITS: u64 = 1 << 16;
/// An upper bound on the size of a polynomial.
struct Size {
    terms: usize,
    /// in each symbol
    degrees: Vec<u32>,
    bits: u64,
}

impl Size {
    fn of(p: &Foreign) -> Self {
        let bits = p.terms.iter().map(|(_, c)| c.numer().bits() + c.denom().bits()).max();
        Self {
            terms: p.terms.len(),
            degrees: (0..p.nvars).map(|v| p.degree(v)).collect(),
            bits: bits.unwrap_or(0),
        }
    }

    fn times(&self, other: &Self) -> Self {
        let (long, short) = if self.degrees.len() < other.degrees.len() {
            (&other.degrees, &self.degrees)
        } else {
            (&self.degrees, &other.degrees)
        };
        let mut degrees = long.clone();
        for (sum, degree) in degrees.iter_mut().zip(short) {
            *sum = sum.saturating_add(*degree);
        }
        Self {
            terms: self.terms.saturating_mul(other.terms),
            degrees,
            bits: self.bits.saturating_add(other.bits),
        }
    }

    /// Of the n-th power: as many terms as there are products of n terms, order aside.
    fn power(self, n: u32) -> Self {
        let most = usize::try_from(n).unwrap_or(usize::MAX);
        let products = (1..self.terms).try_fold(1usize, |count, i| {
            let count = count.checked_mul(most.checked_add(i)?)? / i;
            (count <= MAX_TERMS).then_some(count)
        });
        let growth = self.bits + u64::from(usize::BITS - self.terms.leading_zeros());
        Self {
            terms: products.unwrap_or(usize::MAX),
            degrees: self.degrees.iter().map(|d| d.saturating_mul(n)).collect(),
            bits: growth.saturating_mul(n.into()),
        }
    }

    fn fits(&self) -> bool {
        let degrees = self.degrees.iter().map(|d| usize::try_from(*d).unwrap_or(usize::MAX));
        let monomials = degrees.fold(1usize, |count, d| count.saturating_mul(d.saturating_add(1)));
        self.terms.min(monomials) <= MAX_TERMS
            && self.degrees.iter().all(|d| *d <= MAX_DEGREE)
            && self.bits <= MAX_BITS
    }
}

/// Whether a quotient of these is small enough to be brought to lowest terms.
pub(super) fn affordable(num: &Poly, den: &Poly) -> bool {
    let fits = |p: &Poly| p.len() <= MAX_TERMS && p.bits() <= MAX_BITS;
    let low = |p: &Poly| p.terms().all(|(m, _)| m.iter().all(|&(_, e)| e <= MAX_DEGREE));
    [num, den].into_iter().all(|p| fits(p) && low(p))
}

/// A reader of expressions.
pub(super) struct Reader<'a> {
    pub(super) context: &'a Context,
    /// definitions read so far
    pub(super) known: HashMap<usize, RationalFunction>,
}

impl Reader<'_> {
    /// What an expression says that may use the definitions below an index.
    pub(super) fn read(
        &mut self,
        expr: &Expr,
        below: usize,
    ) -> Result<RationalFunction, NotRational> {
        Ok(match expr {
            Expr::Num(q) => q.clone().into(),
            Expr::Var(v) if *v < self.context.vars.len() => RationalFunction::symbol(*v),
            Expr::Let(i) if *i < below => self.definition(*i)?,
            Expr::Var(_) | Expr::Let(_) => return Err(NotRational::Unknown),
            Expr::Neg(a) => -self.read(a, below)?,
            Expr::Add(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a + b
            }
            Expr::Sub(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a - b
            }
            Expr::Mul(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a * b
            }
            Expr::Div(a, b) => {
                let (a, b) = self.both(a, b, below)?;
                a.checked_div(&b).ok_or(NotRational::DivisionByZero)?
            }
            Expr::Pow(a, n) => {
                let a = self.read(a, below)?;
                let fits = |p: &Foreign| Size::of(p).power(n.unsigned_abs()).fits();
                if !fits(a.value.num()) || !fits(a.value.den()) {
                    return Err(NotRational::TooLarge);
                }
                a.powi(*n).ok_or(NotRational::DivisionByZero)?
            }
            Expr::Deriv(f, x) => {
                let f = self.read(f, below)?;
                let of_x = |v: &usize| self.context.vars.get(*v).is_some_and(|v| v.of == Some(*x));
                if f.symbols().iter().any(of_x) {
                    return Err(NotRational::NotExplicit);
                }
                f.derivative(*x)
            }
            Expr::Abs(_) => return Err(NotRational::Operation("abs")),
            Expr::Min(..) => return Err(NotRational::Operation("min")),
            Expr::Max(..) => return Err(NotRational::Operation("max")),
            Expr::Sqrt(_) => return Err(NotRational::Operation("sqrt")),
            Expr::Cases(..) => return Err(NotRational::Operation("cases")),
        })
    }

    /// Both operands, small enough to be combined.
    fn both(
        &mut self,
        a: &Expr,
        b: &Expr,
        below: usize,
    ) -> Result<(RationalFunction, RationalFunction), NotRational> {
        let (a, b) = (self.read(a, below)?, self.read(b, below)?);
        let size = |f: &RationalFunction| (Size::of(f.value.num()), Size::of(f.value.den()));
        let ((n, d), (m, e)) = (size(&a), size(&b));
        let crossed = [n.times(&e), m.times(&d), n.times(&m), d.times(&e)];
        if crossed.iter().all(Size::fits) { Ok((a, b)) } else { Err(NotRational::TooLarge) }
    }

    fn definition(&mut self, index: usize) -> Result<RationalFunction, NotRational> {
        if let Some(known) = self.known.get(&index) {
            return Ok(known.clone());
        }
        let context = self.context;
        let definition = context.lets.get(index).ok_or(NotRational::Unknown)?;
        let read = self.read(&definition.body, index)?;
        self.known.insert(index, read.clone());
        Ok(read)
    }
}
