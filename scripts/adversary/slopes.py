"""The family of derivatives: first and second ones through cases, roots and powers."""

from fractions import Fraction

from algebraic import Costly
from chance import guard, linear, pieces, polynomial, small, spoil
from expr import ONE, ZERO, add, div, mul, num, power, sub, var, walk
from point import Ambiguous, Undefined, evaluate
from scalar import hidden, start

CLAIMS = 16


def differentiable(rng, symbols, depth=2):
    """Something to differentiate, often with kinks."""
    r = rng.random()
    if depth == 0 or r < 0.2:
        return polynomial(rng, symbols, 1)
    below = depth - 1
    if r < 0.45:
        e = pieces(rng, symbols, below, kinked if rng.random() < 0.4 else polynomial)
        return power(e, rng.choice([1, 2, 3])) if rng.random() < 0.3 else e
    if r < 0.52:
        return ("sqrt", add(power(differentiable(rng, symbols, below), 2), num(rng.choice([0, 1, 1, 4]))))
    if r < 0.58:
        return ("sqrt", differentiable(rng, symbols, below))
    if r < 0.66:
        return power(differentiable(rng, symbols, below), rng.choice([0, 0, 2, 3, -1, -2]))
    if r < 0.74:
        return div(differentiable(rng, symbols, below), polynomial(rng, symbols, 1))
    return (rng.choice("+-**"), differentiable(rng, symbols, below), differentiable(rng, symbols, below))


def kinked(rng, symbols, depth=1):
    e = linear(rng, symbols)
    return rng.choice([("abs", e), ("min", e, linear(rng, symbols)), ("max", e, num(small(rng))), ("sqrt", power(e, 2)), e])


def by_rules(e, x):
    """The textbook derivative as an expression, without a thought for where it is defined."""
    kind = e[0]
    if kind == "n":
        return ZERO
    if kind == "v":
        return ONE if e[1] == x else ZERO
    if kind == "neg":
        return ("neg", by_rules(e[1], x))
    if kind == "^":
        return mul(mul(num(e[2]), power(e[1], e[2] - 1)), by_rules(e[1], x)) if e[2] else ZERO
    if kind == "abs":
        return mul(div(("abs", e[1]), e[1]), by_rules(e[1], x))
    if kind == "sqrt":
        return div(by_rules(e[1], x), mul(num(2), e))
    if kind in ("min", "max"):
        op = "<=" if kind == "min" else ">="
        return ("cases", (((((op, e[1], e[2]),), by_rules(e[1], x))),), by_rules(e[2], x))
    if kind == "cases":
        return ("cases", tuple((g, by_rules(v, x)) for g, v in e[1]), None if e[2] is None else by_rules(e[2], x))
    if kind == "d":
        return by_rules(by_rules(e[1], e[2]), x)
    a, b = e[1], e[2]
    da, db = by_rules(a, x), by_rules(b, x)
    if kind in "+-":
        return (kind, da, db)
    if kind == "*":
        return add(mul(da, b), mul(a, db))
    return div(sub(mul(da, b), mul(a, db)), power(b, 2))


def simple(e):
    """Zeros and ones taken away, so that by-the-rules derivatives stay readable."""
    kind = e[0]
    if kind in ("n", "v", "d"):
        return e
    if kind == "^":
        a = simple(e[1])
        return a if e[2] == 1 else ("^", a, e[2])
    if kind == "cases":
        return ("cases", tuple((g, simple(v)) for g, v in e[1]), None if e[2] is None else simple(e[2]))
    parts = tuple(simple(c) for c in e[1:])
    if kind == "+" and ZERO in parts:
        return parts[1] if parts[0] == ZERO else parts[0]
    if kind == "-" and parts[1] == ZERO:
        return parts[0]
    if kind == "*":
        if ZERO in parts:
            return ZERO
        if ONE in parts:
            return parts[1] if parts[0] == ONE else parts[0]
    if kind == "/" and parts[0] == ZERO and parts[1] != ZERO:
        return ZERO
    return (kind,) + parts


