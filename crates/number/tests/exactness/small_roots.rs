//! The greatest root of every polynomial with small roots, between small ends: it is known which one it is.

use kane_number::testkit::Contract;
use kane_number::{Algebraic, DoubleDouble, Interval, Number, OddFraction, Rational, Real, Scaled};

use crate::rational;

/// The roots that a factor has.
#[derive(Clone)]
enum Factor {
    /// x − r
    At(Rational),
    /// x² − 2
    RootOfTwo,
    /// x² + 1
    None,
}

impl Factor {
    fn coefficients(&self) -> Vec<Rational> {
        let whole = |n: i64| rational(n, 1);
        match self {
            Self::At(r) => vec![-r, whole(1)],
            Self::RootOfTwo => vec![whole(-2), whole(0), whole(1)],
            Self::None => vec![whole(1), whole(0), whole(1)],
        }
    }

    fn roots(&self) -> Vec<Algebraic> {
        match self {
            Self::At(r) => vec![r.clone().into()],
            Self::RootOfTwo => {
                let root = Algebraic::from(rational(2, 1)).sqrt().expect("it is positive");
                vec![-root.clone(), root]
            }
            Self::None => Vec::new(),
        }
    }
}

fn product(f: &[Rational], g: &[Rational]) -> Vec<Rational> {
    let mut product = vec![rational(0, 1); f.len() + g.len() - 1];
    for (i, a) in f.iter().enumerate() {
        for (j, b) in g.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// A polynomial with its distinct roots, and whether one of them is a multiple one.
struct Known {
    coefficients: Vec<Rational>,
    roots: Vec<Algebraic>,
    multiple: bool,
}

impl Known {
    fn of(leading: i64, factors: &[Factor]) -> Self {
        let mut coefficients = vec![rational(leading, 4)];
        let mut roots = Vec::new();
        for factor in factors {
            coefficients = product(&coefficients, &factor.coefficients());
            roots.extend(factor.roots());
        }
        let count = roots.len();
        roots.sort();
        roots.dedup();
        let multiple = roots.len() < count;
        Self { coefficients, roots, multiple }
    }

    fn sign_at(&self, x: &Rational) -> i64 {
        let zero = rational(0, 1);
        let value = self.coefficients.iter().rev().fold(zero.clone(), |sum, c| sum * x + c);
        i64::from(value > zero) - i64::from(value < zero)
    }

    /// The greatest root between two ends, if it is promised that there is one.
    fn greatest(&self, lower: &Rational, upper: &Rational) -> Option<&Algebraic> {
        let promised = self.sign_at(lower) * self.sign_at(upper) <= 0;
        let (lower, upper) = (Algebraic::from(lower.clone()), Algebraic::from(upper.clone()));
        let inside = |root: &&Algebraic| lower <= **root && **root <= upper;
        let found = self.roots.iter().rfind(inside).filter(|_| promised);
        assert!(found.is_some() || !promised, "a promise is kept");
        found
    }
}

fn polynomials() -> Vec<Known> {
    let roots = [(-2, 1), (-1, 2), (0, 1), (1, 1), (3, 2)].map(|(n, d)| Factor::At(rational(n, d)));
    let mut factors: Vec<Vec<Factor>> = vec![vec![Factor::RootOfTwo]];
    for (i, a) in roots.iter().enumerate() {
        factors.push(vec![a.clone()]);
        factors.push(vec![Factor::RootOfTwo, a.clone()]);
        factors.push(vec![a.clone(), Factor::None]);
        for (j, b) in roots[i..].iter().enumerate() {
            factors.push(vec![a.clone(), b.clone()]);
            for c in &roots[i + j..] {
                factors.push(vec![a.clone(), b.clone(), c.clone()]);
            }
        }
    }
    factors.iter().flat_map(|f| [-3, 5].map(|leading| Known::of(leading, f))).collect()
}

const ENDS: [(i64, i64); 9] =
    [(-3, 1), (-2, 1), (-1, 1), (-1, 2), (0, 1), (1, 1), (5, 4), (3, 2), (2, 1)];

/// Puts every polynomial and every pair of ends to a system, and gives how many were asked.
fn ask<N: Contract>(multiple: bool, step: usize) -> usize {
    let mut asked = 0;
    for known in polynomials().iter().filter(|known| multiple || !known.multiple).step_by(step) {
        let mut f: Vec<N> = known.coefficients.iter().map(N::from_rational).collect();
        for (i, lower) in ENDS.iter().enumerate() {
            for upper in &ENDS[i..] {
                let [lower, upper] = [lower, upper].map(|(n, d)| rational(*n, *d));
                let Some(root) = known.greatest(&lower, &upper) else { continue };
                let ends = [&lower, &upper].map(|end| N::from_rational(end));
                let answer = N::greatest_root(&f, &ends[0], &ends[1]);
                let (coefficients, sought) = (&known.coefficients, format!("[{lower}, {upper}]"));
                assert!(
                    N::admits_root(answer.as_ref(), root),
                    "of {coefficients:?} in {sought} it is {root}, not {answer:?}"
                );
                asked += 1;
            }
        }
        // of a formal degree that is greater it is the same, and of four it is refused
        f.resize(4, N::zero());
        let ends = [-3, 2].map(|n| N::from_rational(&rational(n, 1)));
        let found = N::greatest_root(&f, &ends[0], &ends[1]);
        let promised = known.greatest(&rational(-3, 1), &rational(2, 1));
        let right = promised.is_none_or(|root| N::admits_root(found.as_ref(), root));
        assert!(right, "{:?}", known.coefficients);
        f.push(N::zero());
        assert_eq!(N::greatest_root(&f, &ends[0], &ends[1]), None, "five coefficients");
        assert_eq!(N::greatest_root(&f[..4], &ends[1], &ends[0]), None, "ends the wrong way");
    }
    asked
}

#[test]
fn fractions_find_each_root_that_is_one_of_them_and_refuse_the_others() {
    assert!(ask::<Rational>(true, 1) > 2_000);
    assert!(ask::<OddFraction>(true, 3) > 600);
}

#[test]
fn algebraic_numbers_find_each_root() {
    assert!(ask::<Algebraic>(true, 5) > 400);
}

/// c(x − p)(x − q), and with a third factor, of numbers of the field of √2: a conjugate's roots are elsewhere.
#[test]
fn algebraic_numbers_find_the_roots_of_polynomials_over_a_field() {
    let whole = |n: i64| Algebraic::from(rational(n, 1));
    let root = whole(2).sqrt().expect("it is positive");
    let numbers = [-root.clone(), rational(-1, 2).into(), whole(1), root.clone(), whole(1) + &root];
    let mut products: Vec<(Vec<Algebraic>, Vec<usize>)> = vec![(vec![-whole(1) - &root], vec![])];
    let mut asked = 0;
    for _ in 0..3 {
        let mut longer = Vec::new();
        for (f, roots) in &products {
            let first = roots.last().copied().unwrap_or(0);
            for (at, number) in numbers.iter().enumerate().skip(first) {
                // times x less this number
                let shifted = std::iter::once(whole(0)).chain(f.iter().cloned());
                let lowered = f.iter().map(|c| -c.clone() * number).chain([whole(0)]);
                let f: Vec<Algebraic> = shifted.zip(lowered).map(|(a, b)| a + b).collect();
                longer.push((f, [&roots[..], &[at]].concat()));
            }
        }
        products = longer;
        for (f, roots) in products.iter().step_by(products.len() / 12 + 1) {
            for (lower, upper) in [(-3, 3), (-3, 0), (-1, 2), (0, 2), (2, 3)] {
                let (lower, upper) = (whole(lower), whole(upper));
                let inside = |at: &&usize| lower < numbers[**at] && numbers[**at] < upper;
                // an odd number of roots is a change of sign
                if roots.iter().filter(inside).count() % 2 == 1 {
                    let greatest = roots.iter().rfind(inside).map(|at| numbers[*at].clone());
                    assert_eq!(Algebraic::greatest_root(f, &lower, &upper), greatest, "{f:?}");
                    asked += 1;
                }
            }
        }
    }
    assert!(asked > 50, "{asked}");
}

/// The coefficients are floats, and so are the values at a double root and next to it.
#[test]
fn floats_find_each_root_to_a_step() {
    assert!(ask::<f64>(true, 1) > 2_000);
    assert!(ask::<f32>(true, 1) > 2_000);
}

#[test]
fn wide_floats_find_each_root_to_their_precision() {
    assert!(ask::<DoubleDouble>(true, 3) > 600);
    assert!(ask::<Scaled>(true, 3) > 600);
}

#[test]
fn intervals_enclose_each_simple_root() {
    assert!(ask::<Interval>(false, 3) > 300);
}

/// Where the sign at either end is certain, what lies below the greatest root is kept off.
#[test]
fn enclosures_of_simple_roots_have_none_of_the_others() {
    let mut narrow = 0;
    for known in polynomials().iter().filter(|known| !known.multiple) {
        let f: Vec<Interval> = known.coefficients.iter().map(Interval::from_rational).collect();
        for (lower, upper) in
            [(-3, 2), (-3, 5), (-1, 2)].map(|(a, b)| (rational(a, 1), rational(b, 1)))
        {
            if known.sign_at(&lower) * known.sign_at(&upper) >= 0 {
                continue;
            }
            let ends = [&lower, &upper].map(Interval::from_rational);
            let root = Interval::greatest_root(&f, &ends[0], &ends[1]).expect("there is one");
            assert!(root.width() < 1e-12, "{:?} in [{lower}, {upper}]: {root}", known.coefficients);
            narrow += 1;
        }
    }
    assert!(narrow > 60, "{narrow}");
}
