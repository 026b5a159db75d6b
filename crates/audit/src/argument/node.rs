//! Proofs before their atoms are numbered: each atom is a fact with a name of its own, so that what
//! is not used can be left out.

use std::collections::{BTreeMap, BTreeSet};

use kane_kernel::{Atom, Case, Poly, Proof, Sign, Term};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// The name of an atom of the kernel's state.
pub(super) type Fact = usize;

/// What an argument knows: an atom, and the fact behind it, a positive multiple of it. There is no
/// fact behind an equation that was used up: 0 = 0.
#[derive(Clone, Debug)]
pub(super) struct Known {
    pub(super) atom: Atom,
    pub(super) fact: Option<(Fact, BigInt)>,
}

impl Known {
    /// An atom as it stands in the kernel's state.
    pub(super) fn new(poly: Poly, sign: Sign, fact: Fact) -> Self {
        Self { atom: Atom::new(poly, sign), fact: Some((fact, BigInt::one())) }
    }
}

/// A proof of the kernel over facts.
#[derive(Clone, Debug)]
pub(super) struct Node {
    rule: Rule,
    /// facts from above that it uses
    pub(super) used: BTreeSet<Fact>,
}

#[derive(Clone, Debug)]
enum Rule {
    Assume { formula: usize, cases: Vec<(Vec<Fact>, Node)> },
    Split { poly: Poly, cases: Vec<Side> },
    Positive { terms: Vec<Term>, cofactors: Vec<(Fact, Poly)> },
}

/// A case of a split: what is said of the polynomial or its opposite, as which fact, and the rest.
#[derive(Clone, Debug)]
pub(super) struct Side {
    pub(super) opposite: bool,
    pub(super) sign: Sign,
    pub(super) fact: Fact,
    pub(super) then: Node,
}

impl Node {
    /// One case of a formula holds. If a proof does not need its case, it is all that is needed.
    pub(super) fn assume(formula: usize, cases: Vec<(Vec<Fact>, Self)>) -> Self {
        let idle = |(new, node): &(Vec<Fact>, Self)| new.iter().all(|f| !node.used.contains(f));
        if let Some((_, node)) = cases.iter().find(|c| idle(c)) {
            return node.clone();
        }
        let mut used = BTreeSet::new();
        for (new, node) in &cases {
            used.extend(node.used.iter().filter(|f| !new.contains(f)));
        }
        Self { rule: Rule::Assume { formula, cases }, used }
    }

    /// Cases by the sign of a polynomial. If a proof does not need its case, it is all that is
    /// needed.
    pub(super) fn split(poly: Poly, cases: Vec<Side>) -> Self {
        if let Some(idle) = cases.iter().find(|c| !c.then.used.contains(&c.fact)) {
            return idle.then.clone();
        }
        let own = cases.iter().flat_map(|c| c.then.used.iter().filter(|f| **f != c.fact));
        let used = own.copied().collect();
        Self { rule: Rule::Split { poly, cases }, used }
    }

    /// The proof, in a state whose first atoms are these facts in order.
    pub(super) fn numbered(&self, given: usize) -> Proof {
        let mut places = (0..given).map(|f| (f, f)).collect();
        self.place(&mut places, given)
    }

    fn place(&self, places: &mut BTreeMap<Fact, usize>, count: usize) -> Proof {
        let at = |places: &BTreeMap<Fact, usize>, f: &Fact| {
            // What is not there is no atom: the kernel rejects it.
            places.get(f).copied().unwrap_or(usize::MAX)
        };
        match &self.rule {
            Rule::Assume { formula, cases } => {
                let case = |(new, node): &(Vec<Fact>, Self)| {
                    places.extend(new.iter().copied().zip(count..));
                    node.place(places, count + new.len())
                };
                Proof::Assume { formula: *formula, cases: cases.iter().map(case).collect() }
            }
            Rule::Split { poly, cases } => {
                let case = |c: &Side| {
                    places.insert(c.fact, count);
                    let then = c.then.place(places, count + 1);
                    Case { opposite: c.opposite, sign: c.sign, then }
                };
                Proof::Split { poly: poly.clone(), cases: cases.iter().map(case).collect() }
            }
            Rule::Positive { terms, cofactors } => {
                let term = |t: &Term| {
                    let mut factors: Vec<(usize, u32)> =
                        t.factors.iter().map(|(f, n)| (at(places, f), *n)).collect();
                    factors.sort_unstable();
                    Term { factors, ..t.clone() }
                };
                let equation = |(f, c): &(Fact, Poly)| (at(places, f), c.clone());
                Proof::Positive {
                    terms: terms.iter().map(term).collect(),
                    cofactors: cofactors.iter().map(equation).collect(),
                }
            }
        }
    }
}

