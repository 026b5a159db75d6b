//! Points: rational values, or values in one real algebraic number.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use crate::{Atoms, Checked, Fuel, Point, Poly, Rejection, Root, State, descartes, sign, sign_at};

/// Halvings of an isolating interval before a sign is given up as undecided.
const MAX_HALVINGS: usize = 512;

/// The variable that stands for the algebraic number; no scope has as many.
const THETA: usize = usize::MAX;

/// Whether a point satisfies the atoms of a state and a case of each of its formulas.
///
/// # Errors
/// [`Rejection::NotAModel`] with the index of the formula that fails.
pub(crate) fn satisfies(state: &State<'_, '_>, point: &Point) -> Checked {
    let fuel = &state.scope.fuel;
    if let Some(Root { poly, lo, hi }) = &point.generator {
        let simple = descartes(poly, lo, hi, fuel)? == 1;
        if !simple || sign_at(poly, lo) == 0 || sign_at(poly, hi) == 0 {
            return Err(Rejection::RootCount);
        }
    }
    let holds = |atoms: &Atoms| -> Checked<bool> {
        for a in atoms {
            if !point.sign(&a.poly, fuel)?.is_some_and(|s| a.sign.admits(s)) {
                return Ok(false);
            }
        }
        Ok(true)
    };
    if !holds(&state.atoms)? {
        return Err(Rejection::NotAModel(None));
    }
    for (i, cases) in state.formulas.iter().enumerate() {
        let mut found = false;
        for case in cases {
            found = found || holds(case)?;
        }
        if !found {
            return Err(Rejection::NotAModel(Some(i)));
        }
    }
    Ok(())
}

impl Point {
    /// Sign of a polynomial at this point; `None` if a variable has no value. Exact.
    ///
    /// # Errors
    /// [`Rejection::Budget`], also if the sign at an algebraic number does not come out.
    fn sign(&self, p: &Poly, fuel: &Fuel) -> Checked<Option<i8>> {
        let modulus = self.generator.as_ref().map_or(&[][..], |root| &root.poly);
        let modulus = Poly::in_variable(THETA, modulus);
        let mut value = p.clone();
        let occurs = |v: usize| v != THETA && p.degree(v) > 0;
        for (v, coefficients) in self.values.iter().filter(|(v, _)| occurs(*v)) {
            let lcm = |l: BigInt, q: &BigRational| num_integer::lcm(l, q.denom().clone());
            let common = coefficients.iter().fold(BigInt::one(), lcm);
            let whole = coefficients.iter().map(|q| q.numer() * (&common / q.denom()));
            let whole = Poly::in_variable(THETA, &whole.collect::<Vec<_>>());
            // The rule common·v = whole(θ) gives a positive multiple, and so does the modulus.
            let rule = Poly::var(*v).scale(&common).sub(&whole);
            value = value.remainder(*v, &rule, true, fuel)?;
            value = value.remainder(THETA, &modulus, true, fuel)?.primitive().1;
        }
        let Some(value) = value.univariate(THETA) else {
            return Ok(None);
        };
        let Some(root) = &self.generator else {
            return Ok(value.first().map(sign));
        };
        let (mut lo, mut hi) = (root.lo.clone(), root.hi.clone());
        for _ in 0..MAX_HALVINGS {
            let middle = (&lo + &hi) / BigRational::from_integer(2.into());
            let side = sign_at(&root.poly, &middle);
            if side == 0 || descartes(&value, &lo, &hi, fuel)? == 0 {
                return Ok(Some(sign_at(&value, &middle)));
            }
            if side == sign_at(&root.poly, &lo) {
                lo = middle;
            } else {
                hi = middle;
            }
        }
        Err(Rejection::Budget)
    }
}
