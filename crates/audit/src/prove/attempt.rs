//! What a search tried in vain.

use kane_kernel::Atom;

use crate::open::Method;

/// What a search tried, and the smallest conditions on which all of it failed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Attempt {
    pub(crate) tried: Vec<Method>,
    pub(crate) left: Option<Vec<Atom>>,
}

impl Attempt {
    pub(super) fn note(&mut self, method: Method) {
        if !self.tried.contains(&method) {
            self.tried.push(method);
        }
    }

    /// Notes conditions that stay open.
    pub(super) fn leave(&mut self, atoms: &[Atom]) {
        let size = |atoms: &[Atom]| atoms.iter().map(|a| a.poly.len() + 1).sum::<usize>();
        let open: Vec<Atom> = atoms.iter().filter(|a| a.decided().is_none()).cloned().collect();
        if self.left.as_ref().is_none_or(|known| size(&open) < size(known)) {
            self.left = Some(open);
        }
    }

    /// Takes over what another search tried; what this one leaves stays.
    pub(crate) fn join(&mut self, other: Self) {
        other.tried.into_iter().for_each(|m| self.note(m));
        if self.left.is_none() {
            self.left = other.left;
        }
    }
}
