//! Quotients of polynomials that divide each other.

use std::collections::BTreeMap;

use kane_kernel::{Fuel, Monomial, Poly, Power, exponent};
use num_bigint::BigInt;
use num_integer::Integer as _;
use num_traits::{Signed, Zero};

/// What it costs to take a term times a term from what is left, in operations.
const TERM: u64 = 8;
/// Terms of a divisor that are looked at one by one before its variables are gathered.
const FEW: usize = 8;

/// Quotient q and positive integers a, b with a·p = b·q·d, if d divides p over Q; q is primitive.
///
/// Exact where there is one. `None`, too, if the budget of which `fuel` is a part ends, if d is much longer
/// than p, or if there are more than 128 variables or degrees that do not fit beside each other.
#[must_use]
pub fn exact_quotient(p: &Poly, d: &Poly, fuel: &Fuel) -> Option<Poly> {
    if d.is_empty() || d.len() > p.len().saturating_mul(8) {
        return None;
    }
    let fits = |m: &[Power]| m.iter().all(|(v, e)| p.degree(*v) >= *e);
    if !d.terms().take(FEW).all(|(m, _)| fits(m))
        || d.len() > FEW && d.vars().iter().any(|v| d.degree(*v) > p.degree(*v))
    {
        return None;
    }
    if let (1, Some((m, c))) = (d.len(), d.terms().next()) {
        return monomial_quotient(p, m, c.is_negative());
    }
    let d = d.primitive().1;
    fuel.spend_beyond(TERM * (p.len() as u64 + d.len() as u64)).ok()?;
    if !divides_at_a_point(p, &d) {
        return None;
    }
    long_division(&p.primitive().1, &d, fuel)
}

/// Whether d(x) divides p(x) at one integer point, as it must if a primitive d divides p. A cheap
/// look before a long division.
fn divides_at_a_point(p: &Poly, d: &Poly) -> bool {
    const AT: [u32; 12] = [3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41];
    // in a word, where it suffices
    let word = |p: &Poly| {
        p.terms().try_fold(0i64, |sum, (m, c)| {
            let c = i64::try_from(c).ok()?;
            let power = |c: i64, &(v, e): &Power| {
                c.checked_mul(i64::from(AT[v % AT.len()]).checked_pow(e)?)
            };
            sum.checked_add(m.iter().try_fold(c, power)?)
        })
    };
    if let (Some(at), Some(of)) = (word(d), word(p)) {
        return at == 0 || of.checked_rem(at).is_none_or(|rest| rest == 0);
    }
    let value = |p: &Poly| {
        let mut sum = BigInt::zero();
        for (m, c) in p.terms() {
            let mut small = 1u64;
            let mut product = c.clone();
            for &(v, e) in m {
                let base = u64::from(AT[v % AT.len()]);
                match base.checked_pow(e).and_then(|power| small.checked_mul(power)) {
                    Some(next) => small = next,
                    None => product *= num_traits::pow(BigInt::from(base), e as usize),
                }
            }
            sum += product * small;
        }
        sum
    };
    let at = value(d);
    at.is_zero() || (value(p) % at).is_zero()
}

fn monomial_quotient(p: &Poly, m: &[Power], negative: bool) -> Option<Poly> {
    let divides = |n: &[Power]| m.iter().all(|(v, e)| exponent(n, *v) >= *e);
    if !p.terms().all(|(n, _)| divides(n)) {
        return None;
    }
    let terms = p.terms().map(|(n, c)| {
        let rest = n.iter().map(|&(v, e)| (v, e - exponent(m, v)));
        (rest.collect(), if negative { -c } else { c.clone() })
    });
    Some(Poly::sum(terms).primitive().1)
}

/// p/d of primitive polynomials, highest terms first. By Gauss's lemma the quotient has whole coefficients,
/// so the first that is not whole ends it.
fn long_division(p: &Poly, d: &Poly, fuel: &Fuel) -> Option<Poly> {
    let shape = Shape::of(p, d)?;
    let packed = |p: &Poly| p.terms().map(|(m, c)| (shape.packed(m), c.clone())).collect();
    let (mut rest, divisor): (BTreeMap<Packed, BigInt>, BTreeMap<Packed, BigInt>) =
        (packed(p), packed(d));
    let (highest, lead) = divisor.last_key_value()?;
    let mut quotient = Vec::new();
    while let Some((m, c)) = rest.pop_last() {
        let shift = shape.over(m, *highest)?;
        // a factor of higher degree than p leaves room for could not be packed
        shape.over(shape.room, shift)?;
        let (factor, remainder) = c.div_rem(lead);
        if !remainder.is_zero() {
            return None;
        }
        fuel.spend_beyond(TERM * divisor.len() as u64).ok()?;
        for (n, e) in divisor.iter().rev().skip(1) {
            let place = [shift[0] + n[0], shift[1] + n[1]];
            let entry = rest.entry(place).or_default();
            *entry -= &factor * e;
            if entry.is_zero() {
                rest.remove(&place);
            }
        }
        quotient.push((shape.unpacked(shift), factor));
    }
    Some(Poly::sum(quotient))
}

/// Exponents beside each other, each with a spare bit above it. Products are sums, and the order is the
/// lexicographic one.
type Packed = [u128; 2];

/// Where each exponent is.
struct Shape {
    vars: Vec<usize>,
    /// exponents in each of the two words
    each: usize,
    /// bits of an exponent with its spare bit
    width: u32,
    /// all spare bits
    spare: u128,
    /// the degrees of p beyond those of d
    room: Packed,
}

