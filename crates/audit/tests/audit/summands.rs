//! Sums as they are written, differences of roots, and products of two conditions: claims that need no long
//! search, each beside a false neighbour.

use kane_audit::{Options, Verdict, audit, read};

/// The verdict on a claim, and the operations that it took.
fn judged(claim: &str) -> (Verdict, u64) {
    let symbols = "var x, y, z, w, a, b, c, e\nvar p > 0, q > 0, r > 0\n";
    let text = format!("```kane\n{symbols}claim a: {claim}\n```\n");
    let document = read("summands.md", text.as_bytes()).expect("it can be read");
    let judgement = audit(document, &Options::default(), &mut |_, _| {}).judgements.remove(0);
    (judgement.verdict, judgement.links.iter().map(|link| link.work).sum())
}

#[test]
fn a_sum_written_as_squares_is_told_without_a_search() {
    for claim in [
        "(3/2 - x + x*y)^2 + (9/4 - x + x*y^2)^2 + (21/8 - x + x*y^3)^2 + 1/10 > 0",
        "(x^3 - 2*y)^4 + q*(z - w^5)^2 + r > 0",
        "0 <= 2*(x*y - z^3 + 1)^2*p + (x*y*z*w - 3)*(x*y*z*w - 3)/5",
    ] {
        let (verdict, work) = judged(claim);
        assert_eq!(verdict, Verdict::Proved, "{claim}");
        // a fiftieth of what a document may take
        assert!(work < 10_000_000, "{claim}: {work} operations");
    }
    for claim in ["(x^3 - 2*y)^4 + q*(z - w^5)^2 > 0", "(x - 2*y)^2 + w*(z - x)^2 + r > 0"] {
        assert_eq!(judged(claim).0, Verdict::Refuted, "{claim}");
    }
}

#[test]
fn roots_with_equal_squares_are_equal() {
    for claim in [
        "sqrt(2)*sqrt(3) = sqrt(6)",
        "sqrt(2) + sqrt(3) = sqrt(5 + 2*sqrt(6))",
        "a + b = sqrt(5) when a > 0, b > 0, a != b, abs(a - 1/a) = 1, abs(b - 1/b) = 1",
    ] {
        assert_eq!(judged(claim).0, Verdict::Proved, "{claim}");
    }
    for claim in ["sqrt(2)*sqrt(3) = sqrt(7)", "sqrt(2) + sqrt(3) < sqrt(5 + 2*sqrt(6))"] {
        assert_eq!(judged(claim).0, Verdict::Refuted, "{claim}");
    }
}

#[test]
fn a_product_lies_between_those_of_the_ends_of_its_ranges() {
    let ranges = "a <= x, x <= b, c <= y, y <= e, e < 0";
    let ends = "z <= a/c, z <= a/e, z <= b/c, z <= b/e";
    assert_eq!(judged(&format!("z <= x/y when {ranges}, {ends}")).0, Verdict::Proved);
    let fewer = "z <= a/c, z <= a/e, z <= b/c";
    assert_ne!(judged(&format!("z <= x/y when {ranges}, {fewer}")).0, Verdict::Proved);
}

/// Products of conditions that stand among the premises are gone once common factors are cancelled; what they
/// say is found again.
#[test]
fn many_conditions_are_multiplied_by_each_other_where_they_are_linear() {
    let factors = ["a", "1 - a", "b - 1", "b - x", "b - y", "z", "w", "a - z", "a - w"];
    let strict = |n: usize| [0, 7, 8].contains(&n);
    let mut premises: Vec<String> = Vec::new();
    for (n, f) in factors.iter().enumerate() {
        premises.push(format!("{f} {} 0", if strict(n) { ">" } else { ">=" }));
        premises.extend(factors[..n].iter().map(|g| format!("({g})*({f}) >= 0")));
    }
    let under = |claim: &str| judged(&format!("{claim} when {}", premises.join(", "))).0;
    assert_eq!(under("z*y + w*x + z*w < 3*a*b"), Verdict::Proved);
    assert_eq!(under("z*y + w*x < 2*a*b"), Verdict::Proved);
    assert_ne!(under("z*y + w*x + z*w < 2*a*b"), Verdict::Proved);
}

/// p·q·… of ten conditions of degree two and more: only those of them take part whose terms can cancel.
#[test]
fn products_are_summed_without_those_that_cannot_cancel() {
    let premises = "x >= 1, y >= 1, z >= 1, w >= 1, a >= 0, b >= 0, c >= 0, e >= 0, \
        x - a*y >= 0, y - b*z >= 0, z - c*w >= 0, w - e*x >= 0, a^2 + b*z^3*w >= 0, c^3 + e*a*w^2 >= 0";
    let under = |claim: &str| judged(&format!("{claim} when {premises}")).0;
    assert_eq!(under("x*y >= a*y^2"), Verdict::Proved);
    assert_eq!(under("x*y + y^2 >= a*y^2 + b*y*z"), Verdict::Proved);
    assert_ne!(under("x*y >= 2*a*y^2"), Verdict::Proved);
}

/// y = √(s²·(s − 1)/(s + 1)): the leading coefficient of its equation varies.
#[test]
fn sides_with_a_root_of_a_quotient_are_compared_by_their_squares() {
    let root = "p > 0, q > 0, q^2*(p + 1) = p^2*(p - 1)";
    assert_eq!(judged(&format!("2*q*(p + 1) <= p^3 when {root}")).0, Verdict::Proved);
    assert_eq!(judged(&format!("q < p when {root}")).0, Verdict::Proved);
    assert_ne!(judged(&format!("2*q*(p + 1) < p^3 when {root}")).0, Verdict::Proved);
    assert_ne!(judged(&format!("3*q*(p + 1) <= p^3 when {root}")).0, Verdict::Proved);
}
