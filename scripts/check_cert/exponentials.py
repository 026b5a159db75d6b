"""Exponentials and logarithms, written out by their functional equations (the language, "Exponentials").

exp(u) of a product of symbols is a symbol of its own, that of its finest part, and so is log(x). A product is a
tuple of names with their powers, in the order in which they are declared.
"""

from fractions import Fraction
from math import lcm

from . import angles
from .errors import demand

MAX_POWER, MAX_PARTS, MAX_SUMMANDS = 24, 12, 64
ONE, ZERO = ("num", 1, 1), ("num", 0, 1)


class Met(Exception):
    """An exponential of so many parts, or a logarithm (of 0 parts), has to be read as a symbol."""

    def __init__(self, of, parts):
        super().__init__(str(of))
        self.of, self.parts = of, parts


def symbol_name(of, parts):
    """What stands for the exponential of a part, or for the logarithm."""
    written = [(name if abs(n) == 1 else f"{name}^{abs(n)}", n) for name, n in of]
    whole = "*".join(text for text, n in written if n > 0) or "1"
    whole += "".join(f"/{text}" for text, n in written if n < 0)
    return f"log({whole})" if not parts else f"exp({whole})" if parts == 1 else f"exp({whole}/{parts})"


def may_stand(name, document):
    """Is it declared by its name, and no index and no angle?"""
    symbol = document.symbols[name]
    angle = symbol.parts or name in document.points
    return "(" not in name and not (symbol.body or angle or document.sequences.index_of(name))


def never_zero(name, document):
    """Do its bounds exclude 0?"""
    symbol = document.symbols[name]
    low, high = symbol.lower, symbol.upper
    return bool(low and (low[0] > 0 or low == (0, True)) or high and (high[0] < 0 or high == (0, True)))


def times(a, b, document):
    powers = dict(a)
    for name, n in b:
        powers[name] = powers.get(name, 0) + n
    order = list(document.symbols)
    return tuple(sorted(((name, n) for name, n in powers.items() if n), key=lambda power: order.index(power[0])))


def multiplied(a, b, document, fail):
    if len(a) * len(b) > MAX_SUMMANDS:
        fail("this is no exponent")
    found = {}
    for m, p in a.items():
        for n, q in b.items():
            both = times(m, n, document)
            found[both] = found.get(both, 0) + p * q
    return angles.cleared(found)


def summands(e, document, fail):
    """A sum of products with rational factors."""
    kind = e[0]
    inside = [part for part in e[1:] if isinstance(part, tuple)] if kind != "num" else []
    if kind == "num":
        return {(): Fraction(e[1], e[2])}
    if kind == "sym":
        return {((e[1], 1),): Fraction(1)}
    if kind == "def":
        return summands(document.symbols[e[1]].body, document, fail)
    if kind not in ("neg", "add", "sub", "mul", "div", "pow"):
        fail("this is no exponent")
    found = [summands(part, document, fail) for part in inside]
    if kind in ("neg", "add", "sub"):
        total = {} if kind == "neg" else dict(found[0])
        for of, factor in found[-1].items():
            total[of] = total.get(of, 0) + (factor if kind == "add" else -factor)
        return angles.cleared(total)
    if kind == "mul":
        return multiplied(*found, document, fail)
    n = -1 if kind == "div" else e[2]
    if abs(n) > MAX_POWER:
        fail("this is no exponent")
    if n < 0:
        if len(found[-1]) != 1:
            fail("this is no exponent")
        ((of, factor),) = found[-1].items()
        if not factor or not all(never_zero(name, document) for name, _ in of):
            fail("what divides in an exponent may be 0")
        inverse = {tuple((name, m * n) for name, m in of): factor**n}
        return multiplied(found[0], inverse, document, fail) if kind == "div" else inverse
    total = {(): Fraction(1)}
    for _ in range(n):
        total = multiplied(total, found[0], document, fail)
    return total


def variable(of, document, fail):
    """The variable with which a product varies."""
    found = {document.symbols[name].argument or (name if name in document.limited else None) for name, _ in of} - {None}
    if len(found) > 1:
        fail("an exponent varies with two variables")
    return next(iter(found), None)


def exponential(e, document, fail):
    """exp of a sum of products of symbols with rational factors."""
    whole, order = ONE, list(document.symbols)
    found = summands(e, document, fail)
    for of in sorted(found, key=lambda of: [(order.index(name), n) for name, n in of]):
        factor = found[of]
        known = document.exponentials.get(of[0][0]) if len(of) == 1 and of[0][1] == 1 else None
        if known and known[1] == 0:
            base = known[0][0][0]
        else:
            if not of or not all(may_stand(name, document) for name, _ in of):
                fail("this is no exponent")
            variable(of, document, fail)
            parts = document.exponents.get((of, "exp"))
            if not parts or (factor * parts).denominator != 1:
                parts = lcm(parts or 1, factor.denominator)
                if parts > MAX_PARTS:
                    fail("the parts of an exponent are too fine")
                raise Met(of, parts)
            base, factor = symbol_name(of, parts), factor * parts
            if base not in document.symbols:
                fail("an exponential stands above the end of its declaration")
        if factor.denominator != 1 or abs(factor) > MAX_POWER:
            fail("the multiple of an exponent is too large, or not whole")
        power = ("sym", base) if factor == 1 else ("pow", ("sym", base), int(factor))
        whole = angles.product(whole, power)
    return whole


