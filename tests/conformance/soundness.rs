//! Nothing false is accepted, whoever asks.
//!
//! What is false is decided by evaluation at an exact point, which shares no code with the kernel.
//! Each false statement is given to the search, whose findings must not be `proved` or `vacuous`,
//! and to the kernel with the certificate of a true statement much like it: as it is, and mutated.
//!
//! The suite was tried on kernels with planted errors: all certificates or all points accepted;
//! strictness not asked of a sum, or not on the faces of an orthant; odd powers of a lead of unknown
//! sign below an inequality; `<` read as `<=`; a quotient without its condition; a sign table
//! without its roots; an absolute value that keeps its sign. It found each. An odd power of a factor
//! of unknown sign, cancelled from an inequality, it does not find, because the search never
//! proposes one: the kernel's own rules suite does.

use std::collections::BTreeMap;
use std::time::Instant;

use kane::audit::{Budget, judge_goal};
use kane::kernel::{
    Certificate, Conclusion, Evidence, Finding, Fuel, Goal, Link, Model, Point, check, digest,
};

use crate::generate::{any_statement, changed, true_statement};
use crate::many::{self, many, share};
use crate::mutation::{KINDS, clash, kinds, mutant};
use crate::sampling::{At, Sampler, at, has_limits};
use crate::support::{Case, Chance, Q, all_documents, cases, documents, shown};

/// Small, so that many statements fit: a false one only has to be not accepted.
const SMALL: Budget = Budget {
    steps: 10,
    fuel: 100_000,
    check: 20_000_000,
    functions: 4,
    ideals: false,
    products: true,
    squares: 2_000_000,
    cells: 500_000,
    document: u64::MAX,
};

/// Operations of one evaluation of hypotheses up to which a claim has all of its points.
const WEIGHT: usize = 1_000;

fn accepts(goal: &Goal, certificate: &Certificate) -> bool {
    check(goal, certificate, Fuel::new(20_000_000)).is_ok()
}

/// The values of a model's symbols, if all are rational.
fn rational_point(goal: &Goal, certificate: &Certificate) -> Option<Vec<Q>> {
    let Evidence::Model(Model::Point(Point { generator: None, values })) = &certificate.evidence
    else {
        return None;
    };
    let inside = |v: &kane::kernel::Var| match (&v.lower, &v.upper) {
        (None, None) => Q::from_integer(0.into()),
        (Some(a), None) => &a.value + Q::from_integer(1.into()),
        (None, Some(b)) => &b.value - Q::from_integer(1.into()),
        (Some(a), Some(b)) => (&a.value + &b.value) / Q::from_integer(2.into()),
    };
    let mut point: Vec<Q> = goal.context.vars.iter().map(inside).collect();
    for (v, coefficients) in values {
        if let Some(slot) = point.get_mut(*v) {
            *slot = coefficients.first().cloned().unwrap_or_else(|| Q::from_integer(0.into()));
        }
    }
    Some(point)
}

/// What was tried on false statements.
#[derive(Default)]
struct Tally {
    statements: usize,
    transplants: usize,
    mutants: usize,
    witnesses: usize,
    verdicts: BTreeMap<String, usize>,
    wrong: Vec<String>,
}

