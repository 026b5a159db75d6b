//! What resolves an impact: a law, or a process.

use kane_impact::Lasting as Shape;
use kane_impact::compliant::{
    self, Bilinear, Compliance, DimensionReduction, Loss, MawBarberFawcett, SpringDashpot,
};
use kane_impact::{Alpha, Contact, Delassus, Impulse, Law, NoImpulse, NumberSystem, Outcome, Work};
use kane_number::{Interval, Number as _, Ordered as _, Rational, Real, System};

use crate::coordinate::{Coordinate, half};

/// Something that gives the outcome of an impact, in a number system.
pub trait Resolver<N> {
    /// The outcome at a contact.
    ///
    /// # Errors
    /// [`NoImpulse`] where it has none, or the number system cannot tell.
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse>;

    /// What it makes of the slip of a ball that comes to rest, whose next impact is this one; the
    /// contact does not couple.
    fn lasting(&self, next: &Contact<N>) -> Lasting<N>;

    /// Whether it turns the axes of a contact, which says nothing where these are not in one plane.
    fn turns(&self, _: &Contact<N>) -> bool {
        false
    }
}

/// What becomes of the slip through infinitely many impacts, each with e times the approach of the
/// one before.
#[derive(Clone, Debug, PartialEq)]
pub enum Lasting<N> {
    /// There is no friction.
    Without,
    /// Friction acts in full against the slip while α is no greater than this, unless it stops the
    /// slip; without slip there is none.
    Full {
        /// At least the α at which full friction just stops the slip, 1/2, or less.
        up_to: N,
    },
    /// Friction acts in full, or else every impact gives this share of the slip back.
    Share(N),
    /// Not in closed form while there is slip; without slip there is no friction.
    Unsummed,
}

impl<N: NumberSystem> Resolver<N> for Law {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        self.over().resolve(contact)
    }

    fn lasting(&self, _: &Contact<N>) -> Lasting<N> {
        match (self.info.model.map(|model| model.lasting), &self.parameters()[..]) {
            (Some(Shape::Full), _) => Lasting::Full { up_to: half(N::one()) },
            (Some(Shape::Share), [(_, share)]) => Lasting::Share(N::from_rational(share)),
            _ => Lasting::Unsummed,
        }
    }

    fn turns(&self, contact: &Contact<N>) -> bool {
        self.over().frame(contact).is_some()
    }
}

/// No tangential impulse: one dimension. It looks at no slip, so that none need be decided.
#[derive(Clone, Copy, Debug)]
pub struct NormalOnly;

impl<N, R: Resolver<N> + ?Sized> Resolver<N> for &R {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        (**self).resolve(contact)
    }

    fn lasting(&self, next: &Contact<N>) -> Lasting<N> {
        (**self).lasting(next)
    }

    fn turns(&self, contact: &Contact<N>) -> bool {
        (**self).turns(contact)
    }
}

impl<N: Real> Resolver<N> for NormalOnly {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        let normal = contact.closing() / contact.delassus().nn();
        Ok(with_impulse("no friction", contact, Impulse { tangential: N::zero(), normal }))
    }

    fn lasting(&self, _: &Contact<N>) -> Lasting<N> {
        Lasting::Without
    }
}

fn with_impulse<N: Real>(
    regime: &'static str,
    contact: &Contact<N>,
    impulse: Impulse<N>,
) -> Outcome<N> {
    let slip = contact.slip_after(&impulse);
    let separation = contact.restitution().clone() * contact.approach();
    let work = Work {
        normal: half((separation.clone() - contact.approach()) * &impulse.normal),
        tangential: half((slip.clone() + contact.slip()) * &impulse.tangential),
    };
    Outcome { regime, impulse, slip, separation, work }
}

/// Which compliant process follows an elastic contact that does not slide all the time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Process {
    /// An elastic half-space, as a row of springs.
    DimensionReduction,
    /// The same half-space, annulus by annulus: hundreds of times as costly.
    MawBarberFawcett,
    /// Stronge's pair of springs.
    Bilinear,
}

