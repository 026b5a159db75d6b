//! The grammar of statements: `var`, `let`, `given`, `claim` and their clauses.

use std::ops::Range;

use kane_algebra::syntax::{
    DeclareError, MAX_PARAMETERS, Parser, Symbol, SyntaxError, SyntaxErrorKind, Token, Value,
    canonical_name,
};
use kane_kernel::{Expr, Link, Relation, Sentence};
use num_rational::BigRational;

use super::citation::{Cited, Draft, DraftBody, DraftClaim, DraftContent};
use super::label::CLAUSES;
use super::sequence::{self, Recursion};
use super::{Fault, Reader, existence, label};
use crate::{Parts, Verdict};

/// The words with which statements begin.
pub(super) const KEYWORDS: [&str; 4] = ["var", "let", "given", "claim"];

impl Reader {
    /// Reads the statement at `span` of `code`, which begins on line `line`.
    pub(super) fn statement(&mut self, code: &str, span: Range<usize>, line: usize) {
        let text = code.get(span.clone()).unwrap_or_default();
        self.declare_sums(span.start);
        let scope = std::mem::take(&mut self.scope);
        let mut parser = Parser::new(text, span.start, &scope);
        let keyword = parser.lexeme();
        if !KEYWORDS.contains(&keyword) {
            let error = parser.unexpected("`var`, `let`, `given` or `claim`");
            self.note_errors(vec![error], None);
            if let (Some(fault), hint @ Some(_)) =
                (self.faults.last_mut(), super::hint::beginning(keyword, KEYWORDS))
            {
                fault.note = hint;
            }
            self.lose(text);
            self.scope = scope;
            return;
        }
        parser.advance();
        if keyword == "var" {
            self.scope = scope;
            let errors = self.symbols(text, span.start);
            if !errors.is_empty() {
                self.lose(text);
            }
            self.note_errors(errors, None);
            self.declare_powers(span.start);
            self.declare_exponentials(span.start);
            return;
        }
        let head = match keyword {
            "let" => let_head(&mut parser),
            _ => labelled_head(&mut parser),
        };
        let head = match head {
            Ok(head) => head,
            Err(error) => {
                self.note_errors(vec![error], None);
                self.lose(text);
                self.scope = scope;
                return;
            }
        };
        let mut faults = Vec::new();
        let mut parts = Parts { label: head.label_span, ..Parts::default() };
        let outcome =
            match keyword {
                "let" if head.recursive => {
                    let parts = sequence::recursion(&mut parser, &head.name);
                    finish(parser, parts).map(|(parts, end)| (Parsed::Recursion(parts), end))
                }
                "let" if sequence::index(&scope, &head.parameters).is_some() => {
                    let term = parser.expr();
                    finish(parser, term).map(|(term, end)| (Parsed::Term(term), end))
                }
                "let" => body_of_let(parser, &head.parameters)
                    .map(|(body, end)| (Parsed::Let(body), end)),
                "given" => given(parser, &mut parts, &mut faults)
                    .map(|(body, end)| (Parsed::Body(body), end)),
                _ => claim(parser, &mut parts, &mut faults)
                    .map(|(body, end)| (Parsed::Body(body), end)),
            };
        if let (Ok((_, end)), Some((_, name))) = (&outcome, &head.name) {
            parts.content = name.start..*end;
        }
        self.scope = scope;
        self.faults.extend(faults);
        let (parsed, end) = match outcome {
            Ok(outcome) => outcome,
            Err(errors) => {
                self.note_errors(errors, head.name.as_ref().map(|(name, _)| name.as_str()));
                (Parsed::Broken, span.end)
            }
        };
        if let Parsed::Body(DraftBody::Claim(claim)) = &parsed {
            for cited in &claim.from {
                self.differentiate(cited);
            }
        }
        // a broken statement keeps its label and its name, lest every use of them be a fault too
        let takes = head.parameters.len();
        let index = sequence::index(&self.scope, &head.parameters);
        let body = match (parsed, head.name) {
            (Parsed::Let(body), Some((name, site))) => self.define(&name, site, takes, body),
            (Parsed::Term(term), Some((name, site))) => self.define_term(&name, site, index, term),
            (Parsed::Recursion(parts), Some((name, site))) => {
                self.define_recursion(&name, site, parts)
            }
            (Parsed::Broken, Some((name, site))) => {
                let one = Expr::Num(BigRational::from_integer(1.into()));
                self.define(&name, site, takes, Value::Number(one))
            }
            (Parsed::Body(body), _) => body,
            (Parsed::Broken | Parsed::Let(_) | Parsed::Term(_) | Parsed::Recursion(_), _) => {
                DraftBody::Broken
            }
        };
        self.refuse_indices(&body, &parts);
        self.declare_powers(span.start);
        self.enter(Draft { label: head.label, parts, body, span: span.start..end, line });
    }

