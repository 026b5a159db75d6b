//! Ideals of equations.

use kane_algebra::ring::{Ideal, within_gate};
use kane_kernel::{Poly, Sign, State, Term};

use crate::argument::{Argument, Rules};

/// 1, or a product of atoms that do not vanish, in the ideal of the equations.
pub(crate) fn ideal(state: &State<'_, '_>) -> Option<Argument> {
    let equations: Vec<usize> = (0..state.atoms.len())
        .filter(|&i| state.atoms[i].sign == Sign::Zero && state.atoms[i].decided().is_none())
        .collect();
    let polys: Vec<&Poly> = equations.iter().map(|&i| &state.atoms[i].poly).collect();
    let distinct: Vec<usize> = (0..state.atoms.len())
        .filter(|&i| {
            let a = &state.atoms[i];
            matches!(a.sign, Sign::NonZero | Sign::Positive) && a.decided().is_none()
        })
        .collect();
    let targets: Vec<usize> =
        distinct.iter().copied().filter(|&i| state.atoms[i].sign == Sign::NonZero).collect();
    let others: Vec<&Poly> = targets.iter().map(|&i| &state.atoms[i].poly).collect();
    if polys.is_empty() || !within_gate(&polys, &others) {
        return None;
    }
    let ideal = Ideal::new(&polys, &others)?;
    let powers: Vec<Vec<(usize, u32)>> = std::iter::once(Vec::new())
        .chain((1..=2).flat_map(|n| targets.iter().map(move |&i| vec![(i, n)])))
        .collect();
    for factors in powers {
        let mut product = Poly::one();
        for (i, n) in &factors {
            product = product
                .mul(&state.atoms[*i].poly.pow(*n, &state.scope.fuel).ok()?, &state.scope.fuel)
                .ok()?;
        }
        let Some((lift, common)) = ideal.lift(&product) else {
            continue;
        };
        let cofactors: Vec<(usize, Poly)> = equations.iter().copied().zip(lift).collect();
        // common · Π = Σ …; multiply once more by −Π to leave nothing beside a positive square.
        let square: Vec<_> = factors.iter().map(|(i, n)| (*i, 2 * n)).collect();
        let cofactors = cofactors
            .into_iter()
            .map(|(i, c)| Some((i, c.mul(&product.neg(), &state.scope.fuel).ok()?)))
            .collect::<Option<Vec<_>>>()?;
        let term = Term { weight: common, square: Poly::one(), factors: square };
        let scaled = Argument::Positive { terms: vec![term], cofactors };
        if state.closes(&scaled).is_ok() {
            return Some(scaled);
        }
    }
    None
}
