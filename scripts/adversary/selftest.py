#!/usr/bin/env python3
"""Whether the oracles themselves are right: two ways to the same number wherever there are two.

    python3 scripts/adversary/selftest.py
"""

import random
import sys
from decimal import Decimal
from fractions import Fraction
from math import sqrt
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from algebraic import Alg, Costly, root_of, sign, square_root  # noqa: E402
from chance import mixed, rational, scramble, small  # noqa: E402
from expr import show  # noqa: E402
from germ import Germ, approach  # noqa: E402
from inequalities import FAMILIES, fold  # noqa: E402
from neighbourhoods import Unclear, digits  # noqa: E402
from neighbourhoods import Undefined as Nothing  # noqa: E402
from neighbourhoods import value as in_digits  # noqa: E402
from point import Ambiguous, Scope, Undefined, evaluate  # noqa: E402
from reader import read  # noqa: E402
from slopes import by_rules, differentiable  # noqa: E402

SYMBOLS = ["x", "y"]


def value(e, **names):
    try:
        return evaluate(e, Scope({}, names))
    except Undefined:
        return None


def near(v):
    return float(v.near()) if isinstance(v, Alg) else float(v)


def printed_text_reads_back(rng):
    """What is printed means what was meant: another program part reads it, and values are compared."""
    e = mixed(rng, SYMBOLS, 3)
    again = read(show(e, 0, rng))
    for _ in range(4):
        x, y = small(rng), small(rng)
        a, b = value(e, x=x, y=y), value(again, x=x, y=y)
        assert (a is None) == (b is None) and (a is None or sign(a - b) == 0), show(e)


def rewriting_keeps_values(rng):
    e = rational(rng, SYMBOLS, 2)
    other = scramble(e, rng, 3)
    x, y = small(rng), small(rng)
    a, b = value(e, x=x, y=y), value(other, x=x, y=y)
    assert a is None or b is None or a == b, show(e)


def jets_agree_with_differences(rng):
    """The value of a derivative against a difference quotient, where it is defined."""
    e = differentiable(rng, SYMBOLS, 2)
    x, y, h = small(rng), small(rng), Fraction(1, 2**80)
    try:
        slope = value(("d", e, "x"), x=x, y=y)
    except (Ambiguous, Costly):
        return
    if slope is None:
        return
    ends = [value(e, x=x + s * h, y=y) for s in (1, -1)]
    assert None not in ends, show(e)
    try:
        difference = (ends[0] - ends[1]) / (2 * h)
        apart = difference - slope
        apart = abs(apart.near(400) if isinstance(apart, Alg) else apart)
    except Costly:
        return
    assert apart < Fraction(1, 2**60), f"{show(e)} at {x}, {y}: {near(difference)}, {near(slope)}"


def jets_agree_with_rules(rng):
    """For polynomials and quotients the textbook says the same, twice over."""
    e = rational(rng, SYMBOLS, 2)
    x, y = small(rng), small(rng)
    for form in (("d", e, "x"), ("d", ("d", e, "x"), "x")):
        a = value(form, x=x, y=y)
        b = value(by_rules(form[1], "x"), x=x, y=y)
        assert a is None or b is None or a == b, show(e)


def germs_agree_with_points(rng):
    """The sign along a germ is the sign very near."""
    e = rational(rng, SYMBOLS, 2)
    y, a, side = small(rng), small(rng), rng.choice([1, -1])
    g = value(e, x=approach(a, side), y=y)
    t = Fraction(1, 2**200)
    v = value(e, x=a + side * t, y=y)
    assert (g is None) == (v is None), show(e)
    if g is not None:
        assert sign(g) == sign(v), show(e)
        if isinstance(g, Germ) and isinstance(g.limit(), Fraction):
            assert abs(g.limit() - v) < Fraction(1, 2**60), show(e)


def roots_are_exact(rng):
    a, b = abs(small(rng)) + 2, abs(small(rng))
    left, right = square_root(a), square_root(b)
    total = a + b + 2 * square_root(a * b)
    assert sign(square_root(total) - left - right) == 0
    v = square_root(a) - square_root(b + Fraction(1, 3))
    assert (near(v) > 0) == (sqrt(a) > sqrt(b + Fraction(1, 3)))
    r = root_of([-2, 0, 0, 1], Fraction(1), Fraction(2))
    assert sign(r * r * r - 2) == 0 and sign(r * r - Fraction(3, 2)) == 1


def digits_agree_with_exact_values(rng):
    """An inequality that is known, and the same with its arithmetic on numbers done: in digits, and exactly."""
    known = rng.choice(FAMILIES)(rng)
    place = {name: abs(small(rng)) for name in known.letters}
    with digits():
        far = {name: Decimal(v.numerator) / Decimal(v.denominator) for name, v in place.items()}
        for side in known.relation[1:]:
            exact = value(side, **place)
            for e in (side, fold(side)):
                try:
                    v = in_digits(e, far)
                except (Nothing, Unclear):
                    v = None
                assert (v is None) == (exact is None), show(side)
                if v is not None:
                    apart = Fraction(v) - (exact.near(400) if isinstance(exact, Alg) else exact)
                    assert abs(apart) < Fraction(1, 2**80), show(side)


def main():
    checks = [printed_text_reads_back, rewriting_keeps_values, jets_agree_with_differences, jets_agree_with_rules]
    checks += [germs_agree_with_points, roots_are_exact, digits_agree_with_exact_values]
    for check in checks:
        rng = random.Random(check.__name__)
        for _ in range(300):
            check(rng)
    print(f"{len(checks)} checks of the oracles passed")


if __name__ == "__main__":
    main()
