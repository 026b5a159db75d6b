//! Products of symbols with whole powers: what stands in an exponential, as `c*t/m` in `exp(-c*t/m)`.

use std::collections::BTreeMap;

use kane_kernel::Expr;

/// A product of powers of symbols, none of which is 0; in the order of the symbols.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(Vec<(usize, i32)>);

impl Monomial {
    /// A symbol alone.
    #[must_use]
    pub fn symbol(v: usize) -> Self {
        Self(vec![(v, 1)])
    }

    /// The product of these powers.
    #[must_use]
    pub fn of(powers: impl IntoIterator<Item = (usize, i32)>) -> Self {
        let mut whole = Self::default();
        for (v, n) in powers {
            whole = whole.times(&Self(vec![(v, n)]));
        }
        whole
    }

    /// The symbols with their powers.
    #[must_use]
    pub fn powers(&self) -> &[(usize, i32)] {
        &self.0
    }

    /// The symbol that it is, if it is one alone.
    #[must_use]
    pub fn as_symbol(&self) -> Option<usize> {
        match self.0.as_slice() {
            [(v, 1)] => Some(*v),
            _ => None,
        }
    }

    /// Whether the symbol is in it.
    #[must_use]
    pub fn contains(&self, v: usize) -> bool {
        self.0.iter().any(|(known, _)| *known == v)
    }

    /// The symbols in it.
    pub fn symbols(&self) -> impl Iterator<Item = usize> {
        self.0.iter().map(|(v, _)| *v)
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut powers: BTreeMap<usize, i32> = self.0.iter().copied().collect();
        for (v, n) in &other.0 {
            let known = powers.entry(*v).or_default();
            *known = known.saturating_add(*n);
        }
        Self(powers.into_iter().filter(|(_, n)| *n != 0).collect())
    }

    pub(crate) fn raised(&self, n: i32) -> Self {
        Self(self.0.iter().map(|(v, m)| (*v, m.saturating_mul(n))).filter(|p| p.1 != 0).collect())
    }

    /// It as an expression. Exact.
    #[must_use]
    pub fn expr(&self) -> Expr {
        let power = |(v, n): (usize, i32)| match n {
            1 => Expr::Var(v),
            n => Expr::Pow(Expr::Var(v).into(), n),
        };
        let of_sign = |sign: i32| {
            let found = self.0.iter().filter(move |(_, n)| n.signum() == sign);
            found.map(|(v, n)| (*v, n.abs()))
        };
        let product = |a: Expr, b: Expr| Expr::Mul(a.into(), b.into());
        let above = of_sign(1).map(power).reduce(product).unwrap_or(Expr::int(1));
        of_sign(-1).map(power).fold(above, |whole, below| Expr::Div(whole.into(), below.into()))
    }

    /// Its derivative by a symbol. Exact; 0 where the symbol is not in it.
    #[must_use]
    pub fn slope(&self, v: usize) -> Expr {
        let Some((_, n)) = self.0.iter().find(|(known, _)| *known == v) else {
            return Expr::int(0);
        };
        let rest = self.times(&Self(vec![(v, -1)])).expr();
        match n {
            1 => rest,
            n => Expr::Mul(Expr::int(i64::from(*n)).into(), rest.into()),
        }
    }
}
