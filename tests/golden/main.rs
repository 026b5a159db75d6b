//! Snapshots of what the program prints: every file under `snapshots/` has one test here that owns it.
