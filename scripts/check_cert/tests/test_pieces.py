"""Pieces against an evaluator of another kind: at points, by numbers and Taylor series."""

import random
import unittest
from fractions import Fraction
from math import isqrt

from check_cert.document import Document
from check_cert.expressions import parts, symbols_in
from check_cert.goal import Goal

from .prover import evaluate, roots_of, true
from .support import document

N = 7  # terms of a Taylor series


class Undefined(Exception):
    """The expression has no value here."""


class Skip(Exception):
    """The evaluator cannot tell: an irrational root, or x that may have cancelled."""


def exact_root(value):
    if value < 0:
        raise Undefined
    top, bottom = isqrt(value.numerator), isqrt(value.denominator)
    if top * top != value.numerator or bottom * bottom != value.denominator:
        raise Skip
    return Fraction(top, bottom)


def times(a, b):
    return [sum(a[i] * b[n - i] for i in range(n + 1)) for n in range(min(len(a), len(b)))]


def inverse(a):
    if not a[0]:
        raise Undefined
    found = [1 / a[0]]
    for n in range(1, len(a)):
        found.append(-sum(a[i] * found[n - i] for i in range(1, n + 1)) / a[0])
    return found


def holds(sign, a, b):
    return {"=": a == b, "!=": a != b, "<": a < b, "<=": a <= b, ">": a > b, ">=": a >= b}[sign]


class Values:
    """Values at a point, with every sub-expression looked at by itself."""

    def __init__(self, point):
        self.point = point

    def value(self, e):
        kind = e[0]
        if kind == "num":
            return Fraction(e[1], e[2])
        if kind == "sym":
            return self.point[e[1]]
        if kind == "d":
            return self.series(e[1], e[2], True)[1]
        if kind == "cases":
            for guard, body in e[1]:
                if all(holds(s, self.value(a), self.value(b)) for s, a, b in guard):
                    return self.value(body)
            if e[2] is None:
                raise Undefined
            return self.value(e[2])
        values = [self.value(part) for part in parts(e)]
        if kind == "pow":
            if e[2] < 0 and not values[0]:
                raise Undefined
            return values[0] ** e[2]
        if kind == "div":
            if not values[1]:
                raise Undefined
            return values[0] / values[1]
        if kind == "sqrt":
            return exact_root(values[0])
        a, *b = values
        return {
            "neg": lambda: -a, "abs": lambda: abs(a), "add": lambda: a + b[0],
            "sub": lambda: a - b[0], "mul": lambda: a * b[0],
            "min": lambda: min(a, b[0]), "max": lambda: max(a, b[0]),
        }[kind]()

    def series(self, e, x, smooth, length=N):
        """The Taylor series in x, where rule 6 gives one (its value, if only continuous)."""
        kind = e[0]
        if kind in ("num", "sym"):
            return [self.value(e), Fraction(e == ("sym", x))] + [Fraction(0)] * (length - 2)
        if kind == "d":
            inner = self.series(e[1], x, True, length + 1)
            return [a * n for n, a in enumerate(inner)][1:]
        if kind == "cases":
            return self.branch(e[1], e[2], x, smooth, length)
        if kind in ("abs", "min", "max"):
            zero = ("num", 0, 1)
            a, b, last = (e[1], zero, ("neg", e[1])) if kind == "abs" else (e[1], e[2], e[2])
            if smooth:
                sign = "<=" if kind == "min" else ">="
                return self.branch((((((sign, a, b)),), a),), last, x, True, length)
            left = self.series(a, x, False, length)[0]
            right = self.series(last, x, False, length)[0]
            return [(min if kind == "min" else max)(left, right)] + [Fraction(0)] * (length - 1)
        series = [self.series(part, x, smooth, length) for part in parts(e)]
        a, *b = series
        if kind == "neg":
            return [-v for v in a]
        if kind in ("add", "sub"):
            return [v + w if kind == "add" else v - w for v, w in zip(a, b[0])]
        if kind == "mul":
            return times(a, b[0])
        if kind == "div":
            return times(a, inverse(b[0]))
        if kind == "pow":
            found = [Fraction(1)] + [Fraction(0)] * (length - 1)
            for _ in range(abs(e[2])):
                found = times(found, a)
            return found if e[2] >= 0 else inverse(found)
        root = exact_root(a[0])
        if not root:
            if mentions(e, x):
                raise Undefined if any(a[1:]) else Skip
            return [root] + [Fraction(0)] * (length - 1)
        found = [root]
        for n in range(1, length):
            found.append((a[n] - sum(found[i] * found[n - i] for i in range(1, n))) / (2 * root))
        return found

    def branch(self, branches, last, x, smooth, length):
        for guard, body in branches:
            if all(self.steady(relation, x) for relation in guard):
                return self.series(body, x, smooth, length)
        if last is None:
            raise Undefined
        return self.series(last, x, smooth, length)

    def steady(self, relation, x):
        """The truth of a relation that does not change near the point."""
        sign, a, b = relation
        left, right = self.series(a, x, False)[0], self.series(b, x, False)[0]
        if left == right and (mentions(a, x) or mentions(b, x)):
            a, b = self.series(a, x, True), self.series(b, x, True)
            raise Skip if a == b else Undefined
        return holds(sign, left, right)


