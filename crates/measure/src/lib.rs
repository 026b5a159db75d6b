//! Measures what formulas cost and where they fail.
//!
//! A formula is evaluated *as written*, operation by operation, in a number system of choice, and
//! compared with its exact value:
//!
//! ```
//! use kane_measure::{Plain, Program, formulas};
//!
//! let text = b"```kane\nvar x > 0\nlet f := 2/(1 + x) - 1\n```\n";
//! let document = kane_audit::read("two.md", text).expect("the document is well formed");
//! let found = formulas(&document);
//! let program: &Program = &found.formulas[0].program;
//! let small = f64::EPSILON / 4.0;
//! assert_eq!(program.value(&Plain::<f64>::new(), &[small]), Some(1.0)); // rightly rounded
//! assert_eq!(program.value(&Plain::<f32>::new(), &[3.0]), Some(-0.5));
//! ```
//!
//! [`examine`] looks for the inputs at which a formula fails in a binary format, and which other
//! formula of the same value does not.
#![deny(clippy::float_arithmetic)]

mod arithmetic;
mod axis;
pub mod certify;
pub mod chart;
mod dyadic;
mod error;
mod expand;
mod formula;
pub mod growth;
mod over_alpha;
pub mod prices;
mod program;
mod ranges;
mod rounding;
mod stability;

pub use arithmetic::{Arithmetic, Plain, PlainNumber};
pub use axis::{Axis, Format};
pub use dyadic::{Dyadic, DyadicNumber};
pub use error::{Fault, Sample, judge};
pub use formula::{Condition, Formula, Formulas, Input, formulas};
pub use over_alpha::{Curve, OverAlpha, over_alpha};
pub use program::{Branch, Operation, Program, Unsupported};
pub use ranges::{NoRange, Ranges};
pub use rounding::{Piece, RoundingBound, rounding_bounds};
pub use stability::{
    Better, Cell, Examined, Plane, Point, Range, Searched, Stability, Subject, equal_forms,
    examine, examine_over,
};
