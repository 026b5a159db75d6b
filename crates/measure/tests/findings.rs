//! What `kane stability` must find in the paper's formulas. One test a finding.

use std::sync::OnceLock;

use kane_measure::{Examined, Fault, Range, Stability, examine};

fn paper() -> &'static Stability {
    static PAPER: OnceLock<Stability> = OnceLock::new();
    PAPER.get_or_init(|| {
        let text = include_bytes!("../../../docs/derivations/oblique-collision.md");
        let document = kane_audit::read("oblique-collision.md", text).expect("it is well formed");
        examine(&document, true, &mut |_, _| {})
    })
}

/// A formula by its label or that of a statement that prints the same, its text, and the statements
/// whose formulas it uses.
fn line(label: &str, text: &str, by: &[&str], format: &str) -> &'static Examined {
    let stability = paper();
    let found = stability.lines.iter().find(|line| {
        let formula = &stability.subject.formulas[line.formula];
        (formula.label == label || formula.also.iter().any(|also| also == label))
            && formula.text == text
            && formula.by == by
            && line.format == format
    });
    assert!(found.is_some(), "{label}: {text} with {by:?} in {format} was not examined");
    found.expect("it was found just now")
}

fn ranges(line: &Examined, fault: Fault) -> Vec<&Range> {
    line.ranges.iter().filter(|range| range.fault == fault).collect()
}

fn better(range: &Range) -> &'static str {
    let index = range.better.as_ref().expect("an equal formula is better").formula;
    &paper().subject.formulas[index].text
}

/// 2^exponent, subnormal or not: in two factors, so that neither over- nor underflows.
fn power(exponent: i32) -> f64 {
    let half = exponent / 2;
    f64::powi(2.0, half) * f64::powi(2.0, exponent - half)
}

#[test]
fn the_energy_by_k_squared_cancels_at_both_ends() {
    for (format, precision) in [("f32", 24_i32), ("f64", 53)] {
        let energy = line("(19)", "-1/(4*alpha)*(1 - k^2)", &["(16)"], format);
        let lost = ranges(energy, Fault::Lost);
        let [small, large] = lost.as_slice() else { panic!("two ends: {lost:?}") };
        for range in [small, large] {
            assert_eq!(range.cause, "1 - k^2 cancels");
            assert_eq!(better(range), "-(1/(1 + alpha))^2");
            assert!(
                range.lost > 100 * i64::from(precision - 2),
                "nothing is left at {:?}",
                range.worst
            );
        }
        // half of the digits go where α is about the square root of the unit roundoff, or beyond
        // its inverse
        assert!(
            small.to.value < power(-precision / 2 + 2) && small.from.value > power(-precision - 2)
        );
        assert!(large.from.value > power(precision / 2) && large.to.value < power(precision + 3));
        // and still further out 0 is returned
        let zero = ranges(energy, Fault::Vanishes);
        assert_eq!(zero.len(), 2);
        assert_eq!(zero[0].to.value, power(-precision - 1));
    }
}

#[test]
fn the_impulse_by_one_minus_k_cancels_for_small_alpha() {
    for (format, precision) in [("f32", 24_i32), ("f64", 53)] {
        let impulse = line("i_c", "(1 - k_a)/(2*alpha)", &[], format);
        let [lost] = ranges(impulse, Fault::Lost)[..] else { panic!("one range") };
        assert_eq!(lost.cause, "1 - k_a cancels");
        assert_eq!(better(lost), "1/(1 + alpha)");
        let zero = ranges(impulse, Fault::Vanishes);
        assert!(zero[0].open.0, "0 is returned from the least subnormal on");
        assert_eq!(zero[0].to.value, power(-precision - 1));
        // as printed in (9), with the quotient first
        let printed = line("(9)", "1/(2*alpha)*(1 - k)", &["(16)"], format);
        assert_eq!(ranges(printed, Fault::Lost)[0].cause, "1 - k cancels");
    }
}

