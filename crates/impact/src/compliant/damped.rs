//! The normal motion of a contact with a damper, at equal steps of time.

use super::NoOutcome;
use super::hertz::{COMPRESSION, Node, to_float};

/// How a contact with e < 1 loses energy along its normal. Theories of elastic contact do not say; it
/// is a constitutive choice, and k depends on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Loss {
    /// The force of restitution is that of compression run backwards, on a clock faster by 1/e.
    Recoil,
    /// A damper beside Hertz's spring, c·δ^(1/4)·δ', with the c that gives e, which then does not
    /// depend on the speed. After Y. Tsuji, T. Tanaka and T. Ishida, Powder Technol. 71 (1992) 239-250,
    /// from memory, original not consulted.
    Tsuji,
    /// A damper c·δ' beside the spring, with the c that gives e. Its force is there at once when the
    /// bodies touch.
    Linear,
}

impl Loss {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Recoil, Self::Tsuji, Self::Linear];

    /// The word for it in files.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Recoil => "recoil",
            Self::Tsuji => "tsuji",
            Self::Linear => "linear",
        }
    }

    /// What it is, in words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Recoil => "restitution that is compression on a clock faster by 1/e",
            Self::Tsuji => "Tsuji's damper",
            Self::Linear => "a linear damper",
        }
    }

    /// The power of the penetration in the damper.
    fn power(self) -> f64 {
        if self == Self::Tsuji { 0.25 } else { 0.0 }
    }
}

/// The spring of a contact: force K·x^p with K = (p + 1)/2, so that the undamped motion turns at x = 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Spring {
    /// p = 3/2
    Hertz,
    /// p = 1; the clock is the inverse frequency.
    Hooke,
}

impl Spring {
    fn force(self, x: f64) -> f64 {
        match self {
            Self::Hertz => 1.25 * x * x.sqrt(),
            Self::Hooke => x,
        }
    }

    /// How long undamped compression lasts.
    const fn compression(self) -> f64 {
        match self {
            Self::Hertz => COMPRESSION,
            Self::Hooke => std::f64::consts::FRAC_PI_2,
        }
    }
}

/// The strongest damper that is tried; e is below 1/1000 then.
const STRONGEST: f64 = 50.0;
/// Steps in an undamped compression while the damper is sought.
const SEEKING: usize = 200;
/// Times that the interval of the damper is halved.
const HALVINGS: usize = 40;

/// A contact with a damper that gives e.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Damped {
    spring: Spring,
    /// c
    strength: f64,
    /// q
    power: f64,
    restitution: f64,
}

