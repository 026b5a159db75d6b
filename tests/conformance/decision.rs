//! An independent decision of statements in one variable: all sign cells, one sample each.
//!
//! Every polynomial whose sign may matter is collected; between and at its roots, which Sturm's
//! theorem isolates, the statement is evaluated as it is written, in Q(x) localised at the sample.

use kane::kernel::{Conclusion, Expr, Goal, Link, Rel, Relation};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::support::{Q, q};

/// Coefficients from x⁰ up, without trailing zeros.
type Poly = Vec<BigInt>;

fn trimmed(mut p: Poly) -> Poly {
    while p.last().is_some_and(Zero::is_zero) {
        p.pop();
    }
    p
}

fn add(a: &Poly, b: &Poly) -> Poly {
    let n = a.len().max(b.len());
    let at = |p: &Poly, i: usize| p.get(i).cloned().unwrap_or_default();
    trimmed((0..n).map(|i| at(a, i) + at(b, i)).collect())
}

fn neg(a: &Poly) -> Poly {
    a.iter().map(|c| -c).collect()
}

fn mul(a: &Poly, b: &Poly) -> Poly {
    if a.is_empty() || b.is_empty() {
        return Poly::new();
    }
    let mut out = vec![BigInt::zero(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            out[i + j] += x * y;
        }
    }
    trimmed(out)
}

/// Divided by the content, the sign kept.
fn primitive(p: &Poly) -> Poly {
    let content = p.iter().fold(BigInt::zero(), |g, c| g.gcd(c));
    if content.is_zero() { Poly::new() } else { p.iter().map(|c| c / &content).collect() }
}

/// A positive multiple of the remainder of a by b.
fn remainder(a: &Poly, b: &Poly) -> Poly {
    let mut r = a.clone();
    let lead = b.last().expect("a divisor is not zero");
    while r.len() >= b.len() {
        let top = r.last().expect("longer than the divisor").clone();
        let shift = r.len() - b.len();
        // r := |lead|·r − sign(lead)·top·x^shift·b
        let scale = lead.abs();
        let factor = if lead.is_negative() { -top } else { top };
        for c in &mut r {
            *c *= &scale;
        }
        for (i, c) in b.iter().enumerate() {
            r[i + shift] -= &factor * c;
        }
        r = trimmed(r);
    }
    primitive(&r)
}

fn gcd(a: &Poly, b: &Poly) -> Poly {
    let (mut a, mut b) = (primitive(a), primitive(b));
    while !b.is_empty() {
        let r = remainder(&a, &b);
        a = std::mem::replace(&mut b, r);
    }
    a
}

fn derivative(p: &Poly) -> Poly {
    p.iter().enumerate().skip(1).map(|(i, c)| c * BigInt::from(i)).collect()
}

/// a/b up to a constant factor, for b that divides a over Q.
fn quotient(a: &Poly, b: &Poly) -> Poly {
    let mut r = a.clone();
    let lead = b.last().expect("a divisor is not zero");
    let mut out = vec![BigInt::zero(); (a.len() + 1).saturating_sub(b.len())];
    while r.len() >= b.len() {
        let top = r.last().expect("longer than the divisor").clone();
        let shift = r.len() - b.len();
        for c in r.iter_mut().chain(&mut out) {
            *c *= lead;
        }
        out[shift] += &top;
        for (i, c) in b.iter().enumerate() {
            r[i + shift] -= &top * c;
        }
        r = trimmed(r);
    }
    primitive(&trimmed(out))
}

fn square_free(p: &Poly) -> Poly {
    quotient(p, &gcd(p, &derivative(p)))
}

fn sign(x: &BigInt) -> i8 {
    i8::from(x.is_positive()) - i8::from(x.is_negative())
}

fn sign_at(p: &Poly, x: &Q) -> i8 {
    let (mut sum, mut power) = (BigInt::zero(), BigInt::one());
    for c in p.iter().rev() {
        sum = sum * x.numer() + c * &power;
        power *= x.denom();
    }
    sign(&sum)
}

/// A Sturm sequence.
struct Sturm(Vec<Poly>);

impl Sturm {
    fn new(p: &Poly) -> Self {
        let mut chain = vec![p.clone(), derivative(p)];
        while let [.., a, b] = &chain[..] {
            if b.is_empty() {
                chain.pop();
                break;
            }
            let next = neg(&remainder(a, b));
            chain.push(next);
        }
        Self(chain)
    }

    fn changes(&self, x: &Q) -> usize {
        let signs: Vec<i8> = self.0.iter().map(|p| sign_at(p, x)).filter(|s| *s != 0).collect();
        signs.windows(2).filter(|w| w[0] != w[1]).count()
    }