impl Tally {
    /// Tries to get a false statement accepted. `sibling` is for a statement much like it.
    fn attack(
        &mut self,
        goal: &Goal,
        point: &[Q],
        sibling: Option<&Certificate>,
        chance: &mut Chance,
    ) {
        self.statements += 1;
        let label = || format!("{}at {point:?}", shown(goal));
        let found = judge_goal(goal, &[], SMALL).decided;
        let verdict = found.as_ref().map(|c| c.finding);
        *self.verdicts.entry(format!("{verdict:?}")).or_default() += 1;
        if matches!(verdict, Some(Finding::Proved | Finding::Vacuous)) {
            self.wrong.push(format!("{verdict:?} by the search: {}", label()));
        }
        // A witness is held against the evaluator.
        if let Some((c, point)) = found.as_ref().and_then(|c| Some((c, rational_point(goal, c)?))) {
            self.witnesses += 1;
            let says = at(goal, &point);
            let fits = match c.finding {
                Finding::Refuted => says == At::False,
                Finding::IllDefined => says == At::Undefined,
                _ => true,
            };
            if !fits && says != At::Unknown {
                self.wrong.push(format!("witness {point:?} is {says:?}: {}", label()));
            }
        }
        let Some(sibling) = sibling else {
            return;
        };
        let honest = Certificate { goal: digest(goal), ..sibling.clone() };
        self.transplants += 1;
        self.claim(goal, &honest, &label);
        let sites = kinds(&honest).len();
        for _ in 0..3 {
            // not the digest and the kind of evidence: those three come first
            let mut forged = mutant(&honest, 3 + chance.below(sites.saturating_sub(3)), chance);
            forged.goal = digest(goal);
            self.mutants += 1;
            self.claim(goal, &forged, &label);
        }
    }

    fn claim(&mut self, goal: &Goal, c: &Certificate, label: &dyn Fn() -> String) {
        for finding in [Finding::Proved, Finding::Vacuous] {
            let c = Certificate { finding, ..c.clone() };
            if accepts(goal, &c) {
                self.wrong.push(format!("{finding:?} accepted: {}\n{c:?}", label()));
            }
        }
    }

    fn print(&self, what: &str, start: Instant) {
        println!(
            "soundness, {what}: {} false statements, {} transplanted and {} mutated certificates, \
             none accepted; {} witnesses agree with the evaluator; found {:?}; {:.1} s",
            self.statements,
            self.transplants,
            self.mutants,
            self.witnesses,
            self.verdicts,
            start.elapsed().as_secs_f64()
        );
        assert!(self.wrong.is_empty(), "{}", self.wrong.join("\n\n"));
    }
}

/// A point that makes a goal false, among a few.
fn falsifying(goal: &Goal, chance: &mut Chance) -> Option<Vec<Q>> {
    let mut sampler = Sampler::new(goal);
    for _ in 0..6 {
        let (point, says) = sampler.point(chance, 6)?;
        if matches!(says, At::False | At::Undefined) {
            return Some(point);
        }
    }
    None
}

#[test]
fn no_random_false_statement_is_accepted() {
    let (mut chance, mut tally, start) = (Chance::new(1), Tally::default(), Instant::now());
    let mut last: Option<Certificate> = None;
    while tally.statements < many(5_000) {
        let goal = any_statement(&mut chance);
        match falsifying(&goal, &mut chance) {
            Some(point) => tally.attack(&goal, &point, last.as_ref(), &mut chance),
            None => {
                let found = judge_goal(&goal, &[], SMALL).decided;
                last = found.filter(|c| c.finding == Finding::Proved).or(last);
            }
        }
    }
    tally.print("random", start);
}

#[test]
fn no_false_neighbour_of_a_true_statement_is_accepted() {
    let (mut chance, mut tally, start) = (Chance::new(2), Tally::default(), Instant::now());
    let mut proved = 0;
    while tally.statements < many(5_000) {
        let goal = true_statement(&mut chance);
        let found = judge_goal(&goal, &[], SMALL).decided;
        proved += usize::from(found.is_some());
        for _ in 0..4 {
            let neighbour = changed(&goal, &mut chance);
            if let Some(point) = falsifying(&neighbour, &mut chance) {
                tally.attack(&neighbour, &point, found.as_ref(), &mut chance);
            }
        }
    }
    println!("soundness, neighbours: {proved} of the true statements decided");
    tally.print("neighbours of true statements", start);
}

#[test]
fn no_false_neighbour_of_a_shipped_claim_is_accepted() {
    let (mut chance, mut tally, start) = (Chance::new(3), Tally::default(), Instant::now());
    let all: Vec<Case> = share(all_documents().iter().flat_map(cases)).collect();
    let found: Vec<Option<Certificate>> =
        all.iter().map(|c| judge_goal(&c.goal, &c.by, Budget::default()).decided).collect();
    while tally.statements < many(2_000) {
        for (case, found) in all.iter().zip(&found) {
            let neighbour = changed(&case.goal, &mut chance);
            if has_limits(&neighbour) {
                continue;
            }
            if let Some(point) = falsifying(&neighbour, &mut chance) {
                tally.attack(&neighbour, &point, found.as_ref(), &mut chance);
            }
        }
    }
    tally.print("neighbours of shipped claims", start);
}

