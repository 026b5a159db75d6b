//! Nothing: what there is to see is `examples/impacts.rs`.
