//! Two linear springs and a Coulomb slider, in closed form.

use std::f64::consts::{FRAC_PI_2, PI};

use super::march::{Ledger, Moment, bound};
use super::{Compliance, Grip, NoOutcome, Outcome, Process, checked, grazing};
use crate::{Alpha, Ratios};

/// Stronge's pair of springs, a normal one with energetic restitution and a tangential one that
/// Coulomb's cone cuts (id `stronge-bilinear`).
///
/// With the normal frequency 1, in compression F = sin t, in restitution F = cos((t − π/2)/e); the
/// tangential spring follows g' = y while it sticks, and has χ = j_p/(2·η²) for the ratio η² of the
/// normal by the tangential stiffness.
///
/// ```text
/// stick  y = y0·cos wt − w·g0·sin wt    g = g0·cos wt + (y0/w)·sin wt    w² = 2χ
/// slip   g = ±λ·F                       y = y0 ∓ 2χ·λ·∫F dt
/// ```
///
/// Slip ends in closed form; stick ends at the first root of λ·F = |g|, which is bracketed by steps
/// that a bound of the second derivative keeps short of it. k is continuous in α, 1 − 2α while
/// sliding lasts, and tends to cos(w·(1 + e)·π/2) in normal collision. With χ = 1/2 and e = 1 it is
/// max(−1, 1 − 2α), Garwin's law with Coulomb's bound.
///
/// *Heuristic*, as good as rounding: the cone is let pass by 1e-13 of the greatest force before a
/// piece ends.
///
/// Source: W. J. Stronge, Int. J. Impact Eng. 15 (1994) 435–450, and *Impact Mechanics* (2000), from
/// memory; originals not consulted. The pieces are derived here.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bilinear {
    compliance: Compliance,
}

/// A part of the collision during which the contact does one thing. Dimensionless, as [`Moment`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// What the contact does.
    pub grip: Grip,
    leg: Leg,
    /// From and to, on the leg's clock.
    from: f64,
    to: f64,
    slip: f64,
    friction: f64,
    chi: f64,
    cone: f64,
}

/// Compression or restitution, each a quarter period on a clock of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Leg {
    start: f64,
    /// Real time by the clock: 1 or e.
    rate: f64,
    /// F' at the start: 1 or 0.
    rise: f64,
}

impl Leg {
    /// F.
    fn force(self, clock: f64) -> f64 {
        if self.rise == 1.0 { clock.sin() } else { clock.cos() }
    }

    /// ∫F up to here on the clock, 1 − cos or sin, so that F' = rise − ∫F.
    fn impulse(self, clock: f64) -> f64 {
        if self.rise == 1.0 { 2.0 * (clock / 2.0).sin().powi(2) } else { clock.sin() }
    }

    /// When that impulse is reached, if it is on this leg.
    fn when(self, impulse: f64) -> Option<f64> {
        if !(0.0..=1.0).contains(&impulse) {
            return None;
        }
        let clock = match self.rise == 1.0 {
            true => 2.0 * (impulse / 2.0).sqrt().asin(),
            false => impulse.asin(),
        };
        Some(clock.min(FRAC_PI_2))
    }
}

/// y and g.
type State = (f64, f64);

/// Excess over the cone that is let pass, by the greatest force; it keeps rounding from making
/// events where spring and cone are proportional.
const PASSED: f64 = 1e-13;
/// The most pieces, and the most steps towards an event, of one collision.
const MOST_PIECES: usize = 10_000;
const MOST_STEPS: usize = 10_000_000;
/// The shortest step towards an event, by the quarter of the shorter period. An excursion beyond
/// the cone that is over within one is passed over; it is at most a 1e-7th of the greatest force.
const SHORTEST: f64 = 1.0 / 4096.0;