    /// Roots in (a, b].
    fn count(&self, a: &Q, b: &Q) -> usize {
        self.changes(a) - self.changes(b)
    }
}

/// Where a statement is evaluated.
enum Sample {
    Rational(Q),
    /// the only root of a square-free polynomial in (lo, hi]
    Root(Poly, Q, Q),
}

impl Sample {
    fn sign(&self, p: &Poly) -> i8 {
        match self {
            Self::Rational(x) => sign_at(p, x),
            _ if p.is_empty() => 0,
            Self::Root(own, lo, hi) => {
                // a positive multiple of what p is modulo own has the sign of p at its root
                let p = remainder(p, own);
                if p.is_empty() {
                    return 0;
                }
                let common = gcd(own, &p);
                if common.len() > 1 && Sturm::new(&common).count(lo, hi) > 0 {
                    return 0;
                }
                let (own, other) = (Sturm::new(own), Sturm::new(&square_free(&p)));
                let (mut lo, mut hi) = (lo.clone(), hi.clone());
                while other.count(&lo, &hi) > 0 {
                    let middle = (&lo + &hi) / q(2, 1);
                    if own.count(&lo, &middle) > 0 {
                        hi = middle;
                    } else {
                        lo = middle;
                    }
                }
                sign_at(&p, &hi)
            }
        }
    }
}

/// num/den, den not zero at the sample.
type Value = Option<(Poly, Poly)>;

fn constant(x: &Q) -> (Poly, Poly) {
    (trimmed(vec![x.numer().clone()]), vec![x.denom().clone()])
}

fn value(e: &Expr, at: &Sample) -> Value {
    let both = |a: &Expr, b: &Expr| Some((value(a, at)?, value(b, at)?));
    let sum =
        |(a, b): (Poly, Poly), (c, d): (Poly, Poly)| (add(&mul(&a, &d), &mul(&c, &b)), mul(&b, &d));
    let minus = |(a, b): (Poly, Poly)| (neg(&a), b);
    let positive = |(a, b): &(Poly, Poly)| at.sign(a) * at.sign(b);
    Some(match e {
        Expr::Num(x) => constant(x),
        Expr::Var(_) => (vec![BigInt::zero(), BigInt::one()], vec![BigInt::one()]),
        Expr::Neg(a) => minus(value(a, at)?),
        Expr::Add(a, b) => both(a, b).map(|(a, b)| sum(a, b))?,
        Expr::Sub(a, b) => both(a, b).map(|(a, b)| sum(a, minus(b)))?,
        Expr::Mul(a, b) => both(a, b).map(|(a, b)| (mul(&a.0, &b.0), mul(&a.1, &b.1)))?,
        Expr::Div(a, b) => {
            let (a, b) = both(a, b)?;
            if at.sign(&b.0) == 0 {
                return None;
            }
            (mul(&a.0, &b.1), mul(&a.1, &b.0))
        }
        Expr::Pow(a, n) => {
            let a = value(a, at)?;
            let mut out = (vec![BigInt::one()], vec![BigInt::one()]);
            for _ in 0..n.unsigned_abs() {
                out = (mul(&out.0, &a.0), mul(&out.1, &a.1));
            }
            if *n < 0 {
                if at.sign(&out.0) == 0 {
                    return None;
                }
                out = (out.1, out.0);
            }
            out
        }
        Expr::Abs(a) => {
            let a = value(a, at)?;
            if positive(&a) < 0 { minus(a) } else { a }
        }
        Expr::Min(a, b) | Expr::Max(a, b) => {
            let (a, b) = both(a, b)?;
            let order = positive(&sum(a.clone(), minus(b.clone())));
            if (order <= 0) == matches!(e, Expr::Min(..)) { a } else { b }
        }
        Expr::Cases(branches, otherwise) => {
            for (guards, body) in branches {
                let mut all = true;
                for g in guards {
                    all = all && holds(g, at)?;
                }
                if all {
                    return value(body, at);
                }
            }
            return value(otherwise.as_deref()?, at);
        }
        Expr::Let(_) | Expr::Sqrt(_) | Expr::Deriv(..) => unreachable!("not generated"),
    })
}

/// `None` where a side is undefined.
fn holds(r: &Relation, at: &Sample) -> Option<bool> {
    let ((a, b), (c, d)) = (value(&r.lhs, at)?, value(&r.rhs, at)?);
    let gap = add(&mul(&a, &d), &neg(&mul(&c, &b)));
    let order = at.sign(&gap) * at.sign(&b) * at.sign(&d);
    Some(match r.rel {
        Rel::Eq => order == 0,
        Rel::Ne => order != 0,
        Rel::Lt => order < 0,
        Rel::Le => order <= 0,
        Rel::Gt => order > 0,
        Rel::Ge => order >= 0,
    })
}

