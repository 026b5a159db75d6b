//! `exists y: …` without `by`: what may do in the place of y.
//!
//! Equations are solved, one name after the other; where only inequalities speak of a name, what lies between and
//! beside their boundaries is proposed, and then simple expressions of the symbols that are spoken of. Nothing that is
//! proposed here is trusted: each tuple is put in and judged as if the author had written it behind `by`.

use std::collections::BTreeSet;
use std::ops::Range;

use kane_algebra::rational_function::RationalFunction;
use kane_algebra::syntax::{put_in, rebuild};
use kane_kernel::{Context, Expr, Link, Poly, Rel, Relation, Var};
use num_rational::BigRational;
use num_traits::Signed as _;

use crate::spoken::within;

/// Tuples that are proposed in all.
const MOST: usize = 64;
/// Readings of a relation by the signs of its magnitudes and the sides of its minima and maxima.
const MOST_READINGS: usize = 8;
/// Symbols of which simple expressions are proposed.
const MOST_SYMBOLS: usize = 4;
/// Readings of all relations that are looked at for one name.
const MOST_PARTS: usize = 32;
/// Boundaries of a name between and beside which something is proposed.
const MOST_BOUNDS: usize = 8;
/// Nodes of an expression in which further names are replaced.
const MOST_NODES: usize = 10_000;

/// Something that is said to exist, and for which nothing is named.
#[derive(Clone, Debug)]
pub struct Existence {
    /// the names that are bound, in the order of their placeholders
    pub names: Vec<String>,
    /// what is said of them, with a [placeholder](kane_algebra::syntax::placeholder) for each name, and the byte range of each part in the text
    pub links: Vec<(Link, Range<usize>)>,
    /// whether symbols have units: then nothing is proposed that adds a number to one of them
    pub units: bool,
}

impl Existence {
    /// What is said when these values stand in the place of the names.
    #[must_use]
    pub fn of(&self, values: &[Expr]) -> Vec<(Link, Range<usize>)> {
        let side = |e: &Expr| put_in(e, values);
        let of = |link: &Link| match link {
            Link::Relation(r) => {
                Link::Relation(Relation { lhs: side(&r.lhs), rel: r.rel, rhs: side(&r.rhs) })
            }
            Link::Limit(_) => link.clone(),
        };
        self.links.iter().map(|(link, span)| (of(link), span.clone())).collect()
    }

    /// Values for the names to be tried, the likeliest first, in which the symbols stand that are spoken of here and
    /// in the conditions. A heuristic: that none does says nothing.
    pub(crate) fn proposed(&self, when: &[Relation], context: &Context) -> Vec<Vec<Expr>> {
        let first = context.vars.len();
        let mut wide = context.clone();
        let unbound =
            |name: &String| Var { name: name.clone(), of: None, lower: None, upper: None };
        wide.vars.extend(self.names.iter().map(unbound));
        let names: Vec<usize> = (first..wide.vars.len()).collect();
        let symbols: Vec<Expr> = names.iter().map(|v| Expr::Var(*v)).collect();
        let relations: Vec<Relation> = self
            .of(&symbols)
            .into_iter()
            .filter_map(|(link, _)| match link {
                Link::Relation(relation) => Some(relation),
                Link::Limit(_) => None,
            })
            .collect();
        let sides = relations.iter().chain(when).flat_map(|r| [&r.lhs, &r.rhs]);
        let (mut spoken, _) = within(context, sides.collect());
        spoken.retain(|v| *v < first);
        let search = Search { context: &wide, spoken: &spoken, units: self.units };
        let mut found = Vec::new();
        search.tuples(&relations, &names, &mut Vec::new(), &mut found);
        let mut tuples: Vec<Vec<Expr>> = Vec::new();
        for values in found {
            let tuple = names.iter().map(|name| search.written(*name, &values)).collect();
            if let Some(tuple) = tuple
                && !tuples.contains(&tuple)
            {
                tuples.push(tuple);
            }
        }
        tuples
    }
}

/// A name, by its symbol, and what is put in its place; it may speak of names that are chosen later.
type Chosen = Vec<(usize, Expr)>;

/// Where values are looked for.
struct Search<'a> {
    /// the document's, with a symbol for each name behind its own
    context: &'a Context,
    /// the symbols of what is said
    spoken: &'a BTreeSet<usize>,
    units: bool,
}

