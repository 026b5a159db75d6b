//! Random statements: true ones by construction, arbitrary ones, and small changes to either.

use std::rc::Rc;

use kane::kernel::{
    Bound, Conclusion, Context, Expr, Goal, Hypothesis, Link, Rel, Relation, Sentence, Var,
};

use crate::support::{Chance, num, q};

const NAMES: [&str; 3] = ["x", "y", "z"];
pub(crate) const RELS: [Rel; 6] = [Rel::Eq, Rel::Ne, Rel::Lt, Rel::Le, Rel::Gt, Rel::Ge];

pub(crate) fn add(a: Expr, b: Expr) -> Expr {
    Expr::Add(a.into(), b.into())
}

pub(crate) fn sub(a: Expr, b: Expr) -> Expr {
    Expr::Sub(a.into(), b.into())
}

pub(crate) fn mul(a: Expr, b: Expr) -> Expr {
    Expr::Mul(a.into(), b.into())
}

pub(crate) fn div(a: Expr, b: Expr) -> Expr {
    Expr::Div(a.into(), b.into())
}

pub(crate) fn pow(a: Expr, n: i32) -> Expr {
    Expr::Pow(a.into(), n)
}

pub(crate) fn rel(lhs: Expr, rel: Rel, rhs: Expr) -> Relation {
    Relation { lhs, rel, rhs }
}

fn var(name: &str, chance: &mut Chance) -> Var {
    let bound = |n, strict| Some(Bound { value: q(n, 1), strict });
    let (lower, upper) = match chance.below(6) {
        0 | 1 => (None, None),
        2 => (bound(0, true), None),
        3 => (bound(0, false), None),
        4 => (bound(0, false), bound(1, false)),
        _ => (bound(-1, chance.once_in(2)), bound(2, chance.once_in(2))),
    };
    Var { name: name.to_owned(), of: None, lower, upper }
}

pub(crate) fn context(vars: usize, chance: &mut Chance) -> Context {
    Context { vars: NAMES[..vars].iter().map(|n| var(n, chance)).collect(), ..Context::default() }
}

/// A small expression without division.
pub(crate) fn polynomial(vars: usize, depth: usize, chance: &mut Chance) -> Expr {
    if depth == 0 || chance.once_in(4) {
        return if chance.once_in(3) {
            num(&q(chance.within(-3, 3), *chance.pick(&[1, 1, 1, 2])))
        } else {
            Expr::Var(chance.below(vars))
        };
    }
    let a = polynomial(vars, depth - 1, chance);
    let b = polynomial(vars, depth - 1, chance);
    match chance.below(7) {
        0 | 1 => add(a, b),
        2 => sub(a, b),
        3 | 4 => mul(a, b),
        5 => pow(a, 2),
        _ => Expr::Neg(a.into()),
    }
}

/// A small expression with everything in it.
pub(crate) fn expression(vars: usize, depth: usize, chance: &mut Chance) -> Expr {
    if depth == 0 {
        return polynomial(vars, 1, chance);
    }
    let a = expression(vars, depth - 1, chance);
    let mut b = || expression(vars, depth - 1, chance);
    let b = b();
    match chance.below(16) {
        0..=3 => add(a, b),
        4 | 5 => sub(a, b),
        6..=8 => mul(a, b),
        9 | 10 => div(a, b),
        11 => pow(a, *chance.pick(&[2, 3, -1, 0])),
        12 => Expr::Abs(a.into()),
        13 => Expr::Min(a.into(), b.into()),
        14 => {
            let x = Expr::Var(chance.below(vars));
            let guard = rel(x, *chance.pick(&RELS), Expr::int(chance.within(-1, 1)));
            let last = (!chance.once_in(4)).then(|| Rc::new(b));
            Expr::Cases(vec![(vec![guard], a)], last)
        }
        _ => Expr::Sqrt(pow(a, 2).into()),
    }
}

fn given(r: Relation) -> Hypothesis {
    let sentence = Sentence { when: Vec::new(), links: vec![Link::Relation(r)] };
    Hypothesis { sentence, given: true }
}

fn goal(context: Context, hypotheses: Vec<Hypothesis>, when: Vec<Relation>, r: Relation) -> Goal {
    Goal {
        context,
        hypotheses,
        behind: Vec::new(),
        when,
        conclusion: Conclusion::Link(Link::Relation(r)),
    }
}

