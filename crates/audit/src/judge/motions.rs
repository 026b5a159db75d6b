//! Points of a goal that speaks of functions, and what of them counts.

use kane_kernel::{Conclusion, Evidence, Finding, Goal, Link, Model};

use crate::prove::{Decided, Prover, Verdicts};
use crate::{Document, Open};

/// Where derivatives of functions are spoken of, keeps a model only if functions pass through it for
/// which the premises hold for all points.
pub(super) fn only_motions(
    document: &Document,
    (resting, ids): (&Goal, &[usize]),
    complete: bool,
    found: &mut Verdicts,
) {
    let motion = &document.motion;
    // what is behind and cannot be held against a point has no hypothesis
    let all = resting.hypotheses.len() == ids.len();
    let met = |evidence: &Evidence| all && motion.is_met(resting, ids, evidence);
    found.model = found.model.take().filter(|model| met(&Evidence::Model(model.clone())));
    let model = |decided: &&Decided| matches!(decided.certificate.evidence, Evidence::Model(_));
    let unmet = |decided: &Decided| {
        let complete = complete || decided.certificate.goal == kane_kernel::digest(resting);
        !(complete && met(&decided.certificate.evidence))
    };
    if found.decided.as_ref().filter(model).is_some_and(unmet) {
        found.decided = None;
        found.open = Some(match motion.concerns_exponentials(resting) {
            true => Open::Exponential,
            false if motion.concerns_arcs(resting) => Open::Arc,
            false => Open::Motion,
        });
    }
}

/// Looks for a point where the exponentials of a goal are known: exp(0) is 1, and log(1) is 0.
pub(super) fn at_zero(
    document: &Document,
    (resting, ids): (&Goal, &[usize]),
    prover: &Prover<'_>,
    complete: bool,
    found: &mut Verdicts,
) {
    let motion = &document.motion;
    let pins = motion.pins(resting);
    let of_points = matches!(resting.conclusion, Conclusion::Link(Link::Relation(_)));
    if pins.is_empty() || !of_points || resting.hypotheses.len() != ids.len() {
        return;
    }
    let mut pinned = resting.clone();
    pinned.hypotheses.extend(pins);
    let met = |model: &Model| motion.is_met(resting, ids, &Evidence::Model(model.clone()));
    if found.decided.is_none() {
        let witness = [Finding::IllDefined, Finding::Refuted]
            .into_iter()
            .find_map(|finding| prover.witness_within(&pinned, resting, finding));
        if let Some((decided, _)) = witness.filter(|(_, model)| met(model)) {
            (found.decided, found.open, found.behind_met) = (Some(decided), None, true);
        }
    }
    if found.model.is_none() && complete {
        let model = prover.witness_within(&pinned, resting, Finding::Consistent);
        found.model = model.map(|(_, model)| model).filter(met);
    }
}
