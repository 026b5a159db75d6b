//! Laws over columns of floats: as fast as memory allows, with the bounds of the single lane.
//!
//! The columns hold α, or the three quantities of a contact that it is made of; the results are the
//! columns k, i_x and Δe, or, where nothing need be stored, a [`Survey`] of them. What a law promises
//! about its floats is said at its kernel, see [`Batched`]. No row is checked on the way: an α that is
//! no collision parameter gives a row without meaning, which [`survey`] counts.
//!
//! ```
//! use kane_impact::batch::{self, Columns};
//! use kane_impact::laws::{WangSuLi, WhittakerUncapped};
//!
//! let alpha = [0.0, 0.5, 1.0, 3.0];
//! let (mut k, mut impulse, mut energy) = ([0.0; 4], [0.0; 4], [0.0; 4]);
//! let columns = Columns { k: &mut k, impulse: &mut impulse, energy: &mut energy };
//! batch::evaluate(&WangSuLi, &alpha, columns);
//! assert_eq!(k, [1.0, 1.0 / 3.0, 0.0, -0.5]);
//! assert_eq!(impulse, [1.0, 1.0 / 1.5, 0.5, 0.25]);
//!
//! assert_eq!(batch::survey(&WangSuLi, &alpha).gains, 0);
//! assert_eq!(batch::survey(&WhittakerUncapped, &alpha).gains, 1);
//! ```
#![allow(clippy::float_arithmetic, reason = "the float lanes of the laws")]

mod kernel;
mod single;

pub use single::{evaluate_contacts_singly, evaluate_singly, survey_singly};

pub use kernel::{
    Batched, FadingKernel, Kernel, ReboundKernel, Row, SlidingKernel, WeightedKernel,
};

/// Where the results go: columns of the length of the input.
#[derive(Debug)]
pub struct Columns<'a> {
    /// k = v_t⁺/v_t.
    pub k: &'a mut [f64],
    /// i_x, the friction by the one of full sliding.
    pub impulse: &'a mut [f64],
    /// Δe, the work of friction by μ·p_n·v_t.
    pub energy: &'a mut [f64],
}

/// Contacts that do not couple, column by column; SI units.
#[derive(Clone, Copy, Debug)]
pub struct Contacts<'a> {
    /// `v_t`, of either sign; m/s. α has no meaning where it is 0 without friction, and is ∞ where
    /// it is 0 with friction.
    pub slip: &'a [f64],
    /// S = μ·p_n ≥ 0, the friction of full sliding; N·s.
    pub sliding: &'a [f64],
    /// `W_tt` > 0; 1/kg.
    pub mobility: &'a [f64],
}

/// What many rows have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Survey {
    /// How many rows there were.
    pub rows: usize,
    /// Rows whose α is negative or NaN, or at which the law has no value; the others are the law's.
    pub outside: u64,
    /// Rows inside where friction gains energy, Δe > 0.
    pub gains: u64,
    /// Rows inside that exceed Coulomb's bound, |i_x| > 1.
    pub beyond_cone: u64,
    /// The greatest Δe inside; −∞ without a row.
    pub greatest_energy: f64,
    /// The least k inside; ∞ without a row.
    pub least_k: f64,
}

/// Gives k, i_x and Δe for a column of α, each from 0 to ∞.
///
/// # Panics
/// If the columns are not of one length.
pub fn evaluate<L: Batched>(law: &L, alpha: &[f64], out: Columns<'_>) {
    fill(law.kernel(), alpha, out.k, out.impulse, out.energy);
}

/// Slices as arguments of a function of its own: the compiler knows then that they do not overlap.
#[inline(never)]
fn fill<K: Kernel>(
    kernel: K,
    alpha: &[f64],
    k: &mut [f64],
    impulse: &mut [f64],
    energy: &mut [f64],
) {
    let rows = alpha.len();
    assert!([k.len(), impulse.len(), energy.len()] == [rows; 3], "columns of one length");
    for (((&alpha, k), impulse), energy) in alpha.iter().zip(k).zip(impulse).zip(energy) {
        let row = kernel.row(alpha);
        (*k, *impulse, *energy) = (row.k, row.impulse, row.energy);
    }
}

