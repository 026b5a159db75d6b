//! k, i_x and Δe over α: what the laws say exactly, in `f64`, and how far the two are apart.

use std::fmt::Write as _;

use kane_impact::{Alpha, Ratios, law};
use kane_number::{Rational, decode, error_in_ulps};

/// Limits, the landmarks of the paper's figures, and the worst case of k in floats.
fn alphas() -> [f64; 13] {
    [
        0.0,
        f64::from_bits(1),
        2.0_f64.powi(-53),
        0.1,
        0.25,
        1.0 / 3.0,
        0.5,
        1.0,
        2.0,
        3.5,
        1e6,
        10_293_942_005_418_274.0, // just below 2^56/7, see tests/properties/agreement.rs
        f64::MAX,
    ]
}

#[test]
fn the_paper_s_law_over_alpha() {
    crate::settings().bind(|| insta::assert_snapshot!("wang-su-li", table("wang-su-li")));
}

#[test]
fn whittaker_s_law_over_alpha() {
    crate::settings()
        .bind(|| insta::assert_snapshot!("whittaker-uncapped", table("whittaker-uncapped")));
}

fn table(id: &str) -> String {
    let law = law(id).expect("it is known");
    let mut table = format!(
        "{}: {}\nα is the float shown; the fractions are exact for it\n",
        law.info.id, law.info.statement
    );
    for alpha in alphas() {
        let exact = Alpha::Finite(decode(alpha).expect("a finite α"));
        let exact = law.over().ratios(&exact).expect("finite α");
        let float = law.over().ratios(&Alpha::new(alpha).expect("α ≥ 0")).expect("finite α");
        row(&mut table, &format!("α = {alpha:?}"), &float, Some(&exact));
    }
    if let Some(limit) = law.over::<f64>().ratios(&Alpha::Infinite) {
        row(&mut table, "α = ∞", &limit, None);
    }
    table
}

fn row(table: &mut String, alpha: &str, float: &Ratios<f64>, exact: Option<&Ratios<Rational>>) {
    writeln!(table, "\n{alpha}").expect("a string takes all");
    let exact = |part: fn(&Ratios<Rational>) -> &Rational| exact.map(part);
    for (name, float, exact) in [
        ("k  ", float.k, exact(|ratios| &ratios.k)),
        ("i_x", float.impulse, exact(|ratios| &ratios.impulse)),
        ("Δe ", float.energy, exact(|ratios| &ratios.energy)),
    ] {
        let truth = exact.map_or_else(|| format!("{float}"), fraction);
        let error = exact.map_or_else(|| "0".into(), |exact| ulps(float, exact));
        writeln!(table, "  {name} = {truth:<37} f64 {float:<25?} error {error} ulp")
            .expect("a string takes all");
    }
}

/// The exact fraction, or only its size where it has too many digits to read.
fn fraction(exact: &Rational) -> String {
    let text = exact.to_string();
    if text.len() <= 37 {
        return text;
    }
    let bits = |n: &kane_number::Integer| n.bits();
    format!("({} bits)/({} bits)", bits(exact.numer()), bits(exact.denom()))
}

/// The error in ulps to three decimals, rounded towards zero by integer arithmetic.
fn ulps(float: f64, exact: &Rational) -> String {
    let Ok(error) = error_in_ulps(float, exact) else {
        return "an overflow, no finite number of".into();
    };
    let thousandths = (&error * Rational::from_integer(1000.into())).to_integer();
    match i32::try_from(thousandths) {
        Ok(0) if *error.numer() == 0.into() => "0".into(),
        Ok(0) => "below 0.001".into(),
        Ok(thousandths) => format!("{:+.3}", f64::from(thousandths) / 1000.0),
        Err(_) => "more than a million".into(),
    }
}
