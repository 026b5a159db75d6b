//! How long proofs are to read, and the longest of them.

use std::fmt::Write as _;

use kane::audit::{Options, audit, read};
use kane::report::{ProofLength, proof_lengths};

use crate::settings;

/// Proofs that are named.
const LONGEST: usize = 15;

fn lengths(name: &str, bytes: &[u8]) -> Vec<ProofLength> {
    let document = read(name, bytes).expect("it is well formed");
    proof_lengths(&audit(document, &Options::default(), &mut |_, _| {}))
}

/// The share of numbers up to each of these ends, and the greatest number.
fn distribution(what: &str, mut numbers: Vec<usize>, ends: &[usize]) -> String {
    numbers.sort_unstable();
    let (count, most) = (numbers.len(), numbers.last().copied().unwrap_or(0));
    let median = numbers.get(count / 2).copied().unwrap_or(0);
    let mut out = format!("{what}: median {median}, at most {most}");
    for end in ends {
        let within = numbers.iter().filter(|n| *n <= end).count();
        let percent = (100 * within).checked_div(count).unwrap_or(100);
        let _ = write!(out, "; {within} ({percent} %) within {end}");
    }
    out.push('\n');
    out
}

fn told(lengths: &[ProofLength]) -> String {
    let each = |of: fn(&ProofLength) -> usize| lengths.iter().map(of).collect::<Vec<_>>();
    let sum = |of: fn(&ProofLength) -> usize| lengths.iter().map(of).sum::<usize>();
    let mut out = format!(
        "{} proofs, {} lines, {} letters, and {} folded away\n",
        lengths.len(),
        sum(|l| l.lines),
        sum(|l| l.letters),
        sum(|l| l.folded)
    );
    out += &distribution("lines", each(|l| l.lines), &[4, 8, 12, 20, 40, 60]);
    out += &distribution("letters of the longest line", each(|l| l.longest), &[80, 120, 160, 200]);
    let mut order: Vec<&ProofLength> = lengths.iter().collect();
    order.sort_by_key(|l| std::cmp::Reverse((l.lines, l.letters)));
    out.push_str("\nlines  longest  letters  folded  proof\n");
    for l in order.iter().take(LONGEST) {
        let (lines, longest, letters, folded) = (l.lines, l.longest, l.letters, l.folded);
        let proof = match l.link {
            0 => l.label.clone(),
            link => format!("{}, link {}", l.label, link + 1),
        };
        let _ = writeln!(out, "{lines:5}  {longest:7}  {letters:7}  {folded:6}  {proof}");
    }
    out
}

#[test]
fn proofs_of_the_paper_are_short_to_read() {
    let bytes = include_bytes!("../../docs/derivations/oblique-collision.md");
    let lengths = lengths("oblique-collision.md", bytes);
    settings().bind(|| insta::assert_snapshot!("oblique_collision", told(&lengths)));
}

#[test]
fn proofs_of_coupled_collisions_are_short_to_read() {
    let bytes = include_bytes!("../../docs/derivations/coupled-collision.md");
    let lengths = lengths("coupled-collision.md", bytes);
    settings().bind(|| insta::assert_snapshot!("coupled_collision", told(&lengths)));
}
