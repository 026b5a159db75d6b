//! What expressions speak of, also by way of definitions.

use std::collections::BTreeSet;

use kane_kernel::{Context, Expr};

/// Symbols and definitions within expressions.
pub(crate) fn within<'e>(
    context: &'e Context,
    mut todo: Vec<&'e Expr>,
) -> (BTreeSet<usize>, Vec<usize>) {
    let (mut out, mut lets) = (BTreeSet::new(), Vec::new());
    while let Some(e) = todo.pop() {
        match e {
            Expr::Var(v) => {
                out.insert(*v);
            }
            Expr::Let(i) if !lets.contains(i) => {
                lets.push(*i);
                todo.extend(context.lets.get(*i).map(|d| &d.body));
            }
            _ => {}
        }
        todo.extend(e.children());
    }
    lets.sort_unstable();
    (out, lets)
}
