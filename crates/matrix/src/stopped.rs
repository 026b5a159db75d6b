//! Proofs about contacts on which the slip stops, as a process with Coulomb friction sees them.

use kane_impact::{Law, Restitution};
use kane_kernel::{Rel, Relation};
use kane_number::Number as _;

use crate::applied::{ACCEPTED, Premise, ROOT};
use crate::setting::{Setting, Symbolic};
use crate::stop::Stop;
use crate::study::{Family, Part, Question};

/// The kinds of contacts of a family on which the slip can stop.
fn kinds(setting: Setting) -> &'static [Stop] {
    match setting {
        Setting::Driving => {
            &[Stop::DrivingInCompression, Stop::Jamming, Stop::DrivingInRestitution]
        }
        Setting::Braking => &[
            Stop::SticksInCompression,
            Stop::SticksInRestitution,
            Stop::ReversesInCompression,
            Stop::ReversesInRestitution,
        ],
        _ => &[],
    }
}

/// The families of contacts that slow down, of a family that couples; none for laws that are not asked so.
pub(crate) fn families(law: &Law, family: &Family) -> Vec<Family> {
    if law.info.restitution == Restitution::Newton {
        return Vec::new();
    }
    let stops = kinds(family.setting).iter();
    stops.map(|stop| Family::new(&family.memo, law, Setting::Stopped(*stop))).collect()
}

/// Proves what is asked in a regime of a family.
type Prove<'f> = dyn FnMut(&Family, usize) -> Result<Vec<Part>, String> + 'f;

/// A proof in one regime of a family, as the process sees its contacts: first that they slow down.
pub(crate) fn each(
    law: &Law,
    family: &Family,
    index: usize,
    prove: &mut Prove<'_>,
) -> Result<Vec<Part>, String> {
    let regime = &family.regimes[index];
    let stopped = family.stopped.get_or_init(|| families(law, family));
    let place = |f: &Family| f.regimes.iter().position(|r| r.index == regime.index);
    let places: Vec<_> = stopped.iter().filter_map(|f| Some((f, place(f)?))).collect();
    if places.is_empty() {
        return Err("the slip does not stop, or the law is no process".to_owned());
    }
    let contact = &family.contact;
    let slowing = contact.slowing_rate();
    // v_t⁺ if it slid all the time, times W_nn - mu·W_tn
    let lasting = contact.slip().clone() * contact.separation_rate() - contact.closing() * &slowing;
    let guards = |p: &&Premise| p.label != ROOT && p.label != ACCEPTED;
    let mut premises: Vec<Premise> = regime.premises.iter().filter(guards).cloned().collect();
    let mut parts = Vec::new();
    for (claim, quantity, rel) in [
        ("mu*W_tt - W_tn > 0", slowing, Rel::Gt),
        ("v*(W_nn - mu*W_tn) < c*(mu*W_tt - W_tn)", lasting, Rel::Lt),
    ] {
        let relation = family.ranges.relation(&quantity, rel);
        let question = family.question(regime, Vec::new(), relation.clone(), claim.to_owned());
        parts.push(Question { premises: &premises, ..question }.prove_patiently()?);
        premises.push(Premise::new(format!("shown before: {claim}"), Vec::new(), relation));
    }
    for (family, index) in places {
        parts.extend(prove(family, index)?);
    }
    Ok(parts)
}

/// Proves in one regime that neither friction nor the normal force does work in all.
///
/// Friction slides until p and then takes what is left of `p_t` with a slip that changes linearly to
/// v_t⁺: E_f = −mu·p·v/2 + (p_t + mu·p)·v_t⁺/2. The rest of E_t + E_n is the work of the normal force.
pub(crate) fn energy(family: &Family, index: usize) -> Result<Vec<Part>, String> {
    let regime = &family.regimes[index];
    let (contact, outcome) = (&family.contact, &regime.outcome);
    let half = |x: Symbolic| x / Symbolic::one().double();
    let sliding = contact.slip().clone() / contact.slowing_rate() * contact.friction();
    let left = outcome.impulse.tangential.clone() + &sliding;
    let friction = half(left * &outcome.slip - sliding * contact.slip());
    let normal = outcome.work.tangential.clone() + &outcome.work.normal - &friction;
    let (mut parts, mut premises) = (Vec::new(), regime.premises.clone());
    let ask = |premises: &[Premise], claim: String, relation: Relation| {
        family.question(regime, Vec::new(), relation, claim).on(premises)
    };
    if let Some(root) = &regime.root {
        // first ≠, by the equation of the root; then >, without it
        let x = Symbolic::symbol(root.symbol);
        let of_root = |p: &&Premise| p.label == ROOT;
        let mut known: Vec<Premise> = premises.iter().filter(of_root).cloned().collect();
        for (claim, rel) in [("x != 0", Rel::Ne), ("x > 0", Rel::Gt)] {
            let relation = family.ranges.relation(&x, rel);
            let Ok(part) = ask(&known, claim.to_owned(), relation.clone()) else { break };
            parts.push(part);
            known.retain(|p| !p.is_equation());
            known.push(Premise::new(format!("shown before: {claim}"), Vec::new(), relation));
        }
        premises.extend(known.into_iter().filter(|p| p.label != ROOT));
    }
    for (name, work) in [("E_f", friction), ("E_t + E_n - E_f", normal)] {
        let simple = regime.root.as_ref().and_then(|root| root.reduced(&work));
        if let Some(simple) = &simple {
            let same = family.ranges.relation(&(work.clone() - simple), Rel::Eq);
            let claim = format!("{name}, by the equation of the root");
            parts.push(ask(&premises, claim, same)?);
        }
        let sign = family.ranges.relation(&simple.unwrap_or(work), Rel::Le);
        parts.push(ask(&premises, format!("{name} <= 0"), sign)?);
    }
    Ok(parts)
}
