//! Polynomials and fractions against their values at rational points.

use std::hash::{DefaultHasher, Hash, Hasher};

use kane_kernel::{Fraction, Fuel, Poly, Rejection, descartes, exponent, sign, sign_at};
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

use crate::oracle::value;
use crate::support::{Q, n, plenty, q, times, x, y};

/// Some points of the plane.
fn points() -> Vec<[Q; 2]> {
    let some = [q(-2, 1), q(-1, 3), q(0, 1), q(1, 2), q(1, 1), q(5, 3), q(7, 1)];
    some.iter().flat_map(|a| some.iter().map(|b| [a.clone(), b.clone()])).collect()
}

fn at<'a>(point: &'a [Q; 2]) -> impl Fn(usize) -> Q + 'a {
    |v| point[v].clone()
}

/// Some polynomials in x and y.
fn polynomials() -> Vec<Poly> {
    let (x2, y3, xy) = (Poly::power(0, 2), Poly::power(1, 3), times(&x(), &y()));
    vec![
        n(0),
        n(1),
        n(-6),
        x(),
        y().scale(&(-3).into()),
        x2.scale(&2.into()).sub(&xy),
        x2.add(&xy).sub(&n(4)),
        y3.scale(&2.into()).sub(&x()).add(&n(6)),
        times(&x2, &y3).sub(&xy.scale(&9.into())).add(&x2.scale(&3.into())),
    ]
}

#[test]
fn sums_and_products_have_the_values_of_their_parts() {
    for a in polynomials() {
        for b in polynomials() {
            let product = times(&a, &b);
            for p in points() {
                let (va, vb) = (value(&a, &at(&p)), value(&b, &at(&p)));
                assert_eq!(value(&a.add(&b), &at(&p)), &va + &vb);
                assert_eq!(value(&a.sub(&b), &at(&p)), &va - &vb);
                assert_eq!(value(&product, &at(&p)), &va * &vb);
                assert_eq!(value(&a.neg(), &at(&p)), -&va);
                assert_eq!(value(&a.scale(&(-5).into()), &at(&p)), q(-5, 1) * &va);
            }
        }
        assert!(a.sub(&a).is_empty() && a.scale(&0.into()).is_empty());
        assert_eq!(a.sub(&a).len(), 0);
    }
}

#[test]
fn polynomials_that_are_equal_have_one_hash_and_one_place_in_the_order() {
    let hash = |p: &Poly| {
        let mut hasher = DefaultHasher::new();
        p.hash(&mut hasher);
        hasher.finish()
    };
    // Built in another way: equal only by what they are.
    let again = |p: &Poly| p.add(&x()).sub(&x());
    let all = polynomials();
    for (i, a) in all.iter().enumerate() {
        for (j, b) in all.iter().map(again).enumerate() {
            assert_eq!(hash(a) == hash(&b), i == j, "{a:?} and {b:?}");
            assert_eq!(a.partial_cmp(&b), Some(a.cmp(&b)));
            assert_eq!(a.cmp(&b).is_eq(), i == j, "{a:?} and {b:?}");
            assert_eq!(a.cmp(&b), b.cmp(a).reverse());
        }
    }
}

/// The product of this many symbols, from this one on.
fn long(first: usize, count: usize) -> Poly {
    Poly::term((first..first + count).map(|v| (v, 1)).collect(), BigInt::one())
}

#[test]
fn a_product_of_more_than_eight_million_terms_and_powers_is_refused_whatever_is_left() {
    let fuel = Fuel::new(u64::MAX);
    // One term and its powers each: 2,000 · 4,000 is the most, and one power more is too many.
    let product = long(0, 1_999).mul(&long(1_999, 3_999), &fuel);
    assert_eq!(product, Ok(long(0, 5_998)));
    assert_eq!(long(0, 1_999).mul(&long(1_999, 4_000), &fuel), Err(Rejection::Budget));
    assert_eq!(long(0, 2_999).mul(&long(2_999, 2_999), &fuel), Err(Rejection::Budget));
}

#[test]
fn the_length_of_terms_is_charged_to_the_whole_and_not_to_a_part() {
    let whole = Fuel::new(1_000_000);
    let part = whole.within(10);
    long(0, 1_999).mul(&long(1_999, 3_999), &part).expect("one pair of terms");
    assert_eq!(part.left(), 9, "a step for the pair");
    assert_eq!(1_000_000 - whole.left(), 1 + 5_998 / 8, "and an eighth of one for each power");
    let (whole, z) = (Fuel::new(1_000), Poly::var(2));
    let p = times(&x(), &y()).add(&z);
    let q = Poly::var(3).add(&Poly::var(4)).add(&long(5, 3));
    p.mul(&q, &whole.within(10)).expect("six pairs of terms");
    // of 3 and 5 powers, each three or two times, for each time that six is halved and once more
    assert_eq!(1_000 - whole.left(), 6 + (3 * 3 + 5 * 2) * 3 / 8);
}

