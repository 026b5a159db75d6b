//! The proved bound that belongs to a method.

use kane_number::{Rational, Rounding, encode};
use num_traits::Zero;

use super::accuracy::{Accuracy, accuracy_up_to};
use super::method::Method;
use crate::RoundingBound;

/// A bound on the error of a method that another program has proved, beside what was measured.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Proved {
    /// the bound in ulps of the exact value; exact
    pub ulps: Rational,
    /// it holds for α from 0 to here, both included
    pub to: Rational,
    /// the worst error measured up to there, in hundredths of log₂ ulps
    pub measured: Option<i64>,
}

impl Proved {
    /// The bound of the operations that the method runs, if there is one.
    pub(super) fn of(method: &Method, all: &[RoundingBound], whole: &Accuracy) -> Option<Self> {
        let is_its = |bound: &&RoundingBound| {
            (bound.law, bound.quantity, bound.system)
                == (method.law, method.quantity, method.system)
                && bound.methods.contains(&method.name)
        };
        let bound = all.iter().find(is_its)?;
        let to = bound.pieces.last().map_or_else(Rational::zero, |piece| piece.to.clone());
        let reach: f64 = encode(&to, Rounding::Down);
        let measured =
            if whole.greatest <= reach { whole.ulps } else { accuracy_up_to(method, reach)?.ulps };
        Some(Self { ulps: bound.whole(), to, measured })
    }
}
