//! A table of floats, byte by byte from the sign on, with the numbers that they are.
//!
//! It was written from the definition of the formats (IEEE 754, 2019, section 3.4), and names no width of a machine and
//! no order of its bytes: what passes here does so on a machine of 32 bits and on one that stores the high byte first,
//! since the bridge between floats and numbers moves no bytes but by `to_bits` and `from_bits`.

use kane_number::{Rational, Rounding, decode, encode};

use crate::{rational, two_to};

/// Sign, exponent and fraction as bytes; the significand and the power of two that the number is.
const DOUBLES: [([u8; 8], i64, i64); 14] = [
    ([0x00, 0, 0, 0, 0, 0, 0, 0x00], 0, 0),
    ([0x00, 0, 0, 0, 0, 0, 0, 0x01], 1, -1074),
    ([0x80, 0, 0, 0, 0, 0, 0, 0x01], -1, -1074),
    ([0x00, 0, 0, 0, 0, 0, 1, 0x00], 1, -1066),
    ([0x00, 0x0f, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff], (1 << 52) - 1, -1074),
    ([0x00, 0x10, 0, 0, 0, 0, 0, 0x00], 1, -1022),
    ([0x00, 0x10, 0, 0, 0, 0, 0, 0x01], (1 << 52) + 1, -1074),
    ([0x3f, 0xb9, 0x99, 0x99, 0x99, 0x99, 0x99, 0x9a], 0x0019_9999_9999_999a, -56),
    ([0x3f, 0xf0, 0, 0, 0, 0, 0, 0x00], 1, 0),
    ([0xbf, 0xf8, 0, 0, 0, 0, 0, 0x00], -3, -1),
    ([0x40, 0x09, 0x21, 0xfb, 0x54, 0x44, 0x2d, 0x18], 0x0019_21fb_5444_2d18, -51),
    ([0x43, 0x40, 0, 0, 0, 0, 0, 0x01], (1 << 52) + 1, 1),
    ([0x7f, 0xef, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff], (1 << 53) - 1, 971),
    ([0xff, 0xef, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff], 1 - (1 << 53), 971),
];

/// The same in 32 bits.
const SINGLES: [([u8; 4], i64, i64); 10] = [
    ([0x00, 0, 0, 0x00], 0, 0),
    ([0x00, 0, 0, 0x01], 1, -149),
    ([0x80, 0, 1, 0x00], -1, -141),
    ([0x00, 0x7f, 0xff, 0xff], (1 << 23) - 1, -149),
    ([0x00, 0x80, 0, 0x00], 1, -126),
    ([0x3d, 0xcc, 0xcc, 0xcd], 0x00cc_cccd, -27),
    ([0x3f, 0x80, 0, 0x00], 1, 0),
    ([0x40, 0x49, 0x0f, 0xdb], 0x00c9_0fdb, -22),
    ([0x4b, 0x80, 0, 0x01], (1 << 23) + 1, 1),
    ([0xff, 0x7f, 0xff, 0xff], 1 - (1 << 24), 104),
];

fn number(significand: i64, exponent: i64) -> Rational {
    rational(significand, 1) * two_to(exponent)
}

#[test]
fn floats_are_the_numbers_of_the_table_and_the_numbers_these_floats() {
    for rounding in [Rounding::NearestEven, Rounding::Down, Rounding::Up] {
        for (bytes, significand, exponent) in DOUBLES {
            let exact = number(significand, exponent);
            assert_eq!(decode(f64::from_be_bytes(bytes)).ok(), Some(exact.clone()), "{bytes:x?}");
            assert_eq!(encode::<f64>(&exact, rounding).to_be_bytes(), bytes, "{exact}");
        }
        for (bytes, significand, exponent) in SINGLES {
            let exact = number(significand, exponent);
            assert_eq!(decode(f32::from_be_bytes(bytes)).ok(), Some(exact.clone()), "{bytes:x?}");
            assert_eq!(encode::<f32>(&exact, rounding).to_be_bytes(), bytes, "{exact}");
        }
    }
}
