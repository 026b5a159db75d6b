"""The family of limits with parameters: rational and piecewise, one-sided, at infinity, true and false."""

from fractions import Fraction

from chance import linear, names, nonzero, polynomial, small
from document import Document, Limit, Structure
from expr import ONE, ZERO, add, cases, div, mul, num, power, sub, total, var
from point import Ambiguous, Undefined
from structure import limit_of, lies_in_domain, sides

CLAIMS = 18
POINTS = ["oo", "-oo", "0", "0", "1", "-1", "2", "1/2", "-3/2"]


def start(family, rng, parameters):
    """A limit variable with or without bounds, and constants."""
    d = Document(family, rng)
    chosen = names(rng, parameters + 1)
    x = chosen[0]
    r = rng.random()
    lower = upper = None
    if r < 0.3:
        lower = (Fraction(rng.choice([0, 0, -1, 1])), rng.random() < 0.7)
    elif r < 0.4:
        upper = (Fraction(rng.choice([0, 2, 1])), rng.random() < 0.7)
    elif r < 0.5:
        lower, upper = (Fraction(0), rng.random() < 0.5), (Fraction(rng.choice([1, 2])), rng.random() < 0.5)
    d.declare(x, None, lower, upper)
    for s in chosen[1:]:
        low = (Fraction(rng.choice([0, 0, -1])), rng.random() < 0.6) if rng.random() < 0.35 else None
        d.declare(s, None, low)
    return d, x, chosen[1:]


def reachable(rng, d, x):
    """A point of approach that the domain has, with a side now and then."""
    for _ in range(40):
        point = rng.choice(POINTS)
        side = rng.choice(["", "", "+", "-"]) if point not in ("oo", "-oo") else ""
        limit = Limit(ZERO, ZERO, x, point, side)
        found = sides(d, x, limit)
        if found and (side or point in ("oo", "-oo") or len(found) >= 1):
            return point, side
    v = next(v for v in d.vars if v.name == x)
    return (str(v.lower[0]), "") if v.lower else (str(v.upper[0]), "")


def coefficient(rng, parameters):
    r = rng.random()
    if r < 0.45 and parameters:
        p = var(rng.choice(parameters))
        return rng.choice([p, p, sub(p, num(nonzero(rng))), mul(num(nonzero(rng)), p), power(p, 2)])
    return num(nonzero(rng))


def in_powers(rng, x, parameters, centre):
    """A polynomial in x, or in x - centre."""
    base = var(x) if centre in (0, None) or rng.random() < 0.4 else sub(var(x), num(centre))
    terms = []
    for n in rng.sample([0, 1, 1, 2, 3], rng.choice([1, 2, 2, 3])):
        c = coefficient(rng, parameters)
        terms.append(c if n == 0 else mul(c, base if n == 1 else power(base, n)))
    return total(terms)


def expression(rng, x, parameters, centre):
    a, b = in_powers(rng, x, parameters, centre), in_powers(rng, x, parameters, centre)
    r = rng.random()
    if r < 0.5:
        e = div(a, b)
    elif r < 0.6:
        e = a
    elif r < 0.68:
        e = sub(div(a, var(x)), div(b, var(x)))
    elif r < 0.76:
        e = mul(a, power(b, -1))
    else:
        c = num(small(rng))
        e = rng.choice([
            div(("abs", a), var(x)), ("min", a, div(b, var(x))), ("max", div(ONE, var(x)), a),
            cases([([("<", var(x), c)], a)], b), div(cases([([("<=", var(x), c)], a), ([(">", a, ZERO)], b)], var(x)), b),
            ("abs", sub(var(x), c)), ("max", a, c), ("sqrt", power(var(x), 2)) if rng.random() < 0.1 else ("abs", a),
        ])
    return e


def structures(rng, d, x, parameters, count=6):
    """Random values of the constants, within their bounds."""
    out = []
    for _ in range(count):
        constants = {}
        for p in parameters:
            v = next(v for v in d.vars if v.name == p)
            pool = [c for c in [small(rng, True) for _ in range(6)] + [Fraction(0), Fraction(1), Fraction(-1)] if v.allows(c)]
            constants[p] = rng.choice(pool) if pool else v.lower[0] + 1
        s = Structure(x, constants, {})
        if lies_in_domain(d, s):
            out.append(s)
    return out