/// Some statement about one to three symbols; nothing is known of it.
pub(crate) fn any_statement(chance: &mut Chance) -> Goal {
    let n = 1 + chance.below(3);
    let context = context(n, chance);
    let mut hypotheses = Vec::new();
    if n > 1 && chance.once_in(2) {
        let body = expression(n - 1, 1, chance);
        hypotheses.push(given(rel(Expr::Var(n - 1), Rel::Eq, body)));
    }
    let mut when = Vec::new();
    for _ in 0..chance.below(3) {
        let (a, b) = (polynomial(n, 1, chance), polynomial(n, 1, chance));
        when.push(rel(a, *chance.pick(&RELS[1..]), b));
    }
    let (a, b) = (expression(n, 2, chance), expression(n, 1, chance));
    goal(context, hypotheses, when, rel(a, *chance.pick(&RELS), b))
}

/// A statement that is true by a known argument.
pub(crate) fn true_statement(chance: &mut Chance) -> Goal {
    use Rel::{Eq, Ge, Gt, Le, Lt, Ne};
    let n = 1 + chance.below(3);
    let mut context = context(n, chance);
    let some = |chance: &mut Chance| polynomial(n, 2, chance);
    let (a, b, c) = (some(chance), some(chance), some(chance));
    let zero = || Expr::int(0);
    let two = || Expr::int(2);
    let positive = |e: &Expr| rel(e.clone(), Gt, zero());
    let abs = |e: &Expr| Expr::Abs(e.clone().into());
    let (mut hypotheses, mut when) = (Vec::new(), Vec::new());
    let conclusion = match chance.below(24) {
        0 => {
            let middle = mul(mul(two(), a.clone()), b.clone());
            rel(pow(add(a.clone(), b.clone()), 2), Eq, add(add(pow(a, 2), middle), pow(b, 2)))
        }
        1 => rel(
            mul(sub(a.clone(), b.clone()), add(a.clone(), b.clone())),
            Eq,
            sub(pow(a, 2), pow(b, 2)),
        ),
        2 => rel(add(pow(a.clone(), 2), pow(b.clone(), 2)), Ge, mul(two(), mul(a, b))),
        3 => rel(add(pow(a, 2), Expr::int(1)), Gt, zero()),
        4 => {
            when.extend([positive(&a), positive(&b)]);
            rel(mul(a, b), Gt, zero())
        }
        5 => {
            when.extend([positive(&a), positive(&b)]);
            rel(add(div(a.clone(), b.clone()), div(b, a)), Ge, two())
        }
        6 => {
            hypotheses.push(given(rel(a.clone(), Eq, b.clone())));
            rel(add(pow(a, 2), c.clone()), Eq, add(pow(b, 2), c))
        }
        7 => {
            when.push(rel(b.clone(), Ne, zero()));
            rel(mul(div(a.clone(), b.clone()), b), Eq, a)
        }
        8 => {
            when.push(rel(b.clone(), Ne, zero()));
            rel(add(div(a.clone(), b.clone()), div(c.clone(), b.clone())), Eq, div(add(a, c), b))
        }
        9 => rel(abs(&mul(a.clone(), b.clone())), Eq, mul(abs(&a), abs(&b))),
        10 => rel(abs(&add(a.clone(), b.clone())), Le, add(abs(&a), abs(&b))),
        11 => rel(Expr::Max(a.clone().into(), b.into()), Ge, a),
        12 => {
            let both = (Rc::new(a.clone()), Rc::new(b.clone()));
            let (min, max) = (Expr::Min(both.0.clone(), both.1.clone()), Expr::Max(both.0, both.1));
            rel(add(min, max), Eq, add(a, b))
        }
        13 => rel(Expr::Sqrt(pow(a.clone(), 2).into()), Eq, abs(&a)),
        14 => {
            when.push(rel(a.clone(), Ge, zero()));
            rel(pow(Expr::Sqrt(a.clone().into()), 2), Eq, a)
        }
        15 => {
            let guard = rel(a.clone(), Lt, zero());
            let cases =
                Expr::Cases(vec![(vec![guard], Expr::Neg(a.clone().into()))], Some(Rc::new(a)));
            rel(cases, Ge, zero())
        }
        16 => {
            hypotheses.push(given(rel(a.clone(), Lt, b.clone())));
            hypotheses.push(given(rel(b, Lt, c.clone())));
            rel(a, Lt, c)
        }
        17 => {
            hypotheses.push(given(rel(a.clone(), Le, b.clone())));
            hypotheses.push(given(rel(c.clone(), Ge, zero())));
            rel(mul(a, c.clone()), Le, mul(b, c))
        }
        18 => {
            hypotheses.push(given(rel(mul(a.clone(), b.clone()), Eq, c.clone())));
            when.push(rel(a.clone(), Ne, zero()));
            rel(b, Eq, div(c, a))
        }
        19 => {
            hypotheses.push(given(rel(mul(a.clone(), b.clone()), Eq, Expr::int(1))));
            rel(add(pow(a, 2), pow(b, 2)), Ge, two())
        }
        20 => {
            let square = pow(a, 2);
            rel(div(Expr::int(1), add(Expr::int(1), square)), Le, Expr::int(1))
        }
        21 => {
            context.vars[0].lower = Some(Bound { value: q(0, 1), strict: false });
            context.vars[0].upper = Some(Bound { value: q(1, 1), strict: false });
            let x = Expr::Var(0);
            rel(mul(pow(x.clone(), 2), pow(a.clone(), 2)), Le, mul(x, pow(a, 2)))
        }
        22 => {
            hypotheses.push(given(rel(mul(a.clone(), b.clone()), Gt, zero())));
            rel(a, Ne, zero())
        }
        _ => {
            // a step: what is true now stays true, in closed form
            hypotheses.push(given(rel(c.clone(), Eq, mul(a.clone(), b.clone()))));
            rel(mul(c, b.clone()), Eq, mul(a, pow(b, 2)))
        }
    };
    goal(context, hypotheses, when, conclusion)
}

