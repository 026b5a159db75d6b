//! Exact numbers as people write them.

use num_traits::{Pow, Zero};

use crate::{Integer, Rational};

/// The most digits that a literal may have, over all its parts.
pub const MAX_DIGITS: usize = 10_000;

/// The greatest magnitude of a decimal exponent.
pub const MAX_EXPONENT: u32 = 10_000;

/// Why a text is not a number; `at` is a byte offset into the text.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum ParseError {
    /// Digits were expected and none is there.
    #[error("expected a digit at byte {at}")]
    MissingDigits {
        /// Where the digit should be.
        at: usize,
    },
    /// A complete number is followed by something else.
    #[error("unexpected {found:?} at byte {at}")]
    Trailing {
        /// Where the number ended.
        at: usize,
        /// The character found there.
        found: char,
    },
    /// The literal is longer than [`MAX_DIGITS`].
    #[error("more than {limit} digits at byte {at}", limit = MAX_DIGITS)]
    TooManyDigits {
        /// The first digit beyond the limit.
        at: usize,
    },
    /// The decimal exponent is beyond ±[`MAX_EXPONENT`].
    #[error("exponent {exponent} at byte {at} is beyond ±{limit}", limit = MAX_EXPONENT)]
    ExponentTooLarge {
        /// Where the exponent's digits start.
        at: usize,
        /// The digits of the exponent as written, cut short after six with an ellipsis.
        exponent: String,
    },
    /// The denominator is zero.
    #[error("the denominator at byte {at} is zero")]
    ZeroDenominator {
        /// Where the denominator starts.
        at: usize,
    },
}

/// Reads an exact number: an integer, a decimal, a decimal with exponent, or a fraction of integers.
///
/// ```text
/// number   = sign? (fraction | decimal)
/// fraction = digits "/" digits
/// decimal  = (digits ("." digits?)? | "." digits) (("e" | "E") sign? digits)?
/// sign     = "+" | "-"
/// ```
///
/// Exact: `0.1` is 1/10. No spaces and no digit separators. The limits [`MAX_DIGITS`] and
/// [`MAX_EXPONENT`] keep the result below about 70 000 bits whatever the input.
///
/// # Errors
/// [`ParseError`], with the byte at which reading stopped.
///
/// ```
/// use kane_number::parse;
/// assert_eq!(parse("1e-3")?, parse("1/1000")?);
/// assert_eq!(parse("-0.4")?.to_string(), "-2/5");
/// # Ok::<(), kane_number::ParseError>(())
/// ```
pub fn parse(text: &str) -> Result<Rational, ParseError> {
    let mut reader = Reader { text, at: 0, digits_left: MAX_DIGITS };
    let negative = reader.sign();
    let magnitude = reader.magnitude()?;
    match reader.rest().chars().next() {
        Some(found) => Err(ParseError::Trailing { at: reader.at, found }),
        None if negative => Ok(-magnitude),
        None => Ok(magnitude),
    }
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    digits_left: usize,
}

impl<'a> Reader<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    fn take(&mut self, wanted: &[char]) -> bool {
        let found = self.rest().starts_with(wanted);
        // Every wanted character is ASCII, hence one byte.
        self.at += usize::from(found);
        found
    }

    fn sign(&mut self) -> bool {
        let negative = self.rest().starts_with('-');
        self.take(&['-', '+']);
        negative
    }

    /// The longest run of digits, possibly empty, within the budget.
    fn digits(&mut self) -> Result<&'a str, ParseError> {
        let rest = self.rest();
        let length = rest.bytes().take_while(u8::is_ascii_digit).count();
        if length > self.digits_left {
            return Err(ParseError::TooManyDigits { at: self.at + self.digits_left });
        }
        self.digits_left -= length;
        self.at += length;
        Ok(&rest[..length])
    }

    fn some_digits(&mut self) -> Result<&'a str, ParseError> {
        let digits = self.digits()?;
        if digits.is_empty() {
            return Err(ParseError::MissingDigits { at: self.at });
        }
        Ok(digits)
    }

    fn magnitude(&mut self) -> Result<Rational, ParseError> {
        let whole = self.digits()?;
        if !whole.is_empty() && self.take(&['/']) {
            let at = self.at;
            let denominator = integer(self.some_digits()?);
            if denominator.is_zero() {
                return Err(ParseError::ZeroDenominator { at });
            }
            return Ok(Rational::new(integer(whole), denominator));
        }
        let fraction = match (self.take(&['.']), whole.is_empty()) {
            (true, true) => self.some_digits()?,
            (true, false) => self.digits()?,
            (false, true) => return Err(ParseError::MissingDigits { at: self.at }),
            (false, false) => "",
        };
        let mantissa = integer(&[whole, fraction].concat());
        let places = i64::try_from(fraction.len()).expect("bounded by MAX_DIGITS");
        let power = self.exponent()? - places;
        let scale = Integer::from(10).pow(power.unsigned_abs());
        Ok(if power >= 0 {
            Rational::from_integer(mantissa * scale)
        } else {
            Rational::new(mantissa, scale)
        })
    }

    fn exponent(&mut self) -> Result<i64, ParseError> {
        if !self.take(&['e', 'E']) {
            return Ok(0);
        }
        let negative = self.sign();
        let at = self.at;
        let digits = self.some_digits()?;
        let magnitude = match digits.parse::<u32>() {
            Ok(magnitude) if magnitude <= MAX_EXPONENT => i64::from(magnitude),
            _ => {
                let cut = if digits.len() > 6 { "…" } else { "" };
                let exponent = digits.chars().take(6).collect::<String>() + cut;
                return Err(ParseError::ExponentTooLarge { at, exponent });
            }
        };
        Ok(if negative { -magnitude } else { magnitude })
    }
}

fn integer(digits: &str) -> Integer {
    Integer::parse_bytes(digits.as_bytes(), 10).expect("a non-empty run of decimal digits")
}
