//! Gram matrices: squares of a basis times a product, and the equations between their entries.

use std::collections::{BTreeMap, BTreeSet};

use kane_kernel::{Fuel, Monomial, Poly};
use num_traits::{One, Signed, Zero};

use super::elimination::{Column, Row, System};
use super::grading::Grading;
use super::{COLUMNS, Q, Question, ROWS, total_degree};

/// What an entry of the equations costs beside its product, in coefficient operations.
const ENTRY: u64 = 20;

/// A basis whose squares are multiplied by a product.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) product: usize,
    pub(super) basis: Vec<Poly>,
}

/// The unknowns of an identity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Gram {
    pub(super) blocks: Vec<Block>,
    /// monomials that a cofactor may have, by equation
    pub(super) cofactors: Vec<(usize, Monomial)>,
    /// how many equations there are
    pub(super) equations: usize,
}

impl Gram {
    /// All monomials that the degrees leave; `None` if those are too many.
    pub(super) fn of(question: &Question<'_>, fuel: &Fuel) -> Option<Self> {
        let polys =
            || [question.positive].into_iter().chain(question.products).chain(question.equations);
        let vars: BTreeSet<usize> = polys().flat_map(Poly::vars).collect();
        // No variable needs a higher power than it has somewhere, made even; and what the degree asked
        // for has to spare.
        let spare = polys().map(total_degree).max().unwrap_or(0).next_multiple_of(2);
        let spare = question.degree.saturating_sub(spare);
        let most = |v: usize| polys().map(|p| p.degree(v)).max().unwrap_or(0).next_multiple_of(2);
        let most: Vec<(usize, u32)> = vars.iter().map(|&v| (v, most(v) + spare)).collect();
        // Between forms each degree is an identity of its own: that of P is enough.
        let forms = polys().all(is_form);
        let exactly = forms.then(|| total_degree(question.positive));
        let room = |p: &Poly| {
            let left = |&(v, n): &(usize, u32)| (v, n.saturating_sub(p.degree(v)));
            (
                exactly.unwrap_or(question.degree).checked_sub(total_degree(p)),
                most.iter().map(left).collect::<Vec<_>>(),
            )
        };
        let grading = Grading::of(question);
        let mut blocks = Vec::new();
        for (product, p) in question.products.iter().enumerate() {
            let (Some(degree), room) = room(p) else { continue };
            let halves: Vec<(usize, u32)> = room.iter().map(|&(v, n)| (v, n / 2)).collect();
            if forms && degree % 2 == 1 {
                continue;
            }
            let monomials = monomials(&halves, (degree / 2, forms), ROWS * 4)?;
            // a multiple of P itself is in its scale
            if p == question.positive && monomials.iter().all(Vec::is_empty) {
                continue;
            }
            let bases = grading.bases(question, p, monomials);
            blocks.extend(bases.map(|basis| Block { product, basis }));
        }
        let mut cofactors = Vec::new();
        for (equation, p) in question.equations.iter().enumerate() {
            let (Some(degree), room) = room(p) else { continue };
            let monomials = monomials(&room, (degree, forms), COLUMNS)?;
            let useful = monomials.into_iter().filter(|m| grading.cofactor(question, p, m));
            cofactors.extend(useful.map(|m| (equation, m)));
        }
        let mut gram = Self { blocks, cofactors, equations: question.equations.len() };
        // What can only be zero goes: Newton's polytope, as far as diagonals show it.
        let columns = gram.columns();
        if columns > 4 * COLUMNS {
            return None;
        }
        let system = gram.system(question, fuel)?;
        let mut gone = BTreeSet::new();
        loop {
            fuel.spend(columns as u64).ok()?;
            let idle = idle(&system, &gone)?;
            if idle.is_empty() {
                break;
            }
            gone.extend(idle);
        }
        for (b, block) in gram.blocks.iter_mut().enumerate() {
            let mut rows = 0..;
            block.basis.retain(|_| rows.next().is_none_or(|row| !gone.contains(&(b, row))));
        }
        for contact in question.contacts {
            for block in &mut gram.blocks {
                if let Some(degree) = contact.closes(question, &question.products[block.product]) {
                    block.basis = contact.vanishing(&block.basis, degree);
                }
            }
        }
        gram.blocks.retain(|block| !block.basis.is_empty());
        (gram.columns() <= COLUMNS).then_some(gram)
    }

    /// The number of unknowns.
    fn columns(&self) -> usize {
        self.sizes().iter().map(|n| n * (n + 1) / 2).sum::<usize>() + self.cofactors.len()
    }

