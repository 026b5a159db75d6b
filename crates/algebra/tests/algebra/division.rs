//! Division with remainder, against its definition and against the library's.

use kane_algebra::division::division;
use kane_algebra::ring::Ring;
use kane_kernel::{Fuel, Poly};
use num_traits::Signed as _;
use proptest::prelude::*;

/// Polynomials in up to three symbols, not zero.
fn poly() -> impl Strategy<Value = Poly> {
    let term = (prop::collection::vec(0_u32..4, 3), -6_i64..=6);
    let sum = |terms: Vec<(Vec<u32>, i64)>| {
        Poly::sum(terms.into_iter().map(|(exponents, c)| {
            let powers = [2, 5, 7].into_iter().zip(exponents).filter(|p| p.1 > 0);
            (powers.collect(), c.into())
        }))
    };
    let sums = prop::collection::vec(term, 1..6).prop_map(sum);
    sums.prop_filter("not zero", |p| !p.is_empty())
}

fn fuel() -> Fuel {
    Fuel::new(u64::MAX)
}

proptest! {
    #[test]
    fn division_with_remainder_adds_up_and_is_that_of_the_library(p in poly(), d in poly()) {
        let (q, r, c) = division(&p, &d, 10_000, &fuel()).expect("few steps");
        prop_assert!(c.is_positive());
        let product = q.mul(&d, &fuel()).expect("fuel without end");
        prop_assert_eq!(p.scale(&c), product.add(&r));
        let ring = Ring::of(&[&p, &d]);
        let (quotients, rest) = ring.outward(&p).divide(&[ring.outward(&d)]);
        prop_assert_eq!(q.primitive().1, ring.inward(&quotients[0]).0.primitive().1);
        prop_assert_eq!(r.primitive().1, ring.inward(&rest).0.primitive().1);
    }

    #[test]
    fn what_takes_more_steps_or_work_than_there_is_has_no_quotient(p in poly(), d in poly()) {
        let (q, ..) = division(&p, &d, 10_000, &fuel()).expect("few steps");
        prop_assume!(!q.is_empty());
        prop_assert!(division(&p, &d, q.len() - 1, &fuel()).is_none());
        prop_assert!(division(&p, &d, 10_000, &Fuel::new(0)).is_none());
    }
}

#[test]
fn nothing_is_divided_by_zero() {
    assert!(division(&Poly::var(0), &Poly::default(), 10, &fuel()).is_none());
}