/// Changes one node of an expression: sign, coefficient, operation, exponent or symbol.
fn change(e: &mut Expr, site: &mut usize, vars: usize, chance: &mut Chance) -> bool {
    if *site == 0 {
        let old = e.clone();
        *e = match old {
            Expr::Num(value) => Expr::Num(value + q(chance.within(1, 3), 1)),
            Expr::Var(_) if chance.once_in(2) => Expr::Var(chance.below(vars)),
            Expr::Add(a, b) => Expr::Sub(a, b),
            Expr::Sub(a, b) => Expr::Add(a, b),
            Expr::Mul(a, b) if chance.once_in(2) => Expr::Add(a, b),
            Expr::Div(a, b) if chance.once_in(2) => Expr::Mul(a, b),
            Expr::Pow(a, n) => Expr::Pow(a, n + if chance.once_in(2) { 1 } else { -1 }),
            Expr::Min(a, b) => Expr::Max(a, b),
            Expr::Max(a, b) => Expr::Min(a, b),
            Expr::Abs(a) => Rc::unwrap_or_clone(a),
            other if chance.once_in(2) => mul(Expr::int(2), other),
            other => Expr::Neg(other.into()),
        };
        return true;
    }
    *site -= 1;
    let mut go = |a: &mut Expr| change(a, site, vars, chance);
    match e {
        Expr::Num(_) | Expr::Var(_) | Expr::Let(_) => false,
        Expr::Neg(a) | Expr::Pow(a, _) | Expr::Abs(a) | Expr::Sqrt(a) | Expr::Deriv(a, _) => {
            go(Rc::make_mut(a))
        }
        Expr::Add(a, b)
        | Expr::Sub(a, b)
        | Expr::Mul(a, b)
        | Expr::Div(a, b)
        | Expr::Min(a, b)
        | Expr::Max(a, b) => go(Rc::make_mut(a)) || go(Rc::make_mut(b)),
        Expr::Cases(branches, otherwise) => {
            for (guards, body) in branches {
                for g in guards {
                    if go(&mut g.lhs) || go(&mut g.rhs) {
                        return true;
                    }
                }
                if go(body) {
                    return true;
                }
            }
            otherwise.as_mut().map(Rc::make_mut).is_some_and(go)
        }
    }
}

fn nodes(e: &Expr) -> usize {
    1 + e.children().into_iter().map(nodes).sum::<usize>()
}

/// A goal changed in one place; often false where the old one was true.
pub(crate) fn changed(old: &Goal, chance: &mut Chance) -> Goal {
    let mut new = old.clone();
    let vars = new.context.vars.len();
    let what = chance.below(9);
    if what == 0 && !new.hypotheses.is_empty() {
        new.hypotheses.remove(chance.below(old.hypotheses.len()));
        return new;
    }
    if what == 1 && !new.when.is_empty() {
        new.when.remove(chance.below(old.when.len()));
        return new;
    }
    let Conclusion::Link(Link::Relation(r)) = &mut new.conclusion else {
        return new;
    };
    match what {
        2 => r.rel = *chance.pick(&RELS),
        3 => {
            r.rel = match r.rel {
                Rel::Ge => Rel::Gt,
                Rel::Le => Rel::Lt,
                Rel::Gt => Rel::Le,
                Rel::Lt => Rel::Ge,
                Rel::Eq => Rel::Ne,
                Rel::Ne => Rel::Eq,
            }
        }
        4 => std::mem::swap(&mut r.lhs, &mut r.rhs),
        _ => {
            let side = if chance.once_in(2) { &mut r.lhs } else { &mut r.rhs };
            let mut site = chance.below(nodes(side));
            change(side, &mut site, vars, chance);
        }
    }
    new
}
