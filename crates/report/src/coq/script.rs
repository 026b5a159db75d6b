//! Proofs of the kernel as terms of the Coq file.

use kane_kernel::{Atom, Germ, Poly, Proof, Side, Sign, State};
use num_bigint::BigInt;
use num_traits::One;

use super::NotEmitted;
use super::reify::{Symbols, integer, join};

/// Writes proofs over the symbols of one lemma.
#[derive(Debug)]
pub(super) struct Writer<'a> {
    pub(super) symbols: &'a Symbols<'a>,
}

impl Writer<'_> {
    pub(super) fn poly(&self, p: &Poly) -> Result<String, NotEmitted> {
        self.symbols.poly(p)
    }

    /// The proof that closes a state.
    pub(super) fn proof(&self, state: &State<'_, '_>, proof: &Proof) -> Result<String, NotEmitted> {
        Ok(match proof {
            Proof::Absurd => "Absurd".to_owned(),
            Proof::Assume { formula, cases } => {
                let states = state.assume(*formula)?;
                let each = states.iter().zip(cases).map(|(s, p)| self.proof(s, p));
                let each = each.collect::<Result<Vec<_>, _>>()?;
                format!("(Assume {formula} [{}])", each.join("; "))
            }
            Proof::Split { poly, zero, positive, negative } => {
                let with = |sign, p: Poly| state.with(Atom::new(p, sign));
                let zero = self.proof(&with(Sign::Zero, poly.clone()), zero)?;
                let positive = self.proof(&with(Sign::Positive, poly.clone()), positive)?;
                let negative = self.proof(&with(Sign::Positive, poly.neg()), negative)?;
                format!("(Split {} {zero} {positive} {negative})", self.poly(poly)?)
            }
            Proof::Substitute { equation, var, lead, then } => {
                let next = state.substitute(*equation, *var, lead)?;
                let (var, then) = (self.symbols.variable(*var)?, self.proof(&next, then)?);
                format!("(Substitute {equation} {var} {} {then})", factors(lead))
            }
            Proof::Cancel { atom, factors: by, quotient, then } => {
                let next = state.cancel(*atom, by, quotient)?;
                let (quotient, then) = (self.poly(quotient)?, self.proof(&next, then)?);
                format!("(Cancel {atom} {} {quotient} {then})", factors(by))
            }
            Proof::Positive { terms, cofactors } => {
                let terms: Vec<_> = terms
                    .iter()
                    .map(|t| (t.weight.clone(), t.square.clone(), t.factors.clone()))
                    .collect();
                self.positive(&terms, cofactors)?
            }
            Proof::Orthant { atom, bounds } => {
                super::bounds::refute(self, &mut state.atoms.clone(), *atom, bounds)?
            }
            Proof::SignTable { var, bases, roots, atoms } => {
                super::table::Table { writer: self, var: *var, bases, roots, used: atoms }
                    .close(&mut state.atoms.clone())?
            }
            Proof::Pass { germ, atom, along, then } => {
                let (num, den, positive, inside, state_along) = self.germ(state, germ)?;
                let along = self.proof(&state_along.with(atom.not()), along)?;
                let then = self.proof(&state.with(state.at_zero(germ, atom)?), then)?;
                let side = side(&germ.side);
                let atom = self.atom(atom)?;
                format!("(Pass {side} {num} {den} {positive} {inside} {atom} {along} {then})")
            }
        })
    }

    /// A germ's radius and the proofs that it is positive and inside the domain, and the state
    /// along it.
    pub(super) fn germ<'s, 'g>(
        &self,
        state: &State<'s, 'g>,
        germ: &Germ,
    ) -> Result<(String, String, String, String, State<'s, 'g>), NotEmitted> {
        let (num, den) = &germ.radius;
        let below = |p: &Poly| vec![Atom::new(p.clone(), Sign::Positive).not()];
        let with = state.with_cases(vec![below(num), below(den)]);
        let positive = self.proof(&with, &germ.positive)?;
        let along = state.along_unproved(germ)?;
        let leaves = kane_kernel::leaves(state.scope, state.goal, germ.side.var)?;
        let out = State { formulas: std::rc::Rc::new(leaves), ..along.clone() };
        let inside = self.proof(&out, &germ.inside)?;
        Ok((self.poly(num)?, self.poly(den)?, positive, inside, along))
    }

    /// An atom as data.
    pub(super) fn atom(&self, a: &Atom) -> Result<String, NotEmitted> {
        let sign = match a.sign {
            Sign::Zero => "SZ",
            Sign::NonZero => "SNZ",
            Sign::NonNegative => "SNN",
            Sign::Positive => "SP",
        };
        Ok(format!("(A {} {sign})", self.poly(&a.poly)?))
    }

    /// A sum that is zero though one summand is positive: weights, squares, powers of atoms; and
    /// equations with cofactors.
    pub(super) fn positive(
        &self,
        terms: &[(BigInt, Poly, Vec<(usize, u32)>)],
        cofactors: &[(usize, Poly)],
    ) -> Result<String, NotEmitted> {
        let mut parts = Vec::new();
        for (weight, square, known) in terms {
            let square =
                if *square == Poly::one() { "pone".to_owned() } else { self.poly(square)? };
            let weight = if weight.is_one() { "1".to_owned() } else { integer(weight) };
            parts.push(format!("T {weight} {square} {}", factors(known)));
        }
        let mut equations = Vec::new();
        for (i, cofactor) in cofactors {
            equations.push(format!("({i}%nat, {})", self.poly(cofactor)?));
        }
        Ok(format!("(Positive [{}] [{}])", parts.join("; "), equations.join("; ")))
    }
}

/// Indices with powers.
pub(super) fn factors(fs: &[(usize, u32)]) -> String {
    if fs.is_empty() {
        return "[]".to_owned();
    }
    let fs: Vec<String> = fs.iter().map(|(i, n)| format!("({i}, {n})")).collect();
    format!("[{}]%nat", join(&fs, "; "))
}

/// A side as data.
pub(super) fn side(s: &Side) -> String {
    let at = match &s.at {
        Some(a) => format!("(Some (q_ {} {}))", integer(a.numer()), a.denom()),
        None => "None".to_owned(),
    };
    format!("(Side {at} {})", s.above)
}
