//! Judging a document: goals out of statements, verdicts out of findings.

use std::cell::RefCell;
use std::rc::Rc;

use kane_kernel::{
    Conclusion, Context, Definition, Evidence, Expr, Finding, Goal, Hypothesis, Link, Model,
    Sentence, Side, Target,
};

use crate::prove::{Budget, Decided, Prover, Verdicts, expanded};
use crate::{
    Accepted, Audit, Behind, Body, Claim, Content, Document, Explanation, Judgement, LinkJudgement,
    Open, Unreached, Verdict, explain,
};

/// What to judge, and with how much effort.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// indices of the claims to judge, with all that they cite; `None` for all
    pub only: Option<Vec<usize>>,
    /// effort a link
    pub budget: Budget,
}

/// Judges a document. `progress` is told, before each statement, its index and their number.
pub fn audit(
    document: Document,
    options: &Options,
    progress: &mut dyn FnMut(usize, usize),
) -> Audit {
    let count = document.statements.len();
    let wanted = wanted(&document, options);
    let earlier = RefCell::default();
    let mut judgements: Vec<Judgement> = Vec::with_capacity(count);
    for (i, wanted) in wanted.into_iter().enumerate() {
        progress(i, count);
        let judgement = match &document.statements[i].body {
            Body::Let(_) | Body::Defined(_) => plain_verdict(Verdict::Defined, Vec::new()),
            Body::Given(_) => plain_verdict(Verdict::Assumed, vec![i]),
            Body::Claim(claim) if wanted => judge(&document, claim, &judgements, &earlier, options),
            Body::Claim(_) => plain_verdict(Verdict::Undecided, Vec::new()),
        };
        judgements.push(judgement);
    }
    Audit { document, judgements }
}

/// The statements that are asked for and all that they cite.
fn wanted(document: &Document, options: &Options) -> Vec<bool> {
    let count = document.statements.len();
    let Some(only) = &options.only else {
        return vec![true; count];
    };
    let mut wanted = vec![false; count];
    let mut todo = only.clone();
    while let Some(i) = todo.pop() {
        if i < count
            && !std::mem::replace(&mut wanted[i], true)
            && let Body::Claim(claim) = &document.statements[i].body
        {
            todo.extend(&claim.from);
            if let Content::NotImplied(m) = claim.content {
                todo.push(m);
            }
        }
    }
    wanted
}

fn plain_verdict(verdict: Verdict, rests_on: Vec<usize>) -> Judgement {
    Judgement {
        verdict,
        conditional: verdict,
        links: Vec::new(),
        unproved: Vec::new(),
        rests_on,
        hypotheses: Vec::new(),
        met: None,
        expect: None,
    }
}

/// A statement as a premise.
fn hypothesis(document: &Document, i: usize) -> Option<Hypothesis> {
    match &document.statements[i].body {
        Body::Let(_) | Body::Defined(_) => None,
        Body::Given(sentence) => Some(Hypothesis { sentence: sentence.clone(), given: true }),
        Body::Claim(claim) => Some(Hypothesis { sentence: sentence(claim)?, given: false }),
    }
}

