//! What a search keeps of the equations that it solved.

use kane_kernel::{Poly, State};

/// v = −e/d, found on the way.
#[derive(Clone, Debug)]
pub(crate) struct Elimination {
    pub(crate) var: usize,
    pub(crate) d: Poly,
    pub(crate) e: Poly,
}

/// Indices of atoms, with powers.
pub(crate) type Factors = Vec<(usize, u32)>;

/// Variables of the atoms that are not decided.
pub(crate) fn open_vars(state: &State<'_, '_>) -> Vec<usize> {
    let mut vars: Vec<usize> = state.atoms.iter().flat_map(|a| a.poly.vars()).collect();
    vars.sort_unstable();
    vars.dedup();
    vars
}
