#!/usr/bin/env python3
"""Random claims on polynomials whose points lie in small or irrational places, against z3.

    python3 scripts/adversary/cells.py --kane target/release/kane --claims 2000 --certificates

The families are aimed at the search among cells, at elimination by cases and at points by approach:
plane regions, common zeros with irrational coordinates, curves that meet, slivers beside an optimum,
quadratic polynomials with parameters, linear ones with parametric coefficients, and boundaries in many
variables. Polynomials are dictionaries of fractions here, and what is asked of z3 is written from them,
not from the document. Ends with 1 if a verdict was wrong, or the second checker refuses a certificate.
"""

import argparse
import json
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from opinion import second_opinion  # noqa: E402

CLAIMS = 10  # a document
SECONDS = 4  # of z3 a question

# A polynomial maps monomials, tuples of (name, power) by name, to fractions.


def number(q):
    return {(): Fraction(q)} if q else {}


def variable(name):
    return {((name, 1),): Fraction(1)}


def plus(*parts):
    out = {}
    for p in parts:
        for m, c in p.items():
            out[m] = out.get(m, Fraction(0)) + c
    return {m: c for m, c in out.items() if c}


def times(p, q):
    out = {}
    for m, c in p.items():
        for n, d in q.items():
            powers = dict(m)
            for name, k in n:
                powers[name] = powers.get(name, 0) + k
            key = tuple(sorted(powers.items()))
            out[key] = out.get(key, Fraction(0)) + c * d
    return {m: c for m, c in out.items() if c}


def scaled(p, q):
    return times(p, number(q))


def minus(p, q):
    return plus(p, scaled(q, -1))


def power(p, n):
    out = number(1)
    for _ in range(n):
        out = times(out, p)
    return out


def text(p):
    """As documents write it."""
    if not p:
        return "0"
    out = ""
    for m, c in sorted(p.items(), key=lambda t: (-sum(k for _, k in t[0]), t[0])):
        factors = [name if k == 1 else f"{name}^{k}" for name, k in m]
        size = abs(c)
        if size != 1 or not factors:
            factors.insert(0, str(size) if size.denominator == 1 else f"{size.numerator}/{size.denominator}")
        term = "*".join(factors)
        out += (" - " if c < 0 else " + ") + term if out else ("-" if c < 0 else "") + term
    return out


def smt(p):
    """As z3 reads it."""

    def rational(q):
        body = f"{abs(q.numerator)}.0" if q.denominator == 1 else f"(/ {abs(q.numerator)}.0 {q.denominator}.0)"
        return f"(- {body})" if q < 0 else body

    terms = []
    for m, c in p.items():
        factors = [rational(c)] + [name for name, k in m for _ in range(k)]
        terms.append(f"(* {' '.join(factors)})" if len(factors) > 1 else factors[0])
    return f"(+ {' '.join(terms)} 0.0)" if terms else "0.0"


def relation(r):
    p, op, q = r
    return f"{text(p)} {op} {text(q)}"


def formula(r):
    p, op, q = r
    if op == "!=":
        return f"(not (= {smt(p)} {smt(q)}))"
    return f"({op} {smt(p)} {smt(q)})"


# Families: each returns premises and a conclusion.

x, y, z = (variable(n) for n in "xyz")
NAMES = ["x", "y", "z", "u", "v", "w"]


def small(rng):
    return Fraction(rng.choice([-3, -2, -1, -1, 1, 1, 2, 3, 5]), rng.choice([1, 1, 1, 1, 2, 3]))


def form(rng, names, degree, terms):
    """A random polynomial."""
    out = number(small(rng)) if rng.random() < 0.7 else {}
    for _ in range(terms):
        m = number(small(rng))
        for _ in range(rng.randint(1, degree)):
            m = times(m, variable(rng.choice(names)))
        out = plus(out, m)
    return out or variable(names[0])


def comparison(rng, weak=False):
    return rng.choice([">=", "<="] if weak else [">", ">=", "<", "<="])


def plane(rng):
    """Regions of the plane."""
    premises = [(form(rng, ["x", "y"], 2, rng.randint(1, 3)), comparison(rng), number(0)) for _ in range(rng.randint(1, 3))]
    return premises, (form(rng, ["x", "y"], rng.choice([1, 2, 2, 3]), rng.randint(1, 3)), comparison(rng), number(small(rng)))


def zeros(rng):
    """A sum of squares that vanishes, or not, at points with irrational coordinates."""
    p = minus(power(x, rng.choice([2, 2, 3])), number(rng.choice([2, 3, 5])))
    q = rng.choice([minus(power(y, 2), number(rng.choice([2, 3, 6, 7]))), minus(times(y, y), x), minus(times(x, y), number(rng.choice([1, 2])))])
    total = plus(scaled(power(p, 2), rng.choice([1, 2])), power(q, 2))
    if rng.random() < 0.3:
        total = plus(total, power(minus(plus(x, y), number(rng.choice([0, 3]))), 2))
    return [], (total, rng.choice([">", ">", ">=", "!="]), number(0))


