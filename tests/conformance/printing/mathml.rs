//! A small reader of presentation MathML: the tree as the tokens of [`latex`](super::latex), in
//! which each part holds together as it is drawn.

use super::latex::{Read, Token};

/// An element, or a text in one.
#[derive(Clone, Debug)]
pub(super) enum Node {
    Element { tag: String, upright: bool, grows: bool, children: Vec<Node> },
    Text(String),
}

/// The element at the start of the text, and what follows it.
pub(super) fn element(text: &str) -> Read<(Node, &str)> {
    let rest = text.strip_prefix('<').ok_or_else(|| format!("no element: {text:.40}"))?;
    let (head, mut rest) = rest.split_once('>').ok_or("an element that does not end")?;
    let tag = head.split([' ', '/']).next().unwrap_or_default().to_owned();
    let upright = head.contains("mathvariant=\"normal\"");
    let grows = head.contains("stretchy=\"true\"");
    let mut children = Vec::new();
    if head.ends_with('/') {
        return Ok((Node::Element { tag, upright, grows, children }, rest));
    }
    loop {
        if let Some(after) = rest.strip_prefix("</") {
            let (end, after) = after.split_once('>').ok_or("an end that does not end")?;
            if end != tag {
                return Err(format!("{tag} ends as {end}"));
            }
            return Ok((Node::Element { tag, upright, grows, children }, after));
        }
        if rest.starts_with('<') {
            let (child, after) = element(rest)?;
            children.push(child);
            rest = after;
        } else {
            let end = rest.find('<').ok_or("a text that does not end")?;
            children.push(Node::Text(rest[..end].to_owned()));
            rest = &rest[end..];
        }
    }
}

fn unescaped(text: &str) -> String {
    let text = text.replace("&nbsp;", " ").replace("&lt;", "<").replace("&gt;", ">");
    text.replace("&amp;", "&")
}

impl Node {
    fn tag(&self) -> &str {
        match self {
            Self::Element { tag, .. } => tag,
            Self::Text(_) => "",
        }
    }

    /// Whether a bracket is as high as what follows it, which it then holds together.
    fn grows(&self) -> bool {
        matches!(self, Self::Element { grows: true, .. })
    }

    fn children(&self) -> &[Self] {
        match self {
            Self::Element { children, .. } => children,
            Self::Text(_) => &[],
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Text(text) => unescaped(text),
            Self::Element { children, .. } => children.iter().map(Self::text).collect(),
        }
    }

    /// A Latin letter that is set upright, as in the names of functions.
    fn upright_letter(&self) -> Option<char> {
        let upright = matches!(self, Self::Element { tag, upright: true, .. } if tag == "mi");
        self.text().chars().next().filter(|c| upright && c.is_ascii_alphabetic())
    }

    /// What is inside, as tokens.
    pub(super) fn inside(&self) -> Read<Vec<Token>> {
        let mut out = Vec::new();
        for child in self.children() {
            out.extend(child.tokens()?);
        }
        Ok(out)
    }

    fn braced(&self) -> Read<Vec<Token>> {
        let inside = if self.tag() == "mrow" { self.inside()? } else { self.tokens()? };
        Ok([vec![Token::Other('{')], inside, vec![Token::Other('}')]].concat())
    }

    /// An index, in braces: one of several letters and digits is one name.
    fn index(&self) -> Read<Vec<Token>> {
        let text = self.text();
        if self.tag() != "mi" || text.chars().count() < 2 {
            return self.braced();
        }
        let mut inside: Vec<Token> = Vec::new();
        for c in text.chars() {
            match (inside.last_mut(), c.is_ascii_digit()) {
                (Some(Token::Number(digits)), true) => digits.push(c),
                (_, true) => inside.push(Token::Number(c.to_string())),
                _ => inside.push(letter(&c.to_string())?),
            }
        }
        Ok([vec![Token::Other('{')], inside, vec![Token::Other('}')]].concat())
    }

    fn two(&self) -> Read<(&Self, &Self)> {
        match self.children() {
            [a, b] => Ok((a, b)),
            other => Err(format!("{} of {} parts", self.tag(), other.len())),
        }
    }

