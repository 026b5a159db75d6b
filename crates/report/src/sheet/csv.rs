//! Rows for spreadsheets and plotting programs.

/// A table as CSV: a line of names, then a line a row, in quotes where a cell needs them.
pub(crate) fn csv(names: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut out = format!("{names}\n");
    for row in rows {
        let cells: Vec<String> = row.iter().map(|cell| quoted(cell)).collect();
        out.push_str(&cells.join(","));
        out.push('\n');
    }
    out
}

fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::csv;

    #[test]
    fn a_cell_with_a_comma_or_a_quote_stays_one_cell() {
        let rows = vec![vec!["1, 2".to_owned(), "so \"so\"".to_owned(), "x".to_owned()]];
        assert_eq!(csv("a,b,c", rows), "a,b,c\n\"1, 2\",\"so \"\"so\"\"\",x\n");
    }
}
