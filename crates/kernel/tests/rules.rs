//! Each rule of the kernel: a valid use is accepted, and each part of it can be wrong.

use kane_kernel::{
    Approach, Atom, Bound, Case, Certificate, Conclusion, Context, Evidence, Expr, Failure,
    Finding, Fuel, Functions, Germ, Goal, Hypothesis, Inside, Limit, Link, Model, Passages, Point,
    Poly, Proof, Rejection, Rel, Relation, Root, Sentence, Side, SideProof, Sign, State, Target,
    Term, Var, check, digest, scope,
};
use num_bigint::BigInt;
use num_rational::BigRational;

type Q = BigRational;

const X: usize = 0;
const Y: usize = 1;

fn q(n: i64, d: i64) -> Q {
    Q::new(n.into(), d.into())
}

fn symbol(name: &str, of: Option<usize>) -> Var {
    Var { name: name.to_string(), of, lower: None, upper: None }
}

/// A contradiction claim in x and y without premises.
fn plain() -> Goal {
    let vars = vec![symbol("x", None), symbol("y", None)];
    Goal {
        context: Context { vars, ..Context::default() },
        hypotheses: Vec::new(),
        behind: Vec::new(),
        when: Vec::new(),
        conclusion: Conclusion::Contradiction,
    }
}

fn relation(lhs: Expr, rel: Rel, rhs: Expr) -> Relation {
    Relation { lhs, rel, rhs }
}

fn given(links: Vec<Link>) -> Hypothesis {
    Hypothesis { sentence: Sentence { when: Vec::new(), links }, given: true }
}

fn x() -> Poly {
    Poly::var(X)
}

fn y() -> Poly {
    Poly::var(Y)
}

fn n(c: i64) -> Poly {
    Poly::constant(c.into())
}

/// What the kernel says of a proof that atoms contradict each other.
fn refuted(atoms: &[Atom], proof: &Proof) -> Result<(), Rejection> {
    let goal = plain();
    let scope = scope(&goal, Fuel::new(100_000)).expect("a small goal");
    let (atoms, formulas) = (atoms.to_vec(), std::rc::Rc::default());
    let passages = Passages::Anywhere;
    State { scope: &scope, goal: &goal, atoms, formulas, reaching: false, passages }.refute(proof)
}

/// The first proof is accepted, the others are not.
fn only_first(atoms: &[Atom], proofs: &[Proof]) {
    for (i, proof) in proofs.iter().enumerate() {
        assert_eq!(refuted(atoms, proof).is_ok(), i == 0, "proof {i}: {proof:?}");
    }
}

fn judged(goal: &Goal, finding: Finding, evidence: Evidence) -> Result<(), Rejection> {
    let certificate = Certificate { goal: digest(goal), finding, evidence };
    check(goal, &certificate, Fuel::new(1_000_000))
}

fn equal(p: Poly) -> Atom {
    Atom::new(p, Sign::Zero)
}

fn positive(p: Poly) -> Atom {
    Atom::new(p, Sign::Positive)
}

fn at_least(p: Poly) -> Atom {
    Atom::new(p, Sign::NonNegative)
}

fn distinct(p: Poly) -> Atom {
    Atom::new(p, Sign::NonZero)
}

fn term(weight: i64, square: Poly, factors: Vec<(usize, u32)>) -> Term {
    Term { weight: weight.into(), square, factors }
}

/// A sum without a summand, which proves nothing.
fn nothing() -> Proof {
    Proof::Positive { terms: Vec::new(), cofactors: Vec::new() }
}

/// Atom i says that −1 is not negative.
fn minus_one(i: usize) -> Proof {
    let terms = vec![term(1, n(1), vec![(i, 1)]), term(1, n(1), Vec::new())];
    Proof::Positive { terms, cofactors: Vec::new() }
}

/// Atom i says that 1 is 0.
fn one_is_zero(i: usize) -> Proof {
    Proof::Positive { terms: vec![term(1, n(1), Vec::new())], cofactors: vec![(i, n(-1))] }
}

