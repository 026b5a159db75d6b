//! A state made simpler by an equation of it or by a factor that it can do without, with no case distinction.

use kane_kernel::{Atom, Poly, Sign, State};

use super::elimination::{Elimination, Factors};
use super::factors::{cancellation, cannot_vanish, leading};
use super::radicand;
use super::search::Search;
use crate::argument::{Argument, Rules};

/// How little an elimination is liked: place among what is defined, kept variables, leads that vary, constants (the
/// other way round where something is defined), size.
type Score = (usize, u32, usize, usize, usize);

/// A step that has one successor.
#[derive(Clone, Debug)]
pub(crate) enum Step {
    Cancel { atom: usize, factors: Vec<(usize, u32)>, quotient: Poly },
    Substitute { equation: usize, var: usize, lead: Vec<(usize, u32)> },
}

impl Step {
    pub(crate) fn wrap(self, then: Argument) -> Argument {
        let then = Box::new(then);
        match self {
            Self::Cancel { atom, factors, quotient } => {
                Argument::Cancel { atom, factors, quotient, then }
            }
            Self::Substitute { equation, var, lead } => {
                Argument::Substitute { equation, var, lead, then }
            }
        }
    }
}

impl Search<'_> {
    /// A cancellation or a substitution that needs no case distinction.
    pub(crate) fn simplify<'s, 'g>(
        &self,
        state: &State<'s, 'g>,
    ) -> Option<(Step, State<'s, 'g>, Option<Elimination>)> {
        if let Some((atom, factors, quotient)) = cancellation(state) {
            let next = state.cancel(atom, &factors, &quotient).ok()?;
            return Some((Step::Cancel { atom, factors, quotient }, next, None));
        }
        let mut best: Option<(Score, usize, usize, Factors)> = None;
        for (i, v, d, size) in self.linear(state) {
            let kept = self.keep.iter().find(|k| k.0 == v).map_or(0, |k| k.1);
            let var = state.scope.context.vars.get(v);
            let is_function = var.is_some_and(|w| w.of.is_some());
            let class = usize::from(!d.is_constant());
            let place = self.defined.iter().position(|d| *d == v);
            // a root of a product may yet be a product of roots
            let last = self.defined.len() + usize::from(radicand::is_root_of_product(state, v));
            let (place, kept) = place.map_or((last, kept), |place| (place, 0));
            // where a proof is to be read, what varies goes first, and what has a range last
            let (first, second) = match self.defined.is_empty() {
                true => (class, usize::from(!is_function)),
                false if is_function => (0, class),
                false => (1 + usize::from(var.is_some_and(|w| w.lower.is_some())), class),
            };
            let score = (place, kept, first, second, size);
            if best.as_ref().is_none_or(|b| score < b.0)
                && let Some(lead) = leading(state, &d)
            {
                best = Some((score, i, v, lead));
            }
        }
        let Some((_, equation, var, lead)) = best else {
            return self.reduction(state);
        };
        let next = state.substitute(equation, var, &lead).ok()?;
        let part = |n| state.atoms[equation].poly.coefficient(var, n);
        let (e, d) = (part(0), part(1));
        let elimination = Elimination { var, d, e };
        Some((Step::Substitute { equation, var, lead }, next, Some(elimination)))
    }

    /// An elimination that takes it that the leading coefficient does not vanish: to see where
    /// things tend, not to prove it.
    pub(super) fn assumed<'s, 'g>(
        &self,
        state: &State<'s, 'g>,
    ) -> Option<(Step, State<'s, 'g>, Option<Elimination>)> {
        let (equation, var, d, _) = self.linear(state).into_iter().min_by_key(|c| c.3)?;
        let e = state.atoms[equation].poly.coefficient(var, 0);
        let supposed = state.with(Atom::new(d.clone(), Sign::NonZero));
        let lead = vec![(supposed.atoms.len() - 1, 1)];
        let next = supposed.substitute(equation, var, &lead).ok()?;
        let step = Step::Substitute { equation, var, lead };
        Some((step, next, Some(Elimination { var, d, e })))
    }

    /// A reduction of the degree in a variable by an equation of degree two or more in it.
    fn reduction<'s, 'g>(
        &self,
        state: &State<'s, 'g>,
    ) -> Option<(Step, State<'s, 'g>, Option<Elimination>)> {
        for (equation, a) in state.atoms.iter().enumerate() {
            if a.sign != Sign::Zero || a.poly.is_constant() {
                continue;
            }
            // One variable an equation, roots before symbols: by turns of two it would never end.
            for var in a.poly.vars().into_iter().rev() {
                let degree = a.poly.degree(var);
                let reducible =
                    |(i, b): (usize, &Atom)| i != equation && b.poly.degree(var) >= degree;
                if degree < 2 {
                    continue;
                }
                let top = a.poly.coefficient(var, degree);
                let Some(lead) = leading(state, &top) else {
                    continue;
                };
                if !state.atoms.iter().enumerate().any(reducible) {
                    break;
                }
                let next = state.substitute(equation, var, &lead).ok()?;
                return Some((Step::Substitute { equation, var, lead }, next, None));
            }
        }
        None
    }

    /// Equations linear in a variable that may go: (equation, variable, coefficient, size).
    fn linear(&self, state: &State<'_, '_>) -> Vec<(usize, usize, Poly, usize)> {
        let mut out = Vec::new();
        for (i, a) in state.atoms.iter().enumerate() {
            if a.sign != Sign::Zero || a.poly.is_constant() {
                continue;
            }
            for v in a.poly.vars() {
                if a.poly.degree(v) == 1 && (self.may_eliminate)(v, &a.poly) {
                    let d = a.poly.coefficient(v, 1);
                    let size = a.poly.len() + 3 * d.len();
                    out.push((i, v, d, size));
                }
            }
        }
        out
    }

    /// The same for equations in a square, where other atoms have it too; only sure leads, and none of an equation that
    /// already reduces a power: it would reduce what says so of another.
    fn quadratic(&self, state: &State<'_, '_>) -> Vec<(usize, usize, Poly, usize)> {
        let mut out = Vec::new();
        for (i, a) in state.atoms.iter().enumerate() {
            if a.sign != Sign::Zero || a.poly.is_constant() {
                continue;
            }
            let reduces = |v: usize| {
                let degree = a.poly.degree(v);
                degree > 1 && leading(state, &a.poly.coefficient(v, degree)).is_some()
            };
            if a.poly.vars().into_iter().any(reduces) {
                continue;
            }
            for v in a.poly.vars() {
                let degree = a.poly.degree(v);
                let others = state
                    .atoms
                    .iter()
                    .enumerate()
                    .any(|(j, b)| j != i && b.poly.degree(v) >= degree);
                if degree < 2 || !others {
                    continue;
                }
                let d = a.poly.coefficient(v, degree);
                if !d.is_constant() && cannot_vanish(state, &d) {
                    let size = a.poly.len() + 3 * d.len();
                    out.push((i, v, d, size));
                }
            }
        }
        out
    }

    /// A leading coefficient worth a case distinction: first one that cannot vanish.
    pub(super) fn lead_to_split(&self, state: &State<'_, '_>) -> Option<Poly> {
        let known = |d: &Poly| {
            let d = d.primitive().1;
            let same = |p: &Poly| *p == d || *p == d.neg();
            state.atoms.iter().any(|a| a.sign != Sign::NonNegative && same(&a.poly.primitive().1))
        };
        let mut candidates = self.linear(state);
        candidates.extend(self.quadratic(state));
        candidates.retain(|(.., d, _)| !known(d));
        let sure = candidates.iter().filter(|(.., d, _)| cannot_vanish(state, d));
        let single = candidates.iter().filter(|(.., d, _)| d.len() == 1);
        let any = sure
            .min_by_key(|c| c.3)
            .or_else(|| single.min_by_key(|c| c.3))
            .or_else(|| candidates.iter().min_by_key(|c| c.3));
        any.map(|(.., d, _)| {
            // A product of powers splits at the first variable that may vanish.
            let mut vars = d.vars().into_iter().map(Poly::var);
            let open = if d.len() == 1 { vars.find(|v| !known(v)) } else { None };
            open.unwrap_or_else(|| d.primitive().1)
        })
    }
}
