"""Limits of formulas with several symbols under roots, right and wrong ones, and verdicts judged by numbers.

usage: parameters.py KANE [COUNT [SEED]] [--certificates] [--show-open]

Limits that are known (`KNOWN`, each by a line of algebra on paper) are written with products, quotients, sums and roots
of positive symbols in the place of their letters, and with a multiple of the variable in its place; or with something
else on the right. Whether such a claim is true is not taken from that: values in 1,300 decimal digits tell it at several
choices of the symbols. A refutation is evaluated at the symbols that it names.
"""

import random
import re
import sys
from decimal import Context, Decimal, localcontext
from fractions import Fraction

from radicals import approaches, behaviour, judged, number, text, value
from trial import Trial

CLAIMS = 8  # a document
#: what 400 digits of depth and their squares leave is enough for the 20 by which limits are told apart
EXACT = Context(prec=1300, Emax=10**9, Emin=-(10**9))
SYMBOLS = ["a", "b", "c", "m", "k"]


class Writer:
    """Arithmetic on expressions, so that a limit below reads as on paper."""

    def __init__(self, e):
        self.e = e

    def __add__(self, other):
        return Writer(("+", self.e, of(other)))

    def __sub__(self, other):
        return Writer(("-", self.e, of(other)))

    def __mul__(self, other):
        return Writer(("*", self.e, of(other)))

    def __truediv__(self, other):
        return Writer(("/", self.e, of(other)))

    def __pow__(self, n):
        return Writer(("^", self.e, n))

    def __rmul__(self, other):
        return Writer(("*", of(other), self.e))

    def __rsub__(self, other):
        return Writer(("-", of(other), self.e))

    def __radd__(self, other):
        return Writer(("+", of(other), self.e))

    def __rtruediv__(self, other):
        return Writer(("/", of(other), self.e))


def of(e):
    return e.e if isinstance(e, Writer) else e if isinstance(e, tuple) else number(e)


def sqrt(e):
    return Writer(("sqrt", of(e)))


# Where x goes, what tends there, and where to; p, q and r are positive.
KNOWN = [
    ("0", lambda x, p, q, r: (sqrt(p**2 + q * x), p)),
    ("0", lambda x, p, q, r: (sqrt(p + q * x), sqrt(p))),
    ("0", lambda x, p, q, r: (sqrt(p - x**2 / q), sqrt(p))),
    ("0", lambda x, p, q, r: ((sqrt(p**2 + q * x) - p) / x, q / (2 * p))),
    ("0", lambda x, p, q, r: ((sqrt(p + q * x) - sqrt(p)) / x, q / (2 * sqrt(p)))),
    ("0", lambda x, p, q, r: ((sqrt(p + x) - sqrt(p - x)) / x, 1 / sqrt(p))),
    ("0", lambda x, p, q, r: ((p - sqrt(p**2 - x**2)) / x**2, 1 / (2 * p))),
    ("0", lambda x, p, q, r: (r * x / (sqrt(p**2 + q * x) - p), 2 * p * r / q)),
    ("0", lambda x, p, q, r: (sqrt((p + q * x) / (r + x)), sqrt(p / r))),
    ("0", lambda x, p, q, r: (sqrt(p + x) * sqrt(q + x), sqrt(p * q))),
    ("0", lambda x, p, q, r: (sqrt(p + x) / sqrt(q + x), sqrt(p / q))),
    ("0", lambda x, p, q, r: (1 / sqrt(1 - x**2 / p**2), number(1))),
    ("0", lambda x, p, q, r: (p * (1 / sqrt(1 - x**2 / p) - 1) / x**2, number(Fraction(1, 2)))),
    ("0+", lambda x, p, q, r: (sqrt(x) * p / sqrt(q * x + x**2), p / sqrt(q))),
    ("0+", lambda x, p, q, r: (p / sqrt(q * x), "oo")),
    ("0+", lambda x, p, q, r: (sqrt(p * x) / (q + x), number(0))),
    ("0+", lambda x, p, q, r: ((p + q * sqrt(x)) / (r + sqrt(x)), p / r)),
    ("oo", lambda x, p, q, r: (sqrt(x**2 + p * x) - x, p / 2)),
    ("oo", lambda x, p, q, r: (sqrt(x**2 + p * x) - sqrt(x**2 + q * x), (p - q) / 2)),
    ("oo", lambda x, p, q, r: (sqrt(p**2 * x**2 + q * x) - p * x, q / (2 * p))),
    ("oo", lambda x, p, q, r: (sqrt(p * x + q) / sqrt(r * x + 1), sqrt(p / r))),
    ("oo", lambda x, p, q, r: (sqrt(p * x**2 + q) / (r * x + 1), sqrt(p) / r)),
    ("oo", lambda x, p, q, r: (sqrt(x + p) - sqrt(x), number(0))),
    ("oo", lambda x, p, q, r: (sqrt(x) * (sqrt(x + p) - sqrt(x)), p / 2)),
    ("oo", lambda x, p, q, r: (x * (sqrt(x**2 + p) - x), p / 2)),
    ("oo", lambda x, p, q, r: (x / sqrt(x**2 + p**2), number(1))),
    ("oo", lambda x, p, q, r: (sqrt(p * x) + q, "oo")),
    ("oo", lambda x, p, q, r: (p / sqrt(x + q), number(0))),
    ("oo", lambda x, p, q, r: (sqrt(p + q / x), sqrt(p))),
    ("oo", lambda x, p, q, r: (p - sqrt(q * x + r), "-oo")),
]


