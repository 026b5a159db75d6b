//! The line over a point: its cells, each with a value in the field of one real algebraic number.

use kane_kernel::{Fuel, Poly, Root, sign_at};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use polycore::Uni;

use super::resultant::{norm, whole};
use crate::descartes::descartes;
use crate::field::{Field, theta};
use crate::point::Partial;
use crate::ring::univariate;
use crate::sign_table::{Cell, SignTable, midpoint, refine};

type Q = BigRational;

/// Degree over ℚ of the number that carries all coordinates.
const DEGREE: usize = 16;
/// Degree of a polynomial that has all values of a coordinate among its roots.
const NORM: usize = 24;
/// Halvings of an interval.
const HALVINGS: usize = 400;
/// Multiples of a coordinate that are tried for the number that carries both.
const MULTIPLES: i64 = 6;

impl Partial {
    /// Sign of a polynomial all of whose variables have values: exact; `None` if one has none, or if
    /// the sign does not come out.
    #[must_use]
    pub fn sign(&self, p: &Poly, fuel: &Fuel) -> Option<i8> {
        let value = self.eval(p)?;
        let Some(root) = &self.generator else {
            return Some(value.0.first().map_or(0, |c| kane_kernel::sign(c.numer())));
        };
        if value.is_zero() {
            return Some(0);
        }
        let value = whole(&value);
        let mut root = root.clone();
        for _ in 0..HALVINGS {
            if root.is_exact() || descartes(&value, Some(&root.lo), Some(&root.hi), fuel).ok()? == 0
            {
                return Some(sign_at(&value, &midpoint(&root.lo, &root.hi, fuel).ok()?));
            }
            refine(&mut root, fuel).ok()?;
        }
        None
    }

    /// Coefficients of p in v over the field of the point.
    fn along(&self, p: &Poly, v: usize) -> Option<Vec<Uni<Q>>> {
        let mut out: Vec<Uni<Q>> =
            p.coefficients(v).iter().map(|c| self.eval(c)).collect::<Option<_>>()?;
        while out.last().is_some_and(|u| u.is_zero()) {
            out.pop();
        }
        Some(out)
    }
}

/// A line over a point.
pub(super) struct Fibre<'a> {
    base: &'a Partial,
    v: usize,
    table: SignTable,
}

impl<'a> Fibre<'a> {
    /// Cuts the line of v over a point at the zeros of polynomials, and perhaps at more points.
    /// `None` if that takes too much.
    pub(super) fn new(base: &'a Partial, polys: &[Poly], v: usize, fuel: &Fuel) -> Option<Self> {
        let mut cuts: Vec<Vec<BigInt>> = Vec::new();
        for p in polys.iter().filter(|p| p.degree(v) > 0) {
            let along = base.along(p, v)?;
            let found = match &base.generator {
                _ if along.len() < 2 => continue,
                _ if along.iter().all(|c| c.deg() == 0) => {
                    let rational = along.iter().map(|c| c.0.first().cloned().unwrap_or_default());
                    whole(&Uni::new(rational.collect()))
                }
                Some(root) => {
                    let field = Field::of(root);
                    if field.modulus().deg() * (along.len() - 1) > NORM {
                        return None;
                    }
                    norm(field.modulus(), &along, fuel)?
                }
                None => univariate(p, v)?,
            };
            if found.len() > 1 && !cuts.contains(&found) {
                cuts.push(found);
            }
        }
        Some(Self { base, v, table: SignTable::at_roots(&cuts, fuel).ok()? })
    }

    /// The cells, those with simple values first.
    pub(super) fn cells(&self) -> Vec<Cell> {
        let mut cells: Vec<Cell> = self.table.cells().collect();
        cells.sort_by_key(|c| match c {
            Cell::Root(i) if !self.table.roots[*i].is_exact() => (1, BigInt::zero()),
            _ => {
                let q = self.table.sample(*c);
                (0, num_traits::Signed::abs(q.numer()) + q.denom() * 2)
            }
        });
        cells
    }

