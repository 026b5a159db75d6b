"""Whether an inequality can hold with room on all sides, or only with equality (the language, "Derivatives").

Points are tried by chance, the same ones each time. Where none is found the inequality is taken for an equation: that
refuses a document which may be sound, and accepts none that is not.
"""

import random
from math import sqrt

TRIES = 600
ROOM = 1e-9


class OnABoundary(Exception):
    """Undefined here, or on the border of what is."""


class Point:
    """Values of symbols, and of derivatives, which are free."""

    def __init__(self, document, chance):
        self.document, self.chance, self.values = document, chance, {}

    def free(self, key, symbol=None):
        if key not in self.values:
            ends = [float(end[0]) if end else None for end in (symbol.lower, symbol.upper)] if symbol else [None, None]
            low, high = ends
            size = self.chance.choice((0.5, 2, 20))
            if low is not None and high is not None:
                self.values[key] = self.chance.uniform(low, high)
            elif low is not None or high is not None:
                self.values[key] = low + self.chance.expovariate(1 / size) if high is None else high - self.chance.expovariate(1 / size)
            else:
                self.values[key] = self.chance.uniform(-size, size)
        return self.values[key]

    def value(self, e):
        kind = e[0]
        if kind == "num":
            return e[1] / e[2]
        if kind == "sym":
            return self.free(e[1], self.document.symbols[e[1]])
        if kind == "def":
            return self.value(self.document.symbols[e[1]].body)
        if kind == "cases":
            for guard, body in e[1]:
                if all(self.holds(relation) for relation in guard):
                    return self.value(body)
            if e[2] is None:
                raise OnABoundary
            return self.value(e[2])
        if kind in ("neg", "abs", "sqrt", "pow"):
            return self.of_one(kind, self.value(e[1]), e)
        if kind in ("add", "sub", "mul", "div", "min", "max"):
            return self.of_two(kind, self.value(e[1]), self.value(e[2]))
        return self.free(e)

    def of_one(self, kind, a, e):
        if kind == "neg":
            return -a
        if kind == "abs":
            return abs(a)
        if kind == "sqrt":
            if a < ROOM and e[1][0] != "num":
                raise OnABoundary
            return sqrt(a)
        if not isinstance(e[2], int):
            return self.free(e)
        if e[2] < 0 and abs(a) < ROOM:
            raise OnABoundary
        return a ** e[2]

    @staticmethod
    def of_two(kind, a, b):
        if kind == "div":
            if abs(b) < ROOM:
                raise OnABoundary
            return a / b
        return {"add": a + b, "sub": a - b, "mul": a * b, "min": min(a, b), "max": max(a, b)}[kind]

    def holds(self, relation):
        """With room; two sides that are the same expression are equal, others are not."""
        sign, left, right = relation
        if left == right:
            return sign in ("=", "<=", ">=")
        gap = self.value(left) - self.value(right)
        if sign in ("=", "!="):
            return sign == "!="
        if abs(gap) < ROOM:
            raise OnABoundary
        return (gap > 0) == (sign in (">", ">="))


def has_room(relation, document):
    """Is there a point around which it holds?"""
    if relation[1] == relation[2] and relation[0] in ("<=", ">="):
        return True
    for n in range(TRIES):
        try:
            if Point(document, random.Random(n)).holds(relation):
                return True
        except (OnABoundary, OverflowError, ValueError):
            continue
    return False
