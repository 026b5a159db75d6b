//! Formulas that fit on lines: TeX breaks neither inside a fraction nor between brackets that grow.

/// Letters and signs of about a line of an appendix.
const WIDE: usize = 60;

/// The text with fractions that are wider than a line written with a slash, and brackets around what is wider than a line
/// at a size of their own, so that TeX may break what is in them.
pub(crate) fn breakable(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find("\\frac{").into_iter().chain(rest.find("\\left(")).min() {
        out.push_str(&rest[..at]);
        rest = &rest[at..];
        if let Some((above, below, after)) = fraction(rest) {
            match width(above).max(width(below)) > WIDE {
                true => {
                    out.push_str(&format!("(({})/({}))", breakable(above), breakable(below)));
                }
                false => out.push_str(&rest[..rest.len() - after.len()]),
            }
            rest = after;
        } else if let Some((inside, after)) = bracketed(rest).filter(|b| width(b.0) > WIDE) {
            out.push_str(&format!("\\bigl({}\\bigr)", breakable(inside)));
            rest = after;
        } else {
            let command = "\\frac{".len();
            out.push_str(&rest[..command]);
            rest = &rest[command..];
        }
    }
    out.push_str(rest);
    out
}

/// Of a text that begins with a fraction what is above, what is below, and what comes after it.
fn fraction(text: &str) -> Option<(&str, &str, &str)> {
    let (above, rest) = group(text.strip_prefix("\\frac")?)?;
    let (below, rest) = group(rest)?;
    Some((above, below, rest))
}

/// Of a text that begins with a group in braces what is in it, and what comes after it.
fn group(text: &str) -> Option<(&str, &str)> {
    let (mut depth, mut escaped) = (0_usize, false);
    for (at, c) in text.char_indices() {
        match c {
            '{' if !escaped => depth += 1,
            '}' if !escaped => depth = depth.checked_sub(1)?,
            _ => {}
        }
        if depth == 0 {
            return (at > 0).then(|| (&text[1..at], &text[at + 1..]));
        }
        escaped = c == '\\' && !escaped;
    }
    None
}

/// Of a text that begins with a bracket that grows what is between it and its partner, and what comes after that.
fn bracketed(text: &str) -> Option<(&str, &str)> {
    let (open, close) = ("\\left", "\\right");
    let inside = text.strip_prefix("\\left(")?;
    let (mut depth, mut at) = (1_usize, 0);
    loop {
        let next = inside[at..].find(open).into_iter().chain(inside[at..].find(close)).min()?;
        at += next;
        if inside[at..].starts_with(close) {
            depth -= 1;
            if depth == 0 {
                let after = inside[at + close.len()..].strip_prefix(')')?;
                return Some((&inside[..at], after));
            }
            at += close.len();
        } else {
            depth += 1;
            at += open.len();
        }
    }
}

/// About how many letters and signs a formula has: a command is one, and of a fraction the wider part counts.
fn width(text: &str) -> usize {
    let (mut count, mut rest) = (0, text);
    while let Some(c) = rest.chars().next() {
        if let Some((above, below, after)) = fraction(rest) {
            count += width(above).max(width(below));
            rest = after;
            continue;
        }
        rest = &rest[c.len_utf8()..];
        match c {
            '\\' => {
                count += 1;
                let name = rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(rest.len());
                rest = &rest[name.max(usize::from(!rest.is_empty() && rest.is_char_boundary(1)))..];
            }
            '{' | '}' | ' ' | '_' | '^' => {}
            _ => count += 1,
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_fits_stays_and_what_is_wider_than_a_line_can_be_broken() {
        let fits = r"\left(\frac{a + b}{c}\right) = \frac{1}{2}\{x\}";
        assert_eq!(breakable(fits), fits);
        let sum = ["a_{xy} b^{2}"; 30].join(" + ");
        let wide = format!(r"\frac{{{sum}}}{{2}} \cdot \left(\frac{{d y}}{{d t}}\right)");
        let broken = breakable(&wide);
        assert_eq!(broken, format!(r"(({sum})/(2)) \cdot \left(\frac{{d y}}{{d t}}\right)"));
        let grown = format!(r"-\left({sum} - \left(\frac{{p}}{{q}}\right)\right) + 1");
        let smaller = format!(r"-\bigl({sum} - \left(\frac{{p}}{{q}}\right)\bigr) + 1");
        assert_eq!(breakable(&grown), smaller);
        for odd in [r"\frac{a", r"\frac{a}b", r"\left(a", r"\left(a\right]", "\\"] {
            assert_eq!(breakable(odd), odd);
        }
    }
}
