//! Circles: u² + v² = 1 as u = (1 − t²)/(1 + t²), v = 2·t/(1 + t²).
//!
//! One variable takes the place of two and of an equation, and every rational t gives a rational
//! point. If t is algebraic, u and v lie in its field, so that one algebraic number is enough. The
//! point (−1, 0) is missed; what is not found here is looked for in u and v themselves.

use kane_kernel::{Atom, Poly, Sign};
use num_bigint::BigInt;

use super::parameter::Parametrised;

/// Writes the circles of a state by parameters, each of two variables that are on none before it.
pub(super) fn circles(written: &mut Parametrised<'_, '_>) -> Option<()> {
    let on: Vec<(usize, usize)> = written.state.atoms.iter().filter_map(circle).collect();
    for (u, v) in on {
        if written.is_gone(u) || written.is_gone(v) {
            continue;
        }
        let t = written.fresh();
        let (square, one) = (Poly::power(t, 2), Poly::one());
        let nums = [(u, one.sub(&square)), (v, Poly::var(t).scale(&BigInt::from(2)))];
        written.write(&nums, &one.add(&square))?;
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
