//! What pages have in common: their styles, the font for formulas, and what runs on them.
//!
//! A page that stands alone has these within. The pages of a site load them from one directory beside them, so that a
//! browser reads each once.

/// A file that pages share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Shared {
    /// its name in the directory
    pub(crate) name: &'static str,
    /// what it holds
    pub(crate) text: &'static str,
}

/// The directory, seen from the index of a site.
pub(crate) const DIRECTORY: &str = "shared";

macro_rules! shared {
    ($name:literal, $($path:literal),+) => {
        Shared { name: $name, text: concat!($(include_str!($path)),+) }
    };
}

/// Of a font for mathematics what formulas need: without one, indices stand at the base line. It is within the style,
/// since a browser takes no font from another file on a disk.
pub(crate) const MATHS: Shared = shared!("maths.css", "../fonts/maths.css");
/// The style of every page.
pub(crate) const FRAME: Shared = shared!("frame.css", "frame.css");
/// The style of what leads to the pages beside a page.
pub(crate) const PLACE: Shared = shared!("place.css", "../place.css");
/// The style of verdicts and proofs.
pub(crate) const VERDICTS: Shared = shared!("verdicts.css", "verdicts.css");
/// The style of an audit.
pub(crate) const AUDIT: Shared = shared!("audit.css", "audit.css");
/// What runs on the page of an audit.
pub(crate) const AUDIT_SCRIPT: Shared = shared!("audit.js", "scroll.js", "audit.js");
/// The style of the matrix.
pub(crate) const MATRIX: Shared = shared!("matrix.css", "../matrix/matrix.css");
/// What runs on the page of the matrix.
pub(crate) const MATRIX_SCRIPT: Shared = shared!("matrix.js", "scroll.js", "../matrix/matrix.js");
/// The style of a sheet.
pub(crate) const SHEET: Shared = shared!("sheet.css", "../sheet/sheet.css");

/// The style of pictures. An SVG that is a file of its own has it within.
pub(crate) const PICTURE: Shared = shared!("picture.css", "../picture/picture.css");

/// All of them.
pub(crate) const ALL: [Shared; 10] =
    [MATHS, FRAME, PLACE, VERDICTS, AUDIT, AUDIT_SCRIPT, MATRIX, MATRIX_SCRIPT, SHEET, PICTURE];
