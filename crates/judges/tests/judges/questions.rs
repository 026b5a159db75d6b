//! Questions in SMT-LIB hold exactly where a claim fails as its verdict says. What is wanted is written here by hand, as a
//! condition on a point.

use kane_judges::Claims;
use kane_judges::smt::{NotPut, question, questions};
use kane_kernel::{Conclusion, Finding, Goal, Point, Root};
use num_traits::{Signed, Zero};

use crate::document::{Q, assert_asks, found, goal, judged, not_implied, q, text, whole};
use crate::smt::Question;

/// What is asked of a proved claim, that speaks of x and y, and has no roots.
fn assert_fails(statements: &str, fails: impl Fn(&Q, &Q) -> bool) {
    assert_asks_of(statements, Finding::Proved, fails);
}

fn assert_asks_of(statements: &str, finding: Finding, fails: impl Fn(&Q, &Q) -> bool) {
    let text = text(&format!("var x, y\n{statements}"), finding).expect("it can be put");
    assert_asks(&text, &["x", "y"], |_| Vec::new(), |p| fails(&p[0], &p[1]));
}

#[test]
fn a_proved_claim_fails_where_it_is_false_or_undefined_and_a_refuted_one_where_it_is_false() {
    let statement = "claim c: y/x = 1";
    let (defined, holds) = (|x: &Q| !x.is_zero(), |x: &Q, y: &Q| y == x);
    assert_fails(statement, |x, y| !defined(x) || !holds(x, y));
    assert_asks_of(statement, Finding::Refuted, |x, y| defined(x) && !holds(x, y));
    assert_asks_of(statement, Finding::IllDefined, |x, _| !defined(x));
}

#[test]
fn premises_that_contradict_or_do_not_are_asked_about_alone() {
    for finding in [Finding::Vacuous, Finding::Consistent] {
        assert_asks_of("given g: x > y\nclaim c: y = 1", finding, |x, y| x > y);
    }
    let mut goal = goal("var x, y\ngiven g: x > y\nclaim c: y = 1");
    goal.conclusion = Conclusion::Contradiction;
    let text = question(&found(goal, Finding::Proved, None)).expect("it can be put").text;
    assert_asks(&text, &["x", "y"], |_| Vec::new(), |p| p[0] > p[1]);
}

#[test]
fn a_given_is_defined_and_true_and_a_cited_claim_true_where_it_is_defined() {
    let one = whole(1);
    assert_fails("given g: 1/x > 1\nclaim c: y = 1", |x, y| {
        x.is_positive() && *x < one && *y != one
    });
    assert_fails("claim b: 1/x > 1\nclaim c: y = 1", |x, y| {
        (x.is_zero() || x.is_positive() && *x < one) && *y != one
    });
}

#[test]
fn a_chain_is_read_from_left_to_right_to_the_first_link_that_is_not_true() {
    let one = whole(1);
    // where x is 1 or more the second link is not read, and the premise is false, whether 1/(y - 1) is there or not
    assert_fails("claim b: x < 1 < 1/(y - 1)\nclaim c: y = 4", |x, y| {
        let second = *y == one || *y > one && *y < whole(2);
        *x < one && second && *y != whole(4)
    });
}

#[test]
fn conditions_have_to_be_true_and_a_sentence_says_nothing_where_its_own_are_not() {
    let one = whole(1);
    assert_fails("claim c: y = 1 when 1/x > 1", |x, y| x.is_positive() && *x < one && *y != one);
    assert_fails("given g: y > 1 when 1/x > 1\nclaim c: y = 4", |x, y| {
        let applies = x.is_positive() && *x < one;
        (!applies || *y > one) && *y != whole(4)
    });
    // two conditions: the second is read where the first is true
    assert_fails("claim c: y = 1 when x > 0, 1/(x - 1) > 0", |x, y| *x > one && *y != one);
}

#[test]
fn what_does_not_follow_fails_where_its_sentence_is_false_or_undefined() {
    let goal = not_implied("var x, y\ngiven g: y >= 0\nclaim c: 1/y > 1 when x > 0");
    let text = question(&found(goal, Finding::Proved, None)).expect("it can be put").text;
    assert_asks(
        &text,
        &["x", "y"],
        |_| Vec::new(),
        |p| !p[1].is_negative() && p[0].is_positive() && (p[1].is_zero() || p[1] >= whole(1)),
    );
}

