//! Exponentials and logarithms: what stands for them, what is known of it, and where they may stand.
//!
//! The symbol for exp(x) tells neither how it varies with x nor which number it is. So x is a constant of
//! the document, and what is known is a `given`: 1 + x is at most exp(x), and 1 − x at most exp(−x).

use std::collections::BTreeSet;
use std::ops::Range;

use kane_algebra::syntax::Exponential;
use kane_kernel::{Expr, Link, Rel, Relation, Sentence};

use super::citation::{Draft, DraftBody};
use super::{Fault, Reader, tie};
use crate::Parts;

impl Reader {
    /// Enters what stands for the exponential and for the logarithm of a symbol, where these are
    /// spoken of.
    pub(super) fn declare_exponentials(&mut self, symbol: usize, name: &str, span: &Range<usize>) {
        for (function, parts) in self.wanted.exponentials(name) {
            let known = match self.scope.declare_exponential(symbol, parts) {
                Ok(known) => known,
                Err(error) => return self.refuse(&error, span.clone()),
            };
            self.var_sites.resize(self.scope.context().vars.len(), span.start);
            let links = bounds(known).map(Link::Relation).to_vec();
            let body = DraftBody::Given(Sentence { when: Vec::new(), links });
            let parts = Parts { label: span.clone(), content: span.clone(), ..Parts::default() };
            self.exponentials.insert((symbol, known.symbol), self.drafts.len());
            let (label, line) = (format!("({function} {name})"), self.line);
            self.enter(Draft { label, parts, body, span: span.clone(), line });
        }
    }

    /// The `given`s of the exponentials and logarithms of which these expressions speak, if they speak
    /// of what is in them, too.
    pub(super) fn bounds_of<'a>(&self, sides: impl Iterator<Item = &'a Expr>) -> BTreeSet<usize> {
        if self.exponentials.is_empty() {
            return BTreeSet::new();
        }
        let symbols: BTreeSet<usize> = sides.flat_map(|side| self.scope.symbols(side)).collect();
        let spoken = |((of, symbol), given): (&(usize, usize), &usize)| {
            (symbols.contains(of) && symbols.contains(symbol)).then_some(*given)
        };
        self.exponentials.iter().filter_map(spoken).collect()
    }

    /// The fault that a claim, or what it cites, speaks of an exponential beside functions, derivatives
    /// or limits.
    pub(super) fn exponential_beside_variation(
        &self,
        index: usize,
        spoken: &[usize],
    ) -> Option<Fault> {
        if self.exponentials.is_empty() {
            return None;
        }
        let (mut of_exponential, mut varies) = (false, false);
        for body in spoken.iter().filter_map(|i| Some(&self.drafts.get(*i)?.body)) {
            varies |= !tie::limits(body).is_empty();
            for side in tie::sides(body) {
                self.scope.visit(side, &mut |node| match node {
                    Expr::Deriv(..) => varies = true,
                    Expr::Var(v) => {
                        let var = self.scope.context().vars.get(*v);
                        varies |= var.is_some_and(|var| var.of.is_some());
                        of_exponential |= self.scope.exponential_at(*v).is_some();
                    }
                    _ => {}
                });
            }
        }
        if !(of_exponential && varies) {
            return None;
        }
        let at = self.drafts.get(index).map(|draft| draft.parts.label.clone());
        let message = "`exp` and `log` do not go with functions, derivatives and limits".to_owned();
        let note = "not in one claim, nor in what it cites; an exponential that varies is a function with its \
                    equation: `var E(t) > 0`, `given law: d(E, t) = -k*E`";
        Some(Fault::new(at.unwrap_or_default(), message).with_note(note))
    }

    /// The faults that what stands in an exponential or a logarithm varies somewhere.
    pub(super) fn varying_exponents(&self) -> Vec<Fault> {
        let bases: BTreeSet<usize> = self.exponentials.keys().map(|(of, _)| *of).collect();
        let mut faults = Vec::new();
        if bases.is_empty() {
            return faults;
        }
        let vars = &self.scope.context().vars;
        let functions = bases.iter().filter(|v| vars.iter().any(|var| var.of == Some(**v)));
        let mut varying: BTreeSet<usize> = functions.copied().collect();
        for draft in &self.drafts {
            varying.extend(tie::limits(&draft.body).into_iter().filter(|v| bases.contains(v)));
            for side in tie::sides(&draft.body) {
                self.scope.visit(side, &mut |node| {
                    if let Expr::Deriv(_, v) = node {
                        varying.extend(bases.get(v));
                        let of = self.scope.exponential_at(*v).map(|known| known.of);
                        varying.extend(of);
                    }
                });
            }
        }
        for v in varying {
            let name = vars.get(v).map_or("?", |var| &var.name);
            let site = self.var_sites.get(v).copied().unwrap_or_default();
            let message = format!(
                "`{name}` stands in `exp` or `log`, and is a constant: no limit, no derivative and no \
                 function is one by it"
            );
            let note = "an exponential that varies is a function with its equation: `var E(t) > 0`, \
                        `given law: d(E, t) = -k*E`";
            faults.push(Fault::new(site..site + name.len(), message).with_note(note));
        }
        faults
    }
}

/// 1 + x ≤ exp(x) and (1 − x)·exp(x) ≤ 1, of a part of x; log(x) ≤ x − 1 and x·log(x) ≥ x − 1.
fn bounds(known: Exponential) -> [Relation; 2] {
    let (x, e, one) = (Expr::Var(known.of), Expr::Var(known.symbol), Expr::int(1));
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
