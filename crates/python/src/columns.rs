//! Laws over columns of floats that NumPy owns; nothing is copied.

use kane_impact::batch::{self as lanes, Batched, Columns, Contacts, Survey};
use kane_impact::laws::{
    GarwinCapped, Smith1991, Walton, WangSuLi, WhittakerStop, WhittakerUncapped,
};
use kane_impact::{Law, LawInfo, laws};
use numpy::{PyArrayMethods as _, PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;

use crate::bad_input;

/// A law with a kernel of its own for columns.
struct Lane {
    law: &'static LawInfo,
    evaluate: fn(&[f64], Columns<'_>),
    contacts: fn(Contacts<'_>, Columns<'_>),
    survey: fn(&[f64]) -> Survey,
}

impl Lane {
    const fn of<L: Batched + Default>() -> Self {
        Self {
            law: &L::INFO,
            evaluate: |alpha, out| lanes::evaluate(&L::default(), alpha, out),
            contacts: |contacts, out| lanes::evaluate_contacts(&L::default(), contacts, out),
            survey: |alpha| lanes::survey(&L::default(), alpha),
        }
    }
}

const LANES: [Lane; 6] = [
    Lane::of::<WangSuLi>(),
    Lane::of::<WhittakerUncapped>(),
    Lane::of::<WhittakerStop>(),
    Lane::of::<Walton>(),
    Lane::of::<GarwinCapped>(),
    Lane::of::<Smith1991>(),
];

/// How a law goes over a column.
enum Way {
    Lane(&'static Lane),
    /// row by row, as the law stands
    Single(&'static Law),
}

impl Way {
    /// The way of the law with an id.
    fn with(id: &str) -> PyResult<Self> {
        if let Some(lane) = LANES.iter().find(|lane| lane.law.id == id) {
            return Ok(Self::Lane(lane));
        }
        match laws().iter().find(|law| law.info.id == id) {
            Some(law) if law.has_frame() => Err(bad_input(format!(
                "{id} has a frame of its own: its k depends on e, mu and the angle one by one, and not on alpha; \
                 kane.collide puts it to one collision"
            ))),
            Some(law) => Ok(Self::Single(law)),
            None => {
                let known = batched().join(", ");
                Err(bad_input(format!("there is no law {id} for columns; there are {known}")))
            }
        }
    }

    fn evaluate(&self, alpha: &[f64], out: Columns<'_>) {
        match self {
            Self::Lane(lane) => (lane.evaluate)(alpha, out),
            Self::Single(law) => lanes::evaluate_singly(law, alpha, out),
        }
    }

    fn contacts(&self, contacts: Contacts<'_>, out: Columns<'_>) {
        match self {
            Self::Lane(lane) => (lane.contacts)(contacts, out),
            Self::Single(law) => lanes::evaluate_contacts_singly(law, contacts, out),
        }
    }

    fn survey(&self, alpha: &[f64]) -> Survey {
        match self {
            Self::Lane(lane) => (lane.survey)(alpha),
            Self::Single(law) => lanes::survey_singly(law, alpha),
        }
    }
}

/// Rows that are computed at once, before it is asked which of them had a meaning: their numbers are still in
/// a near cache then.
const BLOCK: usize = 4096;

impl Way {
    /// k, i_x and Δe for a column of α: NaN in all three where α is negative or NaN.
    fn fill(&self, alpha: &[f64], out: Columns<'_>) {
        for (alpha, [k, impulse, energy]) in alpha.chunks(BLOCK).zip(blocks(out)) {
            let out = Columns { k: &mut *k, impulse: &mut *impulse, energy: &mut *energy };
            self.evaluate(alpha, out);
            blank(alpha.iter().map(|&alpha| alpha >= 0.0), [k, impulse, energy]);
        }
    }

    /// The same for columns of contacts: NaN where slip is not finite, S < 0, W ≤ 0, or neither slip nor friction is there.
    fn fill_contacts(&self, contacts: Contacts<'_>, out: Columns<'_>) {
        let Contacts { slip, sliding, mobility } = contacts;
        let rows = slip.chunks(BLOCK).zip(sliding.chunks(BLOCK)).zip(mobility.chunks(BLOCK));
        for (((slip, sliding), mobility), [k, impulse, energy]) in rows.zip(blocks(out)) {
            let out = Columns { k: &mut *k, impulse: &mut *impulse, energy: &mut *energy };
            self.contacts(Contacts { slip, sliding, mobility }, out);
            let inside =
                slip.iter().zip(sliding).zip(mobility).map(|((&slip, &sliding), &mobility)| {
                    let moves = (slip.abs() < f64::INFINITY) & ((slip != 0.0) | (sliding > 0.0));
                    moves & (sliding >= 0.0) & (mobility > 0.0)
                });
            blank(inside, [k, impulse, energy]);
        }
    }
}

/// The columns of results, block by block.
fn blocks(out: Columns<'_>) -> impl Iterator<Item = [&mut [f64]; 3]> {
    let two = out.k.chunks_mut(BLOCK).zip(out.impulse.chunks_mut(BLOCK));
    two.zip(out.energy.chunks_mut(BLOCK)).map(|((k, impulse), energy)| [k, impulse, energy])
}

/// Writes NaN into the rows that have no meaning: some laws give numbers there, made by comparisons.
fn blank(inside: impl Iterator<Item = bool> + Clone, [k, impulse, energy]: [&mut [f64]; 3]) {
    // all rows are looked at, without a branch each
    if inside.clone().fold(true, |all, inside| all & inside) {
        return;
    }
    for (((inside, k), impulse), energy) in inside.zip(k).zip(impulse).zip(energy) {
        if !inside {
            (*k, *impulse, *energy) = (f64::NAN, f64::NAN, f64::NAN);
        }
    }
}

/// The ids of the laws that [`batch`] knows: those with kernels of their own first.
#[pyfunction]
pub(crate) fn batched() -> Vec<&'static str> {
    let mut ids: Vec<_> = LANES.iter().map(|lane| lane.law.id).collect();
    let others = laws().iter().filter(|law| !law.has_frame()).map(|law| law.info.id);
    for id in others {
        if !ids.contains(&id) {
            ids.push(id);
        }
    }
    ids
}

/// Fills k, i_x and Δe for a column of α.
///
/// # Errors
/// `ValueError` for another law, columns of several lengths, or columns with gaps.
#[pyfunction]
pub(crate) fn batch(
    py: Python<'_>,
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
    let way = Way::with(law)?;
    py.detach(|| way.fill(alpha, out));
    Ok(())
}

/// Fills k, i_x and Δe for columns of contacts.
///
/// # Errors
/// As of [`batch`].
#[pyfunction]
pub(crate) fn batch_contacts(
    py: Python<'_>,
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
    let way = Way::with(law)?;
    py.detach(|| way.fill_contacts(contacts, out));
    Ok(())
}

/// Rows, rows outside, gains, rows beyond the cone, greatest Δe and least k of a column of α.
///
/// # Errors
/// `ValueError` for another law, or a column with gaps.
#[pyfunction]
pub(crate) fn survey(
    py: Python<'_>,
    law: &str,
    alpha: PyReadonlyArray1<'_, f64>,
) -> PyResult<(usize, u64, u64, u64, f64, f64)> {
    let alpha = filled(&alpha)?;
    let way = Way::with(law)?;
    let s = py.detach(|| way.survey(alpha));
    Ok((s.rows, s.outside, s.gains, s.beyond_cone, s.greatest_energy, s.least_k))
}

/// The numbers of a column, where they stand.
///
/// # Errors
/// `ValueError` for a column with gaps, or not where the processor reads floats.
pub(crate) fn filled<'a>(column: &'a PyReadonlyArray1<'_, f64>) -> PyResult<&'a [f64]> {
    aligned(column.data())?;
    column.as_slice().map_err(|_| bad_input("a column has gaps: its numbers must be contiguous"))
}

fn columns<'a>(
    k: &'a mut PyReadwriteArray1<'_, f64>,
    impulse: &'a mut PyReadwriteArray1<'_, f64>,
    energy: &'a mut PyReadwriteArray1<'_, f64>,
) -> PyResult<Columns<'a>> {
    for column in [&*k, &*impulse, &*energy] {
        aligned(column.data())?;
    }
    let gaps = |_| bad_input("a column for results has gaps: its numbers must be contiguous");
    Ok(Columns {
        k: k.as_slice_mut().map_err(gaps)?,
        impulse: impulse.as_slice_mut().map_err(gaps)?,
        energy: energy.as_slice_mut().map_err(gaps)?,
    })
}

/// A slice of Rust begins where a number may stand.
fn aligned(start: *const f64) -> PyResult<()> {
    match start.is_aligned() {
        true => Ok(()),
        false => Err(bad_input("a column is not aligned: it begins in the middle of a number")),
    }
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
