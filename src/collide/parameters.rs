//! The parameters that laws have of their own.

use crate::impact::{Law, Parameter, laws};
use crate::number::Rational;

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

/// All laws with their parameters.
fn known() -> impl Iterator<Item = (&'static str, &'static Parameter)> {
    laws().iter().flat_map(|law| law.info.parameters.iter().map(|own| (law.info.id, own)))
}

/// `law.name`.
fn path((law, parameter): (&str, &Parameter)) -> String {
    format!("{law}.{}", parameter.name)
}

/// A law's id, the name of its parameter, and the value.
type Set = (&'static str, &'static str, Rational);

/// Values of parameters that are not the laws' defaults.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parameters(Vec<Set>);

impl Parameters {
    /// Sets the parameter `law.name`; the last value counts.
    ///
    /// # Errors
    /// [`UnknownParameter`] if no law has it, or the value is outside its domain.
    pub fn set(&mut self, asked: &str, value: Rational) -> Result<(), UnknownParameter> {
        let Some((law, parameter)) = known().find(|known| path(*known) == asked) else {
            let known: Vec<String> = known().map(path).collect();
            return Err(UnknownParameter::Name { name: asked.to_owned(), known: known.join(", ") });
        };
        if !parameter.admits(&value) {
            let domain = parameter.domain();
            return Err(UnknownParameter::Domain { name: asked.to_owned(), value, domain });
        }
        self.0.retain(|(of, name, _)| (*of, *name) != (law, parameter.name));
        self.0.push((law, parameter.name, value));
        Ok(())
    }

    /// Every law with these parameters, in the order of tables.
    #[must_use]
    pub fn laws(&self) -> Vec<Law> {
        let adjusted = |law: &Law| {
            let own = self.0.iter().filter(|(of, ..)| *of == law.info.id);
            own.fold(law.clone(), |law, (_, name, value)| law.with(name, value).unwrap_or(law))
        };
        laws().iter().map(adjusted).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parameter_that_is_set_reaches_its_law_and_no_other() {
        assert_eq!(known().count(), 10);
        for (id, parameter) in known() {
            let value = Rational::new(3.into(), 7.into());
            let mut parameters = Parameters::default();
            let path = path((id, parameter));
            parameters.set(&path, Rational::from_integer(1.into())).expect("in the domain");
            parameters.set(&path, value.clone()).expect("in the domain");
            for (law, default) in parameters.laws().iter().zip(laws()) {
                let mut expected = default.parameters();
                for (name, of_default) in &mut expected {
                    if (law.info.id, *name) == (id, parameter.name) {
                        of_default.clone_from(&value);
                    }
                }
                assert_eq!(law.parameters(), expected, "{path}");
            }
        }
    }
}
