"""What is found for `exists` without `by`, and limits at symbols: evaluated at random points, in fractions or 80 digits.

usage: existence.py KANE [COUNT [SEED]] [--certificates]

A witness that is told is put into what is said to exist, by Python's own arithmetic; a limit is read off at a + 10^-30
and a - 10^-30. A claim that is proved must hold at every point, and one that holds by the way it was made is neither
refuted nor ill-defined.
"""

import json
import random
import re
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from functools import partial
from pathlib import Path

from trial import Trial

getcontext().prec = 80
SMALL = Decimal(10) ** -50
DECLARED = "var x, y, z, p > 0, a, b, q > 0"
NAMES = ("x", "y", "z", "p", "a", "b", "q")
SIGNS = ("<", "<=", "=", "!=", ">", ">=")
CLAIMS = 12


def root(value):
    return Decimal(value.numerator) / Decimal(value.denominator) if isinstance(value, Fraction) else Decimal(value)


def evaluated(text, at):
    """The value of an expression, in fractions where there is no root; None where it has none."""
    exact = "sqrt" not in text
    number = (lambda v: Fraction(v)) if exact else root
    names = {name: number(value) for name, value in at.items()}
    names |= {"abs": abs, "max": max, "min": min, "sqrt": lambda v: number(v).sqrt(), "N": lambda n: number(Fraction(n))}
    # every number is one of the kind, so that no quotient is rounded to a float
    words, number_before = [], ""
    for c in text.replace("^", "**") + " ":
        if c.isdigit():
            number_before += c
            continue
        if number_before:
            power = words[-2:] == ["*", "*"]
            words.append(number_before if power else f"N({number_before})")
            number_before = ""
        words.append(c)
    try:
        return eval("".join(words), {"__builtins__": {}}, names)
    except (ZeroDivisionError, ArithmeticError):
        return None


def holds(sign, left, right, slack):
    """Does a relation hold? Within the slack there is no telling: None."""
    if left is None or right is None:
        return False
    if isinstance(left, Decimal) or isinstance(right, Decimal):
        left, right = root(left), root(right)
    gap = left - right
    if slack and abs(gap) <= SMALL * (1 + abs(left)):
        return None
    return {"<": gap < 0, "<=": gap <= 0, "=": gap == 0, "!=": gap != 0, ">": gap > 0, ">=": gap >= 0}[sign]


def point(rng):
    values = {name: Fraction(rng.randint(-12, 12), rng.choice([1, 1, 2, 3, 7])) for name in NAMES}
    return values | {name: abs(values[name]) + Fraction(1, rng.choice([1, 3, 50])) for name in ("p", "q")}


def atom(rng, names):
    return rng.choice([*names, *names, str(rng.randint(1, 4))])


def polynomial(rng, names):
    terms = [f"{rng.randint(1, 3)}*{atom(rng, names)}*{atom(rng, names)}", atom(rng, names), f"{atom(rng, names)}^2"]
    return "(" + rng.choice([" + ", " - "]).join(rng.sample(terms, rng.randint(1, 2))) + ")"


class Existence:
    """`exists m: R` or `exists m, k: R`."""

    def __init__(self, rng):
        self.names = rng.choice([("m",), ("m",), ("m", "k")])
        outer = ("x", "y", "z", "p")
        self.relations = []
        for name in self.names if rng.random() < 0.8 else (*self.names, self.names[0]):
            sign = rng.choice(SIGNS)
            side = rng.choice([
                name, name, f"{rng.randint(2, 4)}*{name} + {atom(rng, outer)}", f"{name}^2", f"p*{name}",
                f"{atom(rng, outer)}*{name} - {atom(rng, outer)}", f"abs({name} - {atom(rng, outer)})",
                f"({name} - {atom(rng, outer)})^2", f"{name} + {self.names[-1]}", f"{name}*{self.names[0]}",
            ])  # fmt: skip
            self.relations.append((side, sign, polynomial(rng, outer)))
        said = " ".join(side for side, _, _ in self.relations)
        self.names = tuple(name for name in self.names if name in said)
        self.when = rng.choice([None, None, None, ("x", "<", "y"), ("x", ">", "0"), ("x^2", ">=", "4*y"), ("y*z", ">", "0")])

    def text(self, label):
        said = ", ".join(f"{left} {sign} {right}" for left, sign, right in self.relations)
        when = f" when {' '.join(self.when)}" if self.when else ""
        return f"claim {label}: exists {', '.join(self.names)}: {said}{when} expect undecided"

    def wrong(self, verdict, witness, places):
        if verdict not in ("proved", "undecided"):
            return f"it is {verdict}"
        if verdict == "undecided":
            return None
        if not witness or set(witness) != set(self.names):
            return f"proved without a witness: {witness}"
        for at in places:
            if self.when and holds(self.when[1], evaluated(self.when[0], at), evaluated(self.when[2], at), False) is not True:
                continue
            values = {name: evaluated(text, at) for name, text in witness.items()}
            if None in values.values():
                return f"the witness {witness} has no value at {at}"
            slack = any(isinstance(value, Decimal) for value in values.values())
            there = at | values
            for left, sign, right in self.relations:
                sides = [evaluated(text + (" + 0*sqrt(1)" if slack else ""), there) for text in (left, right)]
                if holds(sign, *sides, slack) is False:
                    return f"with {witness} {left} {sign} {right} fails at {at}"
        return None


