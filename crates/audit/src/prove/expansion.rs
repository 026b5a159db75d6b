//! Expansion by premises: a premise that bounds a variable turns the question onto the orthant.
//!
//! From h = L·y − c ≥ 0 with L > 0 follows y = (c + h)/L, and in powers of h the target loses y. What
//! is left may have coefficients of one sign where it had none before; else the next premise is
//! tried on it. Pólya's idea, with the premises for simplices.

use kane_kernel::{Atom, Fuel, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_traits::{One, Signed};

use super::elimination::Factors;
use crate::argument::{Argument, Rules};

/// Terms of a polynomial beyond which an expansion is given up.
const MAX_TERMS: usize = 400;
/// Premises used one after the other.
const MAX_DEPTH: u32 = 2;

/// multiplier·p = Σ weight·Π atoms, with a multiplier whose coefficients are positive.
struct Expanded {
    multiplier: Poly,
    terms: Vec<(BigInt, Factors)>,
}

/// What is known: variables ≥ 0, each with its atom, and premises that bound one.
struct Known<'a> {
    atoms: &'a [Atom],
    /// (variable, atom)
    variables: Vec<(usize, usize)>,
    /// atoms that are not single variables
    premises: Vec<usize>,
    fuel: &'a Fuel,
}

/// One of the last inequalities, or of the last equations, contradicts the other atoms.
pub(crate) fn expansion(state: &State<'_, '_>) -> Option<Argument> {
    let long = |i: &usize| state.atoms[*i].decided().is_none() && state.atoms[*i].poly.len() > 1;
    let with = |fits: fn(Sign) -> bool| {
        let all = (0..state.atoms.len()).rev().filter(long);
        all.filter(move |&i| fits(state.atoms[i].sign)).take(3)
    };
    with(Sign::is_order).find_map(|i| contradicted(state, i, &state.atoms[i].poly)).or_else(|| {
        let either = |i: usize| {
            let poly = &state.atoms[i].poly;
            [poly.clone(), poly.neg()].iter().find_map(|p| contradicted(state, i, p))
        };
        with(|sign| sign == Sign::Zero).find_map(either)
    })
}

/// Why p, the polynomial of an atom or, for an equation, its negative, is not above 0.
fn contradicted(state: &State<'_, '_>, target: usize, p: &Poly) -> Option<Argument> {
    let atoms = &state.atoms;
    let usable =
        |i: &usize| *i != target && atoms[*i].sign.is_order() && atoms[*i].decided().is_none();
    let mut variables: Vec<(usize, usize)> = Vec::new();
    let mut premises = Vec::new();
    for i in (0..atoms.len()).filter(usable) {
        let p = &atoms[i].poly;
        match (&p.vars()[..], p.len()) {
            ([v], 1) if *p == Poly::var(*v) => {
                match variables.iter_mut().find(|known| known.0 == *v) {
                    // the strict one serves better
                    Some(known) if atoms[i].sign == Sign::Positive => known.1 = i,
                    Some(_) => {}
                    None => variables.push((*v, i)),
                }
            }
            _ if p.len() <= 40 => premises.push(i),
            _ => {}
        }
    }
    let known = Known { atoms, variables, premises, fuel: &state.scope.fuel };
    let Expanded { multiplier, terms } = known.expand(&p.neg(), MAX_DEPTH)?;
    // multiplier·p + Σ terms = 0
    let mut all: Vec<(BigInt, Factors)> = Vec::new();
    let mut cofactors = Vec::new();
    if atoms[target].sign == Sign::Zero {
        let turned = *p != atoms[target].poly;
        cofactors.push((target, if turned { multiplier.neg() } else { multiplier }));
    } else {
        for (weight, factors) in known.product(&multiplier)? {
            all.push((weight, merged(&factors, &[(target, 1)])));
        }
    }
    all.extend(terms);
    let terms =
        all.into_iter().map(|(weight, factors)| Term { weight, square: Poly::one(), factors });
    let proof = Argument::Positive { terms: terms.collect(), cofactors };
    state.closes(&proof).is_ok().then_some(proof)
}