#[test]
fn declared_bounds_are_asserted_with_or_without_their_ends() {
    let declared = "var -1 < x <= 1/4, 0 <= y < 9/4\nclaim c: x = y";
    let text = text(declared, Finding::Proved).expect("it can be put");
    assert_asks(
        &text,
        &["x", "y"],
        |_| Vec::new(),
        |p| {
            let inside =
                p[0] > whole(-1) && p[0] <= q(1, 4) && !p[1].is_negative() && p[1] < q(9, 4);
            inside && p[0] != p[1]
        },
    );
}

#[test]
fn a_symbol_that_stands_in_a_definition_or_a_derivative_is_declared() {
    for claim in ["let f := 1 - y\nclaim c: x = f", "claim c: x + y = 1"] {
        assert_fails(claim, |x, y| x + y != whole(1));
    }
    assert_fails("claim c: d(3*y, x) = x + y", |x, y| !(x + y).is_zero());
    // and one that does not is not
    let text = text("var x, y, z\nclaim c: x = y", Finding::Proved).expect("it can be put");
    assert!(!text.contains("|z|"), "{text}");
}

#[test]
fn comparisons_of_quotients_heed_the_signs_of_denominators() {
    type Holds = fn(&Q, &Q) -> bool;
    let relations: [(&str, Holds); 6] = [
        ("=", |a, b| a == b),
        ("!=", |a, b| a != b),
        ("<", |a, b| a < b),
        ("<=", |a, b| a <= b),
        (">", |a, b| a > b),
        (">=", |a, b| a >= b),
    ];
    for (sign, holds) in relations {
        assert_fails(&format!("claim c: x {sign} y"), |x, y| !holds(x, y));
        assert_fails(&format!("claim c: 1/x {sign} y/(y - 1)"), |x, y| {
            let defined = !x.is_zero() && *y != whole(1);
            !(defined && holds(&(whole(1) / x), &(y / (y - whole(1)))))
        });
        // one denominator on both sides
        assert_fails(&format!("claim c: 1/x {sign} y/x"), |x, y| {
            x.is_zero() || !holds(&(whole(1) / x), &(y / x))
        });
    }
}

#[test]
fn arithmetic_means_what_it_means() {
    /// a value, if there is one
    type Value = fn(&Q, &Q) -> Option<Q>;
    let one = || whole(1);
    let table: [(&str, Value); 16] = [
        ("-x", |x, _| Some(-x)),
        ("x - y", |x, y| Some(x - y)),
        ("x*y", |x, y| Some(x * y)),
        ("x^0*y", |_, y| Some(y.clone())),
        ("x^1", |x, _| Some(x.clone())),
        ("x^3", |x, _| Some(x * x * x)),
        ("(1/x)^2", |x, _| (!x.is_zero()).then(|| whole(1) / (x * x))),
        ("x^-2", |x, _| (!x.is_zero()).then(|| whole(1) / (x * x))),
        ("(x/y)^-1", |x, y| (!x.is_zero() && !y.is_zero()).then(|| y / x)),
        ("x/3 + y/(-2)", |x, y| Some(x / whole(3) - y / whole(2))),
        ("1/x + 1/y", |x, y| (!x.is_zero() && !y.is_zero()).then(|| (x + y) / (x * y))),
        ("1/x + y/x", |x, y| (!x.is_zero()).then(|| (whole(1) + y) / x)),
        ("1/x - 2*y", |x, y| (!x.is_zero()).then(|| whole(1) / x - whole(2) * y)),
        ("1/(1/x)", |x, _| (!x.is_zero()).then(|| x.clone())),
        ("abs(x) + min(x, y)", |x, y| Some(x.abs() + x.min(y))),
        ("max(x, 1/y)", |x, y| (!y.is_zero()).then(|| x.max(&(whole(1) / y)).clone())),
    ];
    for (term, value) in table {
        let fails = |x: &Q, y: &Q| value(x, y) != Some(one());
        let statement = format!("claim c: {term} = 1 + 0*(x + y)");
        assert_fails(&statement, fails);
        assert_fails(&format!("claim c: {term} < x + 3*y - 2"), |x, y| {
            value(x, y).is_none_or(|v| v >= x + whole(3) * y - whole(2))
        });
    }
}

