//! Contacts: simple places where a question about squares has no room, for a claim may touch there.

use kane_algebra::squares::{Contact, Place, Question};
use kane_kernel::{Expr, Fuel, Poly, State};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, ToPrimitive as _, Zero as _};

use super::variation::roots;

type Q = BigRational;

/// Coordinates that are tried, the simplest first, and how many of them by the number of variables.
const VALUES: [(i64, i64); 13] = [
    (0, 1),
    (1, 1),
    (-1, 1),
    (2, 1),
    (1, 2),
    (-2, 1),
    (-1, 2),
    (3, 1),
    (1, 3),
    (-3, 1),
    (3, 2),
    (2, 3),
    (-1, 3),
];
const COORDINATES: [usize; 4] = [13, 13, 9, 5];
/// Places that are kept.
const CONTACTS: usize = 12;
/// Coordinates a + b·√n that are tried: |a| and |b| up to these.
const RATIONAL: i64 = 3;
const ROOT: i64 = 1;
/// Variables beside √n with such coordinates.
const BESIDE: usize = 3;
/// Powers of such a coordinate that are made.
const MOST: usize = 13;
/// Terms beyond which such places are not looked for.
const TERMS: usize = 100;

/// Places with simple coordinates where a question has no room; with the one root of a number that a goal speaks of in
/// them, if none but the origin is rational.
pub(super) fn contacts(
    state: &State<'_, '_>,
    question: &Question<'_>,
    fuel: &Fuel,
) -> Vec<Contact> {
    let polys =
        || [question.positive].into_iter().chain(question.products).chain(question.equations);
    let mut vars: Vec<usize> = polys().flat_map(Poly::vars).collect();
    vars.sort_unstable();
    vars.dedup();
    let found = rational(question, &vars, fuel);
    if !found.iter().all(is_origin) {
        return found;
    }
    let with_root = only_root(state).and_then(|root| with_root(question, &vars, root, fuel));
    with_root.filter(|places| !places.is_empty()).unwrap_or(found)
}

fn rational(question: &Question<'_>, vars: &[usize], fuel: &Fuel) -> Vec<Contact> {
    let Some(&count) = COORDINATES.get(vars.len().wrapping_sub(1)) else { return Vec::new() };
    let cost = question.positive.len() as u64;
    let coordinate = |index: usize, k: u32| {
        let (n, d) = VALUES[index / count.pow(k) % count];
        BigRational::new(n.into(), d.into())
    };
    let n = u32::try_from(vars.len()).unwrap_or(u32::MAX);
    let points = (0..count.pow(n)).map(|index| -> Vec<(usize, BigRational)> {
        (0..).zip(vars).map(|(k, v)| (*v, coordinate(index, k))).collect()
    });
    // a direction has no length, and its last coordinate that is not 0 is 1
    let direction = |at: &Vec<(usize, BigRational)>| {
        at.iter().rev().find(|(_, q)| !q.is_zero()).is_some_and(|(_, q)| q.is_one())
    };
    let at = points.clone().map(|at| Contact::At(Place::rational(at)));
    let towards = points.filter(direction).map(|at| Contact::Towards(Place::rational(at)));
    let paid = |_: &Contact| fuel.spend(cost).is_ok();
    at.chain(towards).take_while(paid).filter(|c| c.is_of(question)).take(CONTACTS).collect()
}

/// Whether a contact is where all variables are zero, as it is of all forms.
fn is_origin(contact: &Contact) -> bool {
    matches!(contact, Contact::At(place) if place.values.iter().all(|(_, [q, _])| q.is_zero()))
}

/// The one root of a whole number of which a goal speaks, and the number, which is no square.
pub(super) fn only_root(state: &State<'_, '_>) -> Option<(usize, i64)> {
    let number = |v: usize| match state.scope.root(v)? {
        Expr::Sqrt(of) => match &**of {
            Expr::Num(q) if q.is_integer() => q.to_i64().filter(|n| *n > 0).map(|n| (v, n)),
            _ => None,
        },
        _ => None,
    };
    let mut whole = roots(state.scope).filter_map(number).filter(|(_, n)| n.isqrt().pow(2) != *n);
    let first = whole.next()?;
    whole.next().is_none().then_some(first)
}

