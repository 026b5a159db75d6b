//! Points as witnesses: their coordinates, and how each condition follows at an algebraic number.

use kane_audit::contradicts_bounds;
use kane_kernel::{Atom, Atoms, Fuel, Point, Poly, Root, Sign, State, sign_at};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::NotEmitted;
use super::reify::{Symbols, integer, join};
use super::script::Writer;

/// Halvings of an isolating interval before its signs are given up.
const MAX_HALVINGS: usize = 64;

/// A point as data, and its coordinates one by one.
#[derive(Debug)]
pub(super) struct Witness {
    pub(super) data: String,
    /// coefficients and denominator of each symbol's value
    pub(super) values: Vec<String>,
}

/// The witness for a state, over symbols behind one more variable, the algebraic number.
pub(super) fn witness(
    symbols: &Symbols<'_>,
    state: &State<'_, '_>,
    point: &Point,
) -> Result<Witness, NotEmitted> {
    let (mut values, mut fixed) = (Vec::new(), Vec::new());
    for &v in &symbols.order {
        let value = point.values.iter().find(|(w, _)| *w == v).map(|(_, cs)| &cs[..]);
        let cs = value.ok_or(NotEmitted::Step("no value"))?;
        let common = cs.iter().fold(BigInt::one(), |l, q| l.lcm(q.denom()));
        let whole: Vec<BigInt> = cs.iter().map(|q| q.numer() * (&common / q.denom())).collect();
        let written: Vec<String> = whole.iter().map(integer).collect();
        values.push(format!("[{}]%Z {common}", join(&written, "; ")));
        let rule = Poly::in_variable(state.scope.germ(), &whole);
        fixed.push((v, Poly::var(v).scale(&common).sub(&rule)));
    }
    let (root, closings) = match &point.generator {
        None => ("None".to_owned(), "Absurd".to_owned()),
        Some(root) => {
            let (root, closings) = At { symbols, state, fixed }.closed(root)?;
            (format!("(Some {})", generator(&root)), closings.join(";\n   "))
        }
    };
    let coordinates: Vec<String> = values.iter().map(|v| format!("c_ {v}")).collect();
    let data = format!("Witness\n  [{}]\n  {root}\n  [{closings}]", coordinates.join("; "));
    Ok(Witness { data, values })
}

fn generator(root: &Root) -> String {
    let cs: Vec<String> = root.poly.iter().map(integer).collect();
    let end = |q: &BigRational| format!("(q_ {} {})", integer(q.numer()), q.denom());
    format!("(Generator [{}]%Z {} {})", cs.join("; "), end(&root.lo), end(&root.hi))
}

/// A point at an algebraic number θ: each symbol as a polynomial in it.
struct At<'a> {
    symbols: &'a Symbols<'a>,
    state: &'a State<'a, 'a>,
    fixed: Vec<(usize, Poly)>,
}

impl At<'_> {
    /// An interval around θ on which all that is to hold is seen by signs of coefficients, its
    /// polynomial rising through zero; and the proofs.
    fn closed(&self, root: &Root) -> Result<(Root, Vec<String>), NotEmitted> {
        let mut root = root.clone();
        if sign_at(&root.poly, &root.lo) > 0 {
            root.poly.iter_mut().for_each(|c| *c = -&*c);
        }
        for _ in 0..MAX_HALVINGS {
            if let Some(closings) = self.closings(&root) {
                return Ok((root, closings));
            }
            let middle = (&root.lo + &root.hi) / BigRational::from_integer(2.into());
            match sign_at(&root.poly, &middle) {
                -1 => root.lo = middle,
                1 => root.hi = middle,
                _ => break,
            }
        }
        Err(NotEmitted::Step("a point at an algebraic number of which a sign is not seen"))
    }

    /// Proofs that one case of each formula holds; `None` if the interval is too wide for that.
    fn closings(&self, root: &Root) -> Option<Vec<String>> {
        let ranges = std::slice::from_ref(&self.state.atoms);
        let mut all: Vec<String> = Vec::new();
        for cases in std::iter::once(ranges).chain(self.state.formulas.iter().map(|c| &c[..])) {
            let case = |atoms: &Atoms| atoms.iter().map(|a| self.closing(root, a).ok()).collect();
            let closed: Vec<String> = cases.iter().find_map(case)?;
            for proof in closed {
                if !all.contains(&proof) {
                    all.push(proof);
                }
            }
        }
        Some(all)
    }

    /// The proof that an atom holds, after all symbols are replaced and powers of θ reduced.
    fn closing(&self, root: &Root, atom: &Atom) -> Result<String, NotEmitted> {
        let theta = self.state.scope.germ();
        let line =
            |a: BigInt, b: BigInt| Atom::new(Poly::in_variable(theta, &[a, b]), Sign::Positive);
        let mut atoms: Atoms =
            self.fixed.iter().map(|(_, p)| Atom::new(p.clone(), Sign::Zero)).collect();
        let n = atoms.len();
        atoms.push(Atom::new(Poly::in_variable(theta, &root.poly), Sign::Zero));
        atoms.push(line(-root.lo.numer(), root.lo.denom().clone()));
        atoms.push(line(root.hi.numer().clone(), -root.hi.denom()));
        atoms.push(atom.not());
        // Coq does the same, one after the other.
        let modulus = (theta, atoms[n].poly.clone());
        for (v, rule) in self.fixed.iter().chain([&modulus]) {
            let rule = match rule.coefficients(*v).pop().and_then(|c| c.as_constant()) {
                Some(c) if c.is_negative() => rule.neg(),
                _ => rule.clone(),
            };
            let rest = atoms[n + 3].poly.remainder(*v, &rule, false, &Fuel::new(u64::MAX))?;
            atoms[n + 3].poly = rest.primitive().1;
        }
        let state = State { atoms, ..self.state.clone() };
        let atoms = &state.atoms;
        match atoms[n + 3].decided() {
            Some(false) => Ok("Absurd".to_owned()),
            Some(true) => Err(NotEmitted::Step("an atom that fails")),
            None => {
                let bounds = [(theta, Some(n + 1), Some(n + 2))];
                let proof = contradicts_bounds(&state, n + 3, &bounds)
                    .ok_or(NotEmitted::Step("coefficients of two signs"))?;
                Writer { symbols: self.symbols, sides: None }.proof(&state, &proof)
            }
        }
    }
}