    fn note_errors(&mut self, errors: Vec<SyntaxError>, defined: Option<&str>) {
        for SyntaxError { kind, span } in errors {
            let mut fault = Fault::new(span, kind.to_string());
            fault.note = kind.hint().map(str::to_owned);
            self.met.learn(&kind, self.count);
            if let SyntaxErrorKind::UnknownSymbol(name) = kind {
                if defined.is_some_and(|own| canonical_name(own) == canonical_name(&name)) {
                    fault.message = format!("cycle: `{name}` is defined in terms of itself");
                } else {
                    fault.unknown = Some(name);
                }
            }
            self.faults.push(fault);
        }
    }

    pub(super) fn enter(&mut self, draft: Draft) {
        let index = self.drafts.len();
        let first = *self.labels.entry(label::key(&draft.label)).or_insert(index);
        if let Some(first) = self.drafts.get(first) {
            let message = format!("duplicate label `{}`", draft.label);
            let note = format!("`{}` on line {} has it already", first.label, first.line);
            self.faults.push(Fault::new(draft.parts.label.clone(), message).with_note(note));
        }
        self.drafts.push(draft);
    }

    fn define(&mut self, name: &str, site: Range<usize>, takes: usize, body: Value) -> DraftBody {
        if takes == 0 && !self.is_free_of_indices(name, &site, body.parts()) {
            return DraftBody::Broken;
        }
        let defined = match body {
            body if takes > 0 => {
                self.scope.define_function(name, takes, body).map(|()| DraftBody::Defined(vec![]))
            }
            Value::Number(body) => self.scope.define(name, body).map(DraftBody::Let),
            Value::Array(array) => {
                let names = array.shape.names(name);
                let parts = names.iter().zip(array.parts);
                let parts = parts.map(|(part, body)| self.scope.define(part, body));
                parts.collect::<Result<Vec<usize>, _>>().and_then(|parts| {
                    let symbols = parts.iter().copied().map(Symbol::Let).collect();
                    self.scope.declare_array(name, array.shape, symbols)?;
                    Ok(DraftBody::Defined(parts))
                })
            }
        };
        self.let_sites.resize(self.scope.context().lets.len(), site.start);
        defined.unwrap_or_else(|error| {
            self.refuse(&error, site);
            DraftBody::Broken
        })
    }

    pub(super) fn refuse(&mut self, error: &DeclareError, site: Range<usize>) {
        let mut fault = Fault::new(site, error.to_string());
        if let DeclareError::Redeclared { first, .. } = error {
            fault.note = Some(match first {
                Symbol::Var(_) => "as a `var`, above".to_owned(),
                Symbol::Let(_) => "by a `let`, above".to_owned(),
            });
        }
        self.faults.push(fault);
    }
}

enum Parsed {
    Let(Value),
    /// the term of a sequence at its index
    Term(Expr),
    Recursion(Recursion),
    Body(DraftBody),
    Broken,
}

/// What stands before the body of a `let`, `given` or `claim`.
struct Head {
    label: String,
    label_span: Range<usize>,
    /// the name that a `let` defines
    name: Option<(String, Range<usize>)>,
    /// the names of its arguments
    parameters: Vec<(String, Range<usize>)>,
    /// whether it defines the first term of a sequence, and then the others
    recursive: bool,
}

/// `LABEL:`
fn labelled_head(p: &mut Parser<'_>) -> Result<Head, SyntaxError> {
    let (label, label_span) = label::take(p)?;
    p.expect(Token::Colon, "`:` after the label, as in `given NAME: a = b`")?;
    Ok(Head {
        label: label.to_owned(),
        label_span,
        name: None,
        parameters: Vec::new(),
        recursive: false,
    })
}

