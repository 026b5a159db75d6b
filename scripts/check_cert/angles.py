"""Angles: sine and cosine of sums of angles, and what holds of an angle (the language, "Angles").

What stands for an angle is the point (cos, sin) of one of its equal parts.
"""

from fractions import Fraction
from math import comb, lcm

from .errors import Unreadable, demand

MAX_MULTIPLE, MAX_PARTS = 24, 12
ZERO, ONE = ("num", 0, 1), ("num", 1, 1)
# cosines of multiples of pi/12 up to pi/2
ACUTE = [
    ONE,
    ("div", ("add", ("sqrt", ("num", 6, 1)), ("sqrt", ("num", 2, 1))), ("num", 4, 1)),
    ("div", ("sqrt", ("num", 3, 1)), ("num", 2, 1)),
    ("div", ("sqrt", ("num", 2, 1)), ("num", 2, 1)),
    ("div", ONE, ("num", 2, 1)),
    ("div", ("sub", ("sqrt", ("num", 6, 1)), ("sqrt", ("num", 2, 1))), ("num", 4, 1)),
    ZERO,
]


class Met(Exception):
    """A symbol has to be read as an angle, in parts as fine."""

    def __init__(self, name, parts):
        super().__init__(name)
        self.name, self.parts = name, parts


def summed(expression):
    """A sum of symbols, pi and a number with rational factors, as a dictionary; None if it is none."""
    kind = expression[0]
    if kind == "num":
        return {"": Fraction(expression[1], expression[2])}
    if kind in ("sym", "pi"):
        return {"pi" if kind == "pi" else ("of", expression[1]): Fraction(1)}
    if kind not in ("neg", "add", "sub", "mul", "div"):
        return None
    found = [summed(part) for part in expression[1:]]
    if None in found:
        return None
    if kind in ("mul", "div"):
        left, right = found
        if kind == "mul" and not set(left) <= {""}:
            left, right = right, left
        number, rest = (left, right) if kind == "mul" else (right, left)
        if not set(number) <= {""}:
            return None
        factor = number.get("", Fraction(0))
        if kind == "div":
            if not factor:
                return None
            factor = 1 / factor
        return cleared({key: value * factor for key, value in rest.items()})
    total = {}
    for sign, part in zip((-1,) if kind == "neg" else (1, -1 if kind == "sub" else 1), found):
        for key, value in part.items():
            total[key] = total.get(key, Fraction(0)) + sign * value
    return cleared(total)


def cleared(total):
    return {key: value for key, value in total.items() if value}


class MetAlone(Exception):
    """An angle stands by itself."""

    def __init__(self, name):
        super().__init__(name)
        self.name = name


TAYLOR = 4  # relations of an arc without a range


def arc(symbol, ends):
    """What cosine and sine of a part are beside it, and that an angle lies in its range: 333/106 < pi < 355/113."""
    u = ("sym", symbol.name) if symbol.parts == 1 else ("div", ("sym", symbol.name), ("num", symbol.parts, 1))
    cos, sin = point(symbol.name, symbol.parts)
    square, fourth = ("pow", u, 2), ("pow", u, 4)
    low = ("sub", ONE, ("div", square, ("num", 2, 1)))
    found = [
        (">=", ("mul", u, sin), ("sub", square, ("div", fourth, ("num", 6, 1)))),
        ("<=", ("mul", u, sin), square),
        (">=", cos, low),
        ("<=", cos, ("add", low, ("div", fourth, ("num", 24, 1)))),
    ]
    for sign, end in zip((">", "<"), ends):
        if end and end[0]:
            pi = Fraction(333, 106) if (sign == ">") == (end[0] > 0) else Fraction(355, 113)
            at = end[0] * pi
            found.append((sign, ("sym", symbol.name), ("num", at.numerator, at.denominator)))
    return found


def negative(a):
    return a[1] if a[0] == "neg" else a if a == ZERO else ("neg", a)


def product(a, b):
    if ZERO in (a, b):
        return ZERO
    if a == ONE:
        return b
    if b == ONE:
        return a
    if a[0] == "neg":
        return negative(product(a[1], b))
    if b[0] == "neg":
        return negative(product(b[1], a))
    return ("mul", a, b)


def plus(a, b):
    if a == ZERO:
        return b
    if b == ZERO:
        return a
    return ("sub", a, b[1]) if b[0] == "neg" else ("add", a, b)


def power(a, n):
    return ONE if n == 0 else a if n == 1 else ("pow", a, n)