#[test]
fn the_impulse_by_one_plus_k_cancels_for_large_alpha() {
    for (format, precision) in [("f32", 24_i32), ("f64", 53)] {
        for (label, text, by) in
            [("i_d", "(1 + k_a)/2", &[][..]), ("(15)", "1/2*(k + 1)", &["(16)"])]
        {
            let impulse = line(label, text, by, format);
            let [lost] = ranges(impulse, Fault::Lost)[..] else { panic!("one range") };
            assert!(lost.from.value >= power(precision / 2) && lost.cause.ends_with("cancels"));
            assert_eq!(better(lost), "1/(1 + alpha)");
            let [zero] = ranges(impulse, Fault::Vanishes)[..] else { panic!("one range") };
            assert!(zero.open.1, "to the greatest float");
            let first = zero.from.value;
            assert!(power(precision) <= first && first < power(precision + 1));
        }
    }
}

#[test]
fn two_over_one_plus_alpha_minus_one_loses_everything_at_one() {
    for (format, precision) in [("f32", 24_i32), ("f64", 53)] {
        let k = line("k_b", "2/(1 + alpha) - 1", &[], format);
        let [zero] = ranges(k, Fault::Vanishes)[..] else { panic!("one range") };
        let ulp = power(1 - precision);
        assert_eq!((zero.from.value, zero.to.value), (1.0 - ulp / 2.0, 1.0 + ulp));
        assert_eq!(zero.lost, i64::from(precision) * 100);
        assert_eq!(better(zero), "(1 - alpha)/(1 + alpha)");
        assert!(ranges(k, Fault::Lost).iter().any(|r| r.from.value < 1.0 && r.to.value > 1.0));
    }
}

#[test]
fn overflow_and_flush_to_zero_have_exact_edges() {
    for (format, greatest) in [("f32", 127), ("f64", 1023)] {
        // 2α overflows from the last binade on, where 1/(2α) is still a subnormal number
        let stop = line("i_R", "min(1, 1/(2*alpha))", &[], format);
        let [zero] = ranges(stop, Fault::Vanishes)[..] else { panic!("one range") };
        assert_eq!((zero.from.value, zero.open.1), (power(greatest), true));
        assert_eq!(zero.cause, "2*alpha overflows");
        // (1 + α)² overflows long before 1/(1 + α)² is 0
        let square = line("(19x)", "-1/(1 + alpha)^2", &[], format);
        let [zero] = ranges(square, Fault::Vanishes)[..] else { panic!("one range") };
        assert_eq!(zero.from.value, power((greatest + 1) / 2));
        assert_eq!(zero.cause, "(1 + alpha)^2 overflows");
        assert_eq!(better(zero), "-(1/(1 + alpha))^2");
        // k² overflows in Whittaker's energy by (19)
        let energy = line("(19e)", "-1/(4*alpha)*(1 - k^2)", &["(22)"], format);
        let [infinite] = ranges(energy, Fault::Infinite)[..] else { panic!("one range") };
        assert_eq!(infinite.from.value, power((greatest - 1) / 2));
        assert_eq!((infinite.cause.as_str(), better(infinite)), ("k^2 overflows", "alpha - 1"));
        // and the quotient that meets 0 gives NaN among the subnormal numbers
        let impulse = line("(9)", "1/(2*alpha)*(1 - k)", &["(16)"], format);
        let [nan] = ranges(impulse, Fault::Nan)[..] else { panic!("one range") };
        assert!(nan.open.0 && nan.to.value == power(-greatest - 2));
    }
}

#[test]
fn the_root_of_smith_s_law_fails_twice() {
    for (format, precision, greatest) in [("f32", 24, 127), ("f64", 53, 1023)] {
        let text = "cases { alpha >= 1/2: alpha - sqrt(alpha^2 + 2*alpha - 1) }";
        let root = line("s_c", text, &[], format);
        let lost = ranges(root, Fault::Lost);
        let [near, far] = lost.as_slice() else { panic!("two ranges: {lost:?}") };
        assert!(near.from.value > 0.5 && near.from.value < 0.5 + power(1 - precision));
        assert!(near.to.value < 0.51);
        assert!(far.from.value >= power(precision / 2 - 1));
        for range in [near, far] {
            assert_eq!(range.cause, "alpha - sqrt(alpha^2 + 2*alpha - 1) cancels");
            assert!(range.better.is_some());
        }
        let [infinite] = ranges(root, Fault::Infinite)[..] else { panic!("one range") };
        assert_eq!(infinite.from.value, power((greatest + 1) / 2));
        assert!(better(infinite).contains("(1/alpha - 2)"));
    }
}

