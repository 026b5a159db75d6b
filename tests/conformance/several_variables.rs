//! Sixty claims of rising difficulty: how far the search gets beyond one variable.
//!
//! Each has its truth next to it. What is decided may grow; nothing may be decided wrongly.

use std::fmt::Write;
use std::time::Instant;

use kane::audit::Verdict;

use crate::support::{assert_snapshot, judged};

const FREE: &str = "var x, y, z, w";
const ORTHANT: &str = "var x >= 0, y >= 0, z >= 0, w >= 0";
const OPEN: &str = "var x > 0, y > 0, z > 0, w > 0";
const BOX: &str = "var 0 <= x <= 1, 0 <= y <= 1, 0 <= z <= 1, 0 <= w <= 1";

/// Symbols, claim, and whether it is true.
const CLAIMS: [(&str, &str, bool); 60] = [
    // identities and their neighbours
    (FREE, "(x + y)^3 = x^3 + 3*x^2*y + 3*x*y^2 + y^3", true),
    (FREE, "(x + y)^3 = x^3 + y^3", false),
    (FREE, "x^3 + y^3 + z^3 - 3*x*y*z = (x + y + z)*(x^2 + y^2 + z^2 - x*y - y*z - z*x)", true),
    (FREE, "(x^2 + y^2)*(z^2 + w^2) = (x*z - y*w)^2 + (x*w + y*z)^2", true),
    (FREE, "(x^2 + y^2)*(z^2 + w^2) = (x*z + y*w)^2", false),
    (OPEN, "1/(x*y) + 1/(y*z) + 1/(z*x) = (x + y + z)/(x*y*z)", true),
    // squares
    (FREE, "x^2 + y^2 >= 2*x*y", true),
    (FREE, "x^2 + y^2 > 2*x*y", false),
    (FREE, "x^2 + x*y + y^2 >= 0", true),
    (FREE, "x^2 + 3*x*y + y^2 >= 0", false),
    (FREE, "x^2 + y^2 + z^2 >= x*y + y*z + z*x", true),
    (FREE, "x^2 + y^2 + 1 >= x + y + x*y", true),
    (FREE, "x^2 + 2*x*y + 2*y^2 + 2*y + 1 >= 0", true),
    (FREE, "x^2 + 2*x*y + 2*y^2 + 2*y + 1 > 0", false),
    (FREE, "x^4 + y^4 >= x^3*y + x*y^3", true),
    (FREE, "x^4 - x^2*y^2 + y^4 >= 0", true),
    (FREE, "x^2 + y^2 + z^2 + w^2 >= x*y + y*z + z*w", true),
    (FREE, "(x^2 + y^2)*(z^2 + w^2) >= (x*z + y*w)^2", true),
    (FREE, "3*(x^2 + y^2 + z^2) >= (x + y + z)^2", true),
    // the orthant
    (OPEN, "x*y + y*z > 0", true),
    (ORTHANT, "x*y + y*z > 0", false),
    (OPEN, "x/y + y/x >= 2", true),
    (OPEN, "(x + y)*(1/x + 1/y) >= 4", true),
    (OPEN, "(x + y + z)*(1/x + 1/y + 1/z) >= 9", true),
    (OPEN, "(x + y + z)*(1/x + 1/y + 1/z) > 9", false),
    (OPEN, "x^3 + y^3 >= x^2*y + x*y^2", true),
    (OPEN, "x/(x + y) + y/(x + y) = 1", true),
    (OPEN, "x/(1 + x) < y/(1 + y) when x < y", true),
    (OPEN, "x*y/(x + y) <= (x + y)/4", true),
    (OPEN, "x*y/(x + y) < x", true),
    (ORTHANT, "(x + y)*(y + z)*(z + x) >= 8*x*y*z", true),
    (ORTHANT, "x^3 + y^3 + z^3 >= 3*x*y*z", true),
    (ORTHANT, "x^3 + y^3 + 1 - 3*x*y >= 0", true),
    (ORTHANT, "x^3 + y^3 + 1 - 3*x*y > 0", false),
    (ORTHANT, "x + (1 - x*y)^2 > 0", true),
    (ORTHANT, "x + (1 - x*y)^2 >= 1/100", false),
    (OPEN, "x/(y + z) + y/(z + x) + z/(x + y) >= 3/2", true),
    // boxes
    (BOX, "x + y - x*y <= 1", true),
    (BOX, "x + y - x*y < 1", false),
    (BOX, "x*(1 - y) + y*(1 - x) <= 1", true),
    (BOX, "x*y*z*w <= (x + y + z + w)/4", true),
    (BOX, "x^2 + y^2 <= x + y", true),
    (BOX, "x^2*(1 - y) + y^2*(1 - z) + z^2*(1 - x) <= 1", true),
    (BOX, "16*x*y*(1 - x)*(1 - y) <= 1", true),
    (BOX, "16*x*y*(1 - x)*(1 - y) < 1", false),
    (BOX, "x/(1 + y) + y/(1 + x) <= 1", true),
    // premises
    (FREE, "x^2 + y^2 >= 1/2 when x + y = 1", true),
    (FREE, "x*y <= 1/4 when x + y = 1", true),
    (FREE, "x*y < 1/4 when x + y = 1", false),
    (FREE, "x*z + y*w <= 1 when x^2 + y^2 = 1, z^2 + w^2 = 1", true),
    (FREE, "x + y <= 3/2 when x^2 + y^2 = 2", false),
    (FREE, "x^2 + y^2 >= z^2 when x + y = z, x >= 0, y >= 0", false),
    (FREE, "x^2 + y^2 <= z^2 when x + y = z, x >= 0, y >= 0", true),
    (OPEN, "x + y >= 2 when x*y = 1", true),
    (OPEN, "x + y + z >= 3 when x*y*z = 1", true),
    // absolute values
    (FREE, "abs(x + y + z) <= abs(x) + abs(y) + abs(z)", true),
    (FREE, "abs(abs(x) - abs(y)) <= abs(x - y)", true),
    // Motzkin, Schur
    (FREE, "x^4*y^2 + x^2*y^4 + 1 - 3*x^2*y^2 >= 0", true),
    (FREE, "x^4*y^2 + x^2*y^4 + z^6 - 3*x^2*y^2*z^2 >= 0", true),
    (ORTHANT, "x*(x - y)*(x - z) + y*(y - x)*(y - z) + z*(z - x)*(z - y) >= 0", true),
];

