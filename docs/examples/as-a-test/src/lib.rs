//! A bounce off a wall. `derivation.md` derives the formula, and `tests/holds.rs` has kane check it.

/// The kinetic energy in joule that a body loses in a bounce off a wall: 1/2·m·u²·(1 − e²), for a mass in
/// kg, a speed in m/s, and a coefficient of restitution from 0 to 1.
#[must_use]
pub fn loss(mass: f64, speed: f64, restitution: f64) -> f64 {
    0.5 * mass * speed * speed * (1.0 - restitution) * (1.0 + restitution)
}
