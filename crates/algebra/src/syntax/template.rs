//! Definitions with arguments, `let f(x) := …`: what is written for `f(a)`.
//!
//! While the definition is read, a placeholder stands for each parameter. Nothing in a document is
//! bound by a name but parameters, and these are no symbols, so an argument cannot come to mean
//! something else by being put in.

use std::collections::BTreeSet;
use std::convert::Infallible;

use kane_kernel::{Expr, Rel, Relation};

use super::rebuild::rebuild;
use super::value::{Value, size};

/// Parameters of one definition, and names that one `exists` binds.
pub const MAX_PARAMETERS: usize = 32;

/// The first placeholder: no context has as many symbols.
const FIRST: usize = usize::MAX - 1_000;

/// What stands for a parameter while a definition is read.
#[must_use]
pub fn placeholder(parameter: usize) -> Expr {
    Expr::Var(FIRST + parameter)
}

/// The parameter for which a symbol stands, if it is a placeholder.
#[must_use]
pub(crate) fn parameter(symbol: usize) -> Option<usize> {
    symbol.checked_sub(FIRST).filter(|parameter| *parameter < MAX_PARAMETERS)
}

/// The parameters that are read wherever an expression is: not those in branches of `cases` alone,
/// nor in guards behind the first.
fn always_read(e: &Expr, found: &mut BTreeSet<usize>) {
    match e {
        Expr::Cases(branches, otherwise) => {
            let first = branches.first().and_then(|(guards, _)| guards.first());
            let sides = first.into_iter().flat_map(|guard| [&guard.lhs, &guard.rhs]);
            let alone = otherwise.as_deref().filter(|_| branches.is_empty());
            sides.chain(alone).for_each(|side| always_read(side, found));
        }
        Expr::Var(v) => found.extend(parameter(*v)),
        _ => e.children().into_iter().for_each(|child| always_read(child, found)),
    }
}

/// The expression with arguments for its placeholders. What has no argument stays.
#[must_use]
pub(crate) fn substituted(e: &Expr, arguments: &[Expr]) -> Expr {
    let mut replace = |part: &Expr| match part {
        Expr::Var(v) => Ok(parameter(*v).and_then(|p| arguments.get(p)).cloned()),
        _ => Ok::<_, Infallible>(None),
    };
    match rebuild(e, &mut replace) {
        Ok(done) => done,
        Err(never) => match never {},
    }
}

/// The expression with arguments for its [placeholders](placeholder).
#[must_use]
pub fn put_in(e: &Expr, arguments: &[Expr]) -> Expr {
    substituted(e, arguments)
}

/// How many parts [`substituted`] writes.
pub(crate) fn written(e: &Expr, arguments: &[Expr]) -> usize {
    let sizes: Vec<usize> = arguments.iter().map(size).collect();
    fn count(e: &Expr, sizes: &[usize]) -> usize {
        match e {
            Expr::Var(v) => parameter(*v).and_then(|p| sizes.get(p)).copied().unwrap_or(1),
            _ => e.children().into_iter().fold(1, |n, child| n.saturating_add(count(child, sizes))),
        }
    }
    count(e, &sizes)
}

/// A definition with arguments.
#[derive(Clone, Debug)]
pub(crate) struct Template {
    /// how many arguments it takes
    pub(crate) takes: usize,
    /// its body, with placeholders
    pub(crate) body: Value,
    /// height of the body, with placeholders as leaves
    pub(crate) height: usize,
    /// parameters that are not read wherever the body is
    unread: Vec<usize>,
}

impl Template {
    pub(crate) fn new(takes: usize, body: Value, height: usize) -> Self {
        let mut read = BTreeSet::new();
        body.parts().iter().for_each(|part| always_read(part, &mut read));
        let unread = (0..takes).filter(|parameter| !read.contains(parameter)).collect();
        Self { takes, body, height, unread }
    }

    /// Parts that an application writes.
    pub(crate) fn written(&self, arguments: &[Expr]) -> usize {
        let guards = self.unread.iter().filter_map(|p| arguments.get(*p)).map(size).sum::<usize>();
        let parts = self.body.parts();
        let bodies = parts.iter().map(|part| written(part, arguments));
        bodies.fold(0_usize, usize::saturating_add).saturating_add(2 * guards * parts.len())
    }

    /// The body with arguments. Where an argument that the body may leave unread is undefined, so is
    /// the result: a guard `a = a` reads it.
    pub(crate) fn applied(&self, arguments: &[Expr]) -> Value {
        let unread = self.unread.iter().filter_map(|parameter| arguments.get(*parameter));
        let same = |a: &Expr| Relation { lhs: a.clone(), rel: Rel::Eq, rhs: a.clone() };
        let guards: Vec<Relation> =
            unread.filter(|a| !matches!(a, Expr::Num(_) | Expr::Var(_))).map(same).collect();
        self.body.map(|part| {
            let body = substituted(part, arguments);
            match guards.is_empty() {
                true => body,
                false => Expr::Cases(vec![(guards.clone(), body)], None),
            }
        })
    }
}
