"""What an expression and a statement mean at one point, straight from the language page.

Values are Fractions, `Alg`s or `Germ`s; all three know their sign, and nothing else is asked of them.
A derivative is taken by jets: the expression is evaluated at x + h with h infinitesimal.
"""

from fractions import Fraction

from algebraic import Alg, sign, square_root
from expr import symbols
from germ import Germ


class Undefined(Exception):
    """The expression has no value at this point."""


class Ambiguous(Exception):
    """The page does not say clearly; no verdict is judged by this point."""


class Scope:
    """The values of all names at one point, and the definitions of the document."""

    __slots__ = ("lets", "values", "memo", "shared")

    def __init__(self, lets, values, shared=None):
        self.lets, self.values, self.memo = lets, values, {}
        self.shared = {} if shared is None else shared  # symbols of expressions, for all points

    def symbols(self, e):
        key = id(e)
        if key not in self.shared:
            self.shared[key] = (symbols(e, self.lets), e)  # e is kept, so that its id stays its own
        return self.shared[key][0]

    def value(self, name):
        if name in self.values:
            return self.values[name]
        if name not in self.memo:
            try:
                self.memo[name] = evaluate(self.lets[name], self)
            except Undefined as undefined:
                self.memo[name] = undefined
        found = self.memo[name]
        if isinstance(found, Undefined):
            raise found
        return found


def quotient(a, b):
    if sign(b) == 0:
        raise Undefined("division by zero")
    return a / b


def int_power(a, n):
    """a^n; 0^0 is 1, and a negative exponent is a division."""
    if n < 0:
        return quotient(Fraction(1), int_power(a, -n))
    if isinstance(a, Fraction):
        return a**n
    out = Fraction(1)
    for _ in range(n):
        out = out * a
    return out


def holds(op, a, b):
    """A relation between two values."""
    s = sign(a - b)
    return {"=": s == 0, "!=": s != 0, "<": s < 0, "<=": s <= 0, ">": s > 0, ">=": s >= 0}[op]


def evaluate(e, scope):
    """The value, or `Undefined`."""
    kind = e[0]
    if kind == "n":
        return e[1]
    if kind == "v":
        return scope.value(e[1])
    if kind == "cases":
        for guard, value in e[1]:
            # conditions are read from left to right
            if all(holds(op, evaluate(a, scope), evaluate(b, scope)) for op, a, b in guard):
                return evaluate(value, scope)
        if e[2] is None:
            raise Undefined("no branch")
        return evaluate(e[2], scope)
    if kind == "d":
        from jet import derivative

        return derivative(e, scope)
    a = evaluate(e[1], scope)
    if kind == "neg":
        return -a
    if kind == "^":
        return int_power(a, e[2])
    if kind == "abs":
        return a if sign(a) >= 0 else -a
    if kind == "sqrt":
        if sign(a) < 0:
            raise Undefined("root of a negative number")
        return square_root(a)
    b = evaluate(e[2], scope)
    if kind == "+":
        return a + b
    if kind == "-":
        return a - b
    if kind == "*":
        return a * b
    if kind == "/":
        return quotient(a, b)
    first = sign(a - b) <= 0
    return a if first == (kind == "min") else b


def relation_at(r, scope):
    """True, False, or None where it is undefined."""
    try:
        return holds(r[0], evaluate(r[1], scope), evaluate(r[2], scope))
    except Undefined:
        return None


def all_at(relations, scope):
    """Relations read from left to right: the first that is not true decides."""
    for r in relations:
        v = relation_at(r, scope)
        if v is not True:
            return v
    return True


def decimal(v):
    """For messages."""
    if isinstance(v, Alg):
        return f"~{float(v.near()):.9g}"
    if isinstance(v, Germ):
        return f"germ with limit {v.limit()}"
    return str(v)
