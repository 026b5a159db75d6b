//! From s-expressions to formulas.

use std::ops::Range;

use kane_algebra::syntax::Diagnostic;
use kane_kernel::Rel;
use kane_number::Rational;

use super::literal::literal;
use super::sexpr::{Fault, Kind, Sexpr, expressions};
use crate::{Argument, Core, Operation, Precision, Program, Test};

/// What may be called, in words.
const OPERATORS: &str = "+ - * / sqrt fma fabs fmin fmax let let* if";

/// Reads every FPCore of a text; there may be none.
///
/// # Errors
/// The first fault: its place, with the line and a caret, and the reason.
pub fn read(file: &str, text: &str) -> Result<Vec<Core>, Box<Diagnostic>> {
    let told = |(span, why): Fault| Box::new(Diagnostic::new(file, text, span, why));
    let expressions = expressions(text).map_err(told)?;
    expressions.iter().map(|expression| core(text, expression).map_err(told)).collect()
}

fn fault<T>(span: &Range<usize>, why: impl Into<String>) -> Result<T, Fault> {
    Err((span.clone(), why.into()))
}

fn core(text: &str, expression: &Sexpr<'_>) -> Result<Core, Fault> {
    let Some([head, rest @ ..]) = expression.list() else {
        return fault(&expression.span, "expected (FPCore (arguments) … expression)");
    };
    if head.atom() != Some("FPCore") {
        return fault(&head.span, "expected `FPCore`");
    }
    let (symbol, rest) = match rest {
        [first, rest @ ..] if first.atom().is_some() => (first.atom(), rest),
        rest => (None, rest),
    };
    let [arguments, rest @ ..] = rest else {
        return fault(&expression.span, "the list of arguments is missing");
    };
    let Some(names) = arguments.list() else {
        return fault(&arguments.span, "expected the list of arguments");
    };
    let mut reader = Reader { program: Program::new(), scope: Vec::new(), text };
    let mut found = Vec::new();
    for name in names {
        let Some(plain) = name.atom().filter(|name| literal(name).is_none()) else {
            return fault(&name.span, "an argument is a name, without annotations");
        };
        // none of them begins or ends anything where a name is written: in Scheme, in comments, in pages
        if let Some(c) = plain.chars().find(|c| "'`,|\\{}#".contains(*c)) {
            return fault(&name.span, format!("a name of FPCore has no `{c}`"));
        }
        if found.iter().any(|known: &Argument| known.name == plain) {
            return fault(&name.span, format!("there are two arguments `{plain}`"));
        }
        let index = reader.program.push(Operation::Input(found.len()), name.span.clone());
        reader.scope.push((plain.to_owned(), index));
        found.push(Argument::new(plain));
    }
    let Some((body, properties)) = rest.split_last() else {
        return fault(&expression.span, "the expression is missing");
    };
    let mut core = Core {
        name: symbol.map(str::to_owned),
        arguments: found,
        assumed: Vec::new(),
        precision: None,
        program: Program::new(),
        root: 0,
        properties: Vec::new(),
    };
    let mut pre = None;
    for property in properties.chunks(2) {
        let [key, value] = property else {
            let key = property.first().map_or(&body.span, |key| &key.span);
            return fault(key, "a property and its value are expected before the expression");
        };
        let Some(name) = key.atom().filter(|key| key.starts_with(':')) else {
            return fault(
                &key.span,
                "expected a property, as `:pre`, or one expression at the end",
            );
        };
        match name {
            ":name" => {
                let Kind::Text = value.kind else {
                    return fault(&value.span, "a name is a text in quotation marks");
                };
                let inside = value.span.start + 1..value.span.end - 1;
                core.name = Some(reader.slice(&inside).to_owned());
            }
            ":precision" => {
                core.precision = match value.atom() {
                    Some("binary32") => Some(Precision::F32),
                    Some("binary64") => Some(Precision::F64),
                    Some("real") => None,
                    _ => {
                        let why = "the precisions are binary32 and binary64";
                        return fault(&value.span, why);
                    }
                }
            }
            ":round" if value.atom() != Some("nearestEven") => {
                return fault(&value.span, "the only rounding is nearestEven");
            }
            ":pre" => pre = Some(value),
            _ => core.properties.push((name.to_owned(), reader.slice(&value.span).to_owned())),
        }
    }
    if let Some(pre) = pre {
        let test = reader.test(pre)?;
        assume(test, &reader.program, &mut core);
        for argument in &core.arguments {
            if let (Some(lower), Some(upper)) = (&argument.lower, &argument.upper)
                && (lower.value > upper.value
                    || (lower.value == upper.value && (lower.strict || upper.strict)))
            {
                return fault(&pre.span, format!("no {} is in its range", argument.name));
            }
        }
    }
    core.root = reader.expression(body)?;
    core.program = reader.program;
    Ok(core)
}

