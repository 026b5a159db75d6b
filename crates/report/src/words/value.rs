//! Values of witnesses: numbers, roots, functions.

use kane_algebra::syntax::NoValue;
use kane_audit::{Comparison, End, Measured, Value, expression};
use kane_kernel::{Context, Expr, Poly, Relation, Root, Target};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_rational::BigRational;
use num_traits::{One as _, Zero as _};

use super::decimal::{apart, decimal};
use super::formula::Formulas;

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
            let letter =
                Formulas::of_letter(formulas.form, formulas.unused_letter(&["r", "q", "w"]));
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
    let letter = Formulas::of_letter(formulas.form, formulas.unused_letter(&["x", "z", "y"]));
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

/// Letters of a value that is told in a sentence as it is; of a longer one its decimals are.
const MOST_LETTERS: usize = 40;

/// The same in a sentence: of long values the decimals, which the point gives exactly.
pub(super) fn assigned_briefly(
    formulas: &Formulas,
    values: &[kane_audit::Assignment],
) -> Vec<String> {
    let one = |given: &kane_audit::Assignment| {
        let long = letters(&given.value) > MOST_LETTERS;
        let near = if long { decimals(&given.value) } else { None };
        match near {
            Some(near) => {
                let (symbol, near) = (formulas.symbol(given.symbol), format!("near {near}"));
                format!("{symbol} {}", formulas.words(&near))
            }
            None => formulas.compared(
                &formulas.symbol(given.symbol),
                "=",
                &value(formulas, &given.value),
            ),
        }
    };
    values.iter().map(one).collect()
}

/// How many letters a value takes, about.
fn letters(value: &Value) -> usize {
    let rationals =
        |all: &[BigRational]| all.iter().map(|q| q.to_string().len() + 3).sum::<usize>();
    let root = |root: &Root| root.poly.iter().map(|c| c.to_string().len() + 4).sum::<usize>();
    match value {
        Value::Number(q) => q.to_string().len(),
        Value::Root(known) => root(known),
        Value::InRoot { coefficients, root: known } => rationals(coefficients) + root(known),
        Value::Function(_) => 0,
    }
}

/// The decimals of a number, where they are known.
fn decimals(value: &Value) -> Option<String> {
    let (low, high) = match value {
        Value::Number(q) => (q.clone(), q.clone()),
        Value::Root(root) => (root.lo.clone(), root.hi.clone()),
        Value::InRoot { coefficients, root } => at_root(coefficients, root),
        Value::Function(_) => return None,
    };
    let near = decimal(&low);
    (near == decimal(&high)).then_some(near)
}

/// Between which numbers Σ coefficientᵢ·rootⁱ is, by Horner's rule on the interval of the root.
fn at_root(coefficients: &[BigRational], root: &Root) -> (BigRational, BigRational) {
    let none = (BigRational::zero(), BigRational::zero());
    coefficients.iter().rev().fold(none, |(low, high), c| {
        let ends = [&low, &high].into_iter().flat_map(|end| [end * &root.lo, end * &root.hi]);
        let mut ends: Vec<BigRational> = ends.collect();
        ends.sort();
        (&ends[0] + c, &ends[3] + c)
    })
}

/// Both sides of a relation at a point, or why it has no meaning there.
pub(super) fn comparison(formulas: &Formulas, comparison: &Comparison) -> String {
    match comparison {
        Comparison::Sides(left, right) => {
            let (left, right) = sides(formulas, left, right);
            format!("left side {left}, right side {right}")
        }
        Comparison::Truth(true) => "it is true".to_owned(),
        Comparison::Truth(false) => "it is false".to_owned(),
        Comparison::Undefined(relation, why, by) => {
            let relation = formulas.relation(relation);
            format!("{relation} is undefined ({})", undefined(formulas, *why, by.as_ref()))
        }
    }
}

/// A value at a point.
pub(super) fn measured(formulas: &Formulas, value: &Measured) -> String {
    match value {
        Measured::Exact(value) => formulas.number(value),
        Measured::Near(value) => about(formulas, &decimal(value)),
        Measured::None(why) if why.is_undefined() => format!("undefined ({why})"),
        Measured::None(why) => format!("not computed ({why})"),
    }
}

