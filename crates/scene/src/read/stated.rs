//! A number with what its author does not know of it.

use kane_number::{Interval, Number as _, Rational};

use super::number::{Domain, read_in};
use super::source::{Fault, Number, Source};

/// A value, known to within some distance.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stated {
    /// the value
    pub value: Rational,
    /// at least 0; the true value is at most so far away
    pub within: Rational,
}

impl Stated {
    /// Whether the value is known exactly.
    #[must_use]
    pub fn is_certain(&self) -> bool {
        self.within == Rational::default()
    }

    /// All that the value may be, enclosed.
    #[must_use]
    pub fn enclosed(&self) -> Interval {
        let end = |x: &Rational| Interval::from_rational(x);
        end(&(&self.value - &self.within)).hull(&end(&(&self.value + &self.within)))
    }
}

impl From<Rational> for Stated {
    fn from(value: Rational) -> Self {
        Self { value, within: Rational::default() }
    }
}

/// A number, or a table `{ value = …, within = … }`.
pub(super) fn stated(
    source: Source<'_>,
    number: &Number,
    symbol: &str,
    domain: Domain,
) -> Result<Stated, Fault> {
    let toml::Value::Table(table) = number.get_ref() else {
        return Ok(source.number(number, symbol, domain)?.into());
    };
    let fault = |message: String| source.fault(number.span(), message);
    if let Some(key) = table.keys().find(|key| *key != "value" && *key != "within") {
        return Err(fault(format!("unknown key `{key}`; write {{ value = 1, within = \"0.1\" }}")));
    }
    let text = source.text.get(number.span()).unwrap_or_default();
    let part = |key: &str, domain: Domain| {
        let value = table.get(key).ok_or_else(|| {
            fault(format!("{symbol} lacks `{key}`; write {{ value = 1, within = \"0.1\" }}"))
        })?;
        let written = match value {
            toml::Value::String(text) => text.clone(),
            _ => after_key(text, key),
        };
        read_in(&written, domain).map_err(|error| fault(format!("`{key}` of {symbol} {error}")))
    };
    let stated =
        Stated { value: part("value", domain)?, within: part("within", Domain::NotNegative)? };
    // the whole range must be in the domain
    for end in [&stated.value - &stated.within, &stated.value + &stated.within] {
        read_in(&end.to_string(), domain)
            .map_err(|error| fault(format!("an end of the range of {symbol} {error}")))?;
    }
    Ok(stated)
}

/// The text of a number inside an inline table: what stands between `key =` and the next comma,
/// because the parser's own floats are not exact.
fn after_key(table: &str, key: &str) -> String {
    let inner = table.trim().trim_start_matches('{').trim_end_matches('}');
    let of_key = inner.split(',').find_map(|item| {
        let (name, value) = item.split_once('=')?;
        (name.trim() == key).then(|| value.trim().replace('_', ""))
    });
    of_key.unwrap_or_default()
}
