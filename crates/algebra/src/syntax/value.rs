//! What an expression of a document is worth: a number, a vector or a square matrix.
//!
//! Vectors and matrices are written out in components as they are read. The kernel sees numbers only.

use std::fmt;

use kane_kernel::Expr;

/// The axes, by which components are called.
const AXES: [&str; 3] = ["x", "y", "z"];

/// How the components of a vector or a matrix are arranged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// so many components, 2 or 3
    Vector(usize),
    /// as many rows and columns, 2 or 3, row by row
    Matrix(usize),
}

impl Shape {
    /// How many components there are.
    #[must_use]
    pub fn count(self) -> usize {
        match self {
            Self::Vector(n) => n,
            Self::Matrix(n) => n * n,
        }
    }

    /// What the components are called, in order: `x`, `y`, or `xx`, `xy`, `yx`, `yy`.
    #[must_use]
    pub fn components(self) -> Vec<String> {
        match self {
            Self::Vector(n) => AXES.iter().take(n).map(|&axis| axis.to_owned()).collect(),
            Self::Matrix(n) => {
                let axes = || AXES.iter().take(n);
                axes().flat_map(|row| axes().map(move |column| format!("{row}{column}"))).collect()
            }
        }
    }

    /// What the components of a symbol are called: `v_x`, and `v_x'` for `v'`.
    #[must_use]
    pub fn names(self, name: &str) -> Vec<String> {
        let bare = name.trim_end_matches(['\'', '′']);
        let primes = name.get(bare.len()..).unwrap_or_default();
        self.components().iter().map(|part| format!("{bare}_{part}{primes}")).collect()
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Vector(n) => write!(f, "a vector in R^{n}"),
            Self::Matrix(n) => write!(f, "a {n}x{n} matrix"),
        }
    }
}

/// An operator between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Plus,
    Minus,
    Times,
    Over,
}

impl Operator {
    /// Two numbers joined.
    pub(crate) fn join(self, a: Expr, b: Expr) -> Expr {
        let (a, b) = (a.into(), b.into());
        match self {
            Self::Plus => Expr::Add(a, b),
            Self::Minus => Expr::Sub(a, b),
            Self::Times => Expr::Mul(a, b),
            Self::Over => Expr::Div(a, b),
        }
    }

    /// As it is told of in a fault.
    pub(crate) fn sign(self) -> &'static str {
        match self {
            Self::Plus => "`+`",
            Self::Minus => "`-`",
            Self::Times => "`*`",
            Self::Over => "`/`",
        }
    }
}

/// A vector or a matrix, in components.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Array {
    /// how they are arranged
    pub shape: Shape,
    /// the components, as many as the shape says
    pub parts: Vec<Expr>,
}

/// What an expression is worth.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// a number
    Number(Expr),
    /// a vector or a matrix
    Array(Array),
}

impl Value {
    /// Its components; a number is the one of its own.
    #[must_use]
    pub fn parts(&self) -> &[Expr] {
        match self {
            Self::Number(e) => std::slice::from_ref(e),
            Self::Array(array) => &array.parts,
        }
    }

    /// The same with each component replaced.
    pub(crate) fn map(&self, change: impl FnMut(&Expr) -> Expr) -> Self {
        self.with_parts(self.parts().iter().map(change).collect())
    }

    /// The same with other components, of which there are as many.
    pub(crate) fn with_parts(&self, mut parts: Vec<Expr>) -> Self {
        match self {
            Self::Number(e) => Self::Number(parts.pop().unwrap_or_else(|| e.clone())),
            Self::Array(Array { shape, .. }) => Self::Array(Array { shape: *shape, parts }),
        }
    }

    /// What it is, in words.
    #[must_use]
    pub fn kind(&self) -> String {
        match self {
            Self::Number(_) => "a number".to_owned(),
            Self::Array(array) => array.shape.to_string(),
        }
    }

    /// Parts of all its expressions.
    pub(crate) fn size(&self) -> usize {
        self.parts().iter().map(size).sum()
    }
}

/// How many parts an expression has, itself included; a definition counts as one.
pub(crate) fn size(e: &Expr) -> usize {
    1 + e.children().into_iter().map(size).sum::<usize>()
}

impl Array {
    /// One component of a matrix, or of a vector in its one column.
    fn at(&self, row: usize, column: usize) -> Expr {
        let index = match self.shape {
            Shape::Vector(_) => row,
            Shape::Matrix(n) => row * n + column,
        };
        self.parts.get(index).cloned().unwrap_or_else(|| Expr::int(0))
    }

