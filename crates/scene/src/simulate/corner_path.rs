//! The height of one corner of a turning body above one wall, over time, and when it is first zero.

use kane_number::{Interval, System};

use crate::coordinate::{Coordinate, half};
use crate::rotation::turn;

/// Steps of a search; more are not made.
const MOST_STEPS: u32 = 20_000;
/// A step that is shorter than this part of the time is at the end.
const SHORT: f64 = 1e-15;
/// Times Newton's method is applied: enough for two floats from one.
const REFINED: u32 = 6;
/// Doublings of the width of an interval around a root.
const DOUBLINGS: u32 = 60;

/// The number system cannot tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Untold;

/// With the turn φ = `angle` + ω·τ
///
/// ```text
/// h(τ) = gap + speed·τ + pull·τ²/2 + along·sin φ − out·(1 − cos φ)
/// ```
///
/// where *out* is the component of the corner's arm along the wall's normal, and *along* that of the arm
/// turned by a right angle, both at φ = 0. A corner that has just left is given with its arm of that time,
/// `angle` = 0 and `gap` = 0, so that nothing cancels.
#[derive(Clone, Debug)]
pub(super) struct CornerPath<N> {
    pub(super) gap: N,
    pub(super) speed: N,
    pub(super) pull: N,
    pub(super) angle: N,
    pub(super) omega: N,
    pub(super) out: N,
    pub(super) along: N,
    /// whether it has just left this wall
    pub(super) leaves: bool,
}

impl<N: Coordinate> CornerPath<N> {
    /// Height and its speed; `None` where the number system does not turn.
    pub(super) fn at(&self, time: &N) -> Option<[N; 2]> {
        let [versine, sine] = turn(&self.omega.mul_add(time, &self.angle))?;
        let turned = self.along.clone() * &sine - self.out.clone() * &versine;
        let fallen = half(self.pull.clone() * time) + &self.speed;
        let height = fallen.mul_add(time, &self.gap) + turned;
        let swing = self.along.clone() * (N::one() - versine) - self.out.clone() * sine;
        let speed = self.pull.mul_add(time, &self.speed) + swing * &self.omega;
        Some([height, speed])
    }

    /// So much h″ lies below zero at most; rounded up.
    fn bend(&self) -> f64 {
        let reach = (self.out.square() + self.along.square()).enclosed().sqrt();
        let reach = reach.map_or(f64::INFINITY, Interval::upper);
        let swing = self.omega.square().enclosed().upper() * reach;
        let pull = self.pull.enclosed().lower();
        let rounding = 1e-12 * (swing + pull.abs());
        (swing - pull + rounding).max(f64::MIN_POSITIVE)
    }

    /// The first time up to the horizon at which the corner reaches the wall.
    ///
    /// From a height g and a speed s no path with h″ ≥ −M is down before g + s·τ − M·τ²/2 is. So steps of
    /// that length miss nothing, and near the wall they are Newton's. Encloses on intervals, where the
    /// corner must come down at once; in floats heuristic, since heights round.
    ///
    /// # Errors
    /// [`Untold`] for a corner that grazes, within what the number system knows, and for more steps than
    /// the budget.
    pub(super) fn comes_down(&self, horizon: f64) -> Result<Option<N>, Untold> {
        let bend = self.bend();
        let mut time = 0.0_f64;
        for _ in 0..MOST_STEPS {
            let here = N::of_enclosure(Interval::from(time)).ok_or(Untold)?;
            let [height, speed] = self.at(&here).ok_or(Untold)?;
            let (mut g, s) = (height.enclosed().lower(), speed.enclosed().lower());
            if time == 0.0 && (self.leaves || g <= 0.0 && s > 0.0) {
                // it is on the wall, and leaves it
                if s <= 0.0 {
                    return Err(Untold);
                }
                g = 0.0;
            } else if g <= 0.0 {
                return self.refined(time).map(Some);
            }
            let root = (s * s + 2.0 * bend * g).sqrt();
            let step = if s < 0.0 { 2.0 * g / (root - s) } else { (s + root) / bend };
            // shorter by more than what all of this rounds
            let next = step.mul_add(1.0 - 1e-12, time) * (1.0 - f64::EPSILON);
            if next.is_nan() || next > horizon {
                return if next.is_nan() { Err(Untold) } else { Ok(None) };
            }
            if next <= time * (1.0 + SHORT) {
                return self.refined(time).map(Some);
            }
            time = next;
        }
        Err(Untold)
    }

