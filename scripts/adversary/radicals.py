#!/usr/bin/env python3
"""Random limits of expressions with roots, right ones and wrong ones, against decimal evaluation.

    python3 scripts/adversary/radicals.py --kane target/release/kane --claims 10000 --certificates

The oracle shares nothing with the program, nor with the other families of this folder: it evaluates
the expression in thousands of decimal digits at x = a ± 10^-100, 10^-200 and 10^-400, or ±10^100 …
An expression in roots that lie at most three deep is a series in x^(1/8) near each point, so from the
first value to the last the distance from a limit falls below 10^-20 of what it was, and what is
infinite grows by as much. What does not behave so judges nothing. Ends with 1 if a verdict was wrong.
"""

import argparse
import json
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from decimal import Context, Decimal, DivisionByZero, InvalidOperation, localcontext
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from opinion import second_opinion  # noqa: E402

DIGITS = 3000
DEPTHS = (100, 200, 400)
CLAIMS = 10  # a document
POINTS = ["oo", "oo", "-oo", "0", "0", "0", "1", "2", "-1", "1/2"]
NEAR = Decimal(10) ** -20
EXACT = Context(prec=DIGITS, Emax=10**9, Emin=-(10**9))


class Undefined(Exception):
    """A root of what is negative, or a division by zero."""


# Expressions are tuples: ("n", Fraction), ("v", name), (operator, left, right), ("sqrt", e), ("^", e, n).


def number(q):
    return ("n", Fraction(q))


def text(e, outer=0):
    """The expression as documents write it."""
    kind = e[0]
    if kind == "n":
        q = e[1]
        out, level = (str(q), 3 if q >= 0 and q.denominator == 1 else 1)
    elif kind == "v":
        out, level = e[1], 4
    elif kind == "sqrt":
        out, level = f"sqrt({text(e[1])})", 4
    elif kind == "^":
        out, level = f"{text(e[1], 4)}^{e[2]}", 3
    else:
        level = 1 if kind in "+-" else 2
        out = f"{text(e[1], level)} {kind} {text(e[2], level + 1)}"
    return out if level >= outer else f"({out})"


def value(e, at):
    """The value in decimals."""
    kind = e[0]
    if kind == "n":
        return Decimal(e[1].numerator) / Decimal(e[1].denominator)
    if kind == "v":
        return at[e[1]]
    if kind == "sqrt":
        inside = value(e[1], at)
        if inside < 0:
            raise Undefined
        return inside.sqrt()
    if kind == "^":
        return value(e[1], at) ** e[2]
    if kind in ("neg", "abs"):
        a = value(e[1], at)
        return -a if kind == "neg" else abs(a)
    if kind == "cases":
        for guards, body in e[1]:
            if all(true(guard, at) for guard in guards):
                return value(body, at)
        if e[2] is None:
            raise Undefined
        return value(e[2], at)
    a, b = value(e[1], at), value(e[2], at)
    if kind in ("min", "max"):
        return min(a, b) if kind == "min" else max(a, b)
    if kind == "/":
        if b == 0:
            raise Undefined
        return a / b
    return {"+": a.__add__, "-": a.__sub__, "*": a.__mul__}[kind](b)


