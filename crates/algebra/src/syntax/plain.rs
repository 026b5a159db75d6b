//! Plain text that reads back as the same syntax.

use std::fmt::Write;

use kane_kernel::{Approach, Context, Expr, Limit, Rel, Relation, Target};
use num_rational::BigRational;
use num_traits::Signed;

use super::chain::{Hand, chained};
use super::logic::Logic;
use super::number::decimal;
use super::parser::Level;

/// An expression.
pub(super) fn whole_expr(e: &Expr, context: &Context) -> String {
    let mut out = String::new();
    expr(&mut out, e, context, Level::Sum);
    out
}

/// Relations with commas between; those that share a side become a chain.
pub(super) fn chain(relations: &[Relation], context: &Context) -> String {
    joined(relations, context, ", ", false)
}

/// Relations with `between` them, in which `or` and its like may have to stand in parentheses.
fn joined(relations: &[Relation], context: &Context, between: &str, within: bool) -> String {
    let formula = |logic: &Logic<'_>| {
        let formula = formula(logic, context);
        if within { format!("({formula})") } else { formula }
    };
    let hand = Hand { side: &|e| whole_expr(e, context), sign: comparison, formula: &formula };
    chained(relations, between, &hand)
}

/// `A or B`, `A implies B`, `A iff B`
fn formula(logic: &Logic<'_>, context: &Context) -> String {
    let part = |relations: &[Relation]| joined(relations, context, " and ", true);
    logic.written(part, [" or ", " implies ", " iff "])
}

/// A comparison as it is typed.
#[must_use]
pub fn comparison(rel: Rel) -> &'static str {
    match rel {
        Rel::Eq => "=",
        Rel::Ne => "!=",
        Rel::Lt => "<",
        Rel::Le => "<=",
        Rel::Gt => ">",
        Rel::Ge => ">=",
    }
}

pub(super) fn tends(limit: &Limit, context: &Context) -> String {
    let to = match &limit.to {
        Target::Finite(value) => whole_expr(value, context),
        Target::PlusInf => "oo".to_owned(),
        Target::MinusInf => "-oo".to_owned(),
    };
    format!("{} -> {to}", whole_expr(&limit.expr, context))
}

pub(super) fn motion(limit: &Limit, context: &Context) -> String {
    moving(limit.var, &limit.at, context)
}

/// How a limit variable moves: `x -> 0+`.
#[must_use]
pub fn moving(var: usize, at: &Approach, context: &Context) -> String {
    let point = match at {
        Approach::To(a) => a.to_string(),
        Approach::Above(a) => format!("{a}+"),
        Approach::Below(a) => format!("{a}-"),
        Approach::PlusInf => "oo".to_owned(),
        Approach::MinusInf => "-oo".to_owned(),
    };
    format!("{} -> {point}", var_name(var, context))
}

pub(crate) fn var_name(index: usize, context: &Context) -> &str {
    context.vars.get(index).map_or("?", |var| &var.name)
}

pub(crate) fn let_name(index: usize, context: &Context) -> &str {
    context.lets.get(index).map_or("?", |definition| &definition.name)
}

/// The loosest operator of what is printed for this expression.
pub(crate) fn level(expr: &Expr) -> Level {
    match expr {
        Expr::Add(..) | Expr::Sub(..) | Expr::Neg(_) => Level::Sum,
        Expr::Num(value) if value.is_negative() => Level::Sum,
        Expr::Num(value) if decimal(value).is_none() => Level::Product,
        Expr::Mul(..) | Expr::Div(..) => Level::Product,
        Expr::Pow(..) => Level::Power,
        _ => Level::Atom,
    }
}

/// Writes `e` where an operand of at least `least` is due. A sum is due only at the head of a
/// sum, so a sign never ends up inside one.
fn expr(out: &mut String, e: &Expr, context: &Context, least: Level) {
    if level(e) < least {
        out.push('(');
        bare(out, e, context);
        out.push(')');
    } else {
        bare(out, e, context);
    }
}

fn bare(out: &mut String, e: &Expr, context: &Context) {
    let pair = |out: &mut String, a: &Expr, operator: &str, b: &Expr, left, right| {
        expr(out, a, context, left);
        out.push_str(operator);
        expr(out, b, context, right);
    };
    let call = |out: &mut String, name: &str, arguments: &[&Expr]| {
        out.push_str(name);
        for (i, argument) in arguments.iter().enumerate() {
            out.push_str(if i == 0 { "(" } else { ", " });
            expr(out, argument, context, Level::Sum);
        }
        out.push(')');
    };
    match e {
        Expr::Num(value) => number(out, value),
        Expr::Var(index) => out.push_str(var_name(*index, context)),
        Expr::Let(index) => out.push_str(let_name(*index, context)),
        Expr::Neg(a) => {
            out.push('-');
            expr(out, a, context, Level::Product);
        }
        Expr::Add(a, b) => pair(out, a, " + ", b, Level::Sum, Level::Product),
        Expr::Sub(a, b) => pair(out, a, " - ", b, Level::Sum, Level::Product),
        Expr::Mul(a, b) => pair(out, a, "*", b, Level::Product, Level::Power),
        Expr::Div(a, b) => pair(out, a, "/", b, Level::Product, Level::Power),
        Expr::Pow(a, exponent) => {
            expr(out, a, context, Level::Atom);
            write_infallibly(out, format_args!("^{exponent}"));
        }
        Expr::Abs(a) => call(out, "abs", &[a]),
        Expr::Sqrt(a) => call(out, "sqrt", &[a]),
        Expr::Min(a, b) => call(out, "min", &[a, b]),
        Expr::Max(a, b) => call(out, "max", &[a, b]),
        Expr::Deriv(f, x) => call(out, "d", &[f, &Expr::Var(*x)]),
        Expr::Cases(branches, otherwise) => {
            out.push_str("cases { ");
            for (i, (guards, value)) in branches.iter().enumerate() {
                if i > 0 {
                    out.push_str("; ");
                }
                out.push_str(&chain(guards, context));
                out.push_str(": ");
                expr(out, value, context, Level::Sum);
            }
            if let Some(value) = otherwise {
                out.push_str(if branches.is_empty() { "else: " } else { "; else: " });
                expr(out, value, context, Level::Sum);
            }
            out.push_str(" }");
        }
    }
}

fn number(out: &mut String, value: &BigRational) {
    if value.is_negative() {
        out.push('-');
    }
    match decimal(value) {
        Some(digits) => out.push_str(&digits),
        None => {
            write_infallibly(out, format_args!("{}/{}", value.numer().magnitude(), value.denom()))
        }
    }
}

fn write_infallibly(out: &mut String, arguments: std::fmt::Arguments<'_>) {
    out.write_fmt(arguments).expect("a string takes every write");
}
