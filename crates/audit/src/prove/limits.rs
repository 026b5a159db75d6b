//! Limits: finding what an expression tends to, and what premised limits say about constants.

use kane_algebra::factors::factors;
use kane_algebra::ring::cancelled;
use kane_kernel::{
    Atom, Expr, Fuel, Germ, Goal, Limit, Poly, Side, Sign, State, Target, constants, differ,
    differs, exponent, premised, sides, unequal,
};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

use super::asymptote;
use super::bounds;
use super::germs::{Germs, Memory};
use super::reciprocal::is_long;
use super::search::{Outcome, Search};
use super::squeeze::{self, between};
use super::symbols::without_squares;
use super::variation::{substituted, varies};
use crate::argument::{LimitArgument, Passage, SideArgument};

/// Case distinctions on constants inside each other.
const SPLITS: u32 = 3;
/// Terms of a polynomial along a germ that is compared with a long one.
const LONGEST: usize = 20_000;

/// What an expression tends to from one side: num/den at t = 0, or ±∞ of order > 0.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) num: Poly,
    pub(crate) den: Poly,
    pub(crate) order: u32,
}

/// What the premised limits on the given sides imply for constants: one atom a pass.
pub(crate) fn passes<'s, 'g>(
    state: &State<'s, 'g>,
    sides: &[Side],
    steps: u64,
    memory: &Memory,
) -> (State<'s, 'g>, Vec<Passage>) {
    let (mut state, mut found) = (state.clone(), Vec::new());
    for _ in 0..3 {
        let before = found.len();
        for side in sides {
            let germs = Germs::new(&state, side, steps).remembering(memory);
            let Some(germ) = germs.all().next() else {
                continue;
            };
            let Ok(along) = state.along_unproved(&germ) else {
                continue;
            };
            let may = varies(&state, side.var);
            let mut search = Search::new(steps, &may, false);
            search.proofs = false;
            // A germ on which nothing can hold: the premises pin x.
            let nothing = Atom::new(Poly::one(), Sign::Zero);
            if let Outcome::Closed(proof) = search.solve(&along.with(nothing.not())) {
                state = state.with(nothing.clone());
                found.push(Passage { germ, atom: nothing, along: proof });
                return (state, found);
            }
            let Some((rest, _)) = search.reduced(&along) else {
                continue;
            };
            let t = state.scope.germ();
            for atom in &rest.atoms {
                let order = matches!(atom.sign, Sign::Positive | Sign::NonNegative);
                let vars = atom.poly.vars();
                if vars.is_empty()
                    || atom.sign == Sign::NonZero
                    || (order && !vars.iter().any(|v| *v > t))
                {
                    continue;
                }
                let sign = if order { Sign::NonNegative } else { Sign::Zero };
                let atom = Atom::new(atom.poly.clone(), sign);
                let Ok(at_zero) = state.at_zero(&germ, &atom) else {
                    continue;
                };
                if at_zero.decided() == Some(true) || state.atoms.contains(&at_zero) {
                    continue;
                }
                if let Outcome::Closed(proof) = search.solve(&along.with(atom.not())) {
                    state = state.with(at_zero);
                    found.push(Passage { germ: germ.clone(), atom, along: proof });
                }
            }
        }
        if found.len() == before {
            break;
        }
    }
    (state, found)
}

/// All sides from which limits are premised.
pub(crate) fn premised_sides(state: &State<'_, '_>, goal: &Goal) -> Vec<Side> {
    let mut out = Vec::new();
    for (_, l) in premised(goal) {
        for side in sides(state.scope, l) {
            if !out.contains(&side) {
                out.push(side);
            }
        }
    }
    out
}

/// What an expression tends to, read off germs without proof.
fn found<'a>(
    state: &'a State<'_, '_>,
    limit: &'a Limit,
    germs: &'a Germs<'_, '_, '_>,
    steps: u64,
) -> impl Iterator<Item = (Germ, Found)> {
    germs.all().flat_map(move |germ| {
        let found = read_off(state, limit, &germ, steps);
        found.into_iter().map(move |found| (germ.clone(), found))
    })
}

