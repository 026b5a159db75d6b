//! What exactness costs, and what floats keep, when each bounce is computed from the last one.

use std::fmt;

use kane_impact::bodies::{Motion, SphereOnPlane};
use kane_impact::{Law, NumberSystem, law};
use kane_number::{DoubleDouble, Interval, Rational, System};

use super::Told;
use super::clock::reading;
use crate::chart::{Answer, Effort, FormNumber, right};
use crate::{Arithmetic as _, Dyadic, DyadicNumber};

/// Bits of the reference: the exact slip is converted before anything is taken from it.
const REFERENCE: Dyadic = Dyadic { bits: 640 };
/// Digits that are right, in hundredths, below which an answer says nothing: not even one.
const ONE_DIGIT: i64 = 100;

/// The systems in which a chain runs.
const LANES: usize = 4;

/// One solid sphere that bounces on a plane, again and again, under one law.
///
/// The sphere falls back as fast as it left: the next approach speed is the last speed of
/// separation, and `v_x` and ω are those after the last bounce.
#[derive(Clone, Debug)]
pub struct Chain {
    /// the law's id
    pub law: &'static str,
    /// the bounces that were looked at
    pub bounces: Vec<Bounce>,
    /// the number systems that did not come to the last bounce, and why
    pub ended: Vec<(System, End)>,
}

/// The state after some bounces.
#[derive(Clone, Debug)]
pub struct Bounce {
    /// how many bounces there were
    pub n: usize,
    /// bits of the exact `v_x`, `v_y` and ω, numerators and denominators together; `None` where the
    /// exact chain has ended
    pub bits: Option<u64>,
    /// digits of the slip that are right, by system; exact ones are not listed
    pub digits: Vec<(System, Digits)>,
    /// picoseconds of this bounce alone, by system, if it was timed
    pub times: Vec<(System, u64)>,
}

/// Decimal digits, in hundredths.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digits {
    /// that agree with the exact slip; `None` where that is not known
    pub right: Option<i64>,
    /// that an enclosure guarantees by its width; `None` for what is no enclosure
    pub certain: Option<i64>,
}

/// Why a number system did not go on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct End {
    /// the bounce that it could not compute
    pub at: usize,
    /// why
    pub why: Why,
}

/// What stopped it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Why {
    /// the state was larger than what is affordable here, in bits
    TooLarge(u64),
    /// the law gave no outcome in this system, in its own words
    NoOutcome(String),
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.why {
            Why::TooLarge(bits) => write!(f, "given up before bounce {}, at {bits} bits", self.at),
            Why::NoOutcome(why) => write!(f, "bounce {}: {why}", self.at),
        }
    }
}

impl Chain {
    /// The last of the bounces looked at up to which a system keeps a digit of the slip: one that is
    /// right, or for intervals one that is certain. `None` if it keeps none.
    #[must_use]
    pub fn keeps_a_digit(&self, lane: System) -> Option<usize> {
        let kept = |bounce: &&Bounce| {
            bounce.digits.iter().any(|(known, digits)| {
                let digits = if lane == System::Interval { digits.certain } else { digits.right };
                *known == lane && digits.is_some_and(|digits| digits >= ONE_DIGIT)
            })
        };
        self.bounces.iter().take_while(kept).last().map(|bounce| bounce.n)
    }

    /// Whether a system was compared with the exact chain at the last bounce looked at.
    #[must_use]
    pub fn is_compared_throughout(&self) -> bool {
        self.bounces.last().is_some_and(|bounce| bounce.bits.is_some())
    }

    /// The last bounce with an exact state, and its bits.
    #[must_use]
    pub fn last_exact(&self) -> Option<(usize, u64)> {
        self.bounces.iter().rev().find_map(|bounce| Some((bounce.n, bounce.bits?)))
    }

    /// Whether the exact state doubles, rather than grows by a constant: each of the last three
    /// bounces makes it at least 1.8 times as large.
    #[must_use]
    pub fn doubles(&self) -> bool {
        let bits: Vec<u64> = self.bounces.iter().map_while(|bounce| bounce.bits).collect();
        let last = bits.get(bits.len().saturating_sub(4)..).unwrap_or_default();
        last.len() == 4 && last.windows(2).all(|pair| 10 * pair[1] >= 18 * pair[0])
    }
}

/// How far a chain goes, and how large an exact state may become.
const fn plan(effort: Effort) -> (usize, u64) {
    match effort {
        Effort::Quick => (200, 1 << 14),
        Effort::Full => (1000, 1 << 19),
    }
}

/// Whether a bounce is looked at: the first twenty, every tenth to a hundred, every fiftieth.
const fn is_looked_at(n: usize) -> bool {
    n <= 20 || (n <= 100 && n.is_multiple_of(10)) || n.is_multiple_of(50)
}

/// A progress step for so many bounces.
const STEP: usize = 10;

pub(super) const fn steps(effort: Effort) -> usize {
    3 * LANES * (plan(effort).0 / STEP)
}

