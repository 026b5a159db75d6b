//! What air does to a round body in flight.

use std::f64::consts::PI;

use crate::round::Round;

/// Air at rest, and the coefficients of the bodies in it.
///
/// ```text
/// F = ρ·π·r²/2·(−C_d·|v|·v + C_m·r·ω·(−v_y, v_x))
/// ```
///
/// Drag with the square of the speed, and Magnus' force with speed and spin alike: the coefficient of
/// lift is `C_m`·r·ω/|v|, as is usual for balls of moderate spin (J. M. Davies, J. Appl. Phys. 20 (1949)
/// 821-828, from memory, original not consulted). Spin does not decay, the air has no wind.
#[derive(Clone, Debug, PartialEq)]
pub struct Air<N> {
    /// ρ ≥ 0; kg/m³.
    pub density: N,
    /// `C_d` ≥ 0 of every body.
    pub drag: N,
    /// `C_m` of every body; above 0 a ball with backspin is lifted.
    pub lift: N,
}

impl<N> Air<N> {
    /// The same in another number system.
    pub fn map<M>(&self, mut to: impl FnMut(&N) -> M) -> Air<M> {
        Air { density: to(&self.density), drag: to(&self.drag), lift: to(&self.lift) }
    }
}

impl Air<f64> {
    /// The acceleration of a body by air and gravity, in m/s², and what the air takes from its energy in a
    /// second, −ρ·π·r²/2·C_d·|v|³, in W; the lift does no work.
    fn slope(&self, body: &Round<f64>, [vx, vy]: [f64; 2], gravity: f64) -> ([f64; 2], f64) {
        let (r, speed) = (body.radius, vx.hypot(vy));
        let by_mass = self.density * PI * r * r / (2.0 * body.mass);
        let drag = -by_mass * self.drag * speed;
        let lift = by_mass * self.lift * r * body.motion.omega;
        let power = -self.density * PI * r * r / 2.0 * self.drag * speed * speed * speed;
        ([drag.mul_add(vx, -lift * vy), drag.mul_add(vy, lift * vx) - gravity], power)
    }

    /// The body after one step of the classical method of Runge and Kutta, of fourth order, and the work of
    /// the air on the way, in J, which is integrated beside the motion and not taken from it: heuristic.
    pub(crate) fn stepped(&self, body: &Round<f64>, gravity: f64, step: f64) -> (Round<f64>, f64) {
        let start = [body.motion.vx, body.motion.vy];
        let at =
            |slope: [f64; 2], part: f64| [0, 1].map(|k| slope[k].mul_add(part * step, start[k]));
        let slope = |velocity: [f64; 2]| self.slope(body, velocity, gravity);
        let (one, first) = slope(start);
        let two_v = at(one, 0.5);
        let (two, second) = slope(two_v);
        let three_v = at(two, 0.5);
        let (three, third) = slope(three_v);
        let four_v = at(three, 1.0);
        let (four, last) = slope(four_v);
        let mean = |a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]| {
            [0, 1].map(|k| step * (a[k] + 2.0 * (b[k] + c[k]) + d[k]) / 6.0)
        };
        let (way, gain) = (mean(start, two_v, three_v, four_v), mean(one, two, three, four));
        let mut after = body.clone();
        after.position = [0, 1].map(|k| body.position[k] + way[k]);
        after.motion.vx += gain[0];
        after.motion.vy += gain[1];
        (after, step * (first + 2.0 * (second + third) + last) / 6.0)
    }

    /// A step in which neither a velocity changes by more than a part of it, nor a body flies farther than
    /// half of its radius; s.
    pub(crate) fn step(&self, bodies: &[Round<f64>], gravity: f64) -> f64 {
        let of = |body: &Round<f64>| {
            let velocity = [body.motion.vx, body.motion.vy];
            let ([ax, ay], _) = self.slope(body, velocity, gravity);
            let (speed, pull) = (velocity[0].hypot(velocity[1]), ax.hypot(ay));
            // from rest it takes a while to fly so far
            let fallen = (body.radius / pull).sqrt();
            let flown = body.radius / (2.0 * speed);
            fallen.min(flown).min((speed / pull).max(fallen) / 64.0)
        };
        bodies.iter().map(of).fold(f64::INFINITY, f64::min)
    }
}
