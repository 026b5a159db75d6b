//! One impact with all that the checks ask of it, and what each says.

use kane_number::Rational;
use num_traits::Signed as _;

use crate::check::{Check, Finding, Verdict};
use crate::event::{Event, FromFloat as _, Given};
use crate::facts::Facts;
use crate::frame::Frame;
use crate::rejection::Reason;
use crate::row::Row;
use crate::tolerance::{Precision, Tolerance};
use crate::written::{Settings, Written, turn};

/// An impact with all that the checks ask.
pub struct Case<'a> {
    /// the row
    pub row: &'a Row,
    /// its frame
    pub frame: Frame,
    /// the impact in floats
    pub event: Event<f64>,
    /// its facts in floats
    pub facts: Facts<f64>,
    /// what is stated
    pub given: Given,
    /// its tolerances
    pub tolerance: Tolerance,
    /// those of a stricter format, where the numbers may be of that as well
    strict: Option<Box<Tolerance>>,
}

/// What is left of a check, how much may be left, and the scale of the quantity.
type Left = (f64, f64, f64);

impl<'a> Case<'a> {
    /// The impact of a row; `spatial` says whether the log is one in space.
    ///
    /// # Errors
    /// [`Reason`] for a row that cannot be checked.
    #[inline(always)]
    pub fn of(row: &'a Row, spatial: bool, precision: &Precision) -> Result<Self, Reason> {
        Given::check(row)?;
        let printed = match &precision.steps {
            Some(steps) if precision.settings => turn(row, steps),
            _ => 0.0,
        };
        let frame = Frame::of(row, spatial, printed)?;
        Event::check(row)?;
        let (given, event) = (Given::of(row), Event::<f64>::of(row, &frame));
        let facts = event.facts();
        let tolerance_of = |log: &Precision| {
            let written = Written::of(row, &frame, log.steps.as_ref(), log.floor);
            let tolerance = Tolerance::of(&event, &facts, &given, log, &written);
            match &log.steps {
                Some(steps) if log.settings => {
                    let off = Settings::of(row, &frame, &event, steps);
                    tolerance.widened(&event, &facts, &given, &off)
                }
                _ => tolerance,
            }
        };
        let tolerance = tolerance_of(precision);
        if facts.before[1] > tolerance.separation {
            return Err(Reason::Apart(facts.before[1]));
        }
        let strict = precision.strict().map(|strict| Box::new(tolerance_of(&strict)));
        Ok(Self { row, frame, event, facts, given, tolerance, strict })
    }

    /// What a check says of this row, or `None` where it has nothing to ask. [`Check::Order`] is
    /// about more than one row and not asked here.
    #[must_use]
    #[inline(always)]
    pub fn finding(&self, check: Check) -> Option<Finding> {
        let (residual, tolerance, scale) = self.left(check, &self.tolerance)?;
        let verdict = match &self.strict {
            None if residual + residual <= tolerance => Verdict::Holds,
            strict => self.verdict(check, residual, tolerance, strict.as_deref()),
        };
        Some(Finding { residual, tolerance, scale, verdict })
    }

    /// Whether a check holds; in doubt by the tolerances of both formats.
    #[cold]
    #[inline(never)]
    fn verdict(
        &self,
        check: Check,
        residual: f64,
        allowed: f64,
        strict: Option<&Tolerance>,
    ) -> Verdict {
        if !self.is_within(check, residual, allowed, &self.tolerance) {
            return Verdict::Fails;
        }
        let holds = strict.is_none_or(|strict| {
            let left = self.left(check, strict);
            left.is_none_or(|(left, allowed, _)| self.is_within(check, left, allowed, strict))
        });
        if holds { Verdict::Holds } else { Verdict::Undecided }
    }

    /// Whether what is left is within the tolerance: by the residual in floats, and near it by the exact one.
    fn is_within(&self, check: Check, residual: f64, allowed: f64, within: &Tolerance) -> bool {
        let exact = || self.exact(check, allowed, within);
        let decided = if undecided(residual, allowed) { exact() } else { None };
        decided.unwrap_or(residual <= allowed)
    }