/// 5/2 kg and 1 m: J = 2/5·m·r² = 1 kg·m². All inputs are floats, so that no system begins with an
/// error: μ = 1/2, e = 7/8, `v_x` = 1 m/s, `v_y` = 1 m/s, ω = 1/4 rad/s.
fn sphere() -> SphereOnPlane<Rational> {
    let n = |p: i64, q: i64| Rational::new(p.into(), q.into());
    SphereOnPlane {
        mass: n(5, 2),
        radius: n(1, 1),
        inertia: n(1, 1),
        friction: n(1, 2),
        restitution: n(7, 8),
        before: Motion { vx: n(1, 1), vy: n(1, 1), omega: n(1, 4) },
    }
}

/// The sphere when it meets the plane again.
fn bounce<N: FormNumber<WideReal: NumberSystem>>(
    law: &Law,
    sphere: &SphereOnPlane<N>,
) -> Result<SphereOnPlane<N>, String> {
    let after = sphere.collide(law.over()).map_err(|error| error.to_string())?.after;
    let before = Motion { vy: -after.vy, ..after };
    Ok(SphereOnPlane { before, ..sphere.clone() })
}

/// The slip of a state, exactly: `v_x` − ω·r with r = 1; for enclosures its two ends.
fn slip<N: FormNumber>(motion: &Motion<N>) -> Option<Answer> {
    Some(match (motion.vx.answer()?, motion.omega.answer()?) {
        (Answer::Between(a, b), Answer::Between(c, d)) => Answer::Between(a - d, b - c),
        (Answer::Number(vx), Answer::Number(omega)) => Answer::Number(vx - omega),
        _ => return None,
    })
}

/// The slips of one system with the times, by bounce, and why it ended.
struct Run {
    points: Vec<Point>,
    end: Option<End>,
}

struct Point {
    n: usize,
    slip: Option<DyadicSlip>,
    bits: u64,
    time: Option<u64>,
}

/// A number, or the two ends of an enclosure.
type DyadicSlip = (DyadicNumber, Option<DyadicNumber>);

fn run<N: FormNumber<WideReal: NumberSystem>>(
    law: &Law,
    effort: Effort,
    timed: bool,
    told: &mut Told<'_>,
) -> Run {
    let (greatest, most) = plan(effort);
    let mut state = sphere().map(N::from_rational);
    let (mut points, mut end) = (Vec::new(), None);
    for n in 1..=greatest {
        if n.is_multiple_of(STEP) {
            told.step();
        }
        if end.is_some() {
            continue;
        }
        let timed = timed && is_looked_at(n);
        let (next, time) = reading(timed, || bounce(law, &state));
        state = match next {
            Ok(next) => next,
            Err(why) => {
                end = Some(End { at: n, why: Why::NoOutcome(why) });
                continue;
            }
        };
        let bits = bits(&state.before);
        if is_looked_at(n) {
            let slip = slip(&state.before).map(|slip| match slip {
                Answer::Number(x) => (REFERENCE.number(&x), None),
                Answer::Between(a, b) => (REFERENCE.number(&a), Some(REFERENCE.number(&b))),
            });
            points.push(Point { n, slip, bits, time });
        }
        if N::SYSTEM == System::Rational && bits > most {
            end = Some(End { at: n + 1, why: Why::TooLarge(bits) });
        }
    }
    Run { points, end }
}

/// Numerators and denominators of the three velocities.
fn bits<N: FormNumber>(motion: &Motion<N>) -> u64 {
    let of = |number: &N| match number.answer() {
        Some(Answer::Number(x)) => x.numer().bits() + x.denom().bits(),
        _ => 0,
    };
    of(&motion.vx) + of(&motion.vy) + of(&motion.omega)
}

/// Digits of one slip beside the exact one.
fn digits((slip, upper): &DyadicSlip, exact: Option<&DyadicNumber>) -> Digits {
    let error = |x: &DyadicNumber, exact: &DyadicNumber| magnitude(&x.minus(exact));
    let agreeing = exact.map(|exact| {
        let mut worst = error(slip, exact);
        if let Some(upper) = upper {
            let other = error(upper, exact);
            if worst.minus(&other).is_negative() {
                worst = other;
            }
        }
        right(&worst, exact)
    });
    let certain = upper.as_ref().map(|upper| {
        let has_zero =
            slip.is_zero() || upper.is_zero() || slip.is_negative() != upper.is_negative();
        let nearer = if slip.is_negative() { upper } else { slip };
        if has_zero { 0 } else { right(&magnitude(&upper.minus(slip)), nearer) }
    });
    Digits { right: agreeing, certain }
}

fn magnitude(x: &DyadicNumber) -> DyadicNumber {
    if x.is_negative() { DyadicNumber::zero().minus(x) } else { x.clone() }
}

