//! Random statements with every kind of node in them, over names of every kind.

use std::rc::Rc;

use kane::algebra::syntax::{Scope, parse_expr};
use kane::kernel::{Approach, Expr, Limit, Link, Rel, Relation, Sentence, Target, Var};

use crate::support::{Chance, num, q};

const RELS: [Rel; 6] = [Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge];

/// Plain symbols: as declared, and as a person would write them in LaTeX.
pub(super) const PLAIN: [(&str, &str); 14] = [
    ("x", "x"),
    ("y", "y"),
    ("mu", r"\mu"),
    ("alpha", r"\alpha"),
    ("v_x0'", "v_{x0}'"),
    ("Delta", r"\Delta"),
    ("E", "E"),
    ("DeltaE", r"\Delta E"),
    ("dE_n", "dE_n"),
    ("slip", r"\mathrm{slip}"),
    ("kW", "k_W"),
    ("w''", "w''"),
    ("mu_0", r"\mu_0"),
    ("i_alpha", r"i_{\alpha}"),
];
/// A function of alpha, and two definitions.
pub(super) const FUNCTION: (&str, &str) = ("k", "k");
pub(super) const DEFINED: [(&str, &str, &str); 2] =
    [("f", "f", "x^2 + 1"), ("q_1", "q_1", "y - 2")];

/// The symbols by which a limit or a derivative may be taken: x and alpha.
const MOVING: [usize; 2] = [0, 3];

/// The declarations that make up [`scope`], as lines of a document.
pub(super) fn declarations() -> String {
    let names: Vec<&str> = PLAIN.iter().map(|(name, _)| *name).collect();
    let mut text = format!("var {}\nvar {}(alpha)\n", names.join(", "), FUNCTION.0);
    for (name, _, body) in DEFINED {
        text.push_str(&format!("let {name} := {body}\n"));
    }
    text
}

pub(super) fn scope() -> Scope {
    let mut scope = Scope::default();
    let mut declare = |name: &str, of| {
        let var = Var { name: name.to_owned(), of, lower: None, upper: None };
        scope.declare(var).expect("the names are free and look different")
    };
    for (name, _) in PLAIN {
        declare(name, None);
    }
    declare(FUNCTION.0, Some(3));
    for (name, _, body) in DEFINED {
        let body = parse_expr(body, &scope).expect("well-formed");
        scope.define(name, body).expect("the name is free");
    }
    scope
}

/// What the expressions are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Wanted {
    /// derivatives, too
    pub(super) slopes: bool,
    /// definitions and functions, too
    pub(super) names: bool,
    /// numbers that the parser never makes: negative ones, and those without a finite decimal
    pub(super) numbers: bool,
}

pub(super) const ALL: Wanted = Wanted { slopes: true, names: true, numbers: false };

pub(super) fn expression(depth: usize, wanted: Wanted, chance: &mut Chance) -> Expr {
    grown(depth, wanted, None, chance)
}

/// `fixed` is a symbol of which no function may occur, nor itself if it is a limit's variable.
fn grown(depth: usize, wanted: Wanted, fixed: Option<usize>, chance: &mut Chance) -> Expr {
    if depth == 0 || chance.once_in(6) {
        return leaf(wanted, fixed, chance);
    }
    let part = |chance: &mut Chance| Rc::new(grown(depth - 1, wanted, fixed, chance));
    match chance.below(17) {
        0 | 1 => Expr::Add(part(chance), part(chance)),
        2 | 3 => Expr::Sub(part(chance), part(chance)),
        4..=6 => Expr::Mul(part(chance), part(chance)),
        7 | 8 => Expr::Div(part(chance), part(chance)),
        9 | 10 => Expr::Neg(part(chance)),
        11 => Expr::Pow(part(chance), i32::try_from(chance.within(-4, 4)).expect("small")),
        12 => Expr::Abs(part(chance)),
        13 if chance.once_in(2) => Expr::Min(part(chance), part(chance)),
        13 => Expr::Max(part(chance), part(chance)),
        14 => Expr::Sqrt(part(chance)),
        15 if wanted.slopes => {
            let x = *chance.pick(&MOVING);
            // no function of x may stand in it, and alpha has one
            Expr::Deriv(grown(depth - 1, wanted, fixed.or(Some(x)), chance).into(), x)
        }
        _ => {
            let branches = (0..chance.below(2) + 1).map(|_| {
                let guards =
                    (0..chance.below(2) + 1).map(|_| relation(depth - 1, wanted, fixed, chance));
                (guards.collect(), Rc::unwrap_or_clone(part(chance)))
            });
            let branches: Vec<_> = branches.collect();
            Expr::Cases(branches, (!chance.once_in(3)).then(|| part(chance)))
        }
    }
}

fn leaf(wanted: Wanted, fixed: Option<usize>, chance: &mut Chance) -> Expr {
    if wanted.numbers && chance.once_in(6) {
        return num(&q(*chance.pick(&[-1, -2, -7, 1, 5]), *chance.pick(&[1, 2, 3, 5, 7])));
    }
    match chance.below(6) {
        0 => num(&q(chance.within(1, 30), 1)),
        1 => num(&q(chance.within(1, 99), *chance.pick(&[2, 5, 10, 100]))),
        2 if wanted.names && chance.once_in(2) => Expr::Let(chance.below(DEFINED.len())),
        3 if wanted.names && fixed.is_none() => Expr::Var(PLAIN.len()),
        _ => Expr::Var(chance.below(PLAIN.len())),
    }
}

