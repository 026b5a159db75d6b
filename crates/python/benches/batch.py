"""What a row of a law over a column costs from Python and in Rust, side by side.

    maturin build --release     # in crates/python; then `pip install` of the wheel that it names
    python benches/batch.py [--repeats 40]

Builds the Rust side with `cargo build --release`. Both run the same column by turns, in samples of a millisecond, and
what counts is the best sample of each: on a busy machine all others tell how long they waited. `call` is what one call
from Python takes beyond the rows. "New columns" are made by each call, in Rust by each pass: then most of the time is
that of the system, which gives their pages.
"""

import argparse
import json
import subprocess
import time
from pathlib import Path

import kane
import numpy as np

ROOT = Path(__file__).resolve().parents[3]
TARGET = 1.2
ROWS_TIMED = 1_000_000  # in one sample
SAMPLES = 5  # in a turn


def rust():
    """The Rust side, which answers `law rows passes samples new` with the nanoseconds of the best sample."""
    build = ["cargo", "build", "--quiet", "--release", "--locked", "-p", "kane-impact", "--example", "batch"]
    subprocess.run(build, cwd=ROOT, check=True)
    found = ["cargo", "metadata", "--no-deps", "--format-version", "1"]
    data = json.loads(subprocess.run(found, cwd=ROOT, check=True, capture_output=True).stdout)
    program = Path(data["target_directory"]) / "release/examples/batch"
    process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(law, rows, passes, new):
        process.stdin.write(f"{law} {rows} {passes} {SAMPLES} {int(new)}\n")
        process.stdin.flush()
        return int(process.stdout.readline())

    return ask


def python(law, rows, passes, new):
    alpha = np.arange(rows) * (4.0 / rows)
    out = None if new else tuple(np.ones(rows) for _ in range(3))
    kane.batch(law, alpha, out=out)
    best = None
    for _ in range(SAMPLES):
        at = time.perf_counter_ns()
        for _ in range(passes):
            kane.batch(law, alpha, out=out)
        took = time.perf_counter_ns() - at
        best = took if best is None else min(best, took)
    return best


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--repeats", type=int, default=40)
    repeats = options.parse_args().repeats
    ask = rust()
    print(f"{'law':<20}{'rows':>9}  {'results':<12}{'Rust':>9}{'Python':>9}  ns a row{'ratio':>8}{'call':>10}")
    worst = 0.0
    for new in (False, True):
        for rows in (1_000, 1_000_000):
            passes = max(1, ROWS_TIMED // rows)
            for law in kane.batched():
                turns = [(ask(law, rows, passes, new), python(law, rows, passes, new)) for _ in range(repeats)]
                of_rust, of_python = (min(turn) / passes for turn in zip(*turns))
                ratio = of_python / of_rust
                if rows == 1_000_000 and not new:
                    worst = max(worst, ratio)
                call = f"{(of_python - of_rust) / 1000:7.2f} µs" if rows == 1_000 else ""
                print(
                    f"{law:<20}{rows:>9}  {'new columns' if new else 'written over':<12}"
                    f"{of_rust / rows:9.2f}{of_python / rows:9.2f}{ratio:18.3f}{call:>10}"
                )
    met = "met" if worst <= TARGET else "missed"
    print(f"worst ratio at a million rows, written over: {worst:.3f}; {TARGET} is {met}")


if __name__ == "__main__":
    main()
