//! A sphere that meets a fixed plane, in the paper's notation.

use kane_number::{Number, Real};

use super::{CollideError, Collided, Collision, Ledger, Motion, PlanarBody, Wide};
use crate::invalid::positive;
use crate::{Contact, InvalidInput, LawOver, Work};

/// A sphere (or a disc) at the moment it touches a fixed plane; SI units, signs as in the crate docs.
///
/// Plain data: [`contact`](Self::contact) and [`collide`](Self::collide) check it.
#[derive(Clone, Debug, PartialEq)]
pub struct SphereOnPlane<N> {
    /// m > 0, kg.
    pub mass: N,
    /// r > 0, m.
    pub radius: N,
    /// J > 0, the moment of inertia about the centre of mass, kg·m² (solid sphere: 2/5·m·r²).
    pub inertia: N,
    /// μ ≥ 0, Coulomb's coefficient of friction.
    pub friction: N,
    /// 0 ≤ e ≤ 1, the coefficient of normal restitution.
    pub restitution: N,
    /// The motion before the collision, with v_y0 ≥ 0 into the plane; v_y0 = 0 is grazing. ω is
    /// positive if it moves the contact point against x.
    pub before: Motion<N>,
}

/// The outcome of a sphere's collision, in the paper's notation.
#[derive(Clone, Debug, PartialEq)]
pub struct Rebound<N> {
    /// The name of the regime that applied.
    pub regime: &'static str,
    /// I_y ≥ 0, N·s.
    pub normal_impulse: N,
    /// I_x, of the sign of the slip before, N·s.
    pub tangential_impulse: N,
    /// v_x − ω·r after the collision; m/s.
    pub slip: N,
    /// The motion after the collision.
    pub after: Motion<N>,
    /// The change of kinetic energy by part.
    pub energy: Ledger<N>,
    /// The same by impulse: what friction and what restitution took.
    pub work: Work<N>,
}

impl<N: Number> SphereOnPlane<N> {
    /// The same collision in the signs of mechanics, where y is out of the plane and ω counts from
    /// x to y.
    #[must_use]
    pub fn collision(&self) -> Collision<N> {
        Collision {
            body: PlanarBody {
                mass: self.mass.clone(),
                inertia: self.inertia.clone(),
                arm: [N::zero(), -self.radius.clone()],
                before: upright(&self.before),
            },
            other: None,
            friction: self.friction.clone(),
            restitution: self.restitution.clone(),
        }
    }

    /// The same sphere in another number system.
    pub fn map<M>(&self, to: impl Fn(&N) -> M) -> SphereOnPlane<M> {
        SphereOnPlane {
            mass: to(&self.mass),
            radius: to(&self.radius),
            inertia: to(&self.inertia),
            friction: to(&self.friction),
            restitution: to(&self.restitution),
            before: self.before.map(&to),
        }
    }
}

/// Between the paper's y, into the plane, and ours.
fn upright<N: Number>(motion: &Motion<N>) -> Motion<N> {
    let Motion { vx, vy, omega } = motion.clone();
    Motion { vx, vy: -vy, omega: -omega }
}

impl<N: Real> SphereOnPlane<N> {
    /// Gives the contact as a law sees it, each entry rounded once:
    ///
    /// ```text
    /// v_t = v_x0 − ω0·r    a = v_y0    W_tt = 1/m + r²/J    W_tn = 0    W_nn = 1/m
    /// ```
    ///
    /// # Errors
    /// [`InvalidInput`] for the first input outside its domain, or if an entry overflows.
    pub fn contact(&self) -> Result<Contact<N>, InvalidInput<N>> {
        positive("the radius", self.radius.clone())?;
        self.collision().contact()
    }

    /// α = j_p·μ·I_y/(2·m·v_t), rounded once, with the sign of the slip; `None` if the slip is zero.
    ///
    /// Source: Wang, Su, Li, equation (7).
    ///
    /// # Errors
    /// [`InvalidInput`] for the first input outside its domain, or if α overflows.
    pub fn alpha(&self) -> Result<Option<N>, InvalidInput<N>> {
        self.collision().alpha()
    }

    /// Collides under a law: impulses, the motion afterwards, and the energy ledger.
    ///
    /// ```text
    /// v_y = −e·v_y0    v_x = v_x0 − I_x/m    ω = ω0 + r·I_x/J
    /// ```
    ///
    /// Exact in exact numbers; in `f64` computed in scaled double-double and rounded once, see
    /// [`Collision::collide`].
    ///
    /// # Errors
    /// [`CollideError`] if the input is invalid, if the law gives no impulse, or if a result leaves
    /// the range of the number system. No NaN is ever returned.
    pub fn collide(&self, law: &dyn LawOver<Wide<N>>) -> Result<Rebound<N>, CollideError<N>> {
        positive("the radius", self.radius.clone())?;
        let Collided { outcome, after, energy, .. } = self.collision().collide(law)?;
        Ok(Rebound {
            regime: outcome.regime,
            normal_impulse: outcome.impulse.normal,
            tangential_impulse: -outcome.impulse.tangential,
            slip: outcome.slip,
            after: upright(&after),
            energy,
            work: outcome.work,
        })
    }
}
