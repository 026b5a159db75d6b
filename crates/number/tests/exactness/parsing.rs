use kane_number::{MAX_DIGITS, ParseError, decode, parse};

use crate::{quickcheck, rational, two_to};

#[test]
fn numbers_are_read_exactly() {
    for (text, numer, denom) in [
        ("0", 0, 1),
        ("-0", 0, 1),
        ("+12", 12, 1),
        ("0.4", 2, 5),
        ("-3/7", -3, 7),
        ("10/4", 5, 2),
        ("1e-3", 1, 1000),
        ("2.5e10", 25_000_000_000_i64, 1),
        ("2.5E+1", 25, 1),
        (".5", 1, 2),
        ("5.", 5, 1),
        ("007", 7, 1),
    ] {
        assert_eq!(parse(text), Ok(rational(numer, denom)), "{text}");
    }
}

#[test]
fn what_is_no_number_is_refused_with_its_place() {
    use ParseError::{MissingDigits, Trailing, ZeroDenominator};
    for (text, error) in [
        ("", MissingDigits { at: 0 }),
        ("-", MissingDigits { at: 1 }),
        (".", MissingDigits { at: 1 }),
        ("x", MissingDigits { at: 0 }),
        ("1/", MissingDigits { at: 2 }),
        ("1/-2", MissingDigits { at: 2 }),
        ("1e", MissingDigits { at: 2 }),
        ("1e+", MissingDigits { at: 3 }),
        ("3/0", ZeroDenominator { at: 2 }),
        ("1 ", Trailing { at: 1, found: ' ' }),
        ("1/2/3", Trailing { at: 3, found: '/' }),
        ("0.1/3", Trailing { at: 3, found: '/' }),
        ("2µ", Trailing { at: 1, found: 'µ' }),
        ("NaN", MissingDigits { at: 0 }),
        ("inf", MissingDigits { at: 0 }),
        ("−1", MissingDigits { at: 0 }),
    ] {
        assert_eq!(parse(text), Err(error), "{text}");
    }
}

#[test]
fn literals_have_a_budget() {
    let longest = "9".repeat(MAX_DIGITS);
    assert!(parse(&longest).is_ok());
    assert_eq!(parse(&format!("{longest}9")), Err(ParseError::TooManyDigits { at: MAX_DIGITS }));
    // The parts of a fraction share the budget.
    let fraction = format!("1/{longest}");
    assert_eq!(parse(&fraction), Err(ParseError::TooManyDigits { at: MAX_DIGITS + 1 }));
    assert_eq!(parse("1e10000"), Ok(rational(10, 1).pow(10_000)));
    for (text, exponent) in [("1e10001", "10001"), ("1e-99999999999", "999999…")] {
        let error = parse(text).expect_err("beyond the limit");
        let ParseError::ExponentTooLarge { exponent: shown, .. } = &error else {
            unreachable!("{error}");
        };
        assert_eq!(shown, exponent);
    }
}

#[test]
fn a_printed_number_is_read_back() {
    fn fraction_survives(numer: i64, denom: i64) -> bool {
        let exact = rational(numer, if denom == 0 { 1 } else { denom });
        parse(&exact.to_string()) == Ok(exact)
    }
    // Display writes every digit of the exact decimal expansion if asked for enough places.
    fn float_survives(bits: u64) -> bool {
        let float = f64::from_bits(bits);
        !float.is_finite() || parse(&format!("{float:.1074}")).ok() == decode(float).ok()
    }
    quickcheck(10_000).quickcheck(fraction_survives as fn(_, _) -> bool);
    quickcheck(1_000).quickcheck(float_survives as fn(_) -> bool);
    assert_eq!(parse(&format!("{:.1074}", f64::from_bits(1))), Ok(two_to(-1074)));
}

#[test]
fn no_text_makes_the_reader_panic() {
    fn returns(text: String) -> bool {
        parse(&text).is_ok() || parse(&text).is_err()
    }
    quickcheck(10_000).quickcheck(returns as fn(_) -> bool);
}
