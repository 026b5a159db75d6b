//! The same functions on a cluster: a scheduler, executors, and sessions whose queries they run.
//!
//! Every process has to know the functions: the scheduler plans with them, executors call them, and a
//! session plans with them before it asks. `docs/cluster.md` has the commands.

mod executor;
mod scheduler;
mod session;

use std::net::{SocketAddr, ToSocketAddrs as _};

pub use executor::{ExecutorOptions, executor};
pub use scheduler::{SchedulerOptions, scheduler};
pub use session::session;

/// Why a process of a cluster does not run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ClusterFault {
    /// A text that is no HOST:PORT.
    #[error("`{0}` is no HOST:PORT")]
    Address(String),
    /// What the library of the cluster says.
    #[error("{0}")]
    Cluster(#[from] ballista_core::error::BallistaError),
    /// What the query engine says.
    #[error("{0}")]
    Engine(#[from] datafusion::error::DataFusionError),
    /// The functions could not be registered.
    #[error(transparent)]
    Lake(#[from] crate::fault::LakeFault),
}

/// The first address that a name has.
fn address(text: &str) -> Result<SocketAddr, ClusterFault> {
    let wrong = || ClusterFault::Address(text.to_owned());
    text.to_socket_addrs().map_err(|_| wrong())?.next().ok_or_else(wrong)
}

/// Host and port of a text, which need not be known here.
fn host_and_port(text: &str) -> Result<(String, u16), ClusterFault> {
    let wrong = || ClusterFault::Address(text.to_owned());
    let (host, port) = text.rsplit_once(':').ok_or_else(wrong)?;
    Ok((host.to_owned(), port.parse().map_err(|_| wrong())?))
}