impl Search<'_> {
    /// Chooses values for the names that are left, one after the other.
    fn tuples(
        &self,
        relations: &[Relation],
        left: &[usize],
        chosen: &mut Chosen,
        found: &mut Vec<Chosen>,
    ) {
        if left.is_empty() {
            found.push(chosen.clone());
            return;
        }
        let parts: Vec<Part> =
            relations.iter().flat_map(|r| self.parts(r)).take(MOST_PARTS).collect();
        let (name, values) =
            self.solved(&parts, left).unwrap_or_else(|| (left[0], self.beside(&parts, left[0])));
        let rest: Vec<usize> = left.iter().copied().filter(|other| *other != name).collect();
        // as many for each name that all tuples together are no more than there may be
        let share = match left.len() {
            1 => MOST,
            2 => 8,
            3 => 4,
            _ => 2,
        };
        for value in values.into_iter().take(share) {
            if found.len() >= MOST {
                return;
            }
            let put = |e: &Expr| replaced(e, name, &value);
            let next: Vec<Relation> = relations
                .iter()
                .map(|r| Relation { lhs: put(&r.lhs), rel: r.rel, rhs: put(&r.rhs) })
                .collect();
            if next.iter().flat_map(|r| [&r.lhs, &r.rhs]).any(is_large) {
                continue;
            }
            chosen.push((name, value.clone()));
            self.tuples(&next, &rest, chosen, found);
            chosen.pop();
        }
    }

    /// The value of a name, in which no name stands any more; nothing if it is too large.
    fn written(&self, name: usize, chosen: &Chosen) -> Option<Expr> {
        let place = chosen.iter().position(|(known, _)| *known == name)?;
        let mut value = chosen[place].1.clone();
        for (later, of) in &chosen[place + 1..] {
            value = replaced(&value, *later, of);
            if is_large(&value) {
                return None;
            }
        }
        let simple = RationalFunction::from_expr(&value, self.context).map(|f| f.to_expr());
        Some(simple.unwrap_or(value))
    }

    /// A relation as polynomials against zero, one for each reading of its magnitudes, minima and maxima.
    fn parts(&self, relation: &Relation) -> Vec<Part> {
        let difference = Expr::Sub(relation.lhs.clone().into(), relation.rhs.clone().into());
        let part = |e: Expr| {
            let (p, _) = RationalFunction::from_expr(&e, self.context).ok()?.fraction();
            Some(Part { p, rel: relation.rel })
        };
        readings(&difference).into_iter().filter_map(part).collect()
    }

    /// A name that an equation gives, and what it gives: one of degree one first, by a number before an expression.
    fn solved(&self, parts: &[Part], left: &[usize]) -> Option<(usize, Vec<Expr>)> {
        let equations = || parts.iter().filter(|part| part.rel == Rel::Eq);
        let each =
            || left.iter().flat_map(move |name| equations().map(move |part| (*name, &part.p)));
        let linear = |(name, p): &(usize, &Poly)| p.degree(*name) == 1;
        let by_number = |(name, p): &(usize, &Poly)| p.coefficient(*name, 1).is_constant();
        let one = each().filter(linear).find(by_number).or_else(|| each().find(linear));
        let of_degree_two = || each().find(|(name, p)| p.degree(*name) == 2);
        let (name, p) = one.or_else(of_degree_two)?;
        // where the coefficients vanish, anything does
        let mut values = roots(p, name);
        values.push(Expr::int(0));
        if !self.units {
            values.push(Expr::int(1));
        }
        Some((name, values))
    }

    /// What lies between and beside the boundaries of a name, and simple expressions.
    fn beside(&self, parts: &[Part], name: usize) -> Vec<Expr> {
        let of_name = parts.iter().filter(|part| part.p.degree(name) > 0);
        let bounds = of_name.flat_map(|part| roots(&part.p, name)).take(MOST_BOUNDS);
        let bounds: Vec<Expr> = bounds.collect();
        let mut found = Vec::new();
        for (i, a) in bounds.iter().enumerate() {
            found.extend(bounds[i + 1..].iter().map(|b| over(plus(a, b), 2)));
        }
        if !self.units {
            for (i, a) in bounds.iter().enumerate() {
                let pairs = bounds[i + 1..].iter();
                found.extend(pairs.flat_map(|b| {
                    [plus(&greatest(a, b), &Expr::int(1)), minus(&least(a, b), &Expr::int(1))]
                }));
            }
            found.extend(
                bounds.iter().flat_map(|b| [plus(b, &Expr::int(1)), minus(b, &Expr::int(1))]),
            );
        }
        found.extend(bounds.iter().flat_map(|b| [b.clone(), over(b.clone(), 2), times(2, b)]));
        found.extend(self.simple());
        let mut values: Vec<Expr> = Vec::new();
        for value in found {
            let value = RationalFunction::from_expr(&value, self.context)
                .map(|f| f.to_expr())
                .unwrap_or(value);
            if !values.contains(&value) {
                values.push(value);
            }
        }
        values
    }

    /// Simple numbers, and simple expressions of the symbols.
    fn simple(&self) -> Vec<Expr> {
        let one = &Expr::int(1);
        let symbols: Vec<Expr> =
            self.spoken.iter().take(MOST_SYMBOLS).map(|v| Expr::Var(*v)).collect();
        let mut found = vec![Expr::int(0)];
        if !self.units {
            found.extend([1, -1, 2].map(Expr::int));
        }
        for x in &symbols {
            found.extend([x.clone(), Expr::Neg(x.clone().into()), over(x.clone(), 2), times(2, x)]);
            if !self.units {
                let (square, size) = (Expr::Pow(x.clone().into(), 2), Expr::Abs(x.clone().into()));
                found.extend([
                    plus(x, one),
                    minus(x, one),
                    plus(&size, one),
                    plus(&square, one),
                    square,
                    size,
                ]);
                found.push(Expr::Div(one.clone().into(), x.clone().into()));
            }
        }
        for (i, x) in symbols.iter().enumerate() {
            for y in &symbols[i + 1..] {
                found.extend([
                    plus(x, y),
                    minus(x, y),
                    minus(y, x),
                    over(plus(x, y), 2),
                    greatest(x, y),
                    least(x, y),
                ]);
                if !self.units {
                    found.push(Expr::Mul(x.clone().into(), y.clone().into()));
                }
            }
        }
        found
    }
}

