//! High powers of sums: what they are multiplied out to is long, and is not multiplied by itself.

use super::sides::holds_but_not;

/// The first is from SymPy's tests of limits, with powers of 2000.
#[test]
fn a_long_quotient_of_polynomials_tends_to_that_of_its_leading_terms() {
    let difference = "((x^2000 - (x + 1)^2000)/x^1999) -> -2000";
    holds_but_not(&format!("{difference} as x -> oo"), ("-2000 ", "-1999 "));
    let at_minus_infinity = "((x^301 - (x - 2)^301)/x^300) -> 602 as x -> -oo";
    holds_but_not(at_minus_infinity, ("602 ", "-602 "));
    let at_zero = "((1/x)^300 - (1/x + 1)^300)*x^299 -> -300 as x -> 0+";
    holds_but_not(at_zero, ("-300 ", "300 "));
    let infinite = "((x^302 - (x + 1)^302)/x^300) -> -oo as x -> oo";
    holds_but_not(infinite, ("-oo", "oo"));
    let odd = "((x^302 - (x + 1)^302)/x^300) -> oo as x -> -oo";
    holds_but_not(odd, ("oo", "-oo"));
}

#[test]
fn a_high_even_power_of_a_sum_is_a_square() {
    holds_but_not("(x + y)^400 >= 0", ("400", "401"));
    holds_but_not("(2*x - 3*y)^400 + (x - 1)^600 + 1 > 0", ("+ 1 >", ">"));
}
