"""The points and functions that a report names, as values."""

import re
from fractions import Fraction

import told
from document import Structure
from reader import Unreadable, number, pairs, read

TAKE = re.compile(r"^Take (.*)\.$")
FAILS = re.compile(r"^Then it fails at (.*)\.$")


def point(link):
    """The values named by 'At the point …:', or None."""
    for text in told.lines(link):
        head = told.point(text)
        if head:
            roots = {}
            return {n: number(v, roots) for n, v in pairs(head[0])}
    return None


def functions(link):
    """Expressions named by 'Take …', {} if nothing had to be chosen, or None if it is another kind."""
    texts = told.lines(link)
    for t in texts:
        m = TAKE.match(t)
        if m:
            return {n: read(v) for n, v in pairs(m.group(1))}
    if any(t.startswith("Then the limit is") or t.startswith("Then it ") for t in texts):
        return {}
    return None


def failing_place(link):
    """The value of the limit variable of 'Then it fails at x = …', or None."""
    for step in link["steps"]:
        m = FAILS.match(step["text"])
        if m:
            roots = {}
            return {n: number(v, roots) for n, v in pairs(m.group(1))}
    return None


def complete(document, values):
    """Names that the report leaves out do not matter, but have to be somewhere."""
    out = dict(values)
    for v in document.vars:
        if v.name not in out:
            out[v.name] = somewhere(v)
    return out


def somewhere(v):
    for c in (1, 2, 0, -1, Fraction(1, 2), Fraction(-1, 2), 3, -2, 5, -5):
        if v.allows(Fraction(c)):
            return Fraction(c)
    if v.lower and v.upper:
        return (v.lower[0] + v.upper[0]) / 2
    return v.lower[0] + Fraction(1, 9) if v.lower else v.upper[0] - Fraction(1, 9)


def structure(document, x, taken):
    """Constants and functions as the report chose them; what it leaves out is a constant somewhere."""
    constants, written = {}, {}
    for v in document.vars:
        if v.name == x:
            continue
        if v.argument is None:
            if v.name in taken:
                constants[v.name] = number_of(taken[v.name])
            else:
                constants[v.name] = somewhere(v)
        else:
            written[v.name] = taken.get(v.name, ("n", somewhere(v)))
    return Structure(x, constants, written)


def number_of(e):
    from point import Scope, evaluate

    try:
        return evaluate(e, Scope({}, {}))
    except KeyError as missing:
        raise Unreadable(str(missing))


def model(statement):
    """The model shown with a statement: ('point', values), ('functions', expressions) or None."""
    named = statement["model"]
    if named is None:
        return None
    roots = {}
    try:
        return "point", {p["name"]: number(p["value"], roots) for p in named}
    except Unreadable:
        return "functions", {p["name"]: read(p["value"]) for p in named}
