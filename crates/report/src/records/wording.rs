//! The words for what a study finds.

use std::fmt::Write as _;

use kane_records::check::{Check, Finding};
use kane_records::fit::{Fitted, PairFit};
use kane_records::format::Format;
use kane_records::friction::{FrictionLaw, Pyramid};
use kane_records::replay::Replay;
use kane_records::restitution::Factor;
use kane_records::rigid::{LawFit, parameters};
use kane_records::schema::{Column, SCHEMA_VERSION, Word};
use kane_records::study::Study;
use kane_records::suspicion::Suspicion;
use kane_records::tally::Checked;
use kane_records::told::Told;
use kane_records::untold::Untold;
use kane_records::worst::Worst;

use super::RecordsReport;
use crate::shell::quoted_file;
use crate::wording::number_of;

/// A float in few digits.
pub(super) fn brief(value: f64) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e5).contains(&value.abs()) {
        let text = format!("{value:.4}");
        let text = text.trim_end_matches('0').trim_end_matches('.');
        text.to_owned()
    } else {
        format!("{value:.1e}")
    }
}

/// What a check asks.
pub(super) const fn asks(check: Check) -> &'static str {
    match check {
        Check::Reaction => "action and reaction add up to nothing",
        Check::Moment => "the impulse acts at the contact point, J*dw = r x p",
        Check::Pull => "the surfaces do not pull, p_n >= 0",
        Check::Penetration => "they do not go on into each other, v_n+ >= 0",
        Check::Cone => "friction is in its cone, |p_t| <= mu*p_n",
        Check::Opposes => "friction opposes the slip that is left",
        Check::Sticks => "friction below its bound leaves no slip",
        Check::Energy => "total energy does not rise",
        Check::Restitution => "restitution is as stated, v_n+ = e*a",
        Check::Order => "time does not go back",
    }
}

/// What a check asks, in two or three words.
pub(super) const fn asks_briefly(check: Check) -> &'static str {
    match check {
        Check::Reaction => "action = reaction",
        Check::Moment => "impulse at the contact point",
        Check::Pull => "no pull",
        Check::Penetration => "no penetration",
        Check::Cone => "friction in its cone",
        Check::Opposes => "friction opposes slip",
        Check::Sticks => "no slip below the cone",
        Check::Energy => "energy does not rise",
        Check::Restitution => "e as stated",
        Check::Order => "time does not go back",
    }
}

/// A pair of materials, and what is stated of it.
pub(super) fn pair(fit: &PairFit, study: &Study) -> String {
    let name = usize::try_from(fit.pair).ok().and_then(|pair| study.pairs.get(pair));
    let mut parts: Vec<String> = name.cloned().into_iter().collect();
    for (symbol, stated) in ["mu", "e"].iter().zip(fit.stated) {
        parts.extend(stated.map(|stated| format!("{symbol} = {stated}")));
    }
    if parts.is_empty() { "nothing stated".to_owned() } else { parts.join(", ") }
}

/// What came of a check.
pub(super) fn verdict(checked: &Checked) -> String {
    match (checked.rows, checked.failed, checked.undecided, checked.excused) {
        (0, ..) => "not asked".to_owned(),
        (_, 0, 0, _) => "holds".to_owned(),
        (_, 0, undecided, _) => format!("undecided in {undecided}"),
        (_, failed, _, Some(law)) => format!("fails in {failed}, as {law} has it"),
        (_, failed, 0, None) => format!("FAILS in {failed}"),
        (_, failed, undecided, None) => format!("FAILS in {failed}, undecided in {undecided}"),
    }
}

/// The worst residual, with what is allowed.
pub(super) fn residual(check: Check, finding: &Finding) -> String {
    let unit = check.unit();
    format!("{} of {} {unit}", brief(finding.residual), brief(finding.tolerance))
}

/// What a check asks, and what came of it, with the worst row where one fails.
pub(crate) fn told(checked: &Checked) -> (&'static str, String) {
    let rows = checked.rows;
    let worst = checked.worst.filter(|_| checked.failed + checked.undecided > 0);
    let worst = worst.map_or_else(String::new, |(_, finding)| {
        format!(", the worst {}", residual(checked.check, &finding))
    });
    let came = match checked.failed + checked.undecided {
        0 => format!("holds in {}", number_of(rows, "row")),
        _ => format!("{} of {}{worst}", verdict(checked), number_of(rows, "row")),
    };
    (asks(checked.check), came)
}

/// Of what a log is suspected.
pub(crate) fn suspicion(suspicion: &Suspicion) -> String {
    match suspicion {
        Suspicion::Degrees => {
            "spins look like degrees a second: J*dw is 57.3 times r x p; convert them to rad/s".to_owned()
        }
        Suspicion::Revolutions => {
            "spins look like revolutions a minute: J*dw is 9.55 times r x p; convert them to rad/s".to_owned()
        }
        Suspicion::Turned => {
            "spins count the other way: J*dw is -(r x p); count them from x to y, and see whether y points down".to_owned()
        }
        Suspicion::Lever(ratio) => format!(
            "J*dw is {} times r x p in most rows: an arm, a radius, a mass or an inertia is off by that much",
            brief(*ratio)
        ),
        Suspicion::Down => {
            "most bodies move apart before they collide: y points down, or the normal does not point out of body 2 into body 1".to_owned()
        }
    }
}

