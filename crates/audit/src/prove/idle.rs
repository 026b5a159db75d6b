//! Idle conditions: they can be met whatever the others say, so that no contradiction needs them.

use kane_kernel::{Atom, Poly, Sign, State};
use num_traits::Signed as _;

/// A state in which conditions that are idle say nothing; `None` if none is. All keep their places, so that an argument by
/// the other conditions closes the state itself.
///
/// Idle is what stands there twice, and the conditions of a variable that all hold where it is large, or where it is far
/// below zero: each of them orders it, with an odd highest power and a number before it.
pub(super) fn without_idle<'s, 'g>(state: &State<'s, 'g>) -> Option<State<'s, 'g>> {
    let mut atoms = state.atoms.to_vec();
    let nothing = nothing();
    let mut is_new = false;
    for i in 0..atoms.len() {
        if atoms[i].decided().is_none() && atoms[..i].contains(&atoms[i]) {
            atoms[i] = nothing.clone();
            is_new = true;
        }
    }
    while let Some(v) = free(&atoms) {
        let with = atoms.iter_mut().filter(|a| a.poly.degree(v) > 0);
        with.for_each(|a| *a = nothing.clone());
        is_new = true;
    }
    is_new.then(|| State { atoms, ..state.clone() })
}

/// A condition that says nothing: it stands in the place of others, so that all keep theirs.
pub(super) fn nothing() -> Atom {
    Atom::new(Poly::one(), Sign::Positive)
}

/// A variable whose conditions can all be met at once.
fn free(atoms: &[Atom]) -> Option<usize> {
    let mut vars: Vec<usize> = atoms.iter().flat_map(|a| a.poly.vars()).collect();
    vars.sort_unstable();
    vars.dedup();
    vars.into_iter().find(|&v| {
        let mut of = atoms.iter().filter(|a| a.poly.degree(v) > 0).map(|a| grows(a, v));
        let first = of.next().flatten();
        first.is_some() && of.all(|sense| sense == first)
    })
}

/// Whether a condition holds for all large v, or for all far below zero.
fn grows(atom: &Atom, v: usize) -> Option<bool> {
    let degree = atom.poly.degree(v);
    let lead = atom.poly.coefficient(v, degree).as_constant()?;
    (atom.sign.is_order() && degree % 2 == 1).then(|| lead.is_positive())
}
