//! A small reader of SMT-LIB: what is declared, and whether all that is asserted holds at a point.

use std::collections::HashMap;

use num_rational::BigRational as Q;
use num_traits::{One, Zero};

#[derive(Clone, Debug)]
enum Term {
    Word(String),
    List(Vec<Term>),
}

enum Value {
    Number(Q),
    Truth(bool),
}

/// The symbols that a question declares, and whether its assertions hold at a point.
#[derive(Debug)]
pub(crate) struct Question {
    pub(crate) declared: Vec<String>,
    /// names for longer terms, each with what it stands for
    defined: Vec<(String, Term)>,
    asserted: Vec<Term>,
}

/// The terms at the start, up to a closing parenthesis.
fn terms(words: &mut impl Iterator<Item = String>) -> Vec<Term> {
    let mut out = Vec::new();
    while let Some(word) = words.next() {
        match word.as_str() {
            "(" => out.push(Term::List(terms(words))),
            ")" => return out,
            _ => out.push(Term::Word(word)),
        }
    }
    out
}

/// Words and parentheses; a symbol between bars is one word, and `;` begins a comment.
fn words(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut rest = text;
    loop {
        rest = rest.trim_start();
        let Some(first) = rest.chars().next() else { return words };
        let length = match first {
            ';' => {
                rest = rest.split_once('\n').map_or("", |(_, rest)| rest);
                continue;
            }
            '(' | ')' => 1,
            '|' => rest[1..].find('|').map_or(rest.len(), |end| end + 2),
            _ => rest.find(|c: char| c.is_whitespace() || "()|".contains(c)).unwrap_or(rest.len()),
        };
        words.push(rest[..length].to_owned());
        rest = &rest[length..];
    }
}

impl Question {
    pub(crate) fn read(text: &str) -> Result<Self, String> {
        let (mut declared, mut defined, mut asserted) = (Vec::new(), Vec::new(), Vec::new());
        let mut asked = 0;
        for command in terms(&mut words(text).into_iter()) {
            let Term::List(parts) = command else { return Err(format!("{command:?}")) };
            match parts.as_slice() {
                [Term::Word(word), Term::Word(logic)] if word == "set-logic" => {
                    if logic != "QF_NRA" {
                        return Err(format!("another logic: {logic}"));
                    }
                }
                [Term::Word(word), Term::Word(name), Term::Word(sort)]
                    if word == "declare-const" && sort == "Real" =>
                {
                    declared.push(name.clone());
                }
                [Term::Word(word), Term::Word(name), Term::List(none), Term::Word(sort), term]
                    if word == "define-fun" && none.is_empty() && sort == "Real" =>
                {
                    defined.push((name.clone(), term.clone()));
                }
                [Term::Word(word), term] if word == "assert" => asserted.push(term.clone()),
                [Term::Word(word)] if word == "check-sat" => asked += 1,
                other => return Err(format!("an unknown command: {other:?}")),
            }
        }
        if asked == 1 {
            Ok(Self { declared, defined, asserted })
        } else {
            Err(format!("asked {asked} times"))
        }
    }

    pub(crate) fn holds(&self, values: &HashMap<String, Q>) -> Result<bool, String> {
        // a symbol that is not declared has no value
        let declared = |(name, _): &(&String, &Q)| self.declared.contains(name);
        let known = values.iter().filter(declared).map(|(name, q)| (name.clone(), q.clone()));
        let mut values: HashMap<String, Q> = known.collect();
        for (name, term) in &self.defined {
            if let Value::Number(number) = value(term, &values)? {
                values.insert(name.clone(), number);
            }
        }
        for term in &self.asserted {
            match value(term, &values)? {
                Value::Truth(true) => {}
                Value::Truth(false) => return Ok(false),
                Value::Number(_) => return Err(format!("no truth: {term:?}")),
            }
        }
        Ok(true)
    }
}

fn value(term: &Term, values: &HashMap<String, Q>) -> Result<Value, String> {
    let parts = match term {
        Term::Word(word) => {
            return Ok(match word.as_str() {
                "true" => Value::Truth(true),
                "false" => Value::Truth(false),
                _ => Value::Number(match word.parse() {
                    Ok(number) => number,
                    Err(_) => {
                        values.get(word).cloned().ok_or_else(|| format!("unknown: {word}"))?
                    }
                }),
            });
        }
        Term::List(parts) => parts,
    };
    let [Term::Word(operator), operands @ ..] = parts.as_slice() else {
        return Err(format!("no operator: {parts:?}"));
    };
    let number = |term: &Term| match value(term, values)? {
        Value::Number(number) => Ok(number),
        Value::Truth(_) => Err(format!("no number: {term:?}")),
    };
    let truth = |term: &Term| match value(term, values)? {
        Value::Truth(truth) => Ok(truth),
        Value::Number(_) => Err(format!("no truth: {term:?}")),
    };
    Ok(match (operator.as_str(), operands) {
        ("+", all) => {
            Value::Number(all.iter().try_fold(Q::zero(), |s, t| Ok::<_, String>(s + number(t)?))?)
        }
        ("*", all) => {
            Value::Number(all.iter().try_fold(Q::one(), |s, t| Ok::<_, String>(s * number(t)?))?)
        }
        ("-", [one]) => Value::Number(-number(one)?),
        ("-", [a, b]) => Value::Number(number(a)? - number(b)?),
        ("/", [a, b]) => Value::Number(number(a)? / number(b)?),
        ("<", [a, b, c]) => Value::Truth(number(a)? < number(b)? && number(b)? < number(c)?),
        ("=", [a, b]) => Value::Truth(number(a)? == number(b)?),
        (">=", [a, b]) => Value::Truth(number(a)? >= number(b)?),
        (">", [a, b]) => Value::Truth(number(a)? > number(b)?),
        ("<=", [a, b]) => Value::Truth(number(a)? <= number(b)?),
        ("<", [a, b]) => Value::Truth(number(a)? < number(b)?),
        ("ite", [asked, yes, no]) => {
            return value(if truth(asked)? { yes } else { no }, values);
        }
        ("not", [a]) => Value::Truth(!truth(a)?),
        ("and", all) => {
            Value::Truth(all.iter().map(truth).collect::<Result<Vec<_>, _>>()?.iter().all(|t| *t))
        }
        ("or", all) => {
            Value::Truth(all.iter().map(truth).collect::<Result<Vec<_>, _>>()?.iter().any(|t| *t))
        }
        other => return Err(format!("an unknown operation: {other:?}")),
    })
}
