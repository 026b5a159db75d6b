"""What a row of a law over a column costs from Python and in Rust, side by side.

    maturin build --release     # in crates/python; then `pip install` of the wheel that it names
    python benches/batch.py [--repeats 21]

Builds the Rust side with `cargo build --release`. In every repeat both run the same column, one right after the other,
so that a busy machine is busy for both; what is printed are medians of the nanoseconds a row, and the median of the
ratios within a repeat. `call` is what one call from Python takes beyond the rows. "New columns" are made by each call,
in Rust by each pass: then most of the time is that of the system, which gives their pages.
"""

import argparse
import json
import statistics
import subprocess
import time
from pathlib import Path

import kane
import numpy as np

ROOT = Path(__file__).resolve().parents[3]
TARGET = 1.2
ROWS_TIMED = 4_000_000  # in one sample


def rust():
    """The Rust side, which answers `law rows passes new` with nanoseconds."""
    build = ["cargo", "build", "--quiet", "--release", "--locked", "-p", "kane-impact", "--example", "batch"]
    subprocess.run(build, cwd=ROOT, check=True)
    found = ["cargo", "metadata", "--no-deps", "--format-version", "1"]
    data = json.loads(subprocess.run(found, cwd=ROOT, check=True, capture_output=True).stdout)
    program = Path(data["target_directory"]) / "release/examples/batch"
    process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(law, rows, passes, new):
        process.stdin.write(f"{law} {rows} {passes} {int(new)}\n")
        process.stdin.flush()
        return int(process.stdout.readline())

    return ask


def python(law, rows, passes, new):
    alpha = np.arange(rows) * (4.0 / rows)
    out = None if new else tuple(np.ones(rows) for _ in range(3))
    kane.batch(law, alpha, out=out)
    at = time.perf_counter_ns()
    for _ in range(passes):
        kane.batch(law, alpha, out=out)
    return time.perf_counter_ns() - at


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--repeats", type=int, default=21)
    repeats = options.parse_args().repeats
    ask = rust()
    print(f"{'law':<20}{'rows':>9}  {'results':<12}{'Rust':>9}{'Python':>9}  ns a row{'ratio':>8}{'call':>10}")
    worst = 0.0
    for new in (False, True):
        for rows in (1_000, 1_000_000):
            passes = max(1, ROWS_TIMED // rows)
            for law in kane.batched():
                pairs = [(ask(law, rows, passes, new), python(law, rows, passes, new)) for _ in range(repeats)]
                of_rust = statistics.median(r for r, _ in pairs) / passes
                of_python = statistics.median(p for _, p in pairs) / passes
                ratio = statistics.median(p / r for r, p in pairs)
                if rows == 1_000_000:
                    worst = max(worst, ratio)
                call = f"{(of_python - of_rust) / 1000:7.2f} µs" if rows == 1_000 else ""
                print(
                    f"{law:<20}{rows:>9}  {'new columns' if new else 'written over':<12}"
                    f"{of_rust / rows:9.2f}{of_python / rows:9.2f}{ratio:18.3f}{call:>10}"
                )
    print(f"worst ratio at a million rows: {worst:.3f}; {'met' if worst <= TARGET else 'missed'}: {TARGET}")


if __name__ == "__main__":
    main()
