//! Functions in a formula: sines, exponentials, sums, extremes, fractions, and derivatives in dots and in
//! differentials.

use crate::command::Beginning::{Angle, Exponential, Extreme, Quotient, Summation};
use crate::command::beginning;
use crate::formula::Reader;
use crate::name::Names;
use crate::part::{Level, Part, is_name, over, power, times};
use crate::token::Token;
use crate::unreadable::Unreadable;

impl<'a> Reader<'a> {
    /// sin, cos or tan, its exponent, and its argument: one factor, or a number and one.
    pub(crate) fn angle_function(&mut self, name: &str) -> Result<Part, Unreadable> {
        let mut exponents = Vec::new();
        while self.takes(&Token::Superscript) {
            let exponent = self.group()?;
            // sin⁻¹ is one over the sine, or its inverse
            if exponent.first() == Some(&Token::Char('-')) {
                return Err(Unreadable::Ambiguous(format!("{name}^-1")));
            }
            exponents.push(exponent);
        }
        let mut argument = if matches!(self.peek(), Some(Token::Char('(' | '['))) {
            self.base()?
        } else {
            let first = self.factor()?;
            if first.literal && self.begins_name() {
                times(&first, &self.factor()?)?
            } else {
                first
            }
        };
        argument = argument.number()?;
        let open = !matches!(
            self.tokens.get(self.at.wrapping_sub(1)),
            Some(Token::Char(')' | ']') | Token::Close)
        );
        if open && (self.begins_factor() && !self.begins_function() || self.divides()) {
            return Err(Unreadable::Ambiguous(format!("{name} {}…", argument.text)));
        }
        let mut out = Part::atom(format!("{name}({})", argument.text));
        for exponent in exponents {
            out = power(&out, exponent)?;
        }
        Ok(out)
    }

    /// Whether another function follows, which is no part of an argument.
    fn begins_function(&self) -> bool {
        let function = |name| {
            let found = beginning(name);
            matches!(
                found,
                Some(Angle(_) | Exponential(_) | Quotient(..) | Summation(_) | Extreme(_))
            )
        };
        self.command().is_some_and(function)
    }

    /// The range of a sum or a product, and its term: one product, behind which no sign may stand.
    pub(crate) fn summation(&mut self, name: &str) -> Result<Part, Unreadable> {
        let (mut below, mut above) = (None, None);
        while below.is_none() || above.is_none() {
            if below.is_none() && self.takes(&Token::Subscript) {
                below = Some(self.group()?);
            } else if above.is_none() && self.takes(&Token::Superscript) {
                above = Some(self.group()?);
            } else {
                return Err(Unreadable::Missing("the range of the sum"));
            }
        }
        let (below, above) = (below.unwrap_or_default(), above.unwrap_or_default());
        let Some(at) = below.iter().position(|token| *token == Token::Char('=')) else {
            return Err(Unreadable::Missing("`=` in the range of the sum"));
        };
        let mut met = Names::default();
        let over = Reader::new(&below[..at], &mut met).base()?;
        if !is_name(&over) || at + 1 == below.len() || met.symbols().len() != 1 {
            return Err(Unreadable::Missing("what the sum runs over"));
        }
        let (from, to) = (self.whole(&below[at + 1..])?.number()?, self.whole(above)?.number()?);
        self.names.over.push(over.text.clone());
        let term = self.product();
        self.names.over.pop();
        let term = term?.number()?;
        if matches!(self.peek(), Some(Token::Char('+' | '-' | '−'))) {
            return Err(Unreadable::Ambiguous(format!("the sum over {}…", over.text)));
        }
        let range = format!("{} in {}..{}", over.text, from.text, to.text);
        Ok(Part::atom(format!("{name}({} for {range})", term.text)))
    }

    /// A power whose exponent speaks of what a sum runs over.
    pub(crate) fn running_power(
        &mut self,
        base: &Part,
        exponent: &'a [Token],
    ) -> Result<Part, Unreadable> {
        let exponent = self.whole(exponent).map_err(|_| Unreadable::Exponent)?.number()?;
        let words = exponent.text.split(|c: char| !(c.is_alphanumeric() || "_'".contains(c)));
        let runs = words.into_iter().any(|word| self.names.over.iter().any(|over| over == word));
        match runs {
            true => {
                let text = format!("{}^{}", base.at(Level::Atom), exponent.at(Level::Atom));
                Ok(Part::new(text, Level::Power))
            }
            false => Err(Unreadable::Exponent),
        }
    }

