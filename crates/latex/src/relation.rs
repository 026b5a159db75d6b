//! Relations: chains, lists, limits and the conditions under which they hold.

use crate::formula::{Reader, out_of_place, strip};
use crate::name::Names;
use crate::plain::fractions;
use crate::token::{Token, tokens};
use crate::unreadable::Unreadable;

/// A formula as the language of derivations writes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// the relations
    pub relations: String,
    /// how the variable of a limit moves, `x -> 0+`
    pub limit: Option<String>,
    /// the conditions
    pub when: Option<String>,
    /// `f(x)`, if the formula is one equation that says what f(x) is: then the relations are its right side
    pub defines: Option<String>,
    /// what the formula has besides, and the statement has not: the name before a limit
    pub left_out: Option<String>,
}

impl Statement {
    /// The statement with its clauses, as it stands behind a label.
    #[must_use]
    pub fn text(&self) -> String {
        let mut out = self.relations.clone();
        if let Some(limit) = &self.limit {
            out.push_str(&format!(" as {limit}"));
        }
        if let Some(when) = &self.when {
            out.push_str(&format!(" when {when}"));
        }
        out
    }
}

/// Reads what stands between dollars.
///
/// ```
/// use kane_latex::{Names, statement};
///
/// let read = statement(r"k = \frac{1-\alpha}{1+\alpha}", &mut Names::default())?;
/// assert_eq!(read.text(), "k = (1 - alpha)/(1 + alpha)");
/// # Ok::<(), kane_latex::Unreadable>(())
/// ```
///
/// # Errors
/// [`Unreadable`], if there is more in it than the language can say, or two readings.
pub fn statement(latex: &str, names: &mut Names) -> Result<Statement, Unreadable> {
    of_tokens(&tokens(latex, true), names)
}

/// Reads the tokens of one statement.
pub(crate) fn of_tokens(all: &[Token], names: &mut Names) -> Result<Statement, Unreadable> {
    let mark = names.mark();
    // columns line rows up; inside of cases and matrices they part cells
    let mut depth = 0usize;
    let flat: Vec<Token> = strip(all)
        .iter()
        .filter(|token| {
            match token {
                Token::Begin(_) => depth += 1,
                Token::End(_) => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth > 0 || **token != Token::Column
        })
        .cloned()
        .collect();
    let read = read(&fractions(&flat), names);
    names.parameters.clear();
    if read.is_err() {
        names.back(mark);
    }
    read
}

/// A list of relations, `a = b, c > 0`.
pub(crate) fn conjunction(reader: &mut Reader<'_>) -> Result<String, Unreadable> {
    let mut clauses = Clauses::default();
    let text = list(reader, &mut clauses)?;
    match reader.peek() {
        None if clauses.limit.is_none() && clauses.when.is_none() => Ok(text),
        None => Err(Unreadable::Missing("a plain condition")),
        Some(token) => Err(out_of_place(token)),
    }
}

#[derive(Default)]
struct Clauses {
    limit: Option<String>,
    when: Option<String>,
    left_out: Option<String>,
}

fn read(all: &[Token], names: &mut Names) -> Result<Statement, Unreadable> {
    if let Some((head, parameters, body)) = definition(all, names) {
        names.parameters = parameters;
        let mut reader = Reader::new(body, names);
        let sum = reader.sum()?.text;
        return match reader.peek() {
            None => Ok(Statement {
                relations: sum,
                limit: None,
                when: None,
                defines: Some(head),
                left_out: None,
            }),
            Some(token) => Err(out_of_place(token)),
        };
    }
    let mut reader = Reader::new(all, names);
    let mut clauses = Clauses::default();
    let relations = list(&mut reader, &mut clauses)?;
    match reader.peek() {
        None => Ok(Statement {
            relations,
            limit: clauses.limit,
            when: clauses.when,
            defines: None,
            left_out: clauses.left_out,
        }),
        Some(token) => Err(out_of_place(token)),
    }
}

/// `f(x) = body` with a name that is known to be a function: its head, its parameters and the body.
fn definition<'a>(all: &'a [Token], names: &Names) -> Option<(String, Vec<String>, &'a [Token])> {
    let (name, parameters, rest) = head(all)?;
    let chained = rest.iter().filter(|token| **token == Token::Char('=')).count() > 1;
    if chained || !names.functions.contains(&name) {
        return None;
    }
    // a function that has its definition has a value at symbols of the paper
    let known = |name: &String| names.symbols().iter().any(|symbol| symbol.name == *name);
    if names.defined.contains(&name) && parameters.iter().all(known) {
        return None;
    }
    let ([Token::Char('='), body @ ..] | [Token::Char(':'), Token::Char('='), body @ ..]) = rest
    else {
        return None;
    };
    Some((format!("{name}({})", parameters.join(", ")), parameters, body))
}