#[test]
fn a_power_pays_for_no_square_that_it_does_not_need() {
    let p = (0..100).fold(Poly::default(), |sum, v| sum.add(&Poly::var(v)));
    assert_eq!(p.pow(1, &Fuel::new(100)), Ok(p.clone()), "100 products with 1");
    assert_eq!(p.pow(1, &Fuel::new(99)), Err(Rejection::Budget));
}

#[test]
fn descartes_pays_for_the_length_of_the_numbers_that_it_makes() {
    // Eight numbers of 1,000 bits, each shifted by ends of 2 + 11 and 3 + 2 bits, and doubled, in
    // each of eight steps: at most 1,000 + 8·(18 + 1) bits are 18 words and a part.
    let p: Vec<BigInt> = (0..8).map(|_| BigInt::one() << 999_u32).collect();
    let (lo, hi) = (q(3, 1024), q(5, 2));
    assert_eq!(descartes(&p, &lo, &hi, &Fuel::new(8 * 8 * 19)), Ok(0));
    assert_eq!(descartes(&p, &lo, &hi, &Fuel::new(8 * 8 * 19 - 1)), Err(Rejection::Budget));
}

#[test]
fn a_power_is_a_repeated_product() {
    for a in polynomials() {
        let mut product = n(1);
        for exponent in 0..12 {
            assert_eq!(a.pow(exponent, &plenty()), Ok(product.clone()), "{a:?}^{exponent}");
            product = times(&product, &a);
        }
    }
    assert_eq!(Poly::power(0, 0), n(1));
    assert_eq!(Poly::power(1, 3), times(&y(), &times(&y(), &y())));
    assert_eq!(n(0).pow(0, &plenty()), Ok(n(1)));
}

#[test]
fn equal_polynomials_are_the_same_value() {
    let (a, b) = (vec![(0, 1), (1, 2)], vec![(1, 2), (0, 1)]);
    let term = |m: &[(usize, u32)]| Poly::term(m.to_vec(), BigInt::from(3));
    assert_eq!(term(&a), term(&b), "in any order");
    assert_eq!(term(&[(1, 1), (0, 1), (1, 1)]), term(&a), "repeated");
    assert_eq!(term(&[(0, 1), (5, 0), (1, 2)]), term(&a), "a power 0");
    assert_eq!(term(&[(4, 0)]).as_constant(), Some(3.into()));
    assert!(Poly::term(a, BigInt::zero()).is_empty());
    let mut sum = term(&b);
    sum = sum.add(&Poly::term(vec![(1, 1), (0, 1), (1, 1)], BigInt::from(-3)));
    assert!(sum.is_empty() && sum == Poly::default());
    assert_eq!(n(0).as_constant(), Some(BigInt::zero()));
    assert_eq!(n(7).as_constant(), Some(7.into()));
    assert_eq!(x().as_constant(), None);
    assert_eq!(x().add(&n(7)).as_constant(), None);
}

#[test]
fn a_sum_does_not_depend_on_the_order_of_its_terms() {
    let terms = |p: &Poly| -> Vec<(Vec<(usize, u32)>, BigInt)> {
        p.terms().map(|(m, c)| (m.to_vec(), c.clone())).collect()
    };
    for a in polynomials() {
        for b in polynomials() {
            // each term of a twice, those of b once and taken away once
            let mut all = [terms(&a), terms(&b), terms(&a), terms(&b.neg())].concat();
            let wanted = a.scale(&2.into());
            assert_eq!(Poly::sum(all.clone()), wanted);
            all.reverse();
            assert_eq!(Poly::sum(all), wanted);
        }
        assert!(terms(&a).is_sorted() && a.terms().all(|(_, c)| !c.is_zero()));
        assert_eq!(a.is_constant(), a.as_constant().is_some());
    }
}

#[test]
fn degrees_and_variables_are_those_that_occur() {
    let p = Poly::power(0, 2).add(&times(&x(), &Poly::power(1, 3)));
    assert_eq!((p.degree(0), p.degree(1), p.degree(2)), (2, 3, 0));
    assert_eq!(p.vars(), vec![0, 1]);
    assert_eq!(times(&y(), &p).vars(), vec![0, 1]);
    assert_eq!(exponent(&[(0, 2), (3, 1)], 3), 1);
    assert_eq!(exponent(&[(0, 2), (3, 1)], 1), 0);
    assert_eq!(n(-5).add(&x()).bits(), 3);
    assert_eq!(n(0).degree(0), 0);
}