    pub(crate) fn extreme(&mut self, name: &str) -> Result<Part, Unreadable> {
        let close = match self.next() {
            Some(Token::Char('(')) => Token::Char(')'),
            Some(Token::Char('[')) => Token::Char(']'),
            Some(Token::Command(open)) if open == "{" || open == "lbrace" => {
                Token::Command("}".to_owned())
            }
            _ => return Err(Unreadable::Missing("a bracket")),
        };
        let mut text = self.sum()?.number()?.text;
        while self.takes_char(',') {
            text = format!("{name}({text}, {})", self.sum()?.number()?.text);
        }
        if !self.takes(&close) {
            return Err(Unreadable::Missing("a closing bracket"));
        }
        Ok(Part::atom(text))
    }

    /// A derivative by t, in dots.
    pub(crate) fn rate(&mut self, order: usize) -> Result<Part, Unreadable> {
        let group = self.group()?;
        // what is met in braces may be half a name: subscripts follow behind them
        let mut met = Names::default();
        let mut inner = Reader::new(group, &mut met);
        let base = inner.factor()?;
        if inner.peek().is_some() || !is_name(&base) {
            return Err(Unreadable::Missing("a name under the dot"));
        }
        let vector = base.vector;
        let spelled = met.spelled(&base.text);
        let whole = self.name(base.text, vector, spelled)?;
        self.names.meet("t", false, "t")?;
        self.names.varies(&whole.text);
        let text = (0..order).fold(whole.text, |inner, _| format!("d({inner}, t)"));
        Ok(Part { vector, ..Part::atom(text) })
    }

    pub(crate) fn fraction(&mut self) -> Result<Part, Unreadable> {
        let (top, bottom) = (self.group()?, self.group()?);
        if let Some(derivative) = self.derivative(top, bottom)? {
            return Ok(derivative);
        }
        let (top, bottom) = (self.whole(top)?, self.whole(bottom)?.number()?);
        let numbers = top.literal && bottom.literal;
        Ok(Part { literal: numbers, ..over(&top, &bottom) })
    }

    /// dⁿf/dxⁿ, with f above the line or behind it; `None` if the fraction is none.
    fn derivative(
        &mut self,
        top: &'a [Token],
        bottom: &'a [Token],
    ) -> Result<Option<Part>, Unreadable> {
        let is_d = |token: &Token| match token {
            Token::Char('d') => true,
            Token::Upright(word) => word == "d",
            Token::Command(name) => name == "partial",
            _ => false,
        };
        let ([d, x @ ..], [first, f @ ..]) = (bottom, top) else { return Ok(None) };
        if !is_d(d) || !is_d(first) || matches!(x, [] | [Token::Subscript, ..]) {
            return Ok(None);
        }
        let (f, above) = order(f)?;
        let mut x = x;
        let mut below = 1;
        if let Some(at) = x.iter().position(|token| *token == Token::Superscript) {
            (_, below) = order(&x[at..])?;
            x = &x[..at];
        }
        if x.iter().any(is_d) {
            return Err(Unreadable::Differential("…".to_owned()));
        }
        if above != below {
            return Err(Unreadable::Exponent);
        }
        let by = self.whole(x)?;
        let behind = f.is_empty();
        let f = if behind { self.factor()? } else { self.whole(f)? };
        if behind && self.begins_factor() {
            // d/dx f g is the derivative of f, times g, or that of the product
            return Err(Unreadable::Ambiguous(format!("the derivative of {}…", f.text)));
        }
        if by.text == "t" && is_name(&f) {
            self.names.varies(&f.text);
        }
        let text = (0..above).fold(f.text, |inner, _| format!("d({inner}, {})", by.text));
        Ok(Some(Part { vector: f.vector, ..Part::atom(text) }))
    }
}

/// The order behind a d, and what follows it.
fn order(tokens: &[Token]) -> Result<(&[Token], usize), Unreadable> {
    let digit = |token: &Token| match token {
        Token::Char(c @ '1'..='6') => c.to_digit(10).map(|n| n as usize),
        _ => None,
    };
    match tokens {
        [Token::Superscript, Token::Open, n, Token::Close, rest @ ..]
        | [Token::Superscript, n, rest @ ..] => match digit(n) {
            Some(n) => Ok((rest, n)),
            None => Err(Unreadable::Exponent),
        },
        _ => Ok((tokens, 1)),
    }
}
