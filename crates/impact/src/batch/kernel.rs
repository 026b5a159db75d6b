//! The laws in terms of α, one row without a branch.
#![allow(clippy::float_arithmetic, reason = "the float lanes of the laws")]

use kane_number::Number;

use crate::ImpactLaw;
use crate::laws::{GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerStop, WhittakerUncapped};

/// k, i_x and Δe of one row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// k = v_t⁺/v_t.
    pub k: f64,
    /// i_x, the friction by the one of full sliding.
    pub impulse: f64,
    /// Δe, the work of friction by μ·p_n·v_t.
    pub energy: f64,
}

/// One row of a law: arithmetic and selection, no branch, so that a loop over it vectorises.
pub trait Kernel: Copy {
    /// Gives the row for 0 ≤ α ≤ ∞. For NaN and below 0 the row has no meaning.
    #[must_use]
    fn row(self, alpha: f64) -> Row;
}

/// A law with a branch-free float lane for contacts that do not couple.
///
/// "As the single lane" means: the very float that [`ratios`](ImpactLaw::ratios) gives, at any α from
/// 0 to ∞, the sign of a zero aside; a subnormal Δe may differ by 2⁻¹⁰⁷³, because that lane doubles a
/// rounded half. Bounds are against the exact law at the float α; u = 2⁻⁵³.
pub trait Batched: ImpactLaw {
    /// What is left of the law in the loop.
    type Kernel: Kernel;

    /// The law's kernel.
    fn kernel(&self) -> Self::Kernel;
}

/// [`WangSuLi`]: k within 9/4 ulp, i_x and Δe as the single lane (3/2 and 4 ulp).
///
/// k is the plain quotient d/s of d = fl(1 − α) and s = fl(1 + α); it is never formed as 2·i_x − 1,
/// which cancels.
///
/// - α < 1/2: |d − (1 − α)| ≤ u/2, |s − (1 + α)| ≤ u, and d/s − k = (ε_d − k·ε_s)/s. For k ≥ 1/2 that
///   is at most 3/2·u, and the division adds u/2: 2 ulp of u. For k < 1/2 (s > 4/3) it is at most
///   3/4·u, and the division adds u/4: 2 ulp of u/2.
/// - 1/2 ≤ α < 1/u: d is exact, so one relative error of u and the division: 3/2 ulp.
/// - 1/u ≤ α < 2/u: α is even. If 4 | α both sums round to α, and k̂ = −1 errs by 2/(α + 1) < 2u. If
///   not, −k̂ = fl(1 − 4/(α + 2)) against 1 − 2/(α + 1): worst where the division still gives 1 − 4u,
///   4/(α + 2) ≥ 7/2·u, so less than 9/4·u; approached at α ≈ 2^56/7.
/// - α ≥ 2/u: k̂ = −1, and the error is 2/(α + 1) < u.
#[derive(Clone, Copy, Debug)]
pub struct FadingKernel;

impl Kernel for FadingKernel {
    #[inline]
    fn row(self, alpha: f64) -> Row {
        let impulse = 1.0 / (1.0 + alpha);
        // at α = ∞ the quotient of the greatest float, −1; a NaN passes
        let finite = if alpha > f64::MAX { f64::MAX } else { alpha };
        let k = (1.0 - finite) / (1.0 + finite);
        Row { k, impulse, energy: 0.0 - impulse * impulse }
    }
}

impl Batched for WangSuLi {
    type Kernel = FadingKernel;

    fn kernel(&self) -> FadingKernel {
        FadingKernel
    }
}

/// [`WhittakerUncapped`]: as the single lane; k and Δe correctly rounded. At α = ∞, where that lane
/// has no value, k = −∞ and Δe = ∞.
#[derive(Clone, Copy, Debug)]
pub struct SlidingKernel;

impl Kernel for SlidingKernel {
    #[inline]
    fn row(self, alpha: f64) -> Row {
        Row { k: 1.0 - 2.0 * alpha, impulse: 1.0, energy: alpha - 1.0 }
    }
}

impl Batched for WhittakerUncapped {
    type Kernel = SlidingKernel;

    fn kernel(&self) -> SlidingKernel {
        SlidingKernel
    }
}