def true(relation, at):
    """Whether a relation holds."""
    sign, a, b = relation[0], value(relation[1], at), value(relation[2], at)
    return {"=": a == b, "!=": a != b, "<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b}[sign]


def rational(rng):
    return Fraction(rng.choice([1, 1, 1, 2, 3, 4, 5, 9, 1, 3]), rng.choice([1, 1, 1, 1, 2, 3]))


def signed(rng):
    return rational(rng) * rng.choice([1, 1, -1])


def coefficient(rng, constants):
    if constants and rng.random() < 0.35:
        return ("v", rng.choice(constants))
    return number(rational(rng))


def near(rng, point):
    """x, or how far x is from the point."""
    if point in ("oo", "-oo", "0"):
        return ("v", "x")
    c = Fraction(point)
    apart = ("-", ("v", "x"), number(c)) if c > 0 else ("+", ("v", "x"), number(-c))
    return apart if rng.random() < 0.7 else ("v", "x")


def polynomial(rng, t, constants, degree):
    """A polynomial in t with random terms."""
    out = None
    for n in sorted(rng.sample(range(degree + 1), rng.randint(1, min(3, degree + 1))), reverse=True):
        c = coefficient(rng, constants)
        power = number(1) if n == 0 else t if n == 1 else ("^", t, n)
        term = c if n == 0 else power if c == number(1) else ("*", c, power)
        out = term if out is None else (rng.choice("++-"), out, term)
    return out


def radicand(rng, t, constants, point, depth):
    """Something that is not negative near the point, most of the time."""
    r = rng.random()
    if depth > 1 and r < 0.25:
        inner = ("sqrt", radicand(rng, t, constants, point, depth - 1))
        return ("+", inner, polynomial(rng, t, constants, 1)) if rng.random() < 0.7 else inner
    if r < 0.75 and point in ("oo", "-oo"):
        return ("+", ("^", t, 2), polynomial(rng, t, constants, 1))
    if r < 0.75:
        if constants and rng.random() < 0.3:
            return ("+", ("v", rng.choice(constants)), polynomial(rng, t, constants, 2))
        return ("+", number(rational(rng) ** 2 if rng.random() < 0.6 else rational(rng)), polynomial(rng, t, constants, 2))
    if r < 0.85:
        return ("/", polynomial(rng, t, constants, 2), ("+", ("^", t, 2), number(1)))
    return polynomial(rng, t, constants, 2)


def root(rng, t, constants, point):
    return ("sqrt", radicand(rng, t, constants, point, rng.choice([1, 1, 1, 2])))


def expression(rng, point, constants):
    """Differences of roots, their quotients and products with powers of t, and sums of such."""
    t = near(rng, point)
    a, b = root(rng, t, constants, point), root(rng, t, constants, point)
    plain = polynomial(rng, t, constants, rng.choice([1, 1, 2]))
    shape = rng.random()
    if shape < 0.2:
        e = ("-", a, plain)
    elif shape < 0.4:
        e = ("-", a, b)
    elif shape < 0.5:
        e = ("/", a, plain)
    elif shape < 0.6:
        e = ("/", a, b)
    elif shape < 0.7:
        e = ("/", ("-", a, number(rational(rng))), t)
    elif shape < 0.8:
        e = ("/", ("-", a, b), t)
    elif shape < 0.87:
        e = ("*", t, ("-", a, plain))
    elif shape < 0.94:
        e = ("/", ("-", a, plain), ("+", b, number(1)))
    else:
        e = ("*", a, ("+", b, plain))
    if rng.random() < 0.1:
        e = ("+", e, ("/", number(rational(rng)), ("+", b, number(1))))
    return e


def approaches(point, side):
    """Functions from a depth to the value of x."""
    if point == "oo":
        return [lambda k: Decimal(10) ** k]
    if point == "-oo":
        return [lambda k: -(Decimal(10) ** k)]
    q = Fraction(point)

    def beside(sign):
        return lambda k: Decimal(q.numerator) / Decimal(q.denominator) + sign * Decimal(10) ** -k

    return [beside(sign) for sign in (1, -1) if side in ("", "+" if sign > 0 else "-")]


def behaviour(e, x, constants):
    """The last values along one approach, or "undefined"."""
    try:
        return [value(e, {"x": x(k), **constants}) for k in DEPTHS]
    except Undefined:
        return "undefined"


def judged(seen, target, constants):
    """Whether values tend to the target: True, False, or None if that is not clear."""
    if seen == "undefined":
        return False
    _, middle, last = seen
    if abs(last) > 1 / NEAR and abs(last) > abs(middle) / NEAR:
        return target == ("oo" if last > 0 else "-oo")
    settled = abs(last - middle) < NEAR
    if target in ("oo", "-oo"):
        return False if settled else None
    try:
        aim = value(target, constants)
    except Undefined:
        return False
    before, now = abs(middle - aim), abs(last - aim)
    if now < NEAR and now <= before:
        return True
    return False if settled and now > Decimal(10) ** -6 else None


def guess(limit):
    """A closed form of a number, if a small one fits: a rational, or the root of one."""
    with localcontext(EXACT):
        for square in (False, True):
            q = Fraction(limit * limit if square else limit).limit_denominator(5000)
            close = Decimal(q.numerator) / Decimal(q.denominator)
            if abs(q.numerator) < 10**6 and abs((limit * limit if square else limit) - close) < NEAR:
                if not square:
                    return number(q)
                return ("sqrt", number(q)) if limit > 0 else ("-", number(0), ("sqrt", number(q)))
    return None


def target_of(rng, e, point, side, constants):
    """What the limit seems to be, or something else."""
    seen = behaviour(e, approaches(point, side)[0], constants)
    if seen == "undefined":
        return rng.choice([number(signed(rng)), number(0), "oo"])
    last = seen[-1]
    if abs(last) > 1 / NEAR:
        right = "oo" if last > 0 else "-oo"
        if rng.random() < 0.6:
            return right
        return rng.choice(["-oo" if right == "oo" else "oo", number(0), number(signed(rng))])
    right = guess(last)
    if right is None:
        return None
    names = [("v", n) for n in constants]
    written = [right]
    for name in names:
        v = Fraction(constants[name[1]])
        if right[0] == "n":
            q = right[1] / v
            written += [name if q == 1 else ("*", number(q), name)] if q else []
        elif right[0] == "sqrt":
            q = right[1][1] / v
            written += [("sqrt", name if q == 1 else ("*", number(q), name))]
    right = rng.choice(written[-1:] + written)
    r = rng.random()
    if r < 0.55:
        return right
    off = number(Fraction(1, rng.choice([2, 3, 10, 1000, 100000])))
    wrong = [("+", right, off), ("-", right, off), ("*", number(-1), right), ("*", number(2), right), number(0), number(signed(rng))]
    return rng.choice(wrong + ["oo", "-oo"])


def document(rng, title):
    """A document's text, and its claims as (label, expression, point, side, target, constants)."""
    constants = [n for n in ("a", "b") if rng.random() < 0.35]
    lines = [f"# {title}", "", "```kane", "var x" + "".join(f", {n} > 0" for n in constants)]
    claims = []
    while len(claims) < CLAIMS:
        point = rng.choice(POINTS)
        side = "" if "oo" in point else rng.choice(["+", "+", "-", ""])
        used = constants if rng.random() < 0.4 else []
        e = expression(rng, point, used)
        chosen = {n: Decimal(rng.choice([1, 2, 3, 5])) for n in used}
        target = target_of(rng, e, point, side, chosen)
        if target is None:
            continue
        label = f"c{len(claims)}"
        aim = target if isinstance(target, str) else text(target)
        lines.append(f"claim {label}: {text(e)} -> {aim} as x -> {point}{side}")
        claims.append((label, e, point, side, target, used))
    return "\n".join([*lines, "```", ""]), claims


def truth(rng, claim):
    """Whether a claim holds at all values of its constants that are tried; None if that is not clear."""
    _, e, point, side, target, used = claim
    tried = [{n: Decimal(rng.choice([1, 2, 3, 4, 7, 10])) / rng.choice([1, 1, 2, 3]) for n in used} for _ in range(6 if used else 1)]
    found = [judged(behaviour(e, x, constants), target, constants) for constants in tried for x in approaches(point, side)]
    if False in found:
        return False
    return None if None in found else True


def run(args):
    tally, wrong, index, began = Counter(), [], args.start, time.monotonic()
    while tally["claims"] < args.claims:
        batch = []
        for index in range(index, index + 10):
            rng = random.Random(f"{args.seed}/{index}")
            batch.append((index, rng, *document(rng, f"roots {args.seed}/{index}")))
        index += 1
        with tempfile.TemporaryDirectory() as folder:
            files = []
            for i, _, source, _ in batch:
                files.append(Path(folder, f"{i}.md"))
                files[-1].write_text(source, encoding="utf-8")
            out = Path(folder, "out")
            command = [args.kane, "audit", *map(str, files), "--format", "json"]
            command += ["--budget", str(args.budget)] if args.budget else []
            done = subprocess.run(command + (["--certificates", str(out)] if args.certificates else []), capture_output=True, text=True)
            if done.returncode not in (0, 1):
                wrong.append(f"document {batch[0][0]} ff.: exit {done.returncode}: {done.stderr[:300]}")
                tally["claims"] += len(batch) * CLAIMS
                continue
            reports = json.loads(done.stdout)["documents"]
            for (i, rng, source, claims), report in zip(batch, reports):
                shown = {s["label"]: s["verdict"] for s in report["statements"] if s["kind"] == "claim"}
                if args.certificates:
                    refused, accepted = second_opinion(source, Path(out, f"{i}.cert.json"), list(shown.values()))
                    tally["links that the second checker accepts"] += accepted
                    wrong += [f"document {i}: second checker: {line}" for line in refused]
                for claim in claims:
                    judge(tally, wrong, rng, i, claim, shown[claim[0]])
        if time.monotonic() - args.told > 60:
            args.told = time.monotonic()
            print(f"{tally['claims']} claims, {len(wrong)} wrong", flush=True)
    print(f"{tally['claims']} claims, {time.monotonic() - began:.0f} s")
    for name, n in sorted(tally.items()):
        print(f"  {name}: {n}")
    print(f"wrong: {len(wrong)}")
    for line in wrong[:30]:
        print("  " + line)
    return 1 if wrong else 0


def judge(tally, wrong, rng, i, claim, verdict):
    label, e, point, side, target, used = claim
    tally["claims"] += 1
    with localcontext(EXACT):
        holds = truth(rng, claim)
    kind = {True: "right", False: "wrong", None: "unclear"}[holds]
    tally[f"{kind} claim{' with constants' if used else ''}: {verdict}"] += 1
    refuted = verdict in ("refuted", "ill-defined")
    # With constants a claim may hold at all values that are tried, and fail at others.
    if (verdict == "proved" and holds is False) or (refuted and holds and not used) or verdict == "vacuous":
        aim = target if isinstance(target, str) else text(target)
        wrong.append(f"document {i}, {label} is {verdict}: {text(e)} -> {aim} as x -> {point}{side}")


def selftest():
    """Limits that are known by hand."""
    x = ("v", "x")
    root_ = ("sqrt", ("+", ("^", x, 2), x))
    with localcontext(EXACT):
        half = ("claim", ("-", root_, x), "oo", "", number(Fraction(1, 2)), [])
        rng = random.Random(0)
        assert truth(rng, half) is True
        assert truth(rng, (*half[:4], number(Fraction(501, 1000)), [])) is False
        assert truth(rng, (*half[:2], "-oo", "", number(Fraction(1, 2)), [])) is False
        assert truth(rng, (*half[:2], "-oo", "", "oo", [])) is True
        assert truth(rng, ("claim", ("sqrt", x), "0", "+", number(0), [])) is True
        assert truth(rng, ("claim", ("sqrt", x), "0", "", number(0), [])) is False
        deep = ("sqrt", ("sqrt", ("sqrt", x)))
        assert truth(rng, ("claim", deep, "0", "+", number(0), [])) is True
        assert truth(rng, ("claim", ("/", number(1), deep), "0", "+", "oo", [])) is True
    assert text(("-", x, ("-", x, number(-2)))) == "x - (x - (-2))", text(("-", x, ("-", x, number(-2))))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kane", required=True, help="the program")
    parser.add_argument("--claims", type=int, default=10000)
    parser.add_argument("--seed", default="1")
    parser.add_argument("--start", type=int, default=0, help="the first document's number")
    parser.add_argument("--certificates", action="store_true", help="put each certificate to scripts/check_cert.py too")
    parser.add_argument("--budget", type=int, help="coefficient operations of a search; else what the program takes")
    parser.add_argument("--show", type=int, help="print the document of this number and stop")
    args = parser.parse_args()
    args.told = time.monotonic()
    sys.setrecursionlimit(100_000)
    sys.set_int_max_str_digits(0)
    selftest()
    with localcontext(EXACT):
        if args.show is not None:
            print(document(random.Random(f"{args.seed}/{args.show}"), f"roots {args.seed}/{args.show}")[0])
            return 0
        return run(args)


if __name__ == "__main__":
    sys.exit(main())
