//! Certificates of true claims, changed in a few places and given to the kernel with these claims or with false ones much
//! like them: what it accepts holds at every point that is tried, by evaluation, which shares no code with the kernel.
#![no_main]

extern crate kane_fuzz as kane;

mod support {
    pub(crate) use kane_fuzz::chance::{Chance, Q, q};
}

#[path = "../../../tests/conformance/mutation.rs"]
#[allow(dead_code, reason = "the list of kinds is for the tests")]
mod mutation;

use std::cell::OnceCell;

use kane_algebra::syntax::holds;
use kane_audit::{Options, audit, read};
use kane_kernel::{
    Certificate, Conclusion, Context, Finding, Fuel, Goal, Link, Relation, check, digest,
};
use libfuzzer_sys::fuzz_target;
use support::{Q, q};

/// Claims that hold, most with a twin that does not.
const CLAIMS: &str = "\
# Claims

```kane
var x > 0, y, 0 <= e <= 1
given g: y >= x
given h: y^2 = 2*x
claim a1: x + 1/x >= 2
claim a2: x + 1/x > 2
claim b1: x/(1 + x) < 1
claim b2: x/(1 + x) < 1/2
claim c1: y > 0 from g
claim c2: y > 1 from g
claim d1: x^2 - 2*x*y + y^2 >= 0
claim d2: x^2 - 3*x*y + y^2 >= 0
claim e1: abs(y) <= 1 when y^2 <= 1
claim e2: abs(y) < 1 when y^2 <= 1
claim f1: e*(1 - e) <= 1/4
claim f2: e*(1 - e) < 1/4
claim g1: x^2 <= 2*x from g, h
claim g2: x^2 <= x from g, h
claim h1: sqrt(x)*sqrt(x) = x
claim h2: sqrt(y)*sqrt(y) = y
claim i1: max(x, y) >= y
claim i2: max(x, y) > y
claim j1: y^4 - y^2 + 1 > 0
claim j2: y^4 - 2*y^2 + 1 > 0
claim k1: (y^2 - 1)/(y - 1) = y + 1 when y != 1
claim k2: (y^2 - 1)/(y - 1) = y + 1
claim l1: y = 0 when y^3 = 0
claim l2: y = 0 when y^3 = y
```
";

/// Claims with what is known of them, and certificates of those that hold.
struct Known {
    goals: Vec<Goal>,
    certificates: Vec<Certificate>,
    points: Vec<Vec<Q>>,
}

impl Known {
    fn new() -> Self {
        let document = read("claims.md", CLAIMS.as_bytes()).expect("it is well formed");
        let judged = audit(document, &Options::default(), &mut |_, _| {});
        let links = judged.judgements.iter().flat_map(|judgement| &judgement.links);
        let accepted: Vec<_> = links.filter_map(|link| link.accepted.clone()).collect();
        let values = [-2, -1, 0, 1, 2, 3, 4, 6, 8].map(|n| q(n, 2));
        let mut points = Vec::new();
        for x in &values {
            for y in &values {
                points.extend(values.iter().map(|e| vec![x.clone(), y.clone(), e.clone()]));
            }
        }
        Self {
            goals: accepted.iter().map(|a| a.goal.clone()).collect(),
            certificates: accepted.iter().map(|a| a.certificate.clone()).collect(),
            points,
        }
    }
}

thread_local! {
    static KNOWN: OnceCell<Known> = const { OnceCell::new() };
}

/// Whether a relation holds, which it does not where a side has no value; `None` if a value is not rational.
fn value(relation: &Relation, context: &Context, point: &[Q]) -> Option<bool> {
    holds(relation, context, point)
        .or_else(|none| if none.is_undefined() { Ok(false) } else { Err(none) })
        .ok()
}

/// Whether all premises and conditions surely hold at a point.
fn is_spoken_of(goal: &Goal, point: &[Q]) -> bool {
    let within = goal.context.vars.iter().zip(point).all(|(var, x)| {
        let above =
            var.lower.as_ref().is_none_or(|b| if b.strict { *x > b.value } else { *x >= b.value });
        let below =
            var.upper.as_ref().is_none_or(|b| if b.strict { *x < b.value } else { *x <= b.value });
        above && below
    });
    let surely = |r: &Relation| value(r, &goal.context, point) == Some(true);
    within
        && goal.when.iter().all(surely)
        && goal.hypotheses.iter().all(|h| {
            h.sentence.when.is_empty()
                && h.sentence.relations().all(surely)
                && h.sentence.limits().next().is_none()
        })
}

fuzz_target!(|data: &[u8]| {
    KNOWN.with(|known| {
        let known = known.get_or_init(Known::new);
        let mut chance = support::Chance::new(data);
        let goal = chance.pick(&known.goals);
        let mut certificate = chance.pick(&known.certificates).clone();
        for _ in 0..8 {
            if chance.is_over() {
                break;
            }
            let sites = mutation::kinds(&certificate).len();
            let site = chance.below(sites);
            certificate = mutation::mutant(&certificate, site, &mut chance);
        }
        certificate.goal = digest(goal);
        if check(goal, &certificate, Fuel::new(2_000_000)).is_err() {
            return;
        }
        let Conclusion::Link(Link::Relation(claimed)) = &goal.conclusion else { return };
        let spoken: Vec<_> =
            known.points.iter().filter(|point| is_spoken_of(goal, point)).collect();
        match certificate.finding {
            Finding::Proved => {
                let fails = |point: &&&Vec<Q>| value(claimed, &goal.context, point) == Some(false);
                assert_eq!(spoken.iter().find(fails), None, "proved, and false: {certificate:?}");
            }
            Finding::Vacuous => assert!(spoken.is_empty(), "vacuous, but not so: {certificate:?}"),
            Finding::Refuted => assert!(
                spoken.iter().any(|point| value(claimed, &goal.context, point) != Some(true)),
                "refuted, and true where it was tried: {claimed:?} {certificate:?}"
            ),
            Finding::IllDefined | Finding::Consistent => {}
        }
    });
});
