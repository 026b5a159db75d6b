"""Exponentials and logarithms, written out by their functional equations (the language, "Exponentials").

exp(x) of a symbol is a symbol of its own, that of its finest part, and so is log(x); in x there is a constant.
"""

from fractions import Fraction
from math import lcm

from . import angles, expressions
from .errors import Rejected, demand

MAX_POWER, MAX_PARTS = 24, 12
ONE, ZERO = ("num", 1, 1), ("num", 0, 1)


class Met(Exception):
    """An exponential of so many parts, or a logarithm (of 0 parts), has to be read as a symbol."""

    def __init__(self, name, parts):
        super().__init__(name)
        self.name, self.parts = name, parts


def symbol_name(name, parts):
    """What stands for the exponential of a part, or for the logarithm."""
    return f"log({name})" if not parts else f"exp({name})" if parts == 1 else f"exp({name}/{parts})"


def constant(name, document):
    """Is it a symbol that varies with nothing?"""
    symbol = document.symbols[name]
    angle = symbol.parts or name in document.points
    return not (symbol.argument or symbol.body or angle or document.sequences.index_of(name))


def exponential(total, document, fail):
    """exp of a sum of symbols with rational factors."""
    if total is None or not all(isinstance(key, tuple) for key in total):
        fail("this is no exponent")
    whole = ONE
    order = list(document.symbols)
    for _, name in sorted(total, key=lambda key: order.index(key[1])):
        factor, base = total["of", name], name
        if name in document.exponentials:
            base, parts = document.exponentials[name]
            if parts:
                fail("this is no exponent")
        else:
            if not constant(name, document):
                fail("this is no exponent")
            parts = document.exponents.get((name, "exp"))
            if not parts or (factor * parts).denominator != 1:
                parts = lcm(parts or 1, factor.denominator)
                if parts > MAX_PARTS:
                    fail("the parts of an exponent are too fine")
                raise Met(name, parts)
            base, factor = symbol_name(name, parts), factor * parts
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
        times, base = powers[name], name
        if name in document.exponentials:
            base, parts = document.exponentials[name]
            if not parts:
                fail("this is no product")
            times = times / parts
        else:
            lower = document.symbols[name].lower
            if not constant(name, document) or not lower or not (lower[0] > 0 or lower == (0, True)):
                fail(f"`{name}` is not declared positive")
            if (name, "log") not in document.exponents:
                raise Met(name, 0)
            base = symbol_name(name, 0)
        number = ("num", times.numerator, times.denominator)
        whole = angles.plus(whole, angles.product(number, ("sym", base)))
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


def bounds(symbol, parts):
    """What the bounds of a symbol say of its exponential or its logarithm."""
    at = Fraction(0 if parts else 1)
    value = 1 - at
    ends = []
    for bound, sign in ((symbol.lower, 1), (symbol.upper, -1)):
        known = bound and sign * (bound[0] - at) >= 0
        ends.append((value, bound[1] or bound[0] != at) if known else None)
    if parts and not ends[0]:
        ends[0] = (Fraction(0), True)
    return ends


def is_exact(symbol, parts):
    """Do they say no more than that?"""
    if parts:
        return all(not bound or bound[0] == 0 for bound in (symbol.lower, symbol.upper))
    low, high = symbol.lower, symbol.upper
    return (low[0] == 1 or low == (0, True)) and (not high or high[0] == 1)


def relations(name, parts):
    """1 + x <= exp(x) and (1 - x)*exp(x) <= 1 of a part; log(x) <= x - 1 and x*log(x) >= x - 1."""
    x, e = ("sym", name), ("sym", symbol_name(name, parts))
    less = ("sub", x, ONE)
    if not parts:
        return [("<=", e, less), (">=", ("mul", x, e), less)]
    part = x if parts == 1 else ("div", x, ("num", parts, 1))
    return [(">=", e, ("add", ONE, part)), ("<=", ("mul", e, ("sub", ONE, part)), ONE)]


def has_derivative(e, document):
    if e[0] == "d":
        return True
    if e[0] == "def" and has_derivative(document.symbols[e[1]].body, document):
        return True
    return any(has_derivative(part, document) for part in expressions.parts(e))


def check(document, statement, fail):
    """They stand beside nothing that varies."""
    spoken = [statement, *statement.cited, *([statement.other] if statement.other else [])]
    said = [e for s in spoken for e in s.expressions()]
    names = set().union(*map(document.mentioned, said))
    if not names & set(document.exponentials):
        return
    functions = any(document.symbols[name].argument for name in names)
    if functions or any(s.limits for s in spoken) or any(has_derivative(e, document) for e in said):
        fail("`exp` and `log` do not go with functions, derivatives and limits")


def check_constants(document, fail):
    """Nothing varies with what stands in them."""
    bases = {name for name, _ in document.exponentials.values()} | set(document.exponentials)
    varying = {s.argument for s in document.symbols.values()} | {s.variable for s in document.statements.values()}
    for statement in document.statements.values():
        for expression in statement.expressions():
            slopes(expression, document, varying, set())
    if bases & varying:
        fail("what stands in `exp` and `log` is a constant")


def slopes(e, document, found, seen):
    """Adds the variables of derivatives."""
    if e[0] == "d":
        found.add(e[2])
    if e[0] == "def" and e[1] not in seen:
        seen.add(e[1])
        slopes(document.symbols[e[1]].body, document, found, seen)
    for part in expressions.parts(e):
        slopes(part, document, found, seen)


def check_witness(goal, kind, content, rests):
    """Have exponentials and logarithms the values of a point, for some value of what is in them?"""
    document = goal.document
    spoken = [name for name in document.exponentials if name in goal.mentioned]
    if not spoken:
        return
    demand(kind == "point", "functions do not show what exponentials are")
    demand(all(given in goal.cited for given in rests), "the witness is not one of all premises")
    for name in spoken:
        base, parts = document.exponentials[name]
        if base in goal.mentioned:
            values = (0, 1) if parts else (1, 0)
            for symbol, value in zip((base, name), values):
                found = content["values"].get(symbol)
                if found is None or len(found) > 1 or (Fraction(found[0]) if found else 0) != value:
                    raise Rejected(f"`{name}` need not have the value that it has beside `{base}`")
            continue
        alone = all(document.exponentials[other][0] != base or other == name for other in spoken)
        demand(alone and is_exact(document.symbols[base], parts), f"`{name}` need not have such a value")
