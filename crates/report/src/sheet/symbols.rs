//! Names of programs in sentences for people: symbols as in print, quantities in words, minus signs.

use kane_algebra::syntax::mathml_name;
use kane_scene::Quantity;
use maud::{Markup, PreEscaped, html};

/// Greek letters that formulas of reports have, as they are typed.
const GREEK: [&str; 10] =
    ["alpha", "beta", "gamma", "eta", "theta", "mu", "phi", "psi", "omega", "Delta"];

/// Text with its symbols as formulas: `W_tn`, `alpha`; and quantities of scenes without their units: `omega_rad_s`.
pub(super) fn typeset(text: &str) -> Markup {
    // what stands between backticks is what a file says
    let pieces = text.split('`');
    if pieces.clone().count().is_multiple_of(2) {
        return set(text, &name);
    }
    html! {
        @for (number, piece) in pieces.enumerate() {
            @if number % 2 == 1 { code { (piece) } } @else { (set(piece, &name)) }
        }
    }
}

/// The head of a column, with its symbols in italics: to those who hear a page, a head of MathML alone is empty.
pub(super) fn heading(text: &str) -> Markup {
    const PLAIN: [(&str, &str); 6] = [
        ("<math><msub><mi>", "<i>"),
        ("<math><mi>", "<i>"),
        ("</mi></math>", "</i>"),
        ("</mi></msub></math>", "</sub>"),
        ("</mn></msub></math>", "</sub>"),
        ("</mi><m", "</i><sub><m"),
    ];
    let mut set = typeset(text).into_string();
    for (math, plain) in PLAIN {
        set = set.replace(math, plain);
    }
    PreEscaped(set.replace("<sub><mi>", "<sub>").replace("<sub><mn>", "<sub>"))
}

/// A formula as it is typed, `1 - 2*alpha/(1 + alpha)`, as in print: letters alone are symbols in it.
pub(super) fn formula(text: &str) -> Markup {
    let text = text.replace(" - ", " − ").replace("(-", "(−");
    let text = text.strip_prefix('-').map_or(text.clone(), |rest| format!("−{rest}"));
    set(&text, &|piece| name(piece).or_else(|| symbol(piece)))
}

/// What names a piece of text, or nothing where it is a word.
type Naming<'n> = &'n dyn Fn(&str) -> Option<Markup>;

fn set(text: &str, name: Naming<'_>) -> Markup {
    let Some((base, behind)) = text.split_once('^') else { return flat(text, name) };
    let (power, rest) = behind.split_at(exponent(behind));
    if power.is_empty() {
        return flat(text, name);
    }
    let bare = power.strip_prefix('(').and_then(|power| power.strip_suffix(')')).unwrap_or(power);
    html! { (flat(base, name)) sup { (set(bare, name)) } (set(rest, name)) }
}

/// How long the exponent is that a text begins with: a number or a name, or what is in parentheses.
fn exponent(text: &str) -> usize {
    if text.starts_with('(') {
        let mut depth = 0;
        let closes = |c: char| {
            depth += i32::from(c == '(') - i32::from(c == ')');
            depth == 0
        };
        return text.find(closes).map_or(0, |end| end + 1);
    }
    let unsigned = text.strip_prefix('-').unwrap_or(text);
    let inside = |c: char| c.is_ascii_alphanumeric() || c == '.';
    let run = &unsigned[..unsigned.find(|c| !inside(c)).unwrap_or(unsigned.len())];
    let run = run.trim_end_matches('.');
    if run.is_empty() { 0 } else { text.len() - unsigned.len() + run.len() }
}

fn flat(text: &str, name: Naming<'_>) -> Markup {
    let is_inside = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut pieces = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let end = rest.find(|c| is_inside(c) != is_inside(first)).unwrap_or(rest.len());
        let (piece, after) = rest.split_at(end);
        let before = text.len() - rest.len();
        pieces.push(if is_inside(first) {
            name(piece).unwrap_or_else(|| html! { (piece) })
        } else {
            html! { (operators(&signs(piece, before == 0, after))) }
        });
        rest = after;
    }
    html! { @for piece in &pieces { (piece) } }
}

/// Comparisons as in print, and a point for a star between factors.
fn operators(between: &str) -> String {
    let mut out = between.to_owned();
    for (typed, sign) in [("<=", "≤"), (">=", "≥"), ("!=", "≠"), ("->", "→")] {
        out = out.replace(typed, sign);
    }
    let joins = |star: usize| !out[..star].ends_with(' ') && !out[star + 1..].starts_with(' ');
    match out.find('*') {
        Some(star) if joins(star) && (between.len() > 1 || between == "*") => {
            out.replacen('*', "·", 1)
        }
        _ => out,
    }
}

