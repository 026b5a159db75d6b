//! Conics on which rational points lie dense, by a parameter: a circle u² + v² = 1 as u = (1 − t²)/(1 + t²),
//! v = 2·t/(1 + t²); a hyperbola p²·u² − q²·v² = c > 0 with w = p·u − q·v > 0 as u = (w² + c)/(2·p·w),
//! v = (c − w²)/(2·q·w), for p·u + q·v is c/w.
//!
//! One variable takes the place of two and of an equation, and every rational parameter gives a rational
//! point. If it is algebraic, u and v lie in its field, so that one algebraic number is enough. The
//! point (−1, 0) of a circle and the branch of a hyperbola with u < 0 are missed; what is not found here is
//! looked for in u and v themselves.

use kane_kernel::{Atom, Poly, Sign};
use num_bigint::BigInt;
use num_traits::Signed;

use super::parameter::Parametrised;

/// Writes the circles and then the hyperbolas of a state by parameters, each of two variables that are on
/// none before it.
pub(super) fn conics(written: &mut Parametrised<'_, '_>) -> Option<()> {
    let circles: Vec<(usize, usize)> = written.state.atoms.iter().filter_map(circle).collect();
    for (u, v) in circles {
        if written.is_gone(u) || written.is_gone(v) {
            continue;
        }
        let t = written.fresh();
        let (square, one) = (Poly::power(t, 2), Poly::one());
        let nums = [(u, one.sub(&square)), (v, Poly::var(t).scale(&BigInt::from(2)))];
        written.write(&nums, &one.add(&square))?;
    }
    let hyperbolas: Vec<Hyperbola> = written.state.atoms.iter().filter_map(Hyperbola::of).collect();
    for Hyperbola { u, v, p, q, c } in hyperbolas {
        if written.is_gone(u) || written.is_gone(v) {
            continue;
        }
        let w = written.fresh();
        let (square, c) = (Poly::power(w, 2), Poly::constant(c));
        let nums = [(u, square.add(&c).scale(&q)), (v, c.sub(&square).scale(&p))];
        written.write(&nums, &Poly::var(w).scale(&(p * q * 2)))?;
        written.state = written.state.with(Atom::new(Poly::var(w), Sign::Positive));
    }
    Some(())
}

/// The two variables of u² + v² = 1.
fn circle(atom: &Atom) -> Option<(usize, usize)> {
    let [u, v] = atom.poly.vars()[..] else { return None };
    if atom.sign != Sign::Zero {
        return None;
    }
    let unit = Poly::power(u, 2).add(&Poly::power(v, 2)).sub(&Poly::one());
    let poly = atom.poly.primitive().1;
    (poly == unit || poly == unit.neg()).then_some((u, v))
}

/// p²·u² − q²·v² = c > 0, with p, q > 0.
struct Hyperbola {
    u: usize,
    v: usize,
    p: BigInt,
    q: BigInt,
    c: BigInt,
}

impl Hyperbola {
    fn of(atom: &Atom) -> Option<Self> {
        let [u, v] = atom.poly.vars()[..] else { return None };
        let coefficient = |m: &[(usize, u32)]| {
            let found = atom.poly.terms().find(|(n, _)| *n == m);
            found.map(|(_, c)| c.clone())
        };
        let [a, b, k] = [coefficient(&[(u, 2)])?, coefficient(&[(v, 2)])?, coefficient(&[])?];
        if atom.sign != Sign::Zero || atom.poly.len() != 3 || a.is_negative() == b.is_negative() {
            return None;
        }
        // The square whose sign is not that of the constant is the larger one.
        let (u, v, a, b) =
            if a.is_negative() == k.is_negative() { (v, u, b, a) } else { (u, v, a, b) };
        let (p, q) = (root(&a.abs())?, root(&b.abs())?);
        Some(Self { u, v, p, q, c: k.abs() })
    }
}

/// The root of a square.
pub(super) fn root(n: &BigInt) -> Option<BigInt> {
    let root = n.sqrt();
    (&root * &root == *n).then_some(root)
}
