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
}
