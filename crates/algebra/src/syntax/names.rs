//! Names: which are allowed, which are the same, and how they are set in LaTeX.

use std::borrow::Cow;

use super::letters::{GREEK, greek_letter, greek_name, subscript_digit};
use super::lexer::{self, Token};

/// Words that can be neither names nor labels.
pub const RESERVED: [&str; 22] = [
    "oo",
    "d",
    "abs",
    "min",
    "max",
    "sqrt",
    "cases",
    "else",
    "from",
    "when",
    "as",
    "by",
    "using",
    "expect",
    "not",
    "implied",
    "contradiction",
    "and",
    "or",
    "implies",
    "iff",
    "exists",
];

/// Names that nothing can be defined by: whoever reads them knows what they mean.
pub(crate) const MATHEMATICAL: [&str; 6] = ["sin", "cos", "tan", "exp", "log", "pi"];

/// The words between formulas.
pub(crate) const CONNECTIVES: [&str; 4] = ["and", "or", "implies", "iff"];

/// Stands for π while an angle is read; no context has as many symbols.
pub(crate) const PI: usize = usize::MAX;

/// The spelling under which a name is known: Greek letters spelled out, plain primes and digits.
///
/// Two names with one canonical form are the same name: `μ'` and `mu'`, `v₀` and `v0`.
#[must_use]
pub fn canonical_name(name: &str) -> Cow<'_, str> {
    if name.is_ascii() {
        return Cow::Borrowed(name);
    }
    let mut spelled = String::with_capacity(name.len() + 8);
    for c in name.chars() {
        match (greek_name(c), subscript_digit(c)) {
            (Some(letter), _) => spelled.push_str(letter),
            (_, Some(digit)) => spelled.push(digit),
            _ if c == '′' => spelled.push('\''),
            _ => spelled.push(c),
        }
    }
    Cow::Owned(spelled)
}

/// A name in LaTeX: `vx0` is `v_{x0}`, `v_px0` is `v_{px0}`, `mu'` is `\mu'`, `DeltaE` is
/// `\Delta E`, `dE` is `dE`, and a word such as `slip` is `\mathrm{slip}`.
///
/// What follows an underscore is always a subscript. Without one, what follows the first letter
/// is, unless it is a word of three or more small letters, which is set upright as a whole.
#[must_use]
pub fn latex_name(name: &str) -> String {
    if let Some((function, time, order)) = rates(name) {
        let (function, time) = (latex_name(function), latex_name(time));
        let power = if order > 1 { format!("^{order}") } else { String::new() };
        return format!("\\frac{{d{power} {function}}}{{d {time}{power}}}");
    }
    if let Some((base, index)) = power(name) {
        let base = if base.starts_with(|c: char| c.is_ascii_digit()) {
            base.to_owned()
        } else {
            latex_name(base)
        };
        return format!("\\left({base}^{{{}}}\\right)", latex_name(index));
    }
    if let Some(sum) = summed(name) {
        let sign = if sum.product { "prod" } else { "sum" };
        let index = (latex_name(sum.over), sum.from, latex_tokens(sum.to), latex_tokens(sum.term));
        return format!(
            "\\left(\\{sign}_{{{}={}}}^{{{}}} {}\\right)",
            index.0, index.1, index.2, index.3
        );
    }
    if let Some((function, argument)) = applied(name) {
        if !["cos", "sin", "exp", "log"].contains(&function) {
            return format!("{}({})", latex_name(function), latex_name(argument));
        }
        let argument = of_argument(argument, [" ", "/"], |factor| match factor.split_once('^') {
            Some((name, n)) => format!("{}^{{{n}}}", latex_name(name)),
            None if factor.starts_with(|c: char| c.is_ascii_digit()) => factor.to_owned(),
            None => latex_name(factor),
        });
        return format!("\\{function}({argument})");
    }
    let canonical = canonical_name(name);
    let primes: String = canonical.chars().filter(|c| *c == '\'').collect();
    let (base, subscripts) = name_parts(&canonical);
    let mut out = String::new();
    for part in &base {
        match split_greek(part) {
            Some((letter, "")) if letter == "Delta" && base.len() > 1 => {
                out.push_str(&latex_letter(letter));
                out.push(' ');
            }
            Some((letter, "")) => out.push_str(&latex_letter(letter)),
            _ if part.len() > 1 => out.push_str(&format!("\\mathrm{{{part}}}")),
            _ => out.push_str(part),
        }
    }
    let subscripts: Vec<String> = subscripts.iter().map(|part| latex_subscript(part)).collect();
    let sub = subscripts.join(",");
    if sub.chars().count() == 1 {
        out.push('_');
        out.push_str(&sub);
    } else if !sub.is_empty() {
        out.push_str("_{");
        out.push_str(&sub);
        out.push('}');
    }
    out + &primes
}

