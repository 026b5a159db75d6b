//! Intervals against inari, whose ends are rounded by the instructions of the processor: the same ends, but for a step
//! further out where an end is below 2^−959, or a numerator from 2^1022 on.
#![no_main]

use kane_number::{Interval, Number};
use libfuzzer_sys::fuzz_target;

/// Whether an end is that of inari, or one step further out where it may be.
fn is_same(own: f64, theirs: f64, outward: fn(f64) -> f64, small: bool) -> bool {
    own == theirs || small && own == outward(theirs)
}

fn assert_same(what: &str, own: Interval, theirs: inari::Interval, small: bool) {
    let near_zero = |x: f64| x.abs() < 2_f64.powi(-959);
    let (low, high) = (theirs.inf(), theirs.sup());
    let small_low = small || near_zero(low);
    let small_high = small || near_zero(high);
    assert!(
        is_same(own.lower(), low, f64::next_down, small_low)
            && is_same(own.upper(), high, f64::next_up, small_high),
        "{what}: {own} and {theirs:?}"
    );
}

fuzz_target!(|data: &[u8]| {
    let Some((bytes, _)) = data.split_first_chunk::<32>() else { return };
    let mut ends = [0.0; 4];
    for (end, bytes) in ends.iter_mut().zip(bytes.as_chunks::<8>().0) {
        *end = f64::from_be_bytes(*bytes);
    }
    if ends.iter().any(|end| !end.is_finite()) {
        return;
    }
    let [a, b, c, d] = ends;
    let pair = |a: f64, b: f64| {
        let theirs = inari::Interval::try_from((a.min(b), a.max(b))).expect("ends in their order");
        (Interval::between(a, b), theirs)
    };
    let ((x, p), (y, q)) = (pair(a, b), pair(c, d));
    assert_same("sum", x + y, p + q, false);
    assert_same("difference", x - y, p - q, false);
    assert_same("product", x * y, p * q, false);
    // a product with which the quotient is held against the numerator may underflow, or overflow
    let extreme = |end: &f64| end.abs() < 2_f64.powi(-959) || end.abs() >= 2_f64.powi(1022);
    let step = [a, b].iter().any(extreme);
    if let Some(quotient) = x.checked_div(&y) {
        assert_same("quotient", quotient, p / q, step);
    }
    if let Some(root) = x.sqrt() {
        assert_same("root", root, p.sqrt(), step);
    }
});