/// A law of friction, after "friction".
pub(super) fn friction(law: FrictionLaw) -> String {
    match law {
        FrictionLaw::None => "is absent".to_owned(),
        FrictionLaw::Coulomb => "is Coulomb's, which stops the slip".to_owned(),
        FrictionLaw::Compression => {
            "saturates at mu*p_n/(1 + e), as if friction were solved before restitution".to_owned()
        }
        FrictionLaw::Share(share) => {
            let as_if = match law.pyramid() {
                None => "",
                Some(Pyramid::Outer) => {
                    ", as along the diagonal of a pyramid that bounds each axis of the surface by mu*p_n"
                }
                Some(Pyramid::Inner) => {
                    ", as along the diagonal of a pyramid that bounds the sum of both axes by mu*p_n"
                }
            };
            format!("saturates at {}*mu*p_n{as_if}", brief(share))
        }
        FrictionLaw::Walton(beta) => {
            format!("is Walton's, which turns the slip back by beta0 = {}", brief(beta))
        }
        FrictionLaw::Smith => "is Smith's mean of the slips before and after".to_owned(),
        FrictionLaw::WangSuLi => "is Wang, Su and Li's (1 + k)/2 of mu*p_n".to_owned(),
        FrictionLaw::Uncapped => "is mu*p_n even where that reverses the slip".to_owned(),
    }
}

/// A law of friction in a table.
pub(super) fn friction_name(law: FrictionLaw) -> String {
    match law {
        FrictionLaw::None => "none".to_owned(),
        FrictionLaw::Coulomb => "Coulomb, stops the slip".to_owned(),
        FrictionLaw::Compression => "Coulomb, bound mu*p_n/(1 + e)".to_owned(),
        FrictionLaw::Share(share) => format!("Coulomb, bound {}*mu*p_n", brief(share)),
        FrictionLaw::Walton(beta) => format!("Walton, beta0 = {}", brief(beta)),
        FrictionLaw::Smith => "Smith".to_owned(),
        FrictionLaw::WangSuLi => "Wang, Su and Li".to_owned(),
        FrictionLaw::Uncapped => "mu*p_n, never stops".to_owned(),
    }
}

/// A factor in a sentence.
pub(super) const fn factor(factor: Factor) -> &'static str {
    match factor {
        Factor::Stated => "the stated e",
        Factor::Speed => "the approach speed",
        Factor::Slip => "the slip",
        Factor::Phase => "the phase within the step",
        Factor::Step => "the time step",
    }
}

/// A law with what was fitted of it.
pub(super) fn law(fit: &LawFit) -> String {
    let mut text = fit.law.info.id.to_owned();
    if fit.fitted {
        for (name, value) in parameters(&fit.law) {
            let _ = write!(text, ", {name} = {}", brief(value));
        }
    }
    text
}

/// What a law is called besides.
pub(super) fn alias(fit: &LawFit) -> &'static str {
    fit.law.info.engines
}

/// An interval of a coefficient.
pub(super) fn interval(fitted: &Fitted) -> String {
    let (low, high) = (brief(fitted.low), brief(fitted.high));
    if fitted.low.is_infinite() && fitted.high.is_infinite() {
        "any value".to_owned()
    } else if fitted.high.is_infinite() {
        format!("at least {low}")
    } else if low == high {
        low
    } else if fitted.one_value {
        format!("{low} to {high}")
    } else {
        format!("{low} to {high}, not one value")
    }
}

/// What that which a log leaves open is about.
pub(super) const fn untold_label(untold: &Untold) -> &'static str {
    match untold {
        Untold::Round => "laws",
        Untold::ConstantRestitution(_) | Untold::NothingSlides => "mu",
        Untold::NothingSticks | Untold::Same(Factor::Slip) => "slip",
        Untold::Same(Factor::Speed) => "speed",
        Untold::Same(Factor::Stated) => "e",
        Untold::Same(Factor::Phase) => "phase",
        Untold::Same(Factor::Step) => "time step",
        Untold::SameFriction(_) => "friction",
        Untold::NoCoefficients => "mu and e",
        Untold::Format(_) => "numbers",
    }
}

