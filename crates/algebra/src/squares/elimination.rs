//! Linear equations between unknowns, solved exactly for as many as there are equations.

use std::collections::{BTreeMap, BTreeSet};

use kane_kernel::{Fuel, Monomial};
use num_traits::{One, Zero};

use super::Q;
use crate::work::FRACTION;

/// What is unknown: an entry of a Gram matrix, or a coefficient of a cofactor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Column {
    Entry { block: usize, row: usize, column: usize },
    Cofactor { equation: usize, monomial: Monomial },
}

/// Σ entries · unknowns = value
#[derive(Clone, Debug, Default)]
pub(super) struct Row {
    pub(super) entries: BTreeMap<usize, Q>,
    pub(super) value: Q,
}

/// Equations between unknowns.
#[derive(Clone, Debug)]
pub(super) struct System {
    pub(super) columns: Vec<Column>,
    pub(super) rows: Vec<Row>,
}

/// Some unknowns in terms of the others, the free ones.
#[derive(Clone, Debug)]
pub(super) struct Solution {
    pub(super) columns: Vec<Column>,
    /// columns that may have any value
    pub(super) free: Vec<usize>,
    /// column = value − Σ entries · free columns
    solved: Vec<(usize, Row)>,
}

impl Solution {
    /// Gauss and Jordan's elimination, sparsest rows and columns first; `None` if the equations
    /// contradict each other.
    pub(super) fn of(system: System, fuel: &Fuel) -> Option<Self> {
        let System { columns, mut rows } = system;
        let mut places: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); columns.len()];
        for (r, row) in rows.iter().enumerate() {
            row.entries.keys().for_each(|&c| _ = places[c].insert(r));
        }
        let mut open: BTreeSet<usize> = (0..rows.len()).collect();
        let mut pivots: Vec<(usize, usize)> = Vec::new();
        while let Some(&r) = open.iter().min_by_key(|&&r| rows[r].entries.len()) {
            open.remove(&r);
            // An entry off the diagonal is worth no sign, so it is the first to go.
            let diagonal =
                |c: usize| matches!(columns[c], Column::Entry { row, column, .. } if row == column);
            let choice = rows[r].entries.keys().copied();
            let Some(c) = choice.min_by_key(|&c| (places[c].len(), diagonal(c))) else {
                if rows[r].value.is_zero() {
                    continue;
                }
                return None;
            };
            let lead = rows[r].entries[&c].clone();
            if !lead.is_one() {
                rows[r].entries.values_mut().for_each(|q| *q /= &lead);
                rows[r].value /= lead;
            }
            pivots.push((c, r));
            let pivot = rows[r].clone();
            let long = pivot.entries.values().chain([&pivot.value]).map(bits).max().unwrap_or(0);
            for other in std::mem::take(&mut places[c]) {
                if other == r {
                    continue;
                }
                let by = rows[other].entries[&c].clone();
                // lowest terms take the square of the words that numbers have
                let words = 1 + (long + bits(&by)) / 64;
                let one = FRACTION.saturating_add(words.saturating_mul(words).saturating_mul(4));
                let width = pivot.entries.len() as u64;
                fuel.spend(width)
                    .and_then(|()| fuel.spend_beyond(width.saturating_mul(one)))
                    .ok()?;
                for (k, q) in &pivot.entries {
                    let entry = rows[other].entries.entry(*k).or_insert_with(Q::zero);
                    *entry -= &by * q;
                    if entry.is_zero() {
                        rows[other].entries.remove(k);
                        places[*k].remove(&other);
                    } else {
                        places[*k].insert(other);
                    }
                }
                rows[other].value -= &by * &pivot.value;
            }
        }
        let taken: BTreeSet<usize> = pivots.iter().map(|p| p.0).collect();
        let free = (0..columns.len()).filter(|c| !taken.contains(c)).collect();
        let solved = pivots.into_iter().map(|(c, r)| {
            let mut row = std::mem::take(&mut rows[r]);
            row.entries.remove(&c);
            (c, row)
        });
        let solved = solved.collect();
        Some(Self { columns, free, solved })
    }

    /// The values of all columns where the free ones are 0.
    pub(super) fn origin(&self) -> impl Iterator<Item = (usize, &Q)> {
        self.solved.iter().map(|(c, row)| (*c, &row.value))
    }

    /// How all columns change with each free one, in the order of those.
    pub(super) fn directions(&self) -> Vec<Vec<(usize, Q)>> {
        let mut out: BTreeMap<usize, Vec<(usize, Q)>> =
            self.free.iter().map(|&c| (c, vec![(c, Q::one())])).collect();
        for (c, row) in &self.solved {
            for (f, q) in &row.entries {
                if let Some(direction) = out.get_mut(f) {
                    direction.push((*c, -q));
                }
            }
        }
        self.free.iter().map(|f| out.remove(f).unwrap_or_default()).collect()
    }

    /// The values of all columns, from those of the free ones.
    pub(super) fn values(&self, free: &[Q]) -> Vec<Q> {
        let mut out = vec![Q::zero(); self.columns.len()];
        for (c, q) in self.free.iter().zip(free) {
            out[*c] = q.clone();
        }
        for (c, row) in &self.solved {
            let less: Q = row.entries.iter().map(|(f, q)| q * &out[*f]).sum();
            out[*c] = &row.value - less;
        }
        out
    }
}

/// Bits of a fraction.
fn bits(q: &Q) -> u64 {
    q.numer().bits() + q.denom().bits()
}
