//! Signs of coefficients as sums of products: after a map of bounds onto the orthant all
//! coefficients have one sign, and each term is a product of the bounds.

use kane_kernel::{Fuel, Poly, Sign, State};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::Bounds;
use super::bound::bound;
use super::expand::{Work, absurd, at};
use super::identity::Reducer;
use super::node::{Known, Node, Sum, power, whole};
use super::rules::{Flaw, Step, composed};

/// A bound k·v + c ≥ 0 or > 0 of a variable.
#[derive(Clone, Debug)]
pub(super) struct End {
    known: Known,
    slope: BigInt,
    value: BigRational,
}

/// The bounds of a variable.
#[derive(Clone, Debug)]
pub(super) struct Range {
    var: usize,
    lower: Option<End>,
    upper: Option<End>,
}

/// What a closed bound is known to be on a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Face {
    Open,
    Zero,
    Positive,
}

impl Range {
    /// Reads bounds of a variable off what is known.
    pub(super) fn new(var: usize, lower: Option<&Known>, upper: Option<&Known>) -> Step<Self> {
        let end = |known: &Known, side: i8| match bound(&known.atom, var) {
            Some((value, k)) if kane_kernel::sign(k) == side => {
                Ok(End { known: known.clone(), slope: k.clone(), value })
            }
            _ => Err(Flaw::NotABound(var)),
        };
        if lower.is_none() && upper.is_none() {
            return Err(Flaw::NotABound(var));
        }
        Ok(Self {
            var,
            lower: lower.map(|k| end(k, 1)).transpose()?,
            upper: upper.map(|k| end(k, -1)).transpose()?,
        })
    }

    fn ends(&self) -> impl Iterator<Item = &End> {
        self.lower.iter().chain(&self.upper)
    }
}

/// The contradiction between an atom and bounds of its variables.
pub(super) fn contradiction(
    work: &Work<'_>,
    known: &[Known],
    target: &Known,
    bounds: &[Bounds],
) -> Step<Node> {
    let mut ranges = Vec::new();
    for (i, &(var, lower, upper)) in bounds.iter().enumerate() {
        if bounds[..i].iter().any(|b| b.0 == var) {
            return Err(Flaw::NotABound(var));
        }
        let lower = lower.map(|i| at(known, i)).transpose()?;
        let upper = upper.map(|i| at(known, i)).transpose()?;
        ranges.push(Range::new(var, lower, upper)?);
    }
    within(work, target, &ranges)
}

fn within(work: &Work<'_>, target: &Known, ranges: &[Range]) -> Step<Node> {
    if target.atom.decided() == Some(false) {
        return absurd(target, 0);
    }
    for (i, r) in ranges.iter().enumerate() {
        if let (Some(low), Some(high)) = (&r.lower, &r.upper)
            && low.value >= high.value
        {
            let others = [&ranges[..i], &ranges[i + 1..]].concat();
            return pinned(work, target, (r.var, low, high), &others);
        }
    }
    // One bound of a variable is often enough, and makes fewer terms.
    let mut fewer = Signs::new(target, (&[], &target.atom.poly), ranges, &work.fuel)?;
    let mut slim = ranges.to_vec();
    for i in 0..slim.len() {
        let Range { var, lower: Some(low), upper: Some(high) } = slim[i].clone() else {
            continue;
        };
        for (lower, upper) in [(Some(low), None), (None, Some(high))] {
            let mut tried = slim.clone();
            tried[i] = Range { var, lower, upper };
            let signs = Signs::new(target, (&[], &target.atom.poly), &tried, &work.fuel);
            if let Ok(signs) = signs
                && signs.summands.len() <= fewer.summands.len()
                && signs.close(work).is_ok()
            {
                (fewer, slim) = (signs, tried);
                break;
            }
        }
    }
    fewer.close(work)
}

