//! Certificates of what is false, forged in each place that a certificate has.

use std::cmp::Ordering;

use kane_kernel::{
    Approach, Bound, Certificate, Conclusion, Definition, Evidence, Expr, Failure, Finding, Fuel,
    Functions, Germ, Goal, Hypothesis, Inside, Link, Model, Point, Poly, Proof, Rejection, Rel,
    Sentence, SideProof, Target, check, digest,
};
use num_bigint::BigInt;

use crate::support::{
    Q, X, Y, cited, div, equal, given, judged, limit, link, n, nothing, number, plain, q, relation,
    root, side, term, var, with_function,
};

#[test]
fn a_certificate_is_for_one_goal_and_one_finding() {
    let goal = Goal { when: vec![relation(number(1, 1), Rel::Lt, number(0, 1))], ..plain() };
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

/// Numbers that are not in lowest terms with a positive denominator.
fn broken() -> Vec<Q> {
    let raw = |n: i64, d: i64| Q::new_raw(BigInt::from(n), BigInt::from(d));
    vec![raw(1, 0), raw(0, 0), raw(-1, 0), raw(1, -1), raw(-1, -2), raw(2, 2), raw(0, 5), raw(6, 4)]
}

/// Puts a number into one place of a goal.
type Change<'a> = Box<dyn Fn(&mut Goal) + 'a>;

/// Whether evidence is refused at the door.
fn refused(goal: &Goal, finding: Finding, evidence: Evidence) -> bool {
    judged(goal, finding, evidence) == Err(Rejection::NotCanonical)
}

#[test]
fn numbers_of_a_statement_are_canonical() {
    let proof = || Evidence::Contradiction(Proof::Assume { formula: 0, cases: Vec::new() });
    for bad in broken() {
        let num = || Expr::Num(bad.clone());
        let bad_link = || link(var(X), Rel::Eq, Expr::Neg(num().into()));
        let list = |links| Sentence { when: Vec::new(), links };
        let under = Sentence { when: vec![relation(num(), Rel::Eq, num())], links: Vec::new() };
        let tends = |e: Expr, to: Expr, at| Link::Limit(limit(e, Target::Finite(to), at));
        let end = || Some(Bound { value: bad.clone(), strict: false });
        let places: Vec<Change<'_>> = vec![
            Box::new(|g| g.context.vars[Y].lower = end()),
            Box::new(|g| g.context.vars[X].upper = end()),
            Box::new(|g| g.context.lets = vec![Definition { name: "a".into(), body: num() }]),
            Box::new(|g| g.hypotheses = vec![given(vec![bad_link()])]),
            Box::new(|g| g.hypotheses = vec![Hypothesis { sentence: under.clone(), given: true }]),
            Box::new(|g| g.behind = vec![list(vec![bad_link()])]),
            Box::new(|g| g.behind = vec![under.clone()]),
            Box::new(|g| g.when = vec![relation(num(), Rel::Ne, num())]),
            Box::new(|g| g.when = vec![relation(var(X), Rel::Ne, num())]),
            Box::new(|g| g.conclusion = Conclusion::Link(bad_link())),
            Box::new(|g| g.conclusion = Conclusion::NotImplied(list(vec![bad_link()]))),
            Box::new(|g| g.conclusion = Conclusion::NotImplied(under.clone())),
            Box::new(|g| g.hypotheses = vec![given(vec![tends(num(), var(Y), Approach::PlusInf)])]),
            Box::new(|g| g.hypotheses = vec![given(vec![tends(var(X), num(), Approach::PlusInf)])]),
            Box::new(|g| {
                g.behind = vec![list(vec![tends(var(X), var(Y), Approach::To(bad.clone()))])]
            }),
            Box::new(|g| {
                g.conclusion =
                    Conclusion::Link(tends(var(X), var(Y), Approach::Above(bad.clone())));
            }),
            Box::new(|g| {
                g.hypotheses =
                    vec![given(vec![tends(var(X), var(Y), Approach::Below(bad.clone()))])]
            }),
        ];
        for (i, place) in places.iter().enumerate() {
            let mut goal = plain();
            place(&mut goal);
            assert!(refused(&goal, Finding::Proved, proof()), "{bad:?} in place {i}");
        }
    }
}

