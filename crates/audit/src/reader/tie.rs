//! Symbols that equations tie to the variable of a derivative, which would hold them fixed.
//!
//! The equations of a claim's premises and conditions are taken together: y = z and z = x² tie y to x.
//! Inequalities that hold only with equality are equations, too. What the equations pin to one value, such
//! as m in m = 2, ties nothing to anything.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::ops::Range;
use std::rc::Rc;

use kane_algebra::rational_function::RationalFunction;
use kane_algebra::syntax::{Angle, Scope};
use kane_kernel::{Expr, Link, Rel, Relation, Target};

use super::Fault;
use super::citation::{Cited, Draft, DraftBody, DraftClaim, DraftContent};
use super::interior::Interiors;

/// What varies in a derivative.
#[derive(Clone, Debug)]
struct Derivative {
    by: usize,
    /// the symbols that it holds fixed
    others: BTreeSet<usize>,
    /// whether functions of the variable may vary with it: then equations with them tie nothing
    total: bool,
}

/// What a relation speaks of.
#[derive(Debug)]
struct Difference {
    relation: Relation,
    /// the symbols of the difference of its sides, in lowest terms
    symbols: BTreeSet<usize>,
}

/// Finds ties, and remembers what it has found in statements.
#[derive(Debug)]
pub(super) struct Ties<'a> {
    scope: &'a Scope,
    drafts: &'a [Draft],
    /// by statement
    derivatives: HashMap<usize, Rc<Vec<Derivative>>>,
    relations: HashMap<usize, Rc<Vec<Rc<Difference>>>>,
    interiors: Interiors<'a>,
}

/// An equation and what states it: cited statements, or the claim's own conditions.
#[derive(Clone, Debug)]
struct Equation {
    symbols: BTreeSet<usize>,
    cited: Vec<Option<usize>>,
}

/// A symbol that is tied to the variable of a derivative.
#[derive(Debug)]
struct Tied {
    symbol: usize,
    to: usize,
    /// what states the equations between them
    links: Vec<Option<usize>>,
    /// the statement with the derivative
    place: usize,
}

impl<'a> Ties<'a> {
    pub(super) fn new(scope: &'a Scope, drafts: &'a [Draft]) -> Self {
        let (derivatives, relations) = (HashMap::new(), HashMap::new());
        let interiors = Interiors::new(scope.context());
        Self { scope, drafts, derivatives, relations, interiors }
    }

    /// The fault that the premises of a claim, each at its place in the list, or its conditions tie a
    /// symbol to the variable of a derivative in it, in one of them, or in what does not follow.
    pub(super) fn find(
        &mut self,
        index: usize,
        premises: &[(usize, &Cited)],
        target: Option<usize>,
    ) -> Option<Fault> {
        let statements = || premises.iter().map(|(premise, _)| *premise).chain(target);
        let mut derivatives: Vec<(Derivative, usize)> = Vec::new();
        for statement in [index].into_iter().chain(statements()) {
            let found = self.derivatives_of(statement);
            derivatives.extend(found.iter().map(|derivative| (derivative.clone(), statement)));
        }
        if derivatives.is_empty() {
            return None;
        }
        if let Some(sought) = premises.iter().find(|(premise, _)| self.is_sought(*premise)) {
            return Some(Self::beside_sought(sought.1));
        }
        if derivatives.iter().all(|(derivative, _)| derivative.others.is_empty()) {
            return None;
        }
        let mut relations = Vec::new();
        for (place, (premise, _)) in premises.iter().enumerate() {
            let said = self.relations_of(*premise);
            relations.extend(said.iter().map(|difference| (difference.clone(), Some(place))));
        }
        let own = self.claim(index)?;
        let of_target = target.map(|target| when_of(&self.drafts.get(target)?.body));
        for relation in own.when.iter().chain(of_target.flatten().unwrap_or_default()) {
            relations.push((Rc::new(self.difference(relation)), None));
        }
        let said: Vec<&Relation> = relations.iter().map(|(d, _)| &d.relation).collect();
        let alone = |rel: fn(Rel) -> bool| -> Vec<Vec<usize>> {
            (0..said.len()).filter(|i| rel(said[*i].rel)).map(|i| vec![i]).collect()
        };
        let equal = equations(&relations, &alone(|rel| rel == Rel::Eq));
        if let Some(tied) = self.tied(equal.clone(), &derivatives) {
            return Some(self.fault(index, premises, tied, true));
        }
        let tight = self.interiors.tight(&said);
        let sure = tight.is_some();
        let tight = equations(&relations, &tight.unwrap_or_else(|| alone(|rel| rel != Rel::Eq)));
        let tied = self.tied([equal, tight].concat(), &derivatives)?;
        Some(self.fault(index, premises, tied, sure))
    }

