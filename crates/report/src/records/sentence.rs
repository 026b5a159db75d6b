//! One sentence that says what a log follows.

use kane_impact::Restitution as Hypothesis;
use kane_records::check::Check;
use kane_records::friction::{FrictionFit, FrictionLaw};
use kane_records::restitution::{NormalLaw, Restitution, Threshold};
use kane_records::statistics::percent;
use kane_records::study::Study;

use super::wording::{at_line, brief, factor, formats, friction};

/// What the log follows, in a sentence.
#[must_use]
pub fn headline(study: &Study) -> String {
    if study.rows == 0 {
        return match study.rejections.total() {
            0 => "The log has no impacts.".to_owned(),
            _ => "No row could be checked.".to_owned(),
        };
    }
    let mut parts = vec![normal(study)];
    parts.extend(tangential(study));
    parts.extend(below_the_cone(study));
    parts.extend(counts(study));
    parts.extend(energy(study));
    parts.extend(lever(study));
    let mut sentence = parts.join("; ");
    if let Some(first) = sentence.get(..1) {
        sentence = format!("{}{}", first.to_uppercase(), &sentence[1..]);
    }
    format!("{sentence}.")
}

/// Restitution.
fn normal(study: &Study) -> String {
    let Some(restitution) = &study.restitution else { return "nothing approaches".to_owned() };
    let [least, middle, greatest] = restitution.observed.map(brief);
    match restitution.law {
        NormalLaw::Stated => "restitution as stated".to_owned(),
        _ if other_hypothesis(study).is_some() => other_hypothesis(study).unwrap_or_default(),
        NormalLaw::Close => {
            let off = restitution.stated - restitution.consistent;
            format!(
                "restitution as stated to 0.01, off beyond rounding in {off} of {} impacts by up to {}",
                restitution.stated,
                brief(restitution.worst.0)
            )
        }
        NormalLaw::Threshold(threshold) => at_threshold(&threshold),
        NormalLaw::Constant => format!("restitution is {middle} whatever is stated"),
        NormalLaw::Depends => format!(
            "restitution is not as stated in {} of {} impacts: e is {least} to {greatest}{}",
            restitution.stated - restitution.close,
            restitution.stated,
            depending(restitution)
        ),
        NormalLaw::Unstated if least == greatest => format!("restitution is {middle}"),
        NormalLaw::Unstated => format!(
            "restitution, which is not stated, is {least} to {greatest}{}",
            depending(restitution)
        ),
    }
}

/// A law that gives every row by another hypothesis than Newton's.
fn other_hypothesis(study: &Study) -> Option<String> {
    let fit = study.consistent_laws().find(|fit| !fit.is_newton())?;
    let hypothesis = match fit.law.info.restitution {
        Hypothesis::Poisson => "Poisson's hypothesis",
        Hypothesis::Energetic => "the energetic hypothesis",
        Hypothesis::Newton => "Newton's hypothesis about a normal that leans",
    };
    Some(format!("restitution as stated by {hypothesis} ({})", fit.law.info.id))
}

fn at_threshold(threshold: &Threshold) -> String {
    let Threshold { factor: of, between: (low, high), misses_below, instead } = threshold;
    let side = if *misses_below { "below" } else { "above" };
    format!(
        "restitution is {} instead of the stated one where {} is {side} a threshold between {} and {}",
        brief(*instead),
        factor(*of),
        brief(*low),
        brief(*high)
    )
}

fn depending(restitution: &Restitution) -> String {
    let names: Vec<&str> = restitution.depends.iter().map(|(of, _)| factor(*of)).collect();
    match names.split_last() {
        None => String::new(),
        Some((one, [])) => format!(", depending on {one}"),
        Some((last, others)) => format!(", depending on {} and {last}", others.join(", ")),
    }
}