/// A germ with a number in one place.
fn germs(bad: &Q) -> Vec<Germ> {
    let germ = || Germ {
        power: 1,
        side: side(Some(q(0, 1)), true),
        radius: (n(1), n(1)),
        positive: nothing().into(),
        inside: vec![Inside { values: vec![(Y, number(1, 1))], proof: nothing() }],
    };
    let mut out = vec![germ(), germ()];
    out[0].side.at = Some(bad.clone());
    out[1].inside[0].values[0].1 = Expr::Num(bad.clone());
    let nested = |inner: &Germ| {
        let pass = || passing(inner.clone());
        let (mut positive, mut inside) = (germ(), germ());
        positive.positive = Box::new(pass());
        inside.inside[0].proof = pass();
        [positive, inside]
    };
    let inner = out[0].clone();
    out.extend(nested(&inner));
    out
}

fn passing(germ: Germ) -> Proof {
    Proof::Pass { germ, atom: equal(n(0)), along: nothing().into(), then: nothing().into() }
}

/// A proof with a germ in one place.
fn proofs(germ: &Germ) -> Vec<Proof> {
    let pass = || passing(germ.clone());
    let inside = |change: &dyn Fn(&mut Proof, &mut Proof)| {
        let good = germs(&q(0, 1)).remove(0);
        let (mut along, mut then) = (nothing(), nothing());
        change(&mut along, &mut then);
        Proof::Pass { germ: good, atom: equal(n(0)), along: along.into(), then: then.into() }
    };
    let case = kane_kernel::Case { opposite: false, sign: kane_kernel::Sign::Zero, then: pass() };
    vec![
        pass(),
        Proof::Assume { formula: 0, cases: vec![nothing(), pass()] },
        Proof::Split { poly: n(1), cases: vec![case] },
        inside(&|along, _| *along = pass()),
        inside(&|_, then| *then = pass()),
    ]
}

/// Side proofs with a number in one place.
fn side_proofs(bad: &Q) -> Vec<SideProof> {
    let good = || SideProof {
        germ: germs(&q(0, 1)).remove(0),
        num: n(0),
        den: n(1),
        order: 0,
        sense: Ordering::Equal,
        upper: None,
        along: nothing().into(),
        at_zero: nothing().into(),
    };
    let inner = germs(bad).remove(0);
    let mut out: Vec<SideProof> =
        germs(bad).into_iter().map(|germ| SideProof { germ, ..good() }).collect();
    out.push(SideProof { along: passing(inner.clone()).into(), ..good() });
    out.push(SideProof { at_zero: passing(inner).into(), ..good() });
    let upper = |proof: &SideProof| SideProof { upper: Some(proof.clone().into()), ..good() };
    let above: Vec<_> = out.iter().map(upper).collect();
    out.push(upper(&above[0]));
    out.extend(above);
    out
}

#[test]
fn numbers_of_a_certificate_are_canonical() {
    let l = limit(var(X), Target::Finite(number(5, 1)), Approach::Above(q(0, 1)));
    let tends = Goal { conclusion: Conclusion::Link(Link::Limit(l)), ..with_function() };
    for bad in broken() {
        for proof in germs(&bad).iter().flat_map(proofs) {
            let evidence = Evidence::Contradiction(proof.clone());
            assert!(refused(&plain(), Finding::Proved, evidence), "{proof:?}");
        }
        for proof in side_proofs(&bad) {
            let evidence = Evidence::Limit(vec![proof.clone()]);
            assert!(refused(&tends, Finding::Proved, evidence.clone()), "{proof:?}");
            let (opposite, sign) = (false, kane_kernel::Sign::Zero);
            let cases = vec![kane_kernel::Case { opposite, sign, then: evidence }];
            let split = Evidence::Split { poly: n(1), cases };
            assert!(refused(&tends, Finding::Proved, split), "{proof:?}");
        }
        let simple = || root(&[-2, 0, 1], q(1, 1), q(2, 1));
        let at = |values, generator| Point { generator, values };
        let (mut low, mut high) = (simple(), simple());
        low.lo = bad.clone();
        high.hi = bad.clone();
        let points = || {
            vec![
                at(vec![(X, vec![bad.clone()])], None),
                at(vec![(Y, vec![q(1, 1)]), (X, vec![q(0, 1), bad.clone()])], Some(simple())),
                at(vec![(X, vec![q(0, 1)])], Some(low.clone())),
                at(vec![(X, vec![q(0, 1)])], Some(high.clone())),
            ]
        };
        for point in points() {
            let evidence = Evidence::Model(Model::Point(point.clone()));
            assert!(refused(&plain(), Finding::Refuted, evidence), "{point:?}");
        }
        let good = || Functions {
            var: X,
            values: Vec::new(),
            ranges: Vec::new(),
            premises: Vec::new(),
            failure: Failure::Reaches(Vec::new()),
        };
        let germ = germs(&bad).remove(0);
        let mut forged: Vec<Functions> = points()
            .into_iter()
            .map(|point| Functions { failure: Failure::At(point), ..good() })
            .collect();
        let proof = || side_proofs(&bad).remove(0);
        let another = |target, proof| Failure::Limit { link: 0, target, proof, apart: None };
        let apart = |proof| {
            let (target, side) = (Target::Finite(Expr::int(1)), side_proofs(&q(0, 1)).remove(0));
            Failure::Limit { link: 0, target, proof: side, apart: Some(Box::new(proof)) }
        };
        let num = Target::Finite(Expr::Num(bad.clone()));
        forged.extend([
            Functions { values: vec![(Y, Expr::Abs(Expr::Num(bad.clone()).into()))], ..good() },
            Functions { ranges: vec![passing(germ.clone())], ..good() },
            Functions { failure: apart(passing(germ.clone())), ..good() },
            Functions { premises: vec![(passing(germ), Vec::new())], ..good() },
            Functions { premises: vec![(nothing(), vec![vec![proof()]])], ..good() },
            Functions { failure: Failure::Reaches(vec![proof()]), ..good() },
            Functions { failure: another(num, side_proofs(&q(0, 1)).remove(0)), ..good() },
            Functions { failure: another(Target::PlusInf, proof()), ..good() },
        ]);
        for f in forged {
            let evidence = Evidence::Model(Model::Functions(f.clone().into()));
            assert!(refused(&tends, Finding::Refuted, evidence), "{f:?}");
        }
    }
    // The same evidence with good numbers is let in, and refused for what it says.
    for proof in side_proofs(&q(3, 4)) {
        let verdict = judged(&tends, Finding::Proved, Evidence::Limit(vec![proof]));
        assert!(!matches!(verdict, Ok(()) | Err(Rejection::NotCanonical)));
    }
}