    /// What equations tie in one of the derivatives.
    fn tied(
        &self,
        mut equations: Vec<Equation>,
        derivatives: &[(Derivative, usize)],
    ) -> Option<Tied> {
        // an angle, its cosine and its sine vary together, whatever is said of them
        equations.extend(self.scope.angles().map(|(theta, Angle { cos, sin, .. })| Equation {
            symbols: [theta, cos, sin].into(),
            cited: Vec::new(),
        }));
        let vars = &self.scope.context().vars;
        derivatives.iter().find_map(|(derivative, place)| {
            let Derivative { by, others, total } = derivative;
            let varies = |v: &usize| vars.get(*v).is_some_and(|var| var.of == Some(*by));
            let ties = |e: &&Equation| !total || !e.symbols.iter().any(varies);
            let (symbol, links) =
                chain(&equations.iter().filter(ties).collect::<Vec<_>>(), *by, others)?;
            Some(Tied { symbol, to: *by, links, place: *place })
        })
    }

    /// Whether a statement says that something exists for which nothing is named.
    fn is_sought(&self, index: usize) -> bool {
        matches!(self.claim(index), Some(claim) if !claim.sought.is_empty())
    }

    /// What will be found may tie symbols, so it is not cited beside a derivative.
    fn beside_sought(cited: &Cited) -> Fault {
        let message = format!("`{}` names nothing that exists", cited.label);
        let note = "beside a derivative it has to, as in `by y := 2*x`: what is found might tie symbols to each \
                    other";
        Fault::new(cited.span.clone(), message).with_note(note)
    }

