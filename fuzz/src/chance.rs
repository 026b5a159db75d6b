//! Chance that the input decides: libFuzzer changes the bytes, and so what is drawn.

use num_rational::BigRational;

pub type Q = BigRational;

/// n/d
#[must_use]
pub fn q(n: i64, d: i64) -> Q {
    Q::new(n.into(), d.into())
}

/// The bytes of an input, one after another; 0 where they end.
#[derive(Debug)]
pub struct Chance {
    bytes: Vec<u8>,
    read: usize,
}

impl Chance {
    #[must_use]
    pub fn new(data: &[u8]) -> Self {
        Self { bytes: data.to_vec(), read: 0 }
    }

    #[must_use]
    pub fn is_over(&self) -> bool {
        self.read >= self.bytes.len()
    }

    fn byte(&mut self) -> usize {
        let byte = self.bytes.get(self.read).copied().unwrap_or_default();
        self.read += 1;
        usize::from(byte)
    }

    /// One of 0, …, n − 1.
    pub fn below(&mut self, n: usize) -> usize {
        let high = if n > 256 { self.byte() << 8 } else { 0 };
        (high + self.byte()) % n.max(1)
    }

    /// An integer from lo to hi, both included.
    pub fn within(&mut self, lo: i64, hi: i64) -> i64 {
        let span = usize::try_from(hi - lo + 1).expect("an ordered range");
        lo + i64::try_from(self.below(span)).expect("a small range")
    }

    /// True once in n times.
    pub fn once_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    pub fn pick<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}
