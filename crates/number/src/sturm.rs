//! Counting the real roots of a polynomial by Sturm's theorem.

use num_traits::Signed;
use polycore::Uni;

use crate::{Integer, Ordered, Rational};

/// The chain f, f′, −(f mod f′), … over an exact ordered field, by ascending coefficients.
///
/// It is kept, since asking it is cheap and making it is not.
pub(crate) struct Sturm<N> {
    chain: Vec<Vec<N>>,
}

impl Sturm<Rational> {
    /// The chain of a rational polynomial, each member scaled to coprime integers: unscaled, the
    /// coefficients of the remainders would double in length with each step.
    pub(crate) fn new(polynomial: &Uni<Rational>) -> Self {
        let scaled = |coefficients: Vec<Rational>| {
            let polynomial = Uni::new(coefficients);
            // The sign matters, the size does not.
            polynomial.scale(&polynomial.content().abs().recip()).0
        };
        Self::with(&polynomial.0, scaled)
    }

    /// An integer that is greater in magnitude than every root (Cauchy); none for the zero polynomial.
    fn bound(&self) -> Option<Rational> {
        let polynomial = self.chain.first()?;
        let leading = polynomial.last()?;
        let greatest = polynomial.iter().map(|c| (c / leading).abs()).max()?;
        Some(greatest.ceil() + Integer::from(1))
    }

    /// The number of distinct real roots above x.
    pub(crate) fn count_above(&self, x: &Rational) -> usize {
        self.bound().map_or(0, |bound| self.count(x, &bound))
    }

    /// Whether there is one root from low to high, which is not low itself.
    pub(crate) fn has_one(&self, low: &Rational, high: &Rational) -> bool {
        self.chain.first().is_some_and(|f| !is_zero(&value(f, low))) && self.count(low, high) == 1
    }

    /// An interval (low, high] for each distinct real root, ascending: by halving the interval
    /// that Cauchy's bound gives.
    pub(crate) fn isolate(&self) -> Vec<(Rational, Rational)> {
        let Some(bound) = self.bound() else { return Vec::new() };
        let mut isolated = Vec::new();
        let mut todo = vec![(-bound.clone(), bound)];
        while let Some((low, high)) = todo.pop() {
            match self.count(&low, &high) {
                0 => {}
                1 => isolated.push((low, high)),
                _ => {
                    let middle = (&low + &high) / Integer::from(2);
                    todo.push((middle.clone(), high));
                    todo.push((low, middle));
                }
            }
        }
        isolated
    }
}

impl<N: Ordered> Sturm<N> {
    /// The chain with every member scaled by a positive factor of the caller's choice. The last
    /// coefficient of the polynomial must not be zero.
    pub(crate) fn with(polynomial: &[N], scaled: impl Fn(Vec<N>) -> Vec<N>) -> Self {
        let mut chain = vec![scaled(polynomial.to_vec())];
        let mut next = derivative(polynomial);
        while !next.is_empty() {
            next = scaled(next);
            let rest = opposite_remainder(&chain[chain.len() - 1], &next);
            chain.push(next);
            next = rest;
        }
        Self { chain }
    }

    /// The number of distinct real roots in (low, high], for low ≤ high. Exact.
    ///
    /// Also for polynomials with multiple roots: the chain's last member, the common divisor, is
    /// constant in sign as long as neither end is a multiple root.
    pub(crate) fn count(&self, low: &N, high: &N) -> usize {
        self.changes(low).saturating_sub(self.changes(high))
    }

    fn changes(&self, x: &N) -> usize {
        let values = self.chain.iter().map(|f| value(f, x));
        let signs: Vec<bool> = values.filter(|v| !is_zero(v)).map(|v| is_positive(&v)).collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    }
}

fn value<N: Ordered>(polynomial: &[N], x: &N) -> N {
    polynomial.iter().rev().fold(N::zero(), |sum, c| sum * x + c)
}

fn is_zero<N: Ordered>(number: &N) -> bool {
    number.sign().is_equal() == Some(true)
}

fn is_positive<N: Ordered>(number: &N) -> bool {
    number.sign().is_greater() == Some(true)
}

fn derivative<N: Ordered>(polynomial: &[N]) -> Vec<N> {
    let mut power = N::zero();
    let step = |c: &N| {
        power = power.clone() + N::one();
        c.clone() * &power
    };
    polynomial.iter().skip(1).map(step).collect()
}

/// −(f mod g), without leading zeros; the last coefficient of g is not zero.
fn opposite_remainder<N: Ordered>(f: &[N], g: &[N]) -> Vec<N> {
    let mut rest = f.to_vec();
    let degree = g.len() - 1;
    while rest.len() > degree {
        let Some(leading) = rest.pop() else { break };
        let factor = leading / &g[degree];
        let base = rest.len() - degree;
        for (entry, c) in rest[base..].iter_mut().zip(g) {
            *entry = entry.clone() - factor.clone() * c;
        }
    }
    while rest.last().is_some_and(is_zero) {
        rest.pop();
    }
    rest.into_iter().map(|c| -c).collect()
}
