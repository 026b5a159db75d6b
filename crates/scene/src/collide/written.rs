//! Exact numbers as a table can hold them.

use num_traits::{Signed as _, Zero as _};

use kane_number::{Algebraic, Integer, Rational, power_of};

/// Digits of a number that is too long to be written out.
const DIGITS: u32 = 20;
/// Columns of a fraction or a surd that is written out.
const SHORT: usize = 24;

/// The number itself if it takes no more than 24 characters (`23/250`, `1 - sqrt(2)`), else its
/// first 20 significant digits, cut and not rounded, with an ellipsis if others follow.
#[must_use]
pub fn written(exact: &Algebraic) -> String {
    // a root that is named by its polynomial is a description, not a value
    if let Some(in_full) = exact.written_out()
        && in_full.len() <= SHORT
    {
        return in_full;
    }
    let mut bits = 128;
    loop {
        let (low, high) = exact.enclose(bits);
        if low.is_negative() == high.is_negative() && !low.is_zero() && !high.is_zero() {
            let (below, above) = (cut(&low), cut(&high));
            if below == above {
                return below;
            }
        }
        bits *= 2;
    }
}

/// A rational as near to the number as 200 bits say, relatively: the number itself if it is rational.
pub(super) fn near(exact: &Algebraic) -> Rational {
    let mut bits = 256;
    loop {
        let (low, high) = exact.enclose(bits);
        let width = &high - &low;
        if width.is_zero() || width * (Integer::from(1) << 200_u32) < low.abs() {
            return low;
        }
        bits *= 2;
    }
}

/// The first digits of a number that is not zero.
fn cut(exact: &Rational) -> String {
    let magnitude = exact.abs();
    let bits = |n: &Integer| i64::try_from(n.bits()).unwrap_or(i64::MAX / 40_000);
    let mut power = (bits(magnitude.numer()) - bits(magnitude.denom())) * 30103 / 100_000 - 1;
    while power_of(10, power + 1) <= magnitude {
        power += 1;
    }
    while power_of(10, power) > magnitude {
        power -= 1;
    }
    let scaled = &magnitude / power_of(10, power + 1 - i64::from(DIGITS));
    let ends = scaled.is_integer();
    let digits = scaled.to_integer().to_string();
    let digits = if ends { digits.trim_end_matches('0') } else { &digits };
    let sign = if exact.is_negative() { "-" } else { "" };
    let rest = if ends { "" } else { "…" };
    match power {
        -5..0 => {
            let zeros = "0".repeat(usize::try_from(-power - 1).unwrap_or(0));
            format!("{sign}0.{zeros}{digits}{rest}")
        }
        0..20 => {
            let whole = usize::try_from(power + 1).unwrap_or(1);
            match digits.split_at_checked(whole) {
                Some((whole, "")) => format!("{sign}{whole}{rest}"),
                Some((whole, part)) => format!("{sign}{whole}.{part}{rest}"),
                None => format!("{sign}{digits:0<whole$}"),
            }
        }
        _ => {
            let (first, others) = digits.split_at(1);
            let point = if others.is_empty() { "" } else { "." };
            format!("{sign}{first}{point}{others}{rest}e{power}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kane_number::parse;

    fn of(text: &str) -> String {
        written(&Algebraic::from(parse(text).expect("a literal")))
    }

    fn of_two() -> Algebraic {
        Algebraic::from(parse("2").expect("a literal"))
    }

    #[test]
    fn a_short_number_is_written_in_full() {
        assert_eq!(of("0.092"), "23/250");
        assert_eq!(of("0"), "0");
        assert_eq!(written(&of_two().sqrt().expect("2 is positive")), "sqrt(2)");
    }

    #[test]
    fn a_long_number_is_cut_and_says_so() {
        assert_eq!(of("1000000000000/3000000000001"), "0.33333333333322222222…");
        assert_eq!(of("-2000000000000000/3000000000001"), "-666.66666666644444444…");
        assert_eq!(of("1e30"), "1e30");
        assert_eq!(of("-1.25e-30"), "-1.25e-30");
        assert_eq!(of("2000000000000000000000003/3000000000000"), "666666666666.66666666…");
    }

    #[test]
    fn a_root_of_a_root_has_no_polynomial_but_digits() {
        let root = |exact: &Algebraic| exact.sqrt().expect("it is positive");
        let nested = root(&(Algebraic::from(Rational::from_integer(1.into())) + root(&of_two())));
        assert_eq!((nested.written_out(), &*written(&nested)), (None, "1.5537739740300373073…"));
        assert_eq!(root(&of_two()).written_out().as_deref(), Some("sqrt(2)"));
    }

    #[test]
    fn a_long_number_that_ends_has_no_ellipsis() {
        assert_eq!(of("0.12345678901234567"), "0.12345678901234567");
    }
}
