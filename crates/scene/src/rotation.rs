//! Turning by an angle, in every number system.

use kane_number::Interval;

use crate::coordinate::{Coordinate, half};

/// Terms of each series behind the first, and what they leave of an eighth: (1/8)^27/27! is below 2^−170.
const TERMS: u32 = 12;
const REST: f64 = f64::from_bits((1023 - 170) << 52);
/// An angle is halved until it is no greater, and no more often than this.
const SMALL: f64 = 0.125;
const MOST_HALVINGS: i32 = 40;

/// 1 − cos φ and sin φ, so that little is lost where φ is small.
///
/// Taylor's series of φ/2^k, and k doublings, 1 − cos 2φ = 2·sin²φ and sin 2φ = 2·sin φ·cos φ. Exact for
/// φ = 0, and without an answer for other φ in exact numbers; encloses on intervals; in floats a few
/// roundings for each doubling.
pub(crate) fn turn<N: Coordinate>(angle: &N) -> Option<[N; 2]> {
    if angle.sign().is_equal() == Some(true) {
        return Some([N::zero(), N::zero()]);
    }
    let enclosed = angle.enclosed();
    let most = enclosed.lower().abs().max(enclosed.upper().abs());
    let rest = N::of_enclosure(Interval::between(-REST, REST))?;
    let halvings = (0..MOST_HALVINGS).find(|k| most * 0.5_f64.powi(*k) <= SMALL)?;
    let one = N::one();
    let two = one.double();
    let small = (0..halvings).fold(angle.clone(), |part, _| half(part));
    let square = small.square();
    // 1 − z/(n·(n + 1))·(1 − z/((n + 2)·(n + 3))·(…, of which the last n is given
    let series = |last: N| {
        let (mut sum, mut n) = (one.clone(), last);
        for _ in 0..TERMS {
            sum = one.clone() - square.clone() * &sum / ((n.clone() + &one) * &n);
            n = n - &two;
        }
        sum
    };
    let eight = two.double().double();
    let most = eight.double() + &eight;
    let mut sine = small * series(most.clone()) + &rest;
    let mut versine = half(square.clone() * series(most + &one)) + rest;
    for _ in 0..halvings {
        let cosine = N::one() - &versine;
        (versine, sine) = (sine.square().double(), (sine * cosine).double());
    }
    Some([versine, sine])
}

/// A vector turned by an angle with these, 1 − cos φ and sin φ.
pub(crate) fn turned<N: Coordinate>([x, y]: &[N; 2], [versine, sine]: &[N; 2]) -> [N; 2] {
    [
        x.clone() - versine.clone() * x - sine.clone() * y,
        y.clone() - versine.clone() * y + sine.clone() * x,
    ]
}

#[cfg(test)]
mod tests {
    use kane_number::{DoubleDouble, Interval, Lane as _, Number as _, Rational};

    use super::turn;

    #[test]
    fn a_turn_is_that_of_the_platform_and_enclosed() {
        for n in -400..400 {
            let angle = f64::from(n) * 0.037;
            let [versine, sine] = turn(&angle).expect("floats turn");
            assert!((sine - angle.sin()).abs() < 1e-13, "{angle}: {sine} {}", angle.sin());
            assert!((1.0 - versine - angle.cos()).abs() < 1e-13, "{angle}");
            let [long_versine, long] = turn(&DoubleDouble::from(angle)).expect("they turn");
            let [enclosed_versine, enclosed] = turn(&Interval::from(angle)).expect("they turn");
            let exact = |x: DoubleDouble| x.exact().expect("it is finite");
            assert!(enclosed.contains(&exact(long)), "{angle}: {enclosed}");
            assert!(enclosed_versine.contains(&exact(long_versine)), "{angle}");
            assert!(enclosed.width() < 1e-11, "{angle}: {enclosed}");
            // the circle, to the digits of the longer floats
            let cosine = DoubleDouble::one() - long_versine;
            let off = cosine * cosine + long * long - DoubleDouble::one();
            assert!(off.to_f64().abs() < 1e-27, "{angle}: {off}");
        }
    }

    #[test]
    fn exact_numbers_turn_by_nothing_alone() {
        let zero = Rational::default();
        assert_eq!(turn(&zero), Some([zero.clone(), zero]));
        assert_eq!(turn(&Rational::one()), None);
    }
}
