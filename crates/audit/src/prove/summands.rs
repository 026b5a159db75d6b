//! Sums of products that are plainly not negative: weights, squares, and powers of atoms.

use std::collections::hash_map::Entry;
use std::collections::{BTreeMap, HashMap};

use kane_algebra::linear_program::common_denominator;
use kane_kernel::{Atom, Atoms, Fuel, Monomial, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _, Zero as _};

use crate::argument::Argument;

/// Summands that a sum may have.
const MOST: usize = 2000;
/// What a product of two summands costs, in operations.
const COST: u64 = 2;

/// weight · square² · Π atomsᵢ^eᵢ with a positive weight
#[derive(Clone, Debug)]
pub(super) struct Summand {
    pub(super) weight: BigRational,
    pub(super) square: Poly,
    pub(super) factors: BTreeMap<usize, u32>,
}

/// Summands one after the other.
pub(super) type Sum = Vec<Summand>;

impl Summand {
    pub(super) fn new(weight: BigRational, factors: &[(usize, u32)]) -> Self {
        let mut out = Self { weight, square: Poly::one(), factors: BTreeMap::new() };
        for &(atom, n) in factors.iter().filter(|f| f.1 > 0) {
            *out.factors.entry(atom).or_insert(0) += n;
        }
        out
    }

    pub(super) fn times(&self, other: &Self, fuel: &Fuel) -> Option<Self> {
        let mut factors = self.factors.clone();
        for (&atom, n) in &other.factors {
            *factors.entry(atom).or_insert(0) += n;
        }
        let weight = &self.weight * &other.weight;
        Some(Self { weight, square: self.square.mul(&other.square, fuel).ok()?, factors })
    }
}

/// The sum 1.
pub(super) fn one() -> Sum {
    vec![Summand::new(BigRational::one(), &[])]
}

/// The product of two sums, each product once, unless it has too many summands.
pub(super) fn product(a: &[Summand], b: &[Summand], fuel: &Fuel) -> Option<Sum> {
    if a.len() * b.len() > MOST {
        return None;
    }
    fuel.spend(COST * (a.len() * b.len()) as u64).ok()?;
    let all: Option<Sum> = a.iter().flat_map(|a| b.iter().map(|b| a.times(b, fuel))).collect();
    all.map(merged)
}

/// The same sum with each product once.
fn merged(sum: Sum) -> Sum {
    let mut places: HashMap<_, usize> = HashMap::new();
    let mut out = Sum::new();
    for summand in sum {
        match places.entry((summand.square.clone(), summand.factors.clone())) {
            Entry::Occupied(known) => out[*known.get()].weight += summand.weight,
            Entry::Vacant(free) => {
                free.insert(out.len());
                out.push(summand);
            }
        }
    }
    out
}

/// Σ summands + Σ cofactors·equations = 0, in whole numbers.
pub(super) fn closed(sum: Sum, cofactors: impl IntoIterator<Item = (usize, Poly)>) -> Argument {
    let sum = merged(sum);
    let scale = common_denominator(sum.iter().map(|s| &s.weight));
    let whole = |weight: BigRational| (weight * BigRational::from(scale.clone())).to_integer();
    let term = |s: Summand| Term {
        weight: whole(s.weight),
        square: s.square,
        factors: s.factors.into_iter().collect(),
    };
    let cofactors = cofactors.into_iter().map(|(i, p)| (i, p.scale(&scale)));
    Argument::Positive {
        cofactors: cofactors.filter(|(_, p)| !p.is_empty()).collect(),
        terms: sum.into_iter().map(term).collect(),
    }
}

/// Which variables are not negative, by atoms.
pub(super) struct Signs {
    atoms: Atoms,
}

impl Signs {
    pub(super) fn new(state: &State<'_, '_>) -> Self {
        Self { atoms: state.atoms.clone() }
    }

    /// One more atom.
    pub(super) fn add(&mut self, atom: Atom) {
        self.atoms.push(atom);
    }

    /// The place of an atom that says that a polynomial is positive, or else that it is not negative.
    pub(super) fn told(&self, p: &Poly) -> Option<usize> {
        let place = |sign| self.atoms.iter().position(|a| a.sign == sign && a.poly == *p);
        place(Sign::Positive).or_else(|| place(Sign::NonNegative))
    }

