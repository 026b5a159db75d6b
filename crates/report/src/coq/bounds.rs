//! Signs of coefficients as sums of products: what the kernel reads off after a map of bounds onto
//! the orthant becomes an identity whose summands are products of the bounds.

use kane_kernel::{Atom, Fuel, Poly, Sign};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::NotEmitted;
use super::script::Writer;

/// One summand: weight and factors, powers of atoms.
type Summand = (BigInt, Vec<(usize, u32)>);

/// A bound k·v + c of a variable, by the index of its atom.
#[derive(Clone, Debug)]
struct End {
    atom: usize,
    slope: BigInt,
    value: BigRational,
}

/// Both bounds of a variable, and the degree of the polynomial in it.
#[derive(Clone, Debug)]
struct Range {
    var: usize,
    degree: u32,
    lower: Option<End>,
    upper: Option<End>,
}

/// What a closed bound is known to be on a face: zero, or positive by a new atom.
#[derive(Clone, Copy, Debug)]
enum Face {
    Zero(usize),
    Positive(usize),
}

/// Refutes an atom by the signs of coefficients after its bounds are mapped onto the orthant.
pub(super) fn refute(
    writer: &Writer<'_>,
    atoms: &mut Vec<Atom>,
    target: usize,
    bounds: &[(usize, Option<usize>, Option<usize>)],
) -> Result<String, NotEmitted> {
    let fuel = Fuel::new(u64::MAX);
    for (at, &(var, lower, upper)) in bounds.iter().enumerate() {
        let (Some(i), Some(j)) = (lower, upper) else {
            continue;
        };
        let (low, high) = (end(atoms, i, var)?, end(atoms, j, var)?);
        if low.value < high.value {
            continue;
        }
        // |k'|·L + k·U is a constant that is not positive.
        let (a, b) = (high.slope.abs(), low.slope.abs());
        let sum = atoms[i].poly.scale(&a).add(&atoms[j].poly.scale(&b));
        let gap = sum.as_constant().unwrap_or_default();
        let both = |i| {
            vec![(a.clone(), Poly::one(), vec![(i, 1)]), (b.clone(), Poly::one(), vec![(j, 1)])]
        };
        if gap.is_negative() {
            let mut terms = both(i);
            terms.push((-gap, Poly::one(), Vec::new()));
            return writer.positive(&terms, &[]);
        }
        if atoms[i].sign == Sign::Positive || atoms[j].sign == Sign::Positive {
            return writer.positive(&both(i), &[]);
        }
        let new = atoms.len();
        let positive = writer.positive(&both(new), &[])?;
        let one = |i| (BigInt::one(), Poly::one(), vec![(i, 1)]);
        let negative = writer.positive(&[one(new), one(i)], &[])?;
        let rule = atoms[i].poly.clone();
        let mut there = Vec::new();
        for a in atoms.iter() {
            let rest = a.poly.remainder(var, &rule, false, &fuel)?;
            there.push(Atom::new(rest.primitive().1, a.sign));
        }
        there.push(Atom::new(Poly::default(), Sign::Zero));
        let others = [&bounds[..at], &bounds[at + 1..]].concat();
        let then = if there.iter().any(|a| a.decided() == Some(false)) {
            "Absurd".to_owned()
        } else {
            refute(writer, &mut there, target, &others)?
        };
        let v = writer.symbols.variable(var)?;
        return Ok(format!(
            "(Split {} (Substitute {new} {v} [] {then}) {positive} {negative})",
            writer.poly(&rule)?
        ));
    }
    let whole = atoms[target].poly.clone();
    if whole.is_empty() {
        return Ok("Absurd".to_owned());
    }
    Signs::new(writer, atoms, target, (&[], &whole), bounds)?.close(atoms)
}

/// A refutation of one atom by the signs of coefficients.
#[derive(Debug)]
pub(super) struct Signs<'a> {
    writer: &'a Writer<'a>,
    /// the atom
    target: usize,
    sign: Sign,
    scale: BigInt,
    negative: bool,
    summands: Vec<Summand>,
    ranges: Vec<Range>,
}

