//! The code of the laws run on symbols: what is proved here is proved about the code itself.
//!
//! Regime by regime, the impulse is computed on rational functions of v_t, a, W, μ, e and the root x.
//! Together with the regime's guards, the root's polynomial and its interval it must satisfy every
//! line of the statement, in the law's frame. An equation may hold identically, or modulo the polynomial of x; what
//! needs an inequality goes to the prover, and counts only with a certificate that the kernel
//! accepts.

use std::fmt::Write as _;

use kane::algebra::quotient::exact_quotient;
use kane::algebra::rational_function::RationalFunction;
use kane::algebra::syntax::{Scope, parse_relations};
use kane::audit::{Budget, prove_goal};
use kane::kernel::{
    Bound, Conclusion, Context, Expr, Fuel, Goal, Hypothesis, Link, Rel, Relation, Sentence, Var,
};
use kane::matrix::{absurd, compare, negated, rel};
use kane_impact::{Contact, Delassus, Equation, Law, RegimeOver, laws};
use kane_number::Number;

use crate::frames::as_given;
use crate::rational;
use crate::statement::{SYMBOLS, Statement, links, value};

/// The symbols of a contact that faces forwards, and of a root.
const NAMES: [&str; 8] = ["v", "a", "W_tt", "W_tn", "W_nn", "mu", "e", "x"];
const TN: usize = 3;
const ROOT: usize = 7;

/// v > 0, a > 0, W_tt > 0, W_nn > 0, μ > 0, 0 ≤ e ≤ 1: where k and i_x have a meaning. A statement
/// says nothing at the borders; there the code is held against the process and its limits.
fn context() -> Context {
    let at = |value: i64, strict| Some(Bound { value: rational(value, 1), strict });
    let vars = NAMES.iter().map(|&name| {
        let (lower, upper) = match name {
            "W_tn" | "x" => (None, None),
            "e" => (at(0, false), at(1, false)),
            _ => (at(0, true), None),
        };
        Var { name: name.into(), of: None, lower, upper }
    });
    Context { vars: vars.collect(), ..Context::default() }
}

type Symbolic = RationalFunction;

fn contact(coupled: bool) -> Contact<Symbolic> {
    let symbol = Symbolic::symbol;
    let tn = if coupled { symbol(TN) } else { Symbolic::zero() };
    let delassus = Delassus::unchecked(symbol(2), tn, symbol(4));
    Contact::unchecked(symbol(0), symbol(1), delassus, symbol(5), symbol(6))
}

/// The guards of a regime as relations.
fn guards(regime: &dyn RegimeOver<Symbolic>, at: &Contact<Symbolic>) -> Vec<Relation> {
    let relation = |(quantity, sign)| compare(&quantity, rel(sign), &Symbolic::zero());
    regime.guards(at).map(relation).collect()
}

fn given(relations: Vec<Relation>) -> Vec<Hypothesis> {
    let links = relations.into_iter().map(Link::Relation);
    let sentence = |link| Sentence { when: Vec::new(), links: vec![link] };
    links.map(|link| Hypothesis { sentence: sentence(link), given: true }).collect()
}

/// Whether the relation follows, with a certificate.
fn follows(
    hypotheses: Vec<Relation>,
    when: Vec<Relation>,
    conclusion: Relation,
) -> Result<(), String> {
    let goal = Goal {
        context: context(),
        hypotheses: given(hypotheses),
        behind: Vec::new(),
        when,
        conclusion: Conclusion::Link(Link::Relation(conclusion)),
    };
    // an empty regime is proved by the contradiction of its guards
    prove_goal(&goal, Budget::default()).map(|_| ()).map_err(|open| open.to_string())
}

/// All ways in which the regimes up to this one are passed over: of each, one guard fails.
fn passed_over(earlier: &[Vec<Relation>]) -> Vec<Vec<Relation>> {
    earlier.iter().fold(vec![Vec::new()], |ways, guards| {
        let extended = ways.iter().flat_map(|way| {
            guards.iter().map(move |guard| way.iter().cloned().chain([negated(guard)]).collect())
        });
        extended.collect()
    })
}

/// Steps on the way for where the prover needs them: each is proved like anything else before it
/// is used, and left out where it does not follow.
const LEMMAS: [&str; 4] = [
    "W_tn > 0",
    "(1 + e)*a*W_tt + W_tn*v > 0",
    "mu*W_tt*a - v*W_nn > 0",
    "v*W_nn - mu*W_tt*a >= 0",
];

/// Adds the lemmas that follow to what is known, the sign of p_n last. How many did.
fn add_lemmas(known: &mut Vec<Relation>, normal: &Symbolic) -> usize {
    let scope = Scope::of(&context());
    let parsed = LEMMAS.iter().flat_map(|text| parse_relations(text, &scope).expect("well formed"));
    let before = known.len();
    for lemma in parsed.chain([compare(normal, Rel::Gt, &Symbolic::zero())]) {
        if follows(known.clone(), Vec::new(), lemma.clone()).is_ok() {
            known.push(lemma);
        }
    }
    known.len() - before
}

