//! Claims that speak of indices: what is put to the kernel for them.
//!
//! A claim that speaks of the index n is one about all natural numbers. In its goal n is a real number, and
//! the symbols of powers and terms are whatever is declared of them. Less is known there than is true, so a
//! proof of the goal is a proof of the claim, but a point of it says nothing. Points count for goals in which
//! a natural number stands in the place of n, and what that makes of powers and terms in the place of
//! their symbols.
//!
//! A claim by induction is two such claims: itself at the first value of n, and, from itself at n, itself at
//! n + 1.

use std::collections::BTreeSet;

use kane_algebra::syntax::Sequences;
use kane_kernel::{
    Conclusion, Evidence, Finding, Goal, Hypothesis, Link, Model, Point, Relation, Sentence,
};

use crate::motion::mentioned;
use crate::prove::Verdicts;
use crate::{Claim, Document, Induction, Open};

/// The greatest numbers that are put in the place of one index, and of each of two.
const GREATEST: [u32; 2] = [8, 3];
/// Numbers that are tried for a model of premises alone.
const FOR_MODEL: usize = 3;
/// Symbols of a point that are named.
const MOST_NAMED: usize = 6;

/// What a link of a judgement is about.
pub(crate) enum Part {
    /// the claim as it stands
    Whole,
    /// its first value
    First(Induction),
    /// one step further; the conclusion at n itself
    Step(Induction, Box<Conclusion>),
    /// a step that comes to too much when it is written out
    Long,
}

/// What one link of a judgement asks.
pub(crate) struct Stage {
    pub(crate) hypotheses: Vec<Hypothesis>,
    pub(crate) conclusion: Conclusion,
    pub(crate) part: Part,
}

/// A goal with what was found about it.
pub(crate) struct Asked {
    pub(crate) goal: Goal,
    pub(crate) resting: Goal,
    pub(crate) found: Verdicts,
    /// the hypotheses that can hold, and where
    pub(crate) met: Option<(Goal, Model)>,
    /// the numbers in the place of indices
    pub(crate) at: Vec<(usize, u32)>,
}

/// Puts a goal, and the same with the givens behind its premises, to the prover; with the whole budget,
/// and with doubt whether the premises can hold, or without.
pub(crate) type Ask<'a> = &'a dyn Fn(Goal, Goal, (bool, bool)) -> Asked;

/// What the links of a claim ask, in their order.
pub(crate) fn stages(
    document: &Document,
    claim: &Claim,
    own: Option<Sentence>,
    conclusions: Vec<Conclusion>,
    hypotheses: &[Hypothesis],
) -> Vec<Stage> {
    let stage = |conclusion, part| Stage { hypotheses: hypotheses.to_vec(), conclusion, part };
    let (Some(induction), Some(own)) = (claim.induction, own) else {
        return conclusions.into_iter().map(|c| stage(c, Part::Whole)).collect();
    };
    let (n, sequences) = (induction.index, &document.sequences);
    let first = conclusions.iter().map(|c| stage(c.clone(), Part::First(induction)));
    let mut stages: Vec<Stage> = first.collect();
    let further =
        hypotheses.iter().filter(|h| sentence_speaks(sequences, document, &h.sentence, n));
    let further: Option<Vec<Hypothesis>> =
        further.map(|h| next_hypothesis(sequences, h, n)).collect();
    let own = Hypothesis { sentence: own, given: true };
    for conclusion in conclusions {
        let next = match &conclusion {
            Conclusion::Link(Link::Relation(r)) => sequences.next_relation(r, n),
            _ => None,
        };
        let Some((next, further)) = next.zip(further.as_ref()) else {
            stages.push(stage(conclusion, Part::Long));
            continue;
        };
        let next = Conclusion::Link(Link::Relation(next));
        let premises = [hypotheses, further, std::slice::from_ref(&own)].concat();
        let part = Part::Step(induction, Box::new(conclusion));
        stages.push(Stage { hypotheses: premises, conclusion: next, part });
    }
    stages
}

