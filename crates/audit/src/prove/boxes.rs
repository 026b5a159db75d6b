//! Boxes: ranges of variables are cut until every box is closed by signs of coefficients, or a condition that
//! varies in one sense along a variable is put to the end of its range.
//!
//! At an end n/d of the range of v, where k·(d·v − n) ≥ 0 is known, a condition p is
//! dᴺ·p(v) = dᴺ·p(n/d) + (d·v − n)·g(v). Where −g ≥ 0, p is largest at that end: from p ≥ 0 it follows that
//! p(n/d) ≥ 0, with one variable less.

use kane_algebra::point::specialised;
use kane_algebra::quotient::exact_quotient;
use kane_kernel::{Atom, Poly, Sign, State, Term};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::elimination::open_vars;
use super::search::Search;
use super::simplification::Step;
use super::{line, tactics};
use crate::argument::{Argument, Rules as _};

type Q = BigRational;

/// Variables of a condition whose ends are looked at, and its terms.
const VARIABLES: usize = 4;
const TERMS: usize = 60;
/// Cuts for which the sign of a slope is worth it.
const SLOPES: u32 = 4;

/// What a condition is at an end of the range of one of its variables.
struct End {
    /// the condition
    atom: usize,
    /// the bound
    bound: usize,
    /// what the identity multiplies the condition by, and the bound with the slope
    scale: BigInt,
    crossed: BigInt,
    /// the condition at the end, and what it is multiplied by
    there: Poly,
    weight: BigInt,
    /// the condition is largest at the end where this is not negative
    slope: Poly,
}

