//! What plain TeX and careful hands write: `{a \over b}`, and empty groups, `\cdot{}`.

use crate::token::Token;

/// Whether an empty group begins here that carries no index and no power: it is printed as nothing.
pub(crate) fn is_empty_group(all: &[Token]) -> bool {
    match all {
        [Token::Open, Token::Close, rest @ ..] => {
            !matches!(rest.first(), Some(Token::Superscript | Token::Subscript | Token::Char('\'')))
        }
        _ => false,
    }
}

/// A group or an environment that is open.
struct Inside {
    is_group: bool,
    /// where it begins
    start: usize,
    /// its one `\over`
    over: Option<usize>,
    /// what has no place in a fraction, or a second `\over`
    spoiled: bool,
}

/// Groups `{a \over b}` as `{\frac{a}{b}}`. An `\over` outside of braces stays: what it divides depends on what
/// stands around the formula.
pub(crate) fn fractions(all: &[Token]) -> Vec<Token> {
    let mut out: Vec<Token> = Vec::new();
    let mut open: Vec<Inside> = Vec::new();
    for token in all {
        match token {
            Token::Open | Token::Begin(_) => {
                let is_group = *token == Token::Open;
                let start = out.len() + 1;
                open.push(Inside { is_group, start, over: None, spoiled: false });
            }
            Token::Close | Token::End(_) => match open.pop() {
                Some(inside) if inside.is_group == (*token == Token::Close) => {
                    divide(&mut out, &inside);
                }
                _ => return all.to_vec(),
            },
            Token::Command(name) if name == "over" => {
                if let Some(inside) = open.last_mut() {
                    inside.spoiled |= inside.over.is_some();
                    inside.over = Some(out.len());
                }
            }
            // the other end of an empty bracket: in TeX it is a group, too
            Token::Command(name) if name == "nothing" => spoil(&mut open),
            Token::Row | Token::Column | Token::Quad | Token::Words(_) => spoil(&mut open),
            _ => {}
        }
        out.push(token.clone());
    }
    if open.is_empty() { out } else { all.to_vec() }
}

fn spoil(open: &mut [Inside]) {
    if let Some(inside) = open.last_mut() {
        inside.spoiled = true;
    }
}

/// Writes the fraction of a group that ends.
fn divide(out: &mut Vec<Token>, inside: &Inside) {
    let Some(over) = inside.over.filter(|_| inside.is_group && !inside.spoiled) else { return };
    if over == inside.start || over + 1 == out.len() {
        return;
    }
    let below = out.split_off(over + 1);
    let above: Vec<Token> =
        out.split_off(inside.start).into_iter().take(over - inside.start).collect();
    out.extend([Token::Command("frac".to_owned()), Token::Open]);
    out.extend(above);
    out.extend([Token::Close, Token::Open]);
    out.extend(below);
    out.push(Token::Close);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::token::{tokens, written};

    fn of(text: &str) -> String {
        written(&fractions(&tokens(text, true)))
    }

    #[test]
    fn a_fraction_of_plain_tex_is_one_of_latex() {
        assert_eq!(of("{a \\over b}"), "{\\frac{a}{b}}");
        assert_eq!(of("x^{1 \\over 2}"), "x^{\\frac{1}{2}}");
        assert_eq!(of("{{a \\over b} \\over c + d}"), "{\\frac{{\\frac{a}{b}}}{c+d}}");
    }

    #[test]
    fn an_over_that_divides_who_knows_what_stays() {
        for text in [
            "a\\over b",
            "{a\\over b\\over c}",
            "{\\over b}",
            "{a\\over}",
            "{a\\over b",
            "{\\begin{cases}a\\over b\\end{cases}}",
        ] {
            assert_eq!(of(text), written(&tokens(text, true)), "{text}");
        }
        // \left. and \right. are a group of their own
        let text = "{\\left. a \\over b \\right. + c}";
        assert!(of(text).contains("\\over"), "{}", of(text));
    }
}
