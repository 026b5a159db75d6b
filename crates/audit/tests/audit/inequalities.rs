//! Inequalities in positive numbers, with equality where all of them are equal: what textbooks have, and
//! nothing but an order of the variables proves.

use kane_audit::{Budget, Options, Verdict, audit, read};

fn verdict(claim: &str) -> Verdict {
    verdict_after("var a > 0, b > 0, c > 0, e > 0, x, y, z", claim, Budget::default())
}

/// The verdict on a claim behind other statements.
fn verdict_after(statements: &str, claim: &str, budget: Budget) -> Verdict {
    let text = format!("```kane\n{statements}\nclaim a: {claim}\n```\n");
    let document = read("inequality.md", text.as_bytes()).expect("it can be read");
    let options = Options { budget, ..Options::default() };
    let judged = audit(document, &options, &mut |_, _| {}).judgements.pop();
    judged.expect("there is a claim").verdict
}

#[test]
fn inequalities_of_positive_numbers_are_proved_by_successive_differences() {
    for claim in [
        // Schur's inequality of degree five
        "a^3*(a - b)*(a - c) + b^3*(b - a)*(b - c) + c^3*(c - a)*(c - b) >= 0",
        // equal at a = b = c, and at a = b for c = 0, which no sum of squares of low degree shows
        "(a*b + b*c + c*a)*(1/(a + b)^2 + 1/(b + c)^2 + 1/(c + a)^2) >= 9/4",
        "a^3/(a^2 + a*b + b^2) + b^3/(b^2 + b*c + c^2) + c^3/(c^2 + c*a + a^2) >= (a + b + c)/3",
        "a^2/(b + c) + b^2/(c + e) + c^2/(e + a) + e^2/(a + b) >= (a + b + c + e)/2",
    ] {
        assert_eq!(verdict(claim), Verdict::Proved, "{claim}");
    }
}

#[test]
fn odd_powers_keep_the_order_of_all_numbers() {
    for claim in [
        "x^5 < y^5 when x < y",
        "x^7 != y^7 when x != y",
        "x = y when x^5 = y^5",
        "x^5 + x < y^5 + y when x < y",
    ] {
        assert_eq!(verdict(claim), Verdict::Proved, "{claim}");
    }
    assert_eq!(verdict("x^4 < y^4 when x < y"), Verdict::Refuted);
}

#[test]
fn a_root_between_two_numbers_is_placed_by_their_order() {
    let gap = "(a + b)/2 - sqrt(a*b) <= (a - b)^2/(8*b) when b <= a";
    assert_eq!(verdict(gap), Verdict::Proved);
    assert_eq!(verdict(&gap.replace("8*b", "8*a")), Verdict::Refuted);
}

#[test]
fn a_little_more_than_they_say_is_refuted() {
    for claim in [
        "a^3*(a - b)*(a - c) + b^3*(b - a)*(b - c) + c^3*(c - a)*(c - b) > 0",
        "(a*b + b*c + c*a)*(1/(a + b)^2 + 1/(b + c)^2 + 1/(c + a)^2) >= 2251/1000",
        "a^3/(a^2 + a*b + b^2) + b^3/(b^2 + b*c + c^2) + c^3/(c^2 + c*a + a^2) >= 1001*(a + b + c)/3000",
        "a^2/(b + c) + b^2/(c + e) + c^2/(e + a) + e^2/(a + b) >= 1001*(a + b + c + e)/2000",
    ] {
        assert_eq!(verdict(claim), Verdict::Refuted, "{claim}");
    }
}