impl Process {
    /// Its name in tables.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::DimensionReduction => "dimension-reduction",
            Self::MawBarberFawcett => "maw-barber-fawcett",
            Self::Bilinear => "stronge-bilinear",
        }
    }

    /// Its answer at α = `W_tt`·μ·(1 + e)·a/(2·`W_nn`·`v_t`) > 0, with the process's own estimate of the
    /// error of k, for a choice of what e < 1 means and a grid so many times finer than the default.
    /// Annuli follow [`Loss::Recoil`] on their default grid, whatever is asked.
    ///
    /// # Errors
    /// [`NoOutcome`](compliant::NoOutcome).
    pub fn outcome(
        self,
        compliance: Compliance,
        loss: Loss,
        finer: usize,
        alpha: f64,
    ) -> Result<compliant::Outcome, compliant::NoOutcome> {
        use compliant::Process as _;
        let alpha = Alpha::Finite(alpha);
        match (self, loss) {
            (Self::DimensionReduction, _) => {
                let [springs, steps] = [DimensionReduction::SPRINGS, DimensionReduction::STEPS]
                    .map(|usual| usual.saturating_mul(finer));
                DimensionReduction::damped(compliance, loss, springs, steps)?.outcome(&alpha)
            }
            (Self::MawBarberFawcett, _) => MawBarberFawcett::new(compliance).outcome(&alpha),
            (Self::Bilinear, Loss::Recoil) => Bilinear::new(compliance).outcome(&alpha),
            (Self::Bilinear, _) => SpringDashpot::new(compliance)?.outcome(&alpha),
        }
    }

    /// The other choices of what e < 1 means, which the process, or the same theory by other means,
    /// can follow.
    const fn other_losses(self) -> (Self, &'static [Loss]) {
        match self {
            Self::DimensionReduction | Self::MawBarberFawcett => {
                (Self::DimensionReduction, &[Loss::Tsuji, Loss::Linear])
            }
            Self::Bilinear => (Self::Bilinear, &[Loss::Linear]),
        }
    }
}

/// An elastic contact: sliding all the time where that is documented, and a process elsewhere.
///
/// χ = κ·`W_tt`/(2·`W_nn`). Maw, Barber and Fawcett (1976), for e = 1 and 2χ ≥ 1: sliding all the time for
/// ψ₁ > 4χ − 1, that is α < 2χ/(4χ − 1), which is at least 1/2. In all the processes a contact starts
/// without slip for α > (1 + e)·χ. Bounds taken here: Maw's where it holds, else the lesser of 1/2, up
/// to which what slides at first slides on, and (1 + e)·χ.
#[derive(Clone, Debug)]
pub struct Elastic {
    /// κ > 0, the tangential by the normal stiffness: 2·(1 − ν)/(2 − ν) of an elastic half-space.
    pub stiffness_ratio: Rational,
    /// What answers beyond sliding.
    pub process: Process,
    /// What e < 1 means, if that is stated. Else it is [`Loss::Recoil`], and how far the other choices
    /// are from it counts as an error of the model.
    pub loss: Option<Loss>,
    /// How many times finer the grid is than by default; at least 1.
    pub finer: usize,
}

impl Elastic {
    /// The α below which the contact certainly slides all the time.
    #[must_use]
    pub fn slides_up_to<N: Real>(&self, contact: &Contact<N>) -> N {
        let w: &Delassus<N> = contact.delassus();
        let one = N::one();
        let twice = N::from_rational(&self.stiffness_ratio) * w.tt() / w.nn();
        let lossless = (one.clone() - contact.restitution()).sign().is_equal() == Some(true);
        if lossless && twice.compare(&one).is_at_least() == Some(true) {
            return twice.clone() / (twice.double() - one);
        }
        let sticks = half(twice * (one.clone() + contact.restitution()));
        let bound = half(one);
        if sticks.compare(&bound).is_at_least() == Some(true) { bound } else { sticks }
    }

    /// The k of the other choices of what e < 1 means, where that is not stated.
    pub(crate) fn other_choices(&self, compliance: Compliance, alpha: f64) -> Vec<(Loss, f64)> {
        if self.loss.is_some() || compliance.restitution() == 1.0 {
            return Vec::new();
        }
        let (process, others) = self.process.other_losses();
        // an e that no damper gives leaves no choice
        let found = others.iter().filter_map(|loss| {
            let alpha = Alpha::Finite(alpha);
            let k = match process {
                Process::Bilinear => SpringDashpot::new(compliance).ok()?.k(&alpha).ok()?,
                _ => {
                    let [springs, steps] = [DimensionReduction::SPRINGS, DimensionReduction::STEPS];
                    let process = DimensionReduction::damped(compliance, *loss, springs, steps);
                    process.ok()?.observe(&alpha, &mut |_| ()).ok()?.0.k
                }
            };
            Some((*loss, k))
        });
        found.collect()
    }

    /// χ and e of a contact, in floats; `None` outside their domain.
    pub(crate) fn compliance(&self, contact: &Contact<Interval>) -> Option<Compliance> {
        let mobility = (*contact.delassus().tt() / contact.delassus().nn()).midpoint();
        let kappa = Interval::from_rational(&self.stiffness_ratio).midpoint();
        let e = contact.restitution().midpoint();
        Compliance::of_springs(mobility, kappa.recip(), e).ok()
    }
}

