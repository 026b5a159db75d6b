//! How long a proof is to read, as a number: what proofs of one claim are compared by.

use kane_kernel::{Atom, Poly};

use super::{Proof, Step};

/// What a step weighs beside what stands in it.
const STEP: usize = 4;
/// What a case weighs beside what follows in it.
const CASE: usize = 6;

impl Proof {
    /// The proof's weight: 4 a step, 6 a case, and of every polynomial in it, one for each term and one for each
    /// symbol in a term, where a symbol of every term counts once. Sums that have to be multiplied out weigh twice.
    #[must_use]
    pub fn weight(&self) -> usize {
        all(&self.steps)
    }
}

fn all(steps: &[Step]) -> usize {
    steps.iter().map(step).sum()
}

fn step(step: &Step) -> usize {
    STEP + match step {
        Step::Suppose { then, .. } => all(then),
        Step::Assume { atoms: said, .. } | Step::Clash(said) => atoms(said),
        Step::SignTable { atoms: said, cuts, .. } => atoms(said) + cuts.len(),
        Step::Cases { cases, .. } => {
            cases.iter().map(|(said, then)| CASE + atoms(said) + all(then)).sum()
        }
        Step::Split { poly, zero, positive, negative } => {
            let cases = [zero, positive, negative].into_iter();
            polynomial(poly) + cases.map(|then| CASE + all(then)).sum::<usize>()
        }
        Step::Solve { solved, divided, leaves } => {
            let quotients = solved.iter().map(|s| STEP + quotient(&s.value));
            quotients.sum::<usize>() + atoms(divided) + atoms(leaves)
        }
        Step::Reduce { by, leaves, .. } => polynomial(&by.poly) + atoms(leaves),
        Step::Factors { atom, factors } => {
            polynomial(&atom.poly) + factors.iter().map(|(a, _)| polynomial(&a.poly)).sum::<usize>()
        }
        Step::Multiple { atom: (_, p), multiples } => 2 * (polynomial(p) + pairs(multiples)),
        Step::Equal { value, .. } => quotient(value),
        Step::Positive { terms, multiples } => {
            let factor = |(p, _): &(Poly, u32)| polynomial(p);
            let term = |t: &super::Summand| {
                polynomial(&t.square) + t.factors.iter().map(factor).sum::<usize>()
            };
            2 * (terms.iter().map(term).sum::<usize>() + pairs(multiples))
        }
        Step::SignsOfCoefficients { atom, bounds, .. } => polynomial(&atom.poly) + atoms(bounds),
        Step::Absurd(atom) => polynomial(&atom.poly),
        Step::Pass { along, otherwise, end, .. } => {
            polynomial(&along.poly) + polynomial(&end.poly) + all(otherwise)
        }
        Step::LimitFrom { quotient: q, otherwise, .. } => quotient(q) + all(otherwise),
        Step::Kept(_) | Step::Point { .. } | Step::Beside { .. } | Step::Functions { .. } => 0,
    }
}

fn atoms(atoms: &[Atom]) -> usize {
    atoms.iter().map(|atom| polynomial(&atom.poly)).sum()
}

fn pairs(pairs: &[(Poly, Poly)]) -> usize {
    pairs.iter().map(quotient).sum()
}

fn quotient((num, den): &(Poly, Poly)) -> usize {
    polynomial(num) + polynomial(den)
}

fn polynomial(p: &Poly) -> usize {
    let size: usize = p.terms().map(|(symbols, _)| 1 + symbols.len()).sum();
    // what stands in every term is told once, before parentheses
    let lowest = |v: usize| p.terms().all(|(symbols, _)| symbols.iter().any(|s| s.0 == v));
    let common = p.vars().into_iter().filter(|v| lowest(*v)).count();
    size - common * p.len().saturating_sub(1)
}
