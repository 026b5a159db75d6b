//! A finding in one sentence.

use std::cmp::Ordering;

use kane_audit::{Behind, LinkJudgement, Means, Reason, Unreached, Variable};
use kane_kernel::{Context, Finding, Goal};

use super::formula::Formulas;
use super::value::{assigned, comparison, end, plain_formulas};
use super::{Form, words};

/// Symbols of a point that are named in a sentence.
const MOST_SYMBOLS: usize = 8;
/// Substituted variables that are named in a sentence.
const MOST_SUBSTITUTED: usize = 4;
/// Letters of a quotient that is told in a sentence.
const MOST_LETTERS: usize = 60;

/// The reason as a sentence without its full stop.
pub(super) fn sentence(goal: &Goal, reason: &Reason, form: Form) -> String {
    let formulas = plain_formulas(form, &goal.context);
    match reason {
        Reason::Contradiction(means) => contradiction(goal, means, form),
        Reason::NoSide => "accepted".to_owned(),
        Reason::Limit { side, power, sense, quotient, variables } => {
            let formulas = Formulas::new(form, &goal.context, variables);
            let plain = Formulas::new(Form::Plain, &goal.context, variables);
            let short = if plain.ratio(quotient).len() > MOST_LETTERS {
                let t = formulas.symbol(formulas.germ());
                format!("a quotient of polynomials in {t}")
            } else {
                formulas.ratio(quotient)
            };
            let at_least = match sense {
                Ordering::Less => "at most ",
                Ordering::Equal => "",
                Ordering::Greater => "at least ",
            };
            format!("{} gives {at_least}{short}", formulas.side(side, *power))
        }
        Reason::Functions { values, end: ends } => {
            let ends = end(&formulas, ends);
            match &assigned(&formulas, values)[..] {
                [] => ends,
                pairs => format!("for {}: {ends}", pairs.join(", ")),
            }
        }
        Reason::Point { values, claim } => {
            let told = claim.as_ref().map(|claim| comparison(&formulas, claim));
            let mut at = assigned(&formulas, values);
            if at.len() > MOST_SYMBOLS {
                at.truncate(MOST_SYMBOLS);
                at.push(words("…", form));
            }
            let at = at.join(", ");
            match (told, at.is_empty()) {
                (None, true) => "everywhere".to_owned(),
                (None, false) => format!("at {at}"),
                (Some(told), true) => told,
                (Some(told), false) => format!("at {at}: {told}"),
            }
        }
    }
}

fn contradiction(goal: &Goal, means: &Means, form: Form) -> String {
    let mut parts = Vec::new();
    if means.limits {
        parts.push("passage to the limit".to_owned());
    }
    if !means.substituted.is_empty() {
        let names = match means.substituted.len() {
            n if n > MOST_SUBSTITUTED => format!("{n} solved premises"),
            _ => listed(goal, &means.substituted, form),
        };
        parts.push(format!("substituting {names}"));
    }
    if !means.tables.is_empty() {
        parts.push(format!("sign table in {}", listed(goal, &means.tables, form)));
    }
    if means.sums {
        parts.push("a sum of non-negative terms".to_owned());
    }
    if means.signs {
        parts.push("signs of coefficients".to_owned());
    }
    let how =
        if parts.is_empty() { "directly".to_owned() } else { format!("by {}", parts.join("; ")) };
    match means.finding {
        Finding::Vacuous => format!("the hypotheses contradict each other, {how}"),
        Finding::Refuted => format!("it does follow, {how}"),
        _ => how,
    }
}

/// Names of variables.
fn listed(goal: &Goal, variables: &[Variable], form: Form) -> String {
    let first = goal.context.vars.len();
    // further variables take the places behind the goal's symbols
    let unplaced = (0..first).map(Variable::Symbol);
    let placed: Vec<Variable> = unplaced.chain(variables.iter().cloned()).collect();
    let formulas = Formulas::new(form, &goal.context, &placed);
    let name = |(i, variable): (usize, &Variable)| match variable {
        Variable::Symbol(v) => formulas.symbol(*v),
        _ => formulas.symbol(first + i),
    };
    variables.iter().enumerate().map(name).collect::<Vec<_>>().join(", ")
}

/// What is to be said of a witness beyond what is cited.
pub(super) fn behind(link: &LinkJudgement, label: &dyn Fn(usize) -> String, form: Form) -> String {
    let named = |indices: &[usize]| {
        let labels: Vec<String> = indices.iter().map(|i| label(*i)).collect();
        labels.join(", ")
    };
    let mut told = match &link.behind {
        None => Vec::new(),
        Some(Behind::NotMet(failing)) => {
            let which = match &failing[..] {
                [] => "the givens behind it are not all met there".to_owned(),
                [one] => format!("{} behind it is not met there", named(&[*one])),
                more => format!("{} behind it are not met there", named(more)),
            };
            vec!["it does not follow from what is cited".to_owned(), which]
        }
        Some(Behind::NotShown) => vec![
            "it does not follow from what is cited".to_owned(),
            "whether these meet the givens behind it was not shown".to_owned(),
        ],
    };
    if let Some(given) = link.would_do {
        told.push(format!("with {} cited too, it would follow", named(&[given])));
    }
    match told.is_empty() {
        true => String::new(),
        false => words(&format!(" ({})", told.join("; ")), form),
    }
}

/// That a given was not shown to be able to hold near a limit.
pub(super) fn unreached(
    unreached: &Unreached,
    context: &Context,
    label: &dyn Fn(usize) -> String,
    form: Form,
) -> String {
    let near = plain_formulas(form, context).moving(unreached.var, &unreached.at);
    let label = |index: usize| words(&label(index), form);
    let what = match (unreached.through, unreached.given) {
        (Some(through), Some(given)) => {
            format!("{} rests on {}, which", label(through), label(given))
        }
        (None, Some(given)) => label(given),
        (_, None) => "a premise".to_owned(),
    };
    format!("{what} was not shown to be able to hold as {near}")
}
