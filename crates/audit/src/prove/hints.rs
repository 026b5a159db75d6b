//! Hints: expressions that the author of a claim says to use. Their squares and their products with
//! premises are summands of a contradiction, and their signs tell cases. They are never believed:
//! what is made of them is a proof like any other.

use kane_algebra::syntax::rebuild;
use kane_kernel::{Context, Expr, Fuel, Poly, Scope, Sign, State};

use super::combination::{Multiple, Size, Summand, combined, summand};
use super::elimination::{Elimination, Factors, open_vars};
use crate::argument::Argument;

/// Columns of the linear program.
const COLUMNS: usize = 900;
/// Rows of the linear program.
const ROWS: usize = 300;
/// Pivots of the linear program.
const PIVOTS: usize = 400;
/// Definitions that the expansion of one hint may open.
const OPENED: usize = 10_000;

/// A hint as a product of powers of polynomials, up to a constant factor.
#[derive(Clone, Debug)]
pub(crate) struct Hint {
    factors: Vec<(Poly, u32)>,
}

/// An expression with its definitions written out; `None` if that gets too long.
pub(crate) fn expanded(e: &Expr, context: &Context) -> Option<Expr> {
    let mut left = OPENED;
    written_out(e, context, &mut left).ok()
}

fn written_out(e: &Expr, context: &Context, left: &mut usize) -> Result<Expr, ()> {
    rebuild(e, &mut |part| {
        *left = left.checked_sub(1).ok_or(())?;
        match part {
            Expr::Let(i) => {
                let body = &context.lets.get(*i).ok_or(())?.body;
                written_out(body, context, left).map(Some)
            }
            _ => Ok(None),
        }
    })
}

impl Hint {
    /// The hints in the variables of a scope. What has no normal form there, as a root that nothing
    /// else names, is left out.
    pub(crate) fn all(scope: &Scope<'_>, using: &[Expr]) -> Vec<Self> {
        using.iter().filter_map(|e| Self::of(scope, e)).collect()
    }

    fn of(scope: &Scope<'_>, e: &Expr) -> Option<Self> {
        let mut factors = Vec::new();
        collect(scope, e, 1, &mut factors)?;
        factors.retain(|(p, _)| !p.is_constant());
        (!factors.is_empty()).then_some(Self { factors })
    }

    /// The hint after eliminations.
    pub(crate) fn after(&self, trail: &[Elimination], fuel: &Fuel) -> Option<Self> {
        let mut factors = self.factors.clone();
        for step in trail {
            let equation = step.d.mul(&Poly::var(step.var), fuel).ok()?.add(&step.e);
            for (p, _) in &mut factors {
                *p = p.remainder(step.var, &equation, false, fuel).ok()?.primitive().1;
            }
        }
        factors.retain(|(p, _)| !p.is_constant());
        (!factors.is_empty()).then_some(Self { factors })
    }

    /// The polynomials whose signs tell cases.
    pub(crate) fn bases(&self) -> impl Iterator<Item = &Poly> {
        self.factors.iter().map(|f| &f.0)
    }

    /// The hint as one polynomial.
    fn product(&self, fuel: &Fuel) -> Option<Poly> {
        power(&self.factors, fuel)
    }

    /// The hint as square² · Π atoms, if its odd factors are atoms.
    pub(super) fn as_term(&self, state: &State<'_, '_>) -> Option<(Poly, Factors)> {
        let (mut halves, mut known) = (Vec::new(), Factors::new());
        for (p, n) in &self.factors {
            halves.push((p.clone(), n / 2));
            if n % 2 == 1 {
                let is_it = |i: &usize| {
                    let a = &state.atoms[*i];
                    a.sign.is_order() && a.poly.primitive().1 == *p
                };
                let i = (0..state.atoms.len()).find(is_it)?;
                match known.iter_mut().find(|k| k.0 == i) {
                    Some(k) => k.1 += 1,
                    None => known.push((i, 1)),
                }
            }
        }
        known.sort_unstable();
        Some((power(&halves, &state.scope.fuel)?, known))
    }
}

/// Π pⁿ
fn power(factors: &[(Poly, u32)], fuel: &Fuel) -> Option<Poly> {
    factors.iter().try_fold(Poly::one(), |q, (p, n)| q.mul(&p.pow(*n, fuel).ok()?, fuel).ok())
}