/// `[LABEL] NAME[(x, …)] :=`
fn let_head(p: &mut Parser<'_>) -> Result<Head, SyntaxError> {
    let (rest, _) = p.rest();
    // two words in a row are a label and a name
    let is_name = !rest.starts_with('(')
        && label::length(rest)
            .and_then(|length| rest.get(length..))
            .is_some_and(|after| !after.trim_start().starts_with(char::is_alphabetic));
    let label = if is_name { None } else { Some(label::take(p)?) };
    let (name, site) = p.name()?;
    let (mut parameters, mut recursive) = (Vec::new(), false);
    if p.accept(Token::OpenParen) {
        if p.token() == Token::Number {
            recursive = true;
            sequence::zero(p)?;
        } else {
            parameters = bound_names(p)?;
        }
        p.expect(Token::CloseParen, "`)` after the names of the arguments")?;
    }
    p.expect(Token::Define, "`:=` after the name")?;
    let (label, label_span) = label.unwrap_or((name, site.clone()));
    let name = Some((name.to_owned(), site));
    Ok(Head { label: label.to_owned(), label_span, name, parameters, recursive })
}

/// Citations of derivatives in one statement that are looked into.
const MAX_DERIVATIVES: usize = 100;

type Outcome<T> = Result<(T, usize), Vec<SyntaxError>>;

/// Ends the statement: its value and where it ends, or all its faults.
fn finish<T>(p: Parser<'_>, result: Result<T, SyntaxError>) -> Outcome<T> {
    let end = p.last_end();
    p.finish(result).map(|value| (value, end))
}

fn body_of_let(mut p: Parser<'_>, parameters: &[(String, Range<usize>)]) -> Outcome<Value> {
    bind(&mut p, parameters);
    let body = p.value();
    if let Ok(body) = &body {
        existence::refuse_unused(&mut p, parameters, body.parts());
    }
    finish(p, body)
}

/// Names with commas between, each of which is to stand for an argument or a witness.
pub(super) fn bound_names(p: &mut Parser<'_>) -> Result<Vec<(String, Range<usize>)>, SyntaxError> {
    let mut names: Vec<(String, Range<usize>)> = Vec::new();
    loop {
        if names.len() == MAX_PARAMETERS {
            return Err(p.fault(SyntaxErrorKind::TooManyNames));
        }
        let (name, span) = p.name()?;
        names.push((name.to_owned(), span));
        if !p.next_item(names.len())? {
            return Ok(names);
        }
    }
}

/// Has names stand for placeholders; notes those that mean something already.
pub(super) fn bind(p: &mut Parser<'_>, names: &[(String, Range<usize>)]) {
    let mut bound: Vec<String> = Vec::new();
    for (name, span) in names {
        let canonical = canonical_name(name).into_owned();
        if !p.scope().is_unused(name) {
            p.report(SyntaxErrorKind::Shadowed(name.clone()), span.clone());
        } else if bound.contains(&canonical) {
            p.report(SyntaxErrorKind::NamedTwice(name.clone()), span.clone());
        }
        bound.push(canonical);
    }
    p.bind(bound);
}

/// Where what a parser reads stands.
fn placed<'a, T>(
    p: &mut Parser<'a>,
    read: impl FnOnce(&mut Parser<'a>) -> Result<T, SyntaxError>,
) -> Result<(T, Range<usize>), SyntaxError> {
    let start = p.span().start;
    let value = read(p)?;
    Ok((value, start..p.last_end()))
}

/// A clause that begins with this word, with its place; nothing where another word is ahead.
fn clause<'a, T: Default>(
    p: &mut Parser<'a>,
    word: &str,
    read: impl FnOnce(&mut Parser<'a>) -> Result<T, SyntaxError>,
) -> Result<(T, Option<Range<usize>>), SyntaxError> {
    if !p.at_word(word) {
        return Ok((T::default(), None));
    }
    let (value, place) = placed(p, |p| {
        p.advance();
        read(p)
    })?;
    Ok((value, Some(place)))
}

/// `RELATION [as x -> a] [when RELATION]`
fn given(mut p: Parser<'_>, parts: &mut Parts, faults: &mut Vec<Fault>) -> Outcome<DraftBody> {
    let sentence = (|| {
        let (links, when);
        if p.at_word("exists") {
            return Err(
                p.unexpected("a relation (what exists is declared by `var`: it has a name)")
            );
        }
        (links, parts.content) = placed(&mut p, Parser::links)?;
        (when, parts.when) = clause(&mut p, "when", |p| conditions(p, &links, faults))?;
        refuse_clauses(&p, &["when"])?;
        let links = links.into_iter().map(|(link, _)| link).collect();
        Ok(DraftBody::Given(Sentence { when, links }))
    })();
    finish(p, sentence)
}

