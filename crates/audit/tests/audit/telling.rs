//! What is told of proofs is true: the sums, products and sides of steps are evaluated at points.

use kane_algebra::syntax::Evaluator;
use kane_audit::{Audit, Options, Proof, Standing, Step, Supposed, Variable, audit, read};
use kane_kernel::{Poly, Sign};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

type Q = BigRational;

const SHORT: &str = "\
var x, y, a > 0, b > 0, 0 <= e <= 1
let s := (x + y)^2
given g: a*x = b*y
given h: x != 0
claim sides: 1/(2*a)*(1 - (a - b)/(a + b)) = b/(a*(a + b))
claim solved: a*x + b*y = 2*b*y from g
claim bounds: (1 - e)*(1 + e)*a >= 0
claim corner: (a + 1)*(b + 2) > 2
claim factor: b*y != 0 from g, h
claim square: s >= 4*x*y
claim wrong: y < 0 from g expect refuted
claim cases: abs(x) >= x";

fn audited(name: &str, text: &str) -> Audit {
    let document = read(name, text.as_bytes()).expect("it is well formed");
    audit(document, &Options::default(), &mut |_, _| {})
}

fn proofs(audit: &Audit) -> Vec<(&Audit, Proof)> {
    let links = audit.judgements.iter().flat_map(|judgement| &judgement.links);
    links.map(|link| (audit, link.steps())).collect()
}

/// All steps, those inside others too.
fn all<'s>(steps: &'s [Step], out: &mut Vec<&'s Step>) {
    for step in steps {
        out.push(step);
        match step {
            Step::Suppose { then, .. } => all(then, out),
            Step::Cases { cases, .. } => cases.iter().for_each(|(_, then)| all(then, out)),
            Step::Split { zero, positive, negative, .. } => {
                [zero, positive, negative].into_iter().for_each(|then| all(then, out));
            }
            Step::Pass { otherwise, .. } | Step::LimitFrom { otherwise, .. } => all(otherwise, out),
            _ => {}
        }
    }
}

/// A point with no pattern in it: the powers of 3 modulo 101, less 50.
fn point(seed: u32) -> impl Fn(usize) -> BigInt {
    move |v| {
        let power = 3u32.pow(4).wrapping_mul(seed + 7) + u32::try_from(v).expect("small") * 31;
        BigInt::from(power * power % 101) - 50
    }
}

fn value(p: &Poly, at: &dyn Fn(usize) -> BigInt) -> BigInt {
    let power = |(v, n): &(usize, u32)| num_traits::pow(at(*v), *n as usize);
    p.terms().map(|(m, c)| m.iter().map(power).fold(c.clone(), |a, b| a * b)).sum()
}