impl Damped {
    /// Looks for c, by halving.
    pub(super) fn new(spring: Spring, loss: Loss, restitution: f64) -> Result<Self, NoOutcome> {
        let power = loss.power();
        let with = |strength: f64| Self { spring, strength, power, restitution };
        let parts = |c: f64| -with(c).follow(SEEKING).last().map_or(-1.0, |last| last.speed);
        if parts(STRONGEST) > restitution {
            return Err(NoOutcome::NoDamper(restitution));
        }
        let (mut low, mut high) = (0.0, STRONGEST);
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if parts(middle) > restitution {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(with(f64::midpoint(low, high)))
    }

    /// The motion x'' = −K·x^p − c·x^q·x' from x = 0, x' = 1 until the force is zero, where x' = −e, with
    /// `steps` steps to the time of an undamped compression. There the bodies part: they do not pull at
    /// each other, and what is left of x recovers without them.
    ///
    /// The force is scaled by 1 + O(h²), so that sliding all the time gives the impulse 1 + e to
    /// rounding. Classical Runge–Kutta; *heuristic*, far below the errors of what uses it.
    pub(super) fn history(&self, steps: usize) -> Vec<Node> {
        let motion = self.follow(steps);
        let sum: f64 = motion
            .windows(2)
            .map(|pair| (pair[1].time - pair[0].time) * (pair[0].force + pair[1].force) / 2.0)
            .sum();
        let scale = (1.0 + self.restitution) / sum;
        let nodes = motion.iter().map(|state| Node {
            time: state.time,
            force: state.force * scale,
            penetration: state.x,
            stiffness: 0.0,
        });
        nodes.collect()
    }

    fn follow(&self, steps: usize) -> Vec<State> {
        follow(self.spring, self.strength, self.power, steps)
    }
}

#[derive(Clone, Copy)]
struct State {
    time: f64,
    x: f64,
    speed: f64,
    force: f64,
}

fn follow(spring: Spring, c: f64, q: f64, steps: usize) -> Vec<State> {
    let force = |x: f64, v: f64| {
        let x = x.max(0.0);
        spring.force(x) + c * if q == 0.0 { 1.0 } else { x.powf(q) } * v
    };
    let h = spring.compression() / to_float(steps);
    let mut here = State { time: 0.0, x: 0.0, speed: 1.0, force: force(0.0, 1.0) };
    let mut states = vec![here];
    // the strongest dampers let the bodies go late
    for _ in 0..steps.saturating_mul(200) {
        let rate = |x: f64, v: f64| (v, -force(x, v));
        let (x, v) = (here.x, here.speed);
        let (a1, b1) = rate(x, v);
        let (a2, b2) = rate(x + h / 2.0 * a1, v + h / 2.0 * b1);
        let (a3, b3) = rate(x + h / 2.0 * a2, v + h / 2.0 * b2);
        let (a4, b4) = rate(x + h * a3, v + h * b3);
        let x = x + h / 6.0 * (a1 + 2.0 * (a2 + a3) + a4);
        let speed = v + h / 6.0 * (b1 + 2.0 * (b2 + b3) + b4);
        let next = State { time: here.time + h, x, speed, force: force(x, speed) };
        if next.speed < 0.0 && (next.force <= 0.0 || next.x <= 0.0) {
            // the part of the step up to where the force, or the penetration, ends
            let to_force = here.force / (here.force - next.force);
            let to_surface = if next.x <= 0.0 { here.x / (here.x - next.x) } else { 1.0 };
            let share = to_force.min(to_surface).clamp(0.0, 1.0);
            let between = |a: f64, b: f64| a + (b - a) * share;
            states.push(State {
                time: here.time + h * share,
                x: between(here.x, next.x).max(0.0),
                speed: between(here.speed, next.speed),
                force: 0.0,
            });
            break;
        }
        here = next;
        states.push(here);
    }
    states
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear spring with a linear damper of ratio ζ parts, force zero, with
    /// e = exp(−ζ/√(1 − ζ²)·(π − atan(2ζ·√(1 − ζ²)/(2ζ² − 1)))) for ζ < 1/√2 (Schwager and Pöschel 2007).
    #[test]
    fn a_linear_damper_gives_the_restitution_of_its_closed_form() {
        for zeta in [0.01_f64, 0.1, 0.3, 0.6] {
            let root = (1.0 - zeta * zeta).sqrt();
            let angle = (2.0 * zeta * root / (1.0 - 2.0 * zeta * zeta)).atan();
            let e = (-zeta / root * (std::f64::consts::PI - angle)).exp();
            let last = follow(Spring::Hooke, 2.0 * zeta, 0.0, 2_000);
            let parts = last.last().expect("it parts").speed;
            assert!((parts + e).abs() < 1e-5, "{zeta}: {parts} {e}");
        }
    }

    #[test]
    fn the_impulse_is_one_and_e_and_nothing_pulls() {
        for loss in [Loss::Tsuji, Loss::Linear] {
            for spring in [Spring::Hertz, Spring::Hooke] {
                for e in [0.02, 0.5, 0.98] {
                    let damped = Damped::new(spring, loss, e).expect("there is a damper");
                    let nodes = damped.history(300);
                    assert!(nodes.iter().all(|node| node.force >= 0.0));
                    let sum: f64 = nodes
                        .windows(2)
                        .map(|pair| {
                            let h = pair[1].time - pair[0].time;
                            h * f64::midpoint(pair[0].force, pair[1].force)
                        })
                        .sum();
                    assert!((sum - 1.0 - e).abs() < 1e-12);
                }
            }
        }
        let none = Damped::new(Spring::Hertz, Loss::Tsuji, 0.0);
        assert_eq!(none, Err(NoOutcome::NoDamper(0.0)));
    }
}
