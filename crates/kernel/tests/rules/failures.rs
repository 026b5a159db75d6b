//! Functions as witnesses about limits: another limit, or one that is reached.

use kane_kernel::{
    Approach, Certificate, Checked, Conclusion, Evidence, Expr, Failure, Finding, Goal, Limit,
    Link, Model, Poly, Proof, Rejection, Rel, Sentence, Side, Sign, State, Target, check,
    claim_state, digest, scope, unequal,
};

use crate::functions::{C, Ends, K, at, far, functions, hyperbola, inverse, judge, tends};
use crate::support::{
    X, abs, add, bound, given, limit, link, mul, n, nothing, number, plenty, pow, q, relation,
    side, sqrt, term, var,
};

/// k → 1 as x → ∞ from k·x = 1 and x > 0, under a condition on c.
fn tending(value: Target, at: Approach, when: i64) -> Goal {
    let mut goal = hyperbola();
    goal.context.vars[K].lower = None;
    goal.hypotheses.remove(2);
    goal.when = vec![relation(var(C), Rel::Eq, number(when, 1))];
    goal.conclusion = Conclusion::Link(Link::Limit(limit(var(K), value, at)));
    goal
}

fn other(target: Target, link: usize, at: Approach, ends: Ends) -> impl Fn(&Goal) -> Failure {
    move |domain| {
        let l = limit(var(K), target.clone(), at.clone());
        let proof = tends(domain, &l, ends.clone());
        Failure::Limit { link, target: target.clone(), proof, apart: None }
    }
}

#[test]
fn a_limit_is_refuted_by_another_limit_from_one_of_its_sides() {
    let finite = |a, b| Target::Finite(number(a, b));
    let zero = |link| other(finite(0, 1), link, Approach::PlusInf, far(1).remove(0));
    let fails = |goal: &Goal, failure: &dyn Fn(&Goal) -> Failure| {
        judge(goal, Finding::Refuted, &functions(goal, inverse(1), &[], failure))
    };
    let infinity = || Approach::PlusInf;
    assert_eq!(fails(&tending(finite(1, 1), infinity(), 1), &zero(0)), Ok(()));
    assert_eq!(fails(&tending(Target::PlusInf, infinity(), 1), &zero(0)), Ok(()));
    let goal = tending(finite(0, 1), infinity(), 1);
    assert_eq!(fails(&goal, &zero(0)), Err(Rejection::NotAModel(None)), "it is the claimed one");
    let same = Target::Finite(mul(number(0, 1), number(3, 1)));
    let goal = tending(same, infinity(), 1);
    assert_eq!(fails(&goal, &zero(0)), Err(Rejection::NotAModel(None)), "written otherwise");
    let goal = tending(finite(1, 1), infinity(), 2);
    assert_eq!(fails(&goal, &zero(0)), Err(Rejection::NotAModel(None)), "its condition is not met");
    let goal = tending(finite(1, 1), infinity(), 1);
    assert_eq!(fails(&goal, &zero(1)), Err(Rejection::WrongEvidence), "no such link");
    let goal = tending(finite(1, 1), Approach::To(q(1, 1)), 1);
    assert_eq!(fails(&goal, &zero(0)), Err(Rejection::OutsideDomain), "not one of its sides");
    // One of two sides is enough: 1/x → 1/2 as x → 2−.
    let t = Poly::var(3);
    let below = || (side(Some(q(2, 1)), false), n(1), n(2).sub(&t), 0);
    let half = other(finite(1, 2), 0, Approach::Below(q(2, 1)), below());
    let goal = tending(finite(1, 1), Approach::To(q(2, 1)), 1);
    assert_eq!(fails(&goal, &half), Ok(()));
    let goal = tending(finite(1, 1), Approach::Above(q(2, 1)), 1);
    assert_eq!(fails(&goal, &half), Err(Rejection::OutsideDomain));
    // At −∞ the functions need not satisfy anything.
    let goal = tending(finite(1, 1), Approach::MinusInf, 1);
    let left = (side(None, false), t.neg(), n(1), 0);
    assert!(fails(&goal, &other(finite(0, 1), 0, Approach::MinusInf, left)).is_err());
    // The other limit has to be one.
    let goal = tending(finite(1, 1), infinity(), 1);
    let wrong = other(finite(5, 1), 0, infinity(), (side(None, true), n(5), n(1), 0));
    assert!(fails(&goal, &wrong).is_err());
    let f = functions(&goal, inverse(1), &[], &zero(0));
    for finding in [Finding::Proved, Finding::IllDefined, Finding::Consistent, Finding::Vacuous] {
        assert_eq!(judge(&goal, finding, &f), Err(Rejection::WrongEvidence), "{finding:?}");
    }
    // A limit is no matter of a point.
    let f = functions(&goal, inverse(1), &[], &at(q(2, 1)));
    assert_eq!(judge(&goal, Finding::Refuted, &f), Err(Rejection::NeedsFunctions));
}