#[test]
fn the_dimensional_chain_is_nan_without_slip() {
    for format in ["f32", "f64"] {
        let chain = line("v_1", "k_v*v_px0", &[], format);
        let [nan] = ranges(chain, Fault::Nan)[..] else { panic!("one range") };
        assert_eq!((nan.from.value, nan.computed.as_str(), nan.exact.as_str()), (0.0, "NaN", "0"));
        assert!(nan.cause.ends_with("divides by 0"), "{}", nan.cause);
        assert!(better(nan).starts_with("v_px0*("));
    }
}

#[test]
fn the_formulas_to_use_never_fail() {
    for (label, text) in [
        ("(16)", "(1 - alpha)/(1 + alpha)"),
        ("(17)", "1/(1 + alpha)"),
        ("e_a", "-(1/(1 + alpha))^2"),
    ] {
        for format in ["f32", "f64"] {
            let line = line(label, text, &[], format);
            assert!(line.ranges.is_empty() && line.worst.1 < 200, "{:?}", line.ranges);
        }
    }
}

/// An edge is exact: the float beyond it does not have the fault.
#[test]
fn the_float_beyond_an_edge_is_sound() {
    use kane_measure::{DyadicNumber, Plain, judge};
    let mut checked = 0;
    for line in paper().lines.iter().filter(|line| line.format == "f64") {
        let formula = &paper().subject.formulas[line.formula];
        for range in &line.ranges {
            let beyond = [
                (!range.open.0).then(|| range.from.value.next_down()),
                (!range.open.1).then(|| range.to.value.next_up()),
            ];
            for input in beyond.into_iter().flatten() {
                let wide = kane_measure::Dyadic { bits: 8000 };
                let exact = [DyadicNumber::of(input).unwrap()];
                if !formula.admits(&wide, &exact) {
                    continue;
                }
                let Some(exact) = formula.program.value(&wide, &exact) else { continue };
                let exact = if exact.certain_bits() > 0 { exact } else { DyadicNumber::zero() };
                let computed = formula.program.value(&Plain::<f64>::new(), &[input]);
                let fault = computed.and_then(|computed| judge(computed, &exact).fault);
                assert_ne!(fault, Some(range.fault), "{} at {input:e}", formula.text);
                checked += 1;
            }
        }
    }
    assert!(checked > 50, "{checked}");
}

fn of(text: &str) -> Stability {
    let text = format!("```kane\n{text}\n```\n");
    let document = kane_audit::read("own.md", text.as_bytes()).expect("it is well formed");
    examine(&document, false, &mut |_, _| {})
}

/// x² − 2 cancels at √2 and at −√2 alike; the root of 2 is no float, so nothing is left at the two
/// floats next to it.
#[test]
fn a_domain_that_reaches_below_zero_is_examined_on_both_sides() {
    let found = of("var x\nlet f := x*x - 2");
    let sides: Vec<bool> = found.lines.iter().map(|line| line.negative).collect();
    assert_eq!(sides, [false, false, true, true]);
    for (above, below) in found.lines.iter().zip(&found.lines[2..]) {
        let [up] = ranges(above, Fault::Lost)[..] else { panic!("one range: {:?}", above.ranges) };
        let [down] = ranges(below, Fault::Lost)[..] else {
            panic!("one range: {:?}", below.ranges)
        };
        assert!(up.from.value < 2.0_f64.sqrt() && 2.0_f64.sqrt() < up.to.value);
        // x ↦ −x is exact in floats, so the ranges are mirror images, in ascending order
        assert_eq!((down.from.value, down.to.value), (-up.to.value, -up.from.value));
        assert_eq!(
            (down.lost, &down.cause, down.worst.place),
            (up.lost, &up.cause, up.worst.place)
        );
        assert_eq!(below.domain.1.value.to_bits() >> 63, 1, "0 itself is on the other side");
    }
    // a range below 0 alone has no other side
    let below = of("var -3 <= x < -1\nlet f := x*x - 2");
    assert!(below.lines.iter().all(|line| line.negative) && below.lines.len() == 2);
    assert_eq!(below.lines[1].domain.0.value, -3.0);
    assert_eq!(below.lines[1].domain.1.value, (-1.0_f64).next_down());
}

