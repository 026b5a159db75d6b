"""Limits of what is smoothed near a kink, with constants of either sign, right and wrong ones, judged by numbers.

usage: kinks.py KANE [COUNT [SEED]] [--certificates] [--show-open]

Limits that are known (`KNOWN`, each by a line of algebra on paper) depend on the sign of p or q, or on which is larger.
Symbols of either sign, their differences and products stand in the place of these, positive ones in that of r; or there is
something else on the right, or the condition of the claim is left out. Values in 1,300 decimal digits tell at several
choices of the symbols whether a claim is true: many of these are 0, or equal. A refutation is evaluated at the symbols
that it names.
"""

import random
import sys
from decimal import Decimal, localcontext
from fractions import Fraction

from expr import ONE, ZERO, add, div, mul, num, relation, sub, substitute, var
from parameters import EXACT, applies, complaint, judge, known, truth, written
from reader import read
from trial import Trial

CLAIMS = 6  # a document
EITHER = ["s", "u", "w"]
POSITIVE = ["k", "m"]

# Where x goes, what tends there, where to, and what has to hold; p and q are of either sign, r is positive.
KNOWN = [
    ("0", "sqrt(p^2 + x^2)", "abs(p)", ()),
    ("0+", "sqrt(p^2 + r*x)", "abs(p)", ()),
    ("0", "p/sqrt(p^2 + x^2)", "p/abs(p)", ("p != 0",)),
    ("0", "r*p/sqrt(p^2 + x^2)", "r", ("p > 0",)),
    ("0", "r*p/sqrt(p^2 + x^2)", "-r", ("p < 0",)),
    ("0+", "r*p/(abs(p) + x)", "r*p/abs(p)", ("p != 0",)),
    ("0", "abs(p + q*x)", "abs(p)", ()),
    ("0+", "(abs(p + x) - abs(p))/x", "1", ("p >= 0",)),
    ("0-", "(abs(p + x) - abs(p))/x", "-1", ("p <= 0",)),
    ("0", "(abs(p + x) - abs(p))/x", "p/abs(p)", ("p != 0",)),
    ("0", "max(p + x, q)", "max(p, q)", ()),
    ("0", "min(p, q + x)", "min(p, q)", ()),
    ("0", "(p + q + sqrt((p - q)^2 + x^2))/2", "max(p, q)", ()),
    ("0+", "(p + q - sqrt((p - q)^2 + 4*r*x))/2", "min(p, q)", ()),
    ("0+", "p + q - sqrt(p^2 + q^2 + 2*x)", "p + q - sqrt(p^2 + q^2)", ()),
    ("0", "sqrt(p^2 + q^2 + x^2)", "sqrt(p^2 + q^2)", ()),
    ("0", "p/sqrt(p^2 + q^2 + x^2)", "p/sqrt(p^2 + q^2)", ("p^2 + q^2 > 0",)),
    ("oo", "sqrt(p^2*x^2 + 1)/x", "abs(p)", ()),
    ("-oo", "sqrt(p^2*x^2 + r)/x", "-abs(p)", ()),
    ("oo", "sqrt(p^2*x^2 + q*x) - abs(p)*x", "q/(2*abs(p))", ("p != 0",)),
    ("oo", "p*x/sqrt(1 + p^2*x^2)", "p/abs(p)", ("p != 0",)),
    ("oo", "p*x/sqrt(1 + x^2)", "p", ()),
    ("oo", "(p*x + q)/(abs(p)*x + 1)", "p/abs(p)", ("p != 0",)),
    ("0+", "max(-r, min(r, p/x))", "r*p/abs(p)", ("p != 0",)),
    ("0+", "cases { p > x: r; p < -x: -r; else: r*p/x }", "r*p/abs(p)", ("p != 0",)),
    ("0+", "p/x", "oo", ("p > 0",)),
    ("0+", "p/x", "-oo", ("p < 0",)),
    ("0+", "x*p/(p^2 + x)", "0", ()),
    ("0", "sqrt(r - p + x)", "sqrt(r - p)", ("p < r",)),
    ("0", "sqrt(p*q + x)", "sqrt(p*q)", ("p < 0", "q < 0")),
    ("0", "sqrt(p^2 - q^2 + x)", "sqrt(p^2 - q^2)", ("p > q", "q > 0")),
    ("0+", "sqrt(abs(p) + x)", "sqrt(abs(p))", ()),
    ("0+", "abs(p)^3/(p^2 + x)", "abs(p)", ()),
]


