//! Why this model, in sentences.

use super::Effort;
use super::evaluate::{Found, contact};
use super::judge::{Judged, Place, Verdict};
use super::model::{Mechanics, Model};
use super::reference::{Known, Reference};
use crate::resolver::COMPLIANT;
use crate::rounded::{at_least, at_most};
use crate::scene::{Scene, Setup};
use crate::simulate::Ending;
use kane_impact::compliant::{Compliance, Loss};
use kane_number::{Interval, Lane as _, Number as _, System};

/// A short number for prose.
pub(super) fn short(value: f64) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        "0".to_owned()
    } else if (1e-3..1e4).contains(&magnitude) {
        let digits = if magnitude < 0.1 { 4 } else { 3 };
        let text = format!("{value:.digits$}");
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        format!("{value:.1e}")
    }
}

pub(super) fn reasons(
    scene: &Scene,
    reference: &Reference,
    judged: &[Judged],
    chosen: Option<Model>,
    wanted: Option<Model>,
    effort: Effort,
) -> Vec<String> {
    let mut said = vec![format!(
        "The scene's own terms are {}{}.",
        reference.mechanics.words(),
        match (&reference.values, reference.known) {
            (Err(_), _) => "",
            (Ok(_), Known::Exactly) => ", known exactly",
            (Ok(_), Known::Enclosed) => ", enclosed by intervals",
            (Ok(_), Known::Documented) =>
                ", which slides all the time here as is documented of it; that is enclosed by intervals",
            (Ok(_), Known::Estimated) if scene.in_air() =>
                ", with flights through air, which have no closed form: they are followed in steps in f64, and how far that is off is an estimate from steps twice as long and no bound",
            (Ok(_), Known::Estimated)
                if matches!(reference.mechanics, Mechanics::NormalOnly | Mechanics::Law(_)) =>
                ", followed in floats of two lengths, because intervals lose it; the difference of the two is an estimate and no bound",
            (Ok(_), Known::Estimated) =>
                ", followed in steps; how far that is off is an estimate from finer and coarser steps and no bound",
        }
    )];
    said.extend(of_the_end(reference));
    said.extend(of_the_contact(scene, reference));
    said.extend(of_the_loss(scene, reference));
    if let Some(wanted) = wanted {
        said.push(format!("{wanted} was asked for."));
        said.extend(of_the_wanted(scene, judged, wanted));
    }
    // where only the one that was asked for was tried, nothing is known of the others
    let alone = wanted.is_some() && effort == Effort::Chosen;
    match chosen {
        Some(chosen) => of_the_choice(reference, judged, chosen, alone, &mut said),
        None if alone && reference.values.is_ok() => {}
        None => said.push(limit(scene, reference, judged)),
    }
    said.extend(of_the_inputs(scene, reference));
    said
}

/// What the stated uncertainty does, where that is more than what was asked, or may be.
fn of_the_inputs(scene: &Scene, reference: &Reference) -> Option<String> {
    let moved = || scene.asked.iter().zip(reference.spread.iter().flatten());
    let beyond: Vec<String> = moved()
        .filter(|(asked, spread)| spread.exceeds(asked.tolerance.to_f64()))
        .map(|(asked, spread)| {
            format!("{} by ±{} at least", asked.quantity, at_least(spread.at_least, short))
        })
        .collect();
    let open: Vec<String> = moved()
        .filter(|(asked, spread)| {
            let tolerance = asked.tolerance.to_f64();
            spread.may_exceed(tolerance) && !spread.exceeds(tolerance)
        })
        .map(|(asked, spread)| format!("{} within ±{}", asked.quantity, at_most(spread.by, short)))
        .collect();
    let mut said = Vec::new();
    if !beyond.is_empty() {
        said.push(format!(
            "What is not known of the state moves {}, more than the tolerance: no model mends that.",
            beyond.join(", ")
        ));
    }
    if !open.is_empty() {
        said.push(format!(
            "What is not known of the state moves {}, as far as it could be enclosed; at its corners it is within the tolerance.",
            open.join(", ")
        ));
    }
    (!said.is_empty()).then(|| said.join(" "))
}

/// Why a sphere's contact in space is one in a plane.
const IN_SPACE: &str = " At a sphere one contact at a time keeps the direction of its slip, so that friction stays in one plane through the normal.";

/// The run of the reference, over the uncertain inputs where there are such.
fn found(reference: &Reference) -> Option<&Found<Interval>> {
    match &reference.over {
        Some(Ok(found)) => Some(found),
        _ => reference.at.as_ref().ok(),
    }
}

