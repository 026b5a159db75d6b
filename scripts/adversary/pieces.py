#!/usr/bin/env python3
"""Random claims whose truth is known from how they are made, at their bounds and a little beyond them.

    python3 scripts/adversary/pieces.py --kane target/release/kane --claims 2000 --certificates

The families are aimed at ends of ranges, at conditions that share no variable, at points on circles and
hyperbolas, at means of few terms, and at sums of squares that vanish at irrational points alone. No other
program is asked: what is convex along each axis of a box is largest at a corner, 3u + 4v ≤ 5 on the circle, and
so on, and all bounds are attained. Ends with 1 if a verdict was wrong, or the second checker refuses a
certificate.
"""

import argparse
import itertools
import json
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from cells import minus, names_of, number, plus, power, relation, scaled, small, times, variable  # noqa: E402
from opinion import second_opinion  # noqa: E402

CLAIMS = 5  # a document
NAMES = ["x", "y", "z", "w", "u", "v"]
EPSILON = [Fraction(1, 10), Fraction(1, 100), Fraction(1, 1000)]


def bounded(rng, p, most):
    """A claim on p, whose largest value is `most`, and whether it is true."""
    kind = rng.randrange(4)
    if kind == 0:
        return (p, "<=", number(most)), True
    if kind == 1:
        return (p, "<", number(most)), False
    if kind == 2:
        return (p, "<", number(most + rng.choice(EPSILON))), True
    return (p, "<=", number(most - rng.choice(EPSILON))), False


def value(p, at):
    total = Fraction(0)
    for m, c in p.items():
        for name, k in m:
            c *= at[name] ** k
        total += c
    return total


# Families: each returns premises that some point satisfies, a conclusion, and whether it follows.


def box(rng):
    """Convex along each axis: largest at a corner."""
    names = NAMES[: rng.randint(2, 4)]
    ends = {}
    for name in names:
        low = Fraction(rng.randint(-3, 2), rng.choice([1, 1, 2]))
        ends[name] = (low, low + Fraction(rng.randint(1, 4), rng.choice([1, 1, 2, 3])))
    p = number(rng.randint(-2, 2))
    for _ in range(rng.randint(2, 5)):
        m = number(small(rng))
        for name in rng.sample(names, rng.randint(1, min(3, len(names)))):
            m = times(m, variable(name))
        p = plus(p, m)
    for name in names:
        if rng.random() < 0.4:
            p = plus(p, scaled(power(variable(name), 2), abs(small(rng))))
    most = max(value(p, dict(zip(names, corner))) for corner in itertools.product(*ends.values()))
    premises = [(variable(n), op, number(e)) for n, (a, b) in ends.items() for op, e in ((">=", a), ("<=", b))]
    said, truth = bounded(rng, p, most)
    return premises, said, truth


def component(rng, names):
    """Relations in two variables that some points satisfy, most of them with irrational coordinates."""
    a, b = (variable(n) for n in names)
    k = number(rng.choice([1, 2, 3, 5]))
    circle = (plus(power(a, 2), power(b, 2)), "=", k)
    return rng.choice(
        [
            [circle],
            [circle, (a, ">=", b)],
            [(times(a, b), "=", k), (a, ">", number(0))],
            [(power(a, 2), "=", k), (b, ">", a)],
            [(power(a, 3), "=", plus(b, k))],
            [(minus(power(a, 2), scaled(power(b, 2), 2)), "=", k)],
            [(a, ">", power(b, 2)), (plus(a, b), "<", number(3))],
        ]
    )


def components(rng):
    """Conditions that share no variable: each has points, and the claim speaks of one part or of two."""
    premises = [r for pair in (("x", "y"), ("z", "w")) for r in component(rng, pair)]
    u, v = variable("u"), variable("v")
    if rng.random() < 0.5:
        square = plus(power(minus(scaled(u, rng.randint(1, 3)), v), 2), power(minus(v, number(rng.randint(0, 2))), 2))
        said, truth = bounded(rng, scaled(square, -1), Fraction(0))
        return premises, said, truth
    # on the circle 3u + 4v ≤ 5
    premises.append((plus(power(u, 2), power(v, 2)), "=", number(1)))
    said, truth = bounded(rng, plus(scaled(u, 3), scaled(v, 4)), Fraction(5))
    return premises, said, truth


def conics(rng):
    """Circles and hyperbolas, with linear bounds that are attained at rational points."""
    total, most, premises = {}, Fraction(0), []
    for a, b in list(zip(NAMES[::2], NAMES[1::2]))[: rng.randint(1, 2)]:
        a, b = variable(a), variable(b)
        if rng.random() < 0.5:
            m, n, r = rng.choice([(3, 4, 5), (-5, 12, 13), (8, -15, 17), (1, 0, 1)])
            premises.append((plus(power(a, 2), power(b, 2)), "=", number(1)))
            total, most = plus(total, scaled(a, m), scaled(b, n)), most + r
        else:
            # (p·a)² − (q·b)² = k², a > 0: m·p·a + n·q·b ≥ r·k where m² − n² = r²
            p, q, k = rng.randint(1, 3), rng.randint(1, 3), rng.randint(1, 4)
            m, n, r = rng.choice([(5, 3, 4), (5, -4, 3), (13, 5, 12), (1, 0, 1)])
            premises.append((minus(scaled(power(a, 2), p * p), scaled(power(b, 2), q * q)), "=", number(k * k)))
            premises.append((a, ">", number(0)))
            total, most = plus(total, scaled(a, -m * p), scaled(b, -n * q)), most - r * k
    said, truth = bounded(rng, total, most)
    return premises, said, truth


