//! What the matrix of laws and properties calls proved, against the laws' exact answers at random
//! contacts; laws with planted faults; certificates that were tampered with.
//!
//! The formulas here are written out again, on outcomes alone: they share nothing with the symbols,
//! the families of contacts or the templates of the matrix. Which cells are proved is read from the
//! snapshot, which the program must print (`golden::matrix`).

use std::collections::BTreeMap;

use kane::kernel::{Certificate, Evidence, Fuel, Proof, check};
use kane::matrix::{Finding, PROPERTIES, Row, row};
use kane_impact::bodies::Direction;
use kane_impact::laws::{ChatterjeeRuina, LougeAdams};
use kane_impact::{
    Contact, Frame, Guard, ImpactLaw, Impulse, Law, LawInfo, NoImpulse, Outcome, Regime, Relation,
    laws,
};
use kane_number::{Algebraic, Number, Rational};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use crate::contacts::tame_contact;
use crate::statement::decoupled;
use crate::{cases, rational, two_to};

/// The proved cells of a law, by the columns of the snapshot.
fn proved() -> BTreeMap<String, Vec<&'static str>> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/matrix/text.snap");
    let text = std::fs::read_to_string(path).expect("the snapshot is committed");
    let rows = text.lines().skip_while(|line| !line.starts_with("law  ")).skip(1);
    let rows = rows.take_while(|line| !line.is_empty());
    let out: BTreeMap<_, _> = rows
        .map(|line| {
            let mut words = line.split_whitespace();
            let law = words.next().expect("a row has a name").to_owned();
            let cells: Vec<_> = words.collect();
            assert_eq!(cells.len(), PROPERTIES.len(), "{line}");
            let proved = PROPERTIES.iter().zip(cells).filter(|(_, cell)| *cell == "yes");
            (law, proved.map(|(property, _)| property.id).collect())
        })
        .collect();
    assert!(out.len() >= 18);
    out
}

type Exact = Contact<Algebraic>;
type Said = Outcome<Algebraic>;

/// The outcome in exact numbers: by rationals where they hold it.
fn resolve(law: &Law, contact: &Contact<Rational>) -> Result<Said, NoImpulse> {
    let exact = |x: &Rational| Algebraic::from(x.clone());
    match law.over().resolve(contact) {
        Err(NoImpulse::Unrepresentable { .. }) => law.over().resolve(&contact.map(exact)),
        other => other.map(|outcome| outcome.map(exact)),
    }
}

fn number(n: i64) -> Algebraic {
    Algebraic::from(rational(n, 1))
}

fn with_speeds(c: &Contact<Rational>, slip: Rational, approach: Rational) -> Contact<Rational> {
    let (w, mu, e) = (c.delassus().clone(), c.friction().clone(), c.restitution().clone());
    Contact::new(slip, approach, w, mu, e).expect("inside the domain")
}

