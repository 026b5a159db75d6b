//! The parameters that laws have of their own.

use crate::impact::ImpactLaw;
use crate::impact::laws::{
    Brach, ChatterjeeRuina, KuninakaHayakawa, LawVisitor, LougeAdams, Saitoh, SmithPrinted, Walton,
    visit_laws,
};
use crate::number::Rational;

/// A parameter of a law, and its domain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LawParameter {
    /// The law's id.
    pub law: &'static str,
    /// The name in the law's statement.
    pub name: &'static str,
    /// The least value.
    pub least: i8,
    /// The greatest value, or `None` without bound.
    pub greatest: Option<i8>,
    /// What it is, in a few words.
    pub meaning: &'static str,
}

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

impl LawParameter {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self {
            law: "brach",
            name: "share",
            least: 0,
            greatest: None,
            meaning: "mu_B/mu, the ratio of the impulses by mu",
        },
        Self {
            law: "smith-printed",
            name: "eta",
            least: 0,
            greatest: None,
            meaning: "the share of the friction",
        },
        Self {
            law: "walton",
            name: "beta0",
            least: 0,
            greatest: Some(1),
            meaning: "the tangential restitution at sticking",
        },
        Self {
            law: "chatterjee-ruina",
            name: "e_t",
            least: -1,
            greatest: Some(1),
            meaning: "the tangential restitution",
        },
        Self {
            law: "louge-adams",
            name: "tilt",
            least: 0,
            greatest: Some(1),
            meaning: "the tangent of half the angle by which the normal leans",
        },
        Self {
            law: "louge-adams",
            name: "beta0",
            least: 0,
            greatest: Some(1),
            meaning: "the tangential restitution at sticking",
        },
        Self {
            law: "kuninaka-hayakawa",
            name: "tilt",
            least: 0,
            greatest: Some(1),
            meaning: "the tangent of half the angle by which the normal leans",
        },
        Self {
            law: "kuninaka-hayakawa",
            name: "beta0",
            least: 0,
            greatest: Some(1),
            meaning: "the tangential restitution at sticking",
        },
        Self {
            law: "saitoh",
            name: "turn",
            least: 0,
            greatest: Some(1),
            meaning: "the tangent of half the angle by which the normal turns",
        },
        Self {
            law: "saitoh",
            name: "beta0",
            least: 0,
            greatest: Some(1),
            meaning: "the tangential restitution at sticking",
        },
    ];

    /// `law.name`.
    #[must_use]
    pub fn path(&self) -> String {
        format!("{}.{}", self.law, self.name)
    }

    fn domain(&self) -> String {
        match self.greatest {
            Some(greatest) => format!("at least {} and at most {greatest}", self.least),
            None => format!("at least {}", self.least),
        }
    }
}

/// Values of parameters that are not the laws' defaults.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Parameters(Vec<(LawParameter, Rational)>);

impl Parameters {
    /// Sets the parameter `law.name`; the last value counts.
    ///
    /// # Errors
    /// [`UnknownParameter`] if no law has it, or the value is outside its domain.
    pub fn set(&mut self, path: &str, value: Rational) -> Result<(), UnknownParameter> {
        let Some(parameter) = LawParameter::ALL.into_iter().find(|known| known.path() == path)
        else {
            let known: Vec<String> = LawParameter::ALL.iter().map(LawParameter::path).collect();
            return Err(UnknownParameter::Name { name: path.to_owned(), known: known.join(", ") });
        };
        let bound = |n: i8| Rational::from_integer(n.into());
        let above = value >= bound(parameter.least);
        let below = parameter.greatest.is_none_or(|greatest| value <= bound(greatest));
        if !(above && below) {
            let domain = parameter.domain();
            return Err(UnknownParameter::Domain { name: path.to_owned(), value, domain });
        }
        self.0.retain(|(known, _)| *known != parameter);
        self.0.push((parameter, value));
        Ok(())
    }

    /// Shows a visitor every law with these parameters, in the order of tables.
    pub fn visit(&self, visitor: &mut impl LawVisitor) {
        visit_laws(&mut Adjusted { parameters: self, visitor });
    }

    /// Puts the value of a law's parameter where it belongs, if it is set.
    fn put(&self, law: &str, name: &str, value: &mut Rational) {
        if let Some((_, set)) =
            self.0.iter().find(|(known, _)| known.law == law && known.name == name)
        {
            value.clone_from(set);
        }
    }
}

/// Exchanges the laws that have other parameters.
struct Adjusted<'a, V> {
    parameters: &'a Parameters,
    visitor: &'a mut V,
}

impl<V: LawVisitor> LawVisitor for Adjusted<'_, V> {
    fn visit<L: ImpactLaw>(&mut self, law: &L) {
        macro_rules! adjusted {
            ($($id:literal: $law:ident { $($name:literal: $field:ident),* })*) => {
                match law.id() {
                    $($id => {
                        let mut law = $law::default();
                        $(self.parameters.put($id, $name, &mut law.$field);)*
                        self.visitor.visit(&law);
                    })*
                    _ => self.visitor.visit(law),
                }
            };
        }
        adjusted! {
            "brach": Brach { "share": share }
            "smith-printed": SmithPrinted { "eta": share }
            "walton": Walton { "beta0": restitution }
            "chatterjee-ruina": ChatterjeeRuina { "e_t": restitution }
            "louge-adams": LougeAdams { "tilt": tilt, "beta0": restitution }
            "kuninaka-hayakawa": KuninakaHayakawa { "tilt": tilt, "beta0": restitution }
            "saitoh": Saitoh { "turn": turn, "beta0": restitution }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Default)]
    struct Seen(Vec<(&'static str, Vec<(&'static str, Rational)>)>);

    impl LawVisitor for Seen {
        fn visit<L: ImpactLaw>(&mut self, law: &L) {
            self.0.push((law.id(), law.parameters()));
        }
    }

    #[test]
    fn every_parameter_of_a_law_can_be_set_and_no_other() {
        let mut seen = Seen::default();
        visit_laws(&mut seen);
        let mut paths: Vec<String> = Vec::new();
        for (law, parameters) in seen.0 {
            paths.extend(parameters.iter().map(|(name, _)| format!("{law}.{name}")));
        }
        paths.sort();
        let mut known: Vec<String> = LawParameter::ALL.iter().map(LawParameter::path).collect();
        known.sort();
        assert_eq!(paths, known);
    }

    #[test]
    fn a_parameter_that_is_set_reaches_its_law() {
        for parameter in LawParameter::ALL {
            let mut parameters = Parameters::default();
            parameters
                .set(&parameter.path(), Rational::new(3.into(), 7.into()))
                .expect("in the domain");
            let mut seen = Seen::default();
            parameters.visit(&mut seen);
            let law = seen.0.into_iter().find(|(law, _)| *law == parameter.law);
            let value = Rational::new(3.into(), 7.into());
            let mut of_its_own = law.expect("it is visited").1;
            of_its_own.retain(|(name, _)| *name == parameter.name);
            assert_eq!(of_its_own, [(parameter.name, value)]);
        }
    }
}
