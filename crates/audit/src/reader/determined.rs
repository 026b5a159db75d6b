//! Givens that hold near a limit for the functions that are meant, and not only for some.
//!
//! The range of a `given` is where it can hold for some functions in it, and the kernel is shown such functions. But
//! exp(t), and the cosine and the sine of an angle, are no functions that could be chosen: their values are
//! determined, and the kernel does not know them. A `given` that speaks of them holds wherever it is an
//! equation, or an inequality, of a function that is free to have that value.

use std::collections::{BTreeMap, BTreeSet};

use kane_kernel::{Bound, Expr, Rel, Sentence};
use num_traits::Zero as _;

use super::Reader;
use super::citation::DraftBody;

impl Reader {
    /// The `given`s of the author that may hold nowhere near a limit, with the variables of such limits.
    pub(super) fn undetermined(&self) -> BTreeMap<usize, BTreeSet<usize>> {
        let of_author = |i: &usize| {
            let mut made = self.circles.values().chain(self.arcs.values());
            !made.any(|own| own == i) && !self.exponentials.values().any(|own| own == i)
        };
        let mut out = BTreeMap::new();
        for (i, draft) in self.drafts.iter().enumerate().filter(|(i, _)| of_author(i)) {
            let DraftBody::Given(sentence) = &draft.body else { continue };
            let determined = self.determined(sentence);
            let variables: BTreeSet<usize> =
                determined.iter().filter_map(|v| self.scope.context().vars.get(*v)?.of).collect();
            if !variables.is_empty() && !self.holds_by_choice(sentence, &determined) {
                out.insert(i, variables);
            }
        }
        out
    }

    /// The exponentials, logarithms, cosines and sines in a statement that are functions.
    fn determined(&self, sentence: &Sentence) -> BTreeSet<usize> {
        let relations = sentence.when.iter().chain(sentence.relations());
        let spoken = relations.flat_map(|r| [&r.lhs, &r.rhs]).flat_map(|e| self.scope.symbols(e));
        spoken.filter(|v| self.is_determined(*v)).collect()
    }

    fn is_determined(&self, v: usize) -> bool {
        let varies = self.scope.context().vars.get(v).is_some_and(|var| var.of.is_some());
        varies && (self.scope.exponential_at(v).is_some() || self.scope.angle_at(v).is_some())
    }

    /// Whether each relation that speaks of these has a function alone on one side that is free to be what
    /// stands on the other, or close to it: nothing else is said of it, and the other side has a value
    /// everywhere.
    fn holds_by_choice(&self, sentence: &Sentence, determined: &BTreeSet<usize>) -> bool {
        let symbols = |e: &Expr| self.scope.inside(self.scope.symbols(e));
        let speaks = |e: &Expr| !self.scope.symbols(e).is_disjoint(determined);
        let (mut chosen, mut read) = (BTreeSet::new(), BTreeSet::new());
        let mut others: Vec<&Expr> = Vec::new();
        for relation in sentence.relations() {
            let (lhs, rhs) = (&relation.lhs, &relation.rhs);
            if !speaks(lhs) && !speaks(rhs) {
                others.extend([lhs, rhs]);
                continue;
            }
            let mut sides = [(lhs, rhs), (rhs, lhs)].into_iter();
            let free = |(one, value)| Some((self.free(one, value, relation.rel)?, value));
            let Some((f, value)) = sides.find_map(free) else { return false };
            read.extend(symbols(value));
            // chosen before, or read by what was chosen before
            if read.contains(&f) || !chosen.insert(f) {
                return false;
            }
        }
        let apart = |e: &Expr| symbols(e).is_disjoint(&chosen);
        let conditions = || sentence.when.iter().flat_map(|r| [&r.lhs, &r.rhs]);
        others.into_iter().all(apart)
            && conditions().all(|e| self.scope.has_value(e) || !speaks(e) && apart(e))
    }

    /// The symbol that one side is, if it is a function that may be the other side, or close to it.
    fn free(&self, one: &Expr, value: &Expr, rel: Rel) -> Option<usize> {
        let Expr::Var(f) = one else { return None };
        let var = self.scope.context().vars.get(*f)?;
        let at_zero = |bound: &Bound| {
            rel == Rel::Eq && bound.value.is_zero() && self.scope.is_above(value, bound.strict)
        };
        let is_free = var.of.is_some()
            && !self.is_determined(*f)
            && var.upper.is_none()
            && var.lower.as_ref().is_none_or(at_zero)
            && !self.ranges.contains_key(f)
            && self.scope.has_value(value);
        is_free.then_some(*f)
    }
}