    fn tokens(&self) -> Read<Vec<Token>> {
        let command = |name: &str| Token::Command(name.to_owned());
        Ok(match self.tag() {
            "mn" => vec![Token::Number(self.text())],
            "mi" => match self.text().as_str() {
                "min" => vec![command("min")],
                "max" => vec![command("max")],
                other => vec![letter(other)?],
            },
            "mo" => match self.text().as_str() {
                "\u{2061}" => vec![],
                "⋅" => vec![command("cdot")],
                "≠" => vec![command("ne")],
                "≤" => vec![command("le")],
                "≥" => vec![command("ge")],
                "→" => vec![command("to")],
                other => vec![letter(other)?],
            },
            "mspace" => vec![],
            "mtext" => vec![Token::Words(self.text().replace('\u{a0}', " ").trim().to_owned())],
            "mfrac" => {
                let (a, b) = self.two()?;
                [vec![command("frac")], a.braced()?, b.braced()?].concat()
            }
            "msqrt" => {
                let inside = [Token::Other('{')].into_iter().chain(self.inside()?);
                [vec![command("sqrt")], inside.collect(), vec![Token::Other('}')]].concat()
            }
            "msub" => {
                let (base, index) = self.two()?;
                let index = index.index()?;
                [base.tokens()?, vec![Token::Other('_')], index].concat()
            }
            "msubsup" => match self.children() {
                [base, index, exponent] => {
                    let index = [vec![Token::Other('_')], index.index()?].concat();
                    let exponent = [vec![Token::Other('^')], exponent.braced()?].concat();
                    [base.tokens()?, index, exponent].concat()
                }
                other => return Err(format!("msubsup of {} parts", other.len())),
            },
            "msup" => {
                let (base, exponent) = self.two()?;
                let base = base.tokens()?;
                if base == [Token::Other('\'')] {
                    return Err("the exponent of a prime".to_owned());
                }
                [base, vec![Token::Other('^')], exponent.braced()?].concat()
            }
            "mrow" => self.row()?,
            other => return Err(format!("an unknown element {other}")),
        })
    }

    /// A row: between brackets, a word, `cases`, or only some things side by side.
    fn row(&self) -> Read<Vec<Token>> {
        let command = |name: &str| Token::Command(name.to_owned());
        let children = self.children();
        let word: Option<String> = children.iter().map(Self::upright_letter).collect();
        if let Some(word) = word.filter(|word| !word.is_empty()) {
            let letters = word.chars().map(Token::Letter);
            let open = [command("mathrm"), Token::Other('{')];
            return Ok(open.into_iter().chain(letters).chain([Token::Other('}')]).collect());
        }
        let Some((first, rest)) = children.split_first() else { return Ok(vec![]) };
        match (first.tag(), first.text().as_str(), rest) {
            ("mo", "{", [table]) => table.cases(),
            ("mo", open @ ("(" | "|"), [inner @ .., last]) if first.grows() => {
                let close = if open == "(" { ")" } else { "|" };
                if last.text() != close {
                    return Err(format!("{open} closed by {}", last.text()));
                }
                let mut out = vec![command("left"), letter(open)?];
                for child in inner {
                    out.extend(child.tokens()?);
                }
                out.extend([command("right"), letter(close)?]);
                Ok(out)
            }
            _ => self.inside(),
        }
    }

    /// The rows behind a brace.
    fn cases(&self) -> Read<Vec<Token>> {
        let command = |name: &str| Token::Command(name.to_owned());
        let environment = || {
            let name = "cases".chars().map(Token::Letter);
            [Token::Other('{')].into_iter().chain(name).chain([Token::Other('}')])
        };
        let mut out = vec![command("begin")];
        out.extend(environment());
        for (n, row) in self.children().iter().enumerate() {
            if n > 0 {
                out.push(command("\\"));
            }
            let (value, condition) = row.two()?;
            out.extend(value.inside()?);
            out.push(Token::Other('&'));
            out.extend(condition.inside()?);
        }
        out.push(command("end"));
        out.extend(environment());
        Ok(out)
    }
}

/// A single character as a token.
fn letter(text: &str) -> Read<Token> {
    let mut chars = text.chars();
    let (Some(c), None) = (chars.next(), chars.next()) else {
        return Err(format!("more than a character: {text}"));
    };
    Ok(match c {
        '−' => Token::Other('-'),
        '′' => Token::Other('\''),
        '∞' => Token::Command("infty".to_owned()),
        'α' => Token::Command("alpha".to_owned()),
        'μ' => Token::Command("mu".to_owned()),
        'Δ' => Token::Command("Delta".to_owned()),
        c if c.is_ascii_alphabetic() => Token::Letter(c),
        c if c.is_ascii() => Token::Other(c),
        c => return Err(format!("an unknown character {c}")),
    })
}
