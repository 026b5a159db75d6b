//! Checks the derivations and the arithmetic of collision laws.
//!
//! This crate re-exports the rooms of the house, from the ground up: [`number`], [`kernel`],
//! [`algebra`], [`impact`], [`audit`], [`report`]. The program `kane` is a thin layer over them.
//!
//! # A guided tour
//!
//! A derivation is a Markdown document; blocks tagged `kane` hold its statements. Premises are
//! `given`, what follows from them is a `claim`. Reading judges nothing. Judging looks, for every
//! claim, for a proof or for a point that speaks against it, and believes neither until the kernel
//! has checked it:
//!
//! ````
//! use kane::audit::{Options, Verdict, audit, read};
//! use kane::report::{Page, Report, explain, text};
//!
//! let wall = "\
//! ## A ball meets a wall
//!
//! ```kane
//! var m > 0, u > 0, v, 0 <= e <= 1
//! given rebound: v = -e*u
//! let loss := 1/2*m*u^2 - 1/2*m*v^2
//! claim energy: loss = 1/2*m*(1 - e^2)*u^2   from rebound
//! claim sign: loss >= 0                      from energy
//! claim strict: loss > 0                     from energy
//! ```
//! ";
//! let document = read("wall.md", wall.as_bytes()).expect("the document is well formed");
//! let audit = audit(document, &Options::default(), &mut |_done, _all| {});
//!
//! let verdicts: Vec<_> = audit.judgements.iter().map(|judgement| judgement.verdict).collect();
//! use Verdict::{Assumed, Defined, Proved, Refuted};
//! assert_eq!(verdicts, [Assumed, Defined, Proved, Proved, Refuted]);
//!
//! // What comes back is data. The reports show it: all of it, or one proof or witness in full.
//! let report = Report::new(&audit, "kane audit wall.md");
//! let shown = text(&report, Page::default());
//! assert!(shown.starts_with("A ball meets a wall (wall.md)\n3 claims: 2 proved, 1 refuted\n"));
//!
//! // The witness can be checked by hand: at e = 1 nothing is lost.
//! let witness = explain(&audit, 4).expect("there are five statements");
//! assert!(witness.contains("e = 1"), "{witness}");
//! ````
//!
//! [`collide`] puts one collision to every law, in every number system, and reports what they say.
//!
//! The laws themselves are in [`impact`], written once for every number system; its page has an
//! example that runs. [`number`] is where floats and exact numbers meet.
//!
//! # Features
//!
//! `cli`, on by default: the program `kane` and everything that only it needs.

pub mod collide;

pub use kane_algebra as algebra;
pub use kane_audit as audit;
pub use kane_impact as impact;
pub use kane_kernel as kernel;
pub use kane_number as number;
pub use kane_report as report;
