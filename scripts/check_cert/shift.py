"""Limits at a point that is no number (the language, "Limits"): of f at a + delta_x, for delta_x -> 0."""

from fractions import Fraction

from . import angles
from .bounds import has
from .expressions import parts

BEHIND = ("when", "from", "using", "expect", "by", "as")  # what may follow a point and its side


class Met(Exception):
    """Something tends to a point that is no number, and its distance has no symbol yet."""

    def __init__(self, name):
        super().__init__(name)
        self.name = name


def distance(name):
    return f"delta_{name}"


def point(reader):
    """Reads an expression behind which a side may stand: `a + b`, but `a` of `a+`."""
    left = reader.negative(reader.product()) if reader.take("-") else reader.product()
    while reader.kind == "sign" and reader.word in "+-" and operand_follows(reader):
        sign = reader.take("+", "-")
        left = ("add" if sign == "+" else "sub", left, reader.product())
    return left


def operand_follows(reader):
    ahead = reader.ahead()
    return ahead not in ("", ",", *BEHIND)


def read(document, statement, at, reader):
    """Puts a + delta_x in the place of x in what has a limit at a."""
    x, symbols = statement.variable, document.symbols
    if not document.is_plain(x):
        reader.fail("the variable of such a limit is a plain variable")
    if not document.mentioned(at) and not has("sqrt", at, document):
        reader.fail("the point has no value")
    if speaks(document, at, x):
        reader.fail(f"the point must be free of `{x}`")
    if not is_inside(document, symbols[x], at):
        reader.fail(f"the point is not known to lie inside the range of `{x}`")
    if distance(x) not in symbols:
        raise Met(x)
    value = ("add", at, ("sym", distance(x)))
    items = []
    for sign, f, limit in statement.items:
        if sign != "->":
            items.append((sign, f, limit))
            continue
        if isinstance(limit, tuple) and document.depends(limit, x):
            reader.fail(f"the limit must be free of `{x}`")
        items.append((sign, put_in(document, f, x, value, reader), limit))
    statement.items = items
    statement.moving, statement.variable, statement.at = x, distance(x), Fraction(0)


def is_inside(document, symbol, at):
    """Does the point lie inside the range of a symbol, by what is declared?"""
    if symbol.floor or symbol.ceiling:
        return False
    of = document.symbols[at[1]] if at[0] == "sym" else None
    low = of.lower if of else None
    high = of.upper if of else None
    if symbol.lower and not (low and (low[0] > symbol.lower[0] or low[1] and low[0] == symbol.lower[0])):
        return False
    return not symbol.upper or bool(high and (high[0] < symbol.upper[0] or high[1] and high[0] == symbol.upper[0]))


def speaks(document, expression, x):
    """Does an expression speak of x, a function of it, or what is made of it?"""
    known = document.sequences

    def made_of(name):
        exponents = document.exponentials.get(name, ((),))[0]
        sources = (*known.powers.get(name, ())[:1], *known.steps.get(name, ())[:2])
        point = {part[1] for part in angles.point(x, document.symbols[x].parts)} if document.symbols[x].parts else set()
        return x in dict(exponents) or name in point or any(speaks(document, e, x) for e in sources)

    return any(
        name == x or document.symbols[name].argument == x or made_of(name) for name in document.mentioned(expression)
    )


def put_in(document, expression, x, value, reader):
    """The expression with a value for x, definitions that speak of it written out."""
    kind = expression[0]
    if expression == ("sym", x):
        return value
    if kind in ("sym", "d") and speaks(document, expression, x):
        reader.fail(f"this varies with `{x}`, which tends to a point that is no number")
    if kind == "def" and speaks(document, expression, x):
        return put_in(document, document.symbols[expression[1]].body, x, value, reader)

    def go(part):
        return put_in(document, part, x, value, reader)

    if kind == "cases":
        branches = tuple(
            (tuple((sign, go(left), go(right)) for sign, left, right in guard), go(body))
            for guard, body in expression[1]
        )
        return ("cases", branches, None if expression[2] is None else go(expression[2]))
    inside = set(map(id, parts(expression)))
    return tuple(go(part) if id(part) in inside else part for part in expression)


def check(document, statement, reader):
    """What such a limit rests on speaks of nothing that tends to the point."""
    x, todo, seen = statement.moving, list(statement.cited), set()
    while x and todo:
        said = todo.pop()
        if id(said) in seen:
            continue
        seen.add(id(said))
        todo += said.cited
        if said.variable == x or any(document.depends(e, x) for e in said.expressions()):
            reader.fail(f"`{said.label}` speaks of `{x}`, which tends to a point that is no number")
