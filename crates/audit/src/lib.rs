//! Reads derivation documents and judges their statements.