impl Shape {
    /// For all that occurs while p is divided by d; `None` if it does not fit.
    fn of(p: &Poly, d: &Poly) -> Option<Self> {
        let vars = p.vars();
        let each = vars.len().div_ceil(2).max(1);
        let width = 128 / u32::try_from(each).ok()?;
        let most = vars.iter().map(|v| p.degree(*v)).max().unwrap_or(0);
        if width < 2 || u32::BITS - most.leading_zeros() >= width {
            return None;
        }
        let spare = (1..=u32::try_from(each).ok()?).fold(0, |all, i| all | 1 << (i * width - 1));
        let mut shape = Self { vars, each, width, spare, room: [0; 2] };
        let room: Option<Monomial> = shape
            .vars
            .iter()
            .map(|v| Some((*v, p.degree(*v).checked_sub(d.degree(*v))?)))
            .collect();
        shape.room = shape.packed(&room?);
        Some(shape)
    }

    /// The word and the shift of the exponent of the variable with this index.
    fn place(&self, index: usize) -> (usize, u32) {
        let within = u32::try_from(index % self.each).unwrap_or(0);
        (index / self.each, within * self.width)
    }

    fn packed(&self, m: &[Power]) -> Packed {
        let mut packed = [0; 2];
        for (v, e) in m {
            if let Ok(index) = self.vars.binary_search(v) {
                let (word, shift) = self.place(index);
                packed[word] |= u128::from(*e) << shift;
            }
        }
        packed
    }

    fn unpacked(&self, packed: Packed) -> Monomial {
        let mask = (1 << (self.width - 1)) - 1;
        let power = |(index, v): (usize, &usize)| {
            let (word, shift) = self.place(index);
            let exponent = u32::try_from(packed[word] >> shift & mask).unwrap_or(u32::MAX);
            (exponent > 0).then_some((*v, exponent))
        };
        self.vars.iter().enumerate().filter_map(power).collect()
    }

    /// m/n, if n divides m.
    fn over(&self, m: Packed, n: Packed) -> Option<Packed> {
        let over = |m: u128, n: u128| {
            // a spare bit that goes was borrowed
            let difference = (m | self.spare) - n;
            (difference & self.spare == self.spare).then_some(difference & !self.spare)
        };
        Some([over(m[0], n[0])?, over(m[1], n[1])?])
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::ring::Ring;

    fn fuel() -> Fuel {
        Fuel::new(u64::MAX)
    }

    /// Polynomials in symbols of any number, not zero.
    fn poly(symbols: &'static [usize]) -> impl Strategy<Value = Poly> {
        let term = (prop::collection::vec(0u32..3, symbols.len()), -3i64..=3);
        let sum = |terms: Vec<(Vec<u32>, i64)>| {
            let monomial = |exponents: Vec<u32>| -> Monomial {
                symbols.iter().copied().zip(exponents).filter(|p| p.1 > 0).collect()
            };
            Poly::sum(terms.into_iter().map(|(exponents, c)| (monomial(exponents), c.into())))
        };
        let sums = prop::collection::vec(term, 1..5).prop_map(sum);
        sums.prop_filter("not zero", |p| !p.is_empty())
    }

    fn times(p: &Poly, q: &Poly) -> Poly {
        p.mul(q, &fuel()).expect("fuel without end")
    }

    /// Quotient and remainder by the library, up to factors.
    fn by_library(p: &Poly, d: &Poly) -> (Poly, Poly) {
        let ring = Ring::of(&[p, d]);
        let (q, r) = ring.outward(p).divide(&[ring.outward(d)]);
        (ring.inward(&q[0]).0, ring.inward(&r).0)
    }

    const SOME: &[usize] = &[2, 5, 7];
    const MANY: &[usize] = &[0, 1, 2, 3, 5, 8, 13, 21, 34, 55, 89];

    fn factors() -> impl Strategy<Value = (Poly, Poly)> {
        prop_oneof![(poly(SOME), poly(SOME)), (poly(MANY), poly(MANY)), (poly(SOME), poly(MANY))]
    }

    proptest! {
        #[test]
        fn the_quotient_by_a_planted_factor_is_what_was_left((p, d) in factors()) {
            let product = times(&p, &d);
            match exact_quotient(&product, &d, &fuel()) {
                // with the sign of the ratio
                Some(q) => prop_assert_eq!(q, p.primitive().1),
                // given up for length alone
                None => prop_assert!(d.len() > 8 * product.len()),
            }
        }

        /// Against the library's division in another order.
        #[test]
        fn there_is_a_quotient_where_the_library_has_no_remainder(
            p in poly(SOME), d in poly(SOME), r in poly(SOME),
        ) {
            let sum = times(&p, &d).add(&r);
            prop_assume!(!sum.is_empty());
            let (q, r) = by_library(&sum, &d);
            match exact_quotient(&sum, &d, &fuel()) {
                Some(found) => {
                    prop_assert!(r.is_empty());
                    prop_assert_eq!(found, q.primitive().1);
                }
                None => prop_assert!(!r.is_empty() || d.len() > 8 * sum.len()),
            }
        }

        #[test]
        fn what_no_budget_pays_for_is_not_found((p, d) in factors()) {
            prop_assume!(d.len() > 1);
            let none = Fuel::new(0).within(u64::MAX);
            prop_assert_eq!(exact_quotient(&times(&p, &d), &d, &none), None);
        }
    }

    #[test]
    fn great_degrees_fit_where_variables_are_few() {
        let x = |n| Poly::power(4, n);
        let one = Poly::one();
        let geometric = x(1).sub(&one);
        let quotient = exact_quotient(&x(2_000).sub(&one), &geometric, &fuel()).expect("a sum");
        assert_eq!(times(&quotient, &geometric), x(2_000).sub(&one));
        assert_eq!(exact_quotient(&x(2_000).add(&one), &geometric, &fuel()), None);
    }
}
