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
        match self {
            Self::Text => String::new(),
            Self::Quiet => " class=\"q\"".to_owned(),
            Self::Grid => " class=\"g\"".to_owned(),
            Self::Paper => " class=\"p\"".to_owned(),
            Self::Series(n) => format!(" class=\"c{}\"", n % INKS),
        }
    }
}

/// The style of every picture. Its rules are the same in all, so that several can stand on one page.
pub(super) const STYLE: &str = "\
.kane{color:#1e2022;font-family:sans-serif}.kane .p{color:#fff}.kane .q{color:#63676c}.kane .g{color:#e1e1e1}\
.kane .c0{color:#0072b2}.kane .c1{color:#d55e00}.kane .c2{color:#009e73}.kane .c3{color:#cc79a7}\
.kane .c4{color:#e69f00}.kane .c5{color:#56b4e9}.kane .c6{color:#6e6e6e}\n\
@media screen and (prefers-color-scheme:dark){\
.kane{color:#e6e3dc}.kane .p{color:#15171a}.kane .q{color:#a9acb0}.kane .g{color:#34383d}\
.kane .c0{color:#4ba3e3}.kane .c1{color:#ff8b45}.kane .c2{color:#2cc59a}.kane .c3{color:#e6a6ca}\
.kane .c4{color:#f3c04f}.kane .c5{color:#a5dcff}.kane .c6{color:#9a9ea3}}";

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
