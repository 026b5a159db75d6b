//! A finding in one sentence.

use std::cmp::Ordering;

use kane_audit::{LinkJudgement, Means, Reason, Standing, Unreached, Variable, Verdict};
use kane_kernel::{Context, Finding, Goal};

use super::formula::Formulas;
use super::value::{assigned, assigned_briefly, comparison, end, plain_formulas};
use super::{Form, words};

/// Of a claim with a counterexample at which every given above holds.
const FALSE: &str = "false under all that was assumed";
/// Of a claim with a counterexample at which what is cited holds.
const DOES_NOT_FOLLOW: &str = "does not follow from what is cited";

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
        Reason::LimitByCases(polys) => {
            let told = polys.iter().map(|p| formulas.poly(p)).collect::<Vec<_>>().join(", ");
            let sign = if polys.len() == 1 { "sign" } else { "signs" };
            format!("by the {sign} of {told}")
        }
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
            let mut at = assigned_briefly(&formulas, values);
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

/// Failing givens that are named in a sentence.
const MOST_FAILING: usize = 3;

/// The sentence of a finding by a witness, with how it stands to what was assumed: before it, whether the claim is false or
/// does not follow; behind it, which givens fail there, and which would do.
pub(super) fn standing(
    link: &LinkJudgement,
    told: &str,
    label: &dyn Fn(usize) -> String,
    form: Form,
) -> String {
    let Some(standing) = &link.standing else { return told.to_owned() };
    let lead = match (link.verdict, standing) {
        (Verdict::IllDefined, Standing::AllMet) => "undefined under all that was assumed",
        (Verdict::IllDefined, _) => "what is cited does not make it defined",
        (_, Standing::AllMet) => FALSE,
        (_, Standing::Unmet(_) | Standing::NotShown) => DOES_NOT_FOLLOW,
    };
    // what is found at a point or for functions goes on with them, what is found without any stands alone
    let goes_on = ["at ", "for ", "everywhere"].iter().any(|start| told.starts_with(start));
    let mark = if goes_on { "," } else { ":" };
    let mut parts = Vec::new();
    match standing {
        Standing::AllMet => {}
        Standing::Unmet(failing) => {
            let mut names: Vec<String> =
                failing.iter().take(MOST_FAILING).map(|i| label(*i)).collect();
            let more = failing.len().saturating_sub(MOST_FAILING);
            if more > 0 {
                names.push(format!("{more} more"));
            }
            let fail = if failing.len() == 1 { "fails" } else { "fail" };
            parts.push(format!("{} {fail} there", names.join(", ")));
        }
        Standing::NotShown => {
            parts.push("whether every given above can hold there was not shown".to_owned());
        }
    }
    if let Some(given) = link.would_do {
        parts.push(format!("with {} cited too, it would follow", label(given)));
    }
    let behind = match parts.is_empty() {
        true => String::new(),
        false => words(&format!(" ({})", parts.join("; ")), form),
    };
    format!("{lead}{mark} {told}{behind}")
}

/// That nothing in a limit varies with its variable, and what is a constant there by its declaration.
pub(crate) fn nothing_varies(
    constants: &[usize],
    along: usize,
    context: &Context,
    form: Form,
) -> String {
    let formulas = plain_formulas(form, context);
    let along = formulas.symbol(along);
    let names: Vec<String> = constants.iter().map(|v| formulas.symbol(*v)).collect();
    let are = if names.len() == 1 { "is a constant" } else { "are constants" };
    let first = names.first().map_or("", String::as_str);
    format!(
        "nothing in it varies with {along}: {} {are} as declared, and would be a function as {first}({along})",
        names.join(", ")
    )
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