#[test]
fn a_value_that_is_no_number_satisfies_nothing() {
    // x² < 0 by x = 1/0, x = 0/0, and x between 0 and 1 by a root in (0/−1, 1/−1).
    let square = crate::support::pow(var(X), 2);
    let goal = Goal { when: vec![relation(square, Rel::Lt, number(0, 1))], ..plain() };
    for value in broken() {
        let point = Point { generator: None, values: vec![(X, vec![value.clone()])] };
        let verdict = judged(&goal, Finding::Refuted, Evidence::Model(Model::Point(point)));
        assert_eq!(verdict, Err(Rejection::NotCanonical), "{value:?}");
    }
}

#[test]
fn a_monomial_written_otherwise_is_no_other_monomial() {
    // x·y − y·x = 0 and x·x − x² = 0 as products, so neither is a summand that is not zero.
    let term = |m: &[(usize, u32)]| kane_kernel::Poly::term(m.to_vec(), 1.into());
    for (a, b) in [
        (term(&[(X, 1), (Y, 1)]), term(&[(Y, 1), (X, 1)])),
        (term(&[(X, 1), (X, 1)]), term(&[(X, 2)])),
        (term(&[(X, 0)]), n(1)),
        (term(&[(Y, 1), (X, 1), (Y, 2)]), term(&[(X, 1), (Y, 3)])),
    ] {
        assert!(a.sub(&b).is_empty());
        let fuel = Fuel::new(1000);
        let other = kane_kernel::Poly::var(Y).add(&kane_kernel::Poly::var(X));
        assert_eq!(a.mul(&other, &fuel), b.mul(&other, &fuel));
        assert_eq!(other.mul(&a, &fuel), other.mul(&b, &fuel));
    }
}

/// 1/x = 1/x, which is nowhere false, and undefined at 0.
fn itself() -> Link {
    let inverse = || div(number(1, 1), var(X));
    link(inverse(), Rel::Eq, inverse())
}

/// x ≠ 0 as atom 0 and x = 0 as atom 1 contradict each other.
fn zero_or_not() -> Proof {
    Proof::Positive {
        terms: vec![term(1, n(1), vec![(0, 2)])],
        cofactors: vec![(1, Poly::var(X).neg())],
    }
}

fn at_point(x: i64) -> Evidence {
    Evidence::Model(Model::Point(Point { generator: None, values: vec![(X, vec![q(x, 1)])] }))
}

