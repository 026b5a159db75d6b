//! What was judged before: a claim about which nothing has changed that its judge reads is not judged
//! again.
//!
//! A judgement is a function of what its judge reads, since budgets count steps and not time. All of
//! that is the key, compared as a whole and not by a digest: symbols with their domains, angles and
//! derivatives; the definitions that are reached; the claim, what it cites, how that was judged, and
//! the givens behind it; the budget, and what the claim may spend of the document's; and the points
//! that claims above left for others to try. Of a refutation the judge also asks which givens above
//! fail, and which would do: then all givens above and all definitions are part of it, too. Claims of
//! documents with sequences are not remembered.

use std::collections::HashMap;
use std::hash::Hash;
use std::ops::RangeInclusive;

use kane_algebra::syntax::{Angle, Exponential};
use kane_kernel::{Definition, Expr, Hypothesis, Link, Model, Relation, Sentence, Var};

use crate::prove::{Budget, REMEMBERED};
use crate::{Claim, Content, Document, Judgement, Verdict};

/// Audits for which a judgement is kept that none of them needed.
const KEPT_FOR: u64 = 16;
/// Sentences and definitions, as numbers, beyond which all is forgotten.
const MOST_NUMBERS: usize = 200_000;

/// Judgements to be used again, by whoever audits a text time and again while it is written.
///
/// [`audit_again`](crate::audit_again) with a memo and without one come to the same audit, step counts
/// and certificates included. What sixteen audits in a row did not need is forgotten.
#[derive(Debug, Default)]
pub struct Memo {
    known: HashMap<Key, Entry>,
    grounds: Numbers<Ground>,
    sentences: Numbers<Hypothesis>,
    definitions: Numbers<Vec<Definition>>,
    above: Numbers<(usize, usize, usize)>,
    audits: u64,
    /// the numbers of the document that is being judged
    ground: usize,
    all_definitions: usize,
    /// how many claims were judged, and how many were known
    counts: (u64, u64),
}

/// Values with a number each, equal ones with the same.
#[derive(Debug)]
struct Numbers<T>(HashMap<T, usize>);

impl<T> Default for Numbers<T> {
    fn default() -> Self {
        Self(HashMap::new())
    }
}

impl<T: Eq + Hash> Numbers<T> {
    fn of(&mut self, value: T) -> usize {
        let next = self.0.len();
        *self.0.entry(value).or_insert(next)
    }
}

/// What all claims of a document read.
#[derive(Debug, PartialEq, Eq, Hash)]
struct Ground {
    vars: Vec<Var>,
    rates: Vec<(usize, usize)>,
    angles: Vec<(usize, usize, usize, u32)>,
    exponentials: Vec<Exponential>,
    measured: Vec<usize>,
    derived: Vec<(usize, usize)>,
    budget: Budget,
}

/// What the judge of a claim reads.
#[derive(Debug, PartialEq, Eq, Hash)]
pub(crate) struct Key {
    ground: usize,
    /// the definitions that are reached; of the others their names
    definitions: usize,
    /// how many statements stand above
    above: usize,
    content: Said,
    exists: bool,
    when: Vec<Relation>,
    using: Vec<Expr>,
    by: Vec<(usize, Expr)>,
    cited: Vec<Cited>,
    /// the givens behind what is cited, and what they say
    behind: Vec<(usize, Option<usize>)>,
    /// points and functions of earlier claims
    earlier: Vec<Model>,
    /// what it may spend of the document's budget
    work: u64,
}

#[derive(Debug, PartialEq, Eq, Hash)]
enum Said {
    Links(Vec<Link>),
    Contradiction,
    NotImplied(usize, Option<usize>),
}

#[derive(Debug, PartialEq, Eq, Hash)]
struct Cited {
    statement: usize,
    says: Option<usize>,
    verdict: Verdict,
    rests_on: Vec<usize>,
}

/// What a judge came to.
#[derive(Debug)]
struct Entry {
    judgement: Judgement,
    /// what it spent of the document's budget
    spent: u64,
    /// models that it left for later claims
    left: Vec<Model>,
    /// the givens above and all definitions, if it read them
    read_above: Option<(usize, usize)>,
    /// the audit that needed it last
    needed: u64,
}

impl Memo {
    /// How many claims were judged so far, and how many were known.
    #[must_use]
    pub const fn counts(&self) -> (u64, u64) {
        self.counts
    }

