//! Checks the derivations and the arithmetic of collision laws.

pub use kane_algebra as algebra;
pub use kane_audit as audit;
pub use kane_impact as impact;
pub use kane_kernel as kernel;
pub use kane_number as number;
pub use kane_report as report;
