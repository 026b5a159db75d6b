"""Units: dimensions of symbols, and of what is said with them (the language, "Units").

A dimension is a dictionary from base units to powers; None is one that is not known.
"""

from fractions import Fraction

from .errors import Unreadable

BASE = ("kg", "m", "s", "A", "K", "mol", "cd")
DERIVED = {
    "rad": {}, "sr": {}, "Hz": {"s": -1}, "N": {"kg": 1, "m": 1, "s": -2}, "Pa": {"kg": 1, "m": -1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2}, "W": {"kg": 1, "m": 2, "s": -3}, "C": {"A": 1, "s": 1},
    "V": {"kg": 1, "m": 2, "s": -3, "A": -1}, "T": {"kg": 1, "s": -2, "A": -1},
}  # fmt: skip
RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def product(a, b, power=1):
    if a is None or b is None:
        return None
    total = dict(a)
    for unit, n in b.items():
        total[unit] = total.get(unit, 0) + n * power
    return {unit: n for unit, n in total.items() if n}


def read(reader):
    """Reads `kg*m/s^2]`; the bracket before it has been read."""
    total, sign = {}, 1
    while True:
        word = reader.word
        if reader.kind == "number" and word == "1":
            unit = {}
        elif word in BASE:
            unit = {word: 1}
        elif word in DERIVED:
            unit = DERIVED[word]
        else:
            reader.fail("expected a unit")
        reader.advance()
        total = product(total, unit, sign * power(reader))
        operator = reader.take("*", "/")
        if not operator:
            break
        sign = 1 if operator == "*" else -1
    reader.expect("]")
    return total


def power(reader):
    if reader.kind == "raised":
        value = int(reader.word.translate(RAISED))
    elif reader.take("^"):
        sign = -1 if reader.take("-") else 1
        if reader.kind != "number" or not reader.word.isdigit():
            reader.fail("expected an integer")
        value = sign * int(reader.word)
    else:
        return 1
    if abs(value) > 100:
        reader.fail("the exponent is too large")
    reader.advance()
    return value


class Units:
    """The dimensions of a document."""

    def __init__(self, document):
        self.document, self.definitions = document, {}

    def check(self):
        """All definitions and statements, if there are units at all."""
        symbols = self.document.symbols.values()
        if all(symbol.unit is None for symbol in symbols):
            return
        for symbol in symbols:
            if symbol.body:
                self.definitions[symbol.name] = self.of(symbol.body)
        for statement in self.document.statements.values():
            for sign, left, right in (*statement.items, *statement.when):
                if isinstance(right, tuple):
                    self.same(left, right)
                else:
                    self.of(left)

    def symbol(self, name):
        known = self.document
        if name in known.rate_of:
            function = known.rate_of[name]
            return product(self.symbol(function), self.symbol(known.symbols[name].argument), -1)
        symbol = known.symbols[name]
        if symbol.unit is None and (name in known.points or name in known.exponentials or symbol.parts):
            return {}
        return symbol.unit

    def same(self, *expressions):
        """The dimension that expressions have in common."""
        found = None
        for expression in expressions:
            dimension = self.of(expression)
            if None not in (found, dimension) and found != dimension:
                raise Unreadable(f"dimensions differ: {found} and {dimension}")
            found = dimension if found is None else found
        return found

    def of(self, e):
        kind = e[0]
        if kind == "num":
            return {} if e[1] else None
        if kind == "sym":
            return self.symbol(e[1])
        if kind == "def":
            return self.definitions.get(e[1])
        if kind in ("neg", "abs"):
            return self.of(e[1])
        if kind in ("add", "sub", "min", "max"):
            return self.same(e[1], e[2])
        if kind in ("mul", "div"):
            return product(self.of(e[1]), self.of(e[2]), 1 if kind == "mul" else -1)
        if kind in ("pow", "sqrt"):
            return product({}, self.of(e[1]), Fraction(1, 2) if kind == "sqrt" else e[2])
        if kind == "d":
            return product(self.of(e[1]), self.symbol(e[2]), -1)
        if kind == "par":
            return None  # what is put in for it is made of what has its dimension
        for guard, _ in e[1]:
            for _, left, right in guard:
                self.same(left, right)
        return self.same(*(body for _, body in e[1]), *([] if e[2] is None else [e[2]]))
