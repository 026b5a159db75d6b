//! What the README and the page of impact records show is what the program prints.

use crate::kane;

const README: &str = include_str!("../../README.md");
const RECORDS: &str = include_str!("../../docs/records.md");

/// Every block that begins with `$ kane …` is the output of that command. A line with `…` alone stands for lines
/// left out, a `…` at the end of a line for the rest of it.
#[test]
fn every_shown_output_is_what_the_program_prints() {
    for page in [README, RECORDS] {
        let mut shown = 0;
        for block in page.split("```").skip(1).step_by(2) {
            let Some((command, output)) = block.trim_start_matches("console\n").split_once('\n')
            else {
                continue;
            };
            let Some(command) = command.strip_prefix("$ kane ") else {
                continue;
            };
            let run = kane(&command.split(' ').collect::<Vec<_>>());
            compare(output, &run.stdout);
            shown += 1;
        }
        assert!(shown > 0, "the page shows no output");
    }
}

/// Goes through both texts; a mark of omission skips to the next line that is shown.
fn compare(shown: &str, printed: &str) {
    let mut printed = printed.lines();
    let mut skipping = false;
    for line in shown.lines() {
        if line.trim() == "…" {
            skipping = true;
            continue;
        }
        let fits = |actual: &str| match line.strip_suffix('…') {
            Some(start) => actual.starts_with(start),
            None => actual == line,
        };
        let found = if skipping { printed.any(fits) } else { printed.next().is_some_and(fits) };
        assert!(found, "the page shows, but the program does not print:\n{line}");
        skipping = false;
    }
    assert!(
        skipping || printed.next().is_none(),
        "the page ends before the output does, without saying so"
    );
}

#[test]
fn the_readme_is_short_and_gives_two_commands() {
    assert!(README.lines().count() < 130);
    let commands: Vec<_> = README.lines().filter(|line| line.starts_with("cargo ")).collect();
    assert_eq!(commands, ["cargo run --release -- audit", "cargo test"]);
}

#[test]
fn the_gate_runs_the_test_command_of_the_readme() {
    let gate = include_str!("../../.ci/run");
    assert!(gate.lines().any(|line| line.ends_with(" cargo test")));
}
