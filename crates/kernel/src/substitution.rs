//! Replacing symbols by expressions, everywhere in a goal.

use crate::{
    Conclusion, Context, Definition, Expr, Goal, Hypothesis, Limit, Link, Relation, Sentence,
    Target,
};

/// The goal with each listed symbol replaced by its expression, definitions included.
#[must_use]
pub fn substituted(goal: &Goal, values: &[(usize, Expr)]) -> Goal {
    let s = Substitution(values);
    let define = |d: &Definition| Definition { name: d.name.clone(), body: s.expr(&d.body) };
    Goal {
        context: Context {
            vars: goal.context.vars.clone(),
            lets: goal.context.lets.iter().map(define).collect(),
        },
        hypotheses: goal
            .hypotheses
            .iter()
            .map(|h| Hypothesis { sentence: s.sentence(&h.sentence), given: h.given })
            .collect(),
        when: s.relations(&goal.when),
        conclusion: match &goal.conclusion {
            Conclusion::Link(l) => Conclusion::Link(s.link(l)),
            Conclusion::Contradiction => Conclusion::Contradiction,
            Conclusion::NotImplied(m) => Conclusion::NotImplied(s.sentence(m)),
        },
    }
}

struct Substitution<'a>(&'a [(usize, Expr)]);

impl Substitution<'_> {
    fn expr(&self, e: &Expr) -> Expr {
        let go = |a: &Expr| Box::new(self.expr(a));
        match e {
            Expr::Var(v) => match self.0.iter().find(|x| x.0 == *v) {
                Some((_, value)) => value.clone(),
                None => e.clone(),
            },
            Expr::Num(_) | Expr::Let(_) => e.clone(),
            Expr::Neg(a) => Expr::Neg(go(a)),
            Expr::Add(a, b) => Expr::Add(go(a), go(b)),
            Expr::Sub(a, b) => Expr::Sub(go(a), go(b)),
            Expr::Mul(a, b) => Expr::Mul(go(a), go(b)),
            Expr::Div(a, b) => Expr::Div(go(a), go(b)),
            Expr::Pow(a, n) => Expr::Pow(go(a), *n),
            Expr::Abs(a) => Expr::Abs(go(a)),
            Expr::Min(a, b) => Expr::Min(go(a), go(b)),
            Expr::Max(a, b) => Expr::Max(go(a), go(b)),
            Expr::Sqrt(a) => Expr::Sqrt(go(a)),
            Expr::Deriv(a, x) => Expr::Deriv(go(a), *x),
            Expr::Cases(branches, otherwise) => Expr::Cases(
                branches
                    .iter()
                    .map(|(guards, body)| (self.relations(guards), self.expr(body)))
                    .collect(),
                otherwise.as_deref().map(go),
            ),
        }
    }

    fn relations(&self, all: &[Relation]) -> Vec<Relation> {
        let one =
            |r: &Relation| Relation { lhs: self.expr(&r.lhs), rel: r.rel, rhs: self.expr(&r.rhs) };
        all.iter().map(one).collect()
    }

    fn link(&self, l: &Link) -> Link {
        match l {
            Link::Relation(r) => {
                Link::Relation(self.relations(std::slice::from_ref(r)).swap_remove(0))
            }
            Link::Limit(l) => Link::Limit(Limit {
                expr: self.expr(&l.expr),
                to: match &l.to {
                    Target::Finite(value) => Target::Finite(self.expr(value)),
                    infinite => infinite.clone(),
                },
                ..l.clone()
            }),
        }
    }

    fn sentence(&self, s: &Sentence) -> Sentence {
        Sentence {
            when: self.relations(&s.when),
            links: s.links.iter().map(|l| self.link(l)).collect(),
        }
    }
}