impl Piece {
    /// When the piece starts; in units of the inverse normal frequency.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.leg.start + self.leg.rate * self.from
    }

    /// When it ends.
    #[must_use]
    pub fn end(&self) -> f64 {
        self.leg.start + self.leg.rate * self.to
    }

    /// The state at a share of the piece, from 0 to 1.
    #[must_use]
    pub fn at(&self, share: f64) -> Moment {
        let clock = self.from + (self.to - self.from) * share;
        let (slip, friction) = self.state(clock);
        Moment {
            time: self.leg.start + self.leg.rate * clock,
            normal: self.leg.force(clock),
            friction: friction / self.cone,
            slip,
        }
    }

    fn state(&self, clock: f64) -> State {
        match self.grip {
            Grip::Stick => {
                let (w, time) = (self.frequency(), self.leg.rate * (clock - self.from));
                let (sin, cos) = (w * time).sin_cos();
                (
                    self.slip * cos - w * self.friction * sin,
                    self.friction * cos + self.slip / w * sin,
                )
            }
            grip => {
                let g = grip.sign() * bound(self.cone, self.leg.force(clock));
                (self.slip - 2.0 * self.chi * self.impulse(clock), g)
            }
        }
    }

    fn frequency(&self) -> f64 {
        (2.0 * self.chi).sqrt()
    }

    /// ∫g dt up to here.
    fn impulse(&self, clock: f64) -> f64 {
        if self.grip == Grip::Stick {
            let (w, time) = (self.frequency(), self.leg.rate * (clock - self.from));
            let half = (w * time / 2.0).sin();
            return self.friction * (w * time).sin() / w + 2.0 * half * half * self.slip / (w * w);
        }
        let given = self.leg.impulse(clock) - self.leg.impulse(self.from);
        self.grip.sign() * self.cone * self.leg.rate * given
    }

    /// −∫g·y dt over the piece; g' = y while it sticks, and y is linear in the impulse while it
    /// slides.
    fn work(&self) -> f64 {
        let (slip, friction) = self.state(self.to);
        match self.grip {
            Grip::Stick => -(friction - self.friction) * (friction + self.friction) / 2.0,
            _ => -self.impulse(self.to) * (self.slip + slip) / 2.0,
        }
    }

    /// The end of slip, where the spring alone would follow: ±y = λ·F', linear in ∫F.
    fn slip_ends(&self) -> Option<f64> {
        let (leg, rate, sign) = (self.leg, self.leg.rate, self.grip.sign());
        let before = leg.impulse(self.from);
        let twice = 2.0 * self.chi * rate;
        let growth = self.cone * (1.0 / rate - twice);
        let now = sign * self.slip - self.cone * (leg.rise - before) / rate;
        if now <= 0.0 && growth <= 0.0 {
            return Some(self.from);
        }
        if growth >= 0.0 {
            return None;
        }
        leg.when(before - now / growth)
    }

    /// The end of stick, with the way that the contact slides then.
    fn stick_ends(&self, steps: &mut usize) -> Result<Option<(f64, Grip)>, NoOutcome> {
        if self.cone == f64::INFINITY {
            return Ok(None);
        }
        let (w, rate) = (self.frequency(), self.leg.rate);
        let amplitude = self.friction.hypot(self.slip / w);
        let passed = PASSED * amplitude.min(self.cone);
        let curvature = self.cone + w * w * rate * rate * amplitude;
        let shortest = FRAC_PI_2 * SHORTEST / (w * rate).max(1.0);
        // what is left up to the cone on either side, and its rate of change
        let left = |clock: f64| {
            let (y, g) = self.state(clock);
            let edge = self.cone * self.leg.force(clock) + passed;
            let widens = self.cone * (self.leg.rise - self.leg.impulse(clock));
            [(edge - g, widens - rate * y), (edge + g, widens + rate * y)]
        };
        let mut here = self.from;
        let mut now = left(here);
        while here < self.to {
            *steps += 1;
            if *steps > MOST_STEPS {
                return Err(NoOutcome::TooManyEvents(MOST_STEPS));
            }
            // left + change·d − curvature·d²/2 ≥ 0 up to here
            let safe = |(left, change): (f64, f64)| {
                let left = left.max(0.0);
                (change + (change * change + 2.0 * curvature * left).sqrt()) / curvature
            };
            let step = safe(now[0]).min(safe(now[1])).max(shortest);
            let next = (here + step).min(self.to);
            let then = left(next);
            for (side, grip) in [(0, Grip::Forward), (1, Grip::Backward)] {
                if then[side].0 < 0.0 {
                    return Ok(Some((bisect(here, next, |clock| left(clock)[side].0), grip)));
                }
            }
            (here, now) = (next, then);
        }
        Ok(None)
    }
}

/// Where a function turns negative, to rounding.
fn bisect(mut lower: f64, mut upper: f64, function: impl Fn(f64) -> f64) -> f64 {
    loop {
        let middle = lower + (upper - lower) / 2.0;
        if middle <= lower || middle >= upper {
            return upper;
        }
        if function(middle) < 0.0 {
            upper = middle;
        } else {
            lower = middle;
        }
    }
}

impl Bilinear {
    /// The springs of a compliance; see [`Compliance::of_springs`].
    #[must_use]
    pub const fn new(compliance: Compliance) -> Self {
        Self { compliance }
    }

