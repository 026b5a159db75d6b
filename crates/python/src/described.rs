//! What the laws are, as data.

use kane_impact::laws as all;
use pyo3::prelude::*;

/// A parameter: name, default, meaning, domain.
type Parameter = (String, String, String, String);

/// A law: id, statement, source, restitution, parameters.
type Described = (String, String, String, String, Vec<Parameter>);

/// The version of the program.
#[pyfunction]
pub(crate) const fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}

/// Every law: its id, its statement in the derivation language, its source, its hypothesis of restitution,
/// and its parameters.
#[pyfunction]
pub(crate) fn laws() -> Vec<Described> {
    let law = |law: &kane_impact::Law| {
        let info = law.info;
        let parameters = info.parameters.iter().map(|own| {
            let default = own.default().to_string();
            (own.name.to_owned(), default, own.meaning.to_owned(), own.domain().to_string())
        });
        (
            info.id.to_owned(),
            info.statement.to_owned(),
            info.source.to_owned(),
            info.restitution.name().to_owned(),
            parameters.collect(),
        )
    };
    all().iter().map(law).collect()
}
