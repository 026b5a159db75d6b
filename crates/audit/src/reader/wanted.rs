//! What a document has that is seen only where it is used: angles, derivatives of functions, and powers
//! with an index for exponent.

use std::collections::{BTreeMap, BTreeSet};

use kane_algebra::syntax::{NamedPowers, SyntaxErrorKind, canonical_name};

/// The highest derivative of a function.
const MAX_ORDER: u32 = 6;

/// Exponentials, and logarithms.
const MAX_EXPONENTS: usize = 1_000;

/// Powers with an index for exponent, and sums up to an index.
const MAX_POWERS: usize = 100;

/// The angles and the derivatives of a document, by the names of their symbols.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Wanted {
    /// into how many parts an angle is cut
    parts: BTreeMap<String, u32>,
    /// how often a function is differentiated
    orders: BTreeMap<String, u32>,
    /// products of symbols in exponents, and into how many parts they are cut
    exponents: BTreeMap<NamedPowers, u32>,
    /// of which symbols there are logarithms
    logarithms: BTreeSet<String>,
    /// angles that stand by themselves
    alone: BTreeSet<String>,
    /// variables of limits
    limited: BTreeSet<String>,
    /// variables of limits at points that are no numbers
    shifted: BTreeSet<String>,
    /// bases of powers, and their indices
    powers: BTreeSet<(String, String)>,
    /// sums up to an index, each with the first statement that has it, in the order in which they are met
    sums: Vec<(String, usize)>,
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

    /// What stands in exponentials and logarithms, and in how many parts; 0 for a logarithm.
    pub(super) fn exponentials(&self) -> Vec<(NamedPowers, u32)> {
        let exponents = self.exponents.iter().map(|(of, parts)| (of.clone(), *parts));
        let logarithms = self.logarithms.iter().map(|name| (vec![(name.clone(), 1)], 0));
        exponents.chain(logarithms).collect()
    }

    /// Whether the symbol stands by itself, or a limit is taken in it.
    pub(super) fn is_alone(&self, name: &str) -> bool {
        self.alone.contains(canonical_name(name).as_ref()) || self.is_limited(name)
    }

    /// Whether the symbol is the variable of a limit.
    pub(super) fn is_limited(&self, name: &str) -> bool {
        self.limited.contains(canonical_name(name).as_ref())
    }

    /// Whether the symbol tends to a point that is no number.
    pub(super) fn is_shifted(&self, name: &str) -> bool {
        self.shifted.contains(canonical_name(name).as_ref())
    }

    /// Takes in that a symbol is the variable of a limit, if something stands for what is made of it.
    pub(super) fn limit(&mut self, name: &str) {
        let name = canonical_name(name);
        let inside = |of: &NamedPowers| of.iter().any(|(factor, _)| *factor == name);
        let stands = self.parts.contains_key(name.as_ref())
            || self.logarithms.contains(name.as_ref())
            || self.exponents.keys().any(inside);
        if stands {
            self.limited.insert(name.into_owned());
        }
    }

    /// The bases of powers and their indices, in the order in which they are declared.
    pub(super) fn powers(&self) -> impl Iterator<Item = &(String, String)> {
        self.powers.iter()
    }

    /// The sums up to an index that stand in a statement for the first time.
    pub(super) fn sums(&self, statement: usize) -> impl Iterator<Item = &str> {
        self.sums.iter().filter(move |sum| sum.1 == statement).map(|sum| sum.0.as_str())
    }

    /// Takes in what a fault in a statement asks for.
    pub(super) fn learn(&mut self, kind: &SyntaxErrorKind, statement: usize) {
        match kind {
            SyntaxErrorKind::NoSum(name) => {
                let known = self.sums.iter().any(|sum| sum.0 == *name);
                if !known && self.sums.len() < MAX_POWERS {
                    self.sums.push((name.clone(), statement));
                }
            }
            SyntaxErrorKind::NoAngle { name, parts } => {
                let known = self.parts.entry(canonical_name(name).into_owned()).or_insert(1);
                *known = num_integer::lcm(*known, *parts);
            }
            SyntaxErrorKind::NoExponential { of, parts } => {
                let mut of = of.clone();
                of.iter_mut().for_each(|(name, _)| *name = canonical_name(name).into_owned());
                of.sort();
                if self.exponents.len() < MAX_EXPONENTS || self.exponents.contains_key(&of) {
                    let known = self.exponents.entry(of).or_insert(1);
                    *known = num_integer::lcm(*known, *parts);
                }
            }
            SyntaxErrorKind::NoShift(name) => {
                self.shifted.insert(canonical_name(name).into_owned());
            }
            SyntaxErrorKind::AngleAlone(name) => {
                self.alone.insert(canonical_name(name).into_owned());
            }
            SyntaxErrorKind::NoLogarithm(name) if self.logarithms.len() < MAX_EXPONENTS => {
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