fn read_off(state: &State<'_, '_>, limit: &Limit, germ: &Germ, steps: u64) -> Vec<Found> {
    let mut out = Vec::new();
    let (Ok(along), Ok(pieces)) = (state.along_unproved(germ), state.scope.pieces(&limit.expr))
    else {
        return out;
    };
    let may = varies(state, germ.side.var);
    let search = Search::new(steps, &may, false);
    for piece in pieces {
        let Some(value) = &piece.value else {
            continue;
        };
        let Some((rest, trail)) = search.reduced(&along.with_cases(vec![piece.atoms])) else {
            continue;
        };
        if super::tactics::quick(&rest).is_some() {
            continue;
        }
        let Ok((num, den)) = substituted(&along, value, &trail) else {
            continue;
        };
        let (num, den) = cancelled(&without_squares(state, num), &without_squares(state, den));
        // nothing over a power of t is nothing
        let den = if num.is_empty() { Poly::one() } else { den };
        let t = state.scope.germ();
        let order = den.terms().map(|(m, _)| exponent(m, t)).min().unwrap_or(0);
        out.push(Found { num, den, order });
    }
    out
}

/// A proof of a limit from one side.
pub(crate) fn one_side(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    steps: u64,
) -> Option<SideArgument> {
    let by_quotient = by_quotient(state, limit, side, steps);
    by_quotient
        .or_else(|| {
            bounds::one_side(state, limit, side, steps, &|power, argument| {
                Germs::new(state, side, steps).along(power).all().find_map(argument)
            })
        })
        .or_else(|| asymptote::one_side(state, limit, side, steps))
        .or_else(|| squeeze::one_side(state, limit, side, steps))
}

/// A proof of a limit from one side by a quotient that the expression equals.
fn by_quotient(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    steps: u64,
) -> Option<SideArgument> {
    let t = state.scope.germ();
    let mut tried: Vec<Poly> = Vec::new();
    let germs = Germs::new(state, side, steps);
    for (at, found) in found(state, limit, &germs, steps) {
        if let Some(proof) = along(state, limit, side, at, &found, steps) {
            return Some(proof);
        }
        // Perhaps the radius has to shrink with what the denominator starts from.
        let start = found.den.coefficients(t).into_iter().find(|c| !c.is_empty())?;
        if start.is_constant() || tried.contains(&start) {
            continue;
        }
        tried.push(start.clone());
        // a power shrinks faster than what it is a power of
        let fuel = &state.scope.fuel;
        let mut bases = factors(&start).1.into_iter().filter(|(f, _)| !f.is_constant());
        let lead = bases.try_fold(Poly::one(), |product, (f, _)| product.mul(&f, fuel).ok())?;
        if let Some(proof) =
            germs.with_lead(lead).and_then(|g| along(state, limit, side, g, &found, steps))
        {
            return Some(proof);
        }
    }
    None
}

/// The proof along a germ, of what was found there.
fn along(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    germ: Germ,
    found: &Found,
    steps: u64,
) -> Option<SideArgument> {
    let parts = (&found.num, &found.den, found.order);
    let at_zero = bounds::at_zero(state, limit, side, parts, steps)?;
    // no square of what is long is formed to say that it is not zero
    let is_long = [&found.num, &found.den].into_iter().any(is_long);
    let compared = |sense: Ordering| {
        let ends = (&found.num, &found.den);
        let wrong = differs(state.scope, &limit.compared(state.scope), ends, sense).ok()?;
        let along = state.along_unproved(&germ).ok()?.with_cases(wrong);
        let may = varies(state, side.var);
        let mut search = Search::new(steps, &may, false);
        if is_long {
            search.widest = LONGEST;
        }
        let Outcome::Closed(along) = search.solve(&along) else {
            return None;
        };
        let Found { num, den, order } = found.clone();
        let (germ, at_zero) = (germ.clone(), at_zero.clone());
        Some(SideArgument { germ, num, den, order, sense, along, at_zero, upper: None })
    };
    if is_long { between(&limit.to, &compared) } else { compared(Ordering::Equal) }
}

/// A proof of a limit from all sides as it is.
pub(crate) fn prove(goal: &Goal, limit: &Limit, steps: u64, fuel: Fuel) -> Option<LimitArgument> {
    let scope = kane_kernel::scope(goal, fuel).ok()?;
    let state = constants(&scope, goal, limit.var).ok()?;
    from_all_sides(&state, limit, steps).map(LimitArgument::Sides)
}