/// Sliding, or else a rebound of the slip: k = max(−β, 1 − 2α) with β from 0 to 1, that is
/// [`WhittakerStop`] (0), [`Walton`] (β0) and [`GarwinCapped`] (1). As the single lane.
///
/// For the float nearest to β: k is correctly rounded, i_x within 3/2 ulp, and
/// Δe = −i_x·(1 + k)/2 within 7/2 ulp of relative error u each while it rebounds; where it slides
/// Δe = −(1 + k)/2 = α − 1 has an absolute error of at most u.
#[derive(Clone, Copy, Debug)]
pub struct ReboundKernel {
    restitution: f64,
    /// α up to which it slides: fl(1 + β)/2.
    reach: f64,
}

impl ReboundKernel {
    fn new(restitution: f64) -> Self {
        Self { restitution, reach: (1.0 + restitution) / 2.0 }
    }
}

impl Kernel for ReboundKernel {
    #[inline]
    fn row(self, alpha: f64) -> Row {
        let slides = alpha <= self.reach;
        let (sliding, share) = (1.0 - 2.0 * alpha, self.reach / alpha);
        let k = if slides { sliding } else { 0.0 - self.restitution };
        let impulse = if slides { 1.0 } else { share };
        Row { k, impulse, energy: 0.0 - (1.0 + k) * impulse / 2.0 }
    }
}

impl Batched for WhittakerStop {
    type Kernel = ReboundKernel;

    fn kernel(&self) -> ReboundKernel {
        ReboundKernel::new(0.0)
    }
}

impl Batched for Walton {
    type Kernel = ReboundKernel;

    fn kernel(&self) -> ReboundKernel {
        ReboundKernel::new(f64::from_rational(&self.restitution))
    }
}

impl Batched for GarwinCapped {
    type Kernel = ReboundKernel;

    fn kernel(&self) -> ReboundKernel {
        ReboundKernel::new(1.0)
    }
}

/// [`Smith1991`] in closed form: where α ≥ 1/2, with d = α² + 2α − 1,
///
/// ```text
/// k = α − √d = (1 − 2α)/(α + √d)    i_x = (1 − k)/(2α)    1 + k = 2/(1 + α + √d)
/// ```
///
/// In relative terms, to first order and barring underflow: k within 6u, i_x within 5u, Δe within
/// 10u, each one division of terms of one sign. d = (α − 1/2)·(α + 5/2) + 1/4 has at most 4u, its root
/// 3u, α + √d 4u and 1 + α + √d as much; so k has u + 4u + u, i_x half of k's (as |k| ≤ 1) and 2u, and
/// Δe = −i_x/(1 + α + √d) has 5u + 4u + u. The single lane finds its root by iteration: the two agree
/// within their bounds, not bit for bit.
///
/// Sliding is no branch: by how much α falls short of 1/2, s = fl(1/2 − α), is added to the row at
/// α = 1/2, which is k = 0, i_x = 1, Δe = −1/2 without an error. So k = 2s = fl(1 − 2α) is correctly
/// rounded, and Δe = −fl(1/2 + s) has an absolute error of at most 3/4·u: u/4 from s, which is below
/// 1/2, and u/2 from a sum that is at most 1. Selections whose other side takes a division or a root
/// would be compiled to branches; those of minima and maxima are not.
#[derive(Clone, Copy, Debug)]
pub struct WeightedKernel;

/// 2⁶⁰: from here on √d is taken for α, because d might overflow later: 2⁶⁰ + fl(α − 2⁶⁰), which with
/// the 1 that is missing has less than the 3u of a root.
const FAR: f64 = f64::from_bits((1023 + 60) << 52);

impl Kernel for WeightedKernel {
    #[inline]
    fn row(self, alpha: f64) -> Row {
        let reach = if alpha > 0.5 { alpha } else { 0.5 };
        let finite = if reach > f64::MAX { f64::MAX } else { reach };
        let near = if finite > FAR { FAR } else { finite };
        let root = ((near - 0.5) * (near + 2.5) + 0.25).sqrt() + (finite - near);
        // halves, so that the sum does not overflow
        let reversed = (0.5 - finite) / (0.5 * finite + 0.5 * root);
        let impulse = 0.5 * (1.0 - reversed) / reach;
        let lost = impulse / (1.0 + finite + root);
        let short = if alpha < 0.5 { 0.5 - alpha } else { 0.0 };
        let (k, lost) = (reversed + 2.0 * short, lost + short);
        Row { k, impulse, energy: 0.0 - lost }
    }
}

impl Batched for Smith1991 {
    type Kernel = WeightedKernel;

    fn kernel(&self) -> WeightedKernel {
        WeightedKernel
    }
}
