//! An audit whose judgements are made by hand, with every verdict in it. Reports are tested on it, so that a change
//! of the prover does not change their snapshots.

use std::rc::Rc;

use kane::audit::{
    Accepted, Assignment, Audit, Body, Comparison, Content, Document, Judgement, LinkJudgement,
    Means, Measured, Open, Proof, Reason, Said, Solved, Source, Speaker, Standing, Step, Supposed,
    Value, Variable, Verdict,
};
use kane::kernel::{
    Atom, Certificate, Conclusion, Evidence, Expr, Finding, Goal, Link, Model, Point, Poly, Rel,
    Relation, Sign,
};
use kane::number::Rational;

const TEXT: &str = "\
# A sphere meets a wall

```kane
var m > 0, mu >= 0, r_0, alpha
var k(alpha), v_x(alpha), v_y(alpha), v_x0(alpha), v_y0(alpha), I_x(alpha), I_y(alpha)
let k_W := 1 - 2*alpha
given (2): m*(v_x - v_x0) = -I_x    # as printed
given dom: alpha > 0
claim (1): m*(v_y - v_y0) = I_y  when mu > 0  from (2)  expect refuted
claim (16): k = (1 - alpha)/(1 + alpha)
  from (2), dom                     # a line that goes on
claim range: -1 < k < 1  from (16), dom
claim wrong: k > 1  from dom
claim half: k = 1/2, k < 1  from dom  expect refuted
claim lost: k >= mu*abs(v_x)  from wrong
claim empty: contradiction  from (2), dom  expect refuted
claim nothing: r_0/r_0*m = m  from (2)  expect vacuous
claim pole: m/(k - 1) > 0  expect ill-defined
claim open: m^4 + mu^4 > m*mu - 1
claim μ-lim: k -> -1 as alpha -> oo  from (16)
```
";

/// A judged document with every verdict, expected and not.
pub(crate) fn audit() -> Audit {
    let document = kane::audit::read("wall.md", TEXT.as_bytes()).expect("the text is well formed");
    let judgements = document
        .statements
        .iter()
        .map(|statement| judgement(&document, &statement.label))
        .collect();
    Audit { document, judgements }
}

/// What the prover could have said of the statement.
fn judgement(document: &Document, label: &str) -> Judgement {
    use Verdict::{Assumed, Defined, IllDefined, Proved, Refuted, Undecided, Unsupported, Vacuous};
    let link = |verdict, number| link(document, label, number, verdict);
    let one = |verdict| judged(verdict, vec![link(verdict, 0)]);
    let expected =
        |judgement: Judgement| Judgement { expect: Some(judgement.verdict), ..judgement };
    let at = |values: &[(usize, Rational)]| Some(Rc::new(met(document, values)));
    match label {
        "k_W" => judged(Defined, vec![]),
        "(2)" | "dom" => judged(Assumed, vec![]),
        "(1)" => Judgement {
            rests_on: vec![1],
            met: at(&[(M, ratio(1, 1)), (V_Y0, ratio(-1, 2))]),
            ..expected(one(Refuted))
        },
        "(16)" => {
            Judgement { rests_on: vec![1, 2], met: at(&[(ALPHA, ratio(1, 1))]), ..one(Proved) }
        }
        "range" => Judgement {
            rests_on: vec![1, 2],
            ..judged(Proved, vec![link(Proved, 0), link(Proved, 1)])
        },
        "wrong" => one(Refuted),
        "half" => expected(judged(Refuted, vec![link(Refuted, 0), link(Proved, 1)])),
        "lost" => Judgement {
            conditional: Proved,
            unproved: vec![6],
            rests_on: vec![2],
            ..judged(Unsupported, vec![link(Proved, 0)])
        },
        "empty" => expected(one(Refuted)),
        "nothing" => expected(one(Vacuous)),
        "pole" => Judgement { met: at(&[]), ..expected(one(IllDefined)) },
        "open" => one(Undecided),
        "μ-lim" => Judgement { met: at(&[]), ..one(Proved) },
        other => unreachable!("no judgement of {other} was made up"),
    }
}

