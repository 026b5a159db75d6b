//! Arguments: proofs as people write them, with the steps that the search takes.
//!
//! The kernel knows four rules. An argument has more, and each of its steps stands for a few uses of
//! those: [`expand`] writes them out. Nothing here is trusted; the kernel checks what comes out.

mod bound;
mod expand;
mod identity;
mod line;
mod node;
mod orthant;
mod rules;
#[cfg(test)]
mod tests;

use std::cmp::Ordering;

use kane_kernel::{Atom, Germ, Model, Poly, Root, Term};
use num_bigint::BigInt;
use num_rational::BigRational;

pub(crate) use bound::{bound, zero};
pub use expand::contradicts_bounds;
pub(crate) use expand::{contradiction, expand, limit_proof, side_proof};
pub use orthant::BoundedSum;
pub(crate) use orthant::bounded_sum;
pub use rules::Flaw;
pub(crate) use rules::{Rules, composed};

/// A variable with the indices of the atoms that bound it below and above.
pub(crate) type Bounds = (usize, Option<usize>, Option<usize>);

/// An atom's index, with the atom as constant · Π baseᵢ^eᵢ.
pub(crate) type Factored = (usize, BigRational, Vec<u32>);

/// Shows that the atoms collected so far, with formulas not yet assumed, have no common point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Argument {
    /// The atom with this index is a constant and false.
    Absurd(usize),
    /// A formula is a disjunction: one argument a case.
    Assume {
        /// index of the formula
        formula: usize,
        /// arguments, in the order of its cases
        cases: Vec<Argument>,
    },
    /// The sign of a polynomial is one of three.
    Split {
        /// the polynomial
        poly: Poly,
        /// argument if it is 0
        zero: Box<Argument>,
        /// argument if it is > 0
        positive: Box<Argument>,
        /// argument if it is < 0
        negative: Box<Argument>,
    },
    /// An equation D·vⁿ + … = 0 with D a product of factors known not to vanish reduces the
    /// degree in v of all other atoms below n; if n = 1, v is gone, and the equation too.
    Substitute {
        /// index of the equation
        equation: usize,
        /// v
        var: usize,
        /// indices of atoms > 0 or ≠ 0, with powers, whose product is ±D; none if D is a constant
        lead: Vec<(usize, u32)>,
        /// the rest
        then: Box<Argument>,
    },
    /// Divides an atom by factors that are known not to vanish.
    Cancel {
        /// index of the atom
        atom: usize,
        /// indices of atoms > 0 or ≠ 0, with powers (even ones for ≠ 0 below an inequality)
        factors: Vec<(usize, u32)>,
        /// what is left, up to a positive factor
        quotient: Poly,
        /// the rest
        then: Box<Argument>,
    },
    /// Σ weightⱼ·squareⱼ²·Π known + Σ cofactorᵢ·equationᵢ = 0 with one summand visibly positive.
    Positive {
        /// the non-negative summands
        terms: Vec<Term>,
        /// indices of equations and their cofactors
        cofactors: Vec<(usize, Poly)>,
    },
    /// Bounds lᵢ ≤ xᵢ ≤ uᵢ mapped onto the orthant give an atom's polynomial the wrong sign.
    Orthant {
        /// index of the atom
        atom: usize,
        /// for each variable of it: indices of atoms for its lower and upper bound
        bounds: Vec<Bounds>,
    },
    /// Atoms in one variable: on no cell of the line do they all hold.
    SignTable {
        /// the variable
        var: usize,
        /// polynomials without common or repeated roots
        bases: Vec<Vec<BigInt>>,
        /// all their roots, ascending
        roots: Vec<Root>,
        /// atoms used
        atoms: Vec<Factored>,
    },
}

/// What is passed to a limit before an argument begins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Passage {
    /// the germ
    pub(crate) germ: Germ,
    /// what holds along it, and so at its end
    pub(crate) atom: Atom,
    /// why it holds along it
    pub(crate) along: Argument,
}

/// An argument for a limit from one side, as [`kane_kernel::SideProof`] has a proof.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SideArgument {
    /// the germ
    pub(crate) germ: Germ,
    /// the numerator
    pub(crate) num: Poly,
    /// the denominator
    pub(crate) den: Poly,
    /// the order of an infinite limit
    pub(crate) order: u32,
    /// how f compares with num/den
    pub(crate) sense: Ordering,
    /// that f does so along the germ
    pub(crate) along: Argument,
    /// that the ends are as claimed
    pub(crate) at_zero: Argument,
    /// the upper bound, if this is the lower one of two
    pub(crate) upper: Option<Box<Self>>,
}

/// An argument for a limit from all its sides, by cases of the constants.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum LimitArgument {
    /// one argument a side
    Sides(Vec<SideArgument>),
    /// in this case nothing has to be shown: the constants cannot be so
    Absurd(Argument),
    /// the sign of a polynomial in constants is one of three
    Split {
        /// the polynomial
        poly: Poly,
        /// if it is 0
        zero: Box<LimitArgument>,
        /// if it is > 0
        positive: Box<LimitArgument>,
        /// if it is < 0
        negative: Box<LimitArgument>,
    },
}

/// How a contradiction is reached where limits may be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Course {
    /// an argument after passages to limits
    After(Vec<Passage>, Argument),
    /// the sign of a polynomial in constants is one of three
    Split {
        /// the polynomial
        poly: Poly,
        /// if it is 0
        zero: Box<Course>,
        /// if it is > 0
        positive: Box<Course>,
        /// if it is < 0
        negative: Box<Course>,
    },
}

/// Why a finding is right, as it is told.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Grounds {
    /// the conditions of the opposite contradict each other
    Contradiction(Course),
    /// a limit is what is claimed
    Limit(LimitArgument),
    /// a point or functions
    Model(Model),
}
