//! Inequalities that can hold only with equality, and so say what equations say.
//!
//! y ≤ z with z ≤ y is one example, (x − y)² ≤ 0 another, and 0 ≤ √(x − y) + √(y − x) a third, by where it is
//! defined. Where all inequalities hold strictly, and what is under roots is positive, every symbol that
//! equations leave free can move a little. So if the strict inequalities contradict each other, and
//! they as they are do not, some hold only with equality. What the search does not show is not known here.

use std::cell::OnceCell;
use std::convert::Infallible;
use std::rc::Rc;

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
const WORK: u64 = 50_000_000;

/// Finds inequalities that hold only with equality, in one document.
#[derive(Debug)]
pub(super) struct Interiors<'a> {
    context: &'a Context,
    /// the context with strict guards, once it is asked for
    strict: OnceCell<Context>,
    /// what is left for all questions
    work: Fuel,
}

impl<'a> Interiors<'a> {
    pub(super) fn new(context: &'a Context) -> Self {
        Self { context, strict: OnceCell::new(), work: Fuel::new(WORK) }
    }

    /// Sets of inequalities, by their indices, that hold only with equality under the equations, where these do not say
    /// so already. No set can do without one of its inequalities. `None` where the work does not suffice to tell.
    pub(super) fn tight(&self, relations: &[&Relation]) -> Option<Vec<Vec<usize>>> {
        let mut found = Vec::new();
        if relations.iter().any(|r| r.rel != Rel::Eq) {
            Interior::of(self, relations).search((0..relations.len()).collect(), &mut found);
        }
        (self.work.left() > 0).then_some(found)
    }
}

/// Relations and what is true where they all can move.
struct Interior<'a> {
    context: &'a Context,
    relations: &'a [&'a Relation],
    work: &'a Fuel,
    /// the context with strict guards
    strict: &'a Context,
    /// each relation made strict, and what is under its roots above 0; equations are as they were
    inside: Vec<Vec<Relation>>,
}

impl<'a> Interior<'a> {
    fn of(document: &'a Interiors<'a>, relations: &'a [&'a Relation]) -> Self {
        let Interiors { context, strict, work } = document;
        let strict = strict.get_or_init(|| {
            let definition = |d: &Definition| Definition {
                name: d.name.clone(),
                body: with_strict_guards(&d.body),
            };
            let lets: Vec<Definition> = context.lets.iter().map(definition).collect();
            Context { lets, ..(*context).clone() }
        });
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
                radicands(strict, side, &mut conditions);
            }
            conditions.push(relation);
            conditions
        };
        let inside = relations.iter().map(inside).collect();
        Self { context, relations, work, strict, inside }
    }

    /// Finds what holds only with equality among these relations.
    ///
    /// Those of claims on different cases stand beside each other here, though they need not hold together. So some may
    /// contradict each other as they are, and what holds only with equality is looked for without each of them.
    fn search(&self, left: Vec<usize>, found: &mut Vec<Vec<usize>>) {
        if self.work.left() == 0 || !self.is_empty(&left) {
            return;
        }
        let least = left.iter().fold(left.clone(), |least, i| {
            let less = without(&least, &[*i]);
            if self.is_empty(&less) { less } else { least }
        });
        if self.contradict(&least) {
            for i in &least {
                self.search(without(&left, &[*i]), found);
            }
            return;
        }
        let (equations, tight): (Vec<usize>, Vec<usize>) =
            least.into_iter().partition(|i| self.is_equation(*i));
        let rest = without(&left, &tight);
        let new: Vec<usize> =
            tight.into_iter().filter(|i| !self.is_known(*i, &equations)).collect();
        if !new.is_empty() && !found.contains(&new) {
            found.push(new);
        }
        self.search(rest, found);
    }

    fn is_equation(&self, i: usize) -> bool {
        self.relations.get(i).is_some_and(|r| r.rel == Rel::Eq)
    }

    /// Whether the inequalities among these relations, made strict, and the equations contradict each other.
    fn is_empty(&self, chosen: &[usize]) -> bool {
        let inside = chosen.iter().filter_map(|i| self.inside.get(*i)).flatten();
        contradict(self.strict, inside.cloned().collect(), self.work)
    }

    /// Whether these relations, as they are, contradict each other.
    fn contradict(&self, chosen: &[usize]) -> bool {
        contradict(self.context, self.said(chosen), self.work)
    }

    /// Whether equations alone make the sides of an inequality equal.
    fn is_known(&self, i: usize, equations: &[usize]) -> bool {
        self.relations.get(i).is_some_and(|inequality| {
            let apart = Relation { rel: Rel::Ne, ..(**inequality).clone() };
            let said = self.said(equations).into_iter().chain([apart]);
            contradict(self.context, said.collect(), self.work)
        })
    }

    fn said(&self, chosen: &[usize]) -> Vec<Relation> {
        chosen.iter().filter_map(|i| self.relations.get(*i)).map(|r| (*r).clone()).collect()
    }
}

/// The first list without what is in the second.
fn without(all: &[usize], some: &[usize]) -> Vec<usize> {
    all.iter().copied().filter(|i| !some.contains(i)).collect()
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
                let otherwise = otherwise.as_deref().map(with_strict_guards).map(Rc::new);
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
