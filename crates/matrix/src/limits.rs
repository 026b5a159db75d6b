//! Limits in alpha, by explicit bounds that hold from some alpha on.
//!
//! f → L for alpha → ∞ is proved as alpha·|f − L| ≤ C for all alpha ≥ T, and refuted as |f − L| ≥ C
//! for all alpha ≥ T; for alpha → 0 as |f − L| ≤ C·alpha for alpha ≤ T, and |f − L| ≥ C. C and T are
//! searched for. Such a bound is a statement about single contacts, so that it is proved regime by
//! regime like any other, also where a regime has a root.

use kane_impact::{Contact, Delassus, Law};
use kane_number::{Number as _, Rational, power_of};

use crate::cell::{Cell, Finding};
use crate::pointwise;
use crate::property::Template;
use crate::sample::{Exact, resolve, violation};
use crate::setting::Setting;
use crate::study::Family;

type Answers = Vec<(Contact<Rational>, Exact)>;

/// Decides `f -> L as alpha -> …`.
pub(crate) fn decide(law: &Law, families: &[Family], template: &str, infinite: bool) -> Cell {
    let (f, rest) = template.split_once(" -> ").expect("a limit has an arrow");
    let (limit, _) = rest.split_once(" as ").expect("a limit says where");
    let gap = match limit.strip_prefix('-') {
        _ if limit == "0" => f.to_owned(),
        Some(size) => format!("({f} + {size})"),
        None => format!("({f} - {limit})"),
    };
    let bare = gap.trim_start_matches('(').trim_end_matches(')');
    let answers = answers(law, infinite);
    if answers.iter().all(|(c, _)| !is_far(c, infinite)) {
        let end = if infinite { "large" } else { "small" };
        return Cell::not_applicable(format!("the law has no answer for {end} alpha"));
    }
    let ends: [&str; 3] = if infinite { ["1", "4", "64"] } else { ["1", "1/4", "1/64"] };
    let when = |end: &str| {
        let rel = if infinite { ">=" } else { "<=" };
        format!("when alpha {rel} {end}")
    };
    let bound = |c: &str, end: &str| {
        let when = when(end);
        if infinite {
            (
                format!("-{c} <= alpha*{gap} <= {c} {when}"),
                format!("alpha*abs({bare}) <= {c} {when}"),
            )
        } else {
            (
                format!("-{c}*alpha <= {gap} <= {c}*alpha {when}"),
                format!("abs({bare}) <= {c}*alpha {when}"),
            )
        }
    };
    let mut last = None;
    for (c, end) in grid(&["1", "2", "4", "16"], &ends) {
        let (text, told) = bound(c, end);
        if let Some(cell) = attempt(law, families, &text, &answers) {
            if cell.finding == Finding::Proved {
                return Cell { reason: told, ..cell };
            }
            last = Some(cell);
        }
    }
    for (c, end) in grid(&["1", "1/2", "1/4", "1/16"], &ends) {
        for text in
            [format!("{bare} >= {c} {}", when(end)), format!("{bare} <= -{c} {}", when(end))]
        {
            if let Some(cell) = attempt(law, families, &text, &answers) {
                if cell.finding == Finding::Proved {
                    return refuted(cell, text, infinite, &answers);
                }
                last = Some(cell);
            }
        }
    }
    last.unwrap_or_else(|| {
        Cell::undecided(
            "neither a bound on the distance from the limit nor one away from it was found",
        )
    })
}

/// Proves a bound if the samples do not speak against it.
pub(crate) fn attempt(
    law: &Law,
    families: &[Family],
    text: &str,
    answers: &[(Contact<Rational>, Exact)],
) -> Option<Cell> {
    let template = Template::new(text);
    if answers.iter().any(|(c, o)| violation(&template, c, o).is_some()) {
        return None;
    }
    Some(pointwise::decide(law, families, &[Setting::Sphere], &template, &[]))
}

/// All pairs, small places first.
fn grid<'a>(constants: &[&'a str], ends: &[&'a str]) -> Vec<(&'a str, &'a str)> {
    let mut out: Vec<(usize, (&str, &str))> = Vec::new();
    for (i, c) in constants.iter().enumerate() {
        out.extend(ends.iter().enumerate().map(|(j, end)| (i + j, (*c, *end))));
    }
    out.sort_by_key(|(cost, _)| *cost);
    out.into_iter().map(|(_, pair)| pair).collect()
}

