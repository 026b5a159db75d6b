//! Small documents that ask for much: each ends, in little room.

use std::time::{Duration, Instant};

use kane_audit::{Options, audit, read};

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
    let positive = |n: usize| (0..n).map(|i| format!("y{i} > 0")).collect::<Vec<_>>().join(", ");
    vec![
        format!("var x\nclaim a: {nines}*x^23 + x > 1"),
        format!("var x\nclaim a: {nines}*x^22 + {nines}7*x^9 + x > 1/{nines}"),
        "var x > 0\nclaim a: x^13 >= sqrt(x/1000003)".to_owned(),
        format!("var x > 0\nclaim a: sqrt({}) >= x^3", "7".repeat(4_000)),
        format!("var {}\nclaim a: {} > 1", positive(26), product(26)),
        format!("var {}\nclaim a: {} = 1", positive(16), product(16)),
        "var x\nclaim a: (x + 1)^999 >= (x - 1)^998".to_owned(),
        "var x, y, z\nclaim a: (x + y + z + 1)^60 != (x - y + 2*z)^61".to_owned(),
    ]
}

#[test]
fn documents_that_ask_for_much_end_in_little_room() {
    for body in hostile() {
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
