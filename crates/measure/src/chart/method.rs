//! A method: one formula or law in one number system.

use std::fmt;
use std::hint::black_box;

use kane_number::{DoubleDouble, Interval, Rational, Real, Rounding, decode, encode};

use crate::PlainNumber;

/// A number system in which methods run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum System {
    /// binary32
    F32,
    /// binary64
    F64,
    /// pairs of binary64
    DoubleDouble,
    /// enclosures with ends in binary64
    Interval,
    /// exact fractions
    Rational,
}

impl System {
    /// All of them, in the order of tables.
    pub const ALL: [Self; 5] =
        [Self::F32, Self::F64, Self::DoubleDouble, Self::Interval, Self::Rational];
}

impl fmt::Display for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::DoubleDouble => "double-double",
            Self::Interval => "interval",
            Self::Rational => "rational",
        })
    }
}

/// What a method returns, exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// a number
    Number(Rational),
    /// a number between two
    Between(Rational, Rational),
}

/// A number system in which a form can run, whatever its operations.
pub trait Lane: Real + PlainNumber {
    /// Which one it is.
    const SYSTEM: System;

    /// The number equal to a float; `f32` is only given floats of its own.
    fn of(float: f64) -> Self;

    /// A small integer, exact in every system.
    fn small(integer: u8) -> Self;

    /// What it is exactly; `None` if it is not finite.
    fn answer(&self) -> Option<Answer>;
}

impl Lane for f32 {
    const SYSTEM: System = System::F32;

    fn of(float: f64) -> Self {
        decode(float).map_or(Self::NAN, |exact| encode(&exact, Rounding::NearestEven))
    }

    fn small(integer: u8) -> Self {
        Self::from(integer)
    }

    fn answer(&self) -> Option<Answer> {
        decode(*self).ok().map(Answer::Number)
    }
}

impl Lane for f64 {
    const SYSTEM: System = System::F64;

    fn of(float: f64) -> Self {
        float
    }

    fn small(integer: u8) -> Self {
        Self::from(integer)
    }

    fn answer(&self) -> Option<Answer> {
        decode(*self).ok().map(Answer::Number)
    }
}

impl Lane for DoubleDouble {
    const SYSTEM: System = System::DoubleDouble;

    fn of(float: f64) -> Self {
        Self::from(float)
    }

    fn small(integer: u8) -> Self {
        Self::from(f64::from(integer))
    }

    fn answer(&self) -> Option<Answer> {
        self.to_rational().ok().map(Answer::Number)
    }
}

impl Lane for Interval {
    const SYSTEM: System = System::Interval;

    fn of(float: f64) -> Self {
        Self::from(float)
    }

    fn small(integer: u8) -> Self {
        Self::from(f64::from(integer))
    }

    fn answer(&self) -> Option<Answer> {
        self.ends().ok().map(|(lower, upper)| Answer::Between(lower, upper))
    }
}

impl Lane for Rational {
    const SYSTEM: System = System::Rational;

    fn of(float: f64) -> Self {
        decode(float).unwrap_or_else(|_| Self::from_integer(0.into()))
    }

    fn small(integer: u8) -> Self {
        Self::from_integer(integer.into())
    }

    fn answer(&self) -> Option<Answer> {
        Some(Answer::Number(self.clone()))
    }
}

/// A form in one number system, with its type erased.
#[derive(Clone, Debug)]
pub struct Method {
    /// the law's id
    pub law: &'static str,
    /// what is computed: `k`, `i_x` or `Delta_e`
    pub quantity: &'static str,
    /// where the form stands: an equation of the paper, `law` for the program's own code
    pub name: &'static str,
    /// the form in the derivation language; what the program's code is equal to
    pub text: &'static str,
    /// k, where the form uses it
    pub k: &'static str,
    /// whether this is the law's own code, not the form literally
    pub is_law: bool,
    /// the least α of the domain, as a power of two
    pub least: i32,
    /// where it runs
    pub system: System,
    answer: fn(f64) -> Option<Answer>,
    prepare: fn(&[f64]) -> Box<dyn Fn()>,
}

/// What a line of the registry says.
#[derive(Clone, Copy, Debug)]
pub(super) struct Form {
    pub(super) law: &'static str,
    pub(super) quantity: &'static str,
    pub(super) name: &'static str,
    pub(super) text: &'static str,
    pub(super) k: &'static str,
    pub(super) is_law: bool,
    pub(super) least: i32,
}

impl Method {
    pub(super) fn new(
        form: Form,
        system: System,
        answer: fn(f64) -> Option<Answer>,
        prepare: fn(&[f64]) -> Box<dyn Fn()>,
    ) -> Self {
        let Form { law, quantity, name, text, k, is_law, least } = form;
        Self { law, quantity, name, text, k, is_law, least, system, answer, prepare }
    }

    /// What it returns at α; `None` if that is no finite number.
    #[must_use]
    pub fn answer(&self, alpha: f64) -> Option<Answer> {
        (self.answer)(alpha)
    }

    /// An evaluation at each α, ready to be timed: inputs are converted beforehand, and the compiler
    /// is kept from seeing inputs and results, so that nothing is moved out of the loop.
    #[must_use]
    pub fn prepare(&self, alphas: &[f64]) -> Box<dyn Fn()> {
        (self.prepare)(alphas)
    }
}

/// The loop that is timed.
pub(super) fn repeatedly<N: Lane>(alphas: &[f64], form: fn(&N) -> Option<N>) -> Box<dyn Fn()> {
    let inputs: Vec<N> = alphas.iter().map(|alpha| N::of(*alpha)).collect();
    Box::new(move || {
        for input in &inputs {
            black_box(form(black_box(input)));
        }
    })
}
