//! Laws over columns one row at a time: any law that has ratios, as it stands.

use super::{Columns, Contacts, Kernel, Row, Survey, fill, fill_contacts, surveyed};
use crate::{Alpha, Law, LawOver};

/// A law as it chooses its regime, row by row; branches and roots are its own.
#[derive(Clone, Copy)]
struct SingleKernel<'l>(&'l dyn LawOver<f64>);

impl Kernel for SingleKernel<'_> {
    fn row(self, alpha: f64) -> Row {
        let ratios = Alpha::new(alpha).ok().and_then(|alpha| self.0.ratios(&alpha));
        ratios.map_or(Row { k: f64::NAN, impulse: f64::NAN, energy: f64::NAN }, |ratios| Row {
            k: ratios.k,
            impulse: ratios.impulse,
            energy: ratios.energy,
        })
    }
}

/// Gives k, i_x and Δe for a column of α: the very floats of [`ImpactLaw::ratios`](crate::ImpactLaw::ratios), with
/// the bounds of the law. A row without a value, as of an α below 0 or of a law with a frame of its own, is NaN.
///
/// # Panics
/// If the columns are not of one length.
pub fn evaluate_singly(law: &Law, alpha: &[f64], out: Columns<'_>) {
    fill(SingleKernel(law.over()), alpha, out.k, out.impulse, out.energy);
}

/// The same for columns of contacts, with α rounded as in [`evaluate_contacts`](super::evaluate_contacts).
///
/// # Panics
/// If the columns are not of one length.
pub fn evaluate_contacts_singly(law: &Law, contacts: Contacts<'_>, out: Columns<'_>) {
    let Contacts { slip, sliding, mobility } = contacts;
    let inputs = [slip, sliding, mobility];
    fill_contacts(SingleKernel(law.over()), inputs, out.k, out.impulse, out.energy);
}

/// What such rows have in common; exact about the floats of [`evaluate_singly`].
#[must_use]
pub fn survey_singly(law: &Law, alpha: &[f64]) -> Survey {
    surveyed(SingleKernel(law.over()), alpha)
}