/// The same where the bounds of a variable leave one point or none.
fn pinned(
    work: &Work<'_>,
    target: &Known,
    (var, low, high): (usize, &End, &End),
    others: &[Range],
) -> Step<Node> {
    // |k'|·L + k·U is the constant k·|k'|·(u − l) ≤ 0.
    let (a, b) = (whole(high.slope.abs()), whole(low.slope.abs()));
    let gap = &a * &b * (&high.value - &low.value);
    let both = |first: &Known| {
        let mut sum = Sum::default();
        sum.product(a.clone(), &[(first, 1)]).product(b.clone(), &[(&high.known, 1)]);
        sum
    };
    let strict = [low, high].iter().any(|e| e.known.atom.sign == Sign::Positive);
    if gap.is_negative() {
        return Ok(both(&low.known).product(-gap, &[]).close());
    }
    if strict {
        return Ok(both(&low.known).close());
    }
    let poly = &low.known.atom.poly;
    let zero = work.side(poly, (false, Sign::Zero), |zero| {
        let reducer = Reducer::new(&zero, var, &[], &work.fuel)?;
        match reducer.derived(target, work.fresh(), &work.fuel)? {
            Some(there) => work.with(&there, || within(work, &there.new, others)),
            None => within(work, target, others),
        }
    })?;
    let positive = work.side(poly, (false, Sign::Positive), |p| Ok(both(&p).close()))?;
    let negative = work.side(poly, (true, Sign::Positive), |n| {
        let one = BigRational::one;
        Ok(Sum::default().product(one(), &[(&n, 1)]).product(one(), &[(&low.known, 1)]).close())
    })?;
    Ok(Node::split(poly.clone(), vec![zero, positive, negative]))
}

/// The powers of the bounds in a summand: of each, in the order of [`Signs::ends`].
type Powers = Vec<u32>;

/// A refutation of one atom by the signs of coefficients.
#[derive(Debug)]
pub(super) struct Signs {
    target: Known,
    /// factors of all summands
    known: Vec<(Known, u32)>,
    /// scale·P = ±Σ weight·Π known·Π boundsⁿ
    scale: BigRational,
    negative: bool,
    summands: Vec<(BigRational, Powers)>,
    ends: Vec<End>,
    /// ends of one variable, and k·|k'|·(u − l)
    pairs: Vec<(usize, usize)>,
}

impl Signs {
    /// Prepares the refutation of an atom whose polynomial is the product of `known` and `rest`.
    pub(super) fn new(
        target: &Known,
        (known, rest): (&[(Known, u32)], &Poly),
        ranges: &[Range],
        fuel: &Fuel,
    ) -> Step<Self> {
        let mut p = rest.clone();
        let (mut scale, mut degrees) = (BigRational::one(), Vec::new());
        for r in ranges {
            let degree = p.degree(r.var);
            let line = |a: BigInt, b: BigInt| Poly::in_variable(r.var, &[a, b]);
            let (num, den, unit) = match (&r.lower, &r.upper) {
                (Some(l), None) => {
                    let d = l.value.denom().clone();
                    let num = line(l.value.numer().clone(), d.clone());
                    (num, Poly::constant(d.clone()), whole(d))
                }
                (None, Some(u)) => {
                    let d = u.value.denom().clone();
                    (line(u.value.numer().clone(), -&d), Poly::constant(d.clone()), whole(d))
                }
                (Some(l), Some(u)) => {
                    let d = l.value.denom() * u.value.denom();
                    let ends =
                        (l.value.numer() * u.value.denom(), u.value.numer() * l.value.denom());
                    let width = &u.value - &l.value;
                    (line(ends.0, ends.1), line(d.clone(), d.clone()), whole(d) * width)
                }
                (None, None) => return Err(Flaw::NotABound(r.var)),
            };
            p = composed(&p, r.var, &num, &den, fuel)?;
            scale *= power(&unit, degree);
            degrees.push(degree);
        }
        if p.vars().iter().any(|v| !ranges.iter().any(|r| r.var == *v)) {
            return Err(Flaw::NotABound(0));
        }
        let (mut ends, mut pairs) = (Vec::new(), Vec::new());
        for r in ranges {
            if r.lower.is_some() && r.upper.is_some() {
                pairs.push((ends.len(), ends.len() + 1));
            }
            ends.extend(r.ends().cloned());
        }
        let mut summands = Vec::new();
        for (m, c) in p.terms() {
            let (mut weight, mut powers) = (whole(c.clone()), Vec::new());
            for (r, degree) in ranges.iter().zip(&degrees) {
                let n = kane_kernel::exponent(m, r.var);
                let low = r.lower.iter().map(|e| (e, n));
                let rest = if r.lower.is_some() { degree - n } else { n };
                for (e, n) in low.chain(r.upper.iter().map(|e| (e, rest))) {
                    weight /= power(&whole(e.slope.abs()), n);
                    powers.push(n);
                }
            }
            summands.push((weight, powers));
        }
        let negative = summands.iter().all(|(w, _)| w.is_negative());
        if !negative && !summands.iter().all(|(w, _)| w.is_positive()) {
            return Err(Flaw::WrongSign);
        }
        let fits = match target.atom.sign {
            Sign::Positive | Sign::NonNegative => negative,
            Sign::Zero => true,
            Sign::NonZero => false,
        };
        if !fits || summands.is_empty() {
            return Err(Flaw::WrongSign);
        }
        for (w, _) in &mut summands {
            *w = w.abs();
        }
        let known = known.to_vec();
        Ok(Self { target: target.clone(), known, scale, negative, summands, ends, pairs })
    }

