//! An axis: from where to where, by which scale, and where it bears numbers.

/// An axis.
#[derive(Clone, Debug)]
pub(crate) struct Axis {
    pub(crate) label: String,
    range: (f64, f64),
    is_logarithmic: bool,
    pub(crate) ticks: Vec<(f64, String)>,
}

/// About so many numbers along an axis.
const TICKS: f64 = 6.0;

impl Axis {
    /// An axis with numbers at round steps.
    pub(crate) fn linear(
        label: impl Into<String>,
        range: (f64, f64),
        name: impl Fn(f64) -> String,
    ) -> Self {
        let (from, to) = range;
        let step = round_step((to - from) / TICKS);
        let first = (from / step).ceil();
        let last = (to / step).floor();
        let steps = std::iter::successors(Some(first), |n| Some(n + 1.0));
        let at = steps.take_while(|n| *n <= last).take(50).map(|n| n * step + 0.0);
        let ticks = at.map(|at| (at, name(at))).collect();
        Self { label: label.into(), range, is_logarithmic: false, ticks }
    }

    /// A logarithmic axis with numbers at powers of ten, and between them where these are few.
    pub(crate) fn logarithmic(
        label: impl Into<String>,
        range: (f64, f64),
        name: impl Fn(f64) -> String,
    ) -> Self {
        let (from, to) = (range.0.log10(), range.1.log10());
        let every = ((to - from) / TICKS).ceil().max(1.0);
        let between: &[f64] = if to - from < 3.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let powers =
            std::iter::successors(Some((from / every).floor() * every), |n| Some(n + every));
        let powers = powers.take_while(|n| *n <= to + 1e-9).take(50);
        let all = powers.flat_map(|n| between.iter().map(move |m| m * 10_f64.powf(n)));
        let inside = all.filter(|at| (range.0 * 0.999..=range.1 * 1.001).contains(at));
        let ticks = inside.map(|at| (at, name(at))).collect();
        Self { label: label.into(), range, is_logarithmic: true, ticks }
    }

    /// An axis with numbers where it is told to have them.
    pub(crate) fn told(
        label: impl Into<String>,
        range: (f64, f64),
        ticks: Vec<(f64, String)>,
    ) -> Self {
        Self { label: label.into(), range, is_logarithmic: false, ticks }
    }

    pub(crate) fn with_logarithms(mut self, is_logarithmic: bool) -> Self {
        self.is_logarithmic = is_logarithmic;
        self
    }

    /// How far along the axis a value is: 0 at its beginning, 1 at its end; `None` for what has no logarithm.
    pub(crate) fn share(&self, value: f64) -> Option<f64> {
        let (from, to) = self.range;
        let share = match self.is_logarithmic {
            true if value > 0.0 => (value / from).ln() / (to / from).ln(),
            true => return None,
            false => (value - from) / (to - from),
        };
        share.is_finite().then_some(share)
    }
}

/// 1, 2 or 5 times a power of ten, near this.
fn round_step(step: f64) -> f64 {
    let step = if step.is_finite() && step > 0.0 { step } else { 1.0 };
    let power = 10_f64.powf(step.log10().floor());
    let rounds = [1.0, 2.0, 5.0, 10.0].into_iter().map(|n| n * power);
    rounds.into_iter().find(|round| *round >= step * 0.999).unwrap_or(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|(_, name)| name.as_str()).collect()
    }

    #[test]
    fn numbers_stand_at_round_places() {
        let name = |x: f64| x.to_string();
        assert_eq!(numbers(&Axis::linear("", (-0.7, 1.3), name)), ["-0.5", "0", "0.5", "1"]);
        let ten = Axis::logarithmic("", (1.0, 1e12), |x| format!("{x:e}"));
        assert_eq!(numbers(&ten), ["1e0", "1e2", "1e4", "1e6", "1e8", "1e10", "1e12"]);
        assert_eq!(numbers(&Axis::logarithmic("", (2.0, 30.0), name)), ["2", "5", "10", "20"]);
    }

    #[test]
    fn a_share_is_none_where_there_is_no_logarithm() {
        let axis = Axis::logarithmic("", (1.0, 100.0), |x| x.to_string());
        assert_eq!([axis.share(10.0), axis.share(0.0)], [Some(0.5), None]);
    }
}
