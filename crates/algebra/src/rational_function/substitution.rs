//! Rational functions put in the place of symbols.

use std::collections::HashMap;

use kane_kernel::{Fuel, Monomial, Poly, Rejection};

/// A symbol and what takes its place.
pub(super) struct Replacement {
    pub(super) symbol: usize,
    pub(super) num: Poly,
    pub(super) den: Poly,
}

/// p(n/d)·Π dᵢ^degreeᵢ, a polynomial.
pub(super) fn composed(
    p: &Poly,
    parts: &[Replacement],
    degrees: &[u32],
    fuel: &Fuel,
) -> Result<Poly, Rejection> {
    let mut powers: HashMap<(usize, u32), Poly> = HashMap::new();
    let mut sum = Poly::default();
    for (m, c) in p.terms() {
        let replaced = |v: usize| parts.iter().any(|r| r.symbol == v);
        let kept: Monomial = m.iter().copied().filter(|&(v, _)| !replaced(v)).collect();
        let mut product = Poly::term(kept, c.clone());
        for (i, (part, degree)) in parts.iter().zip(degrees).enumerate() {
            let e = kane_kernel::exponent(m, part.symbol);
            let power = match powers.get(&(i, e)) {
                Some(known) => known.clone(),
                None => {
                    let power =
                        part.num.pow(e, fuel)?.mul(&part.den.pow(degree - e, fuel)?, fuel)?;
                    powers.insert((i, e), power.clone());
                    power
                }
            };
            product = product.mul(&power, fuel)?;
        }
        sum = sum.add(&product);
    }
    Ok(sum)
}