/// The factors of eⁿ. A quotient has the sign of the product of its parts, and cases count as their
/// first one that has a value.
fn collect(scope: &Scope<'_>, e: &Expr, n: u32, out: &mut Vec<(Poly, u32)>) -> Option<()> {
    match e {
        Expr::Neg(a) => collect(scope, a, n, out),
        Expr::Mul(a, b) | Expr::Div(a, b) => {
            collect(scope, a, n, out)?;
            collect(scope, b, n, out)
        }
        Expr::Pow(a, k) if *k > 0 => {
            collect(scope, a, n.checked_mul(u32::try_from(*k).ok()?)?, out)
        }
        _ => {
            let value = scope.pieces(e).ok()?.into_iter().find_map(|piece| piece.value)?;
            let mut add = |p: &Poly| {
                let p = p.primitive().1;
                match out.iter_mut().find(|f| f.0 == p || f.0 == p.neg()) {
                    Some(known) => known.1 += n,
                    None => out.push((p, n)),
                }
            };
            add(&value.num);
            add(&value.den);
            Some(())
        }
    }
}

/// How many summands are made of hints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wealth {
    /// the hints as they are, and the atoms
    Few,
    /// squares of the hints, of their factors and of their sums, and all these times up to two atoms
    Many,
}

/// A combination of hints and atoms that sums to zero (Farkas 1902).
pub(crate) fn hinted(state: &State<'_, '_>, hints: &[Hint], wealth: Wealth) -> Option<Argument> {
    let fuel = &state.scope.fuel;
    let live = |sign: fn(Sign) -> bool| -> Vec<usize> {
        let all = 0..state.atoms.len();
        all.filter(|&i| sign(state.atoms[i].sign) && state.atoms[i].decided().is_none()).collect()
    };
    let (ordered, equations) = (live(Sign::is_order), live(|s| s == Sign::Zero));
    let products: Vec<Poly> = hints.iter().filter_map(|h| h.product(fuel)).collect();
    let mut named: Vec<(Poly, Factors)> = vec![(Poly::one(), Vec::new())];
    named.extend(hints.iter().filter_map(|h| h.as_term(state)));
    let mut bases: Vec<Poly> = products.clone();
    let many = wealth == Wealth::Many;
    if many {
        bases.extend(hints.iter().flat_map(|h| h.bases().cloned()));
    }
    for (i, p) in products.iter().enumerate().filter(|_| many) {
        bases.extend(products[..i].iter().flat_map(|q| [p.add(q), p.sub(q)]));
    }
    let mut seen: Vec<Poly> = Vec::new();
    for p in bases {
        if !seen.contains(&p) {
            named.push((p.clone(), Vec::new()));
            seen.push(p);
        }
    }
    let mut known: Vec<Factors> = vec![Vec::new()];
    known.extend(ordered.iter().map(|&i| vec![(i, 1)]));
    known.extend(live(|s| s == Sign::NonZero).iter().map(|&i| vec![(i, 2)]));
    if many && named.len() * ordered.len() * ordered.len() <= 2 * COLUMNS {
        for (n, &i) in ordered.iter().enumerate() {
            known.push(vec![(i, 2)]);
            known.extend(ordered[n + 1..].iter().map(|&j| vec![(i, 1), (j, 1)]));
        }
    }
    let mut columns: Vec<Summand> = Vec::new();
    for (square, own) in &named {
        for factors in &known {
            // A hint as it is stands alone, an atom too.
            let alone = factors.is_empty() || (own.is_empty() && square.is_constant());
            if !many && !alone {
                continue;
            }
            let mut factors: Factors = [&own[..], &factors[..]].concat();
            factors.sort_unstable();
            factors.dedup_by(|b, a| {
                let same = a.0 == b.0;
                a.1 += if same { b.1 } else { 0 };
                same
            });
            columns.push(summand(state, square.clone(), factors)?);
        }
    }
    let mut multiples: Vec<Multiple> = Vec::new();
    let vars = open_vars(state);
    let simple = std::iter::once(Poly::one()).chain(vars.into_iter().map(Poly::var));
    let mut cofactors: Vec<Poly> = simple.collect();
    cofactors.extend(products.iter().cloned());
    for &i in &equations {
        for by in &cofactors {
            let multiple = by.mul(&state.atoms[i].poly, fuel).ok()?;
            multiples.push((i, by.clone(), multiple.clone()));
            multiples.push((i, by.neg(), multiple.neg()));
        }
    }
    combined(state, columns, multiples, &Size { rows: ROWS, columns: COLUMNS, pivots: PIVOTS })
}

/// Whether an atom tells the sign of a primitive polynomial.
pub(super) fn is_told(state: &State<'_, '_>, p: &Poly) -> bool {
    state.atoms.iter().any(|a| {
        let q = a.poly.primitive().1;
        a.sign != Sign::NonNegative && a.sign != Sign::NonZero && (q == *p || q == p.neg())
    })
}

/// The first polynomial of a hint whose sign no atom tells.
pub(crate) fn untold(state: &State<'_, '_>, hints: &[Hint]) -> Option<Poly> {
    hints.iter().flat_map(Hint::bases).find(|p| !is_told(state, p)).cloned()
}