/// How a line was shown.
#[derive(Default)]
struct Tally {
    identities: usize,
    certificates: usize,
    lemmas: usize,
    open: String,
}

impl Tally {
    /// Every line of the law's statement, in this regime, at what the law sees as this contact.
    fn regime(&mut self, law: &Law, index: usize, seen: &Contact<Symbolic>) {
        let coupled = !seen.delassus().tn().is_zero();
        let contact = as_given(law.symbolic(), seen);
        let regimes = law.symbolic().regimes();
        let regime = &*regimes[index];
        let earlier: Vec<_> = regimes[..index].iter().map(|r| guards(&**r, &contact)).collect();
        let root = Symbolic::symbol(ROOT);
        let outcome = regime.outcome(&contact, &root);
        let frame = law.symbolic().frame(&contact);
        let (seen, impulse, slip) = match &frame {
            None => (&contact, outcome.impulse.clone(), outcome.slip.clone()),
            Some(frame) => {
                let impulse = outcome.impulse.turned(&frame.turn);
                let slip = frame.contact.slip_after(&impulse);
                (&frame.contact, impulse, slip)
            }
        };
        let facing = seen.slip().clone() / Symbolic::symbol(0);
        let sliding = impulse.normal.clone() * seen.friction() * &facing;
        let Some(i_x) = (-impulse.tangential.clone()).checked_div(&sliding) else { return };
        let k = slip / seen.slip();
        let mut symbols = vec![k, i_x];
        symbols.push(seen.alpha().expect("v is no zero") / facing);
        symbols.extend([seen.restitution().clone(), seen.friction().clone()]);
        debug_assert_eq!(symbols.len(), SYMBOLS.len());
        let statement = Statement::of(law);
        symbols.extend(statement.parameters.iter().map(Symbolic::from_rational));

        let mut hypotheses = guards(regime, &contact);
        if frame.is_some() {
            // it faces forwards and approaches in its own frame, too
            hypotheses.push(compare(contact.slip(), Rel::Gt, &Symbolic::zero()));
            hypotheses.push(compare(contact.approach(), Rel::Gt, &Symbolic::zero()));
        }
        let polynomial = regime.equation(&contact).map(|equation| {
            let Equation { coefficients, between: (lower, upper) } = equation;
            let polynomial =
                coefficients.into_iter().rev().fold(Symbolic::zero(), |sum, c| sum * &root + c);
            hypotheses.push(compare(&lower, Rel::Le, &root));
            hypotheses.push(compare(&root, Rel::Le, &upper));
            hypotheses.push(compare(&polynomial, Rel::Eq, &Symbolic::zero()));
            polynomial
        });
        if coupled {
            let determinant = contact.delassus().determinant();
            hypotheses.push(compare(&determinant, Rel::Gt, &Symbolic::zero()));
        }
        for (number, line) in statement.lines.iter().enumerate() {
            for link in links(line) {
                let side = |expr: &Expr| value(expr, &symbols);
                let (lhs, rhs) = (side(&link.lhs), side(&link.rhs));
                if link.rel == Rel::Eq && vanishes(&(lhs.clone() - &rhs), polynomial.as_ref()) {
                    self.identities += 1;
                    continue;
                }
                let when: Vec<_> = line
                    .when
                    .iter()
                    .map(|when| compare(&side(&when.lhs), when.rel, &side(&when.rhs)))
                    .collect();
                for way in passed_over(&earlier) {
                    let mut known: Vec<_> = hypotheses.iter().cloned().chain(way).collect();
                    let conclusion = compare(&lhs, link.rel, &rhs);
                    let mut found = follows(known.clone(), when.clone(), conclusion.clone());
                    if found.is_err() {
                        self.lemmas += add_lemmas(&mut known, &impulse.normal);
                        found = follows(known, when.clone(), conclusion);
                    }
                    match found {
                        Ok(()) => self.certificates += 1,
                        Err(_) => {
                            let (id, name, line) = (law.info.id, regime.name(), number + 1);
                            writeln!(self.open, "{id}, {name}, line {line}, coupled {coupled}")
                                .expect("a string takes all");
                        }
                    }
                }
            }
        }
    }
}

/// Whether a function is zero, identically or wherever the polynomial of x is.
fn vanishes(function: &Symbolic, polynomial: Option<&Symbolic>) -> bool {
    let numerator = function.fraction().0;
    if function.is_zero() {
        return true;
    }
    polynomial.is_some_and(|polynomial| {
        exact_quotient(&numerator, &polynomial.fraction().0, &Fuel::new(u64::MAX)).is_some()
    })
}

impl Tally {
    fn visit(&mut self, law: &Law) {
        for index in 0..law.symbolic().regimes().len() {
            self.regime(law, index, &contact(false));
            if law.info.stated_for_coupling {
                self.regime(law, index, &contact(true));
            }
            // in a turned frame the slip may be backwards
            if law.symbolic().frame(&contact(false)).is_some() {
                self.regime(law, index, &contact(false).mirrored());
            }
        }
    }
}