    /// The root that is at this time, or a little later.
    fn refined(&self, time: f64) -> Result<N, Untold> {
        if N::SYSTEM == System::Interval {
            return self.enclosed(time);
        }
        let mut root = N::of_enclosure(Interval::from(time)).ok_or(Untold)?;
        for _ in 0..REFINED {
            let [height, speed] = self.at(&root).ok_or(Untold)?;
            if speed.sign().is_less() != Some(true) {
                return Err(Untold);
            }
            root = root - height / speed;
        }
        if root.sign().is_less() == Some(true) { Ok(N::zero()) } else { Ok(root) }
    }

    /// The same on intervals: h is above zero before, below zero after, and falls all the way between.
    fn enclosed(&self, time: f64) -> Result<N, Untold> {
        let lift = |x: Interval| N::of_enclosure(x).ok_or(Untold);
        let mut width = (time * 1e-15).max(1e-18);
        let mut reached = None;
        for _ in 0..DOUBLINGS {
            let [height, _] = self.at(&lift(Interval::from(time + width))?).ok_or(Untold)?;
            if height.enclosed().upper() < 0.0 {
                reached = Some(Interval::between(time, time + width));
                break;
            }
            width *= 2.0;
        }
        let mut within = reached.ok_or(Untold)?;
        for _ in 0..REFINED {
            let [_, speed] = self.at(&lift(within)?).ok_or(Untold)?;
            if speed.sign().is_less() != Some(true) {
                return Err(Untold);
            }
            let middle = lift(Interval::from(within.midpoint()))?;
            let [height, _] = self.at(&middle).ok_or(Untold)?;
            let next = (middle - height / speed).enclosed();
            within = within.intersection(&next).ok_or(Untold)?;
        }
        lift(within)
    }
}

#[cfg(test)]
mod tests {
    use kane_number::{DoubleDouble, Interval, Lane as _};

    use super::CornerPath;
    use crate::coordinate::Coordinate;

    fn path<N: Coordinate>([gap, speed, pull, omega, out, along]: [f64; 6]) -> CornerPath<N> {
        let of = |x: f64| N::of_enclosure(Interval::from(x)).expect("not in exact numbers");
        CornerPath {
            gap: of(gap),
            speed: of(speed),
            pull: of(pull),
            angle: of(0.0),
            omega: of(omega),
            out: of(out),
            along: of(along),
            leaves: false,
        }
    }

    /// The first sign change on a fine grid.
    fn scanned(path: &CornerPath<f64>) -> f64 {
        let steps = 200_000_u32;
        let time = |n: u32| f64::from(n) / f64::from(steps) * 4.0;
        let below = |n: &u32| path.at(&time(*n)).expect("floats turn")[0] < 0.0;
        time((1..steps).find(below).expect("it comes down"))
    }

    #[test]
    fn a_corner_comes_down_first_where_a_fine_grid_says_so() {
        for case in [
            [1.0, 0.5, -9.81, 7.0, -0.2, 0.1],
            [0.4, 0.0, -1.0, 30.0, -0.1, 0.25],
            [0.31, -0.2, 0.0, -25.0, 0.3, 0.0],
            [2.0, -2.0, 1.2, 1.0, 0.1, -0.5],
        ] {
            let floats = path::<f64>(case);
            let found = floats.comes_down(1e3).expect("it is told").expect("it comes");
            let seen = scanned(&floats);
            assert!((found - seen).abs() < 3e-5, "{case:?}: {found} {seen}");
            let longer = path::<DoubleDouble>(case).comes_down(1e3).expect("told").expect("comes");
            let enclosed = path::<Interval>(case).comes_down(1e3).expect("told").expect("comes");
            assert!(enclosed.contains(&longer.exact().expect("finite")), "{case:?}: {enclosed}");
            assert!(enclosed.width() < 1e-12 && (longer.to_f64() - found).abs() < 1e-13);
        }
    }

    #[test]
    fn a_corner_that_grazes_on_intervals_is_not_told() {
        // without weight and spin-free the gap stays; turning, the lowest point just touches
        let grazing = path::<Interval>([0.5, 0.0, 0.0, 2.0, 0.0, 0.5]);
        assert!(grazing.comes_down(10.0).is_err());
    }

    #[test]
    fn what_goes_away_never_comes() {
        let away = path::<f64>([0.5, 1.0, 0.0, 1.0, -0.1, 0.1]);
        assert_eq!(away.comes_down(100.0), Ok(None));
    }
}
