//! Enclosures of roots are no wider than they need be where all is exact, and hold for every choice of what is not.

use kane_number::{Interval, Number, Rational, Real};

use crate::rational;

fn points(f: &[f64]) -> Vec<Interval> {
    f.iter().copied().map(Interval::from).collect()
}

fn between(f: &[f64], lower: f64, upper: f64) -> Option<Interval> {
    Interval::greatest_root(&points(f), &Interval::from(lower), &Interval::from(upper))
}

fn float(x: &Rational) -> f64 {
    let x = Interval::from_rational(x);
    assert!(x.is_point());
    x.lower()
}

#[test]
fn the_root_of_degree_one_is_the_tightest_enclosure_of_the_quotient() {
    for c0 in -9..=9 {
        for c1 in [-7, -1, 3, 8, 10] {
            let root = rational(-c0, c1);
            let f = [f64::from(c0), f64::from(c1)];
            let expected = Some(Interval::from_rational(&root));
            assert_eq!(between(&f, -10.0, 10.0), expected);
            assert_eq!(between(&[f[0], f[1], 0.0, 0.0], -10.0, 10.0), expected, "a formal cubic");
            assert_eq!(between(&f, 9.5, 10.0), None, "{root} lies below");
            assert_eq!(between(&f, -10.0, -9.5), None, "{root} lies above");
        }
    }
}

/// c(x − p)(x − q) over quarters: all that is computed is exact, so the root is a point, at the ends too.
#[test]
fn the_roots_of_exact_quadratics_are_points() {
    let quarters = || (-5..=5).map(|n| rational(n, 4));
    let mut found = 0;
    for p in quarters() {
        for q in quarters().filter(|q| p < *q) {
            for c in [-3, 2] {
                let c = rational(c, 1);
                let f = [&c * &p * &q, -&c * (&p + &q), c].map(|c| float(&c));
                for (lower, upper) in [(-2, 2), (-2, 0), (0, 2), (-1, 1), (1, 1)] {
                    let (lower, upper) = (rational(lower, 1), rational(upper, 1));
                    for upper in [upper, q.clone(), p.clone()] {
                        let inside = |x: &&Rational| lower <= **x && **x <= upper;
                        let root = [&q, &p].into_iter().find(inside);
                        let expected = root.map(Interval::from_rational);
                        let [low, high] = [&lower, &upper].map(float);
                        let found_there = (low <= high).then(|| between(&f, low, high)).flatten();
                        assert_eq!(found_there, expected, "{f:?} in [{lower}, {upper}]");
                        found += u32::from(expected.is_some());
                    }
                }
            }
        }
    }
    assert!(found > 500, "{found}");
}

/// The greatest of three roots next to another one: by Horner's scheme on pieces alone there would be some 2¹² pieces
/// between the two in which none could be excluded.
#[test]
fn the_greatest_of_roots_next_to_each_other_is_enclosed_alone() {
    for bits in [4, 8, 12, 16] {
        let gap = 0.5_f64.powi(bits);
        // (x + 1)(x − 1)(x − 1 − 2^−bits)
        let root = 1.0 + gap;
        for (lower, upper) in [(-2.0, 2.0), (-3.0, 1e6), (-1e6, 3.0), (1.0, 1.5)] {
            for f in [[root, -1.0, -root, 1.0], [-root, 1.0, root, -1.0]] {
                let found = between(&f, lower, upper).expect("it is there");
                assert!(found.lower() <= root && root <= found.upper(), "{root} in {found}");
                assert!(found.width() < gap / 2.0, "{root} in {found}");
            }
        }
    }
}

/// 4x³ − 3x = c for c next to 1 is a root next to 1 and two next to −1/2: that next to the end is told from these.
#[test]
fn a_root_in_the_last_step_below_the_end_is_enclosed_alone() {
    let c = 1.0_f64.next_down();
    let found = between(&[-c, -3.0, 0.0, 4.0], -0.625, 1.0).expect("it is there");
    assert!(found.width() < 1e-15, "{found}");
    // f(1 − 2^−53) is below 0, f(1) above
    assert!(found.lower() <= 1.0_f64.next_down() && found.upper() == 1.0, "{found}");
}

/// (x − 1)(x − 5/2)(x − 3) changes its sign between 0 and any end next to 2 or above 3: for the one the root is 1, for
/// the other 3.
#[test]
fn an_enclosure_holds_for_every_choice_of_the_ends() {
    for f in [[-7.5, 13.0, -6.5, 1.0], [7.5, -13.0, 6.5, -1.0]] {
        for upper in [Interval::between(2.0, 4.0), Interval::between(1.5, 3.0)] {
            let found = Interval::greatest_root(&points(&f), &Interval::zero(), &upper);
            let found = found.expect("there is one");
            assert!(found.lower() <= 1.0 && 3.0 <= found.upper(), "{found} in {upper}");
        }
    }
    // of x² − 1 from an end between −2 and 0 on to one between −1/2 and 2 it is either
    let ends = [Interval::between(-2.0, 0.0), Interval::between(-0.5, 2.0)];
    let found = Interval::greatest_root(&points(&[-1.0, 0.0, 1.0]), &ends[0], &ends[1]);
    let found = found.expect("there is one");
    assert!(found.lower() <= -1.0 && 1.0 <= found.upper(), "{found}");
}

#[test]
fn what_is_not_finite_and_what_has_no_root_is_refused() {
    let one = Interval::one();
    let line = points(&[-1.0, 1.0]);
    assert_eq!(Interval::greatest_root(&line, &one, &one), Some(one), "the root is both ends");
    assert_eq!(Interval::greatest_root(&line, &Interval::from(2.0), &Interval::zero()), None);
    assert_eq!(Interval::greatest_root(&line, &Interval::WHOLE, &one), None);
    assert_eq!(Interval::greatest_root(&line, &Interval::zero(), &Interval::WHOLE), None);
    for f in [[Interval::WHOLE, one], [one, Interval::WHOLE]] {
        assert_eq!(Interval::greatest_root(&f, &-one, &one), None);
    }
    assert_eq!(between(&[-1.0, 1.0, 0.0, 0.0, 0.0], 0.0, 2.0), None, "five coefficients");
    assert_eq!(
        between(&[0.0, 0.0], -1.0, 2.0),
        Some(Interval::between(-1.0, 2.0)),
        "all are roots"
    );
    assert_eq!(between(&[3.0, 0.0], -1.0, 2.0), None, "a constant has none");
    assert_eq!(between(&[], -1.0, 2.0), Some(Interval::between(-1.0, 2.0)));
}
