//! What stands where in a document, also in one that has errors: for editors.

use std::ops::Range;

use crate::{Diagnostic, Document, Origin};

/// A document as far as it could be read, with what stands where.
#[derive(Clone, Debug)]
pub struct Survey {
    /// the document, or everything that is wrong with it; places are those of the text, see `origin`
    pub document: Result<Document, Vec<Diagnostic>>,
    /// labels, citations and names, by their places in the file
    pub outline: Outline,
    /// from places in the text to places in the file
    pub origin: Origin,
}

/// Labels, citations and names, by the bytes of the file. Of a statement with an error only what stands
/// before the error is here.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// the statements that can be cited, in the order of the text
    pub labels: Vec<Label>,
    /// every place where one is cited
    pub citations: Vec<Citation>,
    /// symbols and definitions, in the order of the alphabet
    pub names: Vec<Name>,
    /// the blocks of statements, with their fences
    pub blocks: Vec<Range<usize>>,
}

/// A statement that can be cited.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// as written: `(9)` or `k-range`
    pub text: String,
    /// where it is written
    pub place: Range<usize>,
    /// the whole statement
    pub statement: Range<usize>,
    /// what kind of statement it is
    pub kind: Kind,
    /// whether it is the name of a definition
    pub is_name: bool,
}

/// The kind of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `let`
    Let,
    /// `given`
    Given,
    /// `claim`
    Claim,
    /// one with an error
    Broken,
}

/// A place where a statement is cited.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Citation {
    /// the label there
    pub place: Range<usize>,
    /// the index in [`Outline::labels`] of what it cites; `None` if nothing is called so
    pub cites: Option<usize>,
}

/// A symbol or a definition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// with Greek letters spelled out
    pub text: String,
    /// where it is declared
    pub place: Range<usize>,
    /// whether it is a definition
    pub is_definition: bool,
}
