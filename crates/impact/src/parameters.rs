//! Parameters of laws, found by their names.

use kane_number::Rational;

use crate::Law;

/// A parameter that no law has, or a value outside its domain.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum UnknownParameter {
    /// No law has it.
    #[error("no law has the parameter `{name}`; there are {known}")]
    Name {
        /// as it was asked for
        name: String,
        /// all that there are
        known: String,
    },
    /// The value is outside.
    #[error("{name} is {value}, but must be {domain}")]
    Domain {
        /// law and name
        name: String,
        /// the value
        value: Rational,
        /// what it must be
        domain: String,
    },
}

/// Sets the parameter `law.name`, as in `walton.beta0`, of one of these laws.
///
/// # Errors
/// [`UnknownParameter`] if no law has it, or the value is outside its domain.
pub fn set_parameter(
    laws: &mut [Law],
    asked: &str,
    value: &Rational,
) -> Result<(), UnknownParameter> {
    for law in laws.iter_mut() {
        for parameter in law.info.parameters {
            if format!("{}.{}", law.info.id, parameter.name) != asked {
                continue;
            }
            let adjusted = law.with(parameter.name, value).filter(|_| parameter.admits(value));
            let Some(adjusted) = adjusted else {
                let (value, domain) = (value.clone(), parameter.domain());
                return Err(UnknownParameter::Domain { name: asked.to_owned(), value, domain });
            };
            *law = adjusted;
            return Ok(());
        }
    }
    let names = laws.iter().flat_map(|law| {
        law.info.parameters.iter().map(|own| format!("{}.{}", law.info.id, own.name))
    });
    let known = names.collect::<Vec<_>>().join(", ");
    Err(UnknownParameter::Name { name: asked.to_owned(), known })
}
