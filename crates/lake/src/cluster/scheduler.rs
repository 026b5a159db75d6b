//! The process that cuts queries into tasks and hands them to executors.

use std::sync::Arc;

use ballista_core::config::TaskSchedulingPolicy;
use ballista_core::utils::default_session_builder;
use ballista_scheduler::cluster::BallistaCluster;
use ballista_scheduler::config::{SchedulerConfig, TaskDistributionPolicy};
use ballista_scheduler::scheduler_process::start_server;
use datafusion::prelude::SessionConfig;

use super::{ClusterFault, address};
use crate::aggregate::aggregate_functions;
use crate::scalar::scalar_functions;

/// How the scheduler runs.
#[derive(Clone, Debug)]
pub struct SchedulerOptions {
    /// where it listens, HOST:PORT
    pub bind: String,
    /// an executor that says nothing for so long is given up, and its tasks are run elsewhere; s
    pub patience: u64,
}

/// Runs a scheduler until it is ended.
///
/// # Errors
/// [`ClusterFault`] if it cannot listen there.
pub async fn scheduler(options: &SchedulerOptions) -> Result<(), ClusterFault> {
    let bind = address(&options.bind)?;
    let config = SchedulerConfig {
        bind_host: bind.ip().to_string(),
        bind_port: bind.port(),
        external_host: bind.ip().to_string(),
        scheduling_policy: TaskSchedulingPolicy::PushStaged,
        task_distribution: TaskDistributionPolicy::RoundRobin,
        executor_timeout_seconds: options.patience,
        expire_dead_executor_interval_seconds: options.patience.div_ceil(2).max(1),
        override_session_builder: Some(Arc::new(|config: SessionConfig| {
            let state = default_session_builder(config)?;
            let mut functions = state.scalar_functions().values().cloned().collect::<Vec<_>>();
            functions.extend(scalar_functions());
            let mut aggregates = state.aggregate_functions().values().cloned().collect::<Vec<_>>();
            aggregates.extend(aggregate_functions());
            let builder = datafusion::execution::SessionStateBuilder::new_from_existing(state);
            let builder = builder.with_scalar_functions(functions);
            Ok(builder.with_aggregate_functions(aggregates).build())
        })),
        ..SchedulerConfig::default()
    };
    let cluster = BallistaCluster::new_from_config(&config).await?;
    Ok(start_server(cluster, bind, Arc::new(config)).await?)
}
