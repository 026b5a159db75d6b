//! Components: conditions that share no variable with the others are satisfied on their own.
//!
//! What one component leaves irrational, the others need not know of, as long as it is the last one.

use kane_kernel::{Atom, Point, Poly, Sign, State};
use num_rational::BigRational;
use num_traits::Zero;

use super::elimination::Elimination;
use super::search::Search;

impl Search<'_> {
    /// A point of a state that falls apart, put together from one of each of its components.
    pub(super) fn by_components(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
        splits: u32,
    ) -> Option<Point> {
        let mut parts = components(&state.atoms, vars);
        if parts.len() < 2 {
            return None;
        }
        // What has equations is the most likely to need an irrational number.
        let equations = |part: &Vec<usize>| {
            let own = within(state, part);
            own.atoms.iter().filter(|a| a.sign == Sign::Zero).count()
        };
        parts.sort_by_key(equations);
        let last = parts.pop()?;
        let mut trail = trail.to_vec();
        for part in parts {
            let point = self.point(&within(state, &part), &[], &part, splits)?;
            for v in part {
                trail.push(rational(&point, v)?);
            }
        }
        self.point(&within(state, &last), &trail, &last, splits)
    }
}

/// The variables, those together that stand together in a condition.
fn components(atoms: &[Atom], vars: &[usize]) -> Vec<Vec<usize>> {
    let mut parts: Vec<Vec<usize>> = vars.iter().map(|&v| vec![v]).collect();
    for atom in atoms {
        let inside = atom.poly.vars();
        let (joined, apart): (Vec<_>, Vec<_>) =
            parts.into_iter().partition(|part| part.iter().any(|v| inside.contains(v)));
        parts = apart;
        let mut joined = joined.concat();
        joined.sort_unstable();
        parts.extend((!joined.is_empty()).then_some(joined));
    }
    parts.sort();
    parts
}

/// The conditions on some variables alone.
fn within<'s, 'g>(state: &State<'s, 'g>, part: &[usize]) -> State<'s, 'g> {
    let own = |a: &&Atom| a.poly.vars().iter().any(|v| part.contains(v));
    State { atoms: state.atoms.iter().filter(own).cloned().collect(), ..state.clone() }
}

/// A rational value as one that was found on the way.
fn rational(point: &Point, var: usize) -> Option<Elimination> {
    let (_, value) = point.values.iter().find(|known| known.0 == var)?;
    let (first, higher) =
        value.split_first().map_or((BigRational::zero(), &[][..]), |(q, r)| (q.clone(), r));
    let is_rational = higher.iter().all(Zero::is_zero);
    let (num, den) = (first.numer().clone(), first.denom().clone());
    is_rational.then(|| Elimination { var, d: Poly::constant(den), e: Poly::constant(-num) })
}