    /// Before the claims of a document are judged.
    pub(crate) fn begin(&mut self, document: &Document, budget: Budget) {
        let numbers = self.sentences.0.len() + self.definitions.0.len() + self.above.0.len();
        if numbers > MOST_NUMBERS || self.grounds.0.len() > MOST_NUMBERS / 1_000 {
            *self = Self { audits: self.audits, counts: self.counts, ..Self::default() };
        }
        let motion = &document.motion;
        let angle =
            |(symbol, Angle { cos, sin, parts }): &(usize, Angle)| (*symbol, *cos, *sin, *parts);
        self.ground = self.grounds.of(Ground {
            vars: document.context.vars.clone(),
            rates: motion.rates.iter().map(|(a, b)| (*a, *b)).collect(),
            angles: motion.angles.iter().map(angle).collect(),
            exponentials: motion.exponentials.clone(),
            measured: motion.measured.iter().map(|(theta, _)| *theta).collect(),
            derived: motion.derived.iter().map(|(a, b)| (*a, *b)).collect(),
            budget,
        });
        self.all_definitions = self.definitions.of(document.context.lets.clone());
    }

    /// After all of them: forgets what has not been needed for long.
    pub(crate) fn end(&mut self) {
        self.audits += 1;
        let kept: RangeInclusive<u64> = self.audits.saturating_sub(KEPT_FOR)..=self.audits;
        self.known.retain(|_, entry| kept.contains(&entry.needed));
    }

    /// The number of the givens above a statement, when this one is added to them.
    pub(crate) fn given(&mut self, above: usize, index: usize, sentence: &Sentence) -> usize {
        let says = self.sentences.of(Hypothesis { sentence: sentence.clone(), given: true });
        self.above.of((above + 1, index, says))
    }

    /// All that the judge of a claim reads, but for what it reads of a refutation.
    pub(crate) fn key(&mut self, claim: &Claim, read: Read<'_>) -> Key {
        let Read { done, hypothesis, definitions, earlier, work } = read;
        let mut says = |index: usize| hypothesis(index).map(|said| self.sentences.of(said));
        let content = match &claim.content {
            Content::Links(links) => Said::Links(links.iter().map(|(l, _)| l.clone()).collect()),
            // of what is sought one proposal after the other is judged, as links
            Content::Sought(_) | Content::Contradiction => Said::Contradiction,
            Content::NotImplied(target) => Said::NotImplied(*target, says(*target)),
        };
        let cited = |&index: &usize| Cited {
            statement: index,
            says: says(index),
            verdict: done[index].verdict,
            rests_on: done[index].rests_on.clone(),
        };
        let cited: Vec<Cited> = claim.from.iter().map(cited).collect();
        let behind = rests_on(claim, done).into_iter().map(|index| (index, says(index))).collect();
        Key {
            ground: self.ground,
            definitions: self.definitions.of(definitions),
            above: done.len(),
            content,
            exists: claim.exists,
            when: claim.when.clone(),
            using: claim.using.clone(),
            by: claim.by.clone(),
            cited,
            behind,
            earlier: earlier.iter().rev().take(REMEMBERED).cloned().collect(),
            work,
        }
    }

    /// The judgement, if all is as it was, and what it spent; what it left for later claims is left again.
    pub(crate) fn known(
        &mut self,
        key: &Key,
        above: usize,
        earlier: &mut Vec<Model>,
    ) -> Option<(Judgement, u64)> {
        let now = (above, self.all_definitions);
        let entry = self.known.get_mut(key)?;
        if entry.read_above.is_some_and(|then| then != now) {
            return None;
        }
        entry.needed = self.audits;
        earlier.extend_from_slice(&entry.left);
        self.counts.1 += 1;
        Some((entry.judgement.clone(), entry.spent))
    }

    /// Keeps a judgement.
    pub(crate) fn keep(
        &mut self,
        key: Key,
        (judgement, read_above): (Judgement, bool),
        (spent, left): (u64, &[Model]),
        above: usize,
    ) {
        let read_above = read_above.then_some((above, self.all_definitions));
        self.counts.0 += 1;
        let left = left.to_vec();
        self.known.insert(key, Entry { judgement, spent, left, read_above, needed: self.audits });
    }
}

/// What stands around a claim.
pub(crate) struct Read<'a> {
    /// the judgements of the statements above
    pub(crate) done: &'a [Judgement],
    /// what a statement says as a premise
    pub(crate) hypothesis: &'a dyn Fn(usize) -> Option<Hypothesis>,
    /// the definitions, those emptied that the claim does not reach
    pub(crate) definitions: Vec<Definition>,
    /// models of claims above
    pub(crate) earlier: &'a [Model],
    /// what it may spend of the document's budget
    pub(crate) work: u64,
}

/// The givens on which a claim rests through what it cites, ascending.
pub(crate) fn rests_on(claim: &Claim, done: &[Judgement]) -> Vec<usize> {
    let each = claim.from.iter().flat_map(|&i| done[i].rests_on.iter().copied());
    let mut rests_on: Vec<usize> = each.collect();
    rests_on.sort_unstable();
    rests_on.dedup();
    rests_on
}
