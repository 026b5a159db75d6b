//! Directions from degrees, without the platform's library.

use num_traits::{Signed as _, Zero as _};

use kane_impact::bodies::Direction;
use kane_number::{Integer, Rational, Rounding, decode, encode};

/// π to 100 decimals, cut.
const PI: &str = "31415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679";

/// The pair of floats nearest to the cosine and the sine of an angle in degrees, as exact numbers.
///
/// The floats are the same on every machine: the series are summed in exact numbers with an error
/// below 2^−250, and rounded once. Multiples of 90° are exact. Meant for angles up to a few turns.
#[must_use]
pub(super) fn direction(degrees: &Rational) -> Direction<Rational> {
    let quarter = Rational::from_integer(90.into());
    let turns = (degrees / &quarter).round().to_integer();
    let rest = degrees - Rational::from_integer(turns.clone()) * quarter;
    let (cos, sin) = near_zero(&rest);
    let four = Integer::from(4);
    let quadrant = ((turns % &four) + &four) % &four;
    let (cos, sin) = match u8::try_from(quadrant).unwrap_or(0) {
        0 => (cos, sin),
        1 => (-sin, cos),
        2 => (-cos, -sin),
        _ => (sin, -cos),
    };
    Direction { cos: to_float(&cos), sin: to_float(&sin) }
}

/// The nearest float, exactly: cosines and sines are in its range.
fn to_float(exact: &Rational) -> Rational {
    let float: f64 = encode(exact, Rounding::NearestEven);
    decode(float).unwrap_or_else(|_| exact.clone())
}

/// Cosine and sine of at most 45°, by their series.
fn near_zero(degrees: &Rational) -> (Rational, Rational) {
    let digits = Integer::parse_bytes(PI.as_bytes(), 10).unwrap_or_default();
    let pi = Rational::new(digits, num_traits::pow(Integer::from(10), PI.len() - 1));
    let x = rounded(&(degrees * pi / Integer::from(180)));
    let (mut cos, mut sin) = (Rational::zero(), Rational::zero());
    let mut term = Rational::from_integer(1.into());
    let mut order = 0_u32;
    while !term.is_zero() {
        let sum = if order.is_multiple_of(2) { &mut cos } else { &mut sin };
        if order % 4 < 2 {
            *sum += &term;
        } else {
            *sum -= &term;
        }
        order += 1;
        term = rounded(&(term * &x / Integer::from(order)));
        if term.abs() < Rational::new(1.into(), Integer::from(1) << 290_u32) {
            break;
        }
    }
    (cos, sin)
}

/// Cut after 300 bits below the point, so that fractions stay small.
fn rounded(x: &Rational) -> Rational {
    let scale = Integer::from(1) << 300_u32;
    Rational::new((x * &scale).to_integer(), scale)
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_number::parse;

    #[test]
    fn right_angles_and_thirty_degrees_are_exact() {
        let n = |text| parse(text).expect("a literal");
        for (degrees, cos, sin) in [
            ("0", "1", "0"),
            ("90", "0", "1"),
            ("-90", "0", "-1"),
            ("180", "-1", "0"),
            ("270", "0", "-1"),
            ("360", "1", "0"),
        ] {
            assert_eq!(direction(&n(degrees)), Direction { cos: n(cos), sin: n(sin) }, "{degrees}");
        }
        assert_eq!(direction(&n("30")).sin, n("1/2"));
        assert_eq!(direction(&n("60")).cos, n("1/2"));
    }

    #[test]
    fn the_floats_are_those_of_a_good_library() {
        for degrees in ["20", "45", "89.9", "-33.3", "0.001"] {
            let exact = parse(degrees).expect("a literal");
            let float: f64 = encode(&exact, Rounding::NearestEven);
            let Direction { cos, sin } = direction(&exact);
            let to_f64 = |x: &Rational| -> f64 { encode(x, Rounding::NearestEven) };
            // the library rounds the angle in radians first: a relative error of 2^-53
            let radians = float.to_radians();
            assert!((to_f64(&cos) - radians.cos()).abs() < 1e-15, "{degrees}");
            assert!((to_f64(&sin) - radians.sin()).abs() < 1e-15, "{degrees}");
        }
    }
}
