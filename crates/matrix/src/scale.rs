//! Whether units of speed and of mass matter.

use kane_algebra::rational_function::expression;
use kane_impact::{Contact, Delassus, Equation, Law};
use kane_kernel::{Poly, Rel, Relation, exponent};
use kane_number::{Algebraic, Number, Rational};

use crate::applied::{Applied, Premise, RootOf, apply};
use crate::cell::{Cell, Witness};
use crate::sample::{Exact, resolve};
use crate::setting::{BETA, ROOTS, Symbolic};
use crate::study::{Family, Part, Question, add_root, locate};
use crate::visible::lowered;

/// What is measured in another unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Unit {
    Speed,
    Mobility,
}

impl Unit {
    fn scaled<N: Number>(self, contact: &Contact<N>, s: &N) -> Contact<N> {
        let w = contact.delassus();
        let times = |x: &N| x.clone() * s;
        let (slip, approach, w) = match self {
            Self::Speed => (times(contact.slip()), times(contact.approach()), w.clone()),
            Self::Mobility => {
                let w = Delassus::unchecked(times(w.tt()), times(w.tn()), times(w.nn()));
                (contact.slip().clone(), contact.approach().clone(), w)
            }
        };
        let (mu, e) = (contact.friction().clone(), contact.restitution().clone());
        Contact::unchecked(slip, approach, w, mu, e)
    }

    /// What the impulse is multiplied by.
    fn factor<N: Number>(self, s: &N) -> N {
        match self {
            Self::Speed => s.clone(),
            Self::Mobility => N::one() / s,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Speed => "p(s*v, s*a, W) = s*p(v, a, W)",
            Self::Mobility => "p(v, a, s*W) = p(v, a, W)/s",
        }
    }
}

const UNITS: [Unit; 2] = [Unit::Speed, Unit::Mobility];

/// Decides scale invariance.
pub(crate) fn decide(
    law: &Law,
    families: &[Family],
    answers: &[(Contact<Rational>, Exact)],
) -> Cell {
    for (contact, before) in answers.iter().take(60) {
        for unit in UNITS {
            let two = Rational::one().double();
            let scaled = unit.scaled(contact, &two);
            let Ok(after) = resolve(law, &scaled) else { continue };
            if same(before, &after, &unit.factor(&two)) {
                continue;
            }
            if let Some(part) =
                families.iter().find_map(|f| witness(law, f, contact, &scaled, unit))
            {
                let cell = Cell::refuted(Witness::new(contact, before), part);
                let witness = [cell.witness, vec![Witness::new(&scaled, &after)]].concat();
                return Cell { witness, ..cell };
            }
        }
    }
    let (mut parts, mut open) = (Vec::new(), Vec::new());
    for family in families {
        for unit in UNITS {
            if !open.is_empty() {
                break;
            }
            regimes(law, family, unit, &mut parts, &mut open);
        }
    }
    Cell::from_parts(parts, open)
}

fn same(before: &Exact, after: &Exact, factor: &Rational) -> bool {
    let exact = |outcome: &Exact| match outcome {
        Exact::Rational(o) => o.map(|x| Algebraic::from(x.clone())).impulse,
        Exact::Algebraic(o) => o.impulse.clone(),
    };
    let (p, q) = (exact(before), exact(after));
    let times = |x: &Algebraic| x.clone() * Algebraic::from(factor.clone());
    times(&p.tangential) == q.tangential && times(&p.normal) == q.normal
}