/// `RELATION [as x -> a] | exists y: RELATION | contradiction | not implied M`, then
/// `[when RELATION] [from …] [using EXPR, …] [by f := …, …] [expect VERDICT]`
fn claim(mut p: Parser<'_>, parts: &mut Parts, faults: &mut Vec<Fault>) -> Outcome<DraftBody> {
    let claim = (|| {
        let (mut content, mut by, when, from, using, expect);
        let mut induction = None;
        let (mut bound, mut sought) = (Vec::new(), Vec::new());
        (content, parts.content) = placed(&mut p, |p| content_of_claim(p, &mut bound))?;
        p.bind(Vec::new());
        let links = match &content {
            DraftContent::Links(links) => links.as_slice(),
            _ => &[],
        };
        let start = p.span().start;
        let range = sequence::range(&mut p, &content)?;
        (when, parts.when) = clause(&mut p, "when", |p| conditions(p, links, faults))?;
        let mut when: Vec<Relation> = when;
        if let Some(range) = &range {
            when.insert(0, range.condition());
            parts.when = Some(start..p.last_end());
        }
        (from, parts.from) = clause(&mut p, "from", |p| {
            let mut from = vec![cited(p)?];
            while p.next_item(from.len())? {
                from.push(cited(p)?);
            }
            let ends = matches!(p.token(), Token::End | Token::Semicolon);
            match ends || CLAUSES.contains(&p.lexeme()) {
                true => Ok(from),
                false => Err(p.unexpected(
                    "`,` and another label, or the end (a condition stands behind `when`, before `from`)",
                )),
            }
        })?;
        let mut allowed = vec!["when", "from", "expect"];
        let at_points = match &content {
            DraftContent::Links(links) => {
                links.iter().all(|(link, _)| matches!(link, Link::Relation(_)))
            }
            DraftContent::Contradiction => true,
            DraftContent::NotImplied(_) => false,
        };
        (using, parts.using) = if at_points {
            allowed.push("using");
            clause(&mut p, "using", hints)?
        } else {
            (Vec::new(), None)
        };
        by = Vec::new();
        if !bound.is_empty() {
            allowed.push("by");
            let values;
            (values, parts.by) = clause(&mut p, "by", |p| existence::witnesses(p, &bound))?;
            if parts.by.is_some() {
                existence::put_in(&mut p, &bound, values, &mut content)?;
            } else {
                sought = existence::sought(&mut p, &bound, &content)?;
            }
        } else if matches!(content, DraftContent::Links(_)) && at_points {
            let shown;
            (shown, parts.by) = clause(&mut p, "by", |p| sequence::induction(p, range).map(Some))?;
            induction = shown;
        } else if matches!(content, DraftContent::NotImplied(_)) {
            allowed.push("by");
            (by, parts.by) = clause(&mut p, "by", |p| witness(p, faults))?;
        }
        (expect, parts.expect) = clause(&mut p, "expect", |p| verdict(p).map(Some))?;
        refuse_clauses(&p, &allowed)?;
        let exists = !bound.is_empty();
        let claim =
            DraftClaim { content, exists, sought, when, induction, from, using, by, expect };
        Ok(DraftBody::Claim(claim))
    })();
    finish(p, claim)
}

/// `RELATION [as x -> a] | exists y: RELATION | contradiction | not implied M`
fn content_of_claim(
    p: &mut Parser<'_>,
    bound: &mut Vec<(String, Range<usize>)>,
) -> Result<DraftContent, SyntaxError> {
    if p.accept_word("exists") {
        *bound = bound_names(p)?;
        bind(p, bound);
        p.expect(Token::Colon, "`:` after what exists")?;
        Ok(DraftContent::Links(existence::relations(p)?))
    } else if p.accept_word("contradiction") {
        Ok(DraftContent::Contradiction)
    } else if p.accept_word("not") {
        if !p.accept_word("implied") {
            return Err(p.unexpected("`implied`"));
        }
        Ok(DraftContent::NotImplied(cited(p)?))
    } else {
        Ok(DraftContent::Links(p.links()?))
    }
}

/// Explains a clause that stands where it cannot.
fn refuse_clauses(p: &Parser<'_>, allowed: &[&str]) -> Result<(), SyntaxError> {
    let word = p.lexeme();
    if p.token() != Token::Name || !CLAUSES.contains(&word) {
        return Ok(());
    }
    Err(p.unexpected(if allowed.contains(&word) {
        "the clauses once each and in the order `as`, `when`, `from`, `using`, `by`, `expect`"
    } else if word == "by" {
        "the end (only `exists` and `not implied` take `by`, and relations `by induction`)"
    } else if word == "using" {
        "the end (only a claim about points takes `using`, not a limit and not `not implied`)"
    } else if word == "as" {
        "the end (`as` follows the limit)"
    } else {
        "the end (only a claim takes `from` and `expect`)"
    }))
}

