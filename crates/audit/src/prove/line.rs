//! The line of one variable: its tightest bounds, and the sign table of the conditions in it alone.

use kane_algebra::ring::univariate;
use kane_algebra::sign_table::{Cell, SignTable};
use kane_kernel::{Fuel, Rejection, Sign, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::argument::{Argument, Rules, bound, zero};

type Q = BigRational;

/// Indices of the tightest lower and upper bounds of a variable.
pub(crate) fn bounds(state: &State<'_, '_>, v: usize) -> (Option<usize>, Option<usize>) {
    let mut lower: Option<(Q, usize)> = None;
    let mut upper: Option<(Q, usize)> = None;
    for (i, a) in state.atoms.iter().enumerate() {
        let Some((at, k)) = bound(a, v) else { continue };
        // Of equal bounds the strict one is tighter.
        let strict = a.sign == Sign::Positive;
        if k.is_positive() {
            if lower.as_ref().is_none_or(|(b, _)| at > *b || (at == *b && strict)) {
                lower = Some((at, i));
            }
        } else if upper.as_ref().is_none_or(|(b, _)| at < *b || (at == *b && strict)) {
            upper = Some((at, i));
        }
    }
    (lower.map(|b| b.1), upper.map(|b| b.1))
}

/// The value of a bound.
pub(crate) fn bound_value(state: &State<'_, '_>, i: usize, v: usize) -> Q {
    zero(&state.atoms[i].poly, v).map_or_else(Q::zero, |found| found.0)
}

/// Whether the bounds of a variable leave it no value.
pub(crate) fn is_empty(state: &State<'_, '_>, v: usize) -> bool {
    let (Some(lower), Some(upper)) = bounds(state, v) else {
        return false;
    };
    let strict = [lower, upper].iter().any(|i| state.atoms[*i].sign == Sign::Positive);
    let (low, high) = (bound_value(state, lower, v), bound_value(state, upper, v));
    low > high || (strict && low == high)
}

/// Atoms in the variable v alone: the line cut at their roots, with the atoms' indices.
pub(crate) fn cut(state: &State<'_, '_>, v: usize) -> Option<(SignTable, Vec<usize>)> {
    table(state, v, SignTable::at_roots)
}

/// How a line is cut.
type Cut = fn(&[Vec<BigInt>], &Fuel) -> Result<SignTable, Rejection>;

/// The sign table of these atoms.
fn table(state: &State<'_, '_>, v: usize, cut: Cut) -> Option<(SignTable, Vec<usize>)> {
    let (mut polys, mut contents, mut indices) = (Vec::new(), Vec::new(), Vec::new());
    for (i, a) in state.atoms.iter().enumerate() {
        if a.poly.vars() == [v] {
            let (content, primitive) = a.poly.primitive();
            polys.push(univariate(&primitive, v)?);
            contents.push(content);
            indices.push(i);
        }
    }
    if polys.is_empty() {
        return None;
    }
    let mut table = cut(&polys, &state.scope.fuel).ok()?;
    table.factored.iter_mut().zip(contents).for_each(|((constant, _), c)| *constant *= c);
    Some((table, indices))
}

/// The cells on which all atoms of a line hold, those with the simplest points first.
pub(crate) fn open_cells(state: &State<'_, '_>, table: &SignTable, indices: &[usize]) -> Vec<Cell> {
    let holds = |cell: &Cell| {
        let admits = |(k, i): (usize, &usize)| state.atoms[*i].sign.admits(table.sign(k, *cell));
        indices.iter().enumerate().all(admits)
    };
    let mut cells: Vec<Cell> = table.cells().filter(holds).collect();
    // Simplest first: small rationals, then exact roots, then irrational ones.
    cells.sort_by_key(|c| match c {
        Cell::Root(i) if !table.roots[*i].is_exact() => (2u8, BigInt::zero(), 0u8),
        Cell::Root(_) => weight(&table.sample(*c), 1),
        Cell::Gap(_) => weight(&table.sample(*c), 0),
    });
    cells
}

/// Orders rationals by simplicity: 1 before −1 before 2 before 1/2; 0 comes after 1.
fn weight(q: &Q, kind: u8) -> (u8, BigInt, u8) {
    let size: BigInt = q.numer().abs() + q.denom() * 2;
    let zero = if q.is_zero() { BigInt::from(2) } else { BigInt::zero() };
    (0, size * 2 + zero + i32::from(q.is_negative()), kind)
}

/// The sign table of v as a proof, if no cell is open.
pub(crate) fn sign_table(state: &State<'_, '_>, v: usize) -> Option<Argument> {
    let (table, indices) = table(state, v, SignTable::new)?;
    if !open_cells(state, &table, &indices).is_empty() {
        return None;
    }
    let atoms = indices
        .iter()
        .zip(&table.factored)
        .map(|(i, (c, powers))| (*i, c.clone(), powers.clone()))
        .collect();
    let proof = Argument::SignTable { var: v, bases: table.bases, roots: table.roots, atoms };
    state.closes(&proof).is_ok().then_some(proof)
}