/// Checks one step at one point, and says of which kind it was.
fn holds(step: &Step, at: &dyn Fn(usize) -> BigInt) -> Option<&'static str> {
    match step {
        Step::Multiple { atom: (weight, p), multiples } => {
            let sum: BigInt = multiples.iter().map(|(c, e)| value(c, at) * value(e, at)).sum();
            assert!(weight.is_positive());
            assert_eq!(weight * value(p, at), sum, "{step:?}");
            Some("multiple")
        }
        Step::SignsOfCoefficients { atom, sum: Some(sum), .. } => {
            let term = |(w, factors): &(BigInt, Vec<(Poly, u32)>)| {
                assert!(w.is_positive(), "{step:?}");
                let power = |(p, n): &(Poly, u32)| num_traits::pow(value(p, at), *n as usize);
                factors.iter().map(power).fold(w.clone(), |a, b| a * b)
            };
            let total: BigInt = sum.terms.iter().map(term).sum();
            let sign = if sum.negative { -BigInt::one() } else { BigInt::one() };
            assert_eq!(sign * &sum.scale * value(&atom.poly.primitive().1, at), total, "{step:?}");
            Some("bounded")
        }
        Step::SignsOfCoefficients { atom, .. } => {
            let signs: Vec<bool> = atom.poly.terms().map(|(_, c)| c.is_positive()).collect();
            // in the variables themselves, or with a change of sign that the bounds say
            assert!(!signs.is_empty());
            Some("signs")
        }
        Step::Factors { atom, factors } => {
            let power = |(f, n): &(kane_kernel::Atom, u32)| {
                num_traits::pow(value(&f.poly, at), *n as usize)
            };
            let product = factors.iter().map(power).fold(BigInt::one(), |a, b| a * b);
            let known = |f: &kane_kernel::Atom| matches!(f.sign, Sign::Positive | Sign::NonZero);
            assert!(factors.iter().all(|(f, _)| known(f)), "{step:?}");
            // proportional, with one number at all points: the atom vanishes where the product does
            assert_eq!(product.is_zero(), value(&atom.poly, at).is_zero(), "{step:?}");
            Some("factors")
        }
        Step::Positive { terms, multiples } => {
            let mut total = BigInt::zero();
            for t in terms {
                let power = |(p, n): &(Poly, u32)| num_traits::pow(value(p, at), *n as usize);
                let square = num_traits::pow(value(&t.square, at), 2);
                total += t.factors.iter().map(power).fold(&t.weight * square, |a, b| a * b);
            }
            total += multiples.iter().map(|(c, e)| value(c, at) * value(e, at)).sum::<BigInt>();
            assert!(total.is_zero(), "{step:?}");
            Some("positive")
        }
        Step::Clash(atoms) => {
            let base = atoms[0].poly.primitive().1;
            let same = |p: &Poly| *p == base || *p == base.neg();
            assert!(atoms.iter().all(|atom| same(&atom.poly.primitive().1)), "{step:?}");
            // no sign of the one polynomial satisfies all of them
            let fits = |s: i8| {
                atoms.iter().all(|atom| {
                    let turned = atom.poly.primitive().1 != base;
                    atom.sign.admits(if turned { -s } else { s })
                })
            };
            assert!(![-1, 0, 1].into_iter().any(fits), "{step:?}");
            Some("clash")
        }
        _ => None,
    }
}

#[test]
fn sums_and_products_that_are_told_are_so_at_points() {
    let paper = include_str!("../../../../docs/derivations/oblique-collision.md");
    let short = audited("short.md", &format!("```kane\n{SHORT}\n```\n"));
    let paper = audited("paper.md", paper);
    let mut seen = std::collections::BTreeMap::new();
    for (_, proof) in proofs(&short).into_iter().chain(proofs(&paper)) {
        let mut steps = Vec::new();
        all(&proof.steps, &mut steps);
        for step in steps {
            for seed in 0..3 {
                if let Some(kind) = holds(step, &point(seed)) {
                    *seen.entry(kind).or_insert(0) += 1;
                }
            }
        }
    }
    for kind in ["multiple", "bounded", "signs", "factors", "positive", "clash"] {
        assert!(seen.get(kind).is_some_and(|n| *n > 10), "{kind} is hardly told: {seen:?}");
    }
}

#[test]
fn sides_that_are_told_to_be_equal_are_so_at_points() {
    let audit = audited("short.md", &format!("```kane\n{SHORT}\n```\n"));
    let context = &audit.document.context;
    let proof = &proofs(&audit)[0].1;
    let [Step::Equal { sides, value: (num, den) }, Step::Suppose { .. }] = &proof.steps[..] else {
        panic!("{:?}", proof.steps);
    };
    for seed in 1..6 {
        let at = |v: usize| BigInt::from(2 + 3 * v + 5 * seed);
        let values: Vec<Q> = (0..context.vars.len()).map(|v| at(v).into()).collect();
        let mut evaluator = Evaluator::new(context, &values);
        let told = Q::new(value(num, &at), value(den, &at));
        assert_eq!(evaluator.value(&sides.0).expect("no pole"), told);
        assert_eq!(evaluator.value(&sides.1).expect("no pole"), told);
    }
}

