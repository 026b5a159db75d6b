//! Claims that touch at places with a root in them, and claims that fail at simple places with roots.

use super::sides::{holds_but_not, verdict};
use kane_audit::Verdict;

/// Equal for a = √2 − 3, b = √2, c = √2 + 3 (IMO 2006, 3).
#[test]
fn a_form_that_touches_at_irrational_places_is_a_sum_of_squares_that_vanish_there() {
    let left = "a*b*(a^2 - b^2) + b*c*(b^2 - c^2) + c*a*(c^2 - a^2)";
    let claim = format!("{left} <= 9*sqrt(2)/32*(a^2 + b^2 + c^2)^2");
    holds_but_not(&claim, ("9*sqrt", "8*sqrt"));
}

/// It fails at (0, 1, −1) and where it is near.
#[test]
fn what_fails_at_a_corner_is_refuted_whatever_roots_there_are() {
    let root = "sqrt(6)*sqrt(x^2 + y^2 + c^2)";
    let claim = format!("(x - y)*(y - c)*(c - x) <= (x^2 + y^2 + c^2)*{root}/6");
    assert_eq!(verdict(&claim), Verdict::Refuted);
}