fn chain(law: &Law, effort: Effort, timed: bool, told: &mut Told<'_>) -> Chain {
    let exact = run::<Rational>(law, effort, timed, told);
    let others = [
        (System::F64, run::<f64>(law, effort, timed, told)),
        (System::DoubleDouble, run::<DoubleDouble>(law, effort, timed, told)),
        (System::Interval, run::<Interval>(law, effort, timed, told)),
    ];
    let greatest = plan(effort).0;
    let looked_at = (1..=greatest).filter(|n| is_looked_at(*n));
    let at = |run: &Run, n: usize| run.points.iter().position(|point| point.n == n);
    let bounces = looked_at.map(|n| {
        let truth = at(&exact, n).and_then(|i| exact.points.get(i));
        let mut found = Bounce {
            n,
            bits: truth.map(|point| point.bits),
            digits: Vec::new(),
            times: Vec::new(),
        };
        found.times.extend(truth.and_then(|point| Some((System::Rational, point.time?))));
        let truth = truth.and_then(|point| point.slip.as_ref()).map(|(slip, _)| slip);
        for (lane, run) in &others {
            let Some(point) = at(run, n).and_then(|i| run.points.get(i)) else { continue };
            found.digits.extend(point.slip.as_ref().map(|slip| (*lane, digits(slip, truth))));
            found.times.extend(point.time.map(|time| (*lane, time)));
        }
        found
    });
    let bounces = bounces.collect();
    let runs = [(System::Rational, exact)].into_iter().chain(others);
    let ended = runs.filter_map(|(lane, run)| Some((lane, run.end?))).collect();
    Chain { law: law.info.id, bounces, ended }
}

pub(super) fn chains(effort: Effort, timed: bool, told: &mut Told<'_>) -> Vec<Chain> {
    let laws = ["wang-su-li", "walton", "smith-1991"].into_iter().filter_map(law);
    laws.map(|law| chain(law, effort, timed, told)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(id: &str) -> &'static Law {
        law(id).expect("there is such a law")
    }

    fn slips(law: &Law, count: usize) -> Vec<Rational> {
        let mut state = sphere();
        let next = |_| {
            state = bounce(law, &state).expect("an outcome");
            state.before.vx.clone() - &state.before.omega
        };
        (0..count).map(next).collect()
    }

    /// s′ = s·(|s| − A)/(|s| + A) with A = j_p·μ·(1 + e)·v_y/2, which shrinks by e: α = A/|s| in (16).
    #[test]
    fn the_paper_s_chain_is_the_map_of_the_slip_by_hand() {
        let n = |p: i64, q: i64| Rational::new(p.into(), q.into());
        let (mut slip, mut reach) = (n(3, 4), n(7, 2) * n(1, 2) * n(15, 8) / n(2, 1));
        for found in slips(known("wang-su-li"), 8) {
            let size = if slip < n(0, 1) { -slip.clone() } else { slip.clone() };
            slip = &slip * (&size - &reach) / (&size + &reach);
            reach = &reach * n(7, 8);
            assert_eq!(found, slip);
        }
    }

    /// The slip of a rebound is −β0 times the one before, as often as one likes.
    #[test]
    fn walton_s_chain_is_a_power() {
        let share = Rational::new((-11).into(), 25.into());
        let mut slip = Rational::new(3.into(), 4.into());
        for found in slips(known("walton"), 60) {
            slip *= &share;
            assert_eq!(found, slip);
        }
    }

    #[test]
    fn intervals_hold_the_exact_state_for_as_long_as_they_go() {
        let mut exact = sphere();
        let mut enclosed = sphere().map(<Interval as kane_number::Number>::from_rational);
        let mut bounces = 0;
        while let Ok(next) = bounce(known("walton"), &enclosed) {
            enclosed = next;
            exact = bounce(known("walton"), &exact).expect("exact");
            assert!(enclosed.before.vx.contains(&exact.before.vx));
            assert!(enclosed.before.vy.contains(&exact.before.vy));
            assert!(enclosed.before.omega.contains(&exact.before.omega));
            bounces += 1;
        }
        assert_eq!(bounces, 21);
    }

    #[test]
    fn digits_are_those_of_the_relative_error() {
        let number = |p: i64, q: i64| REFERENCE.number(&Rational::new(p.into(), q.into()));
        let exact = number(1, 3);
        // off by a thousandth of itself: three digits
        let off = digits(&(number(1001, 3000), None), Some(&exact));
        assert!((295..=305).contains(&off.right.expect("compared")) && off.certain.is_none());
        // the further end counts, and the width
        let wide = (number(999, 3000), Some(number(1010, 3000)));
        let wide = digits(&wide, Some(&exact));
        assert!((195..=205).contains(&wide.right.expect("compared")));
        assert!((190..=200).contains(&wide.certain.expect("an enclosure")));
        // an enclosure of 0 is certain of nothing
        let zero = digits(&(number(-1, 3), Some(number(1, 3))), None);
        assert_eq!(zero, Digits { right: None, certain: Some(0) });
    }
}
