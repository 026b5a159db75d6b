//! Positivstellensatz: a positive product of atoms and squares times products of atoms, in sum zero.

use kane_algebra::ring::common_sign;
use kane_algebra::squares::{Contact, Identity, Question, identity, total_degree};
use kane_kernel::{Fuel, Poly, Sign, State, Term};

use super::contacts::{contacts, only_root};
use super::elimination::Factors;
use crate::argument::{Argument, Rules};

/// Atoms with an order, beyond which their products are left out.
const ATOMS: usize = 12;
/// The largest degree of an identity.
const DEGREE: u32 = 12;
/// Symbols with a sign that are taken in pairs beside a condition.
const SYMBOLS: usize = 4;
/// Positive products that are tried.
const TARGETS: usize = 10;

/// How much is tried.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reach {
    /// atoms alone, at the degree that they have
    Atoms,
    /// products of two atoms, too
    Pairs,
    /// those, and products of an atom and two symbols
    Signed,
    /// those of two atoms, and a higher degree
    Higher,
}

/// A product of atoms, and its factors.
#[derive(Clone, Debug)]
struct Product {
    factors: Factors,
    poly: Poly,
}

/// A contradiction between the atoms of a state by squares.
pub(crate) fn squares(state: &State<'_, '_>, reach: Reach, fuel: &Fuel) -> Option<Argument> {
    let live = |sign: fn(Sign) -> bool| -> Vec<usize> {
        let all = 0..state.atoms.len();
        all.filter(|&i| sign(state.atoms[i].sign) && state.atoms[i].decided().is_none()).collect()
    };
    let ordered = live(|s| matches!(s, Sign::Positive | Sign::NonNegative));
    let equations = live(|s| s == Sign::Zero);
    let distinct = live(|s| s == Sign::NonZero);
    let poly = |i: usize| state.atoms[i].poly.clone();
    let one = Product { factors: Vec::new(), poly: Poly::one() };
    let single = |i: usize| Product { factors: vec![(i, 1)], poly: poly(i) };
    let pair = |i: usize, j: usize| -> Option<Product> {
        let factors = if i == j { vec![(i, 2)] } else { vec![(i, 1), (j, 1)] };
        Some(Product { factors, poly: poly(i).mul(&poly(j), fuel).ok()? })
    };
    let strict = |i: &usize| state.atoms[*i].sign == Sign::Positive;
    let positive: Vec<usize> = ordered.iter().rev().copied().filter(|i| strict(i)).collect();
    let helpful: Vec<usize> = ordered.iter().copied().filter(|&i| !is_sum(state, i)).collect();
    let mut products: Vec<Product> = vec![one.clone()];
    products.extend(helpful.iter().map(|&i| single(i)));
    let mut targets: Vec<Product> = positive.iter().map(|&i| single(i)).collect();
    targets.push(one);
    if reach != Reach::Atoms {
        if helpful.len() > ATOMS {
            return None;
        }
        for (n, &i) in helpful.iter().enumerate() {
            for &j in &helpful[..n] {
                products.push(pair(j, i)?);
            }
        }
        if reach == Reach::Signed {
            let (more, strict) = (signed(state, &helpful), corners(state, &positive));
            if more.is_empty() && strict.is_empty() {
                return None;
            }
            let product = |factors: Factors| {
                let mut poly = Poly::one();
                for &(i, _) in &factors {
                    poly = poly.mul(&state.atoms[i].poly, fuel).ok()?;
                }
                Some(Product { factors, poly })
            };
            products.extend(more.into_iter().map(product).collect::<Option<Vec<_>>>()?);
            let strict = strict.into_iter().map(product).collect::<Option<Vec<_>>>()?;
            targets.splice(0..0, strict);
        }
        for (n, &i) in positive.iter().enumerate() {
            for &j in &positive[n..] {
                targets.push(pair(i.min(j), i.max(j))?);
            }
        }
        for &i in &distinct {
            targets.push(pair(i, i)?);
        }
    }
    let premises = ordered.iter().chain(&equations).map(|&i| total_degree(&state.atoms[i].poly));
    let most = premises.max().unwrap_or(0);
    // x⁴ + x³y + … + y⁴ ≤ 0 is contradicted by (y − x)⁴ > 0, of its own degree, and by no lower power
    let strict_alone = ordered.iter().filter(|&&i| total_degree(&poly(i)) == most).all(strict);
    if reach != Reach::Atoms && most >= 4 && (!equations.is_empty() || !strict_alone) {
        for &i in positive.iter().chain(&distinct).filter(|&&i| total_degree(&poly(i)) == 1) {
            let n = most.next_multiple_of(2);
            targets.push(Product { factors: vec![(i, n)], poly: poly(i).pow(n, fuel).ok()? });
        }
    }
    for (n, target) in targets.into_iter().take(TARGETS).enumerate() {
        let more = if reach == Reach::Higher { 2 } else { 0 };
        let degree = most.max(total_degree(&target.poly)).next_multiple_of(2) + more;
        if degree > DEGREE {
            continue;
        }
        let among = Among { state, target: &target, degree };
        // of the newest, without what has other variables, too: matrices are smaller, and fewer of them singular
        let vars = target.poly.vars();
        let near = |p: &Poly| p.vars().iter().all(|v| vars.contains(v));
        let few: Vec<Product> = products.iter().filter(|p| near(&p.poly)).cloned().collect();
        let equal: Vec<usize> = equations.iter().copied().filter(|&i| near(&poly(i))).collect();
        let all = few.len() == products.len() && equal.len() == equations.len();
        let is_first = n == 0 && reach == Reach::Atoms;
        let first = (is_first && !all).then(|| among.proof(&few, &equal, |_| true, fuel));
        // conditions may hide some of the irrational places at which it touches without them
        let has_root = is_first && products.len() > 1 && only_root(state).is_some();
        let bare = || {
            let touches = |places: &[Contact]| places.iter().any(Contact::is_irrational);
            has_root.then(|| among.proof(&products[..1], &[], touches, fuel)).flatten()
        };
        let whole = || among.proof(&products, &equations, |_| true, fuel);
        let found = first.flatten().or_else(bare).or_else(whole);
        if found.is_some() {
            return found;
        }
    }
    None
}

