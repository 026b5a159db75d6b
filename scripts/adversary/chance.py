"""Random numbers, expressions and rewritings that keep the value."""

from fractions import Fraction

from expr import ONE, ZERO, add, cases, div, mul, num, power, sub, total, var

NAMES = ["x", "y", "z", "u", "w", "p_1", "q'", "m", "mu", "alpha", "v_x", "beta"]


def names(rng, count):
    return rng.sample(NAMES, count)


def small(rng, wide=False):
    """A small rational, mostly an integer."""
    r = rng.random()
    if r < 0.75:
        return Fraction(rng.randint(-4, 4))
    if r < 0.95 or not wide:
        return Fraction(rng.randint(-5, 5), 2)
    return Fraction(rng.randint(-9, 9), rng.choice([3, 4, 5, 10]))


def nonzero(rng):
    v = small(rng)
    return v if v else Fraction(1)


def positive(rng):
    return abs(nonzero(rng))


def linear(rng, symbols, constant=True):
    """c1*x1 + … + c0 with one or two of the symbols."""
    chosen = rng.sample(symbols, min(len(symbols), rng.choice([1, 1, 2])))
    parts = [var(s) if rng.random() < 0.5 else mul(num(nonzero(rng)), var(s)) for s in chosen]
    if constant and rng.random() < 0.7:
        parts.append(num(small(rng)))
    return total(parts)


def polynomial(rng, symbols, depth=2):
    """Sums, differences, products and small powers."""
    if depth == 0 or rng.random() < 0.15:
        return var(rng.choice(symbols)) if rng.random() < 0.7 else num(small(rng, True))
    r = rng.random()
    a = polynomial(rng, symbols, depth - 1)
    if r < 0.15:
        return power(a, rng.choice([0, 1, 2, 2, 2, 3]))
    if r < 0.22:
        return ("neg", a)
    b = polynomial(rng, symbols, depth - 1)
    return add(a, b) if r < 0.5 else sub(a, b) if r < 0.68 else mul(a, b)


def rational(rng, symbols, depth=2):
    a = polynomial(rng, symbols, depth)
    if rng.random() < 0.3:
        return a
    b = polynomial(rng, symbols, max(depth - 1, 1))
    if rng.random() < 0.15:
        return mul(a, power(b, -rng.choice([1, 1, 2])))
    return div(a, b)


def guard(rng, symbols):
    op = rng.choice(["<", "<=", ">", ">=", "<", ">", "!=", "="])
    return (op, linear(rng, symbols), rng.choice([ZERO, num(small(rng)), var(rng.choice(symbols))]))


def pieces(rng, symbols, depth=1, inner=polynomial):
    """abs, min, max or cases, with gaps and guards that overlap."""
    kind = rng.choice(["abs", "min", "max", "cases", "cases"])
    if kind == "abs":
        return ("abs", inner(rng, symbols, depth))
    if kind != "cases":
        return (kind, inner(rng, symbols, depth), inner(rng, symbols, depth))
    branches = []
    for _ in range(rng.choice([1, 2, 2, 3])):
        conditions = [guard(rng, symbols) for _ in range(rng.choice([1, 1, 1, 2]))]
        branches.append((conditions, inner(rng, symbols, depth)))
    return cases(branches, inner(rng, symbols, depth) if rng.random() < 0.7 else None)


def mixed(rng, symbols, depth=2):
    """Anything: rational, piecewise, roots."""
    r = rng.random()
    if depth == 0 or r < 0.3:
        return polynomial(rng, symbols, min(depth, 1))
    if r < 0.45:
        return pieces(rng, symbols, depth - 1)
    if r < 0.55:
        return ("sqrt", mixed(rng, symbols, depth - 1))
    if r < 0.65:
        return div(mixed(rng, symbols, depth - 1), polynomial(rng, symbols, 1))
    if r < 0.72:
        return power(mixed(rng, symbols, depth - 1), rng.choice([0, 2, 2, -1, 3]))
    return (rng.choice("++-*"), mixed(rng, symbols, depth - 1), mixed(rng, symbols, depth - 1))


def scramble(e, rng, rounds=3):
    """Another expression with the same value wherever both are defined."""
    for _ in range(rounds):
        e = _rewrite(e, rng)
    return e


def _rewrite(e, rng):
    kind = e[0]
    if kind in ("n", "v", "d", "cases"):
        if rng.random() < 0.08:
            return rng.choice([add(e, ZERO), mul(e, ONE), sub(mul(num(2), e), e), div(mul(num(3), e), num(3))])
        return e
    if rng.random() < 0.6:
        if kind == "^":
            e = ("^", _rewrite(e[1], rng), e[2])
        else:
            e = (kind,) + tuple(_rewrite(c, rng) for c in e[1:])
    if rng.random() < 0.4:
        return e
    a, b = e[1], e[2] if len(e) > 2 else None
    if kind == "+":
        return rng.choice([add(b, a), sub(a, ("neg", b)), ("neg", sub(("neg", a), b))])
    if kind == "-":
        return rng.choice([("neg", sub(b, a)), add(a, ("neg", b)), add(a, mul(num(-1), b))])
    if kind == "*":
        for p, q in ((a, b), (b, a)):
            if q[0] in "+-" and q[0] != "neg" and rng.random() < 0.6:
                return (q[0], mul(p, q[1]), mul(p, q[2]))
        return mul(b, a)
    if kind == "/":
        if a[0] in ("+", "-") and rng.random() < 0.6:
            return (a[0], div(a[1], b), div(a[2], b))
        return rng.choice([mul(a, power(b, -1)), ("neg", div(a, ("neg", b))), mul(div(ONE, b), a)])
    if kind == "^":
        if e[2] == 2:
            if a[0] in ("+", "-"):
                middle = mul(num(2), mul(a[1], a[2]))
                return add((a[0], power(a[1], 2), middle), power(a[2], 2))
            return mul(a, a)
        if e[2] > 2:
            return mul(a, power(a, e[2] - 1))
        return e
    if kind == "abs":
        return rng.choice([("max", a, ("neg", a)), ("sqrt", power(a, 2)), cases([([(">=", a, ZERO)], a)], ("neg", a)), ("abs", ("neg", a))])
    if kind in ("min", "max"):
        op = "<" if kind == "min" else ">"
        return rng.choice([(kind, b, a), cases([([(op, a, b)], a)], b), ("neg", ("max" if kind == "min" else "min", ("neg", a), ("neg", b)))])
    return e


def spoil(e, rng):
    """The expression with one number or sign changed, so that it is most likely another one."""
    if e[0] == "n":
        return num(e[1] + rng.choice([1, -1, Fraction(1, 2)]))
    if e[0] == "v" or rng.random() < 0.2:
        return rng.choice([add(e, num(nonzero(rng))), mul(e, num(2)), ("neg", e)])
    if e[0] in ("^", "d"):
        return (e[0], spoil(e[1], rng), e[2])
    if e[0] == "cases":
        i = rng.randrange(len(e[1]))
        branches = list(e[1])
        branches[i] = (branches[i][0], spoil(branches[i][1], rng))
        return ("cases", tuple(branches), e[2])
    i = rng.randrange(1, len(e))
    return e[:i] + (spoil(e[i], rng),) + e[i + 1 :]