/// In x and e the condition is linear, so that it is largest at an end of each; what is left falls along a variable.
#[test]
fn conditions_in_boxes_are_put_to_the_ends_where_they_are_largest() {
    let ranges = "-1 <= x, x <= 1, -1 <= y, y <= 1, a <= 1, b <= 1";
    let wide = |bound: &str| format!("x*(a^3 - 3*a*b) + y*(b^2*a + 2*b) <= {bound} when {ranges}");
    assert_eq!(verdict(&wide("5")), Verdict::Proved);
    assert_eq!(verdict(&wide("499/100")), Verdict::Refuted);
    let tight = |bound: &str| {
        format!(
            "x*(4*a + 4*a*b^2 - a^3) + 4*a^2 - 10*b^2 - 5*b <= {bound} when {ranges}, 2*x <= 1, 2*b >= 1, 2*a <= 1"
        )
    };
    assert_eq!(verdict(&tight("-45/16")), Verdict::Proved);
    assert_eq!(verdict(&tight("-46/16")), Verdict::Refuted);
}

#[test]
fn few_terms_in_many_variables_are_told_by_means_of_two() {
    for (claim, expected) in [
        // Hölder's inequality for three pairs
        ("(a^3 + b^3)*(c^3 + e^3)*(x^6 + y^6) >= (a*c*x^2 + b*e*y^2)^3", Verdict::Proved),
        ("(a^3 + b^3)*(c^3 + e^3)*(x^6 + y^6) >= 101/100*(a*c*x^2 + b*e*y^2)^3", Verdict::Refuted),
        ("a^3 + b^3 + c^3 + x^6 + y^6 + e^3 >= 3*a*b*c + 3*x^2*y^2*e", Verdict::Proved),
        ("a^3 + b^3 + c^3 + x^6 + y^6 + e^3 >= 3*a*b*c + 4*x^2*y^2*e", Verdict::Refuted),
        ("x^8 + y^8 + a^8 + b^8 >= 4*x^2*y^2*a^2*b^2", Verdict::Proved),
    ] {
        assert_eq!(verdict(claim), expected, "{claim}");
    }
}

#[test]
fn many_terms_are_told_by_the_fewest_of_which_each_is_a_mean() {
    for (claim, expected) in [
        // Hölder's inequality for three triples, whose third powers are 1 and 1 and a variable
        ("(a^3 + 2)*(b^3 + 2)*(c^3 + 2) >= (a + b + c)^3", Verdict::Proved),
        ("(a^3 + 2)*(b^3 + 2)*(c^3 + 2) >= 1001/1000*(a + b + c)^3", Verdict::Refuted),
        ("(a^4 + 1)*(b^4 + 1)*(c^4 + 1)*(e^4 + 1) >= (1 + a*b*c*e)^4", Verdict::Proved),
        ("(a^4 + 1)*(b^4 + 1)*(c^4 + 1)*(e^4 + 1) >= (1 + a*b*c*e)^4 + 1/1000", Verdict::Refuted),
    ] {
        assert_eq!(verdict(claim), expected, "{claim}");
    }
}

#[test]
fn what_a_sum_is_makes_the_other_conditions_homogeneous() {
    for (sum, quotients) in [
        ("a + b + c = 1", "a/(1 + b - c) + b/(1 + c - a) + c/(1 + a - b)"),
        // the same with 2·a for a, and so on
        ("2*a + 2*b + 2*c = 1", "2*a/(1 + 2*b - 2*c) + 2*b/(1 + 2*c - 2*a) + 2*c/(1 + 2*a - 2*b)"),
    ] {
        assert_eq!(verdict(&format!("{quotients} >= 1 when {sum}")), Verdict::Proved, "{sum}");
        let beyond = format!("{quotients} >= 1001/1000 when {sum}");
        assert_eq!(verdict(&beyond), Verdict::Refuted, "{sum}");
    }
}

#[test]
fn a_root_that_has_been_squared_away_does_not_widen_the_search() {
    let claim = |n: &str| format!("a^2 + b^2 + c^2 >= sqrt({n})*a*b*c when a*b*c <= a + b + c");
    assert_eq!(verdict(&claim("3")), Verdict::Proved);
    assert_eq!(verdict(&claim("5")), Verdict::Refuted);
}

