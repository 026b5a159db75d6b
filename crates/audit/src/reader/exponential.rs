//! Exponentials and logarithms: what stands for them, and what is known of it.
//!
//! The symbol for exp(u) does not tell which number it is. What is known is a `given`: 1 + u is at most exp(u),
//! and 1 − u at most exp(−u). Where u varies, by functions in it or with the variable of a limit, so does
//! the symbol.

use std::collections::BTreeSet;

use kane_algebra::syntax::{Exponential, Monomial, Symbol};
use kane_kernel::{Expr, Link, Rel, Relation, Sentence};

use super::Reader;
use super::citation::{Draft, DraftBody};
use super::tie;
use crate::Parts;

impl Reader {
    /// Enters what stands for the exponentials and logarithms whose symbols are declared by now.
    pub(super) fn declare_exponentials(&mut self, site: usize) {
        for (of, parts) in self.wanted.exponentials() {
            let symbol = |name: &str| match self.scope.resolve(name) {
                Some(Symbol::Var(v)) => Some(v),
                _ => None,
            };
            let powers = of.iter().map(|(name, n)| Some((symbol(name)?, *n)));
            let Some(powers) = powers.collect::<Option<Vec<_>>>() else { continue };
            let of = Monomial::of(powers);
            let is_known = match parts {
                0 => self.scope.logarithm(&of).is_some(),
                _ => self.scope.exponential(&of).is_some(),
            };
            if is_known {
                continue;
            }
            let known = match self.scope.declare_exponential(&of, parts) {
                Ok(known) => known,
                Err(error) => return self.refuse(&error, site..site),
            };
            // the words that declare the last of its symbols
            let last = of.symbols().filter_map(|v| self.var_sites.get(v).copied()).max();
            let at = last.unwrap_or(site);
            self.var_sites.resize(self.scope.context().vars.len(), at);
            let name = self.scope.context().vars.get(known.symbol).map_or("?", |var| &var.name);
            let label = format!("({})", name.trim_end_matches(')').replacen('(', " ", 1));
            let links = bounds(&known).map(Link::Relation).to_vec();
            let body = DraftBody::Given(Sentence { when: Vec::new(), links });
            let parts = Parts { label: at..at, content: at..at, ..Parts::default() };
            self.exponentials.insert(known.symbol, self.drafts.len());
            let line = self.line;
            self.enter(Draft { label, parts, body, span: at..at, line });
        }
    }

    /// Notes the variables of the limits in what was read.
    pub(super) fn meet_limits(&mut self) {
        let variables: BTreeSet<usize> =
            self.drafts.iter().flat_map(|draft| tie::limits(&draft.body)).collect();
        for v in variables {
            if let Some(var) = self.scope.context().vars.get(v) {
                self.met.limit(&var.name);
            }
        }
    }

    /// The `given`s of the exponentials and logarithms among these symbols, if what is in them is among
    /// these, too.
    pub(super) fn bounds_of(&self, symbols: &BTreeSet<usize>) -> BTreeSet<usize> {
        let spoken = self.scope.exponentials().filter(|known| {
            symbols.contains(&known.symbol) && known.of.symbols().any(|v| symbols.contains(&v))
        });
        spoken.filter_map(|known| self.exponentials.get(&known.symbol).copied()).collect()
    }
}

/// 1 + u ≤ exp(u) and (1 − u)·exp(u) ≤ 1, of a part of u; log(x) ≤ x − 1 and x·log(x) ≥ x − 1.
fn bounds(known: &Exponential) -> [Relation; 2] {
    let (x, e, one) = (known.of.expr(), Expr::Var(known.symbol), Expr::int(1));
    let minus_one = || Expr::Sub(x.clone().into(), Expr::int(1).into());
    match known.parts {
        0 => [
            Relation { lhs: e.clone(), rel: Rel::Le, rhs: minus_one() },
            Relation { lhs: Expr::Mul(x.clone().into(), e.into()), rel: Rel::Ge, rhs: minus_one() },
        ],
        n => {
            let parts = Expr::int(n.into());
            let part = if n == 1 { x } else { Expr::Div(x.into(), parts.into()) };
            let more = Expr::Add(one.clone().into(), part.clone().into());
            let less = Expr::Sub(one.clone().into(), part.into());
            [
                Relation { lhs: e.clone(), rel: Rel::Ge, rhs: more },
                Relation { lhs: Expr::Mul(e.into(), less.into()), rel: Rel::Le, rhs: one },
            ]
        }
    }
}