    /// What a check leaves of this row, and how much these tolerances allow.
    #[inline(always)]
    fn left(&self, check: Check, tolerance: &Tolerance) -> Option<Left> {
        let facts = &self.facts;
        let [p_t, p_n] = facts.impulse;
        let ([u_t, u_n], [after_t, after_n]) = (facts.before, facts.after);
        let speed = u_t.abs() + u_n.abs();
        let push = p_t.abs() + p_n.abs();
        let slip_within = || tolerance.slip + self.shift_beyond(tolerance.tangential);
        let (residual, allowed, scale) = match check {
            Check::Reaction => {
                let left = reaction(&self.event, facts)?;
                (left.0.abs().max(left.1.abs()), tolerance.reaction, push)
            }
            Check::Moment => {
                let arm = |arm: [f64; 2]| arm[0].abs() + arm[1].abs();
                let first =
                    (facts.moment.abs(), tolerance.moment, push * arm(self.event.first.arm));
                let other = facts.other_moment.zip(self.event.second.as_ref());
                let worse = |a: &Left, b: &Left| a.0 * b.1 >= b.0 * a.1;
                match other.map(|(moment, body)| {
                    (moment.abs(), tolerance.other_moment, push * arm(body.arm))
                }) {
                    Some(other) if !worse(&first, &other) => other,
                    _ => first,
                }
            }
            Check::Pull => (-p_n, tolerance.normal, push),
            Check::Penetration => (-after_n, tolerance.separation, speed),
            Check::Cone => {
                let bound = self.given.friction? * p_n.max(0.0);
                let rounding =
                    self.given.friction? * tolerance.normal + tolerance.friction * p_n.abs();
                (p_t.abs() - bound, tolerance.tangential + rounding, bound.max(push * 1e-3))
            }
            Check::Opposes => {
                let same = p_t * after_t > 0.0 && p_t.abs() > tolerance.tangential;
                (if same { after_t.abs() } else { 0.0 }, slip_within(), speed)
            }
            Check::Sticks => {
                let friction = self.given.friction?;
                let rounding = tolerance.tangential
                    + friction * tolerance.normal
                    + tolerance.friction * p_n.abs();
                let below = p_t.abs() < friction * p_n - rounding;
                (if below { after_t.abs() } else { 0.0 }, slip_within(), speed)
            }
            Check::Energy => {
                let before = self.energy_before();
                (facts.energy.iter().sum(), tolerance.energy, before)
            }
            Check::Restitution => {
                let left = after_n + self.given.restitution? * u_n;
                (left.abs(), tolerance.restitution, u_n.abs())
            }
            Check::Order => return None,
        };
        Some((residual.max(0.0), allowed, scale))
    }

    /// What the slip is uncertain by because the impulse of the first body acted beside the stated
    /// arm, |M/p_t|·(|ω| + |ω⁺|): friction ends the slip where it acts, and a wrong arm is the sin
    /// of [`Check::Moment`]. Zero where there is too little friction to tell; m/s.
    #[must_use]
    pub fn shift(&self) -> f64 {
        self.shift_beyond(self.tolerance.tangential)
    }

    /// The same, with this tolerance of friction.
    #[inline]
    fn shift_beyond(&self, tangential: f64) -> f64 {
        let p_t = self.facts.impulse[0];
        if p_t.abs() <= 100.0 * tangential {
            return 0.0;
        }
        let body = &self.event.first;
        let spin = body.before[2].abs() + body.after[2].abs();
        (self.facts.moment / p_t).abs().min(MOST_SHIFT * body.arm[1].abs()) * spin
    }

    /// The kinetic energy of the motion along the plane before; J.
    #[must_use]
    pub fn energy_before(&self) -> f64 {
        let of = |body: &crate::event::Moving<f64>| {
            let [t, n, spin] = body.before;
            (body.mass * (t * t + n * n) + body.inertia * spin * spin) / 2.0
        };
        of(&self.event.first) + self.event.second.as_ref().map_or(0.0, of)
    }

    /// Whether the check holds, by the exact residual.
    fn exact(&self, check: Check, allowed: f64, within: &Tolerance) -> Option<bool> {
        let event = Event::<Rational>::of(self.row, &self.frame);
        let facts = event.facts();
        let allowed = Rational::of_float(allowed);
        let stated = |value: Option<f64>| value.map(Rational::of_float);
        let zero = <Rational as kane_number::Number>::zero();
        let residual = match check {
            Check::Reaction => {
                let (t, n) = reaction(&event, &facts)?;
                t.abs().max(n.abs())
            }
            Check::Moment => {
                let first = facts.moment.abs();
                let other = facts.other_moment.map(|moment| moment.abs());
                let other_allowed = Rational::of_float(within.other_moment);
                let own = Rational::of_float(within.moment);
                return Some(first <= own && other.is_none_or(|other| other <= other_allowed));
            }
            Check::Pull => -facts.impulse[1].clone(),
            Check::Penetration => -facts.after[1].clone(),
            Check::Cone => {
                let bound = stated(self.given.friction)? * facts.impulse[1].clone().max(zero);
                facts.impulse[0].abs() - bound
            }
            Check::Opposes | Check::Sticks => facts.after[0].abs(),
            Check::Energy => {
                let [a, b, c] = facts.energy;
                a + b + c
            }
            Check::Restitution => {
                (facts.after[1].clone() + stated(self.given.restitution)? * &facts.before[1]).abs()
            }
            Check::Order => return None,
        };
        Some(residual <= allowed)
    }
}

/// The part of an arm by which the point of the impulse may excuse a slip: an engine lets bodies
/// overlap by some percents at most.
const MOST_SHIFT: f64 = 0.02;

/// Whether rounding in this program could change the verdict, see [`tolerance`](crate::tolerance).
fn undecided(residual: f64, tolerance: f64) -> bool {
    (residual - tolerance).abs() <= tolerance / 4.0 && residual != tolerance
        || residual == tolerance && tolerance > 0.0
}

/// What the impulses leave: of both bodies, or of the logged one and m·Δv.
fn reaction<N: kane_number::Number>(event: &Event<N>, facts: &Facts<N>) -> Option<(N, N)> {
    let [t, n] = facts.impulse.clone();
    match (&facts.reaction, &event.stated) {
        (Some([a, b]), _) => Some((t + a, n + b)),
        (None, Some([a, b])) => Some((t - a, n - b)),
        (None, None) => None,
    }
}
