//! Proofs that are made up, as they are told: each line is written here by hand, from what its step means.

use std::cmp::Ordering;

use kane_algebra::syntax::NoValue;
use kane_audit::{End, Held, Measured, Proof, Source, Step, Summand, Supposed, Variable};
use kane_kernel::{Atom, Conclusion, Expr, Goal, Poly, Side, Sign, Target};
use num_rational::BigRational;

use super::{Form, MAX_LINES, Subject};

/// The lines of steps about a and b and the t of a limit, indented by two blanks for each level.
fn told(steps: Vec<Step>) -> Vec<String> {
    let text = b"```kane\nvar a, b\nlet c := a + b\nlet e := a*b\n```\n";
    let context = kane_audit::read("a.md", text).expect("two symbols").context;
    let (hypotheses, behind, when) = (Vec::new(), Vec::new(), Vec::new());
    let goal = Goal { context, hypotheses, behind, when, conclusion: Conclusion::Contradiction };
    let variables = vec![Variable::Symbol(0), Variable::Symbol(1), Variable::Germ];
    let subject = Subject { goal: &goal, labels: &["(1)"] };
    let lines = subject.steps(&Proof { variables, steps }, Form::Plain);
    lines.iter().map(|line| format!("{}{}", "  ".repeat(line.depth), line.text)).collect()
}

fn a() -> Poly {
    Poly::var(0)
}

fn b() -> Poly {
    Poly::var(1)
}

fn t() -> Poly {
    Poly::var(2)
}

fn number(n: i64) -> Poly {
    Poly::constant(n.into())
}

fn zero(poly: Poly) -> Atom {
    Atom::new(poly, Sign::Zero)
}

fn positive(poly: Poly) -> Atom {
    Atom::new(poly, Sign::Positive)
}

fn assume(atom: Atom) -> Step {
    Step::Assume { source: Source::Hypothesis(0), atoms: vec![atom] }
}

/// That a has the other sign by its bound.
fn by_signs() -> Step {
    let (atom, bounds) = (positive(a().neg()), vec![positive(a())]);
    Step::SignsOfCoefficients { atom, bounds, ranges: false, sum: None }
}

/// What takes more than a line.
fn long() -> Vec<Step> {
    vec![Step::Suppose { what: Supposed::Hypotheses, then: vec![Step::Absurd(positive(b()))] }]
}

const LONG: [&str; 2] =
    ["Suppose that all hypotheses hold. This is contradictory:", "  b > 0 is false."];

/// Lines, with those of [`long`] in the place of a mark.
fn lines(all: &[&str]) -> Vec<String> {
    let one = |line: &&str| match line.strip_suffix('@') {
        Some(indent) => LONG.iter().map(|long| format!("{indent}{long}")).collect(),
        None => vec![(*line).to_owned()],
    };
    all.iter().flat_map(one).collect()
}

fn cases(cases: Vec<(Vec<Atom>, Vec<Step>)>) -> Vec<Step> {
    vec![Step::Cases { source: Source::Hypothesis(0), cases }]
}

#[test]
fn cases_that_take_lines_are_numbered_from_one_and_the_others_stand_before_them() {
    let excluded = Step::Factors { atom: zero(b()), factors: vec![(positive(b()), 1)] };
    let told = told(cases(vec![
        (vec![zero(a())], long()),
        // what contradicts b > 0 is not what this case assumes
        (vec![positive(a())], vec![excluded]),
        (vec![positive(b())], long()),
    ]));
    let wanted = [
        "(1): one of 3 cases.",
        "  Excluded: a > 0: b = 0 contradicts b > 0.",
        "  Case 1: a = 0.",
        "    @",
        "  Case 2: b > 0.",
        "    @",
    ];
    assert_eq!(told, lines(&wanted));
}

#[test]
fn what_excludes_a_case_by_another_condition_is_what_the_case_assumes() {
    let of = |assumed: Atom| {
        told(cases(vec![(vec![assumed], vec![by_signs()]), (vec![zero(b())], long())]))
    };
    assert_eq!(of(positive(a().neg())), lines(&["Excluded: 0 > a by a > 0.", "(1): b = 0.", "@"]));
    assert_eq!(
        of(positive(b()))[0],
        "Excluded: b > 0: 0 > a contradicts a > 0: all its terms have the other sign."
    );
}

