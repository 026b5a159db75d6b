//! A number with what its author does not know of it.

use kane_number::{Interval, Number as _, Rational};

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
