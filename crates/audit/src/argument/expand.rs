//! Arguments written out in the kernel's rules.
//!
//! The steps are walked from the outside in, with only those atoms kept up to date that something
//! further in refers to. On the way back each derived atom that was used is cut in, and cases that
//! turn out not to be used are left out.

use std::cell::Cell;
use std::collections::BTreeSet;

use kane_kernel::{
    Atom, Case, Cases, Evidence, Fuel, Limit, Poly, Proof, Rejection, SideProof, Sign, State,
    differs, misses,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::identity::{Derived, Reducer, divided};
use super::node::{Fact, Known, Node, Side, Sum, whole};
use super::rules::{Flaw, Step};
use super::{Argument, Course, LimitArgument, Passage, SideArgument, line, orthant};

/// Coefficient operations that one expansion may take.
const FUEL: u64 = 2_000_000_000;

/// Zero, positive, negative: whether it is said of the opposite, and the sign.
const SIGNS: [(bool, Sign); 3] =
    [(false, Sign::Zero), (false, Sign::Positive), (true, Sign::Positive)];

/// A proof of the kernel for an argument that closes this state.
pub(crate) fn expand(state: &State<'_, '_>, argument: &Argument) -> Step<Proof> {
    let fuel = Fuel::new(FUEL);
    let given = state.atoms.len();
    let work = Work { formulas: &state.formulas, fuel, next: Cell::new(given) };
    let known = state.atoms.iter().enumerate();
    let known = known.map(|(i, a)| Known::new(a.poly.clone(), a.sign, i)).collect();
    Ok(work.walk(known, &Outline::of(argument))?.numbered(given))
}

/// A proof of the kernel for a contradiction.
pub(crate) fn contradiction(state: &State<'_, '_>, course: &Course) -> Step<Proof> {
    match course {
        Course::After(passages, argument) => after(state, passages, argument),
        Course::Split { poly, zero, positive, negative } => {
            let cases = by_sign(state, poly, [&**zero, positive, negative], &contradiction)?;
            Ok(Proof::Split { poly: poly.clone(), cases })
        }
    }
}

/// The evidence for an argument for a limit.
pub(crate) fn limit_proof(
    state: &State<'_, '_>,
    limit: &Limit,
    argument: &LimitArgument,
) -> Step<Evidence> {
    match argument {
        LimitArgument::Sides(sides) => {
            let proofs = sides.iter().map(|side| side_proof(state, limit, side));
            Ok(Evidence::Limit(proofs.collect::<Step<_>>()?))
        }
        LimitArgument::Absurd(argument) => Ok(Evidence::Contradiction(expand(state, argument)?)),
        LimitArgument::Split { poly, zero, positive, negative } => {
            let then = |state: &State<'_, '_>, case: &_| limit_proof(state, limit, case);
            let cases = by_sign(state, poly, [&**zero, positive, negative], &then)?;
            Ok(Evidence::Split { poly: poly.clone(), cases })
        }
    }
}

/// What there is for each of the three signs of a polynomial: zero, positive, negative.
fn by_sign<A, P>(
    state: &State<'_, '_>,
    poly: &Poly,
    arguments: [&A; 3],
    then: &dyn Fn(&State<'_, '_>, &A) -> Step<P>,
) -> Step<Vec<Case<P>>> {
    let case = |((opposite, sign), argument): ((bool, Sign), &A)| {
        let side = if opposite { poly.neg() } else { poly.clone() };
        let then = then(&state.with(Atom::new(side, sign)), argument)?;
        Ok(Case { opposite, sign, then })
    };
    SIGNS.into_iter().zip(arguments).map(case).collect()
}

/// A proof of the kernel for an argument after passages to limits.
fn after(state: &State<'_, '_>, passages: &[Passage], argument: &Argument) -> Step<Proof> {
    let Some((Passage { germ, atom, along }, rest)) = passages.split_first() else {
        return expand(state, argument);
    };
    let there = state.along_unproved(germ)?.with(atom.not());
    let then = state.with(state.at_zero(germ, atom)?);
    Ok(Proof::Pass {
        germ: germ.clone(),
        atom: atom.clone(),
        along: Box::new(expand(&there, along)?),
        then: Box::new(after(&then, rest, argument)?),
    })
}

/// A proof of the kernel for an argument for a limit from one side.
pub(crate) fn side_proof(
    state: &State<'_, '_>,
    limit: &Limit,
    argument: &SideArgument,
) -> Step<SideProof> {
    let SideArgument { germ, num, den, order, sense, along, at_zero, upper } = argument;
    let wrong = differs(state.scope, &limit.compared(state.scope), (num, den), *sense)?;
    let there = state.along_unproved(germ)?.with_cases(wrong);
    let ends = misses(state, &germ.side, (num, den, *order), &limit.to)?;
    Ok(SideProof {
        germ: germ.clone(),
        num: num.clone(),
        den: den.clone(),
        order: *order,
        sense: *sense,
        along: Box::new(expand(&there, along)?),
        at_zero: Box::new(expand(&state.with_cases(ends), at_zero)?),
        upper: upper.as_ref().map(|p| side_proof(state, limit, p).map(Box::new)).transpose()?,
    })
}

/// The proof that an atom contradicts bounds of its variables, if that is seen from the signs of
/// coefficients: for each variable the indices of its lower and its upper bound.
#[must_use]
pub fn contradicts_bounds(
    state: &State<'_, '_>,
    atom: usize,
    bounds: &[(usize, Option<usize>, Option<usize>)],
) -> Option<Proof> {
    expand(state, &Argument::Orthant { atom, bounds: bounds.to_vec() }).ok()
}

/// An argument with what each part of it refers to.
struct Outline<'a> {
    argument: &'a Argument,
    /// indices of atoms
    needs: BTreeSet<usize>,
    parts: Vec<Outline<'a>>,
}

