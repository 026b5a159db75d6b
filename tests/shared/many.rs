//! How much a test does: all in the gate, a quarter in `cargo test`, which someone waits for.

fn is_set(name: &str) -> bool {
    std::env::var_os(name).is_some()
}

/// Whether everything is asked for: in the gate (`KANE_GATE=1`) or in a long run (`KANE_LONG=1`).
pub(crate) fn all() -> bool {
    is_set("KANE_GATE") || is_set("KANE_LONG")
}

/// How many of something: `gate` of them in the gate, ten times that in a long run, and else a quarter.
pub(crate) fn many(gate: usize) -> usize {
    if is_set("KANE_LONG") {
        10 * gate
    } else if all() {
        gate
    } else {
        gate.div_ceil(4)
    }
}

/// Of what does not depend on each other: all in the gate, and else every fourth.
pub(crate) fn share<T>(things: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    things.into_iter().step_by(if all() { 1 } else { 4 })
}
