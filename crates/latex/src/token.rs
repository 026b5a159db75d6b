//! LaTeX mathematics as a list of tokens.

/// The smallest part of a formula that means something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Token {
    /// a letter, a digit or a sign
    Char(char),
    /// `\name`
    Command(String),
    /// `{`
    Open,
    /// `}`
    Close,
    /// `^`
    Superscript,
    /// `_`
    Subscript,
    /// `&`
    Column,
    /// `\\`
    Row,
    /// `\begin{name}`
    Begin(String),
    /// `\end{name}`
    End(String),
    /// `\text{words}`
    Words(String),
    /// `\mathrm{word}`: upright letters, one name
    Upright(String),
    /// a wide space
    Quad,
    /// `\tag{number}`
    Tag(String),
    /// `\label{key}`
    Label(String),
    /// `\nonumber`
    Unnumbered,
}

/// Commands whose argument is words.
const WORDS: [&str; 6] = ["text", "textrm", "textit", "textup", "mbox", "intertext"];
/// Commands whose argument is one upright name.
const UPRIGHT: [&str; 3] = ["mathrm", "mathsf", "mathit"];
/// Commands that say how large or how far, and nothing else.
const SILENT: [&str; 37] = [
    ",",
    ";",
    ":",
    "!",
    ">",
    " ",
    "/",
    "left",
    "right",
    "middle",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "bigr",
    "Bigl",
    "Bigr",
    "biggl",
    "biggr",
    "Biggl",
    "Biggr",
    "displaystyle",
    "textstyle",
    "scriptstyle",
    "limits",
    "nolimits",
    "thinspace",
    "medspace",
    "strut",
    "mathstrut",
    "allowbreak",
    "nobreak",
    "relax",
    "rm",
    "bf",
    "it",
];

/// Reads a formula as tokens. Comments are passed over if the text is of a LaTeX source.
pub(crate) fn tokens(text: &str, comments: bool) -> Vec<Token> {
    let mut reader = Reader { rest: text, out: Vec::new(), comments };
    while reader.step() {}
    reader.out
}

struct Reader<'a> {
    rest: &'a str,
    out: Vec<Token>,
    comments: bool,
}

impl<'a> Reader<'a> {
    fn step(&mut self) -> bool {
        let Some(c) = self.rest.chars().next() else { return false };
        self.rest = &self.rest[c.len_utf8()..];
        let token = match c {
            '\\' => return self.command(),
            '%' if self.comments => {
                let end = self.rest.find('\n').map_or(self.rest.len(), |n| n + 1);
                self.rest = &self.rest[end..];
                return true;
            }
            _ if c.is_whitespace() || c == '~' || c.is_control() => return true,
            '{' => Token::Open,
            '}' => Token::Close,
            '^' => Token::Superscript,
            '_' => Token::Subscript,
            '&' => Token::Column,
            _ => Token::Char(c),
        };
        self.out.push(token);
        true
    }

    fn command(&mut self) -> bool {
        let letters = self.rest.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(self.rest.len());
        let length = match letters {
            0 => self.rest.chars().next().map_or(0, char::len_utf8),
            n => n,
        };
        let (name, rest) = self.rest.split_at(length);
        self.rest = rest;
        let token = match name {
            "" => return false,
            "\\" | "cr" | "newline" => {
                self.optional();
                Token::Row
            }
            "quad" | "qquad" | "enspace" => Token::Quad,
            "nonumber" | "notag" => Token::Unnumbered,
            "begin" | "end" | "tag" | "label" => {
                if name == "tag" {
                    self.rest = self.rest.strip_prefix('*').unwrap_or(self.rest);
                }
                let argument = self.argument();
                match name {
                    "begin" => Token::Begin(argument),
                    "end" => Token::End(argument),
                    "tag" => Token::Tag(argument),
                    _ => Token::Label(argument),
                }
            }
            "hspace" | "vspace" | "phantom" | "hphantom" | "vphantom" => {
                self.argument();
                return true;
            }
            // an empty bracket: what belongs to it is said by its other end
            "left" | "right" if self.rest.trim_start().starts_with('.') => {
                self.rest = self.rest.trim_start().get(1..).unwrap_or_default();
                Token::Command("nothing".to_owned())
            }
            // a bar that is said to open or to close does nothing else
            "left" | "right" if self.bar() => {
                Token::Command(if name == "left" { "lvert" } else { "rvert" }.to_owned())
            }
            _ if SILENT.contains(&name) => return true,
            _ if WORDS.contains(&name) => Token::Words(self.argument()),
            _ if UPRIGHT.contains(&name) => Token::Upright(self.argument()),
            _ => Token::Command(name.to_owned()),
        };
        self.out.push(token);
        true
    }