/// `f(x, …)` at the beginning: the name, the parameters, and what follows.
pub(crate) fn head(all: &[Token]) -> Option<(String, Vec<String>, &[Token])> {
    let open = all.iter().position(|token| *token == Token::Char('('))?;
    let close = all.iter().position(|token| *token == Token::Char(')'))?;
    let alone = |tokens: &[Token]| {
        let mut names = Names::default();
        let mut reader = Reader::new(tokens, &mut names);
        let text = reader.sum().ok()?.text;
        let [symbol] = names.symbols() else { return None };
        (text == symbol.name).then_some(text)
    };
    let name = alone(all.get(..open)?)?;
    let parameters: Option<Vec<String>> =
        all.get(open + 1..close)?.split(|token| *token == Token::Char(',')).map(alone).collect();
    Some((name, parameters?, all.get(close + 1..)?))
}

fn list(reader: &mut Reader<'_>, clauses: &mut Clauses) -> Result<String, Unreadable> {
    let mut out = chain(reader, clauses)?;
    loop {
        let (mut separated, mut punctuated) = (false, false);
        loop {
            if reader.takes_char(',') || reader.takes_char(';') {
                punctuated = true;
            } else if !reader.takes(&Token::Quad) {
                break;
            }
            separated = true;
        }
        if separated && !punctuated && matches!(reader.peek(), Some(Token::Char('+' | '-' | '−')))
        {
            return Err(Unreadable::Ambiguous("a sign behind a wide space".to_owned()));
        }
        let connective = match reader.peek() {
            None => return Ok(out),
            Some(Token::Words(words)) => {
                match words.trim().trim_matches(',').to_lowercase().as_str() {
                    "and" | "with" | "where" | "" => ", ",
                    "or" => " or ",
                    "if" | "when" | "for" | "provided" | "provided that" | "whenever"
                    | "for all" | "if and when" => {
                        reader.at += 1;
                        condition(reader, clauses)?;
                        return Ok(out);
                    }
                    "as" => {
                        reader.at += 1;
                        motion(reader, clauses)?;
                        return Ok(out);
                    }
                    _ => return Err(Unreadable::Words(words.clone())),
                }
            }
            Some(Token::Command(name)) => match name.as_str() {
                "land" | "wedge" => " and ",
                "lor" | "vee" => " or ",
                "implies" | "Rightarrow" | "Longrightarrow" => " implies ",
                "iff" | "Leftrightarrow" | "Longleftrightarrow" => " iff ",
                "forall" => {
                    reader.at += 1;
                    condition(reader, clauses)?;
                    return Ok(out);
                }
                _ if separated => "",
                _ => return Ok(out),
            },
            Some(Token::Char('(')) if separated && in_brackets(reader, clauses)? => return Ok(out),
            _ if separated => "",
            _ => return Ok(out),
        };
        if connective.is_empty() {
            out.push_str(", ");
        } else {
            reader.at += 1;
            out.push_str(connective);
        }
        out.push_str(&chain(reader, clauses)?);
    }
}

/// Conditions up to the end.
fn condition(reader: &mut Reader<'_>, clauses: &mut Clauses) -> Result<(), Unreadable> {
    let mut inner = Clauses::default();
    let when = list(reader, &mut inner)?;
    if clauses.when.is_some() || inner.when.is_some() || inner.limit.is_some() {
        return Err(Unreadable::Missing("a plain condition"));
    }
    clauses.when = Some(when);
    Ok(())
}

