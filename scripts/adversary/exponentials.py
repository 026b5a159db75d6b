#!/usr/bin/env python3
"""Random claims on exponentials and logarithms, evaluated in decimals of 180 digits at many points.

Nothing is written out by functional equations here. A verdict is wrong if numbers speak against it:

- `proved`, and at some point at which the conditions hold the claim is false;
- `refuted`, and at the point that the report names, where exp(x) = 2 gives x = ln 2, the claim is true or a condition fails;
- `vacuous`, and at some point the conditions hold; `ill-defined`: all is defined.

    python3 scripts/adversary/exponentials.py KANE [COUNT [SEED]] [--certificates]
"""

import json
import random
import re
import sys
from decimal import Decimal, getcontext
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from trial import Trial  # noqa: E402

getcontext().prec = 180
CLAIMS, NEAR = 8, Decimal(10) ** -150
DECLARED = {"x": "x", "y": "y", "z": "z >= 0", "w": "w < 0", "s": "s > 0", "r": "r > 0", "t": "t >= 1"}
POSITIVE, ALL = "srt", "xyzwsrt"


def dec(q):
    q = Fraction(q)
    return Decimal(q.numerator) / Decimal(q.denominator)


class Node:
    """How an expression is written, and its value at a point."""

    def __init__(self, text, value):
        self.text, self.value = text, value

    def __add__(self, other):
        return Node(f"{self.text} + {other.text}", lambda at: self.value(at) + other.value(at))

    def __sub__(self, other):
        return Node(f"{self.text} - ({other.text})", lambda at: self.value(at) - other.value(at))

    def __mul__(self, other):
        return Node(f"({self.text})*({other.text})", lambda at: self.value(at) * other.value(at))


def number(q):
    return Node(f"({q})", lambda at: dec(q))


def symbol(name):
    return Node(name, lambda at: at[name])


def exp(rng):
    """exp of a sum with rational factors, at times with a logarithm in it."""
    names = rng.sample(ALL, rng.choice([1, 1, 1, 2]))
    factors = [Fraction(rng.choice(["1", "1", "-1", "2", "1/2", "-1/2", "3/2", "-2", "1/3"])) for _ in names]
    text = " + ".join(f"({q})*{name}" for q, name in zip(factors, names))
    extra = rng.choice(POSITIVE) if rng.random() < 0.15 else None
    if extra:
        text += f" - log({extra})"

    def value(at):
        total = sum(dec(q) * at[name] for q, name in zip(factors, names))
        return (total - (at[extra].ln() if extra else 0)).exp()

    return Node(f"exp({text})", value)


def log(rng):
    """log of a product of powers, at times with an exponential in it."""
    names = rng.sample(POSITIVE, rng.choice([1, 1, 2]))
    powers = [rng.choice([1, 1, 2, -1, -2]) for _ in names]
    text = "*".join(f"{name}^{n}" for n, name in zip(powers, names))
    extra = rng.choice("xyz") if rng.random() < 0.2 else None
    if extra:
        text += f"*exp({extra})"

    def value(at):
        total = sum(n * at[name].ln() for n, name in zip(powers, names))
        return total + (at[extra] if extra else 0)

    return Node(f"log({text})", value)


def atom(rng):
    pick = rng.random()
    if pick < 0.4:
        return exp(rng)
    if pick < 0.65:
        return log(rng)
    return symbol(rng.choice(ALL)) if pick < 0.85 else number(rng.choice(["0", "1", "2", "-1", "1/2", "3"]))


def side(rng):
    a = atom(rng)
    return rng.choice([a, a, a + atom(rng), a - atom(rng), a * atom(rng)])


def book(rng):
    """Claims of the books, at times with a slip."""
    q = rng.choice(["0", "0", "0", "1", "-1", "1/10", "-1/10"])
    slip = number(q)
    v, p, o = rng.choice("xyzw"), rng.choice(POSITIVE), rng.choice(POSITIVE)
    e = lambda f, text: Node(f"exp({text})", lambda at: f(at).exp())  # noqa: E731
    one = number("1")
    ev, minus = e(lambda at: at[v], v), e(lambda at: -at[v], f"-{v}")
    lp = Node(f"log({p})", lambda at: at[p].ln())
    lo = Node(f"log({o})", lambda at: at[o].ln())
    return rng.choice([
        (ev, ">=", one + symbol(v) + slip),
        (ev, rng.choice([">", ">="]), slip),
        (lp, "<=", symbol(p) - one + slip),
        (ev * minus, "=", one + slip),
        (ev + minus, ">=", number("2") + slip),
        (Node(f"log({p}*{o})", lambda at: (at[p] * at[o]).ln()), "=", lp + lo + slip),
        (Node(f"log({p}/{o})", lambda at: (at[p] / at[o]).ln()), "=", lp - lo + slip),
        (Node(f"exp(log({p}))", lambda at: at[p]), "=", symbol(p) + slip),
        (symbol(p) * lp, ">=", symbol(p) - one + slip),
        (e(lambda at: at[v] / 2, f"{v}/2") * e(lambda at: at[v] / 2, f"{v}/2"), "=", ev + slip),
        (e(lambda at: 2 * at[v], f"2*{v}"), ">=", ev * number("2") - one + slip),
        (minus, rng.choice(["<", "<="]), one + slip),
        (ev, rng.choice(["=", "!="]), e(lambda at: at["y"], "y") + slip),
    ])


