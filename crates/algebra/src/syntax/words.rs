//! What begins with a word: names, functions, derivatives and cases.

use std::ops::Range;
use std::rc::Rc;

use kane_kernel::Expr;
use num_bigint::BigInt;

use super::angle::{Direction, Turn, negative, product, sum};
use super::arrays::FUNCTIONS;
use super::bounds::MAX_ITEMS;
use super::error::{SyntaxError, SyntaxErrorKind};
use super::exponential::{by_factor, exponential, logarithm};
use super::lexer::Token;
use super::names::{PI, canonical_name};
use super::parser::{Node, Parser, excerpt};
use super::rate::rate;
use super::scope::{Angle, Scope, Symbol};
use super::sequence::MAX_INDEX;
use super::template::{parameter, placeholder, substituted, written};
use super::value::{Value, size};

/// Makes an expression of two.
type Binary = fn(Rc<Expr>, Rc<Expr>) -> Expr;

/// d f / dθ = ∂f/∂θ + (∂f/∂s·c − ∂f/∂c·s)/n for the cosine c and the sine s of θ/n. Where both parts have a
/// value f is one differentiable expression in c and s near the point, and the chain rule holds.
fn by_angle(f: &Expr, (theta, angle): (usize, Angle), scope: &Scope) -> Expr {
    let known = scope.symbols(f);
    let part = |by: usize, times: usize| match known.contains(&by) {
        true => product(Expr::Deriv(f.clone().into(), by), Expr::Var(times)),
        false => Expr::int(0),
    };
    let (up, down) = (part(angle.sin, angle.cos), part(angle.cos, angle.sin));
    let slope = match (up == Expr::int(0), down == Expr::int(0)) {
        (_, true) => up,
        (true, false) => negative(down),
        (false, false) => Expr::Sub(up.into(), down.into()),
    };
    let slope = match angle.parts {
        1 => slope,
        n => Expr::Div(slope.into(), Expr::int(n.into()).into()),
    };
    // where the angle stands by itself, too
    match known.contains(&theta) {
        true => sum(Expr::Deriv(f.clone().into(), theta), slope),
        false => slope,
    }
}