impl Search<'_> {
    /// Cuts the ranges of the variables until every box is closed by signs of coefficients.
    pub(super) fn boxes(
        &self,
        state: &State<'_, '_>,
        vars: &[usize],
        depth: u32,
    ) -> Option<Argument> {
        if let Some(proof) = tactics::quick(state) {
            return Some(proof);
        }
        if let Some([v]) = state.atoms.last().map(|a| a.poly.vars()).as_deref()
            && let Some(proof) = line::sign_table(state, *v)
        {
            return Some(proof);
        }
        if depth == 0 || vars.len() > 4 || !self.step(state) || self.left() < 50 {
            return None;
        }
        if let Some(found) = self.by_ends(state, vars, depth) {
            return found;
        }
        // Cut the variable whose range is widest after mapping to (0, 1); unbounded ones first.
        let at = |v: usize| {
            let (lower, upper) = line::bounds(state, v);
            let value = |i: Option<usize>| i.map(|i| line::bound_value(state, i, v));
            (value(lower), value(upper))
        };
        let width = |v: usize| match at(v) {
            (Some(a), Some(b)) => b - a,
            (None, None) => Q::from_integer(1000.into()),
            _ => Q::from_integer(100.into()),
        };
        let v = vars.iter().copied().max_by(|a, b| width(*a).cmp(&width(*b)).then(b.cmp(a)))?;
        let cut = match at(v) {
            (Some(a), Some(b)) if a < b => (a + b) / Q::from_integer(2.into()),
            (Some(a), None) => {
                if a.is_positive() {
                    a * Q::from_integer(2.into())
                } else {
                    a + Q::one()
                }
            }
            (None, Some(b)) => b - Q::one(),
            (None, None) => Q::zero(),
            _ => return None,
        };
        let poly = Poly::var(v).scale(cut.denom()).sub(&Poly::constant(cut.numer().clone()));
        let branch = |p: &Poly| {
            let next = state.with(Atom::new(p.clone(), Sign::Positive));
            self.boxes(&next, vars, depth - 1)
        };
        let positive = Box::new(branch(&poly)?);
        let negative = Box::new(branch(&poly.neg())?);
        let on = state.with(Atom::new(poly.clone(), Sign::Zero));
        let equation = on.atoms.len() - 1;
        let next = on.substitute(equation, v, &[]).ok()?;
        let rest: Vec<usize> = open_vars(&next);
        let inner = if rest.len() <= 1 {
            tactics::quick(&next)
                .or_else(|| rest.iter().find_map(|&w| line::sign_table(&next, w)))?
        } else {
            self.boxes(&next, &rest, depth - 1)?
        };
        let step = Step::Substitute { equation, var: v, lead: Vec::new() };
        let zero = Box::new(step.wrap(inner));
        Some(Argument::Split { poly, zero, positive, negative })
    }

    /// A condition put to the ends of the range of a variable, where it is known which of them is worth most:
    /// nothing is lost then, so what comes of it is final. `None` where no variable is of that kind.
    fn by_ends(
        &self,
        state: &State<'_, '_>,
        vars: &[usize],
        depth: u32,
    ) -> Option<Option<Argument>> {
        let atom = target(state)?;
        vars.iter().find_map(|&v| {
            let ends = ends(state, atom, v)?;
            // A range without an end is no side of a box; to look there costs more than it gives.
            let [end, other] = &ends[..] else { return None };
            if state.atoms[atom].poly.degree(v) == 1 {
                return Some(self.at_either(state, vars, v, (end, other), depth - 1));
            }
            ends.iter().find_map(|end| {
                let [some_up, some_down] = signs(state, &end.slope);
                if some_down || !some_up {
                    return None;
                }
                let falls = state.with(Atom::new(end.slope.neg(), Sign::Positive));
                let falls = without(&falls, end.atom);
                let never = self.boxes(&falls, vars, (depth - 1).min(SLOPES))?;
                Some(self.at_end(state, vars, v, (end, never), depth - 1))
            })
        })
    }

    /// At one end where the slope is not negative, at the other one where it is.
    fn at_either(
        &self,
        state: &State<'_, '_>,
        vars: &[usize],
        v: usize,
        (end, other): (&End, &End),
        depth: u32,
    ) -> Option<Argument> {
        let case = |sign, poly: &Poly| state.with(Atom::new(poly.clone(), sign));
        let positive = self.beyond(&case(Sign::Positive, &end.slope), vars, v, end, depth)?;
        let negative = self.beyond(&case(Sign::Positive, &other.slope), vars, v, other, depth)?;
        let zero = self.beyond(&case(Sign::Zero, &end.slope), vars, v, end, depth)?;
        let [zero, positive, negative] = [zero, positive, negative].map(Box::new);
        Some(Argument::Split { poly: end.slope.clone(), zero, positive, negative })
    }

    /// At an end where the slope is never negative, as is proved.
    fn at_end(
        &self,
        state: &State<'_, '_>,
        vars: &[usize],
        v: usize,
        (end, never): (&End, Argument),
        depth: u32,
    ) -> Option<Argument> {
        let case = |sign| state.with(Atom::new(end.slope.clone(), sign));
        let zero = self.beyond(&case(Sign::Zero), vars, v, end, depth)?;
        let positive = self.beyond(&case(Sign::Positive), vars, v, end, depth)?;
        let [zero, positive, negative] = [zero, positive, never].map(Box::new);
        Some(Argument::Split { poly: end.slope.clone(), zero, positive, negative })
    }

    /// The rest without the variable, from the condition at the end. The last atom says that it is largest there.
    fn beyond(
        &self,
        state: &State<'_, '_>,
        vars: &[usize],
        v: usize,
        end: &End,
        depth: u32,
    ) -> Option<Argument> {
        let fresh = state.atoms.len();
        let slope = fresh - 1;
        let term = |weight: &BigInt, factors| Term {
            weight: weight.clone(),
            square: Poly::one(),
            factors,
        };
        // scale·p + crossed·bound·slope − weight·there = 0
        let identity = |there: Sign| {
            let (mut terms, mut cofactors) = (Vec::new(), Vec::new());
            match state.atoms[end.atom].sign {
                Sign::Zero => cofactors.push((end.atom, Poly::constant(end.scale.clone()))),
                _ => terms.push(term(&end.scale, vec![(end.atom, 1)])),
            }
            let (first, second) = (end.bound.min(slope), end.bound.max(slope));
            match state.atoms[slope].sign {
                Sign::Zero => {
                    cofactors.push((slope, state.atoms[end.bound].poly.scale(&end.crossed)));
                }
                _ => terms.push(term(&end.crossed, vec![(first, 1), (second, 1)])),
            }
            match there {
                Sign::Zero => cofactors.push((fresh, Poly::constant(-&end.weight))),
                _ => terms.push(term(&end.weight, vec![(fresh, 1)])),
            }
            Argument::Positive { terms, cofactors }
        };
        let case = |sign, poly: Poly| state.with(Atom::new(poly, sign));
        let on = |next: &State<'_, '_>| {
            let rest: Vec<usize> = vars.iter().copied().filter(|w| *w != v).collect();
            self.boxes(&without(next, end.atom), &rest, depth)
        };
        let closes =
            |next: &State<'_, '_>, proof: Argument| next.closes(&proof).is_ok().then_some(proof);
        let falls = case(Sign::Positive, end.there.neg());
        let negative = closes(&falls, identity(Sign::Positive))?;
        let level = case(Sign::Zero, end.there.clone());
        let zero = match closes(&level, identity(Sign::Zero)) {
            Some(proof) => proof,
            None => on(&level)?,
        };
        let positive = on(&case(Sign::Positive, end.there.clone()))?;
        let [zero, positive, negative] = [zero, positive, negative].map(Box::new);
        Some(Argument::Split { poly: end.there.clone(), zero, positive, negative })
    }
}