/// The certificates that are found for the shipped documents and the semantics suite: deciding
/// ones, and models of the hypotheses.
fn harvest() -> Vec<(Case, Certificate)> {
    let mut all: Vec<Case> = share(all_documents().iter().flat_map(cases)).collect();
    all.extend(extra());
    let mut out = Vec::new();
    for case in all {
        let found = judge_goal(&case.goal, &case.by, Budget::default());
        out.extend(found.decided.into_iter().chain(found.model).map(|c| (case.clone(), c)));
    }
    out
}

/// Claims whose certificates are of kinds that the documents do not need.
fn extra() -> Vec<Case> {
    let text = "```kane\n\
        var x >= 0, 0 <= y <= 1, a, b, c\n\
        claim box: 16*x*y*(1 - y) <= 4*x + x^2*y\n\
        claim squares: a^2 + b^2 + c^2 >= a*b + b*c + c*a\n\
        claim inner: a*b <= 1/4 when a + b = 1\n\
        claim irrational: a^2 != 2\n\
        claim signs: a^2 >= 2 when a^3 >= 3\n\
        claim apart: sqrt(x) -> sqrt(3) as x -> 2\n\
        claim cases: sqrt(a^2 + x) -> abs(a) as x -> 0\n\
        claim case: a/sqrt(a^2 + x) -> a/abs(a) as x -> 0 when a != 0\n\
        ```\n";
    kane::audit::read("extra.md", text.as_bytes()).map(|d| cases(&d)).unwrap_or_default()
}

/// One test, because to find the certificates takes longer than what is done with them.
#[test]
fn certificates_of_the_shipped_claims_serve_these_claims_alone() {
    let start = Instant::now();
    let all = harvest();
    println!("harvest: {} certificates; {:.1} s", all.len(), start.elapsed().as_secs_f64());
    every_field_of_a_certificate_matters(&all);
    certificates_swapped_between_statements_are_rejected(&all);
    a_claim_and_its_negation_are_never_both_accepted(&all);
}