#[test]
fn cases_are_read_in_order_and_are_undefined_where_a_guard_or_the_branch_is() {
    assert_fails("claim c: cases { x < 1: y; x < 2, y > 0: 1/y; else: x } = 1", |x, y| {
        let value = if *x < whole(1) {
            y.clone()
        } else if *x < whole(2) && y.is_positive() {
            whole(1) / y
        } else {
            x.clone()
        };
        value != whole(1)
    });
    assert_fails("claim c: cases { 1/x > 1: y } = 1", |x, y| {
        !(x.is_positive() && *x < whole(1) && *y == whole(1))
    });
    assert_fails("claim c: cases { x > 0: 1/y; else: y } = 1", |_, y| *y != whole(1));
}

#[test]
fn a_definition_is_worth_its_body_however_often_and_however_long() {
    let body = "(x + 1)*(x + 2)*(x + 3)*(x + 4)/((y - 1)*(y + 2 + x^2 + x^4)*(x^2 + 1))";
    let statements = format!("let f := {body}\nclaim c: f*f + f = x");
    let value = |x: &Q, y: &Q| {
        let rise = |n: i64| x + whole(n);
        let top = rise(1) * rise(2) * rise(3) * rise(4);
        let square = x * x;
        let below =
            (y - whole(1)) * (y + whole(2) + &square + &square * &square) * (square + whole(1));
        (!below.is_zero()).then(|| top / below)
    };
    assert_asks_of(&statements, Finding::Refuted, |x, y| {
        value(x, y).is_some_and(|f| &f * &f + &f != *x)
    });
    // what is long has a name, and is written once
    let asked = text(&format!("var x, y\n{statements}"), Finding::Proved).expect("put");
    assert_eq!(asked.matches("define-fun").count(), 2, "{asked}");
    assert_eq!(asked.matches("(+ |x| 4)").count(), 1, "{asked}");
    // what is short has none
    let asked = text("var x, y\nlet f := x + 4\nclaim c: f*f = x", Finding::Proved).expect("put");
    assert!(!asked.contains("define-fun"), "{asked}");
}

/// The rational root of a square, or −1, which is a root of nothing.
fn root(square: &Q) -> Q {
    let root = Q::new(square.numer().magnitude().sqrt().into(), square.denom().sqrt());
    if &root * &root == *square { root } else { whole(-1) }
}

#[test]
fn a_root_is_a_number_that_is_not_negative_and_has_its_square() {
    let statement = "var x, y\nclaim c: sqrt(x)*sqrt(x) + sqrt(y) = y";
    let asked = text(statement, Finding::Refuted).expect("it can be put");
    // roots are numbered as they are met, a right side before a left one
    let holds = |p: &[Q]| {
        let (a, b) = (root(&p[0]), root(&p[1]));
        !a.is_negative() && !b.is_negative() && &p[0] + b != p[1]
    };
    assert_asks(&asked, &["x", "y"], |p| vec![root(&p[1]), root(&p[0])], holds);
    assert_eq!(asked.matches("declare-const |root").count(), 2, "{asked}");
    // the other root, and a number that is none, are none
    let unlike = |p: &[Q]| vec![root(&p[1]), -root(&p[0])];
    assert_asks(&asked, &["x", "y"], unlike, |p| holds(p) && p[0].is_zero());
    let unlike = |p: &[Q]| vec![root(&p[1]), root(&p[0]) + whole(1)];
    let question = Question::read(&asked).expect("it can be read");
    for point in crate::document::points(2) {
        let names = ["|x|", "|y|", "|root 1|", "|root 2|"].map(str::to_owned);
        let values = names.into_iter().zip(point.iter().cloned().chain(unlike(&point)));
        // x = −1: of what is no root nothing is said but that there is none
        assert_eq!(question.holds(&values.collect()), Ok(false));
    }
}