def mentions(e, x):
    found = set()
    symbols_in(e, found)
    return x in found


def numbers(rng):
    return rng.choice(["0", "1", "2", "3", "1/2", "4"])


def expression(rng, depth, derivatives=False):
    """The text of a random expression in x and y."""
    if depth == 0 or rng.random() < 0.15:
        return rng.choice(["x", "x", "y", numbers(rng)])
    inner = lambda: expression(rng, depth - 1, derivatives)  # noqa: E731
    kinds = ["sum", "sum", "sum", "product", "product", "quotient", "power", "abs", "min", "cases", "root"]
    kind = rng.choice(kinds + ["derivative"] * (2 * derivatives))
    if kind == "derivative":
        return f"d({inner()}, x)"
    if kind == "sum":
        return f"({inner()} {rng.choice('+-')} {inner()})"
    if kind == "product":
        return f"({inner()}*{inner()})"
    if kind == "quotient":
        return f"({inner()})/({inner()})"
    if kind == "power":
        return f"({inner()})^{rng.choice(['2', '3', '0', '-1'])}"
    if kind == "abs":
        return f"abs({inner()})"
    if kind == "min":
        return f"{rng.choice(['min', 'max'])}({inner()}, {inner()})"
    if kind == "root":
        return f"sqrt({rng.choice(['(' + inner() + ')^2', inner()])})"
    sign = rng.choice(["<", "<=", ">", ">=", "=", "!="])
    last = f" else: {inner()}" if rng.random() < 0.6 else ""
    return f"cases {{ {inner()} {sign} {inner()}: {inner()};{last} }}"


def goal_for(text):
    """The expression of a claim, with its goal."""
    parsed = Document(document("var x, y", f"claim a: {text} = 0"))
    claim = parsed.claims[0]
    roots = roots_of(parsed, claim, claim.items[0])
    return Goal(parsed, claim, claim.items[0], "proved", "cited", roots), claim.items[0][1]


def roots_at(goal, values, point):
    """Gives the variables of roots their values; any where one is undefined."""
    for radicand, name in goal.roots.items():
        try:
            point[name] = exact_root(values.value(radicand))
        except Undefined:
            point[name] = Fraction(5)


class Pieces(unittest.TestCase):
    def compare(self, text, rng):
        """At some points exactly one piece applies, and it has the right value."""
        goal, e = goal_for(text)
        pieces = goal.pieces.pieces(e)
        compared = 0
        for _ in range(6):
            point = {n: Fraction(rng.choice([0, 0, 1, 2, -1, -2, 3]), rng.choice([1, 1, 2])) for n in "xy"}
            values = Values(dict(point))
            try:
                roots_at(goal, values, point)
                try:
                    value = values.value(e)
                except Undefined:
                    value = None
            except Skip:
                continue
            here = [v for region, v in pieces if all(true(goal, c, point) for c in region)]
            self.assertEqual(len(here), 1, f"{text} at {point}: {here}")
            found = here[0] and evaluate(goal, here[0][0], point) / evaluate(goal, here[0][1], point)
            self.assertEqual(found, value, f"{text} at {point}")
            compared += 1
        return compared

    def test_pieces_have_the_values_of_the_expression(self):
        rng = random.Random(1)
        compared = sum(self.compare(expression(rng, 3), rng) for _ in range(600))
        self.assertGreater(compared, 2000)

    def test_derivatives_are_those_of_the_series(self):
        rng = random.Random(2)
        compared = 0
        for _ in range(500):
            compared += self.compare(f"d({expression(rng, 3)}, x)", rng)
        self.assertGreater(compared, 1500)

    def test_second_derivatives_are_those_of_the_series(self):
        rng = random.Random(3)
        compared = 0
        for _ in range(300):
            compared += self.compare(f"d(d({expression(rng, 2)}, x)*{expression(rng, 1)}, x)", rng)
            compared += self.compare(expression(rng, 2, True), rng)
        self.assertGreater(compared, 1500)


if __name__ == "__main__":
    unittest.main()
