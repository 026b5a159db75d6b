//! What a document has that is seen only where it is used: angles, derivatives of functions, and powers
//! with an index for exponent.

use std::collections::{BTreeMap, BTreeSet};

use kane_algebra::syntax::{SyntaxErrorKind, canonical_name};

/// The highest derivative of a function.
const MAX_ORDER: u32 = 6;

/// Powers with an index for exponent.
const MAX_POWERS: usize = 100;

/// The angles and the derivatives of a document, by the names of their symbols.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Wanted {
    /// into how many parts an angle is cut
    parts: BTreeMap<String, u32>,
    /// how often a function is differentiated
    orders: BTreeMap<String, u32>,
    /// into how many parts an exponent is cut
    exponents: BTreeMap<String, u32>,
    /// of which symbols there are logarithms
    logarithms: BTreeSet<String>,
    /// bases of powers, and their indices
    powers: BTreeSet<(String, String)>,
}

impl Wanted {
    /// Of how many parts the symbol is an angle, if it is one.
    pub(super) fn parts(&self, name: &str) -> Option<u32> {
        self.parts.get(canonical_name(name).as_ref()).copied()
    }

    /// How often the symbol is differentiated.
    pub(super) fn order(&self, name: &str) -> u32 {
        self.orders.get(canonical_name(name).as_ref()).copied().unwrap_or(0)
    }

    /// Which of `exp` and `log` is taken of the symbol, and of how many parts; 0 for a logarithm.
    pub(super) fn exponentials(&self, name: &str) -> Vec<(&'static str, u32)> {
        let name = canonical_name(name);
        let parts = self.exponents.get(name.as_ref()).map(|parts| ("exp", *parts));
        let logarithm = self.logarithms.contains(name.as_ref()).then_some(("log", 0));
        parts.into_iter().chain(logarithm).collect()
    }

    /// The bases of powers and their indices, in the order in which they are declared.
    pub(super) fn powers(&self) -> impl Iterator<Item = &(String, String)> {
        self.powers.iter()
    }

    /// Takes in what a fault asks for.
    pub(super) fn learn(&mut self, kind: &SyntaxErrorKind) {
        match kind {
            SyntaxErrorKind::NoAngle { name, parts } => {
                let known = self.parts.entry(canonical_name(name).into_owned()).or_insert(1);
                *known = num_integer::lcm(*known, *parts);
            }
            SyntaxErrorKind::NoExponential { name, parts } => {
                let known = self.exponents.entry(canonical_name(name).into_owned()).or_insert(1);
                *known = num_integer::lcm(*known, *parts);
            }
            SyntaxErrorKind::NoLogarithm(name) => {
                self.logarithms.insert(canonical_name(name).into_owned());
            }
            SyntaxErrorKind::NoPower { base, index } => {
                let name = |name: &String| canonical_name(name).into_owned();
                if self.powers.len() < MAX_POWERS {
                    self.powers.insert((name(base), name(index)));
                }
            }
            // d(d(x, t), t) asks for the third derivative of x
            SyntaxErrorKind::NoRate(name) => {
                let base = name.trim_start_matches("d(");
                let taken = u32::try_from((name.len() - base.len()) / 2).unwrap_or(MAX_ORDER);
                let base = base.split(',').next().unwrap_or_default();
                if taken < MAX_ORDER {
                    let known = self.orders.entry(canonical_name(base).into_owned()).or_insert(0);
                    *known = (*known).max(taken + 1);
                }
            }
            _ => {}
        }
    }
}
