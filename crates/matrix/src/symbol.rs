//! The symbols of the matrix: one list of what its sentences and templates may name.

use kane_algebra::syntax::Scope;
use kane_kernel::Var;

use crate::property::SYMBOLS;
use crate::setting::{FAMILIES, Setting};
use crate::stop::Stop;

/// All symbols in which people are told of the matrix, as one scope: those of templates, of families of
/// contacts, and the letters of properties that speak of more than one contact.
#[must_use]
pub fn symbols() -> Scope {
    let families = FAMILIES.into_iter().chain(Setting::seen()).map(Setting::context);
    let stops = Stop::ALL.into_iter().map(|stop| Setting::Stopped(stop).context());
    let own = families.chain(stops).flat_map(|context| context.vars).map(|var| var.name);
    // the notation keeps `d` for derivatives; `d_` is set as that letter
    let further = ["W", "b", "c", "d_", "l", "p", "q", "s", "u", "q_t", "q_n"];
    let told = SYMBOLS.into_iter().chain(further).map(str::to_owned);
    let mut scope = Scope::default();
    for name in told.chain(own) {
        let var = Var { name, of: None, lower: None, upper: None };
        // most names are those of several families
        let _ = scope.declare(var);
    }
    scope
}
