//! Chatterjee and Ruina's algebraic law in space.

use kane_number::Real;

use super::ChatterjeeRuina;
use crate::{ImpactLaw, NoImpulse, SpatialContact};

const INSIDE: &str = "inside the cone";
const ON: &str = "on the cone";

impl ChatterjeeRuina {
    /// Gives the impulse (N·s) at a contact in space, in the axes of the contact.
    ///
    /// With the plastic impulses `p_I` = (0, a/`W_yy`, 0) without friction and `p_II` = −W⁻¹·v of
    /// sticking, and D = `p_II` − `p_I`,
    ///
    /// ```text
    /// p = (1 + e)·p_I + (1 + e_t)·D      if that is inside the friction cone, |p_t| ≤ μ·p_n,
    /// p = (1 + e)·p_I + κ·D               else, κ = μ·(1 + e)·p_I,n/(|D_t| − μ·D_n), on the cone.
    /// ```
    ///
    /// D changes no normal velocity, so that e is Newton's. Energy never rises for 0 ≤ e ≤ 1 and
    /// −1 ≤ `e_t` ≤ 1; where v, the lever and the inertia lie in a plane it is the planar law.
    ///
    /// The cone is asked by squares, so that exact numbers decide it. On it κ takes one square root:
    /// algebraic numbers hold it, rational ones only where |D_t| is rational, intervals enclose it.
    /// In floats heuristic: the entries of W⁻¹ may cancel.
    ///
    /// # Errors
    /// [`NoImpulse::Undecided`] if the number system cannot tell whether the impulse is inside the
    /// cone, [`NoImpulse::Unrepresentable`] if it does not hold the root.
    ///
    /// Source: as for the planar law.
    pub fn impulse_in_space<N: Real>(
        &self,
        contact: &SpatialContact<N>,
    ) -> Result<[N; 3], NoImpulse> {
        let law = self.id();
        let w = contact.delassus().entries();
        let [x, y, z] = contact.velocity();
        let [mu, e] = [contact.friction(), contact.restitution()];
        let inverse = w.adjugate();
        let determinant = w.determinant(&inverse);
        let [dx, sticking, dz] = inverse.times(&[x.clone(), y.clone(), z.clone()]);
        let plastic = -(y.clone() / &w.yy);
        let d = [-(dx / &determinant), -(sticking / &determinant) - &plastic, -(dz / &determinant)];
        let pushed = (N::one() + e) * plastic;
        let along = |share: &N| {
            let [x, y, z] = &d;
            [share.clone() * x, y.mul_add(share, &pushed), share.clone() * z]
        };
        let inner = along(&(N::one() + N::from_rational(&self.restitution)));
        let square = |[x, _, z]: &[N; 3]| x.square() + z.square();
        let bound = inner[1].clone() * mu;
        let inside = match bound.sign().is_at_least() {
            Some(true) => (bound.square() - square(&inner)).sign().is_at_least(),
            // friction without push
            Some(false) => Some(false),
            None => None,
        };
        if inside.ok_or(NoImpulse::Undecided { law, regime: INSIDE })? {
            return Ok(inner);
        }
        // outside, (1 + e_t)·(|D_t| − μ·D_n) > μ·(1 + e)·p_I,n ≥ 0
        let size = square(&d);
        let upper = N::one() + &size;
        let size = N::greatest_root(&[-size, N::zero(), N::one()], &N::zero(), &upper)
            .ok_or(NoImpulse::Unrepresentable { law, regime: ON })?;
        let rate = size - d[1].clone() * mu;
        let kappa = (pushed.clone() * mu)
            .checked_div(&rate)
            .ok_or(NoImpulse::Undecided { law, regime: ON })?;
        Ok(along(&kappa))
    }
}
