//! A bounded choice of rows that does not depend on the order in which they come.

use std::collections::BTreeMap;

use kane_records::row::Row;

/// The rows of the smallest hashes: of the rows that differ, as many as there is room for, chosen as
/// by lot and alike however a log is cut into parts. Rows that are equal in all their numbers are one,
/// with a count; two that differ share a hash of 64 bits once in some 10^11 logs.
#[derive(Clone, Debug)]
pub(crate) struct Choice {
    room: usize,
    kept: BTreeMap<u64, Chosen>,
    /// the largest hash that is still wanted
    most: u64,
    /// bytes of the rows that are kept
    bytes: usize,
}

/// A row that was chosen.
#[derive(Clone, Debug)]
pub(crate) struct Chosen {
    pub(crate) count: u64,
    pub(crate) row: Box<[u8]>,
}

impl Choice {
    pub(crate) const fn new(room: usize) -> Self {
        Self { room, kept: BTreeMap::new(), most: u64::MAX, bytes: 0 }
    }

    /// Offers so many rows of this hash; `make` writes the row down if it is kept.
    #[inline]
    pub(crate) fn offer(&mut self, hash: u64, count: u64, make: impl FnOnce() -> Box<[u8]>) {
        if hash <= self.most {
            self.keep(hash, count, make);
        }
    }

    fn keep(&mut self, hash: u64, count: u64, make: impl FnOnce() -> Box<[u8]>) {
        if let Some(chosen) = self.kept.get_mut(&hash) {
            chosen.count += count;
            return;
        }
        let row = make();
        self.bytes += row.len();
        self.kept.insert(hash, Chosen { count, row });
        if self.kept.len() > self.room {
            self.bytes -= self.kept.pop_last().map_or(0, |(_, last)| last.row.len());
        }
        if self.kept.len() == self.room {
            self.most = self.kept.last_key_value().map_or(u64::MAX, |(most, _)| *most);
        }
    }

    pub(crate) fn merge(&mut self, other: &Self) {
        for (hash, chosen) in &other.kept {
            self.offer(*hash, chosen.count, || chosen.row.clone());
        }
    }

    /// The rows by their hashes.
    pub(crate) const fn kept(&self) -> &BTreeMap<u64, Chosen> {
        &self.kept
    }

    /// Bytes of memory, about.
    pub(crate) fn size(&self) -> usize {
        self.bytes + 64 * self.kept.len()
    }
}

/// A hash of the numbers of a row, of their places, and of its words but its name: multiplications and
/// shifts of 64 bits, each of which can be undone, so that rows that differ in one number alone never
/// share a hash.
pub(crate) fn hash(row: &Row, pair: &str) -> u64 {
    let numbers = row.numbers().fold(START, |hash, (place, value)| numbered(hash, place, value));
    worded(numbers, row, pair)
}

/// The hash of a row of nothing.
pub(crate) const START: u64 = 0x243f_6a88_85a3_08d3;

/// A hash with one number more; they are taken by rising places.
#[inline]
pub(crate) fn numbered(hash: u64, place: usize, value: f64) -> u64 {
    mix(hash.rotate_left(u32::try_from(place).unwrap_or(0)), value.to_bits())
}

/// A hash of the numbers with the words.
pub(crate) fn worded(numbers: u64, row: &Row, pair: &str) -> u64 {
    let shapes = row.shapes.iter().flatten().map(|shape| shape.name());
    shapes.chain([pair]).flat_map(str::bytes).fold(numbers, |hash, byte| mix(hash, u64::from(byte)))
}

#[inline]
const fn mix(hash: u64, word: u64) -> u64 {
    let mixed = (hash ^ word).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    mixed ^ (mixed >> 32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chosen(hashes: &[u64]) -> Choice {
        let mut choice = Choice::new(3);
        hashes.iter().for_each(|hash| choice.offer(*hash, 1, || Box::from([])));
        choice
    }

    #[test]
    fn the_choice_is_the_same_in_every_order_and_from_any_parts() {
        let counts = |choice: &Choice| -> Vec<(u64, u64)> {
            choice.kept().iter().map(|(hash, chosen)| (*hash, chosen.count)).collect()
        };
        let whole = chosen(&[5, 3, 9, 3, 1, 9, 5, 3]);
        assert_eq!(counts(&whole), [(1, 1), (3, 3), (5, 2)]);
        assert_eq!(counts(&chosen(&[9, 9, 5, 1, 3, 3, 5, 3])), counts(&whole));
        let mut merged = chosen(&[3, 5, 9]);
        merged.merge(&chosen(&[9, 3, 1, 5, 3]));
        assert_eq!(counts(&merged), counts(&whole));
    }

    #[test]
    fn the_size_is_that_of_the_rows_that_are_kept() {
        let mut choice = Choice::new(3);
        for (hash, length) in [(7, 9), (2, 1), (9, 80), (2, 5), (4, 20), (1, 3)] {
            choice.offer(hash, 1, || vec![0; length].into_boxed_slice());
        }
        let counted: usize = choice.kept().values().map(|chosen| chosen.row.len() + 64).sum();
        assert_eq!(choice.size(), counted);
    }
}