#[test]
fn coefficients_make_up_the_polynomial_again() {
    for p in polynomials() {
        for v in [0, 1] {
            let parts = p.coefficients(v);
            let sum = parts.iter().zip(0..).map(|(c, i)| times(c, &Poly::power(v, i)));
            assert_eq!(sum.fold(n(0), |sum, part| sum.add(&part)), p);
            assert!(parts.iter().all(|c| c.degree(v) == 0));
            assert_eq!(u32::try_from(parts.len()), Ok(p.degree(v) + 1));
            for (c, i) in parts.iter().zip(0..) {
                assert_eq!(p.coefficient(v, i), *c);
            }
        }
        assert!(p.coefficient(0, 9).is_empty());
    }
    let some = [BigInt::from(4), 0.into(), (-3).into()];
    assert_eq!(Poly::in_variable(1, &some).univariate(1), Some(some.to_vec()));
    assert_eq!(x().add(&y()).univariate(1), None);
    assert_eq!(n(3).univariate(1), Some(vec![3.into()]));
}

#[test]
fn a_derivative_is_what_a_small_step_adds() {
    // p(v + h) = p(v) + h·p′(v) + h²·(…): the coefficient of h.
    let h = Poly::var(2);
    for p in polynomials() {
        for v in [0, 1] {
            let step = Poly::var(v).add(&h);
            let powers = (0..=p.degree(v))
                .map(|k| times(&p.coefficient(v, k), &step.pow(k, &plenty()).expect("small")));
            let moved = powers.fold(n(0), |sum, power| sum.add(&power));
            assert_eq!(p.derivative(v, &plenty()), Ok(moved.coefficient(2, 1)), "{p:?} by {v}");
        }
        assert!(p.derivative(3, &plenty()).expect("small").is_empty());
    }
}

#[test]
fn a_remainder_keeps_values_where_the_equation_holds() {
    // (y − 3)·x² = 4·(y − 3) has x = 2, and (y − 3)·x = y + 1 has x = (y + 1)/(y − 3).
    let lead = y().sub(&n(3));
    let square = times(&lead, &Poly::power(0, 2).sub(&n(4)));
    let line = times(&lead, &x()).sub(&y()).sub(&n(1));
    for (equation, root) in [
        (&square, &(|_: &Q| q(2, 1)) as &dyn Fn(&Q) -> Q),
        (&line, &|y: &Q| (y + Q::one()) / (y - q(3, 1))),
    ] {
        for p in polynomials() {
            for even in [true, false] {
                let rest = p.remainder(0, equation, even, &plenty()).expect("small");
                assert!(rest.degree(0) < equation.degree(0));
                for point in points() {
                    let there = [root(&point[1]), point[1].clone()];
                    let (had, has) = (value(&p, &at(&there)), value(&rest, &at(&there)));
                    assert_eq!(had.is_zero(), has.is_zero(), "{p:?} at {there:?}");
                    assert!(!even || had.is_positive() == has.is_positive(), "{p:?} at {there:?}");
                }
            }
        }
    }
    let p = x().add(&y());
    assert_eq!(p.remainder(0, &n(5), true, &plenty()), Ok(p));
}

#[test]
fn the_content_is_positive_and_divides() {
    let p = x().scale(&(-6).into()).add(&n(-4));
    assert_eq!(p.primitive(), (2.into(), x().scale(&(-3).into()).add(&n(-2))));
    assert_eq!(x().primitive(), (1.into(), x()));
    assert_eq!(n(0).primitive(), (1.into(), n(0)));
    assert_eq!(n(-4).primitive(), (4.into(), n(-1)));
}

#[test]
fn a_power_of_two_terms_pays_for_each_coefficient_and_for_its_powers() {
    // coefficients of at most 3·300 bits and two powers: 300·8·(14 + 1 + 2), and what the powers of the two terms take
    let p = x().scale(&2.into()).sub(&y());
    assert_eq!(p.pow(300, &Fuel::new(40_799)), Err(Rejection::Budget));
    let power = p.pow(300, &Fuel::new(80_000)).expect("as much as it takes");
    assert_eq!(
        times(&p.pow(100, &plenty()).expect("plenty"), &p.pow(200, &plenty()).expect("plenty")),
        power
    );
    // 15,968·(499 + 1 + 1) words and powers are held; one power more is too many, whatever is left
    let sum = x().add(&n(1));
    assert!(sum.pow(15_968, &Fuel::new(u64::MAX)).is_ok());
    assert_eq!(sum.pow(15_969, &Fuel::new(u64::MAX)), Err(Rejection::Budget));
}

#[test]
fn powers_beyond_their_range_are_refused() {
    let top = Poly::power(0, u32::MAX);
    for beyond in
        [top.add(&n(1)), Poly::power(0, 1 << 31).add(&x()), Poly::power(0, 1 << 29).add(&n(-3))]
    {
        assert_eq!(beyond.pow(8, &plenty()), Err(Rejection::Budget));
    }
    assert_eq!(top.mul(&x(), &plenty()), Err(Rejection::Budget));
    assert!(top.mul(&y(), &plenty()).is_ok());
}