#[test]
fn sixty_claims_in_several_variables_are_decided_or_left_open_but_never_wrong() {
    let (mut table, mut wrong, mut decided) = (String::new(), Vec::new(), 0);
    let start = Instant::now();
    let mut slowest = (0.0, "");
    for (symbols, claim, truth) in CLAIMS {
        let begin = Instant::now();
        let audit = judged(&format!("{symbols}\nclaim c: {claim}"));
        let verdict = audit.judgements[0].verdict;
        let seconds = begin.elapsed().as_secs_f64();
        if seconds > slowest.0 {
            slowest = (seconds, claim);
        }
        match verdict {
            Verdict::Proved if truth => decided += 1,
            Verdict::Refuted if !truth => decided += 1,
            Verdict::Undecided => {}
            other => wrong.push(format!("{symbols}: {claim} is {truth}, but {other}")),
        }
        let truth = if truth { "true" } else { "false" };
        let domain = symbols.trim_start_matches("var ").split(',').next().unwrap_or_default();
        let _ = writeln!(table, "{:<10} {truth:<6} {domain:<12} {claim}", verdict.to_string());
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let share = format!("{decided} of {} decided", CLAIMS.len());
    println!("several variables: {share} in {:.1} s", start.elapsed().as_secs_f64());
    println!("several variables: the longest took {:.1} s: {}", slowest.0, slowest.1);
    assert_snapshot("several_variables", &format!("{table}\n{share}\n"));
}
