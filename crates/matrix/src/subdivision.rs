//! Whether a law is a process: two parts of the normal impulse, one after the other, do what the
//! whole does.

use kane_impact::{Contact, Law};
use kane_kernel::{Point, Rel};
use kane_number::{Algebraic, Number, Ordered as _, Rational};

use crate::applied::{Applied, Premise, apply_some, with_root};
use crate::cell::{Cell, Witness};
use crate::sample::{Exact, algebraic, contacts};
use crate::setting::{BETA, ROOTS, Setting, Symbolic};
use crate::study::{Family, Part, Question, add_root};
use crate::visible::Condition;

/// The contact with other speeds.
fn at<N: Number>(contact: &Contact<N>, slip: N, approach: N) -> Contact<N> {
    let (w, mu, e) = (contact.delassus(), contact.friction(), contact.restitution());
    Contact::unchecked(slip, approach, w.clone(), mu.clone(), e.clone())
}

/// How the second part meets the slip that the first leaves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Left {
    Forwards,
    Nothing,
    Backwards,
}

impl Left {
    fn rel(self) -> Rel {
        match self {
            Self::Forwards => Rel::Gt,
            Self::Nothing => Rel::Eq,
            Self::Backwards => Rel::Lt,
        }
    }

    /// The slip turned forwards, and back.
    fn turned(self, slip: Symbolic) -> Symbolic {
        match self {
            Self::Forwards => slip,
            Self::Nothing => Symbolic::zero(),
            Self::Backwards => -slip,
        }
    }
}

/// A way in which the two parts and the whole can go.
struct Way<'a> {
    first: &'a Applied,
    left: Left,
    second: &'a Applied,
    whole: &'a Applied,
}

/// Decides invariance under subdivision on contacts that do not couple.
pub(crate) fn decide(law: &Law, family: &Family) -> Cell {
    if let Some(cell) = refuted(law, family) {
        return cell;
    }
    let (mut parts, mut open) = (Vec::new(), Vec::new());
    each(law, family, None, &mut |way, lemmas, premises| {
        let end = way.left.turned(way.second.outcome.slip.clone());
        let difference = end - &way.whole.outcome.slip;
        let question = question(family, &way, premises, &difference);
        match question.prove() {
            Ok(part) => {
                parts.extend(lemmas.iter().cloned());
                parts.push(part);
            }
            Err(why) => open.push(format!("{}: {why}", question.regime)),
        }
    });
    Cell::from_parts(parts, open)
}

fn question<'a>(
    family: &'a Family,
    way: &Way<'_>,
    premises: &'a [Premise],
    difference: &Symbolic,
) -> Question<'a> {
    Question {
        memo: &family.memo,
        context: &family.context,
        setting: family.setting.name(),
        regime: format!("{}, then {}; {}", way.first.name, way.second.name, way.whole.name),
        premises,
        when: Vec::new(),
        conclusion: family.ranges.relation(difference, Rel::Eq),
        claim: "v_1(v_1(v, a), b) = v_1(v, a + b)".to_owned(),
    }
}

/// A regime with its root put in, where it is a rational function, and the proof that it is.
fn solved(
    law: &Law,
    family: &Family,
    contact: &Contact<Symbolic>,
    applied: &Applied,
    before: &[Premise],
) -> (Applied, Option<Part>) {
    let Some(root) = &applied.root else { return (applied.clone(), None) };
    let premises = [before, &applied.premises].concat();
    let found = root.rational().into_iter().find_map(|value| {
        let x = Symbolic::symbol(root.symbol);
        let relation = family.ranges.relation(&(x - &value), Rel::Eq);
        let question = Question {
            premises: &premises,
            ..family.question(applied, Vec::new(), relation, "the root".to_owned())
        };
        let part = question.prove().ok()?;
        let outcome = with_root(law, contact, applied, &value);
        Some((Applied { outcome, ..applied.clone() }, Some(part)))
    });
    found.unwrap_or_else(|| (applied.clone(), None))
}

/// Is given a way, the proofs of its roots, and its premises.
type Found<'f> = dyn FnMut(Way<'_>, &[Part], &[Premise]) + 'f;

/// The numbers of the regimes that the first part, the second and the whole are in.
struct Regimes {
    first: usize,
    left: Left,
    second: usize,
    whole: usize,
}

/// All ways, or one, with the premises of each; roots are put in where all are asked for.
fn each(law: &Law, family: &Family, one: Option<&Regimes>, found: &mut Found<'_>) {
    let solve = one.is_none();
    let wanted = |of: fn(&Regimes) -> usize| match one.map(of) {
        Some(index) => index..index + 1,
        None => 0..law.symbolic().regimes().len(),
    };
    let contact = &family.contact;
    let (v, a) = (contact.slip().clone(), contact.approach().clone());
    let b = a.clone() * Symbolic::symbol(BETA);
    let together = at(contact, v, a + &b);
    let (wholes, _) = apply_some(law, &together, &family.ranges, ROOTS[2], wanted(|r| r.whole));
    let own = |contact: &Contact<Symbolic>, r: &Applied, before: &[Premise]| {
        if solve { solved(law, family, contact, r, before) } else { (r.clone(), None) }
    };
    for first in family.regimes.iter().filter(|r| wanted(|r| r.first).contains(&r.index)) {
        let (first, of_first) = own(contact, first, &[]);
        for left in [Left::Forwards, Left::Nothing, Left::Backwards] {
            if one.is_some_and(|one| one.left != left) {
                continue;
            }
            let mut premises = first.premises.clone();
            match family.ranges.condition(&first.outcome.slip, left.rel()) {
                Condition::Never => continue,
                Condition::Always => {}
                Condition::Where(relation) => {
                    premises.push(Premise::new("the slip left", Vec::new(), relation));
                }
            }
            let next = at(contact, left.turned(first.outcome.slip.clone()), b.clone());
            let (seconds, _) =
                apply_some(law, &next, &family.ranges, ROOTS[1], wanted(|r| r.second));
            for second in &seconds {
                let (second, of_second) = own(&next, second, &premises);
                for whole in &wholes {
                    let (whole, of_whole) = own(&together, whole, &[]);
                    let lemmas: Vec<Part> =
                        [&of_first, &of_second, &of_whole].into_iter().flatten().cloned().collect();
                    let premises = [&premises[..], &second.premises, &whole.premises].concat();
                    let way = Way { first: &first, left, second: &second, whole: &whole };
                    found(way, &lemmas, &premises);
                }
            }
        }
    }
}

