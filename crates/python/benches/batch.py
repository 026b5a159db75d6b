"""What a row of a law over a column costs from Python; `cargo bench --bench impact` times the same in Rust.

Build the wheel with `maturin build --release` first. The best of many rounds, into columns that are there.
"""

import time

import kane
import numpy as np

for rows in (10_000, 1_000_000):
    alpha = np.arange(rows) * 4.0 / rows
    out = tuple(np.zeros(rows) for _ in range(3))
    for law in kane.batched():
        best = float("inf")
        for _ in range(min(40_000_000 // rows, 400)):
            at = time.perf_counter()
            kane.batch(law, alpha, out=out)
            best = min(best, time.perf_counter() - at)
        print(f"{law:<20}{rows:>9} rows  {best * 1e9 / rows:6.2f} ns a row")
