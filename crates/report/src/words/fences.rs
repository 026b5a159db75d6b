//! Parentheses in MathML that are as tall as letters where nothing taller is between them.

const OPEN: &str = "<mo>(</mo>";
const CLOSE: &str = "<mo>)</mo>";
/// What is taller than letters with indices.
const TALL: [&str; 5] = ["<mfrac", "<mtable", "<munder", "<msqrt", "<mroot"];

/// The formula with parentheses that do not stretch. A browser that stretches them takes a taller sign with more room
/// around it even for an index.
pub(super) fn tight(formula: &str) -> String {
    let mut out = String::with_capacity(formula.len());
    let mut rest = formula;
    while let Some(at) = rest.find(OPEN) {
        let (before, behind) = (&rest[..at], &rest[at + OPEN.len()..]);
        out.push_str(before);
        let Some(end) = closing(behind) else {
            out.push_str(OPEN);
            rest = behind;
            continue;
        };
        let (inside, after) = (&behind[..end], &behind[end + CLOSE.len()..]);
        let stretches = TALL.iter().any(|tag| inside.contains(tag));
        let fence = |sign: char| match stretches {
            true => format!("<mo>{sign}</mo>"),
            false => format!("<mo stretchy=\"false\">{sign}</mo>"),
        };
        out.push_str(&fence('('));
        out.push_str(&tight(inside));
        out.push_str(&fence(')'));
        rest = after;
    }
    out.push_str(rest);
    out
}

/// Where the parenthesis closes that was opened before a text.
fn closing(text: &str) -> Option<usize> {
    let (mut depth, mut from) = (0_usize, 0);
    loop {
        let close = from + text.get(from..)?.find(CLOSE)?;
        depth += text[from..close].matches(OPEN).count();
        if depth == 0 {
            return Some(close);
        }
        (depth, from) = (depth - 1, close + CLOSE.len());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parentheses_stretch_around_fractions_alone() {
        let low = |inside: &str| {
            format!("<mo stretchy=\"false\">(</mo>{inside}<mo stretchy=\"false\">)</mo>")
        };
        let a = "<mi>a</mi>";
        assert_eq!(tight(&format!("{OPEN}{a}{CLOSE}")), low(a));
        let tall = format!("{OPEN}<mfrac>{a}{a}</mfrac>{CLOSE}");
        assert_eq!(tight(&tall), tall);
        let nested =
            format!("{OPEN}{OPEN}{a}{CLOSE}<mfrac>{a}{a}</mfrac>{CLOSE}{a}{OPEN}{a}{CLOSE}");
        let set = format!("{OPEN}{}<mfrac>{a}{a}</mfrac>{CLOSE}{a}{}", low(a), low(a));
        assert_eq!(tight(&nested), set);
        let inner = format!("{OPEN}{OPEN}{a}{CLOSE}{a}{OPEN}{a}{CLOSE}{CLOSE}{a}");
        let set = format!("{}{a}", low(&format!("{}{a}{}", low(a), low(a))));
        assert_eq!(tight(&inner), set);
        for broken in ["<mo>(</mo>x", "x<mo>)</mo>", "<mo>)</mo><mo>(</mo>"] {
            assert_eq!(tight(broken), broken);
        }
    }
}