fn judged(verdict: Verdict, links: Vec<LinkJudgement>) -> Judgement {
    Judgement {
        verdict,
        conditional: verdict,
        links,
        unproved: vec![],
        rests_on: vec![],
        hypotheses: vec![1],
        met: None,
        expect: None,
    }
}

/// Symbols of the document.
const M: usize = 0;
const ALPHA: usize = 3;
const K: usize = 4;
const V_X: usize = 5;
const V_X0: usize = 7;
const V_Y0: usize = 8;
const I_X: usize = 9;

fn ratio(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

/// A goal of the document without hypotheses.
fn goal(document: &Document, when: Vec<Relation>, conclusion: Conclusion) -> Goal {
    let (context, hypotheses, behind) = (document.context.clone(), Vec::new(), Vec::new());
    Goal { context, hypotheses, behind, when, conclusion }
}

fn accepted(goal: Goal, finding: Finding, evidence: Evidence) -> Accepted {
    Accepted { goal, certificate: Certificate { goal: 0, finding, evidence } }
}

/// A point at which hypotheses hold that say nothing but this.
fn met(document: &Document, values: &[(usize, Rational)]) -> Accepted {
    let says = |(v, q): &(usize, Rational)| Relation {
        lhs: Expr::Var(*v),
        rel: Rel::Eq,
        rhs: Expr::Num(q.clone()),
    };
    let when = values.iter().map(says).collect();
    let values = values.iter().map(|(v, q)| (*v, vec![q.clone()])).collect();
    let point = Model::Point(Point { generator: None, values });
    let goal = goal(document, when, Conclusion::Contradiction);
    accepted(goal, Finding::Consistent, Evidence::Model(point))
}

/// A link with a reason, a certificate and steps that fit its verdict.
fn link(document: &Document, label: &str, number: usize, verdict: Verdict) -> LinkJudgement {
    let finding = match verdict {
        Verdict::Refuted => Finding::Refuted,
        Verdict::IllDefined => Finding::IllDefined,
        Verdict::Vacuous => Finding::Vacuous,
        _ => Finding::Proved,
    };
    let statement = document.statements.iter().find(|s| s.label == label).expect("it is there");
    let Body::Claim(claim) = &statement.body else { unreachable!("links are those of claims") };
    let conclusion = match &claim.content {
        Content::Links(links) => Conclusion::Link(links[number].0.clone()),
        _ => Conclusion::Contradiction,
    };
    let goal = goal(document, claim.when.clone(), conclusion);
    let told = explanation(&goal, finding);
    let decided = verdict != Verdict::Undecided;
    LinkJudgement {
        verdict,
        certificate: decided.then(|| "0123456789abcdef0123456789abcdef".to_owned()),
        used: if verdict == Verdict::Proved { vec![1] } else { vec![] },
        cost: 12,
        work: 3_400,
        accepted: decided.then(|| Rc::new(accepted(goal, finding, Evidence::Limit(Vec::new())))),
        explanation: if decided { told.into() } else { kane::audit::Explanation::default() },
        beside: None,
        standing: match (verdict, label) {
            (Verdict::Refuted, "half") => Some(Standing::Unmet(vec![1])),
            (Verdict::Refuted, _) => Some(Standing::AllMet),
            (Verdict::IllDefined, _) => Some(Standing::NotShown),
            _ => None,
        },
        attempt: None,
        open: (!decided).then_some(Open::Steps(10_000)),
        unreached: None,
        would_do: (verdict == Verdict::Refuted && label == "half").then_some(1),
        at: Vec::new(),
    }
}

fn explanation(goal: &Goal, finding: Finding) -> (Reason, Proof) {
    let means = |substituted| Means {
        finding,
        limits: false,
        substituted,
        tables: Vec::new(),
        sums: finding == Finding::Vacuous,
        signs: false,
    };
    let at = |symbol, value| Assignment { symbol, value: Value::Number(value) };
    let (reason, step) = match finding {
        Finding::Proved => {
            (Reason::Contradiction(means(vec![Variable::Symbol(I_X)])), contradiction())
        }
        Finding::Vacuous => (Reason::Contradiction(means(Vec::new())), squares()),
        Finding::IllDefined => {
            let Some(Link::Relation(pole)) = goal.conclusion.links().first() else {
                unreachable!("what has no meaning is a relation")
            };
            let why = kane::algebra::syntax::NoValue::DivisionByZero;
            let (values, claim) =
                (vec![at(K, ratio(1, 1))], Comparison::Undefined(pole.clone(), why, None));
            let said = vec![said(Speaker::Claim, pole, &claim)];
            (
                Reason::Point { values: values.clone(), claim: Some(claim) },
                Step::Point { values, definitions: Vec::new(), said },
            )
        }
        Finding::Refuted | Finding::Consistent => {
            let values = vec![at(M, ratio(1, 1)), at(V_Y0, ratio(-1, 2))];
            let both = |a, b| Comparison::Sides(Measured::Exact(a), Measured::Exact(b));
            let (claim, premise) =
                (both(ratio(-1, 2), ratio(3, 2)), both(ratio(0, 1), ratio(0, 1)));
            let equality = Relation { lhs: Expr::Var(V_Y0), rel: Rel::Eq, rhs: Expr::Var(M) };
            let said = vec![
                said(Speaker::Hypothesis(0), &equality, &premise),
                said(Speaker::Claim, &equality, &claim),
            ];
            (
                Reason::Point { values: values.clone(), claim: Some(claim) },
                Step::Point { values, definitions: Vec::new(), said },
            )
        }
    };
    let variables = (0..goal.context.vars.len()).map(Variable::Symbol).collect();
    (reason, Proof { variables, steps: vec![step] })
}

/// What becomes of a relation at a point.
fn said(of: Speaker, relation: &Relation, comparison: &Comparison) -> Said {
    Said { of, relation: relation.clone(), comparison: comparison.clone(), parts: Vec::new() }
}

/// A proof with a substitution and two cases.
fn contradiction() -> Step {
    // I_x + m*v_x - m*v_x0 = 0
    let product = |a: usize, b: usize, c: i64| Poly::term(vec![(a, 1), (b, 1)], c.into());
    let speeds = product(M, V_X0, 1).add(&product(M, V_X, -1));
    let premise = Poly::var(I_X).sub(&speeds);
    let square = Poly::power(K, 2);
    Step::Suppose {
        what: Supposed::Failure,
        then: vec![
            Step::Assume {
                source: Source::Hypothesis(0),
                atoms: vec![Atom::new(premise, Sign::Zero)],
            },
            Step::Solve {
                solved: vec![Solved {
                    variable: I_X,
                    value: (speeds, Poly::one()),
                    source: Some(Source::Hypothesis(0)),
                }],
                divided: Vec::new(),
                leaves: Vec::new(),
            },
            Step::Cases {
                source: Source::Failure,
                cases: vec![
                    (
                        vec![Atom::new(Poly::var(K).sub(&Poly::one()), Sign::Positive)],
                        vec![Step::Absurd(Atom::new(Poly::one().neg(), Sign::NonNegative))],
                    ),
                    (vec![Atom::new(square.neg(), Sign::Positive)], vec![squares()]),
                ],
            },
        ],
    }
}

/// A sum of squares that vanishes.
fn squares() -> Step {
    let one = kane::audit::Summand { weight: 1.into(), square: Poly::one(), factors: Vec::new() };
    let square = kane::audit::Summand { square: Poly::var(M), weight: 2.into(), ..one.clone() };
    let minus = Poly::one().add(&Poly::power(M, 2).scale(&2.into())).neg();
    Step::Positive { terms: vec![one, square], multiples: vec![(Poly::one(), minus)] }
}
