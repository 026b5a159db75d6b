//! What the literature prints, and what it measured, against the laws.
//!
//! Each test cites its source. Where an original could not be consulted, the test says through whom
//! it is known; nothing here is evidence about an original that nobody has read.

use kane::impact::{Alpha, Law, law};
use kane::number::{Algebraic, Number, Rational, decode, parse};

mod compliant; // what every compliant process is held to
mod experiment; // measured points, and how far each law is from them
mod granular; // a reference case of granular mechanics
mod hertz_mindlin; // increments as in codes of granular mechanics
mod kane_table; // Kane's double pendulum under eight laws
mod maw; // the elastic half-space
mod numbers; // single values
mod smith_cubic; // Smith's law on a contact that couples
mod sphere_table; // k(α) of the sphere
mod stronge_bilinear; // two springs

/// A decimal as printed, exactly.
fn exact(printed: &str) -> Rational {
    parse(printed).unwrap_or_else(|error| unreachable!("{printed}: {error}"))
}

fn magnitude(number: Rational) -> Rational {
    if number < Rational::zero() { -number } else { number }
}

/// Whether a value rounds to what is printed: within half a unit of the last printed digit, both
/// neighbours allowed at a tie. An integer is taken to be meant exactly.
fn rounds_to(value: impl Into<Algebraic>, printed: &str) -> bool {
    let places = printed.split_once('.').map_or(0, |(_, digits)| digits.len());
    let (value, printed) = (value.into(), exact(printed));
    if places == 0 {
        return value == printed.into();
    }
    let half = (0..places).fold(exact("1/2"), |unit, _| unit / Rational::from_integer(10.into()));
    let (lower, upper) = (Algebraic::from(&printed - &half), Algebraic::from(printed + half));
    lower <= value && value <= upper
}

/// The same of a float, whose own error of a few ulp is far below any printed digit.
#[track_caller]
fn assert_printed(what: &str, value: f64, printed: &str) {
    let exact = decode(value).unwrap_or_else(|error| unreachable!("{what}: {error}"));
    assert!(rounds_to(exact, printed), "{what}: {value} is printed as {printed}");
}

/// k and i_x at a rational α, exactly.
fn ratios(law: &Law, alpha: &Rational) -> Option<[Algebraic; 2]> {
    let ratios = law.over().ratios(&Alpha::Finite(Algebraic::from(alpha.clone())))?;
    Some([ratios.k, ratios.impulse])
}

/// The value of k at α by the law of that id, with its default parameters.
fn k_by_id(id: &str, alpha: &Rational) -> Option<Algebraic> {
    let law = law(id).unwrap_or_else(|| unreachable!("there is no law {id}"));
    ratios(law, alpha).map(|[k, _]| k)
}
