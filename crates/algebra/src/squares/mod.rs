//! Sums of squares: identities P + Σ squares · products + Σ cofactors · equations = 0.
//!
//! Where P is positive, the products are not negative and the equations hold, such an identity is a
//! contradiction (Krivine 1964, Stengle 1974). It is looked for among Gram matrices: floats find a
//! positive semidefinite one (Parrilo 2000), rational numbers nearby are tried, and what is returned
//! is exact: the identity holds as polynomials, or there is no answer.

mod contact;
mod elimination;
mod grading;
mod gram;
mod ldl;
mod rounding;

use kane_kernel::{Fuel, Poly};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;

pub use contact::{Contact, Place, Surd};
use elimination::Solution;
use gram::Gram;

type Q = BigRational;

/// What is asked: P, the products that may be multiplied by sums of squares, the equations, and the
/// degree of the whole identity.
#[derive(Clone, Debug)]
pub struct Question<'a> {
    /// P
    pub positive: &'a Poly,
    /// what is known not to be negative; 1 should be among it
    pub products: &'a [Poly],
    /// what is known to be zero
    pub equations: &'a [Poly],
    /// the degree that no summand exceeds
    pub degree: u32,
    /// where the identity leaves no room, as far as that is known
    pub contacts: &'a [Contact],
}

/// weight · base² · product, with a positive weight.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Square {
    /// index of the product
    pub product: usize,
    /// the weight
    pub weight: BigInt,
    /// the base
    pub base: Poly,
}

/// scale·P + Σ squares + Σ cofactorᵢ·equationᵢ = 0, exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Identity {
    /// positive
    pub scale: BigInt,
    /// the squares
    pub squares: Vec<Square>,
    /// one cofactor an equation
    pub cofactors: Vec<Poly>,
}

/// How often a face of the cone is entered, one inside the other or one instead of the other: each time the
/// matrices get smaller.
const FACES: usize = 6;
/// Unknown entries of Gram matrices, and free ones among them, beyond which nothing is tried.
const COLUMNS: usize = 2500;
const FREE: usize = 420;
/// Rows of one Gram matrix.
const ROWS: usize = 60;

/// An identity of the kind that is asked for; *exact* if there is an answer, and no answer says
/// nothing.
#[must_use]
pub fn identity(question: &Question<'_>, fuel: &Fuel) -> Option<Identity> {
    inside(question, &Gram::of(question, fuel)?, &mut FACES.clone(), fuel)
}

/// The identity by these matrices, or by those of a face of the cone.
fn inside(
    question: &Question<'_>,
    gram: &Gram,
    faces: &mut usize,
    fuel: &Fuel,
) -> Option<Identity> {
    let solution = Solution::of(gram.system(question, fuel)?, fuel)?;
    let (free, rows) = (solution.free.len(), gram.sizes().into_iter().max().unwrap_or(0));
    if free > FREE || rows > ROWS {
        return None;
    }
    match rounding::rounded(gram, &solution, fuel) {
        rounding::Rounded::Inside(squares) => Some(whole(gram, &solution, &squares)),
        rounding::Rounded::Faces(smaller) => smaller.iter().find_map(|face| {
            *faces = faces.checked_sub(1)?;
            inside(question, face, faces, fuel)
        }),
    }
}

/// The values of all unknowns, and the factors of the Gram matrices.
struct Exact {
    values: Vec<Q>,
    factors: Vec<Vec<ldl::Factor>>,
}

/// The identity in integers.
fn whole(gram: &Gram, solution: &Solution, exact: &Exact) -> Identity {
    let mut squares: Vec<(usize, Q, Poly)> = Vec::new();
    for (block, factors) in gram.blocks.iter().zip(&exact.factors) {
        for factor in factors {
            let common = factor.row.iter().fold(BigInt::one(), |l, q| l.lcm(q.denom()));
            let mut base = Poly::default();
            for (q, p) in factor.row.iter().zip(&block.basis) {
                base = base.add(&p.scale(&(q * Q::from(common.clone())).to_integer()));
            }
            let (content, base) = base.primitive();
            let unit = Q::new(content, common);
            squares.push((block.product, &factor.weight * &unit * unit.clone(), base));
        }
    }
    let mut cofactors = vec![Vec::new(); gram.equations];
    for (column, value) in solution.columns.iter().zip(&exact.values) {
        if let elimination::Column::Cofactor { equation, monomial } = column {
            cofactors[*equation].push((monomial.clone(), value.clone()));
        }
    }
    let weights = squares.iter().map(|s| &s.1);
    let scale = weights
        .chain(cofactors.iter().flatten().map(|c| &c.1))
        .fold(BigInt::one(), |l, q| l.lcm(q.denom()));
    let integer = |q: &Q| (q * Q::from(scale.clone())).to_integer();
    let squares = squares.iter().map(|(product, weight, base)| Square {
        product: *product,
        weight: integer(weight),
        base: base.clone(),
    });
    let cofactor = |terms: &Vec<(kane_kernel::Monomial, Q)>| {
        Poly::sum(terms.iter().map(|(m, q)| (m.clone(), integer(q))))
    };
    Identity {
        squares: squares.collect(),
        cofactors: cofactors.iter().map(cofactor).collect(),
        scale,
    }
}

/// The degree of a polynomial in all its variables together.
#[must_use]
pub fn total_degree(p: &Poly) -> u32 {
    p.terms().map(|(m, _)| m.iter().map(|f| f.1).sum()).max().unwrap_or(0)
}