#[test]
fn nothing_is_shown_to_hold_where_it_is_undefined() {
    let sentence = Sentence { when: Vec::new(), links: vec![itself()] };
    // As a claim, which is proved, and as what is said not to follow, which is refuted.
    for (conclusion, holds, undefined) in [
        (Conclusion::Link(itself()), Finding::Proved, Finding::IllDefined),
        (Conclusion::NotImplied(sentence), Finding::Refuted, Finding::Proved),
    ] {
        let goal = Goal { conclusion, ..plain() };
        let never = Proof::Assume { formula: 1, cases: Vec::new() };
        let verdict = judged(&goal, holds, Evidence::Contradiction(never));
        assert_eq!(verdict, Err(Rejection::CaseCount(1, 0)), "it fails at 0");
        assert_eq!(judged(&goal, undefined, at_point(0)), Ok(()));
        assert!(judged(&goal, undefined, at_point(1)).is_err());
        let when = vec![relation(var(X), Rel::Ne, number(0, 1))];
        let elsewhere = Goal { when, ..goal };
        let fails = Proof::Assume { formula: 1, cases: vec![zero_or_not()] };
        let proof = Proof::Assume { formula: 0, cases: vec![fails] };
        assert_eq!(judged(&elsewhere, holds, Evidence::Contradiction(proof)), Ok(()));
        assert!(judged(&elsewhere, undefined, at_point(0)).is_err());
    }
}

#[test]
fn a_citation_does_not_show_that_it_is_defined() {
    let claim = |given: bool| Goal {
        hypotheses: vec![Hypothesis { given, ..cited(vec![itself()]) }],
        conclusion: Conclusion::Link(link(var(X), Rel::Ne, number(0, 1))),
        ..plain()
    };
    let fails = Proof::Assume { formula: 2, cases: vec![zero_or_not()] };
    let proof = Evidence::Contradiction(Proof::Assume { formula: 0, cases: vec![fails] });
    assert_eq!(judged(&claim(true), Finding::Proved, proof.clone()), Ok(()));
    assert_eq!(judged(&claim(false), Finding::Proved, proof), Err(Rejection::CaseCount(2, 1)));
    let missed = Err(Rejection::NotAModel(Some(0)));
    assert_eq!(judged(&claim(true), Finding::Refuted, at_point(0)), missed);
    assert_eq!(judged(&claim(false), Finding::Refuted, at_point(0)), Ok(()));
}

#[test]
fn evidence_of_one_kind_shows_no_finding_of_another() {
    let relation_claim = || Goal {
        conclusion: Conclusion::Link(link(var(X), Rel::Eq, var(X))),
        when: vec![relation(number(1, 1), Rel::Lt, number(0, 1))],
        ..plain()
    };
    let l = || limit(var(X), Target::Finite(number(0, 1)), Approach::PlusInf);
    let not_implied = |links| Conclusion::NotImplied(Sentence { when: Vec::new(), links });
    let conclusions = [
        relation_claim().conclusion,
        Conclusion::Link(Link::Limit(l())),
        Conclusion::Contradiction,
        not_implied(vec![link(var(X), Rel::Ne, var(X))]),
        not_implied(vec![Link::Limit(l())]),
    ];
    use Finding::{Consistent, IllDefined, Proved, Refuted, Vacuous};
    // By an impossible condition a contradiction shows all that speaks of every point.
    let proof = || Evidence::Contradiction(Proof::Assume { formula: 0, cases: Vec::new() });
    let wanted = [
        vec![Proved, Vacuous],
        vec![Vacuous],
        vec![Proved, Vacuous],
        vec![Refuted, Vacuous],
        vec![Vacuous],
    ];
    for (conclusion, wanted) in conclusions.iter().zip(wanted) {
        let goal = Goal { conclusion: conclusion.clone(), ..relation_claim() };
        for finding in [Proved, Refuted, IllDefined, Vacuous, Consistent] {
            let verdict = judged(&goal, finding, proof());
            assert_eq!(
                verdict.is_ok(),
                wanted.contains(&finding),
                "{conclusion:?} {finding:?} {verdict:?}"
            );
            let limits = judged(&goal, finding, Evidence::Limit(Vec::new()));
            assert!(limits.is_err(), "{conclusion:?} {finding:?}");
        }
    }
}

#[test]
fn a_rejection_says_in_its_own_words_what_can_be_mended() {
    let plain = Rejection::NotPositive.to_string();
    let told = [
        (Rejection::Budget, "budget"),
        (Rejection::OtherGoal, "another statement"),
        (Rejection::NotCanonical, "lowest terms"),
        (Rejection::EmptyRange(0), "empty range"),
        (Rejection::UnknownSymbol, "symbol that is not there"),
        (Rejection::NotExplicit, "derivative"),
        (Rejection::OutsideDomain, "limit"),
        (Rejection::NotAModel(None), "witness"),
    ];
    for (rejection, word) in told {
        let text = rejection.to_string();
        assert!(text.contains(word) && !plain.contains(word), "{rejection:?}: {text}");
    }
    assert!(plain.contains("a step of it does not hold"));
}