def formula(rng, symbols):
    """A positive expression in the symbols, most of the time one of them."""
    r = rng.random()
    s, t = (Writer(("v", rng.choice(symbols))) for _ in range(2))
    if r < 0.45:
        return s
    if r < 0.75:
        return rng.choice([s * t, s / t, 2 * s, s / 2, s**2, s * t**2])
    if r < 0.85:
        return rng.choice([s + t, s**2 + t, 1 + s * t, s + 1])
    if r < 0.92:
        return rng.choice([sqrt(s), sqrt(s * t), sqrt(s / t)])
    return Writer(number(rng.choice([1, 2, 3, Fraction(1, 2)])))


def otherwise(rng, target, symbols):
    """Something else on the right."""
    if isinstance(target, str):
        return rng.choice(["-oo" if target == "oo" else "oo", number(0), ("v", rng.choice(symbols))])
    t = Writer(target)
    s = Writer(("v", rng.choice(symbols)))
    wrong = [2 * t, t / 2, t * s, t / s, t + Fraction(1, 100), t + s, t - s / 1000, -1 * t, Writer(number(0))]
    return rng.choice([of(w) for w in wrong] + ["oo", "-oo"])


def document(rng):
    """A document's text, and its claims as (label, expression, point, side, target, symbols)."""
    symbols = rng.sample(SYMBOLS, rng.randint(1, 4))
    lines = ["# Limits with symbols", "", "```kane", "var x" + "".join(f", {s} > 0" for s in symbols)]
    claims = []
    for i in range(CLAIMS):
        where, make = rng.choice(KNOWN)
        stretch = formula(rng, symbols)
        x = Writer(("v", "x"))
        x = rng.choice([x, x, x * stretch, x / stretch])
        e, target = (of(part) if not isinstance(part, str) else part for part in make(x, *(formula(rng, symbols) for _ in range(3))))
        if rng.random() < 0.4:
            target = otherwise(rng, target, symbols)
        point, side = where.rstrip("+"), "+" if where.endswith("+") else ""
        if point == "0" and not side and rng.random() < 0.4:
            side = rng.choice("+-")
        aim = target if isinstance(target, str) else text(target)
        lines.append(f"claim c{i}: {text(e)} -> {aim} as x -> {point}{side}")
        claims.append((f"c{i}", e, point, side, target, symbols))
    return "\n".join([*lines, "```", ""]), claims