/// All values that an expression may take, with what decides among them put into `critical`.
fn values(e: &Expr, critical: &mut Vec<Poly>) -> Vec<(Poly, Poly)> {
    let one = || vec![BigInt::one()];
    let pairs = |a: &Expr, b: &Expr, critical: &mut Vec<Poly>| {
        let (a, b) = (values(a, critical), values(b, critical));
        let each = |x: &(Poly, Poly)| b.iter().map(|y| (x.clone(), y.clone())).collect::<Vec<_>>();
        a.iter().flat_map(each).collect::<Vec<_>>()
    };
    let cross = |a: &(Poly, Poly), c: &(Poly, Poly), minus: bool| {
        let right = mul(&c.0, &a.1);
        let right = if minus { neg(&right) } else { right };
        (add(&mul(&a.0, &c.1), &right), mul(&a.1, &c.1))
    };
    match e {
        Expr::Num(x) => vec![constant(x)],
        Expr::Var(_) => vec![(vec![BigInt::zero(), BigInt::one()], one())],
        Expr::Neg(a) => values(a, critical).into_iter().map(|(a, b)| (neg(&a), b)).collect(),
        Expr::Add(a, b) => pairs(a, b, critical).iter().map(|(a, b)| cross(a, b, false)).collect(),
        Expr::Sub(a, b) => pairs(a, b, critical).iter().map(|(a, b)| cross(a, b, true)).collect(),
        Expr::Mul(a, b) => {
            pairs(a, b, critical).iter().map(|(a, b)| (mul(&a.0, &b.0), mul(&a.1, &b.1))).collect()
        }
        Expr::Div(a, b) => {
            let all = pairs(a, b, critical);
            critical.extend(all.iter().map(|(_, b)| b.0.clone()));
            all.iter().map(|(a, b)| (mul(&a.0, &b.1), mul(&a.1, &b.0))).collect()
        }
        Expr::Pow(a, n) => {
            let all = values(a, critical);
            if *n < 0 {
                critical.extend(all.iter().map(|a| a.0.clone()));
            }
            let power = |p: &Poly| (0..n.unsigned_abs()).fold(one(), |out, _| mul(&out, p));
            let all = all.iter().map(|(a, b)| (power(a), power(b)));
            if *n < 0 { all.map(|(a, b)| (b, a)).collect() } else { all.collect() }
        }
        Expr::Abs(a) => {
            let all = values(a, critical);
            critical.extend(all.iter().map(|a| a.0.clone()));
            let other: Vec<_> = all.iter().map(|(a, b)| (neg(a), b.clone())).collect();
            [all, other].concat()
        }
        Expr::Min(a, b) | Expr::Max(a, b) => {
            let all = pairs(a, b, critical);
            critical.extend(all.iter().map(|(a, b)| cross(a, b, true).0));
            all.into_iter().flat_map(|(a, b)| [a, b]).collect()
        }
        Expr::Cases(branches, otherwise) => {
            let mut out = Vec::new();
            for (guards, body) in branches {
                guards.iter().for_each(|g| compared(g, critical));
                out.extend(values(body, critical));
            }
            out.extend(otherwise.iter().flat_map(|e| values(e, critical)));
            out
        }
        Expr::Let(_) | Expr::Sqrt(_) | Expr::Deriv(..) => unreachable!("not generated"),
    }
}

fn compared(r: &Relation, critical: &mut Vec<Poly>) {
    let (a, b) = (values(&r.lhs, critical), values(&r.rhs, critical));
    for a in &a {
        for b in &b {
            critical.push(add(&mul(&a.0, &b.1), &neg(&mul(&b.0, &a.1))));
        }
    }
}

/// Square-free polynomials without common roots.
struct Parts(Vec<(Poly, Sturm)>);

impl Parts {
    fn count(&self, a: &Q, b: &Q) -> usize {
        self.0.iter().map(|(_, sturm)| sturm.count(a, b)).sum()
    }

    fn vanish(&self, x: &Q) -> bool {
        self.0.iter().any(|(p, _)| sign_at(p, x) == 0)
    }
}