def means(rng):
    """The mean of monomials in numbers that are not negative, and the one between them."""
    n = rng.choice([2, 3, 3, 4])
    names = NAMES[: rng.randint(n, 6)]
    powers = [{name: n * rng.randint(0, 1) + rng.choice([0, 0, n]) for name in names} for _ in range(n)]
    ends = []
    for row in powers:
        m = number(1)
        for name, k in row.items():
            m = times(m, power(variable(name), k))
        ends.append(m)
    middle = number(1)
    for name in names:
        middle = times(middle, power(variable(name), sum(row[name] for row in powers) // n))
    premises = [(variable(name), ">=", number(0)) for name in names]
    if rng.random() < 0.6:
        return premises, (plus(*ends), ">=", scaled(middle, n)), True
    return premises, (plus(*ends), ">=", scaled(middle, n + rng.choice(EPSILON))), False


def squares(rng):
    """A sum of squares that vanishes at a point with irrational coordinates, and nowhere below."""
    x, y, z = (variable(n) for n in "xyz")
    k = rng.choice([2, 3, 5])
    zero = rng.choice(
        [
            [minus(power(x, 2), number(k)), minus(y, x)],
            [minus(power(x, 2), number(k)), minus(times(x, y), number(1))],
            [plus(power(x, 3), power(y, 2)), plus(x, y, number(rng.randint(1, 2)))],
            [minus(power(x, 2), plus(x, number(1))), minus(y, power(x, 2)), minus(z, y)],
        ]
    )
    p = plus(*[scaled(power(q, 2), rng.choice([1, 1, 2])) for q in zero])
    if rng.random() < 0.5:
        p = plus(p, power(variable("w"), rng.choice([2, 4])))
    said, truth = bounded(rng, scaled(p, -1), Fraction(0))
    return [], said, truth


FAMILIES = {f.__name__: f for f in (box, components, conics, means, squares)}


def document(rng, title, families):
    """A document's text, and its claims as (label, family, claim, truth)."""
    claims, lines = [], []
    for i in range(CLAIMS):
        family = rng.choice(families)
        premises, said, truth = FAMILIES[family](rng)
        labels = [f"h{i}.{j}" for j in range(len(premises))]
        lines += [f"given {label}: {relation(r)}" for label, r in zip(labels, premises)]
        lines.append(f"claim c{i}: {relation(said)}" + (f"    from {', '.join(labels)}" if labels else ""))
        claims.append((f"c{i}", family, (premises, said), truth))
    names = sorted({n for _, _, c, _ in claims for n in names_of(c)})
    return "\n".join([f"# {title}", "", "```kane", "var " + ", ".join(names), *lines, "```", ""]), claims


def run(args):
    tally, wrong, index, began = Counter(), [], 0, time.monotonic()
    families = args.family or list(FAMILIES)
    while tally["claims"] < args.claims:
        rng = random.Random(f"{args.seed}/{index}")
        source, claims = document(rng, f"pieces {args.seed}/{index}", families)
        with tempfile.TemporaryDirectory() as folder:
            file, out = Path(folder, "d.md"), Path(folder, "out")
            file.write_text(source, encoding="utf-8")
            command = [args.kane, "audit", str(file), "--format", "json", *(["--certificates", str(out)] if args.certificates else [])]
            done = subprocess.run(command, capture_output=True, text=True)
            if done.returncode not in (0, 1):
                wrong.append(f"document {index}: exit {done.returncode}: {done.stderr[:300]}")
            else:
                report = json.loads(done.stdout)["documents"][0]
                shown = {s["label"]: s["verdict"] for s in report["statements"] if s["kind"] == "claim"}
                if args.certificates:
                    refused, accepted = second_opinion(source, Path(out, "d.cert.json"), list(shown.values()))
                    tally["links that the second checker accepts"] += accepted
                    wrong += [f"document {index}: second checker: {line}" for line in refused]
                for label, family, claim, truth in claims:
                    verdict = shown[label]
                    tally[f"{family} {'true' if truth else 'false'}: {verdict}"] += 1
                    if verdict not in ("undecided", "proved" if truth else "refuted"):
                        wrong.append(f"document {index}, {label} is {verdict}, and it is {truth}")
                    elif args.show_open and verdict == "undecided":
                        print("open:", family, "|", "; ".join(map(relation, claim[0])), "|-", relation(claim[1]), flush=True)
        tally["claims"] += CLAIMS
        index += 1
    print(f"{tally['claims']} claims, {time.monotonic() - began:.0f} s")
    for name, n in sorted(tally.items()):
        print(f"  {name}: {n}")
    print(f"wrong: {len(wrong)}")
    for line in wrong[:30]:
        print("  " + line)
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kane", required=True, help="the program")
    parser.add_argument("--claims", type=int, default=2000)
    parser.add_argument("--seed", default="pieces")
    parser.add_argument("--family", action="append", choices=list(FAMILIES), help="only these families")
    parser.add_argument("--certificates", action="store_true", help="put each certificate to the second checker too")
    parser.add_argument("--show-open", action="store_true", help="print the claims that stay undecided")
    sys.exit(run(parser.parse_args()))


if __name__ == "__main__":
    main()
