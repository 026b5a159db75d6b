//! Walks over an expression and the definitions that it uses.

use std::collections::{BTreeSet, HashSet};

use kane_kernel::Expr;

use super::Scope;

/// Nodes that all visits of a scope may see together. Definitions that share others can make
/// every visit as long as the document.
const MAX_EFFORT: usize = 50_000_000;

impl Scope {
    /// Operations on the longest path from the root to a leaf, definitions expanded; a leaf has 1.
    #[must_use]
    pub fn height(&self, expr: &Expr) -> usize {
        let below = match expr {
            Expr::Let(index) => self.height_of_let(*index),
            _ => expr.children().iter().map(|child| self.height(child)).max().unwrap_or(0),
        };
        below + 1
    }

    pub(crate) fn height_of_let(&self, index: usize) -> usize {
        self.heights.get(index).copied().unwrap_or(0)
    }

    /// Calls `see` on every node of the expression and of the definitions that it uses, each
    /// definition once. Sees fewer when the scope [is exhausted](Self::is_exhausted).
    pub fn visit<'a>(&'a self, expr: &'a Expr, see: &mut impl FnMut(&'a Expr)) {
        let mut seen = HashSet::new();
        let mut pending = vec![expr];
        while let Some(node) = pending.pop() {
            if self.is_exhausted() {
                return;
            }
            self.effort.set(self.effort.get() + 1);
            see(node);
            if let Expr::Let(index) = node
                && seen.insert(*index)
                && let Some(definition) = self.context.lets.get(*index)
            {
                pending.push(&definition.body);
            }
            pending.extend(node.children());
        }
    }

    /// Whether visits have seen more nodes than they may; then what they found is not to be
    /// relied upon.
    #[must_use]
    pub fn is_exhausted(&self) -> bool {
        self.effort.get() >= MAX_EFFORT
    }

    /// Indices of the symbols in the expression, definitions expanded.
    #[must_use]
    pub fn symbols(&self, expr: &Expr) -> BTreeSet<usize> {
        let mut found = BTreeSet::new();
        self.visit(expr, &mut |node| {
            if let Expr::Var(index) | Expr::Deriv(_, index) = node {
                found.insert(*index);
            }
        });
        found
    }

    /// Whether the value may vary with the symbol `x`: through x itself or a function of it,
    /// definitions expanded.
    #[must_use]
    pub fn varies_with(&self, expr: &Expr, x: usize) -> bool {
        let mut varies = false;
        self.visit(expr, &mut |node| {
            if let Expr::Var(index) = node {
                varies |=
                    *index == x || self.context.vars.get(*index).and_then(|v| v.of) == Some(x);
            }
        });
        varies
    }
}