/// A condition, or the way of a limit, in brackets at the end; whether there is one.
fn in_brackets(reader: &mut Reader<'_>, clauses: &mut Clauses) -> Result<bool, Unreadable> {
    let (start, mark) = (reader.at, reader.names.mark());
    let end = reader.tokens.len();
    if reader.tokens.last() != Some(&Token::Char(')')) {
        return Ok(false);
    }
    let inside = &reader.tokens[start + 1..end - 1];
    let arrow = inside.iter().any(is_arrow);
    let mut inner = Reader::new(inside, reader.names);
    let mut found = Clauses::default();
    let read =
        if arrow { motion(&mut inner, &mut found) } else { condition(&mut inner, &mut found) };
    let whole = inner.peek().is_none();
    if read.is_err() || !whole {
        reader.names.back(mark);
        return Ok(false);
    }
    if found.limit.is_some() {
        clauses.limit = found.limit;
    } else {
        clauses.when = found.when;
    }
    reader.at = end;
    Ok(true)
}

fn is_arrow(token: &Token) -> bool {
    let arrows = ["to", "rightarrow", "longrightarrow", "downarrow", "uparrow"];
    matches!(token, Token::Command(name) if arrows.contains(&name.as_str()))
        || *token == Token::Char('→')
}

/// `x \to a` with its side.
fn motion(reader: &mut Reader<'_>, clauses: &mut Clauses) -> Result<(), Unreadable> {
    let x = variable(reader)?;
    let arrow = match reader.next() {
        Some(token) if is_arrow(token) => token,
        Some(token) => return Err(out_of_place(token)),
        None => return Err(Unreadable::Missing("the point of a limit")),
    };
    let mut point = String::new();
    let named = |name: &str| *arrow == Token::Command(name.to_owned());
    let mut side = if named("downarrow") {
        "+"
    } else if named("uparrow") {
        "-"
    } else {
        ""
    };
    if reader.takes_char('-') || reader.takes_char('−') {
        point.push('-');
    } else {
        reader.takes_char('+');
    }
    if reader.takes(&Token::Command("infty".to_owned())) {
        point.push_str("oo");
    } else {
        let rest = &reader.tokens[reader.at..];
        let number = |token: &Token| match token {
            Token::Char(c) => c.is_ascii_digit() || matches!(c, '.' | '/'),
            Token::Open | Token::Close => true,
            Token::Command(name) => matches!(name.as_str(), "frac" | "tfrac" | "dfrac"),
            _ => false,
        };
        let end = rest.iter().position(|token| !number(token)).unwrap_or(rest.len());
        let mut inner = Reader::new(&rest[..end], reader.names);
        let value = inner.sum()?.text;
        if inner.peek().is_some() {
            return Err(Unreadable::Missing("the point of a limit"));
        }
        point.push_str(&value);
        reader.at += end;
        let superscript = reader.takes(&Token::Superscript);
        let braces = superscript && reader.takes(&Token::Open);
        if reader.takes_char('+') {
            side = "+";
        } else if reader.takes_char('-') || reader.takes_char('−') {
            side = "-";
        } else if superscript {
            return Err(Unreadable::Exponent);
        }
        if braces && !reader.takes(&Token::Close) {
            return Err(Unreadable::Missing("a closing brace"));
        }
    }
    if clauses.limit.is_some() {
        return Err(Unreadable::Missing("a single limit"));
    }
    clauses.limit = Some(format!("{x} -> {point}{side}"));
    Ok(())
}

fn variable(reader: &mut Reader<'_>) -> Result<String, Unreadable> {
    let text = reader.sum()?.text;
    let known = reader.names.symbols().iter().any(|symbol| symbol.name == text);
    if known { Ok(text) } else { Err(Unreadable::Missing("the variable of a limit")) }
}

