//! Small goals, small proofs, and a search for them that is good enough for what the tests ask.

use std::cmp::Ordering;

use std::collections::BTreeMap;

use kane_kernel::{
    Approach, Atom, Bound, Certificate, Conclusion, Context, Evidence, Expr, Finding, Fuel, Germ,
    Goal, Hypothesis, Limit, Link, Passages, Poly, Proof, Rejection, Rel, Relation, Root, Sentence,
    Side, SideProof, Sign, State, Target, Term, Var, check, differs, digest, misses, scope,
};
use num_rational::BigRational;

/// An exact number.
pub(crate) type Q = BigRational;

/// The first symbol, by custom the limit variable.
pub(crate) const X: usize = 0;
/// The second symbol.
pub(crate) const Y: usize = 1;

/// n/d
pub(crate) fn q(n: i64, d: i64) -> Q {
    Q::new(n.into(), d.into())
}

/// More than any test needs.
pub(crate) fn plenty() -> Fuel {
    Fuel::new(10_000_000)
}

/// A symbol without bounds, a function of another symbol or not.
pub(crate) fn symbol(name: &str, of: Option<usize>) -> Var {
    Var { name: name.to_string(), of, lower: None, upper: None }
}

/// An end of a range.
pub(crate) fn bound(value: Q, strict: bool) -> Option<Bound> {
    Some(Bound { value, strict })
}

/// A contradiction claim in x and y without premises.
pub(crate) fn plain() -> Goal {
    let vars = vec![symbol("x", None), symbol("y", None)];
    Goal {
        context: Context { vars, ..Context::default() },
        hypotheses: Vec::new(),
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    }
}

/// The same with a function y of x.
pub(crate) fn with_function() -> Goal {
    let vars = vec![symbol("x", None), symbol("y", Some(X))];
    Goal { context: Context { vars, ..Context::default() }, ..plain() }
}

pub(crate) fn relation(lhs: Expr, rel: Rel, rhs: Expr) -> Relation {
    Relation { lhs, rel, rhs }
}

pub(crate) fn link(lhs: Expr, rel: Rel, rhs: Expr) -> Link {
    Link::Relation(relation(lhs, rel, rhs))
}

pub(crate) fn given(links: Vec<Link>) -> Hypothesis {
    Hypothesis { sentence: Sentence { when: Vec::new(), links }, given: true }
}

pub(crate) fn cited(links: Vec<Link>) -> Hypothesis {
    Hypothesis { given: false, ..given(links) }
}

pub(crate) fn limit(expr: Expr, to: Target, at: Approach) -> Limit {
    Limit { expr, to, var: X, at }
}

pub(crate) fn number(n: i64, d: i64) -> Expr {
    Expr::Num(q(n, d))
}

pub(crate) fn var(v: usize) -> Expr {
    Expr::Var(v)
}

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

pub(crate) fn abs(a: Expr) -> Expr {
    Expr::Abs(a.into())
}

pub(crate) fn sqrt(a: Expr) -> Expr {
    Expr::Sqrt(a.into())
}

/// The derivative by x.
pub(crate) fn slope(a: Expr) -> Expr {
    Expr::Deriv(a.into(), X)
}

/// `cases { lhs ⋈ rhs: yes; else: no }`
pub(crate) fn either(guard: Relation, yes: Expr, no: Expr) -> Expr {
    Expr::Cases(vec![(vec![guard], yes)], Some(no.into()))
}

pub(crate) fn x() -> Poly {
    Poly::var(X)
}

pub(crate) fn y() -> Poly {
    Poly::var(Y)
}

pub(crate) fn n(c: i64) -> Poly {
    Poly::constant(c.into())
}

/// A product without a budget to speak of.
pub(crate) fn times(a: &Poly, b: &Poly) -> Poly {
    a.mul(b, &plenty()).expect("a small product")
}

pub(crate) fn equal(p: Poly) -> Atom {
    Atom::new(p, Sign::Zero)
}

pub(crate) fn positive(p: Poly) -> Atom {
    Atom::new(p, Sign::Positive)
}

pub(crate) fn at_least(p: Poly) -> Atom {
    Atom::new(p, Sign::NonNegative)
}

pub(crate) fn distinct(p: Poly) -> Atom {
    Atom::new(p, Sign::NonZero)
}

pub(crate) fn term(weight: i64, square: Poly, factors: Vec<(usize, u32)>) -> Term {
    Term { weight: weight.into(), square, factors }
}

