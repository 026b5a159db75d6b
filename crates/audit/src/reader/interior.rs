//! Inequalities that can hold only with equality, and so say what equations say.
//!
//! y ≤ z with z ≤ y is one example, (x − y)² ≤ 0 another, and 0 ≤ √(x − y) + √(y − x) a third, by where it is
//! defined. Where all inequalities hold strictly, and what is under roots is positive, every symbol that
//! equations leave free can move a little. So if the strict inequalities contradict each other, and
//! they as they are do not, some hold only with equality. What the search does not show is not known here.

use std::convert::Infallible;

use kane_algebra::syntax::rebuild;
use kane_kernel::{
    Conclusion, Context, Definition, Expr, Fuel, Goal, Hypothesis, Link, Rel, Relation, Sentence,
};

use crate::Budget;
use crate::goal::is_proved;

/// What one question may take. Such contradictions are short, or nobody sees them.
const BUDGET: Budget = Budget {
    steps: 100,
    fuel: 1_000_000,
    check: 1_000_000,
    functions: 0,
    ideals: false,
    products: false,
    squares: 1_000_000,
    cells: 0,
    document: 2_000_000,
};
/// What all questions of a document may take together.
pub(super) const WORK: u64 = 50_000_000;

/// The sets of inequalities, by their indices, that hold only with equality under the equations, where
/// these do not say so already. No set can do without one of its inequalities, and no two have one in common.
/// `None` where the work does not suffice to tell.
pub(super) fn tight(
    context: &Context,
    relations: &[&Relation],
    work: &Fuel,
) -> Option<Vec<Vec<usize>>> {
    let is_inequality = |i: &usize| relations.get(*i).is_some_and(|r| r.rel != Rel::Eq);
    let mut left: Vec<usize> = (0..relations.len()).filter(is_inequality).collect();
    let all = Interior::of(context, relations, work);
    let mut found = Vec::new();
    if !left.is_empty() && all.is_empty(&left) && !all.contradict() {
        while all.is_empty(&left) {
            let mut least = left.clone();
            for i in &left {
                let without: Vec<usize> = least.iter().copied().filter(|j| j != i).collect();
                if all.is_empty(&without) {
                    least = without;
                }
            }
            left.retain(|i| !least.contains(i));
            if least.is_empty() {
                break;
            }
            least.retain(|i| !all.is_known(*i));
            if !least.is_empty() {
                found.push(least);
            }
        }
    }
    (work.left() > 0).then_some(found)
}

/// Relations and what is true where they all can move.
struct Interior<'a> {
    context: &'a Context,
    relations: &'a [&'a Relation],
    work: &'a Fuel,
    /// the context with strict guards
    strict: Context,
    /// each relation made strict, and what is under its roots above 0; equations are as they were
    inside: Vec<Vec<Relation>>,
}

impl<'a> Interior<'a> {
    fn of(context: &'a Context, relations: &'a [&'a Relation], work: &'a Fuel) -> Self {
        let definition =
            |d: &Definition| Definition { name: d.name.clone(), body: with_strict_guards(&d.body) };
        let lets: Vec<Definition> = context.lets.iter().map(definition).collect();
        let strict = Context { lets, ..context.clone() };
        let inside = |r: &&Relation| {
            let relation = Relation {
                lhs: with_strict_guards(&r.lhs),
                rel: strictly(r.rel),
                rhs: with_strict_guards(&r.rhs),
            };
            if r.rel == Rel::Eq {
                return vec![relation];
            }
            let mut conditions = Vec::new();
            for side in [&relation.lhs, &relation.rhs] {
                radicands(&strict, side, &mut conditions);
            }
            conditions.push(relation);
            conditions
        };
        let inside = relations.iter().map(inside).collect();
        Self { context, relations, work, strict, inside }
    }

    /// Whether the equations and these inequalities, made strict, contradict each other.
    fn is_empty(&self, inequalities: &[usize]) -> bool {
        let wanted = |(i, r): &(usize, &&Relation)| r.rel == Rel::Eq || inequalities.contains(i);
        let chosen = self.relations.iter().enumerate().filter(wanted);
        let inside = chosen.flat_map(|(i, _)| self.inside.get(i).cloned().unwrap_or_default());
        contradict(&self.strict, inside.collect(), self.work)
    }

    /// Whether the relations as they are contradict each other.
    fn contradict(&self) -> bool {
        contradict(self.context, self.relations.iter().map(|r| (*r).clone()).collect(), self.work)
    }

    /// Whether the equations alone make the sides of an inequality equal.
    fn is_known(&self, i: usize) -> bool {
        let equations = self.relations.iter().filter(|r| r.rel == Rel::Eq);
        self.relations.get(i).is_some_and(|inequality| {
            let apart = Relation { rel: Rel::Ne, ..(**inequality).clone() };
            let said = equations.map(|r| (*r).clone()).chain([apart]);
            contradict(self.context, said.collect(), self.work)
        })
    }
}

/// Whether relations are shown to have no common point.
fn contradict(context: &Context, relations: Vec<Relation>, work: &Fuel) -> bool {
    let links = relations.into_iter().map(Link::Relation).collect();
    let goal = Goal {
        context: context.clone(),
        hypotheses: vec![Hypothesis {
            sentence: Sentence { when: Vec::new(), links },
            given: true,
        }],
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    };
    is_proved(&goal, BUDGET, work)
}

fn strictly(rel: Rel) -> Rel {
    match rel {
        Rel::Le => Rel::Lt,
        Rel::Ge => Rel::Gt,
        Rel::Eq | Rel::Ne | Rel::Lt | Rel::Gt => rel,
    }
}

/// The expression without branches that are taken only where two sides are equal, and with strict guards for the
/// others: the same wherever no guard is about to change. A guard whose sides are the same is none.
fn with_strict_guards(e: &Expr) -> Expr {
    let moves = |g: &Relation| g.lhs != g.rhs;
    let mut replace = |e: &Expr| -> Result<Option<Expr>, Infallible> {
        Ok(match e {
            // its conditions hold nearby where they hold
            Expr::Deriv(..) => Some(e.clone()),
            Expr::Cases(branches, otherwise) => {
                let guard = |g: &Relation| Relation {
                    lhs: with_strict_guards(&g.lhs),
                    rel: if moves(g) { strictly(g.rel) } else { g.rel },
                    rhs: with_strict_guards(&g.rhs),
                };
                let stays =
                    |guards: &[Relation]| guards.iter().all(|g| g.rel != Rel::Eq || !moves(g));
                let kept = branches.iter().filter(|(guards, _)| stays(guards));
                let branch = |(guards, body): &(Vec<Relation>, Expr)| {
                    (guards.iter().map(guard).collect(), with_strict_guards(body))
                };
                let otherwise = otherwise.as_deref().map(with_strict_guards).map(Box::new);
                Some(Expr::Cases(kept.map(branch).collect(), otherwise))
            }
            _ => None,
        })
    };
    let Ok(rebuilt) = rebuild(e, &mut replace);
    rebuilt
}

/// That what is under the roots is positive, save in branches.
fn radicands(context: &Context, e: &Expr, into: &mut Vec<Relation>) {
    match e {
        Expr::Cases(..) | Expr::Deriv(..) => {}
        Expr::Let(i) => {
            if let Some(definition) = context.lets.get(*i) {
                radicands(context, &definition.body, into);
            }
        }
        _ => {
            if let Expr::Sqrt(a) = e {
                into.push(Relation { lhs: (**a).clone(), rel: Rel::Gt, rhs: Expr::int(0) });
            }
            for child in e.children() {
                radicands(context, child, into);
            }
        }
    }
}