impl Parser<'_> {
    /// Passes a name, or what its reserved word begins.
    pub(crate) fn word(&mut self) -> Result<Node, SyntaxError> {
        match self.lexeme() {
            "abs" => self.call(|p| p.unary_call(Expr::Abs)),
            "sqrt" => self.call(|p| p.unary_call(Expr::Sqrt)),
            "min" => self.call(|p| p.binary_call(Expr::Min)),
            "max" => self.call(|p| p.binary_call(Expr::Max)),
            "d" => self.derivative_call(),
            "cases" => self.cases(),
            word @ ("sin" | "cos" | "tan") if self.scope().is_unused(word) => {
                self.call(|p| p.direction(word))
            }
            "exp" if self.scope().is_unused("exp") => self.call(|p| p.lowered(exponential)),
            "log" if self.scope().is_unused("log") => self.call(|p| p.lowered(logarithm)),
            "pow" if self.scope().is_unused("pow") => self.power_call(),
            word @ ("sum" | "prod") if self.scope().is_unused(word) => self.summation(),
            word => match FUNCTIONS.into_iter().find(|function| *function == word) {
                Some(function) if self.scope().is_unused(word) => self.function_of_arrays(function),
                _ => self.named(),
            },
        }
    }

    /// Passes the name of a symbol, of a definition, or of what stands for an argument.
    fn named(&mut self) -> Result<Node, SyntaxError> {
        let (name, span) = self.name()?;
        if let Some(value) = self.local(name, &span) {
            let height = self.scope().height(&value);
            return self.build(value, span, height);
        }
        if let Some(bound) = self.bound.iter().position(|b| *b == canonical_name(name)) {
            if let Some(index) = self.recursion {
                return self.last_term(index, span);
            }
            return self.build(placeholder(bound), span, 1);
        }
        if self.scope().is_function(name) {
            return self.application(name, span);
        }
        if self.scope().is_sequence(name) {
            return self.term(name, span);
        }
        if let Some(array) = self.scope().array(name) {
            let height = array.parts.iter().map(|e| self.scope().height(e)).max();
            return self.build_value(Value::Array(array), span, height.unwrap_or(1));
        }
        let (expr, height) = match self.scope().resolve(name) {
            // whatever a symbol of that name stands for elsewhere
            _ if self.in_angle && canonical_name(name) == "pi" => (Expr::Var(PI), 1),
            Some(Symbol::Var(index)) => {
                if self.in_term && self.scope().sequences().index_of(index).is_some() {
                    self.report(SyntaxErrorKind::IndexInTerm(excerpt(name)), span.clone());
                }
                if !self.in_angle && self.scope().is_unmeasured(index) {
                    self.report(SyntaxErrorKind::AngleAlone(excerpt(name)), span.clone());
                }
                (Expr::Var(index), 1)
            }
            Some(Symbol::Let(index)) => (Expr::Let(index), self.scope().height_of_let(index) + 1),
            None => {
                let kind = SyntaxErrorKind::UnknownSymbol(excerpt(name));
                self.report(kind, span.clone());
                (Expr::Num(BigInt::from(1).into()), 1)
            }
        };
        self.build(expr, span, height)
    }

    /// Passes `(n)` behind the name of the sequence that is being defined.
    fn last_term(&mut self, index: usize, span: Range<usize>) -> Result<Node, SyntaxError> {
        let (name, at) = (self.bound.first().cloned().unwrap_or_default(), self.span());
        let vars = &self.scope().context().vars;
        let n = vars.get(index).map_or_else(String::new, |var| var.name.clone());
        if !self.accept(Token::OpenParen) {
            self.report(SyntaxErrorKind::TermAlone(name), span.clone());
            return self.build(placeholder(0), span, 1);
        }
        let argument = self.nested(Self::node)?;
        let argument = self.number_of(argument);
        let end = self.close(Token::CloseParen, '(', &at)?;
        if argument != Expr::Var(index) {
            self.report(SyntaxErrorKind::Term { name, index: n }, at.start..end);
        }
        self.build(placeholder(0), span.start..end, 1)
    }

    /// Passes `(n + 1)` or `(0)` behind the name of a sequence.
    fn term(&mut self, name: &str, span: Range<usize>) -> Result<Node, SyntaxError> {
        let scope = self.scope();
        let Some((index, term)) = scope.term(name) else {
            return self.build(Expr::int(1), span, 1);
        };
        let at = self.span();
        if !self.accept(Token::OpenParen) {
            self.report(SyntaxErrorKind::TermAlone(excerpt(name)), span.clone());
            return self.build(Expr::int(1), span, 1);
        }
        let argument = self.nested(Self::node)?;
        let argument = self.number_of(argument);
        let end = self.close(Token::CloseParen, '(', &at)?;
        let whole = span.start..end;
        let sequences = scope.sequences();
        let sum = sequences.linear(&argument).and_then(|sum| {
            let plus = u32::try_from(sum.plus).ok()?;
            let one = sum.times.get(index) == Some(&1) && sum.times.len() == 1;
            (one || sum.times.is_empty()).then_some((one, plus))
        });
        let written = match sum {
            None => {
                let vars = &scope.context().vars;
                let index = vars.get(*index).map_or_else(String::new, |var| var.name.clone());
                Err(SyntaxErrorKind::Term { name: excerpt(name), index })
            }
            Some((_, plus)) if plus > MAX_INDEX => Err(SyntaxErrorKind::LongTerm),
            Some((false, plus)) => {
                sequences.at(term, *index, plus).ok_or(SyntaxErrorKind::LongTerm)
            }
            Some((true, plus)) => {
                let further = |e: Expr| sequences.next(&e, *index);
                let written = (0..plus).try_fold(term.clone(), |e, _| further(e));
                written.ok_or(SyntaxErrorKind::LongTerm)
            }
        };
        match written {
            Ok(e) => {
                self.charge(size(&e), &whole)?;
                let height = scope.height(&e);
                self.build(e, whole, height)
            }
            Err(kind) => {
                self.report(kind, whole.clone());
                self.build(Expr::int(1), whole, 1)
            }
        }
    }

    fn call(
        &mut self,
        arguments: impl FnOnce(&mut Self) -> Result<(Expr, usize), SyntaxError>,
    ) -> Result<Node, SyntaxError> {
        let (start, word) = (self.span().start, self.lexeme());
        self.advance();
        let open = self.span();
        if matches!(self.token(), Token::Caret | Token::Superscript) {
            let due = format!("`(` after a function's name (its square is `{word}(x)^2`)");
            return Err(self.unexpected(&due));
        }
        self.expect(Token::OpenParen, "`(` after a function's name")?;
        let (expr, height) = self.nested(arguments)?;
        let end = self.close(Token::CloseParen, '(', &open)?;
        self.build(expr, start..end, height)
    }

    fn unary_call(&mut self, make: fn(Rc<Expr>) -> Expr) -> Result<(Expr, usize), SyntaxError> {
        let a = self.node()?;
        let height = a.height + 1;
        Ok((make(self.number_of(a).into()), height))
    }

    fn binary_call(&mut self, make: Binary) -> Result<(Expr, usize), SyntaxError> {
        let a = self.node()?;
        self.expect(Token::Comma, "`,` and a second argument")?;
        let b = self.node()?;
        if self.token() == Token::Comma {
            let expected =
                "`)` after two arguments; of three one is nested, as in `max(a, max(b, c))`";
            return Err(self.unexpected(expected));
        }
        let height = a.height.max(b.height) + 1;
        let (a, b) = (self.number_of(a), self.number_of(b));
        Ok((make(a.into(), b.into()), height))
    }

    /// The angle in `sin(…)`: a sum of angles with rational factors, and a multiple of `pi`.
    fn direction(&mut self, word: &str) -> Result<(Expr, usize), SyntaxError> {
        let node = self.with_angles()?;
        let (span, e) = (node.span.clone(), self.number_of(node));
        if self.has_placeholder(&e, &span) {
            return Ok((Expr::int(1), 1));
        }
        let turn = Turn::of(&e).ok_or(SyntaxErrorKind::NotAnAngle);
        match turn.and_then(|turn| turn.direction(self.scope())) {
            Ok(Direction { cos, sin }) => {
                let expr = match word {
                    "sin" => sin,
                    "cos" => cos,
                    _ => Expr::Div(sin.into(), cos.into()),
                };
                let height = self.scope().height(&expr);
                Ok((expr, height))
            }
            Err(kind) => {
                self.report(kind, span);
                Ok((Expr::int(1), 1))
            }
        }
    }

    /// The argument of an exponential or a logarithm, which is written out.
    fn lowered(
        &mut self,
        write: fn(&Expr, &Scope) -> Result<Expr, SyntaxErrorKind>,
    ) -> Result<(Expr, usize), SyntaxError> {
        let node = self.node()?;
        let (span, e) = (node.span.clone(), self.number_of(node));
        if self.has_placeholder(&e, &span) {
            return Ok((Expr::int(1), 1));
        }
        match write(&e, self.scope()) {
            Ok(expr) => {
                let height = self.scope().height(&expr);
                Ok((expr, height))
            }
            Err(kind) => {
                self.report(kind, span);
                Ok((Expr::int(1), 1))
            }
        }
    }

    /// Whether a parameter stands in an expression in which none can, which is noted.
    pub(crate) fn has_placeholder(&mut self, e: &Expr, span: &Range<usize>) -> bool {
        let found = self.scope().symbols(e).into_iter().find_map(parameter);
        if let Some(found) = found {
            let name = self.bound.get(found).cloned().unwrap_or_default();
            self.report(SyntaxErrorKind::BoundInside(name), span.clone());
        }
        found.is_some()
    }

    /// Passes `(a, b)` behind the name of a definition with arguments.
    fn application(&mut self, name: &str, span: Range<usize>) -> Result<Node, SyntaxError> {
        let mut arguments = Vec::new();
        let (open, mut height, mut end) = (self.span(), 0, span.end);
        if self.accept(Token::OpenParen) {
            self.nested(|p| {
                loop {
                    let argument = p.node()?;
                    height = height.max(argument.height);
                    arguments.push(p.number_of(argument));
                    if !p.next_item(arguments.len())? {
                        return Ok(());
                    }
                }
            })?;
            end = self.close(Token::CloseParen, '(', &open)?;
        }
        let (scope, whole) = (self.scope(), span.start..end);
        let Some(template) = scope.function(name) else {
            return self.build(Expr::int(1), whole, 1);
        };
        if template.takes != arguments.len() {
            let (takes, given) = (template.takes, arguments.len());
            let kind = SyntaxErrorKind::WrongArity { name: excerpt(name), takes, given };
            self.report(kind, whole.clone());
            return self.build(Expr::int(1), whole, 1);
        }
        self.charge(template.written(&arguments), &whole)?;
        // one level for a guard around the body
        let height = template.height + height + 1;
        self.build_value(template.applied(&arguments), whole, height)
    }

    /// Passes `d(f, x)`; a vector or a matrix is differentiated component by component.
    fn derivative_call(&mut self) -> Result<Node, SyntaxError> {
        let start = self.span().start;
        self.advance();
        let open = self.span();
        self.expect(Token::OpenParen, "`(` after a function's name")?;
        let (value, height) = self.nested(Self::derivative)?;
        let end = self.close(Token::CloseParen, '(', &open)?;
        self.build_value(value, start..end, height)
    }

    /// `f, x` of a derivative.
    fn derivative(&mut self) -> Result<(Value, usize), SyntaxError> {
        // an angle may stand here by itself
        let f = self.with_angles()?;
        self.expect(Token::Comma, "`,` and the variable of differentiation")?;
        let by = self.derivative_by()?;
        let Node { value, span, height } = f;
        let bound = value.parts().iter().any(|part| self.has_placeholder(part, &span));
        let Some((x, partial)) = by.filter(|_| !bound) else {
            return Ok((*value, height));
        };
        let mut parts = Vec::new();
        let mut tallest = 1;
        for part in value.parts() {
            let f = (part.clone(), span.clone(), height);
            let (slope, height) = if partial { self.by_symbol(f, x) } else { self.slope(f, x) };
            tallest = tallest.max(height);
            parts.push(slope);
        }
        Ok((value.with_parts(parts), tallest))
    }

    /// The symbol of a derivative, and whether it is one without a name of its own; `None` after a
    /// fault that was recorded.
    fn derivative_by(&mut self) -> Result<Option<(usize, bool)>, SyntaxError> {
        let at = self.span();
        // what has no name of its own: `d(f, cos(theta))`, `d(f, d(x, t))`
        if ["cos", "sin", "d"].contains(&self.lexeme()) {
            let by = self.node()?;
            if let Value::Number(Expr::Var(v)) = *by.value {
                return Ok(Some((v, true)));
            }
            self.report(SyntaxErrorKind::NotADerivativeVariable("this".to_owned()), at);
            return Ok(None);
        }
        let (name, span) = self.name()?;
        if let Some(Symbol::Var(x)) = self.scope().resolve(name) {
            return Ok(Some((x, false)));
        }
        let kind = match self.scope().is_unused(name) && !self.bound.contains(&name.to_owned()) {
            true => SyntaxErrorKind::UnknownSymbol(excerpt(name)),
            false => SyntaxErrorKind::NotADerivativeVariable(excerpt(name)),
        };
        self.report(kind, span);
        Ok(None)
    }

    /// The derivative by a symbol that has no name of its own.
    fn by_symbol(&mut self, f: (Expr, Range<usize>, usize), x: usize) -> (Expr, usize) {
        let (f, span, height) = f;
        self.has_angle_alone(&f, &span);
        (Expr::Deriv(f.into(), x), height + 1)
    }

    /// The derivative of a number by a symbol.
    fn slope(&mut self, f: (Expr, Range<usize>, usize), x: usize) -> (Expr, usize) {
        let (f, span, _) = f;
        let scope = self.scope();
        let of = |v: usize| scope.context().vars.get(v).and_then(|var| var.of);
        let varies = scope.symbols(&f).into_iter().any(|v| of(v) == Some(x));
        // the derivative of an angle is a symbol
        let is_angle = varies && matches!(f, Expr::Var(_));
        if !is_angle && self.has_angle_alone(&f, &span) {
            return (Expr::int(1), 1);
        }
        let slope = if varies {
            match rate(&f, x, scope) {
                Ok(slope) => slope,
                Err(kind) => {
                    self.report(kind, span);
                    return (Expr::int(1), 1);
                }
            }
        } else if let Some(angle) = scope.angle(x) {
            by_angle(&f, (x, *angle), scope)
        } else if scope.exponentials().any(|e| e.of.contains(x)) {
            by_factor(&f, x, scope)
        } else {
            Expr::Deriv(f.clone().into(), x)
        };
        scope.note_derivative(&slope, &f, x);
        let height = scope.height(&slope);
        (slope, height)
    }

    /// Whether what is differentiated has an angle, or `pi`, by itself, which is noted.
    fn has_angle_alone(&mut self, f: &Expr, span: &Range<usize>) -> bool {
        let scope = self.scope();
        let alone = |v: &usize| *v == PI || scope.is_unmeasured(*v);
        let found = scope.symbols(f).into_iter().find(alone);
        if let Some(v) = found {
            let name = scope.context().vars.get(v).map_or("pi", |var| &var.name);
            self.report(SyntaxErrorKind::AngleAlone(name.to_owned()), span.clone());
        }
        found.is_some()
    }

    /// An expression with values in the place of what is bound.
    ///
    /// # Errors
    /// When the text makes too much to be written out, or too deep an expression.
    pub fn with_arguments(
        &self,
        e: &Expr,
        arguments: &[Expr],
        span: Range<usize>,
    ) -> Result<Expr, SyntaxError> {
        self.charge(written(e, arguments), &span)?;
        let scope = self.scope();
        let height = arguments.iter().map(|a| scope.height(a)).max().unwrap_or(0);
        self.within_height(scope.height(e) + height, &span)?;
        Ok(substituted(e, arguments))
    }

    fn cases(&mut self) -> Result<Node, SyntaxError> {
        let start = self.span();
        self.advance();
        let open = self.span();
        self.expect(Token::OpenBrace, "`{` after `cases`")?;
        let (expr, height) = self.nested(Self::branches)?;
        let end = self.close(Token::CloseBrace, '{', &open)?;
        if expr == Expr::Cases(Vec::new(), None) {
            self.report(SyntaxErrorKind::NoBranch, start.start..end);
        }
        self.build(expr, start.start..end, height)
    }

    fn branches(&mut self) -> Result<(Expr, usize), SyntaxError> {
        let mut branches = Vec::new();
        let mut otherwise = None;
        let mut height = 0;
        while self.token() != Token::CloseBrace && self.token() != Token::End {
            if otherwise.is_some() {
                return Err(self.fault(SyntaxErrorKind::ElseNotLast));
            }
            if branches.len() >= MAX_ITEMS {
                return Err(self.fault(SyntaxErrorKind::TooManyItems));
            }
            let guards = if self.accept_word("else") {
                None
            } else {
                let links = self.guard_links()?;
                height = links.iter().map(|link| link.height).max().unwrap_or(0).max(height);
                Some(links.into_iter().map(|link| link.relation).collect())
            };
            self.expect(Token::Colon, "`:` after the guard")?;
            let value = self.node()?;
            height = height.max(value.height);
            let value = self.number_of(value);
            match guards {
                Some(guards) => branches.push((guards, value)),
                None => otherwise = Some(value.into()),
            }
            if self.token() == Token::Comma {
                return Err(self.unexpected("`;` between two branches"));
            }
            if !self.accept(Token::Semicolon) {
                break;
            }
        }
        Ok((Expr::Cases(branches, otherwise), height + 1))
    }
}
