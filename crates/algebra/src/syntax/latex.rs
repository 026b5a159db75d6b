//! LaTeX for math mode.

use kane_kernel::{Approach, Context, Expr, Limit, Rel, Relation, Target};
use num_rational::BigRational;
use num_traits::Signed;

use super::chain::{Hand, chained};
use super::logic::Logic;
use super::names::latex_name;
use super::number::{decimal, literal};
use super::parser::Level;
use super::plain::{let_name, level, var_name};

pub(crate) fn whole_expr(expr: &Expr, context: &Context) -> String {
    Writer { context, beyond: &|_| None }.expr(expr, Level::Sum)
}

/// An expression whose further symbols, which the context does not name, are set as `beyond` says.
#[must_use]
pub fn latex_with(
    expr: &Expr,
    context: &Context,
    beyond: &dyn Fn(usize) -> Option<String>,
) -> String {
    Writer { context, beyond }.expr(expr, Level::Sum)
}

/// Relations with commas between; those that share a side become a chain.
pub(crate) fn relations(relations: &[Relation], context: &Context) -> String {
    joined(relations, context, ",\\; ", false)
}

/// Relations with `between` them, in which `or` and its like may have to stand in parentheses.
fn joined(relations: &[Relation], context: &Context, between: &str, within: bool) -> String {
    let formula = |logic: &Logic<'_>| {
        let formula = formula(logic, context);
        if within { parentheses(&formula) } else { formula }
    };
    let hand = Hand { side: &|e| whole_expr(e, context), sign: comparison, formula: &formula };
    chained(relations, between, &hand)
}

/// A ∨ B, A ⇒ B, A ⇔ B
fn formula(logic: &Logic<'_>, context: &Context) -> String {
    let part = |relations: &[Relation]| joined(relations, context, " \\land ", true);
    logic.written(part, [" \\lor ", " \\Rightarrow ", " \\Leftrightarrow "])
}

/// `f \to L \text{ as } x \to a^{+}`
pub(crate) fn limit(limit: &Limit, context: &Context) -> String {
    let to = match &limit.to {
        Target::Finite(value) => whole_expr(value, context),
        Target::PlusInf => "\\infty".to_owned(),
        Target::MinusInf => "-\\infty".to_owned(),
    };
    let number = |a| whole_expr(&literal(a), context);
    let point = match &limit.at {
        Approach::To(a) => number(a),
        Approach::Above(a) => format!("{}^{{+}}", number(a)),
        Approach::Below(a) => format!("{}^{{-}}", number(a)),
        Approach::PlusInf => "\\infty".to_owned(),
        Approach::MinusInf => "-\\infty".to_owned(),
    };
    let x = latex_name(var_name(limit.var, context));
    tends(&whole_expr(&limit.expr, context), &to, &x, &point)
}

pub(super) fn tends(f: &str, to: &str, x: &str, point: &str) -> String {
    format!("{f} \\to {to} \\text{{ as }} {x} \\to {point}")
}

pub(super) fn comparison(rel: Rel) -> &'static str {
    match rel {
        Rel::Eq => "=",
        Rel::Ne => "\\ne",
        Rel::Lt => "<",
        Rel::Le => "\\le",
        Rel::Gt => ">",
        Rel::Ge => "\\ge",
    }
}

fn number(value: &BigRational) -> String {
    let sign = if value.is_negative() { "-" } else { "" };
    match decimal(value) {
        Some(digits) => format!("{sign}{digits}"),
        None => format!("{sign}\\frac{{{}}}{{{}}}", value.numer().magnitude(), value.denom()),
    }
}

/// Whether an exponent would seem to belong to the end of this base alone: to a prime, to what a Δ or
/// d stands before, or to the arguments of a function.
fn seems_shorter(base: &Expr, latex: &str) -> bool {
    let differential = |rest: &str| rest.starts_with(|c: char| c.is_ascii_uppercase());
    match base {
        Expr::Min(..) | Expr::Max(..) => true,
        Expr::Var(_) | Expr::Let(_) => {
            latex.ends_with('\'')
                || latex.starts_with("\\frac")
                || latex.starts_with("\\Delta ")
                || latex.strip_prefix('d').is_some_and(differential)
        }
        _ => false,
    }
}

/// Whether an expression, set with fractions, needs parentheses where an operand of at least `least` is
/// due. A fraction holds together by itself, but an exponent would seem to belong to its top; behind a
/// derivative it would seem to belong to what is differentiated.
pub(super) fn is_loose(e: &Expr, least: Level) -> bool {
    match e {
        Expr::Div(..) | Expr::Deriv(..) => least > Level::Power,
        _ => level(e) < least,
    }
}

/// What the next factor of a product stands behind.
pub(super) fn last_factor(product: &Expr) -> &Expr {
    match product {
        Expr::Mul(_, last) => last,
        only => only,
    }
}

/// Whether a symbol is a function of another.
pub(super) fn is_function(symbol: usize, context: &Context) -> bool {
    context.vars.get(symbol).is_some_and(|var| var.of.is_some())
}