/// Gives k, i_x and Δe for columns of contacts: the rows of α = fl(fl(S·`W_tt`)/(2·|`v_t`|)), which,
/// barring under- and overflow, has a relative error of at most 2u.
///
/// An error ε in α changes k by at most ε/2, i_x by at most ε·i_x·α/(1 + α) under the paper's law.
///
/// # Panics
/// If the columns are not of one length.
pub fn evaluate_contacts<L: Batched>(law: &L, contacts: Contacts<'_>, out: Columns<'_>) {
    let Contacts { slip, sliding, mobility } = contacts;
    fill_contacts(law.kernel(), [slip, sliding, mobility], out.k, out.impulse, out.energy);
}

#[inline(never)]
fn fill_contacts<K: Kernel>(
    kernel: K,
    [slip, sliding, mobility]: [&[f64]; 3],
    k: &mut [f64],
    impulse: &mut [f64],
    energy: &mut [f64],
) {
    let lengths = [sliding.len(), mobility.len(), k.len(), impulse.len(), energy.len()];
    assert!(lengths == [slip.len(); 5], "columns of one length");
    let contacts = slip.iter().zip(sliding).zip(mobility);
    for (((((slip, sliding), mobility), k), impulse), energy) in
        contacts.zip(k).zip(impulse).zip(energy)
    {
        let row = kernel.row(sliding * mobility / (2.0 * slip.abs()));
        (*k, *impulse, *energy) = (row.k, row.impulse, row.energy);
    }
}

/// Rows are surveyed by the block, whose results stay in the first-level cache.
const BLOCK: usize = 256;

/// So many maxima are kept side by side, which leaves their order open.
const LANES: usize = 8;

/// A survey of blocks.
struct Tally {
    outside: u64,
    gains: u64,
    beyond_cone: u64,
    greatest_energy: [f64; LANES],
    least_k: [f64; LANES],
}

impl Tally {
    /// Two loops, since counts vectorise as they are, but the order of maxima must be given up by hand.
    #[inline]
    fn add<K: Kernel>(&mut self, kernel: K, alpha: &[f64; BLOCK]) {
        let (mut energies, mut ks) = ([0.0; BLOCK], [0.0; BLOCK]);
        let (mut outside, mut gains, mut beyond_cone) = (0, 0, 0);
        for ((&alpha, e), l) in alpha.iter().zip(&mut energies).zip(&mut ks) {
            let Row { k, impulse, energy } = kernel.row(alpha);
            let inside = (alpha >= 0.0) & !k.is_nan();
            outside += u64::from(!inside);
            gains += u64::from(inside & (energy > 0.0));
            beyond_cone += u64::from(inside & (impulse.abs() > 1.0));
            *e = if inside { energy } else { f64::NEG_INFINITY };
            *l = if inside { k } else { f64::INFINITY };
        }
        self.outside += outside;
        self.gains += gains;
        self.beyond_cone += beyond_cone;
        for row in energies.as_chunks::<LANES>().0 {
            for (most, &energy) in self.greatest_energy.iter_mut().zip(row) {
                *most = if energy > *most { energy } else { *most };
            }
        }
        for row in ks.as_chunks::<LANES>().0 {
            for (least, &k) in self.least_k.iter_mut().zip(row) {
                *least = if k < *least { k } else { *least };
            }
        }
    }
}

/// Looks at a law on a column of α without storing a result.
///
/// Exact about the floats that [`evaluate`] would give.
#[must_use]
pub fn survey<L: Batched>(law: &L, alpha: &[f64]) -> Survey {
    surveyed(law.kernel(), alpha)
}

fn surveyed<K: Kernel>(kernel: K, alpha: &[f64]) -> Survey {
    let mut tally = Tally {
        outside: 0,
        gains: 0,
        beyond_cone: 0,
        greatest_energy: [f64::NEG_INFINITY; LANES],
        least_k: [f64::INFINITY; LANES],
    };
    let (whole, rest) = alpha.as_chunks::<BLOCK>();
    for rows in whole {
        tally.add(kernel, rows);
    }
    // the last rows are filled up with NaN, which counts as outside and nowhere else
    let mut padded = [f64::NAN; BLOCK];
    padded[..rest.len()].copy_from_slice(rest);
    tally.add(kernel, &padded);
    let padding = u64::try_from(BLOCK - rest.len()).unwrap_or(0);
    Survey {
        rows: alpha.len(),
        outside: tally.outside - padding,
        gains: tally.gains,
        beyond_cone: tally.beyond_cone,
        greatest_energy: tally.greatest_energy.into_iter().fold(f64::NEG_INFINITY, f64::max),
        least_k: tally.least_k.into_iter().fold(f64::INFINITY, f64::min),
    }
}
