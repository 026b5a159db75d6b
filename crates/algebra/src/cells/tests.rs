use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use proptest::prelude::*;

use super::*;

type Q = BigRational;

fn fuel() -> Fuel {
    Fuel::new(1 << 28)
}

fn poly(terms: &[(i64, &[u32])]) -> Poly {
    Poly::sum(terms.iter().map(|(c, powers)| {
        let m = powers.iter().copied().enumerate().filter(|(_, n)| *n > 0).collect();
        (m, BigInt::from(*c))
    }))
}

fn said(atoms: &[Atom], vars: &[usize]) -> Cells {
    cells(atoms, vars, &mut 10_000, &fuel())
}

/// The value of a polynomial at rational values, term by term.
fn value(p: &Poly, at: &[Q]) -> Q {
    let power = |v: usize, n: u32| (0..n).fold(Q::one(), |product, _| product * &at[v]);
    let term = |(m, c): (&[(usize, u32)], &BigInt)| {
        m.iter().fold(Q::from_integer(c.clone()), |product, (v, n)| product * power(*v, *n))
    };
    p.terms().map(term).fold(Q::zero(), |a, b| a + b)
}

fn admits(a: &Atom, at: &[Q]) -> bool {
    a.sign.admits(kane_kernel::sign(value(&a.poly, at).numer()))
}

fn circle() -> Poly {
    poly(&[(1, &[2]), (1, &[0, 2]), (-1, &[])])
}

#[test]
fn the_resultant_of_a_circle_and_a_line_has_their_common_abscissas() {
    // x² + y² = 1 and y = x: 2x² = 1
    let line = poly(&[(1, &[0, 1]), (-1, &[1])]);
    assert_eq!(resultant(&circle(), &line, 1, &fuel()), Some(poly(&[(2, &[2]), (-1, &[])])));
    assert_eq!(resultant(&circle(), &poly(&[(1, &[1])]), 1, &fuel()), None);
}

#[test]
fn the_discriminant_of_a_quadratic_polynomial_is_the_one_of_schools() {
    // a·x² + b·x + c in x, with a = variable 1, b = 2, c = 3: a·(b² − 4ac) up to its sign
    let p = poly(&[(1, &[2, 1]), (1, &[1, 0, 1]), (1, &[0, 0, 0, 1])]);
    let known = poly(&[(1, &[0, 1, 2]), (-4, &[0, 2, 0, 1])]);
    let found = discriminant(&p, 0, &fuel()).unwrap();
    assert!(found == known || found == known.neg());
}

#[test]
fn a_point_with_two_irrational_coordinates_is_found() {
    // (x² − 2)² + (y² − 3)² = 0: only (±√2, ±√3)
    let (f, g) = (poly(&[(1, &[2]), (-2, &[])]), poly(&[(1, &[0, 2]), (-3, &[])]));
    let sum = f.pow(2, &fuel()).unwrap().add(&g.pow(2, &fuel()).unwrap());
    let Cells::Point(point) = said(&[Atom::new(sum, Sign::Zero)], &[0, 1]) else {
        panic!("there are four points");
    };
    for (p, sign) in [(&f, 0), (&g, 0), (&poly(&[(1, &[1, 1]), (-6, &[])]), -1)] {
        assert_eq!(point.sign(p, &fuel()), Some(sign));
    }
    assert_eq!(point.generator.map(|g| g.poly.len()), Some(5));
}

#[test]
fn three_irrational_coordinates_share_one_number() {
    // x² = 2, y² = x, z = x·y with x, y > 0
    let atoms = [
        Atom::new(poly(&[(1, &[2]), (-2, &[])]), Sign::Zero),
        Atom::new(poly(&[(1, &[0, 2]), (-1, &[1])]), Sign::Zero),
        Atom::new(poly(&[(1, &[0, 0, 2]), (-1, &[2, 2])]), Sign::Zero),
        Atom::new(poly(&[(1, &[1])]), Sign::Positive),
        Atom::new(poly(&[(1, &[0, 1])]), Sign::Positive),
        Atom::new(poly(&[(1, &[0, 0, 1])]), Sign::Positive),
    ];
    let Cells::Point(point) = said(&atoms, &[0, 1, 2]) else { panic!("there is one point") };
    // z⁴ = 8
    assert_eq!(point.sign(&poly(&[(1, &[0, 0, 4]), (-8, &[])]), &fuel()), Some(0));
    assert_eq!(point.sign(&poly(&[(1, &[0, 0, 3]), (-4, &[])]), &fuel()), Some(1));
}