#[test]
fn what_is_said_to_be_wrong_is_what_was_assumed() {
    let factors = |atom: Atom, by: Atom| Step::Factors { atom, factors: vec![(by, 1)] };
    let pairs: [(Atom, Step, &str); 8] = [
        (positive(a()), Step::Absurd(positive(a())), "a > 0, which is false."),
        (positive(a()), Step::Absurd(positive(b())), "a > 0. b > 0 is false."),
        (zero(a()), factors(zero(a()), positive(a())), "a = 0, which contradicts a > 0."),
        (zero(a()), factors(zero(b()), positive(b())), "a = 0. b = 0 contradicts b > 0."),
        (
            positive(a().neg()),
            by_signs(),
            "0 > a, which contradicts a > 0: all its terms have the other sign.",
        ),
        (
            zero(b()),
            by_signs(),
            "b = 0. 0 > a contradicts a > 0: all its terms have the other sign.",
        ),
        (zero(a()), Step::Clash(vec![positive(a()), zero(a())]), "a = 0, which contradicts a > 0."),
        (zero(a()), Step::Clash(vec![positive(b()), zero(b())]), "a = 0. b > 0 contradicts b = 0."),
    ];
    for (assumed, wrong, says) in pairs {
        assert_eq!(told(vec![assume(assumed), wrong]), [format!("(1): {says}")]);
    }
}

#[test]
fn of_what_is_assumed_nothing_is_told_that_another_says_already() {
    let of = |other: Poly, sign| {
        let atoms = vec![positive(a()), Atom::new(other, sign)];
        told(vec![Step::Assume { source: Source::Condition, atoms }]).concat()
    };
    let lead = "The condition of the claim: a > 0";
    for (other, sign) in
        [(a(), Sign::NonNegative), (a(), Sign::NonZero), (a().neg(), Sign::NonZero)]
    {
        assert_eq!(of(other, sign), format!("{lead}."));
    }
    assert_eq!(of(a().neg(), Sign::NonNegative), format!("{lead}, 0 >= a."));
    assert_eq!(of(b(), Sign::NonZero), format!("{lead}, b != 0."));
    assert_eq!(of(b(), Sign::NonNegative), format!("{lead}, b >= 0."));
}

#[test]
fn a_definition_has_its_value_at_a_point_or_is_undefined_or_is_left_out() {
    let of = |value| {
        let definitions = vec![(0, value)];
        told(vec![Step::Point { values: Vec::new(), definitions, said: Vec::new() }]).concat()
    };
    let exact = Measured::Exact(BigRational::from_integer(2.into()));
    assert_eq!(of(exact), "At every point, where c = 2:");
    let none = Measured::None(NoValue::DivisionByZero);
    assert_eq!(of(none), "At every point, where c is undefined (division by zero):");
    // nothing is known of it
    assert_eq!(of(Measured::None(NoValue::TooLarge)), "At every point:");
}

#[test]
fn signs_that_end_alike_are_told_as_one() {
    let split = |poly: Poly, zero: Vec<Step>, positive: Vec<Step>, negative: Vec<Step>| {
        told(vec![Step::Split { poly, zero, positive, negative }])
    };
    let short = || vec![Step::Absurd(positive(b()))];
    // the same in words
    let twice = || vec![Step::Absurd(positive(b().scale(&2.into())))];
    let other = || vec![Step::Absurd(zero(b()))];
    let left = |of: &str, open: &str| {
        lines(&[&format!("If {of}, b > 0 is false."), &format!("There is left {open}."), "@"])
    };
    assert_eq!(split(a(), short(), twice(), long()), left("a >= 0", "a < 0"));
    assert_eq!(split(a(), short(), long(), twice()), left("a <= 0", "a > 0"));
    assert_eq!(split(a(), long(), short(), short()), left("a != 0", "a = 0"));
    // what is positive of −a is negative of a
    assert_eq!(split(a().neg(), short(), short(), long()), left("a <= 0", "a > 0"));
    let apart = ["If a = 0, b > 0 is false.", "If a > 0, b = 0 is false.", "There is left a < 0."];
    assert_eq!(split(a(), short(), other(), long())[..3], apart);
    let open = [
        "Distinguish the sign of a:",
        "  If a < 0, b = 0 is false.",
        "  Case a = 0.",
        "    @",
        "  Case a > 0.",
        "    a + b = 0 is false.",
        "    @",
    ];
    let longer = [vec![Step::Absurd(zero(a().add(&b())))], long()].concat();
    assert_eq!(split(a(), long(), longer, other()), lines(&open));
    // by its range, or by another condition on the same
    let clash = || vec![Step::Clash(vec![positive(a()), positive(a().neg())])];
    let why = "There is left a >= 0, by the ranges of its symbols or what is said of it.";
    assert_eq!(split(a(), long(), long(), clash()), lines(&[why, "@"]));
    let ranged = Step::SignsOfCoefficients {
        atom: positive(a().neg()),
        bounds: Vec::new(),
        ranges: true,
        sum: None,
    };
    assert_eq!(split(a(), long(), long(), vec![ranged]), lines(&[why, "@"]));
}

