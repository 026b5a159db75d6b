//! What begins with a word: names, functions, derivatives and cases.

use kane_kernel::Expr;
use num_bigint::BigInt;

use super::angle::{Direction, PI, Turn, negative, product};
use super::bounds::MAX_ITEMS;
use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::Token;
use super::names::canonical_name;
use super::parser::{Binary, Node, Parser, excerpt};
use super::rate::rate;
use super::scope::{Angle, Scope, Symbol};

/// d f / dθ = (∂f/∂s·c − ∂f/∂c·s)/n for the cosine c and the sine s of θ/n. Where both parts have a
/// value f is one differentiable expression in c and s near the point, and the chain rule holds.
fn by_angle(f: &Expr, angle: Angle, scope: &Scope) -> Expr {
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
    match angle.parts {
        1 => slope,
        n => Expr::Div(slope.into(), Expr::int(n.into()).into()),
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
            "d" => self.call(Self::derivative),
            "cases" => self.cases(),
            word @ ("sin" | "cos" | "tan") if self.scope().resolve(word).is_none() => {
                self.call(|p| p.direction(word))
            }
            _ => {
                let (name, span) = self.name()?;
                let (expr, height) = match self.scope().resolve(name) {
                    Some(Symbol::Var(index)) => {
                        if self.scope().angle(index).is_some() && !self.in_angle {
                            self.report(SyntaxErrorKind::AngleAlone(excerpt(name)), span.clone());
                        }
                        (Expr::Var(index), 1)
                    }
                    None if self.in_angle && canonical_name(name) == "pi" => (Expr::Var(PI), 1),
                    Some(Symbol::Let(index)) => {
                        (Expr::Let(index), self.scope().height_of_let(index) + 1)
                    }
                    None => {
                        let kind = SyntaxErrorKind::UnknownSymbol(excerpt(name));
                        self.report(kind, span.clone());
                        (Expr::Num(BigInt::from(1).into()), 1)
                    }
                };
                self.build(expr, span, height)
            }
        }
    }

    fn call(
        &mut self,
        arguments: impl FnOnce(&mut Self) -> Result<(Expr, usize), SyntaxError>,
    ) -> Result<Node, SyntaxError> {
        let start = self.span().start;
        self.advance();
        let open = self.span();
        self.expect(Token::OpenParen, "`(` after a function's name")?;
        let (expr, height) = self.nested(arguments)?;
        let end = self.close(Token::CloseParen, '(', &open)?;
        self.build(expr, start..end, height)
    }

    fn unary_call(&mut self, make: fn(Box<Expr>) -> Expr) -> Result<(Expr, usize), SyntaxError> {
        let a = self.node()?;
        Ok((make(Box::new(a.expr)), a.height + 1))
    }

    fn binary_call(&mut self, make: Binary) -> Result<(Expr, usize), SyntaxError> {
        let a = self.node()?;
        self.expect(Token::Comma, "`,` and a second argument")?;
        let b = self.node()?;
        let height = a.height.max(b.height) + 1;
        Ok((make(Box::new(a.expr), Box::new(b.expr)), height))
    }

    /// The angle in `sin(…)`: a sum of angles with rational factors, and a multiple of `pi`.
    fn direction(&mut self, word: &str) -> Result<(Expr, usize), SyntaxError> {
        let node = self.with_angles()?;
        let turn = Turn::of(&node.expr).ok_or(SyntaxErrorKind::NotAnAngle);
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
                self.report(kind, node.span);
                Ok((Expr::int(1), 1))
            }
        }
    }

    /// `f, x` of a derivative.
    fn derivative(&mut self) -> Result<(Expr, usize), SyntaxError> {
        // an angle may stand here by itself
        let f = self.with_angles()?;
        self.expect(Token::Comma, "`,` and the variable of differentiation")?;
        let at = self.span();
        // what has no name of its own: `d(f, cos(theta))`, `d(f, d(x, t))`
        if ["cos", "sin", "d"].contains(&self.lexeme()) {
            let by = self.node()?;
            return match by.expr {
                Expr::Var(v) => {
                    self.has_angle_alone(&f);
                    Ok((Expr::Deriv(Box::new(f.expr), v), f.height + 1))
                }
                _ => {
                    self.report(SyntaxErrorKind::NotADerivativeVariable("this".to_owned()), at);
                    Ok((f.expr, f.height))
                }
            };
        }
        let (name, span) = self.name()?;
        let x = match self.scope().resolve(name) {
            Some(Symbol::Var(x)) => x,
            found => {
                let kind = match found {
                    None => SyntaxErrorKind::UnknownSymbol(excerpt(name)),
                    Some(_) => SyntaxErrorKind::NotADerivativeVariable(excerpt(name)),
                };
                self.report(kind, span);
                return Ok((f.expr, f.height));
            }
        };
        let scope = self.scope();
        let of = |v: usize| scope.context().vars.get(v).and_then(|var| var.of);
        let varies = scope.symbols(&f.expr).into_iter().any(|v| of(v) == Some(x));
        // the derivative of an angle is a symbol
        let is_angle = varies && matches!(f.expr, Expr::Var(_));
        if !is_angle && self.has_angle_alone(&f) {
            return Ok((Expr::int(1), 1));
        }
        let slope = if varies {
            match rate(&f.expr, x, scope) {
                Ok(slope) => slope,
                Err(kind) => {
                    self.report(kind, f.span);
                    return Ok((Expr::int(1), 1));
                }
            }
        } else if let Some(angle) = scope.angle(x) {
            by_angle(&f.expr, *angle, scope)
        } else {
            Expr::Deriv(Box::new(f.expr), x)
        };
        let height = scope.height(&slope);
        Ok((slope, height))
    }

    /// Whether what is differentiated has an angle, or `pi`, by itself, which is noted.
    fn has_angle_alone(&mut self, f: &Node) -> bool {
        let scope = self.scope();
        let alone = |v: &usize| *v == PI || scope.angle(*v).is_some();
        let found = scope.symbols(&f.expr).into_iter().find(alone);
        if let Some(v) = found {
            let name = scope.context().vars.get(v).map_or("pi", |var| &var.name);
            self.report(SyntaxErrorKind::AngleAlone(name.to_owned()), f.span.clone());
        }
        found.is_some()
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
            match guards {
                Some(guards) => branches.push((guards, value.expr)),
                None => otherwise = Some(Box::new(value.expr)),
            }
            if !self.accept(Token::Semicolon) {
                break;
            }
        }
        Ok((Expr::Cases(branches, otherwise), height + 1))
    }
}
