//! Certificates changed in one place: a walk over all fields of a certificate, and small changes.

use std::cmp::Ordering;
use std::rc::Rc;

use kane::kernel::{
    Atom, Certificate, Evidence, Expr, Failure, Finding, Germ, Model, Point, Poly, Proof, Root,
    Side, SideProof, Sign, Target,
};
use num_bigint::BigInt;
use num_traits::{One, Zero};

use crate::support::{Chance, Q, q};

/// A list of which elements can be dropped, doubled and exchanged.
pub(crate) trait List {
    fn len(&self) -> usize;
    fn drop_at(&mut self, i: usize);
    fn double_at(&mut self, i: usize);
    fn exchange(&mut self, i: usize, j: usize);
}

impl<T: Clone> List for Vec<T> {
    fn len(&self) -> usize {
        Vec::len(self)
    }

    fn drop_at(&mut self, i: usize) {
        self.remove(i);
    }

    fn double_at(&mut self, i: usize) {
        let twin = self[i].clone();
        self.insert(i, twin);
    }

    fn exchange(&mut self, i: usize, j: usize) {
        self.swap(i, j);
    }
}

/// A field of a certificate, to be changed in place.
pub(crate) enum Field<'a> {
    Digest(&'a mut u128),
    Finding(&'a mut Finding),
    Evidence(&'a mut Evidence),
    Proof(&'a mut Proof),
    Index(&'a mut usize),
    Power(&'a mut u32),
    Poly(&'a mut Poly),
    Int(&'a mut BigInt),
    Ratio(&'a mut Q),
    MaybeRatio(&'a mut Option<Q>),
    Flag(&'a mut bool),
    Sign(&'a mut Sign),
    Sense(&'a mut Ordering),
    Root(&'a mut Option<Root>),
    Expr(&'a mut Expr),
    Target(&'a mut Target),
    Failure(&'a mut Failure),
    List(&'a mut dyn List),
}

type See<'s> = &'s mut dyn FnMut(&'static str, Field<'_>);

/// Shows every field of a certificate, in a fixed order, with the name of its kind.
pub(crate) fn walk(c: &mut Certificate, see: See<'_>) {
    see("Certificate.goal", Field::Digest(&mut c.goal));
    see("Certificate.finding", Field::Finding(&mut c.finding));
    see("Certificate.evidence", Field::Evidence(&mut c.evidence));
    evidence(&mut c.evidence, see);
}

fn evidence(e: &mut Evidence, see: See<'_>) {
    match e {
        Evidence::Contradiction(p) => proof("Evidence::Contradiction", p, see),
        Evidence::Limit(sides) => {
            see("Evidence::Limit", Field::List(sides));
            sides.iter_mut().for_each(|s| side_proof(s, see));
        }
        Evidence::Split { poly, cases } => {
            see("Evidence::Split.poly", Field::Poly(poly));
            see("Evidence::Split.cases", Field::List(cases));
            for c in cases {
                see("Evidence::Split.opposite", Field::Flag(&mut c.opposite));
                see("Evidence::Split.sign", Field::Sign(&mut c.sign));
                see("Evidence::Split.then", Field::Evidence(&mut c.then));
                evidence(&mut c.then, see);
            }
        }
        Evidence::Model(Model::Point(p)) => point(p, see),
        Evidence::Model(Model::Functions(f)) => {
            see("Functions.var", Field::Index(&mut f.var));
            see("Functions.values", Field::List(&mut f.values));
            for (v, e) in &mut f.values {
                see("Functions.values.0", Field::Index(v));
                see("Functions.values.1", Field::Expr(e));
            }
            see("Functions.ranges", Field::List(&mut f.ranges));
            f.ranges.iter_mut().for_each(|p| proof("Functions.ranges[]", p, see));
            see("Functions.premises", Field::List(&mut f.premises));
            for (p, limits) in &mut f.premises {
                proof("Functions.premises.0", p, see);
                see("Functions.premises.1", Field::List(limits));
                for limit in limits {
                    see("Functions.premises.1[]", Field::List(limit));
                    limit.iter_mut().for_each(|s| side_proof(s, see));
                }
            }
            see("Functions.failure", Field::Failure(&mut f.failure));
            match &mut f.failure {
                Failure::At(p) => point(p, see),
                Failure::Reaches(sides) => {
                    see("Failure::Reaches", Field::List(sides));
                    sides.iter_mut().for_each(|s| side_proof(s, see));
                }
                Failure::Limit { link, target, proof: side, apart } => {
                    see("Failure::Limit.link", Field::Index(link));
                    see("Failure::Limit.target", Field::Target(target));
                    side_proof(side, see);
                    apart.iter_mut().for_each(|p| proof("Failure::Limit.apart", p, see));
                }
            }
        }
    }
}

fn point(p: &mut Point, see: See<'_>) {
    see("Point.generator", Field::Root(&mut p.generator));
    if let Some(r) = &mut p.generator {
        root(r, see);
    }
    see("Point.values", Field::List(&mut p.values));
    for (v, coefficients) in &mut p.values {
        see("Point.values.0", Field::Index(v));
        see("Point.values.1", Field::List(coefficients));
        coefficients.iter_mut().for_each(|c| see("Point.values.1[]", Field::Ratio(c)));
    }
}

fn root(r: &mut Root, see: See<'_>) {
    see("Root.poly", Field::List(&mut r.poly));
    r.poly.iter_mut().for_each(|c| see("Root.poly[]", Field::Int(c)));
    see("Root.lo", Field::Ratio(&mut r.lo));
    see("Root.hi", Field::Ratio(&mut r.hi));
}

fn germ(g: &mut Germ, see: See<'_>) {
    let Side { var, at, above } = &mut g.side;
    see("Side.var", Field::Index(var));
    see("Side.at", Field::MaybeRatio(at));
    see("Side.above", Field::Flag(above));
    see("Germ.power", Field::Power(&mut g.power));
    see("Germ.radius.0", Field::Poly(&mut g.radius.0));
    see("Germ.radius.1", Field::Poly(&mut g.radius.1));
    proof("Germ.positive", &mut g.positive, see);
    see("Germ.inside", Field::List(&mut g.inside));
    for inside in &mut g.inside {
        see("Inside.values", Field::List(&mut inside.values));
        for (v, e) in &mut inside.values {
            see("Inside.values.0", Field::Index(v));
            see("Inside.values.1", Field::Expr(e));
        }
        proof("Inside.proof", &mut inside.proof, see);
    }
}

fn side_proof(s: &mut SideProof, see: See<'_>) {
    germ(&mut s.germ, see);
    see("SideProof.num", Field::Poly(&mut s.num));
    see("SideProof.den", Field::Poly(&mut s.den));
    see("SideProof.order", Field::Power(&mut s.order));
    see("SideProof.sense", Field::Sense(&mut s.sense));
    proof("SideProof.along", &mut s.along, see);
    proof("SideProof.at_zero", &mut s.at_zero, see);
    if let Some(upper) = &mut s.upper {
        side_proof(upper, see);
    }
}

fn factors(names: [&'static str; 3], list: &mut Vec<(usize, u32)>, see: See<'_>) {
    see(names[0], Field::List(list));
    for (i, n) in list {
        see(names[1], Field::Index(i));
        see(names[2], Field::Power(n));
    }
}

fn cofactors(names: [&'static str; 3], list: &mut Vec<(usize, Poly)>, see: See<'_>) {
    see(names[0], Field::List(list));
    for (i, c) in list {
        see(names[1], Field::Index(i));
        see(names[2], Field::Poly(c));
    }
}

fn proof(name: &'static str, p: &mut Proof, see: See<'_>) {
    see(name, Field::Proof(p));
    match p {
        Proof::Assume { formula, cases } => {
            see("Assume.formula", Field::Index(formula));
            see("Assume.cases", Field::List(cases));
            cases.iter_mut().for_each(|c| proof("Assume.cases[]", c, see));
        }
        Proof::Split { poly, cases } => {
            see("Split.poly", Field::Poly(poly));
            see("Split.cases", Field::List(cases));
            for c in cases {
                see("Case.opposite", Field::Flag(&mut c.opposite));
                see("Case.sign", Field::Sign(&mut c.sign));
                proof("Case.then", &mut c.then, see);
            }
        }
        Proof::Positive { terms, cofactors: list } => {
            see("Positive.terms", Field::List(terms));
            for t in terms {
                see("Term.weight", Field::Int(&mut t.weight));
                see("Term.square", Field::Poly(&mut t.square));
                factors(["Term.factors", "Term.factors.0", "Term.factors.1"], &mut t.factors, see);
            }
            let names = ["Positive.cofactors", "Positive.cofactors.0", "Positive.cofactors.1"];
            cofactors(names, list, see);
        }
        Proof::Pass { germ: g, atom: Atom { poly, sign }, along, then } => {
            germ(g, see);
            see("Pass.atom.poly", Field::Poly(poly));
            see("Pass.atom.sign", Field::Sign(sign));
            proof("Pass.along", along, see);
            proof("Pass.then", then, see);
        }
    }
}

/// A sum without a summand, which proves nothing.
fn nothing() -> Proof {
    Proof::Positive { terms: Vec::new(), cofactors: Vec::new() }
}

/// All kinds of fields, as [`walk`] names them.
pub(crate) const KINDS: &[&str] = &[
    "Certificate.goal",
    "Certificate.finding",
    "Certificate.evidence",
    "Evidence::Contradiction",
    "Evidence::Limit",
    "Evidence::Split.poly",
    "Evidence::Split.cases",
    "Evidence::Split.opposite",
    "Evidence::Split.sign",
    "Evidence::Split.then",
    "Point.generator",
    "Point.values",
    "Point.values.0",
    "Point.values.1",
    "Point.values.1[]",
    "Root.poly",
    "Root.poly[]",
    "Root.lo",
    "Root.hi",
    "Functions.var",
    "Functions.values",
    "Functions.values.0",
    "Functions.values.1",
    "Functions.ranges",
    "Functions.ranges[]",
    "Functions.premises",
    "Functions.premises.0",
    "Functions.premises.1",
    "Functions.premises.1[]",
    "Functions.failure",
    "Failure::Limit.link",
    "Failure::Limit.target",
    "Failure::Limit.apart",
    "Side.var",
    "Side.at",
    "Side.above",
    "Germ.power",
    "Germ.radius.0",
    "Germ.radius.1",
    "Germ.positive",
    "Germ.inside",
    "SideProof.num",
    "SideProof.den",
    "SideProof.order",
    "SideProof.sense",
    "SideProof.along",
    "SideProof.at_zero",
    "Assume.formula",
    "Assume.cases",
    "Assume.cases[]",
    "Split.poly",
    "Split.cases",
    "Case.opposite",
    "Case.sign",
    "Case.then",
    "Positive.terms",
    "Term.weight",
    "Term.square",
    "Term.factors",
    "Term.factors.0",
    "Term.factors.1",
    "Positive.cofactors",
    "Positive.cofactors.0",
    "Positive.cofactors.1",
    "Pass.atom.poly",
    "Pass.atom.sign",
    "Pass.along",
    "Pass.then",
    "Inside.values",
    "Inside.values.0",
    "Inside.values.1",
    "Inside.proof",
    "Failure::Reaches",
];

/// The kinds of a certificate's fields, in the order of [`walk`].
pub(crate) fn kinds(c: &Certificate) -> Vec<&'static str> {
    let mut out = Vec::new();
    walk(&mut c.clone(), &mut |kind, _| out.push(kind));
    out
}

/// The certificate with its field number `site` changed in some way; it may come out the same.
pub(crate) fn mutant(c: &Certificate, site: usize, chance: &mut Chance) -> Certificate {
    let mut out = c.clone();
    let mut n = 0;
    walk(&mut out, &mut |_, field| {
        if n == site {
            change(field, chance);
        }
        n += 1;
    });
    out
}

fn moved(i: usize, chance: &mut Chance) -> usize {
    match chance.below(4) {
        0 => i + 1,
        1 => i.wrapping_sub(1).min(99),
        2 => chance.below(8),
        _ => 1_000,
    }
}

fn ratio(x: &Q, chance: &mut Chance) -> Q {
    match chance.below(5) {
        0 => x + q(1, 1),
        1 => -x,
        2 => Q::zero(),
        3 => x * q(2, 1) - q(1, 3),
        _ => x - q(1, 1_000),
    }
}

fn change(field: Field<'_>, chance: &mut Chance) {
    match field {
        Field::Digest(d) => *d ^= 1 << chance.below(128),
        Field::Finding(f) => {
            *f = *chance.pick(&[
                Finding::Proved,
                Finding::Refuted,
                Finding::IllDefined,
                Finding::Vacuous,
                Finding::Consistent,
            ]);
        }
        Field::Evidence(e) => {
            *e = match chance.below(4) {
                0 => Evidence::Contradiction(nothing()),
                1 => Evidence::Limit(Vec::new()),
                2 => Evidence::Model(Model::Point(Point::default())),
                _ => Evidence::Contradiction(Proof::Assume { formula: 0, cases: Vec::new() }),
            }
        }
        Field::Proof(p) => {
            *p = match chance.below(3) {
                0 => nothing(),
                1 => Proof::Assume { formula: chance.below(4), cases: vec![nothing()] },
                _ => Proof::Split { poly: Poly::one(), cases: Vec::new() },
            }
        }
        Field::Index(i) => *i = moved(*i, chance),
        Field::Power(n) => {
            *n = match chance.below(3) {
                0 => *n + 1,
                1 => n.saturating_sub(1),
                _ => *n + 2,
            }
        }
        Field::Poly(p) => {
            *p = match chance.below(5) {
                0 => p.add(&Poly::one()),
                1 => p.neg(),
                2 => Poly::default(),
                3 => p.add(&Poly::var(chance.below(4))),
                _ => p.scale(&BigInt::from(2)).sub(&Poly::one()),
            }
        }
        Field::Int(c) => {
            *c = match chance.below(4) {
                0 => &*c + BigInt::one(),
                1 => -&*c,
                2 => BigInt::zero(),
                _ => &*c * BigInt::from(3),
            }
        }
        Field::Ratio(x) => *x = ratio(x, chance),
        Field::MaybeRatio(x) => {
            *x = match x {
                Some(_) if chance.once_in(2) => None,
                Some(x) => Some(ratio(x, chance)),
                None => Some(q(chance.within(-1, 1), 1)),
            }
        }
        Field::Flag(b) => *b = !*b,
        Field::Sign(s) => {
            *s = *chance.pick(&[Sign::Zero, Sign::NonZero, Sign::NonNegative, Sign::Positive]);
        }
        Field::Sense(s) => *s = *chance.pick(&[Ordering::Less, Ordering::Equal, Ordering::Greater]),
        Field::Root(r) => {
            *r = match r {
                Some(_) if chance.once_in(2) => None,
                Some(r) => Some(Root { lo: r.hi.clone(), ..r.clone() }),
                // √2
                None => Some(Root {
                    poly: vec![(-2).into(), 0.into(), 1.into()],
                    lo: q(chance.within(-2, 1), 1),
                    hi: q(2, 1),
                }),
            }
        }
        Field::Expr(e) => {
            let old = Rc::new(e.clone());
            *e = match chance.below(5) {
                0 => Expr::Neg(old),
                1 => Expr::Add(old, Rc::new(Expr::int(1))),
                2 => Expr::int(0),
                3 => Expr::Var(chance.below(4)),
                _ => Expr::Div(old, Rc::new(Expr::int(0))),
            }
        }
        Field::Target(t) => {
            *t = match chance.below(3) {
                0 => Target::PlusInf,
                1 => Target::MinusInf,
                _ => Target::Finite(Expr::int(chance.within(-2, 2))),
            }
        }
        Field::Failure(f) => *f = Failure::At(Point::default()),
        Field::List(list) => {
            let (n, i) = (list.len(), chance.below(list.len()));
            match chance.below(3) {
                _ if n == 0 => {}
                0 => list.drop_at(i),
                1 => list.double_at(i),
                _ => list.exchange(i, chance.below(n)),
            }
        }
    }
}

/// Whether two findings about one goal cannot both be right.
pub(crate) fn clash(a: Finding, b: Finding, not_implied: bool) -> bool {
    use Finding::{Consistent, IllDefined, Proved, Refuted, Vacuous};
    let one_way = |a, b| match (a, b) {
        (Proved, Refuted | IllDefined) | (Vacuous, IllDefined | Consistent) => true,
        (Vacuous, Refuted) => !not_implied,
        // that something is not implied is shown by a model of the hypotheses
        (Vacuous, Proved) => not_implied,
        _ => false,
    };
    one_way(a, b) || one_way(b, a)
}
