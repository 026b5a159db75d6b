//! Properties of one outcome at a time.

use kane_impact::{Contact, Law, Outcome};
use kane_kernel::Rel;
use kane_number::Rational;

use crate::applied::Premise;
use crate::cell::{Cell, Witness};
use crate::conjugate;
use crate::outcome::proved;
use crate::property::Template;
use crate::sample::{Exact, resolve, violation};
use crate::setting::{Setting, Symbolic};
use crate::stopped;
use crate::study::{Family, Located, Part, contact_at, locate};
use crate::work;

/// Decides a pointwise property: a witness among simple contacts, or a proof in every regime.
pub(crate) fn decide(
    law: &Law,
    families: &[Family],
    settings: &[Setting],
    template: &Template,
    answers: &[(Contact<Rational>, Exact)],
) -> Cell {
    let families: Vec<&Family> =
        families.iter().filter(|f| settings.contains(&f.setting)).collect();
    let mut faults = Vec::new();
    for (contact, outcome) in answers {
        if let Some(link) = violation(template, contact, outcome) {
            match witness(law, &families, template, contact, link) {
                Some(part) => return Cell::refuted(Witness::new(contact, outcome), part),
                None => faults.push(format!("{contact:?}")),
            }
        }
    }
    let (approaching, resting): (Vec<&Family>, Vec<&Family>) =
        families.iter().partition(|family| family.setting.approaches());
    let conjugate = || match template.is_of_energy() && !approaching.is_empty() {
        true => conjugate::energy(law, &approaching),
        false => Err(String::new()),
    };
    // a frame of the law's own is the better one to ask in
    let stands_turned = approaching.iter().any(|family| family.seen.is_some());
    let early = if stands_turned { conjugate().ok() } else { None };
    let (mut parts, rest) = match early {
        Some(parts) => (parts, resting),
        None => (Vec::new(), families),
    };
    let mut covered = false;
    for family in rest {
        if covered && family.setting.approaches() {
            continue;
        }
        let Err(open) = in_family(law, family, template, &mut parts) else { continue };
        if family.setting.approaches()
            && !stands_turned
            && let Ok(found) = conjugate()
        {
            parts.extend(found);
            covered = true;
            continue;
        }
        // one that is open is enough, and what cannot be proved takes longest
        let found = search(law, family, open.regime, template);
        return found.unwrap_or_else(|| Cell::undecided(open.why));
    }
    Cell::from_parts(parts, Vec::new())
}

/// A regime without a proof.
struct Open {
    regime: usize,
    why: String,
}

/// Proofs in every regime of a family.
fn in_family(
    law: &Law,
    family: &Family,
    template: &Template,
    parts: &mut Vec<Part>,
) -> Result<(), Open> {
    for regime in 0..family.regimes.len() {
        let mut directly = |family: &Family, index| in_regime(family, index, template);
        let found =
            stopped::each(law, family, regime, &mut directly).or_else(|_| directly(family, regime));
        parts.extend(found.map_err(|why| Open { regime, why })?);
    }
    Ok(())
}

fn in_regime(family: &Family, index: usize, template: &Template) -> Result<Vec<Part>, String> {
    let (outcome, solved) = match &family.solved[index] {
        Some((outcome, part)) => (outcome, Some(part)),
        None => (&family.regimes[index].outcome, None),
    };
    if matches!(family.setting, Setting::Stopped(_))
        && template.is_of_energy()
        && let Ok(parts) = stopped::energy(family, index)
    {
        return Ok(parts);
    }
    // each of two summands, where the sum itself is too much
    let found = prove(family, index, outcome, template).or_else(|why| {
        let summands = template.summands().ok_or_else(|| why.clone())?;
        prove(family, index, outcome, &summands).map_err(|_| why)
    });
    let resting = matches!(family.setting, Setting::RestingSphere | Setting::Resting);
    let found = match found {
        Err(why) if resting && template.is_of_energy() => {
            conjugate::regime(family, index).map_err(|_| why)
        }
        found => found,
    };
    let found = found.map(|parts| [solved.into_iter().cloned().collect(), parts].concat());
    if !template.is_of_energy() {
        return found;
    }
    let heavy = found.as_ref().map_or(usize::MAX, |parts| weight(parts));
    if heavy > LIGHT
        && let Ok(parts) = work::energy(family, index)
        && weight(&parts) < heavy
    {
        return Ok(parts);
    }
    found
}