/// A sum without a summand, which proves nothing.
pub(crate) fn nothing() -> Proof {
    Proof::Positive { terms: Vec::new(), cofactors: Vec::new() }
}

/// Atom i says that −1 is not negative.
pub(crate) fn minus_one(i: usize) -> Proof {
    let terms = vec![term(1, n(1), vec![(i, 1)]), term(1, n(1), Vec::new())];
    Proof::Positive { terms, cofactors: Vec::new() }
}

/// Atom i says that 1 is 0.
pub(crate) fn one_is_zero(i: usize) -> Proof {
    Proof::Positive { terms: vec![term(1, n(1), Vec::new())], cofactors: vec![(i, n(-1))] }
}

/// A side of a number, or of infinity.
pub(crate) fn side(at: Option<Q>, above: bool) -> Side {
    Side { var: X, at, above }
}

/// A root of a polynomial with small coefficients.
pub(crate) fn root(poly: &[i64], lo: Q, hi: Q) -> Root {
    Root { poly: poly.iter().map(|c| (*c).into()).collect(), lo, hi }
}

/// What the kernel says of a proof that atoms contradict each other.
pub(crate) fn refuted(atoms: &[Atom], proof: &Proof) -> Result<(), Rejection> {
    closed(atoms, Vec::new(), proof)
}

/// The same with formulas.
pub(crate) fn closed(
    atoms: &[Atom],
    formulas: Vec<Vec<Vec<Atom>>>,
    proof: &Proof,
) -> Result<(), Rejection> {
    let goal = plain();
    let scope = scope(&goal, Fuel::new(100_000)).expect("a small goal");
    let (atoms, formulas) = (atoms.to_vec(), formulas.into());
    let passages = Passages::Anywhere;
    State { scope: &scope, goal: &goal, atoms, formulas, reaching: false, passages }.refute(proof)
}

/// The first proof is accepted, the others are not.
pub(crate) fn only_first(atoms: &[Atom], proofs: &[Proof]) {
    for (i, proof) in proofs.iter().enumerate() {
        assert_eq!(refuted(atoms, proof).is_ok(), i == 0, "proof {i}: {proof:?}");
    }
}

/// What the kernel says of evidence for a finding about a goal.
pub(crate) fn judged(goal: &Goal, finding: Finding, evidence: Evidence) -> Result<(), Rejection> {
    let certificate = Certificate { goal: digest(goal), finding, evidence };
    check(goal, &certificate, Fuel::new(1_000_000))
}

/// A proof that closes a state, if a very small one does: every case of every formula, and then a
/// sum of a few summands.
pub(crate) fn found(state: &State<'_, '_>) -> Option<Proof> {
    cases_from(state, 0, false)
}

/// The same for a state that has one: the test is wrong if none is found.
pub(crate) fn closing(state: &State<'_, '_>) -> Proof {
    let proof = found(state).or_else(|| cases_from(state, 0, true));
    assert!(proof.is_some(), "no proof of {:?} {:?}", state.atoms, state.formulas);
    proof.expect("just seen")
}

fn cases_from(state: &State<'_, '_>, formula: usize, thorough: bool) -> Option<Proof> {
    if let Some(proof) = sum(state, thorough) {
        return Some(proof);
    }
    let next = state.assume(formula).ok()?;
    let cases =
        next.iter().map(|case| cases_from(case, formula + 1, thorough)).collect::<Option<_>>()?;
    Some(Proof::Assume { formula, cases })
}

/// One summand: a term, or an equation with a cofactor.
#[derive(Clone)]
enum Summand {
    Term(Term),
    Equation(usize, Poly),
}

