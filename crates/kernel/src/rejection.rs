//! Why the kernel did not accept a certificate.

use std::fmt;

/// Why the kernel did not accept a certificate; never a synonym of «false».
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Rejection {
    /// the budget ran out
    Budget,
    /// the certificate names another goal
    OtherGoal,
    /// a rational number is not in lowest terms with a positive denominator
    NotCanonical,
    /// evidence of this kind cannot show this finding
    WrongEvidence,
    /// a limit is judged by functions, not by a point
    NeedsFunctions,
    /// cases, proofs: their numbers differ
    CaseCount(usize, usize),
    /// the cases of a sign do not admit all three
    SignLeftOut,
    /// no atom with this index
    NoSuchAtom(usize),
    /// no formula with this index
    NoSuchFormula(usize),
    /// a factor is not known to be non-zero
    MayVanish,
    /// the two sides do not expand to the same polynomial
    NotAnIdentity,
    /// the atom with this index is no equation
    NotAnEquation(usize),
    /// no summand is visibly positive, or one may be negative
    NotPositive,
    /// Descartes' rule does not confirm the stated roots
    RootCount,
    /// the germ does not lie in the domain
    OutsideDomain,
    /// something that varies stands where only constants may
    NotConstant,
    /// the power of t does not fit the limit
    WrongOrder,
    /// the point violates the formula with this index; `None`: a range
    NotAModel(Option<usize>),
    /// a symbol's range is empty
    EmptyRange(usize),
    /// a symbol or definition that the context does not have
    UnknownSymbol,
    /// a derivative of something without a definition
    NotExplicit,
}

/// What a rule leaves, or why it does not apply.
pub type Checked<T = ()> = Result<T, Rejection>;

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Budget => write!(f, "the budget of the check ran out"),
            Self::OtherGoal => write!(f, "the certificate is for another statement"),
            Self::NotCanonical => write!(f, "a number in it is not in lowest terms"),
            Self::EmptyRange(_) => write!(f, "a symbol has an empty range"),
            Self::UnknownSymbol => write!(f, "it names a symbol that is not there"),
            Self::NotExplicit => write!(f, "a derivative in it is of nothing explicit"),
            Self::OutsideDomain => write!(f, "it takes a limit where none can be taken"),
            Self::NotAModel(_) => write!(f, "the witness does not satisfy all that it should"),
            _ => write!(f, "a step of it does not hold"),
        }
    }
}

impl std::error::Error for Rejection {}
