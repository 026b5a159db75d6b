//! The search goes on where a sign is known.

use kane_kernel::{Atom, Sign, State};

use super::elimination::Elimination;
use super::search::{Outcome, Search, since};
use super::settled::{NotNegative, Settled};
use crate::argument::Argument;

impl Search<'_> {
    /// What is left once a sign is known.
    pub(super) fn by_settled(
        &self,
        state: &State<'_, '_>,
        settled: Settled,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        match self.in_case(state, settled.atom(), trail, splits) {
            Outcome::Closed(left) => Outcome::Closed(settled.split(left)),
            other => other,
        }
    }

    /// What is left once a polynomial is known not to be negative.
    pub(super) fn by_not_negative(
        &self,
        state: &State<'_, '_>,
        found: NotNegative,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        by_sign(found, &|case| self.in_case(state, case, trail, splits))
    }

    /// What is left once the squares of two sides are known to differ by no negative number: by itself, if that is enough.
    pub(super) fn by_squares(
        &self,
        state: &State<'_, '_>,
        found: NotNegative,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        by_sign(found, &|case: Atom| {
            let alone = self.case_alone(state, case.clone(), splits);
            alone.map_or_else(|| self.in_case(state, case, trail, splits), Outcome::Closed)
        })
    }

    fn in_case(
        &self,
        state: &State<'_, '_>,
        case: Atom,
        trail: &[Elimination],
        splits: u32,
    ) -> Outcome {
        let next = state.with(case);
        self.run(&next, &since(&next, state.atoms.len()), Vec::new(), trail, splits)
    }
}

/// The split on the sign of what is not negative, if both cases are closed; how one of them ends otherwise.
fn by_sign(found: NotNegative, case: &dyn Fn(Atom) -> Outcome) -> Outcome {
    let NotNegative { poly, zero, negative } = found;
    let positive = match case(Atom::new(poly.clone(), Sign::Positive)) {
        Outcome::Closed(proof) => proof,
        other => return other,
    };
    let at_zero = || case(Atom::new(poly.clone(), Sign::Zero));
    let zero = match zero.map_or_else(at_zero, Outcome::Closed) {
        Outcome::Closed(proof) => proof,
        other => return other,
    };
    let [zero, positive, negative] = [zero, positive, negative].map(Box::new);
    Outcome::Closed(Argument::Split { poly, zero, positive, negative })
}
