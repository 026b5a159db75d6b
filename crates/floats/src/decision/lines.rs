//! The exact part of a certified comparison, a line a step.

use kane_number::Integer;

use super::code::Function;
use super::exact::{Step, Steps};
use crate::{Language, text};

impl Function<'_> {
    /// The exact part.
    pub(super) fn exact(&self, steps: &Steps, text: &mut String) {
        let mut needed = vec![false; steps.steps.len()];
        if let Some(last) = needed.last_mut() {
            *last = true;
        }
        for (index, step) in steps.steps.iter().enumerate().rev() {
            if needed.get(index) == Some(&true) {
                for operand in step.operands() {
                    if let Some(needed) = needed.get_mut(operand) {
                        *needed = true;
                    }
                }
            }
        }
        if self.language == Language::C {
            text.push_str("    kane_number *kpool = NULL;\n");
        }
        let mut last = 0;
        for (index, step) in steps.steps.iter().enumerate() {
            if needed.get(index) != Some(&true) {
                continue;
            }
            last = index;
            let value = self.step(step);
            let is_number = step.is_number();
            let line = match self.language {
                Language::Rust => format!("    let kn{index} = {value};\n"),
                Language::C if is_number => {
                    format!("    const kane_number *kn{index} = {value};\n")
                }
                Language::C => format!("    const int kn{index} = {value};\n"),
                Language::Python => format!("    kn{index} = {value}\n"),
            };
            text.push_str(&line);
        }
        text.push_str(&match self.language {
            Language::Rust => format!("    kn{last}\n"),
            Language::C => format!("    kane_free(kpool);\n    return kn{last};\n"),
            Language::Python => format!("    return kn{last}\n"),
        });
    }

    fn step(&self, step: &Step) -> String {
        let is = |language| self.language == language;
        let two = |rust: &str, c: &str, python: char, a: usize, b: usize| match self.language {
            Language::Rust => format!("kn{a}.{rust}(&kn{b})"),
            Language::C => format!("{c}(&kpool, kn{a}, kn{b})"),
            Language::Python => format!("kn{a} {python} kn{b}"),
        };
        let all = |truths: &[usize], words: [&str; 3], none: [&str; 3]| {
            let place = match self.language {
                Language::Rust => 0,
                Language::C => 1,
                Language::Python => 2,
            };
            let truths: Vec<String> = truths.iter().map(|truth| format!("kn{truth}")).collect();
            match truths.as_slice() {
                [] => none[place].to_owned(),
                truths => truths.join(words[place]),
            }
        };
        match step {
            Step::Input(input) => {
                let argument = self.argument(*input);
                match self.language {
                    Language::Rust => format!("Exact::of({argument})"),
                    Language::C => format!("kane_of(&kpool, {argument})"),
                    Language::Python => format!("Fraction({argument})"),
                }
            }
            Step::Integer(integer) => self.integer(integer),
            Step::Sum(a, b) => two("sum", "kane_sum", '+', *a, *b),
            Step::Difference(a, b) => two("difference", "kane_difference", '-', *a, *b),
            Step::Product(a, b) => two("product", "kane_product", '*', *a, *b),
            Step::Pick(truth, a, b) if is(Language::Rust) => {
                format!("if kn{truth} {{ kn{a}.clone() }} else {{ kn{b}.clone() }}")
            }
            Step::Pick(truth, a, b) => {
                self.choose(&format!("kn{truth}"), &format!("kn{a}"), &format!("kn{b}"))
            }
            Step::Sign(a) => match self.language {
                Language::Rust => format!("kn{a}.sign"),
                Language::C => format!("kn{a}->sign"),
                Language::Python => format!("exact_sign(kn{a})"),
            },
            Step::Signs(a, b) => format!("kn{a} * kn{b}"),
            Step::RootSign(a, b, norm) => {
                let c = if is(Language::C) { "kane_" } else { "" };
                format!("{c}root_sign(kn{a}, kn{b}, kn{norm})")
            }
            Step::Holds(rel, sign) => format!("kn{sign} {} 0", text::sign(*rel)),
            Step::All(truths) => all(truths, [" && ", " && ", " and "], ["true", "1", "True"]),
            Step::Any(truths) => all(truths, [" || ", " || ", " or "], ["false", "0", "False"]),
            Step::Not(truth) if is(Language::Python) => format!("not kn{truth}"),
            Step::Not(truth) => format!("!kn{truth}"),
        }
    }

    fn integer(&self, integer: &Integer) -> String {
        if self.language == Language::Python {
            return integer.to_string();
        }
        let (sign, digits) = integer.to_u32_digits();
        let sign = if sign == num_bigint::Sign::Minus { -1 } else { 1 };
        let count = digits.len();
        let digits: Vec<String> = digits.iter().map(u32::to_string).collect();
        let digits = digits.join(", ");
        match self.language {
            Language::Rust => format!("Exact::integer({sign}, &[{digits}])"),
            _ if count == 0 => "kane_integer(&kpool, 1, 0, NULL)".to_owned(),
            _ => format!("kane_integer(&kpool, {sign}, {count}, (const uint32_t[]){{{digits}}})"),
        }
    }
}

impl Step {
    /// Whether it gives a number, not a sign or a truth.
    const fn is_number(&self) -> bool {
        matches!(
            self,
            Self::Input(_)
                | Self::Integer(_)
                | Self::Sum(..)
                | Self::Difference(..)
                | Self::Product(..)
                | Self::Pick(..)
        )
    }

    fn operands(&self) -> Vec<usize> {
        match self {
            Self::Input(_) | Self::Integer(_) => vec![],
            Self::Sum(a, b) | Self::Difference(a, b) | Self::Product(a, b) | Self::Signs(a, b) => {
                vec![*a, *b]
            }
            Self::Pick(a, b, c) | Self::RootSign(a, b, c) => vec![*a, *b, *c],
            Self::Sign(a) | Self::Holds(_, a) | Self::Not(a) => vec![*a],
            Self::All(truths) | Self::Any(truths) => truths.clone(),
        }
    }
}