impl Known<'_> {
    /// A polynomial with positive coefficients as a sum of products of atoms.
    fn product(&self, p: &Poly) -> Option<Vec<(BigInt, Factors)>> {
        let term = |(m, c): (&[kane_kernel::Power], &BigInt)| {
            let atom = |&(v, n): &(usize, u32)| {
                self.variables.iter().find(|known| known.0 == v).map(|known| (known.1, n))
            };
            let factors: Option<Factors> = m.iter().map(atom).collect();
            c.is_positive().then_some(())?;
            Some((c.clone(), factors?))
        };
        p.terms().map(term).collect()
    }

    fn expand(&self, p: &Poly, depth: u32) -> Option<Expanded> {
        if let Some(terms) = self.product(p) {
            return Some(Expanded { multiplier: Poly::one(), terms });
        }
        if depth == 0 || p.len() > MAX_TERMS {
            return None;
        }
        let vars = p.vars();
        // variables that nothing bounds below are not for the orthant
        self.premises.iter().find_map(|&i| {
            let h = &self.atoms[i].poly;
            vars.iter().filter(|v| h.degree(**v) == 1).find_map(|&v| self.by(p, i, v, depth))
        })
    }

    /// In powers of premise i, which bounds v.
    fn by(&self, p: &Poly, i: usize, v: usize, depth: u32) -> Option<Expanded> {
        let h = self.atoms[i].poly.coefficients(v);
        let [rest, lead] = &h[..] else { return None };
        if self.product(lead).is_some() {
            self.below(p, i, v, (lead, rest), depth)
        } else {
            let lead = lead.neg();
            self.product(&lead)?;
            self.above(p, i, v, (&lead, rest), depth)
        }
    }

    /// h = lead·v + rest: lead^n·p = Σ r_k·h^k.
    fn below(
        &self,
        p: &Poly,
        i: usize,
        v: usize,
        (lead, rest): (&Poly, &Poly),
        depth: u32,
    ) -> Option<Expanded> {
        let (coefficients, fuel) = (p.coefficients(v), self.fuel);
        let n = u32::try_from(coefficients.len()).ok()? - 1;
        // (h − rest)^j in powers of h, one power after the other
        let minus = rest.neg();
        let mut power = vec![Poly::one()];
        let mut sums: Vec<Poly> = vec![Poly::default(); coefficients.len()];
        for (j, a) in (0..).zip(&coefficients) {
            let scale = a.mul(&lead.pow(n - j, fuel).ok()?, fuel).ok()?;
            for (sum, c) in sums.iter_mut().zip(&power) {
                *sum = sum.add(&scale.mul(c, fuel).ok()?);
            }
            let mut next = vec![Poly::default(); power.len() + 1];
            for (k, c) in power.iter().enumerate() {
                next[k] = next[k].add(&c.mul(&minus, fuel).ok()?);
                next[k + 1] = next[k + 1].add(c);
            }
            power = next;
        }
        let parts = (0..).zip(sums).map(|(k, r)| (vec![(i, k)], r));
        self.combined(&lead.pow(n, fuel).ok()?, parts.collect(), depth)
    }

    /// h = rest − lead·v, with v ≥ 0 and rest > 0: rest^n·p = Σ r_k·v^k·h^(n−k).
    fn above(
        &self,
        p: &Poly,
        i: usize,
        v: usize,
        (lead, rest): (&Poly, &Poly),
        depth: u32,
    ) -> Option<Expanded> {
        let fuel = self.fuel;
        self.product(rest)?;
        let at = self.variables.iter().find(|known| known.0 == v)?.1;
        let coefficients = p.coefficients(v);
        let n = u32::try_from(coefficients.len()).ok()? - 1;
        let mut sums: Vec<Poly> = vec![Poly::default(); coefficients.len()];
        for (j, a) in (0u32..).zip(&coefficients) {
            // a·rest^j·v^j·(h + lead·v)^(n−j)
            let scale = a.mul(&rest.pow(j, fuel).ok()?, fuel).ok()?;
            let mut binomial = BigInt::one();
            for k in 0..=(n - j) {
                let c = lead.pow(k, fuel).ok()?.scale(&binomial);
                let place = usize::try_from(j + k).ok()?;
                sums[place] = sums[place].add(&scale.mul(&c, fuel).ok()?);
                binomial = binomial * (n - j - k) / (k + 1);
            }
        }
        let parts = (0..).zip(sums).map(|(k, r)| (merged(&[(at, k)], &[(i, n - k)]), r));
        self.combined(&rest.pow(n, fuel).ok()?, parts.collect(), depth)
    }

    /// Σ r·Π factors with every r expanded in turn.
    fn combined(&self, by: &Poly, parts: Vec<(Factors, Poly)>, depth: u32) -> Option<Expanded> {
        let parts: Vec<_> = parts.into_iter().filter(|(_, r)| !r.is_empty()).collect();
        if parts.iter().any(|(_, r)| r.len() > MAX_TERMS) {
            return None;
        }
        // the cheap refusal first: a part that a premise would have to save is rare
        let expanded: Vec<Expanded> =
            parts.iter().map(|(_, r)| self.expand(r, depth - 1)).collect::<Option<_>>()?;
        let mut multiplier = Poly::one();
        for part in &expanded {
            multiplier = multiplier.mul(&part.multiplier, self.fuel).ok()?;
        }
        let mut terms = Vec::new();
        for (index, ((factors, _), part)) in parts.iter().zip(&expanded).enumerate() {
            let mut others = Poly::one();
            for (_, other) in expanded.iter().enumerate().filter(|(j, _)| *j != index) {
                others = others.mul(&other.multiplier, self.fuel).ok()?;
            }
            for (c, of_others) in self.product(&others)? {
                for (weight, own) in &part.terms {
                    let all = merged(&merged(factors, own), &of_others);
                    terms.push((weight * &c, all));
                }
            }
        }
        (terms.len() <= 20 * MAX_TERMS).then_some(())?;
        Some(Expanded { multiplier: multiplier.mul(by, self.fuel).ok()?, terms })
    }
}

/// The product of two products of atoms.
fn merged(a: &[(usize, u32)], b: &[(usize, u32)]) -> Factors {
    let mut out: Factors = a.iter().copied().filter(|f| f.1 > 0).collect();
    for &(i, n) in b.iter().filter(|f| f.1 > 0) {
        match out.iter_mut().find(|f| f.0 == i) {
            Some(known) => known.1 += n,
            None => out.push((i, n)),
        }
    }
    out.sort_unstable();
    out
}
