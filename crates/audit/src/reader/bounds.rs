//! Bounds that are expressions: `var L > 0, 0 < x < L`.
//!
//! A number bounds a symbol by itself. What depends on other symbols is a `given` that the declaration
//! brings along, `(bounds x)`, and whoever speaks of x rests on it. So it has the meaning of a `given`: it
//! says that the bounds are defined, and along a limit it has a range.

use std::collections::{BTreeMap, BTreeSet};

use kane_kernel::{Expr, Link, Rel, Relation, Sentence};

use super::citation::{Cited, Draft, DraftBody};
use super::symbol::{End, Item};
use super::{Fault, Reader, tie};
use crate::Parts;

/// What bounds may be.
const BOUNDS: &str = "a bound is a number, or an expression in plain symbols that are declared above; what else \
                      holds is a `given`";

impl Reader {
    /// Enters the bounds of a symbol that are expressions.
    pub(super) fn declare_bounds(&mut self, symbol: usize, item: &Item) {
        let ends = [(&item.ends[0], true), (&item.ends[1], false)];
        let mut links = Vec::new();
        for (end, is_lower) in
            ends.into_iter().filter_map(|(end, side)| Some((end.as_ref()?, side)))
        {
            if let Some(fault) = self.unfit(&item.name, end) {
                self.faults.push(fault);
                return;
            }
            let rel = if end.strict { Rel::Lt } else { Rel::Le };
            let (own, value) = (Expr::Var(symbol), end.value.clone());
            let (lhs, rhs) = if is_lower { (value, own) } else { (own, value) };
            links.push(Link::Relation(Relation { lhs, rel, rhs }));
        }
        if links.is_empty() {
            return;
        }
        self.ranges.insert(symbol, self.drafts.len());
        let parts =
            Parts { label: item.span.clone(), content: item.whole.clone(), ..Parts::default() };
        let body = DraftBody::Given(Sentence { when: Vec::new(), links });
        let (label, line) = (format!("(bounds {})", item.name), self.line);
        self.enter(Draft { label, parts, body, span: item.whole.clone(), line });
    }

    /// The fault that a bound speaks of something that is no constant.
    fn unfit(&self, name: &str, end: &End) -> Option<Fault> {
        let fault = |what: String| {
            let message = format!("the bound of `{name}` speaks of {what}");
            Some(Fault::new(end.span.clone(), message).with_note(BOUNDS))
        };
        let mut slope = false;
        self.scope.visit(&end.value, &mut |node| slope |= matches!(node, Expr::Deriv(..)));
        if slope {
            return fault("a derivative".to_owned());
        }
        let vars = &self.scope.context().vars;
        let found = self.scope.symbols(&end.value).into_iter();
        let (of, kind) = found.filter_map(|v| Some((v, self.scope.kind_of(v)?))).next()?;
        fault(format!("`{}`: {kind}", vars.get(of).map_or("pi", |var| &var.name)))
    }

    /// The `given`s of the bounds of all symbols of which statements speak, of what these bounds speak of,
    /// and so on, as if the statement `at` cited them.
    pub(super) fn ranges_of(
        &self,
        statements: impl Iterator<Item = usize>,
        at: usize,
    ) -> Vec<(usize, Cited)> {
        if self.ranges.is_empty() {
            return Vec::new();
        }
        let sides =
            |i: usize| self.drafts.get(i).map(|draft| tie::sides(&draft.body)).unwrap_or_default();
        let symbols = |sides: Vec<&Expr>| -> BTreeSet<usize> {
            sides.into_iter().flat_map(|side| self.scope.symbols(side)).collect()
        };
        let said: Vec<usize> = statements.collect();
        let variables = said.iter().filter_map(|i| Some(tie::limits(&self.drafts.get(*i)?.body)));
        let mut todo: Vec<usize> = variables.flatten().collect();
        todo.extend(symbols(said.iter().flat_map(|i| sides(*i)).collect()));
        let (mut seen, mut found) = (BTreeSet::new(), BTreeMap::new());
        let span = self.drafts.get(at).map(|draft| draft.parts.label.clone()).unwrap_or_default();
        while let Some(v) = todo.pop() {
            if !seen.insert(v) {
                continue;
            }
            // exp(x), and the powers of x, speak of x
            todo.extend(
                self.scope.exponential_at(v).into_iter().flat_map(|known| known.of.symbols()),
            );
            todo.extend(symbols(self.scope.sequences().made_of(v)));
            let Some(given) = self.ranges.get(&v).filter(|given| **given < at) else { continue };
            todo.extend(symbols(sides(*given)));
            let label =
                self.drafts.get(*given).map_or_else(String::new, |draft| draft.label.clone());
            found.insert(*given, Cited { label, span: span.clone(), derivative: None });
        }
        found.into_iter().collect()
    }
}
