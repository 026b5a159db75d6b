//! Circles: u² + v² = 1 as u = (1 − t²)/(1 + t²), v = 2·t/(1 + t²).
//!
//! One variable takes the place of two and of an equation, and every rational t gives a rational
//! point. If t is algebraic, u and v lie in its field, so that one algebraic number is enough. The
//! point (−1, 0) is missed; what is not found here is looked for in u and v themselves.

use kane_kernel::{Atom, Fuel, Monomial, Poly, Sign, State};
use num_bigint::BigInt;

use super::elimination::Elimination;

/// Circles in a state: it is said in their variables t.
pub(super) struct Circles<'s, 'g> {
    /// the state without u and v
    pub(super) state: State<'s, 'g>,
    /// u and v by t, for each circle
    pub(super) eliminations: Vec<Elimination>,
    /// the variables t; no variable of a goal is one of them
    pub(super) parameters: Vec<usize>,
}

/// Steps for the powers of one state.
const STEPS: u64 = 200_000;
/// A power beyond this is left alone.
const DEGREE: u32 = 12;

/// The circles of a state, each of two variables that are on no circle before it.
pub(super) fn circles<'s, 'g>(state: &State<'s, 'g>) -> Option<Circles<'s, 'g>> {
    let symbols = state.goal.context.vars.len();
    let known = symbols + state.scope.germ() + 1 + kane_kernel::premised(state.goal).count();
    let used = state.atoms.iter().flat_map(|a| a.poly.vars()).max().map_or(0, |v| v + 1);
    let mut fresh = known.max(used);

    let fuel = Fuel::new(STEPS);
    let mut found =
        Circles { state: state.clone(), eliminations: Vec::new(), parameters: Vec::new() };
    for atom in &state.atoms {
        let Some((u, v)) = circle(atom) else { continue };
        if found.eliminations.iter().any(|e| e.var == u || e.var == v) {
            continue;
        }
        let by = Parameter { u, v, t: fresh };
        let atoms = found.state.atoms.iter().map(|a| by.atom(a, &fuel));
        found.state = State { atoms: atoms.collect::<Option<_>>()?, ..found.state };
        found.eliminations.extend(by.eliminations());
        found.parameters.push(fresh);
        fresh += 1;
    }
    let possible = found.state.atoms.iter().all(|a| a.decided() != Some(false));
    (possible && !found.parameters.is_empty()).then_some(found)
}

/// The two variables of u² + v² = 1.
fn circle(atom: &Atom) -> Option<(usize, usize)> {
    let [u, v] = atom.poly.vars()[..] else { return None };
    if atom.sign != Sign::Zero {
        return None;
    }
    let unit = Poly::power(u, 2).add(&Poly::power(v, 2)).sub(&Poly::one());
    let poly = atom.poly.primitive().1;
    (poly == unit || poly == unit.neg()).then_some((u, v))
}

/// u and v by t.
struct Parameter {
    u: usize,
    v: usize,
    t: usize,
}

impl Parameter {
    /// 1 + t², 1 − t² and 2·t.
    fn parts(&self) -> [Poly; 3] {
        let square = Poly::power(self.t, 2);
        let one = Poly::one();
        [one.add(&square), one.sub(&square), Poly::var(self.t).scale(&BigInt::from(2))]
    }

    /// u and v as quotients.
    fn eliminations(&self) -> [Elimination; 2] {
        let [d, u, v] = self.parts();
        let of = |var, num: Poly| Elimination { var, d: d.clone(), e: num.neg() };
        [of(self.u, u), of(self.v, v)]
    }

    /// (1 + t²)ⁿ·p with n the degree in u and v together: a positive multiple.
    fn atom(&self, atom: &Atom, fuel: &Fuel) -> Option<Atom> {
        let powers = |m: &Monomial| {
            let power = |w| kane_kernel::exponent(m, w);
            (power(self.u), power(self.v))
        };
        let terms: Vec<(Monomial, &BigInt)> =
            atom.poly.terms().map(|(m, c)| (m.to_vec(), c)).collect();
        let degree = terms.iter().map(|(m, _)| powers(m).0 + powers(m).1).max().unwrap_or(0);
        if degree == 0 {
            return Some(atom.clone());
        }
        if degree > DEGREE {
            return None;
        }
        let [d, u, v] = self.parts();
        let mut sum = Poly::default();
        for (m, c) in terms {
            let (i, j) = powers(&m);
            let rest = m.into_iter().filter(|(w, _)| *w != self.u && *w != self.v).collect();
            let mut term = Poly::term(rest, c.clone());
            for (base, n) in [(&u, i), (&v, j), (&d, degree - i - j)] {
                term = term.mul(&base.pow(n, fuel).ok()?, fuel).ok()?;
            }
            sum.add_all(&term);
        }
        Some(Atom::new(sum, atom.sign))
    }
}