/// Holds one law's proved cells against one contact that faces forwards, and its decoupled twin.
fn contradictions(law: &Law, proved: &[&str], contact: &Contact<Rational>) -> Vec<&'static str> {
    let sphere = decoupled(contact);
    let mut out = Vec::new();
    let mut ask = |id: &'static str, holds: &dyn Fn() -> bool| {
        if proved.contains(&id) && !holds() {
            out.push(id);
        }
    };
    let exact = |c: &Contact<Rational>| -> Exact { c.map(|x| Algebraic::from(x.clone())) };
    let zero = number(0);
    if let Ok(o) = resolve(law, &sphere) {
        let c = exact(&sphere);
        let bound = o.impulse.normal.clone() * c.friction();
        let (pt, v, after) = (&o.impulse.tangential, c.slip(), &o.slip);
        let change = c.delassus().tt().clone() * pt;
        ask("momentum", &|| change == after.clone() - v);
        ask("cone-sphere", &|| bound >= zero && *pt <= bound && -pt.clone() <= bound);
        ask("energy-tangential", &|| (after.clone() + v) * pt <= zero);
        ask("energy-sphere", &|| loss(&c, &o) <= zero);
        ask("sliding", &|| *after <= zero || *pt == -bound.clone());
        ask("reversal", &|| after <= v && -after.clone() <= *v);
    }
    if let Ok(o) = resolve(law, contact) {
        let c = exact(contact);
        let bound = o.impulse.normal.clone() * c.friction();
        let pt = &o.impulse.tangential;
        ask("cone", &|| bound >= zero && *pt <= bound && -pt.clone() <= bound);
        ask("energy", &|| loss(&c, &o) <= zero);
        let factor = rational(3, 7);
        let times = |x: &Algebraic| x.clone() * Algebraic::from(factor.clone());
        ask("scale", &|| {
            let faster =
                with_speeds(contact, contact.slip() * &factor, contact.approach() * &factor);
            let w = contact.delassus().map(|x| x * &factor);
            let lighter = Contact::unchecked(
                contact.slip().clone(),
                contact.approach().clone(),
                w,
                contact.friction().clone(),
                contact.restitution().clone(),
            );
            let (Ok(a), Ok(b)) = (resolve(law, &faster), resolve(law, &lighter)) else {
                return false;
            };
            a.impulse == o.impulse.map(times) && b.impulse.map(times) == o.impulse
        });
    }
    ask("exists-sphere", &|| resolve(law, &sphere).is_ok());
    ask("exists", &|| resolve(law, contact).is_ok());
    ask("odd", &|| {
        let still = with_speeds(&sphere, rational(0, 1), sphere.approach().clone());
        let opposite = |c: &Contact<Rational>| match (resolve(law, c), resolve(law, &c.mirrored()))
        {
            (Ok(a), Ok(b)) => {
                a.impulse.tangential == -b.impulse.tangential
                    && a.impulse.normal == b.impulse.normal
            }
            (a, b) => a.is_err() && b.is_err(),
        };
        opposite(&sphere) && opposite(&still)
    });
    ask("subdivision", &|| {
        let b = contact.approach() * rational(2, 3);
        let whole = with_speeds(&sphere, sphere.slip().clone(), sphere.approach() + &b);
        let Ok(first) = law.over().resolve(&exact(&sphere)) else { return true };
        let e = exact(&sphere);
        let next = Contact::unchecked(
            first.slip,
            Algebraic::from(b),
            e.delassus().clone(),
            e.friction().clone(),
            e.restitution().clone(),
        );
        match (law.over().resolve(&next), law.over().resolve(&exact(&whole))) {
            (Ok(parts), Ok(whole)) => parts.slip == whole.slip,
            _ => true,
        }
    });
    limits(law, &sphere, &mut ask);
    out
}

/// E_t + E_n = p·(v + v⁺)/2, from the impulse alone.
fn loss(c: &Exact, o: &Said) -> Algebraic {
    let (p, w) = (&o.impulse, c.delassus());
    let vt = c.slip().double() + w.tt().clone() * &p.tangential + w.tn().clone() * &p.normal;
    let vn = -c.approach().double() + w.tn().clone() * &p.tangential + w.nn().clone() * &p.normal;
    vt * &p.tangential + vn * &p.normal
}

/// The limits, at one slip that is far out: for alpha above 2^40 and below 2^-40.
fn limits(
    law: &Law,
    sphere: &Contact<Rational>,
    ask: &mut dyn FnMut(&'static str, &dyn Fn() -> bool),
) {
    let small = Algebraic::from(two_to(-20));
    let near = |x: Algebraic, to: i64| {
        let gap = x - number(to);
        gap <= small && -gap <= small
    };
    let alpha = sphere.alpha().expect("there is slip");
    for (far, large) in [(two_to(40), true), (two_to(-40), false)] {
        let slip = sphere.slip() * &alpha / far;
        let there = with_speeds(sphere, slip, sphere.approach().clone());
        let Ok(o) = resolve(law, &there) else { continue };
        let c = there.map(|x| Algebraic::from(x.clone()));
        let k = o.slip.clone() / c.slip();
        let sliding = o.impulse.normal.clone() * c.friction();
        let i = -(o.impulse.tangential.clone() / &sliding);
        if large {
            ask("C1", &|| near(k.clone(), -1));
            ask("C2", &|| near(i.clone(), 0));
            ask("continuity", &|| near(i.clone(), 0));
        } else {
            ask("C3", &|| near(k.clone(), 1));
            ask("C4", &|| near(i.clone(), 1));
        }
    }
}

struct Sampled<'a> {
    proved: &'a BTreeMap<String, Vec<&'static str>>,
    contact: &'a Contact<Rational>,
    faults: Vec<String>,
}

