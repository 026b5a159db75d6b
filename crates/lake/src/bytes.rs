//! Numbers and words as bytes, for what parts of a query hand to each other.

use crate::fault::LakeFault;

/// Writes, little-endian.
#[derive(Default)]
pub(crate) struct Writer(pub(crate) Vec<u8>);

impl Writer {
    pub(crate) fn count(&mut self, value: u64) {
        self.0.extend_from_slice(&value.to_le_bytes());
    }

    pub(crate) fn float(&mut self, value: f64) {
        self.count(value.to_bits());
    }

    pub(crate) fn flag(&mut self, value: bool) {
        self.0.push(u8::from(value));
    }

    pub(crate) fn bytes(&mut self, value: &[u8]) {
        self.count(value.len() as u64);
        self.0.extend_from_slice(value);
    }

    pub(crate) fn text(&mut self, value: &str) {
        self.bytes(value.as_bytes());
    }
}

/// Reads what [`Writer`] wrote; every end that comes too early is an error.
pub(crate) struct Reader<'a>(pub(crate) &'a [u8]);

const SHORT: LakeFault = LakeFault::Parts("a summary ends too early");

impl<'a> Reader<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], LakeFault> {
        let (taken, rest) = self.0.split_at_checked(count).ok_or(SHORT)?;
        self.0 = rest;
        Ok(taken)
    }

    pub(crate) fn count(&mut self) -> Result<u64, LakeFault> {
        let bytes = self.take(8)?.try_into().map_err(|_| SHORT)?;
        Ok(u64::from_le_bytes(bytes))
    }

    pub(crate) fn float(&mut self) -> Result<f64, LakeFault> {
        Ok(f64::from_bits(self.count()?))
    }

    pub(crate) fn flag(&mut self) -> Result<bool, LakeFault> {
        Ok(self.take(1)?[0] != 0)
    }

    pub(crate) fn bytes(&mut self) -> Result<&'a [u8], LakeFault> {
        let count = usize::try_from(self.count()?).map_err(|_| SHORT)?;
        self.take(count)
    }

    pub(crate) fn text(&mut self) -> Result<&'a str, LakeFault> {
        std::str::from_utf8(self.bytes()?).map_err(|_| LakeFault::Parts("a name is not UTF-8"))
    }

    /// A count of things that follow, none of which is shorter than a byte.
    pub(crate) fn length(&mut self) -> Result<usize, LakeFault> {
        let count = usize::try_from(self.count()?).map_err(|_| SHORT)?;
        if count <= self.0.len() { Ok(count) } else { Err(SHORT) }
    }
}
