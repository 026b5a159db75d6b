//! How polynomials of one proof are written: as sums or products, whichever is shorter, and names for long ones.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use kane_algebra::factors::factors;
use kane_algebra::rational_function::{signed_sum, term, with_a_positive_first};
use kane_algebra::syntax::{Notation as _, literal};
use kane_kernel::{Context, Expr, Poly, Power};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Signed as _};

/// Letters for names, of which the first is taken that begins no symbol followed by `_`.
const LETTERS: [&str; 6] = ["P", "Q", "F", "G", "K", "poly"];

/// Shapes and names, shared by all formulas of one proof; without any, polynomials are written out as sums.
#[derive(Clone, Debug, Default)]
pub(super) struct Shapes(Option<Rc<RefCell<Known>>>);

#[derive(Debug, Default)]
struct Known {
    shapes: HashMap<Poly, (Expr, usize)>,
    names: Vec<Poly>,
}

impl Shapes {
    /// Shapes and names for one proof.
    pub(super) fn for_proof() -> Self {
        Self(Some(Rc::default()))
    }

    /// Whether long polynomials have names.
    pub(super) fn are_named(&self) -> bool {
        self.0.is_some()
    }

    /// A polynomial as it is written, and how many letters of text that takes.
    pub(super) fn shaped(&self, p: &Poly, context: &Context) -> (Expr, usize) {
        let known = self.0.as_ref().and_then(|known| known.borrow().shapes.get(p).cloned());
        if let Some(known) = known {
            return known;
        }
        let shape = shortest(p, context);
        if let Some(known) = &self.0 {
            known.borrow_mut().shapes.insert(p.clone(), shape.clone());
        }
        shape
    }

    /// The number of a polynomial's name.
    pub(super) fn name(&self, p: &Poly) -> usize {
        let Some(known) = &self.0 else { return 0 };
        let names = &mut known.borrow_mut().names;
        names.iter().position(|named| named == p).unwrap_or_else(|| {
            names.push(p.clone());
            names.len() - 1
        })
    }

    /// A name as it is written: no symbol of the goal begins so.
    pub(super) fn written(&self, number: usize, context: &Context) -> String {
        let names = || {
            let lets = context.lets.iter().map(|definition| &definition.name);
            context.vars.iter().map(|var| &var.name).chain(lets)
        };
        let is_free = |letter: &&&str| !names().any(|name| name.starts_with(&format!("{letter}_")));
        let letter = LETTERS.iter().find(is_free).unwrap_or(&"named");
        format!("{letter}_{}", number + 1)
    }

    /// The polynomials that have names, in order.
    pub(super) fn all(&self) -> Vec<Poly> {
        self.0.as_ref().map(|known| known.borrow().names.clone()).unwrap_or_default()
    }
}

/// The sum or the product, whichever has fewer letters.
fn shortest(p: &Poly, context: &Context) -> (Expr, usize) {
    let length = |e: &Expr| e.plain(context).chars().count();
    let sum = sum(p);
    let letters = length(&sum);
    if p.len() < 2 {
        return (sum, letters);
    }
    let product = product(p);
    match length(&product) {
        fewer if fewer < letters => (product, fewer),
        _ => (sum, letters),
    }
}

/// A polynomial as a sum that begins with a positive term, if there is one.
pub(super) fn sum(p: &Poly) -> Expr {
    let signed = |(m, c): (&[Power], &BigInt)| (term(m, c, &Expr::Var), c.is_negative());
    signed_sum(with_a_positive_first(p.terms().map(signed).collect()))
}

/// A polynomial as the product of its factors.
fn product(p: &Poly) -> Expr {
    let (c, factors) = factors(p);
    let power = |(f, n): &(Poly, u32)| match i32::try_from(*n) {
        Ok(1) => sum(f),
        Ok(n) => Expr::Pow(sum(f).into(), n),
        Err(_) => Expr::Pow(sum(f).into(), i32::MAX),
    };
    let size = c.abs();
    let first = (!size.is_one()).then(|| literal(&BigRational::from(size)));
    let all = first.into_iter().chain(factors.iter().map(power));
    let product = all.reduce(|a, b| Expr::Mul(a.into(), b.into()));
    let product = product.unwrap_or_else(|| Expr::int(1));
    if c.is_negative() { Expr::Neg(product.into()) } else { product }
}