def condition(text, letters):
    """A relation with expressions in the place of its letters."""
    left, sign, right = text.rsplit(" ", 2)
    return sign, substitute(read(left), letters), substitute(read(right), letters)


def formula(rng, symbols):
    """An expression in symbols of either sign, most of the time one of them."""
    two = {letter: var(rng.choice(symbols)) for letter in "st"}
    written = "s" if rng.random() < 0.5 else rng.choice(["s - t", "s*t", "-s", "s + 1", "2*s", "s + t", "s/2", "1 - s"])
    return substitute(read(written), two)


def otherwise(rng, target, symbols):
    """Something else on the right."""
    if target in ("oo", "-oo"):
        return rng.choice(["-oo" if target == "oo" else "oo", ZERO])
    t, s = target, var(rng.choice(symbols))
    wrong = [mul(num(2), t), mul(num(-1), t), add(t, num(Fraction(1, 100))), add(t, s), sub(t, s), mul(t, s), div(t, num(2))]
    return rng.choice([*wrong, ZERO, s, mul(num(-1), s), "oo"])


def document(rng):
    """A document's text, and its claims as (label, expression, point, side, target, symbols, conditions)."""
    either, positive = rng.sample(EITHER, rng.randint(1, 3)), rng.sample(POSITIVE, 1)
    symbols = either + positive
    names = ", ".join([*either, *(f"{s} > 0" for s in positive)])
    lines, claims = ["# Limits near kinks", "", "```kane", f"var x, {names}"], []
    for i in range(CLAIMS):
        *one, conditions = rng.choice(KNOWN)
        letters = {letter: formula(rng, either) for letter in "pq"}
        letters |= {"r": rng.choice([var(positive[0]), num(2), ONE]), "x": var("x")}
        if rng.random() < 0.3:
            letters["x"] = mul(var("x"), var(positive[0]))
        expression, point, side, target = known(*one, letters)
        conditions = [condition(c, letters) for c in conditions]
        chance = rng.random()
        if chance < 0.25:
            target = otherwise(rng, target, symbols)
        elif chance < 0.35:
            conditions = conditions[1:]
        if point == "0" and not side and rng.random() < 0.3:
            side = rng.choice("+-")
        when = " when " + ", ".join(map(relation, conditions)) if conditions else ""
        lines.append(f"claim c{i}: {written(expression, point, side, target)}{when}")
        claims.append((f"c{i}", expression, point, side, target, symbols, conditions))
    return "\n".join([*lines, "```", ""]), claims


def draws(rng, symbols):
    """Choices of the symbols, many of which are 0 or equal."""
    simple = [0, 1, -1, 1, -1, 2, -2, Fraction(1, 2), Fraction(-3, 10), -5, 10]
    for _ in range(24):
        values = {s: abs(v) or 1 if s in POSITIVE else v for s in symbols for v in [rng.choice(simple)]}
        yield {s: Decimal(v.numerator) / v.denominator for s, v in values.items()}


def selftest():
    """Each limit that is known is one where its condition holds, by its values; without it some are none."""
    rng = random.Random(0)
    letters = {"p": var("s"), "q": var("u"), "r": var("k")}
    for *one, conditions in KNOWN:
        conditions = [condition(c, letters) for c in conditions]
        claim = ("", *known(*one, letters), ["s", "u", "k"], conditions)
        choices = list(draws(rng, claim[-2]))
        assert any(applies(claim, c) for c in choices), one
        assert truth(choices, claim) == "right", one
    bare = ("c", *known("0", "p/sqrt(p^2 + x^2)", "p/abs(p)", letters), ["s"], [])
    assert truth(draws(rng, ["s"]), bare) == "wrong"
    steps = [{"depth": 0, "text": "Take s = 2."}, {"depth": 0, "text": "Then the limit is 1."}]
    said = {"verdict": "refuted", "links": [{"verdict": "refuted", "reason": "for s = 2: the limit is 1", "steps": steps}]}
    assert complaint(bare, "wrong", said), "it is true there"
    only = (*bare[:-1], [condition("p < 0", letters)])
    assert complaint(only, "wrong", said), "the condition fails there"


def main():
    trial = Trial("kinks")
    with localcontext(EXACT):
        selftest()
        return judge(trial, document, draws)


if __name__ == "__main__":
    sys.exit(main())
