//! Equations that reduce powers of a variable: those of roots, and others.

use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Atom, Poly, Power, Sign, State, exponent};

use super::monomial::known;

/// A primitive polynomial as ±pᵏ for the polynomial p of an atom that says that it is positive: the atom, k, and whether
/// the sign is +.
fn lead(state: &State<'_, '_>, a: &Poly) -> Option<(usize, u32, bool)> {
    let one = |(atom, p): (usize, &Atom)| {
        if p.sign != Sign::Positive || p.poly.is_constant() {
            return None;
        }
        let (mut rest, mut power) = (a.clone(), 0);
        while let Some(q) = exact_quotient(&rest, &p.poly, &state.scope.fuel) {
            (rest, power) = (q, power + 1);
        }
        let is_up = rest == Poly::one();
        (is_up || rest == Poly::one().neg()).then_some((atom, power, is_up))
    };
    state.atoms.iter().enumerate().find_map(one)
}

/// An equation that reduces powers of a variable: a·vⁿ = …, n ≥ 2, where a is a number or an atom says that it has a
/// sign.
pub(super) struct Rule {
    pub(super) v: usize,
    pub(super) equation: usize,
    pub(super) degree: u32,
    /// the atom of which a is ± a power, and that power, if a is no number
    pub(super) lead: Option<(usize, u32)>,
    /// whether it says no more than the square of v, which is not negative
    pub(super) is_root: bool,
    /// whether a is positive
    pub(super) is_up: bool,
}

impl Rule {
    /// One an equation: for its last root, or for its last variable, as the search reduces by them. In s² + t² = 1
    /// neither is the root of what the other says.
    pub(super) fn all(state: &State<'_, '_>) -> Vec<Self> {
        let of = |(equation, atom): (usize, &Atom)| {
            let is_one = atom.sign == Sign::Zero && !atom.poly.is_constant();
            let vars = atom.poly.vars().into_iter().rev().filter(|_| is_one);
            let mut rules: Vec<Self> = vars.filter_map(|v| Self::of(state, v, equation)).collect();
            // the one whose square is what the others' squares, and the rest, make up
            let roots = |up: bool| rules.iter().filter(|r| r.is_root && r.is_up == up).count();
            let alone = [roots(false) == 1, roots(true) == 1];
            rules.iter_mut().for_each(|r| r.is_root &= alone[usize::from(r.is_up)]);
            let root = rules.iter().position(|rule| rule.is_root);
            rules.into_iter().nth(root.unwrap_or(0))
        };
        state.atoms.iter().enumerate().filter_map(of).collect()
    }

    fn of(state: &State<'_, '_>, v: usize, equation: usize) -> Option<Self> {
        let p = &state.atoms[equation].poly;
        let degree = p.degree(v);
        if degree < 2 {
            return None;
        }
        let (_, a) = p.coefficient(v, degree).primitive();
        let (lead, is_up) = if a.is_constant() {
            (None, a == Poly::one())
        } else {
            let (atom, power, is_up) = lead(state, &a)?;
            (Some((atom, power)), is_up)
        };
        // a cosine beside a sine is none
        let is_named = lead.is_some() || state.scope.root(v).is_some();
        let is_root = is_pure(p, v) && is_named && known(state, &[(v, 1)]).is_some();
        Some(Self { v, equation, degree, lead, is_root, is_up })
    }
}

/// Which roots a monomial has in odd powers.
pub(super) fn odd(m: &[Power], rules: &[Rule]) -> Vec<usize> {
    rules.iter().filter(|r| r.is_root).map(|r| r.v).filter(|&v| exponent(m, v) % 2 == 1).collect()
}

/// Whether a polynomial is a·v² + b.
pub(super) fn is_pure(p: &Poly, v: usize) -> bool {
    p.degree(v) == 2 && p.coefficient(v, 1).is_empty()
}
