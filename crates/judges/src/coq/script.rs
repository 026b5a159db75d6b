//! Proofs of the kernel as terms of the Coq file.

use std::cell::RefCell;

use kane_kernel::{Atom, Poly, Proof, Side, Sign, State, Term};
use num_traits::One;

use super::NotEmitted;
use super::reify::{Symbols, integer, join};

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
            Proof::Assume { formula, cases } => {
                let states = state.assume(*formula)?;
                let each = states.iter().zip(cases).map(|(s, p)| self.proof(s, p));
                let each = each.collect::<Result<Vec<_>, _>>()?;
                format!("(Assume {formula} [{}])", each.join("; "))
            }
            Proof::Split { poly, cases } => {
                let mut each = Vec::new();
                for c in cases {
                    let side = if c.opposite { poly.neg() } else { poly.clone() };
                    let then = self.proof(&state.with(Atom::new(side, c.sign)), &c.then)?;
                    each.push(format!("({}, {}, {then})", c.opposite, sign(c.sign)));
                }
                format!("(Split {} [{}])", self.poly(poly)?, each.join("; "))
            }
            Proof::Positive { terms, cofactors } => self.positive(terms, cofactors)?,
            Proof::Pass { germ, atom, along, then } => {
                self.pass(state, (germ, atom), (along, then))?
            }
        })
    }

    /// A sum that is zero though one summand is positive: weights, squares, powers of atoms; and
    /// equations with cofactors.
    fn positive(&self, terms: &[Term], cofactors: &[(usize, Poly)]) -> Result<String, NotEmitted> {
        let mut parts = Vec::new();
        for Term { weight, square, factors: known } in terms {
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

/// A sign as the file writes it.
pub(super) fn sign(s: Sign) -> &'static str {
    match s {
        Sign::Zero => "SZ",
        Sign::NonZero => "SNZ",
        Sign::NonNegative => "SNN",
        Sign::Positive => "SP",
    }
}

/// Indices with powers.
fn factors(fs: &[(usize, u32)]) -> String {
    if fs.is_empty() {
        return "[]".to_owned();
    }
    let fs: Vec<String> = fs.iter().map(|(i, n)| format!("({i}, {n})")).collect();
    format!("[{}]%nat", join(&fs, "; "))
}
