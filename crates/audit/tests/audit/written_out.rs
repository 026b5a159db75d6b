//! What the search finds on random conditions is written out in the rules of the kernel, and proofs of one contradiction are
//! none of conditions that have a common point.

use kane_audit::{Budget, Open, prove_goal};
use kane_kernel::{
    Certificate, Conclusion, Context, Expr, Fuel, Goal, Hypothesis, Link, Rel, Relation, Sentence,
    Var, check, digest,
};

/// Rules of the argument, each by what tells of it.
const KINDS: [&str; 7] = [
    "Absurd(",
    "Cases {",
    "Split {",
    "Solve {",
    "Positive {",
    "SignsOfCoefficients {",
    "SignTable {",
];

/// A small source of chance, the same in each run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: u64) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    fn signed(&mut self, most: u64) -> i64 {
        let whole = |n: u64| i64::try_from(n).unwrap_or_default();
        whole(self.below(2 * most + 1)) - whole(most)
    }

    fn condition(&mut self) -> Condition {
        let terms = if self.below(3) == 0 {
            let mut exponents = [0; 3];
            exponents[usize::try_from(self.below(3)).unwrap_or_default()] = 1;
            let sign = if self.below(2) == 0 { 1 } else { -1 };
            vec![(sign, exponents), (self.signed(2), [0; 3])]
        } else {
            let term = |chance: &mut Self| {
                let exponents = [0; 3]
                    .map(|_: u32| u32::try_from(chance.below(6).saturating_sub(3)).unwrap_or(1));
                (chance.signed(4), exponents)
            };
            (0..=self.below(3)).map(|_| term(self)).collect()
        };
        let rel = [Rel::Eq, Rel::Ne, Rel::Ge, Rel::Gt][usize::try_from(self.below(4)).unwrap_or(0)];
        Condition { terms, rel }
    }

    fn conditions(&mut self) -> Vec<Condition> {
        (0..3 + self.below(4)).map(|_| self.condition()).collect()
    }
}

/// Σ c·x^a·y^b·z^c, compared with 0.
struct Condition {
    terms: Vec<(i64, [u32; 3])>,
    rel: Rel,
}

impl Condition {
    fn holds(&self, at: [i64; 3]) -> bool {
        let term = |(c, exponents): &(i64, [u32; 3])| {
            c * at.iter().zip(exponents).map(|(x, e)| x.pow(*e)).product::<i64>()
        };
        let value: i64 = self.terms.iter().map(term).sum();
        match self.rel {
            Rel::Eq => value == 0,
            Rel::Ne => value != 0,
            Rel::Ge => value >= 0,
            _ => value > 0,
        }
    }

    fn relation(&self) -> Relation {
        let power = |(v, e): (usize, &u32)| {
            Expr::Pow(Expr::Var(v).into(), i32::try_from(*e).unwrap_or_default())
        };
        let term = |(c, exponents): &(i64, [u32; 3])| {
            let powers = exponents.iter().enumerate().filter(|(_, e)| **e > 0).map(power);
            powers.fold(Expr::int(*c), |p, q| Expr::Mul(p.into(), q.into()))
        };
        let lhs = self.terms.iter().map(term).reduce(|p, q| Expr::Add(p.into(), q.into()));
        Relation { lhs: lhs.unwrap_or_else(|| Expr::int(0)), rel: self.rel, rhs: Expr::int(0) }
    }
}

/// That the conditions, and one of two further lists of them, contradict each other.
fn goal(all: &[Condition], cases: &[Vec<Condition>; 2]) -> Goal {
    let var = |name: &str| Var { name: name.to_owned(), of: None, lower: None, upper: None };
    let one =
        |list: &Vec<Condition>| (list.iter().map(Condition::relation).collect(), Expr::int(1));
    let either = Relation {
        lhs: Expr::Cases(cases.iter().map(one).collect(), Some(Expr::int(0).into())),
        rel: Rel::Eq,
        rhs: Expr::int(1),
    };
    let links = all.iter().map(Condition::relation).chain([either]).map(Link::Relation).collect();
    Goal {
        context: Context { vars: ["x", "y", "z"].map(var).to_vec(), ..Context::default() },
        hypotheses: vec![Hypothesis {
            sentence: Sentence { when: Vec::new(), links },
            given: true,
        }],
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    }
}

fn has_a_point(all: &[Condition], cases: &[Vec<Condition>; 2]) -> bool {
    let holds = |list: &[Condition], at| list.iter().all(|c| c.holds(at));
    (0..125).any(|n| {
        let at = [n % 5 - 2, n / 5 % 5 - 2, n / 25 - 2];
        holds(all, at) && cases.iter().any(|list| holds(list, at))
    })
}

#[test]
fn what_the_search_finds_is_written_out_and_nothing_false_is() {
    let budget = Budget { steps: 60, squares: 0, cells: 0, ..Budget::default() };
    let mut chance = Chance(7);
    let mut kinds = [0usize; KINDS.len()];
    let mut found: Vec<Certificate> = Vec::new();
    let (mut contradictory, mut satisfied) = (0, 0);
    for _ in 0..400 {
        let all = chance.conditions();
        let cases = [chance.conditions(), chance.conditions()];
        let goal = goal(&all, &cases);
        let has_a_point = has_a_point(&all, &cases);
        match prove_goal(&goal, budget) {
            Ok(decided) => {
                assert!(!has_a_point, "{goal:?}");
                contradictory += 1;
                let told = format!("{:?}", decided.steps(&goal));
                for (count, kind) in kinds.iter_mut().zip(KINDS) {
                    *count += usize::from(told.contains(kind));
                }
                found.push(decided.certificate);
            }
            Err(Open::Unwritten(flaw)) => panic!("{flaw:?}: {goal:?}"),
            Err(Open::Rejected(why)) => panic!("{why:?}: {goal:?}"),
            Err(_) => {}
        }
        if has_a_point {
            satisfied += 1;
            for certificate in found.iter().rev().take(40) {
                let moved = Certificate { goal: digest(&goal), ..certificate.clone() };
                assert!(check(&goal, &moved, Fuel::new(10_000_000)).is_err(), "{moved:?}");
            }
        }
    }
    println!("{contradictory} contradictory, {satisfied} with a point; {KINDS:?} {kinds:?}");
    assert!(contradictory > 60 && satisfied > 30, "{contradictory} {satisfied}");
    assert!(kinds.iter().all(|k| *k > 0), "all rules are used: {KINDS:?} {kinds:?}");
}