/// The document's definitions with those emptied that the goal does not reach, so that a claim and
/// its certificate do not depend on the rest of the document.
fn needed_lets(
    document: &Document,
    goal: &Goal,
    behind: &[Hypothesis],
    by: &[(usize, Expr)],
) -> Vec<Definition> {
    let lets = &document.context.lets;
    let mut needed = vec![false; lets.len()];
    let mut todo: Vec<&Expr> = by.iter().map(|b| &b.1).collect();
    let sentences = goal.hypotheses.iter().chain(behind).map(|h| &h.sentence);
    for s in sentences {
        todo.extend(s.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
        todo.extend(s.links.iter().flat_map(link_parts));
    }
    todo.extend(goal.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
    match &goal.conclusion {
        Conclusion::Link(l) => todo.extend(link_parts(l)),
        Conclusion::NotImplied(s) => {
            todo.extend(s.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
            todo.extend(s.links.iter().flat_map(link_parts));
        }
        Conclusion::Contradiction => {}
    }
    while let Some(e) = todo.pop() {
        if let Expr::Let(i) = e
            && !std::mem::replace(&mut needed[*i], true)
        {
            todo.push(&lets[*i].body);
        }
        todo.extend(e.children());
    }
    let keep = |(d, needed): (&Definition, bool)| Definition {
        name: d.name.clone(),
        body: if needed { d.body.clone() } else { Expr::int(0) },
    };
    lets.iter().zip(needed).map(keep).collect()
}

/// The expressions of a link.
fn link_parts(l: &Link) -> Vec<&Expr> {
    match l {
        Link::Relation(r) => vec![&r.lhs, &r.rhs],
        Link::Limit(l) => match &l.to {
            Target::Finite(value) => vec![&l.expr, value],
            _ => vec![&l.expr],
        },
    }
}

/// Whether a claim or a premise that it cites is about a limit.
fn of_limits(claim: &Claim, hypotheses: &[Hypothesis]) -> bool {
    let limit = |l: &Link| matches!(l, Link::Limit(_));
    let claimed = match &claim.content {
        Content::Links(links) => links.iter().any(|(l, _)| limit(l)),
        Content::Contradiction => false,
        // What M says is seen when it is judged; functions are chosen for it anyway.
        Content::NotImplied(_) => true,
    };
    claimed || hypotheses.iter().any(|h| h.sentence.links.iter().any(limit))
}

/// A claim's sentence; `None` for a claim that says nothing pointwise.
fn sentence(claim: &Claim) -> Option<Sentence> {
    match &claim.content {
        Content::Links(links) => Some(Sentence {
            when: claim.when.clone(),
            links: links.iter().map(|(l, _)| l.clone()).collect(),
        }),
        Content::Contradiction | Content::NotImplied(_) => None,
    }
}

fn judge(
    document: &Document,
    claim: &Claim,
    done: &[Judgement],
    earlier: &RefCell<Vec<Model>>,
    options: &Options,
) -> Judgement {
    let unproved: Vec<usize> = claim
        .from
        .iter()
        .copied()
        .filter(|&i| {
            !matches!(done[i].verdict, Verdict::Proved | Verdict::Assumed | Verdict::Defined)
        })
        .collect();
    let mut rests_on: Vec<usize> =
        claim.from.iter().flat_map(|&i| done[i].rests_on.iter().copied()).collect();
    rests_on.sort_unstable();
    rests_on.dedup();

    let cited: Vec<usize> =
        claim.from.iter().copied().filter(|&i| hypothesis(document, i).is_some()).collect();
    let hypotheses: Vec<Hypothesis> =
        cited.iter().filter_map(|&i| hypothesis(document, i)).collect();
    let further: Vec<usize> = rests_on.iter().copied().filter(|i| !cited.contains(i)).collect();
    let mut behind: Vec<Hypothesis> =
        further.iter().filter_map(|&i| hypothesis(document, i)).collect();
    let ranged: Vec<Sentence> = behind.iter().map(|h| h.sentence.clone()).collect();
    if !of_limits(claim, &hypotheses) {
        // A point can be held against premises at a point only.
        behind.retain(|h| !h.sentence.links.iter().any(|l| matches!(l, Link::Limit(_))));
    }

    let conclusions: Vec<Conclusion> = match &claim.content {
        Content::Links(links) => links.iter().map(|(l, _)| Conclusion::Link(l.clone())).collect(),
        Content::Contradiction => vec![Conclusion::Contradiction],
        Content::NotImplied(m) => {
            let sentence = hypothesis(document, *m).map(|h| h.sentence);
            sentence.map(Conclusion::NotImplied).into_iter().collect()
        }
    };
    let using: Vec<Expr> =
        claim.using.iter().filter_map(|e| expanded(e, &document.context)).collect();
    let mut links = Vec::new();
    let (mut met, mut vacuous) = (None, false);
    for conclusion in conclusions {
        let along = hypotheses.iter().map(|h| &h.sentence.links[..]).chain([conclusion.links()]);
        let limits = along.flatten().any(|l| matches!(l, Link::Limit(_)));
        let mut goal = Goal {
            context: Context { vars: document.context.vars.clone(), ..Context::default() },
            hypotheses: hypotheses.clone(),
            behind: if limits { ranged.clone() } else { Vec::new() },
            when: claim.when.clone(),
            conclusion,
        };
        goal.context.lets = needed_lets(document, &goal, &behind, &claim.by);
        let resting = Goal {
            hypotheses: [&hypotheses[..], &behind[..]].concat(),
            behind: Vec::new(),
            ..goal.clone()
        };
        let prover = Prover {
            budget: options.budget,
            using: &using,
            by: &claim.by,
            earlier,
            cited: hypotheses.len(),
            resting: &resting,
        };
        // The hypotheses are the same for all links: whether they can hold is found once.
        let mut found = prover.judge(&goal, links.is_empty() || vacuous);
        let ids = [&cited[..], &further].concat();
        let complete = found.behind_met || behind.is_empty();
        only_motions(document, (&resting, &ids), complete, &mut found);
        if claim.exists {
            only_proofs(&mut found);
        }
        let unreached = found.unreached.as_ref();
        let unreached =
            unreached.map(|(side, given)| unreached_by(document, claim, done, side, given));
        vacuous |= matches!(&found.decided, Some(d) if d.certificate.finding == Finding::Vacuous);
        if met.is_none() {
            met = found.model.as_ref().map(|m| Rc::new(accepted_model(&goal, m)));
        }
        links.push(LinkJudgement { unreached, ..link_judgement(&goal, &resting, &cited, found) });
    }
    let worst = links.iter().map(|l| rank(l.verdict)).max().map_or(Verdict::Undecided, |r| r.1);
    Judgement {
        verdict: if unproved.is_empty() { worst } else { Verdict::Unsupported },
        conditional: worst,
        links,
        unproved,
        rests_on,
        hypotheses: cited,
        met,
        expect: claim.expect,
    }
}

/// Where derivatives of functions are spoken of, keeps a model only if functions pass through it for
/// which the premises hold for all points.
fn only_motions(
    document: &Document,
    (resting, ids): (&Goal, &[usize]),
    complete: bool,
    found: &mut Verdicts,
) {
    let motion = &document.motion;
    if !motion.concerns(resting) {
        return;
    }
    // what is behind and cannot be held against a point has no hypothesis
    let all = resting.hypotheses.len() == ids.len();
    let met = |evidence: &Evidence| all && motion.is_met(resting, ids, evidence);
    found.model = found.model.take().filter(|model| met(&Evidence::Model(model.clone())));
    let model = |decided: &&Decided| matches!(decided.certificate.evidence, Evidence::Model(_));
    let unmet = |decided: &Decided| !(complete && met(&decided.certificate.evidence));
    if found.decided.as_ref().filter(model).is_some_and(unmet) {
        found.decided = None;
        found.open = Some(Open::Motion);
    }
}

/// Keeps nothing that speaks against a witness: something else may exist.
fn only_proofs(found: &mut Verdicts) {
    let finding = found.decided.as_ref().map(|decided| decided.certificate.finding);
    if matches!(finding, Some(Finding::Refuted | Finding::IllDefined)) {
        found.decided = None;
        found.open = Some(Open::Witness);
    }
}

/// That a given was not shown to hold near a limit, and through which citation a claim rests on it.
fn unreached_by(
    document: &Document,
    claim: &Claim,
    done: &[Judgement],
    side: &Side,
    given: &Sentence,
) -> Unreached {
    let is_it = |i: &usize| matches!(&document.statements[*i].body, Body::Given(s) if s == given);
    let cited = claim.from.iter().copied();
    let (through, given) = match cited.clone().find(is_it) {
        Some(given) => (None, Some(given)),
        None => {
            let rests = |i: &usize| done[*i].rests_on.iter().any(is_it);
            let through = cited.clone().find(rests);
            (through, through.and_then(|i| done[i].rests_on.iter().copied().find(is_it)))
        }
    };
    Unreached { given, through, var: side.var, at: side.approach() }
}

/// A model of a goal's hypotheses, as the kernel accepted it.
fn accepted_model(goal: &Goal, model: &Model) -> Accepted {
    let evidence = Evidence::Model(model.clone());
    let digest = kane_kernel::digest(goal);
    let certificate =
        kane_kernel::Certificate { goal: digest, finding: Finding::Consistent, evidence };
    Accepted { goal: goal.clone(), certificate }
}

/// Worse is larger.
fn rank(v: Verdict) -> (u8, Verdict) {
    let rank = match v {
        Verdict::Vacuous => 5,
        Verdict::IllDefined => 4,
        Verdict::Refuted => 3,
        Verdict::Undecided => 2,
        _ => 1,
    };
    (rank, v)
}

fn link_judgement(goal: &Goal, resting: &Goal, cited: &[usize], found: Verdicts) -> LinkJudgement {
    let verdict = match found.decided.as_ref().map(|d| d.certificate.finding) {
        Some(Finding::Proved) => Verdict::Proved,
        Some(Finding::Refuted) => Verdict::Refuted,
        Some(Finding::IllDefined) => Verdict::IllDefined,
        Some(Finding::Vacuous) => Verdict::Vacuous,
        Some(Finding::Consistent) | None => Verdict::Undecided,
    };
    let undecided = LinkJudgement {
        verdict,
        certificate: None,
        used: Vec::new(),
        cost: found.cost,
        accepted: None,
        explanation: Explanation::default(),
        behind: None,
        open: None,
        attempt: None,
        unreached: None,
    };
    let Some(Decided { certificate, grounds }) = found.decided else {
        let attempt = explain::attempt(goal, found.attempt);
        return LinkJudgement { open: found.open, attempt, ..undecided };
    };
    let whose = if certificate.goal == kane_kernel::digest(goal) { goal } else { resting };
    let used = explain::used(whose, &grounds, cited.len());
    let behind = (!found.behind_met).then(|| behind(goal, resting, &certificate)).flatten();
    LinkJudgement {
        certificate: Some(format!("{:032x}", kane_kernel::digest(&certificate))),
        used: used.into_iter().filter_map(|i| cited.get(i).copied()).collect(),
        accepted: Some(Rc::new(Accepted { goal: whose.clone(), certificate })),
        explanation: Explanation::of(grounds),
        behind,
        ..undecided
    }
}

/// What is to be said of a witness and the givens behind what is cited, if anything.
fn behind(goal: &Goal, resting: &Goal, certificate: &kane_kernel::Certificate) -> Option<Behind> {
    if goal.hypotheses.len() == resting.hypotheses.len() {
        return None;
    }
    match &certificate.evidence {
        Evidence::Model(Model::Point(_)) => {
            let goal = kane_kernel::digest(resting);
            let again = kane_kernel::Certificate { goal, ..certificate.clone() };
            let met = kane_kernel::check(resting, &again, kane_kernel::Fuel::new(10_000_000));
            met.is_err().then_some(Behind::NotMet)
        }
        Evidence::Model(Model::Functions(_)) => Some(Behind::NotShown),
        Evidence::Contradiction(_) | Evidence::Limit(_) => None,
    }
}
