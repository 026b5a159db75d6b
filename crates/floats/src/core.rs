//! A formula with its arguments and their ranges.

use kane_kernel::Bound;
use kane_number::Rational;

use crate::{Program, Test};

/// The binary format in which a program runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Precision {
    /// binary32
    F32,
    /// binary64
    F64,
}

impl Precision {
    /// Both, the narrower one first.
    pub const ALL: [Self; 2] = [Self::F32, Self::F64];

    /// `f32` or `f64`.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
        }
    }

    /// Its name in FPCore.
    #[must_use]
    pub const fn fpcore(self) -> &'static str {
        match self {
            Self::F32 => "binary32",
            Self::F64 => "binary64",
        }
    }

    /// Bits of the significand.
    #[must_use]
    pub const fn bits(self) -> u32 {
        match self {
            Self::F32 => 24,
            Self::F64 => 53,
        }
    }
}

/// An argument: a float of the format, between two bounds.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Argument {
    /// as written
    pub name: String,
    /// lower end, the least finite float if absent
    pub lower: Option<Bound>,
    /// upper end, the greatest finite float if absent
    pub upper: Option<Bound>,
}

impl Argument {
    /// Without bounds.
    #[must_use]
    pub fn new(name: impl Into<String>) -> Self {
        Self { name: name.into(), lower: None, upper: None }
    }

    /// Takes a further lower bound; the tighter one stays.
    pub fn at_least(&mut self, value: &Rational, strict: bool) {
        let tighter = self.lower.as_ref().is_none_or(|known| {
            known.value < *value || (known.value == *value && strict && !known.strict)
        });
        if tighter {
            self.lower = Some(Bound { value: value.clone(), strict });
        }
    }

    /// Takes a further upper bound; the tighter one stays.
    pub fn at_most(&mut self, value: &Rational, strict: bool) {
        let tighter = self.upper.as_ref().is_none_or(|known| {
            known.value > *value || (known.value == *value && strict && !known.strict)
        });
        if tighter {
            self.upper = Some(Bound { value: value.clone(), strict });
        }
    }
}

/// A formula: its arguments, what is assumed of them, its operations, and which is the value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Core {
    /// its name, if it has one
    pub name: Option<String>,
    /// its arguments, in order
    pub arguments: Vec<Argument>,
    /// what is assumed beyond the ranges
    pub assumed: Vec<Test>,
    /// the format that it asks for, if it does
    pub precision: Option<Precision>,
    /// the operations, those of what is assumed among them
    pub program: Program,
    /// the operation that is the value
    pub root: usize,
    /// further properties, by key, as written
    pub properties: Vec<(String, String)>,
}
