//! Impact records: what mechanics says of a log of impacts, and which law it follows.
//!
//! A log has one row an impact ([`schema`], `docs/records.md`). [`study`] reads it once, row by row,
//! and returns data: how each [`Check`](check::Check) fares, with a residual and a
//! [tolerance] that is derived from the format of the numbers and the time step; which
//! [restitution](restitution::restitution), which [friction](friction::ranked) given the measured
//! normal impulse, and which [rigid laws](rigid::ranked) the rows follow; which coefficients they
//! have; and what they cannot tell. Nothing is printed here.
//!
//! ```
//! use kane_records::check::Check;
//! use kane_records::reader::Kind;
//! use kane_records::study::{Options, study};
//!
//! let log = "mass,radius,inertia,mu,e,vx_pre,vy_pre,omega_pre,vx_post,vy_post,omega_post\n\
//!            1,1,0.4,0.25,0.5,2,-1,0,1.625,0.5,-0.9375\n";
//! let study = study(log.as_bytes(), Kind::Csv, &Options::new(kane_impact::laws()))?;
//! assert_eq!((study.rows, study.rejections.total()), (1, 0));
//! assert!(study.checked(Check::Moment).is_some_and(|checked| checked.failed == 0));
//! assert!(study.consistent_laws().any(|fit| fit.law.info.id == "kane-levinson"));
//! # Ok::<(), kane_records::reader::ReadFault>(())
//! ```

mod acted;
pub mod case;
pub mod check;
pub mod comparison;
mod digits;
pub mod event;
pub mod facts;
pub mod fit;
pub mod format;
pub mod frame;
pub mod friction;
pub mod header;
mod json;
pub mod opening;
pub mod preset;
pub mod quotes;
pub mod reader;
pub mod rejection;
pub mod replay;
pub mod restitution;
pub mod rigid;
pub mod row;
pub mod sample;
pub mod scatter;
pub mod schema;
pub mod seen;
mod slip;
mod spelling;
pub mod statistics;
pub mod study;
pub mod suspicion;
pub mod sweep;
pub mod table;
pub mod tally;
pub mod told;
pub mod tolerance;
mod unit;
pub mod untold;
pub mod worst;
mod written;