def multiple(cos, sin, n):
    """The binomial formula for (cos + i sin)^n."""
    total = [ZERO, ZERO]
    for k in range(n + 1):
        term = product(("num", comb(n, k), 1), product(power(cos, n - k), power(sin, k)))
        total[k % 2] = plus(total[k % 2], negative(term) if k % 4 > 1 else term)
    return total


def surd(twelfths):
    """The cosine of a multiple of pi/12."""
    k = twelfths % 24
    k = min(k, 24 - k)
    return negative(ACUTE[12 - k]) if k > 6 else ACUTE[k]


def direction(total, document, fail):
    """Cosine and sine of such a sum."""
    if "" in total:
        fail("this is no angle")
    twelfths = total.get("pi", Fraction(0)) * 12
    if twelfths.denominator != 1:
        fail("only multiples of pi/12 have values")
    cos, sin = surd(int(twelfths)), surd(int(twelfths) - 6)
    order = list(document.symbols)
    for key in sorted((key for key in total if key != "pi"), key=lambda key: order.index(key[1])):
        name, factor = key[1], total[key]
        parts = document.symbols[name].parts
        if not parts or (factor * parts).denominator != 1:
            parts = lcm(parts or 1, factor.denominator)
            if parts > MAX_PARTS:
                fail("the parts of an angle are too fine")
            raise Met(name, parts)
        times = int(factor * parts)
        if abs(times) > MAX_MULTIPLE:
            fail("the multiple of an angle is too large")
        c, s = multiple(*point(name, parts), abs(times))
        s = negative(s) if times < 0 else s
        cos, sin = (
            plus(product(cos, c), negative(product(sin, s))),
            plus(product(sin, c), product(cos, s)),
        )
    return cos, sin


def point(name, parts):
    """The symbols for the cosine and the sine of a part."""
    part = name if parts == 1 else f"{name}/{parts}"
    return ("sym", f"cos({part})"), ("sym", f"sin({part})")


def slope(f, symbol, mentioned):
    """d f / d angle by the chain rule."""
    cos, sin = point(symbol.name, symbol.parts)
    up = product(("d", f, sin[1]), cos) if sin[1] in mentioned else ZERO
    down = product(("d", f, cos[1]), sin) if cos[1] in mentioned else ZERO
    found = up if down == ZERO else negative(down) if up == ZERO else ("sub", up, down)
    found = found if symbol.parts == 1 else ("div", found, ("num", symbol.parts, 1))
    return plus(("d", f, symbol.name), found) if symbol.name in mentioned else found


def check_witness(goal, kind, content, rests):
    """An angle beside its point is 0 at a witness, where its sine and cosine are known."""
    document = goal.document
    for name in document.arcs:
        cos, sin = (part[1] for part in point(name, document.symbols[name].parts))
        if name not in goal.mentioned or not {cos, sin} & set(goal.mentioned):
            continue
        demand(kind == "point", "functions do not show what a sine is")
        demand(all(given in goal.cited for given in rests), "the witness is not one of all premises")
        demand(not any(other in document.rate_of for other in goal.mentioned), "an angle moves as its point does")
        for part, value in ((name, 0), (cos, 1), (sin, 0)):
            if part in goal.mentioned:
                found = content["values"].get(part)
                known = found is not None and len(found) < 2
                demand(known and Fraction(found[0] if found else 0) == value, f"`{part}` need not have such a value")


def circle(symbol, ends, document):
    """The relations that hold of an angle: the unit circle, and its range."""
    name, parts = symbol.name, symbol.parts
    cos, sin = point(name, parts)
    relations = [("=", ("add", ("pow", cos, 2), ("pow", sin, 2)), ONE)]
    low, high = ends
    if low is None or high is None:
        return relations

    def fail(reason):
        raise Unreadable(f"`{name}`: {reason}")

    (a, after), (b, before) = low, high
    if a > b or (a == b and (after or before)):
        fail("the domain is empty")
    width = (b - a) / parts
    start = direction(cleared({("of", name): Fraction(1, parts), "pi": -a / parts}), document, fail)
    end = direction(cleared({("of", name): Fraction(-1, parts), "pi": b / parts}), document, fail)
    if width == 0:
        return [*relations, ("=", start[0], ONE)]
    if width >= 2:
        open_ends = width == 2 and after and before
        return [*relations, ("!=", start[0], ONE)] if open_ends else relations
    if width > 1:
        fail("more than half a turn and less than a whole one")
    both = width < 1 or (after and before)
    for (c, s), strict in ((start, after), (end, before)):
        relations.append((">" if strict and both else ">=", s, ZERO))
        if strict and not both:
            relations.append(("!=", c, ONE))
    return relations
