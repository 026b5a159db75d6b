//! The one number of the materials.

use crate::InvalidInput;
use crate::invalid::{finite, fraction, positive};

/// χ > 0 and 0 ≤ e ≤ 1: all that the processes ask of the bodies beside α. Pure numbers.
///
/// χ = κ·j_p/2 with κ, the tangential by the normal stiffness of the contact, and j_p = m·`W_tt`,
/// the tangential by the normal mobility (7/2 of a solid sphere on a plane). The tangential
/// frequency is √(2χ) times the normal one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compliance {
    chi: f64,
    restitution: f64,
}

/// An elastic material at a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// G > 0, the shear modulus; Pa. ∞ for a rigid body.
    pub shear_modulus: f64,
    /// −1 < ν ≤ 1/2, Poisson's ratio.
    pub poisson: f64,
}

impl Compliance {
    /// Takes χ and e.
    ///
    /// # Errors
    /// [`InvalidInput`] unless χ is finite and positive and 0 ≤ e ≤ 1.
    pub fn new(chi: f64, restitution: f64) -> Result<Self, InvalidInput<f64>> {
        Ok(Self {
            chi: positive("chi", chi)?,
            restitution: fraction("the restitution", restitution)?,
        })
    }

    /// Springs: η² is the normal by the tangential stiffness, so that χ = j_p/(2·η²).
    ///
    /// # Errors
    /// [`InvalidInput`] unless both are finite and positive and 0 ≤ e ≤ 1.
    pub fn of_springs(
        mobility: f64,
        eta_squared: f64,
        restitution: f64,
    ) -> Result<Self, InvalidInput<f64>> {
        let (mobility, eta) = (positive("j_p", mobility)?, positive("eta^2", eta_squared)?);
        Self::new(mobility / (2.0 * eta), restitution)
    }

    /// One material, or any on a rigid plane: κ = 2·(1 − ν)/(2 − ν), after Mindlin.
    ///
    /// # Errors
    /// [`InvalidInput`] unless j_p > 0, −1 < ν ≤ 1/2 and 0 ≤ e ≤ 1.
    pub fn of_poisson(
        mobility: f64,
        poisson: f64,
        restitution: f64,
    ) -> Result<Self, InvalidInput<f64>> {
        let one = Elastic { shear_modulus: 1.0, poisson };
        Self::between([one; 2], mobility, restitution)
    }

    /// Two materials:
    ///
    /// ```text
    /// κ = Σ (1 − ν)/G / Σ (1 − ν/2)/G
    /// ```
    ///
    /// Where the two differ, normal and tangential displacements couple; the theories leave that out.
    ///
    /// # Errors
    /// [`InvalidInput`] unless j_p > 0, both G > 0, one of them finite, both −1 < ν ≤ 1/2 and
    /// 0 ≤ e ≤ 1.
    pub fn between(
        bodies: [Elastic; 2],
        mobility: f64,
        restitution: f64,
    ) -> Result<Self, InvalidInput<f64>> {
        let (mut normal, mut tangential) = (0.0, 0.0);
        for Elastic { shear_modulus, poisson } in bodies {
            // ν + 1 > 0 and 1 − 2ν ≥ 0
            finite("Poisson's ratio", poisson)?;
            positive("1 + nu", 1.0 + poisson)?;
            crate::invalid::not_negative("1 - 2*nu", 1.0 - 2.0 * poisson)?;
            if shear_modulus != f64::INFINITY {
                positive("the shear modulus", shear_modulus)?;
            }
            normal += (1.0 - poisson) / shear_modulus;
            tangential += (1.0 - poisson / 2.0) / shear_modulus;
        }
        let kappa = positive("the stiffness ratio", normal / tangential)?;
        Self::new(kappa * positive("j_p", mobility)? / 2.0, restitution)
    }

    /// χ.
    #[must_use]
    pub const fn chi(&self) -> f64 {
        self.chi
    }

    /// e.
    #[must_use]
    pub const fn restitution(&self) -> f64 {
        self.restitution
    }

    /// λ = α/((1 + e)·χ), the cone's width in units of the slip before; 1/ψ1.
    #[must_use]
    pub fn cone(&self, alpha: f64) -> f64 {
        alpha / ((1.0 + self.restitution) * self.chi)
    }

    /// The α above which a collision of linear or Hertzian bodies starts without slip: (1 + e)·χ,
    /// where ψ1 = 1.
    #[must_use]
    pub fn initial_stick(&self) -> f64 {
        (1.0 + self.restitution) * self.chi
    }

    /// The α up to which linear springs and elastic half-spaces slide all the time, where y ≥ λ·x'
    /// to the end:
    ///
    /// ```text
    /// α_s = (1/2)/(1 − 1/(2χ·e·(1 + e)))  if 2χ·e² ≥ 1, else (1 + e)/2
    /// ```
    ///
    /// This is for 2χ ≥ 1; for softer tangential springs slip ends at the very start if at all, and
    /// α_s = (1 + e)·χ. With e = 1 and 2χ ≥ 1 it is ψ1 = 4χ − 1.
    #[must_use]
    pub fn sliding_until(&self) -> f64 {
        let (twice, e) = (2.0 * self.chi, self.restitution);
        if twice < 1.0 {
            self.initial_stick()
        } else if twice * e * e >= 1.0 {
            0.5 / (1.0 - 1.0 / (twice * e * (1.0 + e)))
        } else {
            f64::midpoint(1.0, e)
        }
    }
}