#[test]
fn the_code_satisfies_its_statement_regime_by_regime() {
    let mut tally = Tally::default();
    for law in laws() {
        tally.visit(law);
    }
    let Tally { identities, certificates, lemmas, open } = tally;
    println!("{identities} identities, {certificates} certificates, {lemmas} lemmas");
    assert!(open.is_empty(), "the prover leaves open:\n{open}");
    assert!(identities >= 49 && certificates >= 434, "{identities}, {certificates}");
}

/// Without coupling in the law's frame: wherever a regime ends at a guard that includes its boundary, the regime that
/// takes over there gives the same impulse, so that it does not matter which of the two is asked.
#[derive(Default)]
struct Seams {
    agree: usize,
    open: String,
}

/// The relation with its boundary.
fn closed(relation: Relation) -> Relation {
    let rel = match relation.rel {
        Rel::Lt => Rel::Le,
        Rel::Gt => Rel::Ge,
        other => other,
    };
    Relation { rel, ..relation }
}

impl Seams {
    fn between(&mut self, law: &Law, first: usize, second: usize) {
        let contact = as_given(law.symbolic(), &contact(false));
        let regimes = law.symbolic().regimes();
        let guards = |index: usize| guards(&*regimes[index], &contact);
        let root = Symbolic::symbol(ROOT);
        let [here, there] = [first, second].map(|index| regimes[index].impulse(&contact, &root));
        if regimes[first].equation(&contact).is_some() {
            return; // the other regime's root would have to be told from this one's
        }
        let mut common = guards(second);
        if law.symbolic().frame(&contact).is_some() {
            common.push(compare(contact.slip(), Rel::Gt, &Symbolic::zero()));
            common.push(compare(contact.approach(), Rel::Ge, &Symbolic::zero()));
        }
        if let Some(equation) = regimes[second].equation(&contact) {
            let Equation { coefficients, between: (lower, upper) } = equation;
            let polynomial =
                coefficients.into_iter().rev().fold(Symbolic::zero(), |sum, c| sum * &root + c);
            common.push(compare(&lower, Rel::Le, &root));
            common.push(compare(&root, Rel::Le, &upper));
            common.push(compare(&polynomial, Rel::Eq, &Symbolic::zero()));
        }
        let others: Vec<_> = (0..second).filter(|&index| index != first).map(guards).collect();
        for (number, border) in guards(first).into_iter().enumerate() {
            // beyond a guard that both have is neither of the two
            if !matches!(border.rel, Rel::Ge | Rel::Le) || guards(second).contains(&border) {
                continue;
            }
            let mut border = vec![Relation { rel: Rel::Eq, ..border }];
            border.extend(
                guards(first).into_iter().enumerate().filter(|(n, _)| *n != number).map(|(_, g)| g),
            );
            // what fails a guard of the second regime does not lead to it
            let leads = |way: &Vec<Relation>| {
                !guards(second).iter().any(|guard| way.contains(&negated(guard)))
            };
            for way in passed_over(&others).into_iter().filter(leads) {
                let known: Vec<_> = common
                    .iter()
                    .chain(&border)
                    .cloned()
                    .chain(way.into_iter().map(closed))
                    .collect();
                let equal = compare(&here.tangential, Rel::Eq, &there.tangential);
                match follows(known, Vec::new(), equal) {
                    Ok(()) => self.agree += 1,
                    Err(reason) => {
                        let names = (regimes[first].name(), regimes[second].name());
                        writeln!(self.open, "{}: {names:?}: {reason}", law.info.id)
                            .expect("a string takes all");
                    }
                }
            }
        }
    }
}

impl Seams {
    fn visit(&mut self, law: &Law) {
        let count = law.symbolic().regimes().len();
        for first in 0..count {
            for second in first + 1..count {
                self.between(law, first, second);
            }
        }
    }
}

#[test]
fn regimes_agree_where_they_meet() {
    let mut seams = Seams::default();
    for law in laws() {
        seams.visit(law);
    }
    println!("{} seams", seams.agree);
    assert!(seams.open.is_empty(), "{}", seams.open);
}

/// Without coupling, the guards of a law that claims to cover every contact leave nothing out.
struct Cover(usize);

impl Cover {
    fn visit(&mut self, law: &Law) {
        if law.info.gap.is_some() {
            return;
        }
        let contact = contact(false);
        let regimes = law.symbolic().regimes();
        let guards: Vec<Vec<_>> = regimes.iter().map(|r| guards(&**r, &contact)).collect();
        for way in passed_over(&guards) {
            let empty = follows(way, Vec::new(), absurd());
            assert!(empty.is_ok(), "{}: {empty:?}", law.info.id);
            self.0 += 1;
        }
    }
}

#[test]
fn guards_leave_nothing_out_where_a_law_claims_to_cover_everything() {
    let mut cover = Cover(0);
    for law in laws() {
        cover.visit(law);
    }
    println!("{} ways to be in no regime, all empty", cover.0);
}