#[test]
fn a_disk_and_a_half_plane_that_do_not_meet_leave_no_point() {
    let inside = Atom::new(circle().neg(), Sign::NonNegative);
    let beyond = |n: i64, d: i64| poly(&[(d, &[1]), (d, &[0, 1]), (-n, &[])]);
    let empty = said(&[inside.clone(), Atom::new(beyond(3, 2), Sign::Positive)], &[0, 1]);
    assert!(matches!(empty, Cells::Empty));
    // 7/5 < √2: a sliver
    let sliver = said(&[inside, Atom::new(beyond(7, 5), Sign::Positive)], &[0, 1]);
    assert!(matches!(sliver, Cells::Point(_)));
}

#[test]
fn steps_bound_the_work() {
    let atoms = [Atom::new(circle().neg(), Sign::Positive)];
    assert!(matches!(cells(&atoms, &[0, 1], &mut 0, &fuel()), Cells::Open));
    assert!(matches!(cells(&atoms, &[0, 1], &mut 100, &Fuel::new(1)), Cells::Open));
}

fn condition() -> impl Strategy<Value = Atom> {
    let term = (-3i64..=3, 0u32..=2, 0u32..=2);
    let signs = prop::sample::select(vec![
        Sign::Zero,
        Sign::Positive,
        Sign::Positive,
        Sign::NonNegative,
        Sign::NonZero,
    ]);
    (prop::collection::vec(term, 1..4), signs).prop_map(|(terms, sign)| {
        let terms = terms.iter().map(|(c, i, j)| poly(&[(*c, &[*i, *j])]));
        Atom::new(terms.fold(Poly::default(), |a, b| a.add(&b)), sign)
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    /// Points on a grid know nothing of projections.
    #[test]
    fn no_point_of_a_grid_satisfies_what_the_cells_call_empty(
        atoms in prop::collection::vec(condition(), 1..4),
    ) {
        match said(&atoms, &[0, 1]) {
            Cells::Empty => {
                for x in -12i64..=12 {
                    for y in -12i64..=12 {
                        let at = [Q::new(x.into(), 4.into()), Q::new(y.into(), 4.into())];
                        prop_assert!(!atoms.iter().all(|a| admits(a, &at)), "{at:?}");
                    }
                }
            }
            Cells::Point(point) => {
                for a in &atoms {
                    let sign = point.sign(&a.poly, &fuel());
                    prop_assert!(sign.is_some_and(|s| a.sign.admits(s)));
                }
                if point.generator.is_none() {
                    let at = |v: usize| point.values.get(&v).and_then(|u| u.0.first().cloned());
                    let at = [at(0).unwrap_or_default(), at(1).unwrap_or_default()];
                    prop_assert!(atoms.iter().all(|a| admits(a, &at)));
                }
            }
            Cells::Open => {}
        }
    }

    #[test]
    fn a_resultant_is_the_one_of_the_values(
        p in condition(), q in condition(), x in -5i64..=5,
    ) {
        let (p, q) = (p.poly, q.poly);
        if let Some(found) = resultant(&p, &q, 1, &fuel()) {
            let here = [(0, Q::from_integer(x.into()))];
            let at = |p: &Poly| crate::point::specialised(p, &here);
            let (p1, q1) = (at(&p), at(&q));
            prop_assume!(p1.degree(1) == p.degree(1) && q1.degree(1) == q.degree(1));
            let vanishes = at(&found).is_empty();
            let coprime = crate::ring::gcd(&p1, &q1).degree(1) == 0;
            prop_assert_eq!(vanishes, !coprime);
        }
    }
}