def target(rng, d, e, limit, parameters):
    """What the limit is for some values of the constants, or something else."""
    r = rng.random()
    if r < 0.12:
        return rng.choice(["oo", "-oo"])
    if r < 0.22:
        return rng.choice([ZERO, num(small(rng))])
    for s in d.structures[:3]:
        for germ_at in sides(d, limit.x, limit)[:1]:
            try:
                v = limit_of(e, d, s, germ_at)
            except (Undefined, Ambiguous):
                continue
            if v in ("+oo", "-oo"):
                return "oo" if v == "+oo" else "-oo"
            if isinstance(v, Fraction):
                # by a guess which parameter it is
                ways = [num(v)] + [var(p) for p, w in s.constants.items() if w == v]
                ways += [div(var(p), var(q)) for p, w in s.constants.items() for q, z in s.constants.items() if p != q and z and w / z == v]
                ways += [mul(num(v / w), var(p)) for p, w in s.constants.items() if w]
                return rng.choice(ways)
    return num(small(rng))


def series(rng, parameters, t, first, exponents):
    """first*t^n and one or two terms that come after it."""
    exponents = list(exponents)
    later = rng.sample(exponents[1:], min(len(exponents) - 1, rng.choice([1, 1, 2])))
    terms = [(first, exponents[0])] + [(coefficient(rng, parameters), k) for k in later]
    return total([c if k == 0 else mul(c, t if k == 1 else power(t, k)) for c, k in terms])


def leading(rng, x, parameters, point):
    """A quotient with its true limit where the leading coefficients do not vanish."""
    a, b = coefficient(rng, parameters), coefficient(rng, parameters)
    # a quotient by a parameter and something small is a long search, so that is rare
    alone = b[0] != "n" and rng.random() < 0.93
    n, m = rng.choice([(1, 1), (2, 2), (1, 2), (2, 1)])
    top = max(n, m)
    if point in ("oo", "-oo"):
        e = div(series(rng, parameters, var(x), a, range(n, -1, -1)), series(rng, parameters, var(x), b, [m] if alone else range(m, -1, -1)))
    else:
        c = Fraction(point)
        t = sub(var(x), num(c)) if c else var(x)
        e = div(series(rng, parameters, t, a, range(top - n, top + 1)), series(rng, parameters, t, b, [top - m] if alone else range(top - m, top + 1)))
    if n == m:
        goal = div(a, b)
    elif n < m:
        goal = ZERO
    else:
        goal = rng.choice(["oo", "-oo"])
    conditions = [(rng.choice(["!=", "!=", ">"]), c, ZERO) for c in (a, b) if c[0] != "n" and rng.random() < 0.85]
    return e, goal, conditions


def limits(rng):
    parameters = rng.choice([0, 1, 1, 2, 2])
    d, x, parameters = start("limits", rng, parameters)
    d.structures = structures(rng, d, x, parameters)
    givens = []
    for p in parameters:
        if rng.random() < 0.6:
            links = [(rng.choice([">", ">=", "!=", "<"]), var(p), num(rng.choice([0, 0, 1])))]
            givens.append(d.given(links, truth=("const",)))
    a = small(rng)
    narrow = d.given([(rng.choice(["<", ">"]), var(x), num(a))], truth=("narrow",))
    if len(parameters) == 2:
        givens.append(d.given([("=", linear(rng, parameters), linear(rng, parameters))], truth=("const",)))
    for _ in range(CLAIMS):
        point, side = reachable(rng, d, x)
        limit = Limit(ZERO, ZERO, x, point, side)
        when = []
        if rng.random() < 0.45:
            e, goal, when = leading(rng, x, parameters, point)
        else:
            centre = None if point in ("oo", "-oo") else Fraction(point)
            e = expression(rng, x, parameters, centre)
            goal = target(rng, d, e, limit, parameters)
            if parameters and rng.random() < 0.4:
                when = [(rng.choice(["!=", ">", "<"]), var(rng.choice(parameters)), num(rng.choice([0, 0, 1])))]
        cites = [g for g in givens if rng.random() < 0.3] + ([narrow] if rng.random() < 0.15 else [])
        if rng.random() < 0.1 and parameters:
            e = add(e, mul(polynomial(rng, parameters, 1), ZERO))
        d.claim([Limit(e, goal, x, point, side)], when, cites)
    return d