class Limit:
    """`f -> L as x -> a`, true by continuity, as a slope, or with another value."""

    def __init__(self, rng):
        inner, outer = ("x", "x", "a", "b"), ("a", "b", "q")
        self.point = rng.choice(["a", "b", "a + b", "2*b", "-a", "sqrt(2)", "a*b"])
        f, g = polynomial(rng, inner), polynomial(rng, inner)
        at = f"({self.point})"
        put = partial(re.sub, r"\bx\b", at)
        if rng.random() < 0.5:
            self.f = rng.choice([f, f"{f}/(1 + {g}^2)", f"abs({f})", f"sqrt(1 + {f}^2)", f"max({f}, {g})", f"sqrt(q)*{f}"])
            self.to = put(self.f)
        else:
            self.f, self.to = rng.choice([
                (f"(x^2 - {at}^2)/(x - {at})", f"2*{at}"), (f"(x^3 - {at}^3)/(x - {at})", f"3*{at}^2"),
                (f"(1/(1 + x^2) - 1/(1 + {at}^2))/(x - {at})", f"-2*{at}/(1 + {at}^2)^2"),
            ])  # fmt: skip
        self.true = rng.random() < 0.6
        if not self.true:
            self.to = rng.choice([f"{self.to} + 1", f"-({self.to})", f"({self.to}) + {atom(rng, outer)}", f"2*({self.to})"])
        self.side = rng.choice(["", "", "+", "-"])

    def text(self, label):
        return f"claim {label}: {self.f} -> {self.to} as x -> {self.point}{self.side} expect undecided"

    def wrong(self, verdict, _witness, places):
        if verdict == "ill-defined" or (self.true and verdict == "refuted"):
            return f"it is {verdict}"
        if verdict != "proved":
            return None
        for at in places:
            exact = {name: root(value) for name, value in at.items()}
            middle, to = evaluated(self.point + " + 0*sqrt(1)", exact), evaluated(self.to + " + 0*sqrt(1)", exact)
            for step in [1] if self.side == "+" else [-1] if self.side == "-" else [1, -1]:
                near = evaluated(self.f + " + 0*sqrt(1)", exact | {"x": middle + step * Decimal(10) ** -30})
                if near is None or abs(near - to) > Decimal(10) ** -20 * (1 + abs(to)):
                    return f"proved, and {near} next to {to} at {at}"
        return None


def document(rng):
    claims = {f"c{i}": rng.choice([Existence, Existence, Limit])(rng) for i in range(CLAIMS)}
    lines = [DECLARED, *(claim.text(label) for label, claim in claims.items())]
    return "# What exists\n\n```kane\n" + "\n".join(lines) + "\n```\n", claims


def main():
    trial = Trial("existence")
    rng = random.Random(trial.seed)
    for source, claims, statements in trial.documents(document, rng, 2_000_000):
        certificate = json.loads((Path(trial.folder.name) / "out/d.cert.json").read_text())
        witnesses = {entry["label"]: entry.get("witness") for entry in certificate["claims"]}
        places = [point(rng) for _ in range(40)]
        for statement in statements:
            label = statement["label"]
            claim = claims.get(label)
            if not claim:
                continue
            trial.judged += 1
            kind = "exists" if isinstance(claim, Existence) else "limit, true" if claim.true else "limit, changed"
            trial.count_one(f"{kind}, {statement['verdict']}")
            why = claim.wrong(statement["verdict"], witnesses[label], places)
            if why:
                trial.wrong.append((source, f"{label}: {why}"))
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