    /// The number of rows of each block.
    pub(super) fn sizes(&self) -> Vec<usize> {
        self.blocks.iter().map(|b| b.basis.len()).collect()
    }

    /// One equation for each monomial of the identity.
    pub(super) fn system(&self, question: &Question<'_>, fuel: &Fuel) -> Option<System> {
        let mut columns = Vec::new();
        let mut rows: BTreeMap<Monomial, Row> = BTreeMap::new();
        for (m, c) in question.positive.terms() {
            rows.entry(m.to_vec()).or_default().value = Q::from(-c);
        }
        let mut add = |column: Column, p: &Poly| -> Option<()> {
            fuel.spend_beyond(ENTRY * p.len() as u64).ok()?;
            for (m, c) in p.terms() {
                rows.entry(m.to_vec())
                    .or_default()
                    .entries
                    .insert(columns.len(), Q::from(c.clone()));
            }
            columns.push(column);
            Some(())
        };
        for (b, block) in self.blocks.iter().enumerate() {
            let product = &question.products[block.product];
            for (i, p) in block.basis.iter().enumerate() {
                let scaled = p.mul(product, fuel).ok()?;
                for (j, q) in block.basis.iter().enumerate().skip(i) {
                    let both = scaled.mul(q, fuel).ok()?;
                    let both = if i == j { both } else { both.add(&both) };
                    add(Column::Entry { block: b, row: i, column: j }, &both)?;
                }
            }
        }
        for (equation, m) in &self.cofactors {
            let p = Poly::term(m.clone(), One::one());
            let multiple = p.mul(&question.equations[*equation], fuel).ok()?;
            add(Column::Cofactor { equation: *equation, monomial: m.clone() }, &multiple)?;
        }
        Some(System { columns, rows: rows.into_values().collect() })
    }
}

/// Places of bases, as (block, row), whose squares have to vanish once others have: they meet nothing that could
/// cancel them. `None` if something cannot be cancelled at all.
fn idle(system: &System, gone: &BTreeSet<(usize, usize)>) -> Option<BTreeSet<(usize, usize)>> {
    let vanishes = |column: &Column| match *column {
        Column::Entry { block, row, column } => {
            gone.contains(&(block, row)) || gone.contains(&(block, column))
        }
        Column::Cofactor { .. } => false,
    };
    let vanishes: Vec<bool> = system.columns.iter().map(vanishes).collect();
    let mut out = BTreeSet::new();
    for row in &system.rows {
        let entries = || row.entries.iter().filter(|entry| !vanishes[*entry.0]);
        let square = |(column, _): (&usize, &Q)| match system.columns[*column] {
            Column::Entry { block, row, column } if row == column => Some((block, row)),
            _ => None,
        };
        let Some(squares) = entries().map(square).collect::<Option<Vec<_>>>() else {
            continue;
        };
        let one_sign = |positive: bool| entries().all(|(_, q)| q.is_positive() == positive);
        let (up, down) = (one_sign(true), one_sign(false));
        if row.value.is_zero() && (up || down) {
            out.extend(squares);
        } else if (up && row.value.is_negative()) || (down && row.value.is_positive()) {
            return None;
        }
    }
    Some(out)
}

/// Whether all terms of a polynomial have the same degree.
fn is_form(p: &Poly) -> bool {
    let mut degrees = p.terms().map(|(m, _)| m.iter().map(|f| f.1).sum::<u32>());
    let first = degrees.next();
    degrees.all(|d| Some(d) == first)
}

/// All monomials within a degree, or of just that degree, and a degree for each variable; `None` if
/// there are more than some.
fn monomials(
    most: &[(usize, u32)],
    (degree, exactly): (u32, bool),
    count: usize,
) -> Option<Vec<Monomial>> {
    let mut out: Vec<(Monomial, u32)> = vec![(Vec::new(), 0)];
    for &(v, n) in most {
        let mut next = Vec::new();
        for (m, used) in &out {
            for e in 0..=n.min(degree - used) {
                let mut m = m.clone();
                if e > 0 {
                    m.push((v, e));
                }
                next.push((m, used + e));
                if next.len() > count {
                    return None;
                }
            }
        }
        out = next;
    }
    out.retain(|(_, used)| !exactly || *used == degree);
    out.sort_by(|a, b| a.1.cmp(&b.1).then_with(|| a.0.cmp(&b.0)));
    Some(out.into_iter().map(|(m, _)| m).collect())
}
