//! Arguments without what they do not use: assumptions, cases and substitutions that nothing further on
//! refers to, and bounds that are not needed.
//!
//! What is left is held against the rules again, and if it does not close the state, nothing is left out.

use std::collections::BTreeSet;

use kane_kernel::{Atom, Poly, Sign, State};

use crate::argument::{Argument, Course, Passage, Rules as _};

/// The argument without what it does not use.
pub(super) fn pruned(state: &State<'_, '_>, argument: &Argument) -> Argument {
    for same in [alike, equal] {
        if let Some((lean, _)) = prune(state, argument, same)
            && state.closes(&lean).is_ok()
        {
            return lean;
        }
    }
    argument.clone()
}

/// Indices of the atoms that an argument refers to.
type Needs = BTreeSet<usize>;

/// Whether two atoms count as one.
type Same = fn(&Atom, &Atom) -> bool;

fn equal(a: &Atom, b: &Atom) -> bool {
    a == b
}

/// Equal up to a positive number, which only sums and sign tables see.
fn alike(a: &Atom, b: &Atom) -> bool {
    a.sign == b.sign && a.poly.primitive().1 == b.poly.primitive().1
}

fn prune(state: &State<'_, '_>, argument: &Argument, same: Same) -> Option<(Argument, Needs)> {
    let first = state.atoms.len();
    match argument {
        Argument::Assume { formula, cases } => {
            let states = state.assume(*formula).ok()?;
            if states.len() != cases.len() {
                return None;
            }
            let (mut parts, mut needs) = (Vec::new(), Needs::new());
            for (case, then) in states.iter().zip(cases) {
                let (then, mut need) = prune(case, then, same)?;
                if need.split_off(&first).is_empty() {
                    return Some((lowered(then, case.atoms.len(), case.atoms.len() - first), need));
                }
                needs.extend(need);
                parts.push(then);
            }
            Some((Argument::Assume { formula: *formula, cases: parts }, needs))
        }
        Argument::Split { poly, zero, positive, negative } => {
            let (mut parts, mut needs) = (Vec::new(), Needs::new());
            for (atom, then) in super::signs(poly).into_iter().zip([zero, positive, negative]) {
                let (then, mut need) = prune(&state.with(atom), then, same)?;
                if need.split_off(&first).is_empty() {
                    return Some((lowered(then, first + 1, 1), need));
                }
                needs.extend(need);
                parts.push(Box::new(then));
            }
            let [zero, positive, negative] = <[_; 3]>::try_from(parts).ok()?;
            Some((Argument::Split { poly: poly.clone(), zero, positive, negative }, needs))
        }
        Argument::Substitute { equation, var, lead, then } => {
            let next = state.substitute(*equation, *var, lead).ok()?;
            let (then, mut needs) = prune(&next, then, same)?;
            let unchanged = |i: &usize| match (next.atoms.get(*i), state.atoms.get(*i)) {
                (Some(new), Some(old)) => i != equation && same(new, old),
                _ => false,
            };
            if needs.iter().all(unchanged) {
                return Some((then, needs));
            }
            needs.insert(*equation);
            needs.extend(lead.iter().map(|f| f.0));
            let (equation, var, lead) = (*equation, *var, lead.clone());
            Some((Argument::Substitute { equation, var, lead, then: then.into() }, needs))
        }
        Argument::Cancel { atom, factors, quotient, then } => {
            let next = state.cancel(*atom, factors, quotient).ok()?;
            let (then, mut needs) = prune(&next, then, same)?;
            if !needs.contains(atom) {
                return Some((then, needs));
            }
            needs.extend(factors.iter().map(|f| f.0));
            let (atom, factors, quotient) = (*atom, factors.clone(), quotient.clone());
            Some((Argument::Cancel { atom, factors, quotient, then: then.into() }, needs))
        }
        Argument::Orthant { atom, bounds } => {
            let slim = slim(state, *atom, bounds);
            let argument = Argument::Orthant { atom: *atom, bounds: slim };
            let needs = needed(&argument);
            Some((argument, needs))
        }
        Argument::Absurd(_) | Argument::Positive { .. } | Argument::SignTable { .. } => {
            Some((argument.clone(), needed(argument)))
        }
    }
}

/// An argument after passages to limits, without the last of them if it does not use them.
pub(crate) fn without_idle(
    state: &State<'_, '_>,
    mut passages: Vec<Passage>,
    argument: &Argument,
) -> Course {
    let mut lean = argument.clone();
    while let Some(last) = passages.len().checked_sub(1) {
        let end = state.atoms.len() + last;
        if needed(&lean).contains(&end) {
            break;
        }
        (lean, _) = (lowered(lean, end + 1, 1), passages.pop());
    }
    Course::After(passages, lean)
}