#[test]
fn split_needs_all_three_signs() {
    // x² < 0, by the sign of x.
    let atoms = [positive(x().mul(&x(), &Fuel::new(10)).expect("small").neg())];
    let square = |i| Proof::Positive {
        terms: vec![term(1, n(1), vec![(0, 1)]), term(1, n(1), vec![(i, 2)])],
        cofactors: Vec::new(),
    };
    let zero =
        || Proof::Positive { terms: vec![term(1, n(1), vec![(0, 1)])], cofactors: vec![(1, x())] };
    let case = |opposite, sign, then| Case { opposite, sign, then };
    let below = |then| case(true, Sign::Positive, then);
    let split = |poly, zero, positive, negative| Proof::Split {
        poly,
        cases: vec![
            case(false, Sign::Zero, zero),
            case(false, Sign::Positive, positive),
            below(negative),
        ],
    };
    let two = |first, second| Proof::Split { poly: x(), cases: vec![first, second] };
    only_first(
        &atoms,
        &[
            split(x(), zero(), square(1), square(1)),
            split(y(), zero(), square(1), square(1)),
            split(x(), nothing(), square(1), square(1)),
            split(x(), zero(), nothing(), square(1)),
            split(x(), zero(), square(1), nothing()),
            two(case(false, Sign::Zero, zero()), below(square(1))),
            two(case(false, Sign::Positive, square(1)), below(square(1))),
            Proof::Split { poly: x(), cases: Vec::new() },
        ],
    );
    // Cases may be wider than one sign, and overlap.
    let differs = || case(false, Sign::NonZero, square(1));
    assert!(refuted(&atoms, &two(case(false, Sign::Zero, zero()), differs())).is_ok());
    assert!(refuted(&atoms, &two(differs(), below(square(1)))).is_err());
}

#[test]
fn a_positive_sum_is_an_identity_of_known_signs() {
    // x ≥ 0, −x − 1 + y ≥ 0, y = 0: their sum with −y is −1.
    let atoms = [at_least(x()), at_least(y().sub(&x()).sub(&n(1))), equal(y()), distinct(x())];
    let sum = |weight, square, factor, cofactor: (usize, Poly)| Proof::Positive {
        terms: vec![
            term(weight, n(1), vec![(factor, 1)]),
            term(1, n(1), vec![(1, 1)]),
            term(1, square, Vec::new()),
        ],
        cofactors: vec![cofactor],
    };
    only_first(
        &atoms,
        &[
            sum(1, n(1), 0, (2, n(-1))),
            sum(2, n(1), 0, (2, n(-1))),
            sum(1, n(2), 0, (2, n(-1))),
            sum(1, n(1), 3, (2, n(-1))),
            sum(1, n(1), 0, (2, n(1))),
            sum(1, n(1), 0, (1, n(-1))),
        ],
    );
    // −1·1 + 1·1 is no sum of positive weights, x² − x·x has no positive summand.
    let terms = vec![term(-1, n(1), Vec::new()), term(1, n(1), Vec::new())];
    assert!(refuted(&atoms, &Proof::Positive { terms, cofactors: Vec::new() }).is_err());
    assert!(
        refuted(&atoms, &Proof::Positive { terms: Vec::new(), cofactors: Vec::new() }).is_err()
    );
}