    fn claim(&self, index: usize) -> Option<&'a DraftClaim> {
        match &self.drafts.get(index)?.body {
            DraftBody::Claim(claim) => Some(claim),
            _ => None,
        }
    }

    fn fault(
        &self,
        index: usize,
        premises: &[(usize, &Cited)],
        Tied { symbol, to, links, place }: Tied,
        sure: bool,
    ) -> Fault {
        let name = |v: usize| self.scope.context().vars.get(v).map_or("?", |var| &var.name);
        let (x, y) = (name(to), name(symbol));
        let own = |draft: &Draft| draft.parts.label.clone();
        let mut span: Range<usize> = self.drafts.get(index).map(own).unwrap_or_default();
        let mut labels: Vec<String> = Vec::new();
        for link in &links {
            let cited = link.and_then(|place| premises.get(place)).map(|(_, cited)| cited);
            if let Some(cited) = cited {
                span = cited.span.clone();
            }
            let label = cited.map_or("its `when`".to_owned(), |cited| format!("`{}`", cited.label));
            if !labels.contains(&label) {
                labels.push(label);
            }
        }
        let tie = match (labels.as_slice(), sure) {
            ([one], true) => format!("{one} ties"),
            ([one], false) => format!("{one} may tie"),
            (several, true) => format!("{} together tie", several.join(", ")),
            (several, false) => format!("{} together may tie", several.join(", ")),
        };
        let message = format!("{tie} `{y}` to `{x}`");
        let where_it_is = match self.drafts.get(place) {
            Some(draft) if place != index => format!("`{}`", draft.label),
            _ => "this claim".to_owned(),
        };
        let note = format!(
            "a derivative by `{x}` in {where_it_is} holds `{y}` fixed; `var {y}({x})` varies"
        );
        Fault::new(span, message).with_note(note)
    }

    fn derivatives_of(&mut self, index: usize) -> Rc<Vec<Derivative>> {
        if let Some(known) = self.derivatives.get(&index) {
            return known.clone();
        }
        let mut found = Vec::new();
        let body = self.drafts.get(index).map(|draft| &draft.body);
        for side in body.map(sides).unwrap_or_default() {
            self.scope.visit(side, &mut |node| {
                if let Expr::Deriv(f, x) = node {
                    let mut others = self.scope.inside(self.scope.symbols(f));
                    let of = |v: usize| self.scope.context().vars.get(v).and_then(|var| var.of);
                    // a function varies with its variable, and so do the other functions of it
                    if let Some(t) = of(*x) {
                        others.retain(|other| of(*other).is_none());
                        found.push(Derivative { by: t, others, total: true });
                        return;
                    }
                    // the chain rule has one by the symbol inside beside it
                    if self.scope.exponential_at(*x).is_some() {
                        return;
                    }
                    // cosine and sine vary together
                    let own = self.scope.angle(*x).map(|angle| (*x, *angle));
                    let mut varied = match own.or_else(|| self.scope.angle_at(*x)) {
                        Some((theta, angle)) => vec![theta, angle.cos, angle.sin],
                        None => vec![*x],
                    };
                    let exponentials = self.scope.exponentials().filter(|e| e.of.contains(*x));
                    varied.extend(exponentials.map(|e| e.symbol));
                    others.retain(|other| !varied.contains(other));
                    let fixed = |by| Derivative { by, others: others.clone(), total: false };
                    found.extend(varied.into_iter().map(fixed));
                }
            });
        }
        let found = Rc::new(found);
        self.derivatives.insert(index, found.clone());
        found
    }

    fn relations_of(&mut self, index: usize) -> Rc<Vec<Rc<Difference>>> {
        if let Some(known) = self.relations.get(&index) {
            return known.clone();
        }
        let body = self.drafts.get(index).map(|draft| &draft.body);
        let relations = body.map(relations).unwrap_or_default();
        let found = relations.into_iter().map(|r| Rc::new(self.difference(r)));
        let found = Rc::new(found.collect::<Vec<_>>());
        self.relations.insert(index, found.clone());
        found
    }

    fn difference(&self, relation: &Relation) -> Difference {
        let (lhs, rhs) = (relation.lhs.clone(), relation.rhs.clone());
        let difference = Expr::Sub(lhs.into(), rhs.into());
        let symbols: BTreeSet<usize> =
            match RationalFunction::from_expr(&difference, self.scope.context()) {
                Ok(value) => value.fraction().0.vars().into_iter().collect(),
                Err(_) => self.scope.symbols(&difference),
            };
        // what is said of an exponential is said of what is in it
        let symbols = self.scope.with_factors(symbols);
        Difference { relation: relation.clone(), symbols }
    }
}

/// A relation, and the place of what states it.
type Stated = (Rc<Difference>, Option<usize>);

/// Each of these sets of relations as equations that it makes together.
fn equations(relations: &[Stated], sets: &[Vec<usize>]) -> Vec<Equation> {
    let stated = |set: &Vec<usize>| {
        let all: Vec<&Stated> = set.iter().filter_map(|i| relations.get(*i)).collect();
        let cited: Vec<Option<usize>> = all.iter().map(|(_, cited)| *cited).collect();
        let one = |(d, _): &&Stated| Equation { symbols: d.symbols.clone(), cited: cited.clone() };
        all.iter().map(one).collect::<Vec<_>>()
    };
    sets.iter().flat_map(stated).collect()
}

