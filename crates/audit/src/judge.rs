//! Judging a document: goals out of statements, verdicts out of findings.

mod definitions;
mod motions;

use std::cell::RefCell;
use std::rc::Rc;

use kane_kernel::{
    Conclusion, Context, Definition, Evidence, Expr, Finding, Fuel, Goal, Hypothesis, Link, Model,
    Sentence, Side,
};

use self::definitions::{kept, link_parts, needed_lets};
use self::motions::{at_zero, only_motions};
use crate::behind::Witnessed;
use crate::memo::{self, Memo, Read};
use crate::prove::{Budget, Decided, Memory, Prover, Verdicts, expanded};
use crate::{
    Accepted, Audit, Body, Claim, Content, Document, Existence, Explanation, Judgement,
    LinkJudgement, Open, Unreached, Verdict, explain, index,
};

/// What the search for one number in the place of an index has of the work that a claim may take.
const SHARE: u64 = 4;
/// What the look at one proposal for something that exists has of the work that a claim may take.
const PROPOSAL: u64 = 16;
/// How many proposals are looked at with more.
const FURTHER: usize = 3;

/// What to judge, and with how much effort.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// indices of the claims to judge, with all that they cite; `None` for all
    pub only: Option<Vec<usize>>,
    /// effort a link, and all links together
    pub budget: Budget,
}

/// Judges a document. `progress` is told, before each statement, its index and their number.
pub fn audit(
    mut document: Document,
    options: &Options,
    progress: &mut dyn FnMut(usize, usize),
) -> Audit {
    let mut go_on = |done, all| {
        progress(done, all);
        true
    };
    let judgements = judge_all(&mut document, options, None, &mut go_on);
    Audit { document, judgements: judgements.unwrap_or_default() }
}

/// Judges a document as [`audit`] does, but for the claims about which nothing has changed since they
/// were judged with this memo. `go_on` is asked before each statement, with its index and their number;
/// `None` if it says no.
pub fn audit_again(
    mut document: Document,
    options: &Options,
    memo: &mut Memo,
    go_on: &mut dyn FnMut(usize, usize) -> bool,
) -> Option<Audit> {
    memo.begin(&document, options.budget);
    let judgements = judge_all(&mut document, options, Some(memo), go_on)?;
    memo.end();
    Some(Audit { document, judgements })
}

/// The judgements of all statements; `None` if it is not to go on. A witness that is found is put into the document.
fn judge_all(
    document: &mut Document,
    options: &Options,
    mut memo: Option<&mut Memo>,
    go_on: &mut dyn FnMut(usize, usize) -> bool,
) -> Option<Vec<Judgement>> {
    let count = document.statements.len();
    let wanted = wanted(document, options);
    let earlier = RefCell::default();
    let is_judged: Vec<bool> = (0..count)
        .map(|i| wanted[i] && matches!(document.statements[i].body, Body::Claim(_)))
        .collect();
    let claims = is_judged.iter().filter(|judged| **judged).count() as u64;
    let (whole, mut after) = (Fuel::new(options.budget.document), claims);
    let mut judgements: Vec<Judgement> = Vec::with_capacity(count);
    let mut above = 0;
    for (i, wanted) in wanted.into_iter().enumerate() {
        if !go_on(i, count) {
            return None;
        }
        after -= u64::from(is_judged[i]);
        let work = || whole.within(options.budget.of_claim(whole.left(), claims, after));
        if wanted
            && let Some(found) =
                found(document, i, &judgements, (options.budget, &work(), &earlier))
        {
            judgements.push(found);
            continue;
        }
        let judgement = match &document.statements[i].body {
            Body::Let(_) | Body::Defined(_) => plain_verdict(Verdict::Defined, Vec::new()),
            Body::Given(sentence) => {
                if let Some(memo) = &mut memo {
                    above = memo.given(above, i, sentence);
                }
                plain_verdict(Verdict::Assumed, vec![i])
            }
            Body::Claim(claim) if wanted => {
                let prover = (options.budget, &work(), &earlier);
                match &mut memo {
                    // what sequences stand for is read, too, and is in no key
                    Some(memo) if document.sequences.is_empty() => {
                        recall((document, claim, &judgements[..]), prover, (memo, above))
                    }
                    _ => judge(document, claim, &judgements, prover).0,
                }
            }
            Body::Claim(_) => plain_verdict(Verdict::Undecided, Vec::new()),
        };
        judgements.push(judgement);
    }
    Some(judgements)
}

