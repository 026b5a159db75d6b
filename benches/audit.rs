//! How long an audit takes.

fn main() {}
