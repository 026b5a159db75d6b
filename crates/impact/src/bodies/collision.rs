//! A body that meets a fixed obstacle, or another body.

use kane_number::{Number, Ordered as _, Real};

use super::{
    CollideError, Motion, PlanarBody, Wide, half, narrow, narrow_contact, narrow_error,
    narrow_outcome,
};
use crate::{Contact, Impulse, InvalidInput, LawOver, Outcome};

/// A planar collision: a body, and what it meets.
///
/// Both bodies are described in the same frame, y from the second into the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Collision<N> {
    /// The body whose impulse is counted.
    pub body: PlanarBody<N>,
    /// The body that it meets, or `None` for a fixed obstacle.
    pub other: Option<PlanarBody<N>>,
    /// μ ≥ 0, Coulomb's coefficient of friction.
    pub friction: N,
    /// 0 ≤ e ≤ 1, the coefficient of restitution.
    pub restitution: N,
}

/// The outcome of a collision.
#[derive(Clone, Debug, PartialEq)]
pub struct Collided<N> {
    /// What happened at the contact; the impulse is on the first body.
    pub outcome: Outcome<N>,
    /// The motion of the first body afterwards.
    pub after: Motion<N>,
    /// The motion of the second body afterwards, if there is one.
    pub other_after: Option<Motion<N>>,
    /// The change of kinetic energy by part, of both bodies together.
    pub energy: Ledger<N>,
}

/// The change of kinetic energy by part; J, negative for a loss.
///
/// In exact numbers the parts add up to the work of the impulse; in floats take that for the sum,
/// because the parts may cancel.
#[derive(Clone, Debug, PartialEq)]
pub struct Ledger<N> {
    /// Σ m·Δ(v_y²)/2.
    pub normal: N,
    /// Σ m·Δ(v_x²)/2.
    pub tangential: N,
    /// Σ J·Δ(ω²)/2.
    pub rotational: N,
}

impl<N: Number> Ledger<N> {
    /// The change in the tangential and rotational directions together.
    #[must_use]
    pub fn by_friction(&self) -> N {
        self.tangential.clone() + &self.rotational
    }

    /// The change of all kinetic energy.
    #[must_use]
    pub fn total(&self) -> N {
        self.by_friction() + &self.normal
    }

    fn plus(self, other: Self) -> Self {
        Self {
            normal: self.normal + other.normal,
            tangential: self.tangential + other.tangential,
            rotational: self.rotational + other.rotational,
        }
    }

    /// Each part as impulse times mean velocity, the kinetic energy theorem, because the difference
    /// of squares would cancel where little changes.
    fn of(body: &PlanarBody<N>, impulse: &Impulse<N>, after: &Motion<N>) -> Self {
        let (before, [x, y]) = (&body.before, &body.arm);
        let mean = |a: &N, b: &N| half(a.clone() + b);
        let Impulse { tangential, normal } = impulse;
        let torque = x.clone() * normal - y.clone() * tangential;
        Self {
            normal: mean(&before.vy, &after.vy) * normal,
            tangential: mean(&before.vx, &after.vx) * tangential,
            rotational: mean(&before.omega, &after.omega) * torque,
        }
    }
}

impl<N: Number> Collision<N> {
    /// The kinetic energy before, of both bodies; J.
    #[must_use]
    pub fn kinetic_energy(&self) -> N {
        let other = self.other.as_ref().map_or_else(N::zero, PlanarBody::kinetic_energy);
        self.body.kinetic_energy() + other
    }

    /// The same collision in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Collision<M> {
        Collision {
            body: self.body.map(&to),
            other: self.other.as_ref().map(|other| other.map(&to)),
            friction: to(&self.friction),
            restitution: to(&self.restitution),
        }
    }
}

impl<N: Real> Collision<N> {
    /// Gives the contact as a law sees it; every entry is rounded once.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first input outside its domain, or if an entry overflows. Bodies
    /// that move apart have a negative approach speed.
    pub fn contact(&self) -> Result<Contact<N>, InvalidInput<N>> {
        narrow_contact(&self.map(N::widen).contact_here().map_err(narrow_error)?)
    }

    /// α of a contact that does not couple, rounded once; `None` if the slip is zero.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first input outside its domain, or if α overflows.
    pub fn alpha(&self) -> Result<Option<N>, InvalidInput<N>> {
        let contact = self.map(N::widen).contact_here().map_err(narrow_error)?;
        contact.alpha().map(|alpha| narrow("alpha", &alpha)).transpose()
    }

    /// The contact, formed in this number system.
    fn contact_here(&self) -> Result<Contact<N>, InvalidInput<N>> {
        self.body.check()?;
        let ([mut slip, mut normal], mut delassus) = (self.body.velocity(), self.body.delassus());
        if let Some(other) = &self.other {
            other.check()?;
            let [vt, vn] = other.velocity();
            (slip, normal) = (slip - vt, normal - vn);
            delassus = delassus.plus(&other.delassus());
        }
        Contact::new(slip, -normal, delassus, self.friction.clone(), self.restitution.clone())
    }

    /// Collides under a law: the impulse, the motion afterwards, and the energy ledger.
    ///
    /// Exact in exact numbers. In `f64` everything is computed in scaled double-double and rounded
    /// once, so that impulses and velocities are within one ulp wherever the law itself does not
    /// lose more than half of the 106 bits.
    ///
    /// # Errors
    /// [`CollideError`] if the input is invalid, if the law gives no impulse, or if a result leaves
    /// the range of the number system. No NaN is ever returned.
    pub fn collide(&self, law: &dyn LawOver<Wide<N>>) -> Result<Collided<N>, CollideError<N>> {
        let contact = self.map(N::widen).contact_here().map_err(narrow_error)?;
        self.collided(&law.resolve(&contact)?)
    }

    /// What follows of an outcome at the contact, whichever law it is by.
    ///
    /// # Errors
    /// [`CollideError`] if a result leaves the range of the number system.
    pub fn collided(&self, result: &Outcome<Wide<N>>) -> Result<Collided<N>, CollideError<N>> {
        let wide: Collision<Wide<N>> = self.map(N::widen);
        let outcome = narrow_outcome(result)?;
        let opposite = Impulse {
            tangential: -result.impulse.tangential.clone(),
            normal: -result.impulse.normal.clone(),
        };
        let mut after = wide.body.after(&result.impulse);
        let central = wide.body.arm[0].sign().is_equal() == Some(true);
        if wide.other.is_none() && central {
            // the centre is on the normal: it separates as the contact point does
            after.vy = result.separation.clone();
        }
        let mut energy = Ledger::of(&wide.body, &result.impulse, &after);
        let mut other_after = None;
        if let Some(other) = &wide.other {
            let motion = other.after(&opposite);
            energy = energy.plus(Ledger::of(other, &opposite, &motion));
            other_after = Some(narrow_motion(&motion)?);
        }
        Ok(Collided {
            outcome,
            after: narrow_motion(&after)?,
            other_after,
            energy: Ledger {
                normal: narrow("the change of normal energy", &energy.normal)?,
                tangential: narrow("the change of tangential energy", &energy.tangential)?,
                rotational: narrow("the change of rotational energy", &energy.rotational)?,
            },
        })
    }
}

fn narrow_motion<N: Real>(wide: &Motion<Wide<N>>) -> Result<Motion<N>, InvalidInput<N>> {
    Ok(Motion {
        vx: narrow("the tangential velocity after", &wide.vx)?,
        vy: narrow("the normal velocity after", &wide.vy)?,
        omega: narrow("the angular velocity after", &wide.omega)?,
    })
}
