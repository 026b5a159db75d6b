//! What the fuzz targets share.

pub use kane_kernel as kernel;

use kane_audit::Budget;

/// Numbers that are drawn from the input.
pub mod chance;

/// The input as text, if it is: what is not is refused by one line, which a test holds.
#[must_use]
pub fn text(data: &[u8]) -> Option<&str> {
    std::str::from_utf8(data).ok()
}

/// So much that every way of searching is gone, and a claim takes milliseconds.
#[must_use]
pub fn small() -> Budget {
    Budget {
        steps: 40,
        fuel: 200_000,
        check: 2_000_000,
        functions: 4,
        squares: 400_000,
        cells: 200_000,
        document: 2_000_000,
        ..Budget::default()
    }
}
