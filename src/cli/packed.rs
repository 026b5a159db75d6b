//! Files packed by gzip.

use std::io::{Read as _, Write as _};

use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;

/// More than this is unpacked of no file: a small one may hold very much.
const MOST: u64 = 1 << 26;

/// The bytes, packed. Equal bytes give equal ones: no time and no name is with them.
pub(super) fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    // writing to memory does not fail
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    written.unwrap_or_default()
}

/// What is packed in the bytes; nothing if they are not packed, or hold too much.
pub(super) fn unpacked(bytes: &[u8]) -> Option<Vec<u8>> {
    let mut held = Vec::new();
    let read = GzDecoder::new(bytes).take(MOST).read_to_end(&mut held).ok()?;
    (u64::try_from(read).ok()? < MOST).then_some(held)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_comes_out_again() {
        let text = "claim (9) ".repeat(10_000);
        let small = packed(text.as_bytes());
        assert_eq!(small, packed(text.as_bytes()));
        assert!(small.len() < text.len() / 50 && small.starts_with(&[0x1f, 0x8b]));
        assert_eq!(unpacked(&small).as_deref(), Some(text.as_bytes()));
        assert_eq!(unpacked(b"claim"), None);
        assert_eq!(unpacked(&small[..small.len() - 1]), None);
    }
}
