"""Fractions of two polynomials, formed without cancelling."""

from .polynomial import add, is_constant, multiply, negative


def plus(a, b):
    """The sum of two fractions; equal denominators are kept."""
    if a[1] == b[1]:
        return add(a[0], b[0]), a[1]
    return add(multiply(a[0], b[1]), multiply(b[0], a[1])), multiply(a[1], b[1])


def minus(a):
    return negative(a[0]), a[1]


def times(a, b):
    return multiply(a[0], b[0]), multiply(a[1], b[1])


def sign_of(a):
    """A polynomial with the sign of a fraction."""
    numerator, denominator = a
    if is_constant(denominator):
        return numerator if denominator[0] > 0 else negative(numerator)
    return multiply(numerator, denominator)
