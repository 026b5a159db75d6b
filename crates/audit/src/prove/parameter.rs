//! Parameters: variables as quotients num/d of polynomials in one new variable, with d > 0.
//!
//! A point is looked for in the new variables, and read off for the old ones.

use kane_kernel::{Atom, Fuel, Monomial, Poly, Power, State, exponent};
use num_bigint::BigInt;

use super::elimination::Elimination;

/// A state in which variables are written by parameters.
pub(super) struct Parametrised<'s, 'g> {
    pub(super) state: State<'s, 'g>,
    /// what the variables that are gone are
    pub(super) eliminations: Vec<Elimination>,
    /// the parameters; no variable of a goal is one of them
    pub(super) parameters: Vec<usize>,
    fuel: Fuel,
}

/// Steps for the powers of one state.
const STEPS: u64 = 400_000;
/// A power beyond this is left alone.
const DEGREE: u32 = 16;

impl<'s, 'g> Parametrised<'s, 'g> {
    pub(super) fn new(state: &State<'s, 'g>) -> Self {
        Self {
            state: state.clone(),
            eliminations: Vec::new(),
            parameters: Vec::new(),
            fuel: state.scope.fuel.beside(STEPS),
        }
    }

    /// Whether anything was written, and nothing is false now.
    pub(super) fn is_of_use(&self) -> bool {
        let possible = self.state.atoms.iter().all(|a| a.decided() != Some(false));
        possible && !self.eliminations.is_empty()
    }

    /// A variable that nothing else uses.
    pub(super) fn fresh(&mut self) -> usize {
        let goal = self.state.goal;
        let of_goal = goal.context.vars.len() + self.state.scope.germ() + 1;
        let known = of_goal + kane_kernel::premised(goal).count();
        let used = self.state.atoms.iter().flat_map(|a| a.poly.vars()).max().map_or(0, |v| v + 1);
        let taken = self.parameters.last().map_or(0, |v| v + 1);
        let fresh = known.max(used).max(taken);
        self.parameters.push(fresh);
        fresh
    }

    /// Whether a variable is written by parameters already.
    pub(super) fn is_gone(&self, v: usize) -> bool {
        self.eliminations.iter().any(|e| e.var == v)
    }

    /// Writes each variable as its numerator over d, which is positive. `None` where powers get
    /// too large.
    pub(super) fn write(&mut self, nums: &[(usize, Poly)], d: &Poly) -> Option<()> {
        let atoms = self.state.atoms.iter().map(|a| written(a, nums, d, &self.fuel));
        self.state = State { atoms: atoms.collect::<Option<_>>()?, ..self.state.clone() };
        let of = |(var, num): &(usize, Poly)| Elimination { var: *var, d: d.clone(), e: num.neg() };
        self.eliminations.extend(nums.iter().map(of));
        Some(())
    }
}

/// dⁿ·p, with n the degree in all variables that go together: a positive multiple.
fn written(atom: &Atom, nums: &[(usize, Poly)], d: &Poly, fuel: &Fuel) -> Option<Atom> {
    let powers = |m: &[Power]| nums.iter().map(|x| exponent(m, x.0)).sum::<u32>();
    let degree = atom.poly.terms().map(|(m, _)| powers(m)).max().unwrap_or(0);
    if degree == 0 {
        return Some(atom.clone());
    }
    if degree > DEGREE {
        return None;
    }
    let mut sum = Poly::default();
    for (m, c) in atom.poly.terms() {
        let stays = |v: usize| nums.iter().all(|x| x.0 != v);
        let rest: Monomial = m.iter().copied().filter(|(v, _)| stays(*v)).collect();
        let mut term = Poly::term(rest, BigInt::clone(c));
        for (v, num) in nums {
            term = term.mul(&num.pow(exponent(m, *v), fuel).ok()?, fuel).ok()?;
        }
        sum = sum.add(&term.mul(&d.pow(degree - powers(m), fuel).ok()?, fuel).ok()?);
    }
    Some(Atom::new(sum, atom.sign))
}
