//! What every system of a table can do: roots, pictures, fractions, prices.

use kane_number::{DoubleDouble, Interval, Lane, Number, Rational, System};

use crate::{rational, two_to};

/// n/d as a number of this system.
fn number<L: Lane>(n: i64, d: i64) -> L {
    L::from_rational(&rational(n, d))
}

/// What each lane says of itself, of 3/4, of the root of 9/16, and of those of 0 and −1.
fn says<L: Lane>(system: System) {
    assert_eq!(L::SYSTEM, system);
    let three_quarters: L = number(3, 4);
    assert_eq!(three_quarters.to_f64(), 0.75, "{system}");
    assert_eq!(three_quarters.exact(), Some(rational(3, 4)), "{system}");
    let root = number::<L>(9, 16).sqrt().expect("it is not negative");
    let error = root.to_f64() - 0.75;
    assert!(error.abs() <= 2.0_f64.powi(-50), "{system}: {error:e}");
    assert_eq!(L::zero().sqrt().map(|root| root.to_f64()), Some(0.0), "{system}");
    assert!(number::<L>(-1, 1).sqrt().is_none(), "{system}");
}

#[test]
fn every_lane_takes_roots_and_is_seen_as_a_float_and_as_a_fraction() {
    says::<f32>(System::F32);
    says::<f64>(System::F64);
    says::<DoubleDouble>(System::DoubleDouble);
    says::<Interval>(System::Interval);
    says::<Rational>(System::Rational);
}

#[test]
fn a_root_of_two_is_as_good_as_its_system() {
    let two = rational(2, 1);
    assert_eq!(Lane::sqrt(&2.0_f32), Some(2.0_f32.sqrt()));
    assert_eq!(Lane::sqrt(&2.0_f64), Some(2.0_f64.sqrt()));
    let pair = Lane::sqrt(&DoubleDouble::from(2.0)).and_then(|root| root.exact());
    let off = pair.map(|root| root.square() - &two).expect("it is finite");
    assert!(-two_to(-98) < off && off < two_to(-98), "the square is 2 but for a part of 2^−98");
    let between = Lane::sqrt(&Interval::from(2.0)).expect("it is not negative");
    let square = |end: f64| rational_of(end).square();
    assert!(square(between.lower()) < two && two < square(between.upper()));
    assert_eq!(Lane::sqrt(&two), None, "no fraction");
    assert_eq!(Lane::sqrt(&rational(2, 9)), None, "whichever part of it is no square");
    assert_eq!(Lane::sqrt(&rational(4, 3)), None);
}

fn rational_of(float: f64) -> Rational {
    float.exact().expect("it is finite")
}

#[test]
fn what_is_no_single_finite_number_has_no_fraction() {
    assert_eq!(f32::INFINITY.exact(), None);
    assert_eq!(f64::NAN.exact(), None);
    let third: Interval = number(1, 3);
    assert_eq!(third.exact(), None);
    assert!((third.to_f64() - 1.0 / 3.0).abs() < 1e-16, "seen by its middle");
    let none = DoubleDouble::from(f64::INFINITY);
    assert!(none.exact().is_none() && none.to_f64().is_nan());
    assert_eq!(number::<Rational>(1, 3).to_f64(), 1.0 / 3.0, "the nearest float");
}

#[test]
fn systems_have_names_and_the_cheap_ones_stand_first() {
    let names = System::ALL.map(|system| system.to_string());
    assert_eq!(names, ["f32", "f64", "double-double", "interval", "rational"]);
    assert_eq!(format!("{:>6}", System::F32), "   f32", "they fill a column");
    let sums = System::ALL.map(|system| system.weights()[0]);
    assert!(sums[0] == sums[1] && sums[1] < sums[2].min(sums[3]) && sums[2].max(sums[3]) < sums[4]);
    for system in System::ALL {
        let [sum, product, quotient, root] = system.weights();
        assert!(1 <= sum && sum <= product && product <= quotient && sum <= root, "{system}");
    }
}
