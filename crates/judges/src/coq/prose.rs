//! Goals as the propositions that people read.

use kane_algebra::syntax::{coq, coq_relation, rebuild};
use kane_kernel::{Expr, Hypothesis, Relation, Sentence};
use num_traits::Zero;

use super::NotEmitted;
use super::reify::Symbols;
use super::slopes::Slope;

/// Propositions as people read them.
pub(super) struct Prose<'a> {
    /// how symbols are written
    pub(super) name: &'a dyn Fn(usize) -> String,
    /// for the derivatives
    pub(super) symbols: &'a Symbols<'a>,
}

impl Prose<'_> {
    pub(super) fn term(&self, e: &Expr) -> Result<String, NotEmitted> {
        Ok(coq(&self.slopes(e)?, self.name))
    }

    /// Derivatives and square roots by their names.
    fn slopes(&self, e: &Expr) -> Result<Expr, NotEmitted> {
        rebuild(e, &mut |part| match part {
            Expr::Deriv(f, x) => Ok(Some(Expr::Var(self.symbols.slope(f, *x)?))),
            Expr::Sqrt(_) => {
                let root = self.symbols.roots.iter().find(|(_, r)| r == part);
                Ok(root.map(|(v, _)| Expr::Var(*v)))
            }
            _ => Ok(None),
        })
    }

    /// One comparison of expanded sides.
    pub(super) fn relation(&self, r: &Relation) -> Result<String, NotEmitted> {
        let r = Relation { lhs: self.slopes(&r.lhs)?, rel: r.rel, rhs: self.slopes(&r.rhs)? };
        Ok(coq_relation(&r, self.name))
    }

    /// The conditions under which an expanded expression is defined.
    pub(super) fn conditions(&self, e: &Expr) -> Result<Vec<String>, NotEmitted> {
        let mut out = Vec::new();
        match e {
            Expr::Div(a, b) => {
                out.extend(self.conditions(a)?);
                out.extend(self.conditions(b)?);
                // A number other than 0 divides.
                if !matches!(&**b, Expr::Num(q) if !q.is_zero()) {
                    out.push(format!("{} <> 0", self.term(b)?));
                }
            }
            Expr::Pow(a, n) if *n < 0 => {
                out.extend(self.conditions(a)?);
                let below = Expr::Pow(a.clone(), n.saturating_neg());
                out.push(format!("{} <> 0", self.term(&below)?));
            }
            Expr::Sqrt(a) => {
                out.extend(self.conditions(a)?);
                out.push(format!("0 <= {}", self.term(a)?));
            }
            Expr::Cases(branches, otherwise) => {
                let mut rest = match otherwise {
                    Some(e) => self.conditions(e)?,
                    None => vec!["False".to_owned()],
                };
                for (guards, body) in branches.iter().rev() {
                    let mut then = self.conditions(body)?;
                    for g in guards.iter().rev() {
                        let mut all = self.conditions(&g.lhs)?;
                        all.extend(self.conditions(&g.rhs)?);
                        let guard = self.relation(g)?;
                        if !then.is_empty() {
                            all.push(format!("{guard} -> {}", conj(&then)));
                        }
                        if !rest.is_empty() {
                            all.push(format!("~ ({guard}) -> {}", conj(&rest)));
                        }
                        then = all;
                    }
                    rest = then;
                }
                out = rest;
            }
            Expr::Deriv(f, x) => {
                let slope = Slope::of(f, *x)?;
                out = self.near_conditions(&slope.f, slope.x)?;
            }
            other => {
                for part in other.children() {
                    out.extend(self.conditions(part)?);
                }
            }
        }
        Ok(out)
    }

    /// The conditions of both sides.
    pub(super) fn defined(&self, r: &Relation) -> Result<Vec<String>, NotEmitted> {
        let mut out = self.conditions(&r.lhs)?;
        out.extend(self.conditions(&r.rhs)?);
        Ok(out)
    }

    /// All relations with the conditions of their sides, in order.
    pub(super) fn flat(&self, rs: &[Relation]) -> Result<Vec<String>, NotEmitted> {
        let mut out = Vec::new();
        for r in rs {
            out.extend(self.defined(r)?);
            out.push(self.relation(r)?);
        }
        Ok(out)
    }

    fn spoken(&self, rs: &[Relation]) -> Result<String, NotEmitted> {
        let Some((r, rest)) = rs.split_first() else {
            return Ok("True".to_owned());
        };
        let mut says = self.relation(r)?;
        if !rest.is_empty() {
            says = format!("{says} /\\ {}", grouped(&self.spoken(rest)?));
        }
        Ok(arrow(&self.defined(r)?, &says))
    }

    /// What a premise says; `None` if it says nothing at a point.
    pub(super) fn hypothesis(&self, h: &Hypothesis) -> Result<Option<String>, NotEmitted> {
        if h.sentence.relations().next().is_none() {
            return Ok(None);
        }
        self.sentence(&h.sentence, h.given).map(Some)
    }

    /// What a sentence says at a point.
    pub(super) fn sentence(&self, s: &Sentence, given: bool) -> Result<String, NotEmitted> {
        let when = self.flat(&self.symbols.expanded(&s.when)?)?;
        let links = self.symbols.expanded(s.relations())?;
        let body = if given { conj(&self.flat(&links)?) } else { self.spoken(&links)? };
        Ok(arrow(&when, &body))
    }
}

/// A conjunction; `True` if it is empty.
pub(super) fn conj(parts: &[String]) -> String {
    match parts {
        [] => "True".to_owned(),
        [one] => one.clone(),
        many => many.iter().map(|p| grouped(p)).collect::<Vec<_>>().join(" /\\ "),
    }
}

/// Premises before a proposition.
pub(super) fn arrow(premises: &[String], says: &str) -> String {
    match premises {
        [] => says.to_owned(),
        some => format!("{} -> {says}", grouped(&conj(some))),
    }
}

/// In parentheses if it is an implication, a conjunction or a choice.
pub(super) fn grouped(p: &str) -> String {
    let open = p.contains("->") || p.contains("/\\") || p.contains("if ") || p.contains("exists ");
    if open { format!("({p})") } else { p.to_owned() }
}