/// Both sides of a relation; where one is not exact or is long, to as many digits as tell them apart.
fn sides(formulas: &Formulas, left: &Measured, right: &Measured) -> (String, String) {
    let number = |side: &Measured| match side {
        Measured::Exact(value) | Measured::Near(value) => Some(value.clone()),
        Measured::None(_) => None,
    };
    let digits = number(left).zip(number(right)).map(|(left, right)| apart(&left, &right));
    let (of_left, of_right) = digits.unzip();
    let one = |side: &Measured, digits: Option<String>| match (side, digits) {
        (Measured::Near(_), Some(digits)) => about(formulas, &digits),
        (Measured::Exact(q), Some(digits)) if q.to_string().len() > MOST_LETTERS => {
            about(formulas, &digits)
        }
        _ => measured(formulas, side),
    };
    (one(left, of_left), one(right, of_right))
}

fn about(formulas: &Formulas, digits: &str) -> String {
    formulas.words(&format!("about {digits}"))
}

/// Why a relation has no meaning, and what it divides by though it is 0.
fn undefined(formulas: &Formulas, why: NoValue, by: Option<&Expr>) -> String {
    let zero = formulas.number(&BigRational::zero());
    let why = formulas.words(&why.to_string());
    match by {
        Some(by) => format!("{why}: {}", formulas.compared(&formulas.expr(by), "=", &zero)),
        None => why,
    }
}

/// What a relation says at a point, in numbers: `1 = 1`, or `-1 = 1 is false`.
pub(super) fn in_numbers(formulas: &Formulas, relation: &Relation, told: &Comparison) -> String {
    match told {
        Comparison::Sides(Measured::Exact(a), Measured::Exact(b)) => {
            let sign = kane_algebra::syntax::comparison(relation.rel);
            let says = formulas.compared(&formulas.number(a), sign, &formulas.number(b));
            match kane_algebra::syntax::compares(relation.rel, a.cmp(b)) {
                true => says,
                false => format!("{says} is false"),
            }
        }
        Comparison::Undefined(_, why, by) => {
            format!("undefined ({})", undefined(formulas, *why, by.as_ref()))
        }
        told => comparison(formulas, told),
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
        End::Limit { target, above, against_nothing } => {
            let target = match target {
                Target::Finite(value) => formulas.expr(value),
                Target::PlusInf => formulas.infinity(true),
                Target::MinusInf => formulas.infinity(false),
            };
            let from = match above {
                None => "",
                Some(true) => " from the right",
                Some(false) => " from the left",
            };
            let against =
                if *against_nothing { ", and what it should be is undefined" } else { "" };
            format!("the limit{from} is {target}{against}")
        }
    }
}

