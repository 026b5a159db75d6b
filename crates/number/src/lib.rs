//! Exact numbers, their floating-point counterparts, and the distance between them.