/// At simple places these have roots of three numbers, none of which is a multiple of a product of others.
#[test]
fn what_is_false_with_roots_of_three_numbers_is_refuted() {
    for claim in [
        "sqrt(4*a + 1) + sqrt(4*b + 1) + sqrt(4*c + 1) >= sqrt(21) when a + b + c = 1",
        "sqrt(a + 1) + sqrt(b + 1) >= sqrt(5) when a + b = 1/2",
        "sqrt(x^2 + 11/10) + sqrt(x^2 + 4) >= sqrt(5) + sqrt(8) + 1/4*(x - 2)",
        "sqrt(a + 2) + sqrt(b + 3) + sqrt(c + 5) >= sqrt(7) + sqrt(11) + sqrt(13)",
    ] {
        assert_eq!(verdict(claim), Verdict::Refuted, "{claim}");
    }
    let most = "sqrt(4*a + 1) + sqrt(4*b + 1) + sqrt(4*c + 1) <= sqrt(21) when a + b + c = 1";
    assert_eq!(verdict(most), Verdict::Proved);
}

/// No mean of two terms has whole powers; of their products with the variables there are enough.
#[test]
fn cyclic_quotients_are_told_by_means_of_products_with_their_variables() {
    assert_eq!(verdict("a/b + b/c + c/e + e/a >= 4"), Verdict::Proved);
    assert_eq!(verdict("a/b + b/c + c/e + e/a >= 4001/1000"), Verdict::Refuted);
}

#[test]
fn sums_of_squares_are_found_where_they_vanish_at_irrational_points_alone() {
    // (x³ + y²)² + (e² + x + y + 2)² + e² + b⁴; with one e² less it fails
    let sum = |n: u32| {
        format!(
            "x^6 + 2*x^3*y^2 + y^4 + e^4 + 2*e^2*x + 2*e^2*y + {n}*e^2 + x^2 + 2*x*y + y^2 + 4*x + 4*y + 4 + b^4 >= 0"
        )
    };
    assert_eq!(verdict(&sum(5)), Verdict::Proved);
    assert_eq!(verdict(&sum(3)), Verdict::Refuted);
}

/// Equal at a, b = 2 ± √2, where b² follows from a premise whose leading coefficient is not a number.
/// The function of Goldstein and Price (1971) has its least value 3 at (0, −1), and its leading form is zero in two directions.
#[test]
fn sums_of_squares_are_found_where_they_vanish_at_a_point_and_in_a_direction() {
    let least = |sign: &str, bound: &str| {
        let first = "1 + (x + y + 1)^2*(19 - 14*x + 3*x^2 - 14*y + 6*x*y + 3*y^2)";
        let second = "30 + (2*x - 3*y)^2*(18 - 32*x + 12*x^2 + 48*y - 36*x*y + 27*y^2)";
        verdict(&format!("({first})*({second}) {sign} {bound}"))
    };
    assert_eq!(least(">=", "3"), Verdict::Proved);
    assert_eq!(least(">", "3"), Verdict::Refuted);
    assert_eq!(least(">=", "3001/1000"), Verdict::Refuted);
    let sum = "a^3/(b + c + e) + b^3/(c + e + a) + c^3/(e + a + b) + e^3/(a + b + c)";
    let of_products = |bound: &str| format!("{sum} >= {bound} when a*b + b*c + c*e + e*a = 1");
    assert_eq!(verdict(&of_products("1/3")), Verdict::Proved);
    assert_eq!(verdict(&of_products("334/1000")), Verdict::Refuted);
}

