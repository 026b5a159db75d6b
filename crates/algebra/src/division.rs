//! Division with remainder in several variables, within a budget: between polynomials of few terms quotients
//! of any length are possible.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use kane_kernel::{Fuel, Monomial, Poly, Power, exponent};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{One as _, Signed as _, Zero as _};

/// The place of a monomial in graded reverse lexicographic order: degree, then exponents of the last variables.
type Place = (u32, Reverse<Vec<u32>>);

/// Division with remainder in graded reverse lexicographic order: q, r and a positive integer c with
/// c·p = q·d + r, where no term of r is divisible by the first one of d. `None` if d = 0, or beyond this many
/// steps, or if the budget is spent.
#[must_use]
pub fn division(p: &Poly, d: &Poly, steps: usize, fuel: &Fuel) -> Option<(Poly, Poly, BigInt)> {
    let mut vars: Vec<usize> = p.vars().into_iter().chain(d.vars()).collect();
    vars.sort_unstable();
    vars.dedup();
    vars.reverse();
    let place = |m: &[Power]| -> Place {
        (m.iter().map(|x| x.1).sum(), Reverse(vars.iter().map(|v| exponent(m, *v)).collect()))
    };
    let mut left: BTreeMap<Place, BigInt> = p.terms().map(|(m, c)| (place(m), c.clone())).collect();
    let divisor: BTreeMap<Place, BigInt> = d.terms().map(|(m, c)| (place(m), c.clone())).collect();
    let ((first, lead), rest) = (divisor.last_key_value()?, divisor.len() - 1);
    let (mut q, mut r) = (BTreeMap::<Place, BigInt>::new(), BTreeMap::<Place, BigInt>::new());
    let mut scale = BigInt::one();
    let mut spent = 0;
    while let Some((at, c)) = left.pop_last() {
        let Some(by) = quotient(&at, first) else {
            r.insert(at, c);
            continue;
        };
        spent += 1;
        let width = u64::try_from(divisor.len()).ok()?;
        fuel.spend(width * (1 + (c.bits() + lead.bits()) / 64)).ok()?;
        if spent > steps {
            return None;
        }
        let common = c.gcd(lead) * lead.signum();
        let (times, c) = (lead / &common, c / &common);
        if !times.is_one() {
            fuel.spend(u64::try_from(left.len() + q.len() + r.len()).ok()?).ok()?;
            scale *= &times;
            for value in left.values_mut().chain(q.values_mut()).chain(r.values_mut()) {
                *value *= &times;
            }
        }
        for (of, value) in divisor.iter().take(rest) {
            let entry = left.entry(product(of, &by)).or_default();
            *entry -= value * &c;
            if entry.is_zero() {
                left.remove(&product(of, &by));
            }
        }
        q.insert(by, c);
    }
    let poly = |terms: BTreeMap<Place, BigInt>| {
        let monomial = |Reverse(exponents): Reverse<Vec<u32>>| -> Monomial {
            let powers = vars.iter().copied().zip(exponents).filter(|(_, n)| *n > 0);
            powers.rev().collect()
        };
        Poly::sum(terms.into_iter().map(|((_, exponents), c)| (monomial(exponents), c)))
    };
    Some((poly(q), poly(r), scale))
}

/// What is to be multiplied by the second to get the first, if anything is.
fn quotient(of: &Place, by: &Place) -> Option<Place> {
    let Reverse(of_exponents) = &of.1;
    let pairs = of_exponents.iter().zip(&by.1.0);
    let exponents = pairs.map(|(a, b)| a.checked_sub(*b)).collect::<Option<Vec<u32>>>()?;
    Some((of.0.checked_sub(by.0)?, Reverse(exponents)))
}

fn product(a: &Place, b: &Place) -> Place {
    let exponents = a.1.0.iter().zip(&b.1.0).map(|(x, y)| x + y).collect();
    (a.0 + b.0, Reverse(exponents))
}
