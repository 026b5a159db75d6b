//! Whether there is an outcome, and only one.

use kane_impact::{Contact, Law};
use kane_kernel::{Link, Point, Poly, Rel, Relation};
use kane_number::Rational;

use crate::applied::{ACCEPTED, Applied, Premise, ROOT, absurd};
use crate::cell::{Cell, Witness};
use crate::conjugate::approach;
use crate::setting::{ROOTS, Setting, Symbolic};
use crate::stopped;
use crate::study::{Family, Part, Question, impossible, locate};
use crate::visible::{Condition, negated};

/// Decides existence: a contact without an outcome, or proofs that there is none.
pub(crate) fn exists(
    law: &Law,
    families: &[Family],
    settings: &[Setting],
    silent: &[(Contact<Rational>, &'static str)],
) -> Cell {
    let families: Vec<&Family> =
        families.iter().filter(|f| settings.contains(&f.setting)).collect();
    for (contact, reason) in silent {
        if let Some(part) = families.iter().find_map(|family| unspoken(law, family, contact)) {
            let cell = Cell::refuted(Witness::silent(contact), part);
            return Cell { reason: format!("{}: {reason}", cell.reason), ..cell };
        }
    }
    let mut parts = Vec::new();
    for family in families {
        // one open goal is enough
        if let Err(why) = in_family(law, family, &mut parts) {
            return Cell::from_parts(parts, vec![format!("{}, {why}", family.setting.name())]);
        }
    }
    Cell::from_parts(parts, Vec::new())
}

fn in_family(law: &Law, family: &Family, parts: &mut Vec<Part>) -> Result<(), String> {
    if let Some(rest) = &family.rest {
        let claim = "some regime applies";
        let found = impossible(family, rest, "none".to_owned(), claim);
        parts.push(found.map_err(|why| format!("{claim}: {why}"))?);
    }
    for regime in 0..family.regimes.len() {
        let mut directly = |family: &Family, index| in_regime(family, index);
        let found =
            stopped::each(law, family, regime, &mut directly).or_else(|_| directly(family, regime));
        parts.extend(found?);
    }
    Ok(())
}

fn in_regime(family: &Family, index: usize) -> Result<Vec<Part>, String> {
    let regime = &family.regimes[index];
    let asked = obligations(family, regime).into_iter();
    asked
        .map(|(claim, premises, conclusion)| {
            let question = family.question(regime, Vec::new(), conclusion, claim.clone());
            let found = question.on(&premises);
            found.map_err(|why| format!("\"{}\", {claim}: {why}", regime.name))
        })
        .collect()
}

/// What must hold for a regime to have an outcome: the claim, on which premises, and the relation.
fn obligations(family: &Family, regime: &Applied) -> Vec<(String, Vec<Premise>, Relation)> {
    let ranges = &family.ranges;
    let without = |label: &[&str]| -> Vec<Premise> {
        regime.premises.iter().filter(|p| !label.contains(&p.label.as_str())).cloned().collect()
    };
    let mut out = Vec::new();
    let mut divisors: Vec<(Poly, bool)> = Vec::new();
    let mut add = |quantity: &Symbolic, early: bool| {
        for p in quantity.conditions() {
            let known = divisors.iter().any(|(q, _)| *q == p);
            if !known && !ranges.vanishes_nowhere(&p) {
                divisors.push((p, early));
            }
        }
    };
    if let Some(root) = &regime.root {
        add(&root.between.0, true);
        add(&root.between.1, true);
        root.coefficients.iter().for_each(|c| add(c, true));
    }
    add(&regime.outcome.impulse.tangential, false);
    add(&regime.outcome.impulse.normal, false);
    add(&regime.outcome.slip, false);
    for (p, early) in divisors {
        let premises = if early { without(&[ROOT, ACCEPTED]) } else { without(&[ACCEPTED]) };
        let quantity = Symbolic::new(&p, &Poly::one()).expect("1 is not zero");
        out.push(("no divisor is 0".to_owned(), premises, ranges.relation(&quantity, Rel::Ne)));
    }
    if let Some(root) = &regime.root {
        let (lower, upper) = &root.between;
        // which sign at which end is seen at the first that can be proved
        let (low, high) = (root.at(lower), root.at(upper));
        let ways = [
            [("p(l) <= 0", -low.clone()), ("p(u) >= 0", high.clone())],
            [("p(l) >= 0", low), ("p(u) <= 0", -high)],
        ];
        let holds = |(claim, quantity): &(&str, Symbolic)| {
            let (conclusion, premises) =
                (ranges.relation(quantity, Rel::Ge), without(&[ROOT, ACCEPTED]));
            let question = family.question(regime, Vec::new(), conclusion, (*claim).to_owned());
            question.on(&premises).is_ok()
        };
        let way = ways.iter().find(|way| way.iter().all(holds)).unwrap_or(&ways[0]);
        let span = ("l <= u", upper.clone() - lower);
        for (claim, quantity) in way.iter().chain([&span]) {
            let relation = ranges.relation(quantity, Rel::Ge);
            out.push(((*claim).to_owned(), without(&[ROOT, ACCEPTED]), relation));
        }
    }
    if let Some(quantity) = &regime.acceptance {
        out.push((
            "the law accepts the outcome".to_owned(),
            without(&[ACCEPTED]),
            ranges.relation(quantity, Rel::Ge),
        ));
    }
    out
}

/// A contact without an outcome as a point that the kernel accepts.
fn unspoken(law: &Law, family: &Family, contact: &Contact<Rational>) -> Option<Part> {
    let values = family.setting.values(contact)?;
    let none = law.over().place(contact).is_none();
    if none {
        let rest = family.rest.as_ref()?;
        let values = values.into_iter().map(|(v, q)| (v, vec![q])).collect();
        let question = Question {
            memo: &family.memo,
            context: &family.context,
            setting: family.setting.name(),
            regime: "none".to_owned(),
            premises: rest,
            when: Vec::new(),
            conclusion: absurd(),
            claim: "some regime applies".to_owned(),
        };
        return question.refute(Point { generator: None, values }).ok();
    }
    let located = locate(law, family, contact)?;
    let regime = &family.regimes[located.regime];
    let premises: Vec<Premise> =
        regime.premises.iter().filter(|p| p.label != ACCEPTED).cloned().collect();
    let relation = family.ranges.relation(regime.acceptance.as_ref()?, Rel::Ge);
    let question =
        family.question(regime, Vec::new(), relation, "the law accepts the outcome".to_owned());
    Question { premises: &premises, ..question }.refute(located.point).ok()
}

/// Decides uniqueness on a family; where a law stands in a frame of its own, as it sees contacts there.
pub(crate) fn unique(law: &Law, family: &Family) -> Cell {
    let (mut parts, mut open) = (Vec::new(), Vec::new());
    if family.seen.is_none() {
        one_impulse(family, &mut parts, &mut open);
        return Cell::from_parts(parts, open);
    }
    match approach(family) {
        Ok(found) => parts.extend(found),
        Err(why) => open.push(why),
    }
    for setting in Setting::seen() {
        match Family::seen(&family.memo, law, setting) {
            _ if !open.is_empty() => {}
            Some(family) => one_impulse(&family, &mut parts, &mut open),
            None => open.push("the law's frame depends on the contact".to_owned()),
        }
    }
    Cell::from_parts(parts, open)
}

/// One root a regime, and regimes that agree where they meet.
fn one_impulse(family: &Family, parts: &mut Vec<Part>, open: &mut Vec<String>) {
    for (index, regime) in family.regimes.iter().enumerate() {
        let Some(root) = &regime.root else { continue };
        if let Some((_, part)) = &family.solved[index] {
            parts.push(part.clone());
            continue;
        }
        let y = Symbolic::symbol(ROOTS[1]);
        let Some(second) = root.premises(&y, &family.ranges) else { continue };
        let premises = [&regime.premises[..], &second].concat();
        let difference = Symbolic::symbol(root.symbol) - &y;
        let relation = family.ranges.relation(&difference, Rel::Eq);
        let question = family.question(regime, Vec::new(), relation, "x = y".to_owned());
        match question.on(&premises) {
            Ok(part) => parts.push(part),
            Err(why) => open.push(format!("the root of \"{}\": {why}", regime.name)),
        }
    }
    for (first, here) in family.regimes.iter().enumerate() {
        for (second, there) in family.regimes.iter().enumerate().skip(first + 1) {
            // one open border is enough, and what cannot be proved takes longest
            if open.is_empty() {
                border(family, (first, here), (second, there), parts, open);
            }
        }
    }
}

/// Where a guard of the first regime that includes its border holds with equality, and the second
/// regime takes over beyond it, both give the same impulse.
fn border(
    family: &Family,
    (first, here): (usize, &Applied),
    (second, there): (usize, &Applied),
    parts: &mut Vec<Part>,
    open: &mut Vec<String>,
) {
    let label = |r: &Applied| format!("guard of \"{}\"", r.name);
    let outcome = |index: usize| match &family.solved[index] {
        Some((outcome, _)) => outcome.clone(),
        None => family.regimes[index].outcome.clone(),
    };
    let (mine, other) = (outcome(first), outcome(second));
    let roots = |r: &Applied| -> Vec<Premise> {
        r.premises.iter().filter(|p| p.label == ROOT || p.label == ACCEPTED).cloned().collect()
    };
    'borders: for (number, guard) in here.guards.iter().enumerate() {
        // beyond a guard that both ask, the second regime does not take over either
        if !matches!(guard.rel, Rel::Ge | Rel::Le) || there.guards.contains(guard) {
            continue;
        }
        let mut premises = vec![Premise::new(
            format!("border of \"{}\"", here.name),
            Vec::new(),
            Relation { rel: Rel::Eq, ..guard.clone() },
        )];
        let others = here.guards.iter().enumerate().filter(|(n, _)| *n != number);
        premises.extend(others.map(|(_, g)| Premise::new(label(here), Vec::new(), g.clone())));
        premises
            .extend(there.guards.iter().map(|g| Premise::new(label(there), Vec::new(), g.clone())));
        premises.extend(family.asked.iter().cloned());
        premises.extend(roots(here));
        premises.extend(roots(there));
        for (index, between) in family.regimes[..second].iter().enumerate() {
            if index == first {
                continue;
            }
            // passed over by a guard that the second regime does not ask too, border included: the second
            // regime is taken beyond, and so at, the border
            let own: Vec<Relation> =
                between.guards.iter().filter(|g| !there.guards.contains(g)).cloned().collect();
            let Some((last, others)) = own.split_last() else { continue 'borders };
            premises.push(Premise::new(
                format!("passed over: \"{}\"", between.name),
                others.iter().map(|g| negated(&closed(negated(g)))).collect(),
                closed(negated(last)),
            ));
        }
        for (claim, a, b) in [
            ("p_t = q_t", &mine.impulse.tangential, &other.impulse.tangential),
            ("p_n = q_n", &mine.impulse.normal, &other.impulse.normal),
        ] {
            let difference = a.clone() - b;
            let relation = match family.ranges.condition(&difference, Rel::Eq) {
                Condition::Never => absurd(),
                _ => family.ranges.relation(&difference, Rel::Eq),
            };
            let names = format!("{} | {}", here.name, there.name);
            let question = Question {
                regime: names.clone(),
                premises: &premises,
                ..family.question(here, Vec::new(), relation, claim.to_owned())
            };
            match question.prove() {
                Ok(part) => parts.push(part),
                Err(why) => {
                    let place = family.setting.name();
                    open.push(format!("{place}, the border of {names}: {why}"));
                }
            }
        }
    }
}

/// The relation with its border.
fn closed(relation: Relation) -> Relation {
    let rel = match relation.rel {
        Rel::Lt => Rel::Le,
        Rel::Gt => Rel::Ge,
        other => other,
    };
    Relation { rel, ..relation }
}

/// The relation that a part proves.
pub(crate) fn proved(part: &Part) -> Option<&Relation> {
    match &part.goal.conclusion {
        kane_kernel::Conclusion::Link(Link::Relation(relation)) => Some(relation),
        _ => None,
    }
}
