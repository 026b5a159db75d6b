//! Running text in Markdown.

/// A paragraph under construction.
#[derive(Clone, Debug, Default)]
pub(crate) struct Prose(String);

impl Prose {
    pub(crate) fn push(&mut self, c: char) {
        self.0.push(c);
    }

    pub(crate) fn push_str(&mut self, text: &str) {
        self.0.push_str(text);
    }

    /// What has come together, with the spaces of the source brought to one.
    pub(crate) fn take(&mut self) -> String {
        let text = std::mem::take(&mut self.0);
        let lines = text.lines().map(|line| {
            let indent = line.len() - line.trim_start().len();
            let words: Vec<&str> = line.split_whitespace().collect();
            // in Markdown an indented line may be a list in a list
            format!("{}{}", " ".repeat(indent.min(3)), words.join(" "))
        });
        lines.collect::<Vec<_>>().join("\n")
    }
}

/// A text that opens no block: three ticks or tildes in a row are parted. Asked of all that goes into a draft, for
/// what is left out of a source can bring together what stood apart in it.
pub(crate) fn unfenced(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut run = 0;
    for c in text.chars() {
        run = if matches!(c, '`' | '~') && out.ends_with(c) { run + 1 } else { 1 };
        if run > 2 {
            out.push(' ');
            run = 1;
        }
        out.push(c);
    }
    out
}

/// A text whose characters mean nothing in Markdown.
pub(crate) fn plain(text: &str) -> String {
    text.chars().map(escaped).collect()
}

/// A character that would mean something in Markdown.
pub(crate) fn escaped(c: char) -> String {
    match c {
        '`' => "‘".to_owned(),
        '*' | '_' | '[' | ']' | '<' | '>' | '#' | '$' | '\\' | '|' | '~' => format!("\\{c}"),
        _ => c.to_string(),
    }
}

/// The combining mark of an accent.
pub(crate) fn accent(c: char) -> Option<char> {
    Some(match c {
        '\'' => '\u{301}',
        '"' => '\u{308}',
        '^' => '\u{302}',
        '~' => '\u{303}',
        '=' => '\u{304}',
        '.' => '\u{307}',
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_that_is_parted_opens_no_block() {
        assert_eq!(unfenced("a `b` ``c`` ~~d~~"), "a `b` ``c`` ~~d~~");
        assert_eq!(unfenced("```kane"), "`` `kane");
        assert_eq!(unfenced("~~~~~~"), "~~ ~~ ~~");
        assert_eq!(unfenced("``~~``"), "``~~``");
    }
}
