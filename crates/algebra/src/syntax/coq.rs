//! Terms of Coq over its real numbers.

use kane_kernel::{Expr, Rel, Relation};
use num_rational::BigRational;
use num_traits::{One, Signed};

/// How tightly an operator of Coq's `R_scope` binds what stands beside it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Sign,
    Power,
    Argument,
}

/// An expression without definitions as a term of type `R`, with names for its symbols. Branches
/// become `if … then … else …`, what is undefined everywhere 0: where it is defined is another
/// question.
#[must_use]
pub fn coq(e: &Expr, name: &dyn Fn(usize) -> String) -> String {
    term(e, name, Level::Sum)
}

/// A comparison as a proposition of Coq.
#[must_use]
pub fn coq_relation(r: &Relation, name: &dyn Fn(usize) -> String) -> String {
    format!("{} {} {}", coq(&r.lhs, name), sign(r.rel), coq(&r.rhs, name))
}

fn sign(rel: Rel) -> &'static str {
    match rel {
        Rel::Eq => "=",
        Rel::Ne => "<>",
        Rel::Lt => "<",
        Rel::Le => "<=",
        Rel::Gt => ">",
        Rel::Ge => ">=",
    }
}

fn term(e: &Expr, name: &dyn Fn(usize) -> String, least: Level) -> String {
    let at = |e: &Expr, least| term(e, name, least);
    let pair = |a: &Expr, operator: &str, b: &Expr, left, right| {
        format!("{} {operator} {}", at(a, left), at(b, right))
    };
    let call = |f: &str, parts: &[&Expr]| {
        let parts: Vec<String> = parts.iter().map(|e| at(e, Level::Argument)).collect();
        format!("{f} {}", parts.join(" "))
    };
    let (text, level) = match e {
        Expr::Num(q) => number(q),
        Expr::Var(v) => {
            let text = name(*v);
            let level = if text.contains(' ') { Level::Power } else { Level::Argument };
            (text, level)
        }
        Expr::Neg(a) => (format!("- {}", at(a, Level::Power)), Level::Sign),
        Expr::Add(a, b) => (pair(a, "+", b, Level::Sum, Level::Product), Level::Sum),
        Expr::Sub(a, b) => (pair(a, "-", b, Level::Sum, Level::Product), Level::Sum),
        Expr::Mul(a, b) => (pair(a, "*", b, Level::Product, Level::Sign), Level::Product),
        Expr::Div(a, b) => (pair(a, "/", b, Level::Product, Level::Sign), Level::Product),
        Expr::Pow(a, n) if *n < 0 => {
            let below = Expr::Pow(a.clone(), n.saturating_neg());
            (format!("1 / {}", at(&below, Level::Sign)), Level::Product)
        }
        Expr::Pow(a, n) => (format!("{} ^ {n}", at(a, Level::Argument)), Level::Power),
        Expr::Abs(a) => (call("Rabs", &[a]), Level::Power),
        Expr::Sqrt(a) => (call("sqrt", &[a]), Level::Power),
        Expr::Min(a, b) => (call("Rmin", &[a, b]), Level::Power),
        Expr::Max(a, b) => (call("Rmax", &[a, b]), Level::Power),
        Expr::Cases(branches, otherwise) => {
            let last = otherwise.as_ref().map_or_else(|| "0".to_owned(), |e| at(e, Level::Sum));
            let text = branches.iter().rev().fold(last, |rest, (guards, body)| {
                let body = at(body, Level::Sum);
                guards.iter().rev().fold(body, |then, g| choice(g, name, &then, &rest))
            });
            (text, Level::Sum)
        }
        Expr::Let(_) | Expr::Deriv(..) => ("0".to_owned(), Level::Argument),
    };
    let open = matches!(e, Expr::Cases(..)) || level < least;
    if open { format!("({text})") } else { text }
}

fn choice(g: &Relation, name: &dyn Fn(usize) -> String, then: &str, rest: &str) -> String {
    let (decide, then, rest) = match g.rel {
        Rel::Eq => ("Req_EM_T", then, rest),
        Rel::Ne => ("Req_EM_T", rest, then),
        Rel::Lt => ("Rlt_dec", then, rest),
        Rel::Le => ("Rle_dec", then, rest),
        Rel::Gt => ("Rgt_dec", then, rest),
        Rel::Ge => ("Rge_dec", then, rest),
    };
    let (a, b) = (term(&g.lhs, name, Level::Argument), term(&g.rhs, name, Level::Argument));
    format!("if {decide} {a} {b} then {then} else {rest}")
}

fn number(q: &BigRational) -> (String, Level) {
    match (q.is_negative(), q.denom().is_one()) {
        (false, true) => (q.numer().to_string(), Level::Argument),
        (true, true) => (q.numer().to_string(), Level::Sign),
        (_, false) => (format!("{} / {}", q.numer(), q.denom()), Level::Product),
    }
}
