//! Rows for spreadsheets and plotting programs.

use kane_algebra::syntax::visible;

/// A table as CSV: a line of names, then a line a row, in quotes where a cell needs them. What is not seen is written out.
///
/// A spreadsheet takes a cell that begins with one of `=`, `+`, `-`, `@` for a formula and computes it. Text that begins
/// so has an apostrophe before it; numbers, whose sign is theirs, stay as they are.
pub(crate) fn csv(names: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut out = format!("{names}\n");
    for row in rows {
        let cells: Vec<String> = row.iter().map(|cell| quoted(&inert(&visible(cell)))).collect();
        out.push_str(&cells.join(","));
        out.push('\n');
    }
    out
}

/// What no spreadsheet computes. Where a comma is decimal, a cell ends at a semicolon.
fn inert(cell: &str) -> String {
    let piece = |piece: &str| {
        // spaces are skipped by some; in the widths of East Asia the signs are others
        let computed = piece.trim_start().starts_with(['=', '+', '-', '@', '＝', '＋', '－', '＠']);
        let is_number = is_number(piece.strip_suffix(';').unwrap_or(piece));
        if computed && !is_number { format!("'{piece}") } else { piece.to_owned() }
    };
    cell.split_inclusive(';').map(piece).collect()
}

/// Whether it is a decimal number, a power or a fraction of two, or infinity, with a sign or without.
fn is_number(cell: &str) -> bool {
    let magnitude = cell.strip_prefix(['+', '-']).unwrap_or(cell);
    let is_decimal = |part: &str| {
        part.starts_with(|first: char| first.is_ascii_digit()) && part.parse::<f64>().is_ok()
    };
    let is_power = |part: &str| match part.split_once('^') {
        Some((base, exponent)) => is_decimal(base) && exponent.parse::<i32>().is_ok(),
        None => is_decimal(part),
    };
    magnitude == "inf" || magnitude.splitn(2, '/').all(is_power)
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::csv;

    fn row(cell: &str) -> String {
        csv("a", [vec![cell.to_owned()]]).lines().nth(1).unwrap_or_default().to_owned()
    }

    #[test]
    fn a_cell_with_a_comma_or_a_quote_stays_one_cell() {
        let rows = vec![vec!["1, 2".to_owned(), "so \"so\"".to_owned(), "x".to_owned()]];
        assert_eq!(csv("a,b,c", rows), "a,b,c\n\"1, 2\",\"so \"\"so\"\"\",x\n");
    }

    #[test]
    fn a_row_is_a_line_and_all_of_it_is_seen() {
        assert_eq!(csv("a", [vec!["x\n=1\u{202e}".to_owned()]]), "a\nx\\u{a}=1\\u{202e}\n");
    }

    #[test]
    fn text_that_a_spreadsheet_would_compute_has_an_apostrophe() {
        for text in [
            "=1+1",
            "@SUM(1)",
            "+x",
            "-x + 1",
            "-2+3+cmd|' /C calc'!A0",
            " =1+1",
            "-1/3/4",
            "-1/x",
            "-2^x",
            "-",
            "--1",
            "-.5",
            "-infinity",
            "+nan",
            "＝1+1",
        ] {
            assert_eq!(row(text), format!("'{text}"));
        }
        assert_eq!(row("a;=1+1; @b;-2;c"), "a;'=1+1;' @b;-2;c");
        assert_eq!(row("=HYPERLINK(\"a\",\"b\")"), "\"'=HYPERLINK(\"\"a\"\",\"\"b\"\")\"");
    }

    #[test]
    fn numbers_and_other_text_stay_as_they_are() {
        for text in [
            "-1", "-1.5", "+2^-10", "+0.25", "-1e-300", "-2.5E+7", "-22/7", "-inf", "x - 1", "1-x",
            "a=b", "",
        ] {
            assert_eq!(row(text), text);
        }
    }
}
