//! Text that fits into a number of columns.

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// The text itself if it fits into `columns`, else its beginning and an ellipsis.
pub(crate) fn shorten(text: &str, columns: usize) -> String {
    if text.width() <= columns {
        return text.to_owned();
    }
    let mut used = 0;
    let kept = text.chars().take_while(|c| {
        used += c.width().unwrap_or(0);
        used < columns
    });
    let mut short: String = kept.collect();
    short.truncate(short.trim_end().len());
    if columns > 0 {
        short.push('…');
    }
    short
}

/// The text, filled with blanks up to `columns`.
pub(crate) fn padded(text: &str, columns: usize) -> String {
    let blanks = columns.saturating_sub(text.width());
    format!("{text}{:blanks$}", "")
}

/// A formula with the letters and signs of print.
pub(crate) fn in_print(formula: &str) -> String {
    let word = |word: &str| match word {
        "alpha" => "α".to_owned(),
        "mu" => "μ".to_owned(),
        "omega" => "ω".to_owned(),
        "eta" => "η".to_owned(),
        word => word.to_owned(),
    };
    let mut out = String::new();
    let mut name = String::new();
    for c in formula.chars() {
        if c.is_ascii_alphabetic() {
            name.push(c);
            continue;
        }
        out.push_str(&word(&std::mem::take(&mut name)));
        out.push(match c {
            '*' => '·',
            '-' => '−',
            c => c,
        });
    }
    out.push_str(&word(&name));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_text_stays() {
        assert_eq!(shorten("k = 1", 5), "k = 1");
    }

    #[test]
    fn long_text_ends_in_an_ellipsis_and_fits() {
        assert_eq!(shorten("k = (1 - alpha)", 8), "k = (1…");
        for columns in 0..20 {
            assert!(shorten("μ = α·β − γ³ and more", columns).width() <= columns);
        }
    }

    #[test]
    fn blanks_count_columns_not_bytes() {
        assert_eq!(padded("μ", 3), "μ  ");
    }

    #[test]
    fn formulas_are_set_as_in_print() {
        assert_eq!(in_print("2/(1 + alpha) - mu*k"), "2/(1 + α) − μ·k");
        assert_eq!(in_print("alphabet*alpha"), "alphabet·α");
    }
}