/// Of √(x² + 1) − x digits are lost up to 1.3e8 in f64, and less is asked.
#[test]
fn a_range_ends_where_what_is_asked_ends() {
    let found = of("var -1000000 <= x <= 1000000\nlet f := sqrt(x^2 + 1) - x");
    for line in &found.lines {
        for range in &line.ranges {
            let ends = (range.from.value, range.to.value);
            assert!(line.domain.0.value <= ends.0 && ends.1 <= line.domain.1.value, "{range:?}");
            assert_eq!(range.open.1, range.to.value == 1e6, "{range:?}");
        }
    }
    let last = ranges(&found.lines[1], Fault::Lost);
    assert_eq!(last.last().map(|range| range.to.value), Some(1e6));
}

/// b² − 4·a·c is the textbook's example; the search must find inputs at which nothing is left, and
/// none at which a sum of squares fails otherwise than by the range of the format.
#[test]
fn three_inputs_are_searched_and_what_cancels_is_found() {
    let found = of("var a, b, c\nlet f := b^2 - 4*a*c\nlet s := a^2 + b^2 + c^2");
    assert!(found.lines.is_empty() && found.planes.is_empty());
    assert_eq!(found.searches.len(), 4, "two formulas in two formats");
    for search in &found.searches {
        assert!(search.tried > 3_000);
        let lost = search.faults.iter().find(|(fault, ..)| *fault == Fault::Lost);
        if search.formula == 0 {
            let (_, count, example) = lost.expect("a difference of products cancels");
            let [a, b, c] = example.as_slice() else { panic!("three inputs") };
            assert!(*count > 10 && a.value * c.value > 0.0, "{example:?}");
            // 4ac is within a factor of b², or nothing would cancel
            let ratio = 4.0 * a.value * c.value / (b.value * b.value);
            assert!((0.9..1.1).contains(&ratio), "{example:?}");
            assert!(search.worst.1 >= 100 * i64::from(search.precision - 3));
        } else {
            assert!(lost.is_none(), "nothing cancels in a sum of squares: {lost:?}");
        }
    }
}

#[test]
fn two_inputs_of_which_one_may_be_negative_have_a_plane_and_a_search() {
    let found = of("var x, y > 0\nlet f := x + y");
    assert_eq!((found.planes.len(), found.searches.len()), (2, 2));
    let negative = of("var x < 0, y > 0\nlet f := x + y");
    assert_eq!((negative.planes.len(), negative.searches.len()), (0, 2));
}

#[test]
fn what_is_not_examined_is_listed_with_its_reason() {
    let found = of("var x > 0\nlet f := x + 1\nlet g := d(x^2, x) + 1");
    let left_out = &found.subject.left_out;
    assert_eq!(left_out.as_slice(), [("g".to_owned(), "it has a derivative".to_owned())]);
    assert_eq!(found.subject.examined, 1);
}

#[test]
fn an_exponential_and_a_sine_are_no_inputs() {
    let found = of("var x, theta\nlet f := exp(x) - 1\nlet g := 1 - cos(theta)\nlet h := x + 1");
    let why = |of: &str| format!("{of} is no input: how it is rounded itself is not known here");
    let left_out = [("f", "exp(x)"), ("g", "cos(theta)")];
    let left_out = left_out.map(|(label, of)| (label.to_owned(), why(of)));
    assert_eq!(found.subject.left_out.as_slice(), left_out);
    assert_eq!(found.subject.examined, 1);
}