/// Of two bounds of a variable one, where it is enough.
fn slim(
    state: &State<'_, '_>,
    atom: usize,
    bounds: &[crate::argument::Bounds],
) -> Vec<crate::argument::Bounds> {
    let mut slim = bounds.to_vec();
    for i in 0..slim.len() {
        let (var, Some(lower), Some(upper)) = slim[i] else { continue };
        for one in [(var, Some(lower), None), (var, None, Some(upper))] {
            let both = std::mem::replace(&mut slim[i], one);
            if state.closes(&Argument::Orthant { atom, bounds: slim.clone() }).is_ok() {
                break;
            }
            slim[i] = both;
        }
    }
    slim
}

/// All indices that an argument refers to, those of its own cases among them.
pub(super) fn needed(argument: &Argument) -> Needs {
    let mut needs = Needs::new();
    refer(&mut argument.clone(), &mut |i| _ = needs.insert(*i));
    needs
}

/// The argument where the atoms from an index on stand so many places lower.
fn lowered(mut argument: Argument, from: usize, by: usize) -> Argument {
    refer(&mut argument, &mut |i| *i -= if *i >= from { by } else { 0 });
    argument
}

/// Goes through all indices of atoms.
fn refer(argument: &mut Argument, see: &mut dyn FnMut(&mut usize)) {
    match argument {
        Argument::Absurd(i) => see(i),
        Argument::Assume { cases, .. } => cases.iter_mut().for_each(|case| refer(case, see)),
        Argument::Split { zero, positive, negative, .. } => {
            [zero, positive, negative].into_iter().for_each(|case| refer(case, see));
        }
        Argument::Substitute { equation, lead, then, .. } => {
            see(equation);
            lead.iter_mut().for_each(|f| see(&mut f.0));
            refer(then, see);
        }
        Argument::Cancel { atom, factors, then, .. } => {
            see(atom);
            factors.iter_mut().for_each(|f| see(&mut f.0));
            refer(then, see);
        }
        Argument::Positive { terms, cofactors } => {
            terms.iter_mut().flat_map(|t| &mut t.factors).for_each(|f| see(&mut f.0));
            cofactors.iter_mut().for_each(|c| see(&mut c.0));
        }
        Argument::Orthant { atom, bounds } => {
            see(atom);
            bounds.iter_mut().flat_map(|b| [&mut b.1, &mut b.2]).flatten().for_each(see);
        }
        Argument::SignTable { atoms, .. } => atoms.iter_mut().for_each(|a| see(&mut a.0)),
    }
}

/// Indices that a reader has to know the atoms of: not of equations by which something is replaced, nor of what is
/// unequal and turns out to be equal.
pub(super) fn shown(argument: &Argument, atoms: &[Atom]) -> Needs {
    let mut shown = Needs::new();
    show(argument, atoms, &mut shown);
    shown
}

fn show(argument: &Argument, atoms: &[Atom], shown: &mut Needs) {
    match argument {
        Argument::Absurd(i) => {
            if atoms.get(*i).is_none_or(|atom| atom.sign != Sign::NonZero) {
                shown.insert(*i);
            }
        }
        Argument::Assume { cases, .. } => cases.iter().for_each(|case| show(case, atoms, shown)),
        Argument::Split { zero, positive, negative, .. } => {
            [zero, positive, negative].into_iter().for_each(|case| show(case, atoms, shown));
        }
        Argument::Substitute { equation, var, lead, then } => {
            let replaces = |atom: &Atom| atom.poly.degree(*var) < 2;
            if !atoms.get(*equation).is_none_or(replaces) {
                shown.insert(*equation);
            }
            shown.extend(lead.iter().map(|f| f.0));
            show(then, atoms, shown);
        }
        Argument::Cancel { atom, factors, then, .. } => {
            shown.extend(factors.iter().map(|f| f.0));
            if is_end(argument) {
                shown.insert(*atom);
            } else {
                show(then, atoms, shown);
            }
        }
        Argument::Positive { .. } | Argument::Orthant { .. } | Argument::SignTable { .. } => {
            shown.extend(needed(argument));
        }
    }
}

/// Whether it divides an atom by all that is in it, so that a false constant is left.
pub(super) fn is_end(argument: &Argument) -> bool {
    let Argument::Cancel { atom, quotient, then, .. } = argument else { return false };
    Poly::is_constant(quotient) && matches!(&**then, Argument::Absurd(i) if i == atom)
}
