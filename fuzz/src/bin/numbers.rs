//! The formats of numbers, there and back: floats through fractions, fractions through their text, and what is rounded
//! lies between its neighbours.
#![no_main]

use kane_number::{ParseError, Rational, Rounding, decode, encode, parse};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    let Some((bytes, rest)) = data.split_first_chunk::<8>() else { return };
    let float = f64::from_be_bytes(*bytes);
    if let Ok(exact) = decode(float) {
        assert_eq!(encode::<f64>(&exact, Rounding::NearestEven), float);
        assert_eq!(parse(&exact.to_string()).ok().unwrap_or_else(|| exact.clone()), exact);
        assert_eq!(
            parse(&format!("{float:e}")).map(|x| encode::<f64>(&x, Rounding::NearestEven)),
            Ok(float)
        );
    }
    let Some(text) = kane_fuzz::text(rest) else { return };
    let Ok(exact) = parse(text) else { return };
    match parse(&exact.to_string()) {
        Ok(read) => assert_eq!(read, exact, "a fraction is read as it is written"),
        // an exponent writes in a few digits what has more of them than are read
        Err(error) => assert!(matches!(error, ParseError::TooManyDigits { .. }), "{error}"),
    }
    let ends =
        [Rounding::Down, Rounding::NearestEven, Rounding::Up].map(|r| encode::<f64>(&exact, r));
    assert!(ends.is_sorted() && (ends[1] == ends[0] || ends[1] == ends[2]));
    let inside = |low: f64, high: f64| {
        decode(low).is_ok_and(|low: Rational| low <= exact)
            && decode(high).is_ok_and(|high| exact <= high)
    };
    assert!(inside(ends[0], ends[2]) || !(ends[0].is_finite() && ends[2].is_finite()));
    // what a program reads with its own library is the same float
    if let (Ok(own), true) = (text.trim().parse::<f64>(), !text.contains('/')) {
        assert_eq!(ends[1], own, "{text}");
    }
});
