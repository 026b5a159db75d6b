//! Points by approach: near a point conditions are taken as linear, the shortest step is taken to where
//! those that fail would hold, and so on (Newton's method for inequalities, Pshenichnyi 1970). The numbers
//! are dyadic and all arithmetic is exact, so a point that is found satisfies the conditions as it stands.

use kane_algebra::cells::{Cells, cells};
use kane_algebra::point::{Partial, specialised};
use kane_kernel::{Atom, Fuel, Point, Poly, Power, Sign, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::elimination::Elimination;
use super::sample::{candidates, complete, diagonal};
use super::search::Search;

type Q = BigRational;

/// Steps from one point.
const STEPS: usize = 16;
/// Variables and conditions of a state that is tried.
const VARIABLES: usize = 8;
const CONDITIONS: usize = 16;
/// Bits of their coefficients.
const BITS: u64 = 256;
/// By how much of its size a condition is to hold, as parts of one.
const MARGINS: [i64; 3] = [16, 256, 8192];
/// Coordinates beyond which it is given up.
const FAR: i64 = 1 << 20;
/// Binary digits behind the point that a coordinate keeps.
const DIGITS: u32 = 24;
/// Cells in which the last coordinates are looked for where equations are left.
const CELLS: usize = 60;

impl Search<'_> {
    /// A point of a state by approach, with its last coordinates on the curves of its equations.
    pub(super) fn by_approach(
        &self,
        state: &State<'_, '_>,
        trail: &[Elimination],
        vars: &[usize],
        starts: usize,
    ) -> Option<Point> {
        let fuel = &self.cells;
        let live: Vec<Atom> =
            state.atoms.iter().filter(|a| a.decided().is_none()).cloned().collect();
        let equations = live.iter().filter(|a| a.sign == Sign::Zero).count();
        let fits = (2..=VARIABLES).contains(&vars.len())
            && live.len() <= CONDITIONS
            && live.iter().all(|a| a.poly.bits() <= BITS);
        if !fits || equations > 2 || equations >= vars.len() || !self.step(state) {
            return None;
        }
        let slopes = |a: &Atom| {
            let slope = |v: &usize| a.poly.derivative(*v, fuel).ok();
            vars.iter().map(slope).collect::<Option<Vec<Poly>>>()
        };
        let slopes: Vec<Vec<Poly>> = live.iter().map(slopes).collect::<Option<_>>()?;
        let lists: Vec<Vec<Q>> = vars.iter().map(|&v| candidates(state, v)).collect();
        let near = Near { atoms: &live, slopes: &slopes, vars, fuel };
        diagonal(&lists, starts).into_iter().find_map(|start| {
            MARGINS.iter().find_map(|m| {
                let margin = Q::new(1.into(), (*m).into());
                let found = near.simplest(near.from(&start, &margin)?);
                complete(state, near.solved(&found, equations)?, trail)
            })
        })
    }
}

struct Near<'a> {
    atoms: &'a [Atom],
    slopes: &'a [Vec<Poly>],
    vars: &'a [usize],
    fuel: &'a Fuel,
}

/// The value of a polynomial at a point whose coordinates are multiples of 2^−DIGITS: a sum of integers
/// over one power of two, so that nothing is reduced on the way.
fn value(p: &Poly, vars: &[usize], at: &[Q], fuel: &Fuel) -> Option<Q> {
    let degree = |m: &[Power]| m.iter().map(|x| x.1).sum::<u32>();
    let highest = p.terms().map(|(m, _)| degree(m)).max().unwrap_or(0);
    fuel.spend(u64::try_from(p.len()).ok()? * u64::from(4 + highest)).ok()?;
    let whole: Vec<BigInt> =
        at.iter().map(|x| (x * Q::from_integer(BigInt::one() << DIGITS)).to_integer()).collect();
    let mut sum = BigInt::zero();
    for (m, c) in p.terms() {
        let mut term = c << (DIGITS * (highest - degree(m)));
        for &(v, n) in m {
            term *= whole[vars.iter().position(|w| *w == v)?].pow(n);
        }
        sum += term;
    }
    Some(Q::new(sum, BigInt::one() << (DIGITS * highest)))
}

/// The nearest multiple of 2^−digits.
fn rounded(q: &Q, digits: u32) -> Q {
    let unit = BigInt::one() << digits;
    Q::new((q * Q::from_integer(unit.clone())).round().to_integer(), unit)
}

/// The solution of a square system whose rows end in the right sides, its numbers rounded on the way;
/// `None` if a pivot vanishes.
fn solved(mut system: Vec<Vec<Q>>, fuel: &Fuel) -> Option<Vec<Q>> {
    let n = system.len();
    for i in 0..n {
        fuel.spend(20 * u64::try_from(n * n).ok()?).ok()?;
        let pivot = (i..n).find(|&r| !system[r][i].is_zero())?;
        system.swap(i, pivot);
        let row: Vec<Q> = system[i].iter().map(|x| x / &system[i][i]).collect();
        for (r, other) in system.iter_mut().enumerate() {
            if r != i {
                let factor = other[i].clone();
                for (x, y) in other.iter_mut().zip(&row) {
                    *x = rounded(&(&*x - &factor * y), 2 * DIGITS);
                }
            }
        }
        system[i] = row;
    }
    system.into_iter().map(|mut row| row.pop()).collect()
}