/// One sample of every cell of the line.
fn samples(critical: &[Poly]) -> Vec<Sample> {
    let mut sorted: Vec<&Poly> = critical.iter().filter(|p| p.len() > 1).collect();
    sorted.sort_by_key(|p| p.len());
    sorted.dedup();
    let mut parts: Vec<Poly> = Vec::new();
    for p in sorted {
        // what is new in each polynomial
        let mut p = square_free(p);
        for known in &parts {
            p = quotient(&p, &gcd(&p, known));
        }
        if p.len() > 1 {
            parts.push(p);
        }
    }
    if parts.is_empty() {
        return vec![Sample::Rational(q(0, 1))];
    }
    let bound = |p: &Poly| {
        let lead = p.last().expect("not constant").abs();
        Q::new(p.iter().map(Signed::abs).max().expect("not constant"), lead) + q(2, 1)
    };
    let bound = parts.iter().map(bound).max().expect("not empty");
    let sturm = Parts(parts.into_iter().map(|p| (p.clone(), Sturm::new(&p))).collect());
    let (mut roots, mut todo) = (Vec::new(), vec![(-&bound, bound.clone())]);
    while let Some((lo, hi)) = todo.pop() {
        match sturm.count(&lo, &hi) {
            0 => {}
            // the ends of the intervals must lie in open cells
            1 if sturm.vanish(&hi) => roots.push((hi.clone(), hi)),
            1 => roots.push((lo, hi)),
            _ => {
                let middle = (&lo + &hi) / q(2, 1);
                todo.push((middle.clone(), hi));
                todo.push((lo, middle));
            }
        }
    }
    roots.sort();
    let mut out = Vec::new();
    for (i, (lo, hi)) in roots.iter().enumerate() {
        // left of the root: refine until there is room
        let (mut lo, hi) = (lo.clone(), hi.clone());
        let before = if i == 0 { -&bound - q(1, 1) } else { roots[i - 1].1.clone() };
        if lo == hi {
            // an exact root: the cell before it reaches up to it
            let mut gap = (&hi - &before) / q(2, 1);
            while sturm.count(&(&hi - &gap), &hi) > 1 || sturm.vanish(&(&hi - &gap)) {
                gap /= q(2, 1);
            }
            out.push(Sample::Rational(&hi - gap));
            out.push(Sample::Rational(hi));
            continue;
        }
        let mut top = hi;
        let mut exact = None;
        // lo may be the root before
        while exact.is_none() && sturm.vanish(&lo) {
            let middle = (&lo + &top) / q(2, 1);
            if sturm.count(&lo, &middle) == 0 {
                lo = middle;
            } else if sturm.vanish(&middle) {
                exact = Some(middle);
            } else {
                top = middle;
            }
        }
        if let Some(root) = exact {
            out.push(Sample::Rational((lo + &root) / q(2, 1)));
            out.push(Sample::Rational(root));
            continue;
        }
        out.push(Sample::Rational(lo.clone()));
        let own = sturm.0.iter().find(|(_, sturm)| sturm.count(&lo, &top) > 0);
        out.push(Sample::Root(own.expect("it has a root").0.clone(), lo, top));
    }
    out.push(Sample::Rational(bound + q(1, 1)));
    out
}

/// What a statement in one variable is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Truth {
    Vacuous,
    Undefined,
    False,
    True,
}

/// Decides a statement without hypotheses about the symbol 0.
pub(crate) fn decide(goal: &Goal) -> Truth {
    let Conclusion::Link(Link::Relation(claim)) = &goal.conclusion else {
        unreachable!("relations only")
    };
    let x = || Expr::Var(0);
    let bounds = |b: &Option<kane::kernel::Bound>, strict, weak| {
        b.as_ref().map(|b| Relation {
            lhs: x(),
            rel: if b.strict { strict } else { weak },
            rhs: Expr::Num(b.value.clone()),
        })
    };
    let var = &goal.context.vars[0];
    let domain: Vec<Relation> = bounds(&var.lower, Rel::Gt, Rel::Ge)
        .into_iter()
        .chain(bounds(&var.upper, Rel::Lt, Rel::Le))
        .collect();
    let conditions: Vec<&Relation> = domain.iter().chain(&goal.when).collect();
    let mut critical = Vec::new();
    conditions.iter().for_each(|r| compared(r, &mut critical));
    compared(claim, &mut critical);
    let mut truth = Truth::Vacuous;
    let mut worst = Truth::True;
    for at in samples(&critical) {
        if conditions.iter().all(|r| holds(r, &at) == Some(true)) {
            truth = Truth::True;
            worst = worst.min(match holds(claim, &at) {
                None => Truth::Undefined,
                Some(false) => Truth::False,
                Some(true) => Truth::True,
            });
        }
    }
    truth.min(worst)
}
