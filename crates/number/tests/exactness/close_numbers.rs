//! Algebraic numbers that lie nearer to each other than a first enclosure of either.

use std::cmp::Ordering;

use kane_number::{Algebraic, Number, Rational, Real};

use crate::{rational, two_to};

fn whole(n: i64) -> Algebraic {
    rational(n, 1).into()
}

fn root_of_two() -> Algebraic {
    whole(2).sqrt().expect("it is positive")
}

fn roots_of(f: [i64; 4]) -> Vec<Algebraic> {
    Algebraic::roots(&f.map(|c| rational(c, 1)))
}

/// θ² + tθ for two roots θ₁ < θ₂ of x³ − 3x + 1 and t above the third one by less than 2⁻⁸⁰. The sum of the roots is
/// zero, so the difference of the two is (θ₁ − θ₂)(t − θ₃).
fn conjugates() -> [Algebraic; 2] {
    let roots = roots_of([1, -3, 0, 1]);
    let (_, t) = roots[2].enclose(80);
    [0, 1].map(|at| roots[at].square() + roots[at].clone() * Algebraic::from(t.clone()))
}

#[test]
fn conjugates_next_to_each_other_are_told_apart() {
    let [less, greater] = conjugates();
    assert_eq!(less.polynomial(), greater.polynomial());
    assert_eq!(less.cmp(&greater), Ordering::Less);
    assert_eq!(greater.cmp(&less), Ordering::Greater);
    let ((low, _), (_, high)) = (less.enclose(100), greater.enclose(100));
    assert!(high - low < two_to(-77));
    let (intervals, numbers) =
        ([less.isolating_interval(), greater.isolating_interval()], [&less, &greater]);
    assert!(intervals[0].1 < intervals[1].0, "{intervals:?}");
    for ((low, high), number) in intervals.into_iter().zip(numbers) {
        assert!(Algebraic::from(low) < *number && *number < high.into(), "{number}");
    }
    let third = rational(-1, 3);
    let exact = Algebraic::from(third.clone());
    assert_eq!(exact.isolating_interval(), (third.clone(), third));
}

#[test]
fn the_roots_of_conjugates_next_to_each_other_are_theirs() {
    let [less, greater] = conjugates();
    let roots = [&less, &greater].map(|x| x.sqrt().expect("it is positive"));
    assert!(!roots[0].is_negative() && roots[0] < roots[1]);
    for (root, x) in roots.iter().zip([&less, &greater]) {
        let (low, high) = root.enclose(120);
        let square = |x: &Rational| Algebraic::from(x * x);
        assert!(square(&low) < *x && *x < square(&high), "{x}");
    }
}

/// Of 2(ax − 1)² = x³ with a = 2⁴⁰ two roots are some 2⁻¹⁰¹ from 1/a, on either side (Mignotte): the interval of a field
/// tells them, but not that of √2 beside it.
#[test]
fn sums_with_roots_next_to_each_other_are_told_apart() {
    let a = 1_i64 << 40;
    let squared = two_to(81);
    let f = [rational(-2, 1), rational(4 * a, 1), -squared, rational(1, 1)];
    let roots = Algebraic::roots(&f);
    let middle = Algebraic::from(two_to(-40));
    assert!(roots[0] < middle && middle < roots[1]);
    let sums = [0, 1].map(|at| roots[at].clone() + root_of_two());
    assert!(sums[0] < sums[1]);
    for (sum, root) in sums.iter().zip(&roots) {
        assert_eq!(sum.polynomial().len(), 7);
        let ((low, high), (from, to)) = (root.enclose(130), root_of_two().enclose(130));
        assert!(Algebraic::from(low + from) < *sum && *sum < (high + to).into());
    }
}

/// (x − √2)(x − c)(x + 1) with c below √2 by less than 2⁻⁷⁰: between the ends of the first enclosure of √2 lies c.
#[test]
fn the_greatest_of_two_roots_next_to_each_other_is_found() {
    let root = root_of_two();
    let (c, _) = root.enclose(70);
    let c = Algebraic::from(c);
    let product = root.clone() * &c;
    let f = [product.clone(), product - &root - &c, whole(1) - &root - &c, whole(1)];
    let at_c = Algebraic::greatest_root(&f, &whole(-2), &c);
    assert_eq!(Algebraic::greatest_root(&f, &whole(-2), &whole(2)), Some(root));
    assert_eq!(at_c, Some(c));
}

/// c(x − 1)(x − √2) from 1 on, which is a root as well.
#[test]
fn the_greater_of_two_roots_is_found_where_the_lower_end_is_the_less() {
    let root = root_of_two();
    for leading in [whole(3), whole(-3), root.clone(), -root.clone()] {
        let f = [root.clone(), -(whole(1) + &root), whole(1)].map(|c| c * &leading);
        assert_eq!(Algebraic::greatest_root(&f, &whole(1), &whole(3)), Some(root.clone()));
        assert_eq!(Algebraic::greatest_root(&f, &whole(0), &rational(5, 4).into()), Some(whole(1)));
    }
}

/// x³ + √2·x − √3 rises, so it has one root, where its sign changes.
#[test]
fn coefficients_of_two_fields_have_a_root_where_the_sign_changes() {
    let three = whole(3).sqrt().expect("it is positive");
    let f = [-three, root_of_two(), whole(0), whole(1)];
    let root = Algebraic::greatest_root(&f, &whole(0), &whole(2)).expect("there is one");
    let (low, high) = root.enclose(20);
    let value = |x: Rational| {
        let x = Algebraic::from(x);
        f.iter().rev().fold(whole(0), |sum, c| sum * &x + c)
    };
    assert!(value(low).is_negative() && value(high) > whole(0), "{root}");
}
