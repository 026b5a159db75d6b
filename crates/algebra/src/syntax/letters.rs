//! Letters of names: Latin, Greek with their names, digits below the line.

/// Greek letters with their names; the first character listed for a name is its usual form.
pub(crate) const GREEK: [(&str, &str); 36] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "εϵ"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θϑ"),
    ("iota", "ι"),
    ("kappa", "κϰ"),
    ("lambda", "λ"),
    ("mu", "μ\u{b5}"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "πϖ"),
    ("rho", "ρϱ"),
    ("sigma", "σς"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φϕ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ\u{2206}"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Upsilon", "Υ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω\u{2126}"),
    // letters without a LaTeX command of their own are left out on purpose,
    // except omicron, which authors use for a little o
    ("omicron", "ο"),
    ("Omicron", "Ο"),
];

/// The name of a Greek letter.
pub(crate) fn greek_name(letter: char) -> Option<&'static str> {
    if letter.is_ascii() {
        return None;
    }
    GREEK.iter().find(|(_, letters)| letters.contains(letter)).map(|(name, _)| *name)
}

/// The letter that a spelled-out name stands for: α for `alpha`.
#[must_use]
pub fn greek_letter(name: &str) -> Option<char> {
    GREEK.iter().find(|(known, _)| *known == name).and_then(|(_, letters)| letters.chars().next())
}

/// The digit that a subscript digit stands for.
pub(crate) fn subscript_digit(c: char) -> Option<char> {
    let digit = u32::from(c).checked_sub(u32::from('₀'))?;
    char::from_digit(digit, 10)
}

pub(crate) fn is_name_start(c: char) -> bool {
    c.is_ascii_alphabetic() || greek_name(c).is_some()
}

pub(crate) fn is_name_part(c: char) -> bool {
    c.is_ascii_alphanumeric()
        || matches!(c, '_' | '\'' | '′')
        || (!c.is_ascii() && (greek_name(c).is_some() || subscript_digit(c).is_some()))
}
