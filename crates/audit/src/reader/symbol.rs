//! `var`: symbols and their domains.

use std::ops::Range;

use kane_algebra::syntax::{Endpoint, Parser, Shape, Symbol, SyntaxError, Token, canonical_name};
use kane_kernel::{Bound, Expr, Rel, Var};
use num_rational::BigRational;

use super::unit::{self, Dimension};
use super::{Fault, MAX_SYMBOLS, Reader};

impl Reader {
    /// Enters the symbols.
    pub(super) fn declare(&mut self, vars: Vec<Item>) {
        for item in vars {
            match item.shape {
                Some(shape) => self.declare_array(item, shape),
                None => self.declare_one(item),
            }
        }
    }

    /// Enters the components of a vector or a matrix, and its name.
    fn declare_array(&mut self, item: Item, shape: Shape) {
        if item.is_bounded() {
            let message = format!("`{}` is {shape} and has no bounds", item.name);
            let note = format!("state them of `{}`", shape.names(&item.name).join("`, `"));
            self.faults.push(Fault::new(item.whole, message).with_note(note));
            return;
        }
        let mut parts = Vec::new();
        for name in shape.names(&item.name) {
            self.declare_one(Item { name: name.clone(), ..item.clone() });
            parts.extend(self.scope.resolve(&name));
        }
        if parts.len() == shape.count()
            && let Err(error) = self.scope.declare_array(&item.name, shape, parts)
        {
            self.refuse(&error, item.span);
        }
    }

    fn declare_one(&mut self, item: Item) {
        let first = self.scope.context().vars.len();
        let unit = item.unit.clone();
        self.declare_number(item);
        // an angle declares more symbols behind itself
        if let Some(unit) = unit.filter(|_| self.scope.context().vars.len() > first) {
            self.units.insert(first, unit);
        }
    }

    fn declare_number(&mut self, item: Item) {
        if self.var_sites.len() == MAX_SYMBOLS {
            let message = format!("more than {MAX_SYMBOLS} symbols");
            self.faults.push(Fault::new(item.span, message));
            return;
        }
        if item.natural {
            self.declare_index(&item);
            return;
        }
        let of = item.of.clone().and_then(|(name, span)| self.argument(&name, span));
        if let Some(parts) = self.wanted.parts(&item.name) {
            self.declare_angle(item, of, parts);
            return;
        }
        if item.turns.iter().any(Option::is_some) {
            let message =
                format!("`{}` is bounded by multiples of `pi`, but is no angle", item.name);
            let note = "an angle is what stands inside `sin`, `cos` or `tan`";
            self.faults.push(Fault::new(item.whole.clone(), message).with_note(note));
        }
        if is_empty(item.lower.as_ref(), item.upper.as_ref()) {
            let message = format!("the domain of `{}` is empty", item.name);
            self.faults.push(Fault::new(item.whole.clone(), message));
        }
        let (name, lower, upper) = (item.name.clone(), item.lower.clone(), item.upper.clone());
        match self.scope.declare(Var { name, of, lower, upper }) {
            Ok(symbol) => {
                self.var_sites.push(item.span.start);
                self.declare_bounds(symbol, &item);
                self.declare_rates(symbol, &item.name, item.span.clone());
                if self.wanted.is_limited(&item.name) {
                    self.scope.declare_limited(symbol);
                }
                if self.wanted.is_shifted(&item.name) {
                    self.declare_shift(symbol, &item);
                }
            }
            Err(error) => self.refuse(&error, item.span),
        }
    }

    /// Enters the distance of a symbol from the point to which it tends.
    fn declare_shift(&mut self, symbol: usize, item: &Item) {
        if let Err(error) = self.scope.declare_shift(symbol) {
            self.refuse(&error, item.span.clone());
        }
        self.var_sites.resize(self.scope.context().vars.len(), item.span.start);
    }

    /// Enters the derivatives that are spoken of.
    pub(super) fn declare_rates(&mut self, symbol: usize, name: &str, span: Range<usize>) {
        if let Err(error) = self.scope.declare_rates(symbol, self.wanted.order(name)) {
            self.refuse(&error, span.clone());
        }
        self.var_sites.resize(self.scope.context().vars.len(), span.start);
    }

    /// The symbol of which a function is declared.
    fn argument(&mut self, name: &str, span: Range<usize>) -> Option<usize> {
        let fault = match self.scope.resolve(name) {
            Some(Symbol::Var(x)) if self.scope.angle(x).is_some() => {
                Fault::new(span, format!("`{name}` is an angle"))
                    .with_note("a function varies with a plain `var`")
            }
            Some(Symbol::Var(x)) if self.scope.sequences().index_of(x).is_some() => {
                Fault::new(span, format!("`{name}` is an index"))
                    .with_note("a sequence is defined by `let s(0) := …, s(n + 1) := …`")
            }
            Some(Symbol::Var(x)) => {
                let is_plain = |var: &Var| var.of.is_none();
                if self.scope.context().vars.get(x).is_some_and(is_plain) {
                    return Some(x);
                }
                Fault::new(span, format!("`{name}` is itself a function"))
                    .with_note("a function varies with a plain `var`")
            }
            Some(Symbol::Let(_)) => Fault::new(span, format!("`{name}` is a definition"))
                .with_note("a function varies with a plain `var`"),
            None => {
                let mut fault = Fault::new(span, format!("unknown symbol `{name}`"));
                fault.unknown = Some(name.to_owned());
                fault
            }
        };
        self.faults.push(fault);
        None
    }
}

