//! What can be wrong with the text of an expression or a relation, and where.

use std::ops::Range;

use thiserror::Error;

use super::bounds::{MAX_DIGITS, MAX_EXPONENT, MAX_HEIGHT, MAX_ITEMS, MAX_NESTING};

/// A fault in the text and the bytes that it concerns.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{kind}")]
pub struct SyntaxError {
    /// what is wrong
    pub kind: SyntaxErrorKind,
    /// the bytes concerned, counted as the parser's text was offset
    pub span: Range<usize>,
}

/// The kinds of fault.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum SyntaxErrorKind {
    /// a character that belongs to no token
    #[error("unexpected character `{0}`")]
    StrayCharacter(char),
    /// something else was due here
    #[error("expected {expected}, found {found}")]
    Expected {
        /// what was due
        expected: String,
        /// what stands there
        found: String,
    },
    /// a parenthesis or brace that is never closed
    #[error("unbalanced: `{0}` is never closed")]
    Unclosed(char),
    /// a parenthesis or brace that was never opened
    #[error("unbalanced: `{0}` closes nothing")]
    Unopened(char),
    /// such as `1.2.3`, `.5` or `2a`
    #[error("malformed number `{0}`")]
    MalformedNumber(String),
    /// a literal with too many digits
    #[error("number with more than {MAX_DIGITS} digits")]
    LiteralTooLong,
    /// a name that nothing declares
    #[error("unknown symbol `{0}`")]
    UnknownSymbol(String),
    /// a reserved word where a name was due
    #[error("`{0}` is a reserved word and cannot be a name")]
    ReservedWord(String),
    /// `a/0`, or `0^-1`
    #[error("division by literal zero")]
    DivisionByLiteralZero,
    /// an exponent that is no literal integer
    #[error("the exponent is not an integer")]
    ExponentNotInteger,
    /// an exponent out of range
    #[error("the exponent exceeds {MAX_EXPONENT} in magnitude")]
    ExponentTooLarge,
    /// too many parentheses within each other
    #[error("nested more than {MAX_NESTING} levels deep")]
    TooNested,
    /// too many operators on top of each other
    #[error("the expression is more than {MAX_HEIGHT} operations deep, definitions included")]
    TooTall,
    /// a list that is too long
    #[error("a list of more than {MAX_ITEMS} items")]
    TooManyItems,
    /// two operands without an operator between them
    #[error("an operator is missing before {0}")]
    ImplicitProduct(String),
    /// nothing before the comparison
    #[error("relation without a left side")]
    NoLeftSide,
    /// nothing after the comparison
    #[error("relation without a right side")]
    NoRightSide,
    /// an expression where a relation was due
    #[error("an expression alone is not a relation")]
    NoRelation,
    /// a limit inside a chain, or where only relations may stand
    #[error("a limit cannot stand here")]
    MisplacedLimit,
    /// `f -> L` without `as x -> a`
    #[error("a limit needs `as x -> a`")]
    LimitWithoutAs,
    /// `as x -> a` without a limit before it
    #[error("`as` without a limit before it")]
    AsWithoutLimit,
    /// the limit variable is a definition or a function
    #[error("`{0}` is not a plain `var` and cannot be the limit variable")]
    NotALimitVariable(String),
    /// a limit point or bound that is not a number
    #[error("this must be a rational constant")]
    NotConstant,
    /// the limit point cannot be approached inside the domain
    #[error("the domain of `{0}` does not reach this point from there")]
    NoLimitPoint(String),
    /// the limit value varies with the limit variable
    #[error("the limit must be free of `{0}`")]
    LimitNotFree(String),
    /// differentiation with respect to something other than a symbol
    #[error("`{0}` is no symbol: nothing can be differentiated by it")]
    NotADerivativeVariable(String),
    /// `sin` of something else than a sum of angles
    #[error("`sin`, `cos` and `tan` take a sum of angles and multiples of `pi`")]
    NotAnAngle,
    /// an angle that is not known as one, or not in parts as fine
    #[error("`{name}` is no angle of {parts} parts")]
    NoAngle {
        /// the symbol
        name: String,
        /// the parts that would do
        parts: u32,
    },
    /// an angle outside of `sin`, `cos` and `tan`
    #[error("`{0}` is an angle, and no number")]
    AngleAlone(String),
    /// such as `cos(pi/7)`
    #[error("multiples of `pi/12` have values that can be written out, and others have none here")]
    NoSurd,
    /// such as `sin(theta/13)`
    #[error("the parts of an angle are twelfths at the finest")]
    TooFine,
    /// such as `sin(100*theta)`
    #[error("multiples of an angle are written out up to 24 of its parts")]
    TooOften,
    /// a function whose derivative has no symbol yet
    #[error("derivatives of functions go up to the sixth order: `{0}` has none here")]
    NoRate(String),
    /// the variable beside functions of it
    #[error("a derivative by `{0}` is not taken where `{0}` itself stands beside functions of it")]
    Explicit(String),
    /// `cases { }`
    #[error("`cases` without a branch")]
    NoBranch,
    /// a branch after `else`
    #[error("`else` must be the last branch")]
    ElseNotLast,
}

impl SyntaxErrorKind {
    /// A hint at the remedy, where there is one to give.
    #[must_use]
    pub fn hint(&self) -> Option<&'static str> {
        Some(match self {
            Self::MalformedNumber(_) => "numbers look like `12` or `0.4`; a product needs its `*`",
            Self::ExponentNotInteger => {
                "only literal integers may be exponents; `sqrt(f)` is a square root"
            }
            Self::ImplicitProduct(_) => {
                "a product needs its `*`, and a function is used by its name alone: `k`, not `k(x)`"
            }
            Self::Explicit(_) => {
                "declare a function that is equal to it: `var s(t)`, `given s = t, d(s, t) = 1`"
            }
            Self::AngleAlone(_) => {
                "it stands in `sin`, `cos`, `tan` and behind `d(f, …)` alone; its value is not known, only \
                 its direction"
            }
            Self::TooTall => "name parts of it with parentheses or split the sum",
            Self::NoRelation => {
                "compare it with something: `=`, `!=`, `<`, `<=`, `>`, `>=` or `->`"
            }
            Self::NotConstant => "no names, only numbers, `+ - * / ^`, and `oo` or `-oo`",
            _ => return None,
        })
    }
}
