//! The normal motion of Hertz's contact, at equal steps of time.

/// The normal state at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Node {
    /// Time by that in which the approach speed covers the greatest penetration.
    pub(super) time: f64,
    /// F; its impulse, summed by the trapezoidal rule, is 1 in compression and e in restitution.
    pub(super) force: f64,
    /// x = δ/δ_max of the elastic state; the radius of contact by its greatest is √x.
    pub(super) penetration: f64,
    /// (ΔF/Δx)/unscaled, the secant stiffness of the step that ends here; 0 at the first node.
    pub(super) stiffness: f64,
}

impl Node {
    /// F shared out to rings of equal width up to the greatest radius, by the share `inside` a
    /// radius in units of that of the contact. A ring takes part once `joins` of its width is
    /// covered, the innermost always; the last one bears what is left outside of it, too.
    pub(super) fn shared(&self, count: usize, joins: f64, inside: impl Fn(f64) -> f64) -> Vec<f64> {
        let rings = self.penetration.sqrt() * to_float(count);
        let takes_part = |i: usize| i == 0 || to_float(i) + joins < rings;
        let mut forces = Vec::new();
        let mut given = 0.0;
        let mut i = 0;
        while self.force > 0.0 && i < count && takes_part(i) {
            let last = i + 1 == count || !takes_part(i + 1);
            let next = if last { 1.0 } else { inside(to_float(i + 1) / rings) };
            forces.push(self.force * (next - given));
            given = next;
            i += 1;
        }
        forces
    }
}

/// The duration of compression, (2/5)·B(2/5, 1/2).
pub(super) const COMPRESSION: f64 = 1.471_637_592_162_352_3;

/// Compression and restitution in `steps` steps each, of which the latter are shorter by e; with
/// e = 0 there is compression alone.
///
/// x'' = −(5/4)·x^(3/2), x' = 1 at x = 0 and x = 1 at x' = 0. Integrated from the turning point,
/// where it is smooth, by the classical Runge–Kutta method: far below the errors of what uses it.
/// The force is scaled by 1 + O(h²), so that sliding all the time gives the whole impulse to
/// rounding.
pub(super) fn history(steps: usize, restitution: f64) -> Vec<Node> {
    let h = COMPRESSION / to_float(steps);
    let mut x = vec![1.0];
    let (mut here, mut speed) = (1.0_f64, 0.0_f64);
    for _ in 1..steps {
        (here, speed) = runge_kutta(here, speed, h);
        x.push(here);
    }
    x.push(0.0);
    x.reverse();
    let raw: Vec<f64> = x.iter().map(|x| 1.25 * x * x.sqrt()).collect();
    let sum: f64 = raw.iter().sum::<f64>() - 0.5 * raw.last().copied().unwrap_or(0.0);
    let scale = 1.0 / (h * sum);
    let node = |i: usize, time: f64, stiffness: f64| Node {
        time,
        force: raw[i] * scale,
        penetration: x[i],
        stiffness,
    };
    let secant = |i: usize| (raw[i + 1] - raw[i]) / (x[i + 1] - x[i]);
    let mut nodes = vec![node(0, 0.0, 0.0)];
    nodes.extend((1..=steps).map(|i| node(i, to_float(i) * h, secant(i - 1))));
    if restitution > 0.0 {
        let later = |i: usize| COMPRESSION + to_float(steps - i) * h * restitution;
        nodes.extend((0..steps).rev().map(|i| node(i, later(i), secant(i))));
    }
    nodes
}

fn runge_kutta(x: f64, v: f64, h: f64) -> (f64, f64) {
    let pull = |x: f64| -1.25 * x.max(0.0) * x.max(0.0).sqrt();
    let (a1, b1) = (v, pull(x));
    let (a2, b2) = (v + h / 2.0 * b1, pull(x + h / 2.0 * a1));
    let (a3, b3) = (v + h / 2.0 * b2, pull(x + h / 2.0 * a2));
    let (a4, b4) = (v + h * b3, pull(x + h * a3));
    (x + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4), v + h / 6.0 * (b1 + 2.0 * (b2 + b3) + b4))
}

/// A count of steps or annuli, which budgets keep far below 2³².
pub(super) fn to_float(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::INFINITY, f64::from)
}

#[cfg(test)]
mod tests {
    use super::{COMPRESSION, Node, history, to_float};

    /// ∫dx/√(1 − x^(5/2)) with x = 1 − s², by the midpoint rule, whose error is of second order:
    /// 1e-7 with a thousand points.
    #[test]
    fn compression_lasts_as_long_as_its_integral_says() {
        let n = 1000;
        let mut sum = 0.0;
        for i in 0..n {
            let s = (to_float(i) + 0.5) / to_float(n);
            sum += 2.0 * s / (1.0 - (1.0 - s * s).powf(2.5)).sqrt();
        }
        assert!((sum / to_float(n) - COMPRESSION).abs() < 1e-6);
    }

    /// Energy, which the integration does not use: between nodes the mean speed is that of
    /// √(1 − x^(5/2)) up to O(h²); and the impulses are 1 and e, to rounding.
    #[test]
    fn the_history_keeps_energy_and_impulse() {
        let (steps, e) = (200, 0.6);
        let nodes = history(steps, e);
        assert_eq!(nodes.len(), 2 * steps + 1);
        let mut impulses = [0.0, 0.0];
        for (n, pair) in nodes.windows(2).enumerate() {
            let [from, to] = pair else { continue };
            let h = to.time - from.time;
            let clock = if n < steps { 1.0 } else { e };
            let speed = (to.penetration - from.penetration).abs() / h * clock;
            let middle = f64::midpoint(from.penetration, to.penetration);
            let expected = (1.0 - middle.powf(2.5)).max(0.0).sqrt();
            // at the turning point the speed is O(h) itself
            assert!((speed - expected).abs() < 0.01, "{n}: {speed} {expected}");
            impulses[usize::from(n >= steps)] += h * (from.force + to.force) / 2.0;
        }
        assert!((impulses[0] - 1.0).abs() < 1e-13 && (impulses[1] - e).abs() < 1e-13);
        assert_eq!(history(steps, 0.0).len(), steps + 1);
    }

    #[test]
    fn rings_share_the_whole_force() {
        for node in history(50, 1.0) {
            for joins in [0.0, 0.385, 0.5] {
                let shares = Node::shared(&node, 20, joins, |r| r * r);
                assert!((shares.iter().sum::<f64>() - node.force).abs() < 1e-15);
                assert!(shares.iter().all(|share| *share >= 0.0));
                assert_eq!(shares.is_empty(), node.force == 0.0);
            }
        }
    }
}
