//! Documents that ask for much: each ends, in little room, and all its claims share one budget.

use std::time::{Duration, Instant};

#[path = "../../../tests/shared/many.rs"]
#[expect(dead_code, reason = "here are no random statements")]
mod many;

use kane_audit::{Audit, Budget, Open, Options, Verdict, audit, read};
use many::share;

/// Longer than the longest of them takes on a busy machine in a build without optimization.
const PATIENCE: Duration = Duration::from_secs(120);
/// Memory of the whole process, in KB, documents one after the other.
const ROOM: u64 = 500_000;

/// The most memory that this process has held, in KB; `None` where the system does not tell.
fn peak() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|l| l.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

fn hostile() -> Vec<String> {
    let nines = "9".repeat(60);
    let product = |n: usize| (0..n).map(|i| format!("(y{i} + 1)")).collect::<Vec<_>>().join("*");
    let above = |n: usize| (0..n).map(|i| format!("m > y{i}")).collect::<Vec<_>>().join(", ");
    let names = |n: usize| (0..n).map(|i| format!("y{i}")).collect::<Vec<_>>().join(", ");
    let doubled =
        |n: usize| (1..n).map(|i| format!("let f{i} := f{0} + f{0}\n", i - 1)).collect::<String>();
    let positive = |n: usize| (0..n).map(|i| format!("y{i} > 0")).collect::<Vec<_>>().join(", ");
    vec![
        format!("var x\nclaim a: {nines}*x^23 + x > 1"),
        format!("var x\nclaim a: {nines}*x^22 + {nines}7*x^9 + x > 1/{nines}"),
        "var x > 0\nclaim a: x^13 >= sqrt(x/1000003)".to_owned(),
        format!("var x > 0\nclaim a: sqrt({}) >= x^3", "7".repeat(4_000)),
        format!("var {}\nclaim a: {} > 1", positive(26), product(26)),
        format!("var {}\nclaim a: {} = 1", positive(16), product(16)),
        "var x\nclaim a: (x + 1)^999 >= (x - 1)^998".to_owned(),
        format!("var {}\nclaim a: exists m: {}", names(400), above(400)),
        format!("var x\nlet f0 := x\n{}claim a: exists m: m > f39", doubled(40)),
        "var x, y\nclaim a: x^10000 + y^10000 >= 2*x^5000*y^5000".to_owned(),
        "var x\nclaim a: x^2 > sqrt(2) + sqrt(3) + sqrt(5) when x > 2".to_owned(),
        "var x\nclaim a: x != sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7) when x > 3".to_owned(),
        "var x, y, z\nclaim a: sqrt(sqrt(100 + sqrt(11))) + z*z - (z + 1/2) = min(sqrt(2/3 + sqrt(13/7)), 343 + max(z, 5)) \
         when x <= x^2 + 1.01, y < 1/2, x < z + y"
            .to_owned(),
        "var x, y\nclaim a: x^10000 + y^10000 > 3*x^5001*y^4999 when x^9999 > 7*y".to_owned(),
        "var x, y, z\nclaim a: (x + y + z + 1)^60 != (x - y + 2*z)^61".to_owned(),
        format!("var m > {0}2{0}\nclaim a: m > 2", "|".repeat(100)),
    ]
}

#[test]
fn documents_that_ask_for_much_end_in_little_room() {
    for body in share(hostile()) {
        let text = format!("```kane\n{body}\n```\n");
        let head: String = body.chars().take(60).collect();
        let start = Instant::now();
        match read("hostile.md", text.as_bytes()) {
            Ok(document) => {
                let audit = audit(document, &Options::default(), &mut |_, _| {});
                println!("{:?} {} {head}", start.elapsed(), audit.judgements[0].verdict);
            }
            Err(faults) => println!("{:?} {:?} {head}", start.elapsed(), faults.len()),
        }
        assert!(start.elapsed() < PATIENCE, "{:?} for {head}", start.elapsed());
        if let Some(held) = peak() {
            assert!(held < ROOM, "{held} KB after {head}");
        }
    }
}

/// Too hard for any budget of these tests: equations of degree three in four variables.
const HARD: &str = "x + y + z + w = 0 from g1, g2, g3";

/// A document of that many hard claims, with easy ones between them and at the end.
fn crowd(hard: usize) -> String {
    let givens = "var x, y, z, w\n\
                  given g1: x^2*y + y^2*z + z^2*w = 1\n\
                  given g2: x*y*z*w = 2\n\
                  given g3: x^3 + y^3 + z^3 + w^3 = 3\n";
    let claims = (0..hard).map(|i| format!("claim h{i}: {HARD}\nclaim e{i}: (x + {i})^2 >= 0\n"));
    format!("```kane\n{givens}{}```\n", claims.collect::<String>())
}