/// Looks for what the statement at this index says exists and does not name, and puts it into the document; the
/// judgement. Nothing for another statement.
fn found(
    document: &mut Document,
    index: usize,
    done: &[Judgement],
    (budget, work, earlier): (Budget, &Fuel, &RefCell<Vec<Model>>),
) -> Option<Judgement> {
    let Body::Claim(claim) = &document.statements[index].body else { return None };
    let Content::Sought(existence) = &claim.content else { return None };
    let proposed = existence.proposed(&claim.when, &document.context);
    let tried = proposed.len();
    let claims = proposed.into_iter().map(|values| Claim {
        content: Content::Links(existence.of(&values)),
        found: existence.names.iter().cloned().zip(values).collect(),
        ..claim.clone()
    });
    let shows =
        |judgement: &Judgement| matches!(judgement.conditional, Verdict::Proved | Verdict::Vacuous);
    // each has a little, and then those all that no point speaks against
    let mut open = Vec::new();
    let mut decided = None;
    for claim in claims {
        let work = work.within(work.left() / PROPOSAL);
        let (judgement, _) =
            judge(document, &claim, done, (budget.share(PROPOSAL), &work, earlier));
        let fails = |link: &LinkJudgement| link.open == Some(Open::Witness);
        if shows(&judgement) {
            decided = Some((claim, judgement));
            break;
        }
        if !judgement.links.iter().any(fails) {
            open.push(claim);
        }
    }
    let further = open.into_iter().take(FURTHER).map(|claim| {
        let work = work.within(work.left() / 2);
        let (judgement, _) = judge(document, &claim, done, (budget, &work, earlier));
        (claim, judgement)
    });
    let decided = decided.or_else(|| further.into_iter().find(|(_, judgement)| shows(judgement)));
    let Some((claim, judgement)) = decided else {
        return Some(unfound(document, claim, existence, done, tried));
    };
    document.statements[index].body = Body::Claim(claim);
    Some(judgement)
}

/// That nothing was found which a claim says exists.
fn unfound(
    document: &Document,
    claim: &Claim,
    existence: &Existence,
    done: &[Judgement],
    tried: usize,
) -> Judgement {
    let unproved = unproved(claim, done);
    let link = LinkJudgement { open: Some(Open::Unfound(tried)), ..LinkJudgement::default() };
    Judgement {
        verdict: if unproved.is_empty() { Verdict::Undecided } else { Verdict::Unsupported },
        links: vec![link; existence.links.len()],
        unproved,
        hypotheses: premises(document, claim),
        expect: claim.expect,
        ..plain_verdict(Verdict::Undecided, memo::rests_on(claim, done))
    }
}

/// The cited statements that are not proved.
fn unproved(claim: &Claim, done: &[Judgement]) -> Vec<usize> {
    let shown = |verdict| matches!(verdict, Verdict::Proved | Verdict::Assumed | Verdict::Defined);
    claim.from.iter().copied().filter(|&i| !shown(done[i].verdict)).collect()
}

/// The cited statements that say something.
fn premises(document: &Document, claim: &Claim) -> Vec<usize> {
    claim.from.iter().copied().filter(|&i| hypothesis(document, i).is_some()).collect()
}

/// The judgement of a claim, from the memo if it is there.
fn recall(
    (document, claim, done): (&Document, &Claim, &[Judgement]),
    (budget, work, earlier): (Budget, &Fuel, &RefCell<Vec<Model>>),
    (memo, above): (&mut Memo, usize),
) -> Judgement {
    let given = work.left();
    let key = {
        let read = Read {
            done,
            hypothesis: &|index| hypothesis(document, index),
            definitions: reached(document, claim, done),
            earlier: &earlier.borrow(),
            work: given,
        };
        memo.key(claim, read)
    };
    if let Some((known, spent)) = memo.known(&key, above, &mut earlier.borrow_mut()) {
        // it was there when the claim was judged, of as much
        let spent = work.spend(spent);
        debug_assert!(spent.is_ok(), "a claim spends no more than it is given");
        // what the author thinks of it is not read by its judge
        return Judgement { expect: claim.expect, ..known };
    }
    let before = earlier.borrow().len();
    let judged = judge(document, claim, done, (budget, work, earlier));
    let judgement = judged.0.clone();
    let spent = given.saturating_sub(work.left());
    memo.keep(key, judged, (spent, &earlier.borrow()[before..]), above);
    judgement
}