/// Where both sums vanish nothing is simple, and the denominators are known to be positive as sums of squares alone.
#[test]
fn quotients_by_sums_of_squares_are_largest_in_their_valleys() {
    let quotient = |least: &str, bound: &str| {
        verdict(&format!("(2 - 3*a - b)/({least} + (x - 2*b + a - 4)^2) {bound}"))
    };
    assert_eq!(quotient("1", "< 7/2"), Verdict::Proved);
    assert_eq!(quotient("1", "< 2"), Verdict::Proved);
    assert_eq!(quotient("1", "< 19/10"), Verdict::Refuted);
    let valley = |bound: &str| {
        verdict(&format!(
            "(2*x + y + z - 2)/(1 + (3*x + y + 4)^2 + (3*y - 2*z - 2*x + 3)^2) <= {bound}"
        ))
    };
    assert_eq!(valley("5"), Verdict::Refuted);
    let two =
        "a/((2*b - x - a - 2)^2 + (b - 3)^2 + 10) + x/(25*b^2 + (2*x + b)^2 + 9*x^2 + 2) <= 1";
    assert_eq!(verdict(two), Verdict::Refuted);
}

#[test]
fn sides_are_compared_by_squares_that_a_premise_with_a_leading_coefficient_reduces() {
    let claim = |n: &str| format!("a + b >= {n} when b <= a, sqrt(a*b)*(a - b) = a + b");
    assert_eq!(verdict(&claim("4")), Verdict::Proved);
    assert_eq!(verdict(&claim("41/10")), Verdict::Refuted);
}

#[test]
fn roots_that_stand_alone_on_their_side_are_squared_away() {
    let verdict = |claim: &str| {
        let vectors = "var a in R^3, b in R^3, f in R^2, s in R^2, r >= 0, x >= 0, y >= 0";
        let statements = format!("{vectors}\ngiven cone: norm(f) <= r");
        verdict_after(&statements, claim, Budget::default())
    };
    for claim in [
        "norm(a + b) <= norm(a) + norm(b)",
        "abs(norm(a) - norm(b)) <= norm(a - b)",
        "abs(dot(a, b)) <= norm(a)*norm(b)",
        "dot(f, s) >= -r*norm(s) from cone",
        "sqrt(x + y + 2*sqrt(x*y)) = sqrt(x) + sqrt(y)",
        "(r + x)/sqrt(1 + r^2) <= sqrt(1 + x^2)",
        "sqrt(1 + x)*sqrt(1 + y) >= 1 + sqrt(x*y)",
        "sqrt((r + x)*(2*r + y)) >= sqrt(2)*r + sqrt(x*y)",
        "sqrt(x + y) >= x/(1 + x^2)",
    ] {
        assert_eq!(verdict(claim), Verdict::Proved, "{claim}");
    }
    for claim in [
        "norm(a - b) <= norm(a) - norm(b)",
        "abs(dot(a, b)) < norm(a)*norm(b)",
        "sqrt(1 + x)*sqrt(1 + y) > 1 + sqrt(x*y)",
        "sqrt((r + x)*(r + y)) <= r + sqrt(x*y)",
        "sqrt(x + y) > x/(1 + x^2)",
    ] {
        assert_eq!(verdict(claim), Verdict::Refuted, "{claim}");
    }
}

#[test]
fn what_rises_with_its_variable_keeps_the_order_of_all_numbers() {
    let rising = |of_x: &str| {
        let of_y = of_x.replace('x', "y");
        (format!("{of_x} < {of_y} when x < y"), format!("{of_y} < {of_x} when x < y"))
    };
    // rises from -1 to 1, as friction that is made smooth
    for of_x in
        ["x/sqrt(1 + x^2)", "x*sqrt(1 + x^2)", "x/(2 + sqrt(1 + x^2))", "x*sqrt(1 + abs(x))"]
    {
        let (claim, opposite) = rising(of_x);
        assert_eq!(verdict(&claim), Verdict::Proved, "{claim}");
        assert_eq!(verdict(&opposite), Verdict::Refuted, "{opposite}");
    }
    assert_eq!(verdict("x/sqrt(1 + x^2) < y/sqrt(2 + y^2) when x < y"), Verdict::Refuted);
    assert_eq!(verdict("x*sqrt(1 + y^2) < y*sqrt(2 + x^2) when x < y"), Verdict::Refuted);
}

