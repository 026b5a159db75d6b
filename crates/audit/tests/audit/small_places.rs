//! Claims that are decided in small or irrational places: where curves meet, beside an optimum, between
//! boundaries in many variables; and quadratic claims with parameters.

use kane_audit::{Options, Verdict, audit, read};

fn verdict(text: &str) -> Verdict {
    let names = "x, y, z, u, v, w, a, b, c, e";
    let text = format!("```kane\nvar {names}\nclaim k: {text}\n```\n");
    let document = read("small.md", text.as_bytes()).expect("it is well formed");
    audit(document, &Options::default(), &mut |_, _| {}).judgements.remove(0).verdict
}

fn assert_all(expected: Verdict, claims: &[&str]) {
    for claim in claims {
        assert_eq!(verdict(claim), expected, "{claim}");
    }
}

#[test]
fn zeros_with_several_irrational_coordinates_refute_what_is_strict() {
    assert_all(
        Verdict::Refuted,
        &[
            "(x^2 - 2)^2 + (y^2 - 3)^2 > 0",
            "(x^2 - 2)^2 + (y^2 - x)^2 > 0",
            "(x^3 - 2)^2 + (x*y - 1)^2 != 0",
            "contradiction when x^2 = 2, y^2 = 3, z^2 = 5",
            "x*y*z < 0 when x^2 = 2, y^2 = x, z^2 = y, y > 0, z > 0",
        ],
    );
}

/// The same with another number for what is missing from zero: √2·√3 is no rational number, and
/// (x² − 2)² + (y² − 3)² + (x·y − 2)² is at least something.
#[test]
fn what_never_vanishes_is_not_refuted() {
    for claim in [
        "(x^2 - 2)^2 + (y^2 - 3)^2 >= 0",
        "(x^2 - 2)^2 + (y^2 - 3)^2 + (x*y - 2)^2 > 0",
        "x + y <= 3/2 when x^2 + y^2 <= 1",
        "3*x + 4*y <= 5 when x^2 + y^2 <= 1",
        "u + v + w + x + y + z <= 5/2 when u^2 + v^2 + w^2 + x^2 + y^2 + z^2 <= 1",
    ] {
        assert_ne!(verdict(claim), Verdict::Refuted, "{claim}");
    }
}

#[test]
fn a_claim_that_fails_only_in_a_sliver_is_refuted() {
    assert_all(
        Verdict::Refuted,
        &[
            "3*x + 4*y < 5 when x^2 + y^2 <= 1",
            "x + y <= 14142/10000 when x^2 + y^2 <= 1",
            "x + y <= 14142/10000 when x^2 + y^2 = 1",
            "u + v + w + x + y + z <= 244/100 when u^2 + v^2 + w^2 + x^2 + y^2 + z^2 <= 1",
            "u + v + w + x <= 33/10 when u^2 + v^2 + w^2 + x^2 = 3, u*v*w = x",
        ],
    );
}

#[test]
fn quadratic_claims_with_parameters_are_decided_by_leads_and_discriminants() {
    assert_all(
        Verdict::Proved,
        &[
            "b^2 >= 4*a*c when a*x^2 + b*x + c = 0",
            "a*x^2 + b*x + c > 0 when a > 0, b^2 < 4*a*c",
            "a*x^2 + b*x + c >= 0 when a <= 0, c >= 0, a + b + c >= 0, x >= 0, x <= 1",
            "e*a - b*c > 0 when a > 0, b > 0, a*x > c, b*x < e",
        ],
    );
    assert_all(
        Verdict::Refuted,
        &[
            "a*x^2 + b*x + c > 0 when a > 0, b^2 <= 4*a*c",
            "a*x^2 + b*x + c >= 0 when a >= 0, c >= 0, a + b + c >= 0, x >= 0, x <= 1",
            "e*a - b*c > 0 when a > 0, a*x > c, b*x < e",
        ],
    );
}

/// Conditions that share no variable: one part far from all simple values, one with an irrational number.
#[test]
fn each_part_of_what_falls_apart_has_a_point_of_its_own() {
    assert_all(
        Verdict::Refuted,
        &[
            "contradiction when x >= 7654321, x <= 7654321, y <= -x, z >= y, u^2*v = 3, u > v, v > 0",
            "contradiction when a <= -987654, b >= a, x^2 = 7, x < y, y < z, z < 0, c >= 12345, e > c + b",
            "x*y <= 1000000 when x >= 2345, y >= 1001, z^3 = 2, z*w < -1",
        ],
    );
    // the last part alone has no point
    assert_all(
        Verdict::Proved,
        &["contradiction when a <= -987654, b >= a, x^2 = 7, x < y, y < z, z < -3"],
    );
}

/// Two hyperbolas with a variable in common, and a narrow condition on it.
#[test]
fn points_on_hyperbolas_are_found_by_a_parameter() {
    assert_all(
        Verdict::Refuted,
        &[
            "contradiction when x^2 = z + 1, y^2 = z - 1, z > 1, x > 0, y > 0, 100*y < 13, 100*y > 12",
            "contradiction when x^2 = 2 + y^2, w^2 = x^2 - 1, w > 0, x > 0, 24*y - 120*y^2 + 240*y^3 <= 2, y > 0",
            "x >= 3 when 4*x^2 - 9*y^2 = 5, z^2 = x^2 + y, z > 0, x > 0, y > 1",
        ],
    );
    assert_all(Verdict::Proved, &["x > y when x^2 = 2 + y^2, x > 0"]);
}