/// That nothing meets any more before so many impacts have happened as are asked for.
fn of_the_end(reference: &Reference) -> Option<String> {
    let end = found(reference)?.end.as_ref().filter(|end| end.ending == Ending::Quiet)?;
    Some(match end.impacts {
        0 => "Nothing meets: no impact happens, and the answers are those of the start.".to_owned(),
        last => format!(
            "Nothing meets any more after impact {last}: the answers are those of the state right after it."
        ),
    })
}

/// Coupling and α.
fn of_the_contact(scene: &Scene, reference: &Reference) -> Option<String> {
    match &scene.setup {
        Setup::Tip(_) => Some(
            "The tip is off the normal through the centre of mass, so that the contact couples and neither direction can be left out.".to_owned(),
        ),
        Setup::Bodies(world) if world.corners.is_some() => Some(
            "A corner is off the normal through the centre of mass, so that its contact couples and neither direction can be left out.".to_owned(),
        ),
        Setup::Bodies(world) => {
            let found = found(reference)?;
            let meets = found.end.as_ref().is_none_or(|end| end.impacts > 0);
            if reference.mechanics == Mechanics::Chain || !meets {
                return None;
            }
            if found.no_slip {
                return Some("No impact has any slip, so that one dimension is enough.".to_owned());
            }
            let alpha = found.alpha?;
            let (low, high) = (alpha.lower().abs(), alpha.upper().abs());
            let (middle, half) = (f64::midpoint(low, high), (high - low).abs() / 2.0);
            let told = short(middle);
            let rounding = (told.parse().unwrap_or(middle) - middle).abs();
            // around the middle as it is told; what is less than its digits say is told by these
            let stated = if half > rounding.max(1e-12 * middle) {
                format!("{told} ± {}", at_most((half + rounding).next_up(), short))
            } else {
                told
            };
            let what = if reference.mechanics == Mechanics::NormalOnly {
                "there is no friction"
            } else if found.slides {
                "every impact slides all the time"
            } else {
                "not every impact slides all the time"
            };
            Some(format!(
                "Round bodies do not couple (W_tn = 0), so that normal and tangential motion separate; |alpha| = {stated} at the first impact, and {what}.{}",
                if world.is_in_space() { IN_SPACE } else { "" }
            ))
        }
    }
}

/// What e < 1 is taken to mean for an elastic contact, where that is not stated.
fn of_the_loss(scene: &Scene, reference: &Reference) -> Option<String> {
    let Setup::Bodies(world) = &scene.setup else { return None };
    let found = reference.at.as_ref().ok().filter(|found| found.estimated)?;
    let elastic = contact(scene, reference.mechanics).ok()?;
    let first = found.bounces.first()?;
    let e = world.map(|stated| Interval::from_rational(&stated.value));
    let e = e.restitution_of(first.encounter, &first.approach).ok()?.midpoint();
    if scene.loss.is_some() || e >= 1.0 {
        return None;
    }
    let mut said = format!(
        "For e < 1 the theory does not say how energy is lost along the normal; here it is {}",
        Loss::Recoil.words()
    );
    let first = found.bounces.first().filter(|bounce| bounce.regime == COMPLIANT);
    let others = first.and_then(|first| {
        let world = world.map(|stated| stated.value.to_f64());
        let mobility = world.mobility_ratio(first.encounter);
        let springs = elastic.stiffness_ratio.to_f64().recip();
        let compliance = Compliance::of_springs(mobility, springs, e).ok()?;
        let k = first.slip[1].checked_div(&first.slip[0])?.midpoint();
        Some((k, elastic.other_choices(compliance, found.alpha?.midpoint().abs())))
    });
    if let Some((k, others)) = others {
        let others: Vec<String> =
            others.iter().map(|(loss, k)| format!("with {} {}", loss.words(), short(*k))).collect();
        let others = others.join(" and ");
        said.push_str(&format!(", with k = {} at the first impact ({others})", short(k)));
    }
    said.push_str("; the difference counts as error, unless the scene states its `loss`.");
    Some(said)
}

/// What the model that was asked for lacks; `None` if it is good enough.
fn of_the_wanted(scene: &Scene, judged: &[Judged], wanted: Model) -> Option<String> {
    let found = judged.iter().find(|judged| judged.model == wanted)?;
    match &found.verdict {
        Verdict::Meets => None,
        Verdict::Misses { quantity, .. } => {
            let asked = scene.asked.iter().find(|asked| asked.quantity == *quantity)?;
            let (tolerance, off) = (asked.tolerance.to_f64(), in_words(&found.verdict));
            Some(match tolerance == 0.0 {
                true => {
                    format!("It is not good enough: {off}, where the exact value is asked for.")
                }
                false => format!("It is not good enough: {off}, more than {}.", short(tolerance)),
            })
        }
        Verdict::Uncertified(why) if wanted.system == System::Interval => {
            Some(format!("It is not judged: {why}."))
        }
        Verdict::Uncertified(_) | Verdict::Fails(_) => {
            Some(format!("It is not known to be good enough: {}.", in_words(&found.verdict)))
        }
    }
}

