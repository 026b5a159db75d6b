//! Writes the claims of documents that take long, as a table, and why they do.
//!
//!     cargo run --release -p kane-audit --example slow_claims -- docs/derivations/*.md
//!
//! Operations, steps, terms and verdicts are the same on all machines, and so is the table. With `--seconds` each
//! row ends with the processor's seconds, which are not.

use std::error::Error;
use std::io::{Write, stdout};
use std::path::Path;
use std::time::Instant;

use kane_audit::{Judgement, LinkJudgement, Options, audit, read};
use kane_kernel::{Fuel, claim_state, scope};

/// Operations from which a claim is in the table: some tenths of a second.
const LONG: u64 = 10_000_000;

fn main() -> Result<(), Box<dyn Error>> {
    let (flags, paths): (Vec<String>, Vec<String>) =
        std::env::args().skip(1).partition(|argument| argument.starts_with("--"));
    let timed = flags.iter().any(|flag| flag == "--seconds");
    let mut out = stdout().lock();
    let seconds = if timed { " seconds |" } else { "" };
    writeln!(
        out,
        "| document | claim | verdict | 10⁶ operations | steps | what takes long |{seconds}"
    )?;
    writeln!(out, "|---|---|---|---|---|---|{}", if timed { "---|" } else { "" })?;
    for path in paths {
        let document =
            read(&path, &std::fs::read(&path)?).map_err(|_| format!("{path} cannot be read"))?;
        let mut began: Vec<Instant> = Vec::new();
        let audit = audit(document, &Options::default(), &mut |_, _| began.push(Instant::now()));
        began.push(Instant::now());
        let name = Path::new(&path).file_stem().unwrap_or_default().to_string_lossy();
        for (i, judgement) in audit.judgements.iter().enumerate() {
            let work: u64 = judgement.links.iter().map(|link| link.work).sum();
            if work < LONG {
                continue;
            }
            let label = &audit.document.statements[i].label;
            let row = row(judgement, work);
            write!(out, "| {name} | {label} | {row} |")?;
            if timed {
                let took = began[i + 1].duration_since(began[i]).as_secs_f64();
                write!(out, " {took:.1} |")?;
            }
            writeln!(out)?;
        }
    }
    Ok(())
}

fn row(judgement: &Judgement, work: u64) -> String {
    let steps: u64 = judgement.links.iter().map(|link| link.cost).sum();
    let longest = judgement.links.iter().max_by_key(|link| link.work);
    let why = longest.map_or_else(String::new, reason);
    format!("{} | {} | {steps} | {why}", judgement.verdict, work / 1_000_000)
}

/// What a link takes, and the size of what it is about.
fn reason(link: &LinkJudgement) -> String {
    let widest = link.accepted.as_ref().and_then(|accepted| {
        let goal = &accepted.goal;
        let scope = scope(goal, Fuel::new(400_000_000)).ok()?;
        let state = claim_state(&scope, goal, accepted.certificate.finding).ok()?;
        let cases = state.formulas.iter().flatten().flatten();
        cases.map(|a| a.poly.len()).max()
    });
    let terms =
        widest.map_or_else(String::new, |n| format!(", {n} terms in its longest condition"));
    format!("{}{terms}", link.burden())
}