#[test]
fn a_proof_does_not_tell_what_it_does_not_use() {
    let text = "```kane\nvar x, y, z\ngiven unused: y = z^2\ngiven used: x > 1\n\
                claim c: x^2 > x from unused, used\n```\n";
    let audit = audited("unused.md", text);
    let mut steps = Vec::new();
    let proof = &proofs(&audit)[0].1;
    all(&proof.steps, &mut steps);
    let told = steps.iter().filter(|step| matches!(step, Step::Assume { .. })).count();
    assert_eq!(told, 2, "the used premise and the failure of the claim: {steps:?}");
}

#[test]
fn a_witness_names_the_given_that_it_fails_and_that_would_do() {
    let text = "```kane\nvar x, y\ngiven positive: x > 0\ngiven other: y > 0\n\
                given below: x < -1\n\
                claim c: x + x^2 > 0 expect refuted\nclaim d: x*y > 0 from other expect refuted\n\
                claim e: x > y from positive expect refuted\n\
                claim f: x > 1 from below expect refuted\n```\n";
    let audit = audited("given.md", text);
    let statement = |label: &str| {
        let mut all = audit.document.statements.iter();
        all.position(|s| s.label == label).expect("it is there")
    };
    let would_do = |label: &str| audit.judgements[statement(label)].links[0].would_do;
    assert_eq!(would_do("c"), Some(statement("positive")));
    assert_eq!(would_do("d"), Some(statement("positive")));
    assert_eq!(would_do("e"), None, "no given says so");
    assert_eq!(would_do("f"), None, "what contradicts the premises proves nothing");
}

#[test]
fn a_witness_with_an_irrational_root_names_the_given_that_it_fails() {
    let text = "```kane\nvar c > 0, y > 0, z\ngiven premise: y*c = 1\ngiven sign: z > 0\n\
                claim a: sqrt(y^2 + 1) + sqrt(c^2 + 1) >= 2*sqrt(2) expect refuted\n\
                claim b: sqrt(2) + sqrt(3) >= sqrt(z + 1) expect ill-defined\n```\n";
    let audit = audited("root.md", text);
    let statement = |label: &str| {
        let mut all = audit.document.statements.iter();
        all.position(|s| s.label == label).expect("it is there")
    };
    let link = |label: &str| audit.judgements[statement(label)].links[0].clone();
    assert_eq!(link("a").standing, Some(Standing::Unmet(vec![statement("premise")])));
    assert_eq!(link("a").would_do, Some(statement("premise")));
    assert_eq!(link("b").standing, Some(Standing::Unmet(vec![statement("sign")])));
    assert_eq!(link("b").would_do, None, "it is false where z is large");
}

#[test]
fn what_is_false_and_what_only_does_not_follow_are_told_apart() {
    let text = "```kane\nvar x, y, z, w >= 0\ngiven positive: x > 0\ngiven tied: z = y + 1\n\
                given root: y = sqrt(w)\n\
                claim false: x > 1 expect refuted\n\
                claim open: x > -1 expect refuted\n\
                claim tied-false: x = z from tied expect refuted\n\
                claim undefined: 1/x = 1/x from tied expect ill-defined\n\
                given near: y -> 0 as w -> 0+\n\
                claim below-a-limit: x > 1 expect refuted\n```\n";
    let audit = audited("standing.md", text);
    let statement = |label: &str| {
        let mut all = audit.document.statements.iter();
        all.position(|s| s.label == label).expect("it is there")
    };
    let link = |label: &str| audit.judgements[statement(label)].links[0].clone();
    // `positive` is not cited, and a point is found at which it holds as well
    assert_eq!(link("false").standing, Some(Standing::AllMet));
    // no point with x > 0 is at most -1: without `positive` it does not follow, with it it does
    assert_eq!(link("open").standing, Some(Standing::Unmet(vec![statement("positive")])));
    assert_eq!(link("open").would_do, Some(statement("positive")));
    assert_eq!(link("tied-false").standing, Some(Standing::AllMet));
    assert_eq!(
        link("undefined").standing,
        Some(Standing::Unmet(vec![statement("positive")])),
        "1/x has a value wherever x > 0"
    );
    assert_eq!(link("below-a-limit").standing, Some(Standing::NotShown));
}