fn relation(depth: usize, wanted: Wanted, fixed: Option<usize>, chance: &mut Chance) -> Relation {
    let lhs = grown(depth, wanted, fixed, chance);
    let rel = *chance.pick(&RELS);
    let zero = chance.once_in(5);
    let rhs = if zero { Expr::int(0) } else { grown(depth, wanted, fixed, chance) };
    Relation { lhs, rel, rhs }
}

/// Relations, some of which share a side and so make a chain.
pub(super) fn relations(depth: usize, wanted: Wanted, chance: &mut Chance) -> Vec<Relation> {
    let mut all: Vec<Relation> = Vec::new();
    for _ in 0..=chance.below(3) {
        let mut next = relation(depth, wanted, None, chance);
        if let (Some(last), true) = (all.last(), chance.once_in(2)) {
            next.lhs = last.rhs.clone();
        }
        all.push(next);
    }
    all
}

fn free_of_x(depth: usize, wanted: Wanted, chance: &mut Chance) -> Expr {
    let scope = scope();
    loop {
        let e = grown(depth, wanted, Some(0), chance);
        if !scope.varies_with(&e, 0) {
            return e;
        }
    }
}

/// A relation or a limit, with or without conditions.
pub(super) fn sentence(depth: usize, wanted: Wanted, chance: &mut Chance) -> Sentence {
    if !chance.once_in(4) {
        let links = relations(depth, wanted, chance).into_iter().map(Link::Relation).collect();
        let when = if chance.once_in(2) { relations(1, wanted, chance) } else { Vec::new() };
        return Sentence { when, links };
    }
    let at = q(chance.within(-5, 5), *chance.pick(&[1, 2, 3, 4]));
    let at = match chance.below(5) {
        0 => Approach::To(at),
        1 => Approach::Above(at),
        2 => Approach::Below(at),
        3 => Approach::PlusInf,
        _ => Approach::MinusInf,
    };
    let to = match chance.below(4) {
        0 => Target::PlusInf,
        1 => Target::MinusInf,
        _ => Target::Finite(free_of_x(depth, wanted, chance)),
    };
    let expr = expression(depth, wanted, chance);
    let links = vec![Link::Limit(Limit { expr, to, var: 0, at })];
    Sentence { when: Vec::new(), links }
}

/// The same with numbers as people write them: a sign, and a quotient where there is no decimal.
pub(super) fn spelled(e: &Expr) -> Expr {
    let go = |e: &Expr| Rc::new(spelled(e));
    let all = |rs: &[Relation]| rs.iter().map(spelled_relation).collect::<Vec<_>>();
    match e {
        Expr::Num(value) => {
            let (n, d) = (value.numer(), value.denom());
            let size = n.magnitude().clone().into();
            let mut rest = d.clone();
            for prime in [2, 5] {
                while (&rest % prime) == 0.into() {
                    rest /= prime;
                }
            }
            let positive = if rest == 1.into() {
                Expr::Num(num_rational::BigRational::new(size, d.clone()))
            } else {
                Expr::Div(Expr::Num(size.into()).into(), Expr::Num(d.clone().into()).into())
            };
            if *n < 0.into() { Expr::Neg(positive.into()) } else { positive }
        }
        Expr::Var(_) | Expr::Let(_) => e.clone(),
        Expr::Neg(a) => Expr::Neg(go(a)),
        Expr::Add(a, b) => Expr::Add(go(a), go(b)),
        Expr::Sub(a, b) => Expr::Sub(go(a), go(b)),
        Expr::Mul(a, b) => Expr::Mul(go(a), go(b)),
        Expr::Div(a, b) => Expr::Div(go(a), go(b)),
        Expr::Pow(a, n) => Expr::Pow(go(a), *n),
        Expr::Abs(a) => Expr::Abs(go(a)),
        Expr::Min(a, b) => Expr::Min(go(a), go(b)),
        Expr::Max(a, b) => Expr::Max(go(a), go(b)),
        Expr::Sqrt(a) => Expr::Sqrt(go(a)),
        Expr::Deriv(a, x) => Expr::Deriv(go(a), *x),
        Expr::Cases(branches, last) => Expr::Cases(
            branches.iter().map(|(guards, body)| (all(guards), spelled(body))).collect(),
            last.as_deref().map(go),
        ),
    }
}

pub(super) fn spelled_relation(r: &Relation) -> Relation {
    Relation { lhs: spelled(&r.lhs), rel: r.rel, rhs: spelled(&r.rhs) }
}

pub(super) fn spelled_sentence(s: &Sentence) -> Sentence {
    let link = |link: &Link| match link {
        Link::Relation(r) => Link::Relation(spelled_relation(r)),
        Link::Limit(l) => Link::Limit(Limit {
            expr: spelled(&l.expr),
            to: match &l.to {
                Target::Finite(value) => Target::Finite(spelled(value)),
                other => other.clone(),
            },
            ..l.clone()
        }),
    };
    Sentence {
        when: s.when.iter().map(spelled_relation).collect(),
        links: s.links.iter().map(link).collect(),
    }
}