#[test]
fn huge_powers_take_no_room() {
    let p = Poly::power(0, u32::MAX).add(&x());
    assert_eq!(p.coefficient(0, 1), n(1));
    let slope = p.derivative(0, &plenty()).expect("two terms");
    assert_eq!(slope, Poly::power(0, u32::MAX - 1).scale(&u32::MAX.into()).add(&n(1)));
    let rule = x().sub(&y());
    assert_eq!(p.remainder(0, &rule, true, &Fuel::new(1000)), Err(Rejection::Budget));
}

/// The value of a fraction, where it has one.
fn ratio(f: &Fraction, point: &[Q; 2]) -> Option<Q> {
    let den = value(&f.den, &at(point));
    (!den.is_zero()).then(|| value(&f.num, &at(point)) / den)
}

#[test]
fn fractions_have_the_values_of_their_parts() {
    let some: Vec<Fraction> = vec![
        Fraction::whole(x().sub(&n(1))),
        Fraction::rational(&q(-3, 4)),
        Fraction { num: y(), den: x() },
        Fraction { num: x().add(&y()), den: y().sub(&n(2)) },
        Fraction { num: n(3), den: x() },
        Fraction { num: x(), den: n(-2) },
    ];
    let fuel = plenty();
    for a in &some {
        for b in &some {
            let sum = a.add(b, &fuel).expect("small");
            let product = a.mul(b, &fuel).expect("small");
            let over = a.over(b, &fuel).expect("small");
            for p in points() {
                let Some((va, vb)) = ratio(a, &p).zip(ratio(b, &p)) else {
                    continue;
                };
                assert_eq!(ratio(&sum, &p), Some(&va + &vb));
                assert_eq!(ratio(&product, &p), Some(&va * &vb));
                if !vb.is_zero() {
                    assert_eq!(ratio(&over, &p), Some(&va / &vb));
                }
            }
        }
        for p in points() {
            let Some(v) = ratio(a, &p) else {
                continue;
            };
            assert_eq!(ratio(&a.neg(), &p), Some(-&v));
            assert_eq!(ratio(&a.pow(3, &fuel).expect("small"), &p), Some(&v * &v * &v));
            let signed = value(&a.sign_poly(&fuel).expect("small"), &at(&p));
            assert_eq!(signed.is_positive(), v.is_positive());
            assert_eq!(signed.is_negative(), v.is_negative());
        }
    }
}

/// Π (bᵢx − aᵢ) for roots aᵢ/bᵢ, times c.
fn with_roots(c: i64, roots: &[Q]) -> Vec<BigInt> {
    let factor = |r: &Q| Poly::in_variable(0, &[-r.numer(), r.denom().clone()]);
    let product = roots.iter().map(factor).fold(n(c), |p, f| times(&p, &f));
    product.univariate(0).expect("in x alone")
}

#[test]
fn the_sign_of_a_value_is_exact() {
    let roots = [q(-7, 2), q(1, 3), q(2, 1)];
    for c in [2, -1] {
        let p = with_roots(c, &roots);
        for i in -30..30 {
            let x = q(i, 6);
            let product: Q = roots.iter().map(|r| &x - r).product::<Q>() * q(c, 1);
            let wanted = i8::from(product.is_positive()) - i8::from(product.is_negative());
            assert_eq!(sign_at(&p, &x), wanted, "{x}");
        }
    }
    assert_eq!(sign_at(&[], &q(1, 2)), 0);
    assert_eq!([-3, 0, 8].map(|c: i32| sign(&c.into())), [-1, 0, 1]);
}

#[test]
fn descartes_counts_the_roots_of_what_has_only_real_ones() {
    let fuel = plenty();
    let ends: Vec<Q> = [-9, -7, -4, -1, 0, 1, 2, 3, 5, 8].iter().map(|i| q(*i, 2)).collect();
    for roots in [
        vec![q(-7, 2), q(0, 1), q(1, 1), q(1, 1), q(4, 3)],
        vec![q(1, 3), q(2, 1)],
        vec![q(-1, 5)],
        vec![],
    ] {
        for c in [1, -3] {
            let p = with_roots(c, &roots);
            let count = |inside: &dyn Fn(&Q) -> bool| roots.iter().filter(|r| inside(r)).count();
            for a in &ends {
                for b in &ends {
                    let between = count(&|r| r > a && r < b);
                    assert_eq!(descartes(&p, a, b, &fuel), Ok(between), "{a} … {b}");
                }
            }
        }
    }
    let p = with_roots(1, &[q(1, 3), q(2, 1)]);
    assert_eq!(descartes(&p, &q(0, 1), &q(1, 1), &Fuel::new(8)), Err(Rejection::Budget));
}