/// The document's definitions with those emptied that nothing reaches which the judge of a claim reads.
fn reached(document: &Document, claim: &Claim, done: &[Judgement]) -> Vec<Definition> {
    let mut cited = claim.from.clone();
    cited.extend(memo::rests_on(claim, done));
    if let Content::NotImplied(target) = claim.content {
        cited.push(target);
    }
    let premises: Vec<Hypothesis> =
        cited.into_iter().filter_map(|i| hypothesis(document, i)).collect();
    let mut roots: Vec<&Expr> = claim.using.iter().chain(claim.by.iter().map(|b| &b.1)).collect();
    roots.extend(claim.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
    if let Content::Links(links) = &claim.content {
        roots.extend(links.iter().flat_map(|(l, _)| link_parts(l)));
    }
    for Hypothesis { sentence, .. } in &premises {
        roots.extend(sentence.when.iter().flat_map(|r| [&r.lhs, &r.rhs]));
        roots.extend(sentence.links.iter().flat_map(link_parts));
    }
    kept(&document.context.lets, roots)
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

/// Whether a claim or a premise that it cites is about a limit.
fn of_limits(claim: &Claim, hypotheses: &[Hypothesis]) -> bool {
    let limit = |l: &Link| matches!(l, Link::Limit(_));
    let claimed = match &claim.content {
        Content::Links(links) => links.iter().any(|(l, _)| limit(l)),
        Content::Contradiction | Content::Sought(_) => false,
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
        Content::Contradiction | Content::NotImplied(_) | Content::Sought(_) => None,
    }
}

/// The judgement of a claim, and whether all givens above and all definitions were read for it.
fn judge(
    document: &Document,
    claim: &Claim,
    done: &[Judgement],
    (budget, work, earlier): (Budget, &Fuel, &RefCell<Vec<Model>>),
) -> (Judgement, bool) {
    let unproved = unproved(claim, done);
    let rests_on = memo::rests_on(claim, done);
    let cited = premises(document, claim);
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
        Content::Sought(_) => Vec::new(),
        Content::NotImplied(m) => {
            let sentence = hypothesis(document, *m).map(|h| h.sentence);
            sentence.map(Conclusion::NotImplied).into_iter().collect()
        }
    };
    let using: Vec<Expr> =
        claim.using.iter().filter_map(|e| expanded(e, &document.context)).collect();
    let mut links: Vec<LinkJudgement> = Vec::new();
    let (mut met, mut vacuous, mut read_above) = (None, false, false);
    let stages = index::stages(document, claim, sentence(claim), conclusions, &hypotheses);
    let from_text = hypotheses.len();
    for index::Stage { conclusion, hypotheses, part } in stages {
        let along = hypotheses.iter().map(|h| &h.sentence.links[..]).chain([conclusion.links()]);
        let limits = along.flatten().any(|l| matches!(l, Link::Limit(_)));
        let goal = Goal {
            context: Context { vars: document.context.vars.clone(), ..Context::default() },
            hypotheses: hypotheses.clone(),
            behind: if limits { ranged.clone() } else { Vec::new() },
            when: claim.when.clone(),
            conclusion,
        };
        let resting = Goal {
            hypotheses: [&hypotheses[..from_text], &behind[..]].concat(),
            behind: Vec::new(),
            ..goal.clone()
        };
        let ids = [&cited[..], &further].concat();
        let complete_behind = behind.is_empty();
        let ask = |mut goal: Goal, mut resting: Goal, (whole, doubt): (bool, bool)| {
            goal.context.lets = needed_lets(document, &goal, &behind, &claim.by);
            resting.context.lets.clone_from(&goal.context.lets);
            let prover = Prover {
                budget: if whole { budget } else { budget.share(SHARE) },
                work: work.clone(),
                using: &using,
                by: &claim.by,
                earlier,
                near: Memory::default(),
                cited: goal.hypotheses.len(),
                resting: &resting,
            };
            let mut found = prover.judge(&goal, doubt);
            only_within_ranges(document, (&goal, &ids), &mut found);
            if document.motion.concerns(&resting) {
                if !complete_behind {
                    prover.of_all(&mut found);
                }
                only_motions(document, (&resting, &ids), complete_behind, &mut found);
                at_zero(document, (&resting, &ids), &prover, complete_behind, &mut found);
            }
            if claim.exists {
                only_proofs(&mut found);
            }
            let met = found.model.as_ref().map(|model| (goal.clone(), model.clone()));
            index::Asked { goal, resting, found, met, at: Vec::new() }
        };
        let before = work.left();
        // The hypotheses are the same for all links: whether they can hold is found once.
        let doubt = links.is_empty() || vacuous;
        let shown = links.iter().all(|l| l.verdict == Verdict::Proved);
        let task = (part, doubt, shown);
        let asked = index::judge(
            &document.sequences,
            (goal, resting),
            task,
            hypotheses.len().min(from_text),
            &ask,
        );
        let index::Asked { goal, resting, mut found, met: model, at } = asked;
        let unreached = found.unreached.as_ref();
        let unreached =
            unreached.map(|(side, given)| unreached_by(document, claim, done, side, given));
        vacuous |= matches!(&found.decided, Some(d) if d.certificate.finding == Finding::Vacuous);
        if met.is_none() {
            met = model.as_ref().map(|(goal, model)| Rc::new(accepted_model(goal, model)));
        }
        let witnessed = Witnessed {
            document,
            above: done.len(),
            goal: &goal,
            cited: &cited,
            further: &further,
            budget,
            work,
        };
        let (standing, beside) = witnessed.standing(&mut found).unzip();
        let beside = beside.flatten().map(Rc::new);
        read_above |= standing.is_some();
        let would_do = witnessed.would_do(standing.as_ref());
        let judged = link_judgement((&goal, &resting), &cited, found);
        let work = before.saturating_sub(work.left());
        links.push(LinkJudgement { work, unreached, standing, beside, would_do, at, ..judged });
    }
    let worst = links.iter().map(|l| rank(l.verdict)).max().map_or(Verdict::Undecided, |r| r.1);
    let judgement = Judgement {
        verdict: if unproved.is_empty() { worst } else { Verdict::Unsupported },
        conditional: worst,
        links,
        unproved,
        rests_on,
        hypotheses: cited,
        met,
        expect: claim.expect,
    };
    (judgement, read_above)
}

/// Where a limit is spoken of, and a premise rests on a given that may hold nowhere near it, keeps nothing that was
/// found by way of it; but that hypotheses contradict each other near a limit that is claimed needs no range.
fn only_within_ranges(document: &Document, (goal, ids): (&Goal, &[usize]), found: &mut Verdicts) {
    let Some((side, given)) = document.motion.unheld(goal, ids) else { return };
    let premised = goal.hypotheses.iter().any(|h| h.sentence.limits().next().is_some());
    let stays = |decided: &Decided| match decided.certificate.finding {
        Finding::Vacuous => !premised,
        Finding::Proved => false,
        Finding::Refuted | Finding::IllDefined | Finding::Consistent => true,
    };
    if found.decided.as_ref().is_some_and(stays) {
        return;
    }
    found.decided = None;
    found.unreached = hypothesis(document, given).map(|given| (side, given.sentence));
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

fn link_judgement(
    (goal, resting): (&Goal, &Goal),
    cited: &[usize],
    found: Verdicts,
) -> LinkJudgement {
    let verdict = match found.decided.as_ref().map(|d| d.certificate.finding) {
        Some(Finding::Proved) => Verdict::Proved,
        Some(Finding::Refuted) => Verdict::Refuted,
        Some(Finding::IllDefined) => Verdict::IllDefined,
        Some(Finding::Vacuous) => Verdict::Vacuous,
        Some(Finding::Consistent) | None => Verdict::Undecided,
    };
    let undecided = LinkJudgement { verdict, cost: found.cost, ..LinkJudgement::default() };
    let Some(Decided { certificate, grounds, kept }) = found.decided else {
        let attempt = explain::attempt(goal, found.attempt);
        return LinkJudgement { open: found.open, attempt, ..undecided };
    };
    let whose = if certificate.goal == kane_kernel::digest(goal) { goal } else { resting };
    let used = explain::used(whose, &grounds, cited.len());
    LinkJudgement {
        certificate: Some(format!("{:032x}", kane_kernel::digest(&certificate))),
        used: used.into_iter().filter_map(|i| cited.get(i).copied()).collect(),
        accepted: Some(Rc::new(Accepted { goal: whose.clone(), certificate })),
        explanation: Explanation::of(grounds, kept),
        ..undecided
    }
}