    /// k in normal collision, cos(√(2χ)·(1 + e)·π/2).
    #[must_use]
    pub fn normal_collision(&self) -> f64 {
        let w = (2.0 * self.compliance.chi()).sqrt();
        (w * (1.0 + self.compliance.restitution()) * FRAC_PI_2).cos()
    }

    /// The collision piece by piece.
    ///
    /// # Errors
    /// [`NoOutcome`], see [`outcome`](Process::outcome).
    pub fn pieces(&self, alpha: &Alpha<f64>) -> Result<Vec<Piece>, NoOutcome> {
        self.walk(checked(alpha)?)
    }

    fn walk(&self, alpha: f64) -> Result<Vec<Piece>, NoOutcome> {
        let (chi, e) = (self.compliance.chi(), self.compliance.restitution());
        let cone = self.compliance.cone(alpha);
        let mut pieces: Vec<Piece> = Vec::new();
        let (mut slip, mut friction) = (1.0, 0.0);
        let mut grip = if cone < 1.0 { Grip::Forward } else { Grip::Stick };
        let mut steps = 0;
        let compression = Leg { start: 0.0, rate: 1.0, rise: 1.0 };
        let restitution = Leg { start: FRAC_PI_2, rate: e, rise: 0.0 };
        for leg in [compression, restitution] {
            if leg.rate == 0.0 {
                continue;
            }
            let mut from = 0.0;
            while from < FRAC_PI_2 {
                if pieces.len() == MOST_PIECES {
                    return Err(NoOutcome::TooManyEvents(MOST_PIECES));
                }
                let mut piece = Piece { grip, leg, from, to: FRAC_PI_2, slip, friction, chi, cone };
                let event = match grip {
                    Grip::Stick => piece.stick_ends(&mut steps)?,
                    _ => piece.slip_ends().map(|end| (end, Grip::Stick)),
                };
                if let Some((end, next)) = event {
                    (piece.to, grip) = (end, next);
                }
                (slip, friction) = piece.state(piece.to);
                from = piece.to;
                pieces.push(piece);
            }
        }
        Ok(pieces)
    }

    /// Over pieces: kinetic energy is y²/(4χ), that of the spring g²/2.
    fn ledger(pieces: &[Piece]) -> Ledger {
        let mut ledger = Ledger { steps: pieces.len(), created: Some(0.0), ..Ledger::default() };
        for piece in pieces {
            let (y, g) = piece.state(piece.to);
            let energy = |y: f64, g: f64| y * y + 2.0 * piece.chi * g * g;
            let rise = energy(y, g) - energy(piece.slip, piece.friction);
            ledger.created = ledger.created.map(|created| created + rise.max(0.0));
            ledger.above_start = ledger.above_start.max(y * y - 1.0);
            let excess = g.abs() - bound(piece.cone, piece.leg.force(piece.to));
            if excess > 0.0 {
                ledger.beyond_cone = ledger.beyond_cone.max(excess / piece.cone);
            }
        }
        ledger
    }
}

impl Process for Bilinear {
    fn id(&self) -> &'static str {
        "stronge-bilinear"
    }

    fn source(&self) -> &'static str {
        "W. J. Stronge, Int. J. Impact Eng. 15 (1994) 435-450, and Impact Mechanics (2000), from memory; originals not consulted"
    }

    fn compliance(&self) -> &Compliance {
        &self.compliance
    }

    fn outcome(&self, alpha: &Alpha<f64>) -> Result<Outcome, NoOutcome> {
        let alpha = checked(alpha)?;
        if alpha == 0.0 {
            let ledger = Ledger { created: Some(0.0), ..Ledger::default() };
            return Ok(Outcome { ratios: grazing(), error: 0.0, ledger });
        }
        let pieces = self.walk(alpha)?;
        let k = pieces.last().map_or(1.0, |piece| piece.state(piece.to).0);
        let (mut impulse, mut work) = (0.0, 0.0);
        for piece in &pieces {
            impulse += piece.impulse(piece.to);
            work += piece.work();
        }
        let whole = self.compliance.cone(alpha) * (1.0 + self.compliance.restitution());
        let ratios = Ratios { k, impulse: impulse / whole, energy: work / whole };
        // a force off by `PASSED`·amplitude during the whole collision, once a piece
        let w = (2.0 * self.compliance.chi()).sqrt();
        let error = PASSED * PI * w.max(1.0) * super::hertz::to_float(pieces.len());
        Ok(Outcome { ratios, error, ledger: Self::ledger(&pieces) })
    }
}
