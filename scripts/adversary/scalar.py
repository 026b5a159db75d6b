"""Families of documents without functions: everything is a matter of points."""

from fractions import Fraction

from chance import guard, linear, mixed, names, nonzero, pieces, polynomial, positive, rational, scramble, small, spoil
from document import Document
from expr import NEGATED, ONE, ZERO, add, cases, div, mul, num, power, sub, total, var, walk
from point import Ambiguous, Undefined, evaluate
from algebraic import Costly

CLAIMS = 18


def start(family, rng, count=None, bounded=0.3):
    """A document with a few constants, some of them bounded."""
    d = Document(family, rng)
    symbols = names(rng, count or rng.choice([1, 2, 2, 3]))
    for s in symbols:
        lower = upper = None
        r = rng.random()
        if r < bounded:
            a = small(rng)
            lower = (a, rng.random() < 0.5)
            if rng.random() < 0.5:
                upper = (a + positive(rng), rng.random() < 0.5)
            if rng.random() < 0.2 and upper is None:
                lower, upper = None, lower
        d.declare(s, None, lower, upper)
    return d, symbols


def denominators(e):
    for node in walk(e):
        if node[0] == "/" and node[2][0] != "n":
            yield node[2]
        if node[0] == "^" and node[2] < 0:
            yield node[1]


def off_poles(e, rng):
    """Conditions that keep the denominators from zero, now and then one too few."""
    out = [("!=", b, ZERO) for b in dict.fromkeys(denominators(e))]
    return [c for c in out if rng.random() < 0.9]


def identities(rng):
    d, symbols = start("identities", rng)
    for _ in range(CLAIMS):
        e = rational(rng, symbols, rng.choice([2, 2, 3]))
        other = scramble(e, rng, rng.choice([2, 4]))
        if rng.random() < 0.35:
            other = spoil(other, rng)
        when = off_poles(("-", e, other), rng)
        d.claim([(rng.choice(["=", "=", "=", "<=", "!="]), e, other)], when)
    return d


def squares(rng, symbols):
    return total([mul(num(positive(rng)), power(polynomial(rng, symbols, 1), 2)) for _ in range(rng.choice([1, 2, 3]))])


def inequalities(rng):
    d, symbols = start("inequalities", rng, rng.choice([1, 2, 3]))
    givens = []
    for s in symbols:
        if rng.random() < 0.8:
            givens.append((s, d.given([(rng.choice([">", ">="]), var(s), num(rng.choice([0, 0, 0, 1])))])))
    for _ in range(CLAIMS):
        cites, when, shift = [], [], num(rng.choice([0, 0, 0, 1, -1, Fraction(1, 10)]))
        a, b = linear(rng, symbols), linear(rng, symbols)
        r = rng.random()
        strict = rng.choice([">=", ">=", ">"])
        if r < 0.25:
            link = (strict, squares(rng, symbols), shift)
        elif r < 0.4:
            link = (strict, add(power(a, 2), power(b, 2)), add(mul(num(2), mul(a, b)), shift))
        elif r < 0.6 and givens:
            chosen = rng.sample(givens, rng.randint(1, len(givens)))
            product = var(chosen[0][0])
            for s, _ in chosen[1:]:
                product = rng.choice([mul(product, var(s)), add(product, var(s)), div(product, var(s))])
            link, cites = (rng.choice([">", ">=", "!="]), product, shift), [g for _, g in chosen]
        elif r < 0.7:
            link = (strict, add(div(a, b), div(b, a)), add(num(2), shift))
            when = [(">", mul(a, b), ZERO)] if rng.random() < 0.8 else [(">", a, ZERO)]
        elif r < 0.8:
            link = ("<=", div(num(1), add(ONE, squares(rng, symbols[:1]))), add(ONE, shift))
        else:
            e = scramble(squares(rng, symbols), rng)
            link = (rng.choice([">", ">=", "!="]), add(e, shift), num(rng.choice([0, 0, -1])))
        if rng.random() < 0.2:
            op, left, right = link
            link = ({">": "<", ">=": "<=", "<=": ">=", "!=": "!="}[op], scramble(right, rng), scramble(left, rng))
        d.claim([link], when, cites)
    return d


