//! Why a goal stays undecided.

use std::fmt;

use kane_algebra::syntax::NoValue;
use kane_kernel::{Approach, Atom, Point, Rejection};

use crate::{Assignment, Variable};

pub use crate::argument::Flaw;

/// Why nothing that decides a goal was found.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Open {
    /// neither proof nor witness within so many states
    Steps(u64),
    /// neither proof nor witness within so many coefficient operations
    Operations(u64),
    /// no proof within so many states
    NoProof(u64),
    /// the budget of the whole document was spent before this was decided, after so many states
    Document(u64),
    /// the normal form does not fit the budget
    Unfit(Rejection),
    /// an argument was found and could not be written out
    Unwritten(Flaw),
    /// a certificate was found and not accepted
    Rejected(Rejection),
    /// an argument was found whose check meets a bound of the kernel that is no budget
    Bound,
    /// a point was found, but not shown to be one of functions for which the premises hold for all t
    Motion,
    /// it fails for some values of exponentials, which may be none of theirs
    Exponential,
    /// it fails for some values of angles and their sines, which may be none of theirs
    Arc,
    /// the witness of an `exists` does not do
    Witness,
    /// of so many expressions none was shown to be what an `exists` says there is
    Unfound(usize),
    /// a point was found, but not for numbers in the place of the indices
    Index,
    /// with numbers, or n + 1, in the place of an index it comes to too much
    Long,
    /// a limit is of what is undefined at a place near its point
    UndefinedNear {
        /// the place
        at: String,
        /// why there is no value
        why: NoValue,
    },
    /// what a limit is claimed to be is undefined
    NoTarget {
        /// for these values of its symbols; none if it has no symbol
        at: String,
        /// why there is no value
        why: NoValue,
    },
    /// the step of an induction fails at these values, and the claim at no index that was tried
    Step(String),
}

impl fmt::Display for Open {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Steps(n) => write!(f, "neither proof nor witness within {n} steps"),
            Self::Operations(n) => {
                write!(f, "neither proof nor witness within {n} coefficient operations")
            }
            Self::Document(n) => write!(
                f,
                "the budget of the document was spent when nothing had decided this in {n} steps; \
                 with a greater effort there is more of it, and a claim judged alone has all of it"
            ),
            Self::NoProof(n) => write!(f, "no proof within {n} steps"),
            Self::Unfit(why) => write!(f, "its normal form does not fit the budget ({why})"),
            Self::Unwritten(Flaw::Kernel(Rejection::Budget)) | Self::Rejected(Rejection::Budget) => {
                f.write_str(
                    "an argument was found, and to check it takes more operations than there are; with \
                     a greater effort there are more",
                )
            }
            Self::Bound => f.write_str(
                "an argument was found, and its check meets a bound of the kernel (terms of a product, cases, \
                 halvings, powers) that no effort raises",
            ),
            Self::Unwritten(Flaw::Kernel(why)) => {
                write!(f, "an argument was found but does not hold: {why}")
            }
            Self::Unwritten(_) => f.write_str("an argument was found but a step of it does not hold"),
            Self::Rejected(why) => write!(f, "a certificate was found but not accepted: {why}"),
            Self::Witness => f.write_str(
                "what is named behind `by` does not do everywhere; that nothing else does is not shown \
                 by that",
            ),
            Self::Unfound(tried) => write!(
                f,
                "none of {tried} expressions that were tried was shown to do; another may, and can be named \
                 behind `by`"
            ),
            Self::Index => f.write_str(
                "it fails for some values of its powers and terms, but at no index that was tried; claims \
                 on them that hold for all indices may be missing from `from`",
            ),
            Self::Long => f.write_str("it comes to too much when powers and terms are written out"),
            Self::UndefinedNear { at, why } => write!(
                f,
                "near the point it is undefined ({why}), for example at {at}; a side, as in `0+`, a `when` or a \
                 narrower domain leaves that out"
            ),
            Self::NoTarget { at, why } if at.is_empty() => {
                write!(f, "what it should tend to is undefined ({why})")
            }
            Self::NoTarget { at, why } => write!(
                f,
                "what it should tend to is undefined ({why}), for example for {at}; a `when` leaves that \
                 out"
            ),
            Self::Step(at) => write!(
                f,
                "it does not follow from the claim at the index before and from what is cited (it fails \
                 for {at}), but at no index that was tried the claim itself fails; a stronger claim may \
                 be shown by induction"
            ),
            Self::Exponential => f.write_str(
                "it fails for some values of its exponentials and logarithms, but whether these have them is \
                 not known: of `exp(x)` beside `x`, `1 + x <= exp(x)` and `(1 - x)*exp(x) <= 1` are used; \
                 speaking of `exp(x/2)`, `exp(x/3)`, … makes that closer",
            ),
            Self::Arc => f.write_str(
                "it fails for some values of its angles and their sines and cosines, but whether these have \
                 them is not known: of an angle u beside these `u^2 - u^4/6 <= u*sin(u) <= u^2` and \
                 `1 - u^2/2 <= cos(u) <= 1 - u^2/2 + u^4/24` are used; speaking of `sin(u/2)`, `sin(u/3)`, … \
                 makes that closer",
            ),
            Self::Motion => f.write_str(
                "it fails for some values of the functions and their derivatives, but whether functions \
                 have them for which the premises hold for all points is not known; premises may be \
                 differentiated, as in `from d(law, t)`",
            ),
        }
    }
}