    /// The base with a value of v in a cell; `None` if that takes too much.
    pub(super) fn point(&self, cell: Cell, fuel: &Fuel) -> Option<Partial> {
        let mut out = self.base.clone();
        match cell {
            Cell::Root(i) if !self.table.roots[i].is_exact() => {
                let root = &self.table.roots[i];
                if root.poly.len() > DEGREE + 1 {
                    return None;
                }
                match &self.base.generator {
                    None => {
                        out.generator = Some(root.clone());
                        out.values.insert(self.v, theta());
                        Some(out)
                    }
                    Some(x) => joined(&self.base.values, x, root, self.v, fuel),
                }
            }
            _ => {
                out.set(self.v, self.table.sample(cell));
                Some(out)
            }
        }
    }
}

/// Values in ℚ(x) and a number y beside them, all in ℚ(θ) for θ = y + k·x (the theorem of the primitive
/// element).
fn joined(
    values: &std::collections::BTreeMap<usize, Uni<Q>>,
    x: &Root,
    y: &Root,
    v: usize,
    fuel: &Fuel,
) -> Option<Partial> {
    let (of_x, of_y) = (Field::of(x), Field::of(y));
    let (m, r) = (of_x.modulus(), of_y.modulus());
    if m.deg() * r.deg() > NORM {
        return None;
    }
    (1..=MULTIPLES).find_map(|k| {
        let k = Q::from_integer(k.into());
        // Resₓ(m(x), r(t − k·x)): the coefficients of r(t − k·x) in t, by Taylor's formula.
        let mut coefficients: Vec<Uni<Q>> = Vec::new();
        let mut slope = r.clone();
        let mut factorial = Q::one();
        let minus = Uni::new(vec![Q::zero(), -k.clone()]);
        for n in 0..=r.deg() {
            if n > 0 {
                factorial *= Q::from_integer(n.into());
            }
            let at = slope.compose(&minus).scale(&factorial.recip());
            coefficients.push(of_x.reduced(at));
            slope = slope.derivative();
        }
        let sums = norm(m, &coefficients, fuel)?;
        let table = SignTable::at_roots(&[sums], fuel).ok()?;
        // Intervals of x and y that leave one root for θ.
        let (mut x, mut y) = (x.clone(), y.clone());
        let mut found = None;
        for _ in 0..HALVINGS {
            let (lo, hi) = (&y.lo + &k * &x.lo, &y.hi + &k * &x.hi);
            let mut inside = table.roots.iter().filter(|t| t.lo <= hi && lo <= t.hi);
            match (inside.next(), inside.next()) {
                (Some(t), None) => {
                    found = Some(t.clone());
                    break;
                }
                (None, _) => return None,
                _ => {}
            }
            refine(&mut x, fuel).ok()?;
            refine(&mut y, fuel).ok()?;
        }
        let generator = found.filter(|t| !t.is_exact() && t.poly.len() <= DEGREE + 1)?;
        let field = Field::of(&generator);
        // x is the common root of m(X) and r(θ − k·X).
        let mut shifted: Vec<Uni<Q>> = vec![Uni::constant(Q::zero()); r.deg() + 1];
        let step = vec![theta(), Uni::constant(-k.clone())];
        let mut power = vec![Uni::constant(Q::one())];
        for c in &r.0 {
            for (sum, p) in shifted.iter_mut().zip(&power) {
                *sum = &*sum + &p.scale(c);
            }
            power = field.product(&power, &step);
        }
        let constant = m.0.iter().map(|c| Uni::constant(c.clone())).collect();
        let common = field.gcd(constant, shifted, fuel)?;
        let [c, d] = <[Uni<Q>; 2]>::try_from(common).ok()?;
        let at = field.reduced(&(-&c) * &field.inverse(&d, fuel)?);
        let mut out = Partial { generator: Some(generator), ..Partial::default() };
        for (w, value) in values {
            let moved = value.0.iter().rev().fold(Uni::constant(Q::zero()), |sum, c| {
                &field.reduced(&sum * &at) + &Uni::constant(c.clone())
            });
            out.values.insert(*w, moved);
        }
        out.values.insert(v, &theta() - &at.scale(&k));
        Some(out)
    })
}
