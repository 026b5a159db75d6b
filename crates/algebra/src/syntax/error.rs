//! What can be wrong with the text of an expression or a relation, and where.

use std::ops::Range;

use thiserror::Error;

use super::bounds::{MAX_DIGITS, MAX_EXPONENT, MAX_HEIGHT, MAX_ITEMS, MAX_NESTING};
use super::exponential_symbol::{NamedPowers, exponential_name};
use super::sequence::MAX_INDEX;
use super::template::MAX_PARAMETERS;

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
    /// such as `==`
    #[error("`{written}` means nothing here: it is written {ours}")]
    Foreign {
        /// an operator of another language
        written: &'static str,
        /// what it is here
        ours: &'static str,
    },
    /// `;` behind a statement
    #[error("a statement ends with its line, without a `;`")]
    LastSemicolon,
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
    /// a limit of an angle at a symbol
    #[error(
        "`{0}` is an angle, since it stands inside `sin`, `cos` or `tan` in this document: its limits are at numbers"
    )]
    AngleAtASymbol(String),
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
    /// `exp` of something else than a sum of symbols
    #[error("`exp` takes a sum of products of symbols with rational factors")]
    NotAnExponent,
    /// such as `exp(x/m)` where m may be 0
    #[error("`{0}`, which may be 0, divides in an exponent")]
    VanishingExponent(String),
    /// such as `exp(x*y)` of functions of two variables
    #[error("an exponent varies with two variables")]
    TwoVariables,
    /// `log` of something else than a product of symbols
    #[error("`log` takes a product of powers of plain symbols")]
    NotALogarithm,
    /// `log` of a symbol that may be 0 or negative
    #[error("`log` of `{0}`, which is not declared positive")]
    NotPositive(String),
    /// an exponential without a symbol
    #[error("`{}` has no symbol here", exponential_name(of, *parts))]
    NoExponential {
        /// the product in it
        of: NamedPowers,
        /// the parts that would do
        parts: u32,
    },
    /// a logarithm without a symbol
    #[error("`log({0})` has no symbol here")]
    NoLogarithm(String),
    /// such as `exp(x/13)` or `exp(100*x)`
    #[error(
        "exponents are twelfths at the finest, and up to 24 of their parts; those of logarithms are whole"
    )]
    TooFinePower,
    /// a function whose derivative has no symbol yet
    #[error("derivatives of functions go up to the sixth order: `{0}` has none here")]
    NoRate(String),
    /// the variable beside functions of it
    #[error("a derivative by `{0}` is not taken where `{0}` itself stands beside functions of it")]
    Explicit(String),
    /// such as `a implies b implies c`
    #[error("`{0}` beside `{0}`: parentheses have to say which is meant first")]
    Ambiguous(&'static str),
    /// a vector or a matrix where a number is due
    #[error("{0} stands where a number is due")]
    NotANumber(String),
    /// such as the sum of a number and a vector
    #[error("{what} does not go with {of}")]
    NoOperation {
        /// an operator or a function
        what: &'static str,
        /// what it was to be applied to, in words
        of: String,
    },
    /// such as `[1]` or `[[1, 2], [3]]`
    #[error("neither a vector nor the rows of a matrix")]
    NoArray,
    /// too long when written out
    #[error("vectors, matrices and definitions with arguments come to too much when written out")]
    TooMuchWritten,
    /// the wrong number of arguments
    #[error("`{name}` takes {takes} and is given {given}")]
    WrongArity {
        /// the definition
        name: String,
        /// arguments that it takes
        takes: usize,
        /// arguments that it is given
        given: usize,
    },
    /// a parameter that means something already
    #[error("`{0}` is declared already and cannot be a name for an argument")]
    Shadowed(String),
    /// a parameter that stands twice
    #[error("`{0}` is named twice")]
    NamedTwice(String),
    /// a parameter that the definition does without
    #[error("`{0}` does not occur in what follows")]
    Unused(String),
    /// too many parameters
    #[error("more than {MAX_PARAMETERS} names")]
    TooManyNames,
    /// a parameter behind `d(…)` or in a sine
    #[error(
        "`{0}` stands for an argument, and cannot stand in a derivative or in a sine, nor in `exp` and `log`, nor in a sum up to an index"
    )]
    BoundInside(String),
    /// `exists` beside a limit
    #[error("`exists` goes with relations, not with limits")]
    LimitExists,
    /// a symbol that tends to a point that is no number, and whose distance has no symbol yet
    #[error("`{0}` tends to a point that is no number, before it is known to")]
    NoShift(String),
    /// the point of a limit speaks of what tends to it
    #[error("the point of a limit must be free of `{0}`, which tends to it")]
    PointNotFree(String),
    /// a point that is not known to lie inside the range of what tends to it
    #[error("the point is not known to lie inside the range of `{0}`")]
    PointNotInside(String),
    /// something that has no value at a + δ
    #[error("`{0}` varies with what tends to a point that is no number")]
    NotShifted(String),
    /// a derivative in what is said of something that is looked for
    #[error("beside a derivative nothing is looked for")]
    SoughtBesideDerivative,
    /// `exists` without a value
    #[error("`exists` needs a value for `{0}`")]
    NoWitness(String),
    /// a power with an index for exponent that has no symbol yet
    #[error("`{base}^{index}` has no symbol here")]
    NoPower {
        /// the base as it is named
        base: String,
        /// the index
        index: String,
    },
    /// the base of a power with an index for exponent
    #[error("the base of a power with an index is a natural number, a plain `var` or a definition")]
    PowerBase,
    /// such as `q^(n - 1)` or `q^(n*m)`
    #[error("an exponent with an index is a sum of indices with natural factors, as in `n + 1`")]
    PowerExponent,
    /// such as `s(2*n)` or `s(n - 1)`
    #[error(
        "a sequence is taken at a natural number or at its index: `{name}({index})`, `{name}({index} + 1)`"
    )]
    Term {
        /// the sequence
        name: String,
        /// its index
        index: String,
    },
    /// a sum without what it runs over
    #[error("`{0}` runs over a range: `{0}(f for k in 1..n)`")]
    NoRange(&'static str),
    /// an end of a range
    #[error(
        "a range goes from a whole number to a whole number, or to an index, `1..n`, `1..n + 2`"
    )]
    Range,
    /// a sum that is too long
    #[error("more than {MAX_INDEX} terms are not written out")]
    LongSum,
    /// such as `2..n`, which is empty in more than one way
    #[error("the range begins too high: at the index 0 it ends at {end}, which is below {least}")]
    HighRange {
        /// where it ends at the index 0
        end: i64,
        /// where it may end
        least: i64,
    },
    /// an index in the term of a sum up to an index
    #[error("a term of a sum up to an index speaks of what the sum runs over, and not of `{0}`")]
    IndexInTerm(String),
    /// a term that may have no value
    #[error("a term of this sum may have no value somewhere")]
    PartialTerm,
    /// a sum up to an index that has no symbol yet
    #[error("`{0}` has no symbol here")]
    NoSum(String),
    /// a sequence without its argument
    #[error("`{0}` is a sequence, and takes its index")]
    TermAlone(String),
    /// an index is due
    #[error("`{0}` is no index")]
    NotAnIndex(String),
    /// a term that comes to too much
    #[error("this term of the sequence comes to too much when written out")]
    LongTerm,
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
            Self::ReservedWord(word) if word == "d" => {
                "`d(f, x)` is a derivative; a distance may be `d_1` or `D`"
            }
            Self::MalformedNumber(_) => "numbers look like `12` or `0.4`; a product needs its `*`",
            Self::ExponentNotInteger => {
                "only literal integers may be exponents; `sqrt(f)` is a square root, and another root is a \
                 symbol: `var r >= 0`, `given root: r^3 = f`"
            }
            Self::ImplicitProduct(found) if ["`if`", "`where`", "`for`"].contains(&&**found) => {
                "a condition stands behind `when`"
            }
            Self::ImplicitProduct(_) => {
                "a product needs its `*`, and a function is used by its name alone: `k`, not `k(x)`"
            }
            Self::Explicit(_) => {
                "declare a function that is equal to it: `var s(t)`, `given s = t, d(s, t) = 1`"
            }
            Self::NotAnAngle => {
                "a phase is an angle that moves: `var phi(t)`, `given rate: d(phi, t) = omega`, and \
                 `sin(phi)` in place of `sin(omega*t)`"
            }
            Self::NotAnExponent => {
                "as in `exp(-c*t/m)`; of all else a symbol that is equal to it: `var x`, `given x = k*t + 1`, \
                 and `exp(x)`; it is no index and no angle"
            }
            Self::NotALogarithm => {
                "a symbol that is equal to it: `var y > 0`, `given y = 1 + x^2`, and `log(y)`"
            }
            Self::VanishingExponent(_) => "declare its sign: `var m > 0`",
            Self::TwoVariables => "one factor is to be a constant",
            Self::NotPositive(_) => "declare it so: `var y > 0`",
            Self::AngleAlone(_) => {
                "`pi` stands in `sin`, `cos`, `tan` and in the bounds of angles alone"
            }
            Self::Ambiguous(_) => "write `(a implies b) implies c`, or `a implies (b implies c)`",
            Self::NotANumber(_) => {
                "the length of a vector is `norm(v)`, a component of it `v_x`; a component of \
                 something else gets a name by `let`"
            }
            Self::NoOperation { .. } => {
                "products of vectors are `dot(a, b)` and `cross(a, b)`; a matrix stands before the \
                 vector; a quotient is one by a number; vectors are compared by `=` and `!=`"
            }
            Self::NoArray => "`[a, b]` in the plane, `[a, b, c]` in space, `[[a, b], [c, d]]`",
            Self::WrongArity { .. } => "each parameter gets one argument, as in `f(x, 2*y)`",
            Self::Shadowed(_) => "give it a name that nothing else in the document has so far",
            Self::Unused(_) => "leave it out, or use it",
            Self::BoundInside(_) => "take the derivative where it is used: `d(f(x), x)`",
            Self::PointNotInside(_) => {
                "declare what tends to it without bounds, or the point by bounds that lie inside"
            }
            Self::NotShifted(_) => {
                "polynomials, quotients, roots and cases of it can tend to such a point; functions, \
                 exponentials, angles, powers with an index and derivatives to numbers and infinities alone"
            }
            Self::SoughtBesideDerivative => "name what exists, as in `by y := 2*x`",
            Self::LimitExists => "name the value with `let`, and claim the limit of it",
            Self::NoWitness(_) => "say which: `by y := …`, an expression in declared symbols",
            Self::NoPower { .. } => {
                "both have to be declared above: `var n in N`, and the base by `var` or `let`"
            }
            Self::PowerBase => {
                "give it a name, `let b := 1 + x`, and write `b^n`; it is a polynomial in plain symbols, \
                 divided by nothing that can be 0 by what is declared"
            }
            Self::PowerExponent => {
                "indices begin at 0; shift the claim so that the lowest exponent is `n`, or divide: \
                 `1/q^n`"
            }
            Self::Term { .. } => {
                "shift the claim, so that the lowest index in it is the index itself"
            }
            Self::Range => {
                "the lower end is a number, the upper one a number or an index and a natural number"
            }
            Self::HighRange { .. } => {
                "let it end higher, as in `2..n + 1`, or take the first terms off, `sum(f for k in 1..n) - f_1`"
            }
            Self::IndexInTerm(_) => {
                "what does not vary with it stands before the sum, `n*sum(k for k in 1..n)`"
            }
            Self::PartialTerm => {
                "a polynomial in plain symbols and in what the sum runs over has one, also divided by what \
                 is not 0 by what is declared"
            }
            Self::NoSum(_) => "a document has up to 100 sums up to an index",
            Self::NotAnIndex(_) => "an index is declared by `var n in N`",
            Self::TermAlone(_) => "write `s(n)`, `s(n + 1)` or `s(0)`",
            Self::LongTerm => "indices up to 64 are put in, if what comes of it is short enough",
            Self::TooTall => "name parts of it with parentheses or split the sum",
            Self::NoRelation => {
                "compare it with something: `=`, `!=`, `<`, `<=`, `>`, `>=` or `->`"
            }
            Self::NotConstant => {
                "no names, only numbers, `+ - * / ^`, and `oo` or `-oo`; a range that other symbols bound \
                 is a `given`"
            }
            _ => return None,
        })
    }
}