    fn rows(&self) -> usize {
        match self.shape {
            Shape::Vector(n) | Shape::Matrix(n) => n,
        }
    }

    /// Each component with the one of the other in its place.
    pub(crate) fn with(&self, other: &Self, make: impl Fn(Expr, Expr) -> Expr) -> Self {
        let pairs = self.parts.iter().zip(&other.parts);
        let parts = pairs.map(|(a, b)| make(a.clone(), b.clone())).collect();
        Self { shape: self.shape, parts }
    }

    /// Σ a·b
    pub(crate) fn dot(&self, other: &Self) -> Expr {
        sum(self.parts.iter().zip(&other.parts).map(|(a, b)| times(a.clone(), b.clone())))
    }

    /// a_x·b_y − a_y·b_x
    pub(crate) fn cross_in_the_plane(&self, other: &Self) -> Expr {
        self.minor(other, 0, 1)
    }

    /// a_i·b_j − a_j·b_i
    fn minor(&self, other: &Self, i: usize, j: usize) -> Expr {
        minus(times(self.at(i, 0), other.at(j, 0)), times(self.at(j, 0), other.at(i, 0)))
    }

    /// a × b in space
    pub(crate) fn cross(&self, other: &Self) -> Self {
        let parts = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| self.minor(other, i, j));
        Self { shape: self.shape, parts: parts.into() }
    }

    /// The vector in the plane, turned by a quarter and multiplied: w·(−a_y, a_x).
    pub(crate) fn turned(&self, w: &Expr) -> Self {
        let parts = vec![
            Expr::Neg(times(w.clone(), self.at(1, 0)).into()),
            times(w.clone(), self.at(0, 0)),
        ];
        Self { shape: self.shape, parts }
    }

    /// A matrix times a vector or a matrix.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let n = self.rows();
        let columns = match other.shape {
            Shape::Vector(_) => 1,
            Shape::Matrix(n) => n,
        };
        let part = |row, column| sum((0..n).map(|k| times(self.at(row, k), other.at(k, column))));
        let parts = (0..n).flat_map(|row| (0..columns).map(move |column| (row, column)));
        Self { shape: other.shape, parts: parts.map(|(row, column)| part(row, column)).collect() }
    }

    /// Rows as columns.
    pub(crate) fn transpose(&self) -> Self {
        let n = self.rows();
        let parts = (0..n).flat_map(|row| (0..n).map(move |column| (row, column)));
        Self { shape: self.shape, parts: parts.map(|(row, column)| self.at(column, row)).collect() }
    }

    /// The determinant; of three rows it is developed by the first.
    pub(crate) fn det(&self) -> Expr {
        match self.rows() {
            2 => minus(times(self.at(0, 0), self.at(1, 1)), times(self.at(0, 1), self.at(1, 0))),
            _ => sum((0..3).map(|column| times(self.at(0, column), self.cofactor(0, column)))),
        }
    }

    /// The determinant of what is left without a row and a column, with its sign.
    fn cofactor(&self, row: usize, column: usize) -> Expr {
        if self.rows() == 2 {
            let other = self.at(1 - row, 1 - column);
            return if row == column { other } else { Expr::Neg(other.into()) };
        }
        // the cyclic order has the sign in it
        let ([a, b], [c, d]) = ([1, 2].map(|k| (row + k) % 3), [1, 2].map(|k| (column + k) % 3));
        minus(times(self.at(a, c), self.at(b, d)), times(self.at(a, d), self.at(b, c)))
    }

    /// The cofactors, transposed, each over the determinant; undefined where that is zero.
    pub(crate) fn inverse(&self) -> Self {
        let (n, det) = (self.rows(), self.det());
        let parts = (0..n).flat_map(|row| (0..n).map(move |column| (row, column)));
        let part = |(row, column)| over(self.cofactor(column, row), det.clone());
        Self { shape: self.shape, parts: parts.map(part).collect() }
    }
}

fn times(a: Expr, b: Expr) -> Expr {
    Expr::Mul(a.into(), b.into())
}

fn minus(a: Expr, b: Expr) -> Expr {
    Expr::Sub(a.into(), b.into())
}

fn over(a: Expr, b: Expr) -> Expr {
    Expr::Div(a.into(), b.into())
}

fn sum(terms: impl Iterator<Item = Expr>) -> Expr {
    let all = terms.reduce(|a, b| Expr::Add(a.into(), b.into()));
    all.unwrap_or_else(|| Expr::int(0))
}
