//! Kane's puzzle as data: where in the plane of friction and restitution a law creates energy.
//!
//! Kane's was a double pendulum; the tip of a rod will do, and any contact that couples.

use kane_number::{Algebraic, Number, Ordered as _, Rational};

use crate::bodies::DoublePendulum;
use crate::{Contact, InvalidInput, Law, NoImpulse};

/// A stretch of friction coefficients, at one restitution, in which a law creates energy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gain {
    /// e
    pub restitution: Rational,
    /// The least μ of the stretch: energy does not rise there, and does within [`RESOLUTION`]
    /// above; zero if it rises for the least friction looked at.
    pub from: Rational,
    /// The end of the stretch, likewise; `None` if it lasts to [`MOST_FRICTION`].
    pub to: Option<Rational>,
}

/// How finely the ends of a stretch are located: 2⁻¹⁶.
pub const RESOLUTION: u32 = 16;

/// The largest μ looked at.
pub const MOST_FRICTION: i32 = 2;

/// Steps of μ between zero and [`MOST_FRICTION`]; a stretch shorter than one may be missed.
const STEPS: i32 = 50;

/// A contact of which friction and restitution vary: the tip of a pendulum, of a rod, of any body.
#[derive(Clone, Debug)]
pub struct Tip {
    contact: Contact<Rational>,
}

impl Tip {
    /// The tip of the pendulum.
    ///
    /// # Errors
    /// [`InvalidInput`] if the pendulum has no contact.
    pub fn of(pendulum: &DoublePendulum<Rational>) -> Result<Self, InvalidInput<Rational>> {
        Ok(Self { contact: pendulum.contact()? })
    }

    /// The contact of any body; its own friction and restitution do not matter.
    #[must_use]
    pub const fn touching(contact: Contact<Rational>) -> Self {
        Self { contact }
    }

    /// The contact with another friction and restitution; both must be in their domains.
    ///
    /// # Errors
    /// [`InvalidInput`] if they are not.
    pub fn with(
        &self,
        friction: &Rational,
        restitution: &Rational,
    ) -> Result<Contact<Rational>, InvalidInput<Rational>> {
        let (slip, approach) = (self.contact.slip().clone(), self.contact.approach().clone());
        let delassus = self.contact.delassus().clone();
        Contact::new(slip, approach, delassus, friction.clone(), restitution.clone())
    }

    /// Whether a law creates energy, decided exactly. Where the law has no outcome it creates none.
    ///
    /// # Errors
    /// [`InvalidInput`] for a friction or restitution outside its domain.
    pub fn gains(
        &self,
        law: &Law,
        friction: &Rational,
        restitution: &Rational,
    ) -> Result<bool, InvalidInput<Rational>> {
        let contact = self.with(friction, restitution)?;
        Ok(match law.over().resolve(&contact) {
            Ok(outcome) => outcome.work.total().sign().is_greater() == Some(true),
            Err(NoImpulse::Unrepresentable { .. }) => {
                let exact = contact.map(|x| Algebraic::from(x.clone()));
                law.over()
                    .resolve(&exact)
                    .is_ok_and(|outcome| outcome.work.total().sign().is_greater() == Some(true))
            }
            Err(_) => false,
        })
    }

    /// The stretches of μ in which a law creates energy at the given restitution, by looking at 50
    /// frictions up to [`MOST_FRICTION`] and bisecting between those that differ; each sign is
    /// decided exactly.
    ///
    /// # Errors
    /// [`InvalidInput`] for a restitution outside its domain.
    pub fn stretches(
        &self,
        law: &Law,
        restitution: &Rational,
    ) -> Result<Vec<Gain>, InvalidInput<Rational>> {
        let at = |step: i32| Rational::new((step * MOST_FRICTION).into(), STEPS.into());
        let mut stretches: Vec<Gain> = Vec::new();
        let mut gained = self.gains(law, &Rational::zero(), restitution)?;
        let mut from = gained.then(Rational::zero);
        for step in 1..=STEPS {
            let gains = self.gains(law, &at(step), restitution)?;
            if gains != gained {
                let border = self.border(law, restitution, at(step - 1), at(step), gained)?;
                match from.take() {
                    None => from = Some(border),
                    Some(start) => stretches.push(Gain {
                        restitution: restitution.clone(),
                        from: start,
                        to: Some(border),
                    }),
                }
            }
            gained = gains;
        }
        if let Some(from) = from {
            stretches.push(Gain { restitution: restitution.clone(), from, to: None });
        }
        Ok(stretches)
    }

    /// Bisects between a lower μ where energy rises, or not, and an upper one where it is otherwise.
    fn border(
        &self,
        law: &Law,
        restitution: &Rational,
        mut lower: Rational,
        mut upper: Rational,
        gains_below: bool,
    ) -> Result<Rational, InvalidInput<Rational>> {
        for _ in 0..RESOLUTION {
            let middle = (&lower + &upper) / Rational::from_integer(2.into());
            if self.gains(law, &middle, restitution)? == gains_below {
                lower = middle;
            } else {
                upper = middle;
            }
        }
        Ok(lower)
    }
}
