//! Which formula of a document stands for a symbol that varies with the inputs.

use std::collections::{BTreeMap, BTreeSet};

use kane_audit::{Body, Claim, Content, Document, Verdict};
use kane_kernel::{Context, Expr, Link, Rel, Relation, Sentence};

/// `symbol = expr` with nothing but inputs on the right.
#[derive(Clone, Debug)]
pub(crate) struct Definition {
    pub(crate) symbol: usize,
    pub(crate) expr: Expr,
    /// index of the statement
    pub(crate) statement: usize,
}

/// The closed definitions of a document, and which statements belong together.
#[derive(Debug)]
pub(crate) struct Expansions<'a> {
    document: &'a Document,
    definitions: Vec<Definition>,
    /// what each statement cites, directly or not, itself included
    closures: Vec<BTreeSet<usize>>,
}

/// One choice of formulas for symbols, by symbol, and the statements that give them.
#[derive(Clone, Debug, Default)]
pub(crate) struct Choice {
    pub(crate) values: BTreeMap<usize, Expr>,
    pub(crate) by: Vec<usize>,
}

impl<'a> Expansions<'a> {
    pub(crate) fn of(document: &'a Document) -> Self {
        let closures = closures(document);
        let mut definitions: Vec<Definition> = Vec::new();
        for (statement, stated) in document.statements.iter().enumerate() {
            let (Body::Given(_) | Body::Claim(Claim { expect: None | Some(Verdict::Proved), .. })) =
                &stated.body
            else {
                continue;
            };
            if !conditions(&stated.body).is_empty() {
                continue;
            }
            for relation in relations(&stated.body) {
                let (Rel::Eq, Expr::Var(symbol)) = (relation.rel, &relation.lhs) else { continue };
                let is_function =
                    |s: &usize| document.context.vars.get(*s).is_some_and(|v| v.of.is_some());
                let free = symbols(&relation.rhs, &document.context);
                let closed = is_function(symbol) && !free.iter().any(is_function);
                let known = |d: &Definition| d.symbol == *symbol && d.expr == relation.rhs;
                if closed && !definitions.iter().any(known) {
                    let expr = relation.rhs.clone();
                    definitions.push(Definition { symbol: *symbol, expr, statement });
                }
            }
        }
        Self { document, definitions, closures }
    }

    /// Every choice of definitions for the functions in a formula that belong to its statement and
    /// to each other; none if a function has no definition.
    pub(crate) fn choices(&self, expr: &Expr, statement: usize) -> Vec<Choice> {
        let context = &self.document.context;
        let is_function = |s: &usize| context.vars.get(*s).is_some_and(|v| v.of.is_some());
        let mut choices = vec![Choice::default()];
        for symbol in symbols(expr, context).into_iter().filter(is_function) {
            let mut next = Vec::new();
            for choice in &choices {
                for definition in self.definitions.iter().filter(|d| d.symbol == symbol) {
                    let fits = |other: usize| self.together(definition.statement, other);
                    if definition.statement != statement
                        && fits(statement)
                        && choice.by.iter().all(|other| fits(*other))
                    {
                        let mut choice = choice.clone();
                        choice.values.insert(symbol, definition.expr.clone());
                        choice.by.push(definition.statement);
                        next.push(choice);
                    }
                }
            }
            choices = next;
        }
        choices
    }

    /// Whether some statement rests on both.
    fn together(&self, a: usize, b: usize) -> bool {
        self.closures.iter().any(|closure| closure.contains(&a) && closure.contains(&b))
    }
}

fn closures(document: &Document) -> Vec<BTreeSet<usize>> {
    let mut closures: Vec<BTreeSet<usize>> = Vec::new();
    for (index, statement) in document.statements.iter().enumerate() {
        let mut closure = BTreeSet::from([index]);
        if let Body::Claim(claim) = &statement.body {
            for cited in &claim.from {
                closure.extend(closures.get(*cited).into_iter().flatten());
                closure.insert(*cited);
            }
        }
        closures.push(closure);
    }
    closures
}

/// The relations that a statement asserts.
pub(crate) fn relations(body: &Body) -> Vec<&Relation> {
    let links = |links: &'_ [Link]| -> Vec<usize> { (0..links.len()).collect() };
    match body {
        Body::Let(_) | Body::Defined(_) => vec![],
        Body::Given(Sentence { links: all, .. }) => links(all)
            .into_iter()
            .filter_map(|i| match all.get(i) {
                Some(Link::Relation(relation)) => Some(relation),
                _ => None,
            })
            .collect(),
        Body::Claim(Claim { content: Content::Links(all), .. }) => all
            .iter()
            .filter_map(|(link, _)| match link {
                Link::Relation(relation) => Some(relation),
                Link::Limit(_) => None,
            })
            .collect(),
        Body::Claim(_) => vec![],
    }
}

/// The conditions under which it asserts them.
pub(crate) fn conditions(body: &Body) -> &[Relation] {
    match body {
        Body::Let(_) | Body::Defined(_) => &[],
        Body::Given(sentence) => &sentence.when,
        Body::Claim(claim) => &claim.when,
    }
}

/// The symbols in an expression, definitions expanded.
pub(crate) fn symbols(expr: &Expr, context: &Context) -> BTreeSet<usize> {
    let mut found = BTreeSet::new();
    let mut seen = BTreeSet::new();
    let mut todo = vec![expr];
    while let Some(expr) = todo.pop() {
        match expr {
            Expr::Var(symbol) => _ = found.insert(*symbol),
            Expr::Let(index) if seen.insert(*index) => {
                todo.extend(context.lets.get(*index).map(|definition| &definition.body));
            }
            other => todo.extend(other.children()),
        }
    }
    found
}
