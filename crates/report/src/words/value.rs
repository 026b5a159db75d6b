//! Values of witnesses: numbers, roots, functions.

use kane_audit::{Comparison, End, Value, expression};
use kane_kernel::{Context, Poly, Root, Target};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::One as _;

use super::formula::{Formulas, decimal};

/// A value.
pub(super) fn value(formulas: &Formulas, value: &Value) -> String {
    match value {
        Value::Number(q) => formulas.number(q),
        Value::Function(f) => formulas.expr(f),
        Value::Root(known) => root(formulas, known),
        Value::InRoot { coefficients, root: known } => {
            let common = coefficients.iter().fold(BigInt::one(), |l, q| l.lcm(q.denom()));
            let whole = |q: &BigRational| q.numer() * (&common / q.denom());
            let whole: Vec<BigInt> = coefficients.iter().map(whole).collect();
            let letter = Formulas::of_letter(formulas.form, "r");
            let text = letter.expr(&expression(&Poly::in_variable(0, &whole)));
            let scaled = match common.is_one() {
                true => text,
                false => format!("({text})/{}", letter.number(&common.into())),
            };
            let r = letter.compared(&letter.symbol(0), "=", &root(formulas, known));
            format!("{scaled} {} {r}", formulas.words("with"))
        }
    }
}

/// A root of a polynomial.
pub(super) fn root(formulas: &Formulas, root: &Root) -> String {
    if root.is_exact() {
        return formulas.number(&root.lo);
    }
    let letter = Formulas::of_letter(formulas.form, "x");
    let poly = letter.expr(&expression(&Poly::in_variable(0, &root.poly)));
    let (the, near) = (formulas.words("the root of"), formulas.words("near"));
    format!("{the} {poly} {near} {}", formulas.words(&decimal(&root.lo)))
}

/// Values of symbols, each as an equation.
pub(super) fn assigned(formulas: &Formulas, values: &[kane_audit::Assignment]) -> Vec<String> {
    let one = |given: &kane_audit::Assignment| {
        let shown = value(formulas, &given.value);
        formulas.compared(&formulas.symbol(given.symbol), "=", &shown)
    };
    values.iter().map(one).collect()
}

/// Both sides of a relation at a point, or why it has no meaning there.
pub(super) fn comparison(formulas: &Formulas, comparison: &Comparison) -> String {
    match comparison {
        Comparison::Sides(left, right) => {
            let shown = |side: &Result<BigRational, kane_algebra::syntax::NoValue>| match side {
                Ok(value) => formulas.number(value),
                Err(why) => formulas.words(&why.to_string()),
            };
            format!("left side {}, right side {}", shown(left), shown(right))
        }
        Comparison::Truth(true) => "it is true".to_owned(),
        Comparison::Truth(false) => "it is false".to_owned(),
        Comparison::Undefined(relation, why) => {
            let relation = formulas.relation(relation);
            format!("{relation} is undefined ({})", formulas.words(&why.to_string()))
        }
    }
}

/// How a claim fails for functions.
pub(super) fn end(formulas: &Formulas, end: &End) -> String {
    match end {
        End::Holds => "all hypotheses hold".to_owned(),
        End::At(_, None) => "it fails".to_owned(),
        End::At(v, Some(at)) => {
            let at = value(formulas, at);
            format!("it fails at {}", formulas.compared(&formulas.symbol(*v), "=", &at))
        }
        End::Limit(target) => {
            let target = match target {
                Target::Finite(value) => formulas.expr(value),
                Target::PlusInf => formulas.infinity(true),
                Target::MinusInf => formulas.infinity(false),
            };
            format!("the limit is {target}")
        }
    }
}

/// Formulas of a goal without a proof.
pub(super) fn plain_formulas(form: super::Form, context: &Context) -> Formulas {
    Formulas::new(form, context, &[])
}
