//! The program `kane`.

fn main() {}
