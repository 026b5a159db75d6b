//! A TOML file of which the numbers are taken as written.

use std::ops::Range;
use std::path::Path;

use kane_algebra::syntax::{Diagnostic, nearest_with_unit};
use kane_number::Rational;
use serde::de::DeserializeOwned;
use toml::Spanned;

use super::number::{Domain, read_in};

/// No description of a few bodies is longer.
const MAX_BYTES: u64 = 1 << 16;

/// Something wrong with a file, shown with its line and a caret.
pub type Fault = Box<Diagnostic>;

/// A number, whose text is looked up in the file: only the text is exact.
pub type Number = Spanned<toml::Value>;

/// The text of a file.
///
/// # Errors
/// Why it cannot be read, in words.
pub fn load(path: &Path) -> Result<String, String> {
    use std::io::Read as _;
    let mut bytes = Vec::new();
    let file = std::fs::File::open(path).map_err(|error| error.to_string())?;
    let read = file.take(MAX_BYTES + 1).read_to_end(&mut bytes);
    read.map_err(|error| error.to_string())?;
    if u64::try_from(bytes.len()).is_ok_and(|length| length > MAX_BYTES) {
        return Err(format!("it has more than {MAX_BYTES} bytes"));
    }
    String::from_utf8(bytes).map_err(|error| {
        let Diagnostic { line, column, .. } = Diagnostic::not_utf8("", error.as_bytes());
        format!("it is not UTF-8 at line {line}, column {column}")
    })
}

/// A file's name, as faults show it, and its text.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a> {
    /// as the user wrote it
    pub name: &'a str,
    /// all of it
    pub text: &'a str,
    /// whether it is a command's flags, by which faults call their values
    of_flags: bool,
}

impl<'a> Source<'a> {
    /// A file.
    #[must_use]
    pub const fn file(name: &'a str, text: &'a str) -> Self {
        Self { name, text, of_flags: false }
    }

    /// The flags of a command.
    #[must_use]
    pub const fn flags(text: &'a str) -> Self {
        Self { name: "the command line", text, of_flags: true }
    }
}

impl Source<'_> {
    /// Something wrong at a place of the file.
    #[must_use]
    pub fn fault(&self, span: Range<usize>, message: impl Into<String>) -> Fault {
        Box::new(Diagnostic::new(self.name, self.text, span, message.into()))
    }

    /// The file as tables.
    ///
    /// # Errors
    /// The first thing that does not fit, with the key that may have been meant.
    pub fn parse<T: DeserializeOwned>(&self) -> Result<T, Fault> {
        toml::from_str(self.text).map_err(|error| {
            if let Some(message) = self.lacks_all() {
                return self.fault(0..0, message);
            }
            let span = error.span().unwrap_or_default();
            let message = error.message().split_whitespace().collect::<Vec<_>>().join(" ");
            let mut fault = self.fault(span, message);
            fault.note = suggestion(&fault.message);
            fault
        })
    }

    /// What is said of a file without a key, where the name of the first one that is missing would mislead.
    fn lacks_all(&self) -> Option<&'static str> {
        let keys = self.text.parse::<toml::Table>().ok().filter(|_| !self.of_flags)?;
        match self.text.trim().is_empty() {
            _ if !keys.is_empty() => None,
            true => Some("the file is empty"),
            false => Some("the file has comments alone, and no key"),
        }
    }

    /// A number's text: TOML's own floats would not be exact.
    #[must_use]
    pub fn written(&self, number: &Number) -> String {
        match number.get_ref() {
            toml::Value::String(text) => text.clone(),
            toml::Value::Integer(_) | toml::Value::Float(_) => {
                self.text.get(number.span()).unwrap_or_default().replace('_', "")
            }
            _ => String::new(),
        }
    }

    /// The flag before a number.
    fn name_of(&self, number: &Number) -> Option<&str> {
        let before = self.text.get(..number.span().start).filter(|_| self.of_flags)?;
        before.trim_end().rsplit(' ').next()
    }

    /// The number as written, exactly.
    ///
    /// # Errors
    /// That it is no number, an uncertain one, or outside the domain; `symbol` says which.
    pub fn number(&self, number: &Number, symbol: &str, domain: Domain) -> Result<Rational, Fault> {
        let symbol = self.name_of(number).unwrap_or(symbol);
        if number.get_ref().is_table() {
            let message = format!("{symbol} is known exactly or not at all: write one number");
            return Err(self.fault(number.span(), message));
        }
        read_in(&self.written(number), domain)
            .map_err(|error| self.fault(number.span(), format!("{symbol} {error}")))
    }
}

/// The key that may have been meant, out of a complaint of the form "unknown field `a`, expected one
/// of `b`, `c`".
fn suggestion(message: &str) -> Option<String> {
    let mut words = message.strip_prefix("unknown field ")?.split('`').skip(1).step_by(2);
    let unknown = words.next()?;
    let near = nearest_with_unit(unknown, words)?;
    Some(format!("did you mean `{near}`?"))
}
