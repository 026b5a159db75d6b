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

#[cfg(test)]
mod tests {
    use kane_kernel::{Approach, Conclusion, Poly, Side};
    use num_bigint::BigInt;

    use super::*;

    fn goal() -> Goal {
        let document = kane_audit::read("r.md", b"```kane\nvar a, b, c\n```\n").expect("symbols");
        let (hypotheses, behind, when) = (Vec::new(), Vec::new(), Vec::new());
        let context = document.context;
        Goal { context, hypotheses, behind, when, conclusion: Conclusion::Contradiction }
    }

    fn told(reason: &Reason) -> String {
        sentence(&goal(), reason, Form::Plain)
    }

    fn means(finding: Finding, substituted: Vec<Variable>) -> Reason {
        let (limits, tables, sums, signs) = (false, Vec::new(), false, false);
        Reason::Contradiction(Means { finding, limits, substituted, tables, sums, signs })
    }

    #[test]
    fn what_a_contradiction_shows_is_told_by_its_finding() {
        let directly = |finding| told(&means(finding, Vec::new()));
        assert_eq!(directly(Finding::Proved), "directly");
        assert_eq!(directly(Finding::Vacuous), "the hypotheses contradict each other, directly");
        // that something does not follow is refuted where it does
        assert_eq!(directly(Finding::Refuted), "it does follow, directly");
    }

    #[test]
    fn up_to_four_substituted_variables_are_named_and_more_are_counted() {
        let (a, z) = (Variable::Symbol(0), |i| Variable::Unnamed(i));
        let by = |all: Vec<Variable>| told(&means(Finding::Proved, all));
        // a further variable has its own name whatever stands before it
        assert_eq!(by(vec![a.clone(), z(7), z(9)]), "by substituting a, z7, z9");
        assert_eq!(by(vec![z(7), a.clone(), z(8), z(9)]), "by substituting z7, a, z8, z9");
        assert_eq!(by(vec![a; 5]), "by substituting 5 solved premises");
    }

    #[test]
    fn a_limit_says_by_the_signs_of_what_it_is_parted_and_whether_it_is_a_bound() {
        let of = |polys: Vec<Poly>| told(&Reason::LimitByCases(polys));
        assert_eq!(of(vec![Poly::var(0)]), "by the sign of a");
        assert_eq!(of(vec![Poly::var(0), Poly::var(1)]), "by the signs of a, b");
        let limit = |sense, num: Poly| {
            told(&Reason::Limit {
                side: Side { var: 0, at: None, above: true },
                power: 1,
                sense,
                quotient: (num, Poly::one()),
                variables: [0, 1, 2]
                    .map(Variable::Symbol)
                    .into_iter()
                    .chain([Variable::Germ])
                    .collect(),
            })
        };
        let b = Poly::var(1);
        assert_eq!(limit(Ordering::Equal, b.clone()), "a = 1/t gives b");
        assert_eq!(limit(Ordering::Less, b.clone()), "a = 1/t gives at most b");
        assert_eq!(limit(Ordering::Greater, b), "a = 1/t gives at least b");
        // sixty letters are told
        let long = |digits: u32| Poly::constant(BigInt::from(10).pow(digits - 1));
        assert_eq!(limit(Ordering::Equal, long(60)), format!("a = 1/t gives 1{}", "0".repeat(59)));
        let more = "a = 1/t gives a quotient of polynomials in t";
        assert_eq!(limit(Ordering::Equal, long(61)), more);
    }

    #[test]
    fn of_a_point_eight_symbols_are_named() {
        let at = |count: usize| {
            let one = kane_audit::Assignment {
                symbol: 0,
                value: kane_audit::Value::Number(num_rational::BigRational::new(
                    1.into(),
                    1.into(),
                )),
            };
            told(&Reason::Point { values: vec![one; count], claim: None })
        };
        assert_eq!(at(0), "everywhere");
        assert_eq!(at(8), format!("at {}", ["a = 1"; 8].join(", ")));
        assert_eq!(at(9), format!("{}, …", at(8)));
        assert_eq!(at(10), at(9));
    }

    #[test]
    fn where_nothing_varies_the_constants_are_named() {
        let context = goal().context;
        let told = |constants: &[usize]| nothing_varies(constants, 2, &context, Form::Plain);
        assert_eq!(
            told(&[0]),
            "nothing in it varies with c: a is a constant as declared, and would be a function as a(c)"
        );
        assert_eq!(
            told(&[1, 0]),
            "nothing in it varies with c: b, a are constants as declared, and would be a function as b(c)"
        );
    }

    #[test]
    fn a_given_that_was_not_reached_is_named_with_the_claim_that_rests_on_it() {
        let context = goal().context;
        let told = |given, through| {
            let unreached_at = Unreached { given, through, var: 0, at: Approach::PlusInf };
            let label = |i: usize| format!("({i})");
            unreached(&unreached_at, &context, &label, Form::Plain)
        };
        let ends = "was not shown to be able to hold as a -> oo";
        assert_eq!(told(Some(3), None), format!("(3) {ends}"));
        assert_eq!(told(Some(3), Some(5)), format!("(5) rests on (3), which {ends}"));
        assert_eq!(told(None, None), format!("a premise {ends}"));
    }

    #[test]
    fn up_to_three_givens_that_fail_are_named_and_more_are_counted() {
        let told = |failing: Vec<usize>| {
            let standing_of = Some(Standing::Unmet(failing));
            let link = LinkJudgement {
                verdict: Verdict::Refuted,
                standing: standing_of,
                ..LinkJudgement::default()
            };
            standing(&link, "at a = 1", &|i| format!("({i})"), Form::Plain)
        };
        let lead = "does not follow from what is cited, at a = 1";
        assert_eq!(told(vec![1]), format!("{lead} ((1) fails there)"));
        assert_eq!(told(vec![1, 2, 3]), format!("{lead} ((1), (2), (3) fail there)"));
        assert_eq!(told(vec![1, 2, 3, 4, 5]), format!("{lead} ((1), (2), (3), 2 more fail there)"));
    }
}