/// The last condition in two variables or more.
fn target(state: &State<'_, '_>) -> Option<usize> {
    (0..state.atoms.len()).rev().find(|&i| {
        let a = &state.atoms[i];
        let several = (2..=VARIABLES).contains(&a.poly.vars().len()) && a.poly.len() <= TERMS;
        a.sign != Sign::NonZero && several
    })
}

/// The ends of the range of a variable, of a condition that depends on it.
fn ends(state: &State<'_, '_>, atom: usize, v: usize) -> Option<Vec<End>> {
    let p = &state.atoms[atom].poly;
    let degree = p.degree(v);
    if degree == 0 {
        return None;
    }
    let (lower, upper) = line::bounds(state, v);
    let end = |bound: usize| -> Option<End> {
        let at = line::bound_value(state, bound, v);
        let there = specialised(p, &[(v, at.clone())]);
        let power = at.denom().pow(degree);
        let by = &state.atoms[bound].poly;
        // dᴺ·p − dᴺ·p(n/d) = (d·v − n)·g, and the bound is k·(d·v − n)
        let difference = p.scale(&power).sub(&there);
        let step = by.primitive();
        let quotient = exact_quotient(&difference, &step.1, &state.scope.fuel)?;
        let (weight, there) = there.primitive();
        let (scale, crossed) = (power * &step.0, difference.primitive().0);
        let (weight, slope) = (weight * step.0, quotient.neg());
        Some(End { atom, bound, scale, crossed, there, weight, slope })
    };
    Some([lower, upper].into_iter().flatten().filter_map(end).collect())
}

/// Whether a polynomial is positive, and whether it is negative, at some corner or in the middle of the ranges of
/// its variables, where those are known.
fn signs(state: &State<'_, '_>, p: &Poly) -> [bool; 2] {
    let vars = p.vars();
    let range = |v: usize| {
        let (lower, upper) = line::bounds(state, v);
        let at = |i: Option<usize>| i.map(|i| line::bound_value(state, i, v));
        let (a, b) = (at(lower), at(upper));
        let two = Q::from_integer(2.into());
        match (a, b) {
            (Some(a), Some(b)) => vec![(&a + &b) / two, a, b],
            (Some(a), None) => vec![&a + Q::one(), a],
            (None, Some(b)) => vec![&b - Q::one(), b],
            (None, None) => vec![Q::zero(), Q::one(), -Q::one()],
        }
    };
    let mut points: Vec<Vec<(usize, Q)>> = vec![Vec::new()];
    for v in vars {
        let values = range(v);
        let further = |point: &Vec<(usize, Q)>| {
            let with = |q: &Q| [&point[..], &[(v, q.clone())]].concat();
            values.iter().map(with).collect::<Vec<_>>()
        };
        points = points.iter().flat_map(further).collect();
    }
    let mut found = [false, false];
    for point in points {
        let value = specialised(p, &point).as_constant().unwrap_or_default();
        found[0] |= value.is_positive();
        found[1] |= value.is_negative();
    }
    found
}

/// The same state with nothing said by one atom.
fn without<'s, 'g>(state: &State<'s, 'g>, atom: usize) -> State<'s, 'g> {
    let mut next = state.clone();
    next.atoms[atom] = Atom::new(Poly::default(), Sign::Zero);
    next
}