/// Judges what a link asks. `shown` says whether all links before it are proved.
pub(crate) fn judge(
    sequences: &Sequences,
    (goal, resting): (Goal, Goal),
    (part, doubt, shown): (Part, bool, bool),
    cited: usize,
    ask: Ask<'_>,
) -> Asked {
    match part {
        Part::Long => long(goal, resting),
        Part::Whole => whole(sequences, goal, resting, doubt, ask),
        Part::First(Induction { index, from }) => {
            let at = (index, from);
            match (goal_at(sequences, &goal, at), goal_at(sequences, &resting, at)) {
                (Some(goal), Some(resting)) => whole(sequences, goal, resting, doubt, ask),
                _ => long(goal, resting),
            }
        }
        Part::Step(Induction { index, from }, conclusion) => {
            let mut direct = Goal { conclusion: *conclusion, ..goal.clone() };
            direct.hypotheses.truncate(cited);
            let direct_resting = Goal { conclusion: direct.conclusion.clone(), ..resting };
            let mut asked = ask(goal.clone(), goal, (true, false));
            asked.met = None;
            asked.found.model = None;
            let failing = failing(&asked);
            match asked.found.decided.as_ref().map(|d| d.certificate.finding) {
                Some(Finding::Proved) => return asked,
                // what contradicts itself at n and holds at the first value is contradicted by the premises
                Some(Finding::Vacuous) if shown => return asked,
                _ => {}
            }
            for value in from + 1..=from + GREATEST[0] {
                let at = (index, value);
                let instance = goal_at(sequences, &direct, at);
                let instance = instance.zip(goal_at(sequences, &direct_resting, at));
                let Some((goal, resting)) = instance else { break };
                if let Some(found) = instance_found(sequences, goal, resting, ask) {
                    return Asked { at: vec![at], met: None, ..found };
                }
            }
            if asked.found.decided.take().is_some() {
                asked.found.open = Some(Open::Step(failing));
            }
            asked
        }
    }
}

/// Judges a claim as it stands.
fn whole(sequences: &Sequences, goal: Goal, resting: Goal, doubt: bool, ask: Ask<'_>) -> Asked {
    let indices = indices(sequences, [&goal, &resting]);
    if indices.is_empty() {
        return ask(goal, resting, (true, doubt));
    }
    let mut asked = ask(goal.clone(), resting.clone(), (true, doubt));
    (asked.found.model, asked.met) = (None, None);
    if asked.found.decided.as_ref().is_some_and(|d| is_model(&d.certificate.evidence)) {
        asked.found.decided = None;
        asked.found.open = Some(Open::Index);
    }
    let decided = asked.found.decided.is_some();
    if decided && !doubt {
        return asked;
    }
    let tuples = tuples(&indices);
    let most = if decided { FOR_MODEL } else { tuples.len() };
    for at in tuples.into_iter().take(most) {
        let put_in = |goal: &Goal| {
            at.iter().try_fold(goal.clone(), |goal, at| goal_at(sequences, &goal, *at))
        };
        let Some((goal, resting)) = put_in(&goal).zip(put_in(&resting)) else { break };
        if !self::indices(sequences, [&goal, &resting]).is_empty() {
            break;
        }
        let found = ask(goal, resting, (false, true));
        if asked.met.is_none() {
            asked.met.clone_from(&found.met);
        }
        if decided && asked.met.is_some() {
            return asked;
        }
        if !decided
            && found.found.decided.as_ref().is_some_and(|d| is_model(&d.certificate.evidence))
        {
            return Asked { at, ..found };
        }
    }
    asked
}

/// What a point decides where numbers stand in the place of all indices.
fn instance_found(sequences: &Sequences, goal: Goal, resting: Goal, ask: Ask<'_>) -> Option<Asked> {
    if !indices(sequences, [&goal, &resting]).is_empty() {
        return None;
    }
    let found = ask(goal, resting, (false, false));
    let decides = found.found.decided.as_ref().is_some_and(|d| is_model(&d.certificate.evidence));
    decides.then_some(found)
}

/// What cannot be put to the kernel.
fn long(goal: Goal, resting: Goal) -> Asked {
    let found = Verdicts { open: Some(Open::Long), ..Verdicts::default() };
    Asked { goal, resting, found, met: None, at: Vec::new() }
}

fn is_model(evidence: &Evidence) -> bool {
    matches!(evidence, Evidence::Model(_))
}