/// What a log leaves open.
pub(super) fn untold(untold: &Untold) -> String {
    match untold {
        Untold::Round => "no row couples normal and tangent: round bodies cannot tell Routh, Keller, Stronge and Kane-Levinson apart; rod tips would".to_owned(),
        Untold::ConstantRestitution(mu) => format!(
            "e is the same wherever impacts slide, so that a bound by e cannot be told from another friction coefficient, mu = {}",
            brief(*mu)
        ),
        Untold::NothingSlides => "no impact slides on: mu has a lower bound alone".to_owned(),
        Untold::NothingSticks => "every impact slides on: nothing is said of what happens where slip stops".to_owned(),
        Untold::Same(Factor::Speed) => "all impacts have one approach speed: a threshold of speed cannot be seen".to_owned(),
        Untold::Same(Factor::Stated) => "no two impacts differ in the stated e: what depends on it cannot be seen".to_owned(),
        Untold::Same(Factor::Phase) => "no two impacts differ in their phase within the step: what depends on it cannot be seen".to_owned(),
        Untold::Same(Factor::Step) => "no two impacts differ in their time step: what depends on it cannot be seen".to_owned(),
        Untold::Same(Factor::Slip) => "all impacts have one slip: what depends on it cannot be seen".to_owned(),
        Untold::SameFriction(laws) => {
            let names: Vec<String> = laws.iter().map(|law| friction_name(*law)).collect();
            format!("these give the same impulses here: {}", names.join("; "))
        }
        Untold::Format(told) => format!(
            "the numbers may have been rounded to {}, and may be {}: too few tell which, and a check that holds by the one and not by the other is undecided; --float says it",
            formats(told),
            told.or.map_or_else(String::new, Format::name)
        ),
        Untold::NoCoefficients => "mu or e is not stated, so that no rigid law can be asked".to_owned(),
    }
}

/// The formats of the numbers.
pub(super) fn formats(told: &Told) -> String {
    let own =
        told.columns().map(|(column, format)| format!("{} to {}", column.name(), format.name()));
    let own: Vec<String> = own.collect();
    let all = told.format.name();
    if own.is_empty() { all } else { format!("{all} ({})", own.join(", ")) }
}

/// What the log is.
pub(super) fn log_facts(report: &RecordsReport<'_>) -> String {
    let study = report.study;
    let precision = &study.precision;
    let told = match (study.format_stated, precision.told.or) {
        (true, _) => "as stated".to_owned(),
        (_, Some(or)) => format!("or {}, which too few tell", or.name()),
        _ => "as the numbers tell".to_owned(),
    };
    let mut text = format!("{} checked", number_of(study.rows, "row"));
    // without a number there is nothing to tell a format from
    if study.rows > 0 || study.format_stated {
        let _ = write!(text, ", numbers in {} ({told})", formats(&precision.told));
    }
    let rejected = study.rejections.total();
    if rejected > 0 {
        let _ = write!(text, ", {} REJECTED", number_of(rejected, "row"));
    }
    if u64::try_from(study.sampled).is_ok_and(|sampled| sampled < study.rows) {
        let _ = write!(text, "; laws are named on {} of them", study.sampled);
    }
    text
}

/// How to see what laws say of a row: with what the log was read by, where a command line read it.
pub(super) fn replayed(worst: &Worst, report: &RecordsReport<'_>) -> String {
    match &worst.replay {
        Replay::Flags(flags) => format!("kane collide {flags}"),
        Replay::File(_) if worst.line == 0 => {
            "kane collide FILE, with the collision that is in the JSON".to_owned()
        }
        Replay::File(_) => {
            let line = worst.line;
            let check = match report.command.starts_with("kane check ") {
                true => report.command.to_owned(),
                false => format!("kane check {}", quoted_file(report.log)),
            };
            format!("{check} --row {line} > row-{line}.toml; kane collide row-{line}.toml")
        }
    }
}

/// The line after a number, if it is known.
pub(super) fn at_line(line: u64) -> String {
    if line == 0 { String::new() } else { format!(" (line {line})") }
}

/// The line before a reason, if it is known.
fn before(line: u64) -> String {
    if line == 0 { String::new() } else { format!("line {line}: ") }
}

/// What one of the worst rows is called: its line and its own name, as far as it has them.
pub(super) fn name(worst: &Worst) -> String {
    let line = if worst.line == 0 { "a row".to_owned() } else { format!("line {}", worst.line) };
    if worst.id.is_empty() { line } else { format!("{line} ({})", worst.id) }
}

/// The rows that were rejected, kind by kind.
pub(super) fn rejected(study: &Study) -> Vec<String> {
    study
        .rejections
        .kinds()
        .map(|(kind, count, rows)| {
            let first: Vec<String> =
                rows.iter().map(|row| format!("{}{}", before(row.line), row.why)).collect();
            format!("{count} rejected, {kind} ({})", first.join("; "))
        })
        .collect()
}

/// The columns of the format, for `kane check --schema`.
#[must_use]
pub fn schema() -> String {
    let mut out =
        format!("kane records, version {SCHEMA_VERSION}: one row an impact, SI units\n\n");
    let rows = Column::all().into_iter().map(|column| (column.name(), column.meaning()));
    let words = Word::ALL.into_iter().map(|word| (word.name().to_owned(), word.meaning()));
    for (name, meaning) in rows.chain(words) {
        let _ = writeln!(out, "  {name:<24}{meaning}");
    }
    out.push_str(
        "\nNames without a unit are taken to be SI, and common spellings are understood: vx_pre, \
         linvel_x_before,\nomega_post, body2.mass, rx, restitution. --map vx1_pre_m_s=NAME renames. \
         Columns in _deg_s, _rpm, _mm\nand the like are refused. What is not given beyond the needed \
         columns is not checked.\n",
    );
    out
}

#[cfg(test)]
mod tests;
