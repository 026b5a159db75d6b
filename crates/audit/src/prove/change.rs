//! A change of symbols in which limits are looked for: constants that an equation determines are gone, or have no high
//! powers, and what is known to be positive is a symbol of its own: v' in the place of −v or of v − w. Polynomials are
//! carried over, and arguments are carried back.

use kane_kernel::{Atom, Poly, Sign, State, Term};
use num_traits::One as _;

use crate::argument::{Argument, Rules as _, composed};

/// Symbols that are changed at most.
const MOST: usize = 4;

/// A constant, and the equation that determines it or a power of it.
#[derive(Clone, Debug)]
struct Solved {
    var: usize,
    equation: Atom,
    /// the equation as it is where earlier ones were used
    rule: Poly,
}

/// A constant v in whose place another one stands.
#[derive(Clone, Debug)]
struct Renewed {
    var: usize,
    /// v, in the new one
    inward: Poly,
    /// the new one, in v: what is not negative
    outward: Poly,
}

/// The change of symbols.
#[derive(Clone, Debug, Default)]
pub(super) struct Change {
    solved: Vec<Solved>,
    renewed: Vec<Renewed>,
}

impl Change {
    /// The change that what is known of constants suggests.
    pub(super) fn new(state: &State<'_, '_>, known: &[Atom], x: usize) -> Option<Self> {
        let constant = |p: &Poly| p.vars().into_iter().all(|v| state.is_constant(v, x));
        let known: Vec<&Atom> = known.iter().filter(|a| constant(&a.poly)).collect();
        let mut out = Self::default();
        for equation in known.iter().filter(|a| a.sign == Sign::Zero) {
            let p = out.inward(state, &equation.poly)?.primitive().1;
            let vars = p.vars();
            let by_degree = |fits: &dyn Fn(u32) -> bool| {
                vars.iter().rev().copied().find(|v| leads(&p, *v) && fits(p.degree(*v)))
            };
            if let Some(var) = by_degree(&|n| n == 1).or_else(|| by_degree(&|n| n > 1)) {
                out.solved.push(Solved { var, equation: (*equation).clone(), rule: p });
            }
        }
        let mut orders: Vec<&Atom> = known.into_iter().filter(|a| a.sign.is_order()).collect();
        orders.sort_by_key(|a| (a.poly.vars().len(), a.poly.len()));
        for atom in &orders {
            let inward = |a: &&Atom| Some(out.inward(state, &a.poly)?.primitive().1);
            let all = orders.iter().map(inward).collect::<Option<Vec<_>>>()?;
            let is_signed = |v: usize| all.contains(&Poly::var(v));
            let p = inward(atom)?;
            let mut open = p.vars().into_iter().rev().filter(|v| !is_signed(*v));
            if let Some(var) = open.find(|v| leads(&p, *v) && p.degree(*v) == 1)
                && out.renewed.len() < MOST
            {
                // ±v + rest is the new one
                let (lead, rest) = (p.coefficient(var, 1), p.coefficient(var, 0));
                let inward = Poly::var(var).sub(&rest);
                let inward = if lead == Poly::one() { inward } else { inward.neg() };
                out.renewed.push(Renewed { var, inward, outward: p });
            }
        }
        Some(out)
    }

    /// A polynomial in the symbols of the statement, in these.
    pub(super) fn inward(&self, state: &State<'_, '_>, p: &Poly) -> Option<Poly> {
        let fuel = &state.scope.fuel;
        let mut solved = self.solved.iter();
        let p = solved.try_fold(p.clone(), |p, Solved { var, rule, .. }| {
            // its coefficient is 1 or −1, which an even power takes the sign of
            p.remainder(*var, rule, true, fuel).ok()
        })?;
        self.renew(state, p)
    }

    /// A polynomial with the new symbols in the place of those that are renewed.
    fn renew(&self, state: &State<'_, '_>, p: Poly) -> Option<Poly> {
        self.renewed.iter().try_fold(p, |p, r| put(state, &p, r.var, &r.inward))
    }

    /// A polynomial in these symbols without what the equations say is 0.
    pub(super) fn reduced(&self, state: &State<'_, '_>, p: Poly) -> Option<Poly> {
        if self.solved.iter().all(|s| s.rule.degree(s.var) < 2) {
            return Some(p);
        }
        self.inward(state, &self.outward(state, &p)?)
    }

    /// A polynomial in these symbols, in those of the statement.
    pub(super) fn outward(&self, state: &State<'_, '_>, p: &Poly) -> Option<Poly> {
        let mut latest_first = self.renewed.iter().rev();
        latest_first.try_fold(p.clone(), |p, r| put(state, &p, r.var, &r.outward))
    }

    /// A case along a germ in these symbols, and the equations by which it came there.
    pub(super) fn case<'s, 'g>(
        &self,
        case: &State<'s, 'g>,
    ) -> Option<(State<'s, 'g>, Vec<(usize, usize)>)> {
        let (mut case, mut by) = (case.clone(), Vec::new());
        for Solved { var, equation, rule } in &self.solved {
            // an earlier one may have changed it
            let same =
                |a: &Atom| a == equation || a.sign == Sign::Zero && a.poly.primitive().1 == *rule;
            let at = case.atoms.iter().position(same)?;
            case = case.substitute(at, *var, &[]).ok()?;
            by.push((at, *var));
        }
        for at in 0..case.atoms.len() {
            case.atoms[at].poly = self.renew(&case, case.atoms[at].poly.clone())?;
        }
        Some((case, by))
    }

    /// The argument for the case as it is, from one in these symbols.
    pub(super) fn argument(
        &self,
        state: &State<'_, '_>,
        argument: Argument,
        by: &[(usize, usize)],
    ) -> Option<Argument> {
        let then = self.told(state, argument)?;
        Some(by.iter().rev().fold(then, |then, &(equation, var)| Argument::Substitute {
            equation,
            var,
            lead: Vec::new(),
            then: then.into(),
        }))
    }

    /// The same argument with its polynomials in the symbols of the statement.
    fn told(&self, state: &State<'_, '_>, argument: Argument) -> Option<Argument> {
        Some(match argument {
            Argument::Split { poly, zero, positive, negative } => {
                let told = |then: Box<Argument>| self.told(state, *then).map(Box::new);
                let (zero, positive, negative) = (told(zero)?, told(positive)?, told(negative)?);
                Argument::Split { poly: self.outward(state, &poly)?, zero, positive, negative }
            }
            Argument::Positive { terms, cofactors } => {
                let term = |t: Term| Some(Term { square: self.outward(state, &t.square)?, ..t });
                let cofactor = |(i, p): (usize, Poly)| Some((i, self.outward(state, &p)?));
                Argument::Positive {
                    terms: terms.into_iter().map(term).collect::<Option<_>>()?,
                    cofactors: cofactors.into_iter().map(cofactor).collect::<Option<_>>()?,
                }
            }
            other => other,
        })
    }
}

/// Whether the highest power of a variable stands there by itself.
fn leads(p: &Poly, v: usize) -> bool {
    let lead = p.coefficient(v, p.degree(v)).as_constant();
    p.degree(v) > 0 && lead.is_some_and(|c| c.magnitude().is_one())
}

/// A polynomial with another one in the place of a variable.
fn put(state: &State<'_, '_>, p: &Poly, v: usize, value: &Poly) -> Option<Poly> {
    composed(p, v, value, &Poly::one(), &state.scope.fuel).ok()
}