/// What is as high as a line stands in plain parentheses: TeX and browsers set those that grow apart from what they
/// multiply.
pub(super) fn parentheses(inner: &str) -> String {
    let high = ["\\frac", "\\begin", "\\sqrt", "\\sum", "\\prod"];
    let is_high = high.iter().any(|high| inner.contains(high));
    if is_high { format!("\\left({inner}\\right)") } else { format!("({inner})") }
}

fn is_parenthesised(formula: &str) -> bool {
    formula.starts_with('(') || formula.starts_with("\\left(")
}

struct Writer<'a> {
    context: &'a Context,
    beyond: &'a dyn Fn(usize) -> Option<String>,
}

impl Writer<'_> {
    /// `e` where an operand of at least `least` is due.
    fn expr(&self, e: &Expr, least: Level) -> String {
        let bare = self.bare(e);
        if is_loose(e, least) { parentheses(&bare) } else { bare }
    }

    fn bare(&self, e: &Expr) -> String {
        match e {
            Expr::Num(value) => number(value),
            Expr::Var(index) => {
                (self.beyond)(*index).unwrap_or_else(|| latex_name(var_name(*index, self.context)))
            }
            Expr::Let(index) => latex_name(let_name(*index, self.context)),
            Expr::Neg(a) => format!("-{}", self.operand(a, Level::Product)),
            Expr::Add(a, b) => self.pair(a, "+", b),
            Expr::Sub(a, b) => self.pair(a, "-", b),
            Expr::Mul(a, b) => self.product(a, b),
            Expr::Div(a, b) => format!("\\frac{{{}}}{{{}}}", self.free(a), self.free(b)),
            Expr::Pow(a, exponent) => {
                let base = self.operand(a, Level::Atom);
                if seems_shorter(a, &base) {
                    format!("{}^{{{exponent}}}", parentheses(&base))
                } else {
                    format!("{base}^{{{exponent}}}")
                }
            }
            Expr::Abs(a) => format!("\\left|{}\\right|", self.free(a)),
            Expr::Sqrt(a) => format!("\\sqrt{{{}}}", self.free(a)),
            Expr::Min(a, b) => format!("\\min{}", self.arguments(a, b)),
            Expr::Max(a, b) => format!("\\max{}", self.arguments(a, b)),
            Expr::Deriv(f, x) => format!(
                "\\frac{{\\mathrm{{d}}}}{{\\mathrm{{d}}{}}}{}",
                latex_name(var_name(*x, self.context)),
                parentheses(&self.free(f))
            ),
            Expr::Cases(branches, otherwise) => self.cases(branches, otherwise.as_deref()),
        }
    }

    fn free(&self, e: &Expr) -> String {
        self.expr(e, Level::Sum)
    }

    fn arguments(&self, a: &Expr, b: &Expr) -> String {
        parentheses(&format!("{}, {}", self.free(a), self.free(b)))
    }

    fn pair(&self, a: &Expr, operator: &str, b: &Expr) -> String {
        format!("{} {operator} {}", self.operand(a, Level::Sum), self.operand(b, Level::Product))
    }

    /// A part of a larger expression. What follows `cases` would seem to belong to its last row.
    fn operand(&self, e: &Expr, least: Level) -> String {
        match e {
            Expr::Cases(..) => parentheses(&self.bare(e)),
            _ => self.expr(e, least),
        }
    }

    fn product(&self, a: &Expr, b: &Expr) -> String {
        let left = self.operand(a, Level::Product);
        let right = self.operand(b, Level::Power);
        let dot = match last_factor(a) {
            // what follows a derivative would seem to be differentiated, too
            Expr::Deriv(..) => true,
            // a function before parentheses would seem to be applied
            Expr::Var(v) if is_function(*v, self.context) && is_parenthesised(&right) => true,
            // juxtaposed digits would read as one number, words as one, a difference of E as the product Δ·E
            last => {
                right.starts_with(|c: char| c.is_ascii_digit())
                    || self.is_word(last)
                    || self.is_word(b)
                    || (right.starts_with("\\frac") && left.ends_with(|c: char| c.is_ascii_digit()))
                    || left.ends_with("\\Delta")
            }
        };
        format!("{left} {}{right}", if dot { "\\cdot " } else { "" })
    }

    /// Whether a symbol is set as a word of several letters.
    fn is_word(&self, e: &Expr) -> bool {
        matches!(e, Expr::Var(_) | Expr::Let(_)) && self.bare(e).starts_with("\\mathrm{")
    }

    fn cases(&self, branches: &[(Vec<Relation>, Expr)], otherwise: Option<&Expr>) -> String {
        let mut rows: Vec<String> = branches
            .iter()
            .map(|(guards, value)| {
                let guards = relations(guards, self.context);
                format!("{} & \\text{{if }} {guards}", self.free(value))
            })
            .collect();
        if let Some(value) = otherwise {
            rows.push(format!("{} & \\text{{otherwise}}", self.free(value)));
        }
        format!("\\begin{{cases}} {} \\end{{cases}}", rows.join(" \\\\ "))
    }
}