/// A relation of a polynomial to zero.
struct Part {
    p: Poly,
    rel: Rel,
}

/// Where a polynomial of degree one or two in a name vanishes.
fn roots(p: &Poly, name: usize) -> Vec<Expr> {
    let ratio = |num: &Poly, den: &Poly| RationalFunction::new(num, den).map(|f| f.to_expr());
    let (a, b, c) = (p.coefficient(name, 2), p.coefficient(name, 1), p.coefficient(name, 0));
    match p.degree(name) {
        1 => ratio(&c.neg(), &b).into_iter().collect(),
        2 => {
            let half = RationalFunction::new(&b.neg(), &a.scale(&2.into()));
            let shift = RationalFunction::new(&c, &a);
            let (Some(half), Some(shift)) = (half, shift) else { return Vec::new() };
            let radicand = half.clone() * &half - &shift;
            let root = root(&radicand);
            match half.is_zero() {
                true => vec![root.clone(), Expr::Neg(root.into())],
                false => {
                    let half = half.to_expr();
                    vec![plus(&half, &root), minus(&half, &root), half]
                }
            }
        }
        _ => Vec::new(),
    }
}

/// The root of a radicand, a number where it is the square of one.
fn root(radicand: &RationalFunction) -> Expr {
    let square = radicand.as_constant().filter(|q| !q.is_negative()).and_then(|q| {
        let (n, d) = (q.numer().sqrt(), q.denom().sqrt());
        (&n * &n == *q.numer() && &d * &d == *q.denom()).then(|| Expr::Num(BigRational::new(n, d)))
    });
    square.unwrap_or_else(|| Expr::Sqrt(radicand.to_expr().into()))
}

/// The expression with magnitudes by each of their signs, and minima and maxima by each of their sides.
fn readings(e: &Expr) -> Vec<Expr> {
    let mut found = vec![e.clone()];
    // one magnitude after the other, from the outside in
    loop {
        let mut next: Vec<Expr> = Vec::new();
        let mut split = false;
        for e in &found {
            match sides(e) {
                Some((choice, [a, b])) if !split && found.len() < MOST_READINGS => {
                    split = true;
                    next.extend([&a, &b].map(|side| instead(e, &choice, side)));
                }
                _ => next.push(e.clone()),
            }
        }
        found = next;
        if !split {
            return found;
        }
    }
}

/// The first magnitude, minimum or maximum, and what it may be.
fn sides(e: &Expr) -> Option<(Expr, [Expr; 2])> {
    match e {
        Expr::Abs(a) => Some((e.clone(), [(**a).clone(), Expr::Neg(a.clone())])),
        Expr::Min(a, b) | Expr::Max(a, b) => Some((e.clone(), [(**a).clone(), (**b).clone()])),
        Expr::Cases(..) => None,
        _ => e.children().into_iter().find_map(sides),
    }
}

/// The expression with another in the place of a part.
fn instead(e: &Expr, part: &Expr, other: &Expr) -> Expr {
    let mut put = |e: &Expr| Ok::<_, std::convert::Infallible>((e == part).then(|| other.clone()));
    rebuild(e, &mut put).unwrap_or_else(|never| match never {})
}

/// The expression with a value in the place of a symbol.
fn replaced(e: &Expr, symbol: usize, value: &Expr) -> Expr {
    instead(e, &Expr::Var(symbol), value)
}

/// Whether an expression has more nodes than one may have in which names are replaced.
fn is_large(e: &Expr) -> bool {
    let (mut todo, mut count) = (vec![e], 0);
    while let Some(e) = todo.pop() {
        count += 1;
        if count > MOST_NODES {
            return true;
        }
        todo.extend(e.children());
    }
    false
}

fn plus(a: &Expr, b: &Expr) -> Expr {
    Expr::Add(a.clone().into(), b.clone().into())
}

fn minus(a: &Expr, b: &Expr) -> Expr {
    Expr::Sub(a.clone().into(), b.clone().into())
}

fn times(n: i64, a: &Expr) -> Expr {
    Expr::Mul(Expr::int(n).into(), a.clone().into())
}

fn over(a: Expr, n: i64) -> Expr {
    Expr::Div(a.into(), Expr::int(n).into())
}

fn greatest(a: &Expr, b: &Expr) -> Expr {
    Expr::Max(a.clone().into(), b.clone().into())
}

fn least(a: &Expr, b: &Expr) -> Expr {
    Expr::Min(a.clone().into(), b.clone().into())
}