def curves(rng):
    """Curves that meet, and something said of where they meet."""
    conics = [
        minus(plus(power(x, 2), power(y, 2)), number(rng.choice([1, 2, 3, 5]))),
        minus(y, plus(power(x, 2), scaled(x, rng.choice([0, 1, -1])))),
        minus(times(x, y), number(rng.choice([1, 2, -1]))),
        minus(plus(power(x, 2), scaled(power(y, 2), 2)), number(rng.choice([3, 4]))),
        minus(power(x, 3), plus(y, number(rng.choice([0, 1])))),
    ]
    a, b = rng.sample(conics, 2)
    said = form(rng, ["x", "y"], rng.choice([1, 1, 2]), 2)
    return [(a, "=", number(0)), (b, "=", number(0))], (said, rng.choice([">", "<", ">=", "<=", "!="]), number(small(rng)))


def sliver(rng):
    """An optimum on a disk or a box, a little moved."""
    a, b = rng.randint(1, 5), rng.randint(1, 5)
    best = a * a + b * b
    # a·x + b·y ≤ √(a² + b²) on the disk
    root = Fraction(int((best * 10**8) ** 0.5), 10**4)
    off = Fraction(rng.choice([-1, 1, -10, 10, -100, 100]), 10**4)
    on = rng.choice(["<=", "="])
    disk = (plus(power(x, 2), power(y, 2)), on, number(1))
    return [disk], (plus(scaled(x, a), scaled(y, b)), rng.choice(["<", "<="]), number(root + off))


def quadratic(rng):
    """a·x² + b·x + c with what decides its sign, or nearly that."""
    a, b, c = (rng.choice([variable(n), variable(n), number(small(rng))]) for n in "abc")
    p = plus(times(a, power(x, 2)), times(b, x), c)
    d = minus(power(b, 2), scaled(times(a, c), 4))
    kind = rng.randrange(5)
    if kind == 0:
        return [(p, "=", number(0))], (d, rng.choice([">=", ">=", ">"]), number(0))
    if kind == 1:
        return [(a, rng.choice([">", ">="]), number(0)), (d, rng.choice(["<", "<="]), number(0))], (p, rng.choice([">", ">="]), number(0))
    if kind == 2:
        at = small(rng)
        there = plus(scaled(a, at * at), scaled(b, at), c)
        return [(a, ">", number(0)), (there, "<", number(0))], (d, rng.choice([">", ">="]), number(0))
    if kind == 3:
        ends = [plus(scaled(a, k * k), scaled(b, k), c) for k in (0, 1)]
        bent = (a, rng.choice(["<=", "<=", ">="]), number(0))
        return [bent, *[(e, ">=", number(0)) for e in ends], (x, ">=", number(0)), (x, "<=", number(1))], (p, rng.choice([">=", ">="]), number(0))
    return [(p, rng.choice(["<", "<="]), number(0)), (a, ">", number(0))], (d, rng.choice([">=", ">"]), number(0))


def linear(rng):
    """Linear in x with coefficients that vary: between two bounds, or not."""
    a, b, c, e = (variable(n) for n in "abce")
    signs = rng.choice([[(a, ">", number(0)), (b, ">", number(0))], [(a, ">=", number(0)), (b, ">", number(0))], [(a, ">", number(0))]])
    low = (minus(times(a, x), c), rng.choice([">", ">="]), number(0))
    high = (minus(times(b, x), e), rng.choice(["<", "<="]), number(0))
    said = (minus(times(e, a), times(b, c)), rng.choice([">", ">=", ">="]), number(0))
    if rng.random() < 0.3:
        said = (plus(said[0], number(rng.choice([1, -1]))), said[1], said[2])
    return [*signs, low, high], said


def boundary(rng):
    """Many variables, and a claim that is false, or true, between two boundaries."""
    n = rng.randint(3, 6)
    names = NAMES[:n]
    square = plus(*[power(variable(m), 2) for m in names])
    total = plus(*[scaled(variable(m), rng.choice([1, 1, 2])) for m in names])
    weights = sum(c * c for c in total.values())
    root = Fraction(int((weights * 10**6) ** 0.5), 10**3)
    off = rng.choice([Fraction(-1, 10), Fraction(-1, 50), Fraction(1, 50), Fraction(-1, 3)])
    premises = [(square, rng.choice(["<=", "<="]), number(1))]
    if rng.random() < 0.3:
        premises.append((times(variable(names[0]), variable(names[1])), ">=", number(Fraction(1, 20))))
    return premises, (total, "<=", number(root + off))


FAMILIES = {f.__name__: f for f in (plane, zeros, curves, sliver, quadratic, linear, boundary)}


def names_of(claim):
    premises, conclusion = claim
    return sorted({name for p, _, q in [*premises, conclusion] for side in (p, q) for m in side for name, _ in m})


