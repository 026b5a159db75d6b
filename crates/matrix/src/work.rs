//! Energy by the works of the two parts of the impulse, each a product with the normal impulse.
//!
//! ```text
//! E_n = p_n·(v_n + v_n⁺)/2 = −(1 − e)·a·p_n/2        E_t = p_t·(v + v_1)/2
//! ```
//!
//! Where p_n > 0 the signs are those of E_n/p_n and E_t/p_n, in which the impulse does not stand any more:
//! what is left of it is the direction of friction, p_t/p_n.

use kane_impact::Outcome;
use kane_kernel::{Rel, Relation};
use kane_number::Number as _;

use crate::applied::{Premise, ROOT};
use crate::setting::Symbolic;
use crate::study::{Family, Part};
use crate::visible::Condition;

/// Proves in one regime that neither part of the impulse does work: that p_n is positive, and what
/// each work is for an impulse of 1.
pub(crate) fn energy(family: &Family, index: usize) -> Result<Vec<Part>, String> {
    let regime = &family.regimes[index];
    let outcome = match &family.solved[index] {
        Some((outcome, _)) => outcome,
        None => &regime.outcome,
    };
    let mut shown = Shown {
        family,
        index,
        parts: family.solved[index].iter().map(|(_, part)| part.clone()).collect(),
        premises: regime.premises.clone(),
    };
    let slip = slip(&mut shown, outcome);
    let normal = &outcome.impulse.normal;
    if shown.that("p_n > 0", normal, Rel::Gt).is_err() {
        let both = slip.clone() + family.contact.slip();
        shown.that("v + v_1 >= 0", &both, Rel::Ge)?;
        shown.that("p_n > 0", normal, Rel::Gt)?;
    }
    let of_one = |work: &Symbolic| work.checked_div(normal).ok_or("the impulse is 0");
    let by_slip = |slip: &Symbolic| {
        let both = slip.clone() + family.contact.slip();
        both * &outcome.impulse.tangential / Symbolic::one().double()
    };
    // a law may say the work in a form of its own, which then is what is asked about
    let tangential = match outcome.work.tangential == by_slip(&outcome.slip) {
        true => by_slip(&slip),
        false => outcome.work.tangential.clone(),
    };
    for (claim, work) in
        [("E_n/p_n <= 0", of_one(&outcome.work.normal)?), ("E_t/p_n <= 0", of_one(&tangential)?)]
    {
        shown.by_signs(claim, &work)?;
    }
    Ok(shown.parts)
}

/// The slip afterwards: x·v where the regime's root x is their ratio, and is shown to be.
fn slip(shown: &mut Shown<'_>, outcome: &Outcome<Symbolic>) -> Symbolic {
    let Some(root) = &shown.family.regimes[shown.index].root else { return outcome.slip.clone() };
    let by_root = Symbolic::symbol(root.symbol) * shown.family.contact.slip();
    let difference = outcome.slip.clone() - &by_root;
    if difference == Symbolic::zero() || shown.that("v_1 = x*v", &difference, Rel::Eq).is_ok() {
        return by_root;
    }
    outcome.slip.clone()
}

/// What was shown of a regime, each from what stands before it.
struct Shown<'f> {
    family: &'f Family,
    index: usize,
    parts: Vec<Part>,
    premises: Vec<Premise>,
}

impl Shown<'_> {
    /// Shows a relation of a quantity to 0, which then is a premise.
    fn that(&mut self, claim: &str, quantity: &Symbolic, rel: Rel) -> Result<(), String> {
        let relation = match self.family.ranges.condition(quantity, rel) {
            Condition::Always => return Ok(()),
            Condition::Never => return Err(format!("{claim} holds nowhere")),
            Condition::Where(relation) => relation,
        };
        let part = self.ask(claim, &relation, &self.premises)?;
        self.parts.push(part);
        let label = format!("shown before: {claim}");
        self.premises.push(Premise::new(label, Vec::new(), relation));
        Ok(())
    }

    /// Shows that a quantity is not positive, from as little as it takes: the ranges, the root's bounds,
    /// all signs, all equations.
    fn by_signs(&mut self, claim: &str, quantity: &Symbolic) -> Result<(), String> {
        let relation = match self.family.ranges.condition(quantity, Rel::Le) {
            Condition::Always => return Ok(()),
            Condition::Never => return Err(format!("{claim} holds nowhere")),
            Condition::Where(relation) => relation,
        };
        let signs = || self.premises.iter().filter(|p| !p.is_equation()).cloned();
        let on: [Vec<Premise>; 4] = [
            Vec::new(),
            signs().filter(|p| p.label == ROOT).collect(),
            signs().collect(),
            self.premises.clone(),
        ];
        let mut found = Err(String::new());
        for premises in on {
            found = self.ask(claim, &relation, &premises);
            if found.is_ok() {
                break;
            }
        }
        self.parts.push(found?);
        Ok(())
    }

    fn ask(&self, claim: &str, relation: &Relation, on: &[Premise]) -> Result<Part, String> {
        let regime = &self.family.regimes[self.index];
        let question = self.family.question(regime, Vec::new(), relation.clone(), claim.to_owned());
        question.on(on)
    }
}
