//! Lemmas of Coq say what the claims say. What is wanted is written here by hand, from the pages on the language and on
//! the judges; that data and proof fit to it, Coq itself checks (see `asked`).

use std::rc::Rc;

use kane_audit::Audit;
use kane_judges::Claims;
use kane_judges::coq::{File, NotEmitted, file};

use kane_kernel::{Evidence, Model, Point, Root};

use crate::document::{Q, judged, q, whole};

/// The file of an audit.
pub(crate) fn coq(audit: &Audit) -> File {
    file(&Claims::of(audit))
}

/// What a lemma, an example or a theorem of a file says, on one line.
fn says(text: &str, kind: &str, name: &str) -> Option<String> {
    let (_, rest) = text.split_once(&format!("{kind} {name} :"))?;
    let (statement, _) = rest.split_once(".\nProof.")?;
    Some(statement.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// Statements, and by the name of a claim what its lemma says.
pub(crate) type Said = (&'static str, &'static [(&'static str, &'static str)]);

/// Holds the lemmas of statements against what they should say.
pub(crate) fn assert_lemmas(said: &Said) {
    assert_said(said, ("Lemma", "claim_"));
}

/// Holds the theorems of statements against what they should say.
pub(crate) fn assert_theorems(said: &Said) {
    assert_said(said, ("Theorem", "theorem_"));
}

/// An example, which says that premises can be met, goes by its own name.
fn assert_said((statements, wanted): &Said, (kind, prefix): (&str, &str)) {
    let audit = judged(statements);
    let text = coq(&audit).beside_theory();
    for (name, wanted) in *wanted {
        let said = match name.starts_with("met_") {
            true => says(&text, "Example", name),
            false => says(&text, kind, &format!("{prefix}{name}")),
        };
        let wanted = wanted.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(said.as_deref(), Some(&*wanted), "{name} in\n{text}");
    }
}

pub(crate) const BOUNDS: Said = (
    "var x, y, 0 < u, -1/2 <= w < 2\n\
         given g: x = u + w\n\
         given p: y > 0 when x > 1\n\
         claim a: x + y > -3 when y >= 0, u > 0 from g\n\
         claim b: y > 0 when x > 2 from p\n\
     claim alone: 1 + 1 = 2\n\
     claim nowhere: 1 = 2 expect refuted",
    &[
        (
            "a",
            "forall x y u w : R, u > 0 -> w >= -1 / 2 -> w < 2 -> x = u + w -> \
                 (y >= 0 /\\ u > 0) -> x + y > - 3",
        ),
        ("b", "forall x y : R, (x > 1 -> y > 0) -> x > 2 -> y > 0"),
        ("alone", "1 + 1 = 2"),
        ("nowhere", "~ ( 1 = 2)"),
    ],
);

#[test]
fn bounds_stand_first_then_premises_then_conditions_then_the_conclusion() {
    assert_lemmas(&BOUNDS);
}

pub(crate) const PREMISES: Said = (
    "var x, y, z\n\
         given g: x < 1/y < z\n\
         claim a: x < z from g\n\
         claim b: x < 1/y < z expect refuted\n\
         claim c: x < z when y != 0 from b\n\
         given w: 1/x > y when 1/z > 0\n\
         claim d: x != 0 when z > 0 from w",
    &[
        ("a", "forall x y z : R, (y <> 0 /\\ x < 1 / y /\\ y <> 0 /\\ 1 / y < z) -> x < z"),
        (
            "c",
            "forall x y z : R, (y <> 0 -> x < 1 / y /\\ (y <> 0 -> 1 / y < z)) -> y <> 0 -> x < z",
        ),
        (
            "d",
            "forall x y z : R, ((z <> 0 /\\ 1 / z > 0) -> x <> 0 /\\ 1 / x > y) -> z > 0 -> x <> 0",
        ),
    ],
);

#[test]
fn a_given_asserts_that_it_is_defined_and_a_cited_claim_speaks_where_it_is() {
    assert_lemmas(&PREMISES);
}

pub(crate) const FINDINGS: Said = (
    "var x, y\n\
         given g: x > 1\n\
         given n: x < 0\n\
         claim proved: 1/x < 1 from g\n\
         claim refuted: 1/x < 1/4 from g expect refuted\n\
         claim ill: 1/(x - 2) = 1/(x - 2) from g expect ill-defined\n\
         claim none: contradiction from g, n\n\
         claim free: not implied n from g\n\
         claim vac: y = 1 from g, n expect vacuous\n\
         given w: 1/y > 0 when x > 2\n\
         claim free-when: not implied w from g",
    &[
        ("proved'", "forall x : R, x > 1 -> x <> 0 /\\ 1 / x < 1"),
        ("refuted'", "~ ( forall x : R, x > 1 -> x <> 0 -> 1 / x < 1 / 4)"),
        ("ill", "~ ( forall x : R, x > 1 -> x - 2 <> 0 /\\ x - 2 <> 0)"),
        ("none", "forall x : R, x > 1 -> x < 0 -> False"),
        ("free", "~ ( forall x : R, x > 1 -> x < 0)"),
        ("vac", "forall x y : R, x > 1 -> x < 0 -> False"),
        ("free_when", "~ ( forall x y : R, x > 1 -> x > 2 -> y <> 0 /\\ 1 / y > 0)"),
    ],
);

#[test]
fn each_finding_is_concluded_in_its_own_way() {
    assert_lemmas(&FINDINGS);
}

pub(crate) const CONDITIONS: Said = (
    "var x, y\n\
         given s: x > 1, y > 1\n\
         claim powers: x^-2*x^2*x^0 = y/y from s\n\
         claim numbers: x/2 + y/0.75 > 0 from s\n\
         let o := 0\n\
         claim zero: x/o = 1 from s expect ill-defined\n\
         claim nested: 1/(1/x) = abs(x) from s\n\
         claim choice: cases { x > 1: y; else: 1/y } > 1 from s\n\
         claim both: cases { x < 1: 1/x; x < 2, y > 0: y; else: 1/y } > 0 from s\n\
         claim open: cases { 1/x < 2: x } > 1 from s\n\
         claim root: sqrt(x) > 0 from s\n\
         claim roots: sqrt(x + sqrt(y)) > sqrt(x) from s\n\
     claim deep: sqrt(x*y + 1) > 1 from s\n\
     claim sums: sqrt(x + y) > sqrt(x) from s",
    &[
        (
            "powers",
            "forall x y : R, (x > 1 /\\ y > 1) -> \
                 x ^ 2 <> 0 /\\ y <> 0 /\\ 1 / x ^ 2 * x ^ 2 * x ^ 0 = y / y",
        ),
        ("numbers", "forall x y : R, (x > 1 /\\ y > 1) -> x / 2 + y / (3 / 4) > 0"),
        ("zero", "~ ( forall x y : R, (x > 1 /\\ y > 1) -> 0 <> 0)"),
        (
            "nested",
            "forall x y : R, (x > 1 /\\ y > 1) -> x <> 0 /\\ 1 / x <> 0 /\\ 1 / (1 / x) = Rabs x",
        ),
        (
            "choice",
            "forall x y : R, (x > 1 /\\ y > 1) -> (~ (x > 1) -> y <> 0) /\\ \
                 ((if Rgt_dec x 1 then y else 1 / y) > 1)",
        ),
        (
            "both",
            "forall x y : R, (x > 1 /\\ y > 1) -> (x < 1 -> x <> 0) /\\ \
                 (~ (x < 1) -> (x < 2 -> ~ (y > 0) -> y <> 0) /\\ (~ (x < 2) -> y <> 0)) /\\ \
                 ((if Rlt_dec x 1 then 1 / x else if Rlt_dec x 2 then if Rgt_dec y 0 then y else 1 / y else 1 / y) > 0)",
        ),
        (
            "open",
            "forall x y : R, (x > 1 /\\ y > 1) -> x <> 0 /\\ (~ (1 / x < 2) -> False) /\\ \
                 ((if Rlt_dec (1 / x) 2 then x else 0) > 1)",
        ),
        (
            "root",
            "forall x y root : R, (0 <= x -> 0 <= root /\\ root * root = x) -> \
                 (x > 1 /\\ y > 1) -> 0 <= x /\\ root > 0",
        ),
        (
            "deep",
            "forall x y root : R, (0 <= x * y + 1 -> 0 <= root /\\ root * root = x * y + 1) -> \
             (x > 1 /\\ y > 1) -> 0 <= x * y + 1 /\\ root > 1",
        ),
        (
            "roots",
            // a root stands behind those inside of it
            "forall x y root' root'' root : R, \
                 (0 <= y -> 0 <= root' /\\ root' * root' = y) -> \
                 (0 <= x -> 0 <= root'' /\\ root'' * root'' = x) -> \
                 (0 <= x + root' -> 0 <= root /\\ root * root = x + root') -> \
                 (x > 1 /\\ y > 1) -> 0 <= y /\\ 0 <= x + root' /\\ 0 <= x /\\ root > root''",
        ),
        (
            "sums",
            "forall x y root' root : R, (0 <= x -> 0 <= root' /\\ root' * root' = x) -> \
                 (0 <= x + y -> 0 <= root /\\ root * root = x + y) -> \
                 (x > 1 /\\ y > 1) -> 0 <= x + y /\\ 0 <= x /\\ root > root'",
        ),
    ],
);

#[test]
fn conditions_say_where_a_term_is_defined_and_no_more() {
    assert_lemmas(&CONDITIONS);
}

pub(crate) const DERIVATIVES: Said = (
    "var x, y, slope_2\n\
         claim quotient: d(x^2/y, x) = 2*x/y when y != 0\n\
         claim power: d(x^-1, x) < 0 when x > 0\n\
         claim two: d(x^2, x) + d(x*y, y) = 3*x\n\
         claim again: d(d(x^3, x), x) = 6*x\n\
         claim third: d(d(d(x^3, x), x), x) = 6\n\
         claim choice: d(abs(x), x) = 1 when x > 0\n\
         claim steady: d(cases { y > 0: 1/x; else: x }, x) < 0 when x > 0, y > 0\n\
         claim taken: d(slope_2*x, x) + d(y^2, y) = slope_2 + 2*y\n\
         claim number: d(x/2, x) = 1/2\n\
     claim zeroth: d(x^0*y, x) = 0\n\
         claim not: d(x^2, x) = 1 expect refuted\n\
     claim beside: sqrt(y)*d(x^2, x) = 2*x*sqrt(y) when y > 0\n\
     claim neither: d(x^3, x) + d(x^2, x) + d(y^2, y) = 1 expect refuted",
    &[
        (
            "quotient",
            "forall x y slope : R, (y <> 0 -> derivable_pt_lim (fun x : R => x ^ 2 / y) x slope) -> \
                 y <> 0 -> y <> 0 /\\ y <> 0 /\\ slope = 2 * x / y",
        ),
        (
            "power",
            "forall x slope : R, (x ^ 1 <> 0 -> derivable_pt_lim (fun x : R => 1 / x ^ 1) x slope) -> \
                 x > 0 -> x ^ 1 <> 0 /\\ slope < 0",
        ),
        (
            "two",
            "forall x y slope slope_2 : R, (derivable_pt_lim (fun x : R => x ^ 2) x slope) -> \
                 (derivable_pt_lim (fun y : R => x * y) y slope_2) -> slope + slope_2 = 3 * x",
        ),
        (
            "again",
            "forall x slope : R, (exists (slope_of : R -> R) (delta : R), 0 < delta /\\ \
                 (forall x' : R, Rabs (x' - x) < delta -> \
                 derivable_pt_lim (fun x : R => x ^ 3) x' (slope_of x')) /\\ \
                 derivable_pt_lim slope_of x slope) -> slope = 6 * x",
        ),
        (
            "third",
            "forall x slope : R, (exists (slope_of_2 : R -> R) (delta_2 : R), 0 < delta_2 /\\ \
                 (forall x_2 : R, Rabs (x_2 - x) < delta_2 -> \
                 derivable_pt_lim (fun x : R => x ^ 3) x_2 (slope_of_2 x_2)) /\\ \
                 exists (slope_of : R -> R) (delta : R), 0 < delta /\\ \
                 (forall x' : R, Rabs (x' - x) < delta -> \
                 derivable_pt_lim slope_of_2 x' (slope_of x')) /\\ \
                 derivable_pt_lim slope_of x slope) -> slope = 6",
        ),
        (
            "choice",
            "forall x slope : R, (x <> 0 -> derivable_pt_lim \
                 (fun x : R => (if Rge_dec x 0 then x else - x)) x slope) -> x > 0 -> x <> 0 /\\ slope = 1",
        ),
        (
            "steady",
            "forall x y slope : R, ((y > 0 -> x <> 0) -> derivable_pt_lim \
                 (fun x : R => (if Rgt_dec y 0 then 1 / x else x)) x slope) -> \
                 (x > 0 /\\ y > 0) -> (y > 0 -> x <> 0) /\\ slope < 0",
        ),
        (
            "taken",
            "forall x y slope_2 slope slope_2' : R, \
                 (derivable_pt_lim (fun x : R => slope_2 * x) x slope) -> \
                 (derivable_pt_lim (fun y : R => y ^ 2) y slope_2') -> \
                 slope + slope_2' = slope_2 + 2 * y",
        ),
        (
            "number",
            "forall x slope : R, (derivable_pt_lim (fun x : R => x / 2) x slope) -> slope = 1 / 2",
        ),
        (
            "zeroth",
            "forall x y slope : R, (derivable_pt_lim (fun x : R => x ^ 0 * y) x slope) -> slope = 0",
        ),
        (
            "not",
            "~ ( forall x slope : R, (derivable_pt_lim (fun x : R => x ^ 2) x slope) -> slope = 1)",
        ),
    ],
);

#[test]
fn a_derivative_is_a_number_and_what_is_known_of_it() {
    assert_lemmas(&DERIVATIVES);
}

/// Points at algebraic numbers, some of which are seen only from close by.
pub(crate) const NUMBERS: Said = (
    "var x, y\n\
     given two: x^2 = 2\n\
     given cube: y^3 = x\n\
     given ahead: x > 0\n\
     claim (sign): x > 0 from two expect refuted\n\
     claim (above): x < 1.41421 from two, ahead expect refuted\n\
     claim (below): x > 1.41422 from two, ahead expect refuted\n\
     claim (same): x^4 - x^3 = 1 from two, ahead expect refuted\n\
     claim (tower): y^2 < 1.2 from two, cube, ahead expect refuted\n\
     claim (free): not implied ahead from two\n\
     given behind: x < 0\n\
     claim (odd): x^2 + x > 1 from two, behind expect refuted\n\
     given three: x^3 - 3*x + 1 = 0\n\
     given between: 0 < x < 1\n\
     claim (middle): x^3 > 1/2 from three, between expect refuted",
    &[
        ("sign", "~ ( forall x : R, x ^ 2 = 2 -> x > 0)"),
        ("above", "~ ( forall x : R, x ^ 2 = 2 -> x > 0 -> x < 141421 / 100000)"),
        ("tower", "~ ( forall x y : R, x ^ 2 = 2 -> y ^ 3 = x -> x > 0 -> y ^ 2 < 6 / 5)"),
        ("free", "~ ( forall x : R, x ^ 2 = 2 -> x > 0)"),
        // where its polynomial falls, the opposite one rises, and that begins with a negative number
        (
            "middle",
            "~ ( forall x : R, x ^ 3 - 3 * x + 1 = 0 -> (0 < x /\\ x < 1) -> x ^ 3 > 1 / 2)",
        ),
    ],
);

#[test]
fn an_algebraic_witness_denies_the_claim_over_all_numbers() {
    assert_lemmas(&NUMBERS);
}

#[test]
fn definitions_are_written_out_as_deep_as_a_document_may_have_them() {
    let claim = |depth: usize| {
        let lets: String = (1..=depth).map(|n| format!("let f{n} := f{} + 0\n", n - 1)).collect();
        let text = coq(&judged(&format!("var x\nlet f0 := x\n{lets}claim c: f{depth} = x")));
        text.lemmas[0].name.clone().map(|_| text.lemmas[0].text.matches("+ 0").count())
    };
    // f0 is the 64th
    assert_eq!(claim(63), Ok(63));
    assert_eq!(claim(64), Err(NotEmitted::Symbol));
}

/// A number between two others, of a polynomial, as a lemma has it.
fn generator(text: &str) -> (String, Vec<Q>) {
    let (_, rest) = text.split_once("(Generator [").expect("a number");
    let (poly, ends) = rest.split_once("]%Z ").expect("coefficients");
    let words = |part: &str| {
        part.replace(['(', ')'], " ").split_whitespace().map(str::to_owned).collect::<Vec<_>>()
    };
    let ends = words(ends.lines().next().unwrap_or_default());
    let number = |at: usize| {
        ends[at].parse::<Q>().expect("an integer") / ends[at + 1].parse::<Q>().expect("an integer")
    };
    (poly.to_owned(), vec![number(1), number(4)])
}

#[test]
fn a_number_is_enclosed_until_each_sign_is_seen_and_its_polynomial_rises() {
    let statements = "var x\ngiven two: x^2 = 2\ngiven up: x > 0\n\
        claim c: 4142*x < 5857 from two, up expect refuted";
    for (poly, hi) in [([-2, 0, 1], 2), ([2, 0, -1], 3)] {
        let mut audit = judged(statements);
        let link = &mut audit.judgements[2].links[0];
        let mut accepted = (**link.accepted.as_ref().expect("it is refuted")).clone();
        // wider than what the kernel has: x > 5857/4142 is not seen
        let generator_of =
            Some(Root { poly: poly.map(Into::into).to_vec(), lo: whole(1), hi: whole(hi) });
        let values = vec![(0, vec![whole(0), whole(1)])];
        let point = Point { generator: generator_of, values };
        accepted.certificate.evidence = Evidence::Model(Model::Point(point));
        link.accepted = Some(Rc::new(accepted));
        let text = coq(&audit).lemmas[0].text.clone();
        let (poly, ends) = generator(&text);
        assert_eq!(poly, "(-2); 0; 1", "{text}");
        let (two, [lo, hi]) = (whole(2), &ends[..]) else { unreachable!("{ends:?}") };
        assert!(lo * lo < two && two < hi * hi && *lo >= q(5857, 4142), "{ends:?}");
    }
}

#[test]
fn a_value_in_an_algebraic_number_is_written_over_one_denominator() {
    let mut audit = judged(
        "var x\ngiven g: (6*x - 3)^2 = 8\ngiven up: 2*x > 1\n\
         claim c: 6*x < 5 from g, up expect refuted",
    );
    let link = &mut audit.judgements[2].links[0];
    let mut accepted = (**link.accepted.as_ref().expect("it is refuted")).clone();
    // the same number as 1/2 + θ/3 with θ² = 2
    let root = Root { poly: [-2, 0, 1].map(Into::into).to_vec(), lo: whole(1), hi: whole(2) };
    let values = vec![(0, vec![q(1, 2), q(1, 3)])];
    let point = Point { generator: Some(root), values };
    accepted.certificate.evidence = Evidence::Model(Model::Point(point));
    link.accepted = Some(Rc::new(accepted));
    let text = coq(&audit).lemmas[0].text.clone();
    let (_, value) = text.split_once("[c_ [").expect("a value");
    let (value, _) = value.split_once("]\n").expect("it ends");
    let (coefficients, denominator) = value.split_once("]%Z ").expect("a denominator");
    let number = |text: &str| text.trim().parse::<Q>().expect("an integer");
    let read: Vec<Q> = coefficients.split(';').map(|c| number(c) / number(denominator)).collect();
    assert_eq!(read, [q(1, 2), q(1, 3)], "{text}");
}