impl Near<'_> {
    /// Values and slopes of all conditions, each with its size.
    fn seen(&self, at: &[Q]) -> Option<Vec<(Q, Vec<Q>, Q)>> {
        let all = self.atoms.iter().zip(self.slopes);
        all.map(|(a, slopes)| {
            let here = |p: &Poly| value(p, self.vars, at, self.fuel);
            let slopes: Vec<Q> = slopes.iter().map(here).collect::<Option<_>>()?;
            let steep = slopes.iter().fold(Q::zero(), |s, g| s + g.abs());
            Some((here(&a.poly)?, slopes, steep + Q::new(1.into(), 1024.into())))
        })
        .collect()
    }

    /// Whether all conditions hold, equations nearly.
    fn holds(&self, seen: &[(Q, Vec<Q>, Q)]) -> bool {
        let nearly = Q::new(1.into(), (1 << 16).into());
        self.atoms.iter().zip(seen).all(|(a, (value, _, size))| match a.sign {
            Sign::Zero => value.abs() / size < nearly,
            sign => sign.admits(kane_kernel::sign(value.numer())),
        })
    }

    /// A point where all conditions hold, equations nearly.
    fn from(&self, start: &[Q], margin: &Q) -> Option<Vec<Q>> {
        let mut at: Vec<Q> = start.iter().map(|x| rounded(x, DIGITS)).collect();
        for _ in 0..STEPS {
            let seen = self.seen(&at)?;
            if self.holds(&seen) {
                return Some(at);
            }
            let step = self.step(&seen, margin)?;
            at = at.iter().zip(&step).map(|(x, d)| rounded(&(x + d), DIGITS)).collect();
            if at.iter().any(|x| x.abs() > Q::from_integer(FAR.into())) {
                return None;
            }
        }
        None
    }

    /// The shortest step after which the conditions that fail now, or hold by less than a margin, hold by
    /// that margin if they are linear: d = Jᵀ·w with (J·Jᵀ + a little)·w = what is missing.
    fn step(&self, seen: &[(Q, Vec<Q>, Q)], margin: &Q) -> Option<Vec<Q>> {
        let mut rows: Vec<(&Vec<Q>, Q)> = Vec::new();
        for (a, (value, slopes, size)) in self.atoms.iter().zip(seen) {
            let missing = match a.sign {
                Sign::Zero => -value,
                Sign::Positive | Sign::NonNegative => margin * size - value,
                Sign::NonZero => continue,
            };
            if a.sign == Sign::Zero || missing.is_positive() {
                rows.push((slopes, missing));
            }
        }
        let dot = |a: &[Q], b: &[Q]| a.iter().zip(b).fold(Q::zero(), |s, (x, y)| s + x * y);
        let little = Q::new(1.into(), (1 << 20).into());
        let mut system: Vec<Vec<Q>> = Vec::new();
        for (i, (a, missing)) in rows.iter().enumerate() {
            let mut row: Vec<Q> = rows.iter().map(|(b, _)| rounded(&dot(a, b), DIGITS)).collect();
            row[i] += &little;
            row.push(rounded(missing, DIGITS));
            system.push(row);
        }
        let weights = solved(system, self.fuel)?;
        let n = self.vars.len();
        let along =
            |j: usize| rows.iter().zip(&weights).fold(Q::zero(), |s, (r, w)| s + &r.0[j] * w);
        Some((0..n).map(along).collect())
    }

    /// The same point with as few digits as leave it one.
    fn simplest(&self, at: Vec<Q>) -> Vec<Q> {
        let short = (0..DIGITS).find_map(|digits| {
            let short: Vec<Q> = at.iter().map(|x| rounded(x, digits)).collect();
            self.seen(&short).is_some_and(|seen| self.holds(&seen)).then_some(short)
        });
        short.unwrap_or(at)
    }

    /// The point itself, or one beside it on the curves of the equations.
    fn solved(&self, at: &[Q], equations: usize) -> Option<Partial> {
        let n = self.vars.len();
        let chosen: Vec<Vec<usize>> = match equations {
            0 => vec![Vec::new()],
            1 => (0..n).map(|i| vec![i]).collect(),
            _ => (0..n).flat_map(|j| (0..j).map(move |i| vec![i, j])).take(6).collect(),
        };
        chosen.iter().find_map(|last| {
            let fixed = (0..n).filter(|i| !last.contains(i));
            let values: Vec<(usize, Q)> = fixed.map(|i| (self.vars[i], at[i].clone())).collect();
            let there = |a: &Atom| Atom::new(specialised(&a.poly, &values), a.sign);
            let atoms: Vec<Atom> = self.atoms.iter().map(there).collect();
            let vars: Vec<usize> = last.iter().map(|i| self.vars[*i]).collect();
            let mut steps = CELLS;
            let Cells::Point(mut partial) = cells(&atoms, &vars, &mut steps, self.fuel) else {
                return None;
            };
            values.into_iter().for_each(|(v, q)| partial.set(v, q));
            Some(partial)
        })
    }
}