/// Facts with powers.
type Powers = Vec<(Fact, u32)>;

/// A sum that is zero though one summand is positive, as it is put together.
#[derive(Clone, Debug, Default)]
pub(super) struct Sum {
    terms: Vec<(BigRational, Poly, Powers)>,
    cofactors: Vec<(BigRational, Poly, Fact)>,
}

impl Sum {
    /// Adds weight · square² · Π powers of what is known.
    pub(super) fn term(
        &mut self,
        mut weight: BigRational,
        square: Poly,
        factors: &[(&Known, u32)],
    ) -> &mut Self {
        let mut powers = Powers::new();
        for (known, n) in factors.iter().filter(|f| f.1 > 0) {
            // A factor that was used up is nobody's fact: the kernel rejects it.
            let (fact, scale) = known.fact.clone().unwrap_or((Fact::MAX, BigInt::one()));
            weight /= power(&BigRational::from(scale), *n);
            match powers.iter_mut().find(|p| p.0 == fact) {
                Some(p) => p.1 += n,
                None => powers.push((fact, *n)),
            }
        }
        if !weight.is_zero() {
            self.terms.push((weight, square, powers));
        }
        self
    }

    /// Adds weight · Π powers of what is known.
    pub(super) fn product(&mut self, weight: BigRational, factors: &[(&Known, u32)]) -> &mut Self {
        self.term(weight, Poly::one(), factors)
    }

    /// Adds weight · cofactor · an equation.
    pub(super) fn multiple(
        &mut self,
        weight: BigRational,
        cofactor: Poly,
        equation: &Known,
    ) -> &mut Self {
        if let Some((fact, scale)) = &equation.fact {
            let weight = weight / BigRational::from(scale.clone());
            if !weight.is_zero() && !cofactor.is_empty() {
                self.cofactors.push((weight, cofactor, *fact));
            }
        }
        self
    }

    /// The proof that this sum is, in integers.
    pub(super) fn close(&self) -> Node {
        let weights = || self.terms.iter().map(|t| &t.0);
        let common = weights()
            .chain(self.cofactors.iter().map(|c| &c.0))
            .fold(BigInt::one(), |l, w| l.lcm(w.denom()));
        // Cofactors may have a factor in common with all weights.
        let whole = |q: &BigRational| q.numer() * (&common / q.denom());
        let part = |(w, p, fact): &(BigRational, Poly, Fact)| {
            let (content, p) = p.primitive();
            (whole(w) * content, p, *fact)
        };
        let parts: Vec<(BigInt, Poly, Fact)> = self.cofactors.iter().map(part).collect();
        let weighed = weights().map(whole).fold(BigInt::zero(), |g, w| g.gcd(&w));
        let gcd = parts.iter().fold(weighed, |g, part| g.gcd(&part.0));
        let unit = if gcd.is_zero() { BigInt::one() } else { gcd };
        let terms = self.terms.iter().map(|(w, square, factors)| Term {
            weight: whole(w) / &unit,
            square: square.clone(),
            factors: factors.clone(),
        });
        let cofactors = parts.into_iter().map(|(w, p, fact)| (fact, p.scale(&(w / &unit))));
        let terms: Vec<Term> = terms.collect();
        let cofactors = merged(cofactors);
        let factors = terms.iter().flat_map(|t| t.factors.iter().map(|f| f.0));
        let used = factors.chain(cofactors.iter().map(|c| c.0)).collect();
        Node { rule: Rule::Positive { terms, cofactors }, used }
    }
}

/// One cofactor for each equation.
fn merged(cofactors: impl Iterator<Item = (Fact, Poly)>) -> Vec<(Fact, Poly)> {
    let mut sums: Vec<(Fact, Poly)> = Vec::new();
    for (fact, p) in cofactors {
        match sums.iter_mut().find(|(known, _)| *known == fact) {
            Some((_, sum)) => *sum = sum.add(&p),
            None => sums.push((fact, p)),
        }
    }
    sums.retain(|(_, sum)| !sum.is_empty());
    sums
}

/// qⁿ
pub(super) fn power(q: &BigRational, n: u32) -> BigRational {
    num_traits::pow::Pow::pow(q, n)
}

/// A rational number from an integer.
pub(super) fn whole(n: BigInt) -> BigRational {
    BigRational::from(n)
}
