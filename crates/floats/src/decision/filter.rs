//! The float part of a certified comparison: values with a running bound on what they are off by.

use std::fmt::Write as _;

use kane_kernel::Rel;
use kane_number::{Rational, Rounding, decode, encode};

use super::code::{Function, function_name};
use super::compared::Decision;
use crate::emit::{infinity, words};
use crate::machine::rounded;
use crate::{Language, Operation, Precision, text};

/// A value in the filter, and by how much it is off at most, `None` for not at all.
#[derive(Clone)]
struct Filtered {
    value: String,
    off: Option<String>,
}

impl Function<'_> {
    /// The float part: values with a running bound.
    pub(super) fn filter(&self, decision: &Decision) -> Option<String> {
        let (left, right) = decision.operands;
        let indent = if self.language == Language::Python { "        " } else { "    " };
        let mut text = match self.language {
            Language::Python => "    try:\n".to_owned(),
            _ => String::new(),
        };
        let needed = self.core.program.needed_by(&[left, right]);
        let mut found: Vec<Option<Filtered>> = Vec::new();
        for (index, operation) in self.core.program.operations().iter().enumerate() {
            let filtered = match needed.get(index) {
                Some(true) => Some(self.filtered(index, operation, &found, indent, &mut text)?),
                _ => None,
            };
            found.push(filtered);
        }
        let (a, b) = (found.get(left)?.clone()?, found.get(right)?.clone()?);
        let [half, more, tiny, _] = self.constants();
        text.push_str(&self.line(indent, "kd", &format!("{} - {}", a.value, b.value)));
        let offs: Vec<String> = [a.off, b.off].into_iter().flatten().collect();
        let offs = offs.iter().map(|off| format!("{off} + ")).collect::<String>();
        let off = format!("({offs}{} * {half}) * {more} + {tiny}", self.magnitude("kd"));
        text.push_str(&self.line(indent, "ke", &off));
        let holds = |order| {
            let holds = kane_algebra::syntax::compares(decision.rel, order);
            match (self.language, holds) {
                (Language::Python, true) => "True",
                (Language::Python, false) => "False",
                (Language::C, true) => "1",
                (Language::C, false) => "0",
                (_, true) => "true",
                (_, false) => "false",
            }
        };
        for (beyond, order) in
            [("kd > ke", std::cmp::Ordering::Greater), ("kd < -ke", std::cmp::Ordering::Less)]
        {
            let answer = holds(order);
            match self.language {
                Language::Rust => {
                    writeln!(text, "{indent}if {beyond} {{ return {answer}; }}")
                }
                Language::C => writeln!(text, "{indent}if ({beyond}) return {answer};"),
                Language::Python => {
                    writeln!(text, "{indent}if {beyond}:\n{indent}    return {answer}")
                }
            }
            .ok()?;
        }
        // what is not finite has no exact value
        let arguments = self.arguments;
        let sign = text::sign(decision.rel);
        match self.language {
            Language::Rust => {
                let finite: Vec<String> =
                    arguments.iter().map(|a| format!("{a}.is_finite()")).collect();
                let plain = format!("{} {sign} {}", a.value, b.value);
                writeln!(
                    text,
                    "    if !({}) {{ return {plain}; }}",
                    if finite.is_empty() { "true".to_owned() } else { finite.join(" && ") }
                )
            }
            Language::C => {
                let finite: Vec<String> =
                    arguments.iter().map(|a| format!("isfinite({a})")).collect();
                let finite =
                    if finite.is_empty() { "1".to_owned() } else { finite.join(" && ") };
                writeln!(text, "    if (!({finite})) return {} {sign} {};", a.value, b.value)
            }
            Language::Python => {
                let finite: Vec<String> =
                    arguments.iter().map(|a| format!("isfinite({a})")).collect();
                let finite =
                    if finite.is_empty() { "True".to_owned() } else { finite.join(" and ") };
                writeln!(
                    text,
                    "{indent}if not ({finite}):\n{indent}    return {} {sign} {}\n    except (ArithmeticError, ValueError):\n        pass",
                    a.value, b.value
                )
            }
        }
        .ok()?;
        Some(text)
    }

    /// One operation with what it is off by.
    fn filtered(
        &self,
        index: usize,
        operation: &Operation,
        found: &[Option<Filtered>],
        indent: &str,
        text: &mut String,
    ) -> Option<Filtered> {
        let at = |index: usize| found.get(index)?.clone();
        let [half, more, tiny, infinity] = self.constants();
        let (t, e) = (format!("kt{index}"), format!("ke{index}"));
        let bounded = |carried: Vec<String>, of: &str| {
            let mut parts = carried;
            parts.push(format!("{} * {half}", self.magnitude(of)));
            format!("({}) * {more} + {tiny}", parts.join(" + "))
        };
        // |a′·b′ − a·b| ≤ |a′|·off(b) + |b′|·off(a) + off(a)·off(b)
        let product = |a: &Filtered, b: &Filtered| {
            let mut parts = Vec::new();
            if let Some(off) = &b.off {
                parts.push(format!("{} * {off}", self.magnitude(&a.value)));
            }
            if let Some(off) = &a.off {
                parts.push(format!("{} * {off}", self.magnitude(&b.value)));
            }
            if let (Some(a), Some(b)) = (&a.off, &b.off) {
                parts.push(format!("{a} * {b}"));
            }
            parts
        };
        let offs = |parts: &[&Filtered]| -> Vec<String> {
            parts.iter().filter_map(|part| part.off.clone()).collect()
        };
        let mut emit = |value: String, off: String| {
            text.push_str(&self.line(indent, &t, &value));
            text.push_str(&self.line(indent, &e, &off));
            Filtered { value: t.clone(), off: Some(e.clone()) }
        };
        Some(match *operation {
            Operation::Number(ref number) => self.constant(number),
            Operation::Input(input) => {
                Filtered { value: self.argument(input).to_owned(), off: None }
            }
            Operation::Neg(a) => {
                let a = at(a)?;
                Filtered { value: format!("(-{})", a.value), off: a.off }
            }
            Operation::Abs(a) => {
                let a = at(a)?;
                Filtered { value: self.magnitude(&a.value), off: a.off }
            }
            Operation::Add(a, b) | Operation::Sub(a, b) => {
                let (a, b) = (at(a)?, at(b)?);
                let sign = if matches!(operation, Operation::Add(..)) { '+' } else { '-' };
                let carried = offs(&[&a, &b]);
                emit(format!("{} {sign} {}", a.value, b.value), bounded(carried, &t))
            }
            Operation::Mul(a, b) => {
                let (a, b) = (at(a)?, at(b)?);
                let off = bounded(product(&a, &b), &t);
                emit(format!("{} * {}", a.value, b.value), off)
            }
            Operation::Fma(a, b, c) => {
                // two roundings are as good: a bound on both is taken
                let (a, b, c) = (at(a)?, at(b)?, at(c)?);
                let inner = format!("({} * {})", a.value, b.value);
                let mut carried = product(&a, &b);
                carried.push(format!("{} * {half}", self.magnitude(&inner)));
                carried.extend(c.off.clone());
                emit(format!("{inner} + {}", c.value), bounded(carried, &t))
            }
            Operation::Div(a, b) => {
                let (a, b) = (at(a)?, at(b)?);
                let quotient = format!("{} / {}", a.value, b.value);
                let size = self.magnitude(&t);
                let carried = a.off.clone().unwrap_or_else(|| "0.0".to_owned());
                let off = match (&a.off, &b.off) {
                    (None, None) => bounded(vec![], &t),
                    (Some(a), None) => {
                        bounded(vec![format!("{a} / {}", self.magnitude(&b.value))], &t)
                    }
                    (_, Some(off)) => {
                        let divisor = self.magnitude(&b.value);
                        let carried = format!("({carried} + {size} * {off}) / ({divisor} - {off})");
                        let within = format!("{divisor} > 2.0 * {off}");
                        self.choose(&within, &bounded(vec![carried], &t), infinity)
                    }
                };
                emit(quotient, off)
            }
            Operation::Sqrt(a) => {
                let a = at(a)?;
                let root = self.call("sqrt", "sqrt", &[&a.value]);
                let off = match &a.off {
                    None => bounded(vec![], &t),
                    Some(off) => {
                        let above = bounded(vec![format!("{off} / {t}")], &t);
                        let at_zero =
                            format!("{} * {more} + {tiny}", self.call("sqrt", "sqrt", &[off]));
                        self.choose(&format!("{t} > 0.0"), &above, &at_zero)
                    }
                };
                emit(root, off)
            }
            Operation::Min(a, b) | Operation::Max(a, b) => {
                let (a, b) = (at(a)?, at(b)?);
                let least = matches!(operation, Operation::Min(..));
                let name = if least { "min" } else { "max" };
                let c = if least { "fmin" } else { "fmax" };
                let other = |name, c| if self.language == Language::C { c } else { name };
                let value = self.call(name, other(name, c), &[&a.value, &b.value]);
                match (&a.off, &b.off) {
                    // a line of its own: written out where it is used it would double with each use
                    (None, None) => {
                        text.push_str(&self.line(indent, &t, &value));
                        Filtered { value: t.clone(), off: None }
                    }
                    (Some(one), None) | (None, Some(one)) => emit(value, one.clone()),
                    (Some(a), Some(b)) => {
                        let off = self.call("max", other("max", "fmax"), &[a, b]);
                        emit(value, off)
                    }
                }
            }
            Operation::If(ref test, a, b) => {
                let (a, b) = (at(a)?, at(b)?);
                let truth = self.condition(test, found);
                let off = |of: &Filtered| of.off.clone().unwrap_or_else(|| "0.0".to_owned());
                let value = self.choose(&truth, &a.value, &b.value);
                let off = self.choose(&truth, &off(&a), &off(&b));
                emit(value, off)
            }
        })
    }

    /// A test in the filter, by the certified comparisons.
    fn condition(&self, test: &crate::Test, found: &[Option<Filtered>]) -> String {
        let value = |index: usize| {
            found.get(index).and_then(Option::as_ref).map_or("", |known| known.value.as_str())
        };
        let arguments = self.arguments;
        let compare = |rel: Rel, a: usize, b: usize| {
            let place =
                self.all.iter().position(|known| known.rel == rel && known.operands == (a, b));
            match place {
                Some(index) => {
                    format!("{}({})", function_name(self.name, index), arguments.join(", "))
                }
                // the machine compares these exactly
                None => format!("{} {} {}", value(a), text::sign(rel), value(b)),
            }
        };
        text::condition(test, words(self.language), &compare)
    }

    /// A constant to the nearest float, and how far that is.
    fn constant(&self, number: &Rational) -> Filtered {
        let nearest: f64 = rounded(number);
        if nearest.is_infinite() {
            let value = infinity(self.language, Precision::F64, nearest.is_sign_negative());
            return Filtered { value, off: Some(self.constants()[3].to_owned()) };
        }
        let value = match (self.language, nearest.is_sign_negative()) {
            (Language::Rust, true) => format!("({nearest:?}_f64)"),
            (Language::Rust, false) => format!("{nearest:?}_f64"),
            (_, true) => format!("({nearest:?})"),
            (_, false) => format!("{nearest:?}"),
        };
        let distance = decode(nearest).map(|exact| exact - number).ok();
        let distance = distance.map(|d| if d < Rational::from_integer(0.into()) { -d } else { d });
        let off = match distance {
            Some(d) if d == Rational::from_integer(0.into()) => None,
            Some(d) => {
                let up: f64 = encode(&d, Rounding::Up);
                Some(format!("{up:?}"))
            }
            None => Some(self.constants()[3].to_owned()),
        };
        Filtered { value, off }
    }
}