    /// The same of a positive multiple of a polynomial without a common factor, and how many times that is.
    fn told_of_multiple(&self, p: &Poly) -> Option<(usize, BigInt)> {
        self.told(p).map(|atom| (atom, BigInt::one())).or_else(|| {
            let content = |a: &Atom| {
                let (content, rest) = a.poly.primitive();
                (rest == *p).then_some(content)
            };
            let place = |sign| {
                let mut own = self.atoms.iter().enumerate().filter(|(_, a)| a.sign == sign);
                own.find_map(|(i, a)| Some((i, content(a)?)))
            };
            place(Sign::Positive).or_else(|| place(Sign::NonNegative))
        })
    }

    pub(super) fn is_strict(&self, atom: usize) -> bool {
        self.atoms[atom].sign == Sign::Positive
    }

    /// A monomial times a positive weight, if it is plainly not negative.
    pub(super) fn monomial(&self, weight: BigRational, m: &[(usize, u32)]) -> Option<Summand> {
        let (mut factors, mut root, mut weight) = (Vec::new(), Monomial::new(), weight);
        for &(v, n) in m {
            match self.told_of_multiple(&Poly::var(v)) {
                Some((atom, times)) => {
                    weight /= BigRational::from(times.pow(n));
                    factors.push((atom, n));
                }
                None if n % 2 == 0 => root.push((v, n / 2)),
                None => return None,
            }
        }
        let square = Poly::term(root, BigInt::one());
        Some(Summand { square, ..Summand::new(weight, &factors) })
    }

    /// The variables of a monomial, each once, whose odd powers have no plain sign.
    pub(super) fn unsigned(&self, m: &[(usize, u32)]) -> Monomial {
        let is_told = |v: usize| self.told_of_multiple(&Poly::var(v)).is_some();
        let open = |&&(v, n): &&(usize, u32)| n % 2 == 1 && !is_told(v);
        m.iter().filter(open).map(|&(v, _)| (v, 1)).collect()
    }

    /// A polynomial as a sum, if it is plainly positive: by its terms, or as a product with what an atom says.
    pub(super) fn positive(&self, p: &Poly) -> Option<Sum> {
        let by_terms = || -> Option<Sum> {
            let term = |(m, c): (&[(usize, u32)], &BigInt)| {
                if c.is_positive() { self.monomial(c.clone().into(), m) } else { None }
            };
            p.terms().map(term).collect()
        };
        by_terms()
            .or_else(|| self.by_atom(p))
            .filter(|sum| sum.iter().any(|s| self.positive_one(s)))
    }

    fn positive_one(&self, s: &Summand) -> bool {
        let constant = s.square.as_constant().is_some_and(|c| !c.is_zero());
        constant && s.factors.keys().all(|atom| self.is_strict(*atom))
    }

    /// What is the polynomial of an atom, or a monomial times that.
    fn by_atom(&self, p: &Poly) -> Option<Sum> {
        [Monomial::new(), common_powers(p)].iter().find_map(|common| {
            let (content, rest) = over(p, common).primitive();
            let (atom, times) = self.told_of_multiple(&rest)?;
            let mut out = self.monomial(BigRational::new(content, times), common)?;
            *out.factors.entry(atom).or_insert(0) += 1;
            Some(vec![out])
        })
    }
}

/// The greatest monomial that divides a polynomial.
pub(super) fn common_powers(p: &Poly) -> Monomial {
    let of = |v: usize| p.terms().map(|(m, _)| kane_kernel::exponent(m, v)).min().unwrap_or(0);
    p.vars().into_iter().map(|v| (v, of(v))).filter(|power| power.1 > 0).collect()
}

/// p/m for a monomial that divides it.
pub(super) fn over(p: &Poly, m: &[(usize, u32)]) -> Poly {
    let less = |&(v, n): &(usize, u32)| (v, n - kane_kernel::exponent(m, v));
    Poly::sum(p.terms().map(|(of, c)| (of.iter().map(less).collect(), c.clone())))
}

/// The product of two monomials.
pub(super) fn joined(a: &[(usize, u32)], b: &[(usize, u32)]) -> Monomial {
    let mut powers = BTreeMap::new();
    for (v, n) in a.iter().chain(b) {
        *powers.entry(*v).or_insert(0) += n;
    }
    powers.into_iter().collect()
}