/// What is said of an impact that a process followed.
pub(crate) const COMPLIANT: &str = "compliant";

const BEYOND: NoImpulse = NoImpulse::Outside {
    law: "elastic contact",
    reason: "the compliant process came to no end within its budget",
};

impl Elastic {
    /// The outcome, with what it may be off by where `bounding`; who wants the middle alone saves the
    /// other choices of what e < 1 means.
    fn enclose(
        &self,
        contact: &Contact<Interval>,
        bounding: bool,
    ) -> Result<Outcome<Interval>, NoImpulse> {
        let sign = contact.slip().sign();
        if sign.is_equal() == Some(true) {
            return NormalOnly.resolve(contact);
        }
        let law = "elastic contact";
        let undecided = NoImpulse::Undecided { law, regime: "forward or backward slip" };
        let forward = sign.is_greater().filter(|forward| *forward || sign.is_less() == Some(true));
        let forward = forward.ok_or(undecided)?;
        let alpha = contact.alpha().ok_or(undecided)?;
        let alpha = if forward { alpha } else { -alpha };
        let normal = contact.closing() / contact.delassus().nn();
        let limit = self.slides_up_to(contact);
        let compliance = self.compliance(contact).ok_or(BEYOND)?;
        // how far another choice is from this k
        let choice = |alpha: f64, k: f64| {
            let others = if bounding { self.other_choices(compliance, alpha) } else { Vec::new() };
            others.iter().map(|(_, other)| (other - k).abs()).fold(0.0, f64::max)
        };
        let documented =
            matches!(self.loss, None | Some(Loss::Recoil)) || compliance.restitution() == 1.0;
        if documented && alpha.compare(&limit).is_at_most() == Some(true) {
            let friction = normal * contact.friction();
            let tangential = if forward { -friction } else { friction };
            let mut outcome = with_impulse("slide", contact, Impulse { tangential, normal });
            // a damper's force is there too soon for the contact to slide at once
            let error = [alpha.lower(), alpha.upper()]
                .map(|alpha| choice(alpha, alpha.mul_add(-2.0, 1.0)))
                .into_iter()
                .fold(0.0, f64::max);
            if error > 0.0 {
                let more = Interval::between(-error, error) * contact.slip();
                outcome.slip = outcome.slip + more;
                let tangential = outcome.impulse.tangential + more / contact.delassus().tt();
                outcome.impulse.tangential = tangential;
                outcome.work.tangential = half((outcome.slip + contact.slip()) * tangential);
            }
            return Ok(outcome);
        }
        let process = self.process;
        // k is not monotone in α: a box of states is answered at a point alone
        if alpha.width() > 1e-9 * alpha.midpoint() {
            return Err(NoImpulse::Undecided { law: process.id(), regime: "over the uncertainty" });
        }
        let loss = self.loss.unwrap_or(Loss::Recoil);
        let found = process.outcome(compliance, loss, self.finer, alpha.midpoint());
        let found = found.map_err(|_| BEYOND)?;
        let k = found.ratios.k;
        let error = found.error + choice(alpha.midpoint(), k);
        let k = Interval::between(k - error, k + error);
        let slip = k * contact.slip();
        let tangential = (slip - contact.slip()) / contact.delassus().tt();
        let mut outcome = with_impulse(COMPLIANT, contact, Impulse { tangential, normal });
        outcome.slip = slip;
        Ok(outcome)
    }
}

impl<N: Coordinate> Resolver<N> for Elastic {
    fn resolve(&self, contact: &Contact<N>) -> Result<Outcome<N>, NoImpulse> {
        let found =
            self.enclose(&contact.map(Coordinate::enclosed), N::SYSTEM == System::Interval)?;
        let lost = || NoImpulse::Unrepresentable { law: "elastic contact", regime: found.regime };
        let of = |x: &Interval| N::of_enclosure(*x).ok_or_else(lost);
        Ok(Outcome {
            regime: found.regime,
            impulse: Impulse {
                tangential: of(&found.impulse.tangential)?,
                normal: of(&found.impulse.normal)?,
            },
            slip: of(&found.slip)?,
            separation: of(&found.separation)?,
            work: Work { normal: of(&found.work.normal)?, tangential: of(&found.work.tangential)? },
        })
    }

    fn lasting(&self, next: &Contact<N>) -> Lasting<N> {
        // of ever smaller α, so that the difference between the choices is that of the first at most
        match self.loss {
            None | Some(Loss::Recoil) => Lasting::Full { up_to: self.slides_up_to(next) },
            Some(_) => Lasting::Unsummed,
        }
    }
}
