//! From tokens to expressions: precedence climbing over one token of look-ahead.

use std::ops::Range;

use kane_kernel::{Expr, Relation, Sentence};
use num_bigint::BigInt;

use super::bounds::{MAX_DIGITS, MAX_HEIGHT, MAX_ITEMS, MAX_NESTING};
use super::error::{SyntaxError, SyntaxErrorKind};
use super::lexer::{self, Token};
use super::names::{RESERVED, canonical_name};
use super::number::{parse_literal, written_out};
use super::scope::Scope;
use super::value::{Operator, Value};

/// Faults of one text that are kept.
const MAX_ERRORS: usize = 1000;

/// How tightly an operator binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    Sum,
    Product,
    Power,
    Atom,
}

/// An expression with its place and its height.
#[derive(Clone)]
pub(crate) struct Node {
    /// in a box, so that a text with groups in groups takes less of the stack
    pub(crate) value: Box<Value>,
    pub(crate) span: Range<usize>,
    pub(crate) height: usize,
}

/// A parser over one piece of text.
///
/// Faults that leave the structure clear (an unknown name, a zero denominator) are collected
/// and parsing goes on; the others end it as `Err`. The result counts only when
/// there are neither.
#[derive(Debug)]
pub struct Parser<'a> {
    text: &'a str,
    offset: usize,
    scope: &'a Scope,
    token: Token,
    span: Range<usize>,
    last_end: usize,
    nesting: usize,
    /// `pi` has a meaning, and angles stand by themselves, as in the argument of a sine
    pub(crate) in_angle: bool,
    /// names that stand for placeholders, in order: parameters, or what `exists` binds
    pub(crate) bound: Vec<String>,
    /// the index of the sequence that is being defined: its name, the only one bound, takes it
    pub(crate) recursion: Option<usize>,
    /// names that stand for values: what sums run over, from the outside in
    pub(crate) locals: Vec<(String, Expr)>,
    /// of those, how many may not be spoken of
    pub(crate) fixed: usize,
    /// what is read is a term of a sum up to an index, which speaks of no index itself
    pub(crate) in_term: bool,
    /// a `+` or `-` may end the expression, as in `as x -> 0+`
    pub(crate) side_may_follow: bool,
    errors: Vec<SyntaxError>,
}

/// The expression that `text` is, whole.
///
/// # Errors
/// All faults found, in the order of discovery.
pub fn parse_expr(text: &str, scope: &Scope) -> Result<Expr, Vec<SyntaxError>> {
    let mut parser = Parser::new(text, 0, scope);
    let expr = parser.expr();
    parser.finish(expr)
}

/// The comma list of relations that `text` is, whole; a chain counts as its links.
///
/// # Errors
/// All faults found, in the order of discovery.
pub fn parse_relations(text: &str, scope: &Scope) -> Result<Vec<Relation>, Vec<SyntaxError>> {
    let mut parser = Parser::new(text, 0, scope);
    let relations = parser.relations();
    parser.finish(relations)
}

/// The sentence that `text` is, whole: `RELATION [as x -> a] [when RELATION]`.
///
/// # Errors
/// All faults found, in the order of discovery.
pub fn parse_sentence(text: &str, scope: &Scope) -> Result<Sentence, Vec<SyntaxError>> {
    let mut parser = Parser::new(text, 0, scope);
    let sentence = parser.sentence();
    parser.finish(sentence)
}

impl<'a> Parser<'a> {
    /// A parser at the start of `text`, whose first byte counts as byte `offset` in all spans.
    #[must_use]
    pub fn new(text: &'a str, offset: usize, scope: &'a Scope) -> Self {
        let (token, span) = lexer::next(text, 0);
        Self {
            text,
            offset,
            scope,
            token,
            span,
            last_end: 0,
            nesting: 0,
            in_angle: false,
            bound: Vec::new(),
            recursion: None,
            locals: Vec::new(),
            fixed: 0,
            in_term: false,
            side_may_follow: false,
            errors: Vec::new(),
        }
    }

