//! Logs of impacts beyond what a program reads row by row: the checks of [`kane_records`] as functions
//! over columns of Arrow, in an embedded query engine or on a cluster of them.
//!
//! [`register`] gives the functions to any session of DataFusion. Without arguments a function takes
//! the columns of the table that it stands over, by their usual names; otherwise a struct of columns
//! that are named as in [`kane_records::schema`], and the [format](Numbers) of their numbers.
//!
//! ```
//! use datafusion::prelude::SessionContext;
//!
//! # #[tokio::main(flavor = "current_thread")]
//! # async fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let session = SessionContext::new();
//! kane_lake::register(&session)?;
//! session
//!     .sql(
//!         "CREATE TABLE impacts AS SELECT * FROM (VALUES ('ice', 1.0, 0.4, 0.0, -1.0, 2.0, -1.0, 0.0, \
//!          1.625, 0.5, -0.9375)) AS t(material, mass, inertia, arm_x, arm_y, vx_pre, vy_pre, omega_pre, \
//!          vx_post, vy_post, omega_post)",
//!     )
//!     .await?
//!     .collect()
//!     .await?;
//! let query = "SELECT material, max(kane_energy_gain()) AS gain FROM impacts GROUP BY material";
//! let answer = session.sql(query).await?.collect().await?;
//! assert_eq!(answer[0].num_rows(), 1);
//! # Ok(())
//! # }
//! ```
//!
//! The arithmetic is that of `kane_records`, called row by row on slices of the columns. Rows of a
//! query have no order, so that [`Check::Order`](kane_records::check::Check::Order) is not asked, and no
//! lines, so that rows are shown by their numbers.

mod aggregate;
mod bytes;
mod check;
mod choice;
#[cfg(feature = "cluster")]
pub mod cluster;
mod columns;
mod fault;
mod handed;
mod log;
mod numbers;
mod quantity;
mod register;
mod rewrite;
mod scalar;
mod summary;
mod written;

pub use aggregate::{Whole, aggregate_functions};
pub use check::{Opened, TABLE, check, open};
pub use fault::LakeFault;
pub use log::{files, table};
pub use numbers::{NoNumbers, Numbers};
pub use quantity::{Asked, Quantity};
pub use register::{register, register_for};
pub use rewrite::Reading;
pub use scalar::scalar_functions;
pub use summary::Summary;
