//! Citing the derivative of a premise: what holds for all t may be differentiated.
//!
//! `from d(law, t)` cites the derivative of an equation that the author assumes. It holds for all t, because
//! t itself does not occur in it, and its sides are quotients of polynomials, which are differentiable
//! where they are defined.

use kane_algebra::syntax::{Symbol, SyntaxErrorKind, rate};
use kane_kernel::{Expr, Link, Rel, Relation, Sentence};

use super::citation::{Cited, Draft, DraftBody};
use super::{Fault, Reader, label};
use crate::Parts;

impl Reader {
    /// Enters the derivative that is cited, unless it is there already. What is wrong with the label
    /// itself is told where citations are resolved.
    pub(super) fn differentiate(&mut self, cited: &Cited) {
        let Some((inner, variable)) = &cited.derivative else { return };
        self.differentiate(inner);
        if self.labels.contains_key(&label::key(&cited.label)) {
            return;
        }
        let Some(&base) = self.labels.get(&label::key(&inner.label)) else { return };
        match self.derivative_of(base, variable) {
            Ok(links) => {
                let body = DraftBody::Given(Sentence { when: Vec::new(), links });
                let span = cited.span.clone();
                let parts =
                    Parts { label: span.clone(), content: span.clone(), ..Parts::default() };
                self.derived.insert(self.drafts.len(), base);
                let line = self.line;
                self.enter(Draft { label: cited.label.clone(), parts, body, span, line });
            }
            Err((message, kind)) => {
                let mut fault = Fault::new(cited.span.clone(), message);
                if let Some(kind) = kind {
                    self.met.learn(&kind, self.count);
                    fault.note = kind.hint().map(str::to_owned);
                }
                self.faults.push(fault);
                // so that the citation itself is no further fault
                let parts = Parts::default();
                let (span, line) = (cited.span.clone(), self.line);
                let body = DraftBody::Broken;
                self.enter(Draft { label: cited.label.clone(), parts, body, span, line });
            }
        }
    }

    fn derivative_of(
        &self,
        base: usize,
        variable: &str,
    ) -> Result<Vec<Link>, (String, Option<SyntaxErrorKind>)> {
        let refuse = |message: String| Err((message, None));
        let Some(draft) = self.drafts.get(base) else { return Ok(Vec::new()) };
        let name = &draft.label;
        let t = match self.scope.resolve(variable) {
            Some(Symbol::Var(t))
                if self.scope.context().vars.get(t).is_some_and(|v| v.of.is_none()) =>
            {
                t
            }
            _ => return refuse(format!("`{variable}` is not a plain `var`")),
        };
        let DraftBody::Given(sentence) = &draft.body else {
            return match draft.body {
                DraftBody::Broken => Ok(Vec::new()),
                _ => refuse(format!("`{name}` is no `given`, and only those are differentiated")),
            };
        };
        if !sentence.when.is_empty() {
            return refuse(format!(
                "`{name}` has conditions, and may not hold for all `{variable}`"
            ));
        }
        let mut links = Vec::new();
        for link in &sentence.links {
            let Link::Relation(Relation { lhs, rel: Rel::Eq, rhs }) = link else {
                return refuse(format!(
                    "`{name}` is no equation, and only those are differentiated"
                ));
            };
            let mut slopes = Vec::new();
            for side in [lhs, rhs] {
                // exp(k*t) and the sine of an angle t speak of t
                if self.scope.inside(self.scope.symbols(side)).contains(&t) {
                    return refuse(format!(
                        "`{name}` speaks of `{variable}` itself, and may not hold for all `{variable}`"
                    ));
                }
                if !self.is_rational(side) {
                    return refuse(format!(
                        "`{name}` has a root or cases, which may have no derivative"
                    ));
                }
                let slope = rate(side, t, &self.scope);
                let slope = slope.map_err(|kind| (kind.to_string(), Some(kind)))?;
                self.scope.note_derivative(&slope, side, t);
                slopes.push(slope);
            }
            let [lhs, rhs] = <[Expr; 2]>::try_from(slopes).unwrap_or([Expr::int(0), Expr::int(0)]);
            links.push(Link::Relation(Relation { lhs, rel: Rel::Eq, rhs }));
        }
        Ok(links)
    }

    /// Whether an expression is a quotient of polynomials, definitions written out.
    fn is_rational(&self, e: &Expr) -> bool {
        let mut rational = true;
        self.scope.visit(e, &mut |node| {
            rational &= !matches!(
                node,
                Expr::Sqrt(_) | Expr::Abs(_) | Expr::Min(..) | Expr::Max(..) | Expr::Cases(..)
            );
        });
        rational
    }
}