def where(e, x, rng):
    """Conditions that keep away from kinks and poles, as a person would write them."""
    out = []
    for node in walk(e):
        if node[0] == "abs":
            out.append((rng.choice(["!=", ">", "<"]), node[1], ZERO))
        elif node[0] == "sqrt":
            out.append((">", node[1], ZERO))
        elif node[0] == "/" and node[2][0] != "n":
            out.append(("!=", node[2], ZERO))
        elif node[0] == "^" and node[2] < 0:
            out.append(("!=", node[1], ZERO))
        elif node[0] in ("min", "max"):
            out.append((rng.choice(["!=", ">", "<"]), node[1], node[2]))
        elif node[0] == "cases":
            for g, _ in node[1]:
                for op, a, b in g:
                    out.append((rng.choice(["!=", ">", "<"]), a, b))
    return [c for c in dict.fromkeys(out) if rng.random() < 0.85][:4]


def slopes(rng):
    d, symbols = start("slopes", rng, rng.choice([1, 1, 2]), bounded=0.1)
    x = symbols[0]
    functions = []
    for k in range(3):
        functions.append(differentiable(rng, symbols, rng.choice([1, 2, 2])))
        if rng.random() < 0.5:
            functions[-1] = ("let", d.define(f"F{k}", functions[-1]), functions[-1])
    labels = premises(rng, d, symbols, x, functions)
    for _ in range(CLAIMS):
        f = rng.choice(functions) if rng.random() < 0.6 else differentiable(rng, symbols, 2)
        name, body = (f[1], f[2]) if f[0] == "let" else (f, f)
        second = rng.random() < 0.35
        left = ("d", ("d", name, x), x) if second else ("d", name, x)
        if rng.random() < 0.1:
            left = ("d", mul(("d", name, x), rng.choice([var(x), name])), x)
        right = simple(by_rules(("d", body, x), x) if second else by_rules(body, x))
        when = where(body, x, rng) if rng.random() < 0.7 else []
        if rng.random() < 0.3:
            when = when[:2] + [guard(rng, symbols)]
        if rng.random() < 0.15:
            when.append(("=", var(x), num(small(rng))))
        cites = [rng.choice(labels)] if labels and rng.random() < 0.25 else []
        r = rng.random()
        if r < 0.6 and len(str(right)) < 6000:
            link = ("=", left, spoil(right, rng) if rng.random() < 0.2 else right)
        elif r < 0.75:
            link = ("=", left, left)
        else:
            link = (rng.choice(["<=", ">=", "!=", "="]), left, num(small(rng)))
        if len(str(link)) < 9000:
            label = d.claim([link], when, cites)
            if rng.random() < 0.3:
                labels.append(label)
    return d


def premises(rng, d, symbols, x, functions):
    """Givens with derivatives that hold at a hidden point, and what follows or not."""
    values = hidden(rng, d, symbols)
    d.points.append(values)
    labels = []
    for f in functions:
        name = f[1] if f[0] == "let" else f
        for e in (("d", name, x), ("d", ("d", name, x), x)):
            try:
                v = evaluate(e, d.scope(values))
            except (Undefined, Ambiguous, Costly):
                continue
            if not isinstance(v, Fraction):
                continue
            op = rng.choice(["=", "=", "<=", ">="])
            right = num(v) if rng.random() < 0.6 else mul(num(v / values[x]), var(x)) if values[x] else num(v)
            given = d.given([(op, e, right)])
            labels.append(given)
            d.claim([], shape="contradiction", cites=[given])
            if rng.random() < 0.6:
                link = (rng.choice(["=", "!=", "<=", ">="]), var(x), num(values[x] if rng.random() < 0.5 else small(rng)))
                d.claim([link], [], [given])
    return labels


