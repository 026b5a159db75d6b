//! What the variables of a goal's scope stand for.

use kane_kernel::{Goal, Scope, premised};

use super::Variable;

/// A variable of a scope: a symbol, a root, t, or what has a limit.
pub(super) fn variable(goal: &Goal, scope: &Scope<'_>, v: usize) -> Variable {
    if v < goal.context.vars.len() {
        return Variable::Symbol(v);
    }
    if let Some(root) = scope.root(v) {
        return Variable::Root(root.clone());
    }
    let Some(further) = v.checked_sub(scope.germ() + 1) else { return Variable::Germ };
    match premised(goal).nth(further) {
        Some((_, limit)) => Variable::Limiting(limit.expr.clone()),
        None => Variable::Unnamed(further),
    }
}

/// All variables that polynomials of a goal's proof may have.
pub(super) fn variables(goal: &Goal, scope: &Scope<'_>) -> Vec<Variable> {
    let count = scope.germ() + 1 + premised(goal).count();
    (0..count).map(|v| variable(goal, scope, v)).collect()
}