/// A name of a program as people write it; nothing if it is a word.
pub(super) fn name(name: &str) -> Option<Markup> {
    if let Some(quantity) = Quantity::parse(name).ok().filter(|_| name.contains('_')) {
        let (stem, body) = name.rsplit_once("_of_").unwrap_or((name, ""));
        let unit = quantity.unit().to_lowercase().replace(['/', '·'], "_");
        let stem = stem.strip_suffix(&format!("_{unit}")).unwrap_or(stem);
        let said = symbol(stem).unwrap_or_else(|| html! { (stem.replace('_', " ")) });
        return Some(html! { (said) @if !body.is_empty() { " of body " (body) } });
    }
    (name.contains('_') || GREEK.contains(&name)).then(|| symbol(name)).flatten()
}

/// A letter, with an index or without.
fn symbol(name: &str) -> Option<Markup> {
    let (letter, index) = name.split_once('_').unwrap_or((name, ""));
    let is_letter = letter.len() == 1 && letter.starts_with(|c: char| c.is_ascii_alphabetic());
    let is_index = index.len() <= 3 && !index.contains('_');
    let is_symbol = (is_letter || GREEK.contains(&letter)) && is_index && !name.ends_with('_');
    is_symbol.then(|| html! { math { (PreEscaped(mathml_name(name))) } })
}

/// A hyphen before a number and behind nothing that it could join is a minus.
fn signs(between: &str, is_first: bool, after: &str) -> String {
    let is_minus = after.starts_with(|c: char| c.is_ascii_digit())
        && match between.strip_suffix('-') {
            Some("") => is_first,
            Some(before) => before.ends_with([' ', '(', '[', '=', '|']),
            None => false,
        };
    match between.strip_suffix('-').filter(|_| is_minus) {
        Some(before) => format!("{before}−"),
        None => between.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(text: &str) -> String {
        typeset(text).into_string()
    }

    #[test]
    fn symbols_are_set_and_words_stay() {
        let w = "<math><msub><mi>W</mi><mi>tn</mi></msub></math>";
        assert_eq!(set("couple (W_tn = 0)"), format!("couple ({w} = 0)"));
        assert_eq!(set("|alpha| = 0.5"), "|<math><mi>α</mi></math>| = 0.5");
        for words in ["a law of k", "smith-1991", "two_spheres.toml", "x_", "<b>", "2-3"] {
            assert_eq!(set(words), words.replace('<', "&lt;").replace('>', "&gt;"));
        }
    }

    #[test]
    fn symbols_of_a_heading_are_text() {
        let head = |text: &str| heading(text).into_string();
        assert_eq!(head("i_x"), "<i>i</i><sub>x</sub>");
        assert_eq!(head("v_1 and omega"), "<i>v</i><sub>1</sub> and <i>ω</i>");
        assert_eq!(head("plain words"), "plain words");
    }

    #[test]
    fn formulas_have_exponents_and_signs_as_in_print() {
        let form =
            |text: &str| formula(text).into_string().replace("<math>", "").replace("</math>", "");
        assert_eq!(form("1 - 2*a/(1 + a)^2"), "1 − 2·<mi>a</mi>/(1 + <mi>a</mi>)<sup>2</sup>");
        assert_eq!(form("x^(n - 1) >= 0"), "<mi>x</mi><sup><mi>n</mi> − 1</sup> ≥ 0");
        assert_eq!(set("2^-149 or 10^6."), "2<sup>−149</sup> or 10<sup>6</sup>.");
        assert_eq!(set("* nothing is better; <= 1"), "* nothing is better; ≤ 1");
        assert_eq!(set("x^ and (y^"), "x^ and (y^");
        assert_eq!(set("its `loss_x`."), "its <code>loss_x</code>.");
    }

    #[test]
    fn quantities_have_no_units_in_their_names() {
        assert_eq!(set("omega_rad_s is off"), "<math><mi>ω</mi></math> is off");
        assert_eq!(set("kinetic_energy_j"), "kinetic energy");
        let v = "<math><msub><mi>v</mi><mi>x</mi></msub></math>";
        assert_eq!(set("v_x_m_s_of_2"), format!("{v} of body 2"));
    }

    #[test]
    fn a_hyphen_before_a_number_is_a_minus() {
        assert_eq!(set("-100/7"), "−100/7");
        assert_eq!(set("from -1 to (-2), 1e-9 and 3-4"), "from −1 to (−2), 1e-9 and 3-4");
    }
}
