//! Exact numbers from what people type, and their domains.

use kane_number::{ParseError, Rational, Rounding, encode, parse};

/// What a value must be.
#[derive(Clone, Copy, Debug)]
pub enum Domain {
    /// any number
    Any,
    /// above zero
    Positive,
    /// at least zero
    NotNegative,
    /// from 0 to 1
    Fraction,
    /// above 1
    AboveOne,
    /// strictly between −n and n
    Within(u8),
}

impl Domain {
    fn holds(self, value: &Rational) -> bool {
        let n = |n: u8| Rational::from_integer(n.into());
        match self {
            Self::Any => true,
            Self::Positive => *value > n(0),
            Self::NotNegative => *value >= n(0),
            Self::Fraction => *value >= n(0) && *value <= n(1),
            Self::AboveOne => *value > n(1),
            Self::Within(bound) => *value < n(bound) && *value > -n(bound),
        }
    }

    fn in_words(self) -> String {
        match self {
            Self::Any => "a number".to_owned(),
            Self::Positive => "above 0".to_owned(),
            Self::NotNegative => "at least 0".to_owned(),
            Self::Fraction => "from 0 to 1".to_owned(),
            Self::AboveOne => "above 1".to_owned(),
            Self::Within(bound) => format!("between -{bound} and {bound}, ends excluded"),
        }
    }
}

/// Reads an exact number of a size that floats have too.
///
/// # Errors
/// What is wrong with the text, in words that follow the name of the quantity.
pub fn read(text: &str) -> Result<Rational, String> {
    let value = parse(text).map_err(|error| {
        let hint = match error {
            ParseError::TooManyDigits { .. } | ParseError::ExponentTooLarge { .. } => "",
            _ => "; write a decimal (0.092, 1e-3) or a fraction (1/3)",
        };
        format!("cannot be {}: {error}{hint}", shown(text))
    })?;
    let float: f64 = encode(&value, Rounding::NearestEven);
    let zero = Rational::default();
    let vanishes = value != zero && kane_number::decode(float).is_ok_and(|float| float == zero);
    if !float.is_finite() || vanishes {
        return Err(format!("is {}, beyond the range of f64, about 1e-323 to 1e308", shown(text)));
    }
    Ok(value)
}

/// The text, or its beginning.
fn shown(text: &str) -> String {
    let start: String = text.chars().take(40).collect();
    if start.is_empty() {
        "empty".to_owned()
    } else if start.len() < text.len() {
        format!("{start}…")
    } else {
        start
    }
}

/// Reads a number of a domain.
///
/// # Errors
/// As [`read`], or that the number is outside the domain.
pub fn read_in(text: &str, domain: Domain) -> Result<Rational, String> {
    let value = read(text)?;
    if domain.holds(&value) {
        Ok(value)
    } else {
        Err(format!("is {}, but must be {}", shown(text), domain.in_words()))
    }
}
