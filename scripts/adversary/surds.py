"""Roots of numbers: sums, products and nested roots, compared in decimals of 150 digits.

usage: surds.py KANE [COUNT [SEED]] [--certificates]

Equal sides are planted: squares of sums of roots under a root, products, quotients with a root below, angles of a
regular polygon. Other sides differ by chance, or by a small number that is added to one of equal sides. A claim that is
proved must be true and one that is refuted false. What takes more than a minute is wrong, too.
"""

import random
import sys
import time
from decimal import Decimal, getcontext

from trial import Trial

getcontext().prec = 150
SMALL = Decimal(10) ** -100
SIGNS = ("<", "<=", "=", "!=", ">", ">=")
CLAIMS = 4
LONGEST = 60


class Side:
    """An expression as it is written, and its value."""

    def __init__(self, text, value):
        self.text, self.value = text, Decimal(value)

    def __add__(self, other):
        return Side(f"{self.text} + {other.text}", self.value + other.value)

    def __sub__(self, other):
        return Side(f"{self.text} - ({other.text})", self.value - other.value)

    def __mul__(self, other):
        return Side(f"({self.text})*({other.text})", self.value * other.value)

    def __truediv__(self, other):
        return Side(f"({self.text})/({other.text})", self.value / other.value)


def number(n, d=1):
    return Side(f"{n}" if d == 1 else f"{n}/{d}", Decimal(n) / Decimal(d))


def root(side):
    return Side(f"sqrt({side.text})", side.value.sqrt())


def total(sides):
    first, *others = sides
    for side in others:
        first = first + side
    return first


def some(rng, k):
    return rng.sample(range(2, 24), k)


def square_of_a_sum(rng):
    values = some(rng, rng.choice((2, 2, 3)))
    crossed = [root(number(4 * a * b)) for i, a in enumerate(values) for b in values[:i]]
    return root(total([number(sum(values)), *crossed])), total([root(number(a)) for a in values])


def square_of_a_difference(rng):
    low, high = sorted(some(rng, 2))
    return root(number(low + high) - number(2) * root(number(low * high))), root(number(high)) - root(number(low))


def product(rng):
    values = some(rng, rng.choice((2, 3)))
    whole, out = 1, None
    for a in values:
        whole *= a
        out = root(number(a)) if out is None else out * root(number(a))
    return out, root(number(whole))


def quotient(rng):
    low, high = sorted(some(rng, 2))
    return number(1) / (root(number(high)) - root(number(low))), (root(number(high)) + root(number(low))) / number(high - low)


def multiples(rng):
    a, k, m = rng.choice((2, 3, 5, 6, 7)), rng.randint(2, 5), rng.randint(2, 5)
    return root(number(a * k * k)) + root(number(a * m * m)), root(number(a * (k + m) ** 2))


def conjugates(rng):
    a = rng.randint(2, 9)
    b = rng.randint(1, a * a - 1)
    inside = root(number(a * a - b))
    return root(number(a) + root(number(b))) * root(number(a) - root(number(b))), inside


def angle(_rng):
    return number(4) * root(number(1, 2) + root(number(3)) / number(4)), root(number(6)) + root(number(2))


EQUAL = (square_of_a_sum, square_of_a_difference, product, quotient, multiples, conjugates, angle)


def nested(rng, depth):
    inner = number(rng.randint(1, 12))
    for _ in range(depth):
        inner = number(rng.randint(1, 9)) + root(inner)
    return root(inner)


def by_chance(rng):
    """A sum of roots and a number near it."""
    parts = [rng.choice((lambda: root(number(rng.randint(2, 30))), lambda: nested(rng, 1)))() for _ in range(rng.randint(2, 3))]
    sides = parts[0]
    for part in parts[1:]:
        sides = sides + part if rng.random() < 0.7 else sides - part
    scale = 10 ** rng.randint(1, 5)
    return sides, number(int(sides.value * scale) + rng.randint(-1, 2), scale)


def claim(rng):
    """A claim as it is written, whether it is true, and its kind."""
    if rng.random() < 0.35:
        left, right = by_chance(rng)
        kind = "by chance"
    else:
        left, right = rng.choice(EQUAL)(rng)
        kind = "equal sides"
        if rng.random() < 0.4:
            right = right + number(rng.choice((1, -1)), 10 ** rng.randint(1, 12))
            kind = "nearly equal sides"
    if rng.random() < 0.5:
        left, right = right, left
    sign = rng.choice(SIGNS)
    difference = left.value - right.value
    way = 0 if abs(difference) < SMALL else 1 if difference > 0 else -1
    true = {"<": way < 0, "<=": way <= 0, "=": way == 0, "!=": way != 0, ">": way > 0, ">=": way >= 0}[sign]
    if rng.random() < 0.2:
        # x + left > right for all x > bound, if and only if that is so at the bound
        gap = right.value - left.value
        bound = int(gap * 8) // 8 + rng.randint(-1, 2)
        true = Decimal(bound) >= gap
        return f"x + {left.text} > {right.text} when x > {bound}", true, "beside a variable"
    return f"{left.text} {sign} {right.text}", true, kind


def main():
    trial = Trial("surds")
    rng = random.Random(trial.seed)
    slowest = 0
    while trial.judged < trial.count:
        claims = [claim(rng) for _ in range(CLAIMS)]
        lines = "".join(f"claim c{i}: {text}\n" for i, (text, _, _) in enumerate(claims))
        source = f"# Roots of numbers\n\n```kane\nvar x\n{lines}```\n"
        begin = time.monotonic()
        statements, messages = trial.statements(source, 2_000_000)
        taken = time.monotonic() - begin
        slowest = max(slowest, taken)
        if statements is None or taken > LONGEST:
            trial.wrong.append((source, messages or f"{taken:.0f} s"))
            if statements is None:
                break
        verdicts = {s["label"]: s["verdict"] for s in statements}
        for i, (text, true, kind) in enumerate(claims):
            trial.judged += 1
            verdict = verdicts[f"c{i}"]
            trial.count_one(f"{kind}, {str(true).lower()}, {verdict}")
            if verdict not in ("proved" if true else "refuted", "undecided"):
                trial.wrong.append((source, f"c{i} is {str(true).lower()}, and {verdict}"))
            if verdict == "undecided" and "--show-open" in sys.argv:
                print("open:", text, file=sys.stderr)
    print(f"slowest document: {slowest:.1f} s", file=sys.stderr)
    return trial.told()


if __name__ == "__main__":
    sys.exit(main())
