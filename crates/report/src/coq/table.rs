//! Sign tables as cases: the line is cut at rational points, and what is left between them is read
//! off the signs of coefficients.

use kane_kernel::{Atom, Fuel, Poly, Root, Sign, sign, sign_at};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::NotEmitted;
use super::bounds::Signs;
use super::script::Writer;

/// A sign table, as the kernel checks it.
#[derive(Debug)]
pub(super) struct Table<'a> {
    pub(super) writer: &'a Writer<'a>,
    pub(super) var: usize,
    pub(super) bases: &'a [Vec<BigInt>],
    pub(super) roots: &'a [Root],
    pub(super) used: &'a [(usize, BigRational, Vec<u32>)],
}

/// An end of an interval: the point and the index of the atom that says on which side of it we are.
type Cut = Option<(BigRational, usize)>;

impl Table<'_> {
    /// The proof.
    pub(super) fn close(&self, atoms: &mut Vec<Atom>) -> Result<String, NotEmitted> {
        if self.roots.is_empty() {
            return self.cut(
                atoms,
                &BigRational::zero(),
                |atoms, cut| self.gap(atoms, None, Some(cut)),
                |atoms, cut| self.gap(atoms, Some(cut), None),
            );
        }
        self.from(atoms, 0, None)
    }

    /// What is right of the cut, from this root on.
    fn from(&self, atoms: &mut Vec<Atom>, i: usize, left: Cut) -> Result<String, NotEmitted> {
        let Some(root) = self.roots.get(i) else {
            return self.gap(atoms, left, None);
        };
        if left.as_ref().is_some_and(|(q, _)| *q == root.lo) {
            return self.root(atoms, i, left);
        }
        let before = left.clone();
        self.cut(
            atoms,
            &root.lo,
            |atoms, cut| self.gap(atoms, before, Some(cut)),
            |atoms, cut| {
                if root.is_exact() {
                    self.from(atoms, i + 1, Some(cut))
                } else {
                    self.root(atoms, i, Some(cut))
                }
            },
        )
    }

    /// Right of an irrational root's interval's left end.
    fn root(&self, atoms: &mut Vec<Atom>, i: usize, left: Cut) -> Result<String, NotEmitted> {
        let root = &self.roots[i];
        self.cut(
            atoms,
            &root.hi,
            |atoms, right| self.inside(atoms, root, &left, &Some(right)),
            |atoms, cut| self.from(atoms, i + 1, Some(cut)),
        )
    }

    /// Cases at a rational point: there, all atoms are numbers.
    fn cut(
        &self,
        atoms: &mut Vec<Atom>,
        at: &BigRational,
        below: impl FnOnce(&mut Vec<Atom>, (BigRational, usize)) -> Result<String, NotEmitted>,
        above: impl FnOnce(&mut Vec<Atom>, (BigRational, usize)) -> Result<String, NotEmitted>,
    ) -> Result<String, NotEmitted> {
        let poly = Poly::in_variable(self.var, &[-at.numer(), at.denom().clone()]);
        let i = atoms.len();
        let v = self.writer.symbols.variable(self.var)?;
        let zero = format!("(Substitute {i} {v} [] Absurd)");
        atoms.push(Atom::new(poly.clone(), Sign::Positive));
        let positive = above(atoms, (at.clone(), i))?;
        atoms[i] = Atom::new(poly.neg(), Sign::Positive);
        let negative = below(atoms, (at.clone(), i))?;
        atoms.pop();
        Ok(format!("(Split {} {zero} {positive} {negative})", self.writer.poly(&poly)?))
    }

    /// The sign of an atom where the bases have these signs.
    fn sign(&self, signs: &[i8], (_, constant, powers): &(usize, BigRational, Vec<u32>)) -> i8 {
        let power = |(s, n): (&i8, &u32)| match n {
            0 => 1,
            n if n % 2 == 0 => s * s,
            _ => *s,
        };
        sign(constant.numer()) * signs.iter().zip(powers).map(power).product::<i8>()
    }

    fn violated(&self, atoms: &[Atom], signs: &[i8]) -> Option<&(usize, BigRational, Vec<u32>)> {
        self.used.iter().find(|a| !atoms[a.0].sign.admits(self.sign(signs, a)))
    }

    /// Between two cuts without a root between them.
    fn gap(&self, atoms: &mut Vec<Atom>, left: Cut, right: Cut) -> Result<String, NotEmitted> {
        let one = BigRational::one();
        let inside = match (&left, &right) {
            (Some((a, _)), Some((b, _))) => (a + b) / BigRational::from_integer(2.into()),
            (Some((a, _)), None) => a + one,
            (None, Some((b, _))) => b - one,
            (None, None) => BigRational::zero(),
        };
        let signs: Vec<i8> = self.bases.iter().map(|p| sign_at(p, &inside)).collect();
        let (i, ..) = self.violated(atoms, &signs).ok_or(NotEmitted::Step("an open cell"))?;
        let whole = atoms[*i].poly.clone();
        let bounds = [(self.var, left.map(|c| c.1), right.map(|c| c.1))];
        Signs::new(self.writer, atoms, *i, (&[], &whole), &bounds)?.close(atoms)
    }

    /// Around an irrational root: at it, right of it and left of it.
    fn inside(
        &self,
        atoms: &mut Vec<Atom>,
        root: &Root,
        left: &Cut,
        right: &Cut,
    ) -> Result<String, NotEmitted> {
        let missing = || NotEmitted::Step("a root without its polynomial");
        let base = self.bases.iter().position(|b| *b == root.poly).ok_or_else(missing)?;
        let poly = Poly::in_variable(self.var, &root.poly);
        let middle = (&root.lo + &root.hi) / BigRational::from_integer(2.into());
        let mut signs: Vec<i8> = self.bases.iter().map(|p| sign_at(p, &middle)).collect();
        let new = atoms.len();
        let bounds = [(self.var, left.as_ref().map(|c| c.1), right.as_ref().map(|c| c.1))];
        let mut parts = Vec::new();
        for here in [0, 1, -1] {
            signs[base] = here;
            let atom = match here {
                0 => Atom::new(poly.clone(), Sign::Zero),
                1 => Atom::new(poly.clone(), Sign::Positive),
                _ => Atom::new(poly.neg(), Sign::Positive),
            };
            atoms.push(atom);
            let (i, constant, powers) =
                self.violated(atoms, &signs).ok_or(NotEmitted::Step("an open cell"))?;
            let n = powers[base];
            let proof = if here == 0 && n > 0 {
                self.at_root(atoms, (*i, new), n, &self.rest(constant, powers, base, 1)?)?
            } else {
                let flip = here < 0 && n % 2 == 1;
                let rest = self.rest(constant, powers, base, if flip { -1 } else { 1 })?;
                let known = [(new, n)];
                let known = if n > 0 { &known[..] } else { &[] };
                Signs::new(self.writer, atoms, *i, (known, &rest), &bounds)?.close(atoms)?
            };
            atoms.pop();
            parts.push(proof);
        }
        Ok(format!("(Split {} {})", self.writer.poly(&poly)?, parts.join(" ")))
    }

    /// The product of all bases but one, with the constant.
    fn rest(
        &self,
        constant: &BigRational,
        powers: &[u32],
        without: usize,
        flip: i64,
    ) -> Result<Poly, NotEmitted> {
        let fuel = Fuel::new(u64::MAX);
        if !constant.denom().is_one() {
            return Err(NotEmitted::Step("a fraction before a product"));
        }
        let mut out = Poly::constant(constant.numer() * flip);
        for (j, (b, n)) in self.bases.iter().zip(powers).enumerate() {
            if j != without {
                out = out.mul(&Poly::in_variable(self.var, b).pow(*n, &fuel)?, &fuel)?;
            }
        }
        Ok(out)
    }

    /// An atom > 0 or ≠ 0 that is a multiple of what is zero.
    fn at_root(
        &self,
        atoms: &[Atom],
        (atom, zero): (usize, usize),
        n: u32,
        rest: &Poly,
    ) -> Result<String, NotEmitted> {
        let fuel = Fuel::new(u64::MAX);
        // P = zeroⁿ·rest, so Pᵉ − zero·(zeroⁿ⁻¹·rest·Pᵉ⁻¹) = 0.
        let e = if atoms[atom].sign == Sign::Positive { 1 } else { 2 };
        let cofactor = atoms[zero].poly.pow(n - 1, &fuel)?.mul(rest, &fuel)?.neg();
        let cofactor = cofactor.mul(&atoms[atom].poly.pow(e - 1, &fuel)?, &fuel)?;
        let term = (BigInt::one(), Poly::one(), vec![(atom, e)]);
        debug_assert!(term.0.is_positive());
        self.writer.positive(&[term], &[(zero, cofactor)])
    }
}
