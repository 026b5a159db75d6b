//! Lists the claims of documents that take more than a second, and what takes it.
//!
//!     cargo run --release -p kane-audit --example slow_claims -- docs/derivations/*.md
//!
//! Seconds are those of the machine and stand in no test; steps, terms and verdicts are the same on all.

use std::error::Error;
use std::io::{Write, stdout};
use std::time::{Duration, Instant};

use kane_audit::{LinkJudgement, Options, audit, read};
use kane_kernel::{Finding, Fuel, claim_state, scope};

/// Search steps from which the search is what takes long.
const STEPS: u64 = 200;

fn main() -> Result<(), Box<dyn Error>> {
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path)?;
        let document = read(&path, &bytes).map_err(|_| format!("{path} cannot be read"))?;
        let mut began: Vec<Instant> = Vec::new();
        let audit = audit(document, &Options::default(), &mut |_, _| began.push(Instant::now()));
        began.push(Instant::now());
        for (i, judgement) in audit.judgements.iter().enumerate() {
            let Some([from, to]) = began.get(i..i + 2) else { continue };
            let took = to.duration_since(*from);
            if took > Duration::from_secs(1) {
                let label = &audit.document.statements[i].label;
                let why: Vec<String> = judgement.links.iter().map(reason).collect();
                let (verdict, why) = (judgement.verdict, why.join("; "));
                writeln!(
                    stdout(),
                    "{path} {label}: {verdict:?}, {:.1} s: {why}",
                    took.as_secs_f64()
                )?;
            }
        }
    }
    Ok(())
}

/// What a link takes: steps of the search, or the size of what it is about.
fn reason(link: &LinkJudgement) -> String {
    let widest = link.accepted.as_ref().and_then(|accepted| {
        let goal = &accepted.goal;
        let scope = scope(goal, Fuel::new(400_000_000)).ok()?;
        let state = claim_state(&scope, goal, Finding::Proved).ok()?;
        let cases = state.formulas.iter().flatten().flatten();
        cases.map(|a| a.poly.len()).max()
    });
    let terms =
        widest.map_or_else(String::new, |n| format!(", {n} terms in its longest condition"));
    let part = if link.cost >= STEPS { "a search of" } else { "not the search, of" };
    format!("{part} {} steps{terms}", link.cost)
}
