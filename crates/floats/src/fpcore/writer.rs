//! From formulas to s-expressions.

use std::fmt::Write as _;

use kane_kernel::Bound;

use crate::text::{decimal, sign};
use crate::{Core, Operation, Test};

/// A formula as an FPCore that reads back as it. What is used more than once is bound by `let*`.
#[must_use]
pub fn write(core: &Core) -> String {
    let names: Vec<&str> = core.arguments.iter().map(|argument| argument.name.as_str()).collect();
    let mut text = format!("(FPCore ({})", names.join(" "));
    if let Some(name) = &core.name {
        write!(text, "\n :name \"{name}\"").expect("a string takes all");
    }
    if let Some(precision) = core.precision {
        write!(text, "\n :precision {}", precision.fpcore()).expect("a string takes all");
    }
    for (key, value) in &core.properties {
        write!(text, "\n {key} {value}").expect("a string takes all");
    }
    let mut pre: Vec<String> = core
        .arguments
        .iter()
        .filter_map(|argument| {
            range(&argument.name, argument.lower.as_ref(), argument.upper.as_ref())
        })
        .collect();
    let plain = Writer { core, bound: vec![None; core.program.operations().len()] };
    pre.extend(core.assumed.iter().map(|test| plain.test(test)));
    match pre.as_slice() {
        [] => {}
        [one] => write!(text, "\n :pre {one}").expect("a string takes all"),
        several => write!(text, "\n :pre (and {})", several.join(" ")).expect("a string takes all"),
    }
    let (bindings, body) = body(core);
    if bindings.is_empty() {
        write!(text, "\n {body})").expect("a string takes all");
    } else {
        let bindings = bindings.join("\n        ");
        write!(text, "\n (let* ({bindings})\n  {body}))").expect("a string takes all");
    }
    text
}

fn range(name: &str, lower: Option<&Bound>, upper: Option<&Bound>) -> Option<String> {
    let less = |strict: bool| if strict { "<" } else { "<=" };
    match (lower, upper) {
        (Some(lower), Some(upper)) if lower.strict == upper.strict => {
            let (a, b) = (decimal(&lower.value), decimal(&upper.value));
            Some(format!("({} {a} {name} {b})", less(lower.strict)))
        }
        (Some(lower), Some(upper)) => Some(format!(
            "({} {} {name}) ({} {name} {})",
            less(lower.strict),
            decimal(&lower.value),
            less(upper.strict),
            decimal(&upper.value)
        ))
        .map(|both| format!("(and {both})")),
        (Some(lower), None) => {
            Some(format!("({} {} {name})", less(lower.strict), decimal(&lower.value)))
        }
        (None, Some(upper)) => {
            Some(format!("({} {name} {})", less(upper.strict), decimal(&upper.value)))
        }
        (None, None) => None,
    }
}

/// Bindings of what is used more than once, and the value.
fn body(core: &Core) -> (Vec<String>, String) {
    let operations = core.program.operations();
    let needed = core.program.needed(core.root);
    let uses = core.program.uses(core.root);
    let mut writer = Writer { core, bound: vec![None; operations.len()] };
    let mut bindings = Vec::new();
    for (index, operation) in operations.iter().enumerate() {
        let is_leaf = matches!(operation, Operation::Number(_) | Operation::Input(_));
        let often = uses.get(index).is_some_and(|uses| *uses > 1);
        if often && !is_leaf && needed.get(index) == Some(&true) {
            let value = writer.expression(index);
            let name = fresh(core, bindings.len());
            bindings.push(format!("[{name} {value}]"));
            if let Some(bound) = writer.bound.get_mut(index) {
                *bound = Some(name);
            }
        }
    }
    let value = writer.expression(core.root);
    (bindings, value)
}

/// A name that no argument has.
fn fresh(core: &Core, number: usize) -> String {
    let mut name = format!("t{}", number + 1);
    while core.arguments.iter().any(|argument| argument.name == name) {
        name.push('_');
    }
    name
}

struct Writer<'a> {
    core: &'a Core,
    bound: Vec<Option<String>>,
}

impl Writer<'_> {
    fn expression(&self, index: usize) -> String {
        if let Some(Some(name)) = self.bound.get(index) {
            return name.clone();
        }
        let Some(operation) = self.core.program.get(index) else { return String::new() };
        let at = |index: &usize| self.expression(*index);
        match operation {
            Operation::Number(number) => decimal(number),
            Operation::Input(input) => {
                self.core.arguments.get(*input).map_or_else(String::new, |a| a.name.clone())
            }
            Operation::Neg(a) => format!("(- {})", at(a)),
            Operation::Add(a, b) => format!("(+ {} {})", at(a), at(b)),
            Operation::Sub(a, b) => format!("(- {} {})", at(a), at(b)),
            Operation::Mul(a, b) => format!("(* {} {})", at(a), at(b)),
            Operation::Div(a, b) => format!("(/ {} {})", at(a), at(b)),
            Operation::Sqrt(a) => format!("(sqrt {})", at(a)),
            Operation::Fma(a, b, c) => format!("(fma {} {} {})", at(a), at(b), at(c)),
            Operation::Abs(a) => format!("(fabs {})", at(a)),
            Operation::Min(a, b) => format!("(fmin {} {})", at(a), at(b)),
            Operation::Max(a, b) => format!("(fmax {} {})", at(a), at(b)),
            Operation::If(test, a, b) => format!("(if {} {} {})", self.test(test), at(a), at(b)),
        }
    }

    fn test(&self, test: &Test) -> String {
        let all = |word: &str, tests: &[Test]| {
            let tests: Vec<String> = tests.iter().map(|test| self.test(test)).collect();
            format!("({word} {})", tests.join(" "))
        };
        match test {
            Test::Compare(rel, a, b) => {
                format!("({} {} {})", sign(*rel), self.expression(*a), self.expression(*b))
            }
            Test::All(tests) if tests.is_empty() => "TRUE".to_owned(),
            Test::Any(tests) if tests.is_empty() => "FALSE".to_owned(),
            Test::All(tests) => all("and", tests),
            Test::Any(tests) => all("or", tests),
            Test::Not(test) => format!("(not {})", self.test(test)),
        }
    }
}