impl<'a> Signs<'a> {
    /// Prepares the refutation of `atoms[target]`, whose polynomial is the product of `known` atoms
    /// and `rest`.
    pub(super) fn new(
        writer: &'a Writer<'a>,
        atoms: &[Atom],
        target: usize,
        (known, rest): (&[(usize, u32)], &Poly),
        bounds: &[(usize, Option<usize>, Option<usize>)],
    ) -> Result<Self, NotEmitted> {
        let fuel = Fuel::new(u64::MAX);
        let mut p = rest.clone();
        let mut ranges = Vec::new();
        let mut whole = BigRational::one();
        for &(var, lower, upper) in bounds {
            let lower = lower.map(|i| end(atoms, i, var)).transpose()?;
            let upper = upper.map(|i| end(atoms, i, var)).transpose()?;
            let degree = p.degree(var);
            let line = |a: BigInt, b: BigInt| Poly::in_variable(var, &[a, b]);
            let (num, den, unit) = match (&lower, &upper) {
                (Some(l), None) => {
                    let d = l.value.denom().clone();
                    (line(l.value.numer().clone(), d.clone()), Poly::constant(d.clone()), d.into())
                }
                (None, Some(u)) => {
                    let d = u.value.denom().clone();
                    (line(u.value.numer().clone(), -&d), Poly::constant(d.clone()), d.into())
                }
                (Some(l), Some(u)) => {
                    let d = l.value.denom() * u.value.denom();
                    let num =
                        line(l.value.numer() * u.value.denom(), u.value.numer() * l.value.denom());
                    let width = &u.value - &l.value;
                    if !width.is_positive() {
                        return Err(NotEmitted::Step("bounds that leave a single point"));
                    }
                    (num, line(d.clone(), d.clone()), BigRational::from(d) * width)
                }
                (None, None) => return Err(NotEmitted::Step("a variable without bounds")),
            };
            p = p.compose(var, &num, &den, &fuel)?;
            whole *= power(&unit, degree);
            ranges.push(Range { var, degree, lower, upper });
        }
        let mut terms: Vec<(BigRational, Vec<(usize, u32)>)> = Vec::new();
        for (m, c) in p.terms() {
            let mut weight = BigRational::from(c.clone());
            let mut factors = known.to_vec();
            for r in &ranges {
                let n = kane_kernel::exponent(m, r.var);
                let low = r.lower.iter().map(|e| (e, n));
                let rest = if r.lower.is_some() { r.degree - n } else { n };
                for (e, n) in low.chain(r.upper.iter().map(|e| (e, rest))) {
                    weight /= power(&BigRational::from(e.slope.abs()), n);
                    if n > 0 {
                        factors.push((e.atom, n));
                    }
                }
            }
            terms.push((weight, factors));
        }
        let negative = terms.iter().all(|(w, _)| w.is_negative());
        if !negative && !terms.iter().all(|(w, _)| w.is_positive()) {
            return Err(NotEmitted::Step("coefficients of two signs"));
        }
        let common = terms.iter().fold(whole.denom().clone(), |l, (w, _)| l.lcm(w.denom()));
        let integer = |q: &BigRational| (q * BigRational::from(common.clone())).to_integer();
        let summands = terms.iter().map(|(w, f)| (integer(&w.abs()), f.clone())).collect();
        let (scale, sign) = (integer(&whole), atoms[target].sign);
        Ok(Self { writer, target, sign, scale, negative, summands, ranges })
    }

    /// The proof, with cases where a bound belongs to the region.
    pub(super) fn close(&self, atoms: &mut Vec<Atom>) -> Result<String, NotEmitted> {
        self.faces(atoms, &mut Vec::new())
    }

