//! A bound as a question to Gappa, a program that proves bounds on round-off and shares nothing with this one.

use std::fmt::Write as _;

use kane_number::{Rational, decode};

use crate::machine::Machine;
use crate::rigor::{Cell, Inputs};
use crate::{Core, Operation, Precision, text};

/// A script that Gappa accepts only if it finds a proof that no input of the ranges, floats of the format of `M`, has
/// an error above `bound`. It splits the ranges by itself. `None` for formulas with choices, minima or
/// maxima, of which Gappa knows nothing, for those with assumptions beyond ranges, and without a finite bound.
#[must_use]
pub fn gappa<M: Machine>(core: &Core, bound: f64) -> Option<String> {
    let whole = Cell::whole::<M>(core, Inputs::Floats).ok()?;
    let bound = dyadic(&decode(bound).ok()?);
    if !core.assumed.is_empty() {
        return None;
    }
    let format = match M::FORMAT {
        Precision::F32 => "ieee_32",
        Precision::F64 => "ieee_64",
    };
    let mut script = format!("# {} in {}\n", core.text(), M::FORMAT.name());
    for (index, argument) in core.arguments.iter().enumerate() {
        writeln!(script, "# x{index} is {}", argument.name).ok()?;
    }
    writeln!(script, "@rnd = float<{format}, ne>;").ok()?;
    for index in 0..core.arguments.len() {
        writeln!(script, "x{index} = rnd(real{index});").ok()?;
    }
    let needed = core.program.needed(core.root);
    for (index, operation) in core.program.operations().iter().enumerate() {
        // an input has no other name, which Gappa would complain of
        if needed.get(index) != Some(&true) || matches!(operation, Operation::Input(_)) {
            continue;
        }
        // the computed value is t, the exact one e
        for (name, rounded) in [('t', true), ('e', false)] {
            let value = value(core, operation, name)?;
            let is_rounded =
                rounded && (operation.rounds() || matches!(operation, Operation::Number(_)));
            let value = if is_rounded { format!("rnd({value})") } else { value };
            writeln!(script, "{name}{index} = {value};").ok()?;
        }
    }
    let ranges = whole.ends.iter().enumerate().map(|(index, (lower, upper))| {
        let [lower, upper] = [lower, upper].map(|end| decode(*end).ok().map(|end| dyadic(&end)));
        Some(format!("x{index} in [{}, {}]", lower?, upper?))
    });
    let ranges: Option<Vec<String>> = ranges.collect();
    let [computed, exact] = ['t', 'e'].map(|name| named(core, core.root, name));
    let premises = ranges?.join(" /\\ ");
    let arrow = if premises.is_empty() { "" } else { " -> " };
    writeln!(script, "{{ {premises}{arrow}|{computed} - {exact}| <= {bound} }}").ok()?;
    let split: Vec<String> = whole
        .ends
        .iter()
        .enumerate()
        .filter(|(_, (lower, upper))| lower < upper)
        .map(|(index, _)| format!("x{index}"))
        .collect();
    if !split.is_empty() {
        writeln!(script, "|{computed} - {exact}| $ {};", split.join(", ")).ok()?;
    }
    Some(script)
}

/// What an operation is called.
fn named(core: &Core, index: usize, name: char) -> String {
    match core.program.get(index) {
        Some(Operation::Input(input)) => format!("x{input}"),
        _ => format!("{name}{index}"),
    }
}

fn value(core: &Core, operation: &Operation, name: char) -> Option<String> {
    let at = |index: usize| named(core, index, name);
    Some(match *operation {
        Operation::Number(ref number) => text::decimal(number),
        Operation::Input(input) => format!("x{input}"),
        Operation::Neg(a) => format!("-{}", at(a)),
        Operation::Add(a, b) => format!("{} + {}", at(a), at(b)),
        Operation::Sub(a, b) => format!("{} - {}", at(a), at(b)),
        Operation::Mul(a, b) => format!("{} * {}", at(a), at(b)),
        Operation::Div(a, b) => format!("{} / {}", at(a), at(b)),
        Operation::Sqrt(a) => format!("sqrt({})", at(a)),
        Operation::Fma(a, b, c) => format!("{} * {} + {}", at(a), at(b), at(c)),
        Operation::Abs(a) => format!("|{}|", at(a)),
        Operation::Min(..) | Operation::Max(..) | Operation::If(..) => return None,
    })
}

/// m·2^e as `mbe`; every float is one.
fn dyadic(number: &Rational) -> String {
    let halvings = number.denom().bits().saturating_sub(1);
    if halvings > 0 {
        return format!("{}b-{halvings}", number.numer());
    }
    let doublings = number.numer().trailing_zeros().unwrap_or(0);
    match doublings {
        0 => number.numer().to_string(),
        up => format!("{}b{up}", number.numer() >> up),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fpcore;

    #[test]
    fn a_question_has_the_operations_twice_and_the_ranges_once() {
        let mut core = fpcore::read("t", "(FPCore (a) (- (sqrt a) 0.1))").unwrap().remove(0);
        core.arguments[0].at_least(&Rational::from_integer(1.into()), false);
        core.arguments[0].at_most(&Rational::from_integer(3.into()), false);
        let script = gappa::<f32>(&core, 0.25).unwrap();
        for line in [
            "@rnd = float<ieee_32, ne>;",
            "t1 = rnd(sqrt(x0));",
            "e1 = sqrt(x0);",
            "t2 = rnd(0.1);",
            "{ x0 in [1, 3] -> |t3 - e3| <= 1b-2 }",
            "|t3 - e3| $ x0;",
        ] {
            assert!(script.lines().any(|known| known == line), "{line}\n{script}");
        }
        let choice = fpcore::read("t", "(FPCore (a) (fmin a 1))").unwrap().remove(0);
        assert_eq!(gappa::<f64>(&choice, 1.0), None);
    }
}