#[test]
fn a_limit_that_does_not_follow_is_another_one_under_its_own_condition() {
    let l = limit(var(K), Target::Finite(number(1, 1)), Approach::PlusInf);
    let goal = |c| {
        let when = vec![relation(var(C), Rel::Eq, number(c, 1))];
        let sentence = Sentence { when, links: vec![Link::Limit(l.clone())] };
        let conclusion = Conclusion::NotImplied(sentence);
        Goal { conclusion, when: Vec::new(), ..tending(Target::PlusInf, Approach::PlusInf, 1) }
    };
    let zero = other(Target::Finite(number(0, 1)), 0, Approach::PlusInf, far(1).remove(0));
    let fails =
        |goal: &Goal| judge(goal, Finding::Proved, &functions(goal, inverse(1), &[], &zero));
    assert_eq!(fails(&goal(1)), Ok(()));
    assert_eq!(fails(&goal(2)), Err(Rejection::NotAModel(None)));
    let f = functions(&goal(1), inverse(1), &[], &zero);
    assert_eq!(judge(&goal(1), Finding::Refuted, &f), Err(Rejection::WrongEvidence));
}

#[test]
fn hypotheses_of_a_limit_are_consistent_if_the_domain_reaches_it() {
    let reaches = |goal: &Goal, at: &[Side]| {
        let failure = |domain: &Goal| {
            let Conclusion::Link(Link::Limit(l)) = &goal.conclusion else {
                unreachable!("a limit");
            };
            let zero = Limit { expr: number(0, 1), to: Target::Finite(number(0, 1)), ..l.clone() };
            let domain = Goal { when: goal.when.clone(), ..domain.clone() };
            let proof = |s: &Side| tends(&domain, &zero, (s.clone(), n(0), n(1), 0));
            Failure::Reaches(at.iter().map(proof).collect())
        };
        judge(goal, Finding::Consistent, &functions(goal, inverse(1), &[], &failure))
    };
    let to = || Target::Finite(number(1, 1));
    let up = side(None, true);
    assert_eq!(reaches(&tending(to(), Approach::PlusInf, 1), &[up]), Ok(()));
    assert!(reaches(&tending(to(), Approach::PlusInf, 1), &[]).is_err());
    assert!(reaches(&tending(to(), Approach::MinusInf, 1), &[side(None, false)]).is_err());
    let never = reaches(&tending(to(), Approach::PlusInf, 2), &[side(None, true)]);
    assert_eq!(never, Err(Rejection::NotAModel(None)), "its own condition is not met");
}

/// c·2 → L as x → ∞, where c = 1, refuted by the limit 2: the targets are told apart as `apart` says.
fn refuted_by_two(to: &Expr, apart: &dyn Fn(&Goal) -> Option<Proof>) -> Checked {
    let goal = tending(Target::Finite(to.clone()), Approach::PlusInf, 1);
    let target = Target::Finite(number(2, 1));
    let ends = (side(None, true), n(2), n(1), 0);
    let mut goal =
        Goal { hypotheses: vec![given(vec![link(var(C), Rel::Eq, number(1, 1))])], ..goal };
    let Conclusion::Link(Link::Limit(l)) = &mut goal.conclusion else {
        unreachable!("a limit");
    };
    l.expr = add(mul(number(0, 1), var(K)), mul(var(C), number(2, 1)));
    let expr = l.expr.clone();
    let failure = |domain: &Goal| {
        let l = limit(expr.clone(), target.clone(), Approach::PlusInf);
        let proof = tends(domain, &l, ends.clone());
        Failure::Limit {
            link: 0,
            target: target.clone(),
            proof,
            apart: apart(domain).map(Box::new),
        }
    };
    let f = functions(&goal, vec![(K, abs(pow(var(X), 2))), (C, number(1, 1))], &[], &failure);
    judge(&goal, Finding::Refuted, &f)
}

