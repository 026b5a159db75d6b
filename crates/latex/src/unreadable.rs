//! Why a formula is not read.

use thiserror::Error;

/// Why a formula, or a part of it, is not read: it is left to the author then.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[non_exhaustive]
pub enum Unreadable {
    /// a command that stands for nothing that the language of derivations has
    #[error("`\\{0}` has no meaning here")]
    Command(String),
    /// words that are no condition
    #[error("the words “{0}”")]
    Words(String),
    /// a character out of place
    #[error("`{0}` is out of place")]
    Character(char),
    /// something is missing at the end, or before a sign
    #[error("{0} is missing")]
    Missing(&'static str),
    /// two readings
    #[error("{0} can be read in two ways")]
    Ambiguous(String),
    /// an exponent that is no number
    #[error("an exponent that is neither an integer nor a half of one")]
    Exponent,
    /// a subscript or a mark that is no part of a name
    #[error("a subscript or a mark that is no part of a name")]
    Subscript,
    /// a differential that is no part of a derivative
    #[error("a differential, `d{0}`, that is no part of a derivative")]
    Differential(String),
    /// an approximation
    #[error("`\\{0}` says that something holds approximately")]
    Approximate(String),
    /// a vector where a number is wanted, or the other way round
    #[error("vectors and numbers are mixed: {0}")]
    Mixed(String),
    /// two symbols that would have one name
    #[error("`{0}` and `{1}` would have one name")]
    SameName(String, String),
    /// a word of the language as a name
    #[error("`{0}` is a word of the language and no name")]
    Reserved(String),
    /// braces, fractions and roots in one another, beyond what is read
    #[error("parts nested too deeply")]
    Depth,
    /// a formula without a relation
    #[error("no relation")]
    NoRelation,
    /// an environment that is not read
    #[error("the environment `{0}`")]
    Environment(String),
    /// macros that stand for too much
    #[error("macros that stand for more than {0} parts")]
    Macros(usize),
    /// a function that has a definition already
    #[error("it defines `{0}` a second time")]
    DefinedTwice(String),
    /// read, but no statement of the language
    #[error("{0}")]
    NotAccepted(String),
}
