"""The greatest common divisor of two polynomials, so that a fraction can be reduced."""

from functools import reduce
from itertools import zip_longest
from math import gcd

from .polynomial import BITS, FIELD, ONE, add, multiply, negative

MAX_TERMS = 400  # above this nothing is divided


class TooLarge(Exception):
    pass


def reduced(p, q):
    """The fraction p/q in lowest terms, or as it is where that takes long."""
    try:
        common = divisor(p, q)
        return divide(p, common), divide(q, common)
    except TooLarge:
        return p, q


def divisor(p, q):
    """The greatest common divisor, by remainders in one variable after the other."""
    if not p or not q:
        return p or q
    union = reduce(lambda a, b: a | b, (m >> BITS for m in (*p, *q)))
    if not union:
        return {0: gcd(p[0], q[0])}
    shift = BITS * (1 + (union.bit_length() - 1) // BITS)  # the last variable that occurs
    parts_p, parts_q = coefficients(p, shift), coefficients(q, shift)
    content_p, content_q = content(parts_p), content(parts_q)
    common = divisor(content_p, content_q)
    a, b = divide(p, content_p), divide(q, content_q)
    if top(a, shift) < top(b, shift):
        a, b = b, a
    while top(b, shift):
        rest = remainder(a, b, shift)
        if not rest:
            return multiply(common, b)
        a, b = b, divide(rest, content(coefficients(rest, shift)))
    return common


def coefficients(p, shift):
    """The coefficients of the powers of one variable."""
    found = {}
    for monomial, value in p.items():
        n = monomial >> shift & FIELD
        found.setdefault(n, {})[monomial - (n << shift) - n] = value
    return found


def content(parts):
    return reduce(divisor, parts.values())


def top(p, shift):
    return max(monomial >> shift & FIELD for monomial in p)


def remainder(a, b, shift):
    """What is left of a, times a power of the leading coefficient of b, without multiples of b."""
    n = top(b, shift)
    lead = coefficients(b, shift)[n]
    while a and top(a, shift) >= n:
        if len(a) > MAX_TERMS:
            raise TooLarge
        k = top(a, shift)
        first = coefficients(a, shift)[k]
        step = {((k - n) << shift) + k - n: 1}
        a = add(multiply(a, lead), negative(multiply(multiply(b, first), step)))
    return a


def divide(p, q):
    """p/q if that is a polynomial, else None."""
    if q == ONE:
        return p
    lead = max(q, key=lambda m: m >> BITS)
    quotient = {}
    while p:
        if len(p) > MAX_TERMS or len(quotient) > MAX_TERMS:
            raise TooLarge
        first = max(p, key=lambda m: m >> BITS)
        if p[first] % q[lead] or any(a < b for a, b in zip_longest(fields(first), fields(lead), fillvalue=0)):
            return None
        quotient[first - lead] = p[first] // q[lead]
        p = add(p, negative(multiply(q, {first - lead: quotient[first - lead]})))
    return quotient


def fields(monomial):
    """The exponents in a monomial, after its degree."""
    return [monomial >> shift & FIELD for shift in range(BITS, monomial.bit_length(), BITS)]
