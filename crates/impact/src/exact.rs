//! The paper's law on a sphere in exact numbers, without a fraction on the way.
//!
//! In the inputs of a [`SphereOnPlane<f64>`], with v = v_x − ω·r and s = μ·(1 + e)·v_y,
//!
//! ```text
//! q = 2·J·|v|    p = (J + m·r²)·s    α = p/q    k = (q − p)/(q + p)    i_x = q/(q + p)
//! ```
//!
//! so that two integers with their sum and difference say everything. [`Rational`] takes a gcd for
//! every operation, and is what this is tested against.
//!
//! [`Rational`]: kane_number::Rational

use std::cmp::Ordering;

use kane_number::Fixed;

use crate::InvalidInput;
use crate::bodies::SphereOnPlane;
use crate::decide::arithmetic::Arithmetic;
use crate::decide::question::{reach, slowing};
use crate::decide::{Dyadic, Fraction, check};

/// k and i_x of one collision, exactly.
#[derive(Clone, Debug)]
pub struct Ratios {
    /// k = v_t⁺/v_t.
    pub k: Fraction,
    /// i_x = |I_x|/(μ·I_y).
    pub impulse: Fraction,
}

/// Gives k and i_x of [`WangSuLi`](crate::laws::WangSuLi) for the floats as given. Exact.
///
/// Without slip the limits for α → ∞, k = −1 and i_x = 0; `None` where there is neither slip nor
/// friction, and α has no meaning.
///
/// # Errors
/// [`InvalidInput`] for the first input outside its domain.
///
/// ```
/// use kane_impact::bodies::{Motion, SphereOnPlane};
/// use kane_impact::exact::wang_su_li;
///
/// let sphere = SphereOnPlane {
///     mass: 1.0,
///     radius: 1.0,
///     inertia: 0.5,
///     friction: 0.25,
///     restitution: 1.0,
///     before: Motion { vx: 1.0, vy: 1.0, omega: 0.0 },
/// };
/// let ratios = wang_su_li(&sphere)?.expect("it slips"); // α = 3/4
/// assert_eq!(ratios.k.to_rational().to_string(), "1/7");
/// assert_eq!(ratios.impulse.to_f64(), 4.0 / 7.0);
/// # Ok::<(), kane_impact::InvalidInput<f64>>(())
/// ```
pub fn wang_su_li(sphere: &SphereOnPlane<f64>) -> Result<Option<Ratios>, InvalidInput<f64>> {
    check(sphere)?;
    let (numer, share, whole) = terms::<Fixed>(sphere);
    if whole.sign() == Some(Ordering::Equal) {
        return Ok(None);
    }
    if let (Some(k), Some(impulse)) = (Fraction::fixed(numer, whole), Fraction::fixed(share, whole))
    {
        return Ok(Some(Ratios { k, impulse }));
    }
    let (numer, share, whole) = terms::<Dyadic>(sphere);
    if whole.sign() == Some(Ordering::Equal) {
        return Ok(None);
    }
    let k = Fraction::big(numer, whole.clone());
    Ok(Some(Ratios { k, impulse: Fraction::big(share, whole) }))
}

/// q − p, q and q + p.
fn terms<A: Arithmetic>(sphere: &SphereOnPlane<f64>) -> (A, A, A) {
    let (q, p) = (reach::<A>(sphere).double(), slowing::<A>(sphere));
    let (difference, sum) = (q.minus(&p), q.plus(&p));
    (difference, q, sum)
}
