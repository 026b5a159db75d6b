"""Sine and cosine in decimals, of the precision that is set."""

from decimal import Decimal, getcontext


def circular(x):
    """sin and cos by their series, the argument halved and doubled again."""
    halvings = max(0, int(abs(x)).bit_length() + 6)
    part = x / 2**halvings
    sin, cos, term, n = Decimal(0), Decimal(0), Decimal(1), 0
    while abs(term) > Decimal(10) ** (-2 - getcontext().prec):
        if n % 2:
            sin += term if n % 4 == 1 else -term
        else:
            cos += term if n % 4 == 0 else -term
        n += 1
        term = term * part / n
    for _ in range(halvings):
        sin, cos = 2 * sin * cos, cos * cos - sin * sin
    return sin, cos
