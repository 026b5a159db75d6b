//! Names of variables, and formulas and numbers as they are told.

use kane_algebra::syntax::Notation;
use kane_kernel::{Goal, Poly, Root, Scope, Side, premised};
use num_rational::BigRational;
use num_traits::{Signed, Zero};

use crate::prove::expression;

type Q = BigRational;

/// A variable of a scope: a symbol, a root, t, or what has a limit.
pub(super) fn name(goal: &Goal, scope: &Scope<'_>, v: usize) -> String {
    if let Some(var) = goal.context.vars.get(v) {
        return var.name.clone();
    }
    if let Some(root) = scope.root(v) {
        return root.plain(&goal.context);
    }
    match v.checked_sub(scope.germ() + 1) {
        None => "t".to_string(),
        Some(i) => match premised(goal).nth(i) {
            Some((_, l)) => format!("[{}]", l.expr.plain(&goal.context)),
            None => format!("z{i}"),
        },
    }
}

/// A polynomial in the variables of a scope.
pub(super) fn poly(goal: &Goal, scope: &Scope<'_>, p: &Poly) -> String {
    if p.len() > 40 {
        return format!("(a polynomial with {} terms)", p.len());
    }
    let top = p.vars().last().map_or(0, |v| v + 1);
    let mut context = kane_kernel::Context::default();
    for v in 0..top {
        context.vars.push(kane_kernel::Var {
            name: name(goal, scope, v),
            of: None,
            lower: None,
            upper: None,
        });
    }
    expression(p).plain(&context)
}

/// A quotient of polynomials.
pub(super) fn ratio(goal: &Goal, scope: &Scope<'_>, num: &Poly, den: &Poly) -> String {
    let (num, den) = (poly(goal, scope, num), poly(goal, scope, den));
    if den == "1" { num } else { format!("({num})/({den})") }
}

/// A side of a limit as a substitution for its variable.
pub(super) fn side(goal: &Goal, side: &Side) -> String {
    let x = &goal.context.vars[side.var].name;
    match (&side.at, side.above) {
        (None, true) => format!("{x} = 1/t"),
        (None, false) => format!("{x} = -1/t"),
        (Some(a), true) if a.is_zero() => format!("{x} = t"),
        (Some(a), false) if a.is_zero() => format!("{x} = -t"),
        (Some(a), true) => format!("{x} = {a} + t"),
        (Some(a), false) => format!("{x} = {a} - t"),
    }
}

/// A context with one symbol.
pub(super) fn single(name: &str) -> kane_kernel::Context {
    let var = kane_kernel::Var { name: name.to_string(), of: None, lower: None, upper: None };
    kane_kernel::Context { vars: vec![var], ..kane_kernel::Context::default() }
}

/// A root of a polynomial.
pub(super) fn root_text(root: &Root) -> String {
    if root.is_exact() {
        return short(&root.lo);
    }
    let p = Poly::in_variable(0, &root.poly);
    let text = expression(&p).plain(&single("x"));
    let mut tight = root.clone();
    for _ in 0..40 {
        if !tight.is_exact() {
            kane_algebra::sign_table::refine(&mut tight);
        }
    }
    format!("the root of {text} near {}", decimal(&tight.lo))
}

/// Four digits after the point, rounded down.
fn decimal(q: &Q) -> String {
    let scaled = (q * Q::from_integer(10_000.into())).floor().to_integer();
    let sign = if scaled.is_negative() { "-" } else { "" };
    let size = scaled.abs();
    let (whole, rest) = (&size / 10_000, &size % 10_000);
    format!("{sign}{whole}.{rest:0>4}")
}

/// A rational number; very long ones by their size.
pub(super) fn short(q: &Q) -> String {
    let text = q.to_string();
    if text.len() > 80 { format!("about {}", decimal(q)) } else { text }
}
