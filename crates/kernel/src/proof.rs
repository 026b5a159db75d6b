//! Certificates: what the search hands over and the kernel checks.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;

use crate::{Atom, Expr, Poly, Sign, Target};

/// What is found about a goal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Finding {
    /// the conclusion holds and is defined wherever the hypotheses hold
    Proved,
    /// somewhere the hypotheses hold and the conclusion is false
    Refuted,
    /// somewhere the hypotheses hold and the conclusion is undefined
    IllDefined,
    /// the hypotheses cannot all hold
    Vacuous,
    /// the hypotheses can all hold
    Consistent,
}

/// Evidence for a finding about the goal with this digest.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Certificate {
    /// [`crate::digest`] of the goal
    pub goal: u128,
    /// what is found
    pub finding: Finding,
    /// why
    pub evidence: Evidence,
}

/// Why a finding is right.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Evidence {
    /// the conditions of the opposite contradict each other
    Contradiction(Proof),
    /// one limit proof a side
    Limit(Vec<SideProof>),
    /// a point or functions
    Model(Model),
    /// for a limit: the sign of a polynomial in constants is one of three
    Split {
        /// the polynomial
        poly: Poly,
        /// cases that between them admit each sign: a limit proof, or that it cannot be
        cases: Vec<Case<Self>>,
    },
}

/// Shows that the atoms collected so far, with formulas not yet assumed, have no common point.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Proof {
    /// A formula is a disjunction: one proof a case.
    Assume {
        /// index of the formula
        formula: usize,
        /// proofs, in the order of its cases
        cases: Vec<Proof>,
    },
    /// The sign of a polynomial is one of three: cases that between them admit each.
    Split {
        /// the polynomial
        poly: Poly,
        /// cases, which may overlap
        cases: Vec<Case>,
    },
    /// Σ weightⱼ·squareⱼ²·Π known + Σ cofactorᵢ·equationᵢ = 0 with one summand visibly positive.
    Positive {
        /// the non-negative summands
        terms: Vec<Term>,
        /// indices of equations and their cofactors
        cofactors: Vec<(usize, Poly)>,
    },
    /// What holds for all small t > 0 holds in the limit (Zero and NonNegative survive).
    Pass {
        /// the germ
        germ: Germ,
        /// polynomial in t, constants and premised limits
        atom: Atom,
        /// proof of the atom along the germ
        along: Box<Proof>,
        /// the rest, with the atom at t = 0
        then: Box<Proof>,
    },
}

/// A case of a [`Proof::Split`] or an [`Evidence::Split`]: the polynomial, or its opposite, has this sign.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Case<P = Proof> {
    /// whether it is said of the opposite
    pub opposite: bool,
    /// the sign
    pub sign: Sign,
    /// what there is with this atom
    pub then: P,
}

/// weight · square² · Π factors, a summand known to be ≥ 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Term {
    /// a positive integer
    pub weight: BigInt,
    /// any polynomial
    pub square: Poly,
    /// indices of atoms, with powers (even ones for ≠ 0)
    pub factors: Vec<(usize, u32)>,
}

/// The only root of `poly` in the open interval (lo, hi), or the point lo = hi.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Root {
    /// coefficients from x⁰ up, without repeated roots in the interval
    pub poly: Vec<BigInt>,
    /// left end
    pub lo: BigRational,
    /// right end
    pub hi: BigRational,
}

/// A side from which a limit is taken.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Side {
    /// the limit variable x
    pub var: usize,
    /// the finite end point a; `None` for infinity
    pub at: Option<BigRational>,
    /// x = a + tⁿ or 1/tⁿ if true, a − tⁿ or −1/tⁿ if false
    pub above: bool,
}

/// A side, and how small t must be.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Germ {
    /// the side
    pub side: Side,
    /// n ≥ 1 in x = a ± tⁿ or ±1/tⁿ: with n > 1 roots of x are powers of t
    pub power: u32,
    /// 0 < t < numerator/denominator, polynomials in constants
    pub radius: (Poly, Poly),
    /// proof that both are positive (its last formula: one of them is not)
    pub positive: Box<Proof>,
    /// that it lies in the range of each given that [`crate::owed`] names
    pub inside: Vec<Inside>,
}

/// Shows that a given can hold at each point along a germ.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Inside {
    /// functions of x, as expressions in x and constants
    pub values: Vec<(usize, Expr)>,
    /// proof that with them the given holds (its last formula: it fails, or a value does)
    pub proof: Proof,
}

/// Proof of a limit f → L from one side: f = num/den along the germ, or f ≥ num/den, or f ≤ num/den,
/// and both ends at t = 0. A finite limit needs f = num/den or both bounds, an infinite one needs
/// f = num/den or the bound on its side.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct SideProof {
    /// the germ
    pub germ: Germ,
    /// num, a polynomial in t, constants and premised limits
    pub num: Poly,
    /// den; for an infinite limit divisible by t^order
    pub den: Poly,
    /// 0 for a finite limit
    pub order: u32,
    /// how f compares with num/den
    pub sense: Ordering,
    /// proof that f is defined and compares so along the germ
    pub along: Box<Proof>,
    /// proof that den ≠ 0 and num = L·den at t = 0; for ±∞ that num and den/t^order have the sign
    pub at_zero: Box<Proof>,
    /// the upper bound of a finite limit, if this is the lower one
    pub upper: Option<Box<Self>>,
}

/// Something that satisfies a list of formulas.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Model {
    /// a point
    Point(Point),
    /// functions of one variable
    Functions(Box<Functions>),
}

/// Values for variables: polynomials with rational coefficients in one real algebraic number θ.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Point {
    /// θ; `None` if all values are rational
    pub generator: Option<Root>,
    /// (variable, coefficients from θ⁰ up)
    pub values: Vec<(usize, Vec<BigRational>)>,
}

/// Explicit functions of a variable x, for which the premises are proved for all x.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Functions {
    /// x
    pub var: usize,
    /// an expression in x for each other symbol that the goal mentions, ascending, in their order
    pub values: Vec<(usize, Expr)>,
    /// for each symbol, in order of `values`: its expression is defined and within its range
    pub ranges: Vec<Proof>,
    /// for each hypothesis: its relations hold for all x; and one limit proof a limit and side
    pub premises: Vec<(Proof, Vec<Vec<SideProof>>)>,
    /// how the conclusion fails
    pub failure: Failure,
}

/// How a conclusion fails for explicit functions. Premises about x alone narrow the domain: they
/// need not hold for all x, but at the point, or along the side, where the conclusion is judged.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Failure {
    /// at a point x (where nothing has to fail for mere consistency)
    At(Point),
    /// nothing fails, and the domain reaches the limit of a limit claim: 0 → 0 along each side
    Reaches(Vec<SideProof>),
    /// the limit at this link is another one, as proved from one of its sides
    Limit {
        /// index of the link in a sentence; 0 for a single link
        link: usize,
        /// what it tends to instead
        target: Target,
        /// the proof
        proof: SideProof,
        /// proof that they differ, if it is not visible
        apart: Option<Box<Proof>>,
    },
}