def piecewise(rng):
    d, symbols = start("piecewise", rng)
    functions = []
    for k in range(rng.choice([1, 2])):
        functions.append(d.define(f"F{k}", pieces(rng, symbols)))
    for _ in range(CLAIMS):
        r = rng.random()
        when = [guard(rng, symbols)] if rng.random() < 0.4 else []
        e = rng.choice(functions) if rng.random() < 0.5 else pieces(rng, symbols)
        if r < 0.35:
            real = d.lets[e[1]] if e[0] == "v" else e
            other = scramble(real, rng, 3)
            if rng.random() < 0.4:
                other = spoil(other, rng)
            link = ("=", e, other)
        elif r < 0.6:
            real = d.lets[e[1]] if e[0] == "v" else e
            if real[0] == "cases":
                conditions, value = rng.choice(real[1])
                when = list(conditions) + ([rng.choice([("!=", var(rng.choice(symbols)), ZERO)])] if rng.random() < 0.3 else [])
                if rng.random() < 0.3:
                    value = real[2] or value
                    when = [(NEGATED[op], a, b) for op, a, b in conditions]
                link = (rng.choice(["=", "=", "<=", ">="]), e, value)
            elif real[0] == "abs":
                link = (rng.choice([">=", ">", "="]), e, rng.choice([ZERO, real[1]]))
            else:
                link = ("<=" if real[0] == "min" else ">=", e, rng.choice(list(real[1:])))
        elif r < 0.8:
            a, b = linear(rng, symbols), linear(rng, symbols)
            link = rng.choice([
                ("<=", ("abs", add(a, b)), add(("abs", a), ("abs", b))),
                ("=", add(("max", a, b), ("min", a, b)), add(a, b)),
                ("=", mul(("max", a, b), ("min", a, b)), mul(a, b)),
                ("=", sub(("max", a, b), ("min", a, b)), ("abs", sub(a, b))),
                ("=", ("abs", mul(a, b)), mul(("abs", a), ("abs", b))),
                (">=", ("abs", sub(a, b)), sub(("abs", a), ("abs", b))),
                ("<", ("min", a, b), ("max", a, b)),
            ])
            if rng.random() < 0.3:
                link = (link[0], link[1], spoil(link[2], rng))
        else:
            link = (rng.choice(["<", "<=", ">", ">=", "=", "!="]), e, rng.choice([linear(rng, symbols), num(small(rng))]))
        d.claim([link], when)
    return d


def roots(rng):
    d, symbols = start("roots", rng, rng.choice([1, 1, 2]))
    x = var(symbols[0])
    r1 = d.given([("=", ("sqrt", linear(rng, symbols)), linear(rng, symbols))])
    r2 = d.given([(">=", linear(rng, symbols), ZERO)])
    for _ in range(CLAIMS):
        a, b = linear(rng, symbols), linear(rng, symbols)
        cites = [g for g in (r1, r2) if rng.random() < 0.25]
        when = []
        if rng.random() < 0.6:
            when = [(rng.choice([">=", ">"]), e, ZERO) for e in rng.sample([a, b], rng.randint(1, 2))]
        s, t = ("sqrt", a), ("sqrt", b)
        link = rng.choice([
            ("=", power(s, 2), a),
            ("=", ("sqrt", power(a, 2)), ("abs", a)),
            ("=", ("sqrt", power(a, 2)), a),
            ("=", mul(s, t), ("sqrt", mul(a, b))),
            ("=", div(s, t), ("sqrt", div(a, b))),
            ("<=", ("sqrt", add(power(a, 2), power(b, 2))), add(("abs", a), ("abs", b))),
            ("<=", mul(num(2), mul(s, t)), add(a, b)),
            ("=", ("sqrt", add(a, mul(num(2), ("sqrt", sub(a, ONE))))), add(ONE, ("sqrt", sub(a, ONE)))),
            ("=", mul(sub(s, t), add(s, t)), sub(a, b)),
            ("=", ("sqrt", ("sqrt", power(a, 4))), ("abs", a)),
            ("<=", ("sqrt", add(a, ONE)), add(ONE, ("abs", a))),
            ("=", x, power(linear(rng, symbols), 2)),
            (">", ("sqrt", add(ONE, power(a, 2))), a),
            ("=", ("sqrt", num(rng.choice([2, 4, 8, 9]))), mul(num(2), ("sqrt", num(rng.choice([1, 2]))))),
            ("!=", power(a, 2), num(rng.choice([2, 3, 5]))),
        ])
        if rng.random() < 0.25:
            link = (link[0], link[1], spoil(link[2], rng))
        d.claim([link], when, cites)
    return d


def hidden(rng, d, symbols):
    """A point of the domain with small coordinates."""
    from sampling import candidates

    by_name = {v.name: v for v in d.vars}
    return {s: rng.choice(candidates(by_name[s], rng)[:12]) for s in symbols}


def at(e, d, values):
    try:
        return evaluate(e, d.scope(values))
    except (Undefined, Ambiguous, Costly):
        return None


def relation_through(rng, d, symbols, values, make):
    """A relation that holds at the point, or None."""
    e = make(rng, symbols, 2)
    v = at(e, d, values)
    if not isinstance(v, Fraction):
        return None
    r = rng.random()
    if r < 0.55:
        return ("=", e, num(v)) if rng.random() < 0.5 else ("=", sub(e, linear(rng, symbols, False)), None)
    if r < 0.8:
        return (rng.choice(["<", "<="]), e, num(v + positive(rng)))
    return (rng.choice([">", ">=", "!="]), e, num(v - positive(rng)))