def document(rng, title, families):
    """A document's text, and its claims as (label, family, claim)."""
    claims, lines = [], []
    for i in range(CLAIMS):
        family = rng.choice(families)
        claim = FAMILIES[family](rng)
        labels = []
        for j, r in enumerate(claim[0]):
            labels.append(f"h{i}.{j}")
            lines.append(f"given {labels[-1]}: {relation(r)}")
        cited = f"    from {', '.join(labels)}" if labels else ""
        lines.append(f"claim c{i}: {relation(claim[1])}{cited}")
        claims.append((f"c{i}", family, claim))
    names = sorted({n for _, _, c in claims for n in names_of(c)})
    return "\n".join([f"# {title}", "", "```kane", "var " + ", ".join(names), *lines, "```", ""]), claims


def asked(relations, negated):
    """Whether z3 finds a common point of the relations and of the opposite of one: sat, unsat, unknown."""
    parts = [formula(r) for r in relations] + ([f"(not {formula(negated)})"] if negated else [])
    names = names_of((relations, negated or relations[0])) if relations or negated else []
    lines = ["(set-logic QF_NRA)", *[f"(declare-const {n} Real)" for n in names], *[f"(assert {p})" for p in parts], "(check-sat)"]
    done = subprocess.run(["z3", f"-T:{SECONDS}", "-in"], input="\n".join(lines), capture_output=True, text=True)
    return done.stdout.split("\n")[0].strip() if done.stdout else "unknown"


def wrong_verdict(verdict, claim, tally, family):
    """What is wrong with a verdict, by z3."""
    premises, conclusion = claim
    against = asked(premises, conclusion)
    truth = {"unsat": "true", "sat": "false"}.get(against, "unknown")
    tally[f"{family} {truth}: {verdict}"] += 1
    if verdict == "proved" and against == "sat":
        return "proved, and z3 has a point against it"
    if verdict in ("refuted", "ill-defined") and against == "unsat":
        return f"{verdict}, and z3 says that there is no point against it"
    if verdict == "vacuous" and premises and asked(premises, None) == "sat":
        return "vacuous, and z3 has a point for the premises"
    return None


def run(args):
    tally, wrong, slow, index, began = Counter(), [], [], 0, time.monotonic()
    families = args.family or list(FAMILIES)
    while tally["claims"] < args.claims:
        rng = random.Random(f"{args.seed}/{index}")
        source, claims = document(rng, f"cells {args.seed}/{index}", families)
        with tempfile.TemporaryDirectory() as folder:
            file, out = Path(folder, "d.md"), Path(folder, "out")
            file.write_text(source, encoding="utf-8")
            command = [args.kane, "audit", str(file), "--format", "json", *(["--certificates", str(out)] if args.certificates else [])]
            start = time.monotonic()
            done = subprocess.run(command, capture_output=True, text=True)
            took = time.monotonic() - start
            if took > 10 * CLAIMS:
                slow.append(f"document {index}: {took:.0f} s")
            if done.returncode not in (0, 1):
                wrong.append(f"document {index}: exit {done.returncode}: {done.stderr[:300]}")
            else:
                report = json.loads(done.stdout)["documents"][0]
                shown = {s["label"]: s["verdict"] for s in report["statements"] if s["kind"] == "claim"}
                if args.certificates:
                    refused, accepted = second_opinion(source, Path(out, "d.cert.json"), list(shown.values()))
                    tally["links that the second checker accepts"] += accepted
                    wrong += [f"document {index}: second checker: {line}" for line in refused]
                for label, family, claim in claims:
                    said = wrong_verdict(shown[label], claim, tally, family)
                    if said:
                        wrong.append(f"document {index}, {label} is {said}")
                    elif args.show_open and shown[label] == "undecided":
                        print("open:", family, "|", "; ".join(map(relation, claim[0])), "|-", relation(claim[1]), flush=True)
        tally["claims"] += CLAIMS
        index += 1
    print(f"{tally['claims']} claims, {time.monotonic() - began:.0f} s")
    for name, n in sorted(tally.items()):
        print(f"  {name}: {n}")
    for line in slow:
        print("  slow:", line)
    print(f"wrong: {len(wrong)}")
    for line in wrong[:30]:
        print("  " + line)
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kane", required=True, help="the program")
    parser.add_argument("--claims", type=int, default=2000)
    parser.add_argument("--seed", default="cells")
    parser.add_argument("--family", action="append", choices=list(FAMILIES), help="only these families")
    parser.add_argument("--certificates", action="store_true", help="put each certificate to the second checker too")
    parser.add_argument("--show-open", action="store_true", help="print the claims that stay undecided")
    args = parser.parse_args()
    if not shutil.which("z3"):
        sys.exit("z3 is not installed: nothing would judge the verdicts")
    sys.exit(run(args))


if __name__ == "__main__":
    main()
