//! The formulas of a derivation document, as programs over their inputs.

use std::cmp::Ordering;

use kane_algebra::syntax::{Notation, compares};
use kane_audit::{Body, Document};
use kane_kernel::{Bound, Expr, Rel, Relation};
use kane_number::Rational;

use crate::expand::{Choice, Expansions, conditions, relations, symbols};
use crate::{Arithmetic, Axis, Format, Program, Unsupported};

/// A formula with everything that is needed to evaluate it.
#[derive(Clone, Debug)]
pub struct Formula {
    /// the label of the statement that prints it
    pub label: String,
    /// labels of further statements that print the same, with the same definitions
    pub also: Vec<String>,
    /// what it is a formula of: the other side
    pub quantity: String,
    /// as written
    pub text: String,
    /// labels of the statements whose formulas stand for symbols in it, evaluated first
    pub by: Vec<String>,
    /// the inputs
    pub inputs: Vec<Input>,
    /// its operations
    pub program: Program,
    /// where it holds, beyond the ranges of the inputs
    pub conditions: Vec<Condition>,
}

/// An input and its range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Input {
    /// name as written
    pub name: String,
    /// lower end, −∞ if absent
    pub lower: Option<Bound>,
    /// upper end, +∞ if absent
    pub upper: Option<Bound>,
}

impl Input {
    /// The floats of its range on one side of 0, which counts as positive; `None` if there is none.
    #[must_use]
    pub fn axis<F: Format>(&self, negative: bool) -> Option<Axis> {
        let (lower, upper) = (self.lower.as_ref(), self.upper.as_ref());
        if negative {
            Axis::below_zero::<F>(lower, upper)
        } else {
            Axis::between::<F>(lower, upper)
        }
    }
}

/// A relation between two programs over the same inputs.
#[derive(Clone, Debug)]
pub struct Condition {
    lhs: Program,
    rel: Rel,
    rhs: Program,
}

impl Condition {
    /// Its two sides and how they compare.
    pub(crate) const fn sides(&self) -> (&Program, Rel, &Program) {
        (&self.lhs, self.rel, &self.rhs)
    }

    /// Whether it holds at a point, as far as the arithmetic can tell.
    pub fn holds<A: Arithmetic>(&self, arithmetic: &A, inputs: &[A::Value]) -> bool {
        let (lhs, rhs) = (self.lhs.value(arithmetic, inputs), self.rhs.value(arithmetic, inputs));
        let order: Option<Ordering> =
            lhs.zip(rhs).and_then(|(lhs, rhs)| arithmetic.compare(&lhs, &rhs));
        order.is_some_and(|order| compares(self.rel, order))
    }
}

impl Formula {
    /// Whether a point is in its domain, the ranges of the inputs apart.
    pub fn admits<A: Arithmetic>(&self, arithmetic: &A, inputs: &[A::Value]) -> bool {
        self.conditions.iter().all(|condition| condition.holds(arithmetic, inputs))
    }
}

/// What was found in a document.
#[derive(Clone, Debug, Default)]
pub struct Formulas {
    /// the formulas, in the order of the text
    pub formulas: Vec<Formula>,
    /// labels of formulas that no program over floats can evaluate, and why
    pub left_out: Vec<(String, String)>,
}

/// Finds the formulas of a document: the body of each `let`, and each side of an equation of which
/// the first side is a symbol.
///
/// A symbol that varies with another is replaced by the formula which the document gives for it, in
/// every way that belongs to the statement: two statements belong together if some statement rests
/// on both. Inputs are the symbols that remain, in the order of declaration; a `given` that compares
/// one of them with a number narrows its range.
#[must_use]
pub fn formulas(document: &Document) -> Formulas {
    let expansions = Expansions::of(document);
    let mut found = Formulas::default();
    for (index, statement) in document.statements.iter().enumerate() {
        let label = &statement.label;
        let mut add = |quantity: &str, expr: &Expr| {
            for choice in expansions.choices(expr, index) {
                found.add(document, index, label, quantity, expr, &choice);
            }
        };
        match &statement.body {
            Body::Let(definition) => {
                if let Some(definition) = document.context.lets.get(*definition) {
                    add(&definition.name, &definition.body);
                }
            }
            Body::Defined(parts) => {
                for definition in parts.iter().filter_map(|i| document.context.lets.get(*i)) {
                    add(&definition.name, &definition.body);
                }
            }
            body => {
                let relations = relations(body);
                let mut quantity: Option<String> = None;
                let mut last: Option<&Expr> = None;
                for relation in relations {
                    if last != Some(&relation.lhs) {
                        let named = matches!(relation.lhs, Expr::Var(_) | Expr::Let(_));
                        quantity = named.then(|| relation.lhs.plain(&document.context));
                    }
                    last = Some(&relation.rhs);
                    if let (Rel::Eq, Some(quantity)) = (relation.rel, &quantity) {
                        add(quantity, &relation.rhs);
                    }
                }
            }
        }
    }
    found
}