def contradictions(rng):
    """Premises through a hidden point are consistent; with one of them spoiled they may not be."""
    d, symbols = start("contradictions", rng)
    values = hidden(rng, d, symbols)
    d.points.append(values)
    labels, spoiled = [], []
    make = rng.choice([polynomial, polynomial, rational, mixed])
    while len(labels) < 5:
        r = relation_through(rng, d, symbols, values, make)
        if r is None:
            make = polynomial
            continue
        if r[2] is None:
            v = at(r[1], d, values)
            r = ("=", r[1], num(v))
        when = [guard(rng, symbols)] if rng.random() < 0.2 else []
        labels.append(d.given([r], when))
        if rng.random() < 0.4 and r[0] == "=":
            spoiled.append((labels[-1], d.given([("=", scramble(r[1], rng), num(r[2][1] + nonzero(rng)))])))
    if rng.random() < 0.4:
        spoiled.append((labels[0], d.given([("<", squares(rng, symbols), num(rng.choice([0, 0, -1])))])))
    proved = []
    for _ in range(CLAIMS):
        r = rng.random()
        cites = rng.sample(labels, rng.randint(1, 3))
        if r < 0.3:
            d.claim([], shape="contradiction", cites=cites)
        elif r < 0.5 and spoiled:
            pair = rng.choice(spoiled)
            d.claim([], shape="contradiction", cites=list(dict.fromkeys(list(pair) + cites[:1])))
        elif r < 0.6:
            about = rng.choice(labels + [b for _, b in spoiled])
            d.claim([], shape="not implied", about=about, cites=cites)
        else:
            s = rng.choice(symbols)
            true = rng.random() < 0.6
            value = values[s] if true else values[s] + nonzero(rng)
            link = (rng.choice(["=", "=", "<=", ">=", "!="]), var(s), num(value))
            if rng.random() < 0.3:
                e = polynomial(rng, symbols, 1)
                link = (rng.choice(["=", "<=", ">="]), e, num(at(e, d, values)))
            if rng.random() < 0.3 and proved:
                cites.append(rng.choice(proved))
            proved.append(d.claim([link], [guard(rng, symbols)] if rng.random() < 0.2 else [], cites))
    return d


def traps(rng):
    """Definedness: 0^0, products with zero, negative exponents, conditions from left to right, citing."""
    d, symbols = start("traps", rng, 2, bounded=0.2)
    x, y = var(symbols[0]), var(symbols[1])
    f = d.define("F", cases([([("=", x, num(small(rng)))], num(small(rng)))], div(polynomial(rng, symbols, 1), sub(x, num(small(rng))))))
    h = d.define("H", mul(ZERO, div(ONE, linear(rng, symbols))))
    c = small(rng)
    law = d.given([("=", mul(sub(x, num(c)), y), num(nonzero(rng)))])
    quotient = d.given([("=", y, div(num(nonzero(rng)), sub(x, num(c))))])
    conditional = d.given([("=", mul(x, y), num(small(rng)))], [guard(rng, symbols), ("!=", polynomial(rng, symbols, 1), ZERO)])
    labels = [law, quotient, conditional]
    for _ in range(CLAIMS):
        e, g = linear(rng, symbols), polynomial(rng, symbols, 1)
        cites = rng.sample(labels, rng.choice([0, 0, 1, 1, 2]))
        when = rng.choice([
            [], [], [("!=", e, ZERO)], [(">", e, ZERO), (">", div(ONE, e), num(small(rng)))],
            [("<", div(ONE, e), num(small(rng)))], [("!=", x, num(c)), (">=", ("sqrt", g), ZERO)],
            [(">", ("sqrt", e), ONE)], [guard(rng, symbols)],
        ])
        n = rng.choice([1, 2, 3])
        link = rng.choice([
            ("=", power(e, 0), ONE), ("=", mul(power(e, -n), power(e, n)), ONE), ("=", mul(ZERO, div(g, e)), ZERO),
            ("=", div(e, e), ONE), ("=", power(div(g, e), 0), ONE), ("=", f, f), ("=", mul(f, ZERO), h),
            ("!=", sub(x, num(c)), ZERO), ("=", power(("sqrt", e), 0), ONE), ("=", sub(div(ONE, e), div(ONE, e)), ZERO),
            ("=", power(sub(e, e), 0), ONE), ("=", y, div(num(nonzero(rng)), sub(x, num(c)))),
            ("=", div(ZERO, g), ZERO), (">=", power(("sqrt", g), 2), ZERO), ("=", power(num(0), 0), power(g, 0)),
            ("=", cases([([(">", e, ZERO)], div(e, e)), ([("<", e, ZERO)], ONE)]), ONE), ("=", div(g, div(ONE, e)), mul(g, e)),
            ("=", div(div(g, e), e), div(g, power(e, 2))), ("=", mul(f, sub(x, num(c))), g), ("=", ("min", ONE, div(ONE, e)), ("min", div(ONE, e), ONE)),
        ])
        links = [link] if rng.random() < 0.85 else [link, (rng.choice(["=", "<="]), g, g)]
        shape = rng.random()
        if shape < 0.07 and cites:
            d.claim([], when, cites, shape="contradiction")
        elif shape < 0.14 and cites:
            d.claim([], when, cites[:1], shape="not implied", about=rng.choice(labels))
        else:
            labels.append(d.claim(links, when, cites))
    return d