def holds(claim, constants):
    """Whether a claim is true at these symbols: True, False, or None if that is not clear."""
    _, e, point, side, target, _ = claim
    found = [judged(behaviour(e, x, constants), target, constants) for x in approaches(point, side)]
    return False if False in found else None if None in found else True


def draws(rng, symbols):
    """Choices of the symbols, of which some are large or small."""
    for _ in range(6):
        yield {s: Decimal(rng.choice([1, 2, 3, 4, 7, 10, 100])) / rng.choice([1, 1, 2, 3, 50]) for s in symbols}


def named(reason, symbols):
    """The symbols' values that a refutation names, and 1 for what it leaves out."""
    found = dict(re.findall(r"\b([a-z]) = (-?\d+(?:/\d+|\.\d+)?)(?=[,:;. ]|$)", reason))
    chosen = {s: Fraction(found.get(s, 1)) for s in symbols}
    return {s: Decimal(v.numerator) / Decimal(v.denominator) for s, v in chosen.items()}


def judge(trial, rng, claim, statement):
    """Counts a verdict; why it is wrong, or nothing."""
    label, e, point, side, target, symbols = claim
    verdict = statement["verdict"]
    truths = [holds(claim, constants) for constants in draws(rng, symbols)]
    kind = "wrong" if False in truths else "unclear" if None in truths else "right"
    trial.count_one(f"{kind}, {verdict}")
    if verdict == "undecided" and kind != "unclear" and "--show-open" in sys.argv:
        print(f"open ({kind}): {statement['source']}", file=sys.stderr, flush=True)
    if verdict == "vacuous" or (verdict == "proved" and kind == "wrong"):
        return f"{label} is {verdict}"
    if verdict not in ("refuted", "ill-defined"):
        return ""
    reason = " ".join(link["reason"] for link in statement["links"] if link["verdict"] == verdict)
    constants = named(reason, symbols)
    if holds(claim, constants):
        return f"{label} is {verdict}, and true where it says: {reason}"
    limit = re.search(r"the limit is (-?\d+(?:\.\d+)?(?:/\d+)?)(?=[;, ]|\.?$)", reason)
    if limit and not any(holds((label, e, *way, number(Fraction(limit[1])), symbols), constants) for way in sides(point, side)):
        return f"{label} has another limit where it is refuted: {reason}"
    return ""


def sides(point, side):
    """The sides from which a point is approached."""
    return [(point, side)] if side or point == "oo" else [(point, "+"), (point, "-")]


def selftest():
    """Each limit that is known is one, by its values."""
    rng = random.Random(0)
    for where, make in KNOWN:
        e, target = (of(part) if not isinstance(part, str) else part for part in make(*(Writer(("v", s)) for s in "xabc")))
        claim = ("", e, where.rstrip("+"), "+" if where.endswith("+") else "", target, ["a", "b", "c"])
        for constants in draws(rng, "abc"):
            assert holds(claim, constants), (text(e), target)
    chosen = named("false, for a = 1/2, b = 2: the limit is -0.5", ["a", "b", "c"])
    assert chosen == {"a": Decimal("0.5"), "b": Decimal(2), "c": Decimal(1)}, chosen
    with_root = value(of(sqrt(Writer(number(4)) / 9) + 1), {})
    assert abs(with_root - Decimal(5) / 3) < Decimal(10) ** -100


def main():
    trial = Trial("parameters")
    rng = random.Random(trial.seed)
    with localcontext(EXACT):
        selftest()
        for source, claims, statements in trial.documents(document, rng, 4_000_000):
            verdicts = {s["label"]: s for s in statements}
            for claim in claims:
                trial.judged += 1
                why = judge(trial, rng, claim, verdicts[claim[0]])
                if why:
                    trial.wrong.append((source, why))
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
