"""Points at which inequalities are evaluated in decimals of 320 digits: simple, equal, huge and tiny ones, those at edges,
and those near a point at which both sides agree.
"""

import itertools
from decimal import Context, Decimal, localcontext

from slopes import by_rules

EXACT = Context(prec=320, Emax=10**9, Emin=-(10**9))
#: beside the numbers it is made of, what is larger than the first is not zero, and what is smaller than the second is
SOMETHING, NOTHING = Decimal(10) ** -200, Decimal(10) ** -300
SIMPLE = [Decimal(n) / d for n, d in ((1, 1), (2, 1), (3, 1), (1, 2), (1, 3), (4, 1), (9, 1), (1, 4), (10, 1), (3, 2))]
DRAWS = 60


class Undefined(Exception):
    """A root of what is negative, or a division by zero."""


class Unclear(Exception):
    """The digits do not tell."""


def sign_of(v, scale=0):
    """−1, 0 or 1, of a number made of some as large as the scale."""
    if abs(v) <= NOTHING * scale:
        return 0
    if abs(v) < SOMETHING * max(scale, 1):
        raise Unclear
    return 1 if v > 0 else -1


def value(e, place):
    """The value in decimals."""
    kind = e[0]
    if kind == "n":
        return Decimal(e[1].numerator) / Decimal(e[1].denominator)
    if kind == "v":
        return place[e[1]]
    if kind == "d":
        value(e[1], place)
        return value(by_rules(e[1], e[2]), place)
    a = value(e[1], place)
    if kind == "sqrt":
        if sign_of(a) < 0:
            raise Undefined
        return a.sqrt()
    if kind == "^":
        if e[2] < 0 and not sign_of(a):
            raise Undefined
        return a ** e[2] if e[2] else Decimal(1)
    if kind in ("neg", "abs"):
        return -a if kind == "neg" else abs(a)
    b = value(e[2], place)
    if kind in ("min", "max"):
        return min(a, b) if kind == "min" else max(a, b)
    if kind == "/":
        if not sign_of(b):
            raise Undefined
        return a / b
    return {"+": a.__add__, "-": a.__sub__, "*": a.__mul__}[kind](b)


def holds(relation, place):
    """True, False, or None where it is undefined."""
    op, a, b = relation
    try:
        a, b = value(a, place), value(b, place)
    except Undefined:
        return None
    s = sign_of(a - b, 1 + abs(a) + abs(b))
    return {"=": s == 0, "!=": s != 0, "<": s < 0, "<=": s <= 0, ">": s > 0, ">=": s >= 0}[op]


def free(rng, names, domain):
    """Values of names, simple ones first; `domain` is ">" for positive ones, ">=" for zero too, "" for any."""
    for v in SIMPLE:
        yield dict.fromkeys(names, v)
    if len(names) <= 3:
        for chosen in itertools.product((Decimal(1), Decimal(2), Decimal("0.5")), repeat=len(names)):
            yield dict(zip(names, chosen))
    for i in range(DRAWS):
        place = {n: rng.choice(SIMPLE) * rng.choice(SIMPLE) for n in names}
        if i % 3 == 1:
            place = {n: v * Decimal(10) ** rng.randint(-20, 20) for n, v in place.items()}
        if i % 3 == 2:
            one = rng.choice(names)
            place[one] *= Decimal(10) ** rng.choice([-30, -12, -3, 3, 12, 30])
        yield place
    if domain == ">":
        return
    for i in range(DRAWS):
        place = {n: rng.choice(SIMPLE) * rng.choice([0, 1, 1]) for n in names}
        if domain == "" and i % 2:
            place = {n: v * rng.choice([1, -1]) for n, v in place.items()}
        yield place
    yield dict.fromkeys(names, Decimal(0))


def nearby(rng, place, domain):
    """Points near one, closer and closer."""
    for k in (1, 2, 3, 4, 6, 10, 20, 30):
        for _ in range(2):
            yield {n: v * (1 + Decimal(rng.choice([-1, 1, 0, 2])) * Decimal(10) ** -k) for n, v in place.items()}
        if domain == "":
            yield {n: v + Decimal(rng.choice([-1, 1, 0])) * Decimal(10) ** -k for n, v in place.items()}


def within(place, domain):
    return domain == "" or all(v > 0 or (v == 0 and domain == ">=") for v in place.values())


def places(rng, setting, domain, kept, claim):
    """Points of a domain at which symbols have values; where the premise is kept they are made of letters that fulfil it.

    Points near those at which both sides of the claim agree come last.
    """

    def whole(place):
        if not kept:
            return [place] if within(place, domain) else []
        try:
            place = place | {known.last: value(known.solution, place)}
            return [p for p in setting.symbols_of(place, domain) if within(p, domain)]
        except (Undefined, Unclear, ArithmeticError):
            return []

    known = setting.known
    names = [n for n in known.letters if n != known.last] if kept else setting.symbols
    draws = list(free(rng, names, domain))
    if kept:
        # a sum leaves room for the last letter where the others are small
        draws += [{n: v * rng.choice(SIMPLE) / 10 for n, v in place.items()} for place in draws]
        draws += [{n: v / 3 for n, v in place.items()} for place in draws]
    contacts = []
    for place in draws:
        for p in whole(place):
            yield p
            if len(contacts) < 4 and agree(claim, p):
                contacts.append(place)
    for contact in contacts:
        for place in nearby(rng, contact, domain):
            yield from whole(place)


def agree(claim, place):
    try:
        return holds(("=", *claim[1:]), place) is True
    except (Unclear, KeyError):
        return False


def digits():
    return localcontext(EXACT)