    /// Passes a bar, if one follows.
    fn bar(&mut self) -> bool {
        let rest = self.rest.trim_start();
        let bars = ["|", "\\vert", "\\lvert", "\\rvert"];
        let found = bars.into_iter().find_map(|bar| rest.strip_prefix(bar));
        let behind = found.filter(|behind| {
            rest.starts_with('|') || !behind.starts_with(|c: char| c.is_ascii_alphabetic())
        });
        self.rest = behind.unwrap_or(self.rest);
        behind.is_some()
    }

    /// The text between the braces that follow, or the next character.
    fn argument(&mut self) -> String {
        let text = self.rest.trim_start();
        match braced(text) {
            Some((inside, rest)) => {
                self.rest = rest;
                inside.to_owned()
            }
            None => {
                let end = text.chars().next().map_or(0, char::len_utf8);
                self.rest = &text[end..];
                text[..end].to_owned()
            }
        }
    }

    /// Passes over what follows in brackets.
    fn optional(&mut self) {
        if let Some(rest) = self.rest.strip_prefix('[')
            && let Some(end) = rest.find(']')
        {
            self.rest = &rest[end + 1..];
        }
    }
}

/// What stands between the braces with which a text begins, and what follows them.
pub(crate) fn braced(text: &str) -> Option<(&str, &str)> {
    let inside = text.strip_prefix('{')?;
    let mut depth = 0usize;
    let mut escaped = false;
    for (at, c) in inside.char_indices() {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '{' => depth += 1,
            '}' if depth == 0 => return Some((&inside[..at], &inside[at + 1..])),
            '}' => depth -= 1,
            _ => {}
        }
    }
    None
}

/// The tokens as LaTeX again.
pub(crate) fn written(tokens: &[Token]) -> String {
    let mut out = String::new();
    for token in tokens {
        match token {
            Token::Char(c) => {
                // a letter behind a command would become part of it
                if c.is_ascii_alphabetic() && ends_in_command(&out) {
                    out.push(' ');
                }
                out.push(*c);
            }
            Token::Command(name) => {
                out.push('\\');
                out.push_str(name);
            }
            Token::Open => out.push('{'),
            Token::Close => out.push('}'),
            Token::Superscript => out.push('^'),
            Token::Subscript => out.push('_'),
            Token::Column => out.push('&'),
            Token::Row => out.push_str(" \\\\ "),
            Token::Begin(name) => out.push_str(&format!("\\begin{{{name}}}")),
            Token::End(name) => out.push_str(&format!("\\end{{{name}}}")),
            Token::Words(words) => out.push_str(&format!("\\text{{{words}}}")),
            Token::Upright(word) => out.push_str(&format!("\\mathrm{{{word}}}")),
            Token::Quad => out.push_str("\\quad "),
            Token::Tag(_) | Token::Label(_) | Token::Unnumbered => {}
        }
    }
    out
}

fn ends_in_command(text: &str) -> bool {
    let before = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    before.len() < text.len() && before.ends_with('\\')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spaces_sizes_and_comments_say_nothing() {
        let all = tokens("\\left( a \\, b \\right) % words\n \\quad \\text{if } c", true);
        let shown = [
            Token::Char('('),
            Token::Char('a'),
            Token::Char('b'),
            Token::Char(')'),
            Token::Quad,
            Token::Words("if ".to_owned()),
            Token::Char('c'),
        ];
        assert_eq!(all, shown);
    }

    #[test]
    fn what_is_written_again_reads_the_same() {
        for text in [
            "\\frac{a}{b}\\alpha x^{2}_{i}",
            "\\begin{cases}a & \\text{if }b \\\\ c\\end{cases}",
            "\\mathrm{Re}\\,\\mu r",
        ] {
            let all = tokens(text, true);
            assert_eq!(tokens(&written(&all), true), all, "{text}");
        }
    }

    #[test]
    fn braces_end_where_they_are_closed() {
        assert_eq!(braced("{a{b}\\}c}d"), Some(("a{b}\\}c", "d")));
        assert_eq!(braced("{a"), None);
    }
}
