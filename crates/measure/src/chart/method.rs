//! A method: one formula or law in one number system.

use std::hint::black_box;

use kane_number::{DoubleDouble, Interval, Lane, Rational, System, decode};

use crate::PlainNumber;

/// What a method returns, exactly.
#[derive(Clone, Debug, PartialEq)]
pub enum Answer {
    /// a number
    Number(Rational),
    /// a number between two
    Between(Rational, Rational),
}

/// A number system in which a form can run, whatever its operations.
pub trait FormNumber: Lane + PlainNumber {
    /// The number equal to a finite float; `f32` is only given floats of its own.
    fn of(float: f64) -> Self {
        Self::from_rational(&decode(float).unwrap_or_else(|_| Rational::from_integer(0.into())))
    }

    /// A small integer, exact in every system.
    fn small(integer: u8) -> Self;

    /// What it is exactly; `None` if it is not finite.
    fn answer(&self) -> Option<Answer> {
        self.exact().map(Answer::Number)
    }
}

impl FormNumber for f32 {
    fn small(integer: u8) -> Self {
        Self::from(integer)
    }
}

impl FormNumber for f64 {
    fn small(integer: u8) -> Self {
        Self::from(integer)
    }
}

impl FormNumber for DoubleDouble {
    fn small(integer: u8) -> Self {
        Self::from(f64::from(integer))
    }
}

impl FormNumber for Interval {
    fn small(integer: u8) -> Self {
        Self::from(f64::from(integer))
    }

    fn answer(&self) -> Option<Answer> {
        self.ends().ok().map(|(lower, upper)| Answer::Between(lower, upper))
    }
}

impl FormNumber for Rational {
    fn small(integer: u8) -> Self {
        Self::from_integer(integer.into())
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
pub(super) fn repeatedly<N: FormNumber>(
    alphas: &[f64],
    form: fn(&N) -> Option<N>,
) -> Box<dyn Fn()> {
    let inputs: Vec<N> = alphas.iter().map(|alpha| N::of(*alpha)).collect();
    Box::new(move || {
        for input in &inputs {
            black_box(form(black_box(input)));
        }
    })
}
