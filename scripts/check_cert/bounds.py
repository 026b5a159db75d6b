"""Ends of ranges, and points of limits.

A bound that is an expression is a `given`, `bounds x`, on which whoever speaks of x rests.
"""

import re
from fractions import Fraction
from math import isqrt

from .expressions import has_pi, parts, spelled as spelled_out, symbols_in

SIGNS = ("=", "!=", "<", "<=", ">", ">=")


def pi_bounds(reader, symbol):
    """Is `pi` a bound here, and not the symbol that is declared?"""
    if reader.word != "pi":
        return False
    item = spelled_out(reader.text[reader.start:].partition(",")[0])
    names = re.findall(r"(?<![\w'])[^\W\d_][\w']*", item)
    return symbol is not None or any(name != "pi" for name in names)


def stands_first(reader):
    """Is a bound ahead and then a symbol, and not the symbol first: `a < x < b`, `2*a < x`, but not `x(t) < a`?"""
    if reader.kind != "name" or reader.word == "oo":
        return True
    before = reader.at, reader.start, reader.kind, reader.word
    depth, relations, words = 0, 0, []
    while reader.kind != "end" and not (depth == 0 and reader.word == ","):
        word = reader.word if reader.kind == "sign" else reader.kind
        depth += (word in ("(", "[", "{")) - (depth > 0 and word in (")", "]", "}"))
        if depth == 0 and word in SIGNS:
            relations += 1
        if not relations:
            words.append(word)
        reader.advance()
    reader.at, reader.start, reader.kind, reader.word = before
    goes_on = words[1:] and words[1] in ("+", "-", "*", "/", "^", "raised", "(")
    return relations == 2 or relations == 1 and goes_on and words != ["name", "(", "name", ")"]


def of_pi(expression):
    """Is it made of numbers and pi alone, and not of numbers alone?"""
    names = set()
    symbols_in(expression, names)
    return not names and has_pi(expression)


def number(expression):
    """The value of an expression without symbols; None where it is no rational number."""
    kind = expression[0]
    if kind == "num":
        return Fraction(expression[1], expression[2])
    if kind == "pow":
        value = number(expression[1])
        fits = value is not None and (value or expression[2] >= 0)
        return value ** expression[2] if fits else None
    if kind not in ("neg", "abs", "add", "sub", "mul", "div", "min", "max", "sqrt"):
        return None
    values = [number(part) for part in expression[1:]]
    if None in values:
        return None
    if kind == "div":
        return values[0] / values[1] if values[1] else None
    if kind == "sqrt":
        return root(values[0])
    return {
        "neg": lambda a: -a, "abs": abs, "add": lambda a, b: a + b, "sub": lambda a, b: a - b,
        "mul": lambda a, b: a * b, "min": min, "max": max,
    }[kind](*values)


def root(value):
    if value < 0:
        return None
    found = Fraction(isqrt(value.numerator), isqrt(value.denominator))
    return found if found * found == value else None


def constant(name, document):
    """Is it a symbol that varies with nothing?"""
    symbol = document.symbols[name]
    angle = symbol.parts or name in document.points
    return not (symbol.argument or symbol.body or angle or document.sequences.index_of(name))


def has(kind, e, document):
    """Does something of a kind stand in it, or in what it is defined by?"""
    if e[0] == kind:
        return True
    if e[0] == "def" and has(kind, document.symbols[e[1]].body, document):
        return True
    return any(has(kind, part, document) for part in parts(e))


def unfit(expression, document):
    """Does a bound speak of something that is no constant?"""
    if has_pi(expression) or has("d", expression, document):
        return True
    names = document.mentioned(expression)
    return any(name in document.exponentials or not constant(name, document) for name in names)


def relations(symbol):
    """What bounds that are expressions say: the lower one first."""
    own, found = ("sym", symbol.name), []
    if symbol.floor:
        found.append(("<" if symbol.floor[1] else "<=", symbol.floor[0], own))
    if symbol.ceiling:
        found.append(("<" if symbol.ceiling[1] else "<=", own, symbol.ceiling[0]))
    return found


def spoken(document, statements):
    """The `given`s of the bounds of symbols of which statements speak, and of what these bounds speak of."""
    todo, seen, found = [], set(), []
    for statement in statements:
        todo += [statement.variable] if statement.variable else []
        for expression in statement.expressions():
            todo += document.mentioned(expression)
    known = document.sequences
    while todo:
        name = todo.pop()
        if name in seen:
            continue
        seen.add(name)
        if name in document.exponentials:
            todo += [base for base, _ in document.exponentials[name][0]]
        for expression in (*known.powers.get(name, ())[:1], *known.steps.get(name, ())[:2]):
            todo += document.mentioned(expression)
        if name in document.ranges:
            given = document.ranges[name]
            found.append(given)
            for expression in given.expressions():
                todo += document.mentioned(expression)
    order = list(document.statements.values())
    return sorted(found, key=order.index)


def allows(symbol, at, above):
    """Do the bounds of a symbol allow a side of a point?"""
    low, high = symbol.lower, symbol.upper
    if at is None:
        return (high if above else low) is None
    if above:
        return (low is None or low[0] <= at) and (high is None or at < high[0])
    return (low is None or low[0] < at) and (high is None or at <= high[0])
