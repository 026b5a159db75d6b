//! Commands that a reader can give to a shell.

use kane_algebra::syntax::visible;

/// The word as a shell takes it, on one line and with all of it seen: what is not, stands as bytes within `$'…'`,
/// which POSIX has since 2024 and bash, zsh and ksh had before.
#[must_use]
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./+:=@,%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else if visible(word) == word {
        format!("'{}'", word.replace('\'', r"'\''"))
    } else {
        format!("$'{}'", word.chars().map(escaped).collect::<String>())
    }
}

/// The name of a file as a shell takes it, and as no program takes it for a flag.
#[must_use]
pub fn quoted_file(name: &str) -> String {
    if name.len() > 1 && name.starts_with('-') {
        quoted(&format!("./{name}"))
    } else {
        quoted(name)
    }
}

/// The character within `$'…'`.
fn escaped(c: char) -> String {
    let mut bytes = [0; 4];
    let text = c.encode_utf8(&mut bytes);
    match c {
        '\\' | '\'' => format!("\\{c}"),
        '\n' => r"\n".to_owned(),
        _ if visible(text) == *text => text.to_owned(),
        _ => text.bytes().map(|byte| format!("\\{byte:03o}")).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::{quoted, quoted_file};

    #[test]
    fn a_shell_reads_the_word_back() {
        assert_eq!(quoted("docs/two-body.md"), "docs/two-body.md");
        assert_eq!(quoted("(9)"), "'(9)'");
        assert_eq!(quoted("it's"), r"'it'\''s'");
        assert_eq!(quoted("$(x) \\ `y`"), "'$(x) \\ `y`'");
    }

    #[test]
    fn a_word_stays_on_its_line_and_is_seen() {
        assert_eq!(quoted("a\n$b\\'\u{1b}c\u{202e}é"), r"$'a\n$b\\\'\033c\342\200\256é'");
        assert_eq!(quoted(""), "''");
    }

    #[test]
    fn a_file_is_no_flag() {
        assert_eq!(
            ["--a.md", "- a", "-", "a-b"].map(quoted_file),
            ["./--a.md", "'./- a'", "-", "a-b"]
        );
    }
}
