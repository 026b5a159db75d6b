#!/usr/bin/env python3
"""Tries all mutants of a package in one build.

usage: run.py PACKAGE [--file GLOB]... [--tests PACKAGE:TARGET]... [--only WORD]... [--within SECONDS] [--beyond SECONDS]
              [--again RESULTS] [--work DIR] [--jobs N] [--out RESULTS]

`cargo mutants --list` says which they are (so cargo-mutants has to be installed), and this puts each behind a switch (see
switch.py; from PyPI: tree-sitter, tree-sitter-rust). The tests are those of the package, and of the targets that are
named with --tests; with --only, those that have one of these words in their name; with --within, those that take no
longer, and with --beyond, those that take longer. --again leaves out what an earlier run told: it goes on with what was
missed, had no switch, or was not tried.

The results are lines of JSON: mutant, outcome, and the test that told it. An outcome is `caught`, `timed out` (five times
the processor time of the tests, and a second), `missed`, `type` (the value of a function is not of its type), or
`switch` and `constant`: not tried here. For these `plain.py` asks the compiler about each mutant by itself.
"""

import argparse
import collections
import concurrent.futures
import json
import random
import sys
import tempfile
import time
from pathlib import Path

import build
import trial

sys.setrecursionlimit(20_000)
ROOT = Path(__file__).resolve().parents[2]


def main() -> None:
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n\n")[0])
    parser.add_argument("package")
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("--file", action="append", default=[])
    parser.add_argument("--tests", action="append", default=[])
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--within", type=float, default=600)
    parser.add_argument("--beyond", type=float, default=0)
    parser.add_argument("--again", type=Path)
    parser.add_argument("--work", type=Path)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out", type=Path)
    asked = parser.parse_args()

    entries = build.listed(asked.root, asked.package, asked.file)
    explained = len(build.listed(asked.root, asked.package, asked.file, config=False)) - len(entries)
    work = asked.work or Path(tempfile.mkdtemp(prefix="mutants-"))
    copy = build.Copy(asked.root, work, asked.package, entries)
    print(f"{asked.package}: {len(entries)} mutants, {explained} more are explained; in {work}", flush=True)

    copy.build(["check", "-p", asked.package, "--lib"])
    messages = copy.build(["test", "--no-run", "-p", asked.package, "--tests"])
    programs = build.tests(messages)
    for target in asked.tests:
        package, name = target.split(":")
        programs += build.tests(copy.build(["test", "--no-run", "-p", package, "--test", name]))
    started = time.monotonic()
    tests, slow = trial.of(programs, build.environment(), asked.only, asked.within, asked.jobs)
    tests = [t for t in tests if t.seconds > asked.beyond]
    print(f"{len(tests)} tests, {sum(t.seconds for t in tests):.1f} s one by one, "
          f"{len(slow)} slower ones left out", flush=True)

    wanted = set(copy.mutants)
    if asked.again:
        # one change may be made in several places of a function: it is left out if all of them were told
        results = [json.loads(line) for line in asked.again.read_text().splitlines()]
        told = collections.Counter(r["change"] for r in results if r["outcome"] in ("caught", "timed out", "type"))
        places = collections.Counter(m.change for m in copy.mutants.values())
        wanted = {n for n in wanted if told[copy.mutants[n].change] < places[copy.mutants[n].change]}
    counts: collections.Counter[str] = collections.Counter()
    with (open(asked.out, "w") if asked.out else tempfile.TemporaryFile("w")) as out:
        def note(number: int, outcome: str, told: str) -> None:
            m = copy.mutants[number]
            counts[outcome] += 1
            out.write(json.dumps({"name": m.name, "change": m.change, "outcome": outcome, "told": told}) + "\n")
            out.flush()
            if outcome == "missed":
                print(f"missed: {m.name} ({told})", flush=True)

        for number in sorted(wanted & set(copy.choices.out)):
            note(number, copy.choices.out[number], "")
        with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
            left = sorted(wanted - set(copy.choices.out))
            # a run that is cut short is a sample
            random.Random(asked.package).shuffle(left)
            runs = [(n, pool.submit(trial.tried, n, tests, build.environment())) for n in left]
            for number, done in runs:
                note(number, *done.result())
    print(f"{asked.package}: {sum(counts.values())} mutants in {time.monotonic() - started:.0f} s: "
          + ", ".join(f"{count} {outcome}" for outcome, count in sorted(counts.items())), flush=True)


if __name__ == "__main__":
    main()