/// The first of the symbols that a chain of equations ties to x, and the chain from it to x.
fn chain(
    equations: &[&Equation],
    x: usize,
    others: &BTreeSet<usize>,
) -> Option<(usize, Vec<Option<usize>>)> {
    let direct = equations.iter().filter(|e| e.symbols.contains(&x));
    for equation in direct {
        if let Some(y) = others.intersection(&equation.symbols).next() {
            return Some((*y, equation.cited.clone()));
        }
    }
    let pinned = pinned(equations, x);
    // by symbol: the equation that ties it, and to which symbol
    let mut tied: BTreeMap<usize, (&Equation, usize)> = BTreeMap::new();
    let mut used = vec![false; equations.len()];
    let mut reached = vec![x];
    let mut next = 0;
    while let Some(&from) = reached.get(next) {
        next += 1;
        for (equation, used) in equations.iter().zip(&mut used) {
            if *used || !equation.symbols.contains(&from) {
                continue;
            }
            *used = true;
            for &y in equation.symbols.iter().filter(|y| !pinned.contains(*y)) {
                if y != x && !tied.contains_key(&y) {
                    tied.insert(y, (equation, from));
                    reached.push(y);
                }
            }
        }
    }
    let y = *others.iter().find(|y| tied.contains_key(*y))?;
    let mut links = Vec::new();
    let mut at = y;
    while let Some((equation, to)) = tied.get(&at) {
        links.extend(&equation.cited);
        at = *to;
    }
    Some((y, links))
}

/// The symbols that equations without x pin: an equation in which all but one are pinned pins that one.
fn pinned(equations: &[&Equation], x: usize) -> BTreeSet<usize> {
    let mut pinned = BTreeSet::new();
    loop {
        let before = pinned.len();
        for equation in equations.iter().filter(|e| !e.symbols.contains(&x)) {
            let mut open = equation.symbols.difference(&pinned);
            if let (Some(&last), None) = (open.next(), open.next()) {
                pinned.insert(last);
            }
        }
        if pinned.len() == before {
            return pinned;
        }
    }
}

fn links(body: &DraftBody) -> Vec<&Link> {
    match body {
        DraftBody::Given(sentence) => sentence.links.iter().collect(),
        DraftBody::Claim(DraftClaim { content: DraftContent::Links(links), .. }) => {
            links.iter().map(|(link, _)| link).collect()
        }
        DraftBody::Claim(_) | DraftBody::Let(_) | DraftBody::Defined(_) | DraftBody::Broken => {
            Vec::new()
        }
    }
}

fn when_of(body: &DraftBody) -> Option<&[Relation]> {
    match body {
        DraftBody::Given(sentence) => Some(&sentence.when),
        DraftBody::Claim(claim) => Some(&claim.when),
        DraftBody::Let(_) | DraftBody::Defined(_) | DraftBody::Broken => None,
    }
}

/// The relations that a statement says or sets as conditions.
fn relations(body: &DraftBody) -> Vec<&Relation> {
    let said = links(body).into_iter().filter_map(|link| match link {
        Link::Relation(relation) => Some(relation),
        Link::Limit(_) => None,
    });
    said.chain(when_of(body).unwrap_or_default()).collect()
}

/// The variables of the limits in a statement.
pub(super) fn limits(body: &DraftBody) -> Vec<usize> {
    let variable = |link: &Link| match link {
        Link::Limit(limit) => Some(limit.var),
        Link::Relation(_) => None,
    };
    links(body).into_iter().filter_map(variable).collect()
}

/// All expressions of a statement.
pub(super) fn sides(body: &DraftBody) -> Vec<&Expr> {
    let mut sides = Vec::new();
    for link in links(body) {
        match link {
            Link::Relation(relation) => sides.extend([&relation.lhs, &relation.rhs]),
            Link::Limit(limit) => {
                sides.push(&limit.expr);
                if let Target::Finite(value) = &limit.to {
                    sides.push(value);
                }
            }
        }
    }
    let when = when_of(body).unwrap_or_default();
    sides.extend(when.iter().flat_map(|relation| [&relation.lhs, &relation.rhs]));
    sides
}
