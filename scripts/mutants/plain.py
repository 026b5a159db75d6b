#!/usr/bin/env python3
"""Asks the compiler about single mutants, whose switch did not compile in `run.py`.

usage: plain.py PACKAGE RESULTS [--work DIR]

Each mutant of RESULTS whose outcome is `switch` or `constant` is put into the copy as cargo-mutants would write it, and
checked. What compiles is listed, and left to cargo-mutants itself: `cargo mutants --package PACKAGE --re NAME`.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import build

sys.setrecursionlimit(20_000)
ROOT = Path(__file__).resolve().parents[2]


def main() -> None:
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n\n")[0])
    parser.add_argument("package")
    parser.add_argument("results", type=Path)
    parser.add_argument("--root", type=Path, default=ROOT)
    parser.add_argument("--work", type=Path)
    asked = parser.parse_args()
    results = [json.loads(line) for line in asked.results.read_text().splitlines()]
    open_ones = {r["name"] for r in results if r["outcome"] in ("switch", "constant")}
    work = asked.work or Path(tempfile.mkdtemp(prefix="mutants-"))
    copy = build.Copy(asked.root, work, asked.package, build.listed(asked.root, asked.package, []))
    compiles = 0
    for m in copy.mutants.values():
        if m.name not in open_ones:
            continue
        source = copy.sources[m.file]
        start, end = source.offset(m.start), source.offset(m.end)
        target = work / m.file
        target.write_bytes(source.bytes[:start] + m.replacement.encode() + source.bytes[end:])
        run = subprocess.run(["cargo", "check", "--quiet", "-p", asked.package, "--lib"], cwd=work, env=copy.environment,
                             capture_output=True)
        target.write_bytes(source.bytes)
        if run.returncode == 0:
            compiles += 1
            print(f"compiles: {m.name}", flush=True)
    print(f"{asked.package}: of {len(open_ones)} mutants without a switch {compiles} compile")


if __name__ == "__main__":
    main()
