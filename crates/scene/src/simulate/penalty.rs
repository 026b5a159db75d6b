//! For contrast: a ball on a spring floor, stepped as common engines do.

/// A ball that drops without loss on a floor that is a linear spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Penalty {
    /// kg
    pub mass: f64,
    /// N/m
    pub stiffness: f64,
    /// m/s²
    pub gravity: f64,
    /// The height of the drop; m.
    pub height: f64,
    /// s
    pub step: f64,
}

/// The energy after the given time by the energy before, by the semi-implicit method of Euler with a
/// fixed step: what a penalty method does to a motion that loses nothing.
///
/// Heuristic, and meant to be. The error is that of the steps in which the ball enters and leaves the
/// spring, and depends on where in a step that happens, so that a smaller step may be worse.
#[must_use]
pub fn bounce_by_penalty(ball: &Penalty, duration: f64) -> f64 {
    let Penalty { mass, stiffness, gravity, height, step } = *ball;
    let (mut y, mut v, mut time) = (height, 0.0, 0.0);
    while time < duration {
        let push = if y < 0.0 { -stiffness * y } else { 0.0 };
        v += (push / mass - gravity) * step;
        y += v * step;
        time += step;
    }
    let spring = if y < 0.0 { stiffness * y * y / 2.0 } else { 0.0 };
    let energy = mass * v * v / 2.0 + mass * gravity * y + spring;
    energy / (mass * gravity * height)
}
