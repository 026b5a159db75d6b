//! Laws over columns of floats that NumPy owns; nothing is copied.

use kane_impact::batch::{self as lanes, Batched, Columns, Contacts, Survey};
use kane_impact::laws::{
    GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerStop, WhittakerUncapped,
};
use numpy::{PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;

use crate::bad_input;

/// Does something with the law of an id that has a lane for columns.
macro_rules! lane {
    ($id:expr, |$law:ident| $then:expr) => {
        match $id {
            "wang-su-li" => {
                let $law = &WangSuLi;
                Some($then)
            }
            "whittaker-uncapped" => {
                let $law = &WhittakerUncapped;
                Some($then)
            }
            "whittaker-stop" => {
                let $law = &WhittakerStop;
                Some($then)
            }
            "walton" => {
                let $law = &Walton::default();
                Some($then)
            }
            "garwin-capped" => {
                let $law = &GarwinCapped;
                Some($then)
            }
            "smith-1991" => {
                let $law = &Smith1991;
                Some($then)
            }
            _ => None,
        }
    };
}

/// The ids of the laws that have a lane for columns.
const LANES: [&str; 6] =
    ["wang-su-li", "whittaker-uncapped", "whittaker-stop", "walton", "garwin-capped", "smith-1991"];

/// The ids of the laws that [`batch`] knows.
#[pyfunction]
pub(crate) fn batched() -> Vec<&'static str> {
    LANES.to_vec()
}

/// Fills k, i_x and Δe for a column of α.
///
/// # Errors
/// `ValueError` for another law, columns of several lengths, or columns with gaps.
#[pyfunction]
pub(crate) fn batch(
    law: &str,
    alpha: PyReadonlyArray1<'_, f64>,
    k: PyReadwriteArray1<'_, f64>,
    impulse: PyReadwriteArray1<'_, f64>,
    energy: PyReadwriteArray1<'_, f64>,
) -> PyResult<()> {
    let alpha = filled(&alpha)?;
    let (mut k, mut impulse, mut energy) = (k, impulse, energy);
    let out = columns(&mut k, &mut impulse, &mut energy)?;
    same_length(&[alpha.len()], &out)?;
    lane!(law, |law| lanes::evaluate(law, alpha, out)).ok_or_else(|| unknown(law))
}

/// Fills k, i_x and Δe for columns of contacts.
///
/// # Errors
/// As of [`batch`].
#[pyfunction]
pub(crate) fn batch_contacts(
    law: &str,
    inputs: [PyReadonlyArray1<'_, f64>; 3],
    k: PyReadwriteArray1<'_, f64>,
    impulse: PyReadwriteArray1<'_, f64>,
    energy: PyReadwriteArray1<'_, f64>,
) -> PyResult<()> {
    let [slip, sliding, mobility] = &inputs;
    let contacts =
        Contacts { slip: filled(slip)?, sliding: filled(sliding)?, mobility: filled(mobility)? };
    let (mut k, mut impulse, mut energy) = (k, impulse, energy);
    let out = columns(&mut k, &mut impulse, &mut energy)?;
    same_length(&[contacts.slip.len(), contacts.sliding.len(), contacts.mobility.len()], &out)?;
    lane!(law, |law| lanes::evaluate_contacts(law, contacts, out)).ok_or_else(|| unknown(law))
}

/// Rows, rows outside, gains, rows beyond the cone, greatest Δe and least k of a column of α.
///
/// # Errors
/// `ValueError` for another law, or a column with gaps.
#[pyfunction]
pub(crate) fn survey(
    law: &str,
    alpha: PyReadonlyArray1<'_, f64>,
) -> PyResult<(usize, u64, u64, u64, f64, f64)> {
    let alpha = filled(&alpha)?;
    let told =
        |s: Survey| (s.rows, s.outside, s.gains, s.beyond_cone, s.greatest_energy, s.least_k);
    lane!(law, |law| told(surveyed(law, alpha))).ok_or_else(|| unknown(law))
}

fn surveyed<L: Batched>(law: &L, alpha: &[f64]) -> Survey {
    lanes::survey(law, alpha)
}

fn filled<'a>(column: &'a PyReadonlyArray1<'_, f64>) -> PyResult<&'a [f64]> {
    column.as_slice().map_err(|_| bad_input("a column has gaps: its numbers must be contiguous"))
}

fn columns<'a>(
    k: &'a mut PyReadwriteArray1<'_, f64>,
    impulse: &'a mut PyReadwriteArray1<'_, f64>,
    energy: &'a mut PyReadwriteArray1<'_, f64>,
) -> PyResult<Columns<'a>> {
    let gaps = |_| bad_input("a column for results has gaps: its numbers must be contiguous");
    Ok(Columns {
        k: k.as_slice_mut().map_err(gaps)?,
        impulse: impulse.as_slice_mut().map_err(gaps)?,
        energy: energy.as_slice_mut().map_err(gaps)?,
    })
}

/// What the batch would panic on.
fn same_length(inputs: &[usize], out: &Columns<'_>) -> PyResult<()> {
    let lengths = [out.k.len(), out.impulse.len(), out.energy.len()];
    let all = || inputs.iter().chain(&lengths);
    match all().min() == all().max() {
        true => Ok(()),
        false => Err(bad_input("the columns are not of one length")),
    }
}

fn unknown(law: &str) -> PyErr {
    bad_input(format!("{law} has no lane for columns; there are {}", LANES.join(", ")))
}
