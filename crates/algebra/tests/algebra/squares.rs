//! Sums of squares: known ones are found, and what is found is an identity.

use kane_algebra::squares::{Contact, Identity, Place, Question, identity, total_degree};
use kane_kernel::{Fuel, Poly};
use num_bigint::BigInt;
use num_traits::Signed;

/// A polynomial in x0, x1, … as coefficients and exponents.
fn poly(terms: &[(i64, &[u32])]) -> Poly {
    Poly::sum(terms.iter().map(|(c, powers)| {
        let monomial = powers.iter().enumerate().filter(|p| *p.1 > 0).map(|(v, n)| (v, *n));
        (monomial.collect(), BigInt::from(*c))
    }))
}

/// P + Σ squares · products + Σ cofactors · equations, which should be zero.
fn total(question: &Question<'_>, found: &Identity) -> Poly {
    let fuel = Fuel::new(u64::MAX);
    let mut sum = question.positive.scale(&found.scale);
    for s in &found.squares {
        assert!(s.weight.is_positive());
        let square = s.base.mul(&s.base, &fuel).expect("there is fuel");
        let product = square.mul(&question.products[s.product], &fuel).expect("there is fuel");
        sum = sum.add(&product.scale(&s.weight));
    }
    for (cofactor, equation) in found.cofactors.iter().zip(question.equations) {
        sum = sum.add(&cofactor.mul(equation, &fuel).expect("there is fuel"));
    }
    sum
}

/// Whether a polynomial is found to be a sum of squares.
fn is_found(p: &Poly) -> bool {
    let positive = p.neg();
    let products = [Poly::one()];
    let degree = total_degree(p).next_multiple_of(2);
    let question = Question {
        positive: &positive,
        products: &products,
        equations: &[],
        degree,
        contacts: &[],
    };
    match identity(&question, &Fuel::new(1 << 32)) {
        Some(found) => {
            assert!(total(&question, &found).is_empty(), "{found:?}");
            true
        }
        None => false,
    }
}

#[test]
fn squares_are_found_inside_the_cone_and_on_its_boundary() {
    // (x + 2y)²
    assert!(is_found(&poly(&[(1, &[2]), (4, &[1, 1]), (4, &[0, 2])])));
    // x⁴ − 2x² + 3
    assert!(is_found(&poly(&[(1, &[4]), (-2, &[2]), (3, &[])])));
    // (x² − 2)²
    assert!(is_found(&poly(&[(1, &[4]), (-4, &[2]), (4, &[])])));
    // x⁴ + y⁴ + z⁴ + w⁴ − 4xyzw
    let four =
        [(1, &[4][..]), (1, &[0, 4]), (1, &[0, 0, 4]), (1, &[0, 0, 0, 4]), (-4, &[1, 1, 1, 1])];
    assert!(is_found(&poly(&four)));
    // 2x⁴ + 2x³y − x²y² + 5y⁴ (Parrilo 2000)
    assert!(is_found(&poly(&[(2, &[4]), (2, &[3, 1]), (-1, &[2, 2]), (5, &[0, 4])])));
}

#[test]
fn squares_that_vanish_at_irrational_points_alone_are_found() {
    // (16 − s²)·(p − 1) = 4·(p − 2)² where p·(x − y)² = s², for s = x + y and p = xy: at s = 4, x and y are 2 ± √2
    let (x, y) = (Poly::var(0), Poly::var(1));
    let equation = poly(&[
        (1, &[3, 1]),
        (-2, &[2, 2]),
        (1, &[1, 3]),
        (-1, &[2]),
        (-2, &[1, 1]),
        (-1, &[0, 2]),
    ]);
    // (4 − s)·x·y > 0
    let positive = poly(&[(4, &[1, 1]), (-1, &[2, 1]), (-1, &[1, 2])]);
    let short = poly(&[(4, &[]), (-1, &[1]), (-1, &[0, 1])]);
    let times = |p: &Poly| short.mul(p, &Fuel::new(1000)).expect("it is short");
    let products = [Poly::one(), times(&x), times(&y), x, y];
    let question = Question {
        positive: &positive,
        products: &products,
        equations: &[equation],
        degree: 6,
        contacts: &[],
    };
    let found = identity(&question, &Fuel::new(1 << 30)).expect("s ≥ 4");
    assert!(total(&question, &found).is_empty());
    // s ≥ 4.01 does not follow
    let positive = positive.scale(&100.into()).add(&poly(&[(1, &[1, 1])]));
    let question = Question { positive: &positive, ..question };
    assert_eq!(identity(&question, &Fuel::new(1 << 30)), None);
}

#[test]
fn what_is_no_sum_of_squares_has_no_identity() {
    // Motzkin's: not negative, and no sum of squares.
    assert!(!is_found(&poly(&[(1, &[4, 2]), (1, &[2, 4]), (-3, &[2, 2]), (1, &[])])));
    assert!(!is_found(&poly(&[(1, &[2]), (3, &[1, 1]), (1, &[0, 2])])));
    assert!(!is_found(&poly(&[(-1, &[])])));
}