impl<'a> Outline<'a> {
    fn of(argument: &'a Argument) -> Self {
        let parts: Vec<Self> = match argument {
            Argument::Assume { cases, .. } => cases.iter().map(Self::of).collect(),
            Argument::Split { zero, positive, negative, .. } => {
                [zero, positive, negative].into_iter().map(|part| Self::of(part)).collect()
            }
            Argument::Substitute { then, .. } | Argument::Cancel { then, .. } => {
                vec![Self::of(then)]
            }
            _ => Vec::new(),
        };
        let mut needs: BTreeSet<usize> = parts.iter().flat_map(|p| &p.needs).copied().collect();
        match argument {
            Argument::Absurd(i) => _ = needs.insert(*i),
            Argument::Substitute { equation, lead, .. } => {
                needs.insert(*equation);
                needs.extend(lead.iter().map(|f| f.0));
            }
            Argument::Cancel { atom, factors, .. } => {
                needs.insert(*atom);
                needs.extend(factors.iter().map(|f| f.0));
            }
            Argument::Positive { terms, cofactors } => {
                needs.extend(terms.iter().flat_map(|t| &t.factors).map(|f| f.0));
                needs.extend(cofactors.iter().map(|c| c.0));
            }
            Argument::Orthant { atom, bounds } => {
                needs.insert(*atom);
                needs.extend(bounds.iter().flat_map(|b| [b.1, b.2]).flatten());
            }
            Argument::SignTable { atoms, .. } => needs.extend(atoms.iter().map(|a| a.0)),
            Argument::Assume { .. } | Argument::Split { .. } => {}
        }
        Self { argument, needs, parts }
    }
}

/// An expansion at work.
pub(super) struct Work<'a> {
    formulas: &'a [Cases],
    pub(super) fuel: Fuel,
    next: Cell<Fact>,
}

/// What is known with this index.
pub(super) fn at(known: &[Known], i: usize) -> Step<&Known> {
    known.get(i).ok_or(Flaw::Kernel(Rejection::NoSuchAtom(i)))
}

fn all<'k>(known: &'k [Known], factors: &[(usize, u32)]) -> Step<Vec<(&'k Known, u32)>> {
    factors.iter().map(|&(i, n)| Ok((at(known, i)?, n))).collect()
}