/// Formulas of a goal without a proof.
pub(super) fn plain_formulas(form: super::Form, context: &Context) -> Formulas {
    Formulas::new(form, context, &[])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn q(text: &str) -> BigRational {
        text.parse().expect("a fraction")
    }

    /// The root of two, between two decimals.
    fn root_of_two() -> Root {
        let poly = [-2, 0, 1].map(BigInt::from).to_vec();
        Root { poly, lo: q("1414213562/1000000000"), hi: q("1414213563/1000000000") }
    }

    #[test]
    fn what_is_computed_from_a_root_is_enclosed_by_its_interval() {
        // 3 − 2·√2 = 0.171572…, whose terms fall and rise
        let (low, high) = at_root(&[q("3"), q("-2")], &root_of_two());
        assert!(low <= q("171572876/1000000000") && q("171572875/1000000000") <= high);
        let value = Value::InRoot { coefficients: vec![q("3"), q("-2")], root: root_of_two() };
        assert_eq!(decimals(&value).as_deref(), Some("0.1716"));
    }

    #[test]
    fn digits_that_the_interval_leaves_open_are_not_told() {
        let wide = Root { hi: q("3/2"), ..root_of_two() };
        assert_eq!(decimals(&Value::Root(wide)), None);
    }

    /// The formulas of a document with the symbol m.
    fn formulas(form: super::super::Form) -> Formulas {
        let document = kane_audit::read("m.md", b"```kane\nvar m, r\n```\n").expect("it is read");
        Formulas::new(form, &document.context, &[])
    }

    fn plain() -> Formulas {
        formulas(super::super::Form::Plain)
    }

    #[test]
    fn a_value_in_a_root_is_told_over_one_denominator_with_a_letter_that_is_free() {
        // 1/2 + √2/3, and r is a symbol
        let coefficients = vec![q("1/2"), q("1/3")];
        let told = value(&plain(), &Value::InRoot { coefficients, root: root_of_two() });
        let (sum, of) = told.split_once(" with ").expect("a letter");
        assert!(["(3 + 2*q)/6", "(2*q + 3)/6"].contains(&sum), "{told}");
        assert!(of.starts_with("q = the root of ") && of.ends_with(" near 1.4142"), "{told}");
        let whole = vec![q("0"), q("3")];
        let told = value(&plain(), &Value::InRoot { coefficients: whole, root: root_of_two() });
        assert!(told.starts_with("3*q with q = "), "{told}");
    }

    #[test]
    fn a_long_value_in_a_sentence_is_told_by_its_decimals() {
        let told = |value: Value| {
            assigned_briefly(&plain(), &[kane_audit::Assignment { symbol: 0, value }]).concat()
        };
        let digits = |count: usize| "7".repeat(count);
        assert_eq!(told(Value::Number(q(&digits(40)))), format!("m = {}", digits(40)));
        assert_eq!(told(Value::Number(q(&digits(41)))), "m near 7.7778e40");
        assert_eq!(told(Value::Number(q("1/3"))), "m = 1/3");
        // a short polynomial is told, and one with long numbers is not
        let long = BigInt::from(10).pow(39);
        let poly = vec![-&long * 2, 0.into(), long];
        assert!(told(Value::Root(root_of_two())).starts_with("m = the root of "));
        assert_eq!(told(Value::Root(Root { poly, ..root_of_two() })), "m near 1.4142");
        let coefficients = vec![q(&format!("1/{}", digits(40))), q("1")];
        let sum = Value::InRoot { coefficients, root: root_of_two() };
        assert_eq!(told(sum), "m near 1.4142");
    }

    #[test]
    fn what_is_near_a_number_is_not_said_to_be_it() {
        let (formulas, near) = (plain(), |text: &str| Measured::Near(q(text)));
        let both = |left, right| comparison(&formulas, &Comparison::Sides(left, right));
        let exact = |text: &str| Measured::Exact(q(text));
        assert_eq!(both(near("14142/10000"), exact("1")), "left side about 1.4142, right side 1");
        // to as many digits as tell them apart
        assert_eq!(
            both(near("14142135/10000000"), near("14142136/10000000")),
            "left side about 1.4142135, right side about 1.4142136"
        );
        let third = |zeros: usize| format!("1{}/3", "0".repeat(zeros));
        let (long, short) = (third(38), third(37));
        assert_eq!((long.len(), short.len()), (41, 40));
        assert_eq!(both(exact(&long), exact("1")), "left side about 3.3333e37, right side 1");
        assert_eq!(both(exact(&short), exact("1")), format!("left side {short}, right side 1"));
        let none = Measured::None;
        assert_eq!(
            both(none(NoValue::DivisionByZero), none(NoValue::TooLarge)),
            "left side undefined (division by zero), right side not computed (too large to compute)"
        );
    }

    #[test]
    fn numbers_that_do_not_compare_as_a_relation_says_are_said_not_to() {
        let formulas = plain();
        let is = |rel| Relation { lhs: Expr::Var(0), rel, rhs: Expr::Var(1) };
        let told = |rel, left: &str, right: &str| {
            let sides = Comparison::Sides(Measured::Exact(q(left)), Measured::Exact(q(right)));
            in_numbers(&formulas, &is(rel), &sides)
        };
        use kane_kernel::Rel::{Eq, Ge, Gt, Le, Lt, Ne};
        for (rel, sign) in [(Eq, "="), (Ne, "!="), (Lt, "<"), (Le, "<="), (Gt, ">"), (Ge, ">=")] {
            for (left, right) in [("1", "2"), ("2", "2"), ("2", "1")] {
                let (l, r): (i32, i32) =
                    (left.parse().expect("a digit"), right.parse().expect("a digit"));
                let holds = match sign {
                    "=" => l == r,
                    "!=" => l != r,
                    "<" => l < r,
                    "<=" => l <= r,
                    ">" => l > r,
                    _ => l >= r,
                };
                let is_false = if holds { "" } else { " is false" };
                assert_eq!(told(rel, left, right), format!("{left} {sign} {right}{is_false}"));
            }
        }
        let nothing = Comparison::Undefined(is(Eq), NoValue::DivisionByZero, Some(Expr::Var(0)));
        assert_eq!(in_numbers(&formulas, &is(Eq), &nothing), "undefined (division by zero: m = 0)");
        assert_eq!(comparison(&formulas, &Comparison::Truth(true)), "it is true");
        assert_eq!(comparison(&formulas, &Comparison::Truth(false)), "it is false");
    }
}