/// The proof of a claim's first link, with all steps in it.
fn told<'a>(audit: &'a Audit, label: &str) -> (Proof, impl Fn(&Proof) -> Vec<Step> + use<'a>) {
    let index = audit.document.statements.iter().position(|s| s.label == label);
    let proof = audit.judgements[index.expect("it is there")].links[0].steps();
    let flat = |proof: &Proof| {
        let mut steps = Vec::new();
        all(&proof.steps, &mut steps);
        steps.into_iter().cloned().collect()
    };
    (proof, flat)
}

#[test]
fn a_proof_leaves_definitions_as_they_are_where_premises_say_enough() {
    let text = "```kane\nvar x, y, E, F\nlet T := (x + y)^4/(1 + x^2)\nlet U := (x - y)^4 + x*y\n\
                given work: T - U = E + F\ngiven loss: E + F <= 0\n\
                claim c: T <= U from work, loss\nclaim d: U + x*y*((x - y)^2 + 1) >= -x^2*y^2 - 1\n```\n";
    let audit = audited("atoms.md", text);
    let (proof, flat) = told(&audit, "c");
    assert_eq!(proof.steps[0], Step::Kept(vec![0, 1]), "in the order in which they are met");
    let names = &proof.variables;
    assert!([0, 1].iter().all(|i| names.contains(&Variable::Definition(*i))), "{names:?}");
    // five symbols and definitions, of which each stands in the first power
    for step in flat(&proof) {
        if let Step::Assume { atoms, .. } = step {
            assert!(atoms.iter().all(|a| a.poly.vars().iter().all(|v| a.poly.degree(*v) == 1)));
        }
    }
    // what the definition is made of decides the other
    let (proof, _) = told(&audit, "d");
    assert!(!matches!(proof.steps.first(), Some(Step::Kept(_))), "{:?}", proof.steps);
}

#[test]
fn an_equality_is_told_by_what_its_symbols_are_defined_as_up_to_two_equal_sides() {
    let paper = audited("p.md", include_str!("../../../../docs/derivations/oblique-collision.md"));
    let (proof, flat) = told(&paper, "(9)");
    let steps = flat(&proof);
    let solved = steps.iter().find_map(|step| match step {
        Step::Solve { solved, .. } => Some(solved),
        _ => None,
    });
    let name = |v: usize| &*paper.document.context.vars[v].name;
    let first: Vec<&str> = solved.expect("it is solved").iter().map(|s| name(s.variable)).collect();
    assert_eq!(&first[..2], ["k", "i_x"], "the claim's own symbols by (5) and (6): {first:?}");
    assert!(steps.iter().any(|step| matches!(step, Step::Equal { .. })), "{steps:?}");
}

#[test]
fn a_limit_that_is_not_used_is_not_passed_to() {
    let paper = audited("p.md", include_str!("../../../../docs/derivations/oblique-collision.md"));
    let (proof, flat) = told(&paper, "literal-BC");
    let passes = flat(&proof).iter().filter(|step| matches!(step, Step::Pass { .. })).count();
    assert_eq!(passes, 1, "multiply by alpha, and let it tend to 0");
}

#[test]
fn where_both_sides_are_the_same_it_is_left_to_show_that_they_have_values() {
    let audit = audited("short.md", &format!("```kane\n{SHORT}\n```\n"));
    let (proof, _) = told(&audit, "sides");
    let [Step::Equal { .. }, Step::Suppose { what, .. }] = &proof.steps[..] else {
        panic!("{:?}", proof.steps);
    };
    assert_eq!(*what, Supposed::NoValue);
}