fn every_field_of_a_certificate_matters(all: &[(Case, Certificate)]) {
    let (mut chance, start) = (Chance::new(5), Instant::now());
    // kind of field: changed, rejected, still accepted
    let mut tally: BTreeMap<&str, [usize; 3]> = KINDS.iter().map(|k| (*k, [0; 3])).collect();
    let mut wrong = Vec::new();
    let enough = many(150);
    let mut order: Vec<usize> = (0..all.len()).collect();
    for i in (1..order.len()).rev() {
        order.swap(i, chance.below(i + 1));
    }
    for i in order {
        let (case, honest) = &all[i];
        let not_implied = matches!(case.goal.conclusion, Conclusion::NotImplied(_));
        assert!(accepts(&case.goal, honest), "what was found is accepted: {}", case.name);
        for (site, kind) in kinds(honest).into_iter().enumerate() {
            let counts = tally.get_mut(kind).expect("KINDS names all kinds");
            if counts[0] >= enough {
                continue;
            }
            let forged = mutant(honest, site, &mut chance);
            if forged == *honest {
                continue;
            }
            counts[0] += 1;
            if accepts(&case.goal, &forged) {
                counts[2] += 1;
                if clash(honest.finding, forged.finding, not_implied) {
                    wrong.push(format!(
                        "{}: {:?} and {kind}: {forged:?}",
                        case.name, honest.finding
                    ));
                }
            } else {
                counts[1] += 1;
            }
        }
    }
    let sums = tally.values().fold([0; 3], |a, b| [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
    println!("mutations of {} certificates: changed, rejected, still a proof", all.len());
    for (kind, [changed, rejected, valid]) in &tally {
        println!("    {kind:<28} {changed:>5} {rejected:>5} {valid:>5}");
    }
    println!(
        "mutations: {} changed, {} rejected, {} still a proof of the same; {:.1} s",
        sums[0],
        sums[1],
        sums[2],
        start.elapsed().as_secs_f64()
    );
    let idle: Vec<&&str> = tally.iter().filter(|(_, c)| c[1] == 0).map(|(k, _)| k).collect();
    // a share of the documents does not need all kinds
    assert!(idle.is_empty() || !many::all(), "no change of these was rejected: {idle:?}");
    assert!(wrong.is_empty(), "accepted against another finding:\n{}", wrong.join("\n"));
}

fn certificates_swapped_between_statements_are_rejected(all: &[(Case, Certificate)]) {
    let (mut chance, start) = (Chance::new(6), Instant::now());
    let sample: Vec<&(Case, Certificate)> =
        (0..many(90).min(all.len())).map(|_| chance.pick(all)).collect();
    let (mut pairs, mut also, mut wrong) = (0, 0, Vec::new());
    for (case, own) in &sample {
        let not_implied = matches!(case.goal.conclusion, Conclusion::NotImplied(_));
        let name = digest(&case.goal);
        for (other, foreign) in &sample {
            if digest(&other.goal) == name {
                continue;
            }
            pairs += 1;
            if accepts(&case.goal, foreign) {
                wrong.push(format!("{} by the certificate of {}", case.name, other.name));
            }
            // A short argument may serve two statements; never for what contradicts the truth.
            let renamed = Certificate { goal: name, ..foreign.clone() };
            for finding in [
                Finding::Proved,
                Finding::Refuted,
                Finding::IllDefined,
                Finding::Vacuous,
                Finding::Consistent,
            ] {
                if accepts(&case.goal, &Certificate { finding, ..renamed.clone() }) {
                    also += 1;
                    if clash(own.finding, finding, not_implied) {
                        wrong.push(format!("{} is {finding:?} by {}", case.name, other.name));
                    }
                }
            }
        }
    }
    println!(
        "swaps: {pairs} pairs rejected as they are; renamed, five findings each, {also} hold too, \
         none against the truth; {:.1} s",
        start.elapsed().as_secs_f64()
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn a_claim_and_its_negation_are_never_both_accepted(all: &[(Case, Certificate)]) {
    let (mut chance, start) = (Chance::new(7), Instant::now());
    let (mut refuted, mut proved, mut points, mut wrong) = (0, 0, 0, Vec::new());
    for (case, honest) in all {
        if has_limits(&case.goal) {
            continue;
        }
        let not_implied = matches!(case.goal.conclusion, Conclusion::NotImplied(_));
        match honest.finding {
            Finding::Refuted | Finding::IllDefined if !not_implied => {
                refuted += 1;
                if let Some(point) = rational_point(&case.goal, honest) {
                    let says = at(&case.goal, &point);
                    if says == At::True || says == At::Outside {
                        wrong.push(format!("{} is {says:?} at {point:?}", case.name));
                    }
                }
                // what the other verdicts of this suite are proved by does not prove this one
                for finding in [Finding::Proved, Finding::Vacuous] {
                    if accepts(&case.goal, &Certificate { finding, ..honest.clone() }) {
                        wrong.push(format!("{} is {finding:?} too", case.name));
                    }
                }
            }
            Finding::Proved | Finding::Vacuous if !not_implied => {
                proved += 1;
                let mut sampler = Sampler::new(&case.goal);
                for _ in 0..20 {
                    let Some((point, _)) = sampler.point(&mut chance, 4) else {
                        break;
                    };
                    points += 1;
                    let values = point.into_iter().enumerate().map(|(v, x)| (v, vec![x])).collect();
                    let model = Model::Point(Point { generator: None, values });
                    for finding in [Finding::Refuted, Finding::IllDefined] {
                        let against = Certificate {
                            goal: digest(&case.goal),
                            finding,
                            evidence: Evidence::Model(model.clone()),
                        };
                        if accepts(&case.goal, &against) {
                            wrong.push(format!("{} is {finding:?} too: {model:?}", case.name));
                        }
                    }
                }
            }
            _ => {}
        }
    }
    println!(
        "negations: {refuted} refuted claims have no proof, {proved} proved ones no witness among \
         {points} points; {:.1} s",
        start.elapsed().as_secs_f64()
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// What sampling says of proved claims.
#[derive(Default)]
struct Sampled {
    /// how many hold at as many points as were wanted
    claims: usize,
    points: usize,
    /// how many rest on limits, which no point shows
    limits: usize,
    /// points at which the value is irrational
    unknown: usize,
    /// what was sampled less, with its points
    open: Vec<String>,
    wrong: Vec<String>,
}

impl Sampled {
    /// Evaluates a claim, if it is a relation and proved, at points of its hypotheses.
    fn sample(&mut self, case: &Case, chance: &mut Chance) {
        if !matches!(case.goal.conclusion, Conclusion::Link(Link::Relation(_))) {
            return;
        }
        let found = judge_goal(&case.goal, &case.by, Budget::default()).decided;
        if found.is_none_or(|c| c.finding != Finding::Proved) {
            return;
        }
        if has_limits(&case.goal) {
            self.limits += 1;
            return;
        }
        let mut sampler = Sampler::new(&case.goal);
        let (wanted, mut seen) = (many(1_000), 0);
        // where hypotheses are seldom met, a point takes as long as a hundred elsewhere; where they are derivatives of
        // derivatives, as long as forty
        let most = many(2_500) * WEIGHT / sampler.weight().max(WEIGHT);
        let (mut tries, mut failures) = (0, 0);
        while seen < wanted && failures < 300 && tries < most && (seen > 0 || tries < 100) {
            tries += 1;
            match sampler.point(chance, 10) {
                None => failures += 1,
                Some((_, At::Unknown)) => {
                    self.unknown += 1;
                    failures += 1;
                }
                Some((_, At::True)) => {
                    failures = 0;
                    seen += 1;
                }
                Some((point, says)) => {
                    seen += 1;
                    self.wrong.push(format!("{} is {says:?} at {point:?}", case.name));
                }
            }
        }
        self.points += seen;
        if seen == wanted {
            self.claims += 1;
        } else {
            self.open.push(format!("{} ({seen})", case.name));
        }
    }

    fn and(mut self, other: Self) -> Self {
        self.claims += other.claims;
        self.points += other.points;
        self.limits += other.limits;
        self.unknown += other.unknown;
        self.open.extend(other.open);
        self.wrong.extend(other.wrong);
        self
    }
}

#[test]
fn what_is_proved_holds_at_points_of_its_hypotheses() {
    /// The longest test of all, and by its name the last: alone it would leave a core idle.
    const SHARES: usize = 2;
    let start = Instant::now();
    let share = |number: usize| {
        let (mut chance, mut sampled) = (Chance::new(8 + number as u64), Sampled::default());
        let documents = documents("docs/derivations");
        for case in documents.iter().flat_map(cases).skip(number).step_by(SHARES) {
            sampled.sample(&case, &mut chance);
        }
        sampled
    };
    let sampled = std::thread::scope(|scope| {
        let shares: Vec<_> = (0..SHARES).map(|n| scope.spawn(move || share(n))).collect();
        shares
            .into_iter()
            .map(|one| one.join().expect("a share panicked"))
            .fold(Sampled::default(), Sampled::and)
    });
    println!(
        "evaluation: {} proved claims hold at {} points each, {} in all; {} rest on limits; {} were \
         sampled less: {}; {} points irrational; {:.1} s",
        sampled.claims,
        many(1_000),
        sampled.points,
        sampled.limits,
        sampled.open.len(),
        sampled.open.join(", "),
        sampled.unknown,
        start.elapsed().as_secs_f64()
    );
    assert!(sampled.claims > 0, "nothing was sampled");
    let wrong = &sampled.wrong;
    assert!(wrong.is_empty(), "{}", wrong[..wrong.len().min(20)].join("\n"));
}
