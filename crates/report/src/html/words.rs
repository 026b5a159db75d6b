//! Sentences and names in HTML.

use kane_algebra::syntax::{greek_letter, latex_name};
use maud::{Markup, PreEscaped, Render as _, html};

use crate::typeset::{Names, Piece};

/// The sentence with its names and operators set as mathematics.
pub(crate) fn sentence(text: &str, names: &Names<'_>) -> Markup {
    let mut out = String::new();
    for piece in names.pieces(text) {
        match piece {
            Piece::Text(text) => text.render_to(&mut out),
            Piece::Name(written) => name(written).render_to(&mut out),
            Piece::Operator(operator) => sign(operator).render_to(&mut out),
            Piece::Power(digits) => out.extend(digits.chars().map(raised)),
        }
    }
    // a product of letters is slanted as a whole; of a long proof that is a tenth
    PreEscaped(out.replace("</i>·<i>", "·"))
}

/// A digit of an exponent. As a letter of its own it is a sixth as long as with tags around it.
fn raised(digit: char) -> char {
    let place = digit.to_digit(10).and_then(|digit| usize::try_from(digit).ok());
    place.and_then(|place| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(place)).unwrap_or(digit)
}

fn sign(operator: &str) -> &str {
    match operator {
        "*" => "·",
        "-" => "−",
        "<=" => "≤",
        ">=" => "≥",
        "!=" => "≠",
        "->" => "→",
        "oo" => "∞",
        other => other,
    }
}

/// A declared name: `v_x0'` with its subscript and prime, slanted.
fn name(name: &str) -> Markup {
    let latex = latex_name(name);
    let upright = latex.starts_with("\\mathrm");
    let (base, index) = latex.split_once('_').unwrap_or((&latex, ""));
    let primes: String = latex.chars().filter(|c| *c == '\'').map(|_| '′').collect();
    let (base, index) = (letters(base), letters(index));
    html! {
        @if upright { (base) } @else { i { (base) } }
        @if !index.is_empty() { sub { (index) } }
        (primes)
    }
}

/// What a piece of LaTeX made by `latex_name` shows, without its commands, braces and primes.
fn letters(latex: &str) -> String {
    let mut out = String::new();
    let mut rest = latex;
    while let Some(first) = rest.chars().next() {
        rest = &rest[first.len_utf8()..];
        match first {
            '\\' => {
                let end = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
                out.extend(greek_letter(&rest[..end]));
                rest = rest[end..].trim_start();
            }
            '{' | '}' | '\'' => {}
            other => out.push(other),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use crate::typeset::Names;

    use super::{name, sentence};

    #[test]
    fn products_and_powers_are_set_as_one() {
        let set = sentence("2*x*y^12*z = -x^2", &Names::default()).into_string();
        assert_eq!(set, "2·<i>x·y</i>¹²·<i>z</i> = −<i>x</i>²");
    }

    #[test]
    fn names_have_their_letters_and_subscripts() {
        for (written, shown) in [
            ("v_px0", "<i>v</i><sub>px0</sub>"),
            ("mu'", "<i>μ</i>′"),
            ("Delta_e", "<i>Δ</i><sub>e</sub>"),
            ("k_alpha", "<i>k</i><sub>α</sub>"),
            ("slip", "slip"),
            ("m", "<i>m</i>"),
        ] {
            assert_eq!(name(written).into_string(), shown);
        }
    }
}
