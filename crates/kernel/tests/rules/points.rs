//! The three rules for points: assume, split, positive.

use kane_kernel::{
    Case, Evidence, Finding, Fuel, Goal, Passages, Poly, Proof, Rejection, Rel, Sign, State, scope,
};

use crate::support::{
    at_least, closed, distinct, equal, judged, minus_one, n, nothing, number, one_is_zero,
    only_first, plain, positive, refuted, relation, term, times, x, y,
};

fn sum(terms: Vec<kane_kernel::Term>, cofactors: Vec<(usize, Poly)>) -> Proof {
    Proof::Positive { terms, cofactors }
}

#[test]
fn split_needs_all_three_signs() {
    // x² < 0, by the sign of x.
    let atoms = [positive(times(&x(), &x()).neg())];
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
fn what_may_be_zero_is_no_strict_summand() {
    let one = || term(1, n(1), Vec::new());
    // x ≥ 0 and −x ≥ 0 can both hold: their sum is 0 and not positive.
    let weak = [at_least(x()), at_least(x().neg())];
    let both = |w| sum(vec![term(w, n(1), vec![(0, 1)]), term(w, n(1), vec![(1, 1)])], Vec::new());
    assert_eq!(refuted(&weak, &both(1)), Err(Rejection::NotPositive));
    let strict = [at_least(x()), positive(x().neg())];
    assert_eq!(refuted(&strict, &both(1)), Ok(()));
    // Among several factors one that may vanish is enough.
    let product = [positive(x()), at_least(y()), at_least(times(&x(), &y()).neg())];
    let factors = || vec![term(1, n(1), vec![(0, 1), (1, 1)]), term(1, n(1), vec![(2, 1)])];
    assert_eq!(refuted(&product, &sum(factors(), Vec::new())), Err(Rejection::NotPositive));
    // x² − x·x = 0: a square that varies may vanish, and so does the square of 0.
    let zero = [equal(x())];
    let square = |p: Poly, c| sum(vec![term(1, p, Vec::new())], vec![(0, c)]);
    assert_eq!(refuted(&zero, &square(x(), x().neg())), Err(Rejection::NotPositive));
    assert_eq!(refuted(&zero, &square(n(0), n(0))), Err(Rejection::NotPositive));
    // No weight is 0 or negative.
    let weights =
        |a, b| sum(vec![term(a, n(1), Vec::new()), term(b, n(1), Vec::new())], Vec::new());
    assert_eq!(refuted(&[], &weights(0, 0)), Err(Rejection::NotPositive));
    assert_eq!(refuted(&[], &weights(1, -1)), Err(Rejection::NotPositive));
    // The strict summand has to be among those that make up zero.
    assert_eq!(refuted(&[], &sum(vec![one()], Vec::new())), Err(Rejection::NotAnIdentity));
}

#[test]
fn a_factor_has_a_sign_that_its_power_keeps() {
    // x + 1 = 0 with an x that is not zero, or is −1 by an equation, or not positive: all can hold.
    let minus = |i: usize, power| {
        sum(vec![term(1, n(1), vec![(i, power)]), term(1, n(1), Vec::new())], vec![(0, n(-1))])
    };
    let root = || equal(x().add(&n(1)));
    assert_eq!(refuted(&[root(), distinct(x())], &minus(1, 1)), Err(Rejection::MayVanish));
    assert_eq!(refuted(&[root(), equal(x().add(&n(1)))], &minus(1, 1)), Err(Rejection::MayVanish));
    assert_eq!(refuted(&[root(), positive(x())], &minus(1, 1)), Ok(()));
    assert_eq!(refuted(&[root(), at_least(x())], &minus(1, 1)), Ok(()));
    // x ≠ 0 and −x² ≥ 0: the square of what is not zero is positive.
    let atoms = [distinct(x()), at_least(times(&x(), &x()).neg())];
    let even =
        |power| sum(vec![term(1, n(1), vec![(0, power)]), term(1, n(1), vec![(1, 1)])], Vec::new());
    assert_eq!(refuted(&atoms, &even(2)), Ok(()));
    assert!(refuted(&atoms, &even(1)).is_err());
    // Powers and several factors count: x > 0, y > 0, −x²y > 0.
    let square = times(&times(&x(), &x()), &y());
    let atoms = [positive(x()), positive(y()), positive(square.neg())];
    let with = |a, b| {
        sum(vec![term(1, n(1), vec![(0, a), (1, b)]), term(1, n(1), vec![(2, 1)])], Vec::new())
    };
    assert_eq!(refuted(&atoms, &with(2, 1)), Ok(()));
    assert!(refuted(&atoms, &with(1, 1)).is_err());
    assert!(refuted(&atoms, &with(2, 2)).is_err());
}

#[test]
fn only_an_equation_has_a_cofactor() {
    for (atom, sound) in [
        (equal(n(1)), true),
        (distinct(n(1)), false),
        (at_least(n(1)), false),
        (positive(n(1)), false),
    ] {
        assert_eq!(refuted(&[atom], &one_is_zero(0)).is_ok(), sound);
    }
}

#[test]
fn an_index_points_into_the_state() {
    let atoms = [at_least(n(-1))];
    assert_eq!(refuted(&atoms, &minus_one(0)), Ok(()));
    assert_eq!(refuted(&atoms, &minus_one(1)), Err(Rejection::NoSuchAtom(1)));
    assert_eq!(refuted(&atoms, &one_is_zero(1)), Err(Rejection::NoSuchAtom(1)));
    let assume = |formula| Proof::Assume { formula, cases: Vec::new() };
    assert_eq!(closed(&[], vec![Vec::new()], &assume(0)), Ok(()));
    assert_eq!(closed(&[], vec![Vec::new()], &assume(1)), Err(Rejection::NoSuchFormula(1)));
    assert_eq!(closed(&[], Vec::new(), &assume(0)), Err(Rejection::NoSuchFormula(0)));
}

#[test]
fn every_case_of_a_formula_has_a_proof() {
    // −1 ≥ 0 or 1 = 0, after an atom that keeps its place.
    let formula = || vec![vec![at_least(n(-1))], vec![equal(n(1))]];
    let atoms = [positive(x())];
    let judge = |cases| closed(&atoms, vec![formula()], &Proof::Assume { formula: 0, cases });
    assert_eq!(judge(vec![minus_one(1), one_is_zero(1)]), Ok(()));
    assert!(judge(vec![one_is_zero(1), minus_one(1)]).is_err(), "in the order of the cases");
    assert!(judge(vec![minus_one(1), nothing()]).is_err(), "the last");
    assert!(judge(vec![nothing(), one_is_zero(1)]).is_err(), "the first");
    assert!(judge(vec![minus_one(0), one_is_zero(0)]).is_err(), "cases come after the atoms");
    assert_eq!(judge(vec![minus_one(1)]), Err(Rejection::CaseCount(2, 1)));
    assert_eq!(judge(Vec::new()), Err(Rejection::CaseCount(2, 0)));
    let three = vec![minus_one(1), one_is_zero(1), minus_one(1)];
    assert_eq!(judge(three), Err(Rejection::CaseCount(2, 3)));
    // All atoms of a case are known: x ≥ 0 and −x − 1 ≥ 0.
    let pair = vec![vec![at_least(x()), at_least(x().neg().sub(&n(1)))]];
    let terms =
        vec![term(1, n(1), vec![(0, 1)]), term(1, n(1), vec![(1, 1)]), term(1, n(1), Vec::new())];
    let proof = Proof::Assume { formula: 0, cases: vec![sum(terms, Vec::new())] };
    assert_eq!(closed(&[], vec![pair], &proof), Ok(()));
}

#[test]
fn a_split_speaks_of_the_polynomial_and_of_its_opposite() {
    // From −x − 1 ≥ 0 the cases x > 0 and x = 0 are refuted, x < 0 is not.
    let atoms = [at_least(x().neg().sub(&n(1)))];
    let one = || term(1, n(1), Vec::new());
    let known = || term(1, n(1), vec![(0, 1)]);
    let case = |opposite, sign, then| Case { opposite, sign, then };
    let above = || sum(vec![known(), term(1, n(1), vec![(1, 1)]), one()], Vec::new());
    let zero = || sum(vec![known(), one()], vec![(1, n(1))]);
    let last = |opposite, sign, then| Proof::Split {
        poly: x(),
        cases: vec![
            case(false, Sign::Positive, above()),
            case(false, Sign::Zero, zero()),
            case(opposite, sign, then),
        ],
    };
    assert!(refuted(&atoms, &last(true, Sign::Positive, above())).is_err());
    assert_eq!(refuted(&atoms, &last(false, Sign::Positive, above())), Err(Rejection::SignLeftOut));
    assert_eq!(
        refuted(&atoms, &last(false, Sign::NonNegative, above())),
        Err(Rejection::SignLeftOut)
    );
    assert_eq!(refuted(&atoms, &last(true, Sign::Zero, zero())), Err(Rejection::SignLeftOut));
    // A wider case has to be refuted as widely as it is stated: x ≥ 0 is not known to be x > 0.
    let wide = |sign| Proof::Split {
        poly: x(),
        cases: vec![
            case(false, sign, sum(vec![term(1, n(1), vec![(0, 1)])], vec![])),
            case(true, Sign::NonNegative, nothing()),
        ],
    };
    assert!(refuted(&[], &wide(Sign::NonNegative)).is_err());
}

#[test]
fn a_passage_is_taken_only_where_it_is_allowed() {
    assert!(Passages::Anywhere.allow(0) && Passages::Anywhere.allow(1));
    assert!(Passages::Along(1).allow(1) && !Passages::Along(1).allow(0));
    assert!(!Passages::Nowhere.allow(0) && !Passages::Nowhere.allow(1));
}

#[test]
fn a_budget_is_spent_and_ends() {
    let fuel = Fuel::new(10);
    let twin = fuel.clone();
    assert_eq!(fuel.spend(4), Ok(()));
    assert_eq!(twin.spend(6), Ok(()), "clones share it");
    assert_eq!(fuel.spend(1), Err(Rejection::Budget));
    assert_eq!(Fuel::new(3).spend(4), Err(Rejection::Budget));
    // Steps of a proof, products and the reading of a statement are paid for.
    let goal = plain();
    let scope = scope(&goal, Fuel::new(1)).expect("nothing to read");
    let proof =
        Proof::Assume { formula: 0, cases: vec![Proof::Assume { formula: 0, cases: Vec::new() }] };
    let state = State {
        scope: &scope,
        goal: &goal,
        atoms: Vec::new(),
        formulas: vec![vec![Vec::new()]].into(),
        reaching: false,
        passages: Passages::Nowhere,
    };
    assert_eq!(state.refute(&proof), Err(Rejection::Budget));
    let two = x().add(&y());
    assert_eq!(two.mul(&two, &Fuel::new(3)), Err(Rejection::Budget));
    assert!(two.mul(&two, &Fuel::new(4)).is_ok());
    assert_eq!(two.pow(40, &Fuel::new(500)), Err(Rejection::Budget));
    let big = n(i64::MAX);
    assert_eq!(times(&big, &big).mul(&big, &Fuel::new(1)), Err(Rejection::Budget), "words count");
    let tower = Goal { when: vec![relation(deep(200), Rel::Eq, number(0, 1))], ..plain() };
    assert!(matches!(kane_kernel::scope(&tower, Fuel::new(100)), Err(Rejection::Budget)));
    let nothing_left = Fuel::new(1);
    let atoms: Vec<_> =
        (0..4).map(|v| relation(number(v, 1), Rel::Ne, kane_kernel::Expr::Var(0))).collect();
    let scope = kane_kernel::scope(&goal, nothing_left).expect("nothing to read");
    assert!(matches!(scope.all(&atoms), Err(Rejection::Budget)), "joining regions is paid for");
}

#[test]
fn a_budget_within_another_is_spent_of_both_and_ends_with_either() {
    let whole = Fuel::new(10);
    let (part, other) = (whole.within(6), whole.within(100));
    assert_eq!(part.spend(4), Ok(()));
    assert_eq!((part.left(), other.left(), whole.left()), (2, 6, 6));
    // What a part does not have, it does not take of the whole.
    assert_eq!(part.spend(50), Err(Rejection::Budget));
    assert_eq!((part.left(), whole.left()), (0, 4));
    assert_eq!(other.spend(5), Err(Rejection::Budget), "the whole has less");
    assert_eq!((other.left(), whole.left()), (0, 0));
}

#[test]
fn work_beyond_a_budget_is_taken_of_the_whole_alone() {
    let whole = Fuel::new(10);
    let part = whole.within(6);
    assert_eq!(part.spend_beyond(3), Ok(()));
    assert_eq!((part.left(), whole.left()), (6, 7));
    assert_eq!(part.beside(2).spend(2), Ok(()), "what is beside a part is of the same whole");
    assert_eq!((part.left(), whole.left()), (5, 5));
    assert_eq!(part.spend_beyond(6), Err(Rejection::Budget));
    assert_eq!(Fuel::new(1).spend_beyond(9), Ok(()), "what is no part has nothing beyond it");
    assert_eq!(Fuel::new(1).beside(4).left(), 4);
}

/// −(−(… x))
fn deep(depth: usize) -> kane_kernel::Expr {
    (0..depth).fold(kane_kernel::Expr::Var(0), |e, _| kane_kernel::Expr::Neg(e.into()))
}

#[test]
fn a_check_that_runs_out_of_its_budget_accepts_nothing() {
    let goal = Goal { when: vec![relation(deep(40), Rel::Ne, deep(40))], ..plain() };
    let proof = || Evidence::Contradiction(Proof::Assume { formula: 0, cases: Vec::new() });
    assert_eq!(judged(&goal, Finding::Proved, proof()), Ok(()));
    let certificate = kane_kernel::Certificate {
        goal: kane_kernel::digest(&goal),
        finding: Finding::Proved,
        evidence: proof(),
    };
    assert_eq!(kane_kernel::check(&goal, &certificate, Fuel::new(20)), Err(Rejection::Budget));
}