/// A symbol before it is entered.
#[derive(Clone)]
pub(super) struct Item {
    pub(super) name: String,
    pub(super) span: Range<usize>,
    /// name and bounds
    pub(super) whole: Range<usize>,
    pub(super) of: Option<(String, Range<usize>)>,
    /// of a vector or a matrix
    shape: Option<Shape>,
    /// whether it is an index
    natural: bool,
    unit: Option<Dimension>,
    pub(super) lower: Option<Bound>,
    pub(super) upper: Option<Bound>,
    /// lower and upper bound as multiples of π, and whether they are strict
    pub(super) turns: [Option<(BigRational, bool)>; 2],
    /// lower and upper bound as expressions
    pub(super) ends: [Option<End>; 2],
}

/// A bound that is an expression.
#[derive(Clone)]
pub(super) struct End {
    pub(super) value: Expr,
    pub(super) strict: bool,
    pub(super) span: Range<usize>,
}

impl Reader {
    /// Reads `[bound <] NAME[(x)] [< bound], …` and enters the symbols; after a fault it goes on behind
    /// the next comma. Passes the errors that end an item.
    pub(super) fn symbols(&mut self, text: &str, start: usize) -> Vec<SyntaxError> {
        let (mut errors, mut at, mut count) = (Vec::new(), 0, 0);
        loop {
            // a bound may speak of the symbol before
            let scope = std::mem::take(&mut self.scope);
            let mut p = Parser::new(text.get(at..).unwrap_or_default(), start + at, &scope);
            let mut items = Vec::new();
            if count == 0 {
                p.advance();
            }
            if let Err(error) = item(&mut p, &mut items, &mut self.faults) {
                errors.push(error);
                while !matches!(p.token(), Token::Comma | Token::End) {
                    p.advance();
                }
            }
            if p.token() != Token::Comma && p.token() != Token::End {
                errors.extend(p.expect_end().err());
                while !matches!(p.token(), Token::Comma | Token::End) {
                    p.advance();
                }
            }
            count += 1;
            let more = p.next_item(count);
            at = p.span().start - start;
            errors.extend(p.into_faults());
            self.scope = scope;
            self.declare(items);
            match more {
                Ok(true) => {}
                Ok(false) => return errors,
                Err(error) => {
                    errors.push(error);
                    return errors;
                }
            }
        }
    }
}

fn item(
    p: &mut Parser<'_>,
    items: &mut Vec<Item>,
    faults: &mut Vec<Fault>,
) -> Result<(), SyntaxError> {
    if p.token() == Token::Bar {
        return Err(p.unexpected("a name, with its bounds beside it, as in `-1 < x < 1`"));
    }
    let start = p.span().start;
    let left = if begins_with_pi(p) || p.bound_stands_first() {
        let end = p.bound()?;
        let rel = bound_relation(p)?;
        Some((mirrored(rel), end))
    } else {
        None
    };
    let (name, span) = p.name()?;
    let mut of = None;
    if p.accept(Token::OpenParen) {
        let (x, x_span) = p.name()?;
        of = Some((x.to_owned(), x_span));
        p.expect(Token::CloseParen, "`)` after the one argument")?;
    }
    items.push(Item {
        name: name.to_owned(),
        span: span.clone(),
        whole: start..p.last_end(),
        of,
        shape: None,
        natural: false,
        unit: None,
        lower: None,
        upper: None,
        turns: [None, None],
        ends: [None, None],
    });
    let right = if matches!(p.token(), Token::Rel(_)) {
        let rel = bound_relation(p)?;
        Some((rel, p.bound()?))
    } else {
        None
    };
    let within = p.accept_word("in");
    let natural = within && p.accept_word("N");
    let shape = if within && !natural { Some(space(p)?) } else { None };
    let item = items.last_mut().expect("an item was pushed just now");
    (item.shape, item.natural) = (shape, natural);
    item.whole.end = p.last_end();
    let unit = if p.token() == Token::OpenBracket { Some(unit::unit(p)?) } else { None };
    let item = items.last_mut().expect("an item was pushed just now");
    item.unit = unit;
    for (rel, end) in left.into_iter().chain(right) {
        if let Err(message) = item.bind(rel, end) {
            faults.push(Fault::new(item.whole.clone(), message));
        }
    }
    Ok(())
}

