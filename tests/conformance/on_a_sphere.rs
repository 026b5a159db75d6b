//! k(α) on a sphere, which stands in the first table of `docs/laws.md` and in `LawInfo`, judged by the
//! auditor: the formulas follow from what the laws state, and they are what the code says exactly.

use std::fmt::Write as _;

use kane::audit::Verdict;
use kane::impact::{Alpha, Law, laws};
use kane::number::{Rational, parse};

use crate::support::judged;

/// k at some α, where it is rational.
fn values(law: &Law) -> Vec<(Rational, Rational)> {
    let value = |alpha: &Rational| {
        let ratios = law.over().ratios(&Alpha::Finite(alpha.clone()))?;
        Some((alpha.clone(), ratios.k))
    };
    alphas().iter().filter_map(value).collect()
}

/// The landmarks of the laws; at the last five Smith's square root is rational.
fn alphas() -> Vec<Rational> {
    let text = "1/100 1/10 1/4 2/5 1/2 3/5 3/4 1 3/2 2 3 5 10 100 5/4 13/6 25/8 41/10 82/15";
    text.split(' ').map(|alpha| parse(alpha).expect("a literal")).collect()
}

/// What leads from Smith's statement to the square root, for the auditor.
const SMITH: &str = "\
claim neg: k <= 0 when alpha >= 1/2 from (9), s0
claim quad: k^2 - 2*alpha*k + 1 - 2*alpha = 0 when k <= 0 from (9), s1
claim factors: (alpha - k - sqrt(alpha^2 + 2*alpha - 1))*(alpha - k + sqrt(alpha^2 + 2*alpha - 1)) = 0
    when alpha >= 1/2 from neg, quad
claim positive: alpha - k + sqrt(alpha^2 + 2*alpha - 1) > 0 when alpha >= 1/2 from neg
";

/// The formulas in the first table against the laws' statements, for every α > 0 and every value of
/// the laws' parameters.
#[test]
fn the_formulas_for_the_sphere_follow_from_the_statements() {
    for law in laws() {
        let mut text = String::from(
            "var alpha > 0, k, i_x, share, eta, 0 <= beta0 <= 1, -1 <= e_t <= 1\n\
             given (9): 2*alpha*i_x = 1 - k\n",
        );
        let mut from = String::from("(9)");
        for (n, line) in law.info.statement.lines().enumerate() {
            let _ = writeln!(text, "given s{n}: {line}");
            let _ = write!(from, ", s{n}");
        }
        if law.info.id == "smith-1991" {
            text.push_str(SMITH);
            from.push_str(", factors, positive");
        }
        let mut lower = "0";
        for (n, (until, formula)) in law.info.on_a_sphere.iter().enumerate() {
            let upper =
                if until.is_empty() { String::new() } else { format!(", alpha <= {until}") };
            let _ = writeln!(
                text,
                "claim formula-{n}: k = {formula} when alpha > {lower}{upper} from {from}"
            );
            lower = until;
        }
        let audit = judged(&text);
        for (statement, judgement) in audit.document.statements.iter().zip(&audit.judgements) {
            let fine = matches!(judgement.verdict, Verdict::Proved | Verdict::Assumed);
            assert!(fine, "{}: {} is {}", law.info.id, statement.label, judgement.verdict);
        }
    }
}

/// The formulas in the first table against the code, judged by the auditor.
#[test]
fn the_formulas_for_the_sphere_are_those_of_the_code() {
    let mut text = String::from("var alpha > 0, share, eta, beta0, e_t\n");
    let mut claims = 0;
    for law in laws() {
        let values = values(law);
        assert!(values.len() >= 8 || law.has_frame(), "{} has values", law.info.id);
        let parameters: String =
            law.parameters().iter().map(|(name, value)| format!(", {name} = {value}")).collect();
        for (n, (alpha, k)) in values.iter().enumerate() {
            let pieces = law.info.on_a_sphere;
            let inside = |(until, _): &&(&str, &str)| {
                until.is_empty() || *alpha <= parse(until).expect("a literal")
            };
            let (_, formula) = pieces.iter().find(inside).expect("the last piece is open");
            let _ = writeln!(
                text,
                "claim {}-{n}: {formula} = {k} when alpha = {alpha}{parameters}",
                law.info.id
            );
            claims += 1;
        }
    }
    let audit = judged(&text);
    for (statement, judgement) in audit.document.statements.iter().zip(&audit.judgements) {
        assert_eq!(judgement.verdict, Verdict::Proved, "{}", statement.label);
    }
    println!("{claims} values of k(α) in the page of laws are proved");
    assert!(claims >= 250, "the suite is there");
}