#[test]
fn a_root_of_a_quotient_and_a_root_in_a_root_are_roots() {
    // where the denominator is negative, too
    let asked = text("var x, y\nclaim c: sqrt(x/y) = 1", Finding::Refuted).expect("put");
    let ratio = |p: &[Q]| if p[1].is_zero() { whole(-1) } else { &p[0] / &p[1] };
    assert_asks(
        &asked,
        &["x", "y"],
        |p| vec![root(&ratio(p))],
        |p| !root(&ratio(p)).is_negative() && root(&ratio(p)) != whole(1),
    );
    let text = text(
        "var x, y\nlet r := sqrt(x)\nclaim c: sqrt(1/4 + 3/2*r) + sqrt(x) = y",
        Finding::Refuted,
    );
    let inner = |p: &[Q]| root(&p[0]);
    let outer = |p: &[Q]| root(&(q(1, 4) + q(3, 2) * inner(p)));
    let asked = text.expect("it can be put");
    assert_asks(
        &asked,
        &["x", "y"],
        |p| vec![inner(p), outer(p)],
        |p| !inner(p).is_negative() && !outer(p).is_negative() && outer(p) + inner(p) != p[1],
    );
}

#[test]
fn where_a_radicand_is_negative_a_claim_is_undefined() {
    let asked = text("var x, y\nclaim c: sqrt(x) = y", Finding::IllDefined).expect("put");
    assert_asks(&asked, &["x", "y"], |p| vec![root(&p[0])], |p| p[0].is_negative());
}

/// Coordinates as polynomials in a number between two others.
fn point() -> Point {
    // θ = 3/2, of 2·θ² + θ − 6, whose other root is −2
    let poly = [-6, 1, 2].map(Into::into).to_vec();
    let generator = Some(Root { poly, lo: whole(1), hi: q(7, 4) });
    let values = vec![
        (0, vec![whole(1), q(-1, 2)]),
        (1, vec![whole(0), whole(0), whole(1)]),
        (2, vec![whole(5)]),
    ];
    Point { generator, values }
}

#[test]
fn a_witness_is_asserted_with_the_number_in_which_it_is_written() {
    let goal = goal("var x, y, z\nclaim c: x > y");
    let asked = question(&found(goal, Finding::Refuted, Some(point()))).expect("it can be put");
    assert!(asked.satisfiable);
    let question = Question::read(&asked.text).expect("it can be read");
    // a symbol of which the claim does not speak has no place
    assert_eq!(question.declared, ["|x|", "|y|", "theta"]);
    // 1 − θ/2 and θ²
    let right = [q(1, 4), q(9, 4), q(3, 2)];
    let holds = |values: &[Q; 3]| {
        let names = question.declared.iter().cloned();
        question.holds(&names.zip(values.iter().cloned()).collect())
    };
    assert_eq!(holds(&right), Ok(true), "{}", asked.text);
    // the other root, an end, and another point
    for wrong in [
        [whole(2), whole(4), whole(-2)],
        [q(1, 2), whole(1), whole(1)],
        [q(1, 8), q(49, 16), q(7, 4)],
        [q(1, 4), q(9, 4), q(5, 4)],
        [q(1, 5), q(9, 4), q(3, 2)],
        [q(1, 4), whole(9), q(3, 2)],
    ] {
        assert_eq!(holds(&wrong), Ok(false), "{wrong:?}\n{}", asked.text);
    }
}

#[test]
fn a_rational_witness_is_asserted_and_needs_no_other_number() {
    let goal = goal("var x, y\nclaim c: x > y");
    let at = Point { generator: None, values: vec![(0, vec![q(-1, 3)]), (1, Vec::new())] };
    let asked = question(&found(goal.clone(), Finding::Refuted, Some(at.clone()))).expect("put");
    let question_of = Question::read(&asked.text).expect("it can be read");
    assert_eq!(question_of.declared, ["|x|", "|y|"]);
    for (x, y, holds) in
        [(q(-1, 3), whole(0), true), (q(-1, 3), whole(1), false), (whole(-1), whole(0), false)]
    {
        let values = [("|x|".to_owned(), x), ("|y|".to_owned(), y)];
        assert_eq!(question_of.holds(&values.into()), Ok(holds), "{}", asked.text);
    }
    // premises without a common point have no witness that meets them
    let vacuous = question(&found(goal, Finding::Vacuous, Some(at))).expect("it can be put");
    assert!(!vacuous.satisfiable);
}

