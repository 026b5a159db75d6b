//! The steps of a proof or of a witness as data: what is assumed, substituted, divided by, evaluated.
//!
//! Polynomials are in the variables of the proof, which [`Proof::variables`] names; expressions are in
//! the symbols of its goal.

use std::cmp::Ordering;

use kane_algebra::syntax::NoValue;
use kane_kernel::{Atom, Expr, Finding, Poly, Relation, Root, Side, Target};
use num_bigint::BigInt;
use num_rational::BigRational;

use crate::argument::BoundedSum;

/// A proof or a witness, step by step.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Proof {
    /// what the variables of its polynomials stand for
    pub variables: Vec<Variable>,
    /// the steps, in order; a long proof ends after [`MAX_STEPS`](super::MAX_STEPS) of them and one more
    pub steps: Vec<Step>,
}

/// What a variable of a proof stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Variable {
    /// the symbol with this index
    Symbol(usize),
    /// the definition with this index
    Definition(usize),
    /// a square root
    Root(Expr),
    /// the t > 0 that tends to 0
    Germ,
    /// a quantity that has a limit
    Limiting(Expr),
    /// another, by its number
    Unnamed(usize),
}

/// Where an assumption comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// the hypothesis with this index, at a point
    Hypothesis(usize),
    /// a limit in the hypothesis with this index
    Limit(usize),
    /// the `when` of the claim
    Condition,
    /// the claim, which is supposed to fail
    Failure,
}

/// What is supposed and contradicts itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Supposed {
    /// that the hypotheses hold
    Hypotheses,
    /// that the hypotheses hold and the claim does not
    Failure,
    /// that the hypotheses hold and a side of the claim has no value; where both have, they are equal
    NoValue,
}

/// A step; what follows from it alone is inside of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Step {
    /// These definitions, by their indices, have values wherever the hypotheses hold, and stay as they are: what
    /// follows is so for any values of them.
    Kept(Vec<usize>),
    /// What a finding excludes is supposed, and contradicts itself.
    Suppose {
        /// what is supposed
        what: Supposed,
        /// the contradiction
        then: Vec<Self>,
    },
    /// A formula says that these hold.
    Assume {
        /// where it comes from
        source: Source,
        /// what it says
        atoms: Vec<Atom>,
    },
    /// A formula says that one of several cases holds.
    Cases {
        /// where it comes from
        source: Source,
        /// what holds in each case, and what follows
        cases: Vec<(Vec<Atom>, Vec<Self>)>,
    },
    /// A polynomial is zero, positive or negative.
    Split {
        /// the polynomial
        poly: Poly,
        /// what follows if it is 0
        zero: Vec<Self>,
        /// if it is > 0
        positive: Vec<Self>,
        /// if it is < 0
        negative: Vec<Self>,
    },
    /// Variables are replaced one after the other, and conditions divided by what does not vanish.
    Solve {
        /// what is replaced, in order
        solved: Vec<Solved>,
        /// that these do not vanish, or are positive, is used
        divided: Vec<Atom>,
        /// what is left of the conditions that are used further on, where they changed
        leaves: Vec<Atom>,
    },
    /// Powers of a variable are lowered by an equation.
    Reduce {
        /// the variable
        variable: usize,
        /// the equation
        by: Atom,
        /// what is left of the atoms that it changes
        leaves: Vec<Atom>,
    },
    /// An atom is a number times powers of what contradicts it.
    Factors {
        /// the atom
        atom: Atom,
        /// what is known of its factors, with their powers
        factors: Vec<(Atom, u32)>,
    },
    /// Conditions on one polynomial cannot all hold.
    Clash(Vec<Atom>),
    /// A multiple of what is not 0 is a sum of multiples of what is 0.
    Multiple {
        /// what is not 0, and how often
        atom: (BigInt, Poly),
        /// the factor, and what vanishes
        multiples: Vec<(Poly, Poly)>,
    },
    /// Both sides of the claim are the same quotient.
    Equal {
        /// the sides as the claim has them
        sides: (Expr, Expr),
        /// numerator and denominator
        value: (Poly, Poly),
    },
    /// A sum that is zero identically has non-negative terms, one of them positive.
    Positive {
        /// the terms
        terms: Vec<Summand>,
        /// multiples of what vanishes: the factor, and what does
        multiples: Vec<(Poly, Poly)>,
    },
    /// Measured from bounds of its variables, all coefficients of an atom have the other sign.
    SignsOfCoefficients {
        /// the atom
        atom: Atom,
        /// the bounds that were assumed
        bounds: Vec<Atom>,
        /// whether declared ranges of symbols are bounds, too
        ranges: bool,
        /// a multiple of the atom's polynomial, or of its opposite, as a sum of products of the bounds; nothing where
        /// they are the variables themselves, and it is the polynomial
        sum: Option<BoundedSum>,
    },
    /// On no part of a line do all atoms hold.
    SignTable {
        /// the variable of the line
        variable: usize,
        /// where the line is cut, ascending
        cuts: Vec<Root>,
        /// the atoms
        atoms: Vec<Atom>,
    },
    /// An atom is a constant and false.
    Absurd(Atom),
    /// What holds along a germ holds at its end.
    Pass {
        /// the side of the limit
        side: Side,
        /// the power of t that is added to the end point, or divides 1
        power: u32,
        /// what holds along it
        along: Atom,
        /// why: the opposite contradicts itself
        otherwise: Vec<Self>,
        /// what holds at the end
        end: Atom,
    },
    /// A limit from one side, read off a quotient of polynomials in t.
    LimitFrom {
        /// the side
        side: Side,
        /// the power of t that is added to the end point, or divides 1
        power: u32,
        /// what tends
        of: Expr,
        /// how it compares with the quotient for small t > 0
        sense: Ordering,
        /// numerator and denominator
        quotient: (Poly, Poly),
        /// why it does: the opposite contradicts itself
        otherwise: Vec<Self>,
        /// numerator and denominator at t = 0
        start: (Poly, Poly),
        /// the order to which the denominator vanishes there
        order: u32,
    },
    /// A point, and what becomes of the statements there.
    Point {
        /// the symbols that are mentioned
        values: Vec<Assignment>,
        /// the definitions that are mentioned, by their indices, with their values
        definitions: Vec<(usize, Measured)>,
        /// what the hypotheses, the condition and the claim say there
        said: Vec<Said>,
    },
    /// What the givens that are not cited say at a point.
    Beside {
        /// whether all of them hold there, and not only those fail that are told
        all: bool,
        /// the symbols that they speak of besides
        values: Vec<Assignment>,
        /// what they say there; each is the hypothesis of its place
        said: Vec<Said>,
    },
    /// Functions of one symbol, for which all hypotheses hold and the claim does not.
    Functions {
        /// the symbol
        of: usize,
        /// the functions
        values: Vec<Assignment>,
        /// by hypothesis, why it holds
        hypotheses: Vec<Held>,
        /// how the claim fails
        end: End,
    },
}

