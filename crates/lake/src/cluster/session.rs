//! A session whose queries a cluster runs.

use ballista::prelude::{SessionConfigExt as _, SessionContextExt as _};
use datafusion::execution::SessionStateBuilder;
use datafusion::prelude::{SessionConfig, SessionContext};

use super::{ClusterFault, host_and_port};

/// A session at a scheduler, HOST:PORT, that cuts a log into so many parts. The functions are given to
/// it by [`open`](crate::open) or [`register`](crate::register): what a session knew before it went to
/// a cluster is not kept.
///
/// # Errors
/// [`ClusterFault`] for a text that is no address. Whether a scheduler is there the first query tells.
pub async fn session(scheduler: &str, parts: usize) -> Result<SessionContext, ClusterFault> {
    let (host, port) = host_and_port(scheduler)?;
    let config = SessionConfig::new_with_ballista()
        .with_target_partitions(parts.max(1))
        // planned again while it runs, a query forgot the tasks of an executor that was lost (Ballista 55.0)
        .set_bool("ballista.planner.adaptive.enabled", false);
    let state = SessionStateBuilder::new().with_default_features().with_config(config).build();
    Ok(SessionContext::remote_with_state(&format!("df://{host}:{port}"), state).await?)
}
