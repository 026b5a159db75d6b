//! The sign of a·p + b with a root p, where the two have opposite signs: that of its product with a·p − b, in which p is
//! squared. No polynomial around p is needed for that.

use kane_kernel::{Poly, Sign};

use super::envelope::{Envelope, unit};
use super::ground::{Cofactors, Equation, Shown, add};
use super::series::{Numbers as _, Value};
use super::summands::{Sum, closed};
use crate::argument::Argument;

impl Envelope<'_, '_, '_> {
    /// The contradiction in an atom that says that a polynomial is negative, or not positive, which is positive for
    /// small t.
    pub(super) fn by_conjugate(&self, atom: usize, shown: &Poly) -> Option<Argument> {
        if !matches!(self.state.atoms[atom].sign, Sign::Positive | Sign::NonNegative) {
            return None;
        }
        let mut roots = self.varying_roots();
        roots.retain(|root| shown.degree(*root) > 0);
        roots.iter().find_map(|&root| {
            let equation = self.of_root(root).filter(|e| !e.of_beta.is_empty())?;
            self.apart_from(atom, shown, &equation)
        })
    }

    /// The same by one root p. With A·p − B or B − A·p in the place of the polynomial, A and B being positive, A·p + B times
    /// the atom is the opposite of A²·p² − B² or of B² − A²·p².
    fn apart_from(&self, atom: usize, shown: &Poly, equation: &Equation) -> Option<Argument> {
        let Equation { atom: q, var, beta, of_beta, gamma, is_opposite, .. } = equation;
        let ground = &self.ground;
        let mut it = Shown::new(shown.clone());
        ground.substitute(&mut it, equation)?;
        let [b, a] = [0, 1].map(|n| it.poly.coefficient(*var, n));
        let is_root_greater = self.sign(&a)?;
        if self.sign(&b)? == is_root_greater {
            return None;
        }
        let (a, b) = if is_root_greater { (a, b.neg()) } else { (a.neg(), b) };
        let p_atom = ground.signs.told(&Poly::var(*var))?;
        let squares = [ground.triple(&a, &a, gamma)?, ground.triple(&b, &b, beta)?];
        let gap =
            if is_root_greater { squares[0].sub(&squares[1]) } else { squares[1].sub(&squares[0]) };
        let [of_a, of_b, of_gap] = [&a, &b, &gap].map(|p| ground.positive(p));
        let (of_a, of_b, of_gap) = (of_a?, of_b?, of_gap?);

        let product = |x: &Sum, y: &Sum| ground.product(x, y);
        let once = product(&product(&it.of_scale, of_beta)?, &vec![unit(&[(atom, 1)])])?;
        let both = product(&of_a.of_scale, &of_b.of_scale)?;
        let with_root = product(&of_a.products, &vec![unit(&[(p_atom, 1)])])?;
        let mut sum = product(&product(&of_b.of_scale, &with_root)?, &of_gap.of_scale)?;
        sum.extend(product(&product(&of_a.of_scale, &of_b.products)?, &of_gap.of_scale)?);
        let mut sum = product(&once, &sum)?;
        sum.extend(product(&both, &of_gap.products)?);

        let opposite = &self.state.atoms[atom].poly;
        let scaled = ground.triple(opposite, &it.scale, beta)?;
        let root = Poly::var(*var);
        let mut cofactors = Cofactors::new();
        let mut more = |of: &Cofactors, by: &Poly| -> Option<()> {
            for (i, c) in ground.times(of, by)? {
                add(&mut cofactors, i, &c);
            }
            Some(())
        };
        let times_gap = |p: &Poly| ground.triple(p, &of_gap.scale, &scaled);
        more(&of_a.cofactors, &ground.mul(&times_gap(&of_b.scale)?, &root)?)?;
        more(&of_b.cofactors, &times_gap(&of_a.scale)?)?;
        more(&of_gap.cofactors, &ground.mul(&of_a.scale, &of_b.scale)?)?;
        let all = ground.triple(&of_a.scale, &of_b.scale, &of_gap.scale)?;
        let whole = ground.mul(&ground.mul(&a, &root)?.add(&b), beta)?;
        more(&it.cofactors, &ground.mul(&all, &whole)?)?;
        let of_square = ground.triple(&all, &a, &a)?;
        let is_added = is_root_greater != *is_opposite;
        add(&mut cofactors, *q, &if is_added { of_square } else { of_square.neg() });
        Some(closed(sum, cofactors))
    }

    /// Whether a polynomial is positive for small t, by its series.
    pub(super) fn sign(&self, p: &Poly) -> Option<bool> {
        let Value::Series(series) = self.along.polynomial(p)? else { return None };
        self.along.numbers.is_positive(&series.coefficients[0])
    }
}
