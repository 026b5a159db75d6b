//! Checks the derivations and the arithmetic of collision laws.
//!
//! This crate re-exports the rooms of the house, from the ground up: [`number`], [`kernel`],
//! [`algebra`], [`impact`], [`audit`], [`measure`], [`scene`], [`records`], [`report`]. The program `kane` is a thin layer over them.
//!
//! # Derivations
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
//! # Laws
//!
//! The laws themselves are in [`impact`], written once and run in every number system. What a law
//! sees is a contact: the relative velocity, the Delassus operator, friction and restitution. Here
//! is one that couples, on which Newton's restitution creates energy by Kane and Levinson's rule,
//! and by Stronge's it does not:
//!
//! ```
//! use kane::impact::laws::{KaneLevinson, Stronge1990};
//! use kane::impact::oracle::integrate;
//! use kane::impact::{Contact, Delassus, ImpactLaw};
//! use kane::number::{Algebraic, Interval, Number, Rational, parse};
//!
//! let n = |text| parse(text).expect("a literal");
//! let delassus = Delassus::new(n("1"), n("1/2"), n("1/2"))?; // W_tt, W_tn, W_nn in 1/kg
//! let contact = Contact::new(n("-1"), n("2"), delassus, n("2"), n("1"))?; // v_t, a, W, μ, e
//!
//! let outcome = KaneLevinson.resolve(&contact)?;
//! assert_eq!(outcome.regime, "stick");
//! assert_eq!((outcome.impulse.tangential, outcome.impulse.normal), (n("-6"), n("14")));
//! assert_eq!(outcome.work.normal + outcome.work.tangential, n("3")); // J gained
//!
//! // Exact where the result is irrational, too.
//! let exact = contact.map(|x| Algebraic::from(x.clone()));
//! let stronge = Stronge1990.resolve(&exact)?;
//! assert!(stronge.work.total() < Algebraic::from(n("0")));
//!
//! // The same law in floats, and in intervals that hold the exact answer.
//! let float = KaneLevinson.impulse(&contact.map(f64::from_rational))?;
//! let enclosed = KaneLevinson.impulse(&contact.map(Interval::from_rational))?;
//! assert!((float.normal, enclosed.normal.contains(&n("14"))) == (14.0, true));
//!
//! // The process, integrated in impulse space: it shares no formula with the closed form.
//! let path = integrate(&exact, Stronge1990.restitution())?;
//! assert_eq!(path.end().impulse, stronge.impulse);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Bodies
//!
//! Contacts come from bodies, in physical units. Whatever is formed on the way is formed in a wider
//! number system and rounded once, so that nothing cancels, overflows or underflows unseen:
//!
//! ```
//! use kane::impact::bodies::{Motion, Shape, Collision};
//! use kane::impact::laws::WangSuLi;
//!
//! let before = Motion { vx: 3.1947, vy: -2.2369, omega: 0.0 }; // m/s, m/s, rad/s
//! let ball = Shape::Sphere.body(1.0, 0.0025, before); // kg, m
//! let collision = Collision { body: ball, other: None, friction: 0.092, restitution: 0.98 };
//! let collided = collision.collide(&WangSuLi)?;
//! assert_eq!(collided.after.vy, 0.98 * 2.2369);
//! assert!(collided.outcome.work.total() < 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`collide`] puts one collision to every law, in every number system, and reports what they say.
//! [`number`] has the number systems and says when to use which.
//!
//! # Features
//!
//! `cli`, on by default: the program `kane` and everything that only it needs.

pub mod figures;
pub mod testing;

pub use kane_algebra as algebra;
pub use kane_audit as audit;
pub use kane_floats as floats;
pub use kane_impact as impact;
pub use kane_judges as judges;
pub use kane_kernel as kernel;
pub use kane_latex as latex;
pub use kane_matrix as matrix;
pub use kane_measure as measure;
pub use kane_number as number;
pub use kane_records as records;
pub use kane_report as report;
pub use kane_scene as scene;
pub use kane_scene::collide;