#[test]
fn an_algebraic_point_is_isolated_by_its_polynomial() {
    // x² = 2 and x > 0 can hold.
    let square = Expr::Pow(Expr::Var(X).into(), 2);
    let goal = Goal {
        hypotheses: vec![given(vec![
            Link::Relation(relation(square, Rel::Eq, Expr::int(2))),
            Link::Relation(relation(Expr::Var(X), Rel::Gt, Expr::int(0))),
        ])],
        ..plain()
    };
    let at = |poly: [i64; 3], lo, hi, values: Vec<Q>| {
        let poly = poly.map(BigInt::from).to_vec();
        let point = Point { generator: Some(Root { poly, lo, hi }), values: vec![(X, values)] };
        judged(&goal, Finding::Refuted, Evidence::Model(Model::Point(point)))
    };
    let theta = || vec![q(0, 1), q(1, 1)];
    assert_eq!(at([-2, 0, 1], q(1, 1), q(2, 1), theta()), Ok(()));
    assert!(at([-3, 0, 1], q(1, 1), q(2, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(-2, 1), q(-1, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(-2, 1), q(2, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(3, 2), q(2, 1), theta()).is_err());
    assert!(at([-2, 0, 1], q(1, 1), q(2, 1), vec![q(0, 1), q(2, 1)]).is_err());
    // No value may redefine the algebraic number itself.
    let poly = vec![(-2).into(), 0.into(), 1.into()];
    let generator = Some(Root { poly, lo: q(1, 1), hi: q(2, 1) });
    let values = vec![(X, vec![q(0, 1), q(2, 1)]), (usize::MAX, vec![q(0, 1), q(0, 1), q(1, 1)])];
    let point = Point { generator, values };
    assert!(judged(&goal, Finding::Refuted, Evidence::Model(Model::Point(point))).is_err());
}

/// 1/x as x → ∞, as a goal, and its proof with x = 1/t.
fn tends_to_zero() -> (Goal, SideProof) {
    let expr = Expr::Div(Expr::int(1).into(), Expr::Var(X).into());
    let to = Target::Finite(Expr::int(0));
    let limit = Limit { expr, to, var: X, at: Approach::PlusInf };
    let goal = Goal { conclusion: Conclusion::Link(Link::Limit(limit)), ..plain() };
    let t = 2;
    let split = |formula, cases| Box::new(Proof::Assume { formula, cases });
    // Formulas along the germ: `when`, then the failure; at t = 0 and for the radius alike.
    let germ = Germ {
        side: Side { var: X, at: None, above: true },
        radius: (n(1), n(1)),
        positive: split(1, vec![minus_one(0), minus_one(0)]),
        inside: Vec::new(),
    };
    // Atoms: t > 0, 1 − t > 0, x·t = 1; then x ≠ 0 and 1 − t·x ≠ 0, or x = 0.
    let gap = n(1).sub(&x().mul(&Poly::var(t), &Fuel::new(10)).expect("small"));
    let pole = Proof::Positive {
        terms: vec![term(1, n(1), Vec::new())],
        cofactors: vec![(2, n(1)), (3, Poly::var(t).neg())],
    };
    let differs =
        Proof::Positive { terms: vec![term(1, n(1), vec![(4, 2)])], cofactors: vec![(2, gap)] };
    let proof = SideProof {
        germ,
        num: Poly::var(t),
        den: n(1),
        order: 0,
        along: split(1, vec![differs, pole]),
        at_zero: split(1, vec![one_is_zero(0)]),
    };
    (goal, proof)
}

#[test]
fn a_limit_is_proved_along_its_germ_and_at_its_end() {
    let (goal, proof) = tends_to_zero();
    let limit = |proof: SideProof| judged(&goal, Finding::Proved, Evidence::Limit(vec![proof]));
    let with = |change: &dyn Fn(&mut SideProof)| {
        let mut changed = proof.clone();
        change(&mut changed);
        limit(changed)
    };
    assert_eq!(with(&|_| ()), Ok(()));
    assert!(with(&|p| p.germ.side.above = false).is_err());
    assert!(with(&|p| p.germ.side.at = Some(q(0, 1))).is_err());
    assert!(with(&|p| p.germ.radius.0 = n(-1)).is_err());
    assert!(with(&|p| p.germ.radius.1 = x()).is_err());
    assert!(with(&|p| *p.germ.positive = nothing()).is_err());
    let inside = || Inside { values: Vec::new(), proof: nothing() };
    assert!(with(&|p| p.germ.inside.push(inside())).is_err());
    assert!(with(&|p| p.num = n(1)).is_err());
    assert!(with(&|p| p.den = n(2)).is_err());
    assert!(with(&|p| p.order = 1).is_err());
    assert!(with(&|p| *p.along = nothing()).is_err());
    assert!(with(&|p| *p.at_zero = nothing()).is_err());
    assert!(judged(&goal, Finding::Proved, Evidence::Limit(Vec::new())).is_err());
}

/// A proof that a premise without undefined parts, or a range, holds: nothing of it is left to fail.
fn evident() -> Proof {
    Proof::Assume { formula: 1, cases: Vec::new() }
}

#[test]
fn a_limit_is_vacuous_only_if_its_own_side_is_not_reached() {
    // x → 0 as x → 0+ from a premise about x.
    let limit = Limit {
        expr: Expr::Var(X),
        to: Target::Finite(Expr::int(0)),
        var: X,
        at: Approach::Above(q(0, 1)),
    };
    let goal = |rel| Goal {
        hypotheses: vec![given(vec![Link::Relation(relation(Expr::Var(X), rel, Expr::int(5)))])],
        conclusion: Conclusion::Link(Link::Limit(limit.clone())),
        ..plain()
    };
    let vacuous = |rel, at: i64, atom: Atom, terms: Vec<Term>, cofactor: i64| {
        let germ = Germ {
            side: Side { var: X, at: Some(q(at, 1)), above: true },
            radius: (n(1), n(1)),
            positive: Box::new(Proof::Assume {
                formula: 2,
                cases: vec![minus_one(0), minus_one(0)],
            }),
            inside: Vec::new(),
        };
        let sum = Proof::Positive { terms, cofactors: vec![(2, n(cofactor))] };
        let along = Box::new(Proof::Assume { formula: 0, cases: vec![sum] });
        let then = Box::new(one_is_zero(0));
        let proof = Proof::Pass { germ, atom, along, then };
        judged(&goal(rel), Finding::Vacuous, Evidence::Contradiction(proof))
    };
    // With x > 5 the side is not reached: (x − 5) + (1 − t) + 4 − (x − t) = 0.
    let reached = || {
        vec![term(1, n(1), vec![(4, 1)]), term(1, n(1), vec![(1, 1)]), term(4, n(1), Vec::new())]
    };
    assert_eq!(vacuous(Rel::Gt, 0, equal(n(1)), reached(), -1), Ok(()));
    assert!(vacuous(Rel::Gt, 0, distinct(n(0)), reached(), -1).is_err());
    assert!(vacuous(Rel::Gt, 0, equal(x()), reached(), -1).is_err());
    assert!(vacuous(Rel::Gt, 0, equal(n(0)), reached(), -1).is_err());
    assert!(vacuous(Rel::Gt, 0, equal(n(1)), reached(), 1).is_err());
    assert!(vacuous(Rel::Gt, 1, equal(n(1)), reached(), -1).is_err());
    // With x < 5 it is, whatever happens beyond 7: t + (5 − x) + 2 + (x − t − 7) = 0.
    let beyond =
        vec![term(1, n(1), vec![(0, 1)]), term(1, n(1), vec![(4, 1)]), term(2, n(1), Vec::new())];
    assert!(vacuous(Rel::Lt, 7, equal(n(1)), beyond, 1).is_err());
}

#[test]
fn a_derivative_by_a_symbol_with_a_value_is_refused() {
    // d(x², x) = c with x := 2, as functions of y.
    let model = |c, var, values: Vec<(usize, Expr)>, at| {
        let slope = Expr::Deriv(Expr::Pow(Expr::Var(X).into(), 2).into(), X);
        let premise = given(vec![Link::Relation(relation(slope, Rel::Eq, Expr::int(c)))]);
        let goal = Goal { hypotheses: vec![premise], ..plain() };
        let ranges = values.iter().map(|_| evident()).collect();
        let failure = Failure::At(Point { generator: None, values: vec![(at, vec![q(0, 1)])] });
        let premises = vec![(evident(), Vec::new())];
        let functions = Functions { var, values, ranges, premises, failure };
        judged(&goal, Finding::Refuted, Evidence::Model(Model::Functions(functions.into())))
    };
    let two = || vec![(X, Expr::int(2))];
    for c in [0, 4] {
        assert_eq!(model(c, Y, two(), Y), Err(Rejection::NotExplicit));
    }
    assert!(model(4, X, two(), Y).is_err());
}

#[test]
fn premised_limits_are_about_the_variable_of_the_functions() {
    // k·a = 1 for all a > 0 and k → 1/3 as a → ∞ cannot both hold; at a = 3 alone they would.
    let (a, k) = (X, 2);
    let mut goal = plain();
    goal.context.vars.push(symbol("k", Some(a)));
    goal.context.vars[a].lower = Some(Bound { value: q(0, 1), strict: true });
    let third = || Expr::Num(q(1, 3));
    let product = Expr::Mul(Expr::Var(k).into(), Expr::Var(a).into());
    let limit =
        Limit { expr: Expr::Var(k), to: Target::Finite(third()), var: a, at: Approach::PlusInf };
    goal.hypotheses = vec![
        given(vec![Link::Relation(relation(product, Rel::Eq, Expr::int(1)))]),
        given(vec![Link::Limit(limit)]),
    ];
    let germ = Germ {
        side: Side { var: a, at: None, above: true },
        radius: (n(1), n(1)),
        positive: Box::new(Proof::Assume { formula: 1, cases: vec![nothing(), nothing()] }),
        inside: Vec::new(),
    };
    let proof = SideProof {
        germ,
        num: n(1),
        den: n(3),
        order: 0,
        along: Box::new(evident()),
        at_zero: Box::new(Proof::Assume { formula: 1, cases: vec![nothing()] }),
    };
    let functions = Functions {
        var: Y,
        values: vec![(a, Expr::int(3)), (k, third())],
        ranges: vec![evident(), evident()],
        premises: vec![(evident(), Vec::new()), (evident(), vec![vec![proof]])],
        failure: Failure::At(Point { generator: None, values: vec![(Y, vec![q(0, 1)])] }),
    };
    let evidence = Evidence::Model(Model::Functions(functions.into()));
    assert_eq!(judged(&goal, Finding::Refuted, evidence), Err(Rejection::NotConstant));
}

#[test]
fn a_derivative_is_undefined_where_a_guard_jumps() {
    // g jumps at x = 1 from 1 to −1, and with it f from x to 2·x.
    let cases = |rel, side: Expr, edge, yes: Expr, no: Expr| {
        Expr::Cases(vec![(vec![relation(side, rel, Expr::int(edge))], yes)], Some(no.into()))
    };
    let double = Expr::Mul(Expr::int(2).into(), Expr::Var(X).into());
    let g = cases(Rel::Lt, Expr::Var(X), 1, Expr::int(1), Expr::int(-1));
    let f = cases(Rel::Gt, g, 0, Expr::Var(X), double);
    let slope = relation(Expr::Deriv(f.into(), X), Rel::Eq, Expr::int(2));
    let goal = Goal { conclusion: Conclusion::Link(Link::Relation(slope)), ..plain() };
    let undefined = |x: i64| {
        let point = Point { generator: None, values: vec![(X, vec![q(x, 1)])] };
        judged(&goal, Finding::IllDefined, Evidence::Model(Model::Point(point)))
    };
    assert_eq!(undefined(1), Ok(()));
    assert!(undefined(0).is_err());
    assert!(undefined(2).is_err());
}

#[test]
fn a_certificate_is_for_one_goal_and_one_finding() {
    let goal = Goal { when: vec![relation(Expr::int(1), Rel::Lt, Expr::int(0))], ..plain() };
    let proof = || Evidence::Contradiction(Proof::Assume { formula: 0, cases: Vec::new() });
    assert_eq!(judged(&goal, Finding::Proved, proof()), Ok(()));
    assert_eq!(judged(&goal, Finding::Vacuous, proof()), Ok(()));
    for finding in [Finding::Refuted, Finding::IllDefined, Finding::Consistent] {
        assert_eq!(judged(&goal, finding, proof()), Err(Rejection::WrongEvidence));
    }
    let other = Certificate { goal: digest(&plain()), finding: Finding::Proved, evidence: proof() };
    assert_eq!(check(&goal, &other, Fuel::new(1000)), Err(Rejection::OtherGoal));
    assert!(judged(&plain(), Finding::Proved, proof()).is_err());
}

#[test]
fn a_limit_is_not_taken_for_the_function_along_the_germ() {
    // f = x for all x and f → 0 as x → 0+ contradict nothing. Along the germ z is f itself, and a
    // passage there would add what holds of its limit.
    let (t, z) = (Poly::var(2), Poly::var(3));
    let f = Expr::Var(Y);
    let same = Link::Relation(relation(f.clone(), Rel::Eq, Expr::Var(X)));
    let at = Approach::Above(q(0, 1));
    let to = Target::Finite(Expr::int(0));
    let limit = Link::Limit(Limit { expr: f, to, var: X, at });
    let goal = Goal {
        context: Context {
            vars: vec![symbol("x", None), symbol("f", Some(X))],
            ..Context::default()
        },
        hypotheses: vec![given(vec![same]), given(vec![limit])],
        ..plain()
    };
    let germ = || Germ {
        side: Side { var: X, at: Some(q(0, 1)), above: true },
        radius: (n(1), n(1)),
        positive: Box::new(Proof::Assume { formula: 4, cases: vec![minus_one(0), minus_one(0)] }),
        // With x for f the given holds along the germ.
        inside: vec![Inside {
            values: vec![(Y, Expr::Var(X))],
            proof: Proof::Assume { formula: 3, cases: Vec::new() },
        }],
    };
    let with_f = |then| {
        let z_is_f = Proof::Assume { formula: 2, cases: vec![then] };
        Box::new(Proof::Assume { formula: 0, cases: vec![z_is_f] })
    };
    let gap = z.sub(&t);
    let along = Proof::Positive {
        terms: vec![term(1, n(1), vec![(4, 2)])],
        cofactors: vec![(3, gap.neg()), (5, gap.neg()), (6, gap.clone())],
    };
    let then = Proof::Positive {
        terms: vec![term(1, n(1), vec![(0, 1)])],
        cofactors: vec![(2, n(1)), (5, n(1)), (6, n(-1)), (4, n(-1))],
    };
    let inner =
        Proof::Pass { germ: germ(), atom: equal(gap), along: with_f(along), then: with_f(then) };
    let absurd = equal(n(1));
    let proof = Proof::Pass {
        germ: germ(),
        atom: absurd,
        along: inner.into(),
        then: one_is_zero(0).into(),
    };
    let verdict = judged(&goal, Finding::Proved, Evidence::Contradiction(proof));
    assert_eq!(verdict, Err(Rejection::OutsideDomain));
}