/// Proofs of less weight are not looked for in another form.
const LIGHT: usize = 300;
/// What a premise weighs that is told before a proof.
const PREMISE: usize = 10;

/// How long proofs are to read.
fn weight(parts: &[Part]) -> usize {
    parts.iter().map(|part| PREMISE * part.labels.len() + part.steps().weight()).sum()
}

/// A witness that the kernel accepts.
fn witness(
    law: &Law,
    families: &[&Family],
    template: &Template,
    contact: &Contact<Rational>,
    link: usize,
) -> Option<Part> {
    families.iter().find_map(|family| {
        let Located { regime, point } = locate(law, family, contact)?;
        let applied = &family.regimes[regime];
        let demand = template.demands(&family.contact, &applied.outcome)?.swap_remove(link);
        let (when, conclusion) = family.relations(&demand)?;
        family.question(applied, when, conclusion, demand.text).refute(point).ok()
    })
}

/// A proof of every link in one regime.
fn prove(
    family: &Family,
    index: usize,
    outcome: &Outcome<Symbolic>,
    template: &Template,
) -> Result<Vec<Part>, String> {
    let regime = &family.regimes[index];
    let name = format!("{}, \"{}\"", family.setting.name(), regime.name);
    let Some(demands) = template.demands(&family.contact, outcome) else {
        return Err(format!("{name}: a ratio has no meaning"));
    };
    let mut parts = Vec::new();
    for demand in demands {
        let Some((when, conclusion)) = family.relations(&demand) else { continue };
        let mut question = family.question(regime, when, conclusion, demand.text.clone());
        if let Ok(part) = question.prove() {
            parts.push(part);
            continue;
        }
        let lemmas = family.lemmas[index].get_or_init(|| lemmas(family, index, outcome));
        let mut premises = regime.premises.clone();
        premises.extend(lemmas.iter().filter_map(|(label, part)| {
            Some(Premise::new(label.clone(), Vec::new(), proved(part)?.clone()))
        }));
        question.premises = &premises;
        let patient = family.setting == Setting::Sphere || regime.root.is_none();
        match if patient { question.prove_patiently() } else { question.prove() } {
            Ok(part) => {
                parts.extend(lemmas.iter().map(|(_, part)| part.clone()));
                parts.push(part);
            }
            Err(why) => return Err(format!("{name}: {}: {why}", demand.text)),
        }
    }
    Ok(parts)
}

/// A witness that the search finds in a regime where no proof was found.
fn search(law: &Law, family: &Family, index: usize, template: &Template) -> Option<Cell> {
    let regime = &family.regimes[index];
    for demand in template.demands(&family.contact, &regime.outcome)? {
        let Some((when, conclusion)) = family.relations(&demand) else { continue };
        let question = family.question(regime, when, conclusion, demand.text.clone());
        let Some((part, point)) = question.search() else { continue };
        let Some(contact) = contact_at(family, &point) else { continue };
        // the law itself has the last word
        let Ok(outcome) = resolve(law, &contact) else { continue };
        if violation(template, &contact, &outcome).is_some() {
            return Some(Cell::refuted(Witness::new(&contact, &outcome), part));
        }
    }
    None
}

/// What is proved first where a proof needs it: signs of the outcome, each from those before it.
fn lemmas(family: &Family, index: usize, outcome: &Outcome<Symbolic>) -> Vec<(String, Part)> {
    let regime = &family.regimes[index];
    let contact = &family.contact;
    let candidates = [
        ("p_n > 0", outcome.impulse.normal.clone(), Rel::Gt),
        ("v_1 >= 0", outcome.slip.clone(), Rel::Ge),
        ("v_1 <= 0", outcome.slip.clone(), Rel::Le),
        ("v + v_1 >= 0", outcome.slip.clone() + contact.slip(), Rel::Ge),
        ("p_t <= 0", outcome.impulse.tangential.clone(), Rel::Le),
    ];
    let mut found: Vec<(String, Part)> = Vec::new();
    let mut premises = regime.premises.clone();
    for (text, quantity, rel) in candidates {
        let relation = family.ranges.relation(&quantity, rel);
        let question = family.question(regime, Vec::new(), relation.clone(), text.to_owned());
        if let Ok(part) = question.on(&premises) {
            let label = format!("shown before: {text}");
            premises.push(Premise::new(label.clone(), Vec::new(), relation));
            found.push((label, part));
        }
    }
    found
}