def compare(relation, a, b):
    """Whether it holds; what is too near to tell counts as equal."""
    d = a - b
    if abs(d) <= NEAR * (1 + abs(a) + abs(b)):
        d = Decimal(0)
    return {"=": d == 0, "!=": d != 0, "<": d < 0, "<=": d <= 0, ">": d > 0, ">=": d >= 0}[relation]


class Claim:
    def __init__(self, left, relation, right, when):
        self.left, self.relation, self.right, self.when, self.cited = left, relation, right, when, {}

    def text(self, label):
        when = ", ".join(f"{a.text} {r} {b.text}" for a, r, b in self.when)
        out = f"claim {label}: {self.left.text} {self.relation} {self.right.text}" + (f" when {when}" if when else "")
        return out + (f" from {', '.join(self.cited)}" if self.cited else "")

    def meant(self, at):
        return all(compare(r, a.value(at), b.value(at)) for a, r, b in (*self.when, *self.cited.values()))

    def holds(self, at):
        return compare(self.relation, self.left.value(at), self.right.value(at))


def points(rng):
    """Values of all symbols; such that exponentials are simple are among them."""
    simple = [Decimal(0), Decimal(0), dec("1/2"), Decimal(1), dec("-1/3"), Decimal(-2), Decimal(2).ln(), -Decimal(3).ln(), Decimal(5)]
    positive = [Decimal(1), Decimal(1), Decimal(2), dec("1/2"), dec("1/50"), Decimal(1).exp(), dec("13/12"), Decimal(30)]
    for _ in range(150):
        at = {name: rng.choice(simple) for name in "xy"}
        at["z"], at["w"] = abs(rng.choice(simple)), -abs(rng.choice(simple[2:]))
        at |= {name: rng.choice(positive) for name in "sr"}
        at["t"] = max(Decimal(1), rng.choice(positive))
        yield at


def document(rng):
    lines, claims = ["var " + ", ".join(DECLARED.values())], {}
    assumed = {}
    for k in range(rng.choice([0, 1, 2])):
        assumed[f"g{k}"] = a, r, b = side(rng), rng.choice(["=", "<=", ">", "!="]), rng.choice([number(rng.choice("0123")), atom(rng)])
        lines.append(f"given g{k}: {a.text} {r} {b.text}")
    for k in range(CLAIMS):
        made = book(rng) if rng.random() < 0.4 else (side(rng), rng.choice(["=", "!=", "<", "<=", ">", ">="]), side(rng))
        when = []
        if rng.random() < 0.3:
            when.append((rng.choice([atom, side])(rng), rng.choice(["<", "<=", ">", ">=", "=", "!="]), number(rng.choice(["0", "1", "2", "1/2"]))))
        claims[f"c{k}"] = claim = Claim(*made, when)
        claim.cited = {name: said for name, said in assumed.items() if rng.random() < 0.4}
        lines.append(claim.text(f"c{k}"))
    return "# Exponentials\n\n```kane\n" + "\n".join(lines) + "\n```\n", claims


def named(values):
    """The point of a certificate; exponentials give what is in them. None if it is irrational."""
    at = {}
    for name, coefficients in values.items():
        if len(coefficients) > 1:
            return None, ""
        value = dec(coefficients[0]) if coefficients else Decimal(0)
        found = re.fullmatch(r"(exp|log)\(([a-z])(?:/(\d+))?\)", name)
        if not found:
            of, told = name, value
        elif found[1] == "exp":
            of, told = found[2], value.ln() * int(found[3] or 1)
        else:
            of, told = found[2], value.exp()
        if abs(at.setdefault(of, told) - told) > NEAR:
            return at, f"`{of}` has two values"
    for name in DECLARED:
        at.setdefault(name, Decimal({"w": -1}.get(name, 1)))
    return at, ""


def inside(at):
    return at["z"] >= 0 and at["w"] < 0 and at["s"] > 0 and at["r"] > 0 and at["t"] >= 1


def judged_wrong(claim, statement, places, values):
    """Why a verdict is wrong, if it is."""
    verdict = statement["verdict"]
    meant = [at for at in places if claim.meant(at)]
    if verdict == "ill-defined":
        return "it is ill-defined, where all is defined"
    if verdict == "vacuous" and meant:
        return f"it is vacuous, and meant at {meant[0]}"
    failing = next((at for at in meant if not claim.holds(at)), None)
    if verdict == "proved" and failing:
        return f"proved, and false at {failing}"
    if verdict == "refuted":
        at, why = named(values)
        if at is None:
            return None
        if why or not inside(at) or not claim.meant(at) or claim.holds(at):
            return f"refuted, and {why or at}: {values}"
    return None


def main():
    trial = Trial("exponentials")
    rng = random.Random(trial.seed)
    for source, claims, statements in trial.documents(document, rng, 100_000):
        places = list(points(rng))
        certificate = json.loads(Path(trial.folder.name, "out", "d.cert.json").read_text())
        evidence = {c["label"]: c["links"][0].get("evidence", {}) for c in certificate["claims"]}
        for statement in statements:
            claim = claims.get(statement["label"])
            if not claim:
                continue
            trial.judged += 1
            false = any(claim.meant(at) and not claim.holds(at) for at in places)
            trial.count_one(f"{'false' if false else 'true'}, {statement['verdict']}")
            values = evidence[statement["label"]].get("point", {}).get("values", {})
            why = judged_wrong(claim, statement, places, values)
            if why:
                trial.wrong.append((source, f"{statement['label']}: {why}"))
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