/// `R^2`, `R^3`, `R^2x2` or `R^3x3`
fn space(p: &mut Parser<'_>) -> Result<Shape, SyntaxError> {
    const SPACES: &str =
        "`R^2`, `R^3`, `R^2x2` or `R^3x3`, or `N` of an index (a number needs no `in`)";
    if !p.accept_word("R") {
        return Err(p.unexpected(SPACES));
    }
    if p.token() != Token::Superscript {
        p.expect(Token::Caret, SPACES)?;
    }
    let shape = match p.lexeme() {
        "2" | "²" => Shape::Vector(2),
        "3" | "³" => Shape::Vector(3),
        "2x2" => Shape::Matrix(2),
        "3x3" => Shape::Matrix(3),
        _ => return Err(p.unexpected(SPACES)),
    };
    let is_vector = matches!(shape, Shape::Vector(_));
    p.advance();
    // with a sign of multiplication, too
    if is_vector && p.token() == Token::Star {
        p.advance();
        return match (shape, p.lexeme()) {
            (Shape::Vector(n), "2" | "3") if p.lexeme() == n.to_string() => {
                p.advance();
                Ok(Shape::Matrix(n))
            }
            _ => Err(p.unexpected(SPACES)),
        };
    }
    Ok(shape)
}

/// Whether the item begins with a bound such as `pi/2`, and not with a symbol that is called `pi`.
fn begins_with_pi(p: &Parser<'_>) -> bool {
    let (rest, _) = p.rest();
    let item = rest.split(',').next().unwrap_or_default();
    let words = item.split(|c: char| !c.is_alphanumeric() && !"_'′".contains(c));
    let mut names = words.filter(|word| word.starts_with(char::is_alphabetic)).map(canonical_name);
    names.next().is_some_and(|name| name == "pi") && names.any(|name| name != "pi")
}

/// `<`, `<=`, `>` or `>=`
fn bound_relation(p: &mut Parser<'_>) -> Result<Rel, SyntaxError> {
    match p.token() {
        Token::Rel(rel @ (Rel::Lt | Rel::Le | Rel::Gt | Rel::Ge)) => {
            p.advance();
            Ok(rel)
        }
        Token::Rel(_) => Err(p.unexpected("`<`, `<=`, `>` or `>=` (an equation is a `given`)")),
        _ => Err(p.unexpected("`<`, `<=`, `>` or `>=`")),
    }
}

/// b ⋈ x as x ⋈′ b
fn mirrored(rel: Rel) -> Rel {
    match rel {
        Rel::Lt => Rel::Gt,
        Rel::Le => Rel::Ge,
        Rel::Gt => Rel::Lt,
        Rel::Ge => Rel::Le,
        Rel::Eq | Rel::Ne => rel,
    }
}

impl Item {
    /// Whether there is a bound of any kind.
    pub(super) fn is_bounded(&self) -> bool {
        let turns = self.turns.iter().any(Option::is_some);
        turns
            || self.lower.is_some()
            || self.upper.is_some()
            || self.ends.iter().any(Option::is_some)
    }

    /// The ends of an angle's range as multiples of π, and whether they are strict.
    pub(super) fn range_in_turns(&self) -> [Option<(BigRational, bool)>; 2] {
        let zero =
            |bound: &Option<Bound>| bound.as_ref().map(|bound| (bound.value.clone(), bound.strict));
        let [lower, upper] = self.turns.clone();
        [lower.or_else(|| zero(&self.lower)), upper.or_else(|| zero(&self.upper))]
    }

    /// Takes in `x ⋈ end`.
    fn bind(&mut self, rel: Rel, end: Endpoint) -> Result<(), String> {
        let is_lower = matches!(rel, Rel::Gt | Rel::Ge);
        let strict = matches!(rel, Rel::Lt | Rel::Gt);
        let side = usize::from(!is_lower);
        let is_bound = [&self.lower, &self.upper][side].is_some() || self.ends[side].is_some();
        let value = match end {
            Endpoint::Finite(value) if self.ends[side].is_none() => value,
            Endpoint::Expression(value, span) if !is_bound => {
                self.ends[side] = Some(End { value, strict, span });
                return Ok(());
            }
            Endpoint::Finite(_) | Endpoint::Expression(..) => {
                let side = if is_lower { "lower" } else { "upper" };
                return Err(format!("`{}` has two {side} bounds", self.name));
            }
            Endpoint::HalfTurns(value) => {
                let slot = &mut self.turns[side];
                return match slot.replace((value, strict)) {
                    None => Ok(()),
                    Some(_) => Err(format!("`{}` is bounded twice on one side", self.name)),
                };
            }
            Endpoint::MinusInf if is_lower => return Ok(()),
            Endpoint::PlusInf if !is_lower => return Ok(()),
            Endpoint::PlusInf | Endpoint::MinusInf => {
                return Err(format!("the domain of `{}` is empty", self.name));
            }
        };
        let bound = Bound { value, strict };
        let (slot, side) =
            if is_lower { (&mut self.lower, "lower") } else { (&mut self.upper, "upper") };
        if slot.replace(bound).is_some() {
            return Err(format!("`{}` has two {side} bounds", self.name));
        }
        Ok(())
    }
}

fn is_empty(lower: Option<&Bound>, upper: Option<&Bound>) -> bool {
    match (lower, upper) {
        (Some(l), Some(u)) => l.value > u.value || (l.value == u.value && (l.strict || u.strict)),
        _ => false,
    }
}