#[test]
fn what_is_reduced_kept_or_multiplied_is_told_in_full() {
    let square = || zero(Poly::power(0, 2).sub(&number(2)));
    let reduce = |leaves| vec![Step::Reduce { variable: 0, by: square(), leaves }];
    assert_eq!(told(reduce(Vec::new())), ["Reduce powers of a by a^2 = 2."]);
    let leaves = vec![positive(a())];
    assert_eq!(told(reduce(leaves)), ["Reduce powers of a by a^2 = 2. This leaves a > 0."]);
    let kept = "c, e stay as they are: what follows is so for any values of theirs.";
    assert_eq!(told(vec![Step::Kept(vec![0, 1])]), [kept]);
    let multiple = |atom, multiples| told(vec![Step::Multiple { atom, multiples }]);
    assert_eq!(
        multiple((1.into(), a()), vec![(number(1), b())]),
        ["a = [b] is 0, since the bracket is, though it is not."]
    );
    assert_eq!(
        multiple((1.into(), a()), vec![(number(2), b())]),
        ["a = (2)*[b] is 0, since the bracket is, though it is not."]
    );
    assert_eq!(
        multiple((3.into(), a()), vec![(number(1), a().sub(&b())), (b(), t())]),
        ["3*a = [a - b] + b*[t] is 0, since the brackets are, though it is not."]
    );
}

#[test]
fn of_a_sum_of_more_than_sixty_products_their_number_is_told() {
    let of = |terms: usize, multiples: usize| {
        let term = Summand { weight: 1.into(), square: a(), factors: Vec::new() };
        let terms = vec![term; terms];
        told(vec![Step::Positive { terms, multiples: vec![(b(), t()); multiples] }]).join(" ")
    };
    let many = |count: usize| {
        format!("A sum of {count} products, which the certificate lists, is 0 identically,")
    };
    for (terms, multiples) in [(61, 0), (0, 61), (41, 20), (45, 30)] {
        let told = of(terms, multiples);
        assert!(told.starts_with(&many(terms + multiples)), "{told}");
    }
    let told = of(40, 20);
    assert_eq!((told.matches("(a)^2").count() + told.matches("a^2").count()).min(40), 40, "{told}");
    assert_eq!(told.matches("b*[t]").count(), 20, "{told}");
}

#[test]
fn a_limit_says_how_its_variable_moves_what_it_is_compared_with_and_where_that_ends() {
    let one = BigRational::from_integer(1.into());
    let none = BigRational::from_integer(0.into());
    let limit = |(at, above): (Option<&BigRational>, bool), power, sense, order, otherwise| {
        let side = Side { var: 0, at: at.cloned(), above };
        told(vec![Step::LimitFrom {
            side,
            power,
            of: Expr::Var(1),
            sense,
            quotient: (number(1).sub(&t()), number(1)),
            otherwise,
            start: (number(1), number(1)),
            order,
        }])
    };
    let brief = || vec![Step::Absurd(positive(b()))];
    let (more, same, less) = (Ordering::Greater, Ordering::Equal, Ordering::Less);
    assert_eq!(
        limit((None, true), 1, more, 0, brief()),
        [
            "With a = 1/t, b >= 1 - t for all small t > 0.",
            "  Otherwise: b > 0 is false.",
            "At t = 0 the bound is 1."
        ]
    );
    assert_eq!(
        limit((Some(&one), false), 1, less, 0, long()),
        lines(&[
            "With a = 1 - t, b <= 1 - t for all small t > 0.",
            "  Otherwise:",
            "    @",
            "At t = 0 the bound is 1."
        ])
    );
    assert_eq!(
        limit((Some(&none), false), 2, same, 0, brief())[0..3],
        [
            "With a = -t^2, b = 1 - t for all small t > 0.",
            "  Otherwise: b > 0 is false.",
            "At t = 0 this is 1."
        ]
    );
    let last = "At t = 0 the numerator is 1 and the denominator vanishes to order 2.";
    assert_eq!(limit((Some(&none), true), 1, same, 2, brief())[2], last);
    assert!(limit((Some(&none), true), 1, same, 2, brief())[0].starts_with("With a = t, "));
    assert!(limit((Some(&one), true), 1, same, 2, brief())[0].starts_with("With a = 1 + t, "));
}

