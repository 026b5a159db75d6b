//! Projection: polynomials in fewer variables between whose zeros nothing changes (Collins 1975,
//! McCallum 1998).

use kane_kernel::{Atom, Fuel, Poly, Sign};

use super::resultant::{discriminant, resultant};
use crate::ring::{cancelled, content_in, gcd};

/// Polynomials of a projection, beyond which it is given up.
const MOST: usize = 40;

/// Polynomials of which `polys` are products up to constants, without common or repeated factors.
fn coprime(polys: &[Poly], v: usize, fuel: &Fuel) -> Option<Vec<Poly>> {
    let mut bases: Vec<Poly> = Vec::new();
    for p in polys {
        let slope = p.derivative(v, fuel).ok()?;
        let mut todo = vec![cancelled(p, &slope).0.primitive().1];
        while let Some(mut p) = todo.pop() {
            let mut i = 0;
            while i < bases.len() && p.degree(v) > 0 {
                fuel.spend(100 * u64::try_from(p.len() + bases[i].len()).ok()?).ok()?;
                let common = gcd(&p, &bases[i]);
                if common.degree(v) > 0 {
                    let rest = cancelled(&bases[i], &common).0.primitive().1;
                    p = cancelled(&p, &common).0.primitive().1;
                    bases[i] = common;
                    if rest.degree(v) > 0 {
                        bases.push(rest);
                    }
                }
                i += 1;
            }
            if p.degree(v) > 0 {
                bases.push(p);
            }
        }
        if bases.len() > MOST {
            return None;
        }
    }
    Some(bases)
}

/// What is left of conditions when v goes: polynomials in the other variables such that, where they
/// keep their signs, the conditions in v have the same cells. An equation in v spares what the others
/// do among themselves: all points lie on it (McCallum 1999). *Heuristic* where a polynomial vanishes
/// identically in v at a point of three variables or more. `None` if it gets too large.
pub(super) fn projection(
    polys: &[Poly],
    equation: Option<&Poly>,
    v: usize,
    fuel: &Fuel,
) -> Option<Vec<Poly>> {
    let mut out: Vec<Poly> = Vec::new();
    let mut with_v = Vec::new();
    let mut split = |p: &Poly, out: &mut Vec<Poly>| {
        if p.degree(v) == 0 {
            add(out, p);
            return;
        }
        let content = content_in(p, v);
        add(out, &content);
        let p = if content.is_constant() { p.clone() } else { cancelled(p, &content).0 };
        with_v.push(p.primitive().1);
    };
    polys.iter().for_each(|p| split(p, &mut out));
    let bases = coprime(&with_v, v, fuel)?;
    let central = equation.map(|e| {
        let e = cancelled(e, &content_in(e, v)).0;
        let divides = |p: &Poly| gcd(&e, p).degree(v) > 0;
        bases.iter().map(divides).collect::<Vec<_>>()
    });
    let is_central = |i: usize| central.as_ref().is_none_or(|c| c[i]);
    for (i, p) in bases.iter().enumerate() {
        if is_central(i) {
            for c in p.coefficients(v).iter().rev() {
                add(&mut out, c);
                if c.is_constant() && !c.is_empty() {
                    break;
                }
            }
            if p.degree(v) > 1 {
                add(&mut out, &discriminant(p, v, fuel)?);
            }
        }
        for (j, q) in bases[..i].iter().enumerate() {
            if is_central(i) || is_central(j) {
                add(&mut out, &resultant(p, q, v, fuel)?);
            }
        }
        if out.len() > MOST {
            return None;
        }
    }
    Some(out)
}

fn add(out: &mut Vec<Poly>, p: &Poly) {
    let p = p.primitive().1;
    if !p.is_constant() && !out.contains(&p) && !out.contains(&p.neg()) {
        out.push(p);
    }
}

/// The equation in v of lowest degree, if there is one.
pub(super) fn equation(atoms: &[Atom], v: usize) -> Option<&Poly> {
    let equations = atoms.iter().filter(|a| a.sign == Sign::Zero && a.poly.degree(v) > 0);
    equations.map(|a| &a.poly).min_by_key(|p| (p.degree(v), p.len()))
}