/// Two parts and the whole, in exact numbers.
struct Trial {
    first: (Contact<Algebraic>, kane_impact::Outcome<Algebraic>),
    second: (Contact<Algebraic>, kane_impact::Outcome<Algebraic>),
    whole: (Contact<Algebraic>, kane_impact::Outcome<Algebraic>),
}

fn trial(law: &Law, contact: &Contact<Rational>, b: &Rational) -> Option<Trial> {
    let exact = algebraic(contact);
    let b = Algebraic::from(b.clone());
    let first = law.over().resolve(&exact).ok()?;
    let next = at(&exact, first.slip.clone(), b.clone());
    let second = law.over().resolve(&next).ok()?;
    let together = at(&exact, exact.slip().clone(), exact.approach().clone() + &b);
    let whole = law.over().resolve(&together).ok()?;
    Some(Trial { first: (exact, first), second: (next, second), whole: (together, whole) })
}

/// A simple contact at which the parts do not make the whole.
fn refuted(law: &Law, family: &Family) -> Option<Cell> {
    let parts: Vec<Rational> = [(1, 1), (2, 1), (1, 2), (1, 4), (4, 1)]
        .map(|(n, d)| Rational::new(n.into(), d.into()))
        .to_vec();
    // first where both parts are rational: a point has room for one root that is not
    refuted_among(law, family, &parts, true).or_else(|| refuted_among(law, family, &parts, false))
}

fn refuted_among(
    law: &Law,
    family: &Family,
    parts: &[Rational],
    rational_parts: bool,
) -> Option<Cell> {
    let is_rational = |contact: &Contact<Rational>, b: &Rational| {
        let Ok(first) = law.over().resolve(contact) else { return false };
        law.over().resolve(&at(contact, first.slip, b.clone())).is_ok()
    };
    let mut tried = 0;
    for contact in contacts(&[Setting::Sphere]) {
        for b in parts {
            if rational_parts && !is_rational(&contact, b) {
                continue;
            }
            let Some(trial) = trial(law, &contact, b) else { continue };
            if trial.second.1.slip == trial.whole.1.slip {
                tried += 1;
                if tried > 150 {
                    return None;
                }
                continue;
            }
            let Some(part) = witness(law, family, &contact, b, &trial) else { continue };
            let mut cell = Cell::refuted(
                Witness::new(&contact, &Exact::Algebraic(trial.first.1.clone().into())),
                part,
            );
            cell.reason = format!("{}, b = {b}", cell.reason);
            for (c, o) in [&trial.second, &trial.whole] {
                if let Some(c) = rational(c) {
                    cell.witness.push(Witness::new(&c, &Exact::Algebraic(o.clone().into())));
                }
            }
            return Some(cell);
        }
    }
    None
}

fn rational(contact: &Contact<Algebraic>) -> Option<Contact<Rational>> {
    let q = |x: &Algebraic| x.as_rational().cloned();
    let slip = q(contact.slip())?;
    Some(contact.map(|x| q(x).unwrap_or_else(|| slip.clone())))
}

fn witness(
    law: &Law,
    family: &Family,
    contact: &Contact<Rational>,
    b: &Rational,
    trial: &Trial,
) -> Option<Part> {
    let values = family.setting.values(contact)?;
    let mut point =
        Point { generator: None, values: values.into_iter().map(|(v, q)| (v, vec![q])).collect() };
    point.values.push((BETA, vec![b / contact.approach()]));
    point.values.sort_by_key(|(v, _)| *v);
    let mut regime = |contact: &Contact<Algebraic>, symbol: usize| {
        let chosen = law.over().regime(contact).ok()?;
        let index = law.over().place(&chosen.contact)?;
        if let Some(root) = &chosen.root {
            add_root(&mut point, symbol, root)?;
        }
        Some(index)
    };
    let first = regime(&trial.first.0, ROOTS[0])?;
    let second = regime(&trial.second.0, ROOTS[1])?;
    let whole = regime(&trial.whole.0, ROOTS[2])?;
    let sign = trial.first.1.slip.sign();
    let left = match (sign.is_greater(), sign.is_less()) {
        (Some(true), _) => Left::Forwards,
        (_, Some(true)) => Left::Backwards,
        _ => Left::Nothing,
    };
    let mut out = None;
    let here = Regimes { first, left, second, whole };
    each(law, family, Some(&here), &mut |way, _, premises| {
        let end = way.left.turned(way.second.outcome.slip.clone());
        let difference = end - &way.whole.outcome.slip;
        out = question(family, &way, premises, &difference).refute(point.clone()).ok();
    });
    out
}
