#!/usr/bin/env python3
"""Random claims on powers and sequences, by induction and without, evaluated plainly at many n.

A sequence is walked from its first term in fractions, a power is multiplied out, and nothing is put in for anything.
A verdict is wrong if numbers speak against it:

- `proved`, and at some n of its range and some values of the symbols the claim is false;
- `refuted`, and at the n and the values that the report names it is true, or n is not in its range;
- `vacuous` or `ill-defined`: nothing is assumed here, and all is defined.

    python3 scripts/adversary/sequences.py KANE [COUNT [SEED]] [--certificates]
"""

import operator
import random
import re
import sys
from fractions import Fraction
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from trial import Trial  # noqa: E402

CLAIMS, FURTHEST = 7, 11
SYMBOLS = {  # how they are declared, and values
    "x": ("x > 0", ["1/7", "1/2", "1", "3/2", "2", "5"]),
    "q": ("0 < q < 1", ["1/9", "1/3", "1/2", "4/5", "99/100"]),
    "y": ("y", ["-3", "-1", "-1/2", "0", "1/2", "1", "2"]),
    "p": ("p >= 1", ["1", "8/7", "3/2", "3"]),
}
RELATIONS = {"=": operator.eq, "!=": operator.ne, "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
STANDING = "(?:false under all that was assumed, |does not follow from what is cited, )?"
FOUND = re.compile(rf"^{STANDING}(?:for n = (\d+), )?(?:(?:at )?((?:[xqyp] = -?[\d/.]+(?:, )?)+): )?")
BOUND = re.compile(r"at n = (\d+)$")


class Node:
    """How an expression is written, and its value for an n and the symbols."""

    def __init__(self, text, value):
        self.text, self.value = text, value

    def __add__(self, other):
        return Node(f"({self.text} + {other.text})", lambda n, at: self.value(n, at) + other.value(n, at))

    def __sub__(self, other):
        return Node(f"({self.text} - {other.text})", lambda n, at: self.value(n, at) - other.value(n, at))

    def __mul__(self, other):
        return Node(f"{self.text}*{other.text}", lambda n, at: self.value(n, at) * other.value(n, at))


def number(q):
    q = Fraction(q)
    return Node(f"({q})" if q.denominator > 1 or q < 0 else str(q), lambda n, at: q)


def symbol(name):
    return Node(name, lambda n, at: at[name])


INDEX = Node("n", lambda n, at: Fraction(n))


def power(rng, base=None):
    """A power of an index, written in one of its ways."""
    base = base or rng.choice([symbol(s) for s in SYMBOLS] + [number(2), number(3), number(0)])
    a, b = rng.choice([(1, 0), (1, 0), (1, 1), (2, 0), (1, 2)])
    exponent = ("n" if a == 1 else f"{a}*n") + (f" + {b}" if b else "")
    text = f"pow({base.text}, {exponent})" if rng.random() < 0.2 else f"{base.text}^({exponent})"
    if exponent == "n" and "pow" not in text:
        text = f"{base.text}^n"
    return Node(text, lambda n, at: base.value(n, at) ** (a * n + b))


class Walk:
    """A sequence: its name, s(0), and s(n + 1) in terms of n and s(n)."""

    def __init__(self, rng, name, earlier):
        self.name = name
        last = Node(f"{name}(n)", lambda n, at: at[self])
        free = [symbol(s) for s in SYMBOLS] + [number(rng.choice([0, 1, 2, -1, "1/2"]))]
        self.first = rng.choice(free)
        kind = rng.random()
        summand = rng.choice([power(rng), INDEX, INDEX * INDEX, number(1), rng.choice(free), INDEX + number(1)])
        if earlier and rng.random() < 0.4:
            summand = rng.choice(earlier).term(rng, rng.choice([0, 1]))
        if kind < 0.6:
            self.next = last + summand
        elif kind < 0.85:
            self.next = rng.choice(free) * last + rng.choice([number(0), summand])
        else:
            self.next = last * last * number("1/2") + rng.choice(free)
        self.known = {}

    def declared(self):
        return f"let {self.name}(0) := {self.first.text}, {self.name}(n + 1) := {self.next.text}"

    def at(self, n, values):
        key = tuple(sorted(values.items()))
        terms = self.known.setdefault(key, [self.first.value(0, values)])
        while len(terms) <= n:
            k = len(terms) - 1
            terms.append(self.next.value(k, {**{s: v for s, v in values.items()}, self: terms[k]}))
        return terms[n]

    def term(self, rng, further=None):
        k = rng.choice([0, 0, 1, 2]) if further is None else further
        plain = lambda at: {s: v for s, v in at.items() if isinstance(s, str)}  # noqa: E731
        text = f"{self.name}(n)" if k == 0 else f"{self.name}(n + {k})"
        return Node(text, lambda n, at: self.at(n + k, plain(at)))

    def constant(self, k):
        return Node(f"{self.name}({k})", lambda n, at: self.at(k, at))


def geometric(rng):
    """Claims of the books, at times with a slip: (definitions, left, relation, right, first n)."""
    b = symbol(rng.choice("qxyp"))
    walk = Walk(rng, "g", [])
    walk.first = number(0)
    last = Node("g(n)", lambda n, at: at[walk])
    kind = rng.choice(["geometric", "odd", "squares", "bernoulli", "double", "bounded", "product", "sign"])
    slip = number(rng.choice([0, 0, 0, 1, "1/100"]))
    if kind == "geometric":
        walk.next = last + power_of(b, 0)
        return [walk], (number(1) - b) * walk.term(rng, 0), "=", number(1) - power_of(b, 0) + slip, 0
    if kind == "odd":
        walk.next = last + number(2) * INDEX + number(1)
        return [walk], walk.term(rng, 0), "=", INDEX * INDEX + slip, 0
    if kind == "squares":
        walk.next = last + (INDEX + number(1)) * (INDEX + number(1))
        right = INDEX * (INDEX + number(1)) * (number(2) * INDEX + number(1) + slip)
        return [walk], number(6) * walk.term(rng, 0), "=", right, 0
    if kind == "bernoulli":
        p = symbol("p")
        right = number(1) + INDEX * (p - number(1)) + slip
        return [], power_of(p, 0), ">=", right, 0
    if kind == "double":
        first = rng.choice([0, 1, 2, 3, 4, 5])
        return [], power_of(number(2), 0), rng.choice([">", ">="]), INDEX * INDEX + slip, first
    if kind == "bounded":
        q = symbol("q")
        walk.next = q * last + (number(1) - q)
        return [walk], walk.term(rng, 0), rng.choice(["<", "<="]), number(1) - slip, 0
    if kind == "product":
        walk.first, walk.next = number(1), last * b * b
        return [walk], walk.term(rng, 0), "=", power_of(b, 0) * power_of(b, rng.choice([0, 0, 1])), 0
    walk.first, walk.next = number(1), number(-1) * last
    return [walk], walk.term(rng, 0) * walk.term(rng, rng.choice([0, 0, 1])), "=", number(1) - slip, 0


def power_of(base, plus):
    text = f"{base.text}^n" if not plus else f"{base.text}^(n + {plus})"
    return Node(text, lambda n, at: base.value(n, at) ** (n + plus))


def random_claim(rng, walks):
    choices = [INDEX, power(rng), power(rng), number(rng.choice([0, 1, 2, -1, "1/2"])), symbol(rng.choice(list(SYMBOLS)))]
    choices += [w.term(rng) for w in walks] * 2 + [w.constant(rng.choice([0, 1, 3])) for w in walks]

    def side():
        a = rng.choice(choices)
        return rng.choice([a, a, a + rng.choice(choices), a * rng.choice(choices)])

    return side(), rng.choice(list(RELATIONS)), side(), rng.choice([0, 0, 1, 2])


def points(rng):
    return [{s: Fraction(rng.choice(values)) for s, (_, values) in SYMBOLS.items()} for _ in range(40)]


class Claim:
    def __init__(self, left, relation, right, first, way, cites):
        self.sides, self.relation, self.first, self.way, self.cites = (left, right), relation, first, way, cites

    def text(self, label):
        out = f"claim {label}: {self.sides[0].text} {self.relation} {self.sides[1].text}"
        if self.way != "plain":
            out += f" for n >= {self.first}"
        if self.cites:
            out += f" from {', '.join(self.cites)}"
        return out + (" by induction" if self.way == "induction" else "")

    def holds(self, n, at):
        return RELATIONS[self.relation](*(side.value(n, at) for side in self.sides))

    def failure(self, places):
        first = 0 if self.way == "plain" else self.first
        for at in places:
            for n in range(first, FURTHEST):
                if not self.holds(n, at):
                    return n, at
        return None


def document(rng):
    walks, claims = [], {}
    for name in rng.sample(["s", "u", "w"], rng.choice([0, 1, 2])):
        walks.append(Walk(rng, name, walks))
    lines = ["var n in N", "var " + ", ".join(declared for declared, _ in SYMBOLS.values())]
    own = None
    if rng.random() < 0.7:
        more, *own = geometric(rng)
        walks += more
    lines += [walk.declared() for walk in walks]
    for k in range(CLAIMS):
        if k == 0 and own:
            claim = Claim(*own, "induction", [])
        else:
            left, relation, right, first = random_claim(rng, walks)
            cites = rng.sample(list(claims), 1) if claims and rng.random() < 0.5 else []
            claim = Claim(left, relation, right, first, rng.choice(["induction", "range", "plain", "induction"]), cites)
        claims[f"c{k}"] = claim
        lines.append(claim.text(f"c{k}"))
    return "# Sequences\n\n```kane\n" + "\n".join(lines) + "\n```\n", claims


def named(claim, link):
    """The n and the values of a witness; None if the report does not tell them all."""
    found = FOUND.match(link["reason"])
    n = found[1] or (BOUND.search(link["text"]) or [None, None])[1]
    if n is None and claim.way == "plain" and "n" not in re.findall(r"\w+", claim.text("c")):
        n = 0  # it speaks of none
    values = dict(pair.split(" = ") for pair in found[2].rstrip(", ").split(", ")) if found[2] else {}
    at = {s: Fraction(values.get(s, choices[-1])) for s, (_, choices) in SYMBOLS.items()}
    return None if n is None else (int(n), at)


def judged_wrong(claim, statement, places):
    """Why a verdict is wrong, if it is."""
    verdict = statement["verdict"]
    if verdict in ("vacuous", "ill-defined"):
        return f"it is {verdict}, where nothing is assumed and all is defined"
    if verdict == "proved":
        failure = claim.failure(places)
        return failure and f"proved, and false at {failure}"
    if verdict == "refuted":
        for link in statement["links"]:
            if link["verdict"] == "refuted":
                found = named(claim, link)
                if " = the root of " in link["reason"]:
                    continue  # the second checker evaluates what is irrational
                if found is None:
                    return f"a witness without an index: {link['reason']}"
                if claim.holds(*found) or (claim.way != "plain" and found[0] < claim.first):
                    return f"refuted, and true at {found}: {link['reason']}"
    return None


def main():
    trial = Trial("sequences")
    rng = random.Random(trial.seed)
    for source, claims, statements in trial.documents(document, rng, 300_000):
        places = points(rng)
        for statement in statements:
            claim = claims.get(statement["label"])
            if not claim:
                continue
            trial.judged += 1
            true = "false" if claim.failure(places) else "true"
            trial.count_one(f"{claim.way}, {true}, {statement['verdict']}")
            why = judged_wrong(claim, statement, places)
            if why:
                trial.wrong.append((source, f"{statement['label']}: {why}"))
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
