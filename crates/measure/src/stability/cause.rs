//! The operation at which digits are lost.

use crate::{Fault, Format, Operation, judge};

use super::scan::Probe;

/// Says in words where the loss at an input happens: at the operation that loses most beyond what
/// its operands had lost.
pub(super) fn cause<F: Format>(probe: &Probe<'_, F>, place: u64, fault: Fault) -> String {
    let computed = probe.all_computed(place);
    let exact = probe.all_exact(place);
    let all = 100 * i64::from(F::PRECISION);
    let mut lost: Vec<i64> = Vec::new();
    let mut worst: Option<(i64, usize)> = None;
    for (index, operation) in probe.formula.program.operations().iter().enumerate() {
        let get = |i: usize| computed.get(i).copied().flatten();
        let here = match (get(index), exact.get(index).and_then(Option::as_ref)) {
            (Some(computed), Some(exact)) => judge(computed, exact).lost,
            // no exact value: a division by zero, which shows as ∞ or NaN
            (Some(computed), None) if !computed.is_finite() => all,
            _ => 0,
        };
        let before = operands(operation).iter().filter_map(|i| lost.get(*i)).max();
        let gain = here - before.copied().unwrap_or(0);
        lost.push(here);
        if worst.is_none_or(|(most, _)| gain > most) {
            worst = Some((gain, index));
        }
    }
    let first_infinite = computed.iter().position(|result| {
        result.is_some_and(|float| float.magnitude_bits() == F::infinity_bits())
    });
    let Some((_, index)) = worst else { return String::new() };
    // an infinity that came before is where it began, even where it is rightly rounded
    let index = match first_infinite {
        Some(first) if fault != Fault::Lost => first.min(index),
        _ => index,
    };
    let Some(operation) = probe.formula.program.operations().get(index) else {
        return String::new();
    };
    let result = computed.get(index).copied().flatten();
    let bits = result.map_or(0, kane_number::Binary::magnitude_bits);
    let zero = |i: &usize| {
        computed.get(*i).copied().flatten().is_some_and(|float| float.magnitude_bits() == 0)
    };
    let text = probe.formula.program.text(index);
    let verb = match operation {
        Operation::Div(_, b) if zero(b) => "divides by 0",
        _ if bits > F::infinity_bits() => "has no value",
        _ if bits == F::infinity_bits() => "overflows",
        Operation::Add(..) | Operation::Sub(..) => "cancels",
        Operation::Mul(..) | Operation::Div(..) => "underflows",
        _ => "rounds",
    };
    format!("{text} {verb}")
}

fn operands(operation: &Operation) -> Vec<usize> {
    match operation {
        Operation::Number(_) | Operation::Input(_) => vec![],
        Operation::Neg(a) | Operation::Sqrt(a) | Operation::Abs(a) => vec![*a],
        Operation::Add(a, b)
        | Operation::Sub(a, b)
        | Operation::Mul(a, b)
        | Operation::Div(a, b)
        | Operation::Min(a, b)
        | Operation::Max(a, b) => vec![*a, *b],
        Operation::Cases(branches, otherwise) => {
            branches.iter().map(|(_, value)| *value).chain(*otherwise).collect()
        }
    }
}