#[test]
fn what_passes_to_a_limit_says_once_what_brackets_stand_for() {
    let side = Side { var: 0, at: None, above: true };
    let pass = || Step::Pass {
        side: side.clone(),
        power: 1,
        along: positive(b()),
        otherwise: vec![Step::Absurd(zero(b()))],
        end: Atom::new(b(), Sign::NonNegative),
    };
    let told = told(vec![pass(), pass()]);
    let one = [
        "Along a = 1/t for small t > 0: b > 0.",
        "  Otherwise: b = 0 is false.",
        "In the limit t = 0: b >= 0.",
    ];
    // there are none
    assert_eq!(told, [one, one].concat());
}

#[test]
fn functions_say_why_each_hypothesis_holds_and_where_the_claim_fails() {
    let functions = |by_proof, limits, end| {
        let hypotheses = vec![Held { by_proof, limits }];
        told(vec![Step::Functions { of: 0, values: Vec::new(), hypotheses, end }])
    };
    let limit = |target, above, against_nothing| End::Limit { target, above, against_nothing };
    assert_eq!(
        functions(true, true, limit(Target::PlusInf, Some(true), false)),
        [
            "  (1) holds for all a, by a sign table or substitution; its limit is as premised.",
            "Then the limit from the right is oo."
        ]
    );
    assert_eq!(
        functions(false, false, limit(Target::MinusInf, Some(false), true)),
        [
            "  (1) holds for all a.",
            "Then the limit from the left is -oo, and what it should be is undefined."
        ]
    );
    let finite = limit(Target::Finite(Expr::int(2)), None, false);
    assert_eq!(functions(false, false, finite)[1], "Then the limit is 2.");
    assert_eq!(functions(false, false, End::Holds)[1], "Then all hypotheses hold.");
    assert_eq!(functions(false, false, End::At(0, None))[1], "Then it fails.");
}

#[test]
fn a_long_polynomial_has_a_name_under_which_it_is_found_at_the_end() {
    // powers of a, which no product is shorter for, beside one that tells them apart
    let long = |terms: u32, last: i64| {
        let powers = (1..terms).map(|n| (vec![(0, n)], (2 * n + 1).into()));
        Poly::sum(powers.chain([(Vec::new(), last.into())]))
    };
    let (first, second, many) = (long(20, 3), long(20, 5), long(61, 3));
    let absurd =
        [&first, &second, &first, &long(60, 7), &many].map(|p| Step::Absurd(positive(p.clone())));
    let told = told(absurd.to_vec());
    let said: Vec<&str> = told[..told.len() - 4].iter().flat_map(|l| l.split(". ")).collect();
    let is = |n: usize| format!("P_{n} > 0 is false");
    let said: Vec<String> = said.iter().map(|l| l.trim_end_matches('.').to_owned()).collect();
    assert_eq!(said, [is(1), is(2), is(1), is(3), is(4)]);
    let legend = &told[told.len() - 4..];
    for (line, begins) in legend.iter().zip(["P_1: 3 + 3*a", "P_2: 5 + 3*a", "P_3: 7 + 3*a"]) {
        assert!(line.starts_with(begins), "{line}");
    }
    assert_eq!(legend[3], "P_4: a polynomial with 61 terms");
}

#[test]
fn a_proof_of_too_many_lines_says_that_the_rest_is_left_out() {
    let line = || Step::Suppose { what: Supposed::Hypotheses, then: Vec::new() };
    let of = |count: usize| told((0..count).map(|_| line()).collect());
    let left_out = "(the rest of this proof is left out here)";
    for (count, lines) in [(MAX_LINES, MAX_LINES), (MAX_LINES + 2, MAX_LINES + 1)] {
        let told = of(count);
        assert_eq!(told.len(), lines);
        assert_eq!(told.last().is_some_and(|l| l == left_out), count > MAX_LINES);
    }
}