/// Takes bounds on arguments out of what is assumed, and keeps the rest.
fn assume(test: Test, program: &Program, core: &mut Core) {
    match test {
        Test::All(tests) => tests.into_iter().for_each(|test| assume(test, program, core)),
        Test::Compare(rel, a, b) => {
            let argument = |index: usize| match program.get(index) {
                Some(Operation::Input(input)) => Some(*input),
                _ => None,
            };
            let (sides, seen) = match (argument(a), program.number(b)) {
                (Some(input), Some(number)) => (Some((input, number)), rel),
                _ => (argument(b).zip(program.number(a)), turned(rel)),
            };
            let bounded = sides
                .filter(|_| rel != Rel::Ne)
                .and_then(|(input, number)| Some((core.arguments.get_mut(input)?, number)));
            let Some((argument, number)) = bounded else {
                core.assumed.push(Test::Compare(rel, a, b));
                return;
            };
            if matches!(seen, Rel::Gt | Rel::Ge | Rel::Eq) {
                argument.at_least(number, seen == Rel::Gt);
            }
            if matches!(seen, Rel::Lt | Rel::Le | Rel::Eq) {
                argument.at_most(number, seen == Rel::Lt);
            }
        }
        other => core.assumed.push(other),
    }
}

/// The comparison with its sides exchanged.
const fn turned(rel: Rel) -> Rel {
    match rel {
        Rel::Lt => Rel::Gt,
        Rel::Le => Rel::Ge,
        Rel::Gt => Rel::Lt,
        Rel::Ge => Rel::Le,
        Rel::Eq | Rel::Ne => rel,
    }
}

struct Reader<'a> {
    program: Program,
    /// names in force, the innermost last
    scope: Vec<(String, usize)>,
    text: &'a str,
}

