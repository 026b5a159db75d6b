//! The energy ledger of a collision.

use kane_number::Number;

use crate::{Motion, SphereOnPlane};

/// The change of kinetic energy by part; joules, negative for a loss.
#[derive(Clone, Debug, PartialEq)]
pub struct Ledger<N> {
    /// m·(v_y² − v_y0²)/2.
    pub normal: N,
    /// m·(v_x² − v_x0²)/2.
    pub tangential: N,
    /// J·(ω² − ω0²)/2.
    pub rotational: N,
}

impl<N: Number> Ledger<N> {
    /// Forms each part as impulse times mean velocity, the kinetic energy theorem, because the
    /// difference of squares would cancel where little changes.
    ///
    /// Exact in exact numbers; heuristic in floats: mean velocities may cancel, so that a part near
    /// zero has no relative bound.
    pub(crate) fn of(
        body: &SphereOnPlane<N>,
        normal: &N,
        tangential: &N,
        after: &Motion<N>,
    ) -> Self {
        let before = &body.before;
        let mean = |a: &N, b: &N| (a.clone() + b) / N::one().double();
        Self {
            normal: -(mean(&before.vy, &after.vy) * normal),
            tangential: -(mean(&before.vx, &after.vx) * tangential),
            rotational: mean(&before.omega, &after.omega) * &body.radius * tangential,
        }
    }

    /// The change in the tangential and rotational directions together, which the tangential
    /// impulse makes: −I_x·(v_t + v_t⁺)/2 (Wang, Su, Li, equation (18)).
    #[must_use]
    pub fn by_friction(&self) -> N {
        self.tangential.clone() + &self.rotational
    }

    /// The change of all kinetic energy.
    #[must_use]
    pub fn total(&self) -> N {
        self.by_friction() + &self.normal
    }
}