/// A variable with what replaces it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Solved {
    /// the variable
    pub variable: usize,
    /// numerator and denominator
    pub value: (Poly, Poly),
    /// what says so, if it is an assumption
    pub source: Option<Source>,
}

/// weight · square² · Π factorⁿ
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Summand {
    /// the weight, positive
    pub weight: BigInt,
    /// what is squared
    pub square: Poly,
    /// what is known not to be negative, with its powers
    pub factors: Vec<(Poly, u32)>,
}

/// A symbol with its value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assignment {
    /// the symbol's index
    pub symbol: usize,
    /// its value
    pub value: Value,
}

/// The value of a symbol in a witness.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// a number
    Number(BigRational),
    /// the root of a polynomial
    Root(Root),
    /// Σ coefficientᵢ · rootⁱ
    InRoot {
        /// the coefficients, ascending
        coefficients: Vec<BigRational>,
        /// the root
        root: Root,
    },
    /// a function
    Function(Expr),
}

/// A relation of a statement at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Said {
    /// whose it is
    pub of: Speaker,
    /// the relation
    pub relation: Relation,
    /// what becomes of it
    pub comparison: Comparison,
    /// the relations that `or`, `implies` or `iff` joins, and what becomes of them
    pub parts: Vec<(Relation, Comparison)>,
}

/// Whose relation it is that holds or fails at a point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Speaker {
    /// the hypothesis with this index
    Hypothesis(usize),
    /// the hypothesis with this index, which says nothing there: the relation is a condition of it that fails or, of a
    /// cited claim, what is undefined
    Idle(usize),
    /// the `when` of the claim
    Condition,
    /// the claim
    Claim,
}

/// A value at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Measured {
    /// the value
    Exact(BigRational),
    /// a number near it: the point is irrational
    Near(BigRational),
    /// there is none
    None(NoValue),
}

/// A relation at a point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// the values of its sides
    Sides(Measured, Measured),
    /// whether `or`, `implies` or `iff` of relations holds
    Truth(bool),
    /// the relation, why it has no meaning, and what it divides by though it is 0
    Undefined(Relation, NoValue, Option<Expr>),
}

/// Why a hypothesis holds for functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Held {
    /// whether it takes a sign table or a substitution to see
    pub by_proof: bool,
    /// whether it also is about limits
    pub limits: bool,
}

/// How a claim fails for functions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum End {
    /// all hypotheses hold, which was in question
    Holds,
    /// it fails where the symbol has this value, if the value is known
    At(usize, Option<Value>),
    /// the limit is another
    Limit {
        /// which one
        target: Target,
        /// of a limit from both sides, whether this is the one from above
        above: Option<bool>,
        /// whether what it is claimed to be is undefined for these values
        against_nothing: bool,
    },
}

/// A finding in outline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reason {
    /// a contradiction, by these means
    Contradiction(Means),
    /// a limit, read off on its first side: numerator and denominator, and their variables
    Limit {
        /// the side
        side: Side,
        /// the power of t that is added to the end point, or divides 1
        power: u32,
        /// how it compares with the quotient for small t > 0
        sense: Ordering,
        /// numerator and denominator
        quotient: (Poly, Poly),
        /// what their variables stand for
        variables: Vec<Variable>,
    },
    /// a limit by cases: the polynomials in constants whose signs are told apart
    LimitByCases(Vec<Poly>),
    /// a limit without a side
    NoSide,
    /// a point
    Point {
        /// the symbols that the claim mentions, or if there are none, the others
        values: Vec<Assignment>,
        /// the last relation of the claim there
        claim: Option<Comparison>,
    },
    /// functions
    Functions {
        /// the functions
        values: Vec<Assignment>,
        /// how the claim fails
        end: End,
    },
}

/// By what a contradiction was reached.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Means {
    /// what the contradiction shows
    pub finding: Finding,
    /// whether limits were passed to
    pub limits: bool,
    /// what was substituted, in the order of the proof
    pub substituted: Vec<Variable>,
    /// what there is a sign table in
    pub tables: Vec<Variable>,
    /// whether a sum of non-negative terms vanished
    pub sums: bool,
    /// whether signs of coefficients contradicted bounds
    pub signs: bool,
}