/// Friction given the measured normal impulse: the nearest law, and those that are not told from it.
fn tangential(study: &Study) -> Option<String> {
    let best = study.friction.first()?;
    let words = friction(best.law);
    let all = best.rows;
    let most = |rows: usize| rows * 10 >= all * 9;
    let unstated = study.friction.iter().all(|fit| fit.law == FrictionLaw::None);
    if unstated && best.consistent < all {
        return Some(format!("friction's law is not told without a stated mu{}", sliding(study)));
    }
    let others = || or_others(study, |fit| format!(", in {}", fit.close));
    Some(if best.consistent == all {
        let named = or_others(study, |_| String::new());
        let fit = match study.friction.iter().filter(|fit| fit.tied).count() {
            1 => "",
            2 => ", which fits every impact as well",
            _ => ", which fit every impact as well",
        };
        format!("friction {words}{named}{fit}")
    } else if best.close == all {
        format!("friction {words}, to 0.01 of k{}", others())
    } else if most(best.close) {
        format!("friction {words}, to 0.01 of k in {} of {all} impacts{}", best.close, others())
    } else if most(best.rough) {
        let which =
            if best.rough == all { "all".to_owned() } else { format!("{} of {all}", best.rough) };
        let named = or_others(study, |fit| format!(", in {}", fit.rough));
        let close = best.close;
        format!("friction {words}, to 0.05 of k in {which} impacts{named} and to 0.01 in {close}")
    } else if best.close * 2 >= all {
        format!(
            "friction {words}, to 0.01 of k in {} of {all} impacts{} (the nearest; no law that is known here gives all)",
            best.close,
            others()
        )
    } else {
        format!(
            "friction follows no law that is known here (the nearest {words}, in {} of {all} impacts{})",
            best.close,
            others()
        )
    })
}

/// How large friction is where contacts slide on, which is μ if it is Coulomb's.
fn sliding(study: &Study) -> String {
    let told = study.fits.iter().filter_map(|fit| fit.friction.filter(|mu| mu.high.is_finite()));
    let range = told.fold(None, |range, mu| match range {
        None => Some((mu.low, mu.high)),
        Some((low, high)) => Some((mu.low.min(low), mu.high.max(high))),
    });
    match range.map(|(low, high)| [low, high].map(brief)) {
        None => String::new(),
        Some([low, high]) if low == high => format!(" (it is {low}*p_n where contacts slide on)"),
        Some([low, high]) => format!(" (it is {low} to {high} of p_n where contacts slide on)"),
    }
}

/// The other laws that are not told from the first, each with its count.
fn or_others(study: &Study, count: impl Fn(&FrictionFit) -> String) -> String {
    let others = study.friction.iter().skip(1).filter(|fit| fit.tied);
    others.map(|fit| format!(", or {}{}", friction(fit.law), count(fit))).collect()
}

/// Impacts that slide with less friction than they could have.
fn below_the_cone(study: &Study) -> Option<String> {
    let best = study.friction.first()?;
    let checked = study.checked(Check::Sticks)?;
    let said = matches!(
        best.law,
        FrictionLaw::Compression | FrictionLaw::Share(_) | FrictionLaw::Coulomb | FrictionLaw::None
    );
    (said && checked.failed > 0)
        .then(|| format!("{} of {} impacts slide below the cone", checked.failed, checked.rows))
}

/// What is odd though no check fails by it.
fn counts(study: &Study) -> Vec<String> {
    let mut parts = Vec::new();
    let rows = study.rows;
    let is_none = study.friction.first().is_some_and(|best| best.law == FrictionLaw::None);
    let none = study.energy.frictionless;
    if none > 0 && !is_none {
        parts.push(format!("{none} of {rows} impacts slide without any friction"));
    }
    let bouncy = study.energy.bouncy;
    if bouncy > 0 {
        parts.push(format!(
            "e is above 1 in {bouncy} of {rows} impacts without a gain of energy, which mechanics allows"
        ));
    }
    let undecided = study.checks.iter().map(|checked| checked.undecided).max().unwrap_or(0);
    if undecided > 0 {
        parts.push(format!(
            "{undecided} of {rows} impacts are undecided, since too few numbers tell whether they were rounded to {}",
            formats(&study.precision.told)
        ));
    }
    parts
}

fn energy(study: &Study) -> Option<String> {
    let checked = study.checked(Check::Energy)?;
    let (line, finding) = checked.worst?;
    (checked.failed > 0).then(|| {
        format!(
            "energy is created in {} of {} impacts, {} of it at most{}",
            checked.failed,
            checked.rows,
            in_percent(finding.size()),
            at_line(line)
        )
    })
}

fn lever(study: &Study) -> Option<String> {
    let checked = study.checked(Check::Moment)?;
    let (middle, _) = study.arm?;
    (checked.failed > 0).then(|| {
        format!(
            "the impulse misses the stated contact point in {} impacts, the arm being off by {} in the median",
            checked.failed,
            in_percent(middle)
        )
    })
}

fn in_percent(share: f64) -> String {
    format!("{} %", brief(percent(share)))
}
