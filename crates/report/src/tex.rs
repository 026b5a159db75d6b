//! Words for LaTeX: no character of theirs is a command.

use kane_algebra::syntax::{canonical_name, greek_letter, latex_name};

/// Digits in a row after which a number may be broken at the end of a line.
const DIGITS: usize = 12;

/// The text as it is, also where it has characters that LaTeX would read, or that its fonts lack.
pub(crate) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut digits = 0;
    for c in text.chars() {
        digits = if c.is_ascii_digit() { digits + 1 } else { 0 };
        if digits > DIGITS {
            out.push_str("\\allowbreak{}");
            digits = 1;
        }
        match c {
            '\\' => out.push_str("\\textbackslash{}"),
            '{' | '}' | '$' | '&' | '#' | '%' | '_' => {
                out.push('\\');
                out.push(c);
            }
            '^' => out.push_str("\\textasciicircum{}"),
            '~' => out.push_str("\\textasciitilde{}"),
            '<' => out.push_str("$<$"),
            '>' => out.push_str("$>$"),
            '|' => out.push_str("$|$"),
            '"' => out.push_str("''"),
            '\n' | '\t' => out.push(' '),
            c if c.is_ascii() && !c.is_ascii_control() => out.push(c),
            c => out.push_str(&beyond_ascii(c)),
        }
    }
    out
}

/// A character that the fonts of LaTeX have in math mode alone, if at all.
fn beyond_ascii(c: char) -> String {
    let written = c.to_string();
    let canonical = canonical_name(&written);
    if greek_letter(&canonical).is_some() {
        return format!("${}$", latex_name(&canonical));
    }
    let known = match c {
        '–' => "--",
        '—' => "---",
        '’' => "'",
        '‘' => "`",
        '“' => "``",
        '”' => "''",
        '…' => "\\dots{}",
        '′' => "$'$",
        '×' => "$\\times$",
        '·' => "$\\cdot$",
        '−' => "$-$",
        '≤' => "$\\le$",
        '≥' => "$\\ge$",
        '≠' => "$\\ne$",
        '→' => "$\\to$",
        '∞' => "$\\infty$",
        '°' => "$^\\circ$",
        '²' => "$^2$",
        '³' => "$^3$",
        // the letters of Latin-1 are in every font
        'À'..='ÿ' => return written,
        _ => return format!("[U+{:04X}]", u32::from(c)),
    };
    known.to_owned()
}

/// A line whose formulas are whole: where nothing but signs stands between two of them, they are one.
///
/// `($a$ + $b$)$^{2}$$\cdot$\allowbreak{}$c$` becomes `($a + b)^{2}\cdot\allowbreak{}c$`.
pub(crate) fn whole(line: &str) -> String {
    let parts = parts(line);
    let mut out = String::with_capacity(line.len());
    // whether a formula is open at the end of what is written
    let mut open = false;
    for (i, (text, is_formula)) in parts.iter().enumerate() {
        if *is_formula {
            if !std::mem::replace(&mut open, true) {
                out.push('$');
            }
            out.push_str(text);
        } else {
            let goes_on = open && parts.get(i + 1).is_some_and(|next| next.1) && joins(text);
            if open && !goes_on {
                out.push('$');
                open = false;
            }
            out.push_str(text);
        }
    }
    if open {
        out.push('$');
    }
    out
}

/// Words and formulas in turn; a dollar behind a backslash is a word.
fn parts(line: &str) -> Vec<(&str, bool)> {
    let (mut parts, mut start, mut is_formula) = (Vec::new(), 0, false);
    let mut escaped = false;
    for (at, c) in line.char_indices() {
        if c == '$' && !escaped {
            if is_formula || at > start {
                parts.push((&line[start..at], is_formula));
            }
            (start, is_formula) = (at + 1, !is_formula);
        }
        escaped = c == '\\' && !escaped;
    }
    if start < line.len() {
        parts.push((&line[start..], false));
    }
    parts
}

/// Whether what stands between two formulas is a sign within one.
fn joins(text: &str) -> bool {
    let rest = text.replace("\\allowbreak{}", "");
    rest.chars().all(|c| "()[]+/ ".contains(c)) && (text.is_empty() || !text.trim().is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_with_signs_alone_between_them_are_one() {
        let line = r"($a$ + $b$)$^{2}$$\cdot$\allowbreak{}$c$ is $0$ identically";
        assert_eq!(whole(line), r"($a + b)^{2}\cdot\allowbreak{}c$ is $0$ identically");
        assert_eq!(whole(r"5\$ and $x$, $y$"), r"5\$ and $x$, $y$");
        assert_eq!(whole("$a$ $b$"), "$a$ $b$");
        assert_eq!(whole("no formula"), "no formula");
    }

    #[test]
    fn a_character_that_is_written_by_a_command_keeps_its_meaning() {
        let written = [
            ("1–2—3", "1--2---3"),
            ("‘a’ “b”…", "`a' ``b''\\dots{}"),
            ("a′", "a$'$"),
            ("2×3·4−5", "2$\\times$3$\\cdot$4$-$5"),
            ("≤≥≠→∞", "$\\le$$\\ge$$\\ne$$\\to$$\\infty$"),
            ("90°", "90$^\\circ$"),
            ("m²m³", "m$^2$m$^3$"),
        ];
        for (text, wanted) in written {
            assert_eq!(escape(text), wanted);
        }
    }

    #[test]
    fn no_character_of_a_text_becomes_a_command() {
        assert_eq!(escape(r"a_b \x {50%} #1 & $"), r"a\_b \textbackslash{}x \{50\%\} \#1 \& \$");
        assert_eq!(escape("μ ≤ é 漢"), "$\\mu$ $\\le$ é [U+6F22]");
        assert_eq!(escape("a\u{1b}[8m\tb\u{9b}"), "a[U+001B][8m b[U+009B]");
        assert_eq!(escape("1234567890123"), "123456789012\\allowbreak{}3");
    }
}