fn judged(text: &str, only: Option<Vec<usize>>, document: u64) -> Audit {
    let read = read("crowd.md", text.as_bytes()).expect("it is well formed");
    let budget = Budget { document, ..Budget::default() };
    audit(read, &Options { only, budget }, &mut |_, _| {})
}

/// Verdict and work of each claim.
fn outcomes(audit: &Audit) -> Vec<(Verdict, u64)> {
    let claims = audit.judgements.iter().filter(|j| !j.links.is_empty());
    claims.map(|j| (j.verdict, j.links.iter().map(|l| l.work).sum())).collect()
}

fn is_of_document(open: Option<&Open>) -> bool {
    matches!(open, Some(Open::Document(_)))
}

#[test]
fn all_claims_of_a_document_share_one_budget() {
    const WHOLE: u64 = 12_000_000;
    let few = outcomes(&judged(&crowd(2), None, WHOLE));
    let many = outcomes(&judged(&crowd(8), None, WHOLE));
    for (count, found) in [(4, &few), (16, &many)] {
        assert_eq!(found.len(), count);
        let spent: u64 = found.iter().map(|f| f.1).sum();
        assert!(spent <= WHOLE, "{spent}");
        assert!(spent > WHOLE / 2, "the first claims have most of it: {spent}");
    }
    // A claim that is easy is decided however much those before it have spent.
    for (i, (verdict, _)) in many.iter().enumerate() {
        let expected = if i % 2 == 0 { Verdict::Undecided } else { Verdict::Proved };
        assert_eq!(*verdict, expected, "claim {i}");
    }
}

#[test]
fn a_claim_whose_document_has_spent_its_budget_says_so_and_alone_has_all_of_it() {
    const WHOLE: u64 = 12_000_000;
    let text = crowd(3);
    let audit = judged(&text, None, WHOLE);
    let last = audit.document.statements.iter().position(|s| s.label == "h2").expect("it is there");
    let link = &audit.judgements[last].links[0];
    assert!(is_of_document(link.open.as_ref()), "{:?}", link.open);
    let said = link.open.as_ref().map(ToString::to_string).unwrap_or_default();
    assert!(said.contains("the budget of the document was spent"), "{said}");
    let alone = judged(&text, Some(vec![last]), WHOLE);
    let more = alone.judgements[last].links[0].work;
    assert!(more > 2 * link.work, "{more} against {}", link.work);
    assert_eq!(more, judged(&text, Some(vec![last]), WHOLE).judgements[last].links[0].work);
}

/// Its argument is found, and the kernel multiplies no polynomials as long as its check has.
#[test]
fn what_no_effort_decides_is_not_said_to_need_more_of_it() {
    let text = "```kane\nvar x\nclaim a: (x + 1)^110/((x + 1)^110 + 1) -> 1 as x -> oo\n```\n";
    for effort in [1, 100] {
        let read = read("long.md", text.as_bytes()).expect("it is well formed");
        let budget = Budget::default().times(effort);
        let audit = audit(read, &Options { only: None, budget }, &mut |_, _| {});
        let open = audit.judgements.iter().flat_map(|j| &j.links).map(|link| link.open.as_ref());
        for open in open {
            assert!(matches!(open, Some(Open::Bound)), "{open:?}");
            let said = open.map(ToString::to_string).unwrap_or_default();
            assert!(
                said.contains("no effort raises") && !said.contains("greater effort"),
                "{said}"
            );
        }
        assert_eq!(audit.judgements.iter().flat_map(|j| &j.links).count(), 1);
    }
}

#[test]
fn what_a_budget_decides_is_the_same_in_every_run() {
    let text = crowd(3);
    let runs: Vec<_> = (0..2).map(|_| outcomes(&judged(&text, None, 7_000_000))).collect();
    assert_eq!(runs[0], runs[1]);
}

#[test]
fn more_effort_is_more_of_the_budget_of_a_document() {
    let usual = Budget::default();
    assert_eq!(usual.times(3).document, 3 * usual.document);
}

#[test]
fn limits_of_quotients_of_high_powers_are_judged_within_the_default_budget() {
    let text = "```kane\nvar x\n\
        claim right: x^1885/(1 + x^1885) -> 1 as x -> oo\n\
        claim wrong: x^1885/(1 + x^1885) -> 2 as x -> oo\n```\n";
    let document = read("powers.md", text.as_bytes()).expect("it can be read");
    let audit = audit(document, &Options::default(), &mut |_, _| {});
    let verdicts: Vec<Verdict> = audit.judgements.iter().map(|j| j.verdict).collect();
    assert_eq!(verdicts, [Verdict::Proved, Verdict::Refuted]);
}
