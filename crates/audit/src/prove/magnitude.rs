//! Limits that are 0 or infinite, of expressions with roots of symbols: beside such an expression lies c·t or c/t, where c is
//! a fraction in the constants that is at least, or at most, as great as the root of a symbol needs.

use std::cmp::Ordering;

use kane_kernel::{Expr, Limit, Poly, Side, State, Target};
use num_bigint::BigInt;
use num_traits::One;

use super::bounds::at_zero;
use super::germs::Germs;
use super::squeeze::{Beside, between, bounded};
use super::variation::varies;
use crate::argument::SideArgument;

/// Powers of t along which such an expression is looked at, where a root grows or falls like t.
const POWERS: [u32; 2] = [2, 1];
/// Germs that are tried along each.
const GERMS: usize = 2;

/// A proof of a limit from one side by multiples of t, or of 1/t.
pub(super) fn one_side(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    steps: u64,
) -> Option<SideArgument> {
    let leads = leads(state, side.var);
    if leads.is_empty() {
        return None;
    }
    let may = varies(state, side.var);
    POWERS.iter().find_map(|&power| {
        let all = beside(state, limit, side, &leads, steps);
        Germs::new(state, side, steps).along(power).all().take(GERMS).find_map(|germ| {
            let shown = |sense: Ordering| {
                let mut all = all.iter().filter(|(of, _)| *of == sense);
                all.find_map(|(_, b)| bounded(state, limit, &germ, b, sense, steps, &may))
            };
            between(&limit.to, &shown)
        })
    })
}

/// Quotients that may lie beside the expression, and on which side of each it is then.
fn beside(
    state: &State<'_, '_>,
    limit: &Limit,
    side: &Side,
    leads: &[Poly],
    steps: u64,
) -> Vec<(Ordering, Beside)> {
    let fuel = &state.scope.fuel;
    let t = Poly::power(state.scope.germ(), 1);
    let large = size(state, side.var);
    let mut out = Vec::new();
    let mut add = |sense, num: Option<Poly>, den: Option<Poly>, order| {
        let (Some(num), Some(den)) = (num, den) else { return };
        if let Some(end) = at_zero(state, limit, side, (&num, &den, order), steps) {
            out.push((sense, Beside { num, den, order, end }));
        }
    };
    let growing = large.mul(&t, fuel).ok();
    match limit.to {
        Target::Finite(_) => {
            for lead in leads.iter().chain([&Poly::one()]) {
                let falling = growing.as_ref().map(Poly::neg);
                add(Ordering::Greater, Some(Poly::default()), Some(lead.clone()), 0);
                add(Ordering::Less, Some(Poly::default()), Some(lead.clone()), 0);
                add(Ordering::Greater, falling, Some(lead.clone()), 0);
                add(Ordering::Less, growing.clone(), Some(lead.clone()), 0);
            }
        }
        Target::PlusInf => {
            leads.iter().for_each(|d| add(Ordering::Greater, Some(d.clone()), growing.clone(), 1));
        }
        Target::MinusInf => {
            leads.iter().for_each(|d| add(Ordering::Less, Some(d.neg()), growing.clone(), 1));
        }
    }
    out
}

/// 2·(1 + Σc²) for all constants c: more than each, and than its root.
fn size(state: &State<'_, '_>, x: usize) -> Poly {
    let constants = state.scope.mentioned.iter().filter(|v| state.is_constant(**v, x));
    let square = |v: &usize| Poly::term(vec![(*v, 2)], BigInt::one());
    constants.fold(Poly::one(), |sum, v| sum.add(&square(v))).scale(&2.into())
}

/// Coefficients of the highest and of the lowest power of x in what roots are taken of, as far as they are no numbers.
fn leads(state: &State<'_, '_>, x: usize) -> Vec<Poly> {
    let first = state.scope.context.vars.len();
    let mut out: Vec<Poly> = Vec::new();
    for root in first..state.scope.germ() {
        let Some(Expr::Sqrt(radicand)) = state.scope.root(root) else { continue };
        let Ok(pieces) = state.scope.pieces(radicand) else { continue };
        for value in pieces.into_iter().filter_map(|piece| piece.value) {
            let Ok(product) = value.num.mul(&value.den, &state.scope.fuel) else { continue };
            let coefficients = product.coefficients(x);
            let ends = [coefficients.last(), coefficients.iter().find(|c| !c.is_empty())];
            for lead in ends.into_iter().flatten() {
                let is_fit = lead.vars().iter().all(|v| state.is_constant(*v, x));
                if is_fit && !lead.is_constant() && product.degree(x) > 0 && !out.contains(lead) {
                    out.push(lead.clone());
                }
            }
        }
    }
    out
}