impl<'a> Reader<'a> {
    fn slice(&self, span: &Range<usize>) -> &'a str {
        self.text.get(span.clone()).unwrap_or_default()
    }

    fn expression(&mut self, written: &Sexpr<'_>) -> Result<usize, Fault> {
        let span = &written.span;
        let (head, operands) = match &written.kind {
            Kind::Text => return fault(span, "a text is no expression"),
            Kind::Atom(atom) => return self.atom(atom, span),
            Kind::List(items) => match items.split_first() {
                Some((head, operands)) => (head, operands),
                None => return fault(span, "an expression is missing here"),
            },
        };
        let Some(name) = head.atom() else {
            return fault(&head.span, format!("expected one of {OPERATORS}"));
        };
        let operation = match (name, operands) {
            ("let" | "let*", [bindings, body]) => return self.bound(name, bindings, body),
            ("if", [test, yes, no]) => {
                let test = self.test(test)?;
                Operation::If(test, self.expression(yes)?, self.expression(no)?)
            }
            ("-", [a]) => Operation::Neg(self.expression(a)?),
            ("sqrt", [a]) => Operation::Sqrt(self.expression(a)?),
            ("fabs", [a]) => Operation::Abs(self.expression(a)?),
            ("fma", [a, b, c]) => {
                let (a, b) = (self.expression(a)?, self.expression(b)?);
                Operation::Fma(a, b, self.expression(c)?)
            }
            ("+" | "-" | "*" | "/" | "fmin" | "fmax", [a, b]) => {
                let (a, b) = (self.expression(a)?, self.expression(b)?);
                match name {
                    "+" => Operation::Add(a, b),
                    "-" => Operation::Sub(a, b),
                    "*" => Operation::Mul(a, b),
                    "/" => Operation::Div(a, b),
                    "fmin" => Operation::Min(a, b),
                    _ => Operation::Max(a, b),
                }
            }
            (
                "let" | "let*" | "if" | "-" | "sqrt" | "fabs" | "fma" | "+" | "*" | "/" | "fmin"
                | "fmax",
                _,
            ) => {
                let count = operands.len();
                let operands = if count == 1 { "operand" } else { "operands" };
                return fault(span, format!("`{name}` does not take {count} {operands}"));
            }
            ("<" | ">" | "<=" | ">=" | "==" | "!=" | "and" | "or" | "not", _) => {
                return fault(span, "a comparison is no number");
            }
            _ => {
                let why = format!("`{name}` is none of the operators {OPERATORS}");
                return fault(&head.span, why);
            }
        };
        Ok(self.program.push(operation, span.clone()))
    }

    fn atom(&mut self, atom: &str, span: &Range<usize>) -> Result<usize, Fault> {
        if let Some((_, index)) = self.scope.iter().rev().find(|(name, _)| name == atom) {
            return Ok(*index);
        }
        match literal(atom) {
            Some(Ok(number)) => Ok(self.program.push(Operation::Number(number), span.clone())),
            Some(Err(why)) => fault(span, why),
            None => fault(span, format!("`{atom}` is neither an argument nor bound by a let")),
        }
    }

    fn bound(
        &mut self,
        name: &str,
        bindings: &Sexpr<'_>,
        body: &Sexpr<'_>,
    ) -> Result<usize, Fault> {
        let Some(pairs) = bindings.list() else {
            return fault(&bindings.span, "expected ((name expression) …)");
        };
        let before = self.scope.len();
        let mut parallel = Vec::new();
        for pair in pairs {
            let Some([symbol, value]) = pair.list() else {
                return fault(&pair.span, "expected (name expression)");
            };
            let Some(symbol) = symbol.atom().filter(|symbol| literal(symbol).is_none()) else {
                return fault(&symbol.span, "expected a name");
            };
            let bound = (symbol.to_owned(), self.expression(value)?);
            if name == "let" { parallel.push(bound) } else { self.scope.push(bound) }
        }
        self.scope.extend(parallel);
        let result = self.expression(body);
        self.scope.truncate(before);
        result
    }

    fn test(&mut self, written: &Sexpr<'_>) -> Result<Test, Fault> {
        let span = &written.span;
        match written.atom() {
            Some("TRUE") => return Ok(Test::All(vec![])),
            Some("FALSE") => return Ok(Test::Any(vec![])),
            _ => {}
        }
        let Some([head, operands @ ..]) = written.list() else {
            return fault(span, "expected a comparison");
        };
        let name = head.atom().unwrap_or_default();
        let rel = match name {
            "<" => Rel::Lt,
            ">" => Rel::Gt,
            "<=" => Rel::Le,
            ">=" => Rel::Ge,
            "==" => Rel::Eq,
            "!=" => Rel::Ne,
            "and" | "or" => {
                let tests: Result<Vec<Test>, Fault> =
                    operands.iter().map(|operand| self.test(operand)).collect();
                return Ok(if name == "and" { Test::All(tests?) } else { Test::Any(tests?) });
            }
            "not" => {
                let [operand] = operands else { return fault(span, "`not` takes one operand") };
                return Ok(Test::Not(Box::new(self.test(operand)?)));
            }
            _ => {
                let why = "expected a comparison: < > <= >= == != and or not";
                return fault(&head.span, why);
            }
        };
        if operands.len() < 2 {
            return fault(span, "a comparison takes two operands or more");
        }
        let sides: Result<Vec<usize>, Fault> =
            operands.iter().map(|operand| self.side(operand)).collect();
        let sides = sides?;
        let compare = |(a, b): (&usize, &usize)| Test::Compare(rel, *a, *b);
        let mut tests: Vec<Test> = sides.iter().zip(sides.iter().skip(1)).map(compare).collect();
        if rel == Rel::Ne {
            // all are different from each other
            tests.clear();
            for (index, a) in sides.iter().enumerate() {
                tests.extend(sides.iter().skip(index + 1).map(|b| Test::Compare(rel, *a, *b)));
            }
        }
        Ok(if tests.len() == 1 { tests.remove(0) } else { Test::All(tests) })
    }

    /// A side of a comparison: quotients of numbers count as numbers.
    fn side(&mut self, written: &Sexpr<'_>) -> Result<usize, Fault> {
        let index = self.expression(written)?;
        Ok(match constant(&self.program, index) {
            Some(value) => self.program.push(Operation::Number(value), written.span.clone()),
            None => index,
        })
    }
}

/// The exact value of an operation on numbers alone, one deep.
fn constant(program: &Program, index: usize) -> Option<Rational> {
    match *program.get(index)? {
        Operation::Neg(a) => Some(-program.number(a)?.clone()),
        Operation::Div(a, b) => {
            let divisor = program.number(b)?;
            (*divisor != Rational::from_integer(0.into())).then_some(())?;
            Some(program.number(a)? / divisor)
        }
        _ => None,
    }
}
