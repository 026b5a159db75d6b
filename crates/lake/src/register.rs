//! The functions for a session of a query engine.

use std::sync::Arc;

use datafusion::execution::FunctionRegistry as _;
use datafusion::prelude::SessionContext;

use crate::aggregate::aggregate_functions;
use crate::fault::LakeFault;
use crate::rewrite::{FillIn, Reading};
use crate::scalar::scalar_functions;

/// Gives a session every function of this crate; columns are known by their usual names.
///
/// # Errors
/// [`LakeFault::Engine`] if the session takes no functions.
pub fn register(session: &SessionContext) -> Result<(), LakeFault> {
    register_for(session, Reading::default())
}

/// The same for tables whose columns are called otherwise, or whose numbers have a known format. What
/// a session was told first stays.
///
/// # Errors
/// [`LakeFault::Engine`] if the session takes no functions.
pub fn register_for(session: &SessionContext, reading: Reading) -> Result<(), LakeFault> {
    for function in scalar_functions() {
        session.register_udf(function.as_ref().clone());
    }
    for function in aggregate_functions() {
        session.register_udaf(function.as_ref().clone());
    }
    // a clone is the same session: what is registered in one is in both
    Ok(session.clone().register_function_rewrite(Arc::new(FillIn(reading)))?)
}
