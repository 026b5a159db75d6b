//! A bounded choice of rows, the same in every run.

/// Keeps every row until it is full, then every second, every fourth and so on: at least half of
/// the capacity, spread evenly over the log.
#[derive(Clone, Debug)]
pub struct Sample<T> {
    kept: Vec<T>,
    capacity: usize,
    /// a power of two
    stride: u64,
    seen: u64,
}

impl<T> Sample<T> {
    /// Keeps at most so many.
    #[must_use]
    pub fn new(capacity: usize) -> Self {
        Self { kept: Vec::new(), capacity: capacity.max(2), stride: 1, seen: 0 }
    }

    /// Whether the next row is one to keep.
    #[must_use]
    pub fn wants(&self) -> bool {
        self.seen & (self.stride - 1) == 0
    }

    /// Counts a row, and keeps it if it is wanted.
    pub fn offer(&mut self, make: impl FnOnce() -> T) {
        if self.wants() {
            if self.kept.len() == self.capacity {
                let mut place = 0_usize;
                self.kept.retain(|_| {
                    place += 1;
                    place % 2 == 1
                });
                self.stride *= 2;
            }
            if self.wants() {
                self.kept.push(make());
            }
        }
        self.seen += 1;
    }

    /// What was kept.
    #[must_use]
    pub fn kept(&self) -> &[T] {
        &self.kept
    }

    /// How many were offered.
    #[must_use]
    pub const fn seen(&self) -> u64 {
        self.seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_is_spread_evenly_and_bounded() {
        let mut sample = Sample::new(8);
        (0..100).for_each(|i| sample.offer(|| i));
        assert_eq!(sample.kept(), [0, 16, 32, 48, 64, 80, 96]);
        assert_eq!(sample.seen(), 100);
        let mut small = Sample::new(8);
        (0..8).for_each(|i| small.offer(|| i));
        assert_eq!(small.kept().len(), 8);
    }
}