fn is_far(contact: &Contact<Rational>, infinite: bool) -> bool {
    let alpha = contact.alpha().unwrap_or_else(Rational::zero);
    if infinite { alpha >= power_of(2, 20) } else { alpha <= power_of(2, 20).recip() }
}

/// A proved bound away from the limit, as a refutation, with an answer of the law close to the end.
fn refuted(
    cell: Cell,
    reason: String,
    infinite: bool,
    answers: &[(Contact<Rational>, Exact)],
) -> Cell {
    let close = answers.iter().find(|(c, _)| is_far(c, infinite));
    let witness = close.map(|(c, o)| crate::Witness::new(c, o)).into_iter().collect();
    Cell { finding: Finding::Refuted, reason, witness, ..cell }
}

/// What the law says towards the end, on contacts with v = a = W_nn = 1 and two ways to choose friction.
pub(crate) fn answers(law: &Law, infinite: bool) -> Answers {
    let mut out = Vec::new();
    for n in [0, 1, 2, 4, 6, 8, 12, 20] {
        let alpha = if infinite { power_of(2, n) } else { power_of(2, n).recip() };
        for e in [Rational::zero(), Rational::one(), power_of(2, 1).recip()] {
            // small friction, too: some laws accept only what creates no energy
            let small = (power_of(2, 3) * &alpha).recip();
            for mu in [Rational::one(), small] {
                let one = Rational::one;
                let tt = power_of(2, 1) * &alpha / (&mu * (one() + &e));
                let delassus = Delassus::unchecked(tt, Rational::zero(), one());
                let contact = Contact::unchecked(one(), one(), delassus, mu, e.clone());
                if let Ok(outcome) = resolve(law, &contact) {
                    out.push((contact, outcome));
                }
            }
        }
    }
    out
}

/// Decides whether friction vanishes with the slip: |p_t|·W_tt ≤ C·v, and p_t = 0 without slip.
pub(crate) fn continuous(
    law: &Law,
    families: &[Family],
    resting: &[(Contact<Rational>, Exact)],
) -> Cell {
    let template = Template::new("p_t = 0");
    let at_zero = pointwise::decide(law, families, &[Setting::RestingSphere], &template, resting);
    if at_zero.finding != Finding::Proved {
        return at_zero;
    }
    let mut answers = answers(law, true);
    answers.extend(self::answers(law, false));
    let mut last = None;
    for c in ["1", "2", "4"] {
        let text = format!("-{c}*v <= W_tt*p_t <= {c}*v");
        if let Some(cell) = attempt(law, families, &text, &answers) {
            if cell.finding == Finding::Proved {
                let parts = [at_zero.parts, cell.parts].concat();
                let reason = format!("W_tt*abs(p_t) <= {c}*v, and p_t = 0 when v = 0");
                return Cell { reason, parts, ..cell };
            }
            last = Some(cell);
        }
    }
    for c in ["1", "1/2", "1/4", "1/16"] {
        for end in ["1", "4"] {
            let text = format!("p_t <= -{c}*mu*p_n when alpha >= {end}");
            if let Some(cell) = attempt(law, families, &text, &answers) {
                if cell.finding == Finding::Proved {
                    return refuted(
                        cell,
                        format!("{text}, and alpha -> oo as v -> 0"),
                        true,
                        &answers,
                    );
                }
                last = Some(cell);
            }
        }
    }
    turned(law, families)
        .or(last)
        .unwrap_or_else(|| Cell::undecided("no bound on friction at small slip was found"))
}

/// Refutes continuity of a law whose normal leans also where the slip is small: of equal bodies with
/// mu = 1 and e = 0, friction keeps its share of the normal impulse however small the slip is.
fn turned(law: &Law, families: &[Family]) -> Option<Cell> {
    let one = Rational::one;
    let delassus = Delassus::unchecked(one(), Rational::zero(), one());
    let contact = Contact::unchecked(one(), power_of(2, 20), delassus, one(), Rational::zero());
    let outcome = resolve(law, &contact).ok()?;
    let answers = [(contact, outcome)];
    for side in ["p_t >= 1/16*p_n", "p_t <= -1/16*p_n"] {
        let text = format!("{side} when a >= 128*v, e = 0, mu = 1, W_tt = W_nn");
        let Some(cell) = attempt(law, families, &text, &answers) else { continue };
        if cell.finding == Finding::Proved {
            let [(contact, outcome)] = &answers;
            let witness = vec![crate::Witness::new(contact, outcome)];
            return Some(Cell { finding: Finding::Refuted, reason: text, witness, ..cell });
        }
    }
    None
}
