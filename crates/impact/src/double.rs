//! The impulse in `f64`: plainly where its bound holds, by wider arithmetic everywhere else.

use kane_number::Number;

use crate::bodies::CollideError;
use crate::invalid::finite;
use crate::{Contact, ImpactLaw, Impulse};

/// Which arithmetic gave a result.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// The law's formulas in `f64`.
    Plain,
    /// The same formulas in double-double with an exponent of its own, rounded once.
    Scaled,
}

impl Contact<f64> {
    /// Whether no intermediate quantity of a law can leave the normal range: every quantity that is
    /// not zero is between 2⁻²⁰⁰ and 2²⁰⁰ in magnitude.
    ///
    /// No formula of a law multiplies or divides more than five of them, and 2^1000 is in range.
    #[must_use]
    pub fn is_well_scaled(&self) -> bool {
        let w = self.delassus();
        [self.slip(), self.approach(), self.friction(), self.restitution(), w.tt(), w.tn(), w.nn()]
            .into_iter()
            .all(|x| *x == 0.0 || (LEAST..=GREATEST).contains(&x.abs()))
    }
}

/// 2⁻²⁰⁰ and 2²⁰⁰, by their bits.
const LEAST: f64 = f64::from_bits((1023 - 200) << 52);
const GREATEST: f64 = f64::from_bits((1023 + 200) << 52);

/// Gives the impulse of a law in `f64`, whatever the size of its inputs.
///
/// Plain `f64`, with the bound that the law states, where the contact does not couple, nor in a
/// [frame](ImpactLaw::frame) of the law's own, and is [well scaled](Contact::is_well_scaled); otherwise in scaled double-double, rounded once: within
/// 1 ulp wherever the law itself does not lose more than half of the 106 bits. Says which.
///
/// # Errors
/// [`CollideError`] if the law gives no impulse, or if the exact one is beyond the range of `f64`.
pub fn impulse<L: ImpactLaw>(
    law: &L,
    contact: &Contact<f64>,
) -> Result<(Impulse<f64>, Arithmetic), CollideError<f64>> {
    let uncoupled = *contact.delassus().tn() == 0.0 && law.frame(contact).is_none();
    if uncoupled && contact.is_well_scaled() {
        return Ok((law.impulse(contact)?, Arithmetic::Plain));
    }
    let wide = law.impulse(&contact.map(Number::widen))?;
    let narrowed = Impulse {
        tangential: finite("the tangential impulse", f64::narrow(&wide.tangential))?,
        normal: finite("the normal impulse", f64::narrow(&wide.normal))?,
    };
    Ok((narrowed, Arithmetic::Scaled))
}