/// `d(x, t)` as `x` and `t`; nothing if it is no derivative.
pub(crate) fn rate(name: &str) -> Option<(&str, &str)> {
    name.strip_prefix("d(")?.strip_suffix(')')?.rsplit_once(", ")
}

/// `d(d(x, t), t)` as `x`, `t` and how often it is differentiated; nothing if it is no derivative.
pub(crate) fn rates(name: &str) -> Option<(&str, &str, usize)> {
    let (mut function, time) = rate(name)?;
    let mut order = 1;
    while let Some((inner, _)) = rate(function).filter(|(_, by)| *by == time) {
        (function, order) = (inner, order + 1);
    }
    Some((function, time, order))
}

/// `pow(e, n)` as `e` and `n`; nothing if it is no power.
pub(crate) fn power(name: &str) -> Option<(&str, &str)> {
    name.strip_prefix("pow(")?.strip_suffix(')')?.rsplit_once(", ")
}

/// A name such as `sum(k^2 for k in 1..n)`, taken apart.
pub(crate) struct Summed<'a> {
    pub(crate) product: bool,
    pub(crate) term: &'a str,
    pub(crate) over: &'a str,
    pub(crate) from: &'a str,
    pub(crate) to: &'a str,
}

/// `sum(k^2 for k in 1..n)` in its parts; nothing if it is no sum.
pub(crate) fn summed(name: &str) -> Option<Summed<'_>> {
    let (word, inside) = name.strip_suffix(')')?.split_once('(')?;
    let product = word == "prod";
    let (term, range) = inside.rsplit_once(" for ").filter(|_| product || word == "sum")?;
    let (over, ends) = range.split_once(" in ")?;
    let (from, to) = ends.split_once("..")?;
    Some(Summed { product, term, over, from, to })
}

/// The text of an expression, sign by sign.
fn latex_tokens(text: &str) -> String {
    let mut out = String::new();
    let mut at = 0;
    loop {
        let (token, span) = lexer::next(text, at);
        at = span.end;
        let lexeme = text.get(span).unwrap_or_default();
        match token {
            Token::End => return out,
            Token::Name => out.push_str(&latex_name(lexeme)),
            Token::Star => out.push_str("\\,"),
            Token::Caret => {
                let (end, exponent) = exponent(text, at);
                out.push_str(&format!("^{{{}}}", latex_tokens(exponent)));
                at = end;
            }
            _ => out.push_str(lexeme),
        }
    }
}

/// What stands behind `^`, one token or what is between parentheses, and where it ends.
pub(crate) fn exponent(text: &str, at: usize) -> (usize, &str) {
    let (mut token, first) = lexer::next(text, at);
    if token != Token::OpenParen {
        return (first.end, text.get(first).unwrap_or_default());
    }
    let (mut depth, mut end) = (1_usize, first.end);
    while token != Token::End {
        let span;
        (token, span) = lexer::next(text, end);
        match token {
            Token::OpenParen => depth += 1,
            Token::CloseParen => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (span.end, text.get(first.end..span.start).unwrap_or_default());
        }
        end = span.end;
    }
    (text.len(), text.get(first.end..).unwrap_or_default())
}

/// `cos(theta/2)` as `cos` and `theta/2`; nothing if it is a plain name.
pub(crate) fn applied(name: &str) -> Option<(&str, &str)> {
    name.strip_suffix(')')?.split_once('(')
}

/// The argument of an exponential or a sine, `c*t/m/2`, with each factor as it is set, and these signs of
/// multiplication and division.
pub(crate) fn of_argument(
    argument: &str,
    [times, over]: [&str; 2],
    factor: impl Fn(&str) -> String,
) -> String {
    let product = |text: &str| text.split('*').map(&factor).collect::<Vec<_>>().join(times);
    argument.split('/').map(product).collect::<Vec<_>>().join(over)
}