impl std::error::Error for Open {}

/// A way to a proof or to a witness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Method {
    /// the line of one variable, cut at all roots
    SignTables,
    /// squares and products of the expressions behind `using`, and the cases of their signs
    Hints,
    /// sums of multiples of the conditions
    Combinations,
    /// sums of products of conditions and simple squares
    Products,
    /// sums of squares times products of conditions
    Squares,
    /// the ideal of the equations
    Ideals,
    /// tangent planes in the place of roots and quotients
    Tangents,
    /// a cone of linear conditions, cut until coefficients have one sign on each part
    Differences,
    /// boxes on which the signs of coefficients tell
    Boxes,
    /// points: simple values, boundaries and where they meet
    Points,
    /// cells on which the conditions keep their signs, with a point in each
    Cells,
    /// cases by leading coefficients, discriminants and resultants
    Cases,
}

/// What was tried in vain for a link, and what it came to.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Attempt {
    /// what was tried
    pub tried: Vec<Method>,
    /// what the variables of the conditions left open stand for
    pub variables: Vec<Variable>,
    /// the smallest conditions for which neither a contradiction nor a point was found; none where
    /// the search ended before it came to any
    pub left: Vec<Atom>,
}

/// A given that was not shown to be able to hold near a limit.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unreached {
    /// the index of the given, if it is known
    pub given: Option<usize>,
    /// the index of the cited claim that rests on it, if it is not cited itself
    pub through: Option<usize>,
    /// the limit variable
    pub var: usize,
    /// how it moves
    pub at: Approach,
}

/// Givens above a claim that it does not cite, and the witness against it at which they are asked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Beside {
    /// whether these are all of them, and hold there; else they are those that fail
    pub all: bool,
    /// which, by their indices
    pub givens: Vec<usize>,
    /// the witness, with values for all of which they speak
    pub(crate) point: Point,
    /// of symbols in those that fail, the values there
    pub(crate) further: Vec<Assignment>,
}

/// How a witness stands to the givens above the claim: whether the claim is false, or only does not follow.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Standing {
    /// the witness goes on to a point at which every given above holds, as the kernel accepted it: the claim is
    /// false under all that was assumed
    AllMet,
    /// the claim does not follow from what is cited, and these givens above, by their indices, fail at the witness;
    /// those come first on which it rests through what it cites
    Unmet(Vec<usize>),
    /// the claim does not follow from what is cited; whether every given above can hold at the witness was not shown
    NotShown,
}