fn sum(state: &State<'_, '_>, thorough: bool) -> Option<Proof> {
    let atoms = &state.atoms;
    let mut pool: Vec<(Poly, Summand)> = Vec::new();
    let mut vars: Vec<usize> = atoms.iter().flat_map(|a| a.poly.vars()).collect();
    vars.sort_unstable();
    vars.dedup();
    for (i, atom) in atoms.iter().enumerate() {
        let p = &atom.poly;
        match atom.sign {
            Sign::Zero => {
                let others = atoms.iter().map(|a| a.poly.scale(&a.poly.primitive().0));
                for m in vars.iter().map(|v| Poly::var(*v)).chain([n(1), n(2)]).chain(others) {
                    for m in [m.neg(), m] {
                        pool.push((times(p, &m), Summand::Equation(i, m)));
                    }
                }
            }
            Sign::NonZero => {
                pool.push((times(p, p), Summand::Term(term(1, n(1), vec![(i, 2)]))));
            }
            Sign::NonNegative | Sign::Positive => {
                for w in [1, 3] {
                    let weighed = Summand::Term(term(w, n(1), vec![(i, 1)]));
                    pool.push((p.scale(&w.into()), weighed));
                }
                for (j, other) in atoms.iter().enumerate().take(i) {
                    if other.sign.is_order() {
                        let factors = vec![(i, 1), (j, 1)];
                        let product = times(p, &other.poly);
                        pool.push((product, Summand::Term(term(1, n(1), factors))));
                    }
                }
            }
        }
    }
    // What two summands add up to, but for the constant, which one more summand can make up for.
    let bare = |p: &Poly| {
        let varies = p.terms().filter(|(m, _)| !m.is_empty());
        varies.fold(Poly::default(), |sum, (m, c)| sum.add(&Poly::term(m.to_vec(), c.clone())))
    };
    let closes = |parts: &[usize]| {
        let (mut terms, mut cofactors) = (Vec::new(), Vec::new());
        let total = parts.iter().fold(Poly::default(), |sum, i| sum.add(&pool[*i].0));
        let missing = -total.as_constant()?;
        if missing > 0.into() {
            terms.push(Term { weight: missing, square: n(1), factors: Vec::new() });
        }
        for i in parts {
            match pool[*i].1.clone() {
                Summand::Term(t) => terms.push(t),
                Summand::Equation(i, m) => cofactors.push((i, m)),
            }
        }
        let proof = Proof::Positive { terms, cofactors };
        state.refute(&proof).is_ok().then_some(proof)
    };
    let mut sums: BTreeMap<Poly, Vec<Vec<usize>>> = BTreeMap::new();
    for (i, (first, _)) in pool.iter().enumerate() {
        sums.entry(bare(first)).or_default().push(vec![i]);
    }
    // One summand, two, three, and if it is worth the time two and two.
    for (i, (first, _)) in pool.iter().enumerate() {
        let rest = sums.get(&bare(first).neg());
        let pairs = rest.into_iter().flatten().map(|rest| [&rest[..], &[i]].concat());
        if let Some(proof) = closes(&[i]).or_else(|| pairs.into_iter().find_map(|p| closes(&p))) {
            return Some(proof);
        }
    }
    let pairs: Vec<(Poly, Vec<usize>)> = (0..pool.len())
        .flat_map(|i| (0..i).map(move |j| (i, j)))
        .map(|(i, j)| (bare(&pool[i].0.add(&pool[j].0)), vec![i, j]))
        .collect();
    for twice in [false, true] {
        if twice && !thorough {
            break;
        }
        if twice {
            for (sum, pair) in &pairs {
                sums.entry(sum.clone()).or_default().push(pair.clone());
            }
        }
        for (sum, pair) in &pairs {
            for rest in sums.get(&sum.neg()).into_iter().flatten() {
                if let Some(proof) = closes(&[&rest[..], &pair[..]].concat()) {
                    return Some(proof);
                }
            }
        }
    }
    None
}

/// A germ 0 < t < 1 on a side, with the proof that 1 is positive.
pub(crate) fn germ(state: &State<'_, '_>, side: Side) -> Germ {
    let no = || vec![positive(n(1)).not()];
    let proof = closing(&state.with_cases(vec![no(), no()]));
    Germ { power: 1, side, radius: (n(1), n(1)), positive: Box::new(proof), inside: Vec::new() }
}

/// A limit proof along a germ: den·f = num, and what is left at t = 0.
pub(crate) fn side_proof(
    state: &State<'_, '_>,
    limit: &Limit,
    germ: Germ,
    parts: (Poly, Poly, u32),
) -> SideProof {
    bounded(state, limit, germ, parts, (Ordering::Equal, &closing))
}

/// The same for a bound, with a proof of it.
pub(crate) fn bounded(
    state: &State<'_, '_>,
    limit: &Limit,
    germ: Germ,
    (num, den, order): (Poly, Poly, u32),
    (sense, along): (Ordering, &dyn Fn(&State<'_, '_>) -> Proof),
) -> SideProof {
    let there = state.along_unproved(&germ).expect("a germ in the domain");
    let wrong = differs(state.scope, &limit.expr, (&num, &den), sense).expect("small");
    let along = Box::new(along(&there.with_cases(wrong)));
    let parts = (&num, &den, order);
    let ends = misses(state, &germ.side, parts, &limit.to).expect("ends that can be compared");
    let at_zero = Box::new(closing(&state.with_cases(ends)));
    SideProof { germ, num, den, order, sense, along, at_zero, upper: None }
}
