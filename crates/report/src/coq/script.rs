//! Proofs of the kernel as terms of the Coq file.

use std::cell::RefCell;

use kane_kernel::{Atom, Poly, Proof, Side, Sign, State};
use num_bigint::BigInt;
use num_traits::One;

use super::NotEmitted;
use super::reify::{Symbols, integer, join};

/// weight · square² · Π powers of atoms
pub(super) type Summand = (BigInt, Poly, Vec<(usize, u32)>);

/// Writes proofs over the symbols of one lemma.
#[derive(Debug)]
pub(super) struct Writer<'a> {
    pub(super) symbols: &'a Symbols<'a>,
    /// the sides from which limits are taken; `None` where none may be
    pub(super) sides: Option<RefCell<Vec<Side>>>,
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
                self.pass(state, (germ, atom), (along, then))?
            }
        })
    }

    /// A sum that is zero though one summand is positive: weights, squares, powers of atoms; and
    /// equations with cofactors.
    pub(super) fn positive(
        &self,
        terms: &[Summand],
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