    /// The same for an atom of which this multiple is the product.
    pub(super) fn times(mut self, n: &BigInt) -> Self {
        self.scale *= whole(n.clone());
        self
    }

    /// The proof, with cases where a bound belongs to the region.
    pub(super) fn close(&self, work: &Work<'_>) -> Step<Node> {
        let mut names: Vec<Known> = self.ends.iter().map(|e| e.known.clone()).collect();
        let face = |e: &End| match e.known.atom.sign {
            Sign::Positive => Face::Positive,
            _ => Face::Open,
        };
        let mut faces: Vec<Face> = self.ends.iter().map(face).collect();
        self.faces(work, &mut names, &mut faces)
    }

    fn faces(&self, work: &Work<'_>, names: &mut [Known], faces: &mut [Face]) -> Step<Node> {
        if let Some(empty) = self.no_point(names, faces) {
            return Ok(empty);
        }
        // The summand that is nearest to being positive.
        let open = |powers: &Powers| -> Option<Vec<usize>> {
            let used = (0..powers.len()).filter(|i| powers[*i] > 0);
            let mut open = Vec::new();
            for i in used {
                match faces[i] {
                    Face::Zero => return None,
                    Face::Open => open.push(i),
                    Face::Positive => {}
                }
            }
            Some(open)
        };
        let nearest = self.summands.iter().filter_map(|(_, p)| open(p)).min_by_key(Vec::len);
        let open = nearest.ok_or(Flaw::WrongSign)?;
        let Some(&i) = open.first().filter(|_| self.target.atom.sign != Sign::Positive) else {
            return Ok(self.sum(names));
        };
        let (bound, poly) = (names[i].clone(), names[i].atom.poly.clone());
        let mut case = |sign, face| {
            work.side(&poly, (false, sign), |new| {
                let old = (std::mem::replace(&mut names[i], new), faces[i]);
                faces[i] = face;
                let node = self.faces(work, names, faces);
                (names[i], faces[i]) = old;
                node
            })
        };
        let zero = case(Sign::Zero, Face::Zero)?;
        let positive = case(Sign::Positive, Face::Positive)?;
        let negative = work.side(&poly, (true, Sign::Positive), |n| {
            let one = BigRational::one;
            Ok(Sum::default().product(one(), &[(&n, 1)]).product(one(), &[(&bound, 1)]).close())
        })?;
        Ok(Node::split(poly.clone(), vec![zero, positive, negative]))
    }

    /// If a variable would have to be at both its bounds: the proof that it is not.
    fn no_point(&self, names: &[Known], faces: &[Face]) -> Option<Node> {
        let both = |(i, j): &&(usize, usize)| faces[*i] == Face::Zero && faces[*j] == Face::Zero;
        let &(i, j) = self.pairs.iter().find(both)?;
        // |k'|·L + k·U = k·|k'|·(u − l) > 0
        let (a, b) = (whole(self.ends[j].slope.abs()), whole(self.ends[i].slope.abs()));
        let gap = &a * &b * (&self.ends[j].value - &self.ends[i].value);
        let mut sum = Sum::default();
        sum.product(gap, &[]);
        sum.multiple(-a, Poly::one(), &names[i]).multiple(-b, Poly::one(), &names[j]);
        Some(sum.close())
    }