impl Sampled<'_> {
    fn visit(&mut self, law: &Law) {
        let proved = self.proved.get(law.info.id).map(Vec::as_slice).unwrap_or_default();
        for id in contradictions(law, proved, self.contact) {
            self.faults.push(format!("{}:{id} at {:?}", law.info.id, self.contact));
        }
    }
}

fn sample(count: u32) {
    let proved = proved();
    let zero = rational(0, 1);
    let config = cases(count);
    // a third of the contacts has no slip, no approach or no friction, and is drawn again
    let max_global_rejects = config.cases.max(1_024);
    let mut runner = TestRunner::new(ProptestConfig { max_global_rejects, ..config });
    let outcome = runner.run(&tame_contact(), |contact| {
        let flows = *contact.slip() != zero && *contact.approach() != zero;
        prop_assume!(flows && *contact.friction() != zero);
        let contact = if *contact.slip() < zero { contact.mirrored() } else { contact };
        let mut sampled = Sampled { proved: &proved, contact: &contact, faults: Vec::new() };
        for law in laws() {
            sampled.visit(law);
        }
        prop_assert!(sampled.faults.is_empty(), "{:?}", sampled.faults);
        Ok(())
    });
    outcome.expect("no sample contradicts a proved cell");
}

#[test]
fn a_thousand_contacts_contradict_no_proved_cell() {
    sample(1_000);
}

/// cargo test --release --test properties -- --ignored a_million_contacts, where `PROPTEST_CASES` replaces the number
#[test]
#[ignore = "a day"]
fn a_million_contacts_contradict_no_proved_cell() {
    sample(1_000_000);
}

/// Friction that drives the slip on, and only for speeds of approach below that of the slip.
#[derive(Clone)]
struct Planted;

impl ImpactLaw for Planted {
    const INFO: LawInfo = LawInfo {
        id: "planted",
        source: "a fault",
        statement: "i_x = -1",
        gap: Some("the approach is too fast"),
        ..LawInfo::PLAIN
    };

    fn normal_collision(&self) -> Option<Rational> {
        None
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        const {
            &[Regime {
                name: "driven on",
                guards: const {
                    &[Guard {
                        quantity: |_, contact: &Contact<N>| {
                            contact.slip().clone() - contact.approach()
                        },
                        relation: Relation::NotNegative,
                    }]
                },
                root: None,
                impulse: |_, contact, _| {
                    let normal = contact.closing() / contact.delassus().nn();
                    Impulse { tangential: normal.clone() * contact.friction(), normal }
                },
                // a slip that does not follow from the impulse
                slip: Some(|_, contact, _| contact.slip().double()),
                work: None,
            }]
        }
    }
}

fn finding(row: &Row, id: &str) -> Finding {
    let index = PROPERTIES.iter().position(|property| property.id == id).expect("it exists");
    row.cells[index].finding
}

fn planted() -> Row {
    row(&Law::new(Planted), &PROPERTIES.iter().collect::<Vec<_>>(), &mut || {})
}

#[test]
fn planted_faults_are_refuted_where_they_are() {
    let row = planted();
    for id in [
        "momentum",
        "C3",
        "C4",
        "energy-tangential",
        "energy-sphere",
        "energy",
        "sliding",
        "reversal",
        "exists-sphere",
        "exists",
    ] {
        assert_eq!(finding(&row, id), Finding::Refuted, "{id}");
    }
    for id in ["cone-sphere", "cone", "scale", "unique"] {
        assert_eq!(finding(&row, id), Finding::Proved, "{id}");
    }
}

/// A push along a normal of its own, four times as strong where the slip there exceeds the approach.
#[derive(Clone)]
struct PlantedJump(Direction<Rational>);

impl ImpactLaw for PlantedJump {
    const INFO: LawInfo =
        LawInfo { id: "planted-jump", source: "a fault", statement: "i_x = 0", ..LawInfo::PLAIN };

    fn frame<N: Number>(&self, contact: &Contact<N>) -> Option<Frame<N>> {
        let turn = self.0.map(N::from_rational);
        Some(Frame { contact: contact.turned(&turn), turn })
    }

    fn normal_collision(&self) -> Option<Rational> {
        None
    }

