"""Ends of ranges, and points of limits."""

import re
from fractions import Fraction

from .expressions import parts, spelled


def pi_bounds(reader, symbol):
    """Is `pi` a bound here, and not the symbol that is declared?"""
    if reader.word != "pi":
        return False
    item = spelled(reader.text[reader.start:].partition(",")[0])
    names = re.findall(r"(?<![\w'])[^\W\d_][\w']*", item)
    return symbol is not None or any(name != "pi" for name in names)


def allows(symbol, at, above):
    """Do the bounds of a symbol allow a side of a point?"""
    low, high = symbol.lower, symbol.upper
    if at is None:
        return (high if above else low) is None
    if above:
        return (low is None or low[0] <= at) and (high is None or at < high[0])
    return (low is None or low[0] < at) and (high is None or at <= high[0])


def rational(expression, reader):
    """The value of an expression of numbers alone."""
    kind = expression[0]
    if kind == "num":
        return Fraction(expression[1], expression[2])
    if kind in ("neg", "add", "sub", "mul", "div", "pow"):
        values = [rational(part, reader) for part in parts(expression)]
        if kind == "neg":
            return -values[0]
        if kind == "add":
            return values[0] + values[1]
        if kind == "sub":
            return values[0] - values[1]
        if kind == "mul":
            return values[0] * values[1]
        if kind == "div" and values[1]:
            return values[0] / values[1]
        if kind == "pow" and abs(expression[2]) < 1000 and (values[0] or expression[2] >= 0):
            return values[0] ** expression[2]
    return reader.fail("expected a rational number")
