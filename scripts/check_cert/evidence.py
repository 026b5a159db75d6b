"""Reads the parts of a certificate, and takes nothing on trust."""

import re
from fractions import Fraction
from math import gcd

from .errors import Rejected, demand
from .polynomial import LIMIT, OPPOSITE

INTEGER = re.compile(r"0|-?[1-9][0-9]*")


def keys(value, *names):
    """An object with these keys and no others; their values in order."""
    demand(isinstance(value, dict), "an object is expected")
    demand(set(value) == set(names), f"the keys {', '.join(names)} are expected")
    return [value[name] for name in names]


def optional(value, name, otherwise):
    """An object without a key that it may have, and what stands there."""
    demand(isinstance(value, dict), "an object is expected")
    demand(name not in value or value[name] != otherwise, f"the key {name} says what goes without saying")
    rest = {key: part for key, part in value.items() if key != name}
    return rest, value.get(name, otherwise)


def listed(value, length=None):
    """A list, of a known length."""
    demand(isinstance(value, list), "a list is expected")
    demand(length is None or len(value) == length, "a list has the wrong length")
    return value


def text(value):
    demand(isinstance(value, str), "a text is expected")
    return value


def count(value, below=LIMIT):
    """A number of something, from 0 up."""
    demand(type(value) is int and 0 <= value < below, "a number is out of range")
    return value


def integer(value):
    demand(isinstance(value, str) and INTEGER.fullmatch(value), "an integer is not well formed")
    return int(value)


def rational(value):
    """A rational number in lowest terms."""
    demand(isinstance(value, str), "a rational number is expected")
    numerator, *rest = value.split("/", 1)
    numerator = integer(numerator)
    if not rest:
        return Fraction(numerator)
    denominator = integer(rest[0])
    demand(denominator > 1 and gcd(numerator, denominator) == 1, "a rational number is not reduced")
    return Fraction(numerator, denominator)


def coefficients(value, kind):
    """Coefficients from the constant one up; the last is not 0."""
    found = [kind(entry) for entry in listed(value)]
    demand(not found or found[-1] != 0, "the leading coefficient is 0")
    return found


def polynomial(value, ring):
    """A polynomial with its terms in order."""
    found, last = {}, None
    for term in listed(value):
        coefficient, exponents = listed(term, 2)
        coefficient = integer(coefficient)
        demand(coefficient != 0 and isinstance(exponents, dict), "a term is not well formed")
        order = sorted(exponents.items())
        monomial, total = 0, 0
        for name, n in order:
            demand(type(n) is int and 0 < n < LIMIT, "an exponent is out of range")
            demand(name in ring.allowed, f"`{name}` is not known here")
            monomial += n << ring.shift(name)
            total += n
        demand(total < LIMIT, "a degree is too large")
        demand(last is None or last < order, "terms are not in order")
        found[monomial + total] = coefficient
        last = order
    return found


def condition(value, ring):
    poly, sign = keys(value, "poly", "is")
    demand(sign in OPPOSITE, "there is no such condition")
    return ring.condition(polynomial(poly, ring), sign)


def unique_keys(pairs):
    """For reading JSON: an object does not name a key twice."""
    found = dict(pairs)
    if len(found) != len(pairs):
        raise Rejected("a key stands twice in an object")
    return found