/// Conditions of degree two or more times two symbols that have a sign.
fn signed(state: &State<'_, '_>, ordered: &[usize]) -> Vec<Factors> {
    let degree = |i: usize| total_degree(&state.atoms[i].poly);
    let is_symbol = |i: &usize| state.atoms[*i].poly.len() == 1 && degree(*i) == 1;
    let symbols: Vec<usize> = ordered.iter().copied().filter(is_symbol).take(SYMBOLS).collect();
    let curved: Vec<usize> = ordered.iter().copied().filter(|&i| degree(i) > 1).collect();
    let mut out = Vec::new();
    for (n, &i) in symbols.iter().enumerate() {
        for &j in &symbols[n + 1..] {
            for &k in &curved {
                let mut factors = vec![(i, 1), (j, 1), (k, 1)];
                factors.sort_unstable();
                out.push(factors);
            }
        }
    }
    out
}

/// Products of three bounds: positive, and zero where a claim touches at the corners of what they bound.
fn corners(state: &State<'_, '_>, positive: &[usize]) -> Vec<Factors> {
    let mut bounds: Vec<usize> = positive.to_vec();
    bounds.retain(|&i| total_degree(&state.atoms[i].poly) == 1);
    bounds.sort_unstable();
    bounds.truncate(SYMBOLS);
    let mut out = Vec::new();
    for (n, &i) in bounds.iter().enumerate() {
        for (m, &j) in bounds.iter().enumerate().skip(n + 1) {
            out.extend(bounds[m + 1..].iter().map(|&k| vec![(i, 1), (j, 1), (k, 1)]));
        }
    }
    out
}

/// What is contradicted, and the degree of the identity.
struct Among<'a> {
    state: &'a State<'a, 'a>,
    target: &'a Product,
    degree: u32,
}

impl Among<'_> {
    /// A contradiction by squares times some products, and multiples of some equations, if its contacts are worth it.
    fn proof(
        &self,
        products: &[Product],
        equations: &[usize],
        are_worth_it: fn(&[Contact]) -> bool,
        fuel: &Fuel,
    ) -> Option<Argument> {
        let polys: Vec<Poly> = products.iter().map(|p| p.poly.clone()).collect();
        let equated: Vec<Poly> =
            equations.iter().map(|&i| self.state.atoms[i].poly.clone()).collect();
        let question = Question {
            positive: &self.target.poly,
            products: &polys,
            equations: &equated,
            degree: self.degree,
            contacts: &[],
        };
        let contacts =
            if self.degree >= 4 { contacts(self.state, &question, fuel) } else { Vec::new() };
        if !are_worth_it(&contacts) {
            return None;
        }
        let question = Question { contacts: &contacts, ..question };
        let proof = argument(self.target, products, equations, identity(&question, fuel)?);
        self.state.closes(&proof).is_ok().then_some(proof)
    }
}

/// Whether an atom says no more than that its variables are not negative, which other atoms say.
fn is_sum(state: &State<'_, '_>, i: usize) -> bool {
    let poly = &state.atoms[i].poly;
    let stands = |v: usize| {
        let mut others = state.atoms.iter().filter(|a| a.poly == Poly::var(v));
        others.any(|a| matches!(a.sign, Sign::Positive | Sign::NonNegative))
    };
    poly.len() > 1 && common_sign(poly) == Some(true) && poly.vars().into_iter().all(stands)
}

/// The identity with indices of atoms.
fn argument(
    target: &Product,
    products: &[Product],
    equations: &[usize],
    found: Identity,
) -> Argument {
    let positive =
        Term { weight: found.scale, square: Poly::one(), factors: target.factors.clone() };
    let squares = found.squares.into_iter().map(|s| Term {
        weight: s.weight,
        square: s.base,
        factors: products[s.product].factors.clone(),
    });
    let cofactors = equations.iter().copied().zip(found.cofactors);
    Argument::Positive {
        terms: std::iter::once(positive).chain(squares).collect(),
        cofactors: cofactors.filter(|(_, p)| !p.is_empty()).collect(),
    }
}