#[test]
fn what_is_zero_or_one_is_not_written_into_products_and_sums() {
    // solvers multiply out what is written: a polynomial over 1 stays a polynomial
    for (claim, asserted) in [
        ("x + y = 2", "(not (= (+ |x| |y|) 2))"),
        ("x + 0 = 0*y", "(not (= |x| 0))"),
        ("-0 + x = y", "(not (= |x| |y|))"),
        ("1*x = y*1", "(not (= |x| |y|))"),
        ("x^2*x^1 = y^0", "(not (= (* (* |x| |x|) |x|) 1))"),
        ("x/3 = -y", "(not (= (* |x| (/ 1 3)) (- |y|)))"),
    ] {
        let asked = text(&format!("var x, y\nclaim c: {claim}"), Finding::Proved).expect("put");
        let line = format!("\n(assert {asserted})\n");
        assert!(asked.contains(&line), "{claim}:\n{asked}");
    }
}

#[test]
fn what_cannot_be_put_says_why() {
    let limit = "var x, y\nclaim c: x*y -> 0 as x -> 0";
    assert_eq!(text(limit, Finding::Proved), Err(NotPut::Limits));
    let premise = "var x, y\ngiven g: x*y -> 0 as x -> 0\nclaim c: y = 1";
    assert_eq!(text(premise, Finding::Proved), Err(NotPut::Limits));
    // two outcomes of each of 11 choices and of their comparison are as many pieces as are written
    let claim = |n: usize| {
        let choices: Vec<String> = (0..n).map(|i| format!("abs(x + {i}*y)")).collect();
        format!("var x, y\nclaim c: {} > -1", choices.join(" + "))
    };
    assert_eq!(text(&claim(12), Finding::Proved), Err(NotPut::TooLarge));
    assert!(text(&claim(11), Finding::Proved).is_ok());
    // a finding that no relation can have
    let goal = not_implied(limit);
    let asked = question(&found(goal, Finding::Proved, None));
    assert_eq!(asked, Err(NotPut::Limits));
    // a symbol that there is not
    let goal = self::goal("var x, y\nclaim c: x = y");
    let mut context = goal.context.clone();
    context.vars.pop();
    let strange = Goal { context, ..goal };
    let asked = question(&found(strange, Finding::Proved, None));
    assert_eq!(asked, Err(NotPut::Symbol));
}

#[test]
fn a_definition_that_uses_another_twice_is_followed_once() {
    let lets: String = (1..=60).map(|n| format!("let f{n} := f{0} - f{0}/2\n", n - 1)).collect();
    let claim = format!("var x, y\nlet f0 := x\n{lets}claim c: 2^60*f60 = y");
    let asked = text(&claim, Finding::Proved).expect("it can be put");
    assert_asks(&asked, &["x", "y"], |_| Vec::new(), |p| p[0] != p[1]);
}

#[test]
fn definitions_in_a_derivative_are_written_out_as_deep_as_64() {
    let claim = |depth: usize| {
        let lets: String = (1..=depth).map(|n| format!("let f{n} := f{} + 1\n", n - 1)).collect();
        text(&format!("var x, y\nlet f0 := x\n{lets}claim c: d(f{depth}, x) = y"), Finding::Proved)
    };
    // f0 is the 64th
    let asked = claim(63).expect("it can be put");
    assert_asks(&asked, &["x", "y"], |_| Vec::new(), |p| p[1] != whole(1));
    assert_eq!(claim(64), Err(NotPut::TooLarge));
}

#[test]
fn every_question_of_a_document_has_a_name_of_its_own() {
    let audit = judged(
        "var x\n\
         claim (1): x^2 >= 0\n\
         claim a-b: x^2 + 1 > 0\n\
         claim a.b: x^2 + 2 > 0\n\
         claim chain: 0 <= x^2 <= x^2 + 1\n\
         claim lim: x -> 0 as x -> 0\n\
         claim open: x > 0 expect refuted\n\
         given g: x > 1",
    );
    let asked = questions(&Claims::of(&audit));
    let names: Vec<&str> = asked.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["1", "a_b", "a_b_", "chain_1", "chain_2", "open"]);
    let satisfiable: Vec<bool> = asked.iter().map(|(_, q)| q.satisfiable).collect();
    assert_eq!(satisfiable, [false, false, false, false, false, true]);
    let only = questions(&Claims::of(&audit).only(&[1, 5]));
    assert_eq!(only.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["a_b", "open"]);
}