def logarithm(e, document, fail):
    """log of a product of powers of positive symbols."""
    powers, whole = {}, ZERO
    factors(e, Fraction(1), powers, fail)
    order = list(document.symbols)
    for name in sorted(powers, key=order.index):
        factor, base = powers[name], ("sym", name)
        if name in document.exponentials:
            of, parts = document.exponentials[name]
            if not parts:
                fail("this is no product")
            factor, base = factor / parts, product(of)
        else:
            lower = document.symbols[name].lower
            if not may_stand(name, document) or not lower or not (lower[0] > 0 or lower == (0, True)):
                fail(f"`{name}` is not declared positive")
            of = ((name, 1),)
            if (of, "log") not in document.exponents:
                raise Met(of, 0)
            base = ("sym", symbol_name(of, 0))
            if base[1] not in document.symbols:
                fail("a logarithm stands above the end of its declaration")
        number = ("num", factor.numerator, factor.denominator)
        whole = angles.plus(whole, angles.product(number, base))
    return whole


def factors(e, power, found, fail):
    """Adds the symbols of a product with their powers."""
    if e[0] == "sym":
        found[e[1]] = found.get(e[1], Fraction(0)) + power
    elif e[0] in ("mul", "div"):
        factors(e[1], power, found, fail)
        factors(e[2], -power if e[0] == "div" else power, found, fail)
    elif e[0] == "pow":
        factors(e[1], power * e[2], found, fail)
    elif e != ONE:
        fail("this is no product")


def product(of, without=None):
    """A product as an expression; without one power of a name, its derivative by it."""
    whole = ONE
    for name, n in of:
        if name == without:
            whole, n = angles.product(whole, ("num", n, 1)), n - 1
        if n:
            whole = angles.product(whole, ("sym", name) if n == 1 else ("pow", ("sym", name), n))
    return whole


def slope(name, inside, document):
    """The derivative of an exponential or a logarithm, given that of what is in it."""
    of, parts = document.exponentials[name]
    if not parts:
        return ("div", inside, product(of))
    whole = angles.product(("sym", name), inside)
    return whole if parts == 1 else ("div", whole, ("num", parts, 1))


def holding(name, document):
    """The exponentials and logarithms in which a symbol stands."""
    return [e for e, (of, _) in document.exponentials.items() if name in dict(of)]


def by_factor(f, name, names, document):
    """d f / d x = ∂f/∂x + Σ ∂f/∂E·E·∂u/∂x over the exponentials in which x stands."""
    total = ("d", f, name)
    for e in holding(name, document):
        if e in names:
            inside = product(document.exponentials[e][0], without=name)
            total = angles.plus(total, angles.product(("d", f, e), slope(e, inside, document)))
    return total


def ends(of, document):
    """The bounds of a symbol, or those at 0 of a product; and do they say all?"""
    if len(of) == 1 and of[0][1] == 1:
        symbol = document.symbols[of[0][0]]
        return symbol.lower, symbol.upper, True
    sign, strict, exact = 1, True, True
    for name, n in of:
        low, high = document.symbols[name].lower, document.symbols[name].upper
        exact = exact and all(not bound or bound[0] == 0 for bound in (low, high)) and not (low and high)
        side = 1 if low and low[0] >= 0 else -1 if high and high[0] <= 0 else 0
        bound = {1: low, -1: high}.get(side)
        strict = strict and bool(bound) and (bound[1] or bound[0] != 0)
        if n % 2:
            sign *= side
    end = (Fraction(0), strict)
    return end if sign > 0 else None, end if sign < 0 else None, exact


def bounds(of, parts, document):
    """What the bounds of its symbols say of an exponential or a logarithm."""
    at = Fraction(0 if parts else 1)
    value = 1 - at
    found = []
    for bound, sign in zip(ends(of, document)[:2], (1, -1)):
        known = bound and sign * (bound[0] - at) >= 0
        found.append((value, bound[1] or bound[0] != at) if known else None)
    if parts and not found[0]:
        found[0] = (Fraction(0), True)
    return found


def is_exact(of, parts, document):
    """Do they say no more than that?"""
    low, high, exact = ends(of, document)
    if parts:
        return exact and all(not bound or bound[0] == 0 for bound in (low, high))
    return (low[0] == 1 or low == (0, True)) and (not high or high[0] == 1)


def relations(of, parts):
    """1 + u <= exp(u) and (1 - u)*exp(u) <= 1 of a part; log(x) <= x - 1 and x*log(x) >= x - 1."""
    x, e = product(of), ("sym", symbol_name(of, parts))
    less = ("sub", x, ONE)
    if not parts:
        return [("<=", e, less), (">=", ("mul", x, e), less)]
    part = x if parts == 1 else ("div", x, ("num", parts, 1))
    return [(">=", e, ("add", ONE, part)), ("<=", ("mul", e, ("sub", ONE, part)), ONE)]


def check_witness(goal, kind, content, rests):
    """Have exponentials and logarithms the values of a point, for some value of what is in them?"""
    document = goal.document
    spoken = [name for name in document.exponentials if name in goal.mentioned]
    if not spoken:
        return
    demand(kind == "point", "functions do not show what exponentials are")
    demand(all(given in goal.cited for given in rests), "the witness is not one of all premises")
    demand(not any(name in document.rate_of for name in goal.mentioned), "no equation is solved for an exponential")

    def has(name, value):
        found = content["values"].get(name)
        known = name in goal.mentioned and found is not None and len(found) < 2
        return known and (Fraction(found[0]) if found else 0) == value

    for name in spoken:
        of, parts = document.exponentials[name]
        if any(base in goal.mentioned for base, _ in of):
            if parts:
                known = has(name, 1) and any(n > 0 and has(base, 0) for base, n in of)
            else:
                known = has(name, 0) and has(of[0][0], 1)
            demand(known, f"`{name}` need not have the value that it has beside what is in it")
            continue
        others = [document.exponentials[other][0] for other in spoken if other != name]
        alone = not any(dict(of).keys() & dict(other).keys() for other in others)
        demand(alone and is_exact(of, parts, document), f"`{name}` need not have such a value")
