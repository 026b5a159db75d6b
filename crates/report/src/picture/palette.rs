//! Colours and pens.
//!
//! The colours are those of Okabe and Ito, which colour-blind people tell apart, and lighter ones of the same hues on
//! a dark ground. An ink is a class that sets `color`; lines and areas are drawn in `currentColor`.

/// What something is drawn in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ink {
    /// that of the words
    Text,
    /// of what stands back
    Quiet,
    /// of the lines behind a plot
    Grid,
    /// the ground
    Paper,
    /// one of a list, from the beginning again after the last
    Series(usize),
}

/// Blue, vermilion, green, purple, orange, sky, grey.
const INKS: usize = 7;

impl Ink {
    pub(crate) const BLUE: Self = Self::Series(0);
    pub(crate) const VERMILION: Self = Self::Series(1);
    pub(crate) const GREEN: Self = Self::Series(2);
    pub(crate) const PURPLE: Self = Self::Series(3);
    pub(crate) const ORANGE: Self = Self::Series(4);
    pub(crate) const SKY: Self = Self::Series(5);
    pub(crate) const GREY: Self = Self::Series(6);

    /// The class, as an attribute; none for the ink of the words.
    pub(super) fn class(self) -> String {
        self.class_with("")
    }

    /// The same with one more.
    pub(super) fn class_with(self, more: &str) -> String {
        let class = match self {
            Self::Text => String::new(),
            Self::Quiet => "q".to_owned(),
            Self::Grid => "g".to_owned(),
            Self::Paper => "p".to_owned(),
            Self::Series(n) => format!("c{}", n % INKS),
        };
        match (class.as_str(), more) {
            ("", "") => String::new(),
            ("", one) | (one, "") => format!(" class=\"{one}\""),
            (both, more) => format!(" class=\"{both} {more}\""),
        }
    }
}

/// The style of every picture. Its rules are the same in all, so that several can stand on one page.
pub(crate) const STYLE: &str = include_str!("picture.css");

/// How a line is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pen {
    pub(crate) ink: Ink,
    pub(crate) width: f64,
    /// lengths of dashes and gaps; empty for a full line
    pub(crate) dashes: &'static str,
    /// how much covers what is behind it, from 0 to 1
    pub(crate) strength: f64,
}

impl Pen {
    pub(crate) const fn new(ink: Ink, width: f64) -> Self {
        Self { ink, width, dashes: "", strength: 1.0 }
    }

    pub(crate) const fn dashed(self, dashes: &'static str) -> Self {
        Self { dashes, ..self }
    }

    pub(crate) const fn faint(self, strength: f64) -> Self {
        Self { strength, ..self }
    }
}