/// The identities of every regime.
fn regimes(law: &Law, family: &Family, unit: Unit, parts: &mut Vec<Part>, open: &mut Vec<String>) {
    let s = Symbolic::symbol(BETA);
    let scaled = unit.scaled(&family.contact, &s);
    let regimes = law.symbolic().regimes();
    for applied in &family.regimes {
        let regime = &regimes[applied.index];
        let mut equal: Vec<(&str, Symbolic, Symbolic)> = Vec::new();
        let mut fits = true;
        for ((here, _), (there, _)) in regime.guards(&family.contact).zip(regime.guards(&scaled)) {
            match factor(&here, &there) {
                Some(factor) => equal.push(("a guard", there, here * factor)),
                None => fits = false,
            }
        }
        let mut root = (Symbolic::zero(), Symbolic::zero());
        if let (Some(here), Some(of)) = (&applied.root, regime.equation(&scaled)) {
            let Equation { coefficients, between } = of;
            let there = RootOf { symbol: ROOTS[1], between, coefficients };
            match root_power(here, &there) {
                Some((m, ends)) => {
                    let f = s.powi(m).expect("s is not zero");
                    for (c, d) in here.coefficients.iter().zip(&there.coefficients) {
                        let by = factor(c, d).unwrap_or_else(Symbolic::one);
                        equal.push(("the root's polynomial", d.clone(), c.clone() * by));
                    }
                    let ((l, u), (low, high)) = (&here.between, &there.between);
                    if ends {
                        equal.push(("the lower end of the root", low.clone(), l.clone() * &f));
                        equal.push(("the upper end of the root", high.clone(), u.clone() * &f));
                    } else {
                        // the same polynomial on another interval: the root must be the only one
                        match only_root(family, applied, here) {
                            Ok(found) => parts.extend(found),
                            Err(why) => {
                                let place = (family.setting.name(), regime.name());
                                open.push(format!("{}, \"{}\", the root: {why}", place.0, place.1));
                                return;
                            }
                        }
                    }
                    let x = Symbolic::symbol(here.symbol);
                    root = (x.clone(), x * f);
                }
                None => fits = false,
            }
        }
        let here = regime.impulse(&family.contact, &root.0);
        let there = regime.impulse(&scaled, &root.1);
        let by = unit.factor(&s);
        equal.push(("p_t", there.tangential, here.tangential * &by));
        equal.push(("p_n", there.normal, here.normal * &by));
        if !fits {
            open.push(format!("{}, \"{}\": {}", family.setting.name(), regime.name(), unit.name()));
            continue;
        }
        for (what, there, here) in equal {
            // in lowest terms, equal functions have equal numerators and equal denominators
            let ((n, d), (m, c)) = (there.fraction(), here.fraction());
            for (p, q) in [(n, m), (d, c)] {
                if p == q && p.is_constant() {
                    continue;
                }
                let (lhs, rhs) = (expression(&p), expression(&q));
                let relation = Relation { lhs, rel: Rel::Eq, rhs };
                let claim = format!("{what}: {}", unit.name());
                let question = family.question(applied, Vec::new(), relation, claim);
                match question.on(&[]) {
                    Ok(part) => parts.push(part),
                    Err(why) => {
                        let place = (family.setting.name(), regime.name());
                        open.push(format!("{}, \"{}\", {what}: {why}", place.0, place.1));
                    }
                }
            }
        }
    }
}

/// A polynomial without a linear term has one root that is not negative: x² = y², x ≥ 0 and y ≥ 0
/// give x = y.
fn only_root(family: &Family, applied: &Applied, root: &RootOf) -> Result<Vec<Part>, String> {
    let [_, linear, _] = &root.coefficients[..] else { return Err("no square root".to_owned()) };
    if !linear.is_zero() || !root.between.0.is_zero() {
        return Err("no square root from 0 on".to_owned());
    }
    let [x, y] = [root.symbol, ROOTS[1]].map(Symbolic::symbol);
    let premise = |quantity: &Symbolic, rel| {
        Premise::new("two roots", Vec::new(), family.ranges.relation(quantity, rel))
    };
    let premises =
        [premise(&x, Rel::Ge), premise(&y, Rel::Ge), premise(&(x.square() - y.square()), Rel::Eq)];
    let claims = [("x >= y", x.clone() - &y), ("y >= x", y - x)];
    let prove = |(claim, quantity): &(&str, Symbolic)| {
        let relation = family.ranges.relation(quantity, Rel::Ge);
        let question = family.question(applied, Vec::new(), relation, (*claim).to_owned());
        Question { premises: &premises, ..question }.prove_patiently()
    };
    claims.iter().map(prove).collect()
}