impl Work<'_> {
    /// A name for a new atom.
    pub(super) fn fresh(&self) -> Fact {
        self.next.replace(self.next.get() + 1)
    }

    /// A case in which the polynomial or its opposite has a sign.
    pub(super) fn side(
        &self,
        poly: &Poly,
        (opposite, sign): (bool, Sign),
        then: impl FnOnce(Known) -> Step<Node>,
    ) -> Step<Side> {
        let side = if opposite { poly.neg() } else { poly.clone() };
        let fact = self.fresh();
        Ok(Side { opposite, sign, fact, then: then(Known::new(side, sign, fact))? })
    }

    /// A derived atom in what follows, or the contradiction that it is.
    pub(super) fn with(&self, derived: &Derived, then: impl FnOnce() -> Step<Node>) -> Step<Node> {
        match derived.absurd(&self.fuel)? {
            Some(absurd) => Ok(absurd),
            None => derived.cut(then()?, &mut || self.fresh(), &self.fuel),
        }
    }

    fn walk(&self, mut known: Vec<Known>, outline: &Outline<'_>) -> Step<Node> {
        match outline.argument {
            Argument::Absurd(i) => absurd(at(&known, *i)?, *i),
            Argument::Assume { formula, .. } => {
                let cases =
                    self.formulas.get(*formula).ok_or(Rejection::NoSuchFormula(*formula))?;
                if cases.len() != outline.parts.len() {
                    return Err(Rejection::CaseCount(cases.len(), outline.parts.len()).into());
                }
                let case = |(atoms, part): (&Vec<Atom>, &Outline<'_>)| {
                    let mut known = known.clone();
                    let mut facts = Vec::new();
                    for a in atoms {
                        facts.push(self.fresh());
                        known.push(Known::new(a.poly.clone(), a.sign, self.next.get() - 1));
                    }
                    Ok((facts, self.walk(known, part)?))
                };
                let cases = cases.iter().zip(&outline.parts).map(case).collect::<Step<_>>()?;
                Ok(Node::assume(*formula, cases))
            }
            Argument::Split { poly, .. } => {
                let case = |(sign, part): ((bool, Sign), &Outline<'_>)| {
                    self.side(poly, sign, |new| self.walk([&known[..], &[new]].concat(), part))
                };
                let cases = SIGNS.into_iter().zip(&outline.parts).map(case);
                Ok(Node::split(poly.clone(), cases.collect::<Step<_>>()?))
            }
            Argument::Substitute { equation, var, lead, .. } => {
                self.substitute(known, (*equation, *var, lead), &outline.parts[0])
            }
            Argument::Cancel { atom, factors, quotient, .. } => {
                if factors.iter().any(|f| f.0 == *atom) {
                    return Err(Rejection::MayVanish.into());
                }
                let (old, factors) = (at(&known, *atom)?, all(&known, factors)?);
                let derived = divided(old, &factors, quotient, self.fresh(), &self.fuel)?;
                known[*atom] = derived.new.clone();
                self.with(&derived, || self.walk(known, &outline.parts[0]))
            }
            Argument::Positive { terms, cofactors } => {
                let mut sum = Sum::default();
                for t in terms {
                    sum.term(whole(t.weight.clone()), t.square.clone(), &all(&known, &t.factors)?);
                }
                for (i, c) in cofactors {
                    sum.multiple(BigRational::one(), c.clone(), at(&known, *i)?);
                }
                Ok(sum.close())
            }
            Argument::Orthant { atom, bounds } => {
                orthant::contradiction(self, &known, at(&known, *atom)?, bounds)
            }
            Argument::SignTable { var, bases, roots, atoms } => {
                line::Line { work: self, var: *var, bases, roots, used: atoms }.close(&known)
            }
        }
    }

    fn substitute(
        &self,
        mut known: Vec<Known>,
        (equation, var, lead): (usize, usize, &[(usize, u32)]),
        rest: &Outline<'_>,
    ) -> Step<Node> {
        let before = known.clone();
        let (by, lead) = (at(&before, equation)?, all(&before, lead)?);
        let reducer = Reducer::new(by, var, &lead, &self.fuel)?;
        let mut new = Vec::new();
        for &i in rest.needs.range(..known.len()).filter(|i| **i != equation) {
            match reducer.derived(&before[i], self.fresh(), &self.fuel)? {
                Some(derived) => {
                    known[i] = derived.new.clone();
                    new.push(derived);
                }
                None => {
                    // The rules leave integers without a common factor.
                    let (content, poly) = before[i].atom.poly.primitive();
                    known[i].atom.poly = poly;
                    if let Some((_, scale)) = &mut known[i].fact {
                        *scale *= content;
                    }
                }
            }
        }
        if by.atom.poly.degree(var) == 1 {
            known[equation] = Known { atom: Atom::new(Poly::default(), Sign::Zero), fact: None };
        }
        for derived in &new {
            if let Some(absurd) = derived.absurd(&self.fuel)? {
                return Ok(absurd);
            }
        }
        let mut node = self.walk(known, rest)?;
        for derived in &new {
            node = derived.cut(node, &mut || self.fresh(), &self.fuel)?;
        }
        Ok(node)
    }
}

/// The contradiction in a constant that has the wrong sign.
pub(super) fn absurd(known: &Known, i: usize) -> Step<Node> {
    let c = known.atom.poly.as_constant().filter(|_| known.atom.decided() == Some(false));
    let c: BigInt = c.ok_or(Flaw::NotAbsurd(i))?;
    let mut sum = Sum::default();
    match known.atom.sign {
        Sign::Zero => {
            sum.product(whole(c.abs()), &[]);
            sum.multiple(-whole(c.signum()), Poly::one(), known);
        }
        Sign::NonZero => {
            sum.product(BigRational::one(), &[(known, 2)]);
        }
        Sign::NonNegative | Sign::Positive => {
            sum.product(BigRational::one(), &[(known, 1)]);
            if !c.is_zero() {
                sum.product(whole(-c), &[]);
            }
        }
    }
    Ok(sum.close())
}
