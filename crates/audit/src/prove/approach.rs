//! Points by approach: near a point conditions are taken as linear, the shortest step is taken to where
//! those that fail would hold, and so on (Newton's method for inequalities, Pshenichnyi 1970). Numbers are
//! integers over one power of two, so that none is ever reduced. A step is rounded; the signs of conditions are exact, so
//! a point that is found satisfies them as it stands.

use kane_algebra::cells::{Cells, cells};
use kane_algebra::point::{Partial, specialised};
use kane_kernel::{Atom, Fuel, Point, Poly, Power, Sign, State};
use num_bigint::{BigInt, BigUint};
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::diagonal::diagonal;
use super::elimination::Elimination;
use super::sample::{candidates, complete};
use super::search::Search;

type Q = BigRational;

/// Steps from one point.
const STEPS: usize = 16;
/// Variables and conditions of a state that is tried.
const VARIABLES: usize = 8;
const CONDITIONS: usize = 16;
/// Bits of their coefficients.
const BITS: u64 = 256;
/// By how much of its size a condition is to hold: by 2^−m of it.
const MARGINS: [u32; 4] = [4, 8, 13, 18];
/// Coordinates beyond which it is given up.
const FAR: i64 = 1 << 20;
/// Binary digits behind the point that a coordinate keeps, and that values, slopes and steps keep.
const DIGITS: u32 = 24;
const FINE: u32 = 48;
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
        diagonal(&lists, starts).find_map(|start| {
            MARGINS.iter().find_map(|m| {
                let found = near.from(&start, *m)?;
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

/// The number nearest to x/2ᵏ, away from 0 where two are.
fn shifted(x: &BigInt, k: u32) -> BigInt {
    match k.checked_sub(1) {
        None => x.clone(),
        Some(half) => {
            let size = (x.magnitude() + (BigUint::one() << half)) >> k;
            BigInt::from_biguint(x.sign(), size)
        }
    }
}

/// A rational number in units of 2^−DIGITS.
fn units(q: &Q) -> BigInt {
    (q * Q::from_integer(BigInt::one() << DIGITS)).round().to_integer()
}

/// A condition seen from a point: its value, which has the right sign, its slopes, and its size, in units of 2^−FINE.
struct Seen {
    value: BigInt,
    slopes: Vec<BigInt>,
    size: BigInt,
}

/// The value of a polynomial at a point in units of 2^−DIGITS, in units of 2^−FINE and never rounded to 0: a sum of
/// integers over one power of two, so that nothing is reduced on the way.
fn value(p: &Poly, vars: &[usize], at: &[BigInt], fuel: &Fuel) -> Option<BigInt> {
    let degree = |m: &[Power]| m.iter().map(|x| x.1).sum::<u32>();
    let highest = p.terms().map(|(m, _)| degree(m)).max().unwrap_or(0);
    // the last factor counts the words of a term, of which there are several where the degree is high
    let words = 1 + u64::from(DIGITS) * u64::from(highest) / 256;
    fuel.spend(u64::try_from(p.len()).ok()? * u64::from(4 + highest) * words).ok()?;
    let mut sum = BigInt::zero();
    for (m, c) in p.terms() {
        let mut term = c << (DIGITS * (highest - degree(m)));
        for &(v, n) in m {
            term *= at[vars.iter().position(|w| *w == v)?].pow(n);
        }
        sum += term;
    }
    let scale = DIGITS * highest;
    let fine = if scale <= FINE { &sum << (FINE - scale) } else { shifted(&sum, scale - FINE) };
    Some(if fine.is_zero() { sum.signum() } else { fine })
}

/// The solution of a square system whose rows end in the right sides, in units of 2^−FINE; `None` if a pivot vanishes.
fn solved(mut system: Vec<Vec<BigInt>>, fuel: &Fuel) -> Option<Vec<BigInt>> {
    let n = system.len();
    for i in 0..n {
        fuel.spend(20 * u64::try_from(n * n).ok()?).ok()?;
        let pivot = (i..n).find(|&r| !system[r][i].is_zero())?;
        system.swap(i, pivot);
        let row: Vec<BigInt> = system[i].iter().map(|x| (x << FINE) / &system[i][i]).collect();
        for (r, other) in system.iter_mut().enumerate() {
            if r != i {
                let factor = other[i].clone();
                for (x, y) in other.iter_mut().zip(&row) {
                    *x -= shifted(&(&factor * y), FINE);
                }
            }
        }
        system[i] = row;
    }
    system.into_iter().map(|mut row| row.pop()).collect()
}

impl Near<'_> {
    /// All conditions as they are seen from a point.
    fn seen(&self, at: &[BigInt]) -> Option<Vec<Seen>> {
        let all = self.atoms.iter().zip(self.slopes);
        all.map(|(a, slopes)| {
            let here = |p: &Poly| value(p, self.vars, at, self.fuel);
            let slopes: Vec<BigInt> = slopes.iter().map(here).collect::<Option<_>>()?;
            let steep = slopes.iter().fold(BigInt::zero(), |s, g| s + g.abs());
            let size = steep + (BigInt::one() << (FINE - 10));
            Some(Seen { value: here(&a.poly)?, slopes, size })
        })
        .collect()
    }

    /// Whether all conditions hold, equations nearly: to 2^−16 of their size.
    fn holds(&self, seen: &[Seen]) -> bool {
        self.atoms.iter().zip(seen).all(|(a, seen)| match a.sign {
            Sign::Zero => seen.value.abs() << 16 < seen.size,
            sign => sign.admits(kane_kernel::sign(&seen.value)),
        })
    }

    /// A point where all conditions hold, equations nearly, with as few digits as leave it one.
    fn from(&self, start: &[Q], margin: u32) -> Option<Vec<Q>> {
        let mut at: Vec<BigInt> = start.iter().map(units).collect();
        let far = BigInt::from(FAR) << DIGITS;
        for _ in 0..STEPS {
            let seen = self.seen(&at)?;
            if self.holds(&seen) {
                return Some(self.simplest(at));
            }
            let step = self.step(&seen, margin)?;
            at.iter_mut().zip(&step).for_each(|(x, d)| *x += shifted(d, FINE - DIGITS));
            if at.iter().any(|x| x.abs() > far) {
                return None;
            }
        }
        None
    }

    /// The shortest step after which the conditions that fail now, or hold by less than a margin of size/2ᵐ, hold by
    /// that margin if they are linear: d = Jᵀ·w with (J·Jᵀ + a little)·w = what is missing.
    fn step(&self, seen: &[Seen], margin: u32) -> Option<Vec<BigInt>> {
        let mut rows: Vec<(&[BigInt], BigInt)> = Vec::new();
        for (a, seen) in self.atoms.iter().zip(seen) {
            let missing = match a.sign {
                Sign::Zero => -&seen.value,
                Sign::Positive | Sign::NonNegative => shifted(&seen.size, margin) - &seen.value,
                Sign::NonZero => continue,
            };
            if a.sign == Sign::Zero || missing.is_positive() {
                rows.push((&seen.slopes, missing));
            }
        }
        let dot = |a: &[BigInt], b: &[BigInt]| -> BigInt {
            a.iter().zip(b).map(|(x, y)| shifted(&(x * y), FINE)).sum()
        };
        let little = BigInt::one() << (FINE - 20);
        let mut system: Vec<Vec<BigInt>> = Vec::new();
        for (i, (a, missing)) in rows.iter().enumerate() {
            let mut row: Vec<BigInt> = rows.iter().map(|(b, _)| dot(a, b)).collect();
            row[i] += &little;
            row.push(missing.clone());
            system.push(row);
        }
        let weights = solved(system, self.fuel)?;
        let along = |j: usize| {
            rows.iter().zip(&weights).map(|(row, w)| shifted(&(&row.0[j] * w), FINE)).sum()
        };
        Some((0..self.vars.len()).map(along).collect())
    }

    fn simplest(&self, at: Vec<BigInt>) -> Vec<Q> {
        let short = (0..DIGITS).find_map(|digits| {
            let cut = |x: &BigInt| shifted(x, DIGITS - digits) << (DIGITS - digits);
            let short: Vec<BigInt> = at.iter().map(cut).collect();
            self.seen(&short).is_some_and(|seen| self.holds(&seen)).then_some(short)
        });
        let fraction = |x: BigInt| Q::new(x, BigInt::one() << DIGITS);
        short.unwrap_or(at).into_iter().map(fraction).collect()
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
