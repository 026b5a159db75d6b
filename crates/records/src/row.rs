//! One row of a log, as numbers.

use kane_impact::bodies::Shape;

use crate::rejection::Reason;
use crate::schema::{COLUMNS, Column, Side};

/// The numbers of a row, and where it stands.
#[derive(Clone, Debug)]
pub struct Row {
    values: [f64; COLUMNS],
    present: u64,
    /// the line of the file, from 1
    pub line: u64,
    /// the name of the row; empty without one
    pub id: String,
    /// the place of its pair of materials among those seen so far
    pub pair: u32,
    /// the shapes, where given
    pub shapes: [Option<Shape>; 2],
}

impl Row {
    /// A row without numbers.
    #[must_use]
    pub const fn empty(line: u64) -> Self {
        Self {
            values: [0.0; COLUMNS],
            present: 0,
            line,
            id: String::new(),
            pair: 0,
            shapes: [None; 2],
        }
    }

    /// Clears it for the next line.
    pub fn clear(&mut self, line: u64) {
        (self.present, self.line, self.pair) = (0, line, 0);
        self.id.clear();
        self.shapes = [None; 2];
    }

    /// Sets a number.
    #[inline]
    pub const fn set(&mut self, column: Column, value: f64) {
        self.values[column.index()] = value;
        self.present |= 1 << column.index();
    }

    /// Sets the number at a place of the schema, see [`Column::index`]; a place that there is not is
    /// passed over.
    pub fn set_place(&mut self, place: usize, value: f64) {
        if let Some(cell) = self.values.get_mut(place) {
            *cell = value;
            self.present |= 1 << place;
        }
    }

    /// The numbers that the row has, each with its place in the schema.
    pub fn numbers(&self) -> impl Iterator<Item = (usize, f64)> {
        let mut left = self.present;
        std::iter::from_fn(move || {
            let place = left.trailing_zeros() as usize;
            let value = self.values.get(place)?;
            left &= left - 1;
            Some((place, *value))
        })
    }

    /// A number, if the row has it.
    #[inline]
    #[must_use]
    pub const fn get(&self, column: Column) -> Option<f64> {
        let index = column.index();
        if self.present & (1 << index) == 0 { None } else { Some(self.values[index]) }
    }

    /// A number, or zero.
    #[inline]
    #[must_use]
    pub const fn or_zero(&self, column: Column) -> f64 {
        match self.get(column) {
            Some(value) => value,
            None => 0.0,
        }
    }

    /// A number that must be there.
    ///
    /// # Errors
    /// [`Reason::Missing`] if it is not.
    #[inline]
    pub fn need(&self, column: Column) -> Result<f64, Reason> {
        self.get(column).ok_or(Reason::Missing(column))
    }

    /// That the row has all of these; `mask` is their [`mask`](Self::mask), made once.
    ///
    /// # Errors
    /// [`Reason::Missing`] for the first that it has not.
    #[inline]
    pub fn need_all(&self, columns: &[Column], mask: u64) -> Result<(), Reason> {
        if self.present & mask == mask {
            return Ok(());
        }
        columns.iter().try_for_each(|column| self.need(*column).map(drop))
    }

    /// Whether the row has one of these that is not zero; by their [`mask`](Self::mask).
    #[inline]
    #[must_use]
    pub fn any_is_not_zero(&self, mask: u64) -> bool {
        self.present & mask != 0
            && self.numbers().any(|(place, value)| mask & (1 << place) != 0 && value != 0.0)
    }

    /// The columns as bits.
    #[must_use]
    pub const fn mask(columns: &[Column]) -> u64 {
        let (mut mask, mut place) = (0, 0);
        while place < columns.len() {
            mask |= 1 << columns[place].index();
            place += 1;
        }
        mask
    }

    /// The shape of a body whose inertia is not given.
    #[inline]
    #[must_use]
    pub fn stated_shape(&self, side: Side) -> Option<Shape> {
        let shape = self.shapes[usize::from(side == Side::Second)];
        shape.filter(|_| self.get(Column::Inertia(side)).is_none())
    }

    /// Whether the row has a second body.
    #[must_use]
    pub const fn has_second(&self) -> bool {
        self.get(Column::Mass(Side::Second)).is_some()
    }
}