impl Formulas {
    fn add(
        &mut self,
        document: &Document,
        index: usize,
        label: &str,
        quantity: &str,
        expr: &Expr,
        choice: &Choice,
    ) {
        let context = &document.context;
        let mut inputs = symbols(expr, context);
        for (symbol, value) in &choice.values {
            inputs.remove(symbol);
            inputs.extend(symbols(value, context));
        }
        let inputs: Vec<usize> = inputs.into_iter().collect();
        if inputs.is_empty() || matches!(expr, Expr::Var(_) | Expr::Let(_)) {
            return;
        }
        if let Some(made) = inputs.iter().find_map(|v| computed(context, *v)) {
            let why = format!("{made} is no input: how it is rounded itself is not known here");
            let left_out = (label.to_owned(), why);
            if !self.left_out.contains(&left_out) {
                self.left_out.push(left_out);
            }
            return;
        }
        let program = match Program::new(expr, context, &choice.values, &inputs) {
            Ok(program) => program,
            Err(why) => {
                let left_out = (label.to_owned(), reason(why, context));
                if !self.left_out.contains(&left_out) {
                    self.left_out.push(left_out);
                }
                return;
            }
        };
        let side = |expr| Program::new(expr, context, &choice.values, &inputs);
        let body = document.statements.get(index).map(|statement| &statement.body);
        let conditions: Vec<Condition> = body
            .map_or(&[][..], conditions)
            .iter()
            .filter_map(|Relation { lhs, rel, rhs }| {
                Some(Condition { lhs: side(lhs).ok()?, rel: *rel, rhs: side(rhs).ok()? })
            })
            .collect();
        let inputs: Vec<Input> = inputs.iter().filter_map(|s| input(document, *s)).collect();
        let same = self.formulas.iter_mut().find(|known| {
            known.inputs == inputs
                && known.program.operations() == program.operations()
                && (known.conditions.is_empty() || known.conditions.len() == conditions.len())
        });
        if let Some(known) = same {
            if known.label != label && !known.also.iter().any(|other| other == label) {
                known.also.push(label.to_owned());
            }
            return;
        }
        let label_of = |index: &usize| document.statements.get(*index).map(|s| s.label.clone());
        self.formulas.push(Formula {
            label: label.to_owned(),
            also: vec![],
            quantity: quantity.to_owned(),
            text: expr.plain(context),
            by: choice.by.iter().filter_map(label_of).collect(),
            inputs,
            program,
            conditions,
        });
    }
}

/// What stands for an exponential, a sine, a power or a sum, by its name: a program computes it, and its
/// rounding counts, so that `exp(x) - 1` is no difference of two inputs. A derivative is one.
fn computed(context: &kane_kernel::Context, symbol: usize) -> Option<&str> {
    let name = &context.vars.get(symbol)?.name;
    (name.contains('(') && !name.starts_with("d(")).then_some(name)
}

/// Why an expression is no formula of floats, in words.
fn reason(why: Unsupported, context: &kane_kernel::Context) -> String {
    match why {
        Unsupported::Derivative => "it has a derivative".to_owned(),
        Unsupported::Power => "an exponent is too large".to_owned(),
        Unsupported::Symbol(symbol) => {
            let name = context.vars.get(symbol).map_or("a symbol", |var| var.name.as_str());
            format!("{name} is neither an input nor given by a formula")
        }
    }
}

/// The symbol with its range, narrowed by what is given of it.
fn input(document: &Document, symbol: usize) -> Option<Input> {
    let var = document.context.vars.get(symbol)?;
    let (mut lower, mut upper) = (var.lower.clone(), var.upper.clone());
    for statement in &document.statements {
        let Body::Given(sentence) = &statement.body else { continue };
        let ([kane_kernel::Link::Relation(relation)], []) =
            (sentence.links.as_slice(), sentence.when.as_slice())
        else {
            continue;
        };
        let (Expr::Var(about), Expr::Num(value)) = (&relation.lhs, &relation.rhs) else { continue };
        if *about != symbol {
            continue;
        }
        let bound = |strict| Bound { value: Rational::clone(value), strict };
        match relation.rel {
            Rel::Gt | Rel::Ge if lower.as_ref().is_none_or(|b| b.value <= *value) => {
                lower = Some(bound(relation.rel == Rel::Gt));
            }
            Rel::Lt | Rel::Le if upper.as_ref().is_none_or(|b| b.value >= *value) => {
                upper = Some(bound(relation.rel == Rel::Lt));
            }
            _ => {}
        }
    }
    Some(Input { name: var.name.clone(), lower, upper })
}
