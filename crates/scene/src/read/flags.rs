//! Flags of a command, read as a file is.

use toml::{Spanned, Value};

use super::source::{Number, Source};

/// The flags of a command with their values, written out in a line that faults point into.
#[derive(Debug)]
pub struct Flags {
    line: String,
    values: Vec<(&'static str, Number)>,
}

impl Flags {
    /// The line of these flags, each with its value.
    #[must_use]
    pub fn new(pairs: &[(&'static str, &str)]) -> Self {
        let (mut line, mut values) = (String::new(), Vec::new());
        for (flag, value) in pairs {
            line.push_str(flag);
            line.push(' ');
            let start = line.len();
            line.push_str(value);
            let place = start..line.len();
            values.push((*flag, Spanned::new(place, Value::String((*value).to_owned()))));
            line.push(' ');
        }
        Self { line, values }
    }

    /// What a reader reads from.
    #[must_use]
    pub fn source(&self) -> Source<'_> {
        Source::flags(&self.line)
    }

    /// The value of a flag.
    #[must_use]
    pub fn get(&self, flag: &str) -> Option<&Number> {
        self.values.iter().find(|(known, _)| *known == flag).map(|(_, value)| value)
    }

    /// The same as a word.
    #[must_use]
    pub fn word(&self, flag: &str) -> Option<Spanned<String>> {
        let value = self.get(flag)?;
        Some(Spanned::new(value.span(), value.get_ref().as_str()?.to_owned()))
    }
}