/// A comparison.
fn relation(reader: &mut Reader<'_>) -> Result<Option<&'static str>, Unreadable> {
    let found = match reader.peek() {
        Some(Token::Char('=' | '≡')) => "=",
        Some(Token::Char(':')) if reader.tokens.get(reader.at + 1) == Some(&Token::Char('=')) => {
            reader.at += 1;
            "="
        }
        Some(Token::Char('<')) => "<",
        Some(Token::Char('>')) => ">",
        Some(Token::Char('≤')) => "<=",
        Some(Token::Char('≥')) => ">=",
        Some(Token::Char('≠')) => "!=",
        Some(Token::Command(name)) => match name.as_str() {
            "equiv" | "coloneqq" | "triangleq" | "doteq" => "=",
            "lt" => "<",
            "gt" => ">",
            "le" | "leq" | "leqslant" | "leqq" => "<=",
            "ge" | "geq" | "geqslant" | "geqq" => ">=",
            "ne" | "neq" => "!=",
            "not" if reader.tokens.get(reader.at + 1) == Some(&Token::Char('=')) => {
                reader.at += 1;
                "!="
            }
            "approx" | "simeq" | "sim" | "propto" | "cong" | "ll" | "gg" | "approxeq"
            | "lesssim" | "gtrsim" => return Err(Unreadable::Approximate(name.clone())),
            _ => return Ok(None),
        },
        _ => return Ok(None),
    };
    reader.at += 1;
    Ok(Some(found))
}

fn is_lim(token: Option<&Token>) -> bool {
    matches!(token, Some(Token::Command(name)) if name == "lim")
}

fn is_equal(token: Option<&Token>) -> bool {
    token == Some(&Token::Char('='))
}

fn chain(reader: &mut Reader<'_>, clauses: &mut Clauses) -> Result<String, Unreadable> {
    let limit = is_lim(reader.peek());
    reader.at += usize::from(limit);
    if limit {
        if !reader.takes(&Token::Subscript) {
            return Err(Unreadable::Missing("the variable of a limit"));
        }
        let below = reader.group()?;
        let mut inner = Reader::new(below, reader.names);
        motion(&mut inner, clauses)?;
        if let Some(token) = inner.peek() {
            return Err(out_of_place(token));
        }
    }
    let mut out = if limit { reader.product()?.text } else { side(reader)? };
    if limit && matches!(reader.peek(), Some(Token::Char('+' | '-' | '−'))) {
        return Err(Unreadable::Ambiguous(format!("the limit of {out}…")));
    }
    if !limit && is_equal(reader.peek()) && is_lim(reader.tokens.get(reader.at + 1)) {
        // k = lim f = L says what f tends to; what the limit is called is no statement
        reader.at += 1;
        let limit = chain(reader, clauses)?;
        clauses.left_out = Some(format!("{out} ="));
        return Ok(limit);
    }
    if limit || reader.peek().is_some_and(is_arrow) {
        let arrow = match reader.next() {
            Some(token) => is_arrow(token) || *token == Token::Char('='),
            None => return Err(Unreadable::NoRelation),
        };
        if !arrow {
            return Err(Unreadable::NoRelation);
        }
        let to = side(reader)?;
        return Ok(format!("{out} -> {to}"));
    }
    if reader.takes(&Token::Command("in".to_owned())) {
        return interval(reader, &out);
    }
    let mut links = 0;
    while let Some(rel) = relation(reader)? {
        out = format!("{out} {rel} {}", side(reader)?);
        links += 1;
    }
    if links == 0 {
        return Err(reader.peek().map_or(Unreadable::NoRelation, out_of_place));
    }
    Ok(out)
}

/// One side of a comparison; infinity by its name.
fn side(reader: &mut Reader<'_>) -> Result<String, Unreadable> {
    let start = reader.at;
    let minus = reader.takes_char('-') || reader.takes_char('−');
    if !minus {
        reader.takes_char('+');
    }
    if reader.takes(&Token::Command("infty".to_owned())) {
        return Ok(if minus { "-oo" } else { "oo" }.to_owned());
    }
    reader.at = start;
    Ok(reader.sum()?.text)
}

/// `x ∈ [a, b)` as a chain.
fn interval(reader: &mut Reader<'_>, x: &str) -> Result<String, Unreadable> {
    let low = match reader.next() {
        Some(Token::Char('[')) => "<=",
        Some(Token::Char('(' | ']')) => "<",
        Some(token) => return Err(out_of_place(token)),
        None => return Err(Unreadable::Missing("an interval")),
    };
    let a = side(reader)?;
    if !reader.takes_char(',') {
        return Err(Unreadable::Missing("an interval"));
    }
    let b = side(reader)?;
    let high = match reader.next() {
        Some(Token::Char(']')) => "<=",
        Some(Token::Char(')' | '[')) => "<",
        _ => return Err(Unreadable::Missing("the end of an interval")),
    };
    match (a.as_str(), b.as_str()) {
        ("-oo", "oo") => Err(Unreadable::NoRelation),
        ("-oo", _) => Ok(format!("{x} {high} {b}")),
        (_, "oo") => Ok(format!("{x} {} {a}", if low == "<=" { ">=" } else { ">" })),
        _ => Ok(format!("{a} {low} {x} {high} {b}")),
    }
}
