//! Conditions whose sides are squared, or multiplied, once it is known that they are not negative.

use kane_audit::{Options, Verdict, audit, read};

/// The verdict on a claim, judged in a document.
pub(crate) fn verdict(claim: &str) -> Verdict {
    let text = format!("```kane\nvar a, b, c, p, q, r, s, t, u, v, x, y\nclaim k: {claim}\n```\n");
    let document = read("sides.md", text.as_bytes()).expect("it can be read");
    let judged = audit(document, &Options::default(), &mut |_, _| {}).judgements.pop();
    judged.expect("there is a claim").verdict
}

/// Proves a claim, and refutes what becomes of it by a change.
pub(crate) fn holds_but_not(claim: &str, (is, would_be): (&str, &str)) {
    assert!(claim.contains(is), "{claim}");
    assert_eq!(verdict(claim), Verdict::Proved, "{claim}");
    let changed = claim.replacen(is, would_be, 1);
    assert_eq!(verdict(&changed), Verdict::Refuted, "{changed}");
}

#[test]
fn of_two_matrices_without_a_negative_eigenvalue_the_product_has_no_negative_trace() {
    let both = "a >= 0, c >= 0, a*c >= b^2, p >= 0, r >= 0, p*r >= q^2";
    holds_but_not(&format!("a*p + 2*b*q + c*r >= 0 when {both}"), ("2*b", "3*b"));
    let sum = "(a + p)*(c + r) - (b + q)^2 >= a*c - b^2 + p*r - q^2";
    holds_but_not(&format!("{sum} when {both}"), ("+ p*r", "+ 2*p*r"));
}

/// 16·s² is Heron's product, so that s is the area: the sharper form of Weitzenböck's inequality (Finsler and Hadwiger
/// 1937). What stands beside the root is a sum of terms of both signs.
#[test]
fn a_side_of_both_signs_is_squared_where_it_is_not_negative() {
    let heron = "(a + b + c)*(b + c - a)*(c + a - b)*(a + b - c)";
    let triangle = "a > 0, b > 0, c > 0, a < b + c, b < c + a, c < a + b";
    let squares = "(a - b)^2 + (b - c)^2 + (c - a)^2";
    let area = format!("16*s^2 = {heron}, s >= 0");
    let claim = format!("a^2 + b^2 + c^2 >= 4*sqrt(3)*s + {squares} when {triangle}, {area}");
    holds_but_not(&claim, ("4*sqrt", "5*sqrt"));
    let root = format!("a^2 + b^2 + c^2 >= sqrt(3)*sqrt({heron}) + {squares} when {triangle}");
    holds_but_not(&root, ("sqrt(3)", "sqrt(4)"));
}

#[test]
fn a_length_is_convex() {
    let between = "sqrt((t*x + (1 - t)*u)^2 + (t*y + (1 - t)*v)^2)";
    let ends = "t*sqrt(x^2 + y^2) + (1 - t)*sqrt(u^2 + v^2)";
    for range in ["0 <= t, t <= 1", "0 < t, t < 1"] {
        holds_but_not(&format!("{between} <= {ends} when {range}"), ("- t)*u", "- t/2)*u"));
    }
}

#[test]
fn an_equation_is_shown_by_its_two_inequalities_where_nothing_else_shows_it() {
    let sum = "sqrt(x + 2*sqrt(x - 1)) + sqrt(x - 2*sqrt(x - 1)) = 2 when 1 <= x, x <= 2";
    holds_but_not(sum, ("x <= 2", "x <= 3"));
}

/// The square that is not zero is a denominator, and positive: it was asked again and again for its sign, in the case
/// in which it is negative.
#[test]
fn the_sign_of_a_square_is_asked_for_once() {
    let square = "(1 - sqrt(1 + 2*x))^2";
    let claim = format!("x < 45/8 when 1 + 2*x >= 0, {square} != 0, 4*x^2/{square} < 2*x + 9");
    holds_but_not(&claim, ("45/8", "44/8"));
}

/// From 1/x + 1/y + 1/z = 2 (Iran 1998). What stands before the square of a root is a polynomial, of which nothing says that
/// it is positive; and the other side has terms of both signs.
#[test]
fn a_root_is_isolated_whatever_positive_stands_before_its_square() {
    let given = "p > 1, q > 1, r > 1, 1/p + 1/q + 1/r = 2";
    let claim = format!("sqrt(p - 1) + sqrt(q - 1) + sqrt(r - 1) <= sqrt(p + q + r) when {given}");
    holds_but_not(&claim, ("<= sqrt(", "<= 9/10*sqrt("));
    let given = "p > 0, q > 0, r > 0, 2*p^2*q^2*r^2 + p^2*q^2 + q^2*r^2 + r^2*p^2 = 1";
    holds_but_not(&format!("p*q + q*r + r*p <= 3/2 when {given}"), ("3/2", "5/4"));
}

/// With p = 1/sqrt(1 + 8·a) and so on this is the second problem of the olympiad of 2001.
#[test]
fn what_stands_before_a_square_is_shown_by_itself_to_be_positive() {
    let range = "0 < p, p < 1, 0 < q, q < 1, 0 < r, r < 1";
    let given = "(1 - p^2)*(1 - q^2)*(1 - r^2) = 512*p^2*q^2*r^2";
    holds_but_not(&format!("p + q + r >= 1 when {range}, {given}"), (">= 1", ">= 11/10"));
}

/// It touches zero at (1, 0), (0, 1) and (1, 1), none of which is in the open triangle.
#[test]
fn a_strict_claim_may_touch_at_the_corners_of_what_it_is_about() {
    let claim = "1 - x^2*y^2 > (2 - x - y)^2*(2*x^2*y^2 + x^2 + y^2)";
    holds_but_not(&format!("{claim} when x > 0, y > 0, x + y < 2"), ("y > 0", "y >= 0"));
}

/// They touch at a corner, where two roots are 1 and the third is √5.
#[test]
fn a_root_has_the_lower_bound_that_its_square_has() {
    let roots = "sqrt(4*a + 1) + sqrt(4*b + 1) + sqrt(4*c + 1)";
    let range = "a >= 0, b >= 0, c >= 0, a + b + c = 1";
    holds_but_not(&format!("{roots} >= 2 + sqrt(5) when {range}"), ("sqrt(5)", "sqrt(6)"));
    holds_but_not(&format!("{roots} > 4 when {range}"), ("> 4", "> 17/4"));
    let squares = "x >= 0, y >= 0, t >= 0, x^2 >= 1, y^2 >= 1, t^2 >= 1, x^2 + y^2 + t^2 = 7";
    holds_but_not(&format!("x + y + t >= 2 + sqrt(5) when {squares}"), ("= 7", "= 6"));
}