#[test]
fn targets_that_are_not_visibly_different_refute_nothing() {
    // √2·√2 is 2, which no normal form shows.
    let root = || sqrt(number(2, 1));
    let verdict = refuted_by_two(&mul(root(), root()), &|_| None);
    assert_eq!(verdict, Err(Rejection::NotAModel(None)));
}

#[test]
fn targets_that_a_proof_tells_apart_refute() {
    let root = sqrt(number(2, 1));
    assert_eq!(refuted_by_two(&root, &|_| None), Err(Rejection::NotAModel(None)), "not visible");
    // √2 = 2 and √2² = 2 give 2 = 4
    let claimed = Target::Finite(root.clone());
    let apart = |domain: &Goal| {
        let conclusion = unequal(&claimed, &Target::Finite(number(2, 1))).expect("numbers");
        let goal = Goal { conclusion, ..domain.clone() };
        let scope = scope(&goal, plenty()).expect("it is small");
        let state = claim_state(&scope, &goal, Finding::Proved).expect("it is small");
        let by = state.formulas.len() - 1;
        let cases = state.assume(by).expect("the claim fails");
        let told = |case: &State<'_, '_>| {
            let r = Poly::var(domain.context.vars.len());
            let equations: Vec<usize> =
                (0..case.atoms.len()).filter(|&i| case.atoms[i].sign == Sign::Zero).collect();
            let square = |i: &&usize| case.atoms[**i].poly.degree(domain.context.vars.len()) == 2;
            let cofactor = |i: &usize| match square(&i) {
                true => (*i, n(-1)),
                false => (*i, r.add(&n(2))),
            };
            let cofactors = equations.iter().map(cofactor).collect();
            Proof::Positive { terms: vec![term(2, n(1), vec![])], cofactors }
        };
        Proof::Assume { formula: by, cases: cases.iter().map(told).collect() }
    };
    assert_eq!(refuted_by_two(&root, &|domain| Some(apart(domain))), Ok(()));
    let other = sqrt(number(4, 1));
    assert!(refuted_by_two(&other, &|domain| Some(apart(domain))).is_err(), "√4 is 2");
    assert!(refuted_by_two(&root, &|_| Some(nothing())).is_err(), "that is no proof");
}

#[test]
fn a_digest_is_for_one_goal() {
    let goal = hyperbola();
    let changed = |change: &dyn Fn(&mut Goal)| {
        let mut other = goal.clone();
        change(&mut other);
        digest(&other)
    };
    let digests = [
        digest(&goal),
        changed(&|g| g.context.vars[C].name = "d".to_string()),
        changed(&|g| g.context.vars[K].lower = None),
        changed(&|g| g.context.vars[K].lower = bound(q(0, 1), false)),
        changed(&|g| g.hypotheses[0].given = false),
        changed(&|g| g.hypotheses.reverse()),
        changed(&|g| g.behind = vec![g.hypotheses[0].sentence.clone()]),
        changed(&|g| g.when.clear()),
        changed(&|g| g.conclusion = Conclusion::Contradiction),
    ];
    let different: std::collections::BTreeSet<u128> = digests.into_iter().collect();
    assert_eq!(different.len(), digests.len());
    assert_eq!(changed(&|_| ()), digests[0]);
    let evidence = Evidence::Model(Model::Functions(
        functions(&goal, inverse(1), &far(1), &at(q(2, 1))).into(),
    ));
    for (named, wanted) in digests.iter().zip([true].iter().chain(std::iter::repeat(&false))) {
        let evidence = evidence.clone();
        let certificate = Certificate { goal: *named, finding: Finding::Refuted, evidence };
        assert_eq!(check(&goal, &certificate, plenty()).is_ok(), *wanted);
    }
}
