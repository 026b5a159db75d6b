//! Energy in two parts, along directions that are conjugate under the operator.
//!
//! In any frame, with s = det W/W_nn and the slip q = v − (W_tn/W_nn)·v_n that a normal push leaves as
//! it is, the kinetic energy at the contact is v_n²/(2·W_nn) + q²/(2·s), so that an impulse changes it by
//!
//! ```text
//! E_t + E_n = E_u + E_q      E_u = (v_n⁺² − a²)/(2·W_nn)      E_q = p_t·(2·q + s·p_t)/2 = (q⁺² − q²)/(2·s)
//! ```
//!
//! Newton's restitution in that frame makes E_u = −(1 − e²)·a²/(2·W_nn). Energy does not depend on the
//! frame, so a law that stands in one of its own is asked there, on every planar contact at once.

use kane_impact::{Contact, Law, Outcome, Restitution};
use kane_kernel::{Expr, Poly, Rel, Relation};
use kane_number::Number as _;

use crate::applied::{ACCEPTED, Premise};
use crate::setting::{Setting, Symbolic};
use crate::study::{Family, Part, Question};

/// Proves that a law creates no energy on any contact that slips and approaches.
pub(crate) fn energy(law: &Law, approaching: &[&Family]) -> Result<Vec<Part>, String> {
    if law.info.restitution != Restitution::Newton {
        return Err("the restitution is not Newton's".to_owned());
    }
    let mut parts = Vec::new();
    for family in approaching {
        parts.extend(approach(family)?);
    }
    let memo = approaching.first().map(|family| family.memo.clone()).unwrap_or_default();
    for setting in Setting::seen() {
        let family =
            Family::seen(&memo, law, setting).ok_or("the law's frame depends on the contact")?;
        for index in 0..family.regimes.len() {
            parts.extend(regime(&family, index)?);
        }
    }
    Ok(parts)
}

/// That the law sees every contact of a family approach.
pub(crate) fn approach(family: &Family) -> Result<Vec<Part>, String> {
    let Some(frame) = &family.seen else { return Ok(Vec::new()) };
    let conclusion = family.ranges.relation(frame.contact.approach(), Rel::Gt);
    let ask = |regime| {
        family.question(regime, Vec::new(), conclusion.clone(), "a' > 0".to_owned()).prove()
    };
    family.regimes.iter().map(ask).collect()
}

/// E_u and E_q of an outcome, in the law's frame.
fn parts_of(family: &Family, outcome: &Outcome<Symbolic>) -> (Symbolic, Symbolic) {
    let (contact, impulse) = match &family.seen {
        Some(frame) => (&frame.contact, outcome.impulse.turned(&frame.turn)),
        None => (&family.contact, outcome.impulse.clone()),
    };
    let (w, a) = (contact.delassus(), contact.approach());
    let half = |x: Symbolic| x / Symbolic::one().double();
    let after = contact.separation_after(&impulse);
    let normal = half((after.square() - a.square()) / w.nn());
    let (q, s) = (left(contact), w.determinant() / w.nn());
    let tangential = half((q.double() + s * &impulse.tangential) * &impulse.tangential);
    (normal, tangential)
}

/// q = v + W_tn·a/W_nn
fn left(contact: &Contact<Symbolic>) -> Symbolic {
    let w = contact.delassus();
    contact.slip().clone() + contact.approach().clone() * w.tn() / w.nn()
}

const NO_DIVISOR: &str = "no divisor is 0";

/// The identity, and the sign of each part.
pub(crate) fn regime(family: &Family, index: usize) -> Result<Vec<Part>, String> {
    let regime = &family.regimes[index];
    let outcome = match &family.solved[index] {
        Some((outcome, _)) => outcome,
        None => &regime.outcome,
    };
    let mut parts: Vec<Part> = family.solved[index].iter().map(|(_, part)| part.clone()).collect();
    let (normal, tangential) = parts_of(family, outcome);
    let whole = outcome.work.tangential.clone() + &outcome.work.normal;
    let sum = Expr::Add(normal.to_expr().into(), tangential.to_expr().into());
    let divisor = Symbolic::new(&outcome.impulse.normal.fraction().1, &Poly::one());
    let divisor = family.ranges.relation(&divisor.expect("1 is not zero"), Rel::Ne);
    // where the regime is taken is enough, as the law sees it
    let asked =
        |p: &&Premise| p.label != ACCEPTED && family.asked.iter().all(|a| a.label != p.label);
    let mut premises: Vec<Premise> = regime.premises.iter().filter(asked).cloned().collect();
    for (claim, conclusion) in [
        (NO_DIVISOR, divisor),
        ("E_t + E_n = E_u + E_q", Relation { lhs: whole.to_expr(), rel: Rel::Eq, rhs: sum }),
        ("E_u <= 0", family.ranges.relation(&normal, Rel::Le)),
        ("E_q <= 0", family.ranges.relation(&tangential, Rel::Le)),
    ] {
        let question = Question {
            premises: &premises,
            ..family.question(regime, Vec::new(), conclusion.clone(), claim.to_owned())
        };
        let part = question.prove_patiently().map_err(|why| {
            format!("{}, \"{}\": {claim}: {why}", family.setting.name(), regime.name)
        });
        parts.push(part?);
        if claim == NO_DIVISOR {
            premises.push(Premise::new(format!("shown before: {claim}"), Vec::new(), conclusion));
        }
    }
    Ok(parts)
}
