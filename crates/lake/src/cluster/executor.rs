//! A process that runs tasks.

use std::path::PathBuf;
use std::sync::Arc;

use ballista_core::config::TaskSchedulingPolicy;
use ballista_core::registry::BallistaFunctionRegistry;
use ballista_executor::executor_process::{ExecutorProcessConfig, start_executor_process};

use super::{ClusterFault, address, host_and_port};
use crate::aggregate::aggregate_functions;
use crate::scalar::scalar_functions;

/// How an executor runs.
#[derive(Clone, Debug)]
pub struct ExecutorOptions {
    /// where it listens for other executors that fetch its results, HOST:PORT
    pub bind: String,
    /// the port where it listens for tasks, on the same host
    pub tasks: u16,
    /// the scheduler, HOST:PORT
    pub scheduler: String,
    /// tasks that it runs at once
    pub cores: usize,
    /// where it keeps results between the stages of a query
    pub work: Option<PathBuf>,
}

/// Seconds from one sign of life to the next.
const HEARTBEAT: u64 = 2;

/// Runs an executor until it is ended.
///
/// # Errors
/// [`ClusterFault`] if there is no scheduler, or it cannot listen.
pub async fn executor(options: &ExecutorOptions) -> Result<(), ClusterFault> {
    let bind = address(&options.bind)?;
    let (scheduler_host, scheduler_port) = host_and_port(&options.scheduler)?;
    let mut functions = BallistaFunctionRegistry::default();
    for function in scalar_functions() {
        functions.scalar_functions.insert(function.name().to_owned(), function);
    }
    for function in aggregate_functions() {
        functions.aggregate_functions.insert(function.name().to_owned(), function);
    }
    let config = ExecutorProcessConfig {
        bind_host: bind.ip().to_string(),
        external_host: Some(bind.ip().to_string()),
        port: bind.port(),
        grpc_port: options.tasks,
        scheduler_host,
        scheduler_port,
        scheduler_connect_timeout_seconds: 30,
        executor_heartbeat_interval_seconds: HEARTBEAT,
        vcores: options.cores,
        task_scheduling_policy: TaskSchedulingPolicy::PushStaged,
        work_dir: options.work.as_ref().map(|work| work.to_string_lossy().into_owned()),
        override_function_registry: Some(Arc::new(functions)),
        ..ExecutorProcessConfig::default()
    };
    Ok(start_executor_process(Arc::new(config)).await?)
}