fn of_the_choice(
    reference: &Reference,
    judged: &[Judged],
    chosen: Model,
    alone: bool,
    said: &mut Vec<String>,
) {
    // the most costly of those passed over tells most; of each mechanics the best
    let passed = judged.iter().take_while(|judged| judged.model != chosen);
    let mut told: Vec<(Mechanics, &Judged)> = Vec::new();
    for judged in passed.filter(|judged| judged.model.mechanics != chosen.mechanics) {
        match told.iter_mut().find(|(mechanics, _)| *mechanics == judged.model.mechanics) {
            Some(slot) => slot.1 = judged,
            None => told.push((judged.model.mechanics, judged)),
        }
    }
    for (mechanics, judged) in told {
        said.push(format!("{}: {}.", capital(mechanics.words()), in_words(&judged.verdict)));
    }
    let same = chosen.mechanics == reference.mechanics;
    let equal = match (same, chosen.mechanics) {
        (true, _) => String::new(),
        (false, Mechanics::NormalOnly) => {
            ", which is as good here as the scene's own terms".to_owned()
        }
        (false, _) => ", which here is what the scene's own terms come to".to_owned(),
    };
    let found = judged.iter().find(|judged| judged.model == chosen);
    let worst = found.and_then(|judged| judged.errors.iter().flatten().copied().reduce(f64::max));
    let error = match (worst, reference.known) {
        (Some(0.0), Known::Exactly | Known::Enclosed) => ", exactly".to_owned(),
        (Some(error), Known::Exactly | Known::Enclosed) => {
            format!(", with no error above {}", at_most(error, short))
        }
        (Some(error), Known::Documented) => {
            format!(", with no error above {} as far as it slides", at_most(error, short))
        }
        (Some(error), Known::Estimated) => format!(", with an estimated error of {}", short(error)),
        (None, _) => String::new(),
    };
    // those after it are there to be compared
    let before = judged.iter().position(|judged| judged.model == chosen).unwrap_or(judged.len());
    let shorter = judged[..before]
        .iter()
        .rfind(|judged| judged.model.mechanics == chosen.mechanics)
        .map(|judged| format!("; {}: {}", judged.model.system, in_words(&judged.verdict)));
    let is = if alone { "Good enough is" } else { "Good enough and cheapest is" };
    said.push(format!(
        "{is} {}{equal}, in {}{error}{}.",
        chosen.mechanics.words(),
        chosen.system,
        shorter.unwrap_or_default()
    ));
}

/// Why none is good enough: the part that limits.
fn limit(scene: &Scene, reference: &Reference, judged: &[Judged]) -> String {
    match &reference.values {
        Err(failed) if failed.is_of_the_model() => {
            let part = match reference.mechanics {
                Mechanics::Compliant => "The tangential compliance of the contact",
                _ => "The law of impact",
            };
            format!("{part} limits the answer: {failed}.")
        }
        Err(failed) => format!(
            "The order of impacts limits the answer: rounding grows from impact to impact until nothing can be certified ({failed})."
        ),
        Ok(_) => {
            let of_reference =
                judged.iter().rfind(|judged| judged.model.mechanics == reference.mechanics);
            let part = match of_reference.map(|judged| &judged.verdict) {
                Some(Verdict::Misses { .. }) => "The number system limits the answer",
                _ => "What is known of the reference limits the answer",
            };
            let asked = scene.asked.iter().map(|asked| short(asked.tolerance.to_f64()));
            let asked: Vec<String> = asked.collect();
            format!("{part}: no model reaches {}.", asked.join(", "))
        }
    }
}

/// A verdict, to follow the name of a model.
pub(super) fn in_words(verdict: &Verdict) -> String {
    match verdict {
        Verdict::Meets => "good enough".to_owned(),
        Verdict::Misses { quantity, by, place } => {
            let place = match place {
                Place::Stated => "",
                Place::Corner => " within the stated uncertainty",
                Place::Near => " where a value is a hundredth off, and agrees here by chance",
            };
            format!("{quantity} is off by {}{place}", short(*by))
        }
        Verdict::Uncertified(why) => (*why).to_owned(),
        Verdict::Fails(reason) => format!("no answer ({reason})"),
    }
}

fn capital(words: &str) -> String {
    let mut chars = words.chars();
    chars
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + chars.as_str())
}