    /// scale·P ∓ Σ = 0
    fn sum(&self, names: &[Known]) -> Node {
        let mut sum = Sum::default();
        for (weight, powers) in &self.summands {
            let known = self.known.iter().map(|(k, n)| (k, *n));
            let bounds = powers.iter().enumerate();
            // A bound that is zero here is still not negative, as it is given.
            let bounds = bounds.map(|(i, n)| match names[i].atom.sign {
                Sign::Zero => (&self.ends[i].known, *n),
                _ => (&names[i], *n),
            });
            let factors: Vec<(&Known, u32)> = known.chain(bounds).collect();
            sum.product(weight.clone(), &factors);
        }
        match self.target.atom.sign {
            Sign::Zero => {
                let scale = if self.negative { self.scale.clone() } else { -&self.scale };
                sum.multiple(scale, Poly::one(), &self.target);
            }
            _ => {
                sum.product(self.scale.clone(), &[(&self.target, 1)]);
            }
        }
        sum.close()
    }
}

/// scale · P = ± Σ weight · Π boundⁿ: what signs of coefficients say of an atom's polynomial, P, divided by its content.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BoundedSum {
    /// of the polynomial, positive
    pub scale: BigInt,
    /// whether the sum is that of the opposite
    pub negative: bool,
    /// positive weights and the powers of what the bounds say is not negative
    pub terms: Vec<(BigInt, Vec<(Poly, u32)>)>,
}

/// An atom's polynomial as a sum of products of bounds of its variables, by the indices of their atoms.
pub(crate) fn bounded_sum(
    state: &State<'_, '_>,
    atom: usize,
    bounds: &[Bounds],
) -> Option<BoundedSum> {
    let known = |i: usize| {
        let atom = state.atoms.get(i)?;
        Some(Known::new(atom.poly.clone(), atom.sign, i))
    };
    let mut ranges = Vec::new();
    for (var, lower, upper) in bounds {
        let (lower, upper) = (lower.and_then(known), upper.and_then(known));
        ranges.push(Range::new(*var, lower.as_ref(), upper.as_ref()).ok()?);
    }
    let (target, fuel) = (known(atom)?, &state.scope.fuel);
    let signs = Signs::new(&target, (&[], &target.atom.poly), &ranges, fuel).ok()?;
    let (content, primitive) = target.atom.poly.primitive();
    let scale = &signs.scale * whole(content);
    let weights = signs.summands.iter().map(|(w, _)| w);
    let common = weights.chain([&scale]).fold(BigInt::one(), |l, w| l.lcm(w.denom()));
    let whole = |w: &BigRational| w.numer() * (&common / w.denom());
    let divisor = signs.summands.iter().fold(whole(&scale), |g, (w, _)| g.gcd(&whole(w)));
    let term = |(w, powers): &(BigRational, Powers)| {
        let factors = signs.ends.iter().zip(powers).filter(|(_, n)| **n > 0);
        let factors = factors.map(|(end, n)| (end.known.atom.poly.clone(), *n));
        (whole(w) / &divisor, factors.collect())
    };
    let told = BoundedSum {
        scale: whole(&scale) / &divisor,
        negative: signs.negative,
        terms: signs.summands.iter().map(term).collect(),
    };
    // what is told is held against the polynomial once more
    let mut rest = primitive.scale(&told.scale);
    if told.negative {
        rest = rest.neg();
    }
    for (weight, factors) in &told.terms {
        let mut product = Poly::constant(weight.clone());
        for (p, n) in factors {
            product = product.mul(&p.pow(*n, fuel).ok()?, fuel).ok()?;
        }
        rest = rest.sub(&product);
    }
    rest.is_empty().then_some(told)
}

/// The value of an atom that bounds a variable, and whether it bounds it below.
pub(super) fn bound_of(known: &Known, var: usize) -> Option<(BigRational, bool)> {
    bound(&known.atom, var).map(|(value, k)| (value, k.is_positive()))
}