    fn faces(
        &self,
        atoms: &mut Vec<Atom>,
        faces: &mut Vec<(usize, Face)>,
    ) -> Result<String, NotEmitted> {
        let face = |i: usize, faces: &[(usize, Face)]| faces.iter().find(|f| f.0 == i).map(|f| f.1);
        if let Some(empty) = self.no_point(atoms, faces)? {
            return Ok(empty);
        }
        // On a face, factors that are known to be positive there are named so.
        let named = |&(i, n): &(usize, u32)| match face(i, faces) {
            Some(Face::Positive(j)) => (j, n),
            _ => (i, n),
        };
        let summands: Vec<Summand> =
            self.summands.iter().map(|(w, f)| (w.clone(), f.iter().map(named).collect())).collect();
        let strict = |(_, f): &Summand| f.iter().all(|&(i, _)| atoms[i].sign == Sign::Positive);
        if self.sign == Sign::Positive || summands.iter().any(strict) {
            return self.sum(&summands);
        }
        let open = summands
            .iter()
            .flat_map(|(_, f)| f)
            .find(|(i, _)| atoms[*i].sign == Sign::NonNegative && face(*i, faces).is_none());
        let Some(&(i, _)) = open else {
            return Err(NotEmitted::Step("a face on which all terms vanish"));
        };
        let poly = atoms[i].poly.clone();
        let new = atoms.len();
        let mut case = |sign, face| {
            atoms.push(Atom::new(poly.clone(), sign));
            faces.push((i, face));
            let proof = self.faces(atoms, faces);
            faces.pop();
            atoms.pop();
            proof
        };
        let zero = case(Sign::Zero, Face::Zero(new))?;
        let positive = case(Sign::Positive, Face::Positive(new))?;
        let one = |i| (BigInt::one(), Poly::one(), vec![(i, 1)]);
        let negative = self.writer.positive(&[one(new), one(i)], &[])?;
        Ok(format!("(Split {} {zero} {positive} {negative})", self.writer.poly(&poly)?))
    }

    /// If a variable would have to be at both its bounds: the proof that it is not.
    fn no_point(
        &self,
        atoms: &[Atom],
        faces: &[(usize, Face)],
    ) -> Result<Option<String>, NotEmitted> {
        let zero = |e: &Option<End>| {
            let atom = e.as_ref()?.atom;
            faces.iter().find_map(|f| match f {
                (i, Face::Zero(j)) if *i == atom => Some(*j),
                _ => None,
            })
        };
        for r in &self.ranges {
            let (Some(i), Some(j)) = (zero(&r.lower), zero(&r.upper)) else {
                continue;
            };
            // |k'|·(k·v + c) + k·(c' − |k'|·v) is the constant k·|k'|·(u − l).
            let fuel = Fuel::new(u64::MAX);
            let slope = |i: usize| atoms[i].poly.coefficients(r.var).pop().unwrap_or_default();
            let (a, b) = (slope(j).neg(), slope(i));
            let sum = atoms[i].poly.mul(&a, &fuel)?.add(&atoms[j].poly.mul(&b, &fuel)?);
            let Some(gap) = sum.as_constant().filter(Signed::is_positive) else {
                return Err(NotEmitted::Step("bounds that do not bound"));
            };
            let constant = (gap, Poly::one(), Vec::new());
            return self.writer.positive(&[constant], &[(i, a.neg()), (j, b.neg())]).map(Some);
        }
        Ok(None)
    }

    /// scale·P ∓ Σ = 0
    fn sum(&self, summands: &[Summand]) -> Result<String, NotEmitted> {
        let mut terms: Vec<_> =
            summands.iter().map(|(w, f)| (w.clone(), Poly::one(), f.clone())).collect();
        match (self.sign, self.negative) {
            (Sign::Positive | Sign::NonNegative, true) => {
                terms.push((self.scale.clone(), Poly::one(), vec![(self.target, 1)]));
                self.writer.positive(&terms, &[])
            }
            (Sign::Zero, negative) => {
                let scale = if negative { self.scale.clone() } else { -&self.scale };
                self.writer.positive(&terms, &[(self.target, Poly::constant(scale))])
            }
            _ if summands.is_empty() => Ok("Absurd".to_owned()),
            _ => Err(NotEmitted::Step("the wrong sign")),
        }
    }
}

fn power(q: &BigRational, n: u32) -> BigRational {
    (0..n).fold(BigRational::one(), |p, _| p * q)
}

fn end(atoms: &[Atom], atom: usize, var: usize) -> Result<End, NotEmitted> {
    match atoms[atom].poly.univariate(var).as_deref() {
        Some([c, k]) if !k.is_zero() => {
            Ok(End { atom, slope: k.clone(), value: BigRational::new(-c, k.clone()) })
        }
        _ => Err(NotEmitted::Step("no bound")),
    }
}