/// The indices of which goals speak.
fn indices(sequences: &Sequences, goals: [&Goal; 2]) -> BTreeSet<usize> {
    if sequences.is_empty() {
        return BTreeSet::new();
    }
    let symbols = goals.into_iter().flat_map(mentioned);
    symbols.filter_map(|v| sequences.index_of(v)).collect()
}

/// The numbers that are tried in the place of indices.
fn tuples(indices: &BTreeSet<usize>) -> Vec<Vec<(usize, u32)>> {
    match indices.iter().copied().collect::<Vec<_>>()[..] {
        [n] => (0..=GREATEST[0]).map(|value| vec![(n, value)]).collect(),
        [n, m] => {
            let all = (0..=GREATEST[1]).flat_map(|a| (0..=GREATEST[1]).map(move |b| (a, b)));
            all.map(|(a, b)| vec![(n, a), (m, b)]).collect()
        }
        _ => Vec::new(),
    }
}

fn sentence_speaks(sequences: &Sequences, document: &Document, s: &Sentence, n: usize) -> bool {
    let goal = Goal {
        context: document.context.clone(),
        hypotheses: vec![Hypothesis { sentence: s.clone(), given: true }],
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    };
    mentioned(&goal).into_iter().any(|v| sequences.index_of(v) == Some(n))
}

fn next_hypothesis(sequences: &Sequences, h: &Hypothesis, n: usize) -> Option<Hypothesis> {
    let next = |r: &Relation| sequences.next_relation(r, n);
    let link = |link: &Link| match link {
        Link::Relation(r) => next(r).map(Link::Relation),
        Link::Limit(_) => Some(link.clone()),
    };
    let when = h.sentence.when.iter().map(next).collect::<Option<_>>()?;
    let links = h.sentence.links.iter().map(link).collect::<Option<_>>()?;
    Some(Hypothesis { sentence: Sentence { when, links }, given: h.given })
}

/// The goal with a number in the place of an index; nothing if it comes to too much.
fn goal_at(sequences: &Sequences, goal: &Goal, (n, value): (usize, u32)) -> Option<Goal> {
    let relations = |rs: &[Relation]| -> Option<Vec<Relation>> {
        rs.iter().map(|r| sequences.relation_at(r, n, value)).collect()
    };
    let link = |link: &Link| match link {
        Link::Relation(r) => sequences.relation_at(r, n, value).map(Link::Relation),
        Link::Limit(_) => Some(link.clone()),
    };
    let sentence = |s: &Sentence| {
        let links = s.links.iter().map(link).collect::<Option<Vec<Link>>>()?;
        Some(Sentence { when: relations(&s.when)?, links })
    };
    let hypothesis =
        |h: &Hypothesis| Some(Hypothesis { sentence: sentence(&h.sentence)?, given: h.given });
    Some(Goal {
        context: goal.context.clone(),
        hypotheses: goal.hypotheses.iter().map(hypothesis).collect::<Option<_>>()?,
        behind: goal.behind.clone(),
        when: relations(&goal.when)?,
        conclusion: match &goal.conclusion {
            Conclusion::Link(l) => Conclusion::Link(link(l)?),
            Conclusion::Contradiction => Conclusion::Contradiction,
            Conclusion::NotImplied(s) => Conclusion::NotImplied(sentence(s)?),
        },
    })
}

/// The values for which a step fails.
fn failing(asked: &Asked) -> String {
    let Some(decided) = &asked.found.decided else { return String::new() };
    let Evidence::Model(Model::Point(Point { generator: None, values, .. })) =
        &decided.certificate.evidence
    else {
        return "values that are no rational numbers".to_owned();
    };
    let vars = &asked.goal.context.vars;
    let named = values.iter().filter_map(|(v, value)| {
        let value = value.first().map_or_else(|| "0".to_owned(), ToString::to_string);
        Some(format!("{} = {value}", vars.get(*v)?.name))
    });
    let mut named: Vec<String> = named.collect();
    if named.len() > MOST_NAMED {
        named.truncate(MOST_NAMED);
        named.push("…".to_owned());
    }
    match named.is_empty() {
        true => "all values".to_owned(),
        false => named.join(", "),
    }
}
