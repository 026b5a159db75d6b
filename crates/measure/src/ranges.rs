//! Over which values of its inputs a formula is examined.

use std::fmt;

use kane_kernel::Bound;
use kane_number::{ParseError, Rational, parse};

use crate::Input;

/// What the user, the document and physics say of the inputs' ranges.
///
/// What the user says of an input goes before what the document says. Where neither ends a range, it ends at
/// ±10⁶; and a range of positive numbers that has no upper end begins at 10⁻⁶, unless the document includes
/// 0 itself. With the full line, such ranges go on to the least and the greatest float.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Ranges {
    /// by name, from and to, both included
    pub given: Vec<(String, Rational, Rational)>,
    /// whether ranges without an end go to the end of the format
    pub full_line: bool,
}

/// Why a text is no range.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoRange {
    /// it is not `name=from..to`
    Form,
    /// an end is no number
    End(String, ParseError),
    /// the first end is above the second
    Empty(String),
}

impl fmt::Display for NoRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Form => f.write_str("a range is written name=from..to, as alpha=1/1000..1000"),
            Self::End(text, error) => write!(f, "{text:?} is no end of a range: {error}"),
            Self::Empty(name) => write!(f, "the range of {name} is empty: from is above to"),
        }
    }
}

impl std::error::Error for NoRange {}

/// Where ranges without an end are taken to end, and those of positive numbers to begin.
fn physical() -> (Rational, Rational) {
    let million = Rational::from_integer(1_000_000.into());
    (million.recip(), million)
}

impl Ranges {
    /// All floats of every domain.
    #[must_use]
    pub fn full_line() -> Self {
        Self { full_line: true, ..Self::default() }
    }

    /// Takes `name=from..to`.
    ///
    /// # Errors
    /// [`NoRange`].
    pub fn add(&mut self, text: &str) -> Result<(), NoRange> {
        let (name, ends) = text.split_once('=').ok_or(NoRange::Form)?;
        let (from, to) = ends.split_once("..").ok_or(NoRange::Form)?;
        let name = name.trim();
        if name.is_empty() {
            return Err(NoRange::Form);
        }
        let end = |text: &str| {
            let text = text.trim();
            parse(text).map_err(|error| NoRange::End(text.to_owned(), error))
        };
        let (from, to) = (end(from)?, end(to)?);
        if from > to {
            return Err(NoRange::Empty(name.to_owned()));
        }
        self.given.push((name.to_owned(), from, to));
        Ok(())
    }

    /// The ends of an input over which it is examined. A range that the user gives is cut to what the
    /// document declares, since a formula means nothing beyond that.
    #[must_use]
    pub fn of(
        &self,
        name: &str,
        lower: Option<&Bound>,
        upper: Option<&Bound>,
    ) -> (Option<Bound>, Option<Bound>) {
        let (mut lower, mut upper) = (lower.cloned(), upper.cloned());
        let at = |value: &Rational| Some(Bound { value: value.clone(), strict: false });
        if let Some((_, from, to)) = self.given.iter().rev().find(|(known, ..)| known == name) {
            if lower.as_ref().is_none_or(|bound| bound.value < *from) {
                lower = at(from);
            }
            if upper.as_ref().is_none_or(|bound| bound.value > *to) {
                upper = at(to);
            }
            return (lower, upper);
        }
        if self.full_line {
            return (lower, upper);
        }
        let (least, most) = physical();
        let zero = Rational::from_integer(0.into());
        let is_sign = |bound: &Option<Bound>| {
            bound.as_ref().is_some_and(|bound| bound.strict && bound.value == zero)
        };
        match (&lower, &upper) {
            (Some(_), Some(_)) => {}
            (None, None) => (lower, upper) = (at(&-most.clone()), at(&most)),
            (Some(bound), None) if bound.value < most => {
                upper = at(&most);
                if is_sign(&lower) {
                    lower = at(&least);
                }
            }
            (None, Some(bound)) if bound.value > -most.clone() => {
                lower = at(&-most);
                if is_sign(&upper) {
                    upper = at(&-least);
                }
            }
            _ => {}
        }
        (lower, upper)
    }

    /// An input with these ends.
    #[must_use]
    pub fn narrowed(&self, input: &Input) -> Input {
        let (lower, upper) = self.of(&input.name, input.lower.as_ref(), input.upper.as_ref());
        Input { name: input.name.clone(), lower, upper }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bound(text: &str, strict: bool) -> Bound {
        Bound { value: parse(text).unwrap(), strict }
    }

    fn ends(ranges: &Ranges, lower: Option<Bound>, upper: Option<Bound>) -> [String; 2] {
        let (lower, upper) = ranges.of("x", lower.as_ref(), upper.as_ref());
        [lower, upper].map(|bound| bound.map_or_else(String::new, |b| b.value.to_string()))
    }

    #[test]
    fn a_domain_without_an_end_ends_where_physics_does() {
        let default = Ranges::default();
        assert_eq!(ends(&default, None, None), ["-1000000", "1000000"]);
        assert_eq!(ends(&default, Some(bound("0", true)), None), ["1/1000000", "1000000"]);
        assert_eq!(ends(&default, Some(bound("0", false)), None), ["0", "1000000"]);
        assert_eq!(ends(&default, None, Some(bound("0", true))), ["-1000000", "-1/1000000"]);
        assert_eq!(ends(&default, Some(bound("0", true)), Some(bound("1", true))), ["0", "1"]);
        assert_eq!(ends(&default, Some(bound("1e7", true)), None), ["10000000", ""]);
        assert_eq!(ends(&Ranges::full_line(), None, None), ["", ""]);
    }

    #[test]
    fn what_the_user_says_stays_in_the_domain() {
        let mut ranges = Ranges::default();
        ranges.add("x=1/1000..1000").unwrap();
        assert_eq!(ends(&ranges, Some(bound("0", true)), None), ["1/1000", "1000"]);
        assert_eq!(ends(&ranges, None, Some(bound("1", true))), ["1/1000", "1"]);
        for (text, why) in [
            ("x", "name=from..to"),
            ("x=1", "name=from..to"),
            ("=1..2", "name=from..to"),
            ("x=2..1", "is empty"),
            ("x=1..y", "is no end"),
        ] {
            let error = ranges.add(text).unwrap_err().to_string();
            assert!(error.contains(why), "{text}: {error}");
        }
    }
}