#[test]
fn products_and_equations_serve() {
    // x ≥ 0, y ≥ 0, −x − y > 0
    let (x, y) = (Poly::var(0), Poly::var(1));
    let positive = x.add(&y).neg();
    let products = [Poly::one(), x.clone(), y.clone()];
    let question = Question {
        positive: &positive,
        products: &products,
        equations: &[],
        degree: 2,
        contacts: &[],
    };
    let found = identity(&question, &Fuel::new(1 << 30)).expect("it is linear");
    assert!(total(&question, &found).is_empty());
    // x + y = 2, xy − 2 > 0
    let positive = poly(&[(1, &[1, 1]), (-2, &[])]);
    let equations = [poly(&[(1, &[1]), (1, &[0, 1]), (-2, &[])])];
    let question = Question {
        positive: &positive,
        products: &products[..1],
        equations: &equations,
        degree: 2,
        contacts: &[],
    };
    let found = identity(&question, &Fuel::new(1 << 30)).expect("(x − 1)² = −(y − 1)²");
    assert!(total(&question, &found).is_empty());
}

/// At a point and in a direction where nothing is left each square is zero, whether that is said before or found.
#[test]
fn what_is_known_to_vanish_does_so_in_the_identity() {
    // (x − 1)²·y² + (x + y − 1)⁴ is 0 at (1, 0) alone, and in no direction
    let fuel = Fuel::new(1 << 30);
    let (x, y) = (Poly::var(0), Poly::var(1));
    let left = x.sub(&Poly::one());
    let square = left.mul(&y, &fuel).and_then(|p| p.pow(2, &fuel)).expect("there is fuel");
    let fourth = left.add(&y).pow(4, &fuel).expect("there is fuel");
    let positive = square.add(&fourth).neg();
    let at = |x: i64, y: i64| vec![(0, BigInt::from(x).into()), (1, BigInt::from(y).into())];
    let products = [Poly::one()];
    let bare = Question {
        positive: &positive,
        products: &products,
        equations: &[],
        degree: 4,
        contacts: &[],
    };
    let point = Contact::At(Place::rational(at(1, 0)));
    assert!(point.is_of(&bare));
    assert!(
        !Contact::At(Place::rational(at(0, 1))).is_of(&bare)
            && !Contact::Towards(Place::rational(at(1, -1))).is_of(&bare)
    );
    let found = identity(&Question { contacts: &[point], ..bare.clone() }, &fuel).expect("a sum");
    assert!(total(&bare, &found).is_empty());
    let here = |p: &Poly| kane_algebra::point::specialised(p, &at(1, 0));
    assert!(found.squares.iter().all(|s| here(&s.base).is_empty()));
    // x⁴ has no room along y
    let leading = x.pow(4, &fuel).expect("there is fuel").neg();
    let towards = Question { positive: &leading, ..bare };
    assert!(Contact::Towards(Place::rational(at(0, 1))).is_of(&towards));
    assert!(!Contact::Towards(Place::rational(at(1, 1))).is_of(&towards));
}

#[test]
fn places_with_a_root_are_those_where_a_claim_touches_and_does_not_cross() {
    // −(x² − 2·y²)² along (√2, 1), and x² − 2·y², which changes its sign there
    let fuel = Fuel::new(1 << 30);
    let (x, y) = (Poly::var(0), Poly::var(1));
    let square = |p: &Poly| p.pow(2, &fuel).expect("there is fuel");
    let cone = square(&x).sub(&square(&y).scale(&2.into()));
    let whole = |n: i64| BigInt::from(n).into();
    let values = |a: i64| vec![(0, [whole(0), whole(a)]), (1, [whole(1), whole(0)])];
    let at = |a: i64| Contact::At(Place { radicand: whole(2), values: values(a) });
    let question = |positive: &Poly, products: &[Poly]| -> [bool; 3] {
        let asked = Question { positive, products, equations: &[], degree: 4, contacts: &[] };
        [at(1).is_of(&asked), at(1).is_flat(&asked, &fuel), at(2).is_of(&asked)]
    };
    let fourth = square(&cone).neg();
    assert_eq!(question(&fourth, &[Poly::one()]), [true, true, false]);
    assert_eq!(question(&cone, &[Poly::one()]), [true, false, false]);
    // what else is zero there, and rises along the same slope, does not keep it from crossing; what rises along another may
    assert_eq!(question(&cone, &[Poly::one(), cone.clone()]), [true, false, false]);
    let beside = square(&x).scale(&2.into()).sub(&square(&y).scale(&4.into())).add(&square(&cone));
    assert_eq!(question(&cone, &[Poly::one(), beside]), [true, false, false]);
    let line = y.sub(&Poly::one());
    assert_eq!(question(&cone, &[Poly::one(), line]), [true, true, false]);
    assert!(at(1).is_irrational());
    let products = [Poly::one()];
    let contacts = [at(1)];
    let asked = Question {
        positive: &fourth,
        products: &products,
        equations: &[],
        degree: 4,
        contacts: &contacts,
    };
    let found = identity(&asked, &fuel).expect("a square");
    assert!(total(&asked, &found).is_empty());
    assert_eq!(found.squares.len(), 1, "of x² − 2·y² alone");
}