    fn regimes<N: Number>(&self) -> &'static [Regime<Self, N>] {
        fn push<N: Number>(law: &PlantedJump, contact: &Contact<N>, times: N) -> Impulse<N> {
            let Frame { turn, contact } = law.frame(contact).expect("it has one");
            let normal = contact.closing() / contact.delassus().nn() * times;
            Impulse { tangential: N::zero(), normal }.turned(&turn.mirrored())
        }
        const {
            &[
                Regime {
                    name: "slow",
                    guards: const {
                        &[Guard {
                            quantity: |law: &Self, contact: &Contact<N>| {
                                let seen = law.frame(contact).expect("it has one").contact;
                                seen.approach().clone() - seen.slip()
                            },
                            relation: Relation::NotNegative,
                        }]
                    },
                    root: None,
                    impulse: |law, contact, _| push(law, contact, N::one()),
                    slip: None,
                    work: None,
                },
                Regime {
                    name: "fast",
                    guards: &[],
                    root: None,
                    impulse: |law, contact, _| push(law, contact, N::one().double().double()),
                    slip: None,
                    work: None,
                },
            ]
        }
    }
}

#[test]
fn a_jump_in_a_frame_of_the_law_s_own_is_not_called_unique() {
    let law = Law::new(PlantedJump(Direction::of_half_tangent(&rational(1, 10))));
    let unique = PROPERTIES.iter().filter(|property| property.id == "unique");
    let row = row(&law, &unique.collect::<Vec<_>>(), &mut || {});
    assert_eq!(row.cells[0].finding, Finding::Undecided);
}

#[test]
fn a_law_that_creates_energy_in_its_own_frame_is_refuted_there() {
    let energy: Vec<_> =
        PROPERTIES.iter().filter(|p| ["energy-sphere", "energy"].contains(&p.id)).collect();
    let (restitution, tilt) = (rational(2, 1), rational(1, 10));
    let turned = Law::from(LougeAdams { tilt, restitution: restitution.clone() });
    let plain = Law::from(ChatterjeeRuina { restitution });
    for row in [row(&turned, &energy, &mut || {}), row(&plain, &energy, &mut || {})] {
        let findings: Vec<_> = row.cells.iter().map(|cell| cell.finding).collect();
        assert_eq!(findings, [Finding::Refuted; 2], "{}", row.law.info.id);
    }
}

#[test]
fn a_tampered_certificate_of_a_cell_is_rejected() {
    let row = planted();
    let parts: Vec<_> = row.cells.iter().flat_map(|cell| &cell.parts).collect();
    let fuel = || Fuel::new(100_000_000);
    let mut tampered = 0;
    for (index, part) in parts.iter().enumerate() {
        assert_eq!(check(&part.goal, &part.decided.certificate, fuel()), Ok(()));
        // the certificate of another goal
        let other = parts[(index + 1) % parts.len()];
        if other.decided.certificate.goal != part.decided.certificate.goal {
            assert!(check(&part.goal, &other.decided.certificate, fuel()).is_err());
            tampered += 1;
        }
        // a claim that a sum without a summand is positive
        let nothing = Proof::Positive { terms: Vec::new(), cofactors: Vec::new() };
        let absurd = Evidence::Contradiction(nothing);
        if part.decided.certificate.evidence != absurd {
            let certificate = Certificate { evidence: absurd, ..part.decided.certificate.clone() };
            assert!(check(&part.goal, &certificate, fuel()).is_err());
            tampered += 1;
        }
        // the same point against a goal that holds there: the conclusion turned round
        if let (
            Evidence::Model(_),
            kane::kernel::Conclusion::Link(kane::kernel::Link::Relation(r)),
        ) = (&part.decided.certificate.evidence, &part.goal.conclusion)
        {
            let mut goal = part.goal.clone();
            let turned = kane::matrix::negated(r);
            goal.conclusion = kane::kernel::Conclusion::Link(kane::kernel::Link::Relation(turned));
            let digest = kane::kernel::digest(&goal);
            let certificate = Certificate { goal: digest, ..part.decided.certificate.clone() };
            assert!(check(&goal, &certificate, fuel()).is_err());
            tampered += 1;
        }
    }
    assert!(tampered > 20, "{tampered}");
}