/// A proof of a limit, which has none as it is, by the sign of what decides how the expression behaves. Each case of the
/// constants has the budget of a claim.
pub(crate) fn prove_by_cases(
    goal: &Goal,
    limit: &Limit,
    steps: u64,
    fuel: &dyn Fn() -> Fuel,
) -> Option<LimitArgument> {
    by_cases(goal, limit, &[], (steps, fuel), SPLITS)
}

/// A proof where these atoms are known.
fn by_cases(
    goal: &Goal,
    limit: &Limit,
    known: &[Atom],
    (steps, fuel): (u64, &dyn Fn() -> Fuel),
    splits: u32,
) -> Option<LimitArgument> {
    let scope = kane_kernel::scope(goal, fuel()).ok()?;
    let mut state = constants(&scope, goal, limit.var).ok()?;
    state.atoms.extend(known.iter().cloned());
    if !known.is_empty() {
        let any = |_: usize, _: &Poly| true;
        if let Outcome::Closed(absurd) = Search::new(steps / 8, &any, false).solve(&state) {
            return Some(LimitArgument::Absurd(absurd));
        }
        if let Some(arguments) = from_all_sides(&state, limit, steps) {
            return Some(LimitArgument::Sides(arguments));
        }
    }
    let splits = splits.checked_sub(1)?;
    let poly = asymptote::undetermined(&state, limit, sides(&scope, limit).first()?)?;
    let case = |poly: Poly, sign: Sign| {
        let known = [known, &[Atom::new(poly, sign)]].concat();
        by_cases(goal, limit, &known, (steps, fuel), splits).map(Box::new)
    };
    let positive = case(poly.clone(), Sign::Positive)?;
    let negative = case(poly.neg(), Sign::Positive)?;
    let zero = case(poly.clone(), Sign::Zero)?;
    Some(LimitArgument::Split { poly, zero, positive, negative })
}

/// Arguments for a limit, one for each of its sides.
pub(crate) fn from_all_sides(
    state: &State<'_, '_>,
    limit: &Limit,
    steps: u64,
) -> Option<Vec<SideArgument>> {
    let sides = sides(state.scope, limit);
    if sides.is_empty() {
        return None;
    }
    sides.iter().map(|side| one_side(state, limit, side, steps)).collect()
}

/// The limit of a closed expression of x, as a target, if it is rational or infinite.
pub(crate) fn value(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    steps: u64,
) -> Option<Target> {
    let germs = Germs::new(state, side, steps);
    let t = state.scope.germ();
    let read = found(state, limit, &germs, steps).find_map(|(_, found)| found.target(t));
    read.or_else(|| bounds::target(state, limit, side))
}

/// Whether a closed expression of x visibly tends to something else than is claimed, as it is read off a germ, without
/// proof: of each of its pieces.
pub(crate) fn misses(state: &State<'_, '_>, limit: &Limit, side: &Side, steps: u64) -> bool {
    let Some(germ) = Germs::new(state, side, steps).all().next() else { return false };
    let another = |target: Target| match unequal(&limit.to, &target) {
        Some(_) => differ(state.scope, &limit.to, &target).unwrap_or(false),
        None => limit.to != target,
    };
    let found = read_off(state, limit, &germ, steps);
    let t = state.scope.germ();
    !found.is_empty() && found.iter().all(|found| found.target(t).is_some_and(another))
}

impl Found {
    /// The number or the infinity that it tends to, if it mentions nothing but t.
    fn target(&self, t: usize) -> Option<Target> {
        let at_zero = |p: &Poly, order: u32| -> Option<BigInt> {
            let mut sum = BigInt::zero();
            for (m, c) in p.terms() {
                match m {
                    [] if order == 0 => sum += c,
                    [(v, e)] if *v == t => {
                        if *e == order {
                            sum += c;
                        }
                    }
                    [] => {}
                    _ => return None,
                }
            }
            Some(sum)
        };
        let (n, d) = (at_zero(&self.num, 0)?, at_zero(&self.den, self.order)?);
        if d.is_zero() || self.order > 0 && n.is_zero() {
            None
        } else if self.order == 0 {
            Some(Target::Finite(Expr::Num(BigRational::new(n, d))))
        } else if n.is_negative() == d.is_negative() {
            Some(Target::PlusInf)
        } else {
            Some(Target::MinusInf)
        }
    }
}
