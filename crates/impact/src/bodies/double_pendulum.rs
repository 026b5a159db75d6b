//! Kane's double pendulum, whose tip strikes the floor.

use kane_number::{Number, Real};

use super::{CollideError, Wide, half, narrow, narrow_contact, narrow_error, narrow_outcome};
use crate::invalid::{finite, positive};
use crate::{Contact, Delassus, Impulse, InvalidInput, LawOver, Outcome};

/// A direction in the plane, as cosine and sine.
#[derive(Clone, Debug, PartialEq)]
pub struct Direction<N> {
    /// The cosine.
    pub cos: N,
    /// The sine.
    pub sin: N,
}

impl<N: Number> Direction<N> {
    /// The direction with the tangent t of half its angle: (1 − t²)/(1 + t²) and 2t/(1 + t²).
    ///
    /// Every rational t gives a rational direction, and those are dense.
    #[must_use]
    pub fn of_half_tangent(tangent: &N) -> Self {
        let square = tangent.square();
        let sum = N::one() + &square;
        Self { cos: (N::one() - square) / &sum, sin: tangent.double() / sum }
    }

    /// The direction with the opposite angle.
    #[must_use]
    pub fn mirrored(&self) -> Self {
        Self { cos: self.cos.clone(), sin: -self.sin.clone() }
    }

    /// The same direction in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> Direction<M> {
        Direction { cos: to(&self.cos), sin: to(&self.sin) }
    }
}

/// Two equal uniform rods, hinged to each other and the upper one to the ceiling; SI units.
///
/// Angles are from the vertical. The lower tip moves with
///
/// ```text
/// v_t = l·(cos q1·u1 + cos q2·u2)      v_n = l·(sin q1·u1 + sin q2·u2)
/// ```
///
/// and the inertia is m·l²·[[4/3, cos(q1 − q2)/2], [cos(q1 − q2)/2, 1/3]]. Source: T. R. Kane (1984),
/// as quoted in the literature on the puzzle; original not consulted.
#[derive(Clone, Debug, PartialEq)]
pub struct DoublePendulum<N> {
    /// m > 0 of each rod; kg.
    pub mass: N,
    /// l > 0 of each rod; m.
    pub length: N,
    /// q1 of the upper and q2 of the lower rod.
    pub angles: [Direction<N>; 2],
    /// u1, u2, the angular velocities before; rad/s.
    pub before: [N; 2],
    /// μ ≥ 0, Coulomb's coefficient of friction.
    pub friction: N,
    /// 0 ≤ e ≤ 1, the coefficient of restitution.
    pub restitution: N,
}

/// The outcome of a pendulum's collision.
#[derive(Clone, Debug, PartialEq)]
pub struct Swung<N> {
    /// What happened at the contact.
    pub outcome: Outcome<N>,
    /// u1, u2 afterwards; rad/s.
    pub after: [N; 2],
    /// T⁺/T, the kinetic energy after by before; above one energy was created. One if there was none.
    pub energy_ratio: N,
}

impl<N: Number> DoublePendulum<N> {
    /// m·l²·(4/3, cos(q1 − q2)/2, 1/3), the entries 11, 12 and 22 of the inertia; kg·m².
    fn inertia(&self) -> [N; 3] {
        let [q1, q2] = &self.angles;
        let unit = self.length.square() * &self.mass;
        let third = unit.clone() / (N::one().double() + N::one());
        let cosine = q1.cos.clone() * &q2.cos + q1.sin.clone() * &q2.sin;
        [third.double().double(), half(unit * cosine), third]
    }

    /// The inverse inertia times a generalised impulse; rad/s.
    fn response(&self, [a, b]: [N; 2]) -> [N; 2] {
        let [m11, m12, m22] = self.inertia();
        let determinant = m11.clone() * &m22 - m12.square();
        let first = m22 * &a - m12.clone() * &b;
        let second = m11 * b - m12 * a;
        [first / &determinant, second / determinant]
    }

