"""Worst inputs against plain sampling: sampled.py KANE FILE.fpcore [SAMPLES [SEED]]

Every core of a file goes to `kane stability` alone. Then its absolute error in binary64 is taken at inputs that are
drawn evenly over the ranges, each between its least and its greatest float and as `:pre` allows, as exact fractions by
the evaluators of `rounding.py`, which share nothing with the program.

Wrong is an error above the bound that is printed, and a worst input whose error is below nine tenths of the greatest
that was drawn. Cores with ranges or operations that the program does not read are listed and count for nothing.
"""

import json
import random
import resource
import subprocess
import sys
import tempfile
from fractions import Fraction
from pathlib import Path

from rounding import Exact, Machine, Undefined, Unknown, at_place, ends_of, error_at, holds, read

FORM = "f64"


def told(core):
    """A list of lists as an s-expression."""
    return core if isinstance(core, str) else "(" + " ".join(told(part) for part in core) + ")"


def strings_kept(text):
    """The text without comments, and with the blanks in its strings replaced, so that each is one token."""
    lines = [line.split(";")[0] for line in text.splitlines()]
    parts = " ".join(lines).split('"')
    for i in range(1, len(parts), 2):
        parts[i] = "".join(c if c.isalnum() else "_" for c in parts[i])
    return '"'.join(parts)


def ask(kane, text):
    """The report on one core, or what the program says against it, and the seconds of the processor that it took."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "one.fpcore"
        path.write_text(text + "\n")
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        run = subprocess.run([kane, "stability", str(path), "--format", "json"], capture_output=True, text=True,
                             check=False)
        took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if run.returncode not in (0, 1):
        return None, run.stderr.strip().splitlines()[0] if run.stderr else "nothing", took
    return json.loads(run.stdout)["formulas"][0], "", took


def ranges_of(pre):
    """The ranges that conjuncts `(<= 1 x 2)` of a condition say."""
    if pre[0] == "and":
        return {name: ends for part in pre[1:] for name, ends in ranges_of(part).items()}
    if pre[0] == "<=" and len(pre) == 4 and isinstance(pre[2], str):
        return {pre[2]: (pre[1], pre[3])}
    return {}


def sampled(core, samples, rng):
    """The greatest error at so many inputs that `:pre` allows, and at how many there was one."""
    names, body = list(core[1]), core[-1]
    pre = core[core.index(":pre") + 1] if ":pre" in core else "TRUE"
    ranges = ranges_of(pre)
    ends = [[at_place(p, FORM) for p in ends_of(*ranges[name], FORM)] for name in names]
    machine, greatest, met = Machine(FORM), Fraction(0), 0
    for _ in range(samples):
        at = [rng.uniform(*end) for end in ends]
        try:
            if not holds(pre, {n: (Fraction(x),) * 2 for n, x in zip(names, at)}, Exact()):
                continue
            error, _ulps = error_at(body, names, at, FORM, machine)
        except (Undefined, Unknown):
            continue
        if error is not None:
            met += 1
            greatest = max(greatest, error)
    return greatest, met


def main():
    kane, file, *rest = sys.argv[1:]
    samples, seed = int(rest[0]) if rest else 2000, rest[1] if len(rest) > 1 else "sampled"
    wrong = judged = left = 0
    print(f"{'core':28} {'at most':>10} {'found':>10} {'drawn':>10} {'found/drawn':>11} {'seconds':>8}")
    for i, core in enumerate(read(strings_kept(Path(file).read_text()))):
        name = core[core.index(":name") + 1].strip('"') if ":name" in core else f"core {i + 1}"
        properties = core.index(":precision") if ":precision" in core else None
        if properties is not None:
            core[properties + 1] = "binary64"
        else:
            core[2:2] = [":precision", "binary64"]
        report, why, took = ask(kane, told(core))
        if report is None or not report["formats"]:
            left += 1
            print(f"{name[:28]:28} not read: {why[:90]}")
            continue
        if ":pre" not in core or any(name not in ranges_of(core[core.index(":pre") + 1]) for name in core[1]):
            left += 1
            print(f"{name[:28]:28} no ranges to draw from")
            continue
        of, = report["formats"]
        bound, found = of["error_at_most"], of["error_found"]
        drawn, met = sampled(core, samples, random.Random(f"{seed}/{i}"))
        judged += 1
        here = Fraction(found["error"]) if found and found["error"] is not None else Fraction(0)
        fault = ""
        if bound is not None and drawn > Fraction(bound):
            fault = "ABOVE THE BOUND"
        elif drawn > 0 and here < drawn * Fraction(9, 10):
            fault = "BELOW NINE TENTHS"
        wrong += bool(fault)
        share = f"{float(here / drawn):.2f}" if drawn else "-"
        most = "none" if bound is None else f"{float(Fraction(bound)):.3e}"
        print(f"{name[:28]:28} {most:>10} {float(here):>10.3e} {float(drawn):>10.3e} {share:>11} {took:8.1f} {fault}"
              f"{'' if met == samples else f' ({met} inputs)'}")
    print(f"{judged} cores, {wrong} wrong, {left} not read; {samples} inputs each")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