fn cited(p: &mut Parser<'_>) -> Result<Cited, SyntaxError> {
    let (rest, at) = p.rest();
    if let Some(inside) = rest.strip_prefix("d(") {
        let start = p.span().start;
        if inside.matches("d(").count() > MAX_DERIVATIVES {
            return Err(p.fault(SyntaxErrorKind::TooNested));
        }
        p.take_until(at + 2);
        let inner = cited(p)?;
        p.expect(Token::Comma, "`,` and the variable of differentiation")?;
        let (variable, _) = p.name()?;
        p.expect(Token::CloseParen, "`)` after the variable of differentiation")?;
        let label = format!("d({}, {variable})", inner.label);
        let derivative = Some((Box::new(inner), variable.to_owned()));
        return Ok(Cited { label, span: start..p.last_end(), derivative });
    }
    let (label, span) = label::take(p)?;
    Ok(Cited { label: label.to_owned(), span, derivative: None })
}

/// `RELATION` of a `when`. Beside a limit it must leave the limit variable free.
fn conditions(
    p: &mut Parser<'_>,
    links: &[(Link, Range<usize>)],
    faults: &mut Vec<Fault>,
) -> Result<Vec<Relation>, SyntaxError> {
    let relations = p.spanned_relations()?;
    let limit = links.iter().find_map(|(link, _)| match link {
        Link::Limit(limit) => Some(limit),
        Link::Relation(_) => None,
    });
    if let Some(limit) = limit {
        let scope = p.scope();
        let moving = scope.shifted_by(limit.var).unwrap_or(limit.var);
        let name = scope.context().vars.get(moving).map_or("", |v| &v.name);
        for (relation, span) in &relations {
            let varies = |side| scope.varies_with(side, moving);
            if varies(&relation.lhs) || varies(&relation.rhs) {
                let message = format!("the `when` of a limit must be free of `{name}`");
                let note = format!("the limit is taken inside the domain of `{name}`");
                faults.push(Fault::new(span.clone(), message).with_note(note));
            }
        }
    }
    Ok(relations.into_iter().map(|(relation, _)| relation).collect())
}

/// `EXPR, …`
fn hints(p: &mut Parser<'_>) -> Result<Vec<Expr>, SyntaxError> {
    let mut using = vec![p.expr()?];
    while p.next_item(using.len())? {
        using.push(p.expr()?);
    }
    Ok(using)
}

/// `f := EXPR, …`
fn witness(p: &mut Parser<'_>, faults: &mut Vec<Fault>) -> Result<Vec<(usize, Expr)>, SyntaxError> {
    let mut by: Vec<(usize, Expr)> = Vec::new();
    loop {
        let (name, span) = p.name()?;
        p.expect(Token::Define, "`:=` and a value or function")?;
        let value = p.expr()?;
        match p.scope().resolve(name) {
            Some(Symbol::Var(index)) if p.scope().angle(index).is_some() => {
                faults
                    .push(Fault::new(span, format!("`{name}` is an angle, and has no value here")));
            }
            Some(Symbol::Var(index)) if by.iter().any(|(seen, _)| *seen == index) => {
                faults.push(Fault::new(span, format!("`{name}` is given twice")));
            }
            Some(Symbol::Var(index)) => by.push((index, value)),
            Some(Symbol::Let(_)) => {
                let message = format!("`{name}` is a definition and has its value already");
                faults.push(Fault::new(span, message));
            }
            None => p.report(SyntaxErrorKind::UnknownSymbol(name.to_owned()), span),
        }
        if !p.next_item(by.len())? {
            return Ok(by);
        }
    }
}

fn verdict(p: &mut Parser<'_>) -> Result<Verdict, SyntaxError> {
    const WORDS: [Verdict; 6] = [
        Verdict::Proved,
        Verdict::Refuted,
        Verdict::Vacuous,
        Verdict::IllDefined,
        Verdict::Unsupported,
        Verdict::Undecided,
    ];
    let (rest, start) = p.rest();
    let length = label::length(rest).unwrap_or(0);
    let word = rest.get(..length).unwrap_or_default();
    match WORDS.into_iter().find(|v| v.to_string() == word) {
        Some(verdict) => {
            p.take_until(start + length);
            Ok(verdict)
        }
        None => Err(p.unexpected(
            "`proved`, `refuted`, `vacuous`, `ill-defined`, `unsupported` or `undecided`",
        )),
    }
}