    /// The rows l·cos and l·sin that map u to the tip's velocity; m.
    fn rows(&self) -> [[N; 2]; 2] {
        let [q1, q2] = &self.angles;
        let scaled = |x: &N| self.length.clone() * x;
        [[scaled(&q1.cos), scaled(&q2.cos)], [scaled(&q1.sin), scaled(&q2.sin)]]
    }

    /// The kinetic energy before; J.
    #[must_use]
    pub fn kinetic_energy(&self) -> N {
        let ([m11, m12, m22], [u1, u2]) = (self.inertia(), &self.before);
        let mixed = (m12 * u1 * u2).double();
        half(m11 * u1.square() + mixed + m22 * u2.square())
    }

    /// u1, u2 after an impulse at the tip; rad/s.
    #[must_use]
    pub fn after(&self, impulse: &Impulse<N>) -> [N; 2] {
        let [t, n] = self.rows();
        let moment = |i: usize| t[i].clone() * &impulse.tangential + n[i].clone() * &impulse.normal;
        let [du1, du2] = self.response([moment(0), moment(1)]);
        [self.before[0].clone() + du1, self.before[1].clone() + du2]
    }

    /// The same pendulum in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> DoublePendulum<M> {
        DoublePendulum {
            mass: to(&self.mass),
            length: to(&self.length),
            angles: [self.angles[0].map(&to), self.angles[1].map(&to)],
            before: [to(&self.before[0]), to(&self.before[1])],
            friction: to(&self.friction),
            restitution: to(&self.restitution),
        }
    }
}

impl<N: Real> DoublePendulum<N> {
    /// Gives the contact as a law sees it; every entry is rounded once.
    ///
    /// # Errors
    /// [`InvalidInput`] for the first input outside its domain, or if an entry overflows.
    pub fn contact(&self) -> Result<Contact<N>, InvalidInput<N>> {
        narrow_contact(&self.map(N::widen).contact_here().map_err(narrow_error)?)
    }

    fn contact_here(&self) -> Result<Contact<N>, InvalidInput<N>> {
        positive("the mass", self.mass.clone())?;
        positive("the length", self.length.clone())?;
        for u in &self.before {
            finite("the angular velocity", u.clone())?;
        }
        let [t, n] = self.rows();
        let dot = |[a, b]: &[N; 2], [x, y]: &[N; 2]| a.clone() * x + b.clone() * y;
        let (from_t, from_n) = (self.response(t.clone()), self.response(n.clone()));
        let delassus = Delassus::new(dot(&t, &from_t), dot(&t, &from_n), dot(&n, &from_n))?;
        let (slip, normal) = (dot(&t, &self.before), dot(&n, &self.before));
        Contact::new(slip, -normal, delassus, self.friction.clone(), self.restitution.clone())
    }

    /// Collides under a law.
    ///
    /// Exact in exact numbers; in `f64` computed in scaled double-double and rounded once.
    ///
    /// # Errors
    /// [`CollideError`] as for [`Collision::collide`](super::Collision::collide).
    pub fn collide(&self, law: &dyn LawOver<Wide<N>>) -> Result<Swung<N>, CollideError<N>> {
        let contact = self.map(N::widen).contact_here().map_err(narrow_error)?;
        self.swung(&law.resolve(&contact)?)
    }

    /// What follows of an outcome at the contact, whichever law it is by.
    ///
    /// # Errors
    /// [`CollideError`] if a result leaves the range of the number system.
    pub fn swung(&self, result: &Outcome<Wide<N>>) -> Result<Swung<N>, CollideError<N>> {
        let wide: DoublePendulum<Wide<N>> = self.map(N::widen);
        let outcome = narrow_outcome(result)?;
        let [u1, u2] = wide.after(&result.impulse);
        let one = <Wide<N> as Number>::one();
        let change = result.work.total().checked_div(&wide.kinetic_energy());
        let ratio = change.map_or_else(|| one.clone(), |change| one.clone() + change);
        Ok(Swung {
            outcome,
            after: [
                narrow("the angular velocity after", &u1)?,
                narrow("the angular velocity after", &u2)?,
            ],
            energy_ratio: narrow("the ratio of energies", &ratio)?,
        })
    }
}