/// m such that s^m·x is a root there where x is one here, and whether the interval follows.
fn root_power(here: &RootOf, there: &RootOf) -> Option<(i32, bool)> {
    let pairs: Vec<_> = here.coefficients.iter().zip(&there.coefficients).collect();
    let powers: Vec<Option<i32>> = pairs
        .iter()
        .map(|(c, d)| if c.is_zero() && d.is_zero() { Some(None) } else { power(c, d).map(Some) })
        .collect::<Option<_>>()?;
    // c_j·s^e_j with e_j + j·m the same for all j
    let same = |m: &i32| {
        let mut sums = (0..).zip(&powers).filter_map(|(j, e)| Some((*e)? + j * m));
        let first = sums.next();
        sums.all(|sum| Some(sum) == first)
    };
    let m = (-3..=3).find(same)?;
    let ends = [(&here.between.0, &there.between.0), (&here.between.1, &there.between.1)];
    let follows =
        |(l, k): &(&Symbolic, &Symbolic)| (l.is_zero() && k.is_zero()) || power(l, k) == Some(m);
    Some((m, ends.iter().all(follows)))
}

/// there/here, if that is a power of s.
fn factor(here: &Symbolic, there: &Symbolic) -> Option<Symbolic> {
    if here.is_zero() {
        return there.is_zero().then(Symbolic::one);
    }
    Symbolic::symbol(BETA).powi(power(here, there)?)
}

/// n such that there = s^n·here, read off lowest terms.
fn power(here: &Symbolic, there: &Symbolic) -> Option<i32> {
    let ((n, d), (m, c)) = (here.fraction(), there.fraction());
    let split = |p: &Poly| {
        let least = p.terms().map(|(m, _)| exponent(m, BETA)).min().unwrap_or(0);
        Some((lowered(p, &[(BETA, least)]), i32::try_from(least).ok()?))
    };
    let ((top, a), (bottom, b)) = (split(&m)?, split(&c)?);
    (top == n && bottom == d).then_some(a - b)
}

/// Both applications at a point, the second impulse not the multiple of the first.
fn witness(
    law: &Law,
    family: &Family,
    contact: &Contact<Rational>,
    scaled: &Contact<Rational>,
    unit: Unit,
) -> Option<Part> {
    let located = locate(law, family, contact)?;
    let mut point = located.point;
    let two = Rational::one().double();
    point.values.push((BETA, vec![two]));
    point.values.sort_by_key(|(v, _)| *v);
    let s = Symbolic::symbol(BETA);
    let (after, _) = apply(law, &unit.scaled(&family.contact, &s), &family.ranges, ROOTS[1]);
    let index = law.over().place(scaled)?;
    let there = after.iter().find(|applied| applied.index == index)?;
    if there.root.is_some() {
        let chosen = law.over().regime(&crate::sample::algebraic(scaled)).ok()?;
        add_root(&mut point, ROOTS[1], &chosen.root?)?;
    }
    let here = &family.regimes[located.regime];
    let premises: Vec<Premise> = [&here.premises[..], &there.premises].concat();
    let by = unit.factor(&s);
    let (p, q) = (&here.outcome.impulse, &there.outcome.impulse);
    [q.tangential.clone() - p.tangential.clone() * &by, q.normal.clone() - p.normal.clone() * &by]
        .iter()
        .find_map(|difference| {
            let relation = family.ranges.relation(difference, Rel::Eq);
            let question = family.question(here, Vec::new(), relation, unit.name().to_owned());
            Question { premises: &premises, ..question }.refute(point.clone()).ok()
        })
}
