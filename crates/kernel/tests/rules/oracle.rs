//! What expressions are, worked out anew: values and derivatives at rational points, with nothing
//! of the kernel but the shape of an expression.

use kane_kernel::{Atom, Expr, Poly, Rel, Relation, Sentence, Sign};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::support::{Q, q};

/// The value of a polynomial.
pub(crate) fn value(p: &Poly, at: &dyn Fn(usize) -> Q) -> Q {
    let mut sum = Q::zero();
    for (m, c) in p.terms() {
        let mut product = Q::from_integer(c.clone());
        for (v, n) in m {
            for _ in 0..*n {
                product *= at(*v);
            }
        }
        sum += product;
    }
    sum
}

/// Whether a condition holds at a point.
pub(crate) fn satisfied(atom: &Atom, at: &dyn Fn(usize) -> Q) -> bool {
    let value = value(&atom.poly, at);
    match atom.sign {
        Sign::Zero => value.is_zero(),
        Sign::NonZero => !value.is_zero(),
        Sign::NonNegative => !value.is_negative(),
        Sign::Positive => value.is_positive(),
    }
}

/// Whether all conditions of a region hold at a point.
pub(crate) fn inside(region: &[Atom], at: &dyn Fn(usize) -> Q) -> bool {
    region.iter().all(|atom| satisfied(atom, at))
}

/// The root of a square; other numbers are not tried.
pub(crate) fn exact_root(a: &Q) -> Option<Q> {
    let whole = |n: &BigInt| {
        let root = n.sqrt();
        (&root * &root == *n).then_some(root)
    };
    if a.is_negative() {
        return None;
    }
    let root = whole(a.numer()).zip(whole(a.denom())).map(|(n, d)| Q::new(n, d));
    assert!(root.is_some(), "the tests take roots of squares, not of {a}");
    root
}

/// The beginning of a power series in the one variable that varies: value, slope, half the
/// curvature, …
type Series = Vec<Q>;

/// How many coefficients a series starts with; each derivative loses one.
const ORDER: usize = 8;

/// An expression at a point, and near it in the direction of x: `None` where it is undefined, or
/// is not one smooth expression although it varies.
pub(crate) fn series(e: &Expr, point: &[Q], x: Option<usize>) -> Option<Series> {
    let go = |e: &Expr| series(e, point, x);
    let constant = |c: Q| {
        let mut s = vec![Q::zero(); ORDER];
        s[0] = c;
        s
    };
    match e {
        Expr::Num(c) => Some(constant(c.clone())),
        Expr::Var(v) => {
            let mut s = constant(point[*v].clone());
            if x == Some(*v) {
                s[1] = Q::one();
            }
            Some(s)
        }
        Expr::Let(_) => None,
        Expr::Neg(a) => Some(go(a)?.into_iter().map(|c| -c).collect()),
        Expr::Add(a, b) => Some(go(a)?.into_iter().zip(go(b)?).map(|(a, b)| a + b).collect()),
        Expr::Sub(a, b) => Some(go(a)?.into_iter().zip(go(b)?).map(|(a, b)| a - b).collect()),
        Expr::Mul(a, b) => Some(product(&go(a)?, &go(b)?)),
        Expr::Div(a, b) => quotient(&go(a)?, &go(b)?),
        Expr::Pow(a, n) => {
            let a = go(a)?;
            let one = constant(Q::one());
            let power = (0..n.unsigned_abs()).fold(one.clone(), |p, _| product(&p, &a));
            if *n < 0 { quotient(&one, &power) } else { Some(power) }
        }
        Expr::Sqrt(a) => {
            let a = go(a)?;
            let mut s = vec![exact_root(&a[0])?];
            if a[0].is_zero() {
                // A root that varies is not smooth at zero.
                return a.iter().all(Zero::is_zero).then_some(a);
            }
            for n in 1..a.len() {
                let cross: Q = (1..n).map(|i| &s[i] * &s[n - i]).sum();
                s.push((&a[n] - cross) / (q(2, 1) * &s[0]));
            }
            Some(s)
        }
        Expr::Abs(a) => {
            let a = go(a)?;
            let flips = first_sign(&a[..1]) < 0;
            smooth(&a, x)?;
            Some(if flips { a.into_iter().map(|c| -c).collect() } else { a })
        }
        Expr::Min(a, b) | Expr::Max(a, b) => {
            let (a, b) = (go(a)?, go(b)?);
            let gap: Series = a.iter().zip(&b).map(|(a, b)| a - b).collect();
            smooth(&gap, x)?;
            let first = (first_sign(&gap[..1]) <= 0) == matches!(e, Expr::Min(..));
            Some(if first { a } else { b })
        }
        Expr::Deriv(f, by) => {
            let f = series(f, point, Some(*by))?;
            // Derivatives by two symbols are tested by hand.
            assert!(x.is_none_or(|x| x == *by), "one direction at a time");
            let slope = (1..f.len()).map(|n| &f[n] * q(i64::try_from(n).ok().unwrap_or(0), 1));
            let mut slope: Series = slope.collect();
            slope.resize(if x.is_some() { slope.len() } else { ORDER }, Q::zero());
            Some(slope)
        }
        Expr::Cases(branches, otherwise) => {
            for (guards, body) in branches {
                if all(guards, point, x)? {
                    return go(body);
                }
            }
            go(otherwise.as_ref()?)
        }
    }
}

/// Nothing, if a series changes its sign at the point.
fn smooth(gap: &Series, x: Option<usize>) -> Option<()> {
    (x.is_none() || !gap[0].is_zero() || gap.iter().all(Zero::is_zero)).then_some(())
}

fn first_sign(s: &[Q]) -> i8 {
    i8::from(s[0].is_positive()) - i8::from(s[0].is_negative())
}

fn product(a: &Series, b: &Series) -> Series {
    let coefficient = |n: usize| (0..=n).map(|i| &a[i] * &b[n - i]).sum();
    (0..a.len().min(b.len())).map(coefficient).collect()
}

fn quotient(a: &Series, b: &Series) -> Option<Series> {
    let mut out: Series = Vec::new();
    for n in 0..a.len().min(b.len()) {
        let known: Q = (0..n).map(|i| &out[i] * &b[n - i]).sum();
        out.push((&a[n] - known) / (!b[0].is_zero()).then(|| b[0].clone())?);
    }
    Some(out)
}

/// The truth of relations, read left to right; `None` where the first that is not true is undefined.
pub(crate) fn all(relations: &[Relation], point: &[Q], x: Option<usize>) -> Option<bool> {
    for r in relations {
        let (a, b) = (series(&r.lhs, point, x)?, series(&r.rhs, point, x)?);
        let gap: Series = a.iter().zip(&b).map(|(a, b)| a - b).collect();
        smooth(&gap, x)?;
        let wanted: &[i8] = match r.rel {
            Rel::Eq => &[0],
            Rel::Ne => &[-1, 1],
            Rel::Lt => &[-1],
            Rel::Le => &[-1, 0],
            Rel::Gt => &[1],
            Rel::Ge => &[0, 1],
        };
        let holds = wanted.contains(&first_sign(&gap[..1]));
        if !holds {
            return Some(false);
        }
    }
    Some(true)
}

/// Whether a premise holds at a point.
pub(crate) fn premise(s: &Sentence, given: bool, point: &[Q]) -> bool {
    if all(&s.when, point, None) != Some(true) {
        return true;
    }
    let relations: Vec<Relation> = s.relations().cloned().collect();
    all(&relations, point, None).unwrap_or(!given)
}