/// A canonical name taken apart: the letters or the word that carry it, and its subscripts.
pub(crate) fn name_parts(canonical: &str) -> (Vec<String>, Vec<String>) {
    let bare: String = canonical.chars().filter(|c| *c != '\'').collect();
    let (head, tail) = bare.split_once('_').unwrap_or((&bare, ""));
    let (mut base, mut rest) = (Vec::new(), head);
    // a difference is one of the letter behind it
    while let Some(letter) = rest.strip_prefix("Delta").filter(|letter| !letter.is_empty()) {
        base.push("Delta".to_owned());
        rest = letter;
    }
    while let Some(letter) =
        rest.strip_prefix('d').filter(|letter| letter.starts_with(|c: char| c.is_ascii_uppercase()))
    {
        base.push("d".to_owned());
        rest = letter;
    }
    let small_letters = rest.chars().skip(1).take_while(char::is_ascii_lowercase).count();
    let end = match split_greek(rest) {
        Some((letter, _)) => letter.len(),
        None if small_letters >= 3 => small_letters + 1,
        None => rest.len().min(1),
    };
    let (letter, own) = rest.split_at(end);
    base.push(letter.to_owned());
    let subscripts = std::iter::once(own).chain(tail.split('_')).filter(|part| !part.is_empty());
    (base, subscripts.map(str::to_owned).collect())
}

/// The letter that a subscript is or begins with, if it is spelled out, and the rest.
pub(crate) fn greek_subscript(text: &str) -> Option<(char, &str)> {
    let (letter, rest) = split_greek(text)?;
    let is_word = rest.starts_with(|c: char| c.is_ascii_lowercase());
    greek_letter(letter).filter(|_| !is_word).map(|letter| (letter, rest))
}

/// The longest Greek name at the start of `text`, and the rest.
fn split_greek(text: &str) -> Option<(&'static str, &str)> {
    GREEK
        .iter()
        .filter_map(|(name, _)| Some((*name, text.strip_prefix(name)?)))
        .max_by_key(|(name, _)| name.len())
}

fn latex_letter(name: &str) -> String {
    match name {
        // the only Greek letters that LaTeX writes as Latin ones
        "omicron" => "o".to_owned(),
        "Omicron" => "O".to_owned(),
        _ => format!("\\{name}"),
    }
}

fn latex_subscript(text: &str) -> String {
    match split_greek(text) {
        Some((letter, "")) => latex_letter(letter),
        Some((letter, rest)) if !rest.starts_with(|c: char| c.is_ascii_lowercase()) => {
            format!("{} {rest}", latex_letter(letter))
        }
        _ => text.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greek_letters_equal_their_names() {
        assert_eq!(canonical_name("μ'"), "mu'");
        assert_eq!(canonical_name("µ′"), "mu'");
        assert_eq!(canonical_name("Δe"), "Deltae");
        assert_eq!(canonical_name("v₀"), "v0");
    }

    #[test]
    fn a_spelled_out_name_gives_its_letter() {
        assert_eq!(greek_letter("mu"), Some('μ'));
        assert_eq!(greek_letter("Omega"), Some('Ω'));
        assert_eq!(greek_letter("me"), None);
    }

    #[test]
    fn names_read_well_in_latex() {
        for (name, latex) in [
            ("m", "m"),
            ("vx0", "v_{x0}"),
            ("v_px0", "v_{px0}"),
            ("vpx0", "v_{px0}"),
            ("w0", "w_0"),
            ("Ix", "I_x"),
            ("kW", "k_W"),
            ("mu", "\\mu"),
            ("μ", "\\mu"),
            ("mu'", "\\mu'"),
            ("v_x'", "v_x'"),
            ("v'_x", "v_x'"),
            ("mu_0", "\\mu_0"),
            ("DeltaE", "\\Delta E"),
            ("ΔEx", "\\Delta E_x"),
            ("dE", "dE"),
            ("dE_n", "dE_n"),
            ("slip", "\\mathrm{slip}"),
            ("k_alpha", "k_{\\alpha}"),
            ("a_b_c", "a_{b,c}"),
            ("eta", "\\eta"),
            ("omicron", "o"),
            ("kWSL", "k_{WSL}"),
            ("d(x_1, t)", "\\frac{d x_1}{d t}"),
            ("d(d(x, t), t)", "\\frac{d^2 x}{d t^2}"),
            ("cos(theta)", "\\cos(\\theta)"),
            ("sin(θ_1/2)", "\\sin(\\theta_1/2)"),
            ("pow(e, n)", "\\left(e^{n}\\right)"),
            ("pow(2, n)", "\\left(2^{n}\\right)"),
            ("s_1(n)", "s_1(n)"),
        ] {
            assert_eq!(latex_name(name), latex, "name {name}");
        }
    }
}
