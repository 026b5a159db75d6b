//! The notation of derivations: parser, printers, and evaluation at a point.
//!
//! Grammar of expressions, loosest first (`^` is right-associative, the others left-associative):
//!
//! ```text
//! sum     := ["-"] product { ("+" | "-") product }       -a*b is −(a·b), -a^2 is −(a²)
//! product := operand { ("*" | "/") operand }             4/3*a is (4/3)·a
//! operand := "-" operand | power                         a/-b*c is (a/(−b))·c
//! power   := atom [ "^" exponent ]
//! exponent:= a literal integer: 2, -2, (2), (-2), or a tower of them, 2^3; or a sum of multiples of
//!            indices, n, (n + 1), (2*n)
//! atom    := number | name | "(" sum ")" | abs(a) | sqrt(a) | min(a, b) | max(a, b) | d(f, x)
//!          | "|" sum "|" | sin(angle) | cos(angle) | tan(angle)
//!          | exp(sum) | log(product)
//!          | pow(a, exponent) | sum(sum for name in sum..sum) | prod(…)
//!          | "[" sum { "," sum } "]" | dot(a, b) | cross(a, b) | norm(a)
//!          | det(a) | transpose(a) | inverse(a) | name "(" sum { "," sum } ")"
//!          | "cases" "{" guard { "," guard } ":" sum { ";" … } [ ";" "else" ":" sum ] [";"] "}"
//! ```
//!
//! There is no implicit product. A `#` starts a comment, which ends with its line (at LF, CR or
//! CRLF), and white space never matters. A name is
//! a Latin or Greek letter followed by letters, digits, `_` and primes; a Greek letter equals its
//! spelled-out name, a subscript digit the digit.

mod angle;
mod arrays;
mod bounds;
mod chain;
mod coq;
mod diagnostic;
mod error;
mod eval;
mod exponent;
mod exponential;
mod exponential_symbol;
mod foreign;
mod formula;
mod hidden;
mod jet;
mod latex;
mod letters;
mod lexer;
mod links;
mod logic;
mod mathml;
mod monomial;
mod names;
mod neighbourhood;
mod no_value;
mod notation;
mod number;
mod parser;
mod plain;
mod rate;
mod rebuild;
mod scope;
mod sequence;
mod shift;
mod suggest;
mod sum_call;
mod summation;
mod surface;
mod template;
mod value;
mod words;

pub use angle::{Direction, Turn};
pub use bounds::{MAX_DIGITS, MAX_EXPONENT, MAX_HEIGHT, MAX_ITEMS, MAX_NESTING};
pub use coq::{coq, coq_relation};
pub use diagnostic::{Diagnostic, Lines, Place};
pub use error::{SyntaxError, SyntaxErrorKind};
pub use eval::{Evaluator, compares, eval, holds};
pub use exponential_symbol::{Exponential, NamedPowers};
pub use hidden::{is_control, is_hidden, printable, visible};
pub use latex::latex_with;
pub use letters::greek_letter;
pub use lexer::Token;
pub use links::Endpoint;
pub use logic::Logic;
pub use mathml::{mathml, mathml_name};
pub use monomial::Monomial;
pub use names::{RESERVED, canonical_name, latex_name};
pub use no_value::NoValue;
pub use notation::Notation;
pub use number::literal;
pub use parser::{Parser, parse_expr, parse_relations, parse_sentence};
pub use plain::{comparison, moving};
pub use rate::rate;
pub use rebuild::rebuild;
pub use scope::{Angle, DeclareError, Scope, Symbol};
pub use sequence::{MAX_INDEX, Sequences};
pub use suggest::{nearest, nearest_with_unit};
pub use summation::Summation;
pub use surface::surface;
pub use template::{MAX_PARAMETERS, placeholder, put_in};
pub use value::{Array, Shape, Value};