/// Points whose coordinates have a square root.
fn with_root(
    question: &Question<'_>,
    vars: &[usize],
    (root, n): (usize, i64),
    fuel: &Fuel,
) -> Option<Vec<Contact>> {
    let others: Vec<usize> = vars.iter().copied().filter(|v| *v != root).collect();
    if others.is_empty() || others.len() > BESIDE {
        return None;
    }
    let grid: Vec<Whole> = (-ROOT..=ROOT)
        .flat_map(|b| (-RATIONAL..=RATIONAL).map(move |a| [a.into(), b.into()]))
        .collect();
    let zeros: Vec<Terms> = [question.positive]
        .into_iter()
        .chain(question.equations)
        .map(|p| Terms::of(p, root, &others))
        .collect::<Option<_>>()?;
    let powers: Vec<Vec<Whole>> = grid.iter().map(|at| powers(*at, n)).collect();
    let count = u32::try_from(others.len()).ok()?;
    let places = grid.len().pow(count);
    let terms: usize = zeros.iter().map(|terms| terms.0.len()).sum();
    if terms > TERMS {
        return None;
    }
    fuel.spend((places * terms) as u64 / 4).ok()?;
    let chosen = |index: usize, k: u32| index / grid.len().pow(k) % grid.len();
    let origin = |k: u32, index: usize| grid[chosen(index, k)] == [0, 0];
    let is_zero = |index: &usize| {
        if (0..count).all(|k| origin(k, *index)) {
            return false;
        }
        let at = |k: u32, e: u32| powers[chosen(*index, k)].get(e as usize).copied();
        zeros.iter().all(|terms| terms.value(n, &at) == Some([0, 0]))
    };
    let contact = |index: usize| {
        let surd = |[a, b]: Whole| [a, b].map(|x| Q::from_integer(BigInt::from(x)));
        let beside = (0..).zip(&others).map(|(k, v)| (*v, surd(grid[chosen(index, k)])));
        let values = beside.chain([(root, surd([0, 1]))]).collect();
        Contact::At(Place { radicand: Q::from_integer(n.into()), values })
    };
    let found = (0..places).filter(is_zero).map(contact);
    let touches = |c: &Contact| c.is_of(question) && c.is_flat(question, fuel);
    Some(found.filter(touches).take(CONTACTS).collect())
}

/// a + b·√n in whole numbers.
type Whole = [i128; 2];

/// The powers of a + b·√n as far as they fit.
fn powers(at: Whole, n: i64) -> Vec<Whole> {
    std::iter::successors(Some([1, 0]), |p| product(*p, at, n)).take(MOST).collect()
}

fn product([a, b]: Whole, [c, d]: Whole, n: i64) -> Option<Whole> {
    let both = b.checked_mul(d)?.checked_mul(n.into())?;
    let real = a.checked_mul(c)?.checked_add(both)?;
    Some([real, a.checked_mul(d)?.checked_add(b.checked_mul(c)?)?])
}

/// The terms of a polynomial: coefficient, power of the root, powers of the other variables.
struct Terms(Vec<(i128, u32, Vec<u32>)>);

impl Terms {
    fn of(p: &Poly, root: usize, others: &[usize]) -> Option<Self> {
        let exponent = |m: &[(usize, u32)], v: usize| kane_kernel::exponent(m, v);
        let term = |(m, c): (&[(usize, u32)], &BigInt)| {
            let powers = others.iter().map(|&v| exponent(m, v)).collect();
            Some((c.to_i128()?, exponent(m, root), powers))
        };
        p.terms().map(term).collect::<Option<_>>().map(Self)
    }

    /// The value where the kth of the other variables to the power e is this; `None` if it does not fit.
    fn value(&self, n: i64, at: &dyn Fn(u32, u32) -> Option<Whole>) -> Option<Whole> {
        let mut sum = [0i128; 2];
        for (c, of_root, powers) in &self.0 {
            let half = i128::from(n).checked_pow(of_root / 2)?.checked_mul(*c)?;
            let start = if of_root % 2 == 0 { [half, 0] } else { [0, half] };
            let mut others = (0..).zip(powers);
            let [a, b] = others.try_fold(start, |term, (k, e)| product(term, at(k, *e)?, n))?;
            sum = [sum[0].checked_add(a)?, sum[1].checked_add(b)?];
        }
        Some(sum)
    }
}
