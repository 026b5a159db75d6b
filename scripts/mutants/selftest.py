#!/usr/bin/env python3
"""The tool on a crate of a few lines, of which it is known what its test notices.

usage: selftest.py

Each line of the crate that ends with `//~` names a mutant of it and what has to become of it.
"""

import re
import subprocess
import tempfile
from pathlib import Path

import build
import trial

SOURCE = '''//! A toy.
use std::cmp::Ordering;

/// One number more than another.
#[derive(Clone, Copy, Default)]
pub struct Pair { pub a: i64, pub b: i64 }

pub const fn twice(n: i64) -> i64 {
    n * 2 //~ * + 7 constant
}
pub const SIX: i64 = twice(3);
pub fn thrice(n: i64) -> i64 {
    n + n + n //~ + - 7 caught
}
pub fn price(n: i64) -> i64 {
    1 + n //~ + * 7 missed
}
pub fn inside(n: i64) -> bool {
    n >= 0 && n < 9 //~ && || 12 caught
}
pub fn below(n: i64) -> bool {
    n < 9 //~ < <= 7 missed
}
pub fn other(n: i64) -> i64 {
    -n //~ - _ 5 caught
}
pub fn sign(n: i64) -> &'static str {
    match n.cmp(&0) {
        Ordering::Less if n > -100 => "less",
        Ordering::Equal => "none", //~ arm _ 9 caught
        _ => "more",
    }
}
pub fn name() -> String {
    "x".into() //~ value String::new() 5 caught
}
pub fn typed() -> Ordering {
    Ordering::Less //~ value Default::default() 5 type
}
pub fn some() -> impl Iterator<Item = i64> {
    [1, 2].into_iter() //~ value ::std::iter::empty() 5 caught
}
pub fn add(mut n: i64) -> i64 {
    n += 1; //~ += -= 7 caught
    n
}
pub fn pair() -> Pair {
    Pair { a: 1, ..Default::default() } //~ field _ 12 caught
}
pub fn steps(mut n: i64) -> i64 {
    let mut count = 0;
    while n > 1 {
        n -= 1; //~ -= /= 11 timed out
        count += 1;
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_of_it() {
        assert!((twice(2), SIX, thrice(5)) == (4, 6, 15) && inside(3) && !inside(-1) && below(3) && !below(12));
        assert!(other(4) == -4 && (sign(-5), sign(0), sign(5)) == ("less", "none", "more") && name() == "x");
        assert!(some().count() == 2 && add(1) == 2 && pair().a == 1 && pair().b == 0 && typed().is_lt());
        assert!(steps(9) == 8 && price(1) > 0);
    }
}
'''
GENRES = {"arm": "MatchArm", "value": "FnValue", "field": "StructField"}


def entries() -> tuple[list[dict], list[str]]:
    """What `cargo mutants --list --json` would say of the marked lines, and what has to become of each."""
    mutants, outcomes = [], []
    for at, line in enumerate(SOURCE.split("\n"), 1):
        if not (marked := re.match(r"(.*?) *//~ (\S+) (\S+) (\d+) (.*)", line)):
            continue
        code, what, to, column, outcome = marked.groups()
        genre = GENRES.get(what, "UnaryOperator" if to == "_" else "BinaryOperator")
        last = len(code) + 1 if genre in ("FnValue", "MatchArm") else int(column) + (4 if what == "field" else len(what))
        name = "delete field a from" if what == "field" else f"{what} by {to}"
        mutants.append({"name": f"src/lib.rs:{at}:{column}: {name}", "file": "src/lib.rs", "genre": genre,
                        "replacement": "" if to == "_" else to,
                        "span": {"start": {"line": at, "column": int(column)}, "end": {"line": at, "column": last}}})
        outcomes.append(outcome)
    return mutants, outcomes


def main() -> None:
    with tempfile.TemporaryDirectory() as directory:
        root, work = Path(directory) / "toy", Path(directory) / "work"
        (root / "src").mkdir(parents=True)
        (root / "src" / "lib.rs").write_text(SOURCE)
        (root / "Cargo.toml").write_text('[package]\nname = "toy"\nversion = "0.0.0"\nedition = "2024"\n[workspace]\n')
        subprocess.run(["git", "init", "--quiet"], cwd=root, check=True)
        mutants, outcomes = entries()
        copy = build.Copy(root, work, "toy", mutants)
        programs = build.tests(copy.build(["test", "--no-run", "--tests"]))
        tests, _ = trial.of(programs, build.environment(), [], 60, 1)
        wrong = 0
        for number, wanted in enumerate(outcomes, 1):
            found = copy.choices.out.get(number) or trial.tried(number, tests, build.environment())[0]
            if found != wanted:
                wrong += 1
                print(f"{copy.mutants[number].name}: {found}, not {wanted}")
        if wrong:
            raise SystemExit(f"{wrong} of {len(outcomes)} mutants are not told as they should")
        print(f"{len(outcomes)} mutants are told as they should")


if __name__ == "__main__":
    main()