    /// The collected faults, or the result if there are none and the text is used up.
    ///
    /// # Errors
    /// All faults found, in the order of discovery.
    pub fn finish<T>(mut self, result: Result<T, SyntaxError>) -> Result<T, Vec<SyntaxError>> {
        let result = result.and_then(|value| self.expect_end().map(|()| value));
        match result {
            Ok(value) if self.errors.is_empty() => Ok(value),
            Ok(_) => Err(self.errors),
            Err(error) => {
                self.errors.push(error);
                Err(self.errors)
            }
        }
    }

    /// The collected faults, wherever the text goes on.
    #[must_use]
    pub fn into_faults(self) -> Vec<SyntaxError> {
        self.errors
    }

    /// The names in force.
    #[must_use]
    pub fn scope(&self) -> &'a Scope {
        self.scope
    }

    /// The token ahead.
    #[must_use]
    pub fn token(&self) -> Token {
        self.token
    }

    /// The token ahead as written.
    #[must_use]
    pub fn lexeme(&self) -> &'a str {
        self.text.get(self.span.clone()).unwrap_or_default()
    }

    /// Where the token ahead stands.
    #[must_use]
    pub fn span(&self) -> Range<usize> {
        self.span.start + self.offset..self.span.end + self.offset
    }

    /// Where the last token that was passed ended.
    #[must_use]
    pub fn last_end(&self) -> usize {
        self.last_end + self.offset
    }

    /// Whether the token ahead is this word.
    #[must_use]
    pub fn at_word(&self, word: &str) -> bool {
        self.token == Token::Name && self.lexeme() == word
    }

    /// Passes the token ahead.
    pub fn advance(&mut self) {
        self.jump(self.span.end);
    }

    /// Goes to a byte of the parser's own text.
    pub(crate) fn jump(&mut self, to: usize) {
        self.last_end = to;
        (self.token, self.span) = lexer::next(self.text, to);
    }

    /// Passes the token ahead if it is `token`.
    pub fn accept(&mut self, token: Token) -> bool {
        let found = self.token == token;
        if found {
            self.advance();
        }
        found
    }

    /// Passes the token ahead if it is this word.
    pub fn accept_word(&mut self, word: &str) -> bool {
        let found = self.at_word(word);
        if found {
            self.advance();
        }
        found
    }

    /// Passes `token`.
    ///
    /// # Errors
    /// When another token is ahead; `expected` says in words what was due.
    pub fn expect(&mut self, token: Token, expected: &str) -> Result<(), SyntaxError> {
        if self.accept(token) { Ok(()) } else { Err(self.unexpected(expected)) }
    }

    /// Passes a name that is no reserved word and returns it as written, with its place.
    ///
    /// # Errors
    /// When there is no name ahead, or a reserved word.
    pub fn name(&mut self) -> Result<(&'a str, Range<usize>), SyntaxError> {
        let span = self.span();
        match self.token {
            Token::Name | Token::Infinity if RESERVED.contains(&self.lexeme()) => {
                Err(self.fault(SyntaxErrorKind::ReservedWord(self.lexeme().to_owned())))
            }
            Token::Name => {
                let name = self.lexeme();
                self.advance();
                Ok((name, span))
            }
            _ => Err(self.unexpected("a name")),
        }
    }

    /// Passes the text from the token ahead up to and without byte `end` of the parser's own text,
    /// for what is not made of tokens, such as labels. Returns it with its place.
    pub fn take_until(&mut self, end: usize) -> (&'a str, Range<usize>) {
        let start = self.span.start;
        let end = end.max(start).min(self.text.len());
        self.jump(end);
        (self.text.get(start..end).unwrap_or_default(), start + self.offset..end + self.offset)
    }

    /// What is left of the text from the token ahead on, and the byte of the parser's own text at
    /// which that begins.
    #[must_use]
    pub fn rest(&self) -> (&'a str, usize) {
        let start = self.span.start;
        (self.text.get(start..).unwrap_or_default(), start)
    }

    /// The parser's own text, and the byte of it at which the token ahead begins.
    pub(crate) fn ahead(&self) -> (&'a str, usize) {
        (self.text, self.span.start)
    }

    /// How many faults are recorded.
    pub(crate) fn faults(&self) -> usize {
        self.errors.len()
    }

    /// Whether a fault was recorded.
    #[must_use]
    pub fn has_faults(&self) -> bool {
        !self.errors.is_empty()
    }

    /// Has these names stand for placeholders, in order, from here on.
    pub fn bind(&mut self, names: Vec<String>) {
        self.bound = names;
    }

    /// Has `name(n)` stand for a placeholder, n being this index, from here on.
    pub fn bind_term(&mut self, name: &str, index: usize) {
        self.bound = vec![canonical_name(name).into_owned()];
        self.recursion = Some(index);
    }

    /// Makes sure that a list may have another item.
    pub(crate) fn within_list(&self, items: usize) -> Result<(), SyntaxError> {
        match items >= MAX_ITEMS {
            true => Err(self.fault(SyntaxErrorKind::TooManyItems)),
            false => Ok(()),
        }
    }

    /// Records a fault that does not end the parse; after a thousand it records no more.
    pub fn report(&mut self, kind: SyntaxErrorKind, span: Range<usize>) {
        if self.errors.len() < MAX_ERRORS {
            self.errors.push(SyntaxError { kind, span });
        }
    }

    /// Passes a comma and tells whether another item of a list is due.
    ///
    /// # Errors
    /// When the list, which has `items` so far, becomes too long.
    pub fn next_item(&mut self, items: usize) -> Result<bool, SyntaxError> {
        if self.token != Token::Comma {
            return Ok(false);
        }
        if items >= MAX_ITEMS {
            return Err(self.fault(SyntaxErrorKind::TooManyItems));
        }
        self.advance();
        Ok(true)
    }

    /// A fault at the token ahead.
    #[must_use]
    pub fn fault(&self, kind: SyntaxErrorKind) -> SyntaxError {
        SyntaxError { kind, span: self.span() }
    }

    /// The fault that something other than the token ahead was due.
    #[must_use]
    pub fn unexpected(&self, expected: &str) -> SyntaxError {
        if let Some(error) = self.foreign_operator() {
            return error;
        }
        let kind = match self.token {
            Token::Stray(c) => SyntaxErrorKind::StrayCharacter(c),
            Token::CloseParen if self.nesting == 0 => SyntaxErrorKind::Unopened(')'),
            Token::CloseBrace if self.nesting == 0 => SyntaxErrorKind::Unopened('}'),
            Token::CloseBracket if self.nesting == 0 => SyntaxErrorKind::Unopened(']'),
            Token::BadNumber => SyntaxErrorKind::MalformedNumber(excerpt(self.lexeme())),
            _ => SyntaxErrorKind::Expected { expected: expected.to_owned(), found: self.found() },
        };
        self.fault(kind)
    }

    fn found(&self) -> String {
        match self.token {
            Token::End => "the end of the statement".to_owned(),
            _ => format!("`{}`", excerpt(self.lexeme())),
        }
    }

    /// Makes sure that nothing is left.
    ///
    /// # Errors
    /// At the first token that is left.
    pub fn expect_end(&mut self) -> Result<(), SyntaxError> {
        if self.token == Token::End {
            return Ok(());
        }
        Err(self
            .missing_operator()
            .or_else(|| self.last_semicolon())
            .unwrap_or_else(|| self.unexpected("an operator or the end of the statement")))
    }

    /// The fault that two operands stand side by side, if an operand is ahead.
    pub(crate) fn missing_operator(&self) -> Option<SyntaxError> {
        let operand = match self.token {
            Token::Number | Token::OpenParen | Token::OpenBracket => true,
            Token::Name => !RESERVED.contains(&self.lexeme()),
            _ => false,
        };
        operand.then(|| self.fault(SyntaxErrorKind::ImplicitProduct(self.found())))
    }

    /// Passes one expression.
    ///
    /// # Errors
    /// On any fault after which the structure is unclear.
    pub fn expr(&mut self) -> Result<Expr, SyntaxError> {
        let node = self.node()?;
        Ok(self.number_of(node))
    }

    /// Passes one expression, which may be a vector or a matrix.
    ///
    /// # Errors
    /// On any fault after which the structure is unclear.
    pub fn value(&mut self) -> Result<Value, SyntaxError> {
        Ok(*self.node()?.value)
    }

    pub(crate) fn node(&mut self) -> Result<Node, SyntaxError> {
        self.binary(Level::Sum)
    }

    /// Passes one expression in which angles and `pi` may stand by themselves.
    pub(crate) fn with_angles(&mut self) -> Result<Node, SyntaxError> {
        let outer = std::mem::replace(&mut self.in_angle, true);
        let node = self.node();
        self.in_angle = outer;
        node
    }

    /// Passes one expression and returns it with its place.
    ///
    /// # Errors
    /// As [`Parser::expr`].
    pub fn spanned_expr(&mut self) -> Result<(Expr, Range<usize>), SyntaxError> {
        let node = self.node()?;
        let span = node.span.clone();
        Ok((self.number_of(node), span))
    }

    fn binary(&mut self, level: Level) -> Result<Node, SyntaxError> {
        let mut left = self.prefix(level)?;
        loop {
            let (operator, above) = match self.token {
                Token::Plus if level == Level::Sum => (Operator::Plus, Level::Product),
                Token::Minus if level == Level::Sum => (Operator::Minus, Level::Product),
                Token::Star if level <= Level::Product => (Operator::Times, Level::Power),
                Token::Slash if level <= Level::Product => (Operator::Over, Level::Power),
                _ => return Ok(left),
            };
            if self.side_may_follow && above == Level::Product && !self.operand_follows() {
                return Ok(left);
            }
            self.advance();
            left = self.operation(operator, left, above)?;
        }
    }

    /// Passes the right operand.
    fn operation(
        &mut self,
        operator: Operator,
        left: Node,
        above: Level,
    ) -> Result<Node, SyntaxError> {
        let right = self.binary(above)?;
        self.join(operator, left, right)
    }

    /// Whether the token after the one ahead can begin an operand.
    fn operand_follows(&self) -> bool {
        let (token, span) = lexer::next(self.text, self.span.end);
        let word = self.text.get(span).unwrap_or_default();
        match token {
            Token::Name => !["when", "from", "using", "expect", "by", "as"].contains(&word),
            Token::End | Token::Comma => false,
            _ => true,
        }
    }

    fn join(&mut self, operator: Operator, left: Node, right: Node) -> Result<Node, SyntaxError> {
        let span = left.span.start..right.span.end;
        let height = left.height.max(right.height) + 1;
        match (*left.value, *right.value) {
            (Value::Number(a), Value::Number(b)) => self.build(operator.join(a, b), span, height),
            (a, b) => {
                let left = Node { value: a.into(), ..left };
                self.operate(operator, &left, &Node { value: b.into(), ..right })
            }
        }
    }

    pub(crate) fn build(
        &self,
        expr: Expr,
        span: Range<usize>,
        height: usize,
    ) -> Result<Node, SyntaxError> {
        self.build_value(Value::Number(expr), span, height)
    }

    pub(crate) fn build_value(
        &self,
        value: Value,
        span: Range<usize>,
        height: usize,
    ) -> Result<Node, SyntaxError> {
        self.within_height(height, &span)?;
        Ok(Node { value: value.into(), span, height })
    }

    pub(crate) fn within_height(
        &self,
        height: usize,
        span: &Range<usize>,
    ) -> Result<(), SyntaxError> {
        match height > MAX_HEIGHT {
            true => Err(SyntaxError { kind: SyntaxErrorKind::TooTall, span: span.clone() }),
            false => Ok(()),
        }
    }

    /// Runs `parse` one level of nesting further in.
    pub(crate) fn nested<T>(
        &mut self,
        parse: impl FnOnce(&mut Self) -> Result<T, SyntaxError>,
    ) -> Result<T, SyntaxError> {
        if self.nesting == MAX_NESTING {
            return Err(self.fault(SyntaxErrorKind::TooNested));
        }
        self.nesting += 1;
        // a side may follow only at the outermost level
        let side = std::mem::take(&mut self.side_may_follow);
        let result = parse(self);
        self.side_may_follow = side;
        self.nesting -= 1;
        result
    }

    pub(crate) fn prefix(&mut self, level: Level) -> Result<Node, SyntaxError> {
        match self.token {
            Token::Minus => self.negative(level),
            _ => self.power(),
        }
    }

    fn negative(&mut self, level: Level) -> Result<Node, SyntaxError> {
        let start = self.span().start;
        self.advance();
        // a leading sign spans the product: -a*b is −(a·b); after * or / it does not
        let inner = self.nested(|p| p.binary(level.max(Level::Product)))?;
        let negative = inner.value.map(|part| Expr::Neg(part.clone().into()));
        self.build_value(negative, start..inner.span.end, inner.height + 1)
    }

    fn power(&mut self) -> Result<Node, SyntaxError> {
        let base = self.atom()?;
        match self.token {
            Token::Caret | Token::Superscript => self.raised_to(base),
            _ => Ok(base),
        }
    }

    // Groups in groups pass through `prefix`, `power` and `atom`: what these need not hold themselves
    // stands in functions of its own, lest the stack end before the nesting does.

    fn atom(&mut self) -> Result<Node, SyntaxError> {
        match self.token {
            Token::Number => self.number(),
            Token::OpenParen => self.group(),
            Token::Bar => self.bars(),
            Token::OpenBracket => self.components(),
            Token::Name => self.word(),
            Token::Infinity => Err(self.unexpected("a number or a name (`oo` is no number)")),
            _ => Err(self.unexpected("an expression")),
        }
    }

    fn number(&mut self) -> Result<Node, SyntaxError> {
        let (text, span) = (self.lexeme(), self.span());
        self.advance();
        if written_out(text) > MAX_DIGITS {
            self.report(SyntaxErrorKind::LiteralTooLong, span.clone());
            return self.build(Expr::Num(BigInt::from(1).into()), span, 1);
        }
        self.build(Expr::Num(parse_literal(text)), span, 1)
    }

    fn group(&mut self) -> Result<Node, SyntaxError> {
        let open = self.span();
        self.advance();
        let mut inner = self.nested(Self::node)?;
        inner.span = open.start..self.close(Token::CloseParen, '(', &open)?;
        Ok(inner)
    }

    fn bars(&mut self) -> Result<Node, SyntaxError> {
        let open = self.span();
        self.advance();
        let inner = self.nested(Self::node)?;
        let end = self.close(Token::Bar, '|', &open)?;
        self.between_bars(inner, open.start..end)
    }

    /// Passes the closing token of a group that was opened at `open`, and returns where it ends.
    pub(crate) fn close(
        &mut self,
        token: Token,
        opener: char,
        open: &Range<usize>,
    ) -> Result<usize, SyntaxError> {
        if self.accept(token) {
            return Ok(self.last_end());
        }
        if let Some(error) = self.missing_operator() {
            return Err(error);
        }
        match self.token {
            Token::BadNumber | Token::Stray(_) => Err(self.unexpected("an operator")),
            _ => Err(SyntaxError { kind: SyntaxErrorKind::Unclosed(opener), span: open.clone() }),
        }
    }
}

/// The start of a lexeme, so that no message grows with the input.
pub(crate) fn excerpt(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("{}…", text.get(..cut).unwrap_or_default()),
        None => text.to_owned(),
    }
}