#[test]
fn forms_with_symbols_are_positive_where_their_minors_are() {
    let form = "a*x^2 + e*y^2 + g*z^2 + 2*b*x*y + 2*c*x*z + 2*f*y*z";
    let minors = "a > 0, a*e - b^2 > 0";
    let whole = "a*e*g + 2*b*c*f - c^2*e - b^2*g - f^2*a";
    let found =
        |claim: &str| verdict_after("var a, b, c, e, f, g, x, y, z", claim, Budget::default());
    for (claim, expected) in [
        (format!("{form} >= 0 when {minors}, {whole} >= 0"), Verdict::Proved),
        (format!("{form} > 0 when {minors}, {whole} > 0, x^2 + y^2 + z^2 > 0"), Verdict::Proved),
        (format!("{form} > 0 when {minors}, {whole} >= 0, x^2 + y^2 + z^2 > 0"), Verdict::Refuted),
        (format!("{form} >= 0 when {minors}"), Verdict::Refuted),
        (format!("{form} >= 0 when a > 0, {whole} >= 0"), Verdict::Refuted),
        // only where all three vanish
        (format!("{form} > 0 when {minors}, {whole} > 0"), Verdict::Refuted),
    ] {
        assert_eq!(found(&claim), expected, "{claim}");
    }
}

#[test]
fn a_root_of_a_product_or_a_quotient_is_that_of_the_roots() {
    let found = |claim: &str| {
        // what is seen at once needs no more
        let budget = Budget { steps: 400, ..Budget::default() };
        verdict_after("var x > 0, y > 0, a > 0, b > 0, t", claim, budget)
    };
    for claim in [
        "sqrt(x/(x + 4)) = sqrt(x)/sqrt(x + 4)",
        "sqrt((x + y)/(a + b)) = sqrt(x + y)/sqrt(a + b)",
        "sqrt((x + y)*(a + b)) = sqrt(x + y)*sqrt(a + b)",
        "sqrt(1 - t^2) = sqrt(1 - t)*sqrt(1 + t) when abs(t) <= 1",
        "sqrt(t^3 - t) = sqrt(t)*sqrt(t - 1)*sqrt(t + 1) when t >= 1",
        "sqrt(6*t^2 + 12*t) = sqrt(2*t)*sqrt(3*t + 6) when t > 0",
        "sqrt(4*t^2 - 1)/sqrt(2*t - 1) = sqrt(2*t + 1) when t > 1",
    ] {
        assert_eq!(found(claim), Verdict::Proved, "{claim}");
    }
    for claim in [
        "sqrt((x + y)*(a + b)) = sqrt(x + y)*sqrt(a + 2*b)",
        "sqrt(4 - t^2) = sqrt(2 - t)*sqrt(1 + t) when abs(t) < 1",
        "sqrt(t^2 - 1) = sqrt(1 - t)*sqrt(-1 - t) when t <= -1, t*sqrt(t^2 - 1) > 0",
    ] {
        assert_ne!(found(claim), Verdict::Proved, "{claim}");
    }
}

#[test]
fn what_is_cited_beside_the_point_does_not_hide_a_proof_or_a_witness() {
    let found = |claim: &str| {
        let given = "var w, mu\ngiven g1: sqrt(w + 1) = w - 2*mu\ngiven g2: sqrt(w) = w - mu";
        verdict_after(given, claim, Budget::default())
    };
    let proved = "sqrt(sqrt((w - 1)^4)) = abs(w - 1) from g1";
    assert_eq!(found(proved), Verdict::Proved);
    let quotient = "sqrt(w + mu)/sqrt(w + mu - 1) = sqrt((w + mu)/(w + mu - 1)) from g2";
    assert_eq!(found(quotient), Verdict::IllDefined);
}
